/* Devices go back to what was saved, and go on from it to the bit. */
#include <stdlib.h>
#include <string.h>

#include "device/rig.h"
#include "fixtures/device_body.h"

/* In each of these the device is in the middle of something. */
static const size_t moments[] = {0,   1,   7,   32,  37,  48,  55,  62,  84,  110, 140, 155, 171,
                                 176, 195, 212, 240, 265, 290, 305, 315, 321, 346, 405, 460};

static void restored_device_continues_bit_equal(void **state)
{
    (void)state;
    const harness_body body = device_body();
    harness_save_restore_continue_at(&body, moments, sizeof moments / sizeof moments[0], 40);
}

/* Hashes see only what is saved. What hosts and hardware see must go on alike, too: nothing that matters is left
 * out. */
enum { AFTER = 60 };
typedef struct reported {
    vbss_device_input inputs[AFTER];
    vbss_output_result results[AFTER];
    vbss_device_statistics in;
    vbss_output_statistics out;
} reported;

static void live_on(vbss_device *device, reported *t)
{
    memset(t, 0, sizeof *t);
    for (int i = 0; i < AFTER; i++) {
        expect_ok(device_run_step(device, &t->inputs[i], &t->results[i]));
    }
    expect_ok(vbss_device_get_statistics(device, &t->in, sizeof t->in));
    expect_ok(vbss_device_get_output_statistics(device, &t->out, sizeof t->out));
}

static bool are_same(const void *a, const void *b, size_t bytes)
{
    return memcmp(a, b, bytes) == 0; /* both cleared before they were filled */
}

static void expect_reported(const reported *wanted, const reported *got, size_t moment)
{
    for (int i = 0; i < AFTER; i++) {
        if (!are_same(&wanted->inputs[i], &got->inputs[i], sizeof got->inputs[i]) ||
            !are_same(&wanted->results[i], &got->results[i], sizeof got->results[i])) {
            fail_msg("restored at step %zu, step %zu is told otherwise", moment,
                     moment + (size_t)i);
        }
    }
    assert_memory_equal(&wanted->in, &got->in, sizeof got->in);
    assert_memory_equal(&wanted->out, &got->out, sizeof got->out);
}

static void steps(vbss_device *device, size_t count)
{
    vbss_device_input input;
    vbss_output_result result;
    for (size_t i = 0; i < count; i++) {
        expect_ok(device_run_step(device, &input, &result));
    }
}

static void restored_at(size_t moment)
{
    static reported wanted, got;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    device_run first, fresh, other;
    uint8_t bytes[8192];
    uint64_t count;
    expect_ok(device_run_create(context, &first));
    steps(first.device, moment);
    expect_ok(vbss_device_save(first.device, bytes, sizeof bytes, &count));
    live_on(first.device, &wanted);
    expect_ok(device_run_create(context, &fresh));
    expect_ok(vbss_device_restore(fresh.device, bytes, count));
    live_on(fresh.device, &got);
    expect_reported(&wanted, &got, moment);
    expect_ok(device_run_create(context, &other)); /* has lived otherwise, in another frame */
    expect_ok(vbss_device_set_calibration(other.device, NULL));
    steps(other.device, moment < 200 ? 350 : 100);
    expect_ok(vbss_device_restore(other.device, bytes, count));
    live_on(other.device, &got);
    expect_reported(&wanted, &got, moment);
    harness_context_end(context, &memory);
}

static void restored_device_reports_same_values(void **state)
{
    (void)state;
    for (size_t moment = 0; moment < DEVICE_RUN_STEPS; moment += moment < 2 ? 1 : 9) {
        restored_at(moment);
    }
    restored_at(150); /* as the clutch is held */
    restored_at(165); /* as it is let go */
}

/* Between a read that failed and its write. */
static void restore_between_read_and_write(void **state)
{
    (void)state;
    device_rig one, two;
    uint8_t bytes[8192];
    uint64_t count;
    device_rig_begin(&one);
    device_rig_begin(&two);
    device_rig_open(&one, 1);
    device_rig_open(&two, 1);
    one.command.solenoid = two.command.solenoid = 1;
    device_rig_steps(&one, 5);
    device_rig_fault(&one, 0, VBSS_MOCK_FAULT_READ_FAILS, 5.0, 0.0);
    device_rig_read(&one);
    expect_ok(vbss_device_save(one.device, bytes, sizeof bytes, &count));
    expect_ok(vbss_device_restore(two.device, bytes, count));
    two.now = one.now;
    device_rig_write(&one, &one.command);
    device_rig_write(&two, &two.command);
    assert_int_equal(one.result.solenoid, 0);
    assert_memory_equal(&one.result, &two.result, sizeof one.result);
    device_rig_end(&two);
    device_rig_end(&one);
}

/* Before the first read any time is good; after it only later ones. */
static void restored_device_keeps_time(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    device_run run, fresh;
    vbss_device_input input;
    uint8_t bytes[8192];
    uint64_t count;
    expect_ok(device_run_create(context, &run));
    expect_ok(device_run_create(context, &fresh));
    steps(run.device, 20);
    expect_ok(vbss_device_save(run.device, bytes, sizeof bytes, &count));
    expect_ok(vbss_device_restore(fresh.device, bytes, count));
    expect_result(VBSS_ERROR_OUT_OF_RANGE,
                  vbss_device_read(fresh.device, 0.018, &input, sizeof input));
    harness_context_end(context, &memory);
}

static void steps_do_not_allocate(void **state)
{
    (void)state;
    const harness_body body = device_body();
    assert_int_equal(harness_step_allocations(&body, DEVICE_RUN_STEPS), 0);
}

/* That the run goes through all it should, or its hashes show little. */
static void recorded_run_covers_all_events(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    device_run run;
    vbss_device_input input;
    vbss_output_result result;
    vbss_device_statistics in;
    vbss_output_statistics out;
    uint32_t events = 0, statuses = 0;
    expect_ok(device_run_create(context, &run));
    vbss_device *device = run.device;
    for (int i = 0; i < DEVICE_RUN_STEPS; i++) {
        expect_ok(device_run_step(device, &input, &result));
        events |= input.events;
        statuses |= 1u << input.status;
    }
    expect_ok(vbss_device_get_statistics(device, &in, sizeof in));
    expect_ok(vbss_device_get_output_statistics(device, &out, sizeof out));
    assert_int_equal(events | VBSS_DEVICE_EVENT_RESTARTED, 4095);
    assert_int_equal(statuses, 14);
    const uint64_t met[] = {in.repeated[0],
                            in.repeated[1],
                            in.out_of_order[0],
                            in.not_finite[0],
                            in.not_unit[0],
                            in.failed_reads[0],
                            in.failed_writes[0],
                            in.lost[0],
                            in.faults[0],
                            in.jaw_refused,
                            in.pose_stale,
                            in.jaw_stale,
                            in.clamped_reads,
                            in.clutches,
                            out.not_finite,
                            out.faults,
                            out.clamped,
                            out.continuous,
                            out.warm,
                            out.slewed,
                            out.input_stale,
                            out.command_stale,
                            out.stopped,
                            out.solenoid_off,
                            out.solenoid_spent,
                            out.watchdogs,
                            out.stops,
                            out.pulses};
    for (size_t i = 0; i < sizeof met / sizeof met[0]; i++) {
        assert_true(met[i] > 0);
    }
    harness_context_end(context, &memory);
}

/* The calibration is part of the state: it comes back with it. */
static void calibration_is_restored(void **state)
{
    (void)state;
    uint8_t bytes[8192];
    uint64_t count;
    device_rig r;
    device_rig_begin(&r);
    r.calibration.scale = 3.0;
    device_rig_open(&r, 1);
    device_rig_steps(&r, 20);
    expect_ok(vbss_device_save(r.device, bytes, sizeof bytes, &count));
    expect_ok(vbss_device_set_calibration(r.device, NULL));
    expect_ok(vbss_device_restore(r.device, bytes, count));
    device_rig_steps(&r, 1);
    expect_near(3.0 * (0.1 * r.now - 0.005), r.input.position[0], 1e-15);
    device_rig_end(&r);
}

int test_state(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(restored_device_continues_bit_equal),
        cmocka_unit_test(restored_device_reports_same_values),
        cmocka_unit_test(restore_between_read_and_write),
        cmocka_unit_test(restored_device_keeps_time),
        cmocka_unit_test(steps_do_not_allocate),
        cmocka_unit_test(recorded_run_covers_all_events),
        cmocka_unit_test(calibration_is_restored),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
