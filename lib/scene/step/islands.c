/* Islands: sets of bodies that may act on each other in the present substep.
 *
 * Contacts, candidates that are not known to stay apart, grasps, holes and pins connect bodies.
 * Resting tools and static bodies connect nothing, as nothing moves them. A moving tool connects
 * all that it may touch, because it is held back together with what holds it back. */
#include "scene/contacts/contacts.h"
#include "scene/step/groups.h"
#include "scene/tissue/tissue.h"
#include "scene/world/world.h"

#define NO_ISLAND UINT32_MAX

/* ---- union-find over indices of bodies */

static uint32_t find_root(const scene_object *s, uint32_t index)
{
    while (s->bodies[index].island != index) {
        scene_body *b = &s->bodies[index];
        b->island = s->bodies[b->island].island; /* halves the path */
        index = b->island;
    }
    return index;
}

static void connect(scene_object *s, const scene_body *a, const scene_body *b)
{
    if (a == NULL || b == NULL || a->island == NO_ISLAND || b->island == NO_ISLAND) {
        return;
    }
    uint32_t x = find_root(s, a->island), y = find_root(s, b->island);
    s->bodies[x > y ? x : y].island = x > y ? y : x;
}

static void connect_numbers(scene_object *s, uint32_t a, uint32_t b)
{
    connect(s, vbss_scene_body(s, a), vbss_scene_body(s, b));
}

/* ---- connections */

static bool is_pose_equal(const pose *a, const pose *b)
{
    return vec3_distance(a->position, b->position) == 0.0 && a->orientation.w == b->orientation.w &&
           a->orientation.x == b->orientation.x && a->orientation.y == b->orientation.y &&
           a->orientation.z == b->orientation.z;
}

static bool is_at_rest(const scene_object *s, const scene_rigid *r)
{
    if (r->kind != VBSS_SCENE_RIGID_DRIVEN ||
        !is_pose_equal(&r->body.target_start, &r->body.target_end) ||
        (r->surface != NULL && r->surface->is_moving) || scene_is_compliant(r->surface)) {
        return false;
    }
    for (uint32_t i = r->first_capsule; i < r->first_capsule + r->capsule_count; i++) {
        const scene_capsule *c = &s->capsules[i];
        if (vec3_distance(c->local[0], c->local_end[0]) != 0.0 ||
            vec3_distance(c->local[1], c->local_end[1]) != 0.0) {
            return false;
        }
    }
    return true;
}

bool vbss_scene_is_mobile(const scene_object *s, const scene_body *b)
{
    scene_body_kind kind = scene_active_kind(b);
    return kind != SCENE_BODY_NONE && !(kind == SCENE_BODY_RIGID && is_at_rest(s, &b->rigid));
}

static void connect_pairs(scene_object *s)
{
    const collision_object *c = s->collision;
    for (uint32_t i = 0; i < c->candidate_count; i++) {
        const collision_candidate *q = &c->candidates[i];
        if (!scene_stays_apart(s, q, s->solver.contact_margin)) {
            connect(s, &s->bodies[s->body_of_shape[q->shape_a]],
                    &s->bodies[s->body_of_shape[q->shape_b]]);
        }
    }
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        const contact_key *key = &s->contacts->constraints[i].key;
        connect_numbers(s, key->body_a, key->body_b);
    }
}

static void connect_grasps_and_holes(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        const scene_thread_grasp *g = &s->thread_grasps[i];
        connect_numbers(s, g->id != 0 ? g->thread : 0, g->tool);
    }
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_RIGID && b->rigid.grasper != NULL) {
            connect_numbers(s, b->number, b->rigid.needle_grasp.needle);
            connect_numbers(s, b->number, b->rigid.wall_grasp.drain);
        }
    }
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        const suture_hole *hole = &s->holes[i];
        connect_numbers(s, hole->id != 0 ? hole->wall : 0,
                        hole->needle != 0 ? hole->needle : hole->thread);
    }
}

void vbss_scene_find_islands(scene_object *s, bool has_all_pairs)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        s->bodies[i].island = vbss_scene_is_mobile(s, &s->bodies[i]) ? i : NO_ISLAND;
    }
    if (has_all_pairs) {
        connect_pairs(s);
    }
    connect_grasps_and_holes(s);
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        const scene_pin *p = &s->pins[i];
        connect_numbers(s, p->id != 0 ? p->thread : 0, p->body);
    }
}

bool vbss_scene_is_in_island(const scene_object *s, const scene_body *b, const scene_body *of)
{
    return of != NULL && b->island != NO_ISLAND && of->island != NO_ISLAND &&
           find_root(s, b->island) == find_root(s, of->island);
}

/* ---- what failed */

/* The thread or drain whose Newton iterations are farthest from convergence. */
static scene_touching_pair find_worst_body(const scene_object *s)
{
    scene_touching_pair worst = {0, 0};
    double largest = 0.0;
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        double error = 0.0;
        if (scene_active_kind(b) == SCENE_BODY_THREAD) {
            error = b->thread.thread->statistics.last_stretch_error / s->solver.stretch_tolerance;
        } else if (scene_active_kind(b) == SCENE_BODY_DRAIN) {
            error = b->drain.max_increment / b->drain.drain->config.move_limit;
        }
        if (error > largest || error != error) {
            worst.body_a = b->number;
            largest = error == error ? error : (double)INFINITY;
        }
    }
    return worst;
}

/* The constraint that penetrates deepest beyond its tolerance. */
static scene_touching_pair find_deepest_contact(const scene_object *s)
{
    const contact_constraint *worst = NULL;
    double largest = 0.0;
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        const contact_constraint *constraint = &s->contacts->constraints[i];
        double excess = -constraint->gap - constraint->allowed_penetration;
        if (!constraint->is_bilateral && excess > largest) {
            worst = constraint;
            largest = excess;
        }
    }
    return worst == NULL ? (scene_touching_pair){0, 0}
                         : (scene_touching_pair){worst->key.body_a, worst->key.body_b};
}

/* The constraint whose force differs most from its law. */
static scene_touching_pair find_worst_contact(const scene_object *s)
{
    const contact_set *set = s->contacts;
    const contact_constraint *worst = NULL;
    double largest = 0.0;
    for (uint32_t i = 0; i < set->count; i++) {
        vec3 law_force = vbss_contact_force(&set->constraints[i], set->current[i].u);
        double violation = vec3_distance(set->current[i].force, law_force);
        if (violation > largest) {
            worst = &set->constraints[i];
            largest = violation;
        }
    }
    return worst == NULL ? (scene_touching_pair){0, 0}
                         : (scene_touching_pair){worst->key.body_a, worst->key.body_b};
}

scene_touching_pair vbss_scene_find_blamed_pair(const scene_object *s,
                                                scene_substep_outcome outcome)
{
    switch (outcome) {
    case SCENE_SUBSTEP_CCD_HIT:
        return s->step.first_impact;
    case SCENE_SUBSTEP_PENETRATION:
        return find_deepest_contact(s);
    case SCENE_SUBSTEP_NO_ACTIVE_SET:
        return find_worst_contact(s);
    case SCENE_SUBSTEP_NOT_CONVERGED:
    case SCENE_SUBSTEP_SINGULAR:
        return find_worst_body(s);
    default:
        return (scene_touching_pair){0, 0};
    }
}
