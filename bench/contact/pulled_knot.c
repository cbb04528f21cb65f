#include "contact/pulled_knot.h"

#include <stdlib.h>
#include <string.h>

#include "base/error.h"
#include "collision/closest.h"
#include "scene/world/scene_data.h"

#define LOAD_N 2.0
#define LOAD_REACHED_N 1.99
#define SPEED 0.025
#define HELD_STEPS 1000u
/* A knot is laid out as a curve whose strands overlap a little; to part them is no pulling, and not timed.
 * The paper's method has no such beginning: it may be lost at once. */
#define LAID_STEPS 4u
/* Steps between measurements of the strands' distance. */
#define SAMPLE_EVERY 16u

void pulled_knot_init(pulled_knot *k, knot_kind kind, vbss_method method)
{
    *k = (pulled_knot){.h = 1e-3, .max_steps = 4000};
    (void)contact_scene_init(&k->options, CONTACT_SCENE_PULLED);
    k->options.knot.kind = kind;
    k->options.knot.length = 0.15;
    k->options.pull = (contact_pull){SPEED, LOAD_N, 0.0};
    k->options.scene.method = k->options.thread.method = method;
    if (method == VBSS_METHOD_VBLAST) {
        k->options.knot.rest = KNOT_REST_CHORDS;
    }
}

/* ---- looking */

static const thread_object *inside(const pulled_knot *k)
{
    thread_object *t = NULL;
    (void)vbss_thread_open(k->scene.threads[0], &t);
    return t;
}

double pulled_knot_min_distance(const vec3 *x, uint32_t nodes, const double *rest, double length,
                                double apart)
{
    double smallest = 1.0;
    for (uint32_t a = 0; a + 1 < nodes; a++) {
        double arc = 0.0;
        for (uint32_t b = a + 2; b + 1 < nodes; b++) {
            arc += rest != NULL ? rest[b - 1] : length;
            if (arc < apart) {
                continue;
            }
            double s, u;
            vec3 separation = closest_between_edges(
                vec3_sub(x[a + 1], x[a]), vec3_sub(x[b + 1], x[b]), vec3_sub(x[b], x[a]), &s, &u);
            smallest = vbss_min(vec3_norm(separation), smallest);
        }
    }
    return smallest;
}

static double min_distance(const thread_object *t)
{
    return pulled_knot_min_distance(t->now.x, t->node_count, t->rest, 0.0, 3.2 * t->config.radius);
}

static double taken_up(const thread_object *t)
{
    double length = 0.0;
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        length += t->rest[i];
    }
    return length - vec3_distance(t->now.x[0], t->now.x[t->node_count - 1]);
}

static uint64_t rejected(const vbss_scene_statistics *s)
{
    return s->rejected_states + s->rejected_stretch + s->rejected_depth + s->rejected_guard +
           s->rejected_singular + s->rejected_full;
}

static bool loaded(const pulled_knot *k)
{
    return contact_scene_pull_felt(&k->scene) >= LOAD_REACHED_N;
}

/* ---- running */

/* As the paper keeps a knot: both strands, where they cross nearest to each other. */
static vbss_result pin_crossing(pulled_knot *k)
{
    const thread_object *t = inside(k);
    uint32_t nodes[2] = {0, 0}, last = t->node_count - 1, pin;
    double smallest = 1.0;
    for (uint32_t a = 1; a < last; a++) {
        for (uint32_t b = a + 3; b < last; b++) {
            double distance = vec3_distance(t->now.x[a], t->now.x[b]);
            if (distance < smallest) {
                smallest = distance;
                nodes[0] = a;
                nodes[1] = b;
            }
        }
    }
    for (int i = 0; i < 2; i++) {
        VBSS_TRY(vbss_scene_pin_thread(k->scene.scene, k->scene.thread_bodies[0], nodes[i], 0, NULL,
                                       &pin));
    }
    return VBSS_OK;
}

bool pulled_knot_make(pulled_knot *k)
{
    return vbss_context_create(NULL, &k->context) == VBSS_OK &&
           contact_scene_create(k->context, &k->options, &k->scene) == VBSS_OK &&
           (!k->pinned || pin_crossing(k) == VBSS_OK);
}

static bool place(pulled_knot *k)
{
    bool fine = true, paper = k->options.scene.method == VBSS_METHOD_VBLAST;
    for (uint32_t i = 0; i < (paper ? 0 : LAID_STEPS) && fine; i++) {
        fine = contact_scene_step(&k->scene, k->h) == VBSS_OK;
    }
    return fine;
}

bool pulled_knot_run(pulled_knot *k)
{
    for (k->steps_to_load = 0; k->steps_to_load < k->max_steps && (k->whole || !loaded(k));
         k->steps_to_load++) {
        if (contact_scene_step(&k->scene, k->h) != VBSS_OK) {
            k->broken = true; /* no finite state */
            break;
        }
    }
    k->taken_up = taken_up(inside(k));
    return true;
}

static bool save(pulled_knot *k)
{
    vbss_scene_statistics s;
    k->scene_at_begin = k->scene;
    if (vbss_scene_save(k->scene.scene, NULL, 0, &k->saved_bytes) != VBSS_ERROR_CAPACITY ||
        (k->saved = malloc(k->saved_bytes)) == NULL ||
        vbss_scene_get_statistics(k->scene.scene, &s, sizeof s) != VBSS_OK) {
        return false;
    }
    k->rejected_at_begin = rejected(&s);
    return vbss_scene_save(k->scene.scene, k->saved, k->saved_bytes, &k->saved_bytes) == VBSS_OK;
}

/* A pulled case must know how many steps it takes, so it is run once before. */
static int set_up(void *user)
{
    pulled_knot *k = user;
    k->samples = k->node_steps = k->max_nodes = 0;
    k->node_sum = 0;
    k->broken = false;
    k->min_distance = 1.0;
    if (!pulled_knot_make(k) || (!k->held && (!place(k) || !save(k))) || !pulled_knot_run(k) ||
        (k->held && !save(k))) {
        return 1;
    }
    return 0;
}

static uint32_t count_steps(void *user)
{
    const pulled_knot *k = user;
    return k->held ? HELD_STEPS : k->steps_to_load + k->hold_steps;
}

static int restore(void *user)
{
    pulled_knot *k = user;
    k->scene = k->scene_at_begin;
    return vbss_scene_restore(k->scene.scene, k->saved, k->saved_bytes) == VBSS_OK ? 0 : 1;
}

static int step(void *user, uint32_t index)
{
    pulled_knot *k = user;
    (void)index;
    return contact_scene_step(&k->scene, k->h) == VBSS_OK ? 0 : 1;
}

static void count_nodes(pulled_knot *k)
{
    uint32_t nodes = inside(k)->node_count;
    if (k->node_steps < count_steps(k)) {
        k->node_sum += nodes;
        k->node_steps++;
        k->max_nodes = nodes > k->max_nodes ? nodes : k->max_nodes;
    }
}

static uint64_t hash(void *user)
{
    pulled_knot *k = user;
    uint64_t value = 0;
    (void)contact_scene_hash(&k->scene, &value);
    count_nodes(k);
    if (k->samples < count_steps(k) && k->samples++ % SAMPLE_EVERY == 0) {
        k->min_distance = vbss_min(min_distance(inside(k)), k->min_distance);
    }
    return value;
}

static bool topology_kept(const pulled_knot *k)
{
    const thread_object *t = inside(k);
    knot_type right = knot_type_of_kind(k->options.knot.kind, k->options.knot.mirrored), found;
    return knot_type_of(t->now.x, t->node_count, &found) && knot_type_same(found, right);
}

static void finish(void *user, bench_result *result)
{
    pulled_knot *k = user;
    const thread_object *t = inside(k);
    vbss_scene_statistics s;
    if (vbss_scene_get_statistics(k->scene.scene, &s, sizeof s) != VBSS_OK) {
        bench_fail(result, "no statistics");
        return;
    }
    bench_simulated_step(result, 1e6 * k->h);
    bench_counter(result, "penetration_um",
                  1e6 * vbss_max(2.0 * t->config.radius - k->min_distance, 0.0));
    bench_counter(result, "stretch_max", t->statistics.stretch_error);
    bench_counter(result, "topology_kept", topology_kept(k) ? 1.0 : 0.0);
    bench_counter(result, "contacts", s.contacts);
    bench_counter(result, "separators", s.separators);
    bench_counter(result, "retries", (double)(rejected(&s) - k->rejected_at_begin));
    bench_counter(result, "clamped", (double)s.clamped);
    bench_counter(result, "most_operations", (double)s.most_operations);
    bench_counter(result, "paused", (double)s.paused);
    bench_counter(result, "paused_ms", 1e3 * s.time_paused);
    bench_counter(result, "parts", (double)s.parts);
    bench_counter(result, "force_N", contact_scene_pull_felt(&k->scene));
    bench_counter(result, "taken_up_mm", 1e3 * taken_up(t));
    bench_counter(result, "nodes_mean",
                  (double)k->node_sum / (k->node_steps > 0 ? k->node_steps : 1));
    bench_counter(result, "nodes_most", k->max_nodes);
    bench_counter(result, "broken", k->broken ? 1.0 : 0.0);
    if (k->more != NULL) {
        k->more(result);
    }
}

void pulled_knot_end(pulled_knot *k)
{
    vbss_context_destroy(k->context);
    free(k->saved);
    k->context = NULL;
    k->saved = NULL;
}

static void tear_down(void *user)
{
    pulled_knot_end(user);
}

void pulled_knot_add(bench *b, pulled_knot *k)
{
    bench_add_stepped(b, &(bench_stepped){.name = k->name,
                                          .user = k,
                                          .dt_us = 1e6 * k->h,
                                          .deadline_us = 1e6 * k->h,
                                          .setup = set_up,
                                          .count = count_steps,
                                          .restore = restore,
                                          .step = step,
                                          .hash = hash,
                                          .finish = finish,
                                          .teardown = tear_down});
}
