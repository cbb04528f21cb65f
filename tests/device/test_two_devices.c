/* Pose from one adapter, jaw and solenoid from another: each with its own signals, outputs, age and faults. */
#include <string.h>

#include "device/rig.h"

/* The handle's electronics: a pose of its own that nobody may take, and a moving raw opening. */
static void measure_handle(void *user, double time, vbss_device_sample *sample)
{
    (void)user;
    sample->valid = VBSS_DEVICE_HAS_POSITION | VBSS_DEVICE_HAS_JAW_RAW | VBSS_DEVICE_HAS_BUTTONS;
    sample->position[0] = 77.0;
    sample->jaw_raw = 2.0 + time;
    sample->buttons = 6;
    sample->time = time - 3e5; /* a clock of its own */
}

static void begin(device_rig *r)
{
    device_rig_begin(r);
    r->mock_configs[1].measure = measure_handle;
    r->calibration.jaw_closed = 2.0;
    r->calibration.jaw_open = 3.0;
    r->calibration.jaw_time = r->calibration.jaw_play = 0.0;
    r->command.force[0] = 0.8;
    r->command.torque[1] = 0.02;
    r->command.solenoid = 1;
}

static void each_signal_comes_from_its_adapter(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    device_rig_open(&r, 2);
    device_rig_steps(&r, 20);
    expect_near(0.1 * r.now - 0.005, r.input.position[0], 1e-15);
    expect_near(r.now, r.input.jaw, 1e-9);
    expect_near(2.0 + r.now, r.input.jaw_raw, 1e-15);
    assert_int_equal(r.input.buttons, 0); /* the first's */
    device_rig_end(&r);
    begin(&r);
    r.config.second_signals |= VBSS_DEVICE_HAS_BUTTONS;
    device_rig_open(&r, 2);
    device_rig_steps(&r, 20);
    assert_int_equal(r.input.buttons, 6);
    vbss_device_statistics s = device_rig_statistics(&r);
    assert_int_equal(s.accepted[0], 20);
    assert_int_equal(s.accepted[1], 20);
    device_rig_end(&r);
}

/* One of the pose brings all of it, one opening the other: no pose is made of two. */
static void grouped_signals_come_from_one_adapter(void **state)
{
    (void)state;
    const uint32_t alone[] = {VBSS_DEVICE_HAS_POSITION, VBSS_DEVICE_HAS_ORIENTATION,
                              VBSS_DEVICE_HAS_VELOCITY, VBSS_DEVICE_HAS_ANGULAR_VELOCITY,
                              VBSS_DEVICE_HAS_JAW_RAW,  VBSS_DEVICE_HAS_JAW};
    for (int i = 0; i < 6; i++) {
        device_rig r;
        begin(&r);
        r.mock_configs[1].measure = NULL; /* gives nothing, but for what is asked of it */
        r.config.second_signals = alone[i];
        device_rig_open(&r, 2);
        device_rig_steps(&r, 5);
        assert_int_equal(r.input.valid & DEVICE_POSE_SIGNALS, i < 4 ? 0 : DEVICE_POSE_SIGNALS);
        assert_int_equal(r.input.valid & VBSS_DEVICE_HAS_JAW_RAW,
                         i < 4 ? VBSS_DEVICE_HAS_JAW_RAW : 0);
        device_rig_end(&r);
    }
}

static void last_row(const device_rig *r, int mock, double row[9])
{
    vbss_view view;
    expect_ok(vbss_mock_get_view(r->mocks[mock], VBSS_MOCK_VIEW_ROWS, &view, sizeof view));
    assert_true(view.count > 0);
    memcpy(row, (const double *)view.data + 9 * (view.count - 1), 9 * sizeof *row);
}

/* The first can all, the second a solenoid: then that is the second's. */
static void each_output_goes_to_its_adapter(void **state)
{
    (void)state;
    double first[9], second[9];
    device_rig r;
    begin(&r);
    device_rig_open(&r, 2);
    device_rig_steps(&r, 20);
    last_row(&r, 0, first);
    last_row(&r, 1, second);
    expect_near(0.8, first[1], 1e-15);
    expect_near(0.02, first[5], 1e-15);
    assert_true(first[7] == 0.0);
    assert_true(second[1] == 0.0 && second[5] == 0.0 && second[7] == 1.0);
    device_rig_end(&r);
    /* A first without force: it is the second's; what nobody has goes nowhere. */
    begin(&r);
    r.capabilities[0].outputs = VBSS_DEVICE_OUT_SOLENOID;
    r.capabilities[1].outputs = VBSS_DEVICE_OUT_FORCE;
    device_rig_open(&r, 2);
    device_rig_steps(&r, 20);
    last_row(&r, 0, first);
    last_row(&r, 1, second);
    assert_true(first[1] == 0.0 && first[7] == 1.0);
    expect_near(0.8, second[1], 1e-15);
    assert_true(second[5] == 0.0 && second[7] == 0.0);
    assert_true(r.result.torque[1] == 0.0);
    device_rig_end(&r);
}

static void each_adapter_has_its_age(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    device_rig_open(&r, 2);
    device_rig_steps(&r, 20);
    device_rig_fault(&r, 1, VBSS_MOCK_FAULT_STALL, 300.0, 0.0);
    device_rig_steps(&r, 100);
    assert_int_equal(r.input.stale, 0);
    assert_int_equal(r.result.solenoid, 1);
    device_rig_steps(&r, 10);
    assert_int_equal(r.input.stale, VBSS_DEVICE_HAS_JAW | VBSS_DEVICE_HAS_JAW_RAW);
    assert_int_equal(r.input.status, VBSS_DEVICE_STATUS_READY);
    assert_int_equal(r.result.solenoid, 0);
    expect_near(0.8, r.result.force[0], 1e-15); /* the arm is as good as ever */
    device_rig_steps(&r, 250);
    assert_int_equal(r.input.stale, 0);
    assert_int_equal(r.result.solenoid, 1);
    device_rig_fault(&r, 0, VBSS_MOCK_FAULT_STALL, 300.0, 0.0);
    device_rig_steps(&r, 20);
    assert_int_equal(r.input.stale & VBSS_DEVICE_HAS_JAW, 0);
    assert_int_equal(r.input.status, VBSS_DEVICE_STATUS_STALE);
    assert_true(r.result.force[0] == 0.0 && r.result.solenoid == 0);
    expect_near(r.now, r.input.jaw, 1e-9); /* the handle goes on */
    vbss_device_statistics s = device_rig_statistics(&r);
    assert_int_equal(s.jaw_stale, 1);
    assert_int_equal(s.pose_stale, 1);
    device_rig_end(&r);
}

static void either_disconnect_stops_both(void **state)
{
    (void)state;
    for (int which = 0; which < 2; which++) {
        device_rig r;
        begin(&r);
        device_rig_open(&r, 2);
        device_rig_steps(&r, 20);
        device_rig_fault(&r, which, VBSS_MOCK_FAULT_DISCONNECT, 5.0, 0.0);
        device_rig_steps(&r, 1);
        double row[9];
        last_row(&r, 1 - which, row); /* the one that is there gets zeros */
        assert_true(row[1] == 0.0 && row[7] == 0.0);
        assert_int_equal((uint32_t)row[8] & VBSS_OUTPUT_FLAG_STOPPED, VBSS_OUTPUT_FLAG_STOPPED);
        assert_int_equal(r.input.status, VBSS_DEVICE_STATUS_LOST);
        vbss_device_statistics s = device_rig_statistics(&r);
        assert_int_equal(s.lost[which], 1);
        assert_int_equal(s.lost[1 - which], 0);
        device_rig_end(&r);
    }
}

/* Lost and not stopped: the handle's solenoid is off, the arm's force is there. */
static void lost_handle_may_leave_arm_force(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    r.config.stop_when_lost = 0;
    device_rig_open(&r, 2);
    device_rig_steps(&r, 20);
    device_rig_fault(&r, 1, VBSS_MOCK_FAULT_DISCONNECT, 50.0, 0.0);
    device_rig_steps(&r, 20);
    expect_near(0.8, r.result.force[0], 1e-15);
    assert_int_equal(r.result.solenoid, 0);
    assert_int_equal(r.input.status, VBSS_DEVICE_STATUS_LOST);
    device_rig_end(&r);
}

/* Each timeout waits for the adapter that its signal comes from. */
static void each_adapter_has_its_timeout(void **state)
{
    (void)state;
    for (int swapped = 0; swapped < 2; swapped++) {
        device_rig r;
        begin(&r);
        r.capabilities[swapped].update_rate = 50.0;
        r.capabilities[1 - swapped].update_rate = 5.0;
        if (swapped == 1) {
            r.config.second_signals = VBSS_DEVICE_HAS_VELOCITY;
        }
        device_rig_open(&r, 2);
        const device_object *d = device_rig_object(&r);
        expect_near(0.05, d->limits.input_timeout, 1e-15);
        expect_near(0.5, d->jaw_timeout, 1e-15);
        device_rig_end(&r);
    }
}

static void combined_capabilities_are_union_of_used_signals(void **state)
{
    (void)state;
    device_rig r;
    vbss_device_capabilities all;
    begin(&r);
    r.capabilities[0].signals = VBSS_DEVICE_HAS_POSITION | VBSS_DEVICE_HAS_JAW;
    r.capabilities[1].signals = VBSS_DEVICE_HAS_JAW_RAW | VBSS_DEVICE_HAS_POSITION;
    r.capabilities[0].outputs = VBSS_DEVICE_OUT_FORCE;
    r.capabilities[1].outputs = VBSS_DEVICE_OUT_FORCE | VBSS_DEVICE_OUT_TORQUE;
    r.capabilities[0].max_damping = 9.0;
    r.capabilities[0].max_stiffness = 900.0;
    r.capabilities[1].max_torque = 0.05;
    r.capabilities[1].max_continuous_torque = 0.01;
    r.output.max_force = 2.5;
    r.output.continuous_force = 0.7;
    device_rig_open(&r, 2);
    expect_ok(vbss_device_get_capabilities(r.device, 2, &all, sizeof all));
    assert_int_equal(all.signals, VBSS_DEVICE_HAS_POSITION | VBSS_DEVICE_HAS_JAW_RAW);
    assert_int_equal(all.outputs, VBSS_DEVICE_OUT_FORCE | VBSS_DEVICE_OUT_TORQUE);
    expect_near(2.5, all.max_force, 0.0);
    expect_near(0.7, all.max_continuous_force, 0.0);
    expect_near(0.05, all.max_torque, 0.0);
    expect_near(0.01, all.max_continuous_torque, 0.0);
    expect_near(400.0, all.max_stiffness, 0.0);
    expect_near(4.0, all.max_damping, 0.0);
    device_rig_end(&r);
}

/* The force is the second's: so are its limits. */
static void limits_are_of_output_adapter(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    r.capabilities[0].outputs = 0;
    r.capabilities[0].max_force = 0.2;
    r.capabilities[1].outputs = VBSS_DEVICE_OUT_FORCE;
    r.capabilities[1].max_force = 0.6;
    device_rig_open(&r, 2);
    device_rig_steps(&r, 20);
    expect_near(0.6, r.result.force[0], 1e-15);
    device_rig_end(&r);
}

static void common_limit_is_minimum(void **state)
{
    (void)state;
    device_rig r;
    vbss_device_capabilities all;
    begin(&r);
    r.capabilities[0].max_force = 1.5;
    r.capabilities[0].max_continuous_force = 0.4;
    r.capabilities[0].max_stiffness = 350.0;
    r.capabilities[1].max_force = 0.1; /* puts out no forces */
    r.command.force[0] = 2.9;
    device_rig_open(&r, 2);
    expect_ok(vbss_device_get_capabilities(r.device, 2, &all, sizeof all));
    expect_near(1.5, all.max_force, 0.0);
    expect_near(0.4, all.max_continuous_force, 0.0);
    expect_near(0.1, all.max_torque, 0.0); /* not known: as configured */
    expect_near(350.0, all.max_stiffness, 0.0);
    expect_near(4.0, all.max_damping, 0.0);
    assert_int_equal(all.outputs, DEVICE_OUTPUTS);
    assert_int_equal(all.signals, DEVICE_SIGNALS);
    device_rig_steps(&r, 20);
    expect_near(1.5, r.result.force[0], 1e-15);
    expect_ok(vbss_device_get_capabilities(r.device, 1, &all, sizeof all));
    expect_near(0.1, all.max_force, 0.0);
    device_rig_end(&r);
}

/* An adapter that only puts out. */
static void second_adapter_needs_no_signals(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    device_rig_open(&r, 2);
    expect_ok(vbss_device_destroy(r.device));
    r.adapters[1].read = NULL;
    r.config.second_signals = 0;
    expect_ok(vbss_device_create(r.context, &r.adapters[0], &r.adapters[1], &r.config, &r.device));
    device_rig_steps(&r, 20);
    assert_int_equal(r.input.status, VBSS_DEVICE_STATUS_READY);
    assert_int_equal(r.result.solenoid, 1);
    double row[9];
    last_row(&r, 1, row);
    assert_true(row[7] == 1.0);
    device_rig_end(&r);
}

int test_two_devices(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_signal_comes_from_its_adapter),
        cmocka_unit_test(grouped_signals_come_from_one_adapter),
        cmocka_unit_test(each_output_goes_to_its_adapter),
        cmocka_unit_test(each_adapter_has_its_age),
        cmocka_unit_test(either_disconnect_stops_both),
        cmocka_unit_test(lost_handle_may_leave_arm_force),
        cmocka_unit_test(each_adapter_has_its_timeout),
        cmocka_unit_test(combined_capabilities_are_union_of_used_signals),
        cmocka_unit_test(limits_are_of_output_adapter),
        cmocka_unit_test(common_limit_is_minimum),
        cmocka_unit_test(second_adapter_needs_no_signals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
