/* What hands do wrong with jaws: close on nothing, on an end, on two strands, both on one segment; let go under
 * load; shake. Nothing passes through jaws, nothing is pulled by what is not there, no step is cut short. */
#include "base/elementary.h"
#include "scene/tools_rig.h"

static const vec3 home = {0.0, 0.0, -2e-3};

static void expect_no_step_was_cut_short(const tools_rig *r)
{
    assert_int_equal(small_statistics(&r->s).clamped, 0);
}

static void closing_on_nothing_holds_nothing(void **state)
{
    (void)state;
    tools_rig r;
    vbss_scene_event event;
    tools_begin_scene(&r);
    tools_add(&r, home);
    tools_open(&r, 0, 0.0);
    for (int i = 0; i < 200; i++) {
        tools_steps(&r, 1);
        assert_int_equal(tools_happened(&r, VBSS_SCENE_EVENT_GRASP, &event), 0);
    }
    vbss_grasper_state tool = tools_state(&r, 0);
    expect_near(0.0, tool.jaw_angle, 0.0);
    expect_near(0.0, tool.pressure, 0.0);
    expect_near(0.0, vec3_norm(tools_hand_force(&r, 0)), 1e-9);
    tools_end(&r);
}

/* Less than the grip's length is left: what is not there is not held, and pulls at nothing. */
static void closing_on_end_adds_no_strain(void **state)
{
    (void)state;
    for (int e = -6; e <= 2; e++) {
        for (int which = 0; which < 2; which++) {
            tools_rig r;
            double sign = which == 0 ? 1.0 : -1.0;
            tools_begin_scene(&r);
            tools_thread(&r, TOOLS_NEITHER, 3e-4);
            r.pins[0] = small_pin(&r.s, r.body, which == 0 ? 0 : TOOLS_NODES - 1, 0);
            tools_add(&r, vec3_make(0.0, sign * (0.015 + 1e-4 * e), -2e-3));
            tools_close(&r, 0);
            assert_int_equal(tools_state(&r, 0).grasp_count, 1);
            expect_near(0.0, vec3_norm(tools_pin_force(&r, 0)), 1e-3);
            expect_near(0.0, vec3_norm(tools_hand_force(&r, 0)), 1e-3);
            expect_no_step_was_cut_short(&r);
            tools_end(&r);
        }
    }
}

/* One on the other between the faces, or one above the other along them. */
static void two_strands_share_pressure(void **state)
{
    (void)state;
    const vec3 second[] = {{-3e-4, 0.0, 0.0}, {-3e-4, 0.0, 8e-4}, {3e-4, 0.0, -6e-4}};
    for (int k = 0; k < 3; k++) {
        tools_rig r;
        tools_begin_scene(&r);
        tools_thread(&r, TOOLS_BOTH, 3e-4);
        vec3 half = vec3_make(0.0, 0.015, 0.0);
        vbss_thread *thread;
        uint32_t other = small_thread(&r.s, vec3_sub(second[k], half), vec3_add(second[k], half),
                                      TOOLS_SEGMENTS, &thread);
        small_pin_ends(&r.s, other, TOOLS_NODES);
        tools_add(&r, home);
        tools_close(&r, 0);
        assert_int_equal(tools_state(&r, 0).grasp_count, 2);
        for (uint32_t i = 0; i < 2; i++) {
            vbss_scene_grasp grasp = tools_grasp(&r, 0, i);
            assert_int_equal(grasp.body, i == 0 ? r.body : other);
            expect_near(r.config.grip_friction * r.config.closing_force, grasp.limit, 1e-12);
        }
        assert_true(vec3_distance(tools_node(&r, 30), small_node(thread, 30)) > 2.4e-4);
        assert_true(small_statistics(&r.s).penetration < 0.1 * 2.5e-4);
        expect_no_step_was_cut_short(&r);
        tools_open(&r, 0, 1.0);
        tools_steps(&r, 300);
        expect_near(tools_state(&r, 0).jaw_angle, r.config.driver_opening, 0.0);
        expect_no_step_was_cut_short(&r);
        tools_end(&r);
    }
}

/* A segment of 5 mm. */
static void two_tools_hold_one_segment(void **state)
{
    (void)state;
    tools_rig r;
    tools_begin_scene(&r);
    r.body =
        small_thread(&r.s, vec3_make(0.0, -0.0125, 0.0), vec3_make(0.0, 0.0125, 0.0), 5, &r.thread);
    small_pin_ends(&r.s, r.body, 6);
    const double y[2] = {-1.2e-3, 1.2e-3};
    for (uint32_t k = 0; k < 2; k++) {
        tools_add(&r, vec3_make(0.0, (k == 0 ? -1.0 : 1.0) * 6e-3, -2e-3));
    }
    /* Shafts beside each other would touch: they lean apart. */
    for (uint32_t k = 0; k < 2; k++) {
        double sign = k == 0 ? 1.0 : -1.0;
        const double q[4] = {vbss_cos(0.3), sign * vbss_sin(0.3), 0.0, 0.0};
        for (int i = 0; i <= 100; i++) {
            double begin = -6e-3 * sign, t = 0.01 * i;
            double tip[3] = {0.0, begin + t * (y[k] - begin), -1e-3};
            expect_ok(vbss_grasper_set_target(r.tools[k], tip, q));
            tools_steps(&r, 1);
        }
    }
    tools_open(&r, 0, 0.0);
    tools_close(&r, 1);
    for (uint32_t k = 0; k < 2; k++) {
        assert_int_equal(tools_state(&r, k).grasp_count, 1);
        double arc = tools_grasp(&r, k, 0).arc_length;
        assert_true(arc > 10e-3 && arc < 15e-3);
    }
    for (int i = 1; i <= 400; i++) { /* apart, against each other */
        for (uint32_t k = 0; k < 2; k++) {
            double sign = k == 0 ? 1.0 : -1.0;
            double tip[3] = {0.0, y[k] - 2e-6 * i * sign, -1e-3};
            expect_ok(vbss_grasper_set_target(r.tools[k], tip, NULL));
        }
        tools_steps(&r, 1);
    }
    tools_steps(&r, 500);
    vec3 sum = vec3_add(tools_hand_force(&r, 0), tools_hand_force(&r, 1));
    vec3 grasps =
        vec3_add(vec3_load(tools_grasp(&r, 0, 0).force), vec3_load(tools_grasp(&r, 1, 0).force));
    expect_near(0.0, vec3_norm(vec3_add(sum, grasps)), 1e-6);
    assert_true(fabs(tools_hand_force(&r, 0).y) > 0.05);
    expect_no_step_was_cut_short(&r);
    tools_open(&r, 0, 1.0);
    tools_open(&r, 1, 1.0);
    tools_steps(&r, 200);
    expect_no_step_was_cut_short(&r);
    tools_end(&r);
}

/* Drawn aside and let go: the thread presses on the jaw at its side and comes away past its end; it does not go
 * through. */
static void thread_released_under_load_does_not_pass_jaws(void **state)
{
    (void)state;
    const double offsets[] = {5e-4, 2e-3, 5e-3};
    for (int k = 0; k < 6; k++) {
        tools_rig r;
        double z = k < 3 ? -2e-3 : -6e-3;
        tools_begin_scene(&r);
        tools_thread(&r, TOOLS_BOTH, 0.0);
        tools_add(&r, vec3_make(0.0, 0.0, z));
        tools_close(&r, 0);
        tools_move_along(&r, 0, vec3_make(0.0, 0.0, z), vec3_make(offsets[k % 3], 0.0, z), 200);
        assert_int_equal(tools_state(&r, 0).grasp_count, 1);
        tools_open(&r, 0, 1.0);
        for (int i = 0; i < 300; i++) {
            vbss_view view;
            double jaw[7];
            tools_steps(&r, 1);
            expect_ok(
                vbss_grasper_get_view(r.tools[0], VBSS_GRASPER_VIEW_CAPSULES, &view, sizeof view));
            memcpy(jaw, (const char *)view.data + 2 * (size_t)view.stride_bytes, sizeof jaw);
            vec3 node = tools_node(&r, 30);
            double share = (node.z - jaw[2]) / (jaw[5] - jaw[2]);
            if (share > 0.0 && share < 1.0) { /* beside it, and on its inner side */
                assert_true(node.x > jaw[0] + share * (jaw[3] - jaw[0]));
            }
        }
        expect_no_step_was_cut_short(&r);
        tools_end(&r);
    }
}

/* The handle is not still for a moment. */
static void instant_close_and_open_grasps_and_releases(void **state)
{
    (void)state;
    tools_rig r;
    vbss_scene_event event;
    uint32_t taken = 0, released = 0;
    tools_begin_scene(&r);
    tools_thread(&r, TOOLS_BOTH, 2e-4);
    double length = tools_length(&r);
    tools_add(&r, home);
    tools_close(&r, 0);
    for (int i = 0; i < 2000; i++) {
        tools_open(&r, 0, i % 7 < 3 ? 0.4 : 0.0);
        tools_move(&r, 0, vec3_make(5e-4 * (i % 7) / 7.0, 0.0, -2e-3));
        tools_steps(&r, 1);
        taken += tools_happened(&r, VBSS_SCENE_EVENT_GRASP, &event);
        released += tools_happened(&r, VBSS_SCENE_EVENT_RELEASE, &event);
    }
    assert_true(taken > 200);
    assert_true(released == taken || released == taken + 1);
    assert_true(small_statistics(&r.s).clamped < 20);
    expect_same_bits(length, tools_length(&r));
    tools_end(&r);
}

static void shaking_hand_keeps_grasp(void **state)
{
    (void)state;
    tools_rig r;
    tools_begin_scene(&r);
    tools_thread(&r, TOOLS_FIRST, 0.0);
    tools_add(&r, home);
    tools_close(&r, 0);
    for (uint32_t i = 1; i <= 400; i++) {
        tools_move(&r, 0, vec3_make(3e-3 * (i & 1), 2e-3 * ((i >> 1) & 1), -2e-3));
        tools_steps(&r, 1);
    }
    assert_int_equal(tools_state(&r, 0).grasp_count, 1);
    assert_true(small_statistics(&r.s).last_stretch_error < 1e-3);
    expect_no_step_was_cut_short(&r);
    tools_end(&r);
}

/* No room: it is told, and the jaws stop at the thread nevertheless. */
static void grasp_above_capacity_is_reported(void **state)
{
    (void)state;
    tools_rig r;
    vbss_scene_event event;
    tools_begin(&r);
    r.s.config.grasp_capacity = 0;
    small_create(&r.s);
    tools_thread(&r, TOOLS_BOTH, 0.0);
    tools_add(&r, home);
    tools_close(&r, 0);
    assert_true(tools_happened(&r, VBSS_SCENE_EVENT_GRASP_LOST, &event) == 1);
    assert_int_equal(event.body_a, r.body);
    assert_int_equal(event.body_b, r.bodies[0]);
    assert_int_equal(tools_state(&r, 0).grasp_count, 0);
    assert_true(tools_state(&r, 0).jaw_angle > 0.01);
    tools_end(&r);
}

/* Either side may leave while it is held. */
static void removal_releases_grasp(void **state)
{
    (void)state;
    for (int which = 0; which < 2; which++) {
        tools_rig r;
        tools_begin_scene(&r);
        tools_thread(&r, TOOLS_BOTH, 0.0);
        tools_add(&r, home);
        tools_close(&r, 0);
        expect_ok(vbss_scene_remove(r.s.scene, which == 0 ? r.body : r.bodies[0]));
        tools_steps(&r, 50);
        vbss_grasper_state tool = tools_state(&r, 0);
        assert_int_equal(tool.grasp_count, 0);
        expect_near(0.0, tool.pressure, 0.0);
        if (which == 0) {
            expect_near(0.0, tool.jaw_angle, 0.0);
            expect_ok(vbss_thread_step(r.thread, 1e-3));
        } else {
            assert_int_equal(tool.body, 0);
            expect_near(0.0, vec3_norm(tools_hand_force(&r, 0)), 0.0);
            expect_ok(vbss_scene_add_grasper(r.s.scene, r.tools[0], &r.bodies[0]));
            tools_steps(&r, 50);
            expect_ok(vbss_scene_remove(r.s.scene, r.bodies[0]));
            expect_ok(vbss_grasper_destroy(r.tools[0]));
        }
        tools_end(&r);
    }
}

int test_grasp_corner_cases(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closing_on_nothing_holds_nothing),
        cmocka_unit_test(closing_on_end_adds_no_strain),
        cmocka_unit_test(two_strands_share_pressure),
        cmocka_unit_test(two_tools_hold_one_segment),
        cmocka_unit_test(thread_released_under_load_does_not_pass_jaws),
        cmocka_unit_test(instant_close_and_open_grasps_and_releases),
        cmocka_unit_test(shaking_hand_keeps_grasp),
        cmocka_unit_test(grasp_above_capacity_is_reported),
        cmocka_unit_test(removal_releases_grasp),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
