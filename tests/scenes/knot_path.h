/* The formulas of the knots' centre lines, in multiples of their size. For knots.c and throw_stack.c. */
#ifndef VBSS_TESTS_SCENES_KNOT_PATH_H
#define VBSS_TESTS_SCENES_KNOT_PATH_H

#include "scenes/knot_curve.h"
#include "scenes/knots.h"

/* In thread radii: below it strands of a throw come nearer than 1.3 diameters. */
#define KNOT_LEAST_SIZE 5.5
/* In sizes: of control points. */
#define KNOT_PATH_SPACING 0.2

enum { KNOT_PILE_THROWS = 8 };

/* wraps[i] of throw i from the bottom, 0: a mere crossing; signs: +1 right-handed. */
typedef struct knot_pile {
    uint32_t throws;
    int wraps[KNOT_PILE_THROWS], signs[KNOT_PILE_THROWS];
} knot_pile;

/* From where the first tail ends to where the last begins, and the cylinder. */
void knot_path(const knot_shape *shape, knot_curve *curve, knot_line *line);

/* At least one throw; below them a loop of that radius, whose middle is the middle of the curve. */
void knot_path_pile(const knot_pile *pile, double size, double radius, knot_curve *curve);
/* The same as a part of a longer curve, which goes on at the point returned; the pile begins opposite to it. */
vec3 knot_path_put_pile(const knot_pile *pile, double size, double radius, knot_curve *curve);

/* Half hitches, with the loop's radius, and where along x its centre is. */
void knot_path_hitches(const knot_shape *shape, double loop_radius, knot_curve *curve,
                       double *cylinder_x);

#endif
