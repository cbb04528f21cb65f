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

static int by_time(const void *a, const void *b)
{
    const watch_step *x = a, *y = b;
    return (x->time > y->time) - (x->time < y->time);
}

static int by_stage(const void *a, const void *b)
{
    const watch_step *x = a, *y = b;
    return x->stage == y->stage ? by_time(a, b) : x->stage > y->stage ? 1 : -1;
}

void watch_sort(watch_step *steps, uint32_t count)
{
    qsort(steps, count, sizeof *steps, by_time);
}

void watch_sort_stages(watch_step *steps, uint32_t count)
{
    qsort(steps, count, sizeof *steps, by_stage);
}

double watch_quantile(const watch_step *steps, uint32_t count, double share)
{
    uint32_t i = (uint32_t)(share * count);
    return MICRO * steps[i < count ? i : count - 1].time;
}
