/* A triangle that many segments are asked about. */
#ifndef VBSS_KNOT_TRIANGLE_H
#define VBSS_KNOT_TRIANGLE_H

#include "knot/orientation.h"

/* What counts as certain in a triangle's tests, a share of the size of products: far above rounding, for a thread that
 * lay in a plane would be left with strands an accident of rounding apart, which no projection could tell. */
#define KNOT_CLEARANCE 1e-9

/* As area_side, with room to spare. */
static inline int clear_side(const area *a, vec3 w)
{
    double value = w.x * a->value.x + w.y * a->value.y + w.z * a->value.z;
    double size = (fabs(w.x) + fabs(w.y) + fabs(w.z)) * (a->size.x + a->size.y + a->size.z);
    return certain_sign(value, KNOT_CLEARANCE * size + ORIENTATION_UNDERFLOW);
}

typedef struct knot_triangle {
    vec3 a, b, c;
    area plane; /* (b - a) x (c - a) */
} knot_triangle;

static inline knot_triangle knot_triangle_make(vec3 a, vec3 b, vec3 c)
{
    knot_triangle t = {a, b, c, area_of(vec3_sub(b, a), vec3_sub(c, a))};
    return t;
}

/* On which side of its plane; 0: not certain. */
static inline int knot_triangle_side(const knot_triangle *t, vec3 p)
{
    return clear_side(&t->plane, vec3_sub(p, t->a));
}

/* vbss_knot_misses of that triangle. */
bool vbss_knot_triangle_misses(const knot_triangle *t, vec3 p, vec3 q);

#endif
