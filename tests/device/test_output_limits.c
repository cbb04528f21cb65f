/* Numbers, magnitude and rise: what an output stage lets through, and that it never adds. */
#include "device/stage_rig.h"

static const double h = 1e-3;

static void unlimited_command_passes_bit_exact(void **state)
{
    (void)state;
    stage_rig r;
    expect_ok(vbss_output_config_init(&r.config, sizeof r.config));
    r.config.continuous_force = 3.0;
    stage_rig_begin(&r);
    vbss_random random;
    vbss_random_seed(&random, 7, 7);
    vec3 force = vec3_zero();
    for (int i = 0; i < 2000; i++) {
        /* At most 0.4 N a step where 0.5 are allowed; a tenth of the longest. */
        force = vec3_scale(vec3_add_scaled(force, 0.3, vbss_random_direction(&random)), 0.9);
        vec3 out = stage_rig_step(&r, h, force);
        assert_int_equal(r.flags, 0);
        expect_same_bits(force.x, out.x);
        expect_same_bits(force.y, out.y);
        expect_same_bits(force.z, out.z);
    }
    assert_int_equal(r.state.statistics.steps, 2000);
}

/* ---- magnitude */

static void force_is_clamped_along_direction(void **state)
{
    (void)state;
    const double lengths[] = {3.0000001, 4.0, 1e10, 1e160, 1.7e308};
    stage_rig r = stage_rig_wide();
    r.config.max_force = 3.0;
    const vec3 direction = vec3_make(0.36, -0.48, 0.8);
    for (size_t i = 0; i < sizeof lengths / sizeof lengths[0]; i++) {
        vec3 out = stage_rig_step(&r, h, vec3_scale(direction, lengths[i]));
        assert_int_equal(r.flags, VBSS_OUTPUT_FLAG_CLAMPED);
        expect_near(3.0, vec3_norm(out), 1e-15 * 3.0);
        expect_near(0.0, vec3_distance(direction, vec3_scale(out, 1.0 / 3.0)), 1e-15);
    }
    stage_rig_step(&r, h, vec3_scale(direction, 3.0 - 1e-12));
    assert_int_equal(r.flags, 0);
    assert_int_equal(r.state.statistics.clamped, 5);
}

static void torque_is_clamped_independently(void **state)
{
    (void)state;
    stage_rig r = stage_rig_wide();
    r.config.max_torque = 0.1;
    r.demand.torque = vec3_make(0.0, 0.3, -0.4);
    vec3 force = stage_rig_step(&r, h, vec3_make(5.0, 0.0, 0.0));
    assert_true(force.x == 5.0);
    expect_near(0.1, vec3_norm(r.state.torque), 1e-16);
    expect_near(0.06, r.state.torque.y, 1e-16);
    assert_int_equal(r.flags, VBSS_OUTPUT_FLAG_CLAMPED);
}

/* ---- numbers */

static void non_finite_command_turns_all_off(void **state)
{
    (void)state;
    stage_rig r = stage_rig_wide();
    for (int part = 0; part < 8; part++) {
        for (int i = 0; i < 3; i++) {
            if (part >= 6 && i > 0) {
                continue; /* an infinite age is an age */
            }
            r.demand = (output_demand){.torque = {1.0, 1.0, 1.0}, .solenoid = true};
            stage_rig_step(&r, h, vec3_make(1.0, 1.0, 1.0));
            assert_int_equal(r.flags, 0);
            assert_true(r.state.solenoid.is_on);
            vec3 bad = vec3_make(1.0, 1.0, 1.0);
            double *const places[] = {&bad.x,
                                      &bad.y,
                                      &bad.z,
                                      &r.demand.torque.x,
                                      &r.demand.torque.z,
                                      &r.demand.temperature,
                                      &r.demand.age,
                                      &r.demand.input_age};
            *places[part] = harness_bad_numbers[i];
            vec3 out = stage_rig_step(&r, h, bad);
            assert_true((r.flags & VBSS_OUTPUT_FLAG_NOT_FINITE) != 0);
            assert_true((r.flags & VBSS_OUTPUT_FLAG_SOLENOID_OFF) != 0);
            assert_true(vec3_norm(out) == 0.0 && vec3_norm(r.state.torque) == 0.0);
            assert_false(r.state.solenoid.is_on);
        }
    }
    assert_int_equal(r.state.statistics.not_finite, 20);
}

static void device_without_force_capability_gets_none(void **state)
{
    (void)state;
    stage_rig r = stage_rig_wide();
    stage_rig_step(&r, h, vec3_make(1.0, 0.0, 0.0));
    r.demand.has_fault = true;
    assert_true(vec3_norm(stage_rig_step(&r, h, vec3_make(1.0, 0.0, 0.0))) == 0.0);
    assert_int_equal(r.flags, VBSS_OUTPUT_FLAG_FAULT);
    r.demand.has_fault = false;
    assert_true(stage_rig_step(&r, h, vec3_make(1.0, 0.0, 0.0)).x == 1.0);
    assert_int_equal(r.state.statistics.faults, 1);
}

/* ---- rise */

static void force_rise_is_rate_limited(void **state)
{
    (void)state;
    stage_rig r = stage_rig_wide();
    r.config.force_rise = 500.0;
    for (int i = 1; i <= 7; i++) {
        vec3 out = stage_rig_step(&r, h, vec3_make(0.0, 3.0, 4.0));
        double wanted = 0.5 * i;
        expect_near(0.6 * wanted, out.y, 1e-15);
        expect_near(0.8 * wanted, out.z, 1e-15);
        assert_int_equal(r.flags, VBSS_OUTPUT_FLAG_SLEWED);
    }
    /* Longer steps rise more, but no step for longer than 10 ms. */
    stage_rig_step(&r, h, vec3_zero());
    expect_near(1.0, vec3_norm(stage_rig_step(&r, 2e-3, vec3_make(0.0, 30.0, 40.0))), 1e-15);
    expect_near(6.0, vec3_norm(stage_rig_step(&r, 5.0, vec3_make(0.0, 30.0, 40.0))), 1e-14);
    assert_true((r.flags & VBSS_OUTPUT_FLAG_LATE) != 0);
}

static void force_fall_is_not_limited(void **state)
{
    (void)state;
    stage_rig r = stage_rig_wide();
    stage_rig_step(&r, h, vec3_make(0.0, 3.0, 4.0));
    r.config.force_rise = 500.0;
    vec3 out = stage_rig_step(&r, h, vec3_make(0.0, 0.3, 0.4));
    assert_int_equal(r.flags, 0);
    expect_near(0.5, vec3_norm(out), 1e-15);
    stage_rig_step(&r, h, vec3_zero());
    assert_int_equal(r.flags, 0);
    assert_true(vec3_norm(r.state.force) == 0.0);
}

/* From one side to the other: to zero at once, then it rises. */
static void reversal_starts_at_zero(void **state)
{
    (void)state;
    stage_rig r = stage_rig_wide();
    stage_rig_step(&r, h, vec3_make(2.0, 0.0, 0.0));
    r.config.force_rise = 500.0;
    vec3 out = stage_rig_step(&r, h, vec3_make(-2.0, 0.0, 0.0));
    expect_near(-0.5, out.x, 1e-15);
    /* A quarter turn keeps nothing of what was. */
    r.config.force_rise = 1e9;
    stage_rig_step(&r, h, vec3_make(2.0, 0.0, 0.0));
    r.config.force_rise = 500.0;
    out = stage_rig_step(&r, h, vec3_make(0.0, 2.0, 0.0));
    expect_near(0.0, out.x, 1e-15);
    expect_near(0.5, out.y, 1e-15);
}

/* ---- whatever comes */

/* No result is longer than what was wanted, than the limit, or than the rise allows; all are finite. */
static void never_more(harness_source *source, void *user)
{
    (void)user;
    stage_rig r;
    expect_ok(vbss_output_config_init(&r.config, sizeof r.config));
    r.config.load_time = 0.05;
    r.config.solenoid_time = 0.02;
    stage_rig_begin(&r);
    for (int i = 0; i < 60; i++) {
        vec3 before = r.state.force;
        double step = harness_draw_below(source, 20) == 0 ? harness_draw_real(source, 0.0, 0.5)
                                                          : harness_draw_real(source, 0.0, 2e-3);
        double scale = harness_draw_below(source, 30) == 0 ? 1e300 : 4.0;
        vec3 wanted = harness_draw_vec3(source, -scale, scale);
        r.demand.torque = harness_draw_vec3(source, -0.2, 0.2);
        r.demand.age =
            harness_draw_below(source, 4) == 0 ? harness_draw_real(source, 0.0, 0.02) : 0.0;
        r.demand.input_age =
            harness_draw_below(source, 4) == 0 ? harness_draw_any_double(source) : 0.0;
        r.demand.temperature = harness_draw_real(source, 0.0, 1.1);
        r.demand.has_fault = harness_draw_below(source, 20) == 0;
        r.demand.solenoid = harness_draw_below(source, 2) == 0;
        vec3 out = stage_rig_step(&r, step, wanted);
        double largest = 3.0;
        if (scale < 1e100) {
            largest = vbss_min(largest, vec3_norm(wanted));
        }
        assert_true(vec3_is_finite(out) && vec3_is_finite(r.state.torque));
        assert_true(vec3_norm(out) <= largest * (1.0 + 1e-14));
        assert_true(vec3_norm(r.state.torque) <= 0.1 * (1.0 + 1e-14));
        double reach = 500.0 * vbss_min(step, 0.01);
        assert_true(vec3_norm(out) <= vec3_norm(before) + reach + 1e-12);
        if (r.flags != 0) {
            continue;
        }
        assert_true(out.x == wanted.x && out.y == wanted.y && out.z == wanted.z);
    }
}

static void no_stage_increases_force(void **state)
{
    (void)state;
    harness_property("never_more", 3000, never_more, NULL);
}

int test_output_limits(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(unlimited_command_passes_bit_exact),
        cmocka_unit_test(force_is_clamped_along_direction),
        cmocka_unit_test(torque_is_clamped_independently),
        cmocka_unit_test(non_finite_command_turns_all_off),
        cmocka_unit_test(device_without_force_capability_gets_none),
        cmocka_unit_test(force_rise_is_rate_limited),
        cmocka_unit_test(force_fall_is_not_limited),
        cmocka_unit_test(reversal_starts_at_zero),
        harness_test(no_stage_increases_force),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
