/* Vectors of the scripted hands, which use the public headers only. Hands compute with + - * /, what IEEE 754
 * rounds exactly (sqrt, fabs, floor, fmod), and the library's own sin, cos, atan2 and acos: a seed is
 * then the same performance on every machine. */
#ifndef VBSS_EXAMPLES_THROW_VEC_H
#define VBSS_EXAMPLES_THROW_VEC_H

#include <math.h>

#include <vblast_ss/elementary.h>

typedef struct vec {
    double x, y, z;
} vec;

static inline vec v3(double x, double y, double z)
{
    return (vec){x, y, z};
}

static inline vec v_load(const double *a)
{
    return v3(a[0], a[1], a[2]);
}

static inline void v_store(double *a, vec v)
{
    a[0] = v.x;
    a[1] = v.y;
    a[2] = v.z;
}

static inline vec v_add(vec a, vec b)
{
    return v3(a.x + b.x, a.y + b.y, a.z + b.z);
}

static inline vec v_sub(vec a, vec b)
{
    return v3(a.x - b.x, a.y - b.y, a.z - b.z);
}

static inline vec v_scale(double s, vec a)
{
    return v3(s * a.x, s * a.y, s * a.z);
}

/* a + s b */
static inline vec v_along(vec a, double s, vec b)
{
    return v_add(a, v_scale(s, b));
}

static inline double v_dot(vec a, vec b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline vec v_cross(vec a, vec b)
{
    return v3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

static inline double v_length(vec a)
{
    return sqrt(v_dot(a, a));
}

static inline double v_distance(vec a, vec b)
{
    return v_length(v_sub(a, b));
}

static inline vec v_unit(vec a)
{
    double length = v_length(a);
    return length > 1e-12 ? v_scale(1.0 / length, a) : v3(0.0, 0.0, 1.0);
}

/* What is left of a without its part along a unit vector. */
static inline vec v_across(vec a, vec unit)
{
    return v_along(a, -v_dot(a, unit), unit);
}

static inline vec v_limit(vec a, double limit)
{
    double length = v_length(a);
    return length > limit ? v_scale(limit / length, a) : a;
}

static inline vec v_mix(vec a, vec b, double share)
{
    return v_along(a, share, v_sub(b, a));
}

/* Of a right triangle, as hypot() but for lengths whose squares neither overflow nor vanish. */
static inline double v_hypotenuse(double x, double y)
{
    return sqrt(x * x + y * y);
}

/* Of two zeros, which fmin() and fmax() may tell apart, the second. */
static inline double smaller(double a, double b)
{
    return a < b ? a : b;
}

static inline double larger(double a, double b)
{
    return a > b ? a : b;
}

static inline double clamp(double x, double low, double high)
{
    return x < low ? low : x > high ? high : x;
}

#endif
