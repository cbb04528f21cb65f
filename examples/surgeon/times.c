/* What time it is, and quantiles. */
#include <stdlib.h>
#include <time.h>

#include "surgeon/watch.h"

#define MICRO 1e6

double watch_wall_clock(void)
{
    struct timespec t;
    (void)clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

void watch_sort(double *times, uint32_t count)
{
    qsort(times, count, sizeof *times, by_size);
}

double watch_quantile(const double *times, uint32_t count, double share)
{
    uint32_t i = (uint32_t)(share * count);
    return MICRO * times[i < count ? i : count - 1];
}
