/* Continuous load and temperature: the mean square against its closed formula, and what it allows. */
#include "device/stage_rig.h"

static const double h = 1e-3;

static stage_rig motor(void)
{
    stage_rig r = stage_rig_wide();
    r.config.max_force = 3.0;
    r.config.continuous_force = 0.8;
    r.config.load_time = 2.0;
    return r;
}

/* Of a constant force that went out t seconds ago: F^2 (1 - exp(-t/T)), whatever the steps are. */
static void mean_square_of_constant_force_is_exponential(void **state)
{
    (void)state;
    stage_rig r = motor();
    double time = 0.0;
    stage_rig_step(&r, h, vec3_make(0.0, 0.7, 0.0));
    for (int i = 0; i < 4000; i++) {
        double step = 1e-3 * (1 + i % 4);
        time += step;
        stage_rig_step(&r, step, vec3_make(0.0, 0.7, 0.0));
        expect_near(0.49 * (1.0 - vbss_exp(-time / 2.0)), r.state.force_load, 1e-13);
    }
    assert_int_equal(r.flags, 0); /* below what may go on for ever */
    double full = r.state.force_load;
    stage_rig_step(&r, h, vec3_zero());
    double last = full + (0.49 - full) * (1.0 - vbss_exp(-h / 2.0));
    stage_rig_step(&r, 0.5, vec3_zero());
    expect_near(last * vbss_exp(-0.25), r.state.force_load, 1e-13);
}

/* Any forces, held from step to step: the sum of their squares, each with its own decay. */
static void mean_square_is_linear_filter(void **state)
{
    (void)state;
    enum { STEPS = 300 };
    stage_rig r = motor();
    r.config.continuous_force = 1e3;
    vbss_random random;
    double squares[STEPS], steps[STEPS];
    vbss_random_seed(&random, 3, 1);
    for (int i = 0; i < STEPS; i++) {
        vec3 force = vec3_scale(vbss_random_direction(&random), 2.0 * vbss_random_uniform(&random));
        steps[i] = 1e-3 + 0.05 * vbss_random_uniform(&random);
        r.demand.torque = vec3_scale(force, 2.0);
        stage_rig_step(&r, steps[i], force);
        squares[i] = vec3_norm_squared(r.state.force);
    }
    double sum = 0.0, later = 0.0;
    for (int i = STEPS - 1; i > 0; i--) { /* a force lasts until the next step */
        sum += squares[i - 1] * (vbss_exp(-later / 2.0) - vbss_exp(-(later + steps[i]) / 2.0));
        later += steps[i];
    }
    expect_near(sum, r.state.force_load, 1e-13);
    expect_near(4.0 * sum, r.state.torque_load, 1e-12);
}

static void peaks_are_allowed_and_derated_in_time(void **state)
{
    (void)state;
    stage_rig r = motor();
    int free_steps = 0;
    double last = 3.0;
    for (int i = 0; i < 20000; i++) {
        vec3 out = stage_rig_step(&r, h, vec3_make(3.0, 0.0, 0.0));
        double force = vec3_norm(out);
        assert_true(force <= last + 1e-12);      /* falls without a jump up */
        assert_true(force >= last - 0.1);        /* and without one down */
        assert_true(force >= 0.8 - 1e-12);       /* never below what may go on for ever */
        assert_true(r.state.force_load <= 0.64); /* whose square the mean never exceeds */
        free_steps += r.flags == 0;
        last = force;
    }
    /* 9 (1 - exp(-t/2)) reaches three quarters of 0.64 after 110 ms. */
    expect_near(-2.0 * vbss_log(1.0 - 0.48 / 9.0), 1e-3 * free_steps, 2e-3);
    expect_near(0.8, last, 1e-6);
    assert_int_equal(r.flags, VBSS_OUTPUT_FLAG_CONTINUOUS);
    assert_int_equal(r.state.statistics.continuous, 20000 - free_steps);
    vbss_output_result result;
    vbss_output_fill_result(&r.config, &r.state, r.flags, &result);
    expect_near(1.0, result.force_load, 1e-5);
    /* Rested for long enough, the peak is there again. */
    for (int i = 0; i < 1000; i++) {
        stage_rig_step(&r, h, vec3_zero());
    }
    expect_near(3.0, vec3_norm(stage_rig_step(&r, h, vec3_make(3.0, 0.0, 0.0))), 1e-15);
}

static void derating_keeps_direction(void **state)
{
    (void)state;
    stage_rig r = motor();
    const vec3 direction = vec3_make(0.36, -0.48, 0.8);
    for (int i = 0; i < 5000; i++) {
        stage_rig_step(&r, h, vec3_scale(direction, 2.0));
    }
    vec3 out = r.state.force;
    assert_int_equal(r.flags, VBSS_OUTPUT_FLAG_CONTINUOUS);
    expect_near(0.0, vec3_norm(vec3_cross(direction, out)), 1e-15);
    assert_true(vec3_dot(direction, out) > 0.79);
}

static void torque_load_is_separate(void **state)
{
    (void)state;
    stage_rig r = motor();
    r.config.max_torque = 0.1;
    r.config.continuous_torque = 0.02;
    for (int i = 0; i < 20000; i++) {
        r.demand.torque = vec3_make(0.0, 0.0, 0.1);
        assert_true(stage_rig_step(&r, h, vec3_make(0.5, 0.0, 0.0)).x == 0.5);
    }
    expect_near(0.02, r.state.torque.z, 1e-7);
}

/* More than full, as after a host that let a peak stand: what lasts is still there. */
static void overloaded_motor_keeps_continuous_force(void **state)
{
    (void)state;
    stage_rig r = motor();
    stage_rig_step(&r, h, vec3_make(3.0, 0.0, 0.0));
    stage_rig_step(&r, 1.0, vec3_make(3.0, 0.0, 0.0));
    assert_true(r.state.force_load > 2.0 * 0.64);
    expect_near(0.8, vec3_norm(r.state.force), 1e-15);
}

static void motor_without_continuous_force_gets_none(void **state)
{
    (void)state;
    stage_rig r = motor();
    r.config.continuous_force = 0.0;
    assert_true(vec3_norm(stage_rig_step(&r, h, vec3_make(1.0, 0.0, 0.0))) == 0.0);
    vbss_output_result result;
    vbss_output_fill_result(&r.config, &r.state, r.flags, &result);
    assert_true(isfinite(result.force_load));
}

/* ---- temperature */

static void warm_motor_is_derated(void **state)
{
    (void)state;
    stage_rig r = stage_rig_wide();
    r.config.max_force = 3.0;
    const double temperatures[] = {0.0, 0.7, 0.85, 0.95, 1.0, 1.3, 1e300};
    const double forces[] = {3.0, 3.0, 1.5, 0.5, 0.0, 0.0, 0.0};
    for (size_t i = 0; i < sizeof forces / sizeof forces[0]; i++) {
        r.demand.temperature = temperatures[i];
        vec3 out = stage_rig_step(&r, h, vec3_make(0.0, 2.9999, 0.0));
        expect_near(vbss_min(forces[i], 2.9999), out.y, 1e-14);
        assert_int_equal(r.flags, i < 2 ? 0 : VBSS_OUTPUT_FLAG_WARM);
        stage_rig_step(&r, h, vec3_zero());
    }
    r.demand.temperature = 0.95;
    assert_true(stage_rig_step(&r, h, vec3_make(0.0, 0.4, 0.0)).y == 0.4); /* small ones stay */
    assert_int_equal(r.flags, 0);
    assert_int_equal(r.state.statistics.warm, 5);
}

int test_output_load(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mean_square_of_constant_force_is_exponential),
        cmocka_unit_test(mean_square_is_linear_filter),
        cmocka_unit_test(peaks_are_allowed_and_derated_in_time),
        cmocka_unit_test(derating_keeps_direction),
        cmocka_unit_test(torque_load_is_separate),
        cmocka_unit_test(overloaded_motor_keeps_continuous_force),
        cmocka_unit_test(motor_without_continuous_force_gets_none),
        cmocka_unit_test(warm_motor_is_derated),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
