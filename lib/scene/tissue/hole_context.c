/* The suture that passes through a hole, and the arc length of the hole along it. */
#include "scene/tissue/tissue.h"
#include "scene/world/world.h"

/* Whether a pin is the weld of a thread's first node to the end of a needle. */
static bool is_swage(const scene_object *s, const scene_pin *p)
{
    if (p->id == 0 || p->attachment != 0 || p->node != 0) {
        return false;
    }
    const scene_rigid *r = &vbss_scene_body(s, p->body)->rigid;
    if (r->needle == NULL || !suture_is_curve(vbss_scene_body(s, p->thread)->thread.thread)) {
        return false;
    }
    return vec3_distance(pose_apply(r->frame, p->point), r->needle->swage) <=
           r->needle->config.wire_radius;
}

const scene_body *vbss_scene_swaged_thread(const scene_object *s, const scene_body *needle)
{
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        if (s->pins[i].body == needle->number && is_swage(s, &s->pins[i])) {
            return vbss_scene_body(s, s->pins[i].thread);
        }
    }
    return NULL;
}

const scene_body *vbss_scene_swaged_needle(const scene_object *s, const scene_body *thread)
{
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        if (s->pins[i].thread == thread->number && is_swage(s, &s->pins[i])) {
            return vbss_scene_body(s, s->pins[i].body);
        }
    }
    return NULL;
}

bool vbss_scene_is_hole_active(const scene_object *s, const suture_hole *hole)
{
    if (hole->id == 0) {
        return false;
    }
    const uint32_t suture = hole->needle != 0 ? hole->needle : hole->thread;
    return !vbss_scene_body(s, hole->wall)->is_frozen && !vbss_scene_body(s, suture)->is_frozen;
}

scene_hole_context vbss_scene_get_hole_context(const scene_object *s, const suture_hole *hole)
{
    const scene_body *wall = vbss_scene_body(s, hole->wall);
    scene_hole_context p = {.wall_body = wall, .wall = vbss_scene_wall_of(wall), .arc = hole->arc};
    if (hole->needle != 0) {
        p.needle = vbss_scene_body(s, hole->needle);
        p.thread = vbss_scene_swaged_thread(s, p.needle);
    } else {
        p.thread = vbss_scene_body(s, hole->thread);
        p.needle = vbss_scene_swaged_needle(s, p.thread);
    }
    if (p.needle != NULL) {
        const scene_rigid *r = &p.needle->rigid;
        p.now.needle = r->needle;
        p.now.needle_pose = vbss_scene_needle_frame(r, r->body.now.pose);
        p.now.swage_arc = vbss_needle_length(r->needle);
        p.trial.needle_pose = vbss_scene_needle_frame(r, r->trial);
    }
    if (p.thread != NULL) {
        p.now.thread = p.thread->thread.thread;
        p.now.node_positions = p.now.thread->now.x;
        p.trial.node_positions = p.now.thread->trial;
    }
    p.trial.needle = p.now.needle;
    p.trial.thread = p.now.thread;
    p.trial.swage_arc = p.now.swage_arc;
    p.arc += hole->thread != 0 ? p.now.swage_arc : 0.0;
    return p;
}

suture_curve_point vbss_scene_hole_curve_point(const scene_hole_context *p, const suture_hole *hole)
{
    return vbss_suture_nearest_point(&p->now, p->arc, vbss_hole_point(hole, &p->wall, p->wall.now));
}

void vbss_scene_commit_holes(scene_object *s)
{
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        const contact_constraint *constraint = &s->contacts->constraints[i];
        if (constraint->key.kind == VBSS_SCENE_CONTACT_HOLE) {
            suture_hole *hole = &s->holes[constraint->key.feature_a];
            vbss_hole_store_forces(hole, constraint);
            if (constraint->tear_force > 0.0) {
                vbss_scene_tear_hole(s, hole, constraint);
            }
        }
    }
}

void vbss_scene_move_hole_to(suture_hole *hole, const scene_hole_context *p, double arc)
{
    double swage = p->now.swage_arc +
                   (hole->thread != 0 ? -SCENE_HOLE_EXIT_DISTANCE : SCENE_HOLE_EXIT_DISTANCE);
    if (p->thread != NULL && (p->needle == NULL || arc > swage)) {
        hole->needle = 0;
        hole->thread = p->thread->number;
        hole->arc = arc - p->now.swage_arc;
    } else if (p->needle != NULL) {
        hole->needle = p->needle->number;
        hole->thread = 0;
        vbss_hole_set_arc(hole, arc);
    }
}

void vbss_scene_advance_holes(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        if (vbss_scene_is_hole_active(s, &s->holes[i])) {
            const scene_hole_context p = vbss_scene_get_hole_context(s, &s->holes[i]);
            vbss_scene_move_hole_to(&s->holes[i], &p,
                                    vbss_scene_hole_curve_point(&p, &s->holes[i]).arc);
        }
    }
}

void vbss_scene_find_trial_slides(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        suture_hole *hole = &s->holes[i];
        if (hole->id != 0) {
            const scene_hole_context p = vbss_scene_get_hole_context(s, hole);
            const vec3 point = vbss_hole_point(hole, &p.wall, p.wall.trial);
            hole->trial_slide = vbss_suture_nearest_point(&p.trial, p.arc, point).arc - p.arc;
        }
    }
}
