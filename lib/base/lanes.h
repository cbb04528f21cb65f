/* Four doubles side by side.
 *
 * Lanes are independent entries, never summed across, so the bits do not depend on how many of them
 * the processor takes at a time. */
#ifndef VBSS_BASE_LANES_H
#define VBSS_BASE_LANES_H

#include "base/linear.h"

#if defined(__GNUC__) && defined(__AVX__)

typedef double lanes __attribute__((vector_size(32)));
static inline lanes lanes_mul(double s, lanes v)
{
    return s * v;
}
static inline lanes lanes_add(lanes a, lanes b)
{
    return a + b;
}
static inline lanes lanes_sub(lanes a, lanes b)
{
    return a - b;
}
static inline double lanes_at(lanes v, int i)
{
    return v[i];
}
static inline lanes lanes_make(double x, double y, double z)
{
    lanes v = {x, y, z, 0.0};
    return v;
}

#elif defined(__GNUC__)

/* Two halves that fit a register: compilers keep wider vectors in memory. */
typedef double half_lanes __attribute__((vector_size(16)));
typedef struct lanes {
    half_lanes low, high;
} lanes;
static inline lanes lanes_mul(double s, lanes v)
{
    lanes r = {s * v.low, s * v.high};
    return r;
}
static inline lanes lanes_add(lanes a, lanes b)
{
    lanes r = {a.low + b.low, a.high + b.high};
    return r;
}
static inline lanes lanes_sub(lanes a, lanes b)
{
    lanes r = {a.low - b.low, a.high - b.high};
    return r;
}
static inline double lanes_at(lanes v, int i)
{
    return i < 2 ? v.low[i] : v.high[i - 2];
}
static inline lanes lanes_make(double x, double y, double z)
{
    lanes r = {{x, y}, {z, 0.0}};
    return r;
}

#else

typedef struct lanes {
    double at[4];
} lanes;
static inline lanes lanes_mul(double s, lanes v)
{
    lanes r = {{s * v.at[0], s * v.at[1], s * v.at[2], s * v.at[3]}};
    return r;
}
static inline lanes lanes_add(lanes a, lanes b)
{
    lanes r = {{a.at[0] + b.at[0], a.at[1] + b.at[1], a.at[2] + b.at[2], a.at[3] + b.at[3]}};
    return r;
}
static inline lanes lanes_sub(lanes a, lanes b)
{
    lanes r = {{a.at[0] - b.at[0], a.at[1] - b.at[1], a.at[2] - b.at[2], a.at[3] - b.at[3]}};
    return r;
}
static inline double lanes_at(lanes v, int i)
{
    return v.at[i];
}
static inline lanes lanes_make(double x, double y, double z)
{
    lanes r = {{x, y, z, 0.0}};
    return r;
}

#endif

static inline lanes lanes_from(vec3 v)
{
    return lanes_make(v.x, v.y, v.z);
}

static inline vec3 lanes_vec3(lanes v)
{
    return vec3_make(lanes_at(v, 0), lanes_at(v, 1), lanes_at(v, 2));
}

#endif
