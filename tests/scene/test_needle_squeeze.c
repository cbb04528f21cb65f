/* A needle that closing jaws squeeze at their tip or at their pivot: friction holds it inside the friction cone, and jaws
 * push it out slowly beyond. */
#include "scene/needles_rig.h"

enum { STEPS = 700 };

typedef struct squeeze {
    bool is_held;
    double speed, speed_at_end; /* of the centre of mass: largest, and after the last step, m/s */
    double moved;               /* of the middle of the arc, m */
    double jaw_angle;           /* largest, rad */
} squeeze;

/* The middle of the needle's arc lies across the jaws, `back` behind their tip. The handle closes within `closing` steps. */
static squeeze run_squeeze(double wire, double jaw, double back, uint32_t closing)
{
    needles_rig r;
    needles_begin_scene(&r);
    r.config.wire_radius = wire;
    memset(r.config.gravity, 0, sizeof r.config.gravity);
    r.tools.config.driver_radius = jaw;
    r.tools.config.stiffness = 2000.0;
    r.tools.config.damping = 10.0;
    double middle = 0.5 * r.config.arc * r.config.radius;
    needles_add_across(&r, middle, vec3_zero());
    tools_add(&r.tools, vec3_make(0.0, 0.0, -back));
    squeeze s = {.is_held = false};
    for (uint32_t i = 1; i <= STEPS; i++) {
        tools_open(&r.tools, 0, i < closing ? 1.0 - (double)i / closing : 0.0);
        tools_steps(&r.tools, 1);
        vec3 v = vec3_load(needles_state(&r).velocity);
        s.speed_at_end = vec3_norm(v);
        s.speed = vbss_max(s.speed_at_end, s.speed);
        s.jaw_angle = vbss_max(tools_state(&r.tools, 0).jaw_angle, s.jaw_angle);
    }
    s.is_held = tools_state(&r.tools, 0).grasp_count == 1;
    s.moved = vec3_norm(needles_place(&r, middle, NULL));
    needles_end(&r);
    return s;
}

/* Beyond the tip the round ends touch the wire at an angle to the closing motion. Its sine is the distance beyond the tip
 * over that of the axes. Friction holds the wire if the angle is below the friction angle. Otherwise the wire leaves about
 * as fast as rigid jaws that close at the speed of their tips push a wedge out. The straight capsules of the needle lean a
 * little more than its arc. */
static void friction_cone_decides_at_tip(void **state)
{
    (void)state;
    const double ratios[] = {0.3, 0.7, 0.95, 1.1, 1.4, 1.8}, wires[] = {0.35e-3, 0.25e-3};
    const double jaws[] = {0.5e-3, 0.25e-3};
    const uint32_t closing[] = {400, 100, 40};
    vbss_grasper_config tool;
    vbss_needle_config needle;
    expect_ok(vbss_grasper_config_init(&tool, sizeof tool));
    expect_ok(vbss_needle_config_init(&needle, sizeof needle));
    double friction_angle = atan(sqrt(tool.friction * needle.friction));
    for (int k = 0; k < 72; k++) {
        double wire = wires[k / 6 % 2], jaw = jaws[k / 12 % 2], ratio = ratios[k % 6];
        uint32_t steps = closing[k / 24];
        double sine = ratio * sin(friction_angle);
        squeeze s = run_squeeze(wire, jaw, -sine * (wire + jaw), steps);
        assert_int_equal(s.is_held, ratio < 1.0);
        if (ratio < 1.0) {
            assert_true(s.speed_at_end < 1e-3);
            assert_true(s.moved < 2e-5);
        } else {
            double turning = 1e3 * (tool.driver_opening + tool.closing_angle) / steps;
            double closing_speed = tool.driver_length * vbss_min(turning, tool.jaw_speed);
            assert_true(s.speed < 1.4 * closing_speed / tan(asin(sine)));
        }
    }
}

/* From there to the pivot, and beside it, where the host has put the needle into the jaws or the neck: it comes out, is
 * held or stays, and no jaw is pushed farther open than it can open. */
static void needle_at_pivot_is_not_shot_off(void **state)
{
    (void)state;
    for (int k = 0; k <= 13; k++) {
        squeeze s = run_squeeze(0.35e-3, 0.5e-3, 12.2e-3 + 1e-4 * k, 400);
        assert_true(s.speed < 0.25);
        assert_true(s.jaw_angle <= 0.35);
    }
}

int test_needle_squeeze(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(friction_cone_decides_at_tip),
        harness_test(needle_at_pivot_is_not_shot_off),
    };
    return cmocka_run_group_tests_name("scene.needle_squeeze", tests, NULL, NULL);
}
