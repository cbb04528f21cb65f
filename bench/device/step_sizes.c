/* Step sizes from 2 kHz to 60 Hz: what docs/notebook/devices.md says about them. All counters are deterministic.
 *
 * A double throw above a stitch is drawn tight in 0.9 s, then both hands let go for 0.5 s. Limits of work are the defaults, or grow
 * with the step. Beside it a clamped thread falls for 0.1 s; its error is that of the tip, against steps of 1/64 ms. */
#include <math.h>
#include <stdlib.h>

#include "base/error.h"
#include "bench_device.h"
#include "fixtures/solver_of.h"
#include "fixtures/stitch_scenes.h"
#include "harness/clock.h"

#define FALL 0.1
#define TIED 0.9
#define HELD 0.5
enum { REFERENCE_STEPS = 6400, LARGEST_COUNT = 4096 };

typedef struct rate {
    const char *name;
    double hertz, budget; /* limits of work, as a multiple of the defaults */
} rate;

static const rate rates[] = {{"device/steps/2000", 2000.0, 1.0},
                             {"device/steps/2000-less-work", 2000.0, 0.5},
                             {"device/steps/1000", 1000.0, 1.0},
                             {"device/steps/500", 500.0, 1.0},
                             {"device/steps/500-more-work", 500.0, 2.0},
                             {"device/steps/200", 200.0, 1.0},
                             {"device/steps/200-more-work", 200.0, 5.0},
                             {"device/steps/60", 60.0, 1.0},
                             {"device/steps/60-more-work", 60.0, 50.0 / 3.0}};

/* ---- accuracy */

static vbss_result make_thread(vbss_context *context, vbss_scene **scene, vbss_thread **thread)
{
    vbss_thread_config config;
    vbss_thread_attachment clamp;
    uint32_t number;
    VBSS_TRY(vbss_thread_config_init(&config, sizeof config));
    VBSS_TRY(vbss_thread_create(context, &config, thread));
    VBSS_TRY(vbss_thread_attachment_init(&clamp, sizeof clamp));
    clamp.kind = VBSS_THREAD_ATTACHMENT_CLAMP;
    VBSS_TRY(vbss_thread_attach(*thread, &clamp, &number));
    VBSS_TRY(vbss_scene_create(context, NULL, scene));
    return vbss_scene_add_thread(*scene, *thread, &number);
}

static vbss_result fall(vbss_context *context, uint32_t steps, vec3 *tip)
{
    vbss_scene *scene;
    vbss_thread *thread;
    vbss_view view;
    VBSS_TRY(make_thread(context, &scene, &thread));
    for (uint32_t i = 0; i < steps; i++) {
        VBSS_TRY(vbss_scene_step(scene, FALL / steps));
    }
    VBSS_TRY(vbss_thread_get_view(thread, VBSS_THREAD_VIEW_POSITIONS, &view, sizeof view));
    *tip = vec3_load((const double *)view.data + 3 * (view.count - 1));
    return VBSS_OK;
}

/* ---- a throw */

typedef struct outcome {
    double lost_time, held_gap;
    uint64_t paused;
} outcome;

/* Of the steps so far. One rate runs at a time. */
static double cpu_us[LARGEST_COUNT], wall_us[LARGEST_COUNT], operations[LARGEST_COUNT];
static uint32_t step_count;
static uint64_t operations_before;

static vbss_result step(stitch_scene *s, double h)
{
    vbss_scene_statistics statistics;
    const bench_clock clock = bench_system_clock();
    const bench_interval begin = bench_interval_begin(&clock);
    VBSS_TRY(vbss_scene_step(s->scene, h));
    const bench_interval taken = bench_interval_end(&clock, begin);
    VBSS_TRY(vbss_scene_get_statistics(s->scene, &statistics, sizeof statistics));
    cpu_us[step_count] = 1e-3 * (double)taken.cpu_ns;
    wall_us[step_count] = 1e-3 * (double)taken.wall_ns;
    operations[step_count++] = (double)(statistics.operations - operations_before);
    operations_before = statistics.operations;
    return VBSS_OK;
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static vbss_result draw_tight(stitch_scene *s, double h)
{
    const uint32_t steps = (uint32_t)(TIED / h + 0.5);
    for (uint32_t i = 0; i < steps; i++) {
        const uint32_t milliseconds = (uint32_t)(i * h * 1e3); /* hands count steps of 1 ms */
        for (int hand = 0; hand < 2; hand++) {
            vec3 to;
            if (stitch_scene_draws(s, hand, milliseconds, h, &to)) {
                VBSS_TRY(stitch_scene_move(s, hand, to));
            }
        }
        VBSS_TRY(step(s, h));
    }
    return VBSS_OK;
}

static vbss_result hold(stitch_scene *s, double h, outcome *out)
{
    vbss_drain_gap gap;
    vbss_scene_statistics statistics;
    VBSS_TRY(stitch_scene_let_go(s, 0));
    VBSS_TRY(stitch_scene_let_go(s, 1));
    for (uint32_t i = 0; i < (uint32_t)(HELD / h + 0.5); i++) {
        VBSS_TRY(step(s, h));
    }
    VBSS_TRY(vbss_drain_get_gap(s->drain, &gap, sizeof gap));
    VBSS_TRY(vbss_scene_get_statistics(s->scene, &statistics, sizeof statistics));
    *out = (outcome){statistics.time_paused, gap.gap, statistics.paused};
    return VBSS_OK;
}

static vbss_result tie(vbss_context *context, const rate *r, outcome *out)
{
    static stitch_scene_options options;
    static stitch_scene stitch;
    VBSS_TRY(stitch_scene_init(&options));
    options.crossings = 5;
    set_step_operations(&options.scene, (uint32_t)(step_operations(&options.scene) * r->budget));
    set_call_operations(&options.scene, (uint32_t)(call_operations(&options.scene) * r->budget));
    step_count = 0;
    operations_before = 0;
    VBSS_TRY(stitch_scene_create(context, &options, &stitch));
    VBSS_TRY(draw_tight(&stitch, 1.0 / r->hertz));
    return hold(&stitch, 1.0 / r->hertz, out);
}

static vbss_result measure(vbss_context *context, const rate *r, bench_result *result)
{
    vec3 reference, tip;
    outcome out;
    VBSS_TRY(fall(context, REFERENCE_STEPS, &reference));
    VBSS_TRY(fall(context, (uint32_t)(FALL * r->hertz + 0.5), &tip));
    VBSS_TRY(tie(context, r, &out));
    bench_counter(result, "error_mm", 1e3 * vec3_distance(tip, reference));
    qsort(operations, step_count, sizeof *operations, compare);
    bench_counter(result, "operations_p50", operations[step_count / 2]);
    bench_counter(result, "operations_p99", operations[step_count * 99 / 100]);
    bench_trial_steps(result, cpu_us, wall_us, step_count);
    bench_counter(result, "paused", (double)out.paused);
    bench_counter(result, "lost_ms", 1e3 * out.lost_time);
    bench_counter(result, "held_gap_mm", 1e3 * out.held_gap);
    return VBSS_OK;
}

static void run_rate(void *user, bench_result *result)
{
    vbss_context *context = NULL;
    vbss_result r = vbss_context_create(NULL, &context);
    r = r != VBSS_OK ? r : measure(context, user, result);
    if (r != VBSS_OK) {
        bench_fail(result, "%s", vbss_result_string(r));
    }
    (void)vbss_context_destroy(context);
}

void add_step_sizes(bench *b)
{
    for (size_t i = 0; i < sizeof rates / sizeof rates[0]; i++) {
        const bench_trial trial = {
            .name = rates[i].name, .user = (void *)&rates[i], .run = run_rate};
        bench_add_trial(b, &trial);
    }
}
