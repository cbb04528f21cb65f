/* What a command says, and how long it counts. */
#include "device/rig.h"

/* A command's fault and temperature hold as long as the command; the age of the pose is the device's own. */
static void command_persists_until_next(void **state)
{
    (void)state;
    device_rig r;
    device_rig_begin(&r);
    r.output.command_timeout = 1.0;
    device_rig_open(&r, 1);
    r.command.force[0] = 0.8;
    r.command.input_age = 0.004;
    device_rig_steps(&r, 20);
    for (int i = 0; i < 20; i++) {
        device_rig_read(&r);
        device_rig_write(&r, NULL);
        assert_int_equal(r.result.flags, 0);
        expect_near(0.8, r.result.force[0], 1e-15);
    }
    r.command.temperature = 0.97;
    device_rig_steps(&r, 1);
    device_rig_read(&r);
    device_rig_write(&r, NULL);
    assert_int_equal(r.result.flags, VBSS_OUTPUT_FLAG_WARM);
    r.command.fault = 1;
    device_rig_steps(&r, 1);
    device_rig_read(&r);
    device_rig_write(&r, NULL);
    assert_true((r.result.flags & VBSS_OUTPUT_FLAG_FAULT) != 0);
    /* A fault of the device is over when the device says so. */
    r.command.fault = 0;
    r.command.temperature = 0.0;
    device_rig_fault(&r, 0, VBSS_MOCK_FAULT_REFUSAL, 5.0, 0.0);
    device_rig_steps(&r, 3);
    for (int i = 0; i < 20; i++) {
        device_rig_read(&r);
        device_rig_write(&r, NULL);
    }
    expect_near(0.8, r.result.force[0], 1e-15);
    device_rig_end(&r);
}

static void non_finite_command_sets_flag(void **state)
{
    (void)state;
    device_rig r;
    device_rig_begin(&r);
    device_rig_open(&r, 1);
    r.command.force[0] = 0.4;
    device_rig_steps(&r, 20);
    for (int i = 0; i < 3; i++) {
        vbss_output_command bad = r.command;
        bad.force[1] = harness_bad_numbers[i];
        device_rig_read(&r);
        device_rig_write(&r, &bad);
        assert_int_equal(r.result.flags, VBSS_OUTPUT_FLAG_NOT_FINITE);
        assert_true(r.result.force[0] == 0.0);
        device_rig_steps(&r, 1);
        expect_near(0.4, r.result.force[0], 1e-15);
    }
    vbss_output_command bad = r.command;
    bad.input_age = bad.age = harness_bad_numbers[0];
    device_rig_read(&r);
    device_rig_write(&r, &bad);
    assert_true((r.result.flags & VBSS_OUTPUT_FLAG_NOT_FINITE) != 0);
    assert_int_equal(device_rig_output_statistics(&r).not_finite, 4);
    device_rig_end(&r);
}

/* The host may know better how old a pose is, or how warm a motor. */
static void worse_of_command_and_device_counts(void **state)
{
    (void)state;
    device_rig r;
    device_rig_begin(&r);
    device_rig_open(&r, 1);
    r.command.force[0] = 0.8;
    r.command.input_age = 1e-9;
    device_rig_steps(&r, 20);
    assert_int_equal(r.result.flags, 0);
    r.command.input_age = 0.0075;
    device_rig_steps(&r, 1);
    expect_near(0.4, r.result.force[0], 1e-12);
    r.command.input_age = 0.0;
    r.command.temperature = 0.97;
    device_rig_steps(&r, 1);
    expect_near(0.3, r.result.force[0], 1e-12);
    r.command.temperature = 0.0;
    r.command.age = 0.0075;
    device_rig_steps(&r, 1);
    expect_near(0.15, r.result.force[0], 1e-12);
    device_rig_end(&r);
}

/* Between writes the pose goes on to grow old. */
static void pose_ages_between_read_and_write(void **state)
{
    (void)state;
    device_rig r;
    device_rig_begin(&r);
    device_rig_open(&r, 1);
    r.command.force[0] = 0.8;
    device_rig_steps(&r, 20);
    expect_ok(vbss_device_write(r.device, r.now + 0.0075, &r.command, &r.result, sizeof r.result));
    assert_int_equal(r.result.flags, VBSS_OUTPUT_FLAG_INPUT_STALE | VBSS_OUTPUT_FLAG_LATE);
    expect_near(0.4, r.result.force[0], 1e-12);
    expect_ok(vbss_device_write(r.device, r.now + 0.0085, NULL, &r.result, sizeof r.result));
    expect_near(0.24, r.result.force[0], 1e-12);
    device_rig_end(&r);
}

int test_commands(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(command_persists_until_next),
        cmocka_unit_test(non_finite_command_sets_flag),
        cmocka_unit_test(worse_of_command_and_device_counts),
        cmocka_unit_test(pose_ages_between_read_and_write),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
