/* On which side of a line or a plane: the sign of a determinant, where doubles can tell it.
 *
 * A determinant is computed in doubles together with the sum of the sizes of its products. It is
 * wrong by less than a fixed multiple of that sum, the subtraction of coordinates included: the bounds A of
 * J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
 * Predicates", Discrete & Computational Geometry 18 (1997), with half a unit in the last place e = 2^-53:
 * (3 + 16 e) e in the plane, (7 + 56 e) e in space. He leaves out underflow, which adds less than ORIENTATION_UNDERFLOW
 * while coordinates are below 1e100. Where products overflow nothing is certain. */
#ifndef VBSS_KNOT_ORIENTATION_H
#define VBSS_KNOT_ORIENTATION_H

#include "base/base.h"

#define ORIENTATION_PLANE_ERROR 3.3306690738754716e-16
#define ORIENTATION_SPACE_ERROR 7.771561172376103e-16
#define ORIENTATION_UNDERFLOW 1e-200

/* +1 or -1: that is certainly the sign of value, which is wrong by less than error. 0: not certain. */
static inline int certain_sign(double value, double error)
{
    return (value > error) - (value < -error);
}

/* +1: a, b, c turn to the left; -1: to the right; 0: not certain. */
static inline int orient2d(double ax, double ay, double bx, double by, double cx, double cy)
{
    double left = (ax - cx) * (by - cy), right = (ay - cy) * (bx - cx);
    return certain_sign(left - right, ORIENTATION_PLANE_ERROR * (fabs(left) + fabs(right)) +
                                          ORIENTATION_UNDERFLOW);
}

/* u x v of differences of coordinates, and the sizes of its products. */
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

/* The sign of w . (u x v), w a difference too; 0: not certain. */
static inline int area_side(const area *a, vec3 w)
{
    double value = w.x * a->value.x + w.y * a->value.y + w.z * a->value.z;
    double size = fabs(w.x) * a->size.x + fabs(w.y) * a->size.y + fabs(w.z) * a->size.z;
    return certain_sign(value, ORIENTATION_SPACE_ERROR * size + ORIENTATION_UNDERFLOW);
}

/* The sign of (a - d) . ((b - d) x (c - d)): -1 when a, b, c turn to the left seen from d; 0: not certain. */
static inline int orient3d(vec3 a, vec3 b, vec3 c, vec3 d)
{
    area bc = area_of(vec3_sub(b, d), vec3_sub(c, d));
    return area_side(&bc, vec3_sub(a, d));
}

#endif
