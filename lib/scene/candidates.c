/* What might touch in a part of a step: pairs of features that are near, as far as they may move.
 *
 * The search lists pairs whose swept boxes come near; of these, those become rows that are nearer than the
 * distance of touching, the margin, and what they may approach each other. How far things may move is
 * a guess from their velocities, after a rejected attempt what that attempt did: the guard finds out. */
#include "base/error.h"
#include "scene/apart.h"
#include "scene/around_holes.h"
#include "scene/attempt.h"
#include "scene/cuts.h"
#include "scene/holes.h"
#include "scene/pins.h"
#include "scene/rows.h"
#include "scene/tools.h"

#include <string.h>

/* Normals turn while features pass: share of their way across it that may come along it. */
#define ACROSS 0.1
/* What is above the floor by so many times what it may come down has no row: by more than rounding. */
#define FAR_ABOVE 1.01

/* ---- ways */

static void set_thread_ways(scene_object *s, const scene_thread *b, const scene_part *part)
{
    const thread_object *t = b->thread;
    vec3 *ways = s->ways + b->first_node;
    for (uint32_t i = 0; i < t->node_count; i++) {
        ways[i] =
            part->again ? vec3_sub(t->trial[i], t->now.x[i]) : vec3_scale(t->now.v[i], part->h);
    }
    for (uint32_t place = 0; place < t->config.attachment_capacity; place++) {
        const thread_attachment *a = &t->attachments[place];
        if (a->id != 0 && vbss_thread_prescribes_motion(a->kind)) {
            vec3 there = vbss_thread_attachment_position(a, part->end);
            ways[a->node] = vec3_sub(there, t->now.x[a->node]);
        }
    }
}

static void set_capsule_ways(scene_object *s, const scene_rigid *r, const scene_part *part)
{
    const vbss_rigid_substep p = {part->step, part->begin, part->end};
    vbss_rigid_motion to;
    if (r->kind == VBSS_RIGID_DRIVEN) {
        to = vbss_rigid_target_motion(&r->body, &p);
    } else {
        vbss_rigid_predict(&r->body, &p, &to);
    }
    for (uint32_t i = r->first_capsule; i < r->first_capsule + r->capsule_count; i++) {
        scene_capsule *c = &s->capsules[i];
        vec3 *ways = s->ways + s->config.node_capacity + 2 * (size_t)i;
        vbss_scene_place_capsule(c, r->body.now.pose, c->now);
        for (int k = 0; k < 2; k++) {
            vec3 there = part->again ? c->trial[k] : pose_apply(to.pose, c->local_trial[k]);
            ways[k] = vec3_sub(there, c->now[k]);
        }
    }
}

static void set_ways(scene_object *s, const scene_part *part)
{
    for (uint32_t i = 0; i < s->place_count; i++) {
        if (s->bodies[i].kind == BODY_THREAD) {
            set_thread_ways(s, &s->bodies[i].thread, part);
        } else if (s->bodies[i].kind == BODY_RIGID) {
            set_capsule_ways(s, &s->bodies[i].rigid, part);
        } else if (s->bodies[i].kind == BODY_DRAIN) {
            vbss_scene_aim_drain(&s->bodies[i].drain, part);
        }
    }
}

/* ---- the search */

static vbss_result move_shape(scene_object *s, const scene_body *b)
{
    uint32_t count = 0;
    const vec3 *ways = s->ways;
    vec3 *start = s->vertices;
    if (b->kind == BODY_THREAD) {
        const thread_object *t = b->thread.thread;
        count = t->node_count;
        ways += b->thread.first_node;
        memcpy(start, t->now.x, count * sizeof *start);
    } else if (b->kind == BODY_DRAIN) {
        count = b->drain.drain->mesh.node_count;
        ways = b->drain.ways;
        start = b->drain.vertices;
        memcpy(start, b->drain.drain->x, count * sizeof *start);
    } else {
        const scene_rigid *r = &b->rigid;
        count = 2 * r->capsule_count;
        ways += s->config.node_capacity + 2 * (size_t)r->first_capsule;
        for (uint32_t i = 0; i < count; i++) {
            start[i] = s->capsules[r->first_capsule + i / 2].now[i % 2];
        }
    }
    vec3 *end = start + count;
    for (uint32_t i = 0; i < count; i++) {
        end[i] = vec3_add_scaled(start[i], SCENE_AHEAD, ways[i]);
    }
    VBSS_TRY(vbss_collision_move(scene_collision(s), b->shape, &start->x, &end->x, count));
    vbss_collision_update_displacements(s->collision->shapes[b->shape]);
    return VBSS_OK;
}

vbss_result vbss_scene_find_pairs(scene_object *s)
{
    VBSS_TRY(vbss_collision_find_candidates(scene_collision(s)));
    s->edge_pairs = s->collision->candidate_count;
    while (s->edge_pairs > 0 &&
           s->collision->candidates[s->edge_pairs - 1].kind != VBSS_PAIR_EDGE_EDGE) {
        s->edge_pairs--;
    }
    return VBSS_OK;
}

static vbss_result search(scene_object *s)
{
    for (uint32_t i = 0; i < s->place_count; i++) {
        if (s->bodies[i].kind != BODY_GONE) {
            VBSS_TRY(move_shape(s, &s->bodies[i]));
        }
    }
    return vbss_scene_find_pairs(s);
}

/* ---- rows */

static const vec3 *ways_of_node(const scene_object *s, const scene_body *b, uint32_t node)
{
    return s->ways + b->thread.first_node + node;
}

static const vec3 *ways_of_capsule(const scene_object *s, const scene_body *b, uint32_t capsule)
{
    return s->ways + s->config.node_capacity + 2 * (size_t)(b->rigid.first_capsule + capsule);
}

bool vbss_scene_is_given(const scene_object *s, const scene_body *b, uint32_t kind, bool is_b,
                         uint32_t feature)
{
    if (b == NULL || b->kind == BODY_RIGID) {
        return b == NULL || b->rigid.kind == VBSS_RIGID_DRIVEN;
    }
    if (b->kind == BODY_DRAIN) {
        uint32_t nodes[3], count = vbss_scene_nodes_of(s, b, kind, is_b, feature, nodes);
        bool given = true;
        for (uint32_t k = 0; k < count; k++) {
            given = given && b->drain.drain->anchored[nodes[k]] != 0;
        }
        return given;
    }
    const thread_object *t = b->thread.thread;
    bool alone = kind == VBSS_CONTACT_NODE_FLOOR || kind == VBSS_CONTACT_POINT_FACE,
         smooth = kind == VBSS_CONTACT_NODE_CAPSULE;
    uint32_t first = smooth && feature > 0 ? feature - 1 : feature;
    uint32_t end = feature + (alone ? 1u : 2u);
    for (uint32_t k = first; k < end && k < t->node_count; k++) {
        if (t->prescribed_by[k] == 0) {
            return false;
        }
    }
    return true;
}

/* The largest approach of any point of one feature to any of the other is that of two vertices: in any direction, and
 * along one. */
static double reach_of(const scene_meeting *m)
{
    double largest = 0.0;
    for (uint32_t i = 0; i < m->count_a; i++) {
        for (uint32_t k = 0; k < m->count_b; k++) {
            vec3 way = vec3_sub(m->ways_a[i], m->ways_b[k]);
            largest = vbss_max_or_nan(vec3_norm_squared(way), largest);
        }
    }
    return SCENE_AHEAD * sqrt(largest);
}

static double approach_of(const scene_meeting *m, vec3 normal)
{
    double most = 0.0;
    for (uint32_t i = 0; i < m->count_a; i++) {
        for (uint32_t k = 0; k < m->count_b; k++) {
            vec3 way = vec3_sub(m->ways_a[i], m->ways_b[k]);
            most = vbss_max_or_nan(-vec3_dot(normal, way), most);
        }
    }
    return SCENE_AHEAD * most;
}

/* Of a wall, which swings the line through it farther than its middle goes. */
static bool is_lip(const scene_body *b, const contact_key *key, bool is_b)
{
    const uint32_t feature = is_b ? key->feature_b : key->feature_a;
    return key->kind == VBSS_CONTACT_SIDES
               ? b->drain.lip_of_side[feature] != SCENE_NO_FACE
               : !is_b && b->drain.lip_of_node[feature] != SCENE_NO_FACE;
}

static bool swings(const scene_meeting *m, const contact_key *key)
{
    return m->a->kind == BODY_DRAIN && m->b->kind == BODY_DRAIN &&
           (is_lip(m->a, key, false) || is_lip(m->b, key, true));
}

/* Laid, and whether it is near enough to touch. */
static bool lay(const scene_object *s, contact_constraint *row, const scene_meeting *m)
{
    uint32_t kind = row->key.kind;
    double margin = s->config.contact_margin, reach = reach_of(m);
    bool near = vbss_scene_lay_row(s, row, m->a, m->b, reach + margin);
    bool directed =
        kind == VBSS_CONTACT_SEGMENTS || (scene_is_of_surface(kind) && !swings(m, &row->key));
    if (near && directed) {
        near = row->start_gap < approach_of(m, row->normal) + ACROSS * reach + margin;
    }
    return near;
}

/* Where a needle is nearest to a side it is in its hole: the rest of it, before and behind, may touch that side elsewhere. A
 * pair has one row, of the nearest piece. */
static bool lay_beside_holes(const scene_object *s, contact_constraint *row, const scene_meeting *m)
{
    const double reach = SCENE_PIN_ARC * row->contact_distance;
    scene_piece piece = {.begun = false}, nearest = piece;
    double least = (double)INFINITY;
    while (vbss_scene_next_piece(s, m->a, row->key.feature_a, m->b, row->key.feature_b, reach,
                                 &piece)) {
        memcpy(row->axis_interval, piece.at, sizeof piece.at);
        if (lay(s, row, m) && row->start_gap < least) {
            least = row->start_gap;
            nearest = piece;
        }
    }
    if (!nearest.begun) {
        return false;
    }
    memcpy(row->axis_interval, nearest.at, sizeof nearest.at);
    return lay(s, row, m);
}

static bool is_needle_at_drain(const contact_constraint *row, const scene_meeting *m)
{
    return row->key.kind == VBSS_CONTACT_SIDES && m->a->kind == BODY_RIGID &&
           m->a->rigid.needle != NULL;
}

bool vbss_scene_add_row(scene_object *s, const contact_key *key, const scene_meeting *m)
{
    if (vbss_scene_is_given(s, m->a, key->kind, false, key->feature_a) &&
        vbss_scene_is_given(s, m->b, key->kind, true, key->feature_b)) {
        s->unlisted = s->unlisted || m->b != NULL; /* the floor is not the guard's pair */
        return true;
    }
    contact_constraint *row = vbss_contact_add(s->contacts, key);
    if (row == NULL) {
        return false;
    }
    bool near = lay(s, row, m);
    if (m->pair != NULL) { /* from the line through a lip it is no farther than from its middle */
        vbss_collision_store_separation(s->collision, m->pair,
                                        row->start_gap + row->contact_distance);
    }
    double share = near && scene_is_of_surface(key->kind) ? vbss_scene_share_of_row(s, row) : 1.0;
    if (share == 0.0 && is_needle_at_drain(row, m)) {
        share = lay_beside_holes(s, row, m) ? 1.0 : 0.0;
    }
    row->overlap_allowance = (1.0 - share) * row->contact_distance;
    row->start_gap += row->overlap_allowance;
    if (!near || share == 0.0) {
        s->contacts->count--;
    }
    return true;
}

/* Where the thread is fine against the capsule, its smoothed nodes touch; else its segments. */
static bool is_fine(const thread_object *t, uint32_t segment, double radius)
{
    return t->rest[segment] <= radius;
}

static bool listed(const scene_object *s, const collision_candidate *like, uint32_t a)
{
    const collision_object *c = s->collision;
    uint32_t low = 0, high = s->edge_pairs;
    while (low < high) {
        uint32_t middle = low + (high - low) / 2;
        const collision_candidate *q = &c->candidates[middle];
        bool before = q->shape_a != like->shape_a   ? q->shape_a < like->shape_a
                      : q->a != a                   ? q->a < a
                      : q->shape_b != like->shape_b ? q->shape_b < like->shape_b
                                                    : q->b < like->b;
        low = before ? middle + 1 : low;
        high = before ? high : middle;
    }
    const collision_candidate *q = &c->candidates[low];
    return low < s->edge_pairs && q->shape_a == like->shape_a && q->a == a &&
           q->shape_b == like->shape_b && q->b == like->b;
}

typedef struct thread_meets {
    const scene_body *thread, *rigid;
    uint32_t segment, capsule;
} thread_meets;

static bool add_node_row(scene_object *s, const thread_meets *m, uint32_t node)
{
    const contact_key key = {VBSS_CONTACT_NODE_CAPSULE, m->thread->number, node, m->rigid->number,
                             m->capsule};
    uint32_t last = m->thread->thread.thread->node_count - 1;
    uint32_t first = node > 0 ? node - 1 : 0, end = node < last ? node + 1 : last;
    const scene_meeting w = {m->thread,
                             m->rigid,
                             ways_of_node(s, m->thread, first),
                             ways_of_capsule(s, m->rigid, m->capsule),
                             end - first + 1,
                             2,
                             NULL};
    return vbss_scene_add_row(s, &key, &w);
}

/* Nodes come with the segment before them, unless that is not near or does not touch: so each comes once. */
static bool add_thread_rows(scene_object *s, const collision_candidate *q, const thread_meets *m,
                            bool thread_first)
{
    const thread_object *t = m->thread->thread.thread;
    double radius = s->capsules[m->rigid->rigid.first_capsule + m->capsule].radius;
    double touching = radius + t->config.radius;
    bool fine = is_fine(t, m->segment, radius); /* what is smoothed may be nearer than the pair */
    if (!fine && scene_stay_apart(s, q, s->config.contact_margin)) {
        return true;
    }
    if (vbss_scene_comes_from(s, m->thread, m->segment, m->rigid, m->capsule, touching)) {
        return true;
    }
    if (!fine) {
        const contact_key key = {VBSS_CONTACT_SEGMENT_CAPSULE, m->thread->number, m->segment,
                                 m->rigid->number, m->capsule};
        const scene_meeting w = {m->thread,
                                 m->rigid,
                                 ways_of_node(s, m->thread, m->segment),
                                 ways_of_capsule(s, m->rigid, m->capsule),
                                 2,
                                 2,
                                 q};
        return vbss_scene_add_row(s, &key, &w);
    }
    bool before =
        m->segment > 0 && is_fine(t, m->segment - 1, radius) &&
        !vbss_scene_comes_from(s, m->thread, m->segment - 1, m->rigid, m->capsule, touching);
    if (before) {
        collision_candidate like = *q;
        if (thread_first) {
            before = listed(s, &like, m->segment - 1);
        } else {
            like.b = m->segment - 1;
            before = listed(s, &like, q->a);
        }
    }
    return (before || add_node_row(s, m, m->segment)) && add_node_row(s, m, m->segment + 1);
}

static bool add_pair(scene_object *s, const collision_candidate *q)
{
    const scene_body *a = &s->bodies[s->shape_places[q->shape_a]];
    const scene_body *b = &s->bodies[s->shape_places[q->shape_b]];
    if (a->kind == b->kind || a->kind == BODY_DRAIN || b->kind == BODY_DRAIN) {
        if (scene_stay_apart(s, q, s->config.contact_margin)) {
            return true;
        }
    }
    if (a->kind == BODY_DRAIN || b->kind == BODY_DRAIN) {
        return vbss_scene_add_surface_row(s, q);
    }
    if (a->kind == BODY_THREAD && b->kind == BODY_THREAD) {
        if (vbss_scene_adjoins(s, a, q->a, b, q->b)) {
            return true;
        }
        const contact_key key = {VBSS_CONTACT_SEGMENTS, a->number, q->a, b->number, q->b};
        const scene_meeting w = {a, b, ways_of_node(s, a, q->a), ways_of_node(s, b, q->b), 2, 2, q};
        return vbss_scene_add_row(s, &key, &w);
    }
    if (a->kind == BODY_RIGID && b->kind == BODY_RIGID) {
        if (vbss_scene_is_in_jaws(s, a, q->a, b, q->b) ||
            vbss_scene_is_in_jaws(s, b, q->b, a, q->a)) {
            return true;
        }
        const contact_key key = {VBSS_CONTACT_CAPSULES, a->number, q->a, b->number, q->b};
        const scene_meeting w = {a, b, ways_of_capsule(s, a, q->a), ways_of_capsule(s, b, q->b), 2,
                                 2, q};
        return vbss_scene_add_row(s, &key, &w);
    }
    bool first = a->kind == BODY_THREAD;
    const thread_meets m = {first ? a : b, first ? b : a, first ? q->a : q->b, first ? q->b : q->a};
    return add_thread_rows(s, q, &m, first);
}

/* ---- the floor */

bool vbss_scene_add_floor_row(scene_object *s, const contact_key *key, const scene_body *b, vec3 x,
                              double radius, vec3 way)
{
    static const vec3 floor;
    /* Only what comes down can meet it. */
    double down = vbss_min(vec3_dot(way, s->floor_normal), 0.0);
    double gap = vec3_dot(s->floor_normal, x) - s->config.floor_height - radius;
    if (gap - s->config.contact_margin > -FAR_ABOVE * SCENE_AHEAD * down) {
        return true;
    }
    vec3 comes = vec3_scale(s->floor_normal, down);
    const scene_meeting m = {b, NULL, &comes, &floor, 1, 1, NULL};
    return vbss_scene_add_row(s, key, &m);
}

static bool add_floor_rows(scene_object *s, const scene_body *b)
{
    if (b->kind == BODY_DRAIN) {
        return vbss_scene_add_drain_floor_rows(s, b);
    }
    bool thread = b->kind == BODY_THREAD;
    uint32_t count = thread ? b->thread.thread->node_count : 2 * b->rigid.capsule_count;
    for (uint32_t i = 0; i < count; i++) {
        const contact_key key = {thread ? VBSS_CONTACT_NODE_FLOOR : VBSS_CONTACT_CAPSULE_FLOOR,
                                 b->number, i, 0, 0};
        const vec3 *way = thread ? ways_of_node(s, b, i) : ways_of_capsule(s, b, i / 2) + i % 2;
        const scene_capsule *c = thread ? NULL : &s->capsules[b->rigid.first_capsule + i / 2];
        vec3 x = thread ? b->thread.thread->now.x[i] : c->now[i % 2];
        double radius = thread ? b->thread.thread->config.radius : c->radius;
        if (!vbss_scene_add_floor_row(s, &key, b, x, radius, *way)) {
            return false;
        }
    }
    return true;
}

/* ---- all of it */

static void note_near(scene_object *s)
{
    for (uint32_t i = 0; i < s->place_count; i++) {
        s->bodies[i].thread.near = s->bodies[i].thread.welded = false;
    }
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        const contact_key *key = &s->contacts->constraints[i].key;
        scene_body *a = vbss_scene_body(s, key->body_a), *b = vbss_scene_body(s, key->body_b);
        a->thread.near = true;
        if (b != NULL) {
            b->thread.near = true;
        }
    }
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        if (s->pins[i].id != 0 && s->pins[i].attachment == 0) {
            vbss_scene_body(s, s->pins[i].thread)->thread.welded = true;
        }
    }
}

bool vbss_scene_find_rows(scene_object *s, const scene_part *part)
{
    contact_set *set = s->contacts;
    vbss_scene_aim_capsules(s, part);
    set_ways(s, part);
    if (search(s) != VBSS_OK) {
        return false;
    }
    vbss_contact_clear(set);
    s->unlisted = false;
    for (uint32_t i = 0; i < s->collision->candidate_count; i++) {
        if (!add_pair(s, &s->collision->candidates[i])) {
            return false;
        }
    }
    for (uint32_t i = 0; s->config.floor != 0 && i < s->place_count; i++) {
        if (s->bodies[i].kind != BODY_GONE && !add_floor_rows(s, &s->bodies[i])) {
            return false;
        }
    }
    if (!vbss_scene_add_grasp_rows(s) || !vbss_scene_add_hold_rows(s) ||
        !vbss_scene_add_pinch_rows(s) || !vbss_scene_add_hole_rows(s)) {
        return false;
    }
    vbss_contact_sort(set);
    vbss_scene_remove_doubles(s);
    note_near(s);
    return true;
}
