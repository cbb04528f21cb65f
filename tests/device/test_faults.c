/* Everything that can go wrong with one adapter, each on demand: what the device tells, and that its output is
 * safe within 10 ms. */
#include <string.h>

#include "device/rig.h"

/* A force on the hand that is up, a solenoid that is on. */
static void begin(device_rig *r)
{
    device_rig_begin(r);
    r->command.force[0] = 0.8;
    r->command.solenoid = 1;
    device_rig_open(r, 1);
    device_rig_steps(r, 20);
    expect_near(0.8, r->result.force[0], 1e-15);
    assert_int_equal(r->result.solenoid, 1);
    assert_int_equal(r->input.status, VBSS_DEVICE_STATUS_READY);
    device_rig_forget(r);
    device_rig_steps(r, 1);
    assert_int_equal(r->events, 0); /* nothing is told twice */
}

static bool is_off(const device_rig *r)
{
    return fabs(r->result.force[0]) < 1e-12 && r->result.solenoid == 0; /* rounding of times */
}

/* Ten milliseconds after the last good sample. The pose is held there. */
static void expect_stale(const device_rig *r, double good)
{
    assert_true(is_off(r));
    expect_near(0.1 * good - 0.005, r->input.position[0], 1e-15);
    assert_true(r->input.velocity[0] == 0.0 && r->input.angular_velocity[2] == 0.0);
    assert_int_equal(r->input.status, VBSS_DEVICE_STATUS_STALE);
    assert_true((r->input.stale & VBSS_DEVICE_HAS_POSITION) != 0);
    assert_true((r->events & VBSS_DEVICE_EVENT_STALE) != 0);
    assert_true((r->flags & VBSS_OUTPUT_FLAG_INPUT_STALE) != 0);
    vbss_device_statistics s = device_rig_statistics(r);
    assert_int_equal(s.pose_stale, 1);
    expect_near(0.01, r->input.age, 1e-12);
}

/* And is over: all is as it was. */
static void expect_recovery(device_rig *r)
{
    device_rig_forget(r);
    device_rig_steps(r, 30);
    assert_int_equal(r->input.status, VBSS_DEVICE_STATUS_READY);
    assert_true((r->events & VBSS_DEVICE_EVENT_FRESH) != 0);
    expect_near(0.8, r->result.force[0], 1e-15);
    assert_int_equal(r->result.solenoid, 1);
    expect_near(0.1 * r->now - 0.005, r->input.position[0], 1e-15);
    expect_near(0.1, r->input.velocity[0], 1e-9);
}

static void refused_samples(vbss_mock_fault fault, double value, size_t counter)
{
    device_rig r;
    begin(&r);
    double good = r.now;
    device_rig_fault(&r, 0, fault, 30.0, value);
    device_rig_steps(&r, 9);
    assert_true(r.result.force[0] > 0.0);
    device_rig_steps(&r, 1);
    expect_stale(&r, good);
    vbss_device_statistics s = device_rig_statistics(&r);
    uint64_t count;
    memcpy(&count, (unsigned char *)&s + counter, sizeof count);
    assert_int_equal(count, 10);
    assert_true((r.events & VBSS_DEVICE_EVENT_REFUSED) != 0);
    device_rig_steps(&r, 20);
    expect_recovery(&r);
    device_rig_end(&r);
}

static void non_finite_numbers_are_rejected(void **state)
{
    (void)state;
    for (int which = 0; which <= 4; which++) {
        if (which != 2) { /* this hand gives no velocity: nobody looks there */
            refused_samples(VBSS_MOCK_FAULT_NAN, which,
                            offsetof(vbss_device_statistics, not_finite));
        }
    }
    device_rig r;
    begin(&r);
    device_rig_fault(&r, 0, VBSS_MOCK_FAULT_NAN, 30.0, 2.0);
    device_rig_steps(&r, 20);
    assert_int_equal(r.events & VBSS_DEVICE_EVENT_REFUSED, 0);
    device_rig_end(&r);
}

static void non_unit_orientations_are_rejected(void **state)
{
    (void)state;
    refused_samples(VBSS_MOCK_FAULT_NORM, 0.9, offsetof(vbss_device_statistics, not_unit));
    refused_samples(VBSS_MOCK_FAULT_NORM, 0.0, offsetof(vbss_device_statistics, not_unit));
    refused_samples(VBSS_MOCK_FAULT_NORM, 1e9, offsetof(vbss_device_statistics, not_unit));
}

static void nearly_unit_orientations_are_normalised(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    device_rig_fault(&r, 0, VBSS_MOCK_FAULT_NORM, 30.0, 1.0009);
    device_rig_steps(&r, 10);
    assert_int_equal(r.events & VBSS_DEVICE_EVENT_REFUSED, 0);
    double square = 0.0;
    for (int i = 0; i < 4; i++) {
        square += r.input.orientation[i] * r.input.orientation[i];
    }
    expect_near(1.0, square, 1e-15);
    device_rig_end(&r);
}

static void absurd_poses_are_rejected(void **state)
{
    (void)state;
    refused_samples(VBSS_MOCK_FAULT_JUMP, 1e6, offsetof(vbss_device_statistics, out_of_range));
}

static void stalled_device_is_stale(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    device_rig_fault(&r, 0, VBSS_MOCK_FAULT_STALL, 30.0, 0.0);
    device_rig_steps(&r, 3);
    assert_int_equal(r.input.status, VBSS_DEVICE_STATUS_READY); /* 3 ms are no reason */
    double good = r.input.time;
    device_rig_steps(&r, 8);
    expect_stale(&r, good);
    assert_int_equal(device_rig_statistics(&r).repeated[0], 10);
    device_rig_steps(&r, 19);
    /* The first new sample is far from the last: no velocity until there is a second. */
    device_rig_steps(&r, 1);
    assert_int_equal(r.input.status, VBSS_DEVICE_STATUS_READY);
    assert_true(r.input.velocity[0] == 0.0 && r.input.position[0] > 0.1 * good - 0.003);
    expect_near(0.029, device_rig_statistics(&r).oldest_pose, 1e-9);
    device_rig_steps(&r, 1);
    expect_near(0.1, r.input.velocity[0], 1e-9);
    device_rig_end(&r);
}

static void failed_reads_are_no_samples(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    double good = r.now;
    device_rig_fault(&r, 0, VBSS_MOCK_FAULT_READ_FAILS, 30.0, 0.0);
    device_rig_steps(&r, 1);
    assert_int_equal(r.result.solenoid, 0); /* off on every fault */
    expect_near(0.8, r.result.force[0], 1e-15);
    device_rig_steps(&r, 9);
    expect_stale(&r, good);
    assert_int_equal(device_rig_statistics(&r).failed_reads[0], 10);
    assert_true((r.events & VBSS_DEVICE_EVENT_FAILED) != 0);
    vbss_result result;
    const char *text;
    expect_ok(vbss_device_get_error(r.device, 0, &result, &text));
    assert_int_equal(result, VBSS_ERROR_DEVICE);
    assert_non_null(strstr(text, "a read fails"));
    device_rig_steps(&r, 20);
    expect_recovery(&r);
    device_rig_end(&r);
}

/* ---- lost */

static void lost_device_stops_until_release(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    device_rig_fault(&r, 0, VBSS_MOCK_FAULT_DISCONNECT, 30.0, 0.0);
    device_rig_steps(&r, 1);
    assert_true(is_off(&r));
    assert_int_equal(r.input.status, VBSS_DEVICE_STATUS_LOST);
    assert_int_equal(r.input.stopped, 1);
    assert_int_equal(r.events & (VBSS_DEVICE_EVENT_LOST | VBSS_DEVICE_EVENT_STOPPED),
                     VBSS_DEVICE_EVENT_LOST | VBSS_DEVICE_EVENT_STOPPED);
    assert_true((r.flags & VBSS_OUTPUT_FLAG_NOT_WRITTEN) != 0);
    device_rig_steps(&r, 40);
    assert_int_equal(r.input.status, VBSS_DEVICE_STATUS_READY);
    assert_true((r.events & VBSS_DEVICE_EVENT_FOUND) != 0);
    assert_true(is_off(&r));
    expect_ok(vbss_device_clear_emergency_stop(r.device));
    device_rig_steps(&r, 1);
    expect_near(0.5, r.result.force[0], 1e-15); /* rises from zero */
    device_rig_steps(&r, 30);
    expect_near(0.8, r.result.force[0], 1e-15);
    assert_int_equal(device_rig_statistics(&r).lost[0], 1);
    assert_true(device_rig_statistics(&r).failed_writes[0] > 20);
    device_rig_end(&r);
}

static void lost_device_only_ages(void **state)
{
    (void)state;
    device_rig r;
    device_rig_begin(&r);
    r.config.stop_when_lost = 0;
    r.command.force[0] = 0.8;
    device_rig_open(&r, 1);
    device_rig_steps(&r, 20);
    device_rig_fault(&r, 0, VBSS_MOCK_FAULT_DISCONNECT, 30.0, 0.0);
    device_rig_steps(&r, 11);
    assert_int_equal(r.input.status, VBSS_DEVICE_STATUS_LOST);
    assert_int_equal(r.input.stopped, 0);
    assert_true(r.result.force[0] == 0.0);
    device_rig_steps(&r, 40);
    expect_near(0.8, r.result.force[0], 1e-15);
    device_rig_end(&r);
}

/* ---- what a device says of itself */

static void device_without_force_capability_gets_none(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    device_rig_fault(&r, 0, VBSS_MOCK_FAULT_REFUSAL, 30.0, 0.0);
    device_rig_steps(&r, 1);
    assert_true(is_off(&r));
    assert_int_equal(r.input.status, VBSS_DEVICE_STATUS_READY);
    assert_true((r.events & VBSS_DEVICE_EVENT_FAULT) != 0);
    assert_true((r.flags & VBSS_OUTPUT_FLAG_FAULT) != 0);
    device_rig_steps(&r, 40);
    expect_near(0.8, r.result.force[0], 1e-15);
    assert_int_equal(device_rig_statistics(&r).faults[0], 1);
    device_rig_end(&r);
}

/* Nor does it begin to take them because it says nothing. */
static void force_refusal_holds_until_new_sample(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    device_rig_fault(&r, 0, VBSS_MOCK_FAULT_REFUSAL, 2.0, 0.0);
    device_rig_steps(&r, 2);
    device_rig_fault(&r, 0, VBSS_MOCK_FAULT_READ_FAILS, 3.0, 0.0);
    device_rig_steps(&r, 3);
    assert_true((r.result.flags & VBSS_OUTPUT_FLAG_FAULT) != 0);
    device_rig_steps(&r, 1);
    assert_int_equal(r.result.flags & VBSS_OUTPUT_FLAG_FAULT, 0);
    device_rig_end(&r);
}

static void device_can_request_emergency_stop(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    device_rig_fault(&r, 0, VBSS_MOCK_FAULT_STOP, 30.0, 0.0);
    uint64_t accepted = device_rig_statistics(&r).accepted[0];
    device_rig_steps(&r, 1);
    assert_true(is_off(&r));
    expect_near(0.1 * r.now - 0.005, r.input.position[0],
                1e-15); /* the sample counts all the same */
    assert_int_equal(device_rig_statistics(&r).accepted[0], accepted + 1);
    assert_true((r.events & VBSS_DEVICE_EVENT_STOPPED) != 0);
    expect_ok(vbss_device_clear_emergency_stop(r.device)); /* the reason is still there */
    device_rig_steps(&r, 1);
    assert_true(is_off(&r));
    device_rig_steps(&r, 40);
    assert_true(is_off(&r));
    expect_ok(vbss_device_clear_emergency_stop(r.device));
    device_rig_steps(&r, 30);
    expect_near(0.8, r.result.force[0], 1e-15);
    assert_int_equal(device_rig_output_statistics(&r).stops, 2);
    device_rig_end(&r);
}

static void warm_motor_is_derated(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    device_rig_fault(&r, 0, VBSS_MOCK_FAULT_TEMPERATURE, 30.0, 1.0);
    device_rig_steps(&r, 1);
    assert_true(r.result.force[0] == 0.0);
    assert_int_equal(r.flags & VBSS_OUTPUT_FLAG_WARM, VBSS_OUTPUT_FLAG_WARM);
    expect_near(1.0, r.input.temperature, 0.0);
    device_rig_end(&r);
}

static void failed_write_turns_solenoid_off(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    device_rig_fault(&r, 0, VBSS_MOCK_FAULT_WRITE_FAILS, 2.0, 0.0);
    device_rig_steps(&r, 1);
    assert_int_equal(r.result.flags, VBSS_OUTPUT_FLAG_NOT_WRITTEN);
    device_rig_steps(&r, 1);
    assert_int_equal(r.result.solenoid, 0);
    assert_int_equal(device_rig_statistics(&r).failed_writes[0], 2);
    vbss_result result;
    const char *text;
    expect_ok(vbss_device_get_error(r.device, 0, &result, &text));
    assert_int_equal(result, VBSS_ERROR_DEVICE);
    assert_non_null(strstr(text, "a write fails"));
    device_rig_steps(&r, 2);
    assert_int_equal(r.result.flags, 0);
    assert_int_equal(r.result.solenoid, 1);
    device_rig_end(&r);
}

static void broken_handle_wire_makes_opening_stale(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    device_rig_fault(&r, 0, VBSS_MOCK_FAULT_JAW, 200.0, 9.7);
    device_rig_steps(&r, 102);
    assert_int_equal(r.input.status, VBSS_DEVICE_STATUS_READY);
    assert_true((r.input.stale & VBSS_DEVICE_HAS_JAW) != 0);
    expect_near(0.5, r.input.jaw, 1e-15); /* held */
    expect_near(9.7, r.input.jaw_raw, 0.0);
    assert_int_equal(r.result.solenoid, 0);
    expect_near(0.8, r.result.force[0], 1e-15);
    assert_int_equal(device_rig_statistics(&r).jaw_refused, 102);
    assert_true((r.events & VBSS_DEVICE_EVENT_JAW_STALE) != 0);
    assert_true((r.events & VBSS_DEVICE_EVENT_REFUSED) != 0);
    device_rig_steps(&r, 110);
    assert_int_equal(r.input.stale, 0);
    assert_int_equal(r.result.solenoid, 1);
    device_rig_end(&r);
}

int test_faults(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(non_finite_numbers_are_rejected),
        cmocka_unit_test(non_unit_orientations_are_rejected),
        cmocka_unit_test(nearly_unit_orientations_are_normalised),
        cmocka_unit_test(absurd_poses_are_rejected),
        cmocka_unit_test(stalled_device_is_stale),
        cmocka_unit_test(failed_reads_are_no_samples),
        cmocka_unit_test(lost_device_stops_until_release),
        cmocka_unit_test(lost_device_only_ages),
        cmocka_unit_test(device_without_force_capability_gets_none),
        cmocka_unit_test(force_refusal_holds_until_new_sample),
        cmocka_unit_test(device_can_request_emergency_stop),
        cmocka_unit_test(warm_motor_is_derated),
        cmocka_unit_test(failed_write_turns_solenoid_off),
        cmocka_unit_test(broken_handle_wire_makes_opening_stale),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
