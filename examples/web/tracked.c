/* Controllers as the arms of live.h: what a page says of them is a device, read and led as an arm is. A pose that comes once a
 * picture is gone to in even parts. */
#include <math.h>
#include <string.h>

#include "page.h"
#include "session.h"

#define STEP 1e-3
#define CLUTCH 2U      /* an arm's second button, as grip.c has it */
#define WORKSPACE 0.15 /* m, of the tool from the middle, each way, as a mouse's */

typedef struct controller {
    vbss_device *device; /* NULL: the mouse has the hand */
    vbss_device_sample sample;
    double to[8]; /* position, orientation, jaw */
    uint32_t parts;
    double force; /* N */
} controller;

struct arms {
    controller sides[SIDES];
};

static arms controllers;

arms *tracked_arms(void)
{
    return &controllers;
}

void tracked_reset(void)
{
    memset(&controllers, 0, sizeof controllers);
}

vbss_device *arms_device(const arms *a, int side)
{
    return a->sides[side].device;
}

double arms_clock(const arms *a, double simulated)
{
    (void)a;
    return simulated;
}

double tracked_force(int side)
{
    const controller *c = &controllers.sides[side];
    return c->device != NULL ? c->force : 0.0;
}

/* ---- the adapter */

/* By the nearer of the two quaternions. */
static void go_on(controller *c)
{
    vbss_device_sample *s = &c->sample;
    const double share = 1.0 / c->parts;
    double dot = 0.0, size = 0.0;
    for (int i = 0; i < 3; i++) {
        s->position[i] += share * (c->to[i] - s->position[i]);
    }
    for (int i = 0; i < 4; i++) {
        dot += s->orientation[i] * c->to[3 + i];
    }
    for (int i = 0; i < 4; i++) {
        const double to = dot < 0.0 ? -c->to[3 + i] : c->to[3 + i];
        s->orientation[i] += share * (to - s->orientation[i]);
        size += s->orientation[i] * s->orientation[i];
    }
    size = sqrt(size);
    for (int i = 0; i < 4; i++) {
        s->orientation[i] /= size;
    }
    s->jaw += share * (c->to[7] - s->jaw);
    c->parts--;
}

static vbss_result read_controller(void *user, double now, vbss_device_sample *sample)
{
    controller *c = user;
    const uint32_t size = sample->struct_size;
    if (c->parts > 0) {
        go_on(c);
    }
    c->sample.time = now;
    memcpy(sample, &c->sample, size < sizeof c->sample ? size : sizeof c->sample);
    sample->struct_size = size;
    return VBSS_OK;
}

static vbss_result write_controller(void *user, double now, const vbss_output_result *output)
{
    controller *c = user;
    const double *f = output->force;
    (void)now;
    c->force = sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]);
    return VBSS_OK;
}

/* ---- made */

static vbss_result begin_sample(controller *c, vbss_grasper *tool)
{
    vbss_grasper_state state;
    TRY(vbss_grasper_get_state(tool, &state, sizeof state));
    TRY(vbss_device_sample_init(&c->sample, sizeof c->sample));
    memcpy(c->sample.position, state.target_position, sizeof state.target_position);
    memcpy(c->sample.orientation, state.target_orientation, sizeof state.target_orientation);
    c->sample.jaw = state.opening;
    c->sample.valid = VBSS_DEVICE_HAS_POSITION | VBSS_DEVICE_HAS_ORIENTATION | VBSS_DEVICE_HAS_JAW |
                      VBSS_DEVICE_HAS_BUTTONS;
    return VBSS_OK;
}

static vbss_result begin_device(controller *c, vbss_context *context)
{
    vbss_device_adapter adapter;
    vbss_device_config config;
    vbss_device_calibration space;
    TRY(vbss_device_adapter_init(&adapter, sizeof adapter));
    adapter.name = "controller";
    adapter.user = c;
    adapter.read = read_controller;
    adapter.write = write_controller;
    TRY(vbss_device_calibration_init(&space, sizeof space));
    for (int i = 0; i < 3; i++) {
        space.workspace_low[i] = -WORKSPACE;
        space.workspace_high[i] = WORKSPACE;
    }
    TRY(vbss_device_config_init(&config, sizeof config));
    config.clock = VBSS_DEVICE_CLOCK_SHARED;
    config.calibration = &space;
    return vbss_device_create(context, &adapter, NULL, &config, &c->device);
}

int32_t page_track(int32_t side, int32_t is_tracked)
{
    page_session *p = page_get();
    if (!p->there || p->plays || side < 0 || side >= SIDES) {
        return VBSS_ERROR_OUT_OF_RANGE;
    }
    controller *c = &controllers.sides[side];
    if ((c->device != NULL) == (is_tracked != 0)) {
        return VBSS_OK;
    }
    if (is_tracked == 0) {
        TRY(vbss_device_destroy(c->device));
        memset(c, 0, sizeof *c);
        return page_take_mouse(p, side);
    }
    TRY(begin_sample(c, p->live.stage.graspers[side]));
    TRY(begin_device(c, p->live.stage.context));
    grip_begin(&p->live.grips[side], c->sample.position);
    return VBSS_OK;
}

void page_pose(int32_t side, double x, double y, double z, double qw, double qx, double qy,
               double qz, double jaw, int32_t clutched, double seconds)
{
    if (side < 0 || side >= SIDES || controllers.sides[side].device == NULL) {
        return;
    }
    controller *c = &controllers.sides[side];
    const double to[8] = {x, y, z, qw, qx, qy, qz, fmin(fmax(jaw, 0.0), 1.0)};
    memcpy(c->to, to, sizeof to);
    c->sample.buttons = clutched != 0 ? CLUTCH : 0;
    c->parts = (uint32_t)fmin(fmax(seconds / STEP, 1.0), 100.0);
}
