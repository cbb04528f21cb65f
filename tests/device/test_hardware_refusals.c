/* Real hardware that is not there, names that are wrong, settings that are refused, handles, memory. */
#include <string.h>

#include "base/error.h"
#include "device/hardware_rig.h"

static void expect_no_arms(hardware_rig *r, vbss_result wanted, const char *text)
{
    vbss_openhaptics *none = (vbss_openhaptics *)r;
    expect_result(wanted, vbss_openhaptics_create(r->context, &r->arms, &none));
    assert_null(none);
    hardware_rig_expect_text(r, text);
}

static void expect_no_lines(hardware_rig *r, vbss_result wanted, const char *text)
{
    vbss_nidaqmx *none = (vbss_nidaqmx *)r;
    expect_result(wanted, vbss_nidaqmx_create(r->context, &r->lines, &none));
    assert_null(none);
    hardware_rig_expect_text(r, text);
}

static void missing_library_is_named(void **state)
{
    (void)state;
    hardware_rig r;
    char text[16];
    hardware_rig_begin(&r, false);
    r.arms.library = "/nowhere/libHD.so";
    r.lines.library = "/nowhere/libnidaqmx.so.1";
    expect_no_arms(&r, VBSS_ERROR_DEVICE, "no library /nowhere/libHD.so");
    expect_no_lines(&r, VBSS_ERROR_DEVICE, "no library /nowhere/libnidaqmx.so.1");
    expect_result(VBSS_ERROR_DEVICE,
                  vbss_nidaqmx_list_devices(r.context, "/nowhere/lib.so", text, sizeof text));
    hardware_rig_end(&r);
}

static void library_with_missing_symbol_is_rejected_by_name(void **state)
{
    (void)state;
    hardware_rig r;
    hardware_rig_begin(&r, false);
    r.arms.library = VBSS_STAND_IN_NIDAQMX;
    r.lines.library = VBSS_STAND_IN_OPENHAPTICS;
    expect_no_arms(&r, VBSS_ERROR_DEVICE, "has no hdInitDevice");
    expect_no_lines(&r, VBSS_ERROR_DEVICE, "has no DAQmxCreateTask");
    hardware_rig_end(&r);
}

static void unknown_names_are_rejected(void **state)
{
    (void)state;
    hardware_rig r;
    hardware_rig_begin(&r, false);
    r.arms.second_name = "Device9";
    expect_no_arms(&r, VBSS_ERROR_DEVICE, "device 'Device9': no such device (0x0104");
    r.lines.second_input = "Dev1/ai8";
    expect_no_lines(&r, VBSS_ERROR_DEVICE, "Dev1/ai8: no such channel (-200170)");
    r.lines.second_input = "Dev7/ai1";
    expect_no_lines(&r, VBSS_ERROR_DEVICE, "Dev7/ai1: no such device (-200220)");
    r.lines.second_input = "Dev1/ai1";
    r.lines.first_line = "Dev1/port9/line0";
    expect_no_lines(&r, VBSS_ERROR_DEVICE, "Dev1/port9/line0,Dev1/port0/line1: no such channel");
    r.lines.first_line = "";
    expect_no_lines(&r, VBSS_ERROR_OUT_OF_RANGE, "name of a line");
    r.lines.first_line = NULL; /* a handle without a solenoid */
    r.lines.first_input = NULL;
    expect_no_lines(&r, VBSS_ERROR_NULL_ARGUMENT, "name of an input");
    hardware_rig_end(&r);
}

static void failed_start_closes_hardware(void **state)
{
    (void)state;
    hardware_rig r;
    hardware_rig_begin(&r, false);
    r.hd->set_fault(0, STAND_IN_NO_LICENCE, 1);
    expect_no_arms(&r, VBSS_ERROR_DEVICE, "begin of the servo: no valid licence (0x0600");
    r.hd->set_fault(0, STAND_IN_NO_LICENCE, 0);
    r.hd->set_fault(1, STAND_IN_UNPLUGGED, 1);
    expect_no_arms(&r, VBSS_ERROR_DEVICE, "device 'Device2': communication failed (0x0302");
    r.daq->set_fault(STAND_IN_RESERVED, 1);
    expect_no_lines(&r, VBSS_ERROR_DEVICE, "in use by another program (-50103)");
    r.daq->set_fault(STAND_IN_RESERVED, 0);
    r.daq->set_fault(STAND_IN_REMOVED, 1);
    expect_no_lines(&r, VBSS_ERROR_DEVICE, "no such device (-200220)");
    r.daq->set_fault(STAND_IN_REMOVED, 0);
    r.daq->set_fault(STAND_IN_WRITE_TIMEOUT, 1);
    expect_no_lines(&r, VBSS_ERROR_DEVICE, "timeout (-200221)");
    hardware_rig_end(&r);
}

static void out_of_range_settings_are_named(void **state)
{
    (void)state;
    hardware_rig r;
    vbss_output_config output;
    hardware_rig_begin(&r, false);
    expect_ok(vbss_output_config_init(&output, sizeof output));
    r.arms.device_count = 3;
    expect_no_arms(&r, VBSS_ERROR_OUT_OF_RANGE, "device_count");
    r.arms.device_count = 1;
    r.arms.rate = 99;
    expect_no_arms(&r, VBSS_ERROR_OUT_OF_RANGE, "rate");
    r.arms.rate = 1000;
    output.max_force = -1.0;
    r.arms.output = &output;
    expect_no_arms(&r, VBSS_ERROR_OUT_OF_RANGE, "max_force");
    r.lines.handle_count = 0;
    expect_no_lines(&r, VBSS_ERROR_OUT_OF_RANGE, "handle_count");
    r.lines.handle_count = 2;
    r.lines.high = r.lines.low;
    expect_no_lines(&r, VBSS_ERROR_OUT_OF_RANGE, "high");
    r.lines.high = 10.0;
    r.lines.timeout = harness_bad_numbers[0];
    expect_no_lines(&r, VBSS_ERROR_NOT_FINITE, "timeout");
    hardware_rig_end(&r);
}

static void pump_requires_lines_without_thread(void **state)
{
    (void)state;
    hardware_rig r;
    hardware_rig_begin(&r, false);
    expect_ok(vbss_nidaqmx_create(r.context, &r.lines, &r.nidaqmx));
    expect_result(VBSS_ERROR_NOT_FINITE, vbss_nidaqmx_poll(r.nidaqmx, harness_bad_numbers[0]));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_nidaqmx_poll(r.nidaqmx, 2e9));
    expect_ok(vbss_nidaqmx_destroy(r.nidaqmx));
    r.lines.own_thread = 1;
    expect_ok(vbss_nidaqmx_create(r.context, &r.lines, &r.nidaqmx));
    expect_result(VBSS_ERROR_WRONG_STATE, vbss_nidaqmx_poll(r.nidaqmx, 1.0));
    hardware_rig_end(&r);
}

/* ---- sizes, handles, memory */

static vbss_result arms_init(void *config, uint32_t struct_size)
{
    vbss_openhaptics_config *c = config;
    VBSS_TRY(vbss_openhaptics_config_init(config, struct_size));
    c->library = VBSS_STAND_IN_OPENHAPTICS;
    return VBSS_OK;
}

static vbss_result use_arms(vbss_context *context, const void *config)
{
    vbss_openhaptics *arms;
    VBSS_TRY(vbss_openhaptics_create(context, config, &arms));
    return vbss_openhaptics_destroy(arms);
}

static vbss_result lines_init(void *config, uint32_t struct_size)
{
    vbss_nidaqmx_config *c = config;
    VBSS_TRY(vbss_nidaqmx_config_init(config, struct_size));
    c->library = VBSS_STAND_IN_NIDAQMX;
    c->own_thread = 0;
    return VBSS_OK;
}

static vbss_result use_lines(vbss_context *context, const void *config)
{
    vbss_nidaqmx *lines;
    VBSS_TRY(vbss_nidaqmx_create(context, config, &lines));
    return vbss_nidaqmx_destroy(lines);
}

static void size_protocol(void **state)
{
    (void)state;
    static const uint32_t sizes[][2] = {{16 + 6 * sizeof(void *), 0}, {56 + 5 * sizeof(void *), 0}};
    const harness_config all[] = {{sizes[0], arms_init, use_arms},
                                  {sizes[1], lines_init, use_lines}};
    hardware_rig r;
    hardware_rig_begin(&r, false);
    harness_config_protocol(&all[0]);
    harness_config_protocol(&all[1]);
    hardware_rig_end(&r);
}

static vbss_result call_arm_adapter(void *arms)
{
    vbss_device_adapter adapter;
    VBSS_TRY(vbss_device_adapter_init(&adapter, sizeof adapter));
    return vbss_openhaptics_get_adapter(arms, 0, &adapter);
}

static vbss_result call_arm_status(void *arms)
{
    vbss_openhaptics_status status;
    return vbss_openhaptics_get_status(arms, 0, &status, sizeof status);
}

static vbss_result call_identity(void *arms)
{
    return vbss_openhaptics_get_identity(arms, 0, NULL, NULL);
}

static vbss_result call_handle_adapter(void *lines)
{
    vbss_device_adapter adapter;
    VBSS_TRY(vbss_device_adapter_init(&adapter, sizeof adapter));
    return vbss_nidaqmx_get_adapter(lines, 0, &adapter);
}

static vbss_result call_pump(void *lines)
{
    return vbss_nidaqmx_poll(lines, 0.0);
}

static vbss_result call_lines_status(void *lines)
{
    vbss_nidaqmx_status status;
    return vbss_nidaqmx_get_status(lines, &status, sizeof status);
}

static void every_call_rejects_invalid_handles(void **state)
{
    (void)state;
    const harness_handle_call arms[] = {call_arm_adapter, call_arm_status, call_identity};
    const harness_handle_call lines[] = {call_handle_adapter, call_pump, call_lines_status};
    hardware_rig r;
    vbss_device_adapter adapter;
    hardware_rig_begin(&r, false);
    hardware_rig_open(&r, 0);
    expect_ok(vbss_device_adapter_init(&adapter, sizeof adapter));
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_openhaptics_get_adapter(r.openhaptics, 2, &adapter));
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_nidaqmx_get_adapter(r.nidaqmx, 2, &adapter));
    vbss_openhaptics *no_arms = r.openhaptics;
    vbss_nidaqmx *no_lines = r.nidaqmx;
    expect_ok(vbss_openhaptics_destroy(no_arms));
    expect_ok(vbss_nidaqmx_destroy(no_lines));
    r.openhaptics = NULL;
    r.nidaqmx = NULL;
    harness_refuses_bad_handles(r.context, no_arms, arms, 3);
    harness_refuses_bad_handles(r.context, no_lines, lines, 3);
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_openhaptics_destroy(no_arms));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_nidaqmx_destroy(no_lines));
    hardware_rig_end(&r);
}

static vbss_result live(vbss_context *context, void *user)
{
    const hardware_rig *r = user;
    VBSS_TRY(use_arms(context, &r->arms));
    return use_lines(context, &r->lines);
}

static void each_failed_allocation_is_reported_and_closes_hardware(void **state)
{
    (void)state;
    hardware_rig r;
    hardware_rig_begin(&r, false);
    harness_fail_every_allocation(live, &r);
    hardware_rig_end(&r);
}

static void context_end_closes_hardware(void **state)
{
    (void)state;
    hardware_rig r;
    const char *first;
    hardware_rig_begin(&r, false);
    hardware_rig_open(&r, 2);
    r.commands[0].force[0] = 1.0;
    hardware_rig_steps(&r, 20);
    harness_context_end(r.context, &r.memory);
    assert_true(hardware_rig_force(&r, 0) == 0.0);
    assert_int_equal(r.hd->illegal(&first) + r.daq->illegal(&first), 0);
}

int test_hardware_refusals(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(missing_library_is_named),
        cmocka_unit_test(library_with_missing_symbol_is_rejected_by_name),
        cmocka_unit_test(unknown_names_are_rejected),
        cmocka_unit_test(failed_start_closes_hardware),
        cmocka_unit_test(out_of_range_settings_are_named),
        cmocka_unit_test(pump_requires_lines_without_thread),
        cmocka_unit_test(size_protocol),
        cmocka_unit_test(every_call_rejects_invalid_handles),
        cmocka_unit_test(each_failed_allocation_is_reported_and_closes_hardware),
        cmocka_unit_test(context_end_closes_hardware),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
