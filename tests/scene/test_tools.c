/* Graspers as tools: how jaws move, what they are pushed by, trocars, exchange. What they hold: test_grasps. */
#include "base/elementary.h"
#include "scene/tools_rig.h"

typedef struct capsules {
    double at[4][7]; /* shaft, jaw at +x, jaw at -x, neck */
} capsules;

static capsules capsules_of(const tools_rig *r, uint32_t tool)
{
    vbss_view view;
    capsules c;
    expect_ok(
        vbss_grasper_get_view(r->tools[tool], VBSS_GRASPER_VIEW_CAPSULES, &view, sizeof view));
    assert_int_equal(view.count, 4);
    for (size_t i = 0; i < 4; i++) {
        memcpy(c.at[i], (const char *)view.data + i * view.stride_bytes, sizeof c.at[i]);
    }
    return c;
}

/* ---- jaws */

static void jaws_follow_handle_at_limited_speed(void **state)
{
    (void)state;
    tools_rig r;
    tools_begin_scene(&r);
    tools_add(&r, vec3_zero());
    double largest = 1e-3 * r.config.jaw_speed, angle = r.config.driver_opening;
    const double openings[] = {0.0, 0.7, 1.0, 0.5, 0.0};
    for (int k = 0; k < 5; k++) {
        double closing = r.config.closing_angle;
        double reported = openings[k] * r.config.driver_opening - (1.0 - openings[k]) * closing;
        tools_open(&r, 0, openings[k]);
        for (int i = 0; i < 60; i++) {
            double to = vbss_max(reported, 0.0);
            angle = angle < to ? vbss_min(angle + largest, to) : vbss_max(angle - largest, to);
            tools_steps(&r, 1);
            expect_near(angle, tools_state(&r, 0).jaw_angle, 1e-15);
            /* Both turn about the pivot; their inner faces meet where the angle is none. */
            capsules c = capsules_of(&r, 0);
            double length = r.config.driver_length, radius = r.config.driver_radius;
            expect_near(radius + length * sin(angle), c.at[1][3], 1e-12);
            expect_near(-c.at[1][3], c.at[2][3], 1e-12);
            expect_near(length * (1.0 - cos(angle)), c.at[1][5], 1e-12);
            expect_near(length, c.at[1][2], 1e-12);
        }
    }
    expect_near(0.0, vec3_norm(tools_hand_force(&r, 0)), 1e-9);
    tools_end(&r);
}

/* Jaws that open against a wall push the tool away from it, as far as the hand lets them. */
static void opening_jaws_push_neighbours(void **state)
{
    (void)state;
    tools_rig r;
    tools_begin_scene(&r);
    tools_add(&r, vec3_make(-5e-3, 0.0, -2e-3));
    tools_open(&r, 0, 0.0);
    tools_steps(&r, 60);
    small_stick(&r.s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.0, 0.0, 0.0), vec3_make(0.0, 0.01, 0.0),
                1e-3);
    tools_move_along(&r, 0, vec3_make(-5e-3, 0.0, -2e-3), vec3_make(-2.6e-3, 0.0, -2e-3), 200);
    expect_near(0.0, vec3_norm(tools_hand_force(&r, 0)), 1e-2);
    tools_open(&r, 0, 1.0);
    tools_steps(&r, 300);
    vbss_grasper_state tool = tools_state(&r, 0);
    expect_near(r.config.driver_opening, tool.jaw_angle, 1e-15);
    assert_true(tool.hand_force[0] < -0.05);
    assert_true(tool.position[0] < -2.9e-3);
    assert_true(small_statistics(&r.s).penetration < 1e-4);
    assert_int_equal(small_statistics(&r.s).clamped, 0);
    tools_end(&r);
}

/* ---- what tools touch */

/* Two shafts crossed and pressed together: as much on the one as on the other. */
static void tools_push_each_other(void **state)
{
    (void)state;
    tools_rig r;
    tools_begin_scene(&r);
    tools_add(&r, vec3_zero());
    const double flat[4] = {vbss_cos(0.785398163397448), vbss_sin(0.785398163397448), 0.0, 0.0};
    tools_add(&r, vec3_make(0.2, 0.0, 0.06)); /* turned out of the way first */
    for (int i = 0; i <= 100; i++) {
        const double tip[3] = {0.2 - 0.194 * 0.01 * i, 0.06, 0.06};
        expect_ok(vbss_grasper_set_target(r.tools[1], tip, flat));
        tools_steps(&r, 1);
    }
    assert_int_equal(small_statistics(&r.s).contacts, 0);
    for (int i = 1; i <= 300; i++) {
        const double tip[3] = {6e-3 - 1e-5 * vbss_min(i, 200.0), 0.06, 0.06};
        expect_ok(vbss_grasper_set_target(r.tools[1], tip, NULL));
        tools_steps(&r, 1);
    }
    tools_steps(&r, 500);
    vec3 first = tools_hand_force(&r, 0), second = tools_hand_force(&r, 1);
    assert_true(first.x < -0.1);
    expect_near(0.0, vec3_norm(vec3_add(first, second)), 1e-6);
    assert_int_equal(small_statistics(&r.s).clamped, 0);
    /* And through it does not go. */
    for (int i = 1; i <= 200; i++) {
        const double tip[3] = {4e-3 - 1e-4 * i, 0.06, 0.06};
        expect_ok(vbss_grasper_set_target(r.tools[1], tip, NULL));
        tools_steps(&r, 1);
        capsules a = capsules_of(&r, 0), b = capsules_of(&r, 1);
        double up = (0.06 - a.at[0][2]) / (a.at[0][5] - a.at[0][2]);
        double along = b.at[0][1] / (b.at[0][1] - b.at[0][4]);
        double of_a = a.at[0][0] + up * (a.at[0][3] - a.at[0][0]);
        double of_b = b.at[0][0] + along * (b.at[0][3] - b.at[0][0]);
        assert_true(of_b - of_a > 0.9 * 5e-3);
    }
    tools_end(&r);
}

/* A hand that presses closed jaws on the floor by 1 mm feels what its spring says, less what the floor gives. */
static void floor_carries_jaws(void **state)
{
    (void)state;
    tools_rig r;
    tools_begin(&r);
    r.s.config.floor = 1;
    r.s.config.floor_normal[1] = 0.0;
    r.s.config.floor_normal[2] = 1.0;
    small_create(&r.s);
    tools_add(&r, vec3_make(0.0, 0.0, 2e-3));
    tools_open(&r, 0, 0.0);
    tools_steps(&r, 100);
    double touching = r.config.driver_radius;
    tools_move_along(&r, 0, vec3_make(0.0, 0.0, 2e-3), vec3_make(0.0, 0.0, touching - 1e-3), 300);
    tools_steps(&r, 500);
    double force = r.config.stiffness * 1e-3;
    force /= 1.0 + r.config.stiffness / (2.0 * r.s.config.contact_stiffness); /* two jaws */
    expect_near(force, tools_hand_force(&r, 0).z, 1e-3 * force);
    expect_near(0.0, vec3_norm(vec3_load(tools_state(&r, 0).hand_torque)), 1e-6);
    tools_end(&r);
}

/* ---- through a trocar */

/* How far its axis passes. */
static double off_the_trocar(const tools_rig *r, uint32_t tool)
{
    vbss_grasper_state s = tools_state(r, tool);
    const double *q = s.target_orientation;
    pose at = pose_make(vec3_load(s.target_position), quat_make(q[0], q[1], q[2], q[3]));
    vec3 trocar = pose_apply_inverse(at, vec3_load(r->config.trocar));
    double lean = r->config.driver_length * sin(r->config.driver_bend); /* of the shaft's axis */
    assert_true(trocar.z > 0.0);
    return sqrt(trocar.x * trocar.x + (trocar.y - lean) * (trocar.y - lean));
}

static void shaft_passes_through_trocar(void **state)
{
    (void)state;
    const double bends[] = {0.0, 0.3};
    for (int k = 0; k < 2; k++) {
        tools_rig r;
        harness_source source = {.bytes = NULL};
        tools_begin_scene(&r);
        r.config.has_trocar = 1;
        r.config.trocar[0] = 0.01;
        r.config.trocar[2] = 0.12;
        r.config.driver_bend = bends[k];
        tools_add(&r, vec3_zero());
        vbss_random_seed(&source.random, 3, 5);
        for (int i = 0; i < 200; i++) {
            vec3 tip = harness_draw_vec3(&source, -0.05, 0.05);
            quat q = harness_draw_unit_quat(&source);
            const double turned[4] = {q.w, q.x, q.y, q.z};
            double position[3];
            vec3_store(position, tip);
            expect_ok(vbss_grasper_set_target(r.tools[0], position, turned));
            tools_steps(&r, 1);
            expect_near(0.0, vec3_distance(tip, vec3_load(tools_state(&r, 0).target_position)),
                        0.0);
            expect_near(0.0, off_the_trocar(&r, 0), 1e-12);
        }
        /* Told again, it is where it was told. */
        tools_move(&r, 0, vec3_make(0.0, 0.01, 0.0));
        tools_steps(&r, 1000);
        vbss_grasper_state tool = tools_state(&r, 0);
        expect_near(0.0, vec3_distance(vec3_load(tool.position), vec3_make(0.0, 0.01, 0.0)), 1e-6);
        const double *p = tool.orientation, *q = tool.target_orientation;
        expect_near(1.0, fabs(p[0] * q[0] + p[1] * q[1] + p[2] * q[2] + p[3] * q[3]), 1e-12);
        if (bends[k] > 0.0) { /* nearer than the bent jaws reach aside */
            const double near[3] = {0.01, 0.0, 0.1185};
            expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_grasper_set_target(r.tools[0], near, NULL));
        }
        tools_end(&r);
    }
}

/* ---- exchange */

static void tools_are_exchanged_only_empty_and_outside(void **state)
{
    (void)state;
    tools_rig r;
    vbss_scene_event event;
    tools_begin(&r);
    r.config.exchange_distance = 0.05;
    r.config.shears_length = 20e-3;
    small_create(&r.s);
    tools_thread(&r, TOOLS_FIRST, 0.0);
    vec3 in = vec3_make(0.0, 0.0, -2e-3), out = vec3_make(0.0, 0.0, 60e-3);
    tools_add(&r, in);
    for (int held = 0; held < 2; held++) { /* inside, empty or not */
        expect_ok(vbss_grasper_exchange(r.tools[0], VBSS_GRASPER_KIND_SHEARS));
        assert_int_equal(tools_state(&r, 0).kind, VBSS_GRASPER_KIND_NEEDLE_DRIVER);
        tools_steps(&r, 1);
        assert_int_equal(tools_happened(&r, VBSS_SCENE_EVENT_NOT_EXCHANGED, &event), 1);
        assert_int_equal(event.body_a, r.bodies[0]);
        assert_int_equal(event.id, VBSS_GRASPER_KIND_SHEARS);
        assert_int_equal(tools_state(&r, 0).kind, VBSS_GRASPER_KIND_NEEDLE_DRIVER);
        tools_steps(&r, 1);
        assert_int_equal(tools_happened(&r, VBSS_SCENE_EVENT_NOT_EXCHANGED, &event),
                         0); /* forgotten */
        tools_close(&r, 0);
        assert_int_equal(tools_state(&r, 0).grasp_count, 1);
    }
    tools_move_along(&r, 0, in, out,
                     600); /* outside, with the thread's rest in the jaws or without */
    bool holds = tools_state(&r, 0).grasp_count > 0;
    expect_ok(vbss_grasper_exchange(r.tools[0], VBSS_GRASPER_KIND_SHEARS));
    tools_steps(&r, 1);
    assert_int_equal(tools_happened(&r, VBSS_SCENE_EVENT_EXCHANGED, &event), holds ? 0 : 1);
    tools_open(&r, 0, 1.0);
    tools_steps(&r, 100);
    expect_ok(vbss_grasper_exchange(r.tools[0], VBSS_GRASPER_KIND_SHEARS));
    tools_steps(&r, 1);
    assert_int_equal(tools_state(&r, 0).kind, VBSS_GRASPER_KIND_SHEARS);
    assert_int_equal(tools_happened(&r, VBSS_SCENE_EVENT_EXCHANGED, &event), holds ? 1 : 0);
    capsules c = capsules_of(&r, 0);
    vec3 begin = vec3_load(c.at[1]), end = vec3_load(c.at[1] + 3);
    tools_steps(&r, 100);
    expect_near(20e-3, vec3_distance(begin, end), 1e-9);
    expect_near(r.config.shears_opening, tools_state(&r, 0).jaw_angle, 1e-15);
    expect_ok(vbss_grasper_exchange(r.tools[0], VBSS_GRASPER_KIND_SHEARS)); /* what it is */
    tools_steps(&r, 1);
    assert_int_equal(tools_happened(&r, VBSS_SCENE_EVENT_EXCHANGED, &event), 0);
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_grasper_exchange(r.tools[0], 3));
    tools_end(&r);
}

int test_tools(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(jaws_follow_handle_at_limited_speed),
        cmocka_unit_test(opening_jaws_push_neighbours),
        cmocka_unit_test(tools_push_each_other),
        cmocka_unit_test(floor_carries_jaws),
        cmocka_unit_test(shaft_passes_through_trocar),
        cmocka_unit_test(tools_are_exchanged_only_empty_and_outside),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
