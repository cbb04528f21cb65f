/* What the test and the soak of the elementary functions share: nasty arguments, and the error in
 * ulp against long double. */
#ifndef VBSS_TESTS_BASE_ELEMENTARY_ULP_H
#define VBSS_TESTS_BASE_ELEMENTARY_ULP_H

#include <float.h>
#include <math.h>
#include <string.h>

#include "base/double_double.h"
#include "base/elementary.h"
#include "base/random.h"

/* How far the reference itself may be off, in ulp of double: two of its own last bits, or a whole
 * libm where long double is no longer than double. */
#define REFERENCE_ERROR (LDBL_MANT_DIG >= 64 ? 0x1p-10 : 1.5)

typedef struct elementary_argument {
    double x, y; /* y only for atan2(y, x) */
} elementary_argument;

typedef struct elementary_function {
    const char *name;
    double bound; /* documented maximal error in ulp: docs/explanation/elementary-functions.md */
    elementary_argument (*draw)(vbss_random *random);
    double (*ours)(elementary_argument a);
    long double (*reference)(elementary_argument a);
} elementary_function;

/* 2^e, and numbers between 2^low and 2^high of any mantissa: exact, so the same everywhere. */
static inline double power_of_two(int e)
{
    return e < -1022 ? double_of(UINT64_C(1) << (e + 1074)) : double_of((uint64_t)(e + 1023) << 52);
}

static inline double draw_scaled(vbss_random *random, int low, int high)
{
    int e = low + (int)vbss_random_below(random, (uint32_t)(high - low));
    return (1.0 + vbss_random_uniform(random)) * power_of_two(e);
}

static inline double draw_sign(vbss_random *random, double x)
{
    return vbss_random_below(random, 2) != 0 ? -x : x;
}

static inline double draw_between(vbss_random *random, double low, double high)
{
    return low + vbss_random_uniform(random) * (high - low);
}

/* x moved by up to `reach` last bits either way. */
static inline double draw_neighbour(vbss_random *random, double x, uint32_t reach)
{
    return double_of(bits_of(x) + vbss_random_below(random, 2u * reach + 1u) - reach);
}

static inline elementary_argument draw_angle(vbss_random *random)
{
    const double half_pi = 0x1.921fb54442d18p0;
    double x = 0.0;
    switch (vbss_random_below(random, 9)) {
    case 0:
        x = draw_between(random, -1.0, 1.0);
        break;
    case 1:
        x = draw_between(random, -100.0, 100.0);
        break;
    case 2:
        x = draw_between(random, -0x1p23, 0x1p23);
        break;
    case 3:
        x = draw_neighbour(random, (1.0 + vbss_random_below(random, 2000)) * half_pi, 3);
        break;
    case 4:
        x = draw_neighbour(random, (1.0 + vbss_random_u32(random)) * half_pi, 3);
        break;
    case 5: /* edges of the table's cells */
        x = draw_neighbour(random, (0.5 + vbss_random_below(random, 300)) * half_pi / 32.0, 300);
        break;
    case 6:
        x = draw_scaled(random, -70, 0);
        break;
    case 7:
        x = draw_scaled(random, 0, 1024);
        break;
    default:
        x = double_of(vbss_random_u64(random));
        break;
    }
    x = draw_sign(random, x);
    return (elementary_argument){isfinite(x) ? x : 0.0, 0.0};
}

static inline elementary_argument draw_direction(vbss_random *random)
{
    double x = draw_between(random, 0x1p-30, 1.0), y = draw_between(random, 0x1p-30, 1.0);
    switch (vbss_random_below(random, 8)) {
    case 0:
        break;
    case 1:
        x = 1.0;
        break;
    case 2:
        y = x * draw_scaled(random, -70, 70);
        break;
    case 3:
        y = draw_neighbour(random, x, 1000);
        break; /* diagonals */
    case 4:    /* edges of the table's cells */
        y = draw_neighbour(random, x * (0.5 + vbss_random_below(random, 16)) / 16.0, 300);
        break;
    case 5: /* down to subnormals */
        x = draw_scaled(random, -1074, -980);
        y = draw_scaled(random, -1074, -980);
        break;
    case 6: /* up to overflow */
        x = draw_scaled(random, 950, 1024);
        y = draw_scaled(random, 950, 1024);
        break;
    default:
        x = double_of(vbss_random_u64(random));
        y = double_of(vbss_random_u64(random));
        break;
    }
    if (!isfinite(x) || !isfinite(y)) {
        x = y = 1.0;
    }
    if (vbss_random_below(random, 2) != 0) {
        double swap = x;
        x = y;
        y = swap;
    }
    x = draw_sign(random, x);
    return (elementary_argument){x, draw_sign(random, y)};
}

static inline elementary_argument draw_cosine(vbss_random *random)
{
    double x = vbss_random_uniform(random);
    switch (vbss_random_below(random, 6)) {
    case 0:
        break;
    case 1:
        x = 1.0 - draw_scaled(random, -53, -1);
        break;
    case 2:
        x = double_of(bits_of(1.0) - vbss_random_below(random, 100));
        break;
    case 3:
        x = draw_scaled(random, -70, 0);
        break;
    case 4:
        x = draw_neighbour(random, 0.5, 1000);
        break;
    default: /* edges of the table's cells */
        x = draw_neighbour(random, (0.5 + vbss_random_below(random, 16)) / 32.0, 300);
        break;
    }
    return (elementary_argument){draw_sign(random, x), 0.0};
}

static inline elementary_argument draw_exponent(vbss_random *random)
{
    double x = 0.0;
    switch (vbss_random_below(random, 7)) {
    case 0:
        x = draw_between(random, -1.0, 1.0);
        break;
    case 1:
        x = draw_between(random, -745.0, 709.0);
        break;
    case 2:
        x = draw_between(random, -746.0, -707.0);
        break; /* subnormal results */
    case 3:
        x = draw_between(random, 707.0, 711.0);
        break; /* overflow */
    case 4:
        x = draw_scaled(random, -70, 0);
        break;
    case 5: /* edges of the table's cells */
        x = (0.5 + vbss_random_below(random, 2000)) * 0x1.62e42fefa39efp-7;
        x = draw_neighbour(random, x, 300);
        break;
    default:
        x = draw_scaled(random, -1074, 12);
        break;
    }
    return (elementary_argument){draw_sign(random, x), 0.0};
}

static inline elementary_argument draw_positive(vbss_random *random)
{
    double x = 1.0;
    switch (vbss_random_below(random, 7)) {
    case 0:
        x = draw_between(random, 0x1p-60, 1.0);
        break;
    case 1:
        x = 1.0 + draw_sign(random, draw_scaled(random, -53, -1));
        break;
    case 2:
        x = draw_between(random, 0.9, 1.1);
        break;
    case 3:
        x = draw_between(random, 0.5, 2.0);
        break;
    case 4:
        x = draw_scaled(random, -1074, -1021);
        break;
    case 5: /* edges of the table's cells */
        x = draw_neighbour(random, (180.5 + vbss_random_below(random, 180)) / 256.0, 300);
        break;
    default:
        x = double_of(vbss_random_u64(random) >> 1);
        break;
    }
    return (elementary_argument){isfinite(x) && x > 0.0 ? x : 1.0, 0.0};
}

static inline double our_sin(elementary_argument a)
{
    return vbss_sin(a.x);
}
static inline double our_cos(elementary_argument a)
{
    return vbss_cos(a.x);
}
static inline double our_atan2(elementary_argument a)
{
    return vbss_atan2(a.y, a.x);
}
static inline double our_acos(elementary_argument a)
{
    return vbss_acos(a.x);
}
static inline double our_exp(elementary_argument a)
{
    return vbss_exp(a.x);
}
static inline double our_log(elementary_argument a)
{
    return vbss_log(a.x);
}
static inline long double long_sin(elementary_argument a)
{
    return sinl((long double)a.x);
}
static inline long double long_cos(elementary_argument a)
{
    return cosl((long double)a.x);
}
static inline long double long_acos(elementary_argument a)
{
    return acosl((long double)a.x);
}
static inline long double long_exp(elementary_argument a)
{
    return expl((long double)a.x);
}
static inline long double long_log(elementary_argument a)
{
    return logl((long double)a.x);
}
static inline long double long_atan2(elementary_argument a)
{
    return atan2l((long double)a.y, (long double)a.x);
}

enum { SIN, COS, ATAN2, ACOS, EXP, LOG, ELEMENTARY_FUNCTIONS };
static const elementary_function elementary_functions[ELEMENTARY_FUNCTIONS] = {
    {"sin", 0.51, draw_angle, our_sin, long_sin},
    {"cos", 0.51, draw_angle, our_cos, long_cos},
    {"atan2", 0.52, draw_direction, our_atan2, long_atan2},
    {"acos", 0.51, draw_cosine, our_acos, long_acos},
    {"exp", 0.52, draw_exponent, our_exp, long_exp},
    {"log", 0.52, draw_positive, our_log, long_log},
};

/* |got - reference| in units of the last bit a double near the reference has. */
static inline double ulp_error(double got, long double reference)
{
    if (isinf(got)) { /* right from half an ulp beyond the largest double on */
        long double limit = (long double)DBL_MAX + (long double)0x1p969;
        bool beyond = signbit(got) ? reference < -limit : reference > limit;
        return beyond || (isinf(reference) && (double)reference == got) ? 0.0 : (double)INFINITY;
    }
    if (isnan(got) || isnan(reference) || isinf(reference)) {
        return isnan(got) && isnan(reference) ? 0.0 : (double)INFINITY;
    }
    int exponent;
    frexpl(reference, &exponent);
    int last_bit = exponent > 1024 ? 971 : exponent < -1021 ? -1074 : exponent - 53;
    return (double)(fabsl((long double)got - reference) / (long double)power_of_two(last_bit));
}

/* The largest error over `count` drawn arguments, and where. */
static inline double worst_ulp_error(const elementary_function *f, uint64_t seed, uint64_t count,
                                     elementary_argument *where)
{
    vbss_random random;
    vbss_random_seed(&random, seed, 0);
    double worst = -1.0;
    for (uint64_t i = 0; i < count; i++) {
        elementary_argument a = f->draw(&random);
        double error = ulp_error(f->ours(a), f->reference(a));
        if (!(error <= worst)) {
            worst = error;
            *where = a;
        }
    }
    return worst;
}

#endif
