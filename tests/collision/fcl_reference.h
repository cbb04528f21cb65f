/* FCL as a reference for collision, behind plain C.
 *
 * Good: distances of capsules (to 1e-9) and of triangles that do not meet (to rounding). As a reference
 * for moving features only its hits count, as it misses many:
 * - rigid bodies, NAIVE: looks at some instants of the step, so it misses what happens in between;
 * - rigid bodies, CONSERVATIVE_ADVANCEMENT: misses half of the contacts of capsules; not used;
 * - moving edges, or a point and a triangle, without thickness (Intersect): roots of the coplanarity
 *   cubic to 1e-7 of the step. It misses parallel and degenerate features, and tells hits where the
 *   features are near each other only. */
#ifndef VBSS_TESTS_COLLISION_FCL_REFERENCE_H
#define VBSS_TESTS_COLLISION_FCL_REFERENCE_H

#include <stdbool.h>
#include <stdint.h>

#include <vblast_ss/collision.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Negative by the depth when they overlap. */
double fcl_capsules_distance(const double a[6], double radius_a, const double b[6],
                             double radius_b);
/* 0 when they meet. */
double fcl_triangles_distance(const double a[9], const double b[9]);
/* Zero thickness; on a hit *time is set. */
bool fcl_features_meet(vbss_collision_pair_kind kind, const double start[12], const double end[12],
                       double *time);
/* Two capsules along edges that do not turn: each moves as its first vertex does. Looks at `instants`
 * of the step; on a hit *time is set. */
bool fcl_shifted_capsules_meet(const double start[12], const double end[12], double radius_a,
                               double radius_b, unsigned instants, double *time);

/* ---- boxes in its tree (DynamicAABBTreeCollisionManager) */

typedef struct fcl_boxes fcl_boxes;
/* NULL when memory is short. */
fcl_boxes *fcl_boxes_create(uint32_t count);
void fcl_boxes_destroy(fcl_boxes *boxes);
void fcl_boxes_set(fcl_boxes *boxes, uint32_t index, const double low[3], const double high[3]);
/* Fits the tree to the boxes and tells each pair that overlaps once, the smaller index first. */
void fcl_boxes_find_pairs(fcl_boxes *boxes, void (*report)(void *user, uint32_t i, uint32_t j),
                          void *user);

#ifdef __cplusplus
}
#endif

#endif
