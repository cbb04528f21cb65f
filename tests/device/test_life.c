/* Handles of devices, calls from inside callbacks, and where memory goes. */
#include "base/error.h"
#include "device/rig.h"
#include "fixtures/device_run.h"

/* ---- handles and callbacks */

static void every_call_rejects_invalid_handles(void **state)
{
    (void)state;
    device_rig r;
    device_rig_begin(&r);
    device_rig_open(&r, 1);
    vbss_device *destroyed = r.device, *none = destroyed;
    expect_ok(vbss_device_destroy(destroyed));
    harness_refuses_bad_handles(r.context, destroyed, device_calls, DEVICE_CALLS);
    expect_ok(vbss_device_destroy(NULL));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_device_destroy(destroyed));
    expect_result(VBSS_ERROR_INVALID_HANDLE,
                  vbss_device_create(NULL, &r.adapters[0], NULL, NULL, &none));
    assert_null(none);
    expect_result(VBSS_ERROR_NULL_ARGUMENT,
                  vbss_device_create(r.context, &r.adapters[0], NULL, NULL, NULL));
    device_rig_end(&r);
}

static device_rig *listening;
static vbss_result heard[DEVICE_CALLS + 2];

static void call_all(void)
{
    vbss_device *made;
    device_rig *r = listening;
    listening = NULL;
    for (int i = 0; r != NULL && i < DEVICE_CALLS; i++) {
        heard[i] = device_calls[i](r->device);
    }
    if (r != NULL) {
        heard[DEVICE_CALLS] = vbss_device_create(r->context, &r->adapters[0], NULL, NULL, &made);
        heard[DEVICE_CALLS + 1] = vbss_device_destroy(r->device);
    }
}

static void measure_and_meddle(void *user, double time, vbss_device_sample *sample)
{
    device_rig_hand(user, time, sample);
    call_all();
}

static void calls_inside_adapter_are_rejected(void **state)
{
    (void)state;
    device_rig r;
    device_rig_begin(&r);
    r.mock_configs[0].measure = measure_and_meddle;
    device_rig_open(&r, 1);
    device_rig_steps(&r, 3);
    listening = &r;
    device_rig_steps(&r, 1);
    assert_null(listening);
    for (int i = 0; i < DEVICE_CALLS; i++) {
        bool edits = i < DEVICE_EDITS;
        expect_result(edits ? VBSS_ERROR_BUSY : VBSS_OK, heard[i]);
    }
    expect_result(VBSS_ERROR_BUSY, heard[DEVICE_CALLS]);
    expect_result(VBSS_ERROR_BUSY, heard[DEVICE_CALLS + 1]);
    for (int i = 0; i < DEVICE_CALLS; i++) { /* all of these work outside */
        vbss_result wanted = device_calls[i] == device_call_restore ? VBSS_ERROR_CORRUPT : VBSS_OK;
        expect_result(wanted, device_calls[i](r.device));
    }
    device_rig_end(&r);
}

/* ---- memory */

static vbss_result live(vbss_context *context, void *user)
{
    device_run run;
    vbss_device_input input;
    vbss_output_result result;
    (void)user;
    VBSS_TRY(device_run_create(context, &run));
    for (int i = 0; i < 3; i++) {
        VBSS_TRY(device_run_step(run.device, &input, &result));
    }
    return device_run_destroy(&run);
}

static void each_failed_allocation_is_reported_without_leak(void **state)
{
    (void)state;
    harness_fail_every_allocation(live, NULL);
}

int test_life(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_call_rejects_invalid_handles),
        cmocka_unit_test(calls_inside_adapter_are_rejected),
        cmocka_unit_test(each_failed_allocation_is_reported_without_leak),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
