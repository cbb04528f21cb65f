/* Watchdog and emergency stop: what is old goes to zero in time, what is stopped at once and for good. */
#include "device/stage_rig.h"

static const double h = 1e-3;
static const uint32_t stale = VBSS_OUTPUT_FLAG_INPUT_STALE | VBSS_OUTPUT_FLAG_COMMAND_STALE;

/* At age t after the timeout: the force at which it began, times 1 - t/ramp. */
static void expect_ramp(uint32_t flag, double timeout)
{
    stage_rig r = stage_rig_wide();
    r.config.input_timeout = 0.005;
    r.config.command_timeout = 0.008;
    r.config.ramp_time = 0.004;
    for (int age = 0; age <= 20; age++) {
        double *old = flag == VBSS_OUTPUT_FLAG_INPUT_STALE ? &r.demand.input_age : &r.demand.age;
        *old = age * h;
        vec3 out = stage_rig_step(&r, h, vec3_make(0.0, -1.2, 1.6));
        double over = age * h - timeout;
        double left = over > 0.0 ? vbss_max(1.0 - over / 0.004, 0.0) : 1.0;
        expect_near(2.0 * left, vec3_norm(out), 1e-12);
        expect_near(0.0, vec3_cross(out, vec3_make(0.0, -0.6, 0.8)).x, 1e-15);
        assert_int_equal(r.flags & stale, over > 0.0 ? flag : 0);
    }
    assert_int_equal(r.state.statistics.watchdogs, 1);
    r.demand.age = r.demand.input_age = 0.0;
    expect_near(2.0, vec3_norm(stage_rig_step(&r, h, vec3_make(0.0, -1.2, 1.6))), 1e-15);
    assert_int_equal(r.flags, 0);
}

static void stale_pose_ramps_to_zero(void **state)
{
    (void)state;
    expect_ramp(VBSS_OUTPUT_FLAG_INPUT_STALE, 0.005);
}

static void stale_command_ramps_to_zero(void **state)
{
    (void)state;
    expect_ramp(VBSS_OUTPUT_FLAG_COMMAND_STALE, 0.008);
}

/* The defaults: nothing after 10 ms. */
static void force_is_zero_after_ten_milliseconds(void **state)
{
    (void)state;
    stage_rig r;
    expect_ok(vbss_output_config_init(&r.config, sizeof r.config));
    stage_rig_begin(&r);
    for (int i = 0; i < 10; i++) {
        stage_rig_step(&r, h, vec3_make(0.8, 0.0, 0.0));
    }
    assert_true(r.state.force.x == 0.8);
    for (int age = 1; age < 10; age++) {
        r.demand.age = age * h;
        assert_true(stage_rig_step(&r, h, vec3_make(0.8, 0.0, 0.0)).x > 0.0);
    }
    r.demand.age = 0.01;
    expect_near(0.0, stage_rig_step(&r, h, vec3_make(0.8, 0.0, 0.0)).x, 1e-15);
}

static void ramp_starts_at_last_force_and_never_rises(void **state)
{
    (void)state;
    stage_rig r = stage_rig_wide();
    stage_rig_step(&r, h, vec3_make(1.0, 0.0, 0.0));
    r.demand.age = 0.0075; /* half way */
    expect_near(0.5, stage_rig_step(&r, h, vec3_make(50.0, 0.0, 0.0)).x, 1e-12);
    expect_near(0.25, stage_rig_step(&r, h, vec3_make(0.25, 0.0, 0.0)).x, 1e-15);
    r.demand.age = 0.0051;
    expect_near(0.98, stage_rig_step(&r, h, vec3_make(50.0, 0.0, 0.0)).x, 1e-12);
}

static void force_recovers_at_rate(void **state)
{
    (void)state;
    stage_rig r = stage_rig_wide();
    r.config.force_rise = 500.0;
    for (int i = 0; i < 6; i++) {
        stage_rig_step(&r, h, vec3_make(3.0, 0.0, 0.0));
    }
    r.demand.input_age = 1.0;
    assert_true(stage_rig_step(&r, h, vec3_make(3.0, 0.0, 0.0)).x == 0.0);
    r.demand.input_age = 0.0;
    for (int i = 1; i < 7; i++) {
        expect_near(0.5 * i, stage_rig_step(&r, h, vec3_make(3.0, 0.0, 0.0)).x, 1e-15);
    }
}

static void missing_first_command_is_stale(void **state)
{
    (void)state;
    stage_rig r = stage_rig_wide();
    output_demand none = vbss_output_repeat_demand(&r.state, h);
    uint32_t flags = vbss_output_advance(&r.config, &r.state, h, &none);
    assert_int_equal(flags & stale, stale);
    vbss_output_store_demand(&r.state, &none); /* cannot grow older than that */
    assert_true(r.state.last_demand.age == OUTPUT_NEVER &&
                r.state.last_demand.input_age == OUTPUT_NEVER);
}

static void torques_ramp_alike(void **state)
{
    (void)state;
    stage_rig r = stage_rig_wide();
    r.demand.torque = vec3_make(0.0, 0.0, -0.4);
    stage_rig_step(&r, h, vec3_make(1.0, 0.0, 0.0));
    r.demand.age = 0.0075;
    stage_rig_step(&r, h, vec3_make(1.0, 0.0, 0.0));
    expect_near(-0.2, r.state.torque.z, 1e-15);
    expect_near(0.4, r.state.statistics.largest_torque, 1e-15);
    r.demand.age = 1.0;
    stage_rig_step(&r, h, vec3_make(1.0, 0.0, 0.0));
    assert_true(r.state.torque.z == 0.0);
}

static void ramp_may_be_a_step(void **state)
{
    (void)state;
    stage_rig r = stage_rig_wide();
    r.config.ramp_time = 0.0;
    stage_rig_step(&r, h, vec3_make(1.0, 0.0, 0.0));
    r.demand.age = 0.005;
    assert_true(stage_rig_step(&r, h, vec3_make(1.0, 0.0, 0.0)).x == 1.0);
    r.demand.age = 0.0051;
    assert_true(stage_rig_step(&r, h, vec3_make(1.0, 0.0, 0.0)).x == 0.0);
}

/* ---- the emergency stop */

static void stop_is_immediate_and_permanent(void **state)
{
    (void)state;
    stage_rig r = stage_rig_wide();
    r.demand.solenoid = true;
    r.demand.torque = vec3_make(0.0, 1.0, 0.0);
    stage_rig_step(&r, h, vec3_make(1.0, 0.0, 0.0));
    vbss_output_latch_stop(&r.state);
    assert_true(vec3_norm(r.state.force) == 0.0 && vec3_norm(r.state.torque) == 0.0);
    assert_false(r.state.solenoid.is_on);
    for (int i = 0; i < 100; i++) {
        assert_true(vec3_norm(stage_rig_step(&r, h, vec3_make(1.0, 0.0, 0.0))) == 0.0);
        assert_true(vec3_norm(r.state.torque) == 0.0);
        assert_false(r.state.solenoid.is_on);
        assert_int_equal(r.flags, VBSS_OUTPUT_FLAG_STOPPED | VBSS_OUTPUT_FLAG_SOLENOID_OFF);
    }
    vbss_output_latch_stop(&r.state);
    assert_int_equal(r.state.statistics.stops, 1);
    assert_int_equal(r.state.statistics.stopped, 100);
}

static void force_rises_from_zero_after_release(void **state)
{
    (void)state;
    stage_rig r = stage_rig_wide();
    r.config.force_rise = 500.0;
    for (int i = 0; i < 6; i++) {
        stage_rig_step(&r, h, vec3_make(3.0, 0.0, 0.0));
    }
    vbss_output_latch_stop(&r.state);
    stage_rig_step(&r, h, vec3_make(3.0, 0.0, 0.0));
    r.state.is_stopped = false;
    expect_near(0.5, stage_rig_step(&r, h, vec3_make(3.0, 0.0, 0.0)).x, 1e-15);
}

static void late_host_is_counted(void **state)
{
    (void)state;
    stage_rig r = stage_rig_wide();
    stage_rig_step(&r, 0.005, vec3_zero());
    assert_int_equal(r.flags, 0);
    stage_rig_step(&r, 0.0051, vec3_zero());
    assert_int_equal(r.flags, VBSS_OUTPUT_FLAG_LATE);
    assert_int_equal(r.state.statistics.late, 1);
}

int test_output_watchdog(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stale_pose_ramps_to_zero),
        cmocka_unit_test(stale_command_ramps_to_zero),
        cmocka_unit_test(force_is_zero_after_ten_milliseconds),
        cmocka_unit_test(ramp_starts_at_last_force_and_never_rises),
        cmocka_unit_test(force_recovers_at_rate),
        cmocka_unit_test(missing_first_command_is_stale),
        cmocka_unit_test(torques_ramp_alike),
        cmocka_unit_test(ramp_may_be_a_step),
        cmocka_unit_test(stop_is_immediate_and_permanent),
        cmocka_unit_test(force_rises_from_zero_after_release),
        cmocka_unit_test(late_host_is_counted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
