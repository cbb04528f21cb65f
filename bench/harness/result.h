/* What a case found out: times, counters, and whether it failed. */
#ifndef VBSS_BENCH_HARNESS_RESULT_H
#define VBSS_BENCH_HARNESS_RESULT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "harness/bench.h"
#include "harness/step_times.h"

enum { BENCH_MAX_COUNTERS = 64, BENCH_MAX_COUNTER_NAME = 48, BENCH_MAX_ERROR = 256 };

typedef struct bench_counter_entry {
    char name[BENCH_MAX_COUNTER_NAME];
    double value;
    bool own; /* set by the harness for every case of its kind, not by the suite */
} bench_counter_entry;

struct bench_result {
    unsigned repetitions;
    uint64_t iterations; /* timed per repetition: steps, or items of a batch */
    double real_time;    /* in time_unit: median step, or item of the fastest batch */
    double cpu_time;
    const char *time_unit; /* NULL until there is a time */
    double call_cpu_ns;    /* of a median step or of one call of a batch, for growth fits */
    double call_wall_ns;
    double mean_step_us;    /* 0 when nothing was stepped */
    bench_step_times steps; /* the least of each, when a pool wants them */
    bench_counter_entry counters[BENCH_MAX_COUNTERS];
    size_t counter_count;
    bool failed;
    char error[BENCH_MAX_ERROR];
};

/* As bench_counter, for the counters that the harness itself writes. */
void bench_own_counter(bench_result *result, const char *name, double value);
const bench_counter_entry *bench_find_counter(const bench_result *result, const char *name);

#endif
