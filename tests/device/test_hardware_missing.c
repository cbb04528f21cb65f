/* Drivers that are missing, incomplete or of another kind: texts that say what to do, and NI-DAQmx Base. */
#include <string.h>

#include "device/hardware_rig.h"
#include "fixtures/stand_in_worlds.h"

static void expect_no_arms(hardware_rig *r, const char *text)
{
    vbss_openhaptics *none;
    expect_result(VBSS_ERROR_DEVICE, vbss_openhaptics_create(r->context, &r->arms, &none));
    hardware_rig_expect_text(r, text);
}

static void expect_no_lines(hardware_rig *r, const char *text)
{
    vbss_nidaqmx *none;
    expect_result(VBSS_ERROR_DEVICE, vbss_nidaqmx_create(r->context, &r->lines, &none));
    hardware_rig_expect_text(r, text);
}

#ifdef VBSS_STAND_IN_INCOMPLETE
/* Linux only: elsewhere the loader does not say which part. */
static void missing_part_of_driver_is_named(void **state)
{
    (void)state;
    hardware_rig r;
    hardware_rig_begin(&r, false);
    r.arms.library = r.lines.library = VBSS_STAND_IN_INCOMPLETE;
    expect_no_arms(&r, "needs libPhantomIOLib42.so, which is missing");
    expect_no_lines(&r, "needs libPhantomIOLib42.so, which is missing");
    hardware_rig_end(&r);
}
#endif

#ifdef __linux__
/* No machine that builds this has the vendors' libraries; where one has, the test says nothing. */
static void usual_names_are_tried(void **state)
{
    (void)state;
    hardware_rig r;
    hardware_rig_begin(&r, false);
    r.arms.library = r.lines.library = NULL;
    vbss_nidaqmx *lines = NULL;
    vbss_openhaptics *arms = NULL;
    if (vbss_nidaqmx_create(r.context, &r.lines, &lines) != VBSS_OK) {
        hardware_rig_expect_text(&r, "NI-DAQmx");
        hardware_rig_expect_text(&r, "USB-6008");
        hardware_rig_expect_text(&r, "libnidaqmxbase.so");
    }
    if (vbss_openhaptics_create(r.context, &r.arms, &arms) != VBSS_OK) {
        hardware_rig_expect_text(&r, "libHD.so");
    }
    expect_ok(vbss_nidaqmx_destroy(lines));
    expect_ok(vbss_openhaptics_destroy(arms));
    hardware_rig_end(&r);
}
#endif

static void driver_without_devices_says_so(void **state)
{
    (void)state;
    hardware_rig r;
    char text[64];
    hardware_rig_begin(&r, false);
    r.daq->set_fault(STAND_IN_UNKNOWN, 1);
    expect_no_lines(&r, "no such device (-200220)");
#ifdef __linux__
    hardware_rig_expect_text(&r, "NI-DAQmx for Linux has no USB-6008");
    hardware_rig_expect_text(&r, "install NI-DAQmx Base");
#endif
    expect_result(VBSS_ERROR_DEVICE,
                  vbss_nidaqmx_list_devices(r.context, VBSS_STAND_IN_NIDAQMX, text, sizeof text));
    hardware_rig_expect_text(&r, "the driver knows no device");
    hardware_rig_end(&r);
}

static void default_arm_may_have_a_name(void **state)
{
    (void)state;
    hardware_rig r;
    hardware_rig_begin(&r, false);
    r.arms.device_count = 1;
    r.hd->set_fault(0, STAND_IN_NO_DEFAULT, 1);
    expect_ok(vbss_openhaptics_create(r.context, &r.arms, &r.openhaptics));
    expect_ok(vbss_openhaptics_destroy(r.openhaptics));
    r.openhaptics = NULL;
    r.hd->set_fault(0, STAND_IN_NO_DEFAULT, 0);
    r.hd->set_fault(0, STAND_IN_UNPLUGGED, 1);
    expect_no_arms(&r, "nor 'Default Device', 'Default PHANToM'");
    hardware_rig_expect_text(&r, "communication failed (0x0302");
    hardware_rig_end(&r);
}

/* ---- NI-DAQmx Base: the names of a USB-6008 on Linux */

static void begin_base(hardware_rig *r)
{
    hardware_rig_begin(r, false);
    r->daq = stand_in_lines_of(VBSS_STAND_IN_NIDAQMXBASE);
    assert_non_null(r->daq);
    r->daq->reset();
    r->lines.library = VBSS_STAND_IN_NIDAQMXBASE;
    r->daq->set_volts(0, 0.5);
}

static void base_library_works(void **state)
{
    (void)state;
    hardware_rig r;
    begin_base(&r);
    r.lines.second_line = "Dev1/port0/line5";
    hardware_rig_open(&r, 2);
    r.commands[1].solenoid = 1;
    hardware_rig_steps(&r, 20);
    assert_true(fabs(r.inputs[0].jaw_raw - 0.5) < 0.01);
    for (int line = 0; line < STAND_IN_LINES; line++) {
        assert_int_equal(r.daq->level(line), line == 5 ? 0 : 1);
    }
    r.commands[1].solenoid = 0;
    r.commands[0].solenoid = 1;
    hardware_rig_steps(&r, 20);
    for (int line = 0; line < STAND_IN_LINES; line++) {
        assert_int_equal(r.daq->level(line), line == 0 ? 0 : 1);
    }
    hardware_rig_end(&r);
    stand_in_lines_of(VBSS_STAND_IN_NIDAQMXBASE)->reset();
}

static void base_library_needs_one_port(void **state)
{
    (void)state;
    hardware_rig r;
    char text[64];
    const char *const wrong[] = {"Dev1/port1/line1", "Dev1/port0/line8", "Dev1/port0", "line"};
    begin_base(&r);
    for (int i = 0; i < 4; i++) {
        r.lines.second_line = wrong[i];
        expect_no_lines(&r, "are not lines 0 to 7 of one port");
    }
    expect_result(VBSS_ERROR_DEVICE, vbss_nidaqmx_list_devices(r.context, VBSS_STAND_IN_NIDAQMXBASE,
                                                               text, sizeof text));
    hardware_rig_expect_text(&r, "lsdaq");
    hardware_rig_end(&r);
}

int test_hardware_missing(void)
{
    const struct CMUnitTest tests[] = {
#ifdef VBSS_STAND_IN_INCOMPLETE
        cmocka_unit_test(missing_part_of_driver_is_named),
#endif
#ifdef __linux__
        cmocka_unit_test(usual_names_are_tried),
#endif
        cmocka_unit_test(driver_without_devices_says_so),
        cmocka_unit_test(default_arm_may_have_a_name),
        cmocka_unit_test(base_library_works),
        cmocka_unit_test(base_library_needs_one_port),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
