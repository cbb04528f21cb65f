/* A run: the cases a suite registered, and how each kind is measured. */
#ifndef VBSS_BENCH_HARNESS_RUN_H
#define VBSS_BENCH_HARNESS_RUN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "harness/bench.h"
#include "harness/clock.h"
#include "harness/options.h"
#include "harness/result.h"

typedef enum bench_kind {
    BENCH_STEPPED,
    BENCH_BATCH,
    BENCH_GROWTH,
    BENCH_TRIAL,
    BENCH_POOL,
    BENCH_SKIPPED
} bench_kind;

enum { BENCH_MAX_NAME = 128 };

/* <suite>/<scene>/<method>[/<N>] taken apart. */
typedef struct bench_name {
    char scene[BENCH_MAX_NAME], method[BENCH_MAX_NAME], n[BENCH_MAX_NAME];
} bench_name;

typedef struct bench_case {
    bench_kind kind;
    const char *name;
    bench_name parts;
    bench_stepped stepped;
    bench_batch batch;
    bench_growth growth;
    bench_trial trial;
    bench_pool pool;
    const char *reason; /* why it is skipped */
    bool selected;
    bool measured;
    bench_result result;
} bench_case;

struct bench {
    const bench_suite *suite;
    bench_options options;
    bench_clock clock;
    bench_timer_cost timer;
    bench_case *cases;
    size_t count, capacity;
    bool failed; /* registration */
    char error[BENCH_MAX_ERROR];
};

/* Registers the suite's cases and selects those that pass the filter. False when a case is not
 * well named or memory ran out; b->error tells. */
bool bench_begin(bench *b, const bench_suite *suite, const bench_options *options,
                 const bench_clock *clock);
/* Measures what is selected, telling progress (NULL: nobody), then fits the growths and makes the pools. */
void bench_run_cases(bench *b, FILE *progress);
/* Cases that failed; a failed growth counts. */
size_t bench_failures(const bench *b);
size_t bench_selected(const bench *b);
void bench_end(bench *b);

/* False unless the name is <suite>/<scene>/<method>[/<N>] with no part empty. */
bool bench_split_name(const char *suite, const char *name, bench_name *parts);

void bench_measure_stepped(const bench *b, const bench_stepped *stepped, bench_result *result);
void bench_measure_trial(const bench_trial *trial, bench_result *result);
void bench_measure_batch(const bench *b, const bench_batch *batch, bench_result *result);
/* True when the growth could be judged: false leaves the case unmeasured, because a filter left out
 * its family. */
bool bench_fit_growth(const bench *b, const bench_growth *growth, bench_result *result);
/* Likewise of a pool, with its cases. */
bool bench_measure_pool(const bench *b, const bench_pool *pool, bench_result *result);

#endif
