#include "task/passed.h"

#include <stdlib.h>
#include <string.h>

#include "task/passed_part.h"

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
    p->failed = p->failed || t->chain_count == MAX_CHAINS;
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
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_THREAD) {
            const thread_object *o = b->thread.thread;
            keep_chain(p, t,
                       (chain){.kind = CHAIN_THREAD, .body = b->number, .count = o->node_count},
                       o->now.x, o->trial);
        } else if (b->kind == SCENE_BODY_RIGID) {
            keep_rigid(p, t, b);
        } else if (b->kind == SCENE_BODY_DRAIN) {
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

/* ---- after it: holes, and what jaws hold */

static void read_holes(passed *p)
{
    memcpy(p->before, p->now, sizeof p->now);
    p->before_count = p->now_count;
    for (p->now_count = 0; p->now_count < MAX_HOLES &&
                           vbss_scene_get_hole(p->scene, p->now_count, &p->now[p->now_count],
                                               sizeof p->now[0]) == VBSS_OK;) {
        p->now_count++;
    }
    p->failed = p->failed || p->now_count == MAX_HOLES;
}

static void read_grasps_of(passed *p, uint32_t tool)
{
    vbss_scene_grasp g;
    for (uint32_t i = 0; vbss_scene_get_grasp(p->scene, tool, i, &g, sizeof g) == VBSS_OK; i++) {
        if (p->held_now_count == MAX_GRASPS) {
            p->failed = true;
            return;
        }
        p->held_now[p->held_now_count++] = (held){tool, g.body, g.arc_length};
    }
}

static void read_grasps(passed *p)
{
    memcpy(p->held_before, p->held_now, sizeof p->held_now);
    p->held_before_count = p->held_now_count;
    p->held_now_count = 0;
    for (uint32_t i = 0; i < p->object->body_count; i++) {
        const scene_body *b = &p->object->bodies[i];
        if (b->kind == SCENE_BODY_RIGID && b->rigid.grasper != NULL) {
            read_grasps_of(p, b->number);
        }
    }
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
    p->sides = calloc(m->edge_count, sizeof *p->sides);
    p->triangles = calloc(m->triangle_count, sizeof *p->triangles);
    p->failed = p->sides == NULL || p->triangles == NULL;
    read_holes(p);
    object->on_substep = keep_part;
    object->on_substep_data = p;
    return p;
}

bool passed_observe(passed *p)
{
    uint64_t before = passed_sum(&p->counts);
    read_holes(p);
    read_grasps(p);
    p->step++;
    for (size_t i = 0; i < p->part_count && !p->failed; i++) {
        passed_ask_part(p, &p->parts[i]);
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
