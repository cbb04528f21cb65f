/* What met in a part, asked of the exact oracle. */
#include <string.h>

#include "oracle/surface.h"
#include "task/passed_part.h"

/* m: so far along thread or needle from a hole the wall round it is not asked; so far along a thread from where jaws hold it they do
 * not touch it (docs/explanation/graspers.md); so far from the swage the thread is not asked with the needle. */
#define HOLE_REACH 1e-3
#define JAW_REACH 1.5e-3
#define SWAGE_REACH 1.2e-3
enum { MAX_STRETCHES = 256 };

/* ---- what may be across */

static bool in_jaws(const held *list, uint32_t count, const chain *thread, const chain *tool,
                    const double ends[2])
{
    for (uint32_t i = 0; i < count; i++) {
        const held *h = &list[i];
        if (h->tool == tool->body && h->thread == thread->body && ends[0] < h->arc + JAW_REACH &&
            ends[1] > h->arc - JAW_REACH) {
            return true;
        }
    }
    return false;
}

/* Whether a stretch of a body, from `begin` to `end` along it, is near one of these holes. What is in a hole round the swage is
 * needle and thread, which begins at the needle's end. */
static bool in_holes(const vbss_scene_hole *holes, uint32_t count, const chain *c,
                     const double ends[2], double needle_length)
{
    for (uint32_t i = 0; i < count; i++) {
        const vbss_scene_hole *h = &holes[i];
        bool needle = c->kind == CHAIN_NEEDLE;
        if (!needle && h->thread != 0 && h->thread != c->body) {
            continue;
        }
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
        const vbss_scene_hole *holes = list == 0 ? p->before : p->now;
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
    b->low = vec3_make(vbss_min(b->low.x, x.x), vbss_min(b->low.y, x.y), vbss_min(b->low.z, x.z));
    b->high =
        vec3_make(vbss_max(b->high.x, x.x), vbss_max(b->high.y, x.y), vbss_max(b->high.z, x.z));
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

static double length_of(const part *t, const chain *c)
{
    double sum = 0.0;
    for (size_t i = c->first; i + 1 < c->first + c->count; i++) {
        sum += vec3_distance(t->start[i], t->start[i + 1]);
    }
    return sum;
}

static uint64_t ask_threads(const part *t)
{
    passing_chain asked[MAX_CHAINS];
    size_t count = 0;
    for (size_t i = 0; i < t->chain_count; i++) {
        const chain *c = &t->chains[i];
        if (c->kind != CHAIN_NEEDLE) {
            asked[count++] = stretch(t, c, 0, c->count, c->kind == CHAIN_TOOL);
        }
    }
    return passing_count(asked, count, NULL);
}

static bool was_cut(const part *t)
{
    size_t threads = 0;
    for (size_t i = 0; i < t->chain_count; i++) {
        threads += t->chains[i].kind == CHAIN_THREAD;
    }
    return threads > 1;
}

/* Ends of two pieces, which are at the same place when they have just been cut. */
static uint64_t count_at_cuts(const part *t)
{
    uint64_t sum = 0;
    for (size_t i = 0; i < t->chain_count; i++) {
        const chain *one = &t->chains[i];
        for (size_t k = i + 1; k < t->chain_count; k++) {
            const chain *other = &t->chains[k];
            bool threads = one->kind == CHAIN_THREAD && other->kind == CHAIN_THREAD;
            for (int ends = 0; threads && ends < 4; ends++) {
                const passing_chain pair[2] = {
                    stretch(t, one, ends % 2 == 0 ? 0 : one->count - 2, 2, false),
                    stretch(t, other, ends / 2 == 0 ? 0 : other->count - 2, 2, false)};
                sum += passing_count(pair, 2, NULL);
            }
        }
    }
    return sum;
}

/* Of a thread and a tool's capsule: what met in the jaws that hold the thread there, or beside the end of a piece, which blades
 * have made. */
static uint64_t count_in_jaws(const passed *p, const part *t, const chain *thread,
                              const chain *tool)
{
    const box round = box_of(t, tool->first, tool->count);
    const double length = length_of(t, thread);
    const bool cut = was_cut(t);
    uint64_t sum = 0;
    double arc = 0.0;
    for (size_t i = 0; i + 1 < thread->count; i++) {
        const size_t at = thread->first + i;
        const double ends[2] = {arc, arc + vec3_distance(t->start[at], t->start[at + 1])};
        const box own = box_of(t, at, 2);
        const bool at_end = cut && (ends[0] < JAW_REACH || ends[1] > length - JAW_REACH);
        arc = ends[1];
        if (!apart(&own, &round) &&
            (at_end || in_jaws(p->held_before, p->held_before_count, thread, tool, ends) ||
             in_jaws(p->held_now, p->held_now_count, thread, tool, ends))) {
            const passing_chain pair[2] = {stretch(t, thread, i, 2, false),
                                           stretch(t, tool, 0, 2, true)};
            sum += passing_count(pair, 2, NULL);
        }
    }
    return sum;
}

static void ask_tools(passed *p, const part *t)
{
    uint64_t met = ask_threads(t), in = met > 0 ? count_at_cuts(t) : 0;
    for (size_t i = 0; met > 0 && i < t->chain_count; i++) {
        for (size_t k = 0; k < t->chain_count; k++) {
            if (t->chains[i].kind == CHAIN_THREAD && t->chains[k].kind == CHAIN_TOOL) {
                in += count_in_jaws(p, t, &t->chains[i], &t->chains[k]);
            }
        }
    }
    p->counts.threads += met - in;
    p->counts.in_jaws += in;
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
    passing_chain chains[MAX_STRETCHES];
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
    if (to->count == MAX_STRETCHES) {
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
                            .sides = p->sides[0]};
    for (uint32_t i = 0; i < m->triangle_count; i++) {
        if (whole || !round_hole(p, m->triangles[i], 3)) {
            memcpy(p->triangles[wall.triangle_count++], m->triangles[i], sizeof p->triangles[0]);
        }
    }
    for (uint32_t i = 0; i < m->edge_count; i++) {
        if (whole || !round_hole(p, m->edges[i].nodes, 2)) {
            memcpy(p->sides[wall.side_count++], m->edges[i].nodes, sizeof p->sides[0]);
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

void passed_ask_part(passed *p, const part *t)
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
    ask_tools(p, t);
    p->counts.thread_drain += ask_kind(p, t, CHAIN_THREAD, needle_length);
    p->counts.needle_drain += ask_kind(p, t, CHAIN_NEEDLE, needle_length);
    p->counts.tool_drain += ask_kind(p, t, CHAIN_TOOL, needle_length);
}
