/* libccd as a reference for collision: whether two convex shapes meet (GJK, in double). It knows no
 * motion and tells no distances.
 *
 * Its answers are good where the gap is not smaller than LIBCCD_BLUR: nearer, GJK's own rounding
 * decides. Its penetration depths and MPR are not used: they are coarse (4e-3 of a radius, and worse). */
#ifndef VBSS_TESTS_COLLISION_LIBCCD_REFERENCE_H
#define VBSS_TESTS_COLLISION_LIBCCD_REFERENCE_H

#include <stdbool.h>
#include <stdint.h>

#include <vblast_ss/collision.h>

/* For shapes of some units in size. */
#define LIBCCD_BLUR 1e-6

enum { LIBCCD_POINTS = 8 };

/* The convex hull of points, inflated. */
typedef struct libccd_hull {
    double points[LIBCCD_POINTS][3];
    uint32_t count;
    double radius;
} libccd_hull;

bool libccd_meet(const libccd_hull *a, const libccd_hull *b);

/* The features of a pair at one time, inflated by half of the thickness each. */
void libccd_features(vbss_collision_pair_kind kind, const double vertices[12], double thickness,
                     libccd_hull *a, libccd_hull *b);
/* All that the vector from a point of a to one of b can be in the step, and more: the hull of the
 * differences of vertices at the start and at the end, inflated by the thickness. Features that come
 * within the thickness of each other make it hold the origin; the reverse is not true, as what happens
 * at different times counts too. */
void libccd_swept_difference(vbss_collision_pair_kind kind, const double start[12],
                             const double end[12], double thickness, libccd_hull *difference);
bool libccd_holds_origin(const libccd_hull *difference);

#endif
