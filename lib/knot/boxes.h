/* Integer bounding boxes, eight in SIMD lanes.
 *
 * Coordinates are rounded to a grid by a non-decreasing function, the same for all. Rounding
 * therefore preserves order: if two integer boxes are disjoint, so are their contents, however
 * coarse the grid is. */
#ifndef VBSS_KNOT_BOXES_H
#define VBSS_KNOT_BOXES_H

#include <stddef.h>
#include <stdint.h>

#include "base/linear.h"

enum { KNOT_BOX_LANES = 8, KNOT_BOX_GROUP = 6 * KNOT_BOX_LANES, KNOT_BOX_MAX = 32767 };

/* ---- the grid */

typedef struct box_grid {
    double origin[3], scale[3];
} box_grid;

static inline int16_t box_coordinate(double x, double origin, double scale)
{
    double n = (x - origin) * scale;
    return (int16_t)(n > -KNOT_BOX_MAX ? (n < KNOT_BOX_MAX ? n : KNOT_BOX_MAX) : -KNOT_BOX_MAX);
}

static inline void box_round(const box_grid *grid, vec3 x, int16_t corner[4])
{
    corner[0] = box_coordinate(x.x, grid->origin[0], grid->scale[0]);
    corner[1] = box_coordinate(x.y, grid->origin[1], grid->scale[1]);
    corner[2] = box_coordinate(x.z, grid->origin[2], grid->scale[2]);
    corner[3] = 0;
}

static inline void box_grid_axis(box_grid *grid, int axis, double low, double high)
{
    double half = 0.5 * high - 0.5 * low;
    grid->origin[axis] = 0.5 * low + 0.5 * high;
    grid->scale[axis] = half > 1e-290 ? KNOT_BOX_MAX / half : 0.0;
}

/* ---- a single box */

typedef struct box {
    int16_t low[3], high[3];
} box;

static inline int16_t box_min(int16_t a, int16_t b)
{
    if (a < b) {
        return a;
    }
    return b;
}

static inline int16_t box_max(int16_t a, int16_t b)
{
    if (a > b) {
        return a;
    }
    return b;
}

static inline box box_empty(void)
{
    box b = {{KNOT_BOX_MAX, KNOT_BOX_MAX, KNOT_BOX_MAX},
             {-KNOT_BOX_MAX - 1, -KNOT_BOX_MAX - 1, -KNOT_BOX_MAX - 1}};
    return b;
}

static inline box box_hull(box a, box b)
{
    for (int i = 0; i < 3; i++) {
        a.low[i] = box_min(a.low[i], b.low[i]);
        a.high[i] = box_max(a.high[i], b.high[i]);
    }
    return a;
}

static inline box box_of_corners(const int16_t p[4], const int16_t q[4])
{
    box b;
    for (int i = 0; i < 3; i++) {
        b.low[i] = box_min(p[i], q[i]);
        b.high[i] = box_max(p[i], q[i]);
    }
    return b;
}

/* ---- groups of eight boxes: lower bounds in x, y, z, then upper bounds */

static inline void boxes_set(int16_t *groups, uint32_t i, box b)
{
    int16_t *at = groups + (size_t)(i / KNOT_BOX_LANES) * KNOT_BOX_GROUP + i % KNOT_BOX_LANES;
    for (size_t k = 0; k < 3; k++) {
        at[k * KNOT_BOX_LANES] = b.low[k];
        at[(3 + k) * KNOT_BOX_LANES] = b.high[k];
    }
}

static inline box boxes_get(const int16_t *groups, uint32_t i)
{
    const int16_t *at = groups + (size_t)(i / KNOT_BOX_LANES) * KNOT_BOX_GROUP + i % KNOT_BOX_LANES;
    box b;
    for (size_t k = 0; k < 3; k++) {
        b.low[k] = at[k * KNOT_BOX_LANES];
        b.high[k] = at[(3 + k) * KNOT_BOX_LANES];
    }
    return b;
}

/* Hull of all boxes of a group. */
static inline box boxes_hull(const int16_t *group)
{
    box b = boxes_get(group, 0);
    for (uint32_t i = 1; i < KNOT_BOX_LANES; i++) {
        b = box_hull(b, boxes_get(group, i));
    }
    return b;
}

/* ---- bit mask of the boxes of a group that overlap a box */

#if defined(__GNUC__) && defined(__SSE2__)

typedef int16_t box_lane __attribute__((vector_size(16)));
typedef char box_bytes __attribute__((vector_size(16)));
typedef struct box_query {
    box_lane low[3], high[3];
} box_query;

static inline box_query box_ask(box b)
{
    box_query q;
    for (int k = 0; k < 3; k++) {
        q.low[k] = (box_lane){0} + b.low[k];
        q.high[k] = (box_lane){0} + b.high[k];
    }
    return q;
}

static inline unsigned boxes_overlapping(const int16_t *group, const box_query *q)
{
    box_lane v[6];
    __builtin_memcpy(v, group, sizeof v);
    box_lane separated = (v[0] > q->high[0]) | (v[1] > q->high[1]) | (v[2] > q->high[2]) |
                         (v[3] < q->low[0]) | (v[4] < q->low[1]) | (v[5] < q->low[2]);
    box_bytes bytes = __builtin_ia32_packsswb128(separated, separated);
    return ~(unsigned)__builtin_ia32_pmovmskb128(bytes) & 0xffu;
}

#else

typedef struct box_query {
    box b;
} box_query;

static inline box_query box_ask(box b)
{
    box_query q = {b};
    return q;
}

static inline unsigned boxes_overlapping(const int16_t *group, const box_query *q)
{
    unsigned bits = 0;
    for (uint32_t i = 0; i < KNOT_BOX_LANES; i++) {
        unsigned meets = 1;
        for (uint32_t k = 0; k < 3; k++) {
            meets &= (unsigned)(group[k * KNOT_BOX_LANES + i] <= q->b.high[k]) &
                     (unsigned)(group[(3 + k) * KNOT_BOX_LANES + i] >= q->b.low[k]);
        }
        bits |= meets << i;
    }
    return bits;
}

#endif

/* Returns the index of the lowest set bit and clears it. */
static inline uint32_t box_pop_bit(uint64_t *bits)
{
    uint64_t b = *bits;
    *bits = b & (b - 1);
#if defined(__GNUC__)
    return (uint32_t)__builtin_ctzll(b);
#else
    uint32_t i = 0;
    while ((b >> i & 1u) == 0) {
        i++;
    }
    return i;
#endif
}

#endif
