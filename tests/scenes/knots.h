/* Loose knots as centre lines by formula, the same for tests, bench and examples.
 *
 * Frame: the first throw lies at the origin along the x axis, throws are stacked along +z, the cylinder
 * (if any) lies below, its axis along y. Both ends leave straight, node 0 towards -x and the last node
 * towards +x (half hitches: see there), so that pulling them apart tightens the knot.
 *
 * A throw of k wraps is two strands that turn about each other by 2 k + 1 half turns; closed, it is the
 * torus knot T(2, 2 k + 1). The curve is a uniform cubic B-spline with control points on these formulas:
 * its curvature is continuous, and it is straight in the tails. */
#ifndef VBSS_TESTS_SCENES_KNOTS_H
#define VBSS_TESTS_SCENES_KNOTS_H

#include <vblast_ss/base.h>

#include "base/linear.h"

typedef enum knot_kind {
    KNOT_LOOP,            /* a turn whose ends cross: no knot */
    KNOT_OVERHAND,        /* one throw, one wrap: 3_1; round a cylinder the half knot */
    KNOT_DOUBLE_OVERHAND, /* one throw, two wraps: 5_1; the surgeon's first throw */
    KNOT_SQUARE,          /* 1=1: 3_1 # m3_1 */
    KNOT_GRANNY,          /* 1x1: 3_1 # 3_1 */
    KNOT_SURGEON,         /* 2=1: 5_1 # m3_1 */
    KNOT_FLS,             /* 2=1=1: 5_1 # m3_1 # 3_1 */
    /* Of the tail round the straight standing part, node 0 at the tail's end. Both turns alike (a clove
     * hitch): the granny's type; reversed (a cow hitch): the square's. */
    KNOT_HALF_HITCHES,
    KNOT_REVERSED_HALF_HITCHES,
    KNOT_KINDS
} knot_kind;
extern const char *const knot_names[KNOT_KINDS];

typedef enum knot_rest {
    KNOT_REST_ARCS, /* length of the curve between nodes: for threads that measure the arc */
    KNOT_REST_CHORDS /* distance of the nodes: for polylines; their sum is a little less than length */
} knot_rest;

typedef struct knot_shape {
    knot_kind kind;
    bool mirrored;          /* the first throw is left-handed */
    bool cylinder;          /* tied round one, else free */
    double cylinder_radius; /* m; default 2.5 mm */
    double thread_radius;   /* m; default 0.125 mm */
    /* m; the curve bends with radii above it, strands lie half of it apart; default 1 mm, at least 5.5
     * thread radii: change both together */
    double size;
    double length; /* of the curve, m; default 150 mm */
    double tail;   /* of it before the knot, m; 0 (default): as much as after it */
    /* Segments of the finest length in the knot, growing by at most the ratio to the coarsest in the
     * tails, m; defaults 0.3 mm, 2 mm, 1.25. With finest = coarsest all segments have one length. */
    double finest, coarsest, ratio;
    knot_rest rest; /* default KNOT_REST_ARCS */
} knot_shape;

/* What was made; the arrays are the caller's. */
typedef struct knot_line {
    uint32_t node_count;
    uint32_t knot_first, knot_last;    /* nodes; all that is not straight lies between them */
    double knot_length;                /* of the curve between the tails, m */
    vec3 cylinder_begin, cylinder_end; /* its axis, as long as the knot needs; equal when free */
    double cylinder_radius;            /* 0 when free */
} knot_line;

/* Enough for all kinds with the defaults. */
enum { KNOT_NODES = 640 };

/* The defaults of a kind; change what you need. */
void knot_shape_init(knot_shape *shape, knot_kind kind);
/* Fills `capacity` positions and as many rest lengths at most (one less than nodes is used).
 * VBSS_ERROR_CAPACITY with node_count set when they are too few; VBSS_ERROR_OUT_OF_RANGE when the length
 * is too short for the knot, or the shape makes no sense. */
vbss_result knot_make(const knot_shape *shape, uint32_t capacity, vec3 *positions,
                      double *rest_lengths, knot_line *line);

#endif
