#include "harness/stats.h"

#include <math.h>
#include <stdlib.h>

static int compare_values(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

void bench_sort(double *values, size_t count)
{
    if (count > 1) {
        qsort(values, count, sizeof *values, compare_values);
    }
}

double bench_percentile(const double *sorted, size_t count, unsigned permille)
{
    if (count == 0) {
        return (double)NAN;
    }
    uint64_t rank = ((uint64_t)count * permille + 999u) / 1000u;
    if (rank < 1) {
        rank = 1;
    }
    if (rank > count) {
        rank = count;
    }
    return sorted[rank - 1];
}

void bench_keep_minimum(uint64_t *best, size_t index, uint64_t sample, bool first)
{
    if (first || sample < best[index]) {
        best[index] = sample;
    }
}

bool bench_fit_power(const double *x, const double *y, size_t count, bench_power_fit *fit)
{
    double mean_x = 0.0, mean_y = 0.0;
    for (size_t i = 0; i < count; i++) {
        if (!(x[i] > 0.0) || !(y[i] > 0.0) || !isfinite(x[i]) || !isfinite(y[i])) {
            return false;
        }
        mean_x += log(x[i]) / (double)count;
        mean_y += log(y[i]) / (double)count;
    }
    double xx = 0.0, xy = 0.0, yy = 0.0;
    bool x_differ = false;
    for (size_t i = 0; i < count; i++) {
        double dx = log(x[i]) - mean_x, dy = log(y[i]) - mean_y;
        xx += dx * dx;
        xy += dx * dy;
        yy += dy * dy;
        x_differ = x_differ || x[i] > x[0] || x[i] < x[0];
    }
    if (!x_differ) {
        return false;
    }
    fit->exponent = xy / xx;
    fit->scale = exp(mean_y - fit->exponent * mean_x);
    /* Below this the y are equal up to rounding and a quotient of rounding errors says nothing. */
    fit->r2 = yy > 1e-24 * (double)count ? xy * xy / (xx * yy) : 1.0;
    return true;
}
