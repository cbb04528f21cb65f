/* Order statistics and fits: pure functions. */
#ifndef VBSS_BENCH_HARNESS_STATS_H
#define VBSS_BENCH_HARNESS_STATS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

void bench_sort(double *values, size_t count);

/* Nearest rank: the smallest value such that at least permille / 1000 of all values are not above
 * it, that is the one of rank ceil(permille * count / 1000), counted from 1. Always a value that
 * occurred, never between two; the median of an even number is the lower middle one. Given in per
 * mille because 99.9 % has no exact double and the rank must not depend on rounding.
 * NaN when there are no values. */
double bench_percentile(const double *sorted, size_t count, unsigned permille);

/* best[i] = min(best[i], sample); `first` overwrites whatever stands there. */
void bench_keep_minimum(uint64_t *best, size_t index, uint64_t sample, bool first);

typedef struct bench_power_fit {
    double exponent;
    double scale; /* y = scale * x^exponent */
    double r2;    /* of the straight line in logarithms; 1 when all y are equal */
} bench_power_fit;

/* Least squares in logarithms. False unless all values are positive and finite and at least two x
 * differ. */
bool bench_fit_power(const double *x, const double *y, size_t count, bench_power_fit *fit);

#endif
