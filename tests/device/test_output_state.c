/* Output stages behind handles: sizes of their structs, going back to what was saved, memory. */
#include "base/error.h"
#include "base/snapshot.h"
#include "device/device.h"
#include "harness/harness.h"
#include "fixtures/device_run.h"

/* ---- sizes */

static vbss_result config_init(void *config, uint32_t struct_size)
{
    return vbss_output_config_init(config, struct_size);
}

static vbss_result create_and_destroy(vbss_context *context, const void *config)
{
    vbss_output *output;
    VBSS_TRY(vbss_output_create(context, config, &output));
    return vbss_output_destroy(output);
}

static vbss_result command_init(void *command, uint32_t struct_size)
{
    return vbss_output_command_init(command, struct_size);
}

static vbss_result step_and_destroy(vbss_context *context, const void *command)
{
    vbss_output *output;
    vbss_output_result own;
    VBSS_TRY(vbss_output_create(context, NULL, &output));
    vbss_result result = vbss_output_step(output, 1e-3, command, &own, sizeof own);
    VBSS_TRY(vbss_output_destroy(output));
    return result;
}

static void size_protocol(void **state)
{
    (void)state;
    static const uint32_t config_sizes[] = {120, 0}, command_sizes[] = {88, 0};
    const harness_config config = {config_sizes, config_init, create_and_destroy};
    const harness_config command = {command_sizes, command_init, step_and_destroy};
    harness_config_protocol(&config);
    harness_config_protocol(&command);
}

/* ---- state */

static vbss_result stage_create(vbss_context *context, void *user, void **handle)
{
    vbss_output *output = NULL;
    vbss_output_config config;
    (void)user;
    VBSS_TRY(vbss_output_config_init(&config, sizeof config));
    config.load_time = 0.1;
    config.solenoid_time = 0.05;
    vbss_result result = vbss_output_create(context, &config, &output);
    *handle = output;
    return result;
}

static vbss_result stage_step(void *handle)
{
    vbss_output_statistics s;
    vbss_output_result result;
    VBSS_TRY(vbss_output_get_statistics(handle, &s, sizeof s));
    return device_run_output(handle, s.steps, &result);
}

static vbss_result stage_destroy(void *handle)
{
    return vbss_output_destroy(handle);
}

static void restored_stage_continues_bit_equal(void **state)
{
    (void)state;
    const harness_body body = {"output stage", &vbss_output_kind, stage_create, NULL,
                               stage_step,     stage_destroy,     NULL};
    for (size_t before = 0; before < 260; before += 13) {
        harness_save_restore_continue(&body, before, 30);
    }
    harness_refuses_bad_snapshots(&body, 95);
    harness_refuses_bad_snapshots(&body, 205);
    assert_int_equal(harness_step_allocations(&body, 300), 0);
}

/* What a command said holds after it, too. */
static void last_command_is_restored(void **state)
{
    (void)state;
    for (int fault = 0; fault < 2; fault++) {
        harness_memory memory;
        vbss_context *context = harness_context(&memory);
        vbss_output *one, *two;
        vbss_output_command command;
        vbss_output_result result;
        vbss_slot *slots[2];
        uint8_t bytes[2048];
        size_t count;
        expect_ok(vbss_output_create(context, NULL, &one));
        expect_ok(vbss_output_create(context, NULL, &two));
        expect_ok(vbss_slot_open(one, &vbss_output_kind, &slots[0]));
        expect_ok(vbss_slot_open(two, &vbss_output_kind, &slots[1]));
        expect_ok(vbss_output_command_init(&command, sizeof command));
        command.force[1] = 0.4;
        command.fault = (uint32_t)fault;
        command.temperature = 0.97;
        expect_ok(vbss_output_step(one, 1e-3, &command, &result, sizeof result));
        expect_ok(vbss_snapshot_save(slots[0], bytes, sizeof bytes, &count));
        expect_ok(vbss_snapshot_restore(slots[1], bytes, count));
        expect_ok(vbss_output_step(two, 1e-3, NULL, &result, sizeof result));
        assert_int_equal(result.flags,
                         VBSS_OUTPUT_FLAG_WARM | (fault == 1 ? VBSS_OUTPUT_FLAG_FAULT : 0));
        harness_context_end(context, &memory);
    }
}

static void snapshot_of_other_stage_is_rejected(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_output_config config;
    vbss_output *output;
    vbss_slot *slot;
    uint8_t bytes[2048];
    size_t count;
    expect_ok(vbss_output_create(context, NULL, &output));
    expect_ok(vbss_slot_open(output, &vbss_output_kind, &slot));
    expect_ok(vbss_snapshot_save(slot, bytes, sizeof bytes, &count));
    expect_ok(vbss_output_config_init(&config, sizeof config));
    config.ramp_time = 0.1;
    expect_ok(vbss_output_create(context, &config, &output));
    expect_ok(vbss_slot_open(output, &vbss_output_kind, &slot));
    expect_result(VBSS_ERROR_CORRUPT, vbss_snapshot_restore(slot, bytes, count));
    harness_context_end(context, &memory);
}

static vbss_result live(vbss_context *context, void *user)
{
    void *output;
    VBSS_TRY(stage_create(context, user, &output));
    VBSS_TRY(stage_step(output));
    return stage_destroy(output);
}

static void each_failed_allocation_is_reported(void **state)
{
    (void)state;
    harness_fail_every_allocation(live, NULL);
}

int test_output_state(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(size_protocol),
        cmocka_unit_test(restored_stage_continues_bit_equal),
        cmocka_unit_test(last_command_is_restored),
        cmocka_unit_test(snapshot_of_other_stage_is_rejected),
        cmocka_unit_test(each_failed_allocation_is_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
