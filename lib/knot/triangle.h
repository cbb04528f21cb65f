/* Triangle tests against many segments. */
#ifndef VBSS_KNOT_TRIANGLE_H
#define VBSS_KNOT_TRIANGLE_H

#include "base/linear.h"
#include "knot/tuning.h"

/* On which side of a plane: the sign of a determinant, where it is certain.
 *
 * A determinant of differences of coordinates in doubles is wrong by less than (7 + 56 e) e of the sum of the sizes of
 * its products, e = 2^-53 (bound A of J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust
 * Geometric Predicates", Discrete & Computational Geometry 18, 1997), and underflow adds less than KNOT_UNDERFLOW while
 * coordinates are below 1e100. Certain is here what exceeds KNOT_CLEARANCE of the product of the lengths, a million times as
 * much: a thread that lay in a plane would otherwise be left with strands an accident of rounding apart, which no
 * projection could tell. Where products overflow nothing is certain. */
#define KNOT_UNDERFLOW 1e-200

/* u x v for differences of coordinates, and the sums of the magnitudes of its products. */
typedef struct area {
    vec3 value, size;
} area;

static inline area area_of(vec3 u, vec3 v)
{
    double x1 = u.y * v.z, x2 = u.z * v.y, y1 = u.z * v.x, y2 = u.x * v.z, z1 = u.x * v.y,
           z2 = u.y * v.x;
    area r = {vec3_make(x1 - x2, y1 - y2, z1 - z2),
              vec3_make(fabs(x1) + fabs(x2), fabs(y1) + fabs(y2), fabs(z1) + fabs(z2))};
    return r;
}

/* Sign of w . (u x v), where w is a difference too; 0 if uncertain. */
static inline int clear_side(const area *a, vec3 w)
{
    double value = w.x * a->value.x + w.y * a->value.y + w.z * a->value.z;
    double size = (fabs(w.x) + fabs(w.y) + fabs(w.z)) * (a->size.x + a->size.y + a->size.z);
    double error = KNOT_CLEARANCE * size + KNOT_UNDERFLOW;
    return (value > error) - (value < -error);
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

/* Side of the triangle's plane; 0 if uncertain. */
static inline int knot_triangle_side(const knot_triangle *t, vec3 p)
{
    return clear_side(&t->plane, vec3_sub(p, t->a));
}

/* As vbss_knot_segment_misses_triangle, for a prepared triangle. */
bool vbss_knot_triangle_misses(const knot_triangle *t, vec3 p, vec3 q);

#endif
