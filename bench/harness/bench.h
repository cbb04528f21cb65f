/* The bench harness as a suite sees it.
 *
 * A suite is one executable bench_<suite>: main calls bench_main, which calls the suite back to
 * register its cases and runs them. A case is named <suite>/<scene>/<method> or, in a family that
 * grows, <suite>/<scene>/<method>/<N>; within one scene and N the first registered method is the
 * one the others are compared with.
 *
 * Scenes are deterministic, so whatever differs between two repetitions of the same step is the
 * machine's doing: the minimum over repetitions is the time the code needs. */
#ifndef VBSS_BENCH_HARNESS_BENCH_H
#define VBSS_BENCH_HARNESS_BENCH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__)
#define BENCH_PRINTF(format_index, first_index) \
    __attribute__((format(printf, format_index, first_index)))
#else
#define BENCH_PRINTF(format_index, first_index)
#endif

typedef struct bench bench;               /* one run of a suite */
typedef struct bench_result bench_result; /* what one case found out */

/* A scene stepped in time. Only step is timed.
 * Order of calls: setup, count, then per repetition restore and steps 0, 1, ... with before ahead of
 * each, after and hash behind it, then finish, teardown. Callbacks that return int return 0 for success; anything else ends
 * the case as an error. Every callback but step may be NULL. */
typedef struct bench_stepped {
    const char *name;
    void *user;
    uint32_t steps;                /* 0: count tells */
    double dt_us;                  /* simulated time of a step; 0: none, or told in finish */
    double deadline_us;            /* 0: none; else steps above it are counted */
    int (*setup)(void *user);      /* once */
    uint32_t (*count)(void *user); /* number of steps, once it is known after setup */
    int (*restore)(void *user);    /* back to the initial state; needed unless step 0 does it */
    int (*before)(void *user, uint32_t index); /* what leads to a step, but is no part of it */
    int (*step)(void *user, uint32_t index);
    int (*after)(void *user, uint32_t index);
    uint64_t (*hash)(void *user); /* of the state: repetitions that differ are an error */
    void (*finish)(void *user, bench_result *result); /* sets counters */
    void (*teardown)(void *user); /* also after a failure, but not when setup failed */
    const char *pool;             /* name of the pool that its steps belong to; NULL: none */
} bench_stepped;

/* The steps of all stepped cases of this pool that this run measured, as if one case had made them: their least times, and
 * percentiles over them all. dt_us and deadline_us as theirs are. */
typedef struct bench_pool {
    const char *name;
    void *user;
    double dt_us, deadline_us;
    void (*finish)(void *user, bench_result *result); /* may be NULL */
} bench_pool;

/* A kernel too short to be timed alone: run works through `items` items and is called often enough
 * for the timer not to matter. Times are per item. Every callback but run may be NULL. */
typedef struct bench_batch {
    const char *name;
    void *user;
    uint32_t items; /* in one call; 0: count tells */
    int (*setup)(void *user);
    uint32_t (*count)(void *user);
    void (*run)(void *user);
    void (*finish)(void *user, bench_result *result);
    void (*teardown)(void *user);
} bench_batch;

/* Fits time = c N^exponent to the cases <family>/<N> that this run measured with n_min <= N <=
 * n_max (0: no upper end): CPU time of a median step, or of one whole call of a batch. At least
 * three are needed. The case gets the counters exponent, fit_r2, n_min, n_max, points; its time is
 * the fitted one at the largest N. The table shows it below its family when they share a scene. */
typedef struct bench_growth {
    const char *name;
    const char *family;
    uint32_t n_min, n_max;
} bench_growth;

/* An experiment too long to be repeated, that times itself: run is called once and tells with bench_trial_steps what steps took. */
typedef struct bench_trial {
    const char *name;
    void *user;
    void (*run)(void *user, bench_result *result);
} bench_trial;

/* Names and user data must outlive the run; the structs are copied. */
void bench_add_stepped(bench *b, const bench_stepped *stepped);
void bench_add_batch(bench *b, const bench_batch *batch);
void bench_add_growth(bench *b, const bench_growth *growth);
void bench_add_trial(bench *b, const bench_trial *trial);
void bench_add_pool(bench *b, const bench_pool *pool);
/* A case that cannot run here (a peer is not installed) is told, not left out silently. */
void bench_add_skipped(bench *b, const char *name, const char *reason);
/* True for a quick look: a suite may then check fewer arguments. Scenes must stay the same. */
bool bench_is_quick(const bench *b);
/* How many seeds a suite that has such should run: of --seeds, else 5, and 1 for a quick look. */
unsigned bench_seeds(const bench *b);

/* ---- in finish, and in the run of a trial */

/* A counter is an error, a count, any number that belongs beside the time; setting it again
 * replaces it. A value that is not finite makes the case an error. */
void bench_counter(bench_result *result, const char *name, double value);
/* What has been counted so far, the harness's own counters included; NaN when there is none. */
double bench_counter_value(const bench_result *result, const char *name);
/* Sets dt_us, and us_per_ms: CPU microseconds per simulated millisecond, mean over the steps. */
void bench_simulated_step(bench_result *result, double dt_us);
/* Of a trial: what `count` steps took, in us, by the thread's CPU time and by the clock; sorts both. Sets the times of the case and
 * the counters p50_us, p99_us, p999_us, max_us, mean_us (CPU) and wall_p50_us, wall_p99_us, wall_p999_us, wall_max_us. */
void bench_trial_steps(bench_result *result, double *cpu_us, double *wall_us, uint32_t count);
/* Makes the case an error; the first text stays. */
void bench_fail(bench_result *result, const char *format, ...) BENCH_PRINTF(2, 3);

/* ---- keeping the compiler honest. A value passed here counts as used; memory passed here counts
 * as read and changed by somebody unknown, so neither the stores before nor the loads after can be
 * left out. */
#if defined(__GNUC__)
static inline void bench_keep(double value)
{
    __asm__ volatile("" : : "g"(value) : "memory");
}
static inline void bench_keep_u64(uint64_t value)
{
    __asm__ volatile("" : : "g"(value) : "memory");
}
static inline void bench_keep_memory(const void *memory)
{
    __asm__ volatile("" : : "g"(memory) : "memory");
}
#else
/* A call into another file, which must not be built with link-time optimisation. */
void bench_keep(double value);
void bench_keep_u64(uint64_t value);
void bench_keep_memory(const void *memory);
#endif

/* ---- the suite's main: `return bench_main(argc, argv, &suite);`. Exit status 0: all well; 1: a
 * case failed or nothing matched; 2: wrong arguments. */
typedef struct bench_suite {
    const char *name;
    const char *library; /* version and build of what is measured, for the context block */
    void (*add_cases)(bench *b);
} bench_suite;
int bench_main(int argc, char **argv, const bench_suite *suite);

#ifdef __cplusplus
}
#endif

#endif
