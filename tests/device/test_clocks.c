/* Times of samples: rates that drop, samples that come late or out of order, clocks that begin anew. */
#include "device/rig.h"

static void begin(device_rig *r)
{
    device_rig_begin(r);
    r->command.force[0] = 0.8;
}

/* A device at 250 Hz under a host at 1 kHz: the pose is held in between, the velocity is right, nothing is stale. */
static void falling_rate_is_followed(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    device_rig_open(&r, 1);
    device_rig_steps(&r, 20);
    device_rig_fault(&r, 0, VBSS_MOCK_FAULT_RATE, 100.0, 0.004);
    device_rig_forget(&r);
    for (int i = 0; i < 90; i++) {
        device_rig_steps(&r, 1);
        assert_int_equal(r.input.status, VBSS_DEVICE_STATUS_READY);
        expect_near(0.1, r.input.velocity[0], 1e-9);
        expect_near(1.0, r.input.angular_velocity[2], 1e-9);
        expect_near(0.1 * r.input.time - 0.005, r.input.position[0], 1e-15);
        assert_true(r.input.age < 0.0031);
    }
    assert_int_equal(r.flags, 0);
    vbss_device_statistics s = device_rig_statistics(&r);
    assert_int_equal(s.accepted[0] + s.repeated[0], 110);
    assert_int_equal(s.accepted[0], 20 + 23);
    device_rig_end(&r);
}

/* At 100 Hz the watchdog would act between samples; a device that says so from the begin is waited for. */
static void slow_device_has_longer_timeout(void **state)
{
    (void)state;
    for (int reported = 0; reported < 2; reported++) {
        device_rig r;
        begin(&r);
        r.capabilities[0].update_rate = reported == 1 ? 100.0 : 0.0;
        device_rig_open(&r, 1);
        device_rig_fault(&r, 0, VBSS_MOCK_FAULT_RATE, 1000.0, 0.01);
        device_rig_steps(&r, 200);
        assert_int_equal((r.events & VBSS_DEVICE_EVENT_STALE) != 0, reported == 0);
        assert_int_equal((r.flags & VBSS_OUTPUT_FLAG_INPUT_STALE) != 0, reported == 0);
        device_rig_fault(&r, 0, VBSS_MOCK_FAULT_STALL, 1000.0, 0.0);
        device_rig_steps(&r, 32);
        assert_int_equal(r.input.status, VBSS_DEVICE_STATUS_STALE); /* but not for ever */
        device_rig_end(&r);
    }
}

/* Steady lateness of 8 ms: told by a shared clock only. */
static void late_sample_is_aged_on_shared_clock(void **state)
{
    (void)state;
    for (int shared = 0; shared < 2; shared++) {
        device_rig r;
        begin(&r);
        r.config.clock = shared;
        device_rig_open(&r, 1);
        device_rig_steps(&r, 20);
        device_rig_fault(&r, 0, VBSS_MOCK_FAULT_LATE, 500.0, 0.0085);
        device_rig_steps(&r, 40);
        vbss_device_statistics s = device_rig_statistics(&r);
        assert_int_equal(s.out_of_order[0], 8); /* until it has caught up */
        assert_int_equal(r.input.status,
                         shared == 1 ? VBSS_DEVICE_STATUS_STALE : VBSS_DEVICE_STATUS_READY);
        expect_near(shared == 1 ? 0.0085 : 0.0, r.input.age, 1e-12);
        /* 3.5 of 5 ms of the ramp are over. */
        if (shared == 1) {
            assert_true(r.result.force[0] > 0.0 && r.result.force[0] < 0.8);
        } else {
            expect_near(0.8, r.result.force[0], 1e-15);
        }
        device_rig_end(&r);
    }
}

static void out_of_order_samples_are_rejected(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    device_rig_open(&r, 1);
    device_rig_steps(&r, 20);
    device_rig_fault(&r, 0, VBSS_MOCK_FAULT_SHUFFLE, 60.0, 0.0011);
    double before = r.input.position[0];
    device_rig_forget(&r);
    for (int i = 0; i < 60; i++) {
        device_rig_steps(&r, 1);
        assert_true(r.input.position[0] >= before); /* never back */
        before = r.input.position[0];
        assert_true(r.input.velocity[0] > 0.099 && r.input.velocity[0] < 0.101);
    }
    vbss_device_statistics s = device_rig_statistics(&r);
    assert_true(s.out_of_order[0] > 20 && s.out_of_order[0] < 40);
    assert_int_equal(r.flags, 0);
    assert_int_equal(r.events & VBSS_DEVICE_EVENT_STALE, 0);
    device_rig_end(&r);
}

/* ---- a clock that begins anew */

static double origin;

static void measure_with_origin(void *user, double time, vbss_device_sample *sample)
{
    device_rig_hand(user, time, sample);
    sample->time = time + origin;
}

static void restarted_clock_is_followed_after_delay(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    r.mock_configs[0].measure = measure_with_origin;
    origin = 5000.0;
    device_rig_open(&r, 1);
    device_rig_steps(&r, 20);
    origin = 0.0;
    device_rig_steps(&r, 99);
    assert_int_equal(r.input.status, VBSS_DEVICE_STATUS_STALE);
    assert_true(r.result.force[0] == 0.0);
    device_rig_forget(&r);
    device_rig_steps(&r, 3);
    assert_int_equal(r.input.status, VBSS_DEVICE_STATUS_READY);
    assert_true((r.events & VBSS_DEVICE_EVENT_RESTARTED) != 0);
    vbss_device_statistics s = device_rig_statistics(&r);
    assert_int_equal(s.restarts[0], 1);
    assert_true(s.out_of_order[0] >= 99);
    device_rig_steps(&r, 5);
    expect_near(0.1, r.input.velocity[0], 1e-9); /* nothing looked back */
    expect_near(0.5, r.input.jaw, 1e-12);
    device_rig_end(&r);
}

/* One wrong time in the far future is followed by the same. */
static void single_future_time_does_not_block(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    r.mock_configs[0].measure = measure_with_origin;
    origin = 0.0;
    device_rig_open(&r, 1);
    device_rig_steps(&r, 20);
    origin = 1e6;
    device_rig_steps(&r, 1);
    origin = 0.0;
    device_rig_steps(&r, 120);
    assert_int_equal(r.input.status, VBSS_DEVICE_STATUS_READY);
    device_rig_end(&r);
    /* A shared clock knows better: such a sample is refused. */
    begin(&r);
    r.config.clock = VBSS_DEVICE_CLOCK_SHARED;
    r.mock_configs[0].measure = measure_with_origin;
    device_rig_open(&r, 1);
    device_rig_steps(&r, 20);
    origin = 0.2;
    device_rig_steps(&r, 1);
    origin = 0.0;
    device_rig_steps(&r, 1);
    assert_int_equal(r.input.status, VBSS_DEVICE_STATUS_READY);
    assert_int_equal(device_rig_statistics(&r).out_of_range[0], 1);
    device_rig_end(&r);
}

/* A device that was plugged in again counts from zero: taken at once, and no filter looks back. */
static void reconnected_device_may_restart_clock(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    r.mock_configs[0].measure = measure_with_origin;
    origin = 5000.0;
    device_rig_open(&r, 1);
    device_rig_steps(&r, 20);
    device_rig_fault(&r, 0, VBSS_MOCK_FAULT_DISCONNECT, 10.0, 0.0);
    device_rig_steps(&r, 10);
    origin = 0.0;
    device_rig_steps(&r, 1);
    assert_int_equal(r.input.status, VBSS_DEVICE_STATUS_READY);
    assert_true(r.input.velocity[0] == 0.0);
    expect_near(0.5, r.input.jaw, 1e-12);
    device_rig_steps(&r, 1);
    expect_near(0.1, r.input.velocity[0], 1e-9);
    assert_int_equal(device_rig_statistics(&r).restarts[0], 0);
    device_rig_end(&r);
}

/* Away for a moment only: nothing is stale, and still no filter looks back over the gap. */
static void briefly_lost_device_restarts(void **state)
{
    (void)state;
    for (int restart = 0; restart < 2; restart++) {
        device_rig r;
        begin(&r);
        r.mock_configs[0].measure = measure_with_origin;
        r.output.input_timeout = r.config.jaw_timeout = 10.0;
        r.calibration.jaw_time = 1.0;
        r.calibration.jaw_play = 0.0;
        origin = 5.0;
        device_rig_open(&r, 1);
        device_rig_steps(&r, 20);
        if (restart == 0) {
            device_rig_fault(&r, 0, VBSS_MOCK_FAULT_DISCONNECT, 2.0, 0.0);
            device_rig_steps(&r, 2);
        } else { /* or its clock jumps back, for which the host waits */
            origin = 0.0;
            device_rig_steps(&r, 100);
        }
        device_rig_fault(&r, 0, VBSS_MOCK_FAULT_JUMP, 1000.0, 0.5);
        device_rig_fault(&r, 0, VBSS_MOCK_FAULT_JAW, 1000.0, 0.9);
        device_rig_forget(&r);
        device_rig_steps(&r, 1);
        assert_int_equal(r.input.status, VBSS_DEVICE_STATUS_READY);
        expect_near(0.1 * r.now + 0.495, r.input.position[0], 1e-15);
        assert_true(r.input.velocity[0] == 0.0);
        expect_near(0.9, r.input.jaw, 1e-12);
        assert_int_equal((r.events & VBSS_DEVICE_EVENT_RESTARTED) != 0, restart);
        device_rig_steps(&r, 1);
        expect_near(0.1, r.input.velocity[0], 1e-9);
        device_rig_end(&r);
    }
}

/* The filter of the opening goes by the samples' times: at 250 Hz as at 1 kHz. */
static void handle_filter_uses_handle_times(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    r.calibration.jaw_time = 0.02;
    r.calibration.jaw_play = 0.0;
    device_rig_open(&r, 1);
    device_rig_fault(&r, 0, VBSS_MOCK_FAULT_RATE, 1000.0, 0.004);
    device_rig_steps(&r, 20);
    double last = r.input.time;
    device_rig_fault(&r, 0, VBSS_MOCK_FAULT_JAW, 1000.0, 1.0);
    for (int i = 0; i < 40; i++) {
        device_rig_steps(&r, 1);
        double since = r.input.time - last;
        expect_near(1.0 - 0.5 * vbss_exp(-since / 0.02), r.input.jaw, 1e-9);
    }
    device_rig_end(&r);
}

static void device_waits_for_first_sample(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    r.command.solenoid = 1;
    r.calibration.workspace_low[2] = 0.5; /* where nothing is yet */
    device_rig_open(&r, 1);
    device_rig_fault(&r, 0, VBSS_MOCK_FAULT_READ_FAILS, 20.0, 0.0);
    r.step = 1;
    device_rig_steps(&r, 10);
    assert_int_equal(r.input.status, VBSS_DEVICE_STATUS_WAITING);
    assert_int_equal(r.input.valid, 0);
    expect_near(-1.0, r.input.age, 0.0);
    expect_near(-1.0, r.input.jaw_age, 0.0);
    expect_near(1.0, r.input.orientation[0], 0.0);
    expect_near(1.0, r.input.jaw, 0.0);
    assert_true(r.result.force[0] == 0.0 && r.result.solenoid == 0);
    assert_true((r.flags & VBSS_OUTPUT_FLAG_INPUT_STALE) != 0);
    assert_int_equal(r.events & (VBSS_DEVICE_EVENT_STALE | VBSS_DEVICE_EVENT_FRESH), 0);
    assert_int_equal(device_rig_statistics(&r).pose_stale_reads, 0);
    assert_int_equal(device_rig_statistics(&r).clamped_reads, 0);
    device_rig_steps(&r, 30);
    assert_int_equal(r.input.status, VBSS_DEVICE_STATUS_READY);
    assert_true((r.events & VBSS_DEVICE_EVENT_FRESH) != 0);
    assert_true((r.events & VBSS_DEVICE_EVENT_JAW_FRESH) != 0);
    device_rig_end(&r);
}

int test_clocks(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(falling_rate_is_followed),
        cmocka_unit_test(slow_device_has_longer_timeout),
        cmocka_unit_test(late_sample_is_aged_on_shared_clock),
        cmocka_unit_test(out_of_order_samples_are_rejected),
        cmocka_unit_test(restarted_clock_is_followed_after_delay),
        cmocka_unit_test(single_future_time_does_not_block),
        cmocka_unit_test(reconnected_device_may_restart_clock),
        cmocka_unit_test(briefly_lost_device_restarts),
        cmocka_unit_test(handle_filter_uses_handle_times),
        cmocka_unit_test(device_waits_for_first_sample),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
