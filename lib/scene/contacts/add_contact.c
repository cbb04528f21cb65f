/* Adds a contact constraint if two features may touch in the substep. */
#include "scene/contacts/contacts.h"
#include "scene/tuning.h"
#include "scene/world/world.h"

#include <string.h>

/* Whether some vertex of a feature of a host surface does. */
static bool has_compliant_vertex(const scene_object *s, const scene_body *b, uint32_t kind,
                                 bool is_b, uint32_t feature)
{
    uint32_t nodes[3];
    const uint32_t count = vbss_scene_surface_feature_nodes(s, b, kind, is_b, feature, nodes);
    bool is_any_compliant = false;
    for (uint32_t k = 0; k < count; k++) {
        is_any_compliant = is_any_compliant || scene_has_compliance(b->rigid.surface, nodes[k]);
    }
    return is_any_compliant;
}

static bool is_feature_prescribed(const scene_object *s, const scene_body *b, uint32_t kind,
                                  bool is_b, uint32_t feature)
{
    if (b != NULL && !b->is_frozen && scene_is_compliant(scene_host_surface_of(b))) {
        return !has_compliant_vertex(s, b, kind, is_b, feature);
    }
    if (b == NULL || b->is_frozen || b->kind == SCENE_BODY_RIGID) {
        return scene_is_prescribed(b);
    }
    if (b->kind == SCENE_BODY_DRAIN) {
        uint32_t nodes[3],
            count = vbss_scene_surface_feature_nodes(s, b, kind, is_b, feature, nodes);
        bool prescribed = true;
        for (uint32_t k = 0; k < count; k++) {
            prescribed = prescribed && b->drain.drain->anchored[nodes[k]] != 0;
        }
        return prescribed;
    }
    const thread_object *t = b->thread.thread;
    bool is_point = kind == VBSS_SCENE_CONTACT_NODE_FLOOR || kind == VBSS_SCENE_CONTACT_POINT_FACE,
         smooth = kind == VBSS_SCENE_CONTACT_NODE_CAPSULE;
    uint32_t first = smooth && feature > 0 ? feature - 1 : feature;
    uint32_t end = feature + (is_point ? 1u : 2u);
    for (uint32_t k = first; k < end && k < t->node_count; k++) {
        if (t->prescribed_by[k] == 0) {
            return false;
        }
    }
    return true;
}

/* Bounds the relative motion of any two points of the features. The maximum over pairs of vertices
 * is enough, as points are averages of vertices. */
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

/* Bounds how far the features approach each other along the normal. */
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

/* Whether a drain's feature is a lip. The line through a lip swings farther than its middle moves,
 * so motions of vertices do not bound its approach along the normal. */
static bool is_lip(const scene_body *b, const contact_key *key, bool is_b)
{
    const uint32_t feature = is_b ? key->feature_b : key->feature_a;
    return key->kind == VBSS_SCENE_CONTACT_SIDES
               ? b->drain.lip_of_side[feature] != SCENE_NO_FACE
               : !is_b && b->drain.lip_of_node[feature] != SCENE_NO_FACE;
}

static bool has_swinging_lip(const scene_contact_pair *m, const contact_key *key)
{
    return m->a->kind == SCENE_BODY_DRAIN && m->b != NULL && m->b->kind == SCENE_BODY_DRAIN &&
           (is_lip(m->a, key, false) || is_lip(m->b, key, true));
}

/* Runs the narrow phase; returns whether the features may touch in the substep. */
static bool compute_geometry(const scene_object *s, contact_constraint *constraint,
                             const scene_contact_pair *m)
{
    uint32_t kind = constraint->key.kind;
    double margin = s->solver.contact_margin, reach = largest_relative_motion(m);
    bool near = vbss_scene_run_narrow_phase(s, constraint, m->a, m->b, reach + margin);
    bool is_directional =
        kind == VBSS_SCENE_CONTACT_SEGMENTS ||
        (scene_is_surface_contact(kind) && !has_swinging_lip(m, &constraint->key));
    if (near && is_directional) {
        near = scene_geometry_of(s, constraint)->start_gap <
               largest_approach(m, constraint->normal) + SCENE_LATERAL_RATIO * reach + margin;
    }
    return near;
}

/* A needle is nearest to an edge inside its hole, where it does not touch. Its axis before
 * and behind the hole may still touch that edge. A pair has one constraint: that of the
 * nearest interval. */
static bool compute_geometry_beside_holes(const scene_object *s, contact_constraint *constraint,
                                          const scene_contact_pair *m)
{
    scene_contact_geometry *geometry = scene_geometry_of(s, constraint);
    const double reach = SCENE_EXCLUSION_ARC_RATIO * geometry->contact_distance;
    scene_axis_interval interval = {.started = false}, nearest = interval;
    double min_gap = (double)INFINITY;
    while (vbss_scene_next_axis_interval(s, m->a, constraint->key.feature_a, m->b,
                                         constraint->key.feature_b, reach, &interval)) {
        memcpy(geometry->axis_interval, interval.bounds, sizeof interval.bounds);
        if (compute_geometry(s, constraint, m) && geometry->start_gap < min_gap) {
            min_gap = geometry->start_gap;
            nearest = interval;
        }
    }
    if (!nearest.started) {
        return false;
    }
    memcpy(geometry->axis_interval, nearest.bounds, sizeof nearest.bounds);
    return compute_geometry(s, constraint, m);
}

static bool is_needle_at_drain(const contact_constraint *constraint, const scene_contact_pair *m)
{
    return constraint->key.kind == VBSS_SCENE_CONTACT_SIDES && m->a->kind == SCENE_BODY_RIGID &&
           m->a->rigid.needle != NULL;
}

bool vbss_scene_add_contact(scene_object *s, const contact_key *key, const scene_contact_pair *m)
{
    if (is_feature_prescribed(s, m->a, key->kind, false, key->feature_a) &&
        is_feature_prescribed(s, m->b, key->kind, true, key->feature_b)) {
        /* CCD tests features at rest and overlaps that the host made not at all, planes by themselves. */
        s->step.has_unlisted_pairs =
            s->step.has_unlisted_pairs ||
            (m->b != NULL && !scene_is_plane(m->b) && largest_relative_motion(m) > 0.0 &&
             !vbss_scene_is_overlap(s, m->a, m->b) &&
             (m->candidate == NULL ||
              !scene_stays_apart(s, m->candidate, s->solver.contact_margin)));
        return true;
    }
    /* A pair that is not near needs no room, whether the separation cache knows that or not. */
    contact_constraint *constraint = vbss_contact_try(s->contacts, key);
    scene_contact_geometry *geometry = scene_geometry_of(s, constraint);
    geometry->axis_interval[0][0] = geometry->axis_interval[1][0] = 0.0;
    geometry->axis_interval[0][1] = geometry->axis_interval[1][1] = 1.0;
    geometry->segments[0] = key->feature_a;
    geometry->segments[1] = key->feature_b;
    bool near = compute_geometry(s, constraint, m);
    /* The line through a lip is never farther than its middle, so this is a lower bound of
     * the separation. */
    if (m->candidate != NULL) {
        vbss_collision_store_separation(s->collision, m->candidate,
                                        geometry->start_gap + geometry->contact_distance);
    }
    double scale = near && scene_is_surface_contact(key->kind)
                       ? vbss_scene_contact_scale_of(s, constraint)
                       : 1.0;
    if (scale == 0.0 && is_needle_at_drain(constraint, m)) {
        scale = compute_geometry_beside_holes(s, constraint, m) ? 1.0 : 0.0;
    }
    geometry->overlap_allowance = (1.0 - scale) * geometry->contact_distance;
    geometry->start_gap += geometry->overlap_allowance;
    const bool is_needed = near && scale != 0.0;
    const bool has_room = s->contacts->count <= s->contacts->capacity;
    if (!is_needed || !has_room) {
        s->contacts->count--;
    }
    return !is_needed || has_room;
}

bool vbss_scene_add_plane_contact(scene_object *s, const contact_key *key,
                                  const scene_sphere *sphere, const scene_body *plane)
{
    static const vec3 plane_displacement;
    const scene_plane p = scene_plane_of(s, plane);
    /* Only a downward motion can reach the plane. */
    double down = vbss_min(vec3_dot(sphere->displacement, p.normal), 0.0);
    double gap = scene_height_over(p, sphere->x) - sphere->radius;
    if (gap - s->solver.contact_margin >
        -SCENE_FLOOR_REACH_RATIO * SCENE_EXTRAPOLATION_RATIO * down) {
        return true;
    }
    vec3 downward = vec3_scale(p.normal, down);
    const scene_contact_pair m = {sphere->body, plane, &downward, &plane_displacement, 1, 1, NULL};
    return vbss_scene_add_contact(s, key, &m);
}
