/* A device's hand on a tool: the tool comes to the hand, is led by it, and is felt. One slot of a millisecond: grip_read, the
 * scene's step, grip_write. */
#ifndef VBSS_EXAMPLES_TRAINER_GRIP_H
#define VBSS_EXAMPLES_TRAINER_GRIP_H

#include <stdbool.h>

#include <vblast_ss/device.h>
#include <vblast_ss/grasper.h>
#include <vblast_ss/scene.h>

typedef struct grip {
    vbss_device_input in;         /* as read last */
    double reported[3];           /* to the tool, m */
    double jaw;                   /* the same */
    double opening;               /* of a handle that is the arm's button */
    uint32_t let_go;              /* buttons that were up once: one that is stuck does not count */
    uint32_t held;                /* buttons that were down in the slot before, of those */
    vbss_grasper_kind has, wants; /* which tool it is; shall be, */
    bool exchanges;               /* from now on */
    bool joined;                  /* the tool has come to the hand */
    double force;                 /* that goes out, N */
    uint32_t wanted, on;          /* solenoid: by the tool; let through by the output stage */
} grip;

/* The tool begins there. */
void grip_begin(grip *g, const double at[3]);
/* False in `known`: there was no pose yet; the tool is to stay where it is. */
vbss_result grip_read(grip *g, vbss_device *device, double now, double h, bool *known);
/* So much bodies are behind after a step of h (vbss_solver_options::call_budget_us), s. */
double grip_late(vbss_scene *scene, double h);
/* `late`: the tool is where it was so long ago, s; it is put out where it has got to by now with its velocity. */
vbss_result grip_write(grip *g, vbss_device *device, double now, const vbss_grasper_state *tool,
                       double late);

#endif
