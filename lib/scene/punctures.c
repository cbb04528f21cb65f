/* Tips that enter walls. */
#include "scene/around_holes.h"
#include "scene/holes.h"
#include "scene/tools.h"

/* Where on the needle a row is about. */
static double arc_of_row(const scene_body *needle, const contact_constraint *row)
{
    bool point = row->key.kind == VBSS_CONTACT_POINT_FACE;
    return point ? vbss_scene_arc_of(needle, row->key.feature_a / 2, row->key.feature_a % 2)
                 : vbss_scene_arc_of(needle, row->key.feature_a, row->barycentric[0]);
}

/* What a drain does to the tip of a needle. */
static bool look_at_tip(const scene_object *s, const scene_body *needle, const scene_body *drain,
                        suture_tip *tip)
{
    const scene_rigid *r = &needle->rigid;
    pose at = vbss_scene_needle_at(r, r->body.now.pose);
    vec3 normal = vec3_zero();
    *tip = (suture_tip){.position = pose_apply(at, vbss_needle_point(r->needle, 0.0)),
                        .direction =
                            quat_rotate(at.orientation, vbss_needle_direction(r->needle, 0.0))};
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        const contact_constraint *row = &s->contacts->constraints[i];
        if (row->key.body_a == needle->number && row->key.body_b == drain->number &&
            row->key.kind != VBSS_CONTACT_HOLE && row->solution.status != CONTACT_OPEN &&
            vbss_scene_is_at_tip(needle, arc_of_row(needle, row))) {
            normal = vec3_add_scaled(normal, row->solution.normal_force, row->normal);
            tip->force = vec3_add(tip->force, row->solution.tangential_force);
        }
    }
    tip->force = vec3_add(tip->force, normal);
    tip->normal = vec3_unit_or(normal, vec3_zero());
    return vec3_norm_squared(normal) > 0.0;
}

/* A tip that is on its way into a wall enters no other place of it: what presses on it there is the wall round the hole. */
static bool is_entering(const scene_object *s, const scene_body *needle, const scene_body *drain)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        const suture_hole *hole = &s->holes[i];
        if (hole->id != 0 && hole->needle == needle->number && hole->drain == drain->number &&
            hole->arc < 0.0) {
            return true;
        }
    }
    return false;
}

static void enter(scene_object *s, const scene_body *needle, const scene_body *drain)
{
    suture_tip tip;
    suture_hole made;
    const drain_object *d = drain->drain.drain;
    double wire = needle->rigid.needle->config.wire_radius;
    /* Farther on than a flat wall lies that it may enter, it does not go into that on which it presses. */
    double reach = (wire + 0.5 * d->config.thickness) / SUTURE_MIN_ENTRY_COSINE;
    if (is_entering(s, needle, drain) || !look_at_tip(s, needle, drain, &tip) ||
        !vbss_suture_tip_punctures(&d->config, &tip) ||
        !vbss_suture_make_hole(d, &tip, reach, wire, &made)) {
        return;
    }
    made.needle = needle->number;
    made.drain = drain->number;
    vbss_scene_add_hole(s, &made);
}

void vbss_scene_settle_holes(scene_object *s)
{
    vbss_scene_leave_holes(s);
    vbss_scene_find_folds(s);
    /* What presses where a part was thrown away says nothing of what the wall bears, nor what does where a search was stopped. */
    bool known = s->taken && !s->contacts->is_stopped_early;
    for (uint32_t i = 0; known && i < s->place_count; i++) {
        const scene_body *needle = &s->bodies[i];
        for (uint32_t k = 0;
             needle->kind == BODY_RIGID && needle->rigid.needle != NULL && k < s->place_count;
             k++) {
            if (s->bodies[k].kind == BODY_DRAIN) {
                enter(s, needle, &s->bodies[k]);
            }
        }
    }
}
