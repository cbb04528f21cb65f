#include "scenes/servo_wall.h"

#include <vblast_ss/device.h>
#include <vblast_ss/haptics.h>

#include "base/elementary.h"
#include "base/error.h"
#include "base/linear.h"
#include "scenes/stand_in_worlds.h"

enum { ROUND = 500, ROUNDS = 10, MEASURED = 5 }; /* ticks of 1 ms */
static const double reach = 5e-3,
                    grip = 200.0; /* m, N/m: of the hand's will, and how firmly it wants it */

typedef struct host {
    servo_wall *wall;
    vbss_device *device;
    vbss_device_input input;
    vbss_output_command command;
    vbss_device_coupling coupling;
    vbss_result result; /* the first failure */
} host;

/* The tool follows the hand freely, and stops at the wall, which stands at x = 0. */
static void solve(host *h)
{
    for (int i = 0; i < 3; i++) {
        h->coupling.position[i] = h->input.position[i];
        h->coupling.velocity[i] = h->input.velocity[i];
    }
    if (h->input.position[0] < 0.0) {
        h->coupling.position[0] = h->coupling.velocity[0] = 0.0;
    }
    h->coupling.stiffness = h->wall->stiffness;
    h->coupling.damping = h->wall->damping;
}

static vbss_result read_in(host *h, double now)
{
    VBSS_TRY(vbss_device_read(h->device, now, &h->input, sizeof h->input));
    solve(h);
    return VBSS_OK;
}

static vbss_result write_out(host *h, double now)
{
    if (h->wall->arrangement != SERVO_FORWARDED) {
        return vbss_device_write_coupled(h->device, now, &h->command, &h->coupling, NULL, 0);
    }
    for (int i = 0; i < 3; i++) {
        h->command.force[i] =
            h->coupling.stiffness * (h->coupling.position[i] - h->input.position[i]) +
            h->coupling.damping * (h->coupling.velocity[i] - h->input.velocity[i]);
    }
    return vbss_device_write(h->device, now, &h->command, NULL, 0);
}

static void keep(host *h, vbss_result result)
{
    h->result = h->result == VBSS_OK ? result : h->result;
}

static void step_inside(void *user, double now)
{
    host *h = user;
    if (h->device != NULL) {
        keep(h, read_in(h, now));
        keep(h, write_out(h, now));
    }
}

/* Between two ticks: a host beside that has `lag` ticks from what it read to what it writes. */
static void step_beside(host *h, int tick)
{
    const servo_wall *w = h->wall;
    const double now = (double)tick / 1000.0;
    int phase = tick % w->period;
    if (phase == w->lag % w->period && tick > w->lag) {
        keep(h, write_out(h, now));
    }
    if (phase == 0) {
        keep(h, read_in(h, now));
    }
}

static void move_hand(const stand_in_hd_table *hd, const servo_wall *w, int tick)
{
    stand_in_hand hand = {.mass = w->mass, .stiffness = grip, .damping = w->arm_damping};
    hand.target[0] = w->away + reach * vbss_cos(6.283185307179586 * tick / ROUND);
    hd->set_hand(0, &hand);
}

static void run(const stand_in_hd_table *hd, host *h)
{
    servo_wall *w = h->wall;
    stand_in_arm now, begin = {.work = 0.0};
    w->deepest = 0.0;
    for (int tick = 1; tick <= ROUND * ROUNDS; tick++) {
        move_hand(hd, w, tick);
        hd->tick(1);
        if (w->arrangement != SERVO_INSIDE) {
            step_beside(h, tick);
        }
        hd->look(0, &now);
        begin = tick == ROUND * (ROUNDS - MEASURED) ? now : begin;
        w->deepest = vbss_max(w->deepest, -now.position[0]);
    }
    w->gained = (now.work - begin.work) / MEASURED;
    w->cpu_worst = now.cpu_worst;
}

static vbss_result open_and_run(vbss_context *context, const char *library, host *h,
                                const stand_in_hd_table *hd)
{
    vbss_openhaptics_config arms;
    vbss_openhaptics *openhaptics;
    vbss_device_adapter adapter;
    vbss_device_config config;
    vbss_output_config output;
    VBSS_TRY(vbss_openhaptics_config_init(&arms, sizeof arms));
    VBSS_TRY(vbss_output_config_init(&output, sizeof output));
    VBSS_TRY(vbss_device_config_init(&config, sizeof config));
    VBSS_TRY(vbss_device_adapter_init(&adapter, sizeof adapter));
    VBSS_TRY(vbss_output_command_init(&h->command, sizeof h->command));
    VBSS_TRY(vbss_device_coupling_init(&h->coupling, sizeof h->coupling));
    output.input_timeout = output.command_timeout = 0.02; /* slow hosts are looked at, too */
    arms.library = library;
    arms.output = config.output = &output;
    arms.tick = h->wall->arrangement == SERVO_INSIDE ? step_inside : NULL;
    arms.user = h;
    VBSS_TRY(vbss_openhaptics_create(context, &arms, &openhaptics));
    h->result = vbss_openhaptics_get_adapter(openhaptics, 0, &adapter);
    keep(h, vbss_device_create(context, &adapter, NULL, &config, &h->device));
    if (h->result == VBSS_OK) {
        run(hd, h);
    }
    VBSS_TRY(vbss_device_destroy(h->device));
    h->device = NULL; /* the servo still ticks */
    VBSS_TRY(vbss_openhaptics_destroy(openhaptics));
    return h->result;
}

vbss_result servo_wall_run(vbss_context *context, const char *library, servo_wall *wall)
{
    const stand_in_hd_table *world = stand_in_arms_of(library);
    const char *first;
    if (world == NULL) {
        return VBSS_ERROR_DEVICE;
    }
    world->reset(0);
    host h = {.wall = wall};
    const double there[3] = {wall->away + reach, 0.0, 0.0};
    world->place(0, there, NULL);
    vbss_result result = open_and_run(context, library, &h, world);
    wall->illegal = world->illegal(&first);
    return result;
}
