/* The drain of VBLaST-SS (Qi et al. 2017): particles tied to their rest positions by a spring each. docs/paper-drain.md tells
 * what the paper leaves open. */
#ifndef VBSS_BASELINE_DRAIN_H
#define VBSS_BASELINE_DRAIN_H

#include "drain/drain.h"

typedef struct baseline_drain {
    vec3 *rest;           /* per node: the end of its spring that does not move, m, in the world */
    double *free_mass;    /* per node, kg; 0: pinned */
    double *mobility;     /* per node: velocity for a unit of impulse, 1/kg; 0: pinned */
    double explicit_step; /* of the last step, s */
    double last_move; /* the farthest that a node has moved in an explicit step of this step, m */
} baseline_drain;

/* ---- drain_step.c */

/* All of a step of h seconds that may fail. */
vbss_result vbss_baseline_move_drain(drain_object *d, double h);
/* The end of a step, before which contacts may have moved nodes that no pin holds: attachments arrive, reactions. */
void vbss_baseline_finish_drain(drain_object *d);

#endif
