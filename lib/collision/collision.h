/* Collision: what two features do to each other, and which features to ask about.
 *
 * Bottom up: closest points (closest.h, closest.c); one continuous test by one of three methods:
 * conservative_advancement.c, without thickness with ccd_crossing.c and ccd_exact.c on polynomials.c and integers.c; ccd_cubic.c;
 * paper_test.c; ccd.c chooses. The same in rows (ccd_batch.c, ccd_simd.c). Shapes (shapes.c, aabb.c,
 * bvh.c), the search (broad_phase.c, bvh_traversal.c), the tests of what it found (narrow_phase.c), and the object that
 * holds them (object.c, batch.c, views.c, snapshot.c). The paper's response stands alone (paper_response.c).
 *
 * Vertices: a0 a1 b0 b1 of two edges; the point and b0 b1 b2 of a triangle. They move evenly from
 * start (time 0) to end (time 1). D is the contact distance. */
#ifndef VBSS_COLLISION_COLLISION_H
#define VBSS_COLLISION_COLLISION_H

#include <stddef.h>

#include <vblast_ss/collision.h>

#include "base/config.h"
#include "base/linear.h"

/* ---- checking (ccd.c) */
#define COLLISION_MAX_COORDINATE 1e30 /* coordinates and D, m: products of six stay finite */
#define COLLISION_MIN_THICKNESS 1e-30 /* D, unless zero */
/* D: zero, or in its range. */
vbss_result vbss_collision_check_thickness(vbss_context *context, double thickness);
/* Finite and not beyond the farthest. */
vbss_result vbss_collision_check_coordinates(vbss_context *context, const double *values,
                                             size_t count, const char *name);

/* ---- one continuous test */

/* What a test needs to know, checked. */
typedef struct collision_ccd_options {
    vbss_collision_method method;
    uint32_t pass_limit;
    double tolerance; /* share of D */
    double paper_parallel, paper_unit;
    /* Memory of the exact decision: ccd_exact.h. */
    uint32_t *limbs;
    uint32_t limb_count;
} collision_ccd_options;
/* Enough for any doubles so far; and what fits on a stack, enough if the bits of the coordinates spread
 * over no more than some 250 binary places. */
enum { COLLISION_LIMBS = 16384, COLLISION_STACK_LIMBS = 2900 };

typedef struct collision_ccd_query {
    vbss_pair_kind kind;
    double thickness; /* D */
    vec3 start[4], end[4];
} collision_ccd_query;

/* As vbss_impact, without the points. All zero but time = 1 for a miss. */
typedef struct collision_ccd_result {
    int32_t hit;
    vbss_decision decision;
    uint32_t passes;
    double time, distance;
    vec3 normal;
    double weights[4];
} collision_ccd_result;

typedef struct collision_counters {
    uint64_t queries, hits, undecided, exact, passes, sign_tests_ended;
} collision_counters;

/* By the method of the rules, counted (ccd.c). */
void vbss_collision_run_ccd(const collision_ccd_options *options, const collision_ccd_query *query,
                            collision_ccd_result *result, collision_counters *counters);
/* One method each; they count passes, exact and sign_tests_ended only. `answer` comes as a miss. */
void vbss_collision_run_conservative(const collision_ccd_options *options,
                                     const collision_ccd_query *query, collision_ccd_result *result,
                                     collision_counters *counters);
void vbss_collision_run_cubic(const collision_ccd_options *options,
                              const collision_ccd_query *query, collision_ccd_result *result,
                              collision_counters *counters);
void vbss_collision_paper(const collision_ccd_options *options, const collision_ccd_query *query,
                          collision_ccd_result *result, collision_counters *counters);
static inline collision_ccd_result vbss_collision_ccd_miss(vbss_decision decision)
{
    collision_ccd_result miss = {.decision = decision, .time = 1.0};
    return miss;
}
static inline void vbss_collision_count_result(collision_counters *counters,
                                               const collision_ccd_result *result)
{
    counters->queries++;
    counters->hits += result->hit != 0;
    counters->undecided += result->decision == VBSS_DECISION_UNDECIDED;
}
/* Checks what a configuration says about tests, and hands it on. */
vbss_result vbss_collision_check_ccd_options(vbss_context *context,
                                             const vbss_collision_config *config);
collision_ccd_options vbss_collision_ccd_options_of(const vbss_collision_config *config);
extern const vbss_layout vbss_collision_config_layout;
void vbss_collision_set_vertices(collision_ccd_query *query, const double start[12],
                                 const double end[12]);
/* Hands out an answer with its points; context may be NULL. */
vbss_result vbss_collision_write_impact(vbss_context *context, const collision_ccd_query *query,
                                        const collision_ccd_result *result, vbss_impact *impact,
                                        uint32_t struct_size);

/* ---- the same in rows (ccd_batch.c): four at a time where the method can, with the bits of _ask */
typedef struct collision_ccd_batch {
    vbss_pair_kind kind;
    uint32_t count;
    size_t stride;
    const double *start, *end; /* 12 rows each */
    const double *thickness;   /* a row, or NULL: `same_thickness` */
    double same_thickness;
    int32_t *hit;
    int32_t *decision; /* this and the rest may be NULL */
    double *time, *distance;
    double *normal, *weights; /* 3 rows, 4 rows */
} collision_ccd_batch;
void vbss_collision_run_ccd_batch(const collision_ccd_options *options, bool wide,
                                  const collision_ccd_batch *batch, collision_counters *counters);

#endif
