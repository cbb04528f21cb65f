/* Renumbering after a mesh change. References to nodes and segments follow the insertion or
 * removal of a node: warm start, pins, grasps and contact views. The thread renumbers its
 * attachments itself. */
#include "collision/closest.h"
#include "scene/topology/topology.h"
#include "scene/tuning.h"
#include "scene/world/world.h"
#include "thread/remesh.h"

#include <string.h>

/* Marks a contact of a removed node; no contact kind has this number. */
#define REMOVED UINT32_MAX

typedef struct renumbering {
    const scene_body *body;
    mesh_change change;
    double before; /* rest length from the start of the segment to the node, m */
} renumbering;

/* ---- nodes and segments */

static uint32_t renumber_node(const mesh_change *c, uint32_t node)
{
    if (c->removes) {
        return node > c->at ? node - 1 : node == c->at ? REMOVED : node;
    }
    return node > c->at ? node + 1 : node;
}

/* `beyond`: the reference is to the part beyond the new node. */
static uint32_t renumber_segment(const mesh_change *c, uint32_t segment, bool beyond)
{
    if (c->removes) {
        return segment >= c->at ? segment - 1 : segment;
    }
    return segment > c->at || (segment == c->at && beyond) ? segment + 1 : segment;
}

static bool is_divided(const renumbering *r, uint32_t number, uint32_t segment)
{
    return !r->change.removes && number == r->body->number && segment == r->change.at;
}

/* ---- warm start */

/* Positions of the closest points on the segments that are divided, 0 to 1; -1 for the other
 * sides. */
static void split_fractions(const scene_object *s, const renumbering *r, const contact_key *k,
                            double fraction[2])
{
    bool segments = k->kind == VBSS_SCENE_CONTACT_SEGMENTS;
    bool a = scene_is_segment_contact(k->kind) && is_divided(r, k->body_a, k->feature_a);
    bool b = segments && is_divided(r, k->body_b, k->feature_b);
    fraction[0] = fraction[1] = -1.0;
    vec3 x[2], y[2];
    double at[2];
    if ((a || b) && vbss_scene_feature_segment(s, k->body_a, k->feature_a, x) &&
        vbss_scene_feature_segment(s, k->body_b, k->feature_b, y)) {
        (void)closest_between_edges(vec3_sub(x[1], x[0]), vec3_sub(y[1], y[0]),
                                    vec3_sub(y[0], x[0]), &at[0], &at[1]);
        fraction[0] = a ? at[0] : -1.0;
        fraction[1] = b ? at[1] : -1.0;
    }
}

/* The halves may be so fine that their nodes, not segments, make contact with the capsule. */
static void convert_to_node_contact(const scene_object *s, const renumbering *r, contact_key *k,
                                    double fraction)
{
    const scene_body *b = vbss_scene_body(s, k->body_b);
    double radius = s->capsules[b->rigid.first_capsule + k->feature_b].radius;
    if (r->before <= radius) {
        k->kind = VBSS_SCENE_CONTACT_NODE_CAPSULE;
        k->feature_a = r->change.at + (fraction > 1.0 - SCENE_RENUMBER_END_FRACTION ? 2
                                       : fraction < SCENE_RENUMBER_END_FRACTION     ? 0
                                                                                    : 1);
    }
}

static void renumber_contact(const scene_object *s, const renumbering *r,
                             contact_warm_start_entry *m)
{
    contact_key *k = &m->key;
    double fraction[2];
    bool node = scene_is_node_contact(k->kind);
    if (!node && !scene_is_segment_contact(k->kind)) {
        return;
    }
    split_fractions(s, r, k, fraction);
    if (k->body_a == r->body->number) {
        k->feature_a = node ? renumber_node(&r->change, k->feature_a)
                            : renumber_segment(&r->change, k->feature_a, fraction[0] > 0.5);
        m->key.kind = k->feature_a == REMOVED ? REMOVED : k->kind;
    }
    if (k->kind == VBSS_SCENE_CONTACT_SEGMENTS && k->body_b == r->body->number) {
        k->feature_b = renumber_segment(&r->change, k->feature_b, fraction[1] > 0.5);
    }
    if (k->kind == VBSS_SCENE_CONTACT_SEGMENT_CAPSULE && fraction[0] >= 0.0) {
        convert_to_node_contact(s, r, k, fraction[0]);
    }
}

/* The first of two contacts that have become one stays. */
void vbss_scene_sort_warm_start(scene_object *s)
{
    contact_set *set = s->contacts;
    uint32_t count = 0;
    for (uint32_t i = 0; i < set->warm_start_count; i++) {
        const contact_warm_start_entry m = set->warm_start[i];
        uint32_t to = count;
        while (to > 0 && vbss_contact_compare_keys(&set->warm_start[to - 1].key, &m.key) > 0) {
            to--;
        }
        bool is_duplicate =
            to > 0 && vbss_contact_compare_keys(&set->warm_start[to - 1].key, &m.key) == 0;
        if (m.key.kind != REMOVED && !is_duplicate) {
            memmove(&set->warm_start[to + 1], &set->warm_start[to],
                    (count - to) * sizeof *set->warm_start);
            set->warm_start[to] = m;
            count++;
        }
    }
    set->warm_start_count = count;
}

/* ---- contact views */

static uint32_t renumber_view(const renumbering *r, bool node, uint32_t feature, vec3 point)
{
    if (node) { /* a removed node becomes the node before it */
        uint32_t renumbered = renumber_node(&r->change, feature);
        return renumbered == REMOVED ? feature - 1 : renumbered;
    }
    bool beyond = false;
    if (is_divided(r, r->body->number, feature)) {
        const vec3 *x = r->body->thread.thread->now.x + feature;
        vec3 e = vec3_sub(x[1], x[0]);
        beyond = vec3_dot(vec3_sub(point, x[0]), e) > 0.5 * vec3_norm_squared(e);
    }
    return renumber_segment(&r->change, feature, beyond);
}

static void renumber_views(scene_object *s, const renumbering *r)
{
    for (uint32_t i = 0; i < s->report.contact_count; i++) {
        uint32_t *f = s->report.contact_features[i];
        bool node = scene_is_node_contact(f[0]);
        if (!node && !scene_is_segment_contact(f[0])) {
            continue;
        }
        if (f[1] == r->body->number) {
            f[2] = renumber_view(r, node, f[2], s->report.contact_points[i]);
        }
        if (f[0] == VBSS_SCENE_CONTACT_SEGMENTS && f[3] == r->body->number) {
            f[4] = renumber_view(r, false, f[4], s->report.contact_points[i]);
        }
    }
}

/* ---- pins and grasps */

/* Pinned nodes are never removed, as the mesh does not change beside them. The node of a pin whose
 * attachment the host has detached may be; the pin, which holds nothing, moves to the node before. */
static void renumber_holders(scene_object *s, const renumbering *r)
{
    const mesh_change *c = &r->change;
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        scene_pin *p = &s->pins[i];
        if (p->id != 0 && p->thread == r->body->number) {
            const bool is_removed = c->removes && p->node == c->at;
            p->node = renumber_node(c, is_removed ? p->node - 1 : p->node);
        }
    }
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        scene_thread_grasp *g = &s->thread_grasps[i];
        if (g->id == 0 || g->thread != r->body->number) {
            continue;
        }
        bool beyond = is_divided(r, g->thread, g->segment) && g->segment_offset > r->before;
        bool joined = c->removes && g->segment == c->at;
        g->segment_offset += joined ? r->before : beyond ? -r->before : 0.0;
        g->segment = renumber_segment(c, g->segment, beyond);
    }
}

static void renumber_all(scene_object *s, const renumbering *r)
{
    for (uint32_t i = 0; i < s->contacts->warm_start_count; i++) {
        renumber_contact(s, r, &s->contacts->warm_start[i]);
    }
    renumber_views(s, r);
    renumber_holders(s, r);
}

bool vbss_scene_apply_mesh_change(scene_object *s, const scene_body *thread,
                                  const mesh_change *change)
{
    thread_object *t = thread->thread.thread;
    renumbering r = {thread, *change, 0.0};
    if (change->removes) {
        r.before = t->rest[change->at - 1];
        if (!vbss_thread_remove_node(t, change->at, change->max_shift)) {
            return false;
        }
        renumber_all(s, &r);
    } else { /* before the split, because contacts refer to positions on the whole segment */
        r.before = 0.5 * t->rest[change->at];
        renumber_all(s, &r);
        vbss_thread_split_segment(t, change->at, change->max_shift);
    }
    return true;
}
