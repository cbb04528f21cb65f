/* Suite tuning: which tuned numbers of the library matter. Cases tuning/<folder>/<NAME>, one a number, each of which halves and
 * doubles it in five golden scenes:
 *   <scene>              0: the hash after its last step is the same; 1: halved, it differs; 2: doubled; 3: both
 *   failed               of the ten runs, those in which a step failed, or that crashed or did not end
 *   attempts_*_pct       largest change of the attempts per step among the scenes, as it is halved or doubled
 *   penetration_*_um     largest change of the worst penetration
 *   stretch_*_ppm        largest change of the worst error of a length
 * The library is one built with VBSS_TUNING. Each run is a process of its own, as a number may be too far off to end well. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <vblast_ss/base.h>

#include "harness/bench.h"
#include "harness/clock.h"
#include "tuning/scenes.h"
#include "tuning_variables.h"

enum { MAX_VARIABLES = 512, FACTORS = 2, MAX_RUN_S = 120, CRASHED = -1 };
static const char *const factor_names[FACTORS] = {"halved", "doubled"};

typedef struct number {
    char name[96];
    const tuning_variable *variable;
} number;

static number numbers[MAX_VARIABLES];
static tuning_outcome baseline[TUNING_SCENES];

/* ---- a run */

static void scale(const tuning_variable *v, bool doubled)
{
    if (v->kind == TUNING_DOUBLE) {
        *(double *)v->address *= doubled ? 2.0 : 0.5;
    } else if (v->kind == TUNING_INT) {
        int *n = v->address;
        *n = doubled ? 2 * *n : *n / 2;
    } else {
        unsigned *n = v->address;
        *n = doubled ? 2 * *n : *n / 2;
    }
}

static tuning_outcome run_scene(const tuning_scene *scene)
{
    vbss_context *context;
    tuning_outcome outcome = {.steps = scene->steps};
    outcome.result = (int32_t)vbss_context_create(NULL, &context);
    if (outcome.result == VBSS_OK) {
        bench_clock clock = bench_system_clock();
        bench_interval begin = bench_interval_begin(&clock);
        outcome.result = (int32_t)scene->run(context, scene->steps, &outcome);
        bench_interval run = bench_interval_end(&clock, begin);
        outcome.cpu_us = 1e-3 * (double)run.cpu_ns / (double)scene->steps;
        outcome.wall_us = 1e-3 * (double)run.wall_ns / (double)scene->steps;
        (void)vbss_context_destroy(context);
    }
    return outcome;
}

/* Without a variable, as the library is. */
static tuning_outcome run_apart(const tuning_scene *scene, const tuning_variable *v, bool doubled)
{
    tuning_outcome outcome = {.result = CRASHED};
    int ends[2];
    if (pipe(ends) != 0) {
        return outcome;
    }
    pid_t child = fork();
    if (child == 0) {
        (void)alarm(MAX_RUN_S);
        if (v != NULL) {
            scale(v, doubled);
        }
        tuning_outcome own = run_scene(scene);
        _exit(write(ends[1], &own, sizeof own) == (ssize_t)sizeof own ? 0 : 1);
    }
    (void)close(ends[1]);
    if (child > 0) {
        tuning_outcome own;
        if (read(ends[0], &own, sizeof own) == (ssize_t)sizeof own) {
            outcome = own;
        }
        (void)waitpid(child, NULL, 0);
    }
    (void)close(ends[0]);
    return outcome;
}

/* ---- a number */

static double larger_change(double largest, double change)
{
    return fabs(change) > fabs(largest) ? change : largest;
}

static void count_changes(bench_result *result, const char *what, const char *factor,
                          const char *unit, double change)
{
    char name[64];
    snprintf(name, sizeof name, "%s_%s_%s", what, factor, unit);
    bench_counter(result, name, change);
}

typedef struct changes {
    unsigned differs[TUNING_SCENES]; /* a bit for each factor */
    unsigned failed, run_count;
    double cpu_us[FACTORS * TUNING_SCENES], wall_us[FACTORS * TUNING_SCENES];
} changes;

static void try_factor(const tuning_variable *v, unsigned factor, changes *c, bench_result *result)
{
    double attempts = 0.0, penetration = 0.0, stretch = 0.0;
    for (unsigned i = 0; i < TUNING_SCENES; i++) {
        const tuning_outcome *usual = &baseline[i];
        tuning_outcome own = run_apart(&tuning_scenes[i], v, factor == 1);
        if (own.result != VBSS_OK) {
            c->failed++;
            c->differs[i] |= 1u << factor;
            continue;
        }
        c->differs[i] |= (own.hash != usual->hash ? 1u : 0u) << factor;
        c->cpu_us[c->run_count] = own.cpu_us;
        c->wall_us[c->run_count] = own.wall_us;
        c->run_count++;
        attempts = larger_change(attempts, own.attempts / usual->attempts - 1.0);
        penetration = larger_change(penetration, own.penetration - usual->penetration);
        stretch = larger_change(stretch, own.stretch - usual->stretch);
    }
    count_changes(result, "attempts", factor_names[factor], "pct", 1e2 * attempts);
    count_changes(result, "penetration", factor_names[factor], "um", 1e6 * penetration);
    count_changes(result, "stretch", factor_names[factor], "ppm", 1e6 * stretch);
}

static void run_baseline(bench_result *result)
{
    for (unsigned i = 0; i < TUNING_SCENES && baseline[i].steps == 0; i++) {
        baseline[i] = run_apart(&tuning_scenes[i], NULL, false);
        if (baseline[i].result != VBSS_OK) {
            bench_fail(result, "%s fails as it is", tuning_scenes[i].name);
        }
    }
}

static void run_number(void *user, bench_result *result)
{
    const number *n = user;
    changes c = {.failed = 0};
    run_baseline(result);
    for (unsigned factor = 0; factor < FACTORS; factor++) {
        try_factor(n->variable, factor, &c, result);
    }
    for (unsigned i = 0; i < TUNING_SCENES; i++) {
        bench_counter(result, tuning_scenes[i].name, c.differs[i]);
    }
    bench_counter(result, "failed", c.failed);
    bench_trial_steps(result, c.cpu_us, c.wall_us, c.run_count);
}

static void add_cases(bench *b)
{
    for (unsigned i = 0; i < tuning_variable_count && i < MAX_VARIABLES; i++) {
        number *n = &numbers[i];
        n->variable = &tuning_variables[i];
        snprintf(n->name, sizeof n->name, "tuning/%s/%s", n->variable->folder, n->variable->name);
        bench_add_trial(b, &(bench_trial){n->name, n, run_number});
    }
}

int main(int argc, char **argv)
{
    const bench_suite suite = {"tuning", vbss_build_info(), add_cases};
    return bench_main(argc, argv, &suite);
}
