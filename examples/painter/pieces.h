/* Private to the painter: a scene in parts small enough to be sorted by depth. */
#ifndef VBSS_EXAMPLES_PAINTER_PIECES_H
#define VBSS_EXAMPLES_PAINTER_PIECES_H

#include "picture.h"

typedef struct drawing {
    bytes *to;
    view v;
    const shape *placed; /* in camera space */
    size_t count;
} drawing;

/* A flat shape, or what lies on a strand between two of its places. */
typedef struct piece {
    size_t first, last; /* shapes; flat: the same */
    double t0, t1;      /* from that fraction of the first to that of the last */
    int layer;          /* 0 beyond a floor, 1 the floors, 2 the rest */
    double depth;
    size_t order;
} piece;

/* The far ones first; NULL without memory. The caller frees them. */
piece *pieces_sorted(const drawing *d, size_t *count);

/* A way along a strand (to its end: step 1; to its beginning: -1), `length` metres or as far as it
 * or the room goes, from fraction t of a shape. Returns how many points it takes, the place where it
 * begins left out; ended (may be NULL): whether the strand ended at once. */
int pieces_walk(const drawing *d, const shape *s, double t, int step, double length, vec *points,
                int room, bool *ended);

/* Writes a piece of a strand of capsules (strokes.c). */
void strokes_put(const drawing *d, const piece *part);

#endif
