#include "task/passed.h"

#include <stdlib.h>
#include <string.h>

#include "oracle/surface.h"
#include "scene/scene.h"

/* m: so far along thread or needle from a hole the wall round it is not asked; so far from the swage the thread is not asked
 * with the needle. */
#define HOLE_REACH 1e-3
#define SWAGE_REACH 1.2e-3
enum {
    MOST_CHAINS = 64,
    MOST_STRETCHES = 256,
    MOST_HOLES = 32,
    ROW_WORDS = 4,
    MOST_NODES = 64 * ROW_WORDS
};

typedef enum chain_kind { CHAIN_THREAD, CHAIN_TOOL, CHAIN_NEEDLE } chain_kind;

/* A chain in a part: where its nodes are in `begin` and `end`, and its body. */
typedef struct chain {
    chain_kind kind;
    uint32_t body;
    size_t first, count;
    double begins; /* along its body, m: of a needle from the tip */
} chain;

typedef struct part {
    chain chains[MOST_CHAINS];
    size_t chain_count, node_count, room;
    vec3 *start, *end; /* of all chains, then of the drain */
    size_t drain_first;
} part;

struct passed {
    vbss_scene *scene;
    const scene_object *object;
    part *parts;
    size_t part_count, part_room;
    bool failed; /* no memory or room */
    vbss_hole before[MOST_HOLES], now[MOST_HOLES];
    uint32_t before_count, now_count;
    const drain_object *drain;
    uint32_t (*sides)[2], (*triangles)[3]; /* of the wall, or of what is not round a hole */
    uint64_t near[MOST_NODES][ROW_WORDS];  /* all are: the drain is not asked with itself */
    uint64_t step;
    passed_counts counts;
};

/* ---- during a step: keeps where all begins and ends */

static vec3 *room_for(passed *p, part *t, size_t count, vec3 **end)
{
    if (t->node_count + count > t->room) {
        size_t room = 2 * (t->node_count + count);
        vec3 *start = realloc(t->start, room * sizeof *start);
        t->start = start != NULL ? start : t->start;
        vec3 *ends = realloc(t->end, room * sizeof *ends);
        t->end = ends != NULL ? ends : t->end;
        p->failed = p->failed || start == NULL || ends == NULL;
        t->room = p->failed ? t->room : room;
    }
    if (p->failed) {
        return NULL;
    }
    vec3 *start = t->start + t->node_count;
    *end = t->end + t->node_count;
    t->node_count += count;
    return start;
}

static void keep_chain(passed *p, part *t, chain c, const vec3 *start, const vec3 *end)
{
    vec3 *ends, *starts = room_for(p, t, c.count, &ends);
    p->failed = p->failed || t->chain_count == MOST_CHAINS;
    if (!p->failed) {
        c.first = (size_t)(starts - t->start);
        memcpy(starts, start, c.count * sizeof *start);
        memcpy(ends, end, c.count * sizeof *end);
        t->chains[t->chain_count++] = c;
    }
}

static void keep_rigid(passed *p, part *t, const scene_body *b)
{
    double arc = 0.0;
    for (uint32_t i = 0; i < b->rigid.capsule_count; i++) {
        const scene_capsule *c = &p->object->capsules[b->rigid.first_capsule + i];
        chain_kind kind = b->rigid.needle != NULL ? CHAIN_NEEDLE : CHAIN_TOOL;
        keep_chain(p, t, (chain){.kind = kind, .body = b->number, .count = 2, .begins = arc},
                   c->now, c->trial);
        arc += vec3_distance(c->now[0], c->now[1]);
    }
}

static void keep_part(void *watcher, const scene_object *s)
{
    passed *p = watcher;
    if (p->part_count == p->part_room) {
        size_t room = p->part_room == 0 ? 8 : 2 * p->part_room;
        part *more = realloc(p->parts, room * sizeof *more);
        if (more == NULL) {
            p->failed = true;
            return;
        }
        memset(more + p->part_room, 0, (room - p->part_room) * sizeof *more);
        p->parts = more;
        p->part_room = room;
    }
    part *t = &p->parts[p->part_count++];
    t->chain_count = t->node_count = 0;
    const drain_object *d = NULL;
    for (uint32_t i = 0; i < s->place_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->kind == BODY_THREAD) {
            const thread_object *o = b->thread.thread;
            keep_chain(p, t,
                       (chain){.kind = CHAIN_THREAD, .body = b->number, .count = o->node_count},
                       o->now.x, o->trial);
        } else if (b->kind == BODY_RIGID) {
            keep_rigid(p, t, b);
        } else if (b->kind == BODY_DRAIN) {
            d = b->drain.drain;
        }
    }
    if (d != NULL) {
        vec3 *ends, *starts = room_for(p, t, d->mesh.node_count, &ends);
        if (starts != NULL) {
            t->drain_first = (size_t)(starts - t->start);
            memcpy(starts, d->x, d->mesh.node_count * sizeof *starts);
            memcpy(ends, d->trial, d->mesh.node_count * sizeof *ends);
        }
    }
}

/* ---- holes */

static void read_holes(passed *p)
{
    memcpy(p->before, p->now, sizeof p->now);
    p->before_count = p->now_count;
    for (p->now_count = 0; p->now_count < MOST_HOLES &&
                           vbss_scene_get_hole(p->scene, p->now_count, &p->now[p->now_count],
                                               sizeof p->now[0]) == VBSS_OK;) {
        p->now_count++;
    }
    p->failed = p->failed || p->now_count == MOST_HOLES;
}

/* Whether a stretch of a body, from `begin` to `end` along it, is near one of these holes. What is in a hole round the swage is
 * needle and thread, which begins at the needle's end. */
static bool in_holes(const vbss_hole *holes, uint32_t count, const chain *c, const double ends[2],
                     double needle_length)
{
    for (uint32_t i = 0; i < count; i++) {
        const vbss_hole *h = &holes[i];
        bool needle = c->kind == CHAIN_NEEDLE;
        double at = h->arc_length;
        at += needle && h->thread != 0    ? needle_length
              : !needle && h->needle != 0 ? -needle_length
                                          : 0.0;
        if (ends[0] < at + HOLE_REACH && ends[1] > at - HOLE_REACH) {
            return true;
        }
    }
    return false;
}

/* Whether one of the nodes is of a triangle with a hole. */
static bool round_hole(const passed *p, const uint32_t *nodes, int count)
{
    for (int list = 0; list < 2; list++) {
        const vbss_hole *holes = list == 0 ? p->before : p->now;
        uint32_t hole_count = list == 0 ? p->before_count : p->now_count;
        for (uint32_t i = 0; i < hole_count; i++) {
            const uint32_t *of = p->drain->mesh.triangles[holes[i].triangle];
            for (int k = 0; k < count; k++) {
                if (of[0] == nodes[k] || of[1] == nodes[k] || of[2] == nodes[k]) {
                    return true;
                }
            }
        }
    }
    return false;
}

/* ---- what is asked of a part: threads, tools and the needle */

typedef struct box {
    vec3 low, high;
} box;

static void include(box *b, vec3 x)
{
    b->low = vec3_make(lesser(b->low.x, x.x), lesser(b->low.y, x.y), lesser(b->low.z, x.z));
    b->high = vec3_make(greater(b->high.x, x.x), greater(b->high.y, x.y), greater(b->high.z, x.z));
}

static box box_of(const part *t, size_t first, size_t count)
{
    box b = {t->start[first], t->start[first]};
    for (size_t i = first; i < first + count; i++) {
        include(&b, t->start[i]);
        include(&b, t->end[i]);
    }
    return b;
}

static bool apart(const box *a, const box *b)
{
    return a->low.x > b->high.x || a->low.y > b->high.y || a->low.z > b->high.z ||
           b->low.x > a->high.x || b->low.y > a->high.y || b->low.z > a->high.z;
}

static passing_chain stretch(const part *t, const chain *c, size_t from, size_t nodes, bool tool)
{
    return (passing_chain){t->start + c->first + from, t->end + c->first + from, nodes, tool};
}

static uint64_t ask_threads(const part *t)
{
    passing_chain asked[MOST_CHAINS];
    size_t count = 0;
    for (size_t i = 0; i < t->chain_count; i++) {
        const chain *c = &t->chains[i];
        if (c->kind != CHAIN_NEEDLE) {
            asked[count++] = stretch(t, c, 0, c->count, c->kind == CHAIN_TOOL);
        }
    }
    return passing_count(asked, count, NULL);
}

/* The thread hangs from the needle's end: what is near that is left out. */
static uint64_t ask_needle(const part *t, const chain *thread, const chain *needle)
{
    const box round = box_of(t, needle->first, needle->count);
    uint64_t sum = 0;
    double arc = 0.0;
    for (size_t i = 0; i + 1 < thread->count; i++) {
        const size_t at = thread->first + i;
        const box own = box_of(t, at, 2);
        if (arc >= SWAGE_REACH && !apart(&own, &round)) {
            const passing_chain pair[2] = {stretch(t, thread, i, 2, false),
                                           stretch(t, needle, 0, 2, true)};
            sum += passing_count(pair, 2, NULL);
        }
        arc += vec3_distance(t->start[at], t->start[at + 1]);
    }
    return sum;
}

/* ---- the wall */

typedef struct asked_chains {
    passing_chain chains[MOST_STRETCHES];
    size_t count;
} asked_chains;

typedef enum beside { BESIDE_NOTHING, BESIDE_WALL, BESIDE_HOLE } beside;

/* Whether a segment is to be asked with the wall, and with which. */
static beside beside_of(const passed *p, const part *t, const chain *c, size_t i,
                        const double ends[2], const box *wall, double needle_length)
{
    const box own = box_of(t, c->first + i, 2);
    if (apart(&own, wall)) {
        return BESIDE_NOTHING;
    }
    return c->kind != CHAIN_TOOL && (in_holes(p->before, p->before_count, c, ends, needle_length) ||
                                     in_holes(p->now, p->now_count, c, ends, needle_length))
               ? BESIDE_HOLE
               : BESIDE_WALL;
}

static void add_stretch(passed *p, asked_chains *to, passing_chain c)
{
    if (to->count == MOST_STRETCHES) {
        p->failed = true;
        return;
    }
    to->chains[to->count++] = c;
}

/* Stretches of a chain that are alike. */
static void cut_chain(passed *p, const part *t, const chain *c, const box *wall,
                      double needle_length, asked_chains by[2])
{
    beside now = BESIDE_NOTHING;
    size_t from = 0, i = 0;
    double arc = c->begins;
    for (; i + 1 < c->count; i++) {
        double next = arc + vec3_distance(t->start[c->first + i], t->start[c->first + i + 1]);
        const double ends[2] = {arc, next};
        beside is = beside_of(p, t, c, i, ends, wall, needle_length);
        if (is != now && now != BESIDE_NOTHING) {
            add_stretch(p, &by[now == BESIDE_HOLE], stretch(t, c, from, i - from + 1, false));
        }
        from = is != now ? i : from;
        now = is;
        arc = next;
    }
    if (now != BESIDE_NOTHING) {
        add_stretch(p, &by[now == BESIDE_HOLE], stretch(t, c, from, i - from + 1, false));
    }
}

/* With `whole`, or with what is not round a hole. */
static uint64_t ask_wall(passed *p, const part *t, const asked_chains *chains, bool whole)
{
    const drain_mesh *m = &p->drain->mesh;
    passing_surface wall = {.start = t->start + t->drain_first,
                            .end = t->end + t->drain_first,
                            .nodes = m->node_count,
                            .triangles = p->triangles[0],
                            .sides = p->sides[0],
                            .near = p->near[0],
                            .words = ROW_WORDS};
    for (uint32_t i = 0; i < m->triangle_count; i++) {
        if (whole || !round_hole(p, m->triangles[i], 3)) {
            memcpy(p->triangles[wall.triangle_count++], m->triangles[i], sizeof p->triangles[0]);
        }
    }
    for (uint32_t i = 0; i < m->side_count; i++) {
        if (whole || !round_hole(p, m->sides[i].nodes, 2)) {
            memcpy(p->sides[wall.side_count++], m->sides[i].nodes, sizeof p->sides[0]);
        }
    }
    passing_surface_report report;
    return passing_surfaces(&wall, 1, chains->chains, chains->count, &report);
}

static uint64_t ask_kind(passed *p, const part *t, chain_kind kind, double needle_length)
{
    static asked_chains by[2];
    const box wall = box_of(t, t->drain_first, p->drain->mesh.node_count);
    by[0].count = by[1].count = 0;
    for (size_t i = 0; i < t->chain_count; i++) {
        if (t->chains[i].kind == kind) {
            cut_chain(p, t, &t->chains[i], &wall, needle_length, by);
        }
    }
    return (by[0].count > 0 ? ask_wall(p, t, &by[0], true) : 0) +
           (by[1].count > 0 ? ask_wall(p, t, &by[1], false) : 0);
}

static void ask_part(passed *p, const part *t)
{
    double needle_length = 0.0;
    for (size_t i = 0; i < t->chain_count; i++) {
        const chain *c = &t->chains[i];
        if (c->kind == CHAIN_NEEDLE) {
            needle_length = c->begins + vec3_distance(t->start[c->first], t->start[c->first + 1]);
        }
        for (size_t k = 0; k < t->chain_count; k++) {
            if (c->kind == CHAIN_THREAD && t->chains[k].kind == CHAIN_NEEDLE) {
                p->counts.thread_needle += ask_needle(t, c, &t->chains[k]);
            }
        }
    }
    p->counts.parts++;
    p->counts.threads += ask_threads(t);
    p->counts.thread_drain += ask_kind(p, t, CHAIN_THREAD, needle_length);
    p->counts.needle_drain += ask_kind(p, t, CHAIN_NEEDLE, needle_length);
    p->counts.tool_drain += ask_kind(p, t, CHAIN_TOOL, needle_length);
}

/* ---- from begin to end */

passed *passed_create(vbss_scene *scene, uint32_t drain_body)
{
    scene_object *object;
    passed *p = calloc(1, sizeof *p);
    if (p == NULL || vbss_scene_open(scene, &object) != VBSS_OK) {
        free(p);
        return NULL;
    }
    p->scene = scene;
    p->object = object;
    p->drain = vbss_scene_body(object, drain_body)->drain.drain;
    const drain_mesh *m = &p->drain->mesh;
    p->sides = calloc(m->side_count, sizeof *p->sides);
    p->triangles = calloc(m->triangle_count, sizeof *p->triangles);
    p->failed = p->sides == NULL || p->triangles == NULL || m->node_count > MOST_NODES;
    memset(p->near, 0xff, sizeof p->near);
    read_holes(p);
    object->watch = keep_part;
    object->watcher = p;
    return p;
}

bool passed_look(passed *p)
{
    uint64_t before = passed_sum(&p->counts);
    read_holes(p);
    p->step++;
    for (size_t i = 0; i < p->part_count && !p->failed; i++) {
        ask_part(p, &p->parts[i]);
    }
    p->part_count = 0;
    if (p->counts.first_step == 0 && passed_sum(&p->counts) > before) {
        p->counts.first_step = p->step;
    }
    return !p->failed;
}

passed_counts passed_get(const passed *p)
{
    return p->counts;
}

uint64_t passed_sum(const passed_counts *c)
{
    return c->threads + c->thread_needle + c->thread_drain + c->needle_drain + c->tool_drain;
}

void passed_destroy(passed *p)
{
    for (size_t i = 0; p != NULL && i < p->part_room; i++) {
        free(p->parts[i].start);
        free(p->parts[i].end);
    }
    if (p != NULL) {
        free(p->parts);
        free(p->sides);
        free(p->triangles);
    }
    free(p);
}
