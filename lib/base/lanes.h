/* Four doubles in SIMD lanes.
 *
 * Lanes are independent entries and are never summed across. The bits therefore do not depend on
 * how many of them the processor takes at a time: four, two, or one. Two are a struct of two
 * registers, because compilers keep vectors wider than a register in memory. */
#ifndef VBSS_BASE_LANES_H
#define VBSS_BASE_LANES_H

#include <stdint.h>

#include "base/linear.h"

enum { LANES = 4 };

/* ---- types: lanes_part is one register, lanes consists of as many parts as needed */

#if defined(__GNUC__) && defined(__AVX__)

typedef double lanes_part __attribute__((vector_size(32)));
typedef int64_t lanes_part_mask __attribute__((vector_size(32)));
typedef lanes_part lanes;
typedef lanes_part_mask lanes_mask;
#define LANES_OF(type, part, a, b, c) return part(a, b, c)

static inline double lanes_at(lanes v, int i)
{
    return v[i];
}
static inline bool lanes_mask_at(lanes_mask v, int i)
{
    return v[i] != 0;
}
static inline lanes lanes_load(const double *from)
{
    lanes v = {from[0], from[1], from[2], from[3]};
    return v;
}

#elif defined(__GNUC__)

typedef double lanes_part __attribute__((vector_size(16)));
typedef int64_t lanes_part_mask __attribute__((vector_size(16)));
typedef struct lanes {
    lanes_part low, high;
} lanes;
typedef struct lanes_mask {
    lanes_part_mask low, high;
} lanes_mask;
#define LANES_OF(type, part, a, b, c)                                                \
    type r_ = {part((a).low, (b).low, (c).low), part((a).high, (b).high, (c).high)}; \
    return r_

static inline double lanes_at(lanes v, int i)
{
    return i < 2 ? v.low[i] : v.high[i - 2];
}
static inline bool lanes_mask_at(lanes_mask v, int i)
{
    return (i < 2 ? v.low[i] : v.high[i - 2]) != 0;
}
static inline lanes lanes_load(const double *from)
{
    lanes v = {{from[0], from[1]}, {from[2], from[3]}};
    return v;
}

#else

typedef double lanes_part;
typedef int64_t lanes_part_mask;
typedef struct lanes {
    double at[LANES];
} lanes;
typedef struct lanes_mask {
    int64_t at[LANES];
} lanes_mask;
#define LANES_OF(type, part, a, b, c)                         \
    type r_;                                                  \
    for (int i_ = 0; i_ < LANES; i_++) {                      \
        r_.at[i_] = part((a).at[i_], (b).at[i_], (c).at[i_]); \
    }                                                         \
    return r_

static inline double lanes_at(lanes v, int i)
{
    return v.at[i];
}
static inline bool lanes_mask_at(lanes_mask v, int i)
{
    return v.at[i] != 0;
}
static inline lanes lanes_load(const double *from)
{
    lanes v = {{from[0], from[1], from[2], from[3]}};
    return v;
}

#endif

/* Reorders the entries of two parts, where the compiler has a builtin for it. */
#if defined(__clang__) || (defined(__GNUC__) && __GNUC__ >= 12)
#define LANES_SHUFFLE(a, b, ...) __builtin_shufflevector(a, b, __VA_ARGS__)
#endif

/* ---- operations on one part. All macros take three arguments; callers repeat one for those
 * unused. */

#define LANES_ADD(a, b, unused) ((a) + (b))
#define LANES_SUB(a, b, unused) ((a) - (b))
#define LANES_TIMES(a, b, unused) ((a) * (b))
#define LANES_OVER(a, b, unused) ((a) / (b))
#define LANES_BOTH(a, b, unused) ((a) & (b))
#define LANES_EITHER(a, b, unused) ((a) | (b))
#define LANES_NOT(a, unused, unused_too) (~(a))
#if defined(__GNUC__)
#define LANES_LESS(a, b, unused) ((lanes_part_mask)((a) < (b)))
#define LANES_CHOOSE(mask, a, b) \
    ((lanes_part)(((mask) & (lanes_part_mask)(a)) | (~(mask) & (lanes_part_mask)(b))))
#define LANES_ABS(a, unused, unused_too) \
    ((lanes_part)((lanes_part_mask)(a)&INT64_C(0x7fffffffffffffff)))
#else
#define LANES_LESS(a, b, unused) (-(int64_t)((a) < (b)))
#define LANES_CHOOSE(mask, a, b) ((mask) != 0 ? (a) : (b))
#define LANES_ABS(a, unused, unused_too) fabs(a)
#endif
/* a > b ? a : b and a < b ? a : b, each a single instruction on most processors */
#if defined(__GNUC__) && defined(__AVX__)
#define LANES_LARGER(a, b, unused) __builtin_ia32_maxpd256(a, b)
#define LANES_SMALLER(a, b, unused) __builtin_ia32_minpd256(a, b)
#elif defined(__GNUC__) && defined(__SSE2__)
#define LANES_LARGER(a, b, unused) __builtin_ia32_maxpd(a, b)
#define LANES_SMALLER(a, b, unused) __builtin_ia32_minpd(a, b)
#else
#define LANES_LARGER(a, b, unused) LANES_CHOOSE(LANES_LESS(b, a, b), a, b)
#define LANES_SMALLER(a, b, unused) LANES_CHOOSE(LANES_LESS(a, b, b), a, b)
#endif

/* ---- construction */

static inline lanes lanes_make(double x, double y, double z)
{
    double all[LANES] = {x, y, z, 0.0};
    return lanes_load(all);
}

/* All four lanes are x. */
static inline lanes lanes_splat(double x)
{
    double all[LANES] = {x, x, x, x};
    return lanes_load(all);
}

/* The vector's components in lanes 0 to 2, and 0 in lane 3. */
static inline lanes lanes_from(vec3 v)
{
    return lanes_make(v.x, v.y, v.z);
}

/* Lanes 0 to 2 as a vector. */
static inline vec3 lanes_vec3(lanes v)
{
    return vec3_make(lanes_at(v, 0), lanes_at(v, 1), lanes_at(v, 2));
}

/* ---- arithmetic */

static inline lanes lanes_add(lanes a, lanes b)
{
    LANES_OF(lanes, LANES_ADD, a, b, a);
}

static inline lanes lanes_sub(lanes a, lanes b)
{
    LANES_OF(lanes, LANES_SUB, a, b, a);
}

static inline lanes lanes_times(lanes a, lanes b)
{
    LANES_OF(lanes, LANES_TIMES, a, b, a);
}

static inline lanes lanes_div(lanes a, lanes b)
{
    LANES_OF(lanes, LANES_OVER, a, b, a);
}

static inline lanes lanes_scale(double s, lanes v)
{
    return lanes_times(lanes_splat(s), v);
}

static inline lanes lanes_abs(lanes a)
{
    LANES_OF(lanes, LANES_ABS, a, a, a);
}

static inline lanes lanes_max(lanes a, lanes b)
{
    LANES_OF(lanes, LANES_LARGER, a, b, a);
}

static inline lanes lanes_min(lanes a, lanes b)
{
    LANES_OF(lanes, LANES_SMALLER, a, b, a);
}

static inline lanes lanes_sqrt(lanes a)
{
    double roots[LANES] = {sqrt(lanes_at(a, 0)), sqrt(lanes_at(a, 1)), sqrt(lanes_at(a, 2)),
                           sqrt(lanes_at(a, 3))};
    return lanes_load(roots);
}

/* ---- comparison: false if either entry is NaN */

static inline lanes_mask lanes_less(lanes a, lanes b)
{
    LANES_OF(lanes_mask, LANES_LESS, a, b, a);
}

static inline lanes_mask lanes_and(lanes_mask a, lanes_mask b)
{
    LANES_OF(lanes_mask, LANES_BOTH, a, b, a);
}

static inline lanes_mask lanes_or(lanes_mask a, lanes_mask b)
{
    LANES_OF(lanes_mask, LANES_EITHER, a, b, a);
}

static inline lanes_mask lanes_not(lanes_mask a)
{
    LANES_OF(lanes_mask, LANES_NOT, a, a, a);
}

/* a where the mask is set, otherwise b */
static inline lanes lanes_select(lanes_mask mask, lanes a, lanes b)
{
    LANES_OF(lanes, LANES_CHOOSE, mask, a, b);
}

/* Bit i of the result is set if lane i of the mask is set. */
static inline unsigned lanes_movemask(lanes_mask mask)
{
#if defined(__GNUC__) && defined(__AVX__)
    return (unsigned)__builtin_ia32_movmskpd256((lanes)mask);
#elif defined(__GNUC__) && defined(__SSE2__)
    return (unsigned)__builtin_ia32_movmskpd((lanes_part)mask.low) |
           (unsigned)__builtin_ia32_movmskpd((lanes_part)mask.high) << 2;
#else
    return (unsigned)lanes_mask_at(mask, 0) | (unsigned)lanes_mask_at(mask, 1) << 1 |
           (unsigned)lanes_mask_at(mask, 2) << 2 | (unsigned)lanes_mask_at(mask, 3) << 3;
#endif
}

/* Transposes three rows: to[i] = (a_i, b_i, c_i, 0). */
static inline void lanes_transpose(lanes a, lanes b, lanes c, lanes to[LANES])
{
#if defined(LANES_SHUFFLE) && defined(__AVX__)
    const lanes zero = lanes_splat(0.0);
    lanes ab_even = LANES_SHUFFLE(a, b, 0, 4, 2, 6), ab_odd = LANES_SHUFFLE(a, b, 1, 5, 3, 7);
    lanes c_even = LANES_SHUFFLE(c, zero, 0, 4, 2, 6), c_odd = LANES_SHUFFLE(c, zero, 1, 5, 3, 7);
    to[0] = LANES_SHUFFLE(ab_even, c_even, 0, 1, 4, 5);
    to[1] = LANES_SHUFFLE(ab_odd, c_odd, 0, 1, 4, 5);
    to[2] = LANES_SHUFFLE(ab_even, c_even, 2, 3, 6, 7);
    to[3] = LANES_SHUFFLE(ab_odd, c_odd, 2, 3, 6, 7);
#elif defined(LANES_SHUFFLE)
    const lanes_part zero = {0.0, 0.0};
    to[0].low = LANES_SHUFFLE(a.low, b.low, 0, 2);
    to[1].low = LANES_SHUFFLE(a.low, b.low, 1, 3);
    to[2].low = LANES_SHUFFLE(a.high, b.high, 0, 2);
    to[3].low = LANES_SHUFFLE(a.high, b.high, 1, 3);
    to[0].high = LANES_SHUFFLE(c.low, zero, 0, 2);
    to[1].high = LANES_SHUFFLE(c.low, zero, 1, 3);
    to[2].high = LANES_SHUFFLE(c.high, zero, 0, 2);
    to[3].high = LANES_SHUFFLE(c.high, zero, 1, 3);
#else
    for (int i = 0; i < LANES; i++) {
        to[i] = lanes_make(lanes_at(a, i), lanes_at(b, i), lanes_at(c, i));
    }
#endif
}

static inline void lanes_store(double *to, lanes v)
{
    for (int i = 0; i < LANES; i++) {
        to[i] = lanes_at(v, i);
    }
}

#endif
