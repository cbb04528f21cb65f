/* Configurations and calls of devices: their defaults, and every bad number and word with its status and a text
 * that names it. */
#include <string.h>

#include "device/rig.h"

/* ---- what is there */

static void defaults_match_documentation(void **state)
{
    (void)state;
    vbss_device_config c;
    vbss_device_calibration calibration;
    vbss_mock_config mock;
    const vbss_device_config wanted = {.struct_size = sizeof wanted,
                                       .tool = VBSS_DEVICE_TOOL_NEEDLE_DRIVER,
                                       .second_signals =
                                           VBSS_DEVICE_HAS_JAW | VBSS_DEVICE_HAS_JAW_RAW,
                                       .clock = VBSS_DEVICE_CLOCK_OWN,
                                       .stop_when_lost = 1,
                                       .jaw_timeout = 0.1,
                                       .velocity_time = 0.005,
                                       .norm_tolerance = 1e-3,
                                       .max_stiffness = 400.0,
                                       .max_damping = 4.0};
    memset(&c, 0xff, sizeof c);
    memset(&calibration, 0xff, sizeof calibration);
    expect_ok(vbss_device_config_init(&c, sizeof c));
    assert_memory_equal(&wanted, &c, sizeof c);
    const vbss_device_calibration plain = {
        .struct_size = sizeof plain,
        .axes = {1, 2, 3},
        .rotation = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0},
        .scale = 1.0,
        .mount = {1.0, 0.0, 0.0, 0.0},
        .workspace_low = {-1.0, -1.0, -1.0},
        .workspace_high = {1.0, 1.0, 1.0},
        .force_scale = 1.0,
        .jaw_open = 1.0,
        .jaw_margin = 0.25,
        .jaw_play = 0.02,
        .jaw_time = 0.01,
        .jaw_close_at = 0.05,
        .jaw_open_at = 0.1};
    expect_ok(vbss_device_calibration_init(&calibration, sizeof calibration));
    assert_memory_equal(&plain, &calibration, sizeof plain);
    expect_ok(vbss_mock_config_init(&mock, sizeof mock));
    assert_int_equal(mock.fault_capacity, 16);
    assert_int_equal(mock.row_capacity, 1024);
}

/* ---- bad configurations */

static void expect_refused(device_rig *r, vbss_result wanted, const char *name)
{
    const char *text;
    vbss_context_statistics before, after;
    vbss_device *device = (vbss_device *)r->context;
    expect_ok(vbss_context_get_statistics(r->context, &before, sizeof before));
    expect_result(wanted,
                  vbss_device_create(r->context, &r->adapters[0], NULL, &r->config, &device));
    assert_null(device);
    expect_ok(vbss_context_get_last_error(r->context, NULL, &text));
    assert_non_null(strstr(text, name));
    expect_ok(vbss_context_get_statistics(r->context, &after, sizeof after));
    assert_int_equal(before.bytes_allocated, after.bytes_allocated);
}

#define FIELD(field, low, high)                                \
    {                                                          \
#field, offsetof(vbss_device_config, field), low, high \
    }

static void every_bad_number_is_rejected_by_name(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        size_t at;
        double low, high;
    } fields[] = {FIELD(jaw_timeout, 1e-4, 1e3), FIELD(velocity_time, 0.0, 10.0),
                  FIELD(norm_tolerance, 0.0, 0.5), FIELD(max_stiffness, 0.0, 1e6),
                  FIELD(max_damping, 0.0, 1e6)};
    device_rig r;
    device_rig_begin(&r);
    device_rig_open(&r, 1);
    expect_ok(vbss_device_destroy(r.device));
    const vbss_device_config good = r.config;
    for (size_t i = 0; i < sizeof fields / sizeof fields[0]; i++) {
        const double bad[] = {fields[i].low - 1e-5, fields[i].high * 1.001, harness_bad_numbers[0],
                              harness_bad_numbers[1], harness_bad_numbers[2]};
        for (int k = 0; k < 5; k++) {
            r.config = good;
            memcpy((unsigned char *)&r.config + fields[i].at, &bad[k], sizeof bad[k]);
            expect_refused(&r, k < 2 ? VBSS_ERROR_OUT_OF_RANGE : VBSS_ERROR_NOT_FINITE,
                           fields[i].name);
        }
        const double ends[] = {fields[i].low, fields[i].high};
        for (int k = 0; k < 2; k++) {
            r.config = good;
            memcpy((unsigned char *)&r.config + fields[i].at, &ends[k], sizeof ends[k]);
            expect_ok(vbss_device_create(r.context, &r.adapters[0], NULL, &r.config, &r.device));
            expect_ok(vbss_device_destroy(r.device));
        }
    }
    r.config = good;
    r.config.tool = 3;
    expect_refused(&r, VBSS_ERROR_OUT_OF_RANGE, "tool");
    r.config = good;
    r.config.second_signals = 512;
    expect_refused(&r, VBSS_ERROR_OUT_OF_RANGE, "second_signals");
    r.config = good;
    r.config.clock = -1;
    expect_refused(&r, VBSS_ERROR_OUT_OF_RANGE, "clock");
    r.config = good;
    r.config.stop_when_lost = 2;
    expect_refused(&r, VBSS_ERROR_OUT_OF_RANGE, "stop_when_lost");
    r.config = good;
    r.config.clutch_orientation = 2;
    expect_refused(&r, VBSS_ERROR_OUT_OF_RANGE, "clutch_orientation");
    r.config = good;
    r.calibration.scale = 0.0;
    expect_refused(&r, VBSS_ERROR_OUT_OF_RANGE, "scale");
    r.calibration.scale = 1.0;
    r.output.ramp_time = -1.0;
    expect_refused(&r, VBSS_ERROR_OUT_OF_RANGE, "ramp_time");
    device_rig_end(&r);
}

/* ---- bad calls */

static void bad_calls_touch_no_adapter(void **state)
{
    (void)state;
    device_rig r;
    vbss_mock_statistics before, after;
    device_rig_begin(&r);
    device_rig_open(&r, 1);
    device_rig_steps(&r, 20);
    expect_ok(vbss_mock_get_statistics(r.mocks[0], &before, sizeof before));
    uint64_t hash = device_rig_hash(&r);
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_device_read(r.device, 1.0, NULL, sizeof r.input));
    expect_result(VBSS_ERROR_STRUCT_SIZE, vbss_device_read(r.device, 1.0, &r.input, 207));
    expect_result(VBSS_ERROR_STRUCT_SIZE,
                  vbss_device_write(r.device, 1.0, &r.command, &r.result, 95));
    r.command.solenoid = 7;
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_device_write(r.device, 1.0, &r.command, NULL, 0));
    r.command.struct_size = 12;
    expect_result(VBSS_ERROR_STRUCT_SIZE, vbss_device_write(r.device, 1.0, &r.command, NULL, 0));
    expect_ok(vbss_mock_get_statistics(r.mocks[0], &after, sizeof after));
    assert_memory_equal(&before, &after, sizeof before);
    assert_true(device_rig_hash(&r) == hash);
    device_rig_end(&r);
}

/* The last row of the mock: time, force, torque, solenoid, flags. */
static const double *last_output(const device_rig *r)
{
    vbss_view view;
    expect_ok(vbss_mock_get_view(r->mocks[0], VBSS_MOCK_VIEW_ROWS, &view, sizeof view));
    assert_true(view.count > 0);
    return (const double *)view.data + 9 * (view.count - 1);
}

/* With an adapter that keeps its last output for ever, as one does that knows no `expires`. */
static void wrong_clock_switches_outputs_off(void **state)
{
    (void)state;
    for (int call = 0; call < 3; call++) {
        for (int i = 0; i < 4; i++) {
            device_rig r;
            vbss_device_coupling coupling;
            device_rig_begin(&r);
            device_rig_open(&r, 1);
            r.command.force[0] = 0.8;
            r.command.solenoid = 1;
            device_rig_steps(&r, 20);
            assert_true(fabs(last_output(&r)[1] - 0.8) < 1e-12);
            expect_ok(vbss_device_coupling_init(&coupling, sizeof coupling));
            const double times[] = {r.now - 50.0, 2e9, harness_bad_numbers[0],
                                    harness_bad_numbers[1]};
            vbss_result wanted = i < 2 ? VBSS_ERROR_OUT_OF_RANGE : VBSS_ERROR_NOT_FINITE;
            expect_result(wanted,
                          call == 0 ? vbss_device_read(r.device, times[i], &r.input, sizeof r.input)
                          : call == 1 ? vbss_device_write(r.device, times[i], &r.command, NULL, 0)
                                      : vbss_device_write_coupled(r.device, times[i], &r.command,
                                                                  &coupling, NULL, 0));
            assert_true(last_output(&r)[1] == 0.0 && last_output(&r)[7] == 0.0);
            assert_int_equal(device_rig_output_statistics(&r).stops, 0);
            device_rig_steps(&r, 5); /* the clock is right again */
            assert_true(fabs(last_output(&r)[1] - 0.8) < 1e-12);
            device_rig_end(&r);
        }
    }
}

static void jump_of_clock_switches_outputs_off_for_10_ms(void **state)
{
    (void)state;
    device_rig r;
    device_rig_begin(&r);
    device_rig_open(&r, 1);
    r.command.force[0] = 0.8;
    device_rig_steps(&r, 20);
    r.step += 50000;
    device_rig_steps(&r, 1);
    assert_true(last_output(&r)[1] == 0.0);
    assert_true((r.result.flags & VBSS_OUTPUT_FLAG_COMMAND_STALE) != 0);
    device_rig_steps(&r, 9);
    assert_true(last_output(&r)[1] == 0.0);
    device_rig_steps(&r, 5);
    assert_true(fabs(last_output(&r)[1] - 0.8) < 1e-12);
    device_rig_end(&r);
}

static void time_is_monotonic_after_read_only(void **state)
{
    (void)state;
    device_rig r;
    device_rig_begin(&r);
    device_rig_open(&r, 1);
    expect_ok(vbss_device_read(r.device, -5.0, &r.input, sizeof r.input));
    expect_result(VBSS_ERROR_OUT_OF_RANGE,
                  vbss_device_read(r.device, -5.1, &r.input, sizeof r.input));
    expect_ok(vbss_device_read(r.device, -5.0, &r.input, sizeof r.input));
    device_rig_end(&r);
}

int test_refusals(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(defaults_match_documentation),
        cmocka_unit_test(every_bad_number_is_rejected_by_name),
        cmocka_unit_test(bad_calls_touch_no_adapter),
        cmocka_unit_test(wrong_clock_switches_outputs_off),
        cmocka_unit_test(jump_of_clock_switches_outputs_off_for_10_ms),
        cmocka_unit_test(time_is_monotonic_after_read_only),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
