/* Handles and solenoids through the vendor's interface. */
#include <string.h>

#include "device/hardware_rig.h"

static void potentiometers_are_read_in_volts(void **state)
{
    (void)state;
    hardware_rig r;
    hardware_rig_begin(&r, false);
    hardware_rig_open(&r, 2);
    r.daq->set_volts(0, 1.25);
    r.daq->set_volts(1, 0.3);
    hardware_rig_steps(&r, 10);
    const double step = 20.0 / 2048.0; /* 11 bits, single-ended */
    assert_true(fabs(r.inputs[0].jaw_raw - 1.25) <= 0.5 * step);
    assert_true(fabs(r.inputs[1].jaw_raw - 0.3) <= 0.5 * step);
    hardware_rig_end(&r);
}

/* Pulses of a script, one a handle, against what the lines do: late by a round at most, and of their length. */
static void solenoid_pulses_match_script(void **state)
{
    (void)state;
    hardware_rig r;
    hardware_rig_begin(&r, false);
    hardware_rig_open(&r, 2);
    hardware_rig_steps(&r, 20);
    bool wanted[2][6] = {{false}}; /* what the script said, up to 5 ms ago */
    int on[2] = {0, 0}, scripted[2] = {0, 0}, edges[2] = {0, 0};
    for (int k = 0; k < 1200; k++) {
        for (int i = 0; i < 2; i++) {
            bool now = (k % (200 + 100 * i)) < 40 + 4 * i && k < 1000;
            memmove(wanted[i] + 1, wanted[i], sizeof wanted[i] - sizeof wanted[i][0]);
            wanted[i][0] = now;
            r.commands[i].solenoid = now;
            scripted[i] += now;
        }
        bool was[2] = {hardware_rig_solenoid(&r, 0), hardware_rig_solenoid(&r, 1)};
        hardware_rig_steps(&r, 1);
        for (int i = 0; i < 2; i++) {
            bool is = hardware_rig_solenoid(&r, i);
            on[i] += is;
            edges[i] += is != was[i];
            assert_true(is == wanted[i][1] || is == wanted[i][2]);
        }
    }
    assert_int_equal(on[0], scripted[0]);
    assert_int_equal(on[1], scripted[1]);
    assert_int_equal(edges[0], 2 * 5);
    assert_int_equal(edges[1], 2 * 4);
    hardware_rig_end(&r);
}

static void silent_host_turns_solenoid_off(void **state)
{
    (void)state;
    for (int i = 0; i < 2; i++) {
        hardware_rig r;
        vbss_nidaqmx_status status;
        hardware_rig_begin(&r, false);
        r.lines.active_low = i == 0;
        hardware_rig_open(&r, 1);
        r.commands[0].solenoid = 1;
        hardware_rig_steps(&r, 30);
        assert_true(hardware_rig_solenoid(&r, 0));
        r.silent = true;
        hardware_rig_steps(&r, 10);
        assert_false(hardware_rig_solenoid(&r, 0));
        expect_ok(vbss_nidaqmx_get_status(r.nidaqmx, &status, sizeof status));
        assert_true(status.silent_cycles > 0 && status.solenoids == 0);
        r.lines.active_low = 1; /* what the end asks about */
        expect_ok(vbss_device_destroy(r.devices[0]));
        r.device_count = 0;
        expect_ok(vbss_nidaqmx_destroy(r.nidaqmx));
        assert_int_equal(r.daq->level(0), i == 0 ? 1 : 0);
        r.nidaqmx = NULL;
        r.daq->reset();
        hardware_rig_end(&r);
    }
}

/* The last word comes just after a round, and each waits for the hardware longer than its period. */
static void slow_rounds_turn_solenoid_off_within_10_ms(void **state)
{
    (void)state;
    for (int spacing = 2; spacing <= 5; spacing++) {
        hardware_rig r;
        hardware_rig_begin(&r, false);
        hardware_rig_open(&r, 1);
        r.commands[0].solenoid = 1;
        const int last = 8 * spacing;
        for (int i = 1; i <= last + 10; i++) {
            r.now = 1e-3 * i;
            if (i % spacing == 0) {
                expect_ok(vbss_nidaqmx_poll(r.nidaqmx, r.now));
            }
            r.hd->tick(1);
            if (i <= last) {
                assert_true(i < last || hardware_rig_solenoid(&r, 0));
                expect_ok(vbss_device_read(r.devices[0], r.now, &r.inputs[0], sizeof r.inputs[0]));
                expect_ok(vbss_device_write(r.devices[0], r.now, &r.commands[0], NULL, 0));
            }
        }
        assert_false(hardware_rig_solenoid(&r, 0));
        hardware_rig_end(&r);
    }
}

static void handle_before_first_round_says_that_nothing_was_measured(void **state)
{
    (void)state;
    hardware_rig r;
    const char *text = "";
    hardware_rig_begin(&r, false);
    hardware_rig_open(&r, 1);
    expect_ok(vbss_device_read(r.devices[0], r.now, &r.inputs[0], sizeof r.inputs[0]));
    expect_ok(vbss_device_get_error(r.devices[0], 1, NULL, &text));
    assert_non_null(strstr(text, "nothing was measured yet"));
    hardware_rig_end(&r);
}

static void host_step_never_touches_lines(void **state)
{
    (void)state;
    hardware_rig r;
    hardware_rig_begin(&r, false);
    hardware_rig_open(&r, 1);
    hardware_rig_steps(&r, 4);
    uint64_t reads = r.daq->reads(), writes = r.daq->writes();
    for (int i = 0; i < 20; i++) {
        r.now += 1e-3;
        r.commands[0].solenoid = (uint32_t)i & 1u;
        expect_ok(vbss_device_read(r.devices[0], r.now, &r.inputs[0], sizeof r.inputs[0]));
        expect_ok(vbss_device_write(r.devices[0], r.now, &r.commands[0], NULL, 0));
    }
    assert_true(r.daq->reads() == reads && r.daq->writes() == writes);
    hardware_rig_end(&r);
}

static void devices_are_listed(void **state)
{
    (void)state;
    hardware_rig r;
    char text[64];
    hardware_rig_begin(&r, false);
    expect_ok(vbss_nidaqmx_list_devices(r.context, VBSS_STAND_IN_NIDAQMX, text, sizeof text));
    assert_string_equal(text, "Dev1  USB-6008\nDev2  USB-6009\n");
    expect_ok(vbss_nidaqmx_list_devices(r.context, VBSS_STAND_IN_NIDAQMX, text, 9));
    assert_string_equal(text, "Dev1  US");
    hardware_rig_end(&r);
}

int test_handle_lines(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(potentiometers_are_read_in_volts),
        cmocka_unit_test(solenoid_pulses_match_script),
        cmocka_unit_test(silent_host_turns_solenoid_off),
        cmocka_unit_test(slow_rounds_turn_solenoid_off_within_10_ms),
        cmocka_unit_test(handle_before_first_round_says_that_nothing_was_measured),
        cmocka_unit_test(host_step_never_touches_lines),
        cmocka_unit_test(devices_are_listed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
