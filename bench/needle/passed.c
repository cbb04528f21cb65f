/* Cases needle/passed/seed-<n>: the scripted hands of examples/needle take the needle from the floor and pass it through both marks,
 * one trial a seed (--seeds), from seed 1 on, with thread, drain, needle, both tools and the record. A step is the scene's; what the
 * hands and their devices do before it is not in it. needle/passed/all has the steps of all seeds.
 *   through       1: through both walls, once each and near their marks, as pass_needle counts it; of all: share of the seeds
 *   right_off_mm, left_off_mm  of the holes from their marks; of all: the farthest
 *   paused, clamped            steps that waited at the work limit, and those that the guard cut short; of all: sums */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "needle/bench_needle.h"
#include "needle/stitch.h"

#define STEP_S 1e-3
#define MAX_S 20.0 /* simulated, of a trial */
#define POOL "needle/passed/all"
enum { ENDS_OTHERWISE = -1 }; /* no result of the library */

typedef struct trial {
    char name[32];
    uint64_t seed;
    uint32_t steps; /* as the first time */
    uint64_t end;   /* hash, likewise */
    bool through;
    double off[2];
    vbss_scene_statistics scene;
} trial;

static stitch now; /* one case runs at a time */
static trial *trials;
static unsigned seeds;

/* ---- one trial */

static void end_trial(void *user)
{
    (void)user;
    throw_rig_destroy(&now.site.rig);
}

static int begin_trial(void *user)
{
    const trial *t = user;
    stitch_plan plan;
    char note[64];
    end_trial(user);
    stitch_plan_usual(&plan);
    snprintf(note, sizeof note, "vbss needle pass seed %lu", (unsigned long)t->seed);
    vbss_result result = stitch_create(&now, t->seed, &plan);
    return (int)(result == VBSS_OK ? throw_rig_begin(&now.site.rig, NULL, note) : result);
}

static bool goes_on(void)
{
    return now.state < STITCH_DONE && now.site.rig.time < MAX_S;
}

static uint64_t hash_trial(void *user)
{
    uint64_t hash = 0;
    (void)user;
    (void)vbss_scene_get_hash(now.site.rig.scene, &hash);
    return hash;
}

static int lead(void *user, uint32_t index)
{
    (void)user;
    (void)index;
    return (int)stitch_lead(&now, STEP_S);
}

static int step(void *user, uint32_t index)
{
    (void)user;
    (void)index;
    return (int)throw_rig_step(&now.site.rig, STEP_S);
}

/* It ends in the step in which it ended the first time, and as it did. */
static int check_step(void *user, uint32_t index)
{
    const trial *t = user;
    vbss_result result = stitch_observe(&now);
    bool last = index + 1 == t->steps;
    bool as_before = goes_on() != last && (!last || hash_trial(NULL) == t->end);
    return result == VBSS_OK && !as_before ? ENDS_OTHERWISE : (int)result;
}

/* Makes it once, untimed, to know how long it is. */
static int know_trial(void *user)
{
    trial *t = user;
    int result = begin_trial(t);
    for (t->steps = 0; result == 0 && goes_on(); t->steps++) {
        result = lead(t, t->steps);
        result = result == 0 ? step(t, t->steps) : result;
        result = result == 0 ? (int)stitch_observe(&now) : result;
    }
    t->end = hash_trial(NULL);
    if (result != 0) {
        end_trial(t);
    }
    return result;
}

static uint32_t count_steps(void *user)
{
    return ((const trial *)user)->steps;
}

static void report(bench_result *result, double through, const double *off,
                   const vbss_scene_statistics *scene)
{
    bench_counter(result, "through", through);
    if (off[SITE_RIGHT] >= 0.0) {
        bench_counter(result, "right_off_mm", 1e3 * off[SITE_RIGHT]);
    }
    if (off[SITE_LEFT] >= 0.0) {
        bench_counter(result, "left_off_mm", 1e3 * off[SITE_LEFT]);
    }
    bench_counter(result, "paused", (double)scene->paused);
    bench_counter(result, "clamped", (double)scene->clamped);
}

static void finish_trial(void *user, bench_result *result)
{
    trial *t = user;
    t->through = stitch_is_through(&now, t->off);
    if (vbss_scene_get_statistics(now.site.rig.scene, &t->scene, sizeof t->scene) != VBSS_OK) {
        bench_fail(result, "no statistics");
    }
    report(result, t->through ? 1.0 : 0.0, t->off, &t->scene);
}

/* ---- all of them */

static void finish_all(void *user, bench_result *result)
{
    double through = 0.0, off[2] = {-1.0, -1.0};
    vbss_scene_statistics sums = {0};
    (void)user;
    for (unsigned i = 0; i < seeds; i++) {
        const trial *t = &trials[i];
        through += t->through ? 1.0 / seeds : 0.0;
        off[SITE_LEFT] = fmax(off[SITE_LEFT], t->off[SITE_LEFT]);
        off[SITE_RIGHT] = fmax(off[SITE_RIGHT], t->off[SITE_RIGHT]);
        sums.paused += t->scene.paused;
        sums.clamped += t->scene.clamped;
    }
    report(result, through, off, &sums);
    bench_counter(result, "seeds", seeds);
}

void add_passed(bench *b)
{
    seeds = bench_seeds(b);
    trials = calloc(seeds, sizeof *trials);
    if (trials == NULL) {
        bench_add_skipped(b, POOL, "out of memory");
        return;
    }
    for (unsigned i = 0; i < seeds; i++) {
        trial *t = &trials[i];
        t->seed = i + 1;
        snprintf(t->name, sizeof t->name, "needle/passed/seed-%u", i + 1);
        bench_add_stepped(b, &(bench_stepped){.name = t->name,
                                              .user = t,
                                              .dt_us = 1e6 * STEP_S,
                                              .deadline_us = 1e6 * STEP_S,
                                              .setup = know_trial,
                                              .count = count_steps,
                                              .restore = begin_trial,
                                              .before = lead,
                                              .step = step,
                                              .after = check_step,
                                              .hash = hash_trial,
                                              .finish = finish_trial,
                                              .teardown = end_trial,
                                              .pool = POOL});
    }
    bench_add_pool(b, &(bench_pool){.name = POOL,
                                    .dt_us = 1e6 * STEP_S,
                                    .deadline_us = 1e6 * STEP_S,
                                    .finish = finish_all});
}
