/* A node of a thread comes or goes, and all that names nodes and segments by their numbers goes on to mean the same
 * places: what contact remembers, pins, grasps, contacts in the views. Attachments are the thread's own. */
#include "scene/meshes.h"
#include "scene/rows.h"

#include "collision/closest.h"

#include <string.h>

/* A contact that is not there any more: no kind has this number. */
#define GONE UINT32_MAX

typedef struct renaming {
    const scene_body *body;
    mesh_change change;
    double before; /* rest length on this side of the node, m */
} renaming;

/* ---- names */

static uint32_t rename_node(const mesh_change *c, uint32_t node)
{
    if (c->removes) {
        return node > c->at ? node - 1 : node == c->at ? GONE : node;
    }
    return node > c->at ? node + 1 : node;
}

/* `beyond`: what is meant lies beyond the new node. */
static uint32_t rename_segment(const mesh_change *c, uint32_t segment, bool beyond)
{
    if (c->removes) {
        return segment >= c->at ? segment - 1 : segment;
    }
    return segment > c->at || (segment == c->at && beyond) ? segment + 1 : segment;
}

static bool is_divided(const renaming *r, uint32_t number, uint32_t segment)
{
    return !r->change.removes && number == r->body->number && segment == r->change.at;
}

/* ---- what contact remembers */

/* Where the closest points are on the sides that are divided: share of the segment, or -1. */
static void shares_of(const scene_object *s, const renaming *r, const contact_key *k,
                      double share[2])
{
    bool segments = k->kind == VBSS_CONTACT_SEGMENTS;
    bool a = scene_is_of_segment(k->kind) && is_divided(r, k->body_a, k->feature_a);
    bool b = segments && is_divided(r, k->body_b, k->feature_b);
    share[0] = share[1] = -1.0;
    vec3 x[2], y[2];
    double at[2];
    if ((a || b) && vbss_scene_axis_of(s, k->body_a, k->feature_a, x) &&
        vbss_scene_axis_of(s, k->body_b, k->feature_b, y)) {
        (void)closest_between_edges(vec3_sub(x[1], x[0]), vec3_sub(y[1], y[0]),
                                    vec3_sub(y[0], x[0]), &at[0], &at[1]);
        share[0] = a ? at[0] : -1.0;
        share[1] = b ? at[1] : -1.0;
    }
}

/* Halves may be so fine that their nodes touch the capsule. */
static void go_to_node(const scene_object *s, const renaming *r, contact_key *k, double share)
{
    const scene_body *b = vbss_scene_body(s, k->body_b);
    double radius = s->capsules[b->rigid.first_capsule + k->feature_b].radius;
    if (r->before <= radius) {
        k->kind = VBSS_CONTACT_NODE_CAPSULE;
        k->feature_a = r->change.at + (share > 0.75 ? 2 : share < 0.25 ? 0 : 1);
    }
}

static void rename_contact(const scene_object *s, const renaming *r, contact_warm_start_entry *m)
{
    contact_key *k = &m->key;
    double share[2];
    bool node = scene_is_of_node(k->kind);
    if (!node && !scene_is_of_segment(k->kind)) {
        return;
    }
    shares_of(s, r, k, share);
    if (k->body_a == r->body->number) {
        k->feature_a = node ? rename_node(&r->change, k->feature_a)
                            : rename_segment(&r->change, k->feature_a, share[0] > 0.5);
        m->key.kind = k->feature_a == GONE ? GONE : k->kind;
    }
    if (k->kind == VBSS_CONTACT_SEGMENTS && k->body_b == r->body->number) {
        k->feature_b = rename_segment(&r->change, k->feature_b, share[1] > 0.5);
    }
    if (k->kind == VBSS_CONTACT_SEGMENT_CAPSULE && share[0] >= 0.0) {
        go_to_node(s, r, k, share[0]);
    }
}

/* Keys ascending, each once: of two contacts that have become one the first is remembered. */
void vbss_scene_order_memory(scene_object *s)
{
    contact_set *set = s->contacts;
    uint32_t kept = 0;
    for (uint32_t i = 0; i < set->warm_start_count; i++) {
        const contact_warm_start_entry m = set->warm_start[i];
        uint32_t to = kept;
        while (to > 0 && vbss_contact_compare_keys(&set->warm_start[to - 1].key, &m.key) > 0) {
            to--;
        }
        bool twice = to > 0 && vbss_contact_compare_keys(&set->warm_start[to - 1].key, &m.key) == 0;
        if (m.key.kind != GONE && !twice) {
            memmove(&set->warm_start[to + 1], &set->warm_start[to],
                    (kept - to) * sizeof *set->warm_start);
            set->warm_start[to] = m;
            kept++;
        }
    }
    set->warm_start_count = kept;
}

/* ---- views of contacts, which say where they are */

static uint32_t rename_seen(const renaming *r, bool node, uint32_t feature, vec3 point)
{
    if (node) { /* a node that went: the one before it */
        uint32_t name = rename_node(&r->change, feature);
        return name == GONE ? feature - 1 : name;
    }
    bool beyond = false;
    if (is_divided(r, r->body->number, feature)) {
        const vec3 *x = r->body->thread.thread->now.x + feature;
        vec3 e = vec3_sub(x[1], x[0]);
        beyond = vec3_dot(vec3_sub(point, x[0]), e) > 0.5 * vec3_norm_squared(e);
    }
    return rename_segment(&r->change, feature, beyond);
}

static void rename_views(scene_object *s, const renaming *r)
{
    for (uint32_t i = 0; i < s->contact_count; i++) {
        uint32_t *f = s->contact_features[i];
        bool node = scene_is_of_node(f[0]);
        if (!node && !scene_is_of_segment(f[0])) {
            continue;
        }
        if (f[1] == r->body->number) {
            f[2] = rename_seen(r, node, f[2], s->contact_points[i]);
        }
        if (f[0] == VBSS_CONTACT_SEGMENTS && f[3] == r->body->number) {
            f[4] = rename_seen(r, false, f[4], s->contact_points[i]);
        }
    }
}

/* ---- what holds it */

/* Nodes of pins stay: nothing changes beside them. */
static void rename_holders(scene_object *s, const renaming *r)
{
    const mesh_change *c = &r->change;
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        scene_pin *p = &s->pins[i];
        if (p->id != 0 && p->thread == r->body->number) {
            p->node = rename_node(c, p->node);
        }
    }
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        scene_grasp *g = &s->grasps[i];
        if (g->id == 0 || g->thread != r->body->number) {
            continue;
        }
        bool beyond = is_divided(r, g->thread, g->segment) && g->into > r->before;
        bool joined = c->removes && g->segment == c->at;
        g->into += joined ? r->before : beyond ? -r->before : 0.0;
        g->segment = rename_segment(c, g->segment, beyond);
    }
}

static void rename_all(scene_object *s, const renaming *r)
{
    for (uint32_t i = 0; i < s->contacts->warm_start_count; i++) {
        rename_contact(s, r, &s->contacts->warm_start[i]);
    }
    rename_views(s, r);
    rename_holders(s, r);
}

bool vbss_scene_change_mesh(scene_object *s, const scene_body *thread, const mesh_change *change)
{
    thread_object *t = thread->thread.thread;
    renaming r = {thread, *change, 0.0};
    if (change->removes) {
        r.before = t->rest[change->at - 1];
        if (!vbss_thread_remove_node(t, change->at, change->room)) {
            return false;
        }
        rename_all(s, &r);
    } else { /* contacts are where the whole segment was */
        r.before = 0.5 * t->rest[change->at];
        rename_all(s, &r);
        vbss_thread_split_segment(t, change->at, change->room);
    }
    return true;
}
