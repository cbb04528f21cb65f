/* What steps took, one by one: the least of all repetitions. */
#ifndef VBSS_BENCH_HARNESS_STEP_TIMES_H
#define VBSS_BENCH_HARNESS_STEP_TIMES_H

#include <stdbool.h>
#include <stdint.h>

#include "harness/bench.h"

typedef struct bench_step_times {
    uint32_t count;
    uint64_t *cpu_ns, *wall_ns;
} bench_step_times;

/* All zero. False: no memory; it is to be freed then too. */
bool bench_allocate_step_times(bench_step_times *times, uint32_t count);
void bench_free_step_times(bench_step_times *times);
/* Sets the times of a case and its own counters, percentiles and all. dt_us, deadline_us: as in bench_stepped. */
void bench_report_step_times(const bench_step_times *times, double dt_us, double deadline_us,
                             bench_result *result);

#endif
