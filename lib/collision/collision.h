/* Collision: continuous tests of two features, and the search for pairs to test.
 *
 * Closest points are in closest.h and closest.c. One continuous test uses one of three methods, which ccd.c chooses:
 * conservative_advancement.c, ccd_cubic.c, or that of lib/baseline. Without thickness conservative advancement also needs
 * ccd_crossing.c and ccd_exact.c, which use polynomials.c and integers.c. ccd_batch.c and ccd_simd.c make many tests at once.
 * Shapes are in shapes.c, aabb.c and bvh.c. The broad phase finds candidates (broad_phase.c, bvh_traversal.c), and the
 * narrow phase tests them (narrow_phase.c). The object owns all of these (object.c, batch.c, views.c, snapshot.c).
 *
 * Vertices: a0 a1 b0 b1 of two edges; the point and b0 b1 b2 of a triangle. They move evenly from
 * start (time 0) to end (time 1). D is the contact distance. */
#ifndef VBSS_COLLISION_COLLISION_H
#define VBSS_COLLISION_COLLISION_H

#include <stddef.h>

#include <vblast_ss/collision.h>

#include "base/config.h"
#include "base/linear.h"

/* ---- checks of arguments (ccd.c) */
#define COLLISION_MAX_COORDINATE 1e30 /* coordinates and D, m: products of six stay finite */
#define COLLISION_MIN_THICKNESS 1e-30 /* D, unless zero */
/* VBSS_ERROR_OUT_OF_RANGE unless D is zero or in its range. */
vbss_result vbss_collision_check_thickness(vbss_context *context, double thickness);
/* VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FINITE, or VBSS_ERROR_OUT_OF_RANGE beyond
 * COLLISION_MAX_COORDINATE. */
vbss_result vbss_collision_check_coordinates(vbss_context *context, const double *values,
                                             size_t count, const char *name);

/* ---- one query */

typedef struct collision_ccd_options collision_ccd_options;
typedef struct collision_ccd_query collision_ccd_query;
typedef struct collision_ccd_result collision_ccd_result;
typedef struct collision_counters collision_counters;

/* Checked options of a test. */
typedef struct collision_ccd_method {
    /* Counts passes, exact and sign_tests_ended only. `result` comes as a miss. */
    void (*test_pair)(const collision_ccd_options *options, const collision_ccd_query *query,
                      collision_ccd_result *result, collision_counters *counters);
    vbss_collision_decision miss_decision; /* what a miss is worth */
    bool has_lanes;                        /* ccd_batch.c can test four pairs at a time */
} collision_ccd_method;
extern const collision_ccd_method vbss_baseline_ccd; /* defined in lib/baseline */

/* What a test needs to know, checked. */
struct collision_ccd_options {
    const collision_ccd_method *method;
    uint32_t pass_limit;
    double tolerance; /* relative to D */
    /* Baseline: edges are parallel when |a|^2 |b|^2 - (a.b)^2 is below parallel_threshold length_unit^4; m. */
    double parallel_threshold, length_unit;
    /* Workspace of the exact predicate: ccd_exact.h. */
    uint32_t *limbs;
    uint32_t limb_count;
};
/* The first number has been enough for all doubles so far. The second one fits on a stack; it is enough
 * if the bits of the coordinates spread over some 250 binary places. */
enum { COLLISION_LIMBS = 16384, COLLISION_STACK_LIMBS = 2900 };

struct collision_ccd_query {
    vbss_collision_pair_kind kind;
    double thickness; /* contact distance D, m */
    vec3 start[4], end[4];
};

/* Result as in vbss_collision_impact, without the points. For a miss all fields are zero except time = 1. */
struct collision_ccd_result {
    int32_t hit;
    vbss_collision_decision decision;
    uint32_t passes;
    double time, distance;
    vec3 normal;
    double weights[4];
};

struct collision_counters {
    uint64_t queries, hits, undecided, exact, passes, sign_tests_ended;
};

/* Runs the selected method and counts it (ccd.c). */
void vbss_collision_run_ccd(const collision_ccd_options *options, const collision_ccd_query *query,
                            collision_ccd_result *result, collision_counters *counters);
/* One method each. They count only passes, exact and sign_tests_ended. *result must be initialised
 * as a miss. */
void vbss_collision_run_conservative(const collision_ccd_options *options,
                                     const collision_ccd_query *query, collision_ccd_result *result,
                                     collision_counters *counters);
void vbss_collision_run_cubic(const collision_ccd_options *options,
                              const collision_ccd_query *query, collision_ccd_result *result,
                              collision_counters *counters);
static inline collision_ccd_result vbss_collision_ccd_miss(vbss_collision_decision decision)
{
    collision_ccd_result miss = {.decision = decision, .time = 1.0};
    return miss;
}
static inline void vbss_collision_count_result(collision_counters *counters,
                                               const collision_ccd_result *result)
{
    counters->queries++;
    counters->hits += result->hit != 0;
    counters->undecided += result->decision == VBSS_COLLISION_DECISION_UNDECIDED;
}
/* Checks the options of a test in a configuration, and extracts them. */
vbss_result vbss_collision_check_ccd_options(vbss_context *context,
                                             const vbss_collision_config *config);
collision_ccd_options vbss_collision_ccd_options_of(const vbss_collision_config *config);
extern const vbss_layout vbss_collision_config_layout;
void vbss_collision_set_vertices(collision_ccd_query *query, const double start[12],
                                 const double end[12]);
/* Writes a result with its points to the caller's struct. `context` may be NULL. */
vbss_result vbss_collision_write_impact(vbss_context *context, const collision_ccd_query *query,
                                        const collision_ccd_result *result,
                                        vbss_collision_impact *impact, uint32_t struct_size);

/* ---- batches of queries (ccd_batch.c), four at a time if the method allows it, with the same bits
 * as vbss_collision_run_ccd */
typedef struct collision_ccd_batch {
    vbss_collision_pair_kind kind;
    uint32_t count;
    size_t stride;             /* distance of rows, in numbers */
    const double *start, *end; /* 12 rows each: the coordinates of the four vertices */
    const double *thickness;   /* one row; NULL to use same_thickness */
    double same_thickness;
    int32_t *hit;
    int32_t *decision; /* this and the following fields may be NULL */
    double *time, *distance;
    double *normal, *weights; /* 3 rows and 4 rows */
} collision_ccd_batch;
/* Runs all queries of a batch; `wide` selects the AVX2 copy. */
void vbss_collision_run_ccd_batch(const collision_ccd_options *options, bool wide,
                                  const collision_ccd_batch *batch, collision_counters *counters);

#endif
