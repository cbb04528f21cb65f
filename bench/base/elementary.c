/* Elementary functions beside libm: ns per call over independent arguments, and the largest error
 * in ulp of the exact result, taken against long double. Where long double is no wider than double
 * the error cannot be told and is left out. */
#include <float.h>
#include <math.h>
#include <stdio.h>

#include "base/elementary.h"
#include "base/random.h"
#include "bench_base.h"

/* More than a branch predictor remembers, less than the second cache level. */
enum { ARGUMENTS = 4096, CHECKED = 1000000, CHECKED_QUICK = 20000, MAX_RANGES = 3, MAX_CASES = 64 };

typedef enum shape { UNARY, BINARY, TWO_RESULTS } shape;

typedef union function {
    double (*unary)(double);
    double (*binary)(double, double);
    void (*two_results)(double, double *, double *);
} function;

typedef union reference {
    long double (*unary)(long double);
    long double (*binary)(long double, long double);
} reference;

typedef enum spread {
    NO_RANGE,
    EVEN,      /* evenly in [low, high] */
    MAGNITUDE, /* 2^u, u evenly in [low, high], either sign */
    POSITIVE,  /* the same, positive */
    NEAR_ONE   /* 1 - 2^u, either sign */
} spread;

typedef struct range {
    const char *name;
    spread spread;
    double low, high;
} range;

/* For TWO_RESULTS `exact` and `exact_second` are functions of the one argument. */
typedef struct elementary {
    const char *name;
    shape shape;
    function ours, libm;
    reference exact, exact_second;
    range ranges[MAX_RANGES];
} elementary;

#define PI 3.14159265358979323846

static void libm_sincos(double x, double *sine, double *cosine)
{
    *sine = sin(x);
    *cosine = cos(x);
}

static const elementary functions[] = {
    {"sin",
     UNARY,
     {.unary = vbss_sine},
     {.unary = sin},
     {.unary = sinl},
     {NULL},
     {{"typical", EVEN, -PI, PI}, {"wide", EVEN, -1e5, 1e5}, {"huge", MAGNITUDE, 20.0, 1020.0}}},
    {"cos",
     UNARY,
     {.unary = vbss_cosine},
     {.unary = cos},
     {.unary = cosl},
     {NULL},
     {{"typical", EVEN, -PI, PI}, {"wide", EVEN, -1e5, 1e5}, {"huge", MAGNITUDE, 20.0, 1020.0}}},
    {"sincos",
     TWO_RESULTS,
     {.two_results = vbss_sincos},
     {.two_results = libm_sincos},
     {.unary = sinl},
     {.unary = cosl},
     {{"typical", EVEN, -PI, PI}, {"wide", EVEN, -1e5, 1e5}}},
    {"atan2",
     BINARY,
     {.binary = vbss_arc_tangent},
     {.binary = atan2},
     {.binary = atan2l},
     {NULL},
     {{"typical", EVEN, -1.0, 1.0}, {"wide", MAGNITUDE, -500.0, 500.0}}},
    {"acos",
     UNARY,
     {.unary = vbss_arc_cosine},
     {.unary = acos},
     {.unary = acosl},
     {NULL},
     {{"typical", EVEN, -1.0, 1.0}, {"near-one", NEAR_ONE, -53.0, -1.0}}},
    {"exp",
     UNARY,
     {.unary = vbss_exp},
     {.unary = exp},
     {.unary = expl},
     {NULL},
     {{"typical", EVEN, -1.0, 1.0}, {"wide", EVEN, -700.0, 700.0}}},
    {"log",
     UNARY,
     {.unary = vbss_log},
     {.unary = log},
     {.unary = logl},
     {NULL},
     {{"typical", EVEN, 0.5, 2.0}, {"wide", POSITIVE, -1020.0, 1020.0}}},
};

typedef struct elementary_case {
    char name[64];
    const elementary *what;
    const range *range;
    function function;
    int checked;
} elementary_case;

/* One case runs at a time. */
static elementary_case cases[MAX_CASES];
static double first[ARGUMENTS], second[ARGUMENTS], out[ARGUMENTS], out_second[ARGUMENTS];

static double draw(vbss_random *random, const range *r)
{
    double u = r->low + (r->high - r->low) * vbss_random_uniform(random);
    double sign = vbss_random_u32(random) & 1u ? 1.0 : -1.0;
    switch (r->spread) {
    case MAGNITUDE:
        return sign * exp2(u);
    case POSITIVE:
        return exp2(u);
    case NEAR_ONE:
        return sign * (1.0 - exp2(u));
    case EVEN:
    case NO_RANGE:
        break;
    }
    return u;
}

static int fill_arguments(void *user)
{
    const elementary_case *c = user;
    vbss_random random;
    vbss_random_seed(&random, 1, 1);
    for (int i = 0; i < ARGUMENTS; i++) {
        first[i] = draw(&random, c->range);
        second[i] = draw(&random, c->range);
    }
    return 0;
}

static void run_unary(void *user)
{
    double (*f)(double) = ((const elementary_case *)user)->function.unary;
    for (int i = 0; i < ARGUMENTS; i++) {
        out[i] = f(first[i]);
    }
    bench_keep_memory(out);
}

static void run_binary(void *user)
{
    double (*f)(double, double) = ((const elementary_case *)user)->function.binary;
    for (int i = 0; i < ARGUMENTS; i++) {
        out[i] = f(first[i], second[i]);
    }
    bench_keep_memory(out);
}

static void run_two_results(void *user)
{
    void (*f)(double, double *, double *) = ((const elementary_case *)user)->function.two_results;
    for (int i = 0; i < ARGUMENTS; i++) {
        f(first[i], &out[i], &out_second[i]);
    }
    bench_keep_memory(out);
    bench_keep_memory(out_second);
}

static double error_ulp(double value, long double exact)
{
    int exponent;
    frexpl(exact, &exponent);
    exponent = exponent < DBL_MIN_EXP ? DBL_MIN_EXP : exponent;
    return (double)fabsl(ldexpl((long double)value - exact, DBL_MANT_DIG - exponent));
}

static double argument_error(const elementary_case *c, double x, double y)
{
    const elementary *f = c->what;
    long double wide_x = (long double)x, wide_y = (long double)y;
    double value, value_second, error, error_second;
    switch (f->shape) {
    case BINARY:
        return error_ulp(c->function.binary(x, y), f->exact.binary(wide_x, wide_y));
    case TWO_RESULTS:
        c->function.two_results(x, &value, &value_second);
        error = error_ulp(value, f->exact.unary(wide_x));
        error_second = error_ulp(value_second, f->exact_second.unary(wide_x));
        return error > error_second ? error : error_second;
    case UNARY:
        break;
    }
    return error_ulp(c->function.unary(x), f->exact.unary(wide_x));
}

static void check_errors(void *user, bench_result *result)
{
    const elementary_case *c = user;
    if (LDBL_MANT_DIG < DBL_MANT_DIG + 8) {
        return;
    }
    double largest = 0.0;
    vbss_random random;
    vbss_random_seed(&random, 2, 1);
    for (int i = 0; i < c->checked; i++) {
        double x = draw(&random, c->range), y = draw(&random, c->range);
        double error = argument_error(c, x, y);
        if (!isfinite(error)) {
            bench_fail(result, "not finite at x = %.17g, y = %.17g", x, y);
            return;
        }
        largest = error > largest ? error : largest;
    }
    bench_counter(result, "max_error_ulp", largest);
}

void add_elementary_cases(bench *b)
{
    static void (*const runs[])(void *) = {run_unary, run_binary, run_two_results};
    size_t used = 0;
    for (size_t i = 0; i < sizeof functions / sizeof functions[0]; i++) {
        const elementary *f = &functions[i];
        for (size_t r = 0; r < MAX_RANGES && f->ranges[r].spread != NO_RANGE; r++) {
            for (int peer = 0; peer <= 1; peer++) {
                elementary_case *c = &cases[used++];
                c->what = f;
                c->range = &f->ranges[r];
                c->function = peer ? f->libm : f->ours;
                c->checked = bench_is_quick(b) ? CHECKED_QUICK : CHECKED;
                snprintf(c->name, sizeof c->name, "base/%s-%s/%s", f->name, c->range->name,
                         peer ? "libm" : "ours");
                const bench_batch batch = {.name = c->name,
                                           .user = c,
                                           .items = ARGUMENTS,
                                           .setup = fill_arguments,
                                           .run = runs[f->shape],
                                           .finish = check_errors};
                bench_add_batch(b, &batch);
            }
        }
    }
}
