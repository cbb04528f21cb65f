/* The output stage behind its handle: limits, commands, steps without one. */
#include <string.h>

#include "base/snapshot.h"
#include "device/device.h"
#include "harness/harness.h"

typedef struct output_rig {
    harness_memory memory;
    vbss_context *context;
    vbss_output_config config;
    vbss_output *output;
    vbss_output_command command;
    vbss_output_result result;
} output_rig;

static void begin(output_rig *r)
{
    memset(r, 0, sizeof *r);
    r->context = harness_context(&r->memory);
    expect_ok(vbss_output_config_init(&r->config, sizeof r->config));
    expect_ok(vbss_output_command_init(&r->command, sizeof r->command));
}

static void create(output_rig *r)
{
    expect_ok(vbss_output_create(r->context, &r->config, &r->output));
}

static vbss_result step(output_rig *r, const vbss_output_command *command)
{
    return vbss_output_step(r->output, 1e-3, command, &r->result, sizeof r->result);
}

static void end(output_rig *r)
{
    harness_context_end(r->context, &r->memory);
}

static void defaults_match_documentation(void **state)
{
    (void)state;
    vbss_output_config c;
    const vbss_output_config wanted = {.struct_size = sizeof wanted,
                                       .max_force = 3.0,
                                       .max_torque = 0.1,
                                       .continuous_force = 0.88,
                                       .continuous_torque = 0.03,
                                       .load_time = 10.0,
                                       .warm = 0.7,
                                       .hot = 1.0,
                                       .force_rise = 500.0,
                                       .torque_rise = 20.0,
                                       .input_timeout = 0.005,
                                       .command_timeout = 0.005,
                                       .ramp_time = 0.005,
                                       .solenoid_time = 1.0,
                                       .solenoid_duty = 0.25};
    memset(&c, 0xff, sizeof c);
    expect_ok(vbss_output_config_init(&c, sizeof c));
    assert_memory_equal(&wanted, &c, sizeof c);
}

/* Held, grown older with each step, then ramped down. */
static void step_without_command_holds_last(void **state)
{
    (void)state;
    output_rig r;
    begin(&r);
    create(&r);
    r.command.force[0] = 0.4;
    expect_ok(step(&r, &r.command));
    for (int i = 1; i <= 12; i++) {
        expect_ok(step(&r, NULL));
        double left = 1.0 - 0.2 * (i - 5);
        expect_near(i <= 5 ? 0.4 : 0.4 * vbss_max(left, 0.0), r.result.force[0], 1e-12);
    }
    assert_int_equal(r.result.flags, VBSS_OUTPUT_FLAG_INPUT_STALE | VBSS_OUTPUT_FLAG_COMMAND_STALE);
    expect_near(0.01, r.result.expires, 1e-15);
    expect_ok(step(&r, &r.command));
    expect_near(0.4, r.result.force[0], 1e-15);
    end(&r);
}

static void no_output_before_first_command(void **state)
{
    (void)state;
    output_rig r;
    begin(&r);
    create(&r);
    expect_ok(step(&r, NULL));
    assert_int_equal(r.result.flags, VBSS_OUTPUT_FLAG_INPUT_STALE | VBSS_OUTPUT_FLAG_COMMAND_STALE);
    assert_true(r.result.force[0] == 0.0);
    end(&r);
}

static void stop_and_release(void **state)
{
    (void)state;
    output_rig r;
    vbss_output_statistics s;
    begin(&r);
    create(&r);
    r.command.force[1] = 0.4;
    expect_ok(step(&r, &r.command));
    expect_ok(vbss_output_latch_emergency_stop(r.output));
    expect_ok(step(&r, &r.command));
    assert_int_equal(r.result.flags, VBSS_OUTPUT_FLAG_STOPPED);
    assert_true(r.result.force[1] == 0.0);
    expect_ok(vbss_output_clear_emergency_stop(r.output));
    expect_ok(step(&r, &r.command));
    expect_near(0.4, r.result.force[1], 1e-15);
    expect_ok(vbss_output_get_statistics(r.output, &s, sizeof s));
    assert_int_equal(s.steps, 3);
    assert_int_equal(s.stops, 1);
    expect_near(0.4, s.largest_force, 1e-15);
    end(&r);
}

/* ---- bad input */

static void invalid_limits_are_rejected(void **state)
{
    (void)state;
    output_rig r;
    begin(&r);
    const vbss_output_config good = r.config;
    for (size_t at = offsetof(vbss_output_config, max_force); at < sizeof good; at += 8) {
        const double bad[] = {-1.0, 1e200, harness_bad_numbers[0], harness_bad_numbers[1],
                              harness_bad_numbers[2]};
        for (int i = 0; i < 5; i++) {
            r.config = good;
            memcpy((unsigned char *)&r.config + at, &bad[i], sizeof bad[i]);
            vbss_result wanted = i < 2 ? VBSS_ERROR_OUT_OF_RANGE : VBSS_ERROR_NOT_FINITE;
            r.output = (vbss_output *)r.context;
            expect_result(wanted, vbss_output_create(r.context, &r.config, &r.output));
            assert_null(r.output);
        }
    }
    r.config = good;
    r.config.hot = r.config.warm;
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_output_create(r.context, &r.config, &r.output));
    r.config = good;
    r.config.reserved = 1;
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_output_create(r.context, &r.config, &r.output));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_output_create(r.context, NULL, NULL));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_output_create(NULL, NULL, &r.output));
    expect_ok(vbss_output_create(r.context, NULL, &r.output));
    end(&r);
}

static uint64_t hash_of(vbss_output *output)
{
    vbss_slot *slot;
    uint64_t hash;
    expect_ok(vbss_slot_open(output, &vbss_output_kind, &slot));
    expect_ok(vbss_snapshot_hash(slot, &hash));
    return hash;
}

/* What was not finite is held as nothing, and can be saved. */
static void non_finite_command_is_not_stored(void **state)
{
    (void)state;
    output_rig r;
    begin(&r);
    create(&r);
    r.command.force[0] = 0.4;
    r.command.temperature = (double)NAN;
    expect_ok(step(&r, &r.command));
    assert_int_equal(r.result.flags, VBSS_OUTPUT_FLAG_NOT_FINITE);
    hash_of(r.output);
    vbss_slot *slot;
    uint8_t bytes[2048];
    size_t count;
    expect_ok(vbss_slot_open(r.output, &vbss_output_kind, &slot));
    expect_ok(vbss_snapshot_save(slot, bytes, sizeof bytes, &count));
    expect_ok(vbss_snapshot_restore(slot, bytes, count));
    expect_ok(step(&r, NULL));
    assert_int_equal(r.result.flags, 0);
    assert_true(r.result.force[0] == 0.0);
    end(&r);
}

/* Fault and temperature hold as long as the command. */
static void command_persists_until_next(void **state)
{
    (void)state;
    output_rig r;
    begin(&r);
    create(&r);
    r.command.force[0] = 0.4;
    r.command.solenoid = 1;
    r.command.temperature = 0.95;
    expect_ok(step(&r, &r.command));
    expect_ok(step(&r, NULL));
    assert_int_equal(r.result.flags, 0);
    r.command.force[0] = 0.5;
    r.command.fault = 1;
    expect_ok(step(&r, &r.command));
    expect_ok(step(&r, NULL));
    assert_int_equal(r.result.flags, VBSS_OUTPUT_FLAG_FAULT | VBSS_OUTPUT_FLAG_SOLENOID_OFF);
    r.command.temperature = 1.0;
    r.command.fault = 0;
    expect_ok(step(&r, &r.command));
    expect_ok(step(&r, NULL));
    assert_int_equal(r.result.flags, VBSS_OUTPUT_FLAG_WARM);
    end(&r);
}

static void bad_calls_change_nothing(void **state)
{
    (void)state;
    output_rig r;
    begin(&r);
    create(&r);
    r.command.force[0] = 0.4;
    expect_ok(step(&r, &r.command));
    uint64_t before = hash_of(r.output);
    vbss_output_command bad = r.command;
    bad.solenoid = 2;
    expect_result(VBSS_ERROR_OUT_OF_RANGE, step(&r, &bad));
    bad = r.command;
    bad.fault = 9;
    expect_result(VBSS_ERROR_OUT_OF_RANGE, step(&r, &bad));
    bad = r.command;
    bad.reserved = 1;
    expect_result(VBSS_ERROR_OUT_OF_RANGE, step(&r, &bad));
    const double steps[] = {-1e-9, 2e6, harness_bad_numbers[0], harness_bad_numbers[1]};
    for (int i = 0; i < 4; i++) {
        expect_result(i < 2 ? VBSS_ERROR_OUT_OF_RANGE : VBSS_ERROR_NOT_FINITE,
                      vbss_output_step(r.output, steps[i], &r.command, &r.result, sizeof r.result));
    }
    expect_result(VBSS_ERROR_NULL_ARGUMENT,
                  vbss_output_step(r.output, 1e-3, &r.command, NULL, sizeof r.result));
    expect_result(VBSS_ERROR_STRUCT_SIZE,
                  vbss_output_step(r.output, 1e-3, &r.command, &r.result, 95));
    const char *text;
    expect_ok(vbss_context_get_last_error(r.context, NULL, &text));
    assert_non_null(strstr(text, "vbss_output_result"));
    expect_result(VBSS_ERROR_OUT_OF_RANGE,
                  vbss_output_step(r.output, -1.0, NULL, &r.result, sizeof r.result));
    expect_ok(vbss_context_get_last_error(r.context, NULL, &text));
    assert_non_null(strstr(text, "h is -1"));
    assert_true(hash_of(r.output) == before);
    end(&r);
}

static vbss_result call_step(void *output)
{
    vbss_output_result result;
    return vbss_output_step(output, 1e-3, NULL, &result, sizeof result);
}

static vbss_result call_stop(void *output)
{
    return vbss_output_latch_emergency_stop(output);
}

static vbss_result call_release(void *output)
{
    return vbss_output_clear_emergency_stop(output);
}

static vbss_result call_statistics(void *output)
{
    vbss_output_statistics s;
    return vbss_output_get_statistics(output, &s, sizeof s);
}

static void every_call_rejects_invalid_handles(void **state)
{
    (void)state;
    const harness_handle_call calls[] = {call_step, call_stop, call_release, call_statistics};
    output_rig r;
    begin(&r);
    create(&r);
    expect_ok(vbss_output_destroy(r.output));
    harness_refuses_bad_handles(r.context, r.output, calls, 4);
    expect_ok(vbss_output_destroy(NULL));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_output_destroy(r.output));
    end(&r);
}

int test_output_handle(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(defaults_match_documentation),
        cmocka_unit_test(step_without_command_holds_last),
        cmocka_unit_test(no_output_before_first_command),
        cmocka_unit_test(stop_and_release),
        cmocka_unit_test(invalid_limits_are_rejected),
        cmocka_unit_test(non_finite_command_is_not_stored),
        cmocka_unit_test(command_persists_until_next),
        cmocka_unit_test(bad_calls_change_nothing),
        cmocka_unit_test(every_call_rejects_invalid_handles),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
