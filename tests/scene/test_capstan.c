/* The law of the rope over a capsule (capstan_rig.h). */
#include "scene/capstan_rig.h"

static void check_law(vbss_thread_bending bending, double tolerance)
{
    const double turns[] = {0.5, 1.0, 2.0}, stiffness[] = {427.0, 4000.0};
    for (int i = 0; i < 18; i++) {
        capstan c = capstan_half_turn(0.1 * (1 + i % 3));
        c.turns = turns[i / 3 % 3];
        c.axial_stiffness = stiffness[i / 9];
        c.bending = bending;
        double got = capstan_pulled_over(&c);
        expect_near(1.0, got / (c.friction * c.angle), tolerance);
    }
}

static void tension_follows_capstan_equation(void **state)
{
    (void)state;
    check_law(VBSS_THREAD_BENDING_SPLINE, 0.01);
}

static void tension_follows_capstan_equation_with_local_bending(void **state)
{
    (void)state;
    check_law(VBSS_THREAD_BENDING_LOCAL, 0.005);
}

static void capstan_error_is_second_order_in_segment_length(void **state)
{
    (void)state;
    const double fineness[] = {0.85, 0.5, 0.25, 0.125}, tolerance[] = {0.03, 0.022, 0.006, 0.0018};
    for (int b = 0; b < 2; b++) {
        for (int i = 0; i < 4; i++) {
            capstan c = capstan_half_turn(0.3);
            c.turns = 1.5;
            c.fineness = fineness[i];
            c.bending = b == 0 ? VBSS_THREAD_BENDING_SPLINE : VBSS_THREAD_BENDING_LOCAL;
            double got = capstan_pulled_over(&c);
            expect_near(1.0, got / (c.friction * c.angle), tolerance[i]);
        }
    }
}

/* Ten times as fast too: nothing brakes but friction. */
static void frictionless_tension_is_constant(void **state)
{
    (void)state;
    const double speeds[] = {0.01, 0.1};
    for (int i = 0; i < 2; i++) {
        capstan c = capstan_half_turn(0.0);
        c.speed = speeds[i];
        double got = capstan_pulled_over(&c);
        expect_near(0.0, got, 0.003);
    }
}

static void friction_reverses_with_pull(void **state)
{
    (void)state;
    capstan c = capstan_half_turn(0.3);
    capstan_begin(&c);
    (void)capstan_pull(&c, capstan_start_segments(&c));
    capstan_ratios forth = capstan_pull(&c, 4.0);
    c.speed = -c.speed;
    (void)capstan_pull(&c, 1.0);
    capstan_ratios back = capstan_pull(&c, 4.0);
    scene_rig_end(&c.rig);
    expect_near(1.0, forth.mean / (0.3 * CAPSTAN_PI), 0.01);
    expect_near(-1.0, back.mean / (0.3 * CAPSTAN_PI), 0.01);
    assert_true(back.largest < -0.28 * CAPSTAN_PI); /* never to and fro */
}

/* Of the largest ratio that friction could hold: 99 % is held, without creep. */
static void load_below_capstan_limit_holds(void **state)
{
    (void)state;
    capstan c = capstan_half_turn(0.3);
    capstan_begin(&c);
    (void)capstan_pull(&c, capstan_start_segments(&c));
    expect_ok(vbss_thread_detach(c.rig.thread.thread, c.end));
    uint32_t last = c.rig.thread.nodes - 1;
    double pulls = CAPSTAN_LOAD * exp(0.99 * 0.3 * CAPSTAN_PI);
    rig_force(&c.rig.thread, last, vec3_scale(c.pulled, pulls));
    scene_rig_run(&c.rig, 1e-3, 500);
    vec3 before = rig_position(&c.rig.thread, last);
    scene_rig_run(&c.rig, 1e-3, 2000);
    double crept = vec3_distance(before, rig_position(&c.rig.thread, last));
    scene_rig_end(&c.rig);
    expect_near(0.0, crept, 1e-9);
}

int test_capstan(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tension_follows_capstan_equation),
        cmocka_unit_test(tension_follows_capstan_equation_with_local_bending),
        cmocka_unit_test(capstan_error_is_second_order_in_segment_length),
        cmocka_unit_test(frictionless_tension_is_constant),
        cmocka_unit_test(friction_reverses_with_pull),
        cmocka_unit_test(load_below_capstan_limit_holds),
    };
    return cmocka_run_group_tests_name("scene.capstan", tests, NULL, NULL);
}
