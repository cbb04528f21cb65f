/* Cases task/double-throw-wound/<method>/<segments>: what finer threads cost while hands go through the motions of a double
 * throw: wind a limb round a tool, take the tail, draw it through (tests/scenes/throw_scenes.h). That script takes less care than a
 * surgeon, and what is tied in the end differs: `wraps` tells. What is tied for sure, but without a tool, is in drawn.c.
 *   wraps      of the throw that is tied in the end, judged without the tools; 0: none
 *   certified  1: and its type is proved
 *   broken     1: the last step that is counted was followed by one without a finite or possible state
 *   contacts, clamped, paused, stretch_max  as in suite contact */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "scenes/throw_scenes.h"
#include "task/bench_task.h"

#include <vblast_ss/knot.h>

#define THREAD_LENGTH 150e-3 /* nearly: of it 3 mm are in the drain */
#define TAKEN_AT 3.5e-3      /* of the tail, from its end */
#define PAPER_DAMPING 0.01   /* or it shakes to pieces (docs/paper-scene.md) */
enum { SIZES = 5, METHODS = 2, WELDED = 1, QUICK_SIZE = 120 /* of the paper's method */ };
static const uint32_t sizes[SIZES] = {30, 60, 120, 240, 480};
static const char *const method_names[METHODS] = {"ours", "paper"};

typedef struct throw_case {
    char name[64];
    uint32_t segments;
    bool paper;
    vbss_context *context;
    throw_scene scene, begin;
    uint32_t steps, most_contacts;
    bool broken;
    uint8_t *saved;
    uint64_t saved_bytes;
} throw_case;

static throw_case cases[METHODS][SIZES];

static bool make(throw_case *c)
{
    throw_scene_options o;
    if (vbss_context_create(NULL, &c->context) != VBSS_OK ||
        throw_scene_init(&o, true) != VBSS_OK) {
        return false;
    }
    o.segment = THREAD_LENGTH / c->segments;
    o.from_tail_end = (uint32_t)fmax(WELDED, floor(TAKEN_AT / o.segment + 0.5));
    if (c->paper) {
        o.scene.method = VBSS_METHOD_PAPER;
        o.thread.method = VBSS_METHOD_PAPER;
        o.thread.paper_damping = PAPER_DAMPING;
    }
    return throw_scene_create(c->context, &o, &c->scene) == VBSS_OK;
}

static bool save(throw_case *c)
{
    c->begin = c->scene;
    return vbss_scene_save(c->scene.scene, NULL, 0, &c->saved_bytes) == VBSS_ERROR_CAPACITY &&
           (c->saved = malloc(c->saved_bytes)) != NULL &&
           vbss_scene_save(c->scene.scene, c->saved, c->saved_bytes, &c->saved_bytes) == VBSS_OK;
}

/* How many steps the hands take is known when it has been run once. */
static int set_up(void *user)
{
    throw_case *c = user;
    if (!make(c) || !save(c)) {
        return 1;
    }
    c->broken = false;
    for (c->steps = 0; c->scene.phase != THROW_DONE; c->steps++) {
        vbss_scene_statistics s;
        c->broken = throw_scene_step(&c->scene) != VBSS_OK;
        if (c->broken) {
            break;
        }
        if (vbss_scene_get_statistics(c->scene.scene, &s, sizeof s) != VBSS_OK) {
            return 1;
        }
        c->most_contacts = s.contacts > c->most_contacts ? s.contacts : c->most_contacts;
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

/* ---- what is tied */

static vbss_result judge(throw_case *c, vbss_knot_state *state, vbss_knot_throw *first)
{
    const throw_scene *s = &c->scene;
    vbss_knot_detector *detector;
    vbss_knot_input in;
    vbss_view x;
    VBSS_TRY(vbss_thread_get_view(s->thread, VBSS_THREAD_POSITIONS, &x, sizeof x));
    VBSS_TRY(vbss_knot_detector_create(c->context, NULL, &detector));
    VBSS_TRY(vbss_knot_input_init(&in, sizeof in));
    in.points = x.data;
    in.point_count = s->nodes;
    in.hole_count = 2;
    in.away[2] = -1.0;
    const uint32_t marks[2] = {s->right_mark, s->left_mark};
    for (int i = 0; i < 2; i++) {
        vec3_store(in.holes[i], ((const vec3 *)x.data)[marks[i]]);
        in.hole_places[i] = marks[i];
    }
    VBSS_TRY(vbss_knot_detector_judge(detector, &in));
    VBSS_TRY(vbss_knot_detector_get_state(detector, state, sizeof *state));
    return state->throw_count > 0 ? vbss_knot_detector_get_throw(detector, 0, first, sizeof *first)
                                  : VBSS_OK;
}

static void finish(void *user, bench_result *result)
{
    throw_case *c = user;
    vbss_scene_statistics s;
    vbss_knot_state knot;
    vbss_knot_throw first = {0};
    if (vbss_scene_get_statistics(c->scene.scene, &s, sizeof s) != VBSS_OK ||
        judge(c, &knot, &first) != VBSS_OK) {
        bench_fail(result, "nobody can say what is tied");
        return;
    }
    bench_counter(result, "wraps", knot.throw_count == 1 ? first.wraps : 0.0);
    bench_counter(result, "certified", knot.verdict == VBSS_KNOT_VERDICT_CERTIFIED);
    bench_counter(result, "broken", c->broken);
    bench_counter(result, "contacts", c->most_contacts);
    bench_counter(result, "clamped", (double)s.clamped);
    bench_counter(result, "paused", (double)s.paused);
    bench_counter(result, "stretch_max", s.stretch_error);
}

static void tear_down(void *user)
{
    throw_case *c = user;
    vbss_context_destroy(c->context);
    free(c->saved);
    c->context = NULL;
    c->saved = NULL;
}

void add_wound_cases(bench *b)
{
    for (int m = 0; m < METHODS; m++) {
        for (int i = 0; i < SIZES; i++) {
            throw_case *c = &cases[m][i];
            if (m > 0 && sizes[i] > QUICK_SIZE && bench_is_quick(b)) {
                continue;
            }
            c->segments = sizes[i];
            c->paper = m == 1;
            snprintf(c->name, sizeof c->name, "task/double-throw-wound/%s/%u", method_names[m],
                     sizes[i]);
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
    bench_add_growth(b, &(bench_growth){.name = "task/double-throw-wound/ours-growth",
                                        .family = "task/double-throw-wound/ours"});
}
