/* A uniform cubic B-spline whose control points are put down by a pen, and its length. For knots.c. */
#ifndef VBSS_TESTS_SCENES_KNOT_CURVE_H
#define VBSS_TESTS_SCENES_KNOT_CURVE_H

#include <stdint.h>

#include "base/linear.h"

enum { KNOT_CURVE_POINTS = 2048 };

typedef struct knot_curve {
    double spacing; /* of control points, m, about */
    uint32_t count; /* of them */
    bool full;      /* more were asked for */
    vec3 points[KNOT_CURVE_POINTS];
    /* Set by knot_curve_finish: from the curve's beginning to that of each span, m. The curve runs from
     * the second control point to the last but one: it passes through both, as each lies in the middle of
     * its straight neighbours. */
    double arcs[KNOT_CURVE_POINTS];
} knot_curve;

void knot_curve_begin(knot_curve *curve, double spacing);
/* Pieces put down points from their first on, without their last: the next piece begins there. */
void knot_curve_straight(knot_curve *curve, vec3 from, vec3 to);
/* In the plane of x and z, about a centre, from one angle (rad, from x to z) to another. */
void knot_curve_arc(knot_curve *curve, vec3 centre, double radius, double from, double to);
/* `at` for t from 0 to 1; `length` m, about. */
void knot_curve_piece(knot_curve *curve, double length, vec3 (*at)(double t, const void *user),
                      const void *user);
/* A straight end, the last piece, with a first piece of the same kind: two spacings at least. */
void knot_curve_finish(knot_curve *curve, vec3 last);

double knot_curve_length(const knot_curve *curve);
/* The point at that length from the beginning; in a straight line beyond either end. */
vec3 knot_curve_at(const knot_curve *curve, double s);

#endif
