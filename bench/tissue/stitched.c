/* Case tissue/scene-stitched/ours/137: a double throw above a stitch is tightened until the slit is shut, and held
 * (tests/fixtures/stitch_scenes.h); hands are points.
 *   gap_mm, open_mm  of the slit at the end; at first
 *   pull_N           of a hand at the end
 *   nodes            of the thread
 *   parts, paused, clamped  how it went */
#include "fixtures/stitch_scenes.h"
#include "tissue/scenes.h"

#define STEP_S 1e-3

typedef struct stitched_case {
    vbss_context *context;
    stitch_scene scene;
    double open;
} stitched_case;

static stitched_case stitched;

static void end_stitched(void *user)
{
    stitched_case *c = user;
    (void)vbss_context_destroy(c->context);
    c->context = NULL;
}

static double gap_of(const stitched_case *c)
{
    vbss_drain_gap gap = {.struct_size = sizeof gap};
    (void)vbss_drain_get_gap(c->scene.drain, &gap, sizeof gap);
    return gap.gap;
}

static int begin_stitched(void *user)
{
    stitched_case *c = user;
    static stitch_scene_options options;
    end_stitched(c);
    vbss_result result = vbss_context_create(NULL, &c->context);
    if (result == VBSS_OK) {
        result = stitch_scene_init(&options);
    }
    options.crossings = 5;
    if (result == VBSS_OK) {
        result = stitch_scene_create(c->context, &options, &c->scene);
    }
    c->open = result == VBSS_OK ? gap_of(c) : 0.0;
    return (int)result;
}

static uint32_t count_steps(void *user)
{
    (void)user;
    return STITCH_TIE_STEPS;
}

static int step_stitched(void *user, uint32_t index)
{
    stitched_case *c = user;
    return (int)stitch_scene_tie(&c->scene, index, STEP_S);
}

/* Not timed. */
static uint64_t hash_stitched(void *user)
{
    stitched_case *c = user;
    uint64_t hash = 0;
    (void)vbss_scene_get_hash(c->scene.scene, &hash);
    return hash;
}

static void finish_stitched(void *user, bench_result *result)
{
    stitched_case *c = user;
    vbss_scene_statistics s;
    (void)vbss_scene_get_statistics(c->scene.scene, &s, sizeof s);
    bench_counter(result, "gap_mm", 1e3 * gap_of(c));
    bench_counter(result, "open_mm", 1e3 * c->open);
    bench_counter(result, "pull_N", stitch_scene_pull(&c->scene, 0));
    bench_counter(result, "nodes", c->scene.node_count);
    bench_counter(result, "parts", (double)s.parts);
    bench_counter(result, "paused", (double)s.paused);
    bench_counter(result, "clamped", (double)s.clamped);
}

void add_stitched(bench *b)
{
    bench_add_stepped(b, &(bench_stepped){.name = "tissue/scene-stitched/ours/137",
                                          .user = &stitched,
                                          .count = count_steps,
                                          .dt_us = STEP_S * 1e6,
                                          .deadline_us = 1000.0,
                                          .restore = begin_stitched,
                                          .step = step_stitched,
                                          .hash = hash_stitched,
                                          .finish = finish_stitched,
                                          .teardown = end_stitched});
}
