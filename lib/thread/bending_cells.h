/* Cells of bending: the places where rest curvature and bending memory act. */
#ifndef VBSS_THREAD_BENDING_CELLS_H
#define VBSS_THREAD_BENDING_CELLS_H

#include "thread/thread.h"

/* A cell. Its curvature is the turn from one chord to the next, or to a clamp's direction, over its
 * length. `before` and `after`: whether the chords on either side of the node take part. */
typedef struct bending_cell {
    vec3 turn;
    double length;
    bool before, after;
} bending_cell;

/* Fills in the cells of a node with the nodes at `x`: one around an inner node, two half cells at a
 * clamp, none at a free end. Returns their number. */
int vbss_thread_bending_cells(const thread_object *t, const vec3 *x, uint32_t node,
                              bending_cell cells[2]);

#endif
