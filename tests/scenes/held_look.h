/* Where a tied knot begins and ends along its thread, and what its loop bears. For held_knot.c. */
#ifndef VBSS_TESTS_SCENES_HELD_LOOK_H
#define VBSS_TESTS_SCENES_HELD_LOOK_H

#include "scenes/held_knot.h"

/* A thread as it is now, until the next step. */
typedef struct held_line {
    uint32_t nodes;
    const vec3 *x;
    double arc[KNOT_NODES]; /* of the nodes, m */
} held_line;
vbss_result held_look_line(const tied_knot *knot, held_line *line);

/* The edges by what touches. `known`: they are those of the step before, and what tails touch well outside of them
 * does not count. False when nothing touches; then the edges stay. */
vbss_result held_look(const tied_knot *knot, bool known, held_knot_edges *edges, bool *touches);
/* Of the loop beside the knot, N. */
vbss_result held_look_tension(const tied_knot *knot, const held_knot_edges *edges, double *tension);
/* Of the nodes in the knot. */
vbss_result held_look_middle(const tied_knot *knot, const held_knot_edges *edges, vec3 *middle);

#endif
