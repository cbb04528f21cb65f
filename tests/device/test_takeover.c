/* Jaws that do not jump: a handle takes them over when it has passed where they are. */
#include "device/rig.h"

static void begin(device_rig *r)
{
    device_rig_begin(r);
    r->config.jaw_takeover = 1;
    r->calibration.jaw_play = 0.0;
    r->calibration.jaw_time = 0.0;
    device_rig_open(r, 1);
    device_rig_steps(r, 5);
    assert_true(fabs(r->input.jaw - 0.5) < 1e-12 && r->input.jaw_held == 0);
}

/* The handle is at `raw` from now on. */
static void squeeze(device_rig *r, double raw)
{
    device_rig_fault(r, 0, VBSS_MOCK_FAULT_JAW, 2.5, raw);
    device_rig_forget(r);
    device_rig_steps(r, 2);
}

/* Closed jaws stay closed while the handle is open, and until it was closed. */
static void expect_takeover(device_rig *r)
{
    assert_true((r->events & VBSS_DEVICE_EVENT_JAW_HELD) != 0);
    for (int i = 0; i < 8; i++) {
        squeeze(r, 1.0 - 0.1 * i);
        assert_true(fabs(r->input.jaw - 0.1) < 1e-12 && r->input.jaw_held == 1);
        assert_int_equal(r->events & (VBSS_DEVICE_EVENT_JAW_HELD | VBSS_DEVICE_EVENT_JAW_TAKEN), 0);
    }
    squeeze(r, 0.05); /* past them */
    assert_true((r->events & VBSS_DEVICE_EVENT_JAW_TAKEN) != 0);
    assert_true(fabs(r->input.jaw - 0.05) < 1e-12 && r->input.jaw_held == 0);
    squeeze(r, 1.0);
    assert_true(r->input.jaw == 1.0);
}

static void host_holds_jaws(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    expect_ok(vbss_device_hold_jaw(r.device, 0.1));
    device_rig_forget(&r);
    device_rig_steps(&r, 1);
    expect_takeover(&r);
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_device_hold_jaw(r.device, 1.1));
    expect_result(VBSS_ERROR_NOT_FINITE, vbss_device_hold_jaw(r.device, harness_bad_numbers[0]));
    device_rig_end(&r);
}

static void clutch_holds_jaws(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    device_rig_fault(&r, 0, VBSS_MOCK_FAULT_JAW, 3.5, 0.1);
    device_rig_steps(&r, 3);
    expect_ok(vbss_device_set_clutch(r.device, 1));
    squeeze(&r, 0.0); /* with the clutch held the handle takes nothing over */
    squeeze(&r, 1.0);
    assert_true(fabs(r.input.jaw - 0.1) < 1e-12 && r.input.jaw_held == 1);
    expect_ok(vbss_device_set_clutch(r.device, 0));
    device_rig_steps(&r, 1);
    r.events = VBSS_DEVICE_EVENT_JAW_HELD;
    expect_takeover(&r);
    device_rig_end(&r);
}

static void restored_jaws_stay(void **state)
{
    (void)state;
    static uint8_t bytes[8192];
    uint64_t size;
    device_rig r;
    begin(&r);
    expect_ok(vbss_device_hold_jaw(r.device, 0.1));
    device_rig_fault(&r, 0, VBSS_MOCK_FAULT_JAW, 3.5, 0.1);
    device_rig_steps(&r, 3);
    assert_true(r.input.jaw_held == 0 && fabs(r.input.jaw - 0.1) < 1e-12);
    expect_ok(vbss_device_save(r.device, bytes, sizeof bytes, &size));
    squeeze(&r, 1.0);
    assert_true(r.input.jaw == 1.0);
    expect_ok(vbss_device_restore(r.device, bytes, size));
    device_rig_forget(&r);
    device_rig_steps(&r, 1);
    assert_true(r.input.jaw_held == 1);
    assert_true(fabs(r.input.jaw - 0.1) < 1e-12);
    device_rig_end(&r);
}

/* Without the option everything is as it was. */
static void option_is_off_by_default(void **state)
{
    (void)state;
    device_rig r;
    device_rig_begin(&r);
    device_rig_open(&r, 1);
    device_rig_steps(&r, 5);
    expect_result(VBSS_ERROR_INCOMPATIBLE, vbss_device_hold_jaw(r.device, 0.1));
    expect_ok(vbss_device_set_clutch(r.device, 1));
    device_rig_fault(&r, 0, VBSS_MOCK_FAULT_JAW, 1000.0, 1.0);
    device_rig_steps(&r, 200);
    assert_true(r.input.jaw > 0.99 && r.input.jaw_held == 0);
    device_rig_end(&r);
}

int test_takeover(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(host_holds_jaws),
        cmocka_unit_test(clutch_holds_jaws),
        cmocka_unit_test(restored_jaws_stay),
        cmocka_unit_test(option_is_off_by_default),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
