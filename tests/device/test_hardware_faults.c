/* Faults of real hardware: each ends in safe output within 10 ms, and is told in words. */
#include <string.h>

#include "device/hardware_rig.h"

enum { ARM = 0, LINES = 1 };

/* 1 N on the first arm and its solenoid on; then what the case does; then 10 ms. */
static void begin_pressed(hardware_rig *r)
{
    hardware_rig_begin(r, false);
    hardware_rig_open(r, 2);
    r->couplings[0].stiffness = 100.0;
    r->couplings[0].position[0] = 0.01;
    r->hd->set_hand(0, &(stand_in_hand){.mass = 0.1, .stiffness = 1e5, .damping = 20.0});
    r->commands[0].solenoid = 1;
    hardware_rig_steps(r, 60);
    assert_true(fabs(hardware_rig_force(r, 0) - 1.0) < 0.01);
    assert_true(hardware_rig_solenoid(r, 0));
}

static void expect_safe(hardware_rig *r, int adapter, const char *wanted)
{
    const char *text;
    for (int i = 0; i < 10; i++) {
        hardware_rig_steps(r, 1);
    }
    assert_true(hardware_rig_force(r, 0) == 0.0 || adapter == LINES);
    assert_false(hardware_rig_solenoid(r, 0));
    for (int i = 0; i < 300; i++) { /* and it stays so */
        hardware_rig_steps(r, 1);
        assert_true(hardware_rig_force(r, 0) == 0.0 || adapter == LINES);
        assert_false(hardware_rig_solenoid(r, 0));
    }
    if (wanted != NULL) {
        expect_ok(vbss_device_get_error(r->devices[0], (uint32_t)adapter, NULL, &text));
        if (strstr(text, wanted) == NULL) {
            fail_msg("'%s' says nothing of '%s'", text, wanted);
        }
    }
}

static void unplugged_arm_is_lost(void **state)
{
    (void)state;
    hardware_rig r;
    vbss_openhaptics_status status;
    begin_pressed(&r);
    r.hd->set_fault(0, STAND_IN_UNPLUGGED, 1);
    expect_safe(&r, ARM, "communication failed (0x0302");
    assert_int_equal(r.inputs[0].status, VBSS_DEVICE_STATUS_LOST);
    assert_int_equal(r.inputs[0].stopped, 1);
    assert_int_equal(r.inputs[1].status, VBSS_DEVICE_STATUS_READY); /* the other goes on */
    expect_ok(vbss_openhaptics_get_status(r.openhaptics, 0, &status, sizeof status));
    assert_int_equal(status.state, VBSS_HAPTICS_STATE_LOST);
    r.hd->set_fault(0, STAND_IN_UNPLUGGED, 0); /* back: no force until it is released */
    hardware_rig_steps(&r, 300);
    assert_int_equal(r.inputs[0].status, VBSS_DEVICE_STATUS_READY);
    assert_true(hardware_rig_force(&r, 0) == 0.0);
    expect_ok(vbss_device_clear_emergency_stop(r.devices[0]));
    hardware_rig_steps(&r, 20);
    assert_true(fabs(hardware_rig_force(&r, 0) - 1.0) < 0.01);
    hardware_rig_end(&r);
}

static void single_failed_frame_stops(void **state)
{
    (void)state;
    hardware_rig r;
    begin_pressed(&r);
    r.hd->set_fault(0, STAND_IN_COMM_ERROR, 1);
    expect_safe(&r, ARM, "communication failed");
    assert_int_equal(r.inputs[0].stopped, 1);
    hardware_rig_end(&r);
}

static void non_finite_pose_moves_nothing(void **state)
{
    (void)state;
    hardware_rig r;
    vbss_device_statistics figures;
    begin_pressed(&r);
    r.hd->set_fault(0, STAND_IN_NAN_POSE, 1);
    hardware_rig_steps(&r, 2); /* the servo sees it before the host does */
    assert_true(hardware_rig_force(&r, 0) == 0.0);
    expect_safe(&r, ARM, NULL);
    assert_int_equal(r.inputs[0].status, VBSS_DEVICE_STATUS_STALE);
    expect_ok(vbss_device_get_statistics(r.devices[0], &figures, sizeof figures));
    assert_true(figures.not_finite[0] > 100);
    hardware_rig_end(&r);
}

static void warm_motors_get_no_force(void **state)
{
    (void)state;
    hardware_rig r;
    vbss_openhaptics_status status;
    begin_pressed(&r);
    r.hd->set_fault(0, STAND_IN_WARM, 1);
    expect_safe(&r, ARM, NULL);
    expect_ok(vbss_openhaptics_get_status(r.openhaptics, 0, &status, sizeof status));
    assert_int_equal(status.state, VBSS_HAPTICS_STATE_REFUSING);
    assert_int_equal(status.error, 0x0200);
    assert_true(status.temperature == 0.95);
    assert_int_equal(r.inputs[0].status, VBSS_DEVICE_STATUS_READY); /* it still measures */
    r.hd->set_fault(0, STAND_IN_WARM, 0);
    hardware_rig_steps(&r, 1500);
    assert_true(fabs(hardware_rig_force(&r, 0) - 1.0) < 0.01);
    hardware_rig_end(&r);
}

static void overspeed_arm_rests_for_a_second(void **state)
{
    (void)state;
    hardware_rig r;
    begin_pressed(&r);
    r.hd->set_fault(0, STAND_IN_TOO_FAST, 1);
    expect_safe(&r, ARM, NULL);
    hardware_rig_steps(&r, 1000);
    assert_true(fabs(hardware_rig_force(&r, 0) - 1.0) < 0.01);
    hardware_rig_end(&r);
}

static void uncalibrated_arm_gets_no_force(void **state)
{
    (void)state;
    hardware_rig r;
    vbss_openhaptics_status status;
    hardware_rig_begin(&r, false);
    r.hd->set_fault(0, STAND_IN_UNCALIBRATED, 1);
    hardware_rig_open(&r, 1);
    r.commands[0].force[0] = 1.0;
    hardware_rig_steps(&r, 50);
    assert_true(hardware_rig_force(&r, 0) == 0.0);
    expect_ok(vbss_openhaptics_get_status(r.openhaptics, 0, &status, sizeof status));
    assert_int_equal(status.state, VBSS_HAPTICS_STATE_UNCALIBRATED);
    r.hd->set_fault(0, STAND_IN_UNCALIBRATED, 0); /* in the inkwell */
    hardware_rig_steps(&r, 150);
    assert_true(fabs(hardware_rig_force(&r, 0) - 1.0) < 0.01);
    hardware_rig_end(&r);
}

/* Nobody can put a force out while the servo stands; when it goes on, nothing is left of the old one. */
static void stopped_servo_makes_pose_stale(void **state)
{
    (void)state;
    hardware_rig r;
    vbss_output_result out;
    begin_pressed(&r);
    r.hd->set_fault(0, STAND_IN_STALLED, 1);
    hardware_rig_steps(&r, 10);
    assert_int_equal(r.inputs[0].status, VBSS_DEVICE_STATUS_STALE);
    assert_false(hardware_rig_solenoid(&r, 0));
    expect_ok(vbss_device_write_coupled(r.devices[0], r.now, &r.commands[0], &r.couplings[0], &out,
                                        sizeof out));
    assert_true(out.force[0] == 0.0 && (out.flags & VBSS_OUTPUT_FLAG_INPUT_STALE) != 0);
    r.hd->set_fault(0, STAND_IN_STALLED, 0);
    r.silent = true;
    hardware_rig_steps(&r, 1);
    assert_true(hardware_rig_force(&r, 0) == 0.0);
    hardware_rig_end(&r);
}

static void silent_host_releases_force_within_10_ms(void **state)
{
    (void)state;
    hardware_rig r;
    vbss_openhaptics_status status;
    begin_pressed(&r);
    r.silent = true;
    expect_safe(&r, ARM, NULL);
    expect_ok(vbss_openhaptics_get_status(r.openhaptics, 0, &status, sizeof status));
    assert_true(status.silent_ticks > 100);
    hardware_rig_end(&r);
}

static void late_lines_turn_solenoids_off(void **state)
{
    (void)state;
    hardware_rig r;
    vbss_nidaqmx_status status;
    begin_pressed(&r);
    r.daq->set_fault(STAND_IN_READ_TIMEOUT, 1);
    expect_safe(&r, LINES, "no sample in time (-200284)");
    expect_ok(vbss_nidaqmx_get_status(r.nidaqmx, &status, sizeof status));
    assert_int_equal(status.state, VBSS_HAPTICS_STATE_REFUSING);
    assert_int_equal(r.inputs[0].stopped, 0); /* a handle that is slow is not lost */
    r.daq->set_fault(STAND_IN_READ_TIMEOUT, 0);
    hardware_rig_steps(&r, 10);
    assert_true(hardware_rig_solenoid(&r, 0));
    hardware_rig_end(&r);
}

static void removed_lines_are_lost(void **state)
{
    (void)state;
    hardware_rig r;
    begin_pressed(&r);
    r.daq->set_fault(STAND_IN_REMOVED, 1);
    expect_safe(&r, LINES, "device removed (-200045)");
    assert_true(hardware_rig_force(&r, 0) == 0.0); /* a lost part stops all of the device */
    assert_int_equal(r.inputs[0].status, VBSS_DEVICE_STATUS_LOST);
    assert_int_equal(r.inputs[0].stopped, 1);
    hardware_rig_end(&r);
}

static void warnings_are_only_counted(void **state)
{
    (void)state;
    hardware_rig r;
    vbss_nidaqmx_status status;
    begin_pressed(&r);
    r.daq->set_fault(STAND_IN_WARNING, 1);
    hardware_rig_steps(&r, 100);
    assert_true(hardware_rig_solenoid(&r, 0));
    expect_ok(vbss_nidaqmx_get_status(r.nidaqmx, &status, sizeof status));
    assert_true(status.warnings == 50 && status.state == VBSS_HAPTICS_STATE_RUNNING);
    hardware_rig_end(&r);
}

/* The host does nothing meanwhile, so what it would do does not hide what the servo does not. */
static void servo_releases_force_by_itself(void **state)
{
    (void)state;
    const stand_in_hd_fault faults[] = {STAND_IN_COMM_ERROR, STAND_IN_NAN_POSE, STAND_IN_TOO_FAST};
    for (int i = 0; i < 3; i++) {
        hardware_rig r;
        begin_pressed(&r);
        r.silent = true;
        r.hd->set_fault(0, faults[i], 1);
        hardware_rig_steps(&r, faults[i] == STAND_IN_TOO_FAST ? 2 : 1); /* told when a frame ends */
        assert_true(hardware_rig_force(&r, 0) == 0.0);
        hardware_rig_steps(&r, 1);
        assert_true(hardware_rig_force(&r, 0) == 0.0);
        hardware_rig_end(&r);
    }
}

static void failed_measurement_turns_solenoids_off(void **state)
{
    (void)state;
    hardware_rig r;
    begin_pressed(&r);
    uint64_t writes = r.daq->writes();
    r.daq->set_fault(STAND_IN_READ_TIMEOUT, 1);
    expect_ok(vbss_nidaqmx_poll(r.nidaqmx, r.now + 0.001)); /* while the host still wants it on */
    assert_false(hardware_rig_solenoid(&r, 0));
    expect_ok(vbss_nidaqmx_poll(r.nidaqmx, r.now + 0.002));
    assert_false(hardware_rig_solenoid(&r, 0));
    assert_true(r.daq->writes() == writes + 1);
    hardware_rig_end(&r);
}

int test_hardware_faults(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(unplugged_arm_is_lost),
        cmocka_unit_test(single_failed_frame_stops),
        cmocka_unit_test(non_finite_pose_moves_nothing),
        cmocka_unit_test(warm_motors_get_no_force),
        cmocka_unit_test(overspeed_arm_rests_for_a_second),
        cmocka_unit_test(uncalibrated_arm_gets_no_force),
        cmocka_unit_test(stopped_servo_makes_pose_stale),
        cmocka_unit_test(silent_host_releases_force_within_10_ms),
        cmocka_unit_test(late_lines_turn_solenoids_off),
        cmocka_unit_test(removed_lines_are_lost),
        cmocka_unit_test(warnings_are_only_counted),
        cmocka_unit_test(servo_releases_force_by_itself),
        cmocka_unit_test(failed_measurement_turns_solenoids_off),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
