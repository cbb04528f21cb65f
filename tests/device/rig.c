#include "device/rig.h"

#include "base/rotation.h"

#include <string.h>

void device_rig_hand(void *user, double time, vbss_device_sample *sample)
{
    (void)user;
    sample->valid = VBSS_DEVICE_HAS_POSITION | VBSS_DEVICE_HAS_ORIENTATION |
                    VBSS_DEVICE_HAS_JAW_RAW | VBSS_DEVICE_HAS_BUTTONS;
    sample->position[0] = 0.1 * time - 0.005;
    quat q = vbss_quat_from_rotation_vector(vec3_make(0.0, 0.0, time));
    sample->orientation[0] = q.w;
    sample->orientation[3] = q.z;
    sample->jaw_raw = 0.5;
}

void device_rig_begin(device_rig *r)
{
    memset(r, 0, sizeof *r);
    r->context = harness_context(&r->memory);
    for (int i = 0; i < 2; i++) {
        expect_ok(vbss_device_capabilities_init(&r->capabilities[i], sizeof r->capabilities[i]));
        r->capabilities[i].signals = DEVICE_SIGNALS;
        expect_ok(vbss_mock_config_init(&r->mock_configs[i], sizeof r->mock_configs[i]));
        r->mock_configs[i].measure = device_rig_hand;
        r->mock_configs[i].capabilities = &r->capabilities[i];
    }
    r->capabilities[0].outputs = DEVICE_OUTPUTS;
    r->capabilities[1].outputs = VBSS_DEVICE_OUT_SOLENOID;
    expect_ok(vbss_device_calibration_init(&r->calibration, sizeof r->calibration));
    expect_ok(vbss_output_config_init(&r->output, sizeof r->output));
    expect_ok(vbss_device_config_init(&r->config, sizeof r->config));
    r->config.calibration = &r->calibration;
    r->config.output = &r->output;
    expect_ok(vbss_output_command_init(&r->command, sizeof r->command));
}

void device_rig_open(device_rig *r, int adapters)
{
    for (int i = 0; i < adapters; i++) {
        expect_ok(vbss_mock_create(r->context, &r->mock_configs[i], &r->mocks[i]));
        expect_ok(vbss_device_adapter_init(&r->adapters[i], sizeof r->adapters[i]));
        expect_ok(vbss_mock_get_adapter(r->mocks[i], &r->adapters[i]));
    }
    expect_ok(vbss_device_create(r->context, &r->adapters[0], adapters > 1 ? &r->adapters[1] : NULL,
                                 &r->config, &r->device));
}

void device_rig_read(device_rig *r)
{
    r->now = (double)r->step / 1000.0;
    r->step++;
    expect_ok(vbss_device_read(r->device, r->now, &r->input, sizeof r->input));
    r->events |= r->input.events;
}

void device_rig_write(device_rig *r, const vbss_output_command *command)
{
    expect_ok(vbss_device_write(r->device, r->now, command, &r->result, sizeof r->result));
    r->flags |= r->result.flags;
}

void device_rig_steps(device_rig *r, int count)
{
    for (int i = 0; i < count; i++) {
        device_rig_read(r);
        device_rig_write(r, &r->command);
    }
}

void device_rig_forget(device_rig *r)
{
    r->events = r->flags = 0;
}

void device_rig_fault(device_rig *r, int mock, vbss_mock_fault fault, double ms, double value)
{
    double from = r->now + 0.0005;
    expect_ok(vbss_mock_add_fault(r->mocks[mock], fault, from, from + 0.001 * ms, value));
}

void device_rig_end(device_rig *r)
{
    harness_context_end(r->context, &r->memory);
}

vbss_device_statistics device_rig_statistics(const device_rig *r)
{
    vbss_device_statistics s;
    expect_ok(vbss_device_get_statistics(r->device, &s, sizeof s));
    return s;
}

vbss_output_statistics device_rig_output_statistics(const device_rig *r)
{
    vbss_output_statistics s;
    expect_ok(vbss_device_get_output_statistics(r->device, &s, sizeof s));
    return s;
}

uint64_t device_rig_hash(const device_rig *r)
{
    uint64_t hash;
    expect_ok(vbss_device_get_hash(r->device, &hash));
    return hash;
}

device_object *device_rig_object(const device_rig *r)
{
    device_object *d;
    expect_ok(vbss_device_open(r->device, &d));
    return d;
}

/* ---- every function that takes a device */

static vbss_result call_read(void *device)
{
    vbss_device_input input;
    return vbss_device_read(device, 1e3, &input, sizeof input);
}

static vbss_result call_write(void *device)
{
    vbss_output_result result;
    return vbss_device_write(device, 1e3, NULL, &result, sizeof result);
}

static vbss_result call_stop(void *device)
{
    return vbss_device_latch_emergency_stop(device);
}

static vbss_result call_release(void *device)
{
    return vbss_device_clear_emergency_stop(device);
}

static vbss_result call_clutch(void *device)
{
    return vbss_device_set_clutch(device, 1);
}

static vbss_result call_recentre(void *device)
{
    return vbss_device_recentre(device, NULL, NULL);
}

static vbss_result call_calibrate(void *device)
{
    return vbss_device_set_calibration(device, NULL);
}

vbss_result device_call_restore(void *device)
{
    const uint8_t bytes[32] = {0};
    return vbss_device_restore(device, bytes, sizeof bytes);
}

static vbss_result call_unclutch(void *device)
{
    return vbss_device_set_clutch(device, 0);
}

static vbss_result call_capabilities(void *device)
{
    vbss_device_capabilities capabilities;
    return vbss_device_get_capabilities(device, 2, &capabilities, sizeof capabilities);
}

static vbss_result call_error(void *device)
{
    return vbss_device_get_error(device, 0, NULL, NULL);
}

static vbss_result call_statistics(void *device)
{
    vbss_device_statistics statistics;
    return vbss_device_get_statistics(device, &statistics, sizeof statistics);
}

static vbss_result call_output_statistics(void *device)
{
    vbss_output_statistics statistics;
    return vbss_device_get_output_statistics(device, &statistics, sizeof statistics);
}

static vbss_result call_save(void *device)
{
    static uint8_t bytes[8192];
    uint64_t written;
    return vbss_device_save(device, bytes, sizeof bytes, &written);
}

static vbss_result call_hash(void *device)
{
    uint64_t hash;
    return vbss_device_get_hash(device, &hash);
}

const harness_handle_call device_calls[DEVICE_CALLS] = {call_read,
                                                        call_write,
                                                        call_stop,
                                                        call_release,
                                                        call_clutch,
                                                        call_recentre,
                                                        call_calibrate,
                                                        device_call_restore,
                                                        call_unclutch,
                                                        call_capabilities,
                                                        call_error,
                                                        call_statistics,
                                                        call_output_statistics,
                                                        call_save,
                                                        call_hash};
