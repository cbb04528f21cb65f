/* Creates the contact constraints of a substep from the candidates of the broad phase.
 *
 * A candidate becomes a contact if its gap is below the contact margin plus the distance by which
 * its features may approach each other. That distance is an estimate from motion bounds, so CCD
 * checks the result of the substep. */
#include "scene/contacts/contacts.h"
#include "scene/tools/tools.h"
#include "scene/topology/topology.h"
#include "scene/world/world.h"

/* ---- contacts of two bodies */

static const vec3 *node_displacements(const scene_object *s, const scene_body *b, uint32_t node)
{
    return s->step.expected_displacements + b->thread.first_node + node;
}

static const vec3 *capsule_displacements(const scene_object *s, const scene_body *b,
                                         uint32_t capsule)
{
    return s->step.expected_displacements + s->config.node_capacity +
           2 * (size_t)(b->rigid.first_capsule + capsule);
}

/* A thread with short segments touches a capsule by its smoothed nodes, other threads by
 * their segments. */
static bool is_fine(const thread_object *t, uint32_t segment, double radius)
{
    return t->rest[segment] <= radius;
}

/* Whether the broad phase lists the pair `like` with `a` in place of its own feature a. Candidates
 * of edges are sorted. */
static bool is_listed(const scene_object *s, const collision_candidate *like, uint32_t a)
{
    const collision_object *c = s->collision;
    uint32_t low = 0, high = s->step.edge_pair_count;
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
    return low < s->step.edge_pair_count && q->shape_a == like->shape_a && q->a == a &&
           q->shape_b == like->shape_b && q->b == like->b;
}

typedef struct thread_capsule_pair {
    const scene_body *thread, *rigid;
    uint32_t segment, capsule;
} thread_capsule_pair;

static bool add_node_contact(scene_object *s, const thread_capsule_pair *m, uint32_t node)
{
    const contact_key key = {VBSS_SCENE_CONTACT_NODE_CAPSULE, m->thread->number, node,
                             m->rigid->number, m->capsule};
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

/* A segment adds its second node. It adds its first node only if the segment before it does not: so
 * each node is added once. */
static bool add_thread_contacts(scene_object *s, const collision_candidate *q,
                                const thread_capsule_pair *m, bool thread_first)
{
    const thread_object *t = m->thread->thread.thread;
    double radius = s->capsules[m->rigid->rigid.first_capsule + m->capsule].radius;
    double contact_distance = radius + t->config.radius;
    bool fine = is_fine(t, m->segment, radius); /* a smoothed node may be nearer than the segment */
    if (!fine && scene_is_known_apart(s, q, s->solver.contact_margin)) {
        return true;
    }
    if (vbss_scene_is_excluded_at_pin(s, m->thread, m->segment, m->rigid, m->capsule,
                                      contact_distance)) {
        return true;
    }
    if (!fine) {
        const contact_key key = {VBSS_SCENE_CONTACT_SEGMENT_CAPSULE, m->thread->number, m->segment,
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
    const bool has_surface = scene_has_triangles(a) || scene_has_triangles(b);
    if (a->kind == b->kind || has_surface) {
        if (scene_is_known_apart(s, q, s->solver.contact_margin)) {
            return true;
        }
    }
    if (has_surface) {
        return vbss_scene_is_behind_mesh(s, q) || vbss_scene_add_surface_contact(s, q);
    }
    if (a->kind == SCENE_BODY_THREAD && b->kind == SCENE_BODY_THREAD) {
        if (vbss_scene_is_excluded_across_cut(s, a, q->a, b, q->b)) {
            return true;
        }
        const contact_key key = {VBSS_SCENE_CONTACT_SEGMENTS, a->number, q->a, b->number, q->b};
        const scene_contact_pair w = {
            a, b, node_displacements(s, a, q->a), node_displacements(s, b, q->b), 2, 2, q};
        return vbss_scene_add_contact(s, &key, &w);
    }
    if (a->kind == SCENE_BODY_RIGID && b->kind == SCENE_BODY_RIGID) {
        if (vbss_scene_is_needle_in_grasp(s, a, q->a, b, q->b) ||
            vbss_scene_is_needle_in_grasp(s, b, q->b, a, q->a)) {
            return true;
        }
        const contact_key key = {VBSS_SCENE_CONTACT_CAPSULES, a->number, q->a, b->number, q->b};
        const scene_contact_pair w = {
            a, b, capsule_displacements(s, a, q->a), capsule_displacements(s, b, q->b), 2, 2, q};
        return vbss_scene_add_contact(s, &key, &w);
    }
    bool first = a->kind == SCENE_BODY_THREAD;
    const thread_capsule_pair m = {first ? a : b, first ? b : a, first ? q->a : q->b,
                                   first ? q->b : q->a};
    return add_thread_contacts(s, q, &m, first);
}

/* ---- contacts with planes */

static bool add_plane_contacts_of(scene_object *s, const scene_body *b, const scene_body *plane)
{
    if (b->kind == SCENE_BODY_DRAIN) {
        return vbss_scene_add_drain_plane_contacts(s, b, plane);
    }
    bool thread = b->kind == SCENE_BODY_THREAD;
    uint32_t count = thread ? b->thread.thread->node_count : 2 * b->rigid.capsule_count;
    for (uint32_t i = 0; i < count; i++) {
        const contact_key key = {thread ? VBSS_SCENE_CONTACT_NODE_FLOOR
                                        : VBSS_SCENE_CONTACT_CAPSULE_FLOOR,
                                 b->number, i, plane != NULL ? plane->number : 0, 0};
        const vec3 *displacement =
            thread ? node_displacements(s, b, i) : capsule_displacements(s, b, i / 2) + i % 2;
        const scene_capsule *c = thread ? NULL : &s->capsules[b->rigid.first_capsule + i / 2];
        const scene_sphere sphere = {.body = b,
                                     .x = thread ? b->thread.thread->now.x[i] : c->now[i % 2],
                                     .displacement = *displacement,
                                     .radius =
                                         thread ? b->thread.thread->config.radius : c->radius};
        if (!vbss_scene_add_plane_contact(s, &key, &sphere, plane)) {
            return false;
        }
    }
    return true;
}

/* Contacts of all bodies with a plane (NULL: the floor). */
static bool add_plane_contacts(scene_object *s, const scene_body *plane)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->kind != SCENE_BODY_NONE && vbss_scene_do_collide(s, b, plane) &&
            !add_plane_contacts_of(s, b, plane)) {
            return false;
        }
    }
    return true;
}

static bool add_contacts_of_all_planes(scene_object *s)
{
    bool has_room = s->config.floor == 0 || add_plane_contacts(s, NULL);
    for (uint32_t i = 0; has_room && i < s->body_count; i++) {
        has_room = !scene_is_plane(&s->bodies[i]) || add_plane_contacts(s, &s->bodies[i]);
    }
    return has_room;
}

/* ---- all constraints */

static void flag_contact_of(scene_body *b)
{
    if (b != NULL && b->kind == SCENE_BODY_THREAD) {
        b->thread.has_contacts = true;
    }
}

/* While the list of contacts is incomplete, each thread counts as in contact. What an earlier attempt
 * has left would differ in a restored scene. */
static void begin_contact_flags(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        flag_contact_of(&s->bodies[i]);
        if (s->bodies[i].kind == SCENE_BODY_THREAD) {
            s->bodies[i].thread.is_welded = false;
        }
    }
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        if (s->pins[i].id != 0 && s->pins[i].attachment == 0) {
            vbss_scene_body(s, s->pins[i].thread)->thread.is_welded = true;
        }
    }
}

static void set_contact_flags(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (s->bodies[i].kind == SCENE_BODY_THREAD) {
            s->bodies[i].thread.has_contacts = false;
        }
    }
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        const contact_key *key = &s->contacts->constraints[i].key;
        flag_contact_of(vbss_scene_body(s, key->body_a));
        flag_contact_of(vbss_scene_body(s, key->body_b));
    }
}

bool vbss_scene_create_contacts(scene_object *s, const scene_substep *substep)
{
    contact_set *set = s->contacts;
    begin_contact_flags(s);
    vbss_scene_set_capsule_trials(s, substep);
    vbss_scene_set_motion_bounds(s, substep);
    if (vbss_scene_find_candidates(s) != VBSS_OK) {
        return false;
    }
    vbss_contact_clear(set);
    s->step.has_unlisted_pairs = false;
    for (uint32_t i = 0; i < s->collision->candidate_count; i++) {
        if (!add_pair_contacts(s, &s->collision->candidates[i])) {
            return false;
        }
    }
    if (!add_contacts_of_all_planes(s) || !vbss_scene_add_thread_grasp_constraints(s) ||
        !vbss_scene_add_needle_grasp_constraints(s) || !vbss_scene_add_wall_grasp_constraints(s) ||
        !vbss_scene_add_hole_constraints(s)) {
        return false;
    }
    vbss_contact_sort(set);
    vbss_scene_remove_duplicate_contacts(s);
    /* Not with a budget, because a search that it stops leaves inexact forces, which would move with their points. Not
     * in halved substeps, where pieces of cut threads stayed without an active set. */
    if (!vbss_scene_limits_steps(s) && substep->h == substep->step_length) {
        vbss_scene_predict_slides(s);
    }
    set_contact_flags(s);
    return true;
}
