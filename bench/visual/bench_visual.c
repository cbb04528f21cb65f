/* Suite visual: what a frame costs, beside 5 % of one at 60 Hz, which is the deadline of 833 us. Every frame all that is
 * shown has moved.
 *   thread  240 segments in a tight helix of eight turns, which swings
 *   drain   of default mesh, whose slit is pulled
 *   task    both, a needle and two graspers
 * at the default tolerances, and at a third of them. Beside the time: vertices, triangles and bytes that a renderer gets. */
#include <math.h>

#include "base/elementary.h"
#include "base/error.h"
#include "base/hash.h"
#include "bench_visual.h"
#include "drain/drain.h"
#include "harness/bench.h"
#include "visual/visual.h"

enum { FRAMES = 200, NODES = 241 };
#define DEADLINE_US (0.05 * 1e6 / 60.0)

typedef struct show {
    const char *name;
    bool thread, drain, tools;
    double finer;
} show;

static const show shows[] = {{"visual/thread/default", true, false, false, 1.0},
                             {"visual/thread/fine", true, false, false, 3.0},
                             {"visual/drain/default", false, true, false, 1.0},
                             {"visual/drain/fine", false, true, false, 3.0},
                             {"visual/task/default", true, true, true, 1.0},
                             {"visual/task/fine", true, true, true, 3.0}};

/* One case runs at a time. */
static vbss_context *context;
static vbss_visual *visual;
static vbss_thread *thread;
static vbss_drain *drain;
static vbss_needle *needle;
static double nodes[3 * NODES], rest[NODES];

static void end_show(void *user)
{
    (void)user;
    (void)vbss_context_destroy(context);
    context = NULL;
    thread = NULL;
    drain = NULL;
    needle = NULL;
}

/* 150 mm; a quarter of it in turns of 3 mm. */
static void place_thread(uint32_t frame)
{
    const double swing = 0.02 * (double)(frame % 32);
    double angle = 0.0, length = 0.15 / (NODES - 1);
    vec3 x = vec3_make(-0.05, 0.02, 0.0);
    for (uint32_t i = 0; i < NODES; i++) {
        vec3_store(nodes + 3 * (size_t)i, x);
        rest[i] = length;
        angle += i > 80 && i < 140 ? length / 1.5e-3 : 0.15 * swing;
        x = vec3_add(
            x, vec3_scale(vec3_make(0.8 * vbss_cos(angle), 0.8 * vbss_sin(angle), 0.6), length));
    }
}

static vbss_result make_thread(void)
{
    vbss_thread_config c;
    VBSS_TRY(vbss_thread_config_init(&c, sizeof c));
    place_thread(0);
    c.segment_count = NODES - 1;
    c.positions = nodes;
    c.rest_lengths = rest;
    VBSS_TRY(vbss_thread_create(context, &c, &thread));
    return vbss_visual_add_thread(visual, thread, NULL);
}

static vbss_result make_drain(void)
{
    vbss_drain_config c;
    VBSS_TRY(vbss_drain_config_init(&c, sizeof c));
    VBSS_TRY(vbss_drain_create(context, &c, &drain));
    return vbss_visual_add_drain(visual, drain, NULL);
}

static vbss_result make_tools(void)
{
    VBSS_TRY(vbss_needle_create(context, NULL, &needle));
    VBSS_TRY(vbss_visual_add_needle(visual, needle, NULL));
    for (int i = 0; i < 2; i++) {
        vbss_grasper *grasper;
        VBSS_TRY(vbss_grasper_create(context, NULL, &grasper));
        VBSS_TRY(vbss_visual_add_grasper(visual, grasper, NULL));
    }
    return VBSS_OK;
}

static vbss_result make(const show *s)
{
    vbss_visual_config c;
    VBSS_TRY(vbss_context_create(NULL, &context));
    VBSS_TRY(vbss_visual_config_init(&c, sizeof c));
    c.tube_tolerance /= s->finer;
    c.surface_tolerance /= s->finer;
    VBSS_TRY(vbss_visual_create(context, &c, &visual));
    if (s->thread) {
        VBSS_TRY(make_thread());
    }
    if (s->drain) {
        VBSS_TRY(make_drain());
    }
    return s->tools ? make_tools() : VBSS_OK;
}

static int begin_show(void *user)
{
    end_show(user);
    return (int)make(user);
}

static int step_show(void *user, uint32_t index)
{
    (void)user;
    (void)index;
    return (int)vbss_visual_update(visual);
}

/* After a frame all moves, outside of what is timed. */
static vbss_result move_all(void)
{
    vbss_visual_statistics s;
    VBSS_TRY(vbss_visual_get_statistics(visual, &s, sizeof s));
    const uint32_t frame = (uint32_t)s.updates;
    if (thread != NULL) {
        place_thread(frame);
        VBSS_TRY(vbss_thread_set_state(thread, nodes, NULL, NODES));
    }
    if (drain != NULL) {
        drain_object *d;
        VBSS_TRY(vbss_drain_open(drain, &d));
        for (uint32_t i = 0; i < d->mesh.node_count; i++) {
            vec3 at = d->mesh.rest[i];
            double pull = 1e-5 * (double)(frame % 32) * vbss_max(at.y, 0.0) / 6.5e-3;
            d->x[i] = vec3_add(at, vec3_make(0.0, 0.0, pull));
        }
    }
    return VBSS_OK;
}

static uint64_t hash_show(void *user)
{
    vbss_view view;
    vbss_hash hash;
    (void)user;
    vbss_hash_begin(&hash);
    if (vbss_visual_get_view(visual, VBSS_VISUAL_VIEW_VERTICES, &view, sizeof view) == VBSS_OK) {
        vbss_hash_add(&hash, view.data, view.count * view.stride_bytes);
    }
    return move_all() == VBSS_OK ? vbss_hash_end(&hash) : 0;
}

static void report(void *user, bench_result *result)
{
    vbss_visual_statistics s;
    (void)user;
    if (vbss_visual_get_statistics(visual, &s, sizeof s) != VBSS_OK) {
        bench_fail(result, "no statistics");
        return;
    }
    bench_counter(result, "vertices", s.vertices);
    bench_counter(result, "triangles", s.triangles);
    bench_counter(result, "kilobytes", 1e-3 * (48.0 * s.vertices + 12.0 * s.triangles));
}

static void add_cases(bench *b)
{
    for (size_t i = 0; i < sizeof shows / sizeof shows[0]; i++) {
        const bench_stepped stepped = {.name = shows[i].name,
                                       .user = (void *)&shows[i],
                                       .steps = FRAMES,
                                       .deadline_us = DEADLINE_US,
                                       .restore = begin_show,
                                       .step = step_show,
                                       .hash = hash_show,
                                       .finish = report,
                                       .teardown = end_show};
        bench_add_stepped(b, &stepped);
    }
    add_replica_cases(b);
}

int main(int argc, char **argv)
{
    const bench_suite suite = {"visual", vbss_build_info(), add_cases};
    return bench_main(argc, argv, &suite);
}
