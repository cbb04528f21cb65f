/* Throws that are tied round a tool: loops that slide along it and off its tip, where the states of contacts
 * are hardest to find. What counts beside time is how often a step had to be tried again. */
#include <stdlib.h>

#include "contact/bench_contact.h"
#include "fixtures/throw_scenes.h"

typedef struct throw_case {
    char name[64];
    double segment; /* m; 0: the scene's */
    double finest;  /* if it adapts; m */
    vbss_context *context;
    throw_scene scene, begin;
    uint32_t steps, max_contacts, max_nodes;
    bool twice, adapts, offline;
    bool long_run; /* not in a quick look */
    uint64_t node_sum;
    uint8_t *saved;
    uint64_t saved_bytes;
    vbss_scene_statistics statistics_at_begin;
} throw_case;

/* Both throws; with all the work they take; then the double on finer and on adaptive meshes. */
static throw_case cases[] = {
    {.name = "contact/throw-single/ours/298"},
    {.name = "contact/throw-double/ours/298", .twice = true},
    {.name = "contact/throw-single/ours-offline/298", .offline = true},
    {.name = "contact/throw-double/ours-offline/298", .twice = true, .offline = true},
    {.name = "contact/mesh/throw-double/fine-0.3",
     .long_run = true,
     .twice = true,
     .offline = true,
     .segment = 0.3e-3},
    {.name = "contact/mesh/throw-double/adaptive-0.5",
     .long_run = true,
     .twice = true,
     .adapts = true,
     .offline = true,
     .finest = 0.5e-3},
    {.name = "contact/mesh/throw-double/adaptive-0.25",
     .long_run = true,
     .twice = true,
     .adapts = true,
     .offline = true,
     .finest = 0.3e-3},
};
enum { CASES = sizeof cases / sizeof cases[0] };

static bool make(throw_case *c)
{
    throw_scene_options options;
    if (vbss_context_create(NULL, &c->context) != VBSS_OK ||
        throw_scene_init(&options, c->twice) != VBSS_OK) {
        return false;
    }
    options.segment = c->segment > 0.0 ? c->segment : options.segment;
    options.scene.mode = c->offline ? VBSS_SCENE_MODE_OFFLINE : VBSS_SCENE_MODE_REAL_TIME;
    if (c->adapts) {
        options.thread.mesh = VBSS_THREAD_MESH_ADAPTIVE;
        options.thread.finest_length = c->finest;
        options.thread.node_capacity = 500;
    }
    return throw_scene_create(c->context, &options, &c->scene) == VBSS_OK;
}

static bool save(throw_case *c)
{
    c->begin = c->scene;
    vbss_scene_statistics *s = &c->statistics_at_begin;
    return vbss_scene_save(c->scene.scene, NULL, 0, &c->saved_bytes) == VBSS_ERROR_CAPACITY &&
           (c->saved = malloc(c->saved_bytes)) != NULL &&
           vbss_scene_get_statistics(c->scene.scene, s, sizeof *s) == VBSS_OK &&
           vbss_scene_save(c->scene.scene, c->saved, c->saved_bytes, &c->saved_bytes) == VBSS_OK;
}

/* How many steps the hands take is known when it has been run once. */
static int set_up(void *user)
{
    throw_case *c = user;
    if (!make(c) || !save(c)) {
        return 1;
    }
    c->node_sum = 0;
    for (c->steps = 0; c->scene.phase != THROW_DONE; c->steps++) {
        vbss_scene_statistics s;
        vbss_thread_statistics t;
        if (throw_scene_step(&c->scene) != VBSS_OK ||
            vbss_scene_get_statistics(c->scene.scene, &s, sizeof s) != VBSS_OK ||
            vbss_thread_get_statistics(c->scene.thread, &t, sizeof t) != VBSS_OK) {
            return 1;
        }
        c->node_sum += t.nodes;
        c->max_nodes = t.nodes > c->max_nodes ? t.nodes : c->max_nodes;
        c->max_contacts = s.contacts > c->max_contacts ? s.contacts : c->max_contacts;
    }
    return 0;
}

static uint32_t count_steps(void *user)
{
    return ((throw_case *)user)->steps;
}

static int restore(void *user)
{
    throw_case *c = user;
    c->scene = c->begin;
    return vbss_scene_restore(c->scene.scene, c->saved, c->saved_bytes) == VBSS_OK ? 0 : 1;
}

static int step(void *user, uint32_t index)
{
    (void)index;
    return throw_scene_step(&((throw_case *)user)->scene) == VBSS_OK ? 0 : 1;
}

static uint64_t hash(void *user)
{
    uint64_t value = 0;
    (void)vbss_scene_get_hash(((throw_case *)user)->scene.scene, &value);
    return value;
}

static void finish(void *user, bench_result *result)
{
    throw_case *c = user;
    const vbss_scene_statistics *b = &c->statistics_at_begin;
    vbss_scene_statistics s;
    if (vbss_scene_get_statistics(c->scene.scene, &s, sizeof s) != VBSS_OK) {
        bench_fail(result, "no statistics");
        return;
    }
    double steps = c->steps, tries = (double)(s.attempts - b->attempts);
    bench_simulated_step(result, 1e6 * THROW_SCENE_STEP);
    bench_counter(result, "penetration_um", 1e6 * s.penetration);
    bench_counter(result, "stretch_max", s.stretch_error);
    bench_counter(result, "contacts", c->max_contacts);
    bench_counter(result, "retries", tries - (double)(s.parts - b->parts) + (double)s.clamped);
    bench_counter(result, "clamped", (double)s.clamped);
    bench_counter(result, "attempts_per_step", tries / steps);
    bench_counter(result, "solves_per_step", (double)(s.state_solves - b->state_solves) / steps);
    bench_counter(result, "nodes_mean", (double)c->node_sum / steps);
    bench_counter(result, "nodes_most", c->max_nodes);
    bench_counter(result, "loose_states", (double)s.loose_states);
    bench_counter(result, "paused", (double)s.paused);
    bench_counter(result, "paused_ms", 1e3 * s.time_paused);
}

static void tear_down(void *user)
{
    throw_case *c = user;
    vbss_context_destroy(c->context);
    free(c->saved);
    c->context = NULL;
    c->saved = NULL;
}

void add_throw_cases(bench *b)
{
    for (size_t i = 0; i < CASES; i++) {
        throw_case *c = &cases[i];
        if (c->long_run && bench_is_quick(b)) {
            continue;
        }
        bench_add_stepped(b, &(bench_stepped){.name = c->name,
                                              .user = c,
                                              .dt_us = 1e6 * THROW_SCENE_STEP,
                                              .deadline_us = 1e6 * THROW_SCENE_STEP,
                                              .setup = set_up,
                                              .count = count_steps,
                                              .restore = restore,
                                              .step = step,
                                              .hash = hash,
                                              .finish = finish,
                                              .teardown = tear_down});
    }
}
