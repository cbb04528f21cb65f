/* Pure bending: a weightless thread between two clamps, which bend it into a circle in the x-y plane. */
#ifndef VBSS_TESTS_THREAD_BEND_RIG_H
#define VBSS_TESTS_THREAD_BEND_RIG_H

#include "thread/rig.h"

enum { BEND_SEGMENTS = 40 };
#define BEND_LENGTH 0.03    /* m */
#define BEND_STIFFNESS 1e-8 /* N m^2 */

typedef struct bend_rig {
    rig r;
    uint32_t clamps[2];
    double curvature; /* 1/m */
    bool has_arcs;    /* the length of a segment is that of its arc */
} bend_rig;

/* The default thread without weight, with drag, of BEND_LENGTH. */
vbss_thread_config bend_config(vbss_thread_bending bending);
/* A straight thread, clamped at both ends. The rig must stay where it is until its end. */
void bend_begin(bend_rig *b, const vbss_thread_config *config);
void bend_end(bend_rig *b);
/* Bends at a constant rate to a curvature, in `steps` steps of `h` seconds. */
void bend_to(bend_rig *b, double curvature, uint32_t steps, double h);
/* Angle between the clamps, rad. */
double bend_angle(const bend_rig *b);
/* Moment that the far clamp needs, N m; positive if it bends towards positive curvature. */
double bend_moment(bend_rig *b);
/* Frees the far end. */
void bend_release(bend_rig *b);
/* Component of a field of curvature vectors at a node towards the centre of a circle of positive
 * curvature, 1/m. */
double bend_component(bend_rig *b, vbss_thread_field field, uint32_t node);

#endif
