/* One rigid body alone in a system, stepped as bodies are; and a fine integration to compare it with. */
#ifndef VBSS_TESTS_RIGID_RIG_H
#define VBSS_TESTS_RIGID_RIG_H

#include "harness/harness.h"
#include "solver/rigid.h"

typedef struct rigid_rig {
    vbss_rigid body;
    vec3 force, torque; /* from outside, in the world */
    double h;
    uint32_t rounds; /* linearisations in a part */
    uint32_t parts;  /* of a step, all alike */

    harness_memory memory;
    vbss_context *context;
    vbss_system *system;
    vbss_rigid_blocks blocks;
    vbss_rigid_substep part;     /* the last one */
    vbss_rigid_motion predicted; /* in it */
} rigid_rig;

/* A body of different moments at rest at the origin, free; 1 ms, one part, one linearisation. */
void rigid_rig_begin(rigid_rig *rig, vbss_role role);
void rigid_rig_end(rigid_rig *rig);
/* Puts the body and the given pose there, at rest. */
void rigid_rig_place(rigid_rig *rig, pose at);
/* A step, in which the given pose goes to `end`. */
void rigid_rig_step(rigid_rig *rig, pose end);
/* Steps with the given pose where it is. */
void rigid_rig_steps(rigid_rig *rig, uint32_t count);

/* Condense, and all that follows it. */
void rigid_rig_solve(vbss_system *system);

double rigid_energy(const vbss_rigid *body);
/* The length of the turn from one orientation to another. */
double rigid_turn(quat from, quat to);
pose rigid_draw_pose(harness_source *source, double size);
/* Any body: moments of a cloud of masses, sizes over some decades. */
void rigid_draw_mass(harness_source *source, vbss_rigid *body);

/* The same motion of rotation by Runge and Kutta's method in the body's own axes, in `count` steps in all:
 * under a constant torque in the world, and the virtual coupling to a pose at rest (rigid->end). */
vbss_rigid_motion rigid_fine(const vbss_rigid *body, vec3 torque, double time, uint32_t count);

#endif
