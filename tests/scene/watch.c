#include "scene/watch.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

typedef struct chain_set {
    passing_chain chains[WATCH_CHAINS];
    uint32_t owners[WATCH_CHAINS]; /* of tools: their bodies' numbers */
    uint32_t count, nodes;
} chain_set;

/* ---- what is there */

static void add_chain(watch *w, chain_set *l, const vec3 *start, const vec3 *end, uint32_t nodes,
                      uint32_t owner)
{
    if (l->count == WATCH_CHAINS || l->nodes + nodes > WATCH_NODES) {
        abort(); /* what is not looked at proves nothing */
    }
    memcpy(w->start + l->nodes, start, nodes * sizeof *start);
    memcpy(w->end + l->nodes, end, nodes * sizeof *end);
    l->chains[l->count] =
        (passing_chain){w->start + l->nodes, w->end + l->nodes, nodes, owner != 0};
    l->owners[l->count++] = owner;
    l->nodes += nodes;
}

static void collect_chains(watch *w, const scene_object *s, chain_set *l)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_THREAD) {
            const thread_object *t = b->thread.thread;
            add_chain(w, l, t->now.x, t->trial, t->node_count, 0);
        }
        for (uint32_t c = 0; b->kind == SCENE_BODY_RIGID && c < b->rigid.capsule_count; c++) {
            const scene_capsule *capsule = &s->capsules[b->rigid.first_capsule + c];
            add_chain(w, l, capsule->now, capsule->trial, 2, b->number);
        }
    }
}

/* ---- what is asked */

static uint64_t jumps(watch *w, const chain_set *l)
{
    uint64_t found = 0;
    if (w->count == l->nodes && w->count > 0) {
        found = memcmp(w->last, w->start, l->nodes * sizeof *w->last) != 0;
    }
    memcpy(w->last, w->end, l->nodes * sizeof *w->last);
    w->count = l->nodes;
    return found;
}

/* Axes of different tools: passing_count does not ask about them. */
static void ask_tools(const chain_set *l, passing_report *all)
{
    for (uint32_t i = 0; i < l->count; i++) {
        for (uint32_t k = i + 1; l->owners[i] != 0 && k < l->count; k++) {
            if (l->owners[k] == 0 || l->owners[k] == l->owners[i]) {
                continue;
            }
            passing_chain both[2] = {l->chains[i], l->chains[k]};
            both[0].tool = both[1].tool = false;
            passing_report report;
            passing_count(both, 2, &report);
            all->pairs += report.pairs;
            all->asked += report.asked;
            all->passed += report.passed;
        }
    }
}

/* Both ends of a straight way above it: all of it is. A floor along an axis makes that exact. */
static uint64_t below_floor(const watch *w, const scene_object *s, uint32_t count)
{
    uint64_t found = 0;
    for (uint32_t i = 0; s->config.floor != 0 && i < count; i++) {
        found += !(vec3_dot(w->start[i], s->floor_normal) > s->config.floor_height &&
                   vec3_dot(w->end[i], s->floor_normal) > s->config.floor_height);
    }
    return found;
}

/* The rays go out from the thread's middle through its ends, and begin a little beyond these: in between nothing has room. */
static void find_rays(const thread_object *t, const vec3 *x, vec3 rays[2][2])
{
    const uint32_t n = t->node_count;
    vec3 middle = vec3_zero();
    double extent = 0.0;
    for (uint32_t i = 0; i < n; i++) {
        middle = vec3_add_scaled(middle, 1.0 / n, x[i]);
    }
    for (uint32_t i = 0; i < n; i++) {
        extent = fmax(extent, vec3_distance(x[i], middle));
    }
    for (int k = 0; k < 2; k++) {
        vec3 end = x[k == 0 ? 0 : n - 1];
        vec3 out = vec3_unit_or(vec3_sub(end, middle), vec3_make(1.0, 0.0, 0.0));
        rays[k][0] = vec3_add_scaled(end, 0.5 * t->config.radius, out);
        rays[k][1] = vec3_add_scaled(end, 10.0 * extent, out);
    }
}

static bool is_closed_anew(const scene_object *s)
{
    const scene_body *b = s->bodies;
    while (b->kind != SCENE_BODY_THREAD) {
        b++;
    }
    const thread_object *t = b->thread.thread;
    vec3 start[2][2], end[2][2];
    find_rays(t, t->now.x, start);
    find_rays(t, t->trial, end);
    /* as a tool the thread is asked against the rays alone */
    const passing_chain chains[] = {{t->now.x, t->trial, t->node_count, true},
                                    {start[0], end[0], 2, false},
                                    {start[1], end[1], 2, false}};
    return passing_count(chains, 3, NULL) > 0;
}

static double now(void)
{
    struct timespec t;
    (void)clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return 1e6 * (double)t.tv_sec + 1e-3 * (double)t.tv_nsec;
}

static void see(void *watcher, const scene_object *s)
{
    watch *w = watcher;
    double begin = now();
    chain_set l = {.count = 0};
    passing_report report;
    collect_chains(w, s, &l);
    passing_count(l.chains, l.count, &report);
    ask_tools(&l, &report);
    w->parts++;
    w->pairs += report.pairs;
    w->asked += report.asked;
    w->passed += report.passed;
    w->below += below_floor(w, s, l.nodes);
    w->jumps += jumps(w, &l);
    w->closed_anew += w->closes && is_closed_anew(s);
    if (w->first == 0 && watch_faults(w) > 0) {
        w->first = w->parts;
        w->report = report;
    }
    w->cost += now() - begin;
}

/* ---- watching */

void watch_begin(watch *w, vbss_scene *scene)
{
    scene_object *s;
    if (vbss_scene_open(scene, &s) != VBSS_OK) {
        abort();
    }
    s->on_substep = see;
    s->on_substep_data = w;
    w->scene = s;
    w->count = 0;
}

void watch_again(watch *w)
{
    w->count = 0;
}

void watch_add(watch *w, const watch *other)
{
    w->parts += other->parts;
    w->pairs += other->pairs;
    w->asked += other->asked;
    w->passed += other->passed;
    w->below += other->below;
    w->jumps += other->jumps;
    w->closed_anew += other->closed_anew;
}

uint64_t watch_faults(const watch *w)
{
    return w->passed + w->below + w->jumps;
}
