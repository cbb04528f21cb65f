#include "trainer/grip.h"

#include <math.h>
#include <string.h>

#include "throw/rig.h"

#define JOIN_SPEED 0.15  /* m/s, of a tool that comes to its hand */
#define JOINED 0.5e-3    /* m */
#define STIFFNESS 400.0  /* of the coupling to the hand, N/m */
#define DAMPING 1.0      /* N s/m */
#define BUTTON_SPEED 4.0 /* of the opening, 1/s */

/* Buttons of an arm. The first closes the jaws or, where a handle does, exchanges the tool. */
enum { CLOSES = 1, EXCHANGES = 1, CLUTCHES = 2 };

void grip_begin(grip *g, const double at[3])
{
    memset(g, 0, sizeof *g);
    memcpy(g->reported, at, sizeof g->reported);
    g->opening = 1.0;
    g->has = g->wants = VBSS_GRASPER_KIND_NEEDLE_DRIVER;
}

/* ---- in */

/* The tool comes to the hand; from then on it is where the hand is, until that is lost. */
static void lead(grip *g, double h)
{
    const double *to = g->in.position;
    double displacement[3], length = 0.0;
    for (int i = 0; i < 3; i++) {
        displacement[i] = to[i] - g->reported[i];
        length += displacement[i] * displacement[i];
    }
    length = sqrt(length);
    g->joined = g->in.status != VBSS_DEVICE_STATUS_LOST && (g->joined || length < JOINED);
    double share = g->joined || length <= JOIN_SPEED * h ? 1.0 : JOIN_SPEED * h / length;
    for (int i = 0; i < 3; i++) {
        g->reported[i] += share * displacement[i];
    }
}

static double find_opening(grip *g, double h)
{
    if ((g->in.valid & VBSS_DEVICE_HAS_JAW) != 0) {
        return g->in.jaw;
    }
    double wanted = (g->in.buttons & g->let_go & CLOSES) != 0 ? 0.0 : 1.0,
           largest = BUTTON_SPEED * h;
    g->opening += smaller(larger(wanted - g->opening, -largest), largest);
    return g->opening;
}

/* A device that tells its tool has told another, or the button is pressed. */
static void find_tool(grip *g)
{
    uint32_t down = g->in.buttons & g->let_go, pressed = down & ~g->held;
    bool by_button = (g->in.valid & VBSS_DEVICE_HAS_JAW) != 0 && (pressed & EXCHANGES) != 0;
    bool reported = (g->in.events & VBSS_DEVICE_EVENT_TOOL) != 0;
    bool shears =
        reported ? g->in.tool == VBSS_DEVICE_TOOL_SHEARS : g->has != VBSS_GRASPER_KIND_SHEARS;
    g->held = down;
    g->exchanges = reported || by_button;
    if (g->exchanges) {
        g->wants = shears ? VBSS_GRASPER_KIND_SHEARS : VBSS_GRASPER_KIND_NEEDLE_DRIVER;
    }
}

vbss_result grip_read(grip *g, vbss_device *device, double now, double h, bool *known)
{
    TRY(vbss_device_read(device, now, &g->in, sizeof g->in));
    *known = g->in.status != VBSS_DEVICE_STATUS_WAITING;
    if (!*known) {
        return VBSS_OK;
    }
    g->let_go |= ~g->in.buttons;
    TRY(vbss_device_set_clutch(device, (g->in.buttons & g->let_go & CLUTCHES) != 0));
    lead(g, h);
    g->jaw = find_opening(g, h);
    find_tool(g);
    return VBSS_OK;
}

/* ---- out */

double grip_late(vbss_scene *scene, double h)
{
    vbss_scene_statistics c;
    bool known = vbss_scene_get_statistics(scene, &c, sizeof c) == VBSS_OK;
    return known ? h * c.behind : 0.0;
}

vbss_result grip_write(grip *g, vbss_device *device, double now, const vbss_grasper_state *tool,
                       double late)
{
    vbss_output_command command;
    vbss_device_coupling coupling;
    vbss_output_result out;
    g->has = tool->kind;
    TRY(vbss_output_command_init(&command, sizeof command));
    TRY(vbss_device_coupling_init(&coupling, sizeof coupling));
    if (g->joined) {
        command.solenoid = tool->solenoid;
        for (int k = 0; k < 3; k++) {
            coupling.position[k] = tool->position[k] + late * tool->velocity[k];
        }
        memcpy(coupling.velocity, tool->velocity, sizeof coupling.velocity);
        coupling.stiffness = STIFFNESS;
        coupling.damping = DAMPING;
        TRY(vbss_device_write_coupled(device, now, &command, &coupling, &out, sizeof out));
    } else {
        TRY(vbss_device_write(device, now, &command, &out, sizeof out));
    }
    g->wanted = command.solenoid;
    g->on = out.solenoid;
    g->force = sqrt(out.force[0] * out.force[0] + out.force[1] * out.force[1] +
                    out.force[2] * out.force[2]);
    return VBSS_OK;
}
