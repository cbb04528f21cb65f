/* A shape that moves as in tests/fixtures/moving_shapes.h, or as a knot does, with the positions of all
 * steps worked out beforehand. */
#ifndef VBSS_BENCH_COLLISION_MOVING_H
#define VBSS_BENCH_COLLISION_MOVING_H

#include <stdbool.h>
#include <stdint.h>

#include "fixtures/moving_shapes.h"

#define MOVING_RADIUS MOVING_SHAPES_RADIUS /* of the thread, m */

typedef enum moving_kind {
    MOVING_COIL, /* the thread of moving_shapes: wound, each turn near the next */
    MOVING_KNOT  /* a thread tied into a trefoil, slowly pulled tight, in trembling hands */
} moving_kind;

typedef struct moving {
    uint32_t segments, steps;
    double length;     /* of a segment at rest, m */
    double *positions; /* steps + 1 times segments + 1 nodes, 3 doubles each, m */
} moving;

bool moving_make(moving *m, moving_kind kind, uint32_t segments, uint32_t steps);
void moving_release(moving *m);
/* Of a step; its motion goes on to those of the next. */
const double *moving_at(const moving *m, uint32_t step);
/* The box of a segment swept over a step, inflated by the radius. */
void moving_box(const moving *m, uint32_t step, uint32_t segment, double low[3], double high[3]);

#endif
