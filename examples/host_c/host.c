/* A host that has a device layer of its own, such as another simulator: it fills the library's table of functions from that,
 * and everything behind the table (checks, calibration, coupling, output stage) works as with any other hardware.
 *
 * The layer here is a small one of the usual kind: devices by number, a thread-safe newest state in millimetres, forces set
 * in newtons, errors by number. What is worth copying stands under "the bridge". */
#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <vblast_ss/vblast_ss.h>

/* ---- the host's device layer: a pen that a hand moves slowly into a wall at x = 10 mm, and that is unplugged in the end */

enum { PEN_OK = 0, PEN_GONE = 7 };

typedef struct pen_state {
    double position_mm[3];
    double time; /* s, of the layer's own clock */
    int pressed; /* how far the lever is, 0 to 255 */
} pen_state;

typedef struct pen {
    double time;
    int open, plugged;
    double force[3]; /* that its motors put out, N */
} pen;

static int pen_open(pen *p)
{
    p->open = p->plugged;
    return p->plugged ? PEN_OK : PEN_GONE;
}

static void pen_close(pen *p)
{
    p->open = 0;
    memset(p->force, 0, sizeof p->force);
}

static int pen_get(const pen *p, pen_state *state)
{
    if (!p->plugged) {
        return PEN_GONE;
    }
    memset(state, 0, sizeof *state);
    state->position_mm[0] = 15.0 * p->time;
    state->time = p->time;
    state->pressed = 204;
    return PEN_OK;
}

static int pen_set_force(pen *p, const double newton[3])
{
    if (!p->plugged) {
        memset(p->force, 0, sizeof p->force);
        return PEN_GONE;
    }
    memcpy(p->force, newton, sizeof p->force);
    return PEN_OK;
}

/* ---- the bridge: the library's table, filled from that layer */

typedef struct bridge {
    pen *pen;
    int error; /* of the last call that failed */
} bridge;

static vbss_result keep(bridge *b, int error)
{
    b->error = error != PEN_OK ? error : b->error;
    return error == PEN_OK ? VBSS_OK : VBSS_ERROR_DEVICE;
}

static vbss_result open_it(void *user)
{
    bridge *b = user;
    return keep(b, pen_open(b->pen));
}

static void close_it(void *user)
{
    bridge *b = user;
    pen_close(b->pen);
}

/* Limits that are known make the output stage careful; 0 stays "not known". */
static vbss_result describe(void *user, vbss_device_capabilities *c)
{
    (void)user;
    c->signals = VBSS_DEVICE_HAS_POSITION | VBSS_DEVICE_HAS_JAW;
    c->outputs = VBSS_DEVICE_OUT_FORCE;
    c->input_dof = 3;
    c->output_dof = 3;
    c->max_force = 2.0;
    c->update_rate = 1000.0;
    return VBSS_OK;
}

/* Only what is measured is told as valid; velocities follow from positions. SI units, and the layer's own time. */
static vbss_result read_it(void *user, double now, vbss_device_sample *sample)
{
    bridge *b = user;
    pen_state state;
    (void)now;
    int error = pen_get(b->pen, &state);
    if (error != PEN_OK) {
        sample->flags = VBSS_DEVICE_FLAG_LOST; /* latches the emergency stop */
        return keep(b, error);
    }
    for (int i = 0; i < 3; i++) {
        sample->position[i] = 1e-3 * state.position_mm[i];
    }
    sample->jaw = 1.0 - state.pressed / 255.0;
    sample->time = state.time;
    sample->valid = VBSS_DEVICE_HAS_POSITION | VBSS_DEVICE_HAS_JAW;
    return VBSS_OK;
}

static vbss_result write_it(void *user, double now, const vbss_output_result *output)
{
    bridge *b = user;
    (void)now;
    return keep(b, pen_set_force(b->pen, output->force));
}

static void explain(void *user, char *text, uint32_t bytes)
{
    const bridge *b = user;
    (void)snprintf(text, bytes, "pen error %d", b->error);
}

static vbss_result make_device(vbss_context *context, bridge *b, vbss_device **device)
{
    vbss_device_adapter table;
    vbss_result result = vbss_device_adapter_init(&table, sizeof table);
    if (result != VBSS_OK) {
        return result;
    }
    table.name = "pen";
    table.user = b;
    table.open = open_it;
    table.close = close_it;
    table.describe = describe;
    table.read = read_it;
    table.write = write_it;
    table.explain = explain;
    return vbss_device_create(context, &table, NULL, NULL, device);
}

/* ---- the host's loop */

#define WALL 10e-3      /* m */
#define STIFFNESS 300.0 /* N/m */
#define STEP 1e-3

/* One turn of the host: read, compute, write. */
static vbss_result turn(vbss_device *device, double now, vbss_device_input *in)
{
    vbss_output_command command;
    vbss_device_coupling tool;
    vbss_result result = vbss_device_read(device, now, in, sizeof *in);
    result = result ? result : vbss_output_command_init(&command, sizeof command);
    result = result ? result : vbss_device_coupling_init(&tool, sizeof tool);
    if (result != VBSS_OK) {
        return result;
    }
    memcpy(tool.position, in->position, sizeof tool.position);
    tool.position[0] = fmin(in->position[0], WALL); /* the tool stays before the wall */
    tool.stiffness = STIFFNESS;
    return vbss_device_write_coupled(device, now, &command, &tool, NULL, 0);
}

static int run(vbss_context *context)
{
    pen hardware = {.plugged = 1};
    bridge b = {.pen = &hardware};
    vbss_device *device;
    vbss_device_input in;
    const char *text = "";
    double now = 0.0;
    if (make_device(context, &b, &device) != VBSS_OK) {
        return 1;
    }
    for (int i = 1; i <= 1000; i++) {
        hardware.time = now = i * STEP;
        if (turn(device, now, &in) != VBSS_OK) {
            return 1;
        }
    }
    double felt = -hardware.force[0], wanted = STIFFNESS * (in.position[0] - WALL);
    printf("pen at %.2f mm, opening %.2f, pushed back with %.3f N\n", 1e3 * in.position[0], in.jaw,
           felt);
    if (fabs(in.position[0] - 15e-3) > 1e-9 || fabs(felt - wanted) > 1e-9) {
        return 1;
    }
    hardware.plugged = 0;
    if (turn(device, now + STEP, &in) != VBSS_OK ||
        vbss_device_get_error(device, 0, NULL, &text) != VBSS_OK) {
        return 1;
    }
    printf("unplugged: %s, emergency stop %s\n", text, in.stopped != 0 ? "latched" : "not latched");
    if (in.status != VBSS_DEVICE_STATUS_LOST || in.stopped == 0 || hardware.force[0] != 0.0) {
        return 1;
    }
    return vbss_device_destroy(device) == VBSS_OK && !hardware.open ? 0 : 1;
}

int main(void)
{
    (void)setlocale(LC_NUMERIC, "C"); /* numbers with a decimal point */
    vbss_context *context;
    if (vbss_context_create(NULL, &context) != VBSS_OK) {
        return 1;
    }
    int status = run(context);
    return vbss_context_destroy(context) == VBSS_OK ? status : 1;
}
