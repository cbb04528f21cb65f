/* Warm start: contacts begin with status and forces of the last substep, also after they slid to an
 * adjacent feature. Adjacent are neighbouring nodes or segments of a thread, and edges or triangles
 * of a drain that share a node. */
#include "scene/contacts/contacts.h"
#include "scene/tuning.h"
#include "scene/world/world.h"

static bool have_common_node(const scene_object *s, const scene_body *b, const contact_key *x,
                             const contact_key *y, bool is_b)
{
    uint32_t p[3], q[3];
    uint32_t count = vbss_scene_surface_feature_nodes(s, b, x->kind, is_b,
                                                      is_b ? x->feature_b : x->feature_a, p);
    uint32_t others = vbss_scene_surface_feature_nodes(s, b, y->kind, is_b,
                                                       is_b ? y->feature_b : y->feature_a, q);
    bool shared = false;
    for (uint32_t i = 0; i < count; i++) {
        for (uint32_t k = 0; k < others; k++) {
            shared = shared || p[i] == q[k];
        }
    }
    return shared;
}

/* Whether the features a of two keys are adjacent or equal. */
static bool are_adjacent(const scene_object *s, const scene_body *a, const contact_key *x,
                         const contact_key *y)
{
    if (scene_has_triangles(a)) {
        return have_common_node(s, a, x, y, false);
    }
    if (a->kind == SCENE_BODY_THREAD) {
        return x->feature_a + 1 >= y->feature_a && y->feature_a + 1 >= x->feature_a;
    }
    uint32_t one = x->kind == VBSS_SCENE_CONTACT_POINT_FACE ? x->feature_a / 2 : x->feature_a;
    return one == (y->kind == VBSS_SCENE_CONTACT_POINT_FACE ? y->feature_a / 2 : y->feature_a);
}

/* Index of the nearest adjacent contact that has no warm start yet, or UINT32_MAX. */
static uint32_t find_adjacent_contact(const scene_object *s, const contact_key *key)
{
    const contact_set *set = s->contacts;
    double min_gap = (double)INFINITY;
    const scene_body *a = vbss_scene_body(s, key->body_a), *b = vbss_scene_body(s, key->body_b);
    uint32_t best = UINT32_MAX;
    for (uint32_t i = 0; a != NULL && b != NULL && i < set->count; i++) {
        const contact_constraint *constraint = &set->constraints[i];
        if (scene_is_surface_contact(constraint->key.kind) &&
            constraint->solution.status == CONTACT_OPEN && constraint->key.body_a == key->body_a &&
            constraint->key.body_b == key->body_b &&
            scene_geometry_of(s, constraint)->start_gap < min_gap &&
            are_adjacent(s, a, key, &constraint->key) &&
            have_common_node(s, b, key, &constraint->key, true)) {
            best = i;
            min_gap = scene_geometry_of(s, constraint)->start_gap;
        }
    }
    return best;
}

/* Whether the contact is one of jaws with the wall that they grasp, or have released but still
 * overlap. Beside the grasped strip, where contact is excluded, such a contact may begin deep. */
static bool is_of_wall_in_jaws(const scene_object *s, const contact_key *key)
{
    const scene_body *a = vbss_scene_body(s, key->body_a);
    return a != NULL && a->kind == SCENE_BODY_RIGID && a->rigid.wall_grasp.drain != 0 &&
           a->rigid.wall_grasp.drain == key->body_b;
}

/* Smallest overlap of a wall without a force that is left to later substeps, m; INFINITY for none. A
 * fold has no inside: as its sides turn, other pairs are nearest, and those may begin far deeper than
 * their force explains. In real time substeps leave small overlaps that no force explains; if these
 * were left, they would grow. */
static double min_deferred_overlap(const scene_object *s, const contact_constraint *constraint)
{
    const contact_key *key = &constraint->key;
    if (key->body_a == key->body_b) {
        return s->config.mode == VBSS_SCENE_MODE_OFFLINE
                   ? 0.0
                   : SCENE_DEEP_FOLD_RATIO * constraint->thickness;
    }
    return is_of_wall_in_jaws(s, key) ? 0.0 : (double)INFINITY;
}

/* Overlap at the start of a substep that is left to later ones, m. The substep bears what the contact
 * force explains, or removes as much as a bounded speed does. An overlap within the tolerance is no
 * fault and goes at once, as do those of threads, which leave bad states by forces of their own. */
static double deferred_overlap(const scene_object *s, const contact_constraint *constraint,
                               double h)
{
    const scene_contact_geometry *geometry = scene_geometry_of(s, constraint);
    double overlap = -geometry->start_gap;
    double explained = constraint->solution.status == CONTACT_OPEN
                           ? 0.0
                           : constraint->solution.normal_force / constraint->stiffness;
    if (scene_is_surface_contact(constraint->key.kind)) {
        double opening = SCENE_FOLD_OPENING_RATE * constraint->thickness * h;
        double excess = overlap - vbss_max(explained, opening);
        return excess > min_deferred_overlap(s, constraint) ? excess : 0.0;
    }
    bool is_rigid = constraint->key.kind == VBSS_SCENE_CONTACT_CAPSULES ||
                    constraint->key.kind == VBSS_SCENE_CONTACT_CAPSULE_FLOOR;
    double removable = SCENE_RECOVERY_RATE * geometry->contact_distance * h;
    bool is_fault = is_rigid && overlap > s->solver.penetration_tolerance * constraint->thickness &&
                    overlap > explained + removable;
    return is_fault ? overlap - vbss_max(explained, removable) : 0.0;
}

/* Rigid bodies that the host has placed in each other would fly apart if one substep removed all of their
 * overlap; so would a wall. */
static void bound_recovery_speed(scene_object *s, double h)
{
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        contact_constraint *constraint = &s->contacts->constraints[i];
        scene_contact_geometry *geometry = scene_geometry_of(s, constraint);
        if (constraint->is_bilateral || geometry->start_gap >= 0.0) {
            continue;
        }
        double deferred = deferred_overlap(s, constraint, h);
        if (deferred > 0.0) {
            constraint->recovery_allowance = deferred;
            geometry->overlap_allowance += deferred;
            geometry->start_gap += deferred;
            constraint->gap += deferred;
        }
    }
}

void vbss_scene_warm_start_contacts(scene_object *s, const scene_substep *substep)
{
    contact_set *set = s->contacts;
    vbss_contact_warm_start(set);
    for (uint32_t m = 0; m < set->warm_start_count; m++) {
        const contact_key *key = &set->warm_start[m].key;
        if (set->warm_start[m].has_constraint) {
            continue;
        }
        if (!scene_is_surface_contact(key->kind)) {
            vbss_contact_warm_start_neighbour(set, m);
            continue;
        }
        uint32_t adjacent = find_adjacent_contact(s, key);
        if (adjacent != UINT32_MAX) {
            vbss_contact_warm_start_one(set, m, adjacent);
        }
    }
    bound_recovery_speed(s, substep->h);
}
