/* What each option of the thread costs: a thread of 300 segments with it and one without it make the same motion, step by step in
 * turns, so that both see the same machine. The least CPU time of each step over all repetitions counts. Counters:
 *   ratio: time with the option over time without it, of all steps;
 *   iteration_ratio: linearisations with the option over those without it.
 * Case off compares two threads without options: its ratio shows how far others may be wrong.
 *
 *     ./bench/run.sh thread --filter thread/options */
#include <string.h>

#include "base/error.h"
#include "thread/bench_thread.h"
#include "harness/clock.h"

#include <vblast_ss/thread.h>

enum { SEGMENTS = 300, STEPS = 300, REPETITIONS = 15, QUICK_REPETITIONS = 3 };
#define STEP_S 1e-3
#define LENGTH_M 0.15
#define SHORTENING 0.3 /* of the length by which two clamps come together */
#define TURN_RAD 6.283185307179586

typedef struct option_case {
    const char *name;
    double yield, relaxation, torsion;
    bool
        is_clamped_twice; /* both ends come together while one rolls; else one is clamped and the thread falls */
    bool is_quick;
} option_case;

static option_case cases[] = {
    {.name = "thread/options/off/300"},
    {.name = "thread/options/plastic/300", .yield = 60.0},
    {.name = "thread/options/viscous/300", .relaxation = 0.5},
    {.name = "thread/options/plastic-viscous/300", .yield = 60.0, .relaxation = 0.5},
    {.name = "thread/options/twist/300", .is_clamped_twice = true, .torsion = 0.7e-8},
};

typedef struct subject {
    vbss_thread *thread;
    uint32_t clamps[2];
} subject;

static vbss_result clamp_end(subject *s, uint32_t node, uint32_t *id)
{
    vbss_thread_attachment a;
    VBSS_TRY(vbss_thread_attachment_init(&a, sizeof a));
    a.kind = VBSS_THREAD_ATTACHMENT_CLAMP;
    a.node = node;
    a.position[0] = LENGTH_M * node / SEGMENTS;
    return vbss_thread_attach(s->thread, &a, id);
}

static vbss_result make(vbss_context *context, const option_case *c, bool with, subject *s)
{
    vbss_thread_config config;
    VBSS_TRY(vbss_thread_config_init(&config, sizeof config));
    config.segment_count = SEGMENTS;
    config.length = LENGTH_M;
    if (with) {
        config.yield_curvature = c->yield;
        config.yield_hardening = c->yield > 0.0 ? 0.2 : 0.0;
        config.relaxation_ratio = c->relaxation;
        config.relaxation_time = 0.1;
        config.torsional_stiffness = c->torsion;
    }
    VBSS_TRY(vbss_thread_create(context, &config, &s->thread));
    VBSS_TRY(clamp_end(s, 0, &s->clamps[0]));
    return c->is_clamped_twice ? clamp_end(s, SEGMENTS, &s->clamps[1]) : VBSS_OK;
}

/* What the host does before a step: no part of its time. */
static vbss_result drive(const option_case *c, subject *s, bool with, uint32_t step)
{
    const double share = (step + 1.0) / STEPS;
    const double target[3] = {LENGTH_M * (1.0 - SHORTENING * share), 0.0, 0.0};
    if (!c->is_clamped_twice) {
        return VBSS_OK;
    }
    VBSS_TRY(vbss_thread_set_attachment_target(s->thread, s->clamps[1], target, NULL));
    return with ? vbss_thread_set_roll(s->thread, s->clamps[1], TURN_RAD * share) : VBSS_OK;
}

typedef struct times {
    double cpu_us[STEPS], wall_us[STEPS];
} times;

static vbss_result step_once(const option_case *c, subject *s, bool with, uint32_t step, bool first,
                             times *minimum)
{
    const bench_clock clock = bench_system_clock();
    VBSS_TRY(drive(c, s, with, step));
    const bench_interval begin = bench_interval_begin(&clock);
    VBSS_TRY(vbss_thread_step(s->thread, STEP_S));
    const bench_interval taken = bench_interval_end(&clock, begin);
    const double cpu = 1e-3 * (double)taken.cpu_ns, wall = 1e-3 * (double)taken.wall_ns;
    if (first || cpu < minimum->cpu_us[step]) {
        minimum->cpu_us[step] = cpu;
    }
    if (first || wall < minimum->wall_us[step]) {
        minimum->wall_us[step] = wall;
    }
    return VBSS_OK;
}

static vbss_result repeat(const option_case *c, vbss_context *context, unsigned repetition,
                          times minimum[2], uint64_t iterations[2])
{
    subject subjects[2];
    for (int k = 0; k < 2; k++) {
        VBSS_TRY(make(context, c, k == 1, &subjects[k]));
    }
    for (uint32_t i = 0; i < STEPS; i++) {
        for (unsigned turn = 0; turn < 2; turn++) { /* who comes first changes with each step */
            const unsigned k = (turn + i + repetition) % 2;
            VBSS_TRY(step_once(c, &subjects[k], k == 1, i, repetition == 0, &minimum[k]));
        }
    }
    for (int k = 0; k < 2; k++) {
        vbss_thread_statistics statistics;
        VBSS_TRY(vbss_thread_get_statistics(subjects[k].thread, &statistics, sizeof statistics));
        iterations[k] = statistics.iterations;
        VBSS_TRY(vbss_thread_destroy(subjects[k].thread));
    }
    return VBSS_OK;
}

static double sum_of(const double *values)
{
    double sum = 0.0;
    for (uint32_t i = 0; i < STEPS; i++) {
        sum += values[i];
    }
    return sum;
}

static vbss_result measure(const option_case *c, vbss_context *context, bench_result *result)
{
    static times minimum[2];
    uint64_t iterations[2] = {0, 0};
    const unsigned repetitions = c->is_quick ? QUICK_REPETITIONS : REPETITIONS;
    memset(minimum, 0, sizeof minimum);
    for (unsigned r = 0; r < repetitions; r++) {
        VBSS_TRY(repeat(c, context, r, minimum, iterations));
    }
    bench_counter(result, "ratio", sum_of(minimum[1].cpu_us) / sum_of(minimum[0].cpu_us));
    bench_counter(result, "iteration_ratio", (double)iterations[1] / (double)iterations[0]);
    bench_counter(result, "without_us", sum_of(minimum[0].cpu_us) / STEPS);
    bench_trial_steps(result, minimum[1].cpu_us, minimum[1].wall_us, STEPS);
    bench_simulated_step(result, STEP_S * 1e6);
    return VBSS_OK;
}

static void run_case(void *user, bench_result *result)
{
    vbss_context *context = NULL;
    vbss_result status = vbss_context_create(NULL, &context);
    if (status == VBSS_OK) {
        status = measure(user, context, result);
        (void)vbss_context_destroy(context);
    }
    if (status != VBSS_OK) {
        bench_fail(result, "%s", vbss_result_name(status));
    }
}

void add_option_cases(bench *b)
{
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        cases[i].is_quick = bench_is_quick(b);
        bench_add_trial(b,
                        &(bench_trial){.name = cases[i].name, .user = &cases[i], .run = run_case});
    }
}
