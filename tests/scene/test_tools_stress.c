/* Tools, and a floor, where contact is hard: they strike a tight knot, are drawn out of turns, turn fast, are
 * told to go where others are. Each ends with nothing passed in any part, decided exactly: no thread, no axis of
 * a tool through another, nothing below the floor. */
#include <math.h>

#include "base/rotation.h"
#include "scene/hard_case.h"

static hard_case c;

static contact_scene_options options_of(contact_scene_kind kind)
{
    contact_scene_options o;
    expect_ok(contact_scene_init(&o, kind));
    return o;
}

static vbss_scene_rigid_state tool_of(uint32_t tool)
{
    vbss_scene_rigid_state s;
    expect_ok(vbss_scene_get_rigid(c.scene.scene, c.scene.tools[tool], &s, sizeof s));
    return s;
}

static void expect_finite_tools(void)
{
    for (uint32_t k = 0; k < c.scene.tool_count; k++) {
        vbss_scene_rigid_state s = tool_of(k);
        assert_true(vec3_is_finite(vec3_load(s.position)));
        assert_true(vec3_is_finite(vec3_load(s.velocity)));
        assert_true(vec3_is_finite(vec3_load(s.angular_velocity)));
    }
}

/* ---- thread and tools */

static void tight_knot_survives_strike_at_1_m_per_second(void **state)
{
    (void)state;
    static const char *const names[] = {"struck by a driven rod", "struck by a coupled rod",
                                        "struck by a free rod"};
    for (int kind = 0; kind < 2; kind++) {
        for (vbss_scene_rigid_kind tool = VBSS_SCENE_RIGID_DRIVEN; tool <= VBSS_SCENE_RIGID_FREE;
             tool++) {
            contact_scene_options o = options_of(CONTACT_SCENE_STRUCK);
            o.knot.kind = kind == 0 ? KNOT_OVERHAND : KNOT_DOUBLE_OVERHAND;
            o.pull.force = 2.0;
            o.tool = tool;
            o.begin = 200;
            hard_begin(&c, names[tool], &o, 1e-3);
            assert_true(hard_pull(&c, 190));
            hard_run(&c, 206 - c.steps);
            double before = contact_scene_pull_felt(&c.scene), largest = before;
            for (int i = 0; i < 150; i++) {
                hard_run(&c, 1);
                largest = fmax(largest, contact_scene_pull_felt(&c.scene));
            }
            assert_true(largest > 1.2 * before); /* it was hit */
            hard_report(&c);
            hard_expect_kept(&c);
            hard_expect_same_knot(&c);
            expect_finite_tools();
            hard_end(&c);
        }
    }
}

/* Hands that do not give way, a thread that hardly stretches: something must, and it is counted. */
static void knot_between_rigid_hands_survives_strike(void **state)
{
    (void)state;
    contact_scene_options o = options_of(CONTACT_SCENE_STRUCK);
    o.knot.kind = KNOT_DOUBLE_OVERHAND;
    o.pull.stiffness = 0.0;
    o.begin = 200;
    hard_begin(&c, "struck between rigid hands", &o, 1e-3);
    hard_run(&c, 400);
    hard_report(&c);
    hard_expect_kept(&c);
    hard_expect_same_knot(&c);
    hard_end(&c);
}

static void turns_slide_off_withdrawn_tool(void **state)
{
    (void)state;
    static const double friction[] = {0.15, 0.0, 0.5};
    for (int k = 0; k < 3; k++) {
        contact_scene_options o = options_of(CONTACT_SCENE_SLIDING_OFF);
        o.tool_friction = friction[k];
        o.tool_speed = 0.15;
        o.begin = 100;
        hard_begin(&c, "two and a half turns slide off", &o, 1e-3);
        hard_run(&c, 900);
        hard_report(&c);
        hard_expect_kept(&c);
        /* The tool has gone out of all turns, which are no knot. */
        double nearest = 1.0;
        vbss_scene_rigid_state tool = tool_of(0);
        for (uint32_t i = 0; i < c.scene.nodes[0]; i++) {
            nearest = fmin(nearest, hard_nodes(&c, 0)[i].z - tool.position[2]);
        }
        assert_true(nearest > 0.013);
        assert_int_equal(hard_knot(&c, 0).determinant, 1);
        assert_true(contact_scene_pull_felt(&c.scene) < 0.1); /* nothing holds it */
        hard_end(&c);
    }
}

static void thread_falls_on_tools_and_floor(void **state)
{
    (void)state;
    /* Waved and across; straight along a tool; beside all tools, on the floor. */
    static const vec3 aside[] = {{0.0, 0.0, 0.0}, {0.055, 0.0, 0.0}, {0.0, 0.0, 0.08}};
    static const double wave[] = {1e-3, 0.0, 1e-3};
    for (int k = 0; k < 3; k++) {
        contact_scene_options o = options_of(CONTACT_SCENE_DROPPED);
        o.aside = aside[k];
        o.wave = wave[k];
        hard_begin(&c, "dropped on tools and floor", &o, 1e-3);
        double begin = hard_energy(&c);
        hard_run(&c, 600);
        hard_report(&c);
        hard_expect_kept(&c);
        assert_true(hard_energy(&c) < begin);
        assert_true(hard_fastest(&c) < 0.05);
        hard_expect_at_rest(&c, 100);
        hard_end(&c);
    }
}

/* A rod turns through a taut thread by a third of a radian in a step, and by more. */
static void fast_rotating_tool_stops_at_thread(void **state)
{
    (void)state;
    static const double turns[] = {0.02, 0.3, 1.0};
    for (int k = 0; k < 3; k++) {
        contact_scene_options o = options_of(CONTACT_SCENE_STRUCK);
        o.begin = 10000;
        hard_begin(&c, "a rod that turns through a thread", &o, 1e-3);
        assert_true(hard_pull(&c, 1000));
        for (int i = 1; i <= 100; i++) {
            double home[3], turn[4];
            quat q = vbss_quat_from_rotation_vector(vec3_make(turns[k] * i, 0.0, 0.0));
            turn[0] = q.w, turn[1] = q.x, turn[2] = q.y, turn[3] = q.z;
            vec3_store(home, c.scene.tool_homes[0]);
            expect_ok(vbss_scene_set_rigid_target(c.scene.scene, c.scene.tools[0], home, turn));
            hard_run(&c, 1);
        }
        hard_report(&c);
        hard_expect_kept(&c);
        hard_expect_same_knot(&c);
        hard_end(&c);
    }
}

/* A needle of a thousand segments' mass, joined to a thread of which the other end is held, falls on tools
 * and the floor. */
static void heavy_needle_falls_with_thread(void **state)
{
    (void)state;
    contact_scene_options o = options_of(CONTACT_SCENE_DROPPED);
    o.pull.stiffness = 0.0;
    hard_begin(&c, "a needle of 1000 segments' mass", &o, 1e-3);
    uint32_t last = c.scene.nodes[0] - 1, body, pin;
    vec3 end = hard_nodes(&c, 0)[last], gap = vec3_make(0.53e-3, 0.0, 0.0);
    vbss_scene_rigid_config needle;
    vbss_scene_capsule capsule = {{0.0, 0.0, 0.0}, {0.02, 0.0, 0.0}, 0.4e-3};
    double point[3];
    expect_ok(vbss_scene_rigid_config_init(&needle, sizeof needle));
    needle.kind = VBSS_SCENE_RIGID_FREE;
    needle.capsules = &capsule;
    needle.capsule_count = 1;
    needle.mass = 1000.0 * 6.4e-5 * 0.6e-3;
    needle.gravity[1] = -9.81;
    vec3_store(needle.position, vec3_add(end, gap));
    vec3_store(point, vec3_neg(gap));
    expect_ok(vbss_scene_add_rigid(c.scene.scene, &needle, &body));
    expect_ok(
        vbss_scene_pin_thread(c.scene.scene, c.scene.thread_bodies[0], last, body, point, &pin));
    expect_ok(vbss_scene_pin_thread(c.scene.scene, c.scene.thread_bodies[0], 0, 0, NULL, &pin));
    hard_run(&c, 1000);
    hard_report(&c);
    hard_expect_kept(&c);
    vbss_scene_rigid_state s;
    expect_ok(vbss_scene_get_rigid(c.scene.scene, body, &s, sizeof s));
    assert_true(vec3_norm(vec3_load(s.velocity)) < 2.0);
    hard_end(&c);
}

/* ---- tools among themselves */

static void tools_press_on_tools_and_floor(void **state)
{
    (void)state;
    static const double friction[] = {0.15, 0.0, 1.0};
    for (int k = 0; k < 3; k++) {
        contact_scene_options o = options_of(CONTACT_SCENE_TOOLS);
        o.tool_friction = friction[k];
        hard_begin(&c, "tools on tools and the floor", &o, 1e-3);
        hard_run(&c, 1000);
        hard_report(&c);
        hard_expect_kept(&c);
        expect_finite_tools();
        /* What was pressed is free again, and lies or rolls on the floor. */
        expect_near(0.02, tool_of(0).position[1], 1e-6);
        expect_near(0.013, tool_of(1).position[1], 1e-3);
        expect_near(2e-3, tool_of(2).position[1], 1e-4);
        expect_near(3e-3, tool_of(3).position[1], 1e-4);
        assert_true(tool_of(4).position[1] < 0.012);
        hard_end(&c);
    }
}

/* Told to go through the floor and on: it stays above it, and comes back. */
static void driven_tool_stops_at_floor(void **state)
{
    (void)state;
    contact_scene_options o = options_of(CONTACT_SCENE_TOOLS);
    hard_begin(&c, "a driven tool at the floor", &o, 1e-3);
    double at[3] = {0.1, 0.02, 0.0}; /* beside all others */
    for (int i = 0; i < 300; i++) {
        at[1] = 0.02 - (i < 150 ? 0.5e-3 * i : 0.5e-3 * (300 - i));
        expect_ok(vbss_scene_set_rigid_target(c.scene.scene, c.scene.tools[0], at, NULL));
        expect_ok(vbss_scene_step(c.scene.scene, c.h)); /* nobody else tells it to go anywhere */
        assert_true(tool_of(0).position[1] > 0.0);
    }
    expect_near(0.02, tool_of(0).position[1], 1e-3);
    hard_report(&c);
    hard_expect_kept(&c);
    hard_end(&c);
}

int test_tools_stress(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tight_knot_survives_strike_at_1_m_per_second),
        cmocka_unit_test(knot_between_rigid_hands_survives_strike),
        cmocka_unit_test(turns_slide_off_withdrawn_tool),
        cmocka_unit_test(thread_falls_on_tools_and_floor),
        cmocka_unit_test(fast_rotating_tool_stops_at_thread),
        cmocka_unit_test(heavy_needle_falls_with_thread),
        cmocka_unit_test(tools_press_on_tools_and_floor),
        cmocka_unit_test(driven_tool_stops_at_floor),
    };
    return cmocka_run_group_tests_name("scene.tools_stress", tests, NULL, NULL);
}
