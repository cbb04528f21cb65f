/* Vectors, matrices, quaternions and poses: small types, passed by value, with inline functions.
 *
 * Every sum has one written order and is evaluated left to right, so results do not depend on the
 * compiler. Quaternions are (w, x, y, z); those that represent an orientation have unit length.
 * Matrices are row-major, poses map body to world, and frames are right-handed. sqrt is the only
 * function of libm here that rounds. */
#ifndef VBSS_BASE_LINEAR_H
#define VBSS_BASE_LINEAR_H

#include <float.h>
#include <math.h>
#include <stdbool.h>

#include "base/compiler.h"

typedef struct vec3 {
    double x, y, z;
} vec3;

/* Row-major: m[row][column]. */
typedef struct mat3 {
    double m[3][3];
} mat3;

typedef struct quat {
    double w, x, y, z;
} quat;

/* A rigid transformation: world = position + orientation * body. */
typedef struct pose {
    vec3 position;
    quat orientation;
} pose;

/* The larger value, or NaN if either is NaN: for maxima that must not hide a broken state. */
static inline double vbss_max_or_nan(double a, double b)
{
    return a > b || a != a ? a : b;
}

/* The smaller value; b if either is NaN. */
static inline double vbss_min(double a, double b)
{
    return a < b ? a : b;
}

/* The larger value; b if either is NaN. */
static inline double vbss_max(double a, double b)
{
    return a > b ? a : b;
}

/* ---- vec3 */

static inline vec3 vec3_make(double x, double y, double z)
{
    vec3 v = {x, y, z};
    return v;
}

static inline vec3 vec3_zero(void)
{
    return vec3_make(0.0, 0.0, 0.0);
}

static inline vec3 vec3_load(const double v[3])
{
    return vec3_make(v[0], v[1], v[2]);
}

static inline void vec3_store(double out[3], vec3 v)
{
    out[0] = v.x;
    out[1] = v.y;
    out[2] = v.z;
}

static inline vec3 vec3_add(vec3 a, vec3 b)
{
    return vec3_make(a.x + b.x, a.y + b.y, a.z + b.z);
}

static inline vec3 vec3_sub(vec3 a, vec3 b)
{
    return vec3_make(a.x - b.x, a.y - b.y, a.z - b.z);
}

static inline vec3 vec3_neg(vec3 a)
{
    return vec3_make(-a.x, -a.y, -a.z);
}

static inline vec3 vec3_scale(vec3 a, double s)
{
    return vec3_make(a.x * s, a.y * s, a.z * s);
}

/* a + s b */
static inline vec3 vec3_add_scaled(vec3 a, double s, vec3 b)
{
    return vec3_make(a.x + s * b.x, a.y + s * b.y, a.z + s * b.z);
}

/* (1 - t) a + t b, exact at both ends */
static inline vec3 vec3_lerp(vec3 a, vec3 b, double t)
{
    double u = 1.0 - t;
    return vec3_make(u * a.x + t * b.x, u * a.y + t * b.y, u * a.z + t * b.z);
}

static inline double vec3_dot(vec3 a, vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline vec3 vec3_cross(vec3 a, vec3 b)
{
    return vec3_make(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

static inline double vec3_norm_squared(vec3 a)
{
    return vec3_dot(a, a);
}

/* Overflows above 1e154 m and underflows below 1e-154 m, far outside any scene. */
static inline double vec3_norm(vec3 a)
{
    return sqrt(vec3_dot(a, a));
}

static inline double vec3_distance(vec3 a, vec3 b)
{
    return vec3_norm(vec3_sub(a, b));
}

/* 1/n, or NaN for a norm that overflowed or is NaN: a broken state must stay visible. */
static inline double inverse_norm(double n)
{
    return n <= DBL_MAX ? 1.0 / n : n - n;
}

/* The unit vector along a; `fallback` if a is too short to have a direction; NaN if its norm is not
 * finite. */
static inline vec3 vec3_unit_or(vec3 a, vec3 fallback)
{
    double n = vec3_norm(a);
    return n <= 1e-150 ? fallback : vec3_scale(a, inverse_norm(n));
}

static inline bool vec3_is_finite(vec3 a)
{
    return isfinite(a.x) && isfinite(a.y) && isfinite(a.z);
}

/* A unit vector normal to the unit vector a. It varies continuously with a except across a.z = 0
 * (Duff et al. 2017, with copysign). */
static inline vec3 vec3_any_normal(vec3 a)
{
    double sign = copysign(1.0, a.z);
    double p = -1.0 / (sign + a.z);
    return vec3_make(1.0 + sign * (a.x * a.x * p), sign * (a.x * a.y * p), -sign * a.x);
}

/* ---- mat3 */

static inline mat3 mat3_zero(void)
{
    mat3 a = {{{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}};
    return a;
}

static inline mat3 mat3_diagonal(double x, double y, double z)
{
    mat3 a = {{{x, 0.0, 0.0}, {0.0, y, 0.0}, {0.0, 0.0, z}}};
    return a;
}

static inline mat3 mat3_identity(void)
{
    return mat3_diagonal(1.0, 1.0, 1.0);
}

static inline mat3 mat3_rows(vec3 a, vec3 b, vec3 c)
{
    mat3 r = {{{a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z}}};
    return r;
}

/* a b^T */
static inline mat3 mat3_outer(vec3 a, vec3 b)
{
    return mat3_rows(vec3_scale(b, a.x), vec3_scale(b, a.y), vec3_scale(b, a.z));
}

/* The cross product matrix: mat3_cross(a) b = a x b. */
static inline mat3 mat3_cross(vec3 a)
{
    mat3 r = {{{0.0, -a.z, a.y}, {a.z, 0.0, -a.x}, {-a.y, a.x, 0.0}}};
    return r;
}

static inline mat3 mat3_transpose(mat3 a)
{
    mat3 r = {{{a.m[0][0], a.m[1][0], a.m[2][0]},
               {a.m[0][1], a.m[1][1], a.m[2][1]},
               {a.m[0][2], a.m[1][2], a.m[2][2]}}};
    return r;
}

/* a + s b */
static inline mat3 mat3_add_scaled(mat3 a, double s, mat3 b)
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            a.m[i][j] += s * b.m[i][j];
        }
    }
    return a;
}

static inline mat3 mat3_add(mat3 a, mat3 b)
{
    return mat3_add_scaled(a, 1.0, b);
}

static inline mat3 mat3_sub(mat3 a, mat3 b)
{
    return mat3_add_scaled(a, -1.0, b);
}

static inline mat3 mat3_scale(mat3 a, double s)
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            a.m[i][j] *= s;
        }
    }
    return a;
}

static inline vec3 mat3_mul_vec3(mat3 a, vec3 v)
{
    return vec3_make(a.m[0][0] * v.x + a.m[0][1] * v.y + a.m[0][2] * v.z,
                     a.m[1][0] * v.x + a.m[1][1] * v.y + a.m[1][2] * v.z,
                     a.m[2][0] * v.x + a.m[2][1] * v.y + a.m[2][2] * v.z);
}

/* a^T v */
static inline vec3 mat3_transpose_mul_vec3(mat3 a, vec3 v)
{
    return vec3_make(a.m[0][0] * v.x + a.m[1][0] * v.y + a.m[2][0] * v.z,
                     a.m[0][1] * v.x + a.m[1][1] * v.y + a.m[2][1] * v.z,
                     a.m[0][2] * v.x + a.m[1][2] * v.y + a.m[2][2] * v.z);
}

static inline mat3 mat3_mul(mat3 a, mat3 b)
{
    mat3 r;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            r.m[i][j] = a.m[i][0] * b.m[0][j] + a.m[i][1] * b.m[1][j] + a.m[i][2] * b.m[2][j];
        }
    }
    return r;
}

static inline double mat3_determinant(mat3 a)
{
    return a.m[0][0] * (a.m[1][1] * a.m[2][2] - a.m[1][2] * a.m[2][1]) -
           a.m[0][1] * (a.m[1][0] * a.m[2][2] - a.m[1][2] * a.m[2][0]) +
           a.m[0][2] * (a.m[1][0] * a.m[2][1] - a.m[1][1] * a.m[2][0]);
}

/* Inverts by cofactors. Returns false and leaves *inverse unchanged if an entry is not finite or
 * the rows are dependent in double precision: |determinant| <= 1e-14 times the product of their
 * lengths. */
static inline bool mat3_invert(mat3 a, mat3 *inverse)
{
    double allowed =
        vec3_norm(vec3_load(a.m[0])) * vec3_norm(vec3_load(a.m[1])) * vec3_norm(vec3_load(a.m[2]));
    double d = mat3_determinant(a);
    if (!(fabs(d) > 1e-14 * allowed)) {
        return false;
    }
    double s = 1.0 / d;
    mat3 result;
    bool finite = true;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            /* Cyclic indices give the cofactor with its sign; [j][i] transposes. */
            int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            result.m[j][i] = s * (a.m[i1][j1] * a.m[i2][j2] - a.m[i1][j2] * a.m[i2][j1]);
            finite = finite && isfinite(result.m[j][i]);
        }
    }
    if (finite) {
        *inverse = result;
    }
    return finite;
}

/* ---- quat */

static inline quat quat_make(double w, double x, double y, double z)
{
    quat q = {w, x, y, z};
    return q;
}

static inline quat quat_identity(void)
{
    return quat_make(1.0, 0.0, 0.0, 0.0);
}

/* The rotation by b, then by a. */
static inline quat quat_mul(quat a, quat b)
{
    return quat_make(a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
                     a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
                     a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
                     a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w);
}

static inline quat quat_conjugate(quat q)
{
    return quat_make(q.w, -q.x, -q.y, -q.z);
}

static inline double quat_dot(quat a, quat b)
{
    return a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
}

/* The unit quaternion along q; the identity if q is too short to have a direction; NaN if its norm
 * is not finite. */
static inline quat quat_unit(quat q)
{
    double n = sqrt(quat_dot(q, q));
    if (n <= 1e-150) {
        return quat_identity();
    }
    double s = inverse_norm(n);
    return quat_make(q.w * s, q.x * s, q.y * s, q.z * s);
}

/* Rotates v by the unit quaternion q: v + 2 w (u x v) + 2 u x (u x v) with u = (x, y, z). */
static inline vec3 quat_rotate(quat q, vec3 v)
{
    vec3 u = vec3_make(q.x, q.y, q.z);
    vec3 t = vec3_scale(vec3_cross(u, v), 2.0);
    return vec3_add(vec3_add_scaled(v, q.w, t), vec3_cross(u, t));
}

/* Rotates v by the inverse of the unit quaternion q. */
static inline vec3 quat_rotate_back(quat q, vec3 v)
{
    return quat_rotate(quat_conjugate(q), v);
}

static inline mat3 quat_to_mat3(quat q)
{
    double xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
    double xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z;
    double wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
    mat3 r = {{{1.0 - 2.0 * (yy + zz), 2.0 * (xy - wz), 2.0 * (xz + wy)},
               {2.0 * (xy + wz), 1.0 - 2.0 * (xx + zz), 2.0 * (yz - wx)},
               {2.0 * (xz - wy), 2.0 * (yz + wx), 1.0 - 2.0 * (xx + yy)}}};
    return r;
}

/* The shortest rotation that takes the unit vector a to the unit vector b, by way of the vector
 * halfway between them. It is accurate to rounding, but only to 1e-7 for nearly opposite vectors.
 * Vectors opposite to within 1e-8 give a half turn about vec3_any_normal(a). */
static inline quat quat_between(vec3 a, vec3 b)
{
    vec3 sum = vec3_add(a, b);
    double n = vec3_norm(sum);
    if (n < 1e-8) {
        vec3 axis = vec3_any_normal(a);
        return quat_make(0.0, axis.x, axis.y, axis.z);
    }
    vec3 half = vec3_scale(sum, 1.0 / n);
    vec3 v = vec3_cross(a, half);
    return quat_unit(quat_make(vec3_dot(a, half), v.x, v.y, v.z));
}

static inline bool quat_is_finite(quat q)
{
    return isfinite(q.w) && isfinite(q.x) && isfinite(q.y) && isfinite(q.z);
}

/* ---- pose */

static inline pose pose_make(vec3 position, quat orientation)
{
    pose p = {position, orientation};
    return p;
}

static inline void pose_store(pose p, double position[3], double orientation[4])
{
    vec3_store(position, p.position);
    orientation[0] = p.orientation.w;
    orientation[1] = p.orientation.x;
    orientation[2] = p.orientation.y;
    orientation[3] = p.orientation.z;
}

static inline pose pose_identity(void)
{
    return pose_make(vec3_zero(), quat_identity());
}

static inline vec3 pose_apply(pose p, vec3 body)
{
    return vec3_add(p.position, quat_rotate(p.orientation, body));
}

static inline vec3 pose_apply_inverse(pose p, vec3 world)
{
    return quat_rotate_back(p.orientation, vec3_sub(world, p.position));
}

/* Transformation by b, then by a. */
static inline pose pose_mul(pose a, pose b)
{
    return pose_make(pose_apply(a, b.position), quat_mul(a.orientation, b.orientation));
}

static inline pose pose_inverse(pose p)
{
    quat q = quat_conjugate(p.orientation);
    return pose_make(vec3_neg(quat_rotate(q, p.position)), q);
}

#endif
