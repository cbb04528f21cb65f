/* Case tissue/scene-pierced/ours/137: a needle through both walls of a drain and back out (tests/fixtures/puncture_scenes.h).
 *   peak_N, peak2_N  most that drives it along its arc up to the first entry, and from there to the second
 *   back_N        most that it is held back with on the way out
 *   events        entries and exits: 4
 *   parts, paused, clamped  how it went */
#include "base/linear.h"
#include "fixtures/puncture_scenes.h"
#include "tissue/scenes.h"

#define STEP_S 1e-3

typedef struct pierced_case {
    vbss_context *context;
    puncture_scene scene;
    double peak[2], back;
    uint32_t entries, exits;
} pierced_case;

static pierced_case pierced;

static void end_pierced(void *user)
{
    pierced_case *c = user;
    (void)vbss_context_destroy(c->context);
    c->context = NULL;
}

static int begin_pierced(void *user)
{
    pierced_case *c = user;
    vbss_scene_config scene;
    vbss_drain_config drain;
    end_pierced(c);
    *c = (pierced_case){0};
    vbss_result result = vbss_context_create(NULL, &c->context);
    if (result == VBSS_OK) {
        result = puncture_scene_configs(&scene, &drain);
    }
    if (result == VBSS_OK) {
        result = puncture_scene_create(c->context, &scene, &drain, &c->scene);
    }
    return (int)result;
}

static uint32_t count_steps(void *user)
{
    (void)user;
    const puncture_scene usual = {.speed = PUNCTURE_SCENE_SPEED};
    return puncture_scene_steps(&usual, STEP_S);
}

static int step_pierced(void *user, uint32_t index)
{
    pierced_case *c = user;
    (void)index;
    return (int)puncture_scene_step(&c->scene, STEP_S);
}

/* Not timed: what the step has left is looked at as well. */
static uint64_t hash_pierced(void *user)
{
    pierced_case *c = user;
    uint64_t hash = 0;
    double push = 0.0;
    if (puncture_scene_push(&c->scene, &push) == VBSS_OK && c->entries < 2) {
        c->peak[c->entries] = vbss_max(push, c->peak[c->entries]);
    }
    c->back = vbss_max(-push, c->back);
    uint32_t entered = puncture_scene_count(&c->scene, VBSS_SCENE_EVENT_PUNCTURE);
    if (entered > 0 && c->entries < 2) { /* pushed with in the step in which it entered */
        c->entries += entered;
    }
    c->exits += puncture_scene_count(&c->scene, VBSS_SCENE_EVENT_WITHDRAWN);
    (void)vbss_scene_get_hash(c->scene.scene, &hash);
    return hash;
}

static void finish_pierced(void *user, bench_result *result)
{
    pierced_case *c = user;
    vbss_scene_statistics s;
    (void)vbss_scene_get_statistics(c->scene.scene, &s, sizeof s);
    bench_counter(result, "peak_N", c->peak[0]);
    bench_counter(result, "peak2_N", c->peak[1]);
    bench_counter(result, "back_N", c->back);
    bench_counter(result, "events", (double)c->entries + c->exits);
    bench_counter(result, "parts", (double)s.parts);
    bench_counter(result, "paused", (double)s.paused);
    bench_counter(result, "clamped", (double)s.clamped);
}

void add_pierced(bench *b)
{
    bench_add_stepped(b, &(bench_stepped){.name = "tissue/scene-pierced/ours/137",
                                          .user = &pierced,
                                          .count = count_steps,
                                          .dt_us = STEP_S * 1e6,
                                          .deadline_us = 1000.0,
                                          .restore = begin_pierced,
                                          .step = step_pierced,
                                          .hash = hash_pierced,
                                          .finish = finish_pierced,
                                          .teardown = end_pierced});
}
