/* The coach's goals come in the order of the task, go back with it, and say how far they are. */
#include <math.h>
#include <string.h>

#include "base/rotation.h"
#include "rig.h"
#include "session/writable.h"

#define LENGTH 0.15

enum { MAX_NODES = 4096 }; /* of the drain */

/* Until facts and goals have dwelt. */
static void run(rig *r)
{
    rig_run(r, 0.2);
}

/* The hand's tool is at the needle, so far from its tip. */
static void put_on_needle(rig *r, uint32_t tool, double arc)
{
    vbss_needle *needle = r->scene.needle;
    double point[3];
    expect_ok(vbss_needle_get_place(needle, arc, point, NULL));
    r->observation.tools[tool].tip = vec3_load(point);
}

static void stitch_goals_follow_the_needle(void **state)
{
    (void)state;
    rig r;
    rig_begin_coached(&r);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_TAKE_NEEDLE, VBSS_METRICS_TOOL_RIGHT);
    rig_take(&r, RIG_RIGHT);
    put_on_needle(&r, RIG_RIGHT, 0.02);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_REACH_MARK, VBSS_METRICS_TOOL_RIGHT);
    assert_int_equal(rig_coaching(&r).number, 1);
    rig_pierce(&r, RIG_ENTRY, 1, 0.0);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_DRIVE, VBSS_METRICS_TOOL_RIGHT);
    assert_int_equal(rig_coaching(&r).number, 0);
    rig_pierce(&r, RIG_EXIT, 0, 0.0);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_EXPOSE_TIP, VBSS_METRICS_TOOL_RIGHT);
    r.observation.holes[1].distance_from_tip = 9e-3;
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_TAKE_TIP, VBSS_METRICS_TOOL_LEFT);
    rig_take(&r, RIG_LEFT);
    put_on_needle(&r, RIG_LEFT, 4e-3);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_RELEASE_NEEDLE, VBSS_METRICS_TOOL_RIGHT);
    rig_drop(&r, RIG_RIGHT);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_DRAW_NEEDLE, VBSS_METRICS_TOOL_LEFT);
    rig_thread_through(&r, RIG_ENTRY, 0.02);
    rig_thread_through(&r, RIG_EXIT, 0.01);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_HAND_OVER, VBSS_METRICS_TOOL_RIGHT); /* who winds */
    rig_take(&r, RIG_RIGHT);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_RELEASE_NEEDLE, VBSS_METRICS_TOOL_LEFT);
    rig_drop(&r, RIG_LEFT);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_DRAW_THREAD, VBSS_METRICS_TOOL_RIGHT);
    expect_near(LENGTH - 0.02 - r.scene.config.tail_high, rig_coaching(&r).length, 1e-12);
    rig_thread_through(&r, RIG_ENTRY, LENGTH - 0.01);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_LENGTHEN_TAIL, VBSS_METRICS_TOOL_LEFT);
    expect_near(5e-3, rig_coaching(&r).length, 1e-12);
    const vec3 root = vbss_session_thread_position(r.s, &r.observation, LENGTH - 0.01 + 4e-3);
    expect_near(0.0, vec3_distance(root, vec3_load(rig_coaching(&r).point)), 1e-9);
    rig_hold_thread(&r, RIG_LEFT, 6e-3);
    run(&r);
    rig_thread_through(&r, RIG_ENTRY, LENGTH - 0.017);
    rig_run(&r, 1.0);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_RELEASE_TAIL, VBSS_METRICS_TOOL_LEFT);
    assert_int_equal(rig_coaching(&r).mistake, VBSS_SESSION_MISTAKE_NONE); /* no turns are needed */
    rig_let_go(&r, RIG_LEFT);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_WIND, VBSS_METRICS_TOOL_RIGHT);
    rig_take(&r, RIG_LEFT); /* and if it is passed once more */
    rig_drop(&r, RIG_RIGHT);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_HAND_OVER, VBSS_METRICS_TOOL_RIGHT);
    rig_end(&r);
}

static vec3 on_arc(const vbss_session_coaching *c, double angle)
{
    vec3 arm = vec3_sub(vec3_load(c->arc_start), vec3_load(c->arc_centre));
    quat turn = vbss_quat_from_rotation_vector(vec3_scale(vec3_load(c->arc_axis), angle));
    return vec3_add(vec3_load(c->arc_centre), quat_rotate(turn, arm));
}

/* From the jaws, which rest far off, it goes over the slit to as far on the side of the hand. */
static void expect_path_of_tail(const rig *r)
{
    vbss_grasper_state tool;
    const vbss_session_coaching c = rig_coaching(r);
    expect_ok(vbss_grasper_get_state(r->scene.tools[RIG_LEFT], &tool, sizeof tool));
    const vec3 slit = vec3_load(c.point), own = vec3_load(c.direction);
    const vec3 from = vec3_sub(vec3_load(tool.position), slit),
               up = vec3_cross(own, vec3_load(c.arc_axis)); /* out of the tissue */
    const double along = vec3_dot(from, own), above = vec3_dot(from, up);
    expect_near(1.0, vec3_norm(up), 1e-12);
    assert_true(vec3_dot(slit, up) > 0.0); /* the drain lies about the origin */
    assert_true((c.geometry & (uint32_t)VBSS_SESSION_GEOMETRY_ARC) != 0);
    expect_near(sqrt(along * along + above * above), c.arc_radius, 1e-9);
    vec3 start = vec3_add_scaled(vec3_add_scaled(slit, along, own), above, up);
    expect_near(0.0, vec3_distance(start, on_arc(&c, 0.0)), 1e-9);
    vec3 end = vec3_add_scaled(slit, c.arc_radius, own);
    expect_near(0.0, vec3_distance(end, on_arc(&c, c.arc_angle)), 1e-9);
    assert_true(vec3_dot(vec3_sub(on_arc(&c, 0.5 * c.arc_angle), slit), up) > 0.0);
}

/* Places so much of the tail's end below the drain, the rest beside it. */
static void place_tail(const rig *r, double below, double beside)
{
    const scene_thread_info t = vbss_scene_inspect_thread(r->scene.thread);
    const scene_drain_info d = vbss_scene_inspect_drain(r->scene.drain);
    const vec3 across =
        vec3_unit_or(vec3_sub(d.positions[d.marks[1]], d.positions[d.marks[0]]), vec3_zero());
    const vec3 top = vec3_lerp(d.positions[d.marks[0]], d.positions[d.marks[1]], 0.5);
    vec3 *positions = writable(t.positions);
    double from_end = 0.0;
    for (uint32_t i = t.node_count; i-- > 0;) {
        const vec3 under = vec3_sub(vec3_scale(d.centre, 2.0), top);
        positions[i] =
            from_end <= below ? under : vec3_add_scaled(under, d.radius + beside, across);
        from_end += i > 0 ? t.rest_lengths[i - 1] : 0.0;
    }
}

/* Across from the middle of the drain, m. */
static double aside(const rig *r)
{
    const scene_drain_info d = vbss_scene_inspect_drain(r->scene.drain);
    const vec3 across =
        vec3_unit_or(vec3_sub(d.positions[d.marks[1]], d.positions[d.marks[0]]), vec3_zero());
    return vec3_dot(vec3_sub(vec3_load(rig_coaching(r).point), d.centre), across);
}

/* Near its end, but beside the drain. */
static void a_tail_is_taken_where_jaws_reach_it(void **state)
{
    (void)state;
    rig r;
    rig_begin_coached(&r);
    rig_to_tail(&r);
    rig_wind(&r, RIG_LEFT, 2.3, 1);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_TAKE_TAIL, VBSS_METRICS_TOOL_LEFT);
    const double radius = vbss_scene_inspect_drain(r.scene.drain).radius;
    place_tail(&r, 6e-3, 4e-3);
    assert_true(aside(&r) > radius + 3e-3);
    place_tail(&r, 2e-3, 1e-3); /* it hangs down close to the drain */
    assert_true(aside(&r) < radius + 1.1e-3);
    place_tail(&r, 12e-3, 4e-3); /* no part that would do */
    assert_true(fabs(aside(&r)) < 1e-3);
    rig_end(&r);
}

static void throw_goals_follow_the_thread(void **state)
{
    (void)state;
    rig r;
    rig_begin_coached(&r);
    rig_to_tail(&r);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_WIND, VBSS_METRICS_TOOL_RIGHT);
    expect_near(2.25, rig_coaching(&r).turns, 1e-12);
    rig_wind(&r, RIG_LEFT, 1.5, 1);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_WIND, VBSS_METRICS_TOOL_RIGHT);
    expect_near(0.75, rig_coaching(&r).turns, 1e-12);
    rig_wind(&r, RIG_LEFT, 2.3, 1);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_TAKE_TAIL, VBSS_METRICS_TOOL_LEFT);
    rig_wind(&r, RIG_LEFT, 2.1, 1); /* less than it had to be, but enough */
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_TAKE_TAIL, VBSS_METRICS_TOOL_LEFT);
    rig_wind(&r, RIG_LEFT, 1.7, 1); /* jaws that turn to the tail see fewer */
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_TAKE_TAIL, VBSS_METRICS_TOOL_LEFT);
    rig_wind(&r, RIG_LEFT, 1.6, 1); /* these have come off */
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_WIND, VBSS_METRICS_TOOL_RIGHT);
    rig_wind(&r, RIG_LEFT, 2.3, 1);
    run(&r);
    rig_hold_thread(&r, RIG_LEFT, 4e-3);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_DRAW_TAIL, VBSS_METRICS_TOOL_LEFT);
    expect_path_of_tail(&r);
    const double arc = r.observation.holes[0].arc;
    rig_thread_through(&r, RIG_ENTRY, arc - 20e-3); /* drawing makes it long */
    rig_wind(&r, RIG_LEFT, 0.5, 1);
    run(&r);
    assert_int_equal(r.s->phase, VBSS_SESSION_PHASE_PULL_THROUGH);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_DRAW_TAIL, VBSS_METRICS_TOOL_LEFT);
    rig_thread_through(&r, RIG_ENTRY, arc);
    run(&r);
    rig_wind(&r, RIG_LEFT, 0.1, 0);
    rig_set_throw(&r, 0, 2, -1, VBSS_METRICS_RELATION_FIRST);
    rig_pull(&r, 0.3, 2e-3);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_SEAT, VBSS_METRICS_TOOL_LEFT);
    assert_int_equal(rig_coaching(&r).mistake, VBSS_SESSION_MISTAKE_NONE);
    rig_wind(&r, RIG_LEFT, 0.9, 1); /* hands that go round the slit */
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_SEAT, VBSS_METRICS_TOOL_LEFT);
    rig_wind(&r, RIG_LEFT, 1.3, 1); /* wound in earnest */
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_DRAW_TAIL, VBSS_METRICS_TOOL_LEFT);
    rig_wind(&r, RIG_LEFT, 0.1, 0);
    run(&r);
    rig_pull(&r, 1.0, 3e-4);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_RELEASE_TAIL, VBSS_METRICS_TOOL_LEFT);
    rig_let_go(&r, RIG_LEFT);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_HAND_OVER, VBSS_METRICS_TOOL_LEFT);
    rig_take(&r, RIG_LEFT);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_RELEASE_NEEDLE, VBSS_METRICS_TOOL_RIGHT);
    rig_drop(&r, RIG_RIGHT);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_WIND, VBSS_METRICS_TOOL_LEFT);
    assert_int_equal(rig_coaching(&r).number, 1);
    expect_near(1.25, rig_coaching(&r).turns, 1e-12);
    rig_wind(&r, RIG_RIGHT, -1.3, 1);
    rig_hold_thread(&r, RIG_RIGHT, 4e-3);
    rig_pull(&r, 0.0, 2e-3); /* the slit opens under the first throw */
    run(&r);
    assert_int_equal(r.s->seated_count, 0);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_DRAW_TAIL, VBSS_METRICS_TOOL_RIGHT);
    rig_wind(&r, RIG_RIGHT, -0.6, 1); /* a last turn hangs on the jaws */
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_DRAW_TAIL, VBSS_METRICS_TOOL_RIGHT);
    rig_wind(&r, RIG_RIGHT, 0.0, 0);
    rig_set_throw(&r, 1, 1, 1, VBSS_METRICS_RELATION_SQUARE);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_SEAT, VBSS_METRICS_TOOL_RIGHT);
    rig_pull(&r, 1.0, 3e-4);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_RELEASE_TAIL, VBSS_METRICS_TOOL_RIGHT);
    rig_end(&r);
}

/* Handedness alternates, so the turns about the other hand's tool do; both are over the top. */
static void later_throw_is_wound_for_a_square(void **state)
{
    (void)state;
    rig r;
    rig_begin_coached(&r);
    rig_to_tail(&r);
    rig_to_throw(&r, 0, RIG_RIGHT); /* right-handed: turns < 0, from below */
    assert_true(vbss_session_wanted_sign(r.s) > 0.0);
    const vbss_session_coaching next = rig_coaching(&r);
    assert_true(next.goal == VBSS_SESSION_GOAL_HAND_OVER);
    rig_take(&r, RIG_LEFT);
    rig_drop(&r, RIG_RIGHT);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_WIND, VBSS_METRICS_TOOL_LEFT);
    assert_non_null(strstr(rig_coaching(&r).sentence, "underneath, away"));
    rig_end(&r);
}

/* The first throw is seated and its tail let go: the left hand has to take the needle. */
static void to_hand_over(rig *r)
{
    rig_begin_coached(r);
    rig_to_tail(r);
    rig_to_throw(r, 0, RIG_RIGHT);
    rig_let_go(r, RIG_LEFT);
    run(r);
    rig_expect_goal(r, VBSS_SESSION_GOAL_HAND_OVER, VBSS_METRICS_TOOL_LEFT);
}

static void take_needle_over(rig *r)
{
    rig_take(r, RIG_LEFT);
    rig_drop(r, RIG_RIGHT);
    run(r);
}

/* A sprung throw is left, and the next one, wound for a square, closes the slit. */
static void opened_slit_is_left_to_the_next_throw(void **state)
{
    (void)state;
    rig r;
    to_hand_over(&r);
    const double sign = vbss_session_wanted_sign(r.s);
    rig_pull(&r, 0.0, 2e-3);
    run(&r);
    assert_int_equal(r.s->seated_count, 0);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_HAND_OVER, VBSS_METRICS_TOOL_LEFT);
    rig_hold_thread(&r, RIG_LEFT, 4e-3);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_RELEASE_TAIL, VBSS_METRICS_TOOL_LEFT);
    assert_non_null(strstr(rig_coaching(&r).remedy, "next throw"));
    rig_let_go(&r, RIG_LEFT);
    run(&r);
    take_needle_over(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_WIND, VBSS_METRICS_TOOL_LEFT);
    assert_int_equal(rig_coaching(&r).number, 1);
    expect_near(1.25, rig_coaching(&r).turns, 1e-12);
    assert_true(vbss_session_wanted_sign(r.s) == sign);
    assert_int_equal(rig_coaching(&r).mistake, VBSS_SESSION_MISTAKE_SLIT_OPENED);
    assert_non_null(strstr(rig_coaching(&r).remedy, "next throw"));
    rig_wind(&r, RIG_RIGHT, 1.3 * sign, 1);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_TAKE_TAIL, VBSS_METRICS_TOOL_RIGHT);
    rig_hold_thread(&r, RIG_RIGHT, 4e-3);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_DRAW_TAIL, VBSS_METRICS_TOOL_RIGHT);
    rig_wind(&r, RIG_RIGHT, 0.0, 0); /* through, and not tied yet */
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_DRAW_TAIL, VBSS_METRICS_TOOL_RIGHT);
    rig_set_throw(&r, 1, 1, -r.s->throws[0].value.handedness, VBSS_METRICS_RELATION_SQUARE);
    run(&r);
    assert_int_equal(r.s->seated_count, 1);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_SEAT, VBSS_METRICS_TOOL_RIGHT);
    assert_int_equal(rig_coaching(&r).mistake, VBSS_SESSION_MISTAKE_NONE);
    rig_end(&r);
}

/* Unit vector to the side of a hand. */
static vec3 own_side(const rig *r, uint32_t hand)
{
    const scene_drain_info d =
        vbss_scene_inspect_drain(vbss_scene_inspect_body(r->s->scene, r->s->config.drain).drain);
    return vec3_unit_or(vec3_sub(d.positions[d.marks[hand]], d.positions[d.marks[1 - hand]]),
                        vec3_zero());
}

/* Whether the hand with the tail is to pull to the other hand's side; `apart`: its tip from the other one's toward its own side, m. */
static bool is_pulled_from_behind(const rig *r, double apart, double tension, double gap)
{
    session_observation seen;
    vbss_session_coaching c;
    const session_goal goal = vbss_session_current_goal(r->s);
    vbss_session_observe(r->s, &seen);
    seen.tension[0] = seen.tension[1] = tension;
    seen.signed_gap = gap;
    assert_int_equal(goal.goal, VBSS_SESSION_GOAL_SEAT);
    const vec3 own = own_side(r, goal.tool);
    seen.tools[goal.tool].tip = vec3_scale(own, 0.5 * apart);
    seen.tools[1 - goal.tool].tip = vec3_scale(own, -0.5 * apart);
    memset(&c, 0, sizeof c);
    vbss_session_describe_goal(r->s, &seen, goal, &c);
    const double toward = vec3_dot(own, vec3_load(c.direction));
    assert_true(fabs(toward) > 0.9);
    return toward < 0.0;
}

/* The second throw is tied, and the right hand has its tail. */
static void to_second_seat(rig *r)
{
    to_hand_over(r);
    take_needle_over(r);
    rig_wind(r, RIG_RIGHT, 1.3 * vbss_session_wanted_sign(r->s), 1);
    rig_hold_thread(r, RIG_RIGHT, 4e-3);
    run(r);
    rig_wind(r, RIG_RIGHT, 0.0, 0);
    rig_set_throw(r, 1, 1, -r->s->throws[0].value.handedness, VBSS_METRICS_RELATION_SQUARE);
    rig_pull(r, 0.0, 1e-3);
    run(r);
    rig_expect_goal(r, VBSS_SESSION_GOAL_SEAT, VBSS_METRICS_TOOL_RIGHT);
}

/* A throw that hangs loose over an open slit is pulled with the hands on each other's sides, and so on from there; one that bears tension is pulled
 * flat. */
static void open_slit_is_pulled_from_behind(void **state)
{
    (void)state;
    rig r;
    to_second_seat(&r);
    assert_false(is_pulled_from_behind(&r, 0.04, 0.0, 1.1e-3));
    rig_run(&r, 19.0); /* it hangs loose, but slack takes time to be taken up */
    assert_false(is_pulled_from_behind(&r, 0.04, 0.0, 1.1e-3));
    rig_run(&r, 2.0);
    assert_false(is_pulled_from_behind(&r, 0.04, 0.0, 9e-4));
    assert_true(is_pulled_from_behind(&r, 0.04, 0.0, 1.1e-3));
    assert_true(is_pulled_from_behind(&r, -0.04, 0.8, 3e-4));
    assert_true(is_pulled_from_behind(&r, -0.04, 0.3, 1.1e-3));
    assert_false(is_pulled_from_behind(&r, -0.04, 0.0, 3e-4)); /* just drawn, and closed */
    r.s->coach.from_behind =
        1u; /* the throw below was pulled so: its ends lie on the other sides */
    assert_false(is_pulled_from_behind(&r, 0.04, 0.0, 1.1e-3));
    assert_false(is_pulled_from_behind(&r, -0.04, 0.8, 1.1e-3));
    rig_end(&r);
}

/* The coach keeps which throws were closed from behind. */
static void sides_of_a_seat_are_kept(void **state)
{
    (void)state;
    for (int crossed = 0; crossed < 2; crossed++) {
        rig r;
        to_second_seat(&r);
        /* The frame of the coach is that of the scene's drain and of the lips that are seen. */
        session_observation seen;
        vbss_session_observe(r.s, &seen);
        memcpy(r.observation.lips, seen.lips, sizeof seen.lips);
        r.observation.into_tissue = seen.into_tissue;
        const vec3 own = vec3_scale(own_side(&r, RIG_RIGHT), crossed != 0 ? -0.02 : 0.02);
        r.observation.tools[RIG_RIGHT].tip = own;
        r.observation.tools[RIG_LEFT].tip = vec3_neg(own);
        rig_pull(&r, 1.0, 3e-4);
        run(&r);
        rig_expect_goal(&r, VBSS_SESSION_GOAL_RELEASE_TAIL, VBSS_METRICS_TOOL_RIGHT);
        assert_int_equal(r.s->coach.from_behind >> 1 & 1u, crossed);
        rig_end(&r);
    }
}

static void first_throw_is_pulled_flat(void **state)
{
    (void)state;
    rig r;
    rig_begin_coached(&r);
    rig_to_tail(&r);
    rig_wind(&r, RIG_LEFT, 2.3, 1);
    rig_hold_thread(&r, RIG_LEFT, 4e-3);
    run(&r);
    rig_wind(&r, RIG_LEFT, 0.0, 0);
    rig_set_throw(&r, 0, 2, -1, VBSS_METRICS_RELATION_FIRST);
    rig_pull(&r, 0.0, 2e-3);
    run(&r);
    assert_false(is_pulled_from_behind(&r, 0.04, 0.0, 2e-3));
    assert_false(is_pulled_from_behind(&r, -0.04, 0.0, 2e-3));
    rig_end(&r);
}

/* With that much of the limb. */
static vec3 place_to_wind(const rig *r, double limb)
{
    session_observation seen;
    vbss_session_coaching c;
    memset(&c, 0, sizeof c);
    vbss_session_observe(r->s, &seen);
    seen.hole_count = 1;
    seen.holes[0] = (session_hole_observation){
        .id = r->s->holes[SESSION_EXIT].id, .thread = seen.thread, .arc = limb};
    vbss_session_describe_goal(r->s, &seen, vbss_session_current_goal(r->s), &c);
    return vec3_load(c.point);
}

/* Its upper half, 5 mm aside and along. */
static void lean_drain(const rig *r, vec3 up)
{
    static double moved[3 * MAX_NODES];
    vbss_drain *drain = vbss_scene_inspect_body(r->s->scene, r->s->config.drain).drain;
    const scene_drain_info d = vbss_scene_inspect_drain(drain);
    assert_true(d.node_count <= MAX_NODES);
    for (uint32_t i = 0; i < d.node_count; i++) {
        vec3 x = d.positions[i];
        if (vec3_dot(vec3_sub(x, d.centre), up) > 0.0) {
            x = vec3_add(x, vec3_make(3e-3, 0.0, 4e-3));
        }
        vec3_store(moved + 3 * (size_t)i, x);
    }
    expect_ok(vbss_drain_set_state(drain, moved, NULL, d.node_count));
}

/* The less of the limb is left, the lower; a drain that the limb drags along does not take the place with it. */
static void place_to_wind_follows_the_limb(void **state)
{
    (void)state;
    rig r;
    rig_begin_coached(&r);
    rig_to_tail(&r);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_WIND, VBSS_METRICS_TOOL_RIGHT);
    const vec3 low = place_to_wind(&r, 60e-3), middle = place_to_wind(&r, 100e-3),
               high = place_to_wind(&r, 140e-3);
    session_observation seen;
    vbss_session_observe(r.s, &seen);
    const vec3 up = vec3_unit_or(vec3_neg(seen.into_tissue), vec3_zero());
    expect_near(0.0, vec3_distance(vec3_sub(middle, low), vec3_scale(up, 25e-3)), 1e-6);
    expect_near(0.0, vec3_distance(vec3_sub(high, middle), vec3_scale(up, 15e-3)), 1e-6);
    lean_drain(&r, up);
    vbss_session_observe(r.s, &seen);
    assert_true(vec3_dot(vec3_unit_or(seen.into_tissue, up), up) > -0.99);
    expect_near(0.0, vec3_distance(middle, place_to_wind(&r, 100e-3)), 1e-12);
    rig_end(&r);
}

static void cut_goals_follow_the_tails(void **state)
{
    (void)state;
    rig r;
    rig_begin_coached(&r);
    rig_to_cut(&r);
    rig_hold_thread(&r, RIG_LEFT, 4e-3);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_RELEASE_TAIL, VBSS_METRICS_TOOL_LEFT);
    rig_let_go(&r, RIG_LEFT);
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_TAKE_SHEARS, VBSS_METRICS_TOOL_LEFT);
    r.observation.tools[RIG_LEFT].is_shears = true;
    run(&r);
    rig_expect_goal(&r, VBSS_SESSION_GOAL_CUT, VBSS_METRICS_TOOL_LEFT);
    assert_int_equal(rig_coaching(&r).number, SESSION_ENTRY);
    r.observation.thread_length = r.observation.holes[0].arc + 5e-3;
    run(&r);
    assert_int_equal(rig_coaching(&r).number, SESSION_EXIT);
    rig_end(&r);
}

/* Each change of the goal is an event, and nothing else is. */
static void each_goal_is_one_event(void **state)
{
    (void)state;
    rig r;
    vbss_session_event e;
    static const struct {
        vbss_session_goal goal;
        vbss_metrics_tool tool;
    } wanted[] = {
        {VBSS_SESSION_GOAL_TAKE_NEEDLE, VBSS_METRICS_TOOL_RIGHT},
        {VBSS_SESSION_GOAL_REACH_MARK, VBSS_METRICS_TOOL_RIGHT},
        {VBSS_SESSION_GOAL_TAKE_NEEDLE, VBSS_METRICS_TOOL_RIGHT},
    };
    uint32_t found = 0;
    rig_begin_coached(&r);
    run(&r);
    rig_take(&r, RIG_RIGHT);
    run(&r);
    rig_drop(&r, RIG_RIGHT);
    run(&r);
    const vbss_session_status status = rig_status(&r);
    for (uint64_t i = 0; i < status.event_count; i++) {
        expect_ok(vbss_session_get_event(r.session, i, &e, sizeof e));
        if (e.kind == VBSS_SESSION_EVENT_GOAL) {
            assert_true(found < 3);
            assert_int_equal(e.number, wanted[found].goal);
            assert_int_equal(e.tool, wanted[found].tool);
            found++;
        }
    }
    assert_int_equal(found, 3);
    assert_int_equal(r.s->coach_event_count, 3);
    rig_end(&r);
}

/* The scene's own bodies, which rest: geometry and distances agree. */
static void distances_are_those_of_the_geometry(void **state)
{
    (void)state;
    rig r;
    double mark[3];
    rig_begin_coached(&r);
    run(&r);
    vbss_session_coaching c = rig_coaching(&r);
    assert_int_equal(c.geometry, VBSS_SESSION_GEOMETRY_POINT | VBSS_SESSION_GEOMETRY_DIRECTION);
    double point[3];
    expect_ok(vbss_needle_get_place(r.scene.needle, 0.64 * 0.0105 * 3.14159265358979, point, NULL));
    for (int k = 0; k < 3; k++) {
        expect_near(point[k], c.point[k], 1e-6);
    }
    rig_take(&r, RIG_RIGHT);
    run(&r);
    c = rig_coaching(&r);
    double tip[3];
    expect_ok(vbss_needle_get_place(r.scene.needle, 0.0, tip, NULL));
    memcpy(mark, c.point, sizeof mark);
    expect_near(vec3_distance(vec3_load(tip), vec3_load(mark)), c.distance, 1e-12);
    expect_near(1.0, vec3_norm(vec3_load(c.direction)), 1e-12);
    rig_pierce(&r, RIG_ENTRY, 1, 0.0);
    run(&r);
    c = rig_coaching(&r);
    assert_true((c.geometry & (uint32_t)VBSS_SESSION_GEOMETRY_ARC) != 0);
    expect_near(0.0105, c.arc_radius, 1e-9);
    expect_near(c.arc_radius, vec3_distance(vec3_load(c.arc_start), vec3_load(c.arc_centre)), 1e-9);
    expect_near(
        0.0,
        vec3_dot(vec3_sub(vec3_load(c.arc_start), vec3_load(c.arc_centre)), vec3_load(c.arc_axis)),
        1e-9);
    rig_end(&r);
}

int test_coach_goals(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stitch_goals_follow_the_needle),
        cmocka_unit_test(a_tail_is_taken_where_jaws_reach_it),
        cmocka_unit_test(throw_goals_follow_the_thread),
        cmocka_unit_test(later_throw_is_wound_for_a_square),
        cmocka_unit_test(opened_slit_is_left_to_the_next_throw),
        cmocka_unit_test(open_slit_is_pulled_from_behind),
        cmocka_unit_test(sides_of_a_seat_are_kept),
        cmocka_unit_test(first_throw_is_pulled_flat),
        cmocka_unit_test(place_to_wind_follows_the_limb),
        cmocka_unit_test(cut_goals_follow_the_tails),
        cmocka_unit_test(each_goal_is_one_event),
        cmocka_unit_test(distances_are_those_of_the_geometry),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
