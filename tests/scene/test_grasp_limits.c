/* What jaws bear: Coulomb friction of both faces, along them, about their normal, and no more than they press
 * across. Beyond that a thread slides, turns, is torn out. */
#include "base/elementary.h"
#include "scene/tools_rig.h"

static const vec3 home = {0.0, 0.0, -2e-3};

typedef struct pull {
    double speed, largest, mean; /* m/s; N, of the force of the jaws while it slid */
    double slid, limit;
} pull;

/* A thread with one end pinned, and a tool that is drawn along it by 6 mm. */
static pull pulled_through(double pressure, double friction, double speed)
{
    tools_rig r;
    pull p = {speed, 0.0, 0.0, 0.0, 0.0};
    tools_begin(&r);
    r.config.closing_force = pressure;
    r.config.grip_friction = friction;
    r.config.stiffness = r.config.turning_stiffness = 1e5; /* the tip is where the hand is */
    small_create(&r.s);
    tools_thread(&r, TOOLS_FIRST, 0.0);
    tools_add(&r, vec3_make(0.0, -5e-3, -2e-3));
    tools_close(&r, 0);
    uint32_t steps = (uint32_t)(6e-3 / (1e-3 * speed)), count = 0;
    for (uint32_t i = 1; i <= steps; i++) {
        tools_move(&r, 0, vec3_make(0.0, -5e-3 + 1e-3 * speed * i, -2e-3));
        tools_steps(&r, 1);
        vbss_scene_grasp grasp = tools_grasp(&r, 0, 0);
        if (2 * i > steps) {
            double tension = vec3_norm(vec3_load(grasp.force));
            expect_near(tension, small_tension(r.thread, 5), 0.01 * tension);
            p.largest = vbss_max(p.largest, tension);
            p.mean += tension;
            count++;
        }
        p.slid = grasp.slid;
        p.limit = grasp.limit;
    }
    p.mean /= count;
    tools_end(&r);
    return p;
}

static void grasped_thread_slides_at_friction_of_both_faces(void **state)
{
    (void)state;
    const double cases[][2] = {{8.0, 0.5}, {8.0, 0.25}, {2.0, 0.5}, {4.0, 0.1}};
    for (int i = 0; i < 4; i++) {
        pull p = pulled_through(cases[i][0], cases[i][1], 2e-3);
        double limit = 2.0 * cases[i][0] * cases[i][1];
        expect_near(limit, p.limit, 1e-12);
        expect_near(limit, p.mean, 0.01 * limit);
        assert_true(p.slid > 3e-3);
    }
}

/* What exceeds the limit is let go at the end of a step: within one it is what the springs gain. */
static void grip_force_lags_by_one_step(void **state)
{
    (void)state;
    const double speeds[] = {1e-3, 1e-2, 5e-2, 0.1};
    for (int i = 0; i < 4; i++) {
        pull p = pulled_through(1.0, 0.5, speeds[i]);
        double lag = 1e-3 * speeds[i] * 3000.0;
        assert_true(p.mean >= p.limit);
        assert_true(p.largest <= p.limit + 1.01 * lag);
        expect_near(p.limit + lag, p.mean, 0.1 * lag + 1e-3);
    }
}

/* The handle presses as far as it is squeezed beyond what the jaws hold. */
static void grip_limit_grows_with_pressure(void **state)
{
    (void)state;
    tools_rig r;
    tools_begin_scene(&r);
    tools_thread(&r, TOOLS_FIRST, 0.0);
    tools_add(&r, home);
    tools_close(&r, 0);
    const vbss_grasper_config *c = &r.config;
    double held = tools_state(&r, 0).jaw_angle, last = 1e9;
    for (int i = 0; i <= 20; i++) {
        double opening = 0.01 * i;
        double reported = opening * c->driver_opening - (1.0 - opening) * c->closing_angle;
        double share = vbss_min((held - reported) / c->closing_angle, 1.0);
        tools_open(&r, 0, opening);
        tools_steps(&r, 1);
        expect_near(c->closing_force * share, tools_state(&r, 0).pressure, 1e-9);
        expect_near(2.0 * c->grip_friction * c->closing_force * share, tools_grasp(&r, 0, 0).limit,
                    1e-9);
        assert_true(tools_grasp(&r, 0, 0).limit <= last);
        last = tools_grasp(&r, 0, 0).limit;
    }
    tools_end(&r);
}

static void weaker_of_two_tools_slips(void **state)
{
    (void)state;
    for (int weak = 0; weak < 2; weak++) {
        tools_rig r;
        vbss_scene_event event;
        uint32_t slips[2] = {0, 0};
        tools_begin(&r);
        r.config.stiffness = 2000.0;
        r.config.turning_stiffness = 200.0;
        small_create(&r.s);
        tools_thread(&r, TOOLS_NEITHER, 0.0);
        for (int k = 0; k < 2; k++) {
            r.config.closing_force = k == weak ? 0.8 : 3.0;
            tools_add(&r, vec3_make(0.0, k == 0 ? -5e-3 : 5e-3, -2e-3));
        }
        tools_open(&r, 0, 0.0);
        tools_close(&r, 1);
        for (uint32_t i = 1; i <= 2000; i++) {
            tools_move(&r, 1, vec3_make(0.0, 5e-3 + 2e-6 * i, -2e-3));
            tools_steps(&r, 1);
            if (tools_happened(&r, VBSS_SCENE_EVENT_SLIP, &event) > 0) {
                slips[event.body_b == r.bodies[1]]++;
            }
            /* At every moment one bears what the other does. */
            expect_near(-tools_grasp(&r, 0, 0).force[1], tools_grasp(&r, 1, 0).force[1], 2e-3);
        }
        assert_int_equal(slips[weak], 1);
        assert_int_equal(slips[1 - weak], 0);
        vbss_scene_grasp weaker = tools_grasp(&r, (uint32_t)weak, 0);
        vbss_scene_grasp stronger = tools_grasp(&r, (uint32_t)(1 - weak), 0);
        assert_true(weaker.slid > 1e-3);
        expect_near(0.0, stronger.slid, 0.0);
        expect_near(0.8, weaker.limit, 1e-12);
        expect_near(0.8, small_tension(r.thread, 30), 0.01 * 0.8);
        expect_near(0.8, fabs(tools_hand_force(&r, 0).y), 0.01 * 0.8);
        expect_near(0.8, fabs(tools_hand_force(&r, 1).y), 0.01 * 0.8);
        tools_end(&r);
    }
}

/* A rod that the tool turns, ends pinned: the jaws bear half a grip's length times half their limit. */
static void grasped_thread_turns_at_torque_limit(void **state)
{
    (void)state;
    tools_rig r;
    tools_begin(&r);
    r.s.thread.bending_stiffness = 1e-5;
    r.s.thread.axial_stiffness = 4000.0;
    r.config.closing_force = 0.5;
    r.config.turning_stiffness = r.config.stiffness = 1e5;
    small_create(&r.s);
    tools_thread(&r, TOOLS_BOTH, 0.0);
    tools_add(&r, home);
    tools_close(&r, 0);
    double limit = 0.25 * r.config.grip_length * tools_grasp(&r, 0, 0).limit, largest = 0.0;
    for (uint32_t i = 1; i <= 900; i++) {
        double half = 0.5 * 1e-3 * i,
               tip[3] = {0.0, 2e-3 * vbss_sin(2.0 * half), -2e-3 * vbss_cos(2.0 * half)};
        const double turned[4] = {vbss_cos(half), vbss_sin(half), 0.0, 0.0};
        expect_ok(vbss_grasper_set_target(r.tools[0], tip, turned)); /* about where it holds */
        tools_steps(&r, 1);
        vbss_grasper_state tool = tools_state(&r, 0);
        vec3 arm = vec3_neg(vec3_load(tool.position));
        vec3 force = vec3_load(tool.hand_force);
        double torque = vec3_load(tool.hand_torque).x - vec3_cross(arm, force).x;
        largest =
            i > 100 ? vbss_max(largest, fabs(torque)) : 0.0; /* the tool has come up to speed */
        if (i > 800) {
            expect_near(limit, fabs(torque), 0.03 * limit);
        }
    }
    assert_true(largest < 1.05 * limit);
    assert_int_equal(tools_state(&r, 0).grasp_count, 1);
    tools_end(&r);
}

/* Pulled from face to face, a thread pries the jaws with no more than they press, and comes out. */
static void jaws_are_pried_open_above_closing_force(void **state)
{
    (void)state;
    tools_rig r;
    vbss_scene_event event;
    uint32_t torn = 0;
    tools_begin(&r);
    r.config.closing_force = 0.5;
    r.config.turning_stiffness = 200.0;
    small_create(&r.s);
    tools_thread(&r, TOOLS_BOTH, 0.0);
    tools_add(&r, home);
    tools_close(&r, 0);
    for (uint32_t i = 1; i <= 4000 && torn == 0; i++) {
        tools_move(&r, 0, vec3_make(2e-6 * i, 0.0, -2e-3));
        tools_steps(&r, 1);
        torn = tools_happened(&r, VBSS_SCENE_EVENT_TORN, &event);
        if (torn == 0) {
            assert_true(fabs(tools_grasp(&r, 0, 0).force[0]) <= 0.5 + 64.0 * 3000.0 * 2.5e-6);
        }
    }
    assert_int_equal(torn, 1);
    assert_int_equal(tools_state(&r, 0).grasp_count, 0);
    tools_end(&r);
}

/* Out over the thread's end: once, and then nothing holds it; nothing of it is lost. */
static void thread_is_torn_out_over_its_end(void **state)
{
    (void)state;
    for (int up = 0; up < 2; up++) {
        tools_rig r;
        vbss_scene_event event;
        uint32_t count[VBSS_SCENE_EVENT_NOT_EXCHANGED + 1] = {0};
        tools_begin(&r);
        r.config.closing_force = 0.5;
        small_create(&r.s);
        tools_thread(&r, TOOLS_NEITHER, 0.0);
        uint32_t pin = small_pin(&r.s, r.body, up ? 0 : TOOLS_NODES - 1, 0);
        double length = tools_length(&r), sign = up ? 1.0 : -1.0;
        (void)pin;
        tools_add(&r, home);
        tools_close(&r, 0);
        for (uint32_t i = 1; i <= 2500; i++) {
            tools_move(&r, 0, vec3_make(0.0, sign * 1e-5 * i, -2e-3));
            tools_steps(&r, 1);
            for (uint32_t k = VBSS_SCENE_EVENT_GRASP; k <= VBSS_SCENE_EVENT_SLIP; k++) {
                count[k] += tools_happened(&r, (vbss_scene_event_kind)k, &event);
            }
        }
        assert_int_equal(count[VBSS_SCENE_EVENT_GRASP], 0); /* not again */
        assert_int_equal(count[VBSS_SCENE_EVENT_SLIP], 1);
        assert_int_equal(count[VBSS_SCENE_EVENT_TORN], 1);
        assert_int_equal(count[VBSS_SCENE_EVENT_RELEASE], 0);
        assert_int_equal(tools_state(&r, 0).grasp_count, 0);
        expect_near(0.0, tools_state(&r, 0).jaw_angle, 0.0);
        expect_near(0.0, vec3_norm(tools_hand_force(&r, 0)), 1e-3);
        expect_same_bits(length, tools_length(&r));
        assert_int_equal(small_statistics(&r.s).clamped, 0);
        tools_end(&r);
    }
}

int test_grasp_limits(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(grasped_thread_slides_at_friction_of_both_faces),
        cmocka_unit_test(grip_force_lags_by_one_step),
        cmocka_unit_test(grip_limit_grows_with_pressure),
        cmocka_unit_test(weaker_of_two_tools_slips),
        cmocka_unit_test(grasped_thread_turns_at_torque_limit),
        cmocka_unit_test(jaws_are_pried_open_above_closing_force),
        cmocka_unit_test(thread_is_torn_out_over_its_end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
