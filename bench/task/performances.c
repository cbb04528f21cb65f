/* Cases task/fls/<skill>: the whole task by the scripted surgeon of examples/surgeon, once a seed (--seeds), from seed 0 on;
 * task/stitch/expert: a quick look at that, until the thread is drawn through both marks.
 *   completed         share of the seeds for which the session calls the task done
 *   hands_done        in which the hands have made all their stages, the cuts too
 *   certified         in which the knot was certified as 2=1=1 in the end
 *   p50_us ... max_us a call of 1 ms with devices, session and record, over all seeds; the thread's CPU, one run. What hands think
 *                     is not in it
 *   real_time_factor  simulated time, without what was left out, by CPU time
 *   left_out          share of the time that was left out as there was no work left for it
 *   pass_throughs     what met in the same performance, made once more (passed.h); its kinds beside it
 *   repeats           share of the seeds of which that second one ended in the same state
 *   gap_mm            largest, of the slit in the end of a performance in which the hands were done
 *   force_N           largest that a hand feels
 *   clamped, paused, rejected_guard   sums of the scenes' statistics */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "harness/clock.h"
#include "surgeon/surgeon.h"
#include "surgeon/task.h"
#include "task/bench_task.h"
#ifdef VBSS_HAVE_ORACLE
#include "task/passed.h"
#endif

#define STEP_S 1e-3
enum { MAX_STEPS = 300000, NOTATION = 32, KINDS = 7 };

/* Whose hands: more of them need a line more. */
static const char *const skills[] = {"expert", "resident", "novice"};
enum { SKILLS = sizeof skills / sizeof skills[0] };

typedef struct performances {
    char name[64];
    const char *skill;
    surgeon_stage until; /* ends before this one */
    unsigned seeds;
    double *cpu_us, *wall_us;
    uint32_t steps, room;
    double cpu_s;
    unsigned completed, hands_done, certified, repeats;
    double gap, force, left_out_s;
    uint64_t clamped, paused, rejected_guard, passed[KINDS];
} performances;

static performances all[SKILLS];

/* ---- one seed */

typedef struct performance {
    surgeon surgeon;
    task task;
    uint64_t hash;
} performance;

static vbss_result begin(performance *p, const surgeon_options *o)
{
    TRY(surgeon_create(&p->surgeon, o));
    TRY(task_create(&p->task, &p->surgeon.stitch, p->surgeon.stitch.site.rig.record, NULL));
    p->surgeon.stitch.site.rig.session = p->task.session;
    return VBSS_OK;
}

static bool goes_on(const performances *c, const performance *p)
{
    return p->surgeon.stage < c->until && p->surgeon.steps < MAX_STEPS;
}

static void end(performance *p)
{
    (void)vbss_scene_get_hash(p->surgeon.stitch.site.rig.scene, &p->hash);
    throw_rig_destroy(&p->surgeon.stitch.site.rig);
}

static double hand_feels(const hand *h)
{
    vbss_grasper_state g;
    bool good = vbss_grasper_get_state(h->grasper, &g, sizeof g) == VBSS_OK;
    return good ? v_length(v_load(g.hand_force)) : 0.0;
}

static bool keep_time(performances *c, bench_interval taken)
{
    if (c->steps == c->room) {
        uint32_t room = c->room == 0 ? 1u << 17 : 2 * c->room;
        double *cpu = realloc(c->cpu_us, room * sizeof *cpu);
        c->cpu_us = cpu != NULL ? cpu : c->cpu_us;
        double *wall = realloc(c->wall_us, room * sizeof *wall);
        c->wall_us = wall != NULL ? wall : c->wall_us;
        if (cpu == NULL || wall == NULL) {
            return false;
        }
        c->room = room;
    }
    c->cpu_us[c->steps] = 1e-3 * (double)taken.cpu_ns;
    c->wall_us[c->steps++] = 1e-3 * (double)taken.wall_ns;
    c->cpu_s += 1e-9 * (double)taken.cpu_ns;
    return true;
}

static vbss_result count(performances *c, const performance *p)
{
    vbss_scene_statistics s;
    vbss_session_status status;
    vbss_knot_state knot;
    char notation[NOTATION];
    TRY(vbss_scene_get_statistics(p->surgeon.stitch.site.rig.scene, &s, sizeof s));
    TRY(vbss_session_get_status(p->task.session, &status, sizeof status));
    TRY(vbss_knot_detector_get_state(p->task.knots, &knot, sizeof knot));
    TRY(vbss_knot_detector_get_notation(p->task.knots, notation, sizeof notation));
    c->completed += status.phase == VBSS_SESSION_PHASE_DONE;
    c->hands_done += p->surgeon.stage == SURGEON_DONE;
    c->certified += knot.verdict == VBSS_KNOT_VERDICT_CERTIFIED && strcmp(notation, "2=1=1") == 0;
    c->gap = p->surgeon.stage == SURGEON_DONE ? fmax(c->gap, p->surgeon.gap) : c->gap;
    c->clamped += s.clamped;
    c->paused += s.paused;
    c->left_out_s += s.time_paused;
    c->rejected_guard += s.rejected_guard;
    return VBSS_OK;
}

static vbss_result perform(performances *c, performance *p, const surgeon_options *o)
{
    const bench_clock clock = bench_system_clock();
    TRY(begin(p, o));
    while (goes_on(c, p)) {
        bench_interval started = bench_interval_begin(&clock);
        TRY(surgeon_step(&p->surgeon, STEP_S));
        bench_interval taken = bench_interval_end(&clock, started);
        const uint64_t took = (uint64_t)(1e9 * p->surgeon.stitch.site.rig.took);
        const uint64_t thought = taken.cpu_ns > took ? taken.cpu_ns - took : 0;
        taken.cpu_ns = took;
        taken.wall_ns -= thought < taken.wall_ns ? thought : taken.wall_ns;
        if (!keep_time(c, taken)) {
            return VBSS_ERROR_OUT_OF_MEMORY;
        }
        c->force = fmax(c->force, hand_feels(&p->surgeon.stitch.left));
        c->force = fmax(c->force, hand_feels(&p->surgeon.stitch.right));
    }
    return count(c, p);
}

/* ---- once more */

#ifdef VBSS_HAVE_ORACLE
static vbss_result repeat_observed(performances *c, performance *p, const surgeon_options *o)
{
    TRY(begin(p, o));
    passed *watch =
        passed_create(p->surgeon.stitch.site.rig.scene, p->surgeon.stitch.site.drain_body);
    vbss_result result = watch != NULL ? VBSS_OK : VBSS_ERROR_OUT_OF_MEMORY;
    while (result == VBSS_OK && goes_on(c, p)) {
        result = surgeon_step(&p->surgeon, STEP_S);
        if (result == VBSS_OK && !passed_observe(watch)) {
            result = VBSS_ERROR_CAPACITY;
        }
    }
    if (watch != NULL) {
        passed_counts found = passed_get(watch);
        const uint64_t kinds[KINDS] = {passed_sum(&found), found.threads,      found.thread_needle,
                                       found.thread_drain, found.needle_drain, found.tool_drain,
                                       found.in_jaws};
        for (int i = 0; i < KINDS; i++) {
            c->passed[i] += kinds[i];
        }
        if (kinds[0] > 0) {
            printf("seed %lu: first pass-through in step %lu\n", (unsigned long)o->seed,
                   (unsigned long)found.first_step);
        }
    }
    end(p);
    passed_destroy(watch);
    return result;
}
#endif

static vbss_result run_seed(performances *c, uint64_t seed)
{
    static performance p;
    const surgeon_options o = {.seed = seed, .until = c->until, .skill = skill_named(c->skill)};
    vbss_result result = perform(c, &p, &o);
    end(&p);
#ifdef VBSS_HAVE_ORACLE
    uint64_t hash = p.hash;
    if (result == VBSS_OK) {
        result = repeat_observed(c, &p, &o);
        c->repeats += p.hash == hash;
    }
#endif
    return result;
}

/* ---- all of them */

static void report(performances *c, bench_result *result)
{
    bench_trial_steps(result, c->cpu_us, c->wall_us, c->steps);
    bench_simulated_step(result, 1e6 * STEP_S);
    bench_counter(result, "seeds", c->seeds);
    bench_counter(result, "completed", (double)c->completed / c->seeds);
    bench_counter(result, "hands_done", (double)c->hands_done / c->seeds);
    bench_counter(result, "certified", (double)c->certified / c->seeds);
    const double asked_s = STEP_S * c->steps;
    bench_counter(result, "real_time_factor", (asked_s - c->left_out_s) / c->cpu_s);
    bench_counter(result, "left_out", c->left_out_s / asked_s);
#ifdef VBSS_HAVE_ORACLE
    static const char *const kinds[KINDS] = {
        "pass_throughs",       "passed_threads",    "passed_thread_needle", "passed_thread_drain",
        "passed_needle_drain", "passed_tool_drain", "met_in_jaws"};
    for (int i = 0; i < KINDS; i++) {
        bench_counter(result, kinds[i], (double)c->passed[i]);
    }
    bench_counter(result, "repeats", (double)c->repeats / c->seeds);
#endif
    bench_counter(result, "gap_mm", 1e3 * c->gap);
    bench_counter(result, "force_N", c->force);
    bench_counter(result, "clamped", (double)c->clamped);
    bench_counter(result, "paused", (double)c->paused);
    bench_counter(result, "rejected_guard", (double)c->rejected_guard);
}

static void run(void *user, bench_result *result)
{
    performances *c = user;
    for (unsigned seed = 0; seed < c->seeds; seed++) {
        vbss_result r = run_seed(c, seed);
        if (r != VBSS_OK) {
            bench_fail(result, "seed %u: %s", seed, vbss_result_name(r));
        }
    }
    report(c, result);
    free(c->cpu_us);
    free(c->wall_us);
}

void add_performances(bench *b)
{
    bool quick = bench_is_quick(b);
    for (int i = 0; i < (quick ? 1 : (int)SKILLS); i++) {
        performances *c = &all[i];
        c->skill = skills[i];
        c->until = quick ? SURGEON_TIE : SURGEON_DONE;
        c->seeds = bench_seeds(b);
        snprintf(c->name, sizeof c->name, "task/%s/%s", quick ? "stitch" : "fls", c->skill);
        bench_add_trial(b, &(bench_trial){.name = c->name, .user = c, .run = run});
    }
}
