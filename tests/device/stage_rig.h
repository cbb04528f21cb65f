/* An output stage alone, without a handle. */
#ifndef VBSS_TESTS_DEVICE_STAGE_RIG_H
#define VBSS_TESTS_DEVICE_STAGE_RIG_H

#include "device/device.h"
#include "harness/harness.h"

typedef struct stage_rig {
    vbss_output_config config;
    output_state state;
    output_demand demand;
    uint32_t flags; /* of the last step */
} stage_rig;

static inline void stage_rig_begin(stage_rig *r)
{
    expect_ok(vbss_output_check_config(NULL, &r->config));
    vbss_output_init_state(&r->config, &r->state);
    r->demand = (output_demand){.age = 0.0};
    r->flags = 0;
}

/* Limits that nothing of these tests reaches, to look at one at a time. */
static inline stage_rig stage_rig_wide(void)
{
    stage_rig r;
    expect_ok(vbss_output_config_init(&r.config, sizeof r.config));
    r.config.max_force = r.config.continuous_force = 1e3;
    r.config.max_torque = r.config.continuous_torque = 1e3;
    r.config.force_rise = r.config.torque_rise = 1e9;
    stage_rig_begin(&r);
    return r;
}

static inline vec3 stage_rig_step(stage_rig *r, double h, vec3 force)
{
    r->demand.force = force;
    r->flags = vbss_output_advance(&r->config, &r->state, h, &r->demand);
    return r->state.force;
}

#endif
