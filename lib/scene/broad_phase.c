/* What might touch in a part of a step: pairs of features that are near, as far as they may move.
 *
 * The search lists pairs whose swept boxes come near; of these, those become rows that are nearer than the
 * distance of touching, the margin, and what they may approach each other. How far things may move is
 * a guess from their velocities, after a rejected attempt what that attempt did: the guard finds out. */
#include "base/error.h"
#include "scene/separation_cache.h"
#include "scene/hole_exclusion.h"
#include "scene/substep.h"
#include "scene/cuts.h"
#include "scene/holes.h"
#include "scene/pins.h"
#include "scene/contacts.h"
#include "scene/tools.h"

#include <string.h>

/* Normals turn while features pass: share of their way across it that may come along it. */
#define LATERAL_RATIO 0.1
/* What is above the floor by so many times what it may come down has no row: by more than rounding. */
#define FLOOR_REACH_RATIO 1.01

/* ---- ways */

static void set_thread_displacements(scene_object *s, const scene_thread *b,
                                     const scene_substep *substep)
{
    const thread_object *t = b->thread;
    vec3 *displacements = s->expected_displacements + b->first_node;
    for (uint32_t i = 0; i < t->node_count; i++) {
        displacements[i] = substep->uses_trial_motion ? vec3_sub(t->trial[i], t->now.x[i])
                                                      : vec3_scale(t->now.v[i], substep->h);
    }
    for (uint32_t k = 0; k < t->config.attachment_capacity; k++) {
        const thread_attachment *a = &t->attachments[k];
        if (a->id != 0 && vbss_thread_prescribes_motion(a->kind)) {
            vec3 target = vbss_thread_attachment_position(a, substep->end_fraction);
            displacements[a->node] = vec3_sub(target, t->now.x[a->node]);
        }
    }
}

static void set_capsule_displacements(scene_object *s, const scene_rigid *r,
                                      const scene_substep *substep)
{
    const vbss_rigid_substep p = {substep->step_length, substep->start_fraction,
                                  substep->end_fraction};
    vbss_rigid_motion next_motion;
    if (r->kind == VBSS_RIGID_DRIVEN) {
        next_motion = vbss_rigid_target_motion(&r->body, &p);
    } else {
        vbss_rigid_predict(&r->body, &p, &next_motion);
    }
    for (uint32_t i = r->first_capsule; i < r->first_capsule + r->capsule_count; i++) {
        scene_capsule *c = &s->capsules[i];
        vec3 *displacements = s->expected_displacements + s->config.node_capacity + 2 * (size_t)i;
        vbss_scene_transform_capsule(c, r->body.now.pose, c->now);
        for (int k = 0; k < 2; k++) {
            vec3 target = substep->uses_trial_motion
                              ? c->trial[k]
                              : pose_apply(next_motion.pose, c->local_trial[k]);
            displacements[k] = vec3_sub(target, c->now[k]);
        }
    }
}

static void set_displacements(scene_object *s, const scene_substep *substep)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (s->bodies[i].kind == SCENE_BODY_THREAD) {
            set_thread_displacements(s, &s->bodies[i].thread, substep);
        } else if (s->bodies[i].kind == SCENE_BODY_RIGID) {
            set_capsule_displacements(s, &s->bodies[i].rigid, substep);
        } else if (s->bodies[i].kind == SCENE_BODY_DRAIN) {
            vbss_scene_set_drain_displacements(&s->bodies[i].drain, substep);
        }
    }
}

/* ---- the search */

static vbss_result sweep_shape(scene_object *s, const scene_body *b)
{
    uint32_t count = 0;
    const vec3 *displacements = s->expected_displacements;
    vec3 *start = s->vertices;
    if (b->kind == SCENE_BODY_THREAD) {
        const thread_object *t = b->thread.thread;
        count = t->node_count;
        displacements += b->thread.first_node;
        memcpy(start, t->now.x, count * sizeof *start);
    } else if (b->kind == SCENE_BODY_DRAIN) {
        count = b->drain.drain->mesh.node_count;
        displacements = b->drain.expected_displacements;
        start = b->drain.vertices;
        memcpy(start, b->drain.drain->x, count * sizeof *start);
    } else {
        const scene_rigid *r = &b->rigid;
        count = 2 * r->capsule_count;
        displacements += s->config.node_capacity + 2 * (size_t)r->first_capsule;
        for (uint32_t i = 0; i < count; i++) {
            start[i] = s->capsules[r->first_capsule + i / 2].now[i % 2];
        }
    }
    vec3 *end = start + count;
    for (uint32_t i = 0; i < count; i++) {
        end[i] = vec3_add_scaled(start[i], SCENE_EXTRAPOLATION_RATIO, displacements[i]);
    }
    VBSS_TRY(vbss_collision_move(scene_collision(s), b->shape, &start->x, &end->x, count));
    vbss_collision_update_displacements(s->collision->shapes[b->shape]);
    return VBSS_OK;
}

vbss_result vbss_scene_run_broad_phase(scene_object *s)
{
    VBSS_TRY(vbss_collision_find_candidates(scene_collision(s)));
    s->edge_pair_count = s->collision->candidate_count;
    while (s->edge_pair_count > 0 &&
           s->collision->candidates[s->edge_pair_count - 1].kind != VBSS_PAIR_EDGE_EDGE) {
        s->edge_pair_count--;
    }
    return VBSS_OK;
}

static vbss_result find_candidates(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (s->bodies[i].kind != SCENE_BODY_NONE) {
            VBSS_TRY(sweep_shape(s, &s->bodies[i]));
        }
    }
    return vbss_scene_run_broad_phase(s);
}

/* ---- rows */

static const vec3 *node_displacements(const scene_object *s, const scene_body *b, uint32_t node)
{
    return s->expected_displacements + b->thread.first_node + node;
}

static const vec3 *capsule_displacements(const scene_object *s, const scene_body *b,
                                         uint32_t capsule)
{
    return s->expected_displacements + s->config.node_capacity +
           2 * (size_t)(b->rigid.first_capsule + capsule);
}

bool vbss_scene_is_feature_prescribed(const scene_object *s, const scene_body *b, uint32_t kind,
                                      bool is_b, uint32_t feature)
{
    if (b == NULL || b->kind == SCENE_BODY_RIGID) {
        return b == NULL || b->rigid.kind == VBSS_RIGID_DRIVEN;
    }
    if (b->kind == SCENE_BODY_DRAIN) {
        uint32_t nodes[3], count = vbss_scene_drain_feature_nodes(s, b, kind, is_b, feature, nodes);
        bool prescribed = true;
        for (uint32_t k = 0; k < count; k++) {
            prescribed = prescribed && b->drain.drain->anchored[nodes[k]] != 0;
        }
        return prescribed;
    }
    const thread_object *t = b->thread.thread;
    bool is_point = kind == VBSS_CONTACT_NODE_FLOOR || kind == VBSS_CONTACT_POINT_FACE,
         smooth = kind == VBSS_CONTACT_NODE_CAPSULE;
    uint32_t first = smooth && feature > 0 ? feature - 1 : feature;
    uint32_t end = feature + (is_point ? 1u : 2u);
    for (uint32_t k = first; k < end && k < t->node_count; k++) {
        if (t->prescribed_by[k] == 0) {
            return false;
        }
    }
    return true;
}

/* The largest approach of any point of one feature to any of the other is that of two vertices: in any direction, and
 * along one. */
static double largest_relative_motion(const scene_contact_pair *m)
{
    double largest = 0.0;
    for (uint32_t i = 0; i < m->count_a; i++) {
        for (uint32_t k = 0; k < m->count_b; k++) {
            vec3 displacement = vec3_sub(m->displacements_a[i], m->displacements_b[k]);
            largest = vbss_max_or_nan(vec3_norm_squared(displacement), largest);
        }
    }
    return SCENE_EXTRAPOLATION_RATIO * sqrt(largest);
}

static double largest_approach(const scene_contact_pair *m, vec3 normal)
{
    double largest = 0.0;
    for (uint32_t i = 0; i < m->count_a; i++) {
        for (uint32_t k = 0; k < m->count_b; k++) {
            vec3 displacement = vec3_sub(m->displacements_a[i], m->displacements_b[k]);
            largest = vbss_max_or_nan(-vec3_dot(normal, displacement), largest);
        }
    }
    return SCENE_EXTRAPOLATION_RATIO * largest;
}

/* Of a wall, which swings the line through it farther than its middle goes. */
static bool is_lip(const scene_body *b, const contact_key *key, bool is_b)
{
    const uint32_t feature = is_b ? key->feature_b : key->feature_a;
    return key->kind == VBSS_CONTACT_SIDES
               ? b->drain.lip_of_side[feature] != SCENE_NO_FACE
               : !is_b && b->drain.lip_of_node[feature] != SCENE_NO_FACE;
}

static bool has_swinging_lip(const scene_contact_pair *m, const contact_key *key)
{
    return m->a->kind == SCENE_BODY_DRAIN && m->b->kind == SCENE_BODY_DRAIN &&
           (is_lip(m->a, key, false) || is_lip(m->b, key, true));
}

/* Laid, and whether it is near enough to touch. */
static bool compute_geometry(const scene_object *s, contact_constraint *constraint,
                             const scene_contact_pair *m)
{
    uint32_t kind = constraint->key.kind;
    double margin = s->config.contact_margin, reach = largest_relative_motion(m);
    bool near = vbss_scene_run_narrow_phase(s, constraint, m->a, m->b, reach + margin);
    bool is_directional = kind == VBSS_CONTACT_SEGMENTS || (scene_is_surface_contact(kind) &&
                                                            !has_swinging_lip(m, &constraint->key));
    if (near && is_directional) {
        near = constraint->start_gap <
               largest_approach(m, constraint->normal) + LATERAL_RATIO * reach + margin;
    }
    return near;
}

/* Where a needle is nearest to a side it is in its hole: the rest of it, before and behind, may touch that side elsewhere. A
 * pair has one row, of the nearest piece. */
static bool compute_geometry_beside_holes(const scene_object *s, contact_constraint *constraint,
                                          const scene_contact_pair *m)
{
    const double reach = SCENE_EXCLUSION_ARC_RATIO * constraint->contact_distance;
    scene_axis_interval interval = {.started = false}, nearest = interval;
    double min_gap = (double)INFINITY;
    while (vbss_scene_next_axis_interval(s, m->a, constraint->key.feature_a, m->b,
                                         constraint->key.feature_b, reach, &interval)) {
        memcpy(constraint->axis_interval, interval.bounds, sizeof interval.bounds);
        if (compute_geometry(s, constraint, m) && constraint->start_gap < min_gap) {
            min_gap = constraint->start_gap;
            nearest = interval;
        }
    }
    if (!nearest.started) {
        return false;
    }
    memcpy(constraint->axis_interval, nearest.bounds, sizeof nearest.bounds);
    return compute_geometry(s, constraint, m);
}

static bool is_needle_at_drain(const contact_constraint *constraint, const scene_contact_pair *m)
{
    return constraint->key.kind == VBSS_CONTACT_SIDES && m->a->kind == SCENE_BODY_RIGID &&
           m->a->rigid.needle != NULL;
}

bool vbss_scene_add_contact(scene_object *s, const contact_key *key, const scene_contact_pair *m)
{
    if (vbss_scene_is_feature_prescribed(s, m->a, key->kind, false, key->feature_a) &&
        vbss_scene_is_feature_prescribed(s, m->b, key->kind, true, key->feature_b)) {
        s->has_unlisted_pairs =
            s->has_unlisted_pairs || m->b != NULL; /* the floor is not the guard's pair */
        return true;
    }
    contact_constraint *constraint = vbss_contact_add(s->contacts, key);
    if (constraint == NULL) {
        return false;
    }
    bool near = compute_geometry(s, constraint, m);
    if (m->candidate !=
        NULL) { /* from the line through a lip it is no farther than from its middle */
        vbss_collision_store_separation(s->collision, m->candidate,
                                        constraint->start_gap + constraint->contact_distance);
    }
    double scale = near && scene_is_surface_contact(key->kind)
                       ? vbss_scene_contact_scale_of(s, constraint)
                       : 1.0;
    if (scale == 0.0 && is_needle_at_drain(constraint, m)) {
        scale = compute_geometry_beside_holes(s, constraint, m) ? 1.0 : 0.0;
    }
    constraint->overlap_allowance = (1.0 - scale) * constraint->contact_distance;
    constraint->start_gap += constraint->overlap_allowance;
    if (!near || scale == 0.0) {
        s->contacts->count--;
    }
    return true;
}

/* Where the thread is fine against the capsule, its smoothed nodes touch; else its segments. */
static bool is_fine(const thread_object *t, uint32_t segment, double radius)
{
    return t->rest[segment] <= radius;
}

static bool is_listed(const scene_object *s, const collision_candidate *like, uint32_t a)
{
    const collision_object *c = s->collision;
    uint32_t low = 0, high = s->edge_pair_count;
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
    return low < s->edge_pair_count && q->shape_a == like->shape_a && q->a == a &&
           q->shape_b == like->shape_b && q->b == like->b;
}

typedef struct thread_capsule_pair {
    const scene_body *thread, *rigid;
    uint32_t segment, capsule;
} thread_capsule_pair;

static bool add_node_contact(scene_object *s, const thread_capsule_pair *m, uint32_t node)
{
    const contact_key key = {VBSS_CONTACT_NODE_CAPSULE, m->thread->number, node, m->rigid->number,
                             m->capsule};
    uint32_t last = m->thread->thread.thread->node_count - 1;
    uint32_t first = node > 0 ? node - 1 : 0, end = node < last ? node + 1 : last;
    const scene_contact_pair w = {m->thread,
                                  m->rigid,
                                  node_displacements(s, m->thread, first),
                                  capsule_displacements(s, m->rigid, m->capsule),
                                  end - first + 1,
                                  2,
                                  NULL};
    return vbss_scene_add_contact(s, &key, &w);
}

/* Nodes come with the segment before them, unless that is not near or does not touch: so each comes once. */
static bool add_thread_contacts(scene_object *s, const collision_candidate *q,
                                const thread_capsule_pair *m, bool thread_first)
{
    const thread_object *t = m->thread->thread.thread;
    double radius = s->capsules[m->rigid->rigid.first_capsule + m->capsule].radius;
    double contact_distance = radius + t->config.radius;
    bool fine = is_fine(t, m->segment, radius); /* what is smoothed may be nearer than the pair */
    if (!fine && scene_is_known_apart(s, q, s->config.contact_margin)) {
        return true;
    }
    if (vbss_scene_is_excluded_at_pin(s, m->thread, m->segment, m->rigid, m->capsule,
                                      contact_distance)) {
        return true;
    }
    if (!fine) {
        const contact_key key = {VBSS_CONTACT_SEGMENT_CAPSULE, m->thread->number, m->segment,
                                 m->rigid->number, m->capsule};
        const scene_contact_pair w = {m->thread,
                                      m->rigid,
                                      node_displacements(s, m->thread, m->segment),
                                      capsule_displacements(s, m->rigid, m->capsule),
                                      2,
                                      2,
                                      q};
        return vbss_scene_add_contact(s, &key, &w);
    }
    bool before = m->segment > 0 && is_fine(t, m->segment - 1, radius) &&
                  !vbss_scene_is_excluded_at_pin(s, m->thread, m->segment - 1, m->rigid, m->capsule,
                                                 contact_distance);
    if (before) {
        collision_candidate like = *q;
        if (thread_first) {
            before = is_listed(s, &like, m->segment - 1);
        } else {
            like.b = m->segment - 1;
            before = is_listed(s, &like, q->a);
        }
    }
    return (before || add_node_contact(s, m, m->segment)) && add_node_contact(s, m, m->segment + 1);
}

static bool add_pair_contacts(scene_object *s, const collision_candidate *q)
{
    const scene_body *a = &s->bodies[s->body_of_shape[q->shape_a]];
    const scene_body *b = &s->bodies[s->body_of_shape[q->shape_b]];
    if (a->kind == b->kind || a->kind == SCENE_BODY_DRAIN || b->kind == SCENE_BODY_DRAIN) {
        if (scene_is_known_apart(s, q, s->config.contact_margin)) {
            return true;
        }
    }
    if (a->kind == SCENE_BODY_DRAIN || b->kind == SCENE_BODY_DRAIN) {
        return vbss_scene_add_surface_contact(s, q);
    }
    if (a->kind == SCENE_BODY_THREAD && b->kind == SCENE_BODY_THREAD) {
        if (vbss_scene_is_excluded_across_cut(s, a, q->a, b, q->b)) {
            return true;
        }
        const contact_key key = {VBSS_CONTACT_SEGMENTS, a->number, q->a, b->number, q->b};
        const scene_contact_pair w = {
            a, b, node_displacements(s, a, q->a), node_displacements(s, b, q->b), 2, 2, q};
        return vbss_scene_add_contact(s, &key, &w);
    }
    if (a->kind == SCENE_BODY_RIGID && b->kind == SCENE_BODY_RIGID) {
        if (vbss_scene_is_needle_in_grasp(s, a, q->a, b, q->b) ||
            vbss_scene_is_needle_in_grasp(s, b, q->b, a, q->a)) {
            return true;
        }
        const contact_key key = {VBSS_CONTACT_CAPSULES, a->number, q->a, b->number, q->b};
        const scene_contact_pair w = {
            a, b, capsule_displacements(s, a, q->a), capsule_displacements(s, b, q->b), 2, 2, q};
        return vbss_scene_add_contact(s, &key, &w);
    }
    bool first = a->kind == SCENE_BODY_THREAD;
    const thread_capsule_pair m = {first ? a : b, first ? b : a, first ? q->a : q->b,
                                   first ? q->b : q->a};
    return add_thread_contacts(s, q, &m, first);
}

/* ---- the floor */

bool vbss_scene_add_floor_contact(scene_object *s, const contact_key *key, const scene_body *b,
                                  vec3 x, double radius, vec3 displacement)
{
    static const vec3 floor_displacement;
    /* Only what comes down can meet it. */
    double down = vbss_min(vec3_dot(displacement, s->floor_normal), 0.0);
    double gap = vec3_dot(s->floor_normal, x) - s->config.floor_height - radius;
    if (gap - s->config.contact_margin > -FLOOR_REACH_RATIO * SCENE_EXTRAPOLATION_RATIO * down) {
        return true;
    }
    vec3 downward = vec3_scale(s->floor_normal, down);
    const scene_contact_pair m = {b, NULL, &downward, &floor_displacement, 1, 1, NULL};
    return vbss_scene_add_contact(s, key, &m);
}

static bool add_floor_contacts(scene_object *s, const scene_body *b)
{
    if (b->kind == SCENE_BODY_DRAIN) {
        return vbss_scene_add_drain_floor_contacts(s, b);
    }
    bool thread = b->kind == SCENE_BODY_THREAD;
    uint32_t count = thread ? b->thread.thread->node_count : 2 * b->rigid.capsule_count;
    for (uint32_t i = 0; i < count; i++) {
        const contact_key key = {thread ? VBSS_CONTACT_NODE_FLOOR : VBSS_CONTACT_CAPSULE_FLOOR,
                                 b->number, i, 0, 0};
        const vec3 *displacement =
            thread ? node_displacements(s, b, i) : capsule_displacements(s, b, i / 2) + i % 2;
        const scene_capsule *c = thread ? NULL : &s->capsules[b->rigid.first_capsule + i / 2];
        vec3 x = thread ? b->thread.thread->now.x[i] : c->now[i % 2];
        double radius = thread ? b->thread.thread->config.radius : c->radius;
        if (!vbss_scene_add_floor_contact(s, &key, b, x, radius, *displacement)) {
            return false;
        }
    }
    return true;
}

/* ---- all of it */

static void set_contact_flags(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        s->bodies[i].thread.has_contacts = s->bodies[i].thread.is_welded = false;
    }
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        const contact_key *key = &s->contacts->constraints[i].key;
        scene_body *a = vbss_scene_body(s, key->body_a), *b = vbss_scene_body(s, key->body_b);
        a->thread.has_contacts = true;
        if (b != NULL) {
            b->thread.has_contacts = true;
        }
    }
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        if (s->pins[i].id != 0 && s->pins[i].attachment == 0) {
            vbss_scene_body(s, s->pins[i].thread)->thread.is_welded = true;
        }
    }
}

bool vbss_scene_create_contacts(scene_object *s, const scene_substep *substep)
{
    contact_set *set = s->contacts;
    vbss_scene_set_capsule_trials(s, substep);
    set_displacements(s, substep);
    if (find_candidates(s) != VBSS_OK) {
        return false;
    }
    vbss_contact_clear(set);
    s->has_unlisted_pairs = false;
    for (uint32_t i = 0; i < s->collision->candidate_count; i++) {
        if (!add_pair_contacts(s, &s->collision->candidates[i])) {
            return false;
        }
    }
    for (uint32_t i = 0; s->config.floor != 0 && i < s->body_count; i++) {
        if (s->bodies[i].kind != SCENE_BODY_NONE && !add_floor_contacts(s, &s->bodies[i])) {
            return false;
        }
    }
    if (!vbss_scene_add_thread_grasp_constraints(s) ||
        !vbss_scene_add_needle_grasp_constraints(s) || !vbss_scene_add_wall_grasp_constraints(s) ||
        !vbss_scene_add_hole_constraints(s)) {
        return false;
    }
    vbss_contact_sort(set);
    vbss_scene_remove_duplicate_contacts(s);
    set_contact_flags(s);
    return true;
}
