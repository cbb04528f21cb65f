/* The two clocks of a measurement. They are passed in so that a test can bring its own. */
#ifndef VBSS_BENCH_HARNESS_CLOCK_H
#define VBSS_BENCH_HARNESS_CLOCK_H

#include <stdint.h>

typedef struct bench_clock {
    uint64_t (*cpu_ns)(void *user);  /* CPU time of the calling thread */
    uint64_t (*wall_ns)(void *user); /* monotonic */
    void *user;
} bench_clock;

typedef struct bench_timer_cost {
    double overhead_ns;   /* of one reading of the CPU clock, mean */
    double resolution_ns; /* smallest step it was seen to make */
    /* What a timed interval shows with nothing in it, at least: see bench_interval. */
    uint64_t empty_cpu_ns, empty_wall_ns;
} bench_timer_cost;

/* The CPU clock is read inside the wall clock: it is the one that counts. */
typedef struct bench_interval {
    uint64_t cpu_ns, wall_ns;
} bench_interval;
bench_interval bench_interval_begin(const bench_clock *clock);
bench_interval bench_interval_end(const bench_clock *clock, bench_interval begin);
/* Less the smallest cost of reading the clocks, so that steps of a microsecond can be compared. */
bench_interval bench_interval_net(bench_interval interval, bench_timer_cost cost);

bench_clock bench_system_clock(void);

/* Reads a clock until enough has been seen; ends even when the clock stands still, which then
 * shows as zeros. */
bench_timer_cost bench_measure_timer(const bench_clock *clock);

/* What a timed interval may be wrong by: the larger of the two, at least 1 ns. */
double bench_timer_cost_ns(bench_timer_cost cost);

#endif
