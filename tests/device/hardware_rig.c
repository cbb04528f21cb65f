#include "device/hardware_rig.h"

#include <string.h>

#include "fixtures/stand_in_worlds.h"

void hardware_rig_begin(hardware_rig *r, bool threaded)
{
    memset(r, 0, sizeof *r);
    r->context = harness_context(&r->memory);
    r->hd = stand_in_arms_of(VBSS_STAND_IN_OPENHAPTICS);
    r->daq = stand_in_lines_of(VBSS_STAND_IN_NIDAQMX);
    assert_non_null(r->hd);
    assert_non_null(r->daq);
    r->hd->reset(threaded);
    r->daq->reset();
    expect_ok(vbss_openhaptics_config_init(&r->arms, sizeof r->arms));
    expect_ok(vbss_nidaqmx_config_init(&r->lines, sizeof r->lines));
    expect_ok(vbss_device_config_init(&r->config, sizeof r->config));
    r->arms.library = VBSS_STAND_IN_OPENHAPTICS;
    r->arms.device_count = 2;
    r->lines.library = VBSS_STAND_IN_NIDAQMX;
    r->lines.own_thread = threaded;
    for (int i = 0; i < 2; i++) {
        expect_ok(vbss_output_command_init(&r->commands[i], sizeof r->commands[i]));
        expect_ok(vbss_device_coupling_init(&r->couplings[i], sizeof r->couplings[i]));
        r->daq->set_volts(i, 0.5);
    }
}

void hardware_rig_open(hardware_rig *r, int devices)
{
    vbss_device_adapter arm, handle;
    expect_ok(vbss_openhaptics_create(r->context, &r->arms, &r->openhaptics));
    expect_ok(vbss_nidaqmx_create(r->context, &r->lines, &r->nidaqmx));
    expect_ok(vbss_device_adapter_init(&arm, sizeof arm));
    expect_ok(vbss_device_adapter_init(&handle, sizeof handle));
    r->device_count = devices;
    for (int i = 0; i < devices; i++) {
        expect_ok(vbss_openhaptics_get_adapter(r->openhaptics, (uint32_t)i, &arm));
        expect_ok(vbss_nidaqmx_get_adapter(r->nidaqmx, (uint32_t)i, &handle));
        expect_ok(vbss_device_create(r->context, &arm, &handle, &r->config, &r->devices[i]));
    }
}

static void write_one(hardware_rig *r, int i)
{
    const vbss_device_coupling *c = &r->couplings[i];
    if (c->stiffness > 0.0 || c->damping > 0.0) {
        expect_ok(vbss_device_write_coupled(r->devices[i], r->now, &r->commands[i], c,
                                            &r->results[i], sizeof r->results[i]));
    } else {
        expect_ok(vbss_device_write(r->devices[i], r->now, &r->commands[i], &r->results[i],
                                    sizeof r->results[i]));
    }
}

void hardware_rig_tick(hardware_rig *r)
{
    if (r->step >= r->next_round && r->step > 1) {
        (void)r->daq->waited();
        expect_ok(vbss_nidaqmx_poll(r->nidaqmx, (double)r->step / 1000.0));
        const uint64_t waited = (uint64_t)ceil(1000.0 * r->daq->waited() - 1e-6);
        r->next_round = r->step + (waited > 2 ? waited : 2);
    }
    r->hd->tick(1);
}

void hardware_rig_steps(hardware_rig *r, int count)
{
    for (int k = 0; k < count; k++) {
        r->now = (double)++r->step / 1000.0;
        hardware_rig_tick(r);
        for (int i = 0; i < r->device_count && !r->silent; i++) {
            vbss_device_input *in = &r->inputs[i];
            expect_ok(vbss_device_read(r->devices[i], r->now, in, sizeof *in));
            write_one(r, i);
        }
    }
}

double hardware_rig_force(const hardware_rig *r, int arm)
{
    stand_in_arm now;
    r->hd->get_state(arm, &now);
    return vec3_norm(vec3_load(now.force));
}

bool hardware_rig_solenoid(const hardware_rig *r, int handle)
{
    return r->daq->level(handle) == (r->lines.active_low != 0 ? 0 : 1);
}

void hardware_rig_end(hardware_rig *r)
{
    const char *first;
    for (int i = 0; i < r->device_count; i++) {
        expect_ok(vbss_device_destroy(r->devices[i]));
    }
    expect_ok(vbss_openhaptics_destroy(r->openhaptics));
    expect_ok(vbss_nidaqmx_destroy(r->nidaqmx));
    for (int i = 0; i < 2; i++) {
        assert_true(hardware_rig_force(r, i) == 0.0);
        assert_false(hardware_rig_solenoid(r, i));
    }
    if (r->hd->illegal(&first) != 0) {
        fail_msg("OpenHaptics, illegal: %s", first);
    }
    if (r->daq->illegal(&first) != 0) {
        fail_msg("NI-DAQmx, illegal: %s", first);
    }
    harness_context_end(r->context, &r->memory);
}

void hardware_rig_expect_text(const hardware_rig *r, const char *wanted)
{
    const char *text;
    expect_ok(vbss_context_get_last_error(r->context, NULL, &text));
    if (strstr(text, wanted) == NULL) {
        fail_msg("'%s' says nothing of '%s'", text, wanted);
    }
}
