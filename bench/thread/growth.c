/* Stepped scene: a thread of N segments of 1.25 mm, clamped at one end, straight and horizontal at
 * first, falls and swings. Each step is one linearisation whatever N is, so that what grows is the
 * work of one. Method ours takes the hot loops made for this processor, ours-plain those for any; both
 * must reach the same bits.
 *
 * The bar: up to N = 2000 time grows at most as N^1.05. Longer ones show what caches do to it. */
#include <stdio.h>
#include <stdlib.h>

#include "base/error.h"
#include "thread/bench_thread.h"
#include "thread/thread.h"

enum { SIZES = 9, COPIES = 2, STEPS = 200, IN_CACHE = 2000 };
static const uint32_t sizes[SIZES] = {30, 60, 120, 240, 500, 1000, IN_CACHE, 5000, 10000};

#define SEGMENT_M 1.25e-3
#define STEP_S 1e-3

typedef struct swing {
    char name[64];
    uint32_t segments;
    bool plain;
    vbss_context *context;
    vbss_thread *thread;
    uint64_t last_hash;
} swing;

static swing swings[SIZES][COPIES];

static void end_swing(void *user)
{
    swing *s = user;
    vbss_context_destroy(s->context);
    s->context = NULL;
}

static vbss_result make(swing *s)
{
    vbss_thread_config config;
    vbss_thread_attachment clamp;
    thread_object *inside;
    uint32_t id;
    VBSS_TRY(vbss_context_create(NULL, &s->context));
    VBSS_TRY(vbss_thread_config_init(&config, sizeof config));
    config.segment_count = s->segments;
    config.length = s->segments * SEGMENT_M;
    config.iteration_limit = 1;
    config.halving_limit = 0;
    config.stretch_tolerance = 1e-2;
    config.position_tolerance = 1.0;
    VBSS_TRY(vbss_thread_create(s->context, &config, &s->thread));
    VBSS_TRY(vbss_thread_attachment_init(&clamp, sizeof clamp));
    clamp.kind = VBSS_THREAD_ATTACHMENT_CLAMP;
    VBSS_TRY(vbss_thread_attach(s->thread, &clamp, &id));
    VBSS_TRY(vbss_thread_edit(s->thread, &inside));
    inside->system->wide = inside->system->wide && !s->plain;
    return VBSS_OK;
}

static int begin_swing(void *user)
{
    swing *s = user;
    end_swing(s);
    return (int)make(s);
}

static int step_swing(void *user, uint32_t index)
{
    swing *s = user;
    (void)index;
    return (int)vbss_thread_step(s->thread, STEP_S);
}

static uint64_t hash_swing(void *user)
{
    swing *s = user;
    s->last_hash = 0;
    vbss_thread_get_hash(s->thread, &s->last_hash);
    return s->last_hash;
}

static void finish_swing(void *user, bench_result *result)
{
    swing *s = user;
    vbss_thread_statistics statistics;
    if (vbss_thread_get_statistics(s->thread, &statistics, sizeof statistics) != VBSS_OK ||
        statistics.iterations != statistics.substeps) {
        bench_fail(result, "not one linearisation a step");
    }
    for (size_t i = 0; i < SIZES; i++) {
        const swing *ours = &swings[i][0];
        /* 0: left out by a filter */
        if (s->plain && ours->segments == s->segments && ours->last_hash != 0 &&
            ours->last_hash != s->last_hash) {
            bench_fail(result, "other bits than by the loops made for this processor");
        }
    }
    double median_us = bench_counter_value(result, "median_us");
    bench_counter(result, "ns_per_node", 1e3 * median_us / (s->segments + 1.0));
    bench_counter(result, "stretch_max", statistics.stretch_error);
}

void add_growth_cases(bench *b)
{
    static const char *const methods[COPIES] = {"ours", "ours-plain"};
    for (size_t i = 0; i < SIZES; i++) {
        for (size_t copy = 0; copy < COPIES; copy++) {
            swing *s = &swings[i][copy];
            s->segments = sizes[i];
            s->plain = copy == 1;
            snprintf(s->name, sizeof s->name, "thread/growth/%s/%u", methods[copy],
                     (unsigned)sizes[i]);
            if (s->plain && !vbss_wide_is_available()) {
                bench_add_skipped(b, s->name, "no AVX2: ours is the plain one");
                continue;
            }
            bench_add_stepped(b, &(bench_stepped){.name = s->name,
                                                  .user = s,
                                                  .steps = STEPS,
                                                  .dt_us = STEP_S * 1e6,
                                                  .deadline_us = 1000.0,
                                                  .restore = begin_swing,
                                                  .step = step_swing,
                                                  .hash = hash_swing,
                                                  .finish = finish_swing,
                                                  .teardown = end_swing});
        }
    }
    bench_add_growth(b, &(bench_growth){.name = "thread/growth/ours",
                                        .family = "thread/growth/ours",
                                        .n_max = IN_CACHE});
    bench_add_growth(
        b, &(bench_growth){.name = "thread/growth/ours/all", .family = "thread/growth/ours"});
}
