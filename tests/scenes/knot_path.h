/* The formulas of the knots' centre lines, in multiples of their size. For knots.c. */
#ifndef VBSS_TESTS_SCENES_KNOT_PATH_H
#define VBSS_TESTS_SCENES_KNOT_PATH_H

#include "scenes/knot_curve.h"
#include "scenes/knots.h"

/* In thread radii: below it strands of a throw come nearer than 1.3 diameters. */
#define KNOT_LEAST_SIZE 5.5

/* From where the first tail ends to where the last begins, and the cylinder. */
void knot_path(const knot_shape *shape, knot_curve *curve, knot_line *line);

/* Half hitches, with the loop's radius, and where along x its centre is. */
void knot_path_hitches(const knot_shape *shape, double loop_radius, knot_curve *curve,
                       double *cylinder_x);

#endif
