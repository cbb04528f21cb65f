/* Punctures: needles whose tips enter walls. */
#include "scene/tissue/tissue.h"
#include "scene/world/world.h"

/* Arc length of a contact on a needle, from its tip, m. */
static double contact_arc(const scene_object *s, const scene_body *needle,
                          const contact_constraint *constraint)
{
    bool point = constraint->key.kind == VBSS_SCENE_CONTACT_POINT_FACE;
    return point ? vbss_scene_suture_arc_length(needle, constraint->key.feature_a / 2,
                                                constraint->key.feature_a % 2)
                 : vbss_scene_suture_arc_length(needle, constraint->key.feature_a,
                                                scene_geometry_of(s, constraint)->barycentric[0]);
}

/* Finds the load of a wall on the tip of a needle. Returns false if they are not in contact. */
static bool find_tip_load(const scene_object *s, const scene_body *needle,
                          const scene_body *wall_body, suture_tip *tip)
{
    const scene_rigid *r = &needle->rigid;
    pose at = vbss_scene_needle_frame(r, r->body.now.pose);
    vec3 normal = vec3_zero();
    *tip = (suture_tip){.position = pose_apply(at, vbss_needle_point(r->needle, 0.0)),
                        .direction =
                            quat_rotate(at.orientation, vbss_needle_direction(r->needle, 0.0))};
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        const contact_constraint *constraint = &s->contacts->constraints[i];
        if (constraint->key.body_a == needle->number &&
            constraint->key.body_b == wall_body->number &&
            constraint->key.kind != VBSS_SCENE_CONTACT_HOLE &&
            constraint->solution.status != CONTACT_OPEN &&
            vbss_scene_is_at_tip(needle, contact_arc(s, needle, constraint))) {
            normal = vec3_add_scaled(normal, constraint->solution.normal_force, constraint->normal);
            tip->force = vec3_add(tip->force, constraint->solution.tangential_force);
        }
    }
    tip->force = vec3_add(tip->force, normal);
    tip->normal = vec3_unit_or(normal, vec3_zero());
    return vec3_norm_squared(normal) > 0.0;
}

/* Whether the needle's tip is entering the wall already. It then makes no second hole, because
 * the force on it comes from the wall around the first. */
static bool is_entering(const scene_object *s, const scene_body *needle,
                        const scene_body *wall_body)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        const suture_hole *hole = &s->holes[i];
        if (hole->id != 0 && hole->needle == needle->number && hole->wall == wall_body->number &&
            hole->arc < 0.0) {
            return true;
        }
    }
    return false;
}

static void puncture_wall(scene_object *s, const scene_body *needle, const scene_body *wall_body)
{
    suture_tip tip;
    suture_hole made;
    const suture_wall wall = vbss_scene_wall_of(wall_body);
    double wire = needle->rigid.needle->config.wire_radius;
    /* Distance along the tip to a flat wall in contact with it, at the most oblique angle of
     * entry. A hole farther ahead would not be in the wall that the tip presses on. */
    double reach = (wire + 0.5 * wall.law->thickness) / SUTURE_MIN_ENTRY_COSINE;
    if (is_entering(s, needle, wall_body) || !find_tip_load(s, needle, wall_body, &tip) ||
        !vbss_suture_tip_punctures(wall.law, &tip) ||
        !vbss_suture_make_hole(&wall, &tip, reach, wire, &made)) {
        return;
    }
    made.needle = needle->number;
    made.wall = wall_body->number;
    vbss_scene_add_hole(s, &made, -vec3_dot(tip.force, tip.direction));
}

void vbss_scene_update_holes(scene_object *s)
{
    vbss_scene_update_tears(s);
    vbss_scene_close_exited_holes(s, true);
    vbss_scene_find_fold_punctures(s);
    /* Forces of a rejected attempt, or of an active-set search that was stopped early, are not
     * the load on the wall. */
    bool forces_known = s->step.has_accepted_contacts && !s->contacts->is_stopped_early;
    for (uint32_t i = 0; forces_known && i < s->body_count; i++) {
        const scene_body *needle = &s->bodies[i];
        for (uint32_t k = 0; scene_active_kind(needle) == SCENE_BODY_RIGID &&
                             needle->rigid.needle != NULL && k < s->body_count;
             k++) {
            if (scene_is_active(&s->bodies[k]) && scene_is_pierceable(&s->bodies[k])) {
                puncture_wall(s, needle, &s->bodies[k]);
            }
        }
    }
}
