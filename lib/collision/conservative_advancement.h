/* Bounds and types of conservative advancement, shared by the scalar code and the SIMD code. */
#ifndef VBSS_COLLISION_CONSERVATIVE_ADVANCEMENT_H
#define VBSS_COLLISION_CONSERVATIVE_ADVANCEMENT_H

#include "collision/collision.h"
#include "collision/tuning.h"

/* Vertices 1, 2 and 3 of a query relative to vertex 0. */
typedef struct collision_relative_motion {
    vec3 start[3], end[3];
    double size; /* largest magnitude of a coordinate */
} collision_relative_motion;

static inline vec3 relative_at(const collision_relative_motion *m, int vertex, double t)
{
    return vec3_add_scaled(m->start[vertex], t, vec3_sub(m->end[vertex], m->start[vertex]));
}

/* Rounding of the volume of the four vertices as a share of the product of their largest coordinates,
 * and its smallest value without underflow: docs/explanation/collision-proof.md. */
#define VOLUME_ROUNDING (32.0 * DBL_EPSILON)
#define VOLUME_UNDERFLOW 1e-290

typedef struct conservative_bounds {
    /* a direction that separates the features by this proves a distance above D */
    double clearance;
    double near_square;     /* features closer than the root of this are a hit */
    double rounding_square; /* shorter vectors than the root of this have no direction */
} conservative_bounds;

/* The least tolerance, as a share of size and D; and below which share of the size a vector is all rounding. */
#define MIN_TOLERANCE (128.0 * DBL_EPSILON)
#define ROUNDING_FRACTION (16.0 * DBL_EPSILON)
/* With D = 0: fourth powers of lengths might underflow below this size. */
#define TINY_SIZE 1e-50

static inline uint32_t conservative_pass_limit(uint32_t limit, double thickness)
{
    return thickness == 0.0 && limit > COLLISION_ZERO_PASS_LIMIT ? COLLISION_ZERO_PASS_LIMIT
                                                                 : limit;
}

/* `size` is the largest coordinate of the query relative to its first vertex.
 * docs/explanation/collision-proof.md proves that all rounding errors stay below half of the tolerance. */
static inline conservative_bounds conservative_bounds_of(double tolerance, double thickness,
                                                         double size)
{
    double min_tolerance = MIN_TOLERANCE * (size + thickness), wanted = tolerance * thickness;
    double whole = wanted < min_tolerance ? min_tolerance : wanted;
    double near = thickness + COLLISION_HIT_FRACTION * whole;
    /* Nothing can be proved at this size; everything is left to exact arithmetic. */
    bool tiny = thickness == 0.0 && size < TINY_SIZE;
    double rounding = ROUNDING_FRACTION * size;
    conservative_bounds bounds = {thickness + 0.5 * whole, tiny ? DBL_MAX : near * near,
                                  rounding * rounding};
    return bounds;
}

/* Proves that the features never meet, with zero thickness. False means that nothing is known. */
bool vbss_collision_proves_separation(const collision_ccd_query *query);

#endif
