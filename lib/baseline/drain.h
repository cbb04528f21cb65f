/* The drain of VBLaST-SS (Qi et al. 2017): a spring ties each particle to its rest position.
 * docs/explanation/paper-drain.md lists the points that the paper leaves open. */
#ifndef VBSS_BASELINE_DRAIN_H
#define VBSS_BASELINE_DRAIN_H

#include "drain/drain.h"

typedef struct baseline_drain {
    vec3 *rest;           /* per node: fixed end of its spring in the world, m */
    double *free_mass;    /* per node, kg; 0: pinned */
    double *mobility;     /* per node: velocity by a unit impulse, 1/kg; 0: pinned */
    double explicit_step; /* size of a substep in the last step, s */
    double last_move;     /* largest displacement of a node in a substep of this step, m */
} baseline_drain;

/* ---- drain_step.c */

/* Moves the drain by a step of h seconds, without contacts. Returns VBSS_ERROR_NOT_FINITE if the
 * state is not finite; the caller then restores it. */
vbss_result vbss_baseline_move_drain(drain_object *d, double h);
/* Finishes the step after contacts have moved free nodes: commits the attachments and computes
 * the reactions. */
void vbss_baseline_finish_drain(drain_object *d);

#endif
