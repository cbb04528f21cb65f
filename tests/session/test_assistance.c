/* The aids between a hand and its tool. The scene is still: a test looks at the targets of the tools. */
#include <math.h>
#include <string.h>

#include "base/rotation.h"
#include "rig.h"
#include "session/writable.h"

/* Along the direction of the aids, which each test sets to x. */
#define STRIDE 1e-4
#define SLACK 1e-12

typedef struct hand_path {
    rig r;
    vbss_session_hand input;
    vbss_session_phase phase; /* in which each step is made */
} hand_path;

static vbss_grasper_state tool_of(const hand_path *p, int tool)
{
    vbss_grasper_state state;
    expect_ok(vbss_grasper_get_state(p->r.scene.tools[tool], &state, sizeof state));
    return state;
}

static pose target_of(const hand_path *p)
{
    const vbss_grasper_state state = tool_of(p, RIG_RIGHT);
    const double *q = state.target_orientation;
    return pose_make(vec3_load(state.target_position), quat_make(q[0], q[1], q[2], q[3]));
}

/* Facts do not change: the right tool holds the needle from then on if the test says so. */
static void begin(hand_path *p)
{
    memset(p, 0, sizeof *p);
    rig_make(&p->r);
    p->r.scene.config.dwell = 10.0;
    expect_ok(vbss_session_create(p->r.scene.scene, &p->r.scene.config, &p->r.session));
    expect_ok(vbss_session_open(p->r.session, &p->r.s));
    p->phase = VBSS_SESSION_PHASE_APPROACH;
    p->input = vbss_session_hand_default();
    const pose at = target_of(p);
    pose_store(at, p->input.position, p->input.orientation);
    p->input.opening = 1.0;
}

static void step(hand_path *p)
{
    p->r.s->phase = p->phase;
    expect_ok(vbss_session_move_hand(p->r.session, VBSS_METRICS_TOOL_RIGHT, &p->input));
    expect_ok(vbss_session_step(p->r.session, 0.0, RIG_STEP));
}

static void switch_on(hand_path *p, uint32_t aids)
{
    vbss_session_assistance a = vbss_session_assistance_default();
    a.aids = aids;
    a.direction[0] = 2.0;
    expect_ok(vbss_session_set_assistance(p->r.session, &a));
    step(p); /* which takes the origin */
}

static void shift(hand_path *p, double x, double y, double z)
{
    p->input.position[0] += x;
    p->input.position[1] += y;
    p->input.position[2] += z;
    step(p);
}

/* The input turns about an axis of the tool. */
static void turn(hand_path *p, vec3 rotation)
{
    double *q = p->input.orientation;
    const quat to =
        quat_mul(quat_make(q[0], q[1], q[2], q[3]), vbss_quat_from_rotation_vector(rotation));
    pose_store(pose_make(vec3_load(p->input.position), to), p->input.position, q);
    step(p);
}

static void tools_go_where_hands_are(void **state)
{
    (void)state;
    static hand_path p;
    begin(&p);
    for (int i = 0; i < 20; i++) {
        shift(&p, STRIDE, -STRIDE, 0.5 * STRIDE);
        const vbss_grasper_state tool = tool_of(&p, RIG_RIGHT);
        expect_near(p.input.position[0], tool.target_position[0], 0.0);
        expect_near(p.input.position[2], tool.target_position[2], 0.0);
        expect_near(1.0, tool.opening, 0.0);
    }
    assert_int_equal(rig_status(&p.r).aids_used, 0);
    rig_end(&p.r);
}

/* ---- ARC */

static void needle_turns_about_its_own_centre(void **state)
{
    (void)state;
    static hand_path p;
    vbss_needle_state needle;
    begin(&p);
    p.r.s->holding_tools.value = 2;
    switch_on(&p, VBSS_SESSION_AID_ARC);
    expect_ok(vbss_needle_get_state(p.r.scene.needle, &needle, sizeof needle));
    const scene_needle_info info = vbss_scene_inspect_needle(p.r.scene.needle);
    const vec3 axis = quat_rotate(info.pose.orientation, vec3_make(0.0, 0.0, 1.0));
    const pose first = target_of(&p), inverse = pose_inverse(first);
    const pose on_tool = pose_mul(inverse, info.pose);
    for (int i = 1; i <= 300; i++) {
        shift(&p, i <= 200 ? STRIDE : -STRIDE, (i % 7 - 3) * STRIDE, (i % 3 - 1) * STRIDE);
        turn(&p, vec3_make(0.01, 0.0, 0.02));
        /* The needle that the tool would hold. */
        const pose held = pose_mul(target_of(&p), on_tool);
        expect_near(0.0, vec3_distance(held.position, info.pose.position), SLACK);
        double along = (i <= 200 ? i : 400 - i) * STRIDE;
        const quat want =
            quat_mul(vbss_quat_from_rotation_vector(vec3_scale(axis, along / info.arc_radius)),
                     info.pose.orientation);
        expect_near(1.0, fabs(quat_dot(want, held.orientation)), SLACK);
    }
    rig_end(&p.r);
}

/* Neither without the needle, nor in a throw. */
static void arc_needs_a_needle(void **state)
{
    (void)state;
    static hand_path p;
    for (int i = 0; i < 2; i++) {
        begin(&p);
        p.r.s->holding_tools.value = i == 0 ? 0 : 2;
        p.phase = i == 0 ? VBSS_SESSION_PHASE_APPROACH : VBSS_SESSION_PHASE_THROW_1;
        switch_on(&p, VBSS_SESSION_AID_ARC);
        const pose first = target_of(&p);
        shift(&p, 0.0, 5e-3, 0.0);
        expect_near(5e-3, target_of(&p).position.y - first.position.y, SLACK);
        rig_end(&p.r);
    }
}

/* ---- WIND */

static void find_loop(const hand_path *p, vec3 *centre, vec3 *axis)
{
    const scene_grasper_info loop = vbss_scene_inspect_grasper(p->r.scene.tools[RIG_LEFT]);
    *axis = vec3_neg(quat_rotate(loop.pose.orientation, loop.forward));
    *centre = vec3_add_scaled(loop.pose.position, 10e-3, *axis);
}

static void begin_winding(hand_path *p, vec3 *centre, vec3 *axis, double radius)
{
    begin(p);
    p->r.s->holding_tools.value = 2;
    p->phase = VBSS_SESSION_PHASE_THROW_1;
    find_loop(p, centre, axis);
    const vec3 start = vec3_add_scaled(*centre, radius, vec3_any_normal(*axis));
    vec3_store(p->input.position, start);
    p->input.opening = 0.0; /* clear of the other tool */
    step(p);
    switch_on(p, VBSS_SESSION_AID_WIND);
}

static double radius_about(vec3 centre, vec3 axis, vec3 place, double *aside)
{
    const vec3 from = vec3_sub(place, centre);
    *aside = vec3_dot(from, axis);
    return vec3_norm(vec3_add_scaled(from, -*aside, axis));
}

static void winding_keeps_its_radius(void **state)
{
    (void)state;
    static hand_path p;
    vec3 centre, axis;
    double aside, turned = 0.0;
    begin_winding(&p, &centre, &axis, 20e-3);
    const pose first = target_of(&p);
    vec3 before = first.position;
    for (int i = 1; i <= 600; i++) {
        shift(&p, STRIDE, (i % 7 - 3) * STRIDE, (i % 3 - 1) * STRIDE);
        const vec3 now = target_of(&p).position;
        expect_near(20e-3, radius_about(centre, axis, now, &aside), SLACK);
        expect_near(0.0, aside, SLACK);
        const vec3 a = vec3_sub(before, centre), b = vec3_sub(now, centre);
        turned += vec3_dot(vec3_cross(a, b), axis) / (20e-3 * 20e-3);
        before = now;
    }
    /* The sum of sines of small angles; the first throw is wound to the left by the right hand. */
    expect_near(600.0 * STRIDE / 20e-3, turned, 1e-4);
    expect_near(1.0, fabs(quat_dot(first.orientation, target_of(&p).orientation)), SLACK);
    rig_end(&p.r);
}

static void winding_stops_when_turns_come_off(void **state)
{
    (void)state;
    static hand_path p;
    vec3 centre, axis;
    begin_winding(&p, &centre, &axis, 20e-3);
    session_coach *c = &p.r.s->coach;
    const vec3 first = target_of(&p).position;
    c->open |= 1ull << VBSS_SESSION_MISTAKE_TURNS_LOST;
    c->begun[VBSS_SESSION_MISTAKE_TURNS_LOST] = p.r.s->time;
    for (int i = 0; i < 20; i++) {
        shift(&p, STRIDE, 0.0, 0.0);
    }
    expect_near(0.0, vec3_distance(first, target_of(&p).position), SLACK);
    shift(&p, -STRIDE, 0.0, 0.0); /* back it goes */
    const vec3 back = target_of(&p).position;
    expect_near(STRIDE, vec3_distance(first, back), 1e-6);
    c->begun[VBSS_SESSION_MISTAKE_TURNS_LOST] = p.r.s->time - 2.1;
    shift(&p, STRIDE, 0.0, 0.0);
    expect_near(0.0, vec3_distance(first, target_of(&p).position), 1e-6);
    rig_end(&p.r);
}

static void winding_comes_to_its_limits(void **state)
{
    (void)state;
    static hand_path p;
    vec3 centre, axis;
    double aside;
    const double starts[2] = {60e-3, 7.6e-3}, ends[2] = {45e-3, 8e-3};
    for (int k = 0; k < 2; k++) {
        begin_winding(&p, &centre, &axis, starts[k]);
        const vec3 first = target_of(&p).position;
        for (int i = 0; i < 20; i++) { /* what is beside the direction moves nothing */
            shift(&p, 0.0, STRIDE, STRIDE);
        }
        expect_near(0.0, vec3_distance(first, target_of(&p).position), SLACK);
        for (int i = 0; i < 200; i++) {
            shift(&p, STRIDE, 0.0, 0.0);
        }
        /* Near to it, the tool pushes the other one aside for a moment. */
        const double radius = radius_about(centre, axis, target_of(&p).position, &aside);
        assert_true(radius > ends[k] - SLACK && radius < ends[k] + (k == 0 ? SLACK : 0.2e-3));
        rig_end(&p.r);
    }
}

/* The circle shrinks with the free length of the thread. */
static void winding_keeps_the_thread_nearly_taut(void **state)
{
    (void)state;
    static hand_path p;
    begin(&p);
    session_object *s = p.r.s;
    session_observation seen = p.r.observation;
    const scene_thread_info t = vbss_scene_inspect_thread(p.r.scene.thread);
    double arc = 0.0, sign = vbss_session_wanted_sign(s);
    for (uint32_t i = 0; i < 40; i++) {
        arc += t.rest_lengths[i];
    }
    const vec3 centre = vec3_add_scaled(t.positions[40], arc - 30e-3, vec3_make(0.0, 0.0, 1.0));
    expect_near(20e-3, vbss_session_wind_radius(s, &seen, RIG_LEFT, centre, 20e-3, false), SLACK);
    seen.hole_count = 1;
    seen.holes[0] = (session_hole_observation){.id = RIG_EXIT, .thread = seen.thread, .arc = arc};
    s->holes[SESSION_EXIT].id = RIG_EXIT;
    expect_near(0.92 * 30e-3, vbss_session_wind_radius(s, &seen, RIG_LEFT, centre, 20e-3, false),
                1e-9);
    s->coach.turns[RIG_LEFT] = sign * 1.5;
    double wound = 6.283185307179586 * 1.3e-3;
    expect_near(0.92 * (30e-3 - wound),
                vbss_session_wind_radius(s, &seen, RIG_LEFT, centre, 20e-3, false), 1e-9);
    /* Winding on, the circle does not grow with the limb: that comes out of the stitch. */
    expect_near(15e-3, vbss_session_wind_radius(s, &seen, RIG_LEFT, centre, 15e-3, true), 1e-9);
    expect_near(0.92 * (30e-3 - wound),
                vbss_session_wind_radius(s, &seen, RIG_LEFT, centre, 25e-3, true), 1e-9);
    /* Pulled, it shrinks; wound back it need not. */
    seen.needle_pull = 0.05;
    expect_near(15e-3, vbss_session_wind_radius(s, &seen, RIG_LEFT, centre, 15e-3, true), 1e-9);
    seen.needle_pull = 0.2;
    expect_near(0.9 * 15e-3, vbss_session_wind_radius(s, &seen, RIG_LEFT, centre, 15e-3, true),
                1e-9);
    expect_near(0.92 * (30e-3 - wound),
                vbss_session_wind_radius(s, &seen, RIG_LEFT, centre, 15e-3, false), 1e-9);
    seen.needle_pull = 0.0;
    s->coach.turns[RIG_LEFT] = sign * 0.9;
    wound = 6.283185307179586 * 0.4 * 1.3e-3;
    expect_near(0.92 * (30e-3 - wound),
                vbss_session_wind_radius(s, &seen, RIG_LEFT, centre, 15e-3, true), 1e-9);
    s->coach.turns[RIG_LEFT] = sign * 1.5;
    s->knot.is_located = true; /* so long a part of the thread is in it */
    s->knot.end_arcs[SESSION_EXIT] = arc - 40e-3;
    expect_near(8e-3, vbss_session_wind_radius(s, &seen, RIG_LEFT, centre, 20e-3, false), SLACK);
    rig_end(&p.r);
}

/* A tied throw keeps some tension in the limb beside the stitch. */
static void a_hand_pulls_with_the_tension_beside_the_needle(void **state)
{
    (void)state;
    static hand_path p;
    begin(&p);
    const scene_thread_info t = vbss_scene_inspect_thread(p.r.scene.thread);
    double *tensions = writable(t.tensions), arc = 0.0;
    session_observation seen;
    for (int k = 0; k < 2; k++) {
        arc = 0.0;
        for (uint32_t i = 0; i + 1 < t.node_count; i++) {
            tensions[i] = arc < 11e-3 ? 0.2 * k + (i == 3 ? 0.1 : 0.0) : 0.3;
            arc += t.rest_lengths[i];
        }
        vbss_session_observe(p.r.s, &seen);
        expect_near(0.2 * k, seen.needle_pull, SLACK);
    }
    rig_end(&p.r);
}

/* ---- SNAP_ROLL */

#define EIGHTH 0.78539816339744831

/* Out of the tissue, unit. */
static vec3 up_of(const hand_path *p)
{
    const scene_drain_info d = vbss_scene_inspect_drain(p->r.scene.drain);
    const vec3 middle = vec3_lerp(d.positions[d.marks[0]], d.positions[d.marks[1]], 0.5);
    return vec3_unit_or(vec3_sub(middle, d.centre), vec3_zero());
}

/* Roll of the target about its shaft from where its jaws open along the slit, in steps of pi / 4. */
static double steps_of_roll(const hand_path *p)
{
    const scene_drain_info d = vbss_scene_inspect_drain(p->r.scene.drain);
    const vec3 across = vec3_sub(d.positions[d.marks[1]], d.positions[d.marks[0]]);
    const vec3 along = vec3_cross(up_of(p), vec3_unit_or(across, vec3_zero()));
    const quat q = target_of(p).orientation;
    const vec3 shaft = quat_rotate(q, vec3_make(0.0, 0.0, 1.0));
    const vec3 jaws = quat_rotate(q, vec3_make(1.0, 0.0, 0.0));
    const vec3 zero =
        vec3_unit_or(vec3_add_scaled(along, -vec3_dot(along, shaft), shaft), vec3_zero());
    return atan2(vec3_dot(vec3_cross(zero, jaws), shaft), vec3_dot(zero, jaws)) / EIGHTH;
}

static double off_step(double steps)
{
    return fabs(steps - floor(steps + 0.5));
}

static void rest_hand(hand_path *p)
{
    double before = steps_of_roll(p);
    for (int i = 0; i < 400; i++) {
        step(p);
        const double now = steps_of_roll(p);
        double change = fabs(now - before);
        change = change > 4.0 ? 8.0 - change : change;
        assert_true(change * EIGHTH < 3.1 * RIG_STEP); /* no jump: 3 rad/s */
        before = now;
        if (i > 2 && change < 1e-12) {
            return;
        }
    }
}

static void roll_snaps_to_steps(void **state)
{
    (void)state;
    static hand_path p;
    begin(&p);
    turn(&p, vec3_make(0.2, 0.1, 0.3)); /* anyhow */
    switch_on(&p, VBSS_SESSION_AID_SNAP_ROLL);
    rest_hand(&p);
    assert_true(off_step(steps_of_roll(&p)) < 1e-9);
    double last = steps_of_roll(&p);
    int changes = 0;
    for (int i = 0; i < 16; i++) { /* a whole turn, by half steps */
        turn(&p, vec3_make(0.0, 0.0, 0.5 * EIGHTH));
        rest_hand(&p);
        const double now = steps_of_roll(&p);
        assert_true(off_step(now) < 1e-9);
        changes += fabs(now - last) > 0.5;
        last = now;
    }
    assert_in_range(changes, 7, 9); /* by the roll at first */
    for (int i = 0; i < 60 && fabs(steps_of_roll(&p) - last) < 0.5; i++) { /* to the next step */
        turn(&p, vec3_make(0.0, 0.0, 0.02 * EIGHTH));
        rest_hand(&p);
    }
    turn(&p, vec3_make(0.0, 0.0, -0.11 * EIGHTH)); /* back beyond the middle between both */
    rest_hand(&p);
    last = steps_of_roll(&p);
    changes = 0;
    for (int i = 0; i < 20; i++) { /* a tremor about that middle */
        turn(&p, vec3_make(0.0, 0.0, (i % 2 == 0 ? 0.2 : -0.2) * EIGHTH));
        rest_hand(&p);
        changes += fabs(steps_of_roll(&p) - last) > 0.5;
        last = steps_of_roll(&p);
    }
    assert_int_equal(changes, 0);
    /* Switched off, the tool stays as it is. */
    expect_ok(vbss_session_set_assistance(p.r.session, NULL));
    const pose snapped = target_of(&p);
    step(&p);
    step(&p);
    expect_near(1.0, fabs(quat_dot(snapped.orientation, target_of(&p).orientation)), SLACK);
    rig_end(&p.r);
}

/* ---- SLOW_MOTION */

static void time_goes_slower(void **state)
{
    (void)state;
    static hand_path p;
    begin(&p);
    vbss_session_assistance a = vbss_session_assistance_default();
    a.aids = VBSS_SESSION_AID_SLOW_MOTION;
    a.time_scale = 0.25;
    expect_ok(vbss_session_set_assistance(p.r.session, &a));
    step(&p); /* the clock begins at its end */
    for (int i = 0; i < 100; i++) {
        step(&p);
    }
    expect_near(0.25 * 100.0 * RIG_STEP, rig_status(&p.r).time, 1e-12);
    rig_end(&p.r);
}

/* ---- HOVER */

static void climb(hand_path *p, double speed, double aside)
{
    const vec3 up = up_of(p), side = vec3_any_normal(up);
    const vec3 by = vec3_add_scaled(vec3_scale(up, speed * RIG_STEP), aside, side);
    shift(p, by.x, by.y, by.z);
}

static void hands_that_sink_keep_their_height(void **state)
{
    (void)state;
    static hand_path p;
    begin(&p);
    switch_on(&p, VBSS_SESSION_AID_HOVER);
    const vec3 first = target_of(&p).position, up = up_of(&p);
    for (int i = 0; i < 1000; i++) { /* 2 mm/s down, while it goes aside */
        climb(&p, -2e-3, 0.3 * STRIDE);
    }
    vec3 now = target_of(&p).position;
    expect_near(0.0, vec3_dot(vec3_sub(now, first), up), SLACK);
    expect_near(1000 * 0.3 * STRIDE, vec3_distance(now, first), 1e-9);
    for (int i = 0; i < 500; i++) { /* 20 mm/s down is meant */
        climb(&p, -20e-3, 0.0);
    }
    now = target_of(&p).position;
    assert_true(vec3_dot(vec3_sub(first, now), up) > 0.85 * 10e-3); /* but for the first moment */
    for (int i = 0; i < 500; i++) {                                 /* up, however slowly */
        climb(&p, 2e-3, 0.0);
    }
    expect_near(1e-3, vec3_dot(vec3_sub(target_of(&p).position, now), up), 1e-9);
    rig_end(&p.r);
}

/* ---- AUTO_HOLD */

static void idle_tools_stay(void **state)
{
    (void)state;
    static hand_path p;
    begin(&p);
    p.input.opening = 0.1;
    switch_on(&p, VBSS_SESSION_AID_AUTO_HOLD);
    for (int i = 0; i < 800; i++) {
        step(&p);
    }
    const pose held = target_of(&p);
    for (int i = 0; i < 400; i++) { /* tremor of hand and grip */
        const double swing = i % 100 < 50 ? STRIDE / 4.0 : -STRIDE / 4.0;
        p.input.opening = i % 100 < 50 ? 0.3 : 0.05;
        shift(&p, swing, swing, 0.0);
        expect_near(0.0, vec3_distance(held.position, target_of(&p).position), 0.0);
        expect_near(0.1, tool_of(&p, RIG_RIGHT).opening, 0.0);
    }
    for (int i = 0; i < 100; i++) { /* 10 mm */
        shift(&p, STRIDE, 0.0, 0.0);
    }
    const double moved = target_of(&p).position.x - held.position.x;
    assert_true(moved > 7e-3 && moved < 9e-3); /* but for those in which it rested */
    p.input.opening = 0.9;
    step(&p);
    expect_near(0.9, tool_of(&p, RIG_RIGHT).opening, 0.0);
    for (int i = 0; i < 800; i++) {
        step(&p);
    }
    p.input.opening = 0.2; /* a grip ends the hold, too */
    step(&p);
    expect_near(0.2, tool_of(&p, RIG_RIGHT).opening, 0.0);
    rig_end(&p.r);
}

/* ---- together */

/* A relative input, such as a mouse, starts at the tool. */
static void an_origin_moves_nothing(void **state)
{
    (void)state;
    static hand_path p;
    begin(&p);
    switch_on(&p, VBSS_SESSION_AID_HOVER);
    const pose first = target_of(&p);
    p.input.position[0] += 0.05;
    p.input.is_origin = 1;
    expect_ok(vbss_session_move_hand(p.r.session, VBSS_METRICS_TOOL_RIGHT, &p.input));
    p.input.is_origin = 0;
    step(&p);
    expect_near(0.0, vec3_distance(first.position, target_of(&p).position), SLACK);
    shift(&p, 1e-3, 0.0, 0.0);
    expect_near(1e-3, target_of(&p).position.x - first.position.x, SLACK);
    rig_end(&p.r);
}

static void bad_input_is_refused(void **state)
{
    (void)state;
    static hand_path p;
    begin(&p);
    vbss_session *s = p.r.session;
    vbss_session_hand hand = p.input;
    vbss_session_assistance a = vbss_session_assistance_default();
    a.aids = VBSS_SESSION_AID_ALL + 1;
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_session_set_assistance(s, &a));
    a.aids = VBSS_SESSION_AID_ALL;
    a.time_scale = 0.1;
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_session_set_assistance(s, &a));
    a.time_scale = 1.0;
    a.direction[1] = 1e-12;
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_session_set_assistance(s, &a));
    expect_ok(vbss_session_get_assistance(s, &a, sizeof a));
    assert_int_equal(a.aids, 0);
    expect_result(VBSS_ERROR_NULL_ARGUMENT,
                  vbss_session_move_hand(s, VBSS_METRICS_TOOL_LEFT, NULL));
    expect_result(VBSS_ERROR_OUT_OF_RANGE,
                  vbss_session_move_hand(s, VBSS_METRICS_TOOL_NONE, &hand));
    hand.opening = 1.5;
    expect_result(VBSS_ERROR_OUT_OF_RANGE,
                  vbss_session_move_hand(s, VBSS_METRICS_TOOL_LEFT, &hand));
    hand.opening = 1.0;
    hand.position[1] = (double)NAN;
    expect_result(VBSS_ERROR_NOT_FINITE, vbss_session_move_hand(s, VBSS_METRICS_TOOL_LEFT, &hand));
    hand.position[1] = 0.0;
    memset(hand.orientation, 0, sizeof hand.orientation);
    expect_result(VBSS_ERROR_OUT_OF_RANGE,
                  vbss_session_move_hand(s, VBSS_METRICS_TOOL_LEFT, &hand));
    rig_end(&p.r);
}

int test_assistance(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tools_go_where_hands_are),
        cmocka_unit_test(needle_turns_about_its_own_centre),
        cmocka_unit_test(arc_needs_a_needle),
        cmocka_unit_test(winding_keeps_its_radius),
        cmocka_unit_test(winding_stops_when_turns_come_off),
        cmocka_unit_test(winding_comes_to_its_limits),
        cmocka_unit_test(winding_keeps_the_thread_nearly_taut),
        cmocka_unit_test(a_hand_pulls_with_the_tension_beside_the_needle),
        cmocka_unit_test(roll_snaps_to_steps),
        cmocka_unit_test(time_goes_slower),
        cmocka_unit_test(hands_that_sink_keep_their_height),
        cmocka_unit_test(idle_tools_stay),
        cmocka_unit_test(an_origin_moves_nothing),
        cmocka_unit_test(bad_input_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
