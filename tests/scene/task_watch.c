#include "scene/task_watch.h"

enum { MAX_CHAINS = 64, MAX_NODES = 128 };
static const double at_swage = 2e-3; /* of the thread, which does not touch the needle, m */
static const double at_hole = 4.0; /* a crossing is so near to its hole, in distances of touching */

/* ---- what there is */

static void count_node(task_watch *w, const scene_object *s, vec3 x)
{
    if (s->config.floor != 0 && !(vec3_dot(x, s->floor_normal) > s->config.floor_height)) {
        w->below++;
    }
}

static void count_nodes(task_watch *w, const scene_object *s, const vec3 *x, const vec3 *v,
                        uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        count_node(w, s, x[i]);
        w->fastest = vbss_max(w->fastest, vec3_norm(v[i]));
    }
}

static void count_bodies(task_watch *w, const scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_THREAD) {
            const thread_object *t = b->thread.thread;
            count_nodes(w, s, t->trial, t->now.v, t->node_count);
        } else if (b->kind == SCENE_BODY_DRAIN) {
            const drain_object *d = b->drain.drain;
            count_nodes(w, s, d->trial, d->v, d->mesh.node_count);
        } else {
            for (uint32_t c = 0; c < b->rigid.capsule_count; c++) {
                count_node(w, s, s->capsules[b->rigid.first_capsule + c].trial[0]);
                count_node(w, s, s->capsules[b->rigid.first_capsule + c].trial[1]);
            }
        }
    }
}

typedef struct task_chains {
    passing_chain all[MAX_CHAINS];
    uint32_t bodies[MAX_CHAINS];
    size_t count;
} task_chains;

static void add_chain(task_chains *c, const vec3 *start, const vec3 *end, size_t nodes, bool tool,
                      uint32_t body)
{
    assert_true(c->count < MAX_CHAINS);
    c->bodies[c->count] = body;
    c->all[c->count++] = (passing_chain){start, end, nodes, tool};
}

/* Without the needle's. */
static void gather_axes_of_tools(const task_watch *w, const scene_object *s, task_chains *c)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        for (uint32_t k = 0; b->kind == SCENE_BODY_RIGID && b->number != w->needle.needle &&
                             k < b->rigid.capsule_count;
             k++) {
            const scene_capsule *capsule = &s->capsules[b->rigid.first_capsule + k];
            add_chain(c, capsule->now, capsule->trial, 2, true, b->number);
        }
    }
}

/* Whole, or without the part at the swage. */
static void gather_threads(const scene_object *s, bool trims, bool tool, task_chains *c)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->kind != SCENE_BODY_THREAD) {
            continue;
        }
        const thread_object *t = b->thread.thread;
        uint32_t first = 0;
        double arc = 0.0;
        while (trims && first + 2 < t->node_count && arc < at_swage) {
            arc += vec3_distance(t->now.x[first], t->now.x[first + 1]);
            first++;
        }
        add_chain(c, t->now.x + first, t->trial + first, t->node_count - first, tool, b->number);
    }
}

/* ---- queries */

/* The needle's axis, which is one line, against threads. */
static uint64_t ask_needle(const task_watch *w, const scene_object *s)
{
    const scene_body *needle = vbss_scene_body(s, w->needle.needle);
    vec3 start[MAX_NODES], end[MAX_NODES];
    task_chains c = {.count = 0};
    uint32_t n = 0;
    for (uint32_t i = 0; needle != NULL && i < needle->rigid.capsule_count; i++) {
        const scene_capsule *capsule = &s->capsules[needle->rigid.first_capsule + i];
        assert_true(n + 2 < MAX_NODES);
        assert_true(n == 0 || vec3_distance(start[n], capsule->now[0]) < 1e-12);
        start[n] = capsule->now[0], end[n] = capsule->trial[0];
        n++;
        start[n] = capsule->now[1], end[n] = capsule->trial[1];
    }
    if (n == 0) {
        return 0;
    }
    add_chain(&c, start, end, n + 1, false, 0);
    gather_threads(s, true, true, &c);
    return passing_count(c.all, c.count, NULL);
}

/* Axes of tools against those of other tools and of the needle. */
static uint64_t ask_tools(const task_watch *w, const scene_object *s, const task_chains *tools)
{
    const scene_body *needle = vbss_scene_body(s, w->needle.needle);
    task_chains c = *tools;
    uint64_t passed = 0;
    for (uint32_t i = 0; needle != NULL && i < needle->rigid.capsule_count; i++) {
        const scene_capsule *capsule = &s->capsules[needle->rigid.first_capsule + i];
        add_chain(&c, capsule->now, capsule->trial, 2, true, needle->number);
    }
    for (size_t i = 0; i < c.count; i++) {
        for (size_t k = i + 1; k < c.count; k++) {
            passing_chain both[2] = {c.all[i], c.all[k]};
            both[0].tool = both[1].tool = false;
            passed += c.bodies[i] == c.bodies[k] ? 0 : passing_count(both, 2, NULL);
        }
    }
    return passed;
}

static void see(void *watcher, const scene_object *s)
{
    task_watch *w = watcher;
    task_chains tools = {.count = 0}, all;
    passing_surface_report report;
    gather_axes_of_tools(w, s, &tools);
    all = tools;
    gather_threads(s, false, false, &all);
    w->substeps++;
    w->passed += passing_count(all.all, all.count, NULL);
    w->passed += ask_needle(w, s) + ask_tools(w, s, &tools);
    w->passed_drain += drain_watch_passed(&w->drains, s, tools.all, tools.count, &report);
    needle_watch_observe(&w->needle, s);
    count_bodies(w, s);
}

/* ---- watching */

void task_watch_begin(task_watch *w, vbss_scene *scene)
{
    scene_object *s;
    expect_ok(vbss_scene_open(scene, &s));
    memset(w, 0, sizeof *w);
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_DRAIN) {
            const vbss_drain_config *d = &b->drain.drain->config;
            w->needle.drain = b->number;
            w->needle.give = 1.0 / d->hole_stiffness;
            w->needle.touching += at_hole * 0.5 * d->thickness;
        } else if (b->kind == SCENE_BODY_RIGID && b->rigid.needle != NULL) {
            w->needle.needle = b->number;
            w->needle.touching += at_hole * b->rigid.needle->config.wire_radius;
        }
    }
    assert_true(w->needle.drain != 0 && w->needle.needle != 0);
    w->needle.threads = true;
    s->on_substep = see;
    s->on_substep_data = w;
}

void task_watch_expect_nothing(const task_watch *w)
{
    assert_true(w->substeps > 0 && w->needle.parts > 0);
    assert_int_equal(w->passed, 0);
    assert_int_equal(w->passed_drain, 0);
    assert_int_equal(w->needle.passed, 0);
    assert_int_equal(w->below, 0);
}
