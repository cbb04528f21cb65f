/* FOLLOW: a tool whose hand rests goes with the other one. The scene is still: a test looks at the targets of the tools, and sets the facts
 * before each step. */
#include <math.h>
#include <string.h>

#include "rig.h"
#include "session/writable.h"

#define STRIDE 1e-4
#define ROUNDING 1e-15
#define SLACK 1e-12

typedef struct hands {
    rig r;
    vbss_session_hand input[2];
    vbss_session_goal goal;
    double tail, limb, turns; /* N; about the left tool's jaws */
    vec3 up, slit;
    bool is_left_absent; /* no input of it */
    uint32_t steps, throws;
} hands;

static pose target_of(const hands *p, int tool)
{
    vbss_grasper_state state;
    expect_ok(vbss_grasper_get_state(p->r.scene.tools[tool], &state, sizeof state));
    const double *q = state.target_orientation;
    return pose_make(vec3_load(state.target_position), quat_make(q[0], q[1], q[2], q[3]));
}

/* Tensions of the thread from the needle on, and to the tail's end; in the middle, that of a tied throw. */
static void tense(const hands *p)
{
    const scene_thread_info t = vbss_scene_inspect_thread(p->r.scene.thread);
    double *tensions = writable(t.tensions), arc = 0.0;
    for (uint32_t i = 0; i + 1 < t.node_count; i++) {
        tensions[i] = arc < 11e-3 ? p->limb : arc > t.length - 11e-3 ? p->tail : 3.0;
        arc += t.rest_lengths[i];
    }
}

static void step(hands *p)
{
    session_object *s = p->r.s;
    bool has_tail = p->goal != VBSS_SESSION_GOAL_TAKE_TAIL;
    s->phase = VBSS_SESSION_PHASE_THROW_1;
    s->throw_count = s->seated_count = p->throws;
    s->holding_tools.value = 2; /* the right tool has the needle, the left one the tail */
    s->coach.holding_thread = has_tail ? 1 : 0;
    s->coach.goal.value = (uint32_t)p->goal * SESSION_GOAL_TOOLS;
    s->coach.turns[RIG_LEFT] = p->turns;
    tense(p);
    for (int i = p->is_left_absent ? 1 : 0; i < 2; i++) {
        p->input[i].position[2] += p->steps++ % 2 == 0 ? ROUNDING : -ROUNDING;
        expect_ok(vbss_session_move_hand(p->r.session, (vbss_metrics_tool)i, &p->input[i]));
    }
    expect_ok(vbss_session_step(p->r.session, 0.0, RIG_STEP));
}

static void rest(hands *p, int steps)
{
    for (int i = 0; i < steps; i++) {
        step(p);
    }
}

static void set_aids(hands *p, uint32_t aids)
{
    vbss_session_assistance a = vbss_session_assistance_default();
    a.aids = aids;
    expect_ok(vbss_session_set_assistance(p->r.session, &a));
}

/* With both hands at rest for long enough. */
static void begin_with(hands *p, vbss_session_goal goal, bool has_left)
{
    memset(p, 0, sizeof *p);
    p->is_left_absent = !has_left;
    rig_make(&p->r);
    p->r.scene.config.dwell = 10.0;
    expect_ok(vbss_session_create(p->r.scene.scene, &p->r.scene.config, &p->r.session));
    expect_ok(vbss_session_open(p->r.session, &p->r.s));
    p->goal = goal;
    p->tail = p->limb =
        goal == VBSS_SESSION_GOAL_SEAT || goal == VBSS_SESSION_GOAL_RELEASE_TAIL ? 0.5 : 0.0;
    for (int i = 0; i < 2; i++) {
        p->input[i] = vbss_session_hand_default();
        const pose at = target_of(p, i);
        pose_store(at, p->input[i].position, p->input[i].orientation);
    }
    const scene_drain_info d = vbss_scene_inspect_drain(p->r.scene.drain);
    const vec3 marks[2] = {d.positions[d.marks[0]], d.positions[d.marks[1]]};
    const vec3 across = vec3_unit_or(vec3_sub(marks[1], marks[0]), vec3_zero());
    p->slit = vec3_lerp(marks[0], marks[1], 0.5);
    const vec3 out = vec3_sub(p->slit, d.centre);
    p->up = vec3_unit_or(vec3_add_scaled(out, -vec3_dot(out, across), across), vec3_zero());
    set_aids(p, VBSS_SESSION_AID_FOLLOW);
    rest(p, 120);
}

static void begin(hands *p, vbss_session_goal goal)
{
    begin_with(p, goal, true);
}

static void shift(hands *p, int hand, vec3 by)
{
    const vec3 to = vec3_add(vec3_load(p->input[hand].position), by);
    vec3_store(p->input[hand].position, to);
    step(p);
}

/* Movement of the other tool while a hand moves by so much, in small parts. */
static vec3 move(hands *p, int hand, vec3 by)
{
    const vec3 before = target_of(p, 1 - hand).position;
    for (int i = 0; i < 50; i++) {
        shift(p, hand, vec3_scale(by, 0.02));
    }
    step(p);
    return vec3_sub(target_of(p, 1 - hand).position, before);
}

static vec3 opposite(const hands *p, vec3 by)
{
    return vec3_add_scaled(vec3_neg(by), vec3_dot(by, p->up), p->up);
}

static void expect_moved(vec3 want, vec3 is)
{
    expect_near(0.0, vec3_distance(want, is), SLACK);
}

/* Away from the slit, for that tool. */
static vec3 outward(const hands *p, int hand)
{
    const vec3 at = vec3_sub(target_of(p, hand).position, p->slit);
    return vec3_scale(vec3_unit_or(at, vec3_zero()), 5e-3);
}

static void ends_are_pulled_alike(void **state)
{
    (void)state;
    static hands p;
    const vbss_session_goal goals[] = {VBSS_SESSION_GOAL_SEAT, VBSS_SESSION_GOAL_RELEASE_TAIL};
    for (int k = 0; k < 4; k++) {
        begin(&p, goals[k / 2]);
        int hand = k % 2;
        const vec3 out = outward(&p, hand), in = vec3_scale(out, -0.5);
        const pose before = target_of(&p, 1 - hand);
        expect_moved(opposite(&p, out), move(&p, hand, out));
        expect_moved(opposite(&p, in), move(&p, hand, in));
        expect_near(1.0, fabs(quat_dot(before.orientation, target_of(&p, 1 - hand).orientation)),
                    SLACK);
        rig_end(&p.r);
    }
}

static void the_end_that_bears_more_is_pulled_less(void **state)
{
    (void)state;
    static hands p;
    begin(&p, VBSS_SESSION_GOAL_SEAT);
    const vec3 out = outward(&p, RIG_LEFT), in = vec3_neg(out), zero = vec3_zero();
    p.tail = 0.5;
    p.limb = 0.575; /* of the tool that follows: half the limit more */
    expect_moved(vec3_scale(opposite(&p, out), 0.5), move(&p, RIG_LEFT, out));
    expect_moved(vec3_scale(opposite(&p, in), 1.5), move(&p, RIG_LEFT, in));
    p.limb = 0.65; /* the limit */
    expect_moved(zero, move(&p, RIG_LEFT, out));
    p.limb = 0.9;
    expect_moved(vec3_neg(opposite(&p, out)), move(&p, RIG_LEFT, out));
    expect_moved(vec3_scale(opposite(&p, in), 2.0), move(&p, RIG_LEFT, in));
    p.limb = 0.0;
    expect_moved(vec3_scale(opposite(&p, out), 2.0), move(&p, RIG_LEFT, out));
    expect_moved(zero, move(&p, RIG_LEFT, in));
    p.tail = 0.06;
    p.limb = 0.094; /* ends that bear little differ by less */
    expect_moved(vec3_scale(opposite(&p, out), 0.5), move(&p, RIG_LEFT, out));
    p.tail = p.limb = 0.04; /* slack is taken up alone */
    expect_moved(zero, move(&p, RIG_LEFT, out));
    expect_moved(opposite(&p, in), move(&p, RIG_LEFT, in));
    rig_end(&p.r);
}

/* From the slit over the neck of the left tool to the right one. */
static double path_of_limb(const hands *p)
{
    const scene_grasper_info loop = vbss_scene_inspect_grasper(p->r.scene.tools[RIG_LEFT]);
    const pose left = target_of(p, RIG_LEFT);
    const vec3 neck =
        vec3_add_scaled(left.position, -10e-3, quat_rotate(left.orientation, loop.forward));
    return vec3_distance(p->slit, neck) + vec3_distance(neck, target_of(p, RIG_RIGHT).position);
}

static void move_with_turns(hands *p)
{
    for (int i = 0; i < 500; i++) {
        const vec3 left = target_of(p, RIG_LEFT).position, right = target_of(p, RIG_RIGHT).position;
        const double by = i < 300 ? STRIDE : -STRIDE;
        shift(p, RIG_LEFT, vec3_make(0.3 * by, by, -0.5 * by));
        step(p);
        double moved = vec3_distance(left, target_of(p, RIG_LEFT).position);
        double followed = vec3_distance(right, target_of(p, RIG_RIGHT).position);
        assert_true(followed < 2.0 * moved + SLACK); /* no jump */
    }
}

static void a_wound_limb_keeps_its_length(void **state)
{
    (void)state;
    static hands p;
    for (int k = 0; k < 3; k++) {
        begin(&p, k == 0 ? VBSS_SESSION_GOAL_TAKE_TAIL : VBSS_SESSION_GOAL_DRAW_TAIL);
        p.throws = k == 2 ? 0 : 1;
        p.turns = 1.5;
        const double before = path_of_limb(&p);
        const vec3 first = target_of(&p, RIG_RIGHT).position;
        move_with_turns(&p);
        const vec3 moved = vec3_sub(target_of(&p, RIG_RIGHT).position, first);
        if (k == 2) { /* drawn in the first throw, it stays */
            expect_near(0.0, vec3_norm(moved), 1e-9);
            rig_end(&p.r);
            continue;
        }
        assert_true(vec3_norm(moved) > 5e-3);
        expect_near(before - 4e-3, path_of_limb(&p), 1e-9);
        p.limb = 0.06; /* taut: it comes nearer by the path of the jaws */
        (void)move(&p, RIG_LEFT, vec3_make(0.0, 5e-3, 0.0));
        expect_near(before - 9e-3, path_of_limb(&p), 1e-9);
        p.turns = 0.5; /* without turns it stays */
        expect_moved(vec3_zero(), move(&p, RIG_LEFT, vec3_make(0.0, 5e-3, 0.0)));
        rig_end(&p.r);
    }
}

static double height_of(const hands *p, int tool)
{
    return vec3_dot(vec3_sub(target_of(p, tool).position, p->slit), p->up);
}

static void sink(hands *p, double height)
{
    const vec3 down = vec3_scale(p->up, -3.0 * STRIDE);
    for (int i = 0; i < 2000 && height_of(p, RIG_LEFT) > height; i++) {
        shift(p, RIG_LEFT, down);
    }
}

/* It stays above the jaws, and above the drain while the limb is long enough. */
static void a_needle_goes_over_the_drain(void **state)
{
    (void)state;
    static hands p;
    begin(&p, VBSS_SESSION_GOAL_TAKE_TAIL);
    p.turns = 1.5;
    sink(&p, -40e-3);
    const vec3 left = target_of(&p, RIG_LEFT).position, right = target_of(&p, RIG_RIGHT).position;
    assert_true(height_of(&p, RIG_RIGHT) - height_of(&p, RIG_LEFT) >
                0.4 * vec3_distance(left, right));
    sink(&p, -80e-3);
    assert_true(height_of(&p, RIG_RIGHT) > 5e-3);
    rig_end(&p.r);
}

static void only_a_tool_at_rest_follows(void **state)
{
    (void)state;
    static hands p;
    begin(&p, VBSS_SESSION_GOAL_SEAT);
    const vec3 out = vec3_scale(outward(&p, RIG_LEFT), 0.02),
               own = vec3_make(0.0, 0.1 * STRIDE, 0.0);
    vec3 before = target_of(&p, RIG_RIGHT).position;
    for (int i = 0; i < 300; i++) { /* both move */
        vec3_store(p.input[RIG_RIGHT].position,
                   vec3_add(vec3_load(p.input[RIG_RIGHT].position), own));
        shift(&p, RIG_LEFT, out);
    }
    expect_moved(vec3_scale(own, 300.0), vec3_sub(target_of(&p, RIG_RIGHT).position, before));
    before = target_of(&p, RIG_RIGHT).position;
    for (int i = 0; i < 90; i++) { /* not for long enough yet */
        shift(&p, RIG_LEFT, out);
    }
    expect_moved(vec3_zero(), vec3_sub(target_of(&p, RIG_RIGHT).position, before));
    for (int i = 0; i < 30; i++) {
        shift(&p, RIG_LEFT, out);
    }
    expect_moved(vec3_scale(opposite(&p, out), 21.0),
                 vec3_sub(target_of(&p, RIG_RIGHT).position, before));
    rig_end(&p.r);
}

static void other_goals_move_one_tool(void **state)
{
    (void)state;
    static hands p;
    for (int goal = VBSS_SESSION_GOAL_NONE; goal <= VBSS_SESSION_GOAL_CUT; goal++) {
        if (goal == VBSS_SESSION_GOAL_SEAT || goal == VBSS_SESSION_GOAL_RELEASE_TAIL) {
            continue;
        }
        begin(&p, (vbss_session_goal)goal);
        expect_moved(vec3_zero(), move(&p, RIG_LEFT, outward(&p, RIG_LEFT)));
        rig_end(&p.r);
    }
}

static void switching_moves_nothing(void **state)
{
    (void)state;
    static hands p;
    begin(&p, VBSS_SESSION_GOAL_SEAT);
    const vec3 out = outward(&p, RIG_LEFT);
    for (int i = 0; i < 3; i++) {
        set_aids(&p, 0);
        expect_moved(vec3_zero(), move(&p, RIG_LEFT, out));
        const vec3 before = target_of(&p, RIG_RIGHT).position;
        set_aids(&p, VBSS_SESSION_AID_FOLLOW);
        rest(&p, 120);
        expect_moved(before, target_of(&p, RIG_RIGHT).position);
        p.input[RIG_LEFT].position[0] += 0.05; /* a clutch */
        p.input[RIG_LEFT].is_origin = 1;
        expect_ok(vbss_session_move_hand(p.r.session, VBSS_METRICS_TOOL_LEFT, &p.input[RIG_LEFT]));
        p.input[RIG_LEFT].is_origin = 0;
        rest(&p, 3);
        expect_moved(before, target_of(&p, RIG_RIGHT).position);
    }
    rig_end(&p.r);
}

static void a_hand_that_joins_moves_nothing(void **state)
{
    (void)state;
    static hands p;
    begin_with(&p, VBSS_SESSION_GOAL_TAKE_TAIL, false);
    p.turns = 1.5;
    const vec3 before = target_of(&p, RIG_RIGHT).position;
    p.is_left_absent = false;
    rest(&p, 10);
    expect_moved(vec3_zero(), vec3_sub(target_of(&p, RIG_RIGHT).position, before));
    rig_end(&p.r);
}

static void a_tool_that_follows_stays_in_reach(void **state)
{
    (void)state;
    static hands p;
    begin(&p, VBSS_SESSION_GOAL_SEAT);
    const vec3 out = vec3_scale(outward(&p, RIG_LEFT), 10.0);
    for (int i = 0; i < 8; i++) {
        (void)move(&p, RIG_LEFT, out);
    }
    const vec3 end = target_of(&p, RIG_RIGHT).position;
    double far = vec3_distance(end, p.slit);
    assert_true(far < 0.15 && far > 0.13);
    const vec3 back = vec3_scale(out, -0.1);
    expect_moved(opposite(&p, back), move(&p, RIG_LEFT, back));
    rig_end(&p.r);
}

int test_assistance_follow(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ends_are_pulled_alike),
        cmocka_unit_test(the_end_that_bears_more_is_pulled_less),
        cmocka_unit_test(a_wound_limb_keeps_its_length),
        cmocka_unit_test(a_needle_goes_over_the_drain),
        cmocka_unit_test(only_a_tool_at_rest_follows),
        cmocka_unit_test(other_goals_move_one_tool),
        cmocka_unit_test(switching_moves_nothing),
        cmocka_unit_test(a_hand_that_joins_moves_nothing),
        cmocka_unit_test(a_tool_that_follows_stays_in_reach),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
