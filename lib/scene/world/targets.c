/* Target poses of rigid bodies. While a step is suspended, new targets stay pending until the
 * next step. */
#include "scene/world/method.h"
#include "scene/world/world.h"

void vbss_scene_apply_rigid_targets(scene_object *s)
{
    bool any = false;
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_rigid *r = &s->bodies[i].rigid;
        if (s->bodies[i].kind == SCENE_BODY_RIGID && r->has_pending_target) {
            r->body.target_end = r->pending_target;
            r->has_pending_target = false;
            any = true;
        }
    }
    if (any) {
        vbss_scene_set_pin_targets(s);
    }
}

void vbss_scene_apply_loads(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (s->bodies[i].kind == SCENE_BODY_RIGID) {
            scene_rigid *r = &s->bodies[i].rigid;
            r->body.load = r->pending_load;
            r->pending_load = (vbss_rigid_wrench){0};
        }
    }
}

/* Largest distance of a capsule or mesh from the origin of the principal frame, m. */
static double reach_of(const scene_object *s, const scene_rigid *r)
{
    double reach = r->is_rigid_mesh ? r->mesh.reach : 0.0;
    for (uint32_t i = 0; i < r->capsule_count; i++) {
        const scene_capsule *c = &s->capsules[r->first_capsule + i];
        for (int k = 0; k < 2; k++) {
            reach = vbss_max(reach, vec3_norm(c->local_end[k]) + c->radius);
        }
    }
    return reach;
}

bool vbss_scene_limit_target(const scene_object *s, scene_rigid *r, double h)
{
    const vbss_rigid_substep whole = {.step_length = 1.0, .end_fraction = 1.0};
    const double allowed = s->settings.speed_limit * h;
    if (s->settings.speed_limit == 0.0 || s->method->drives_tools) {
        return false;
    }
    const vbss_rigid_motion wanted = vbss_rigid_target_motion(&r->body, &whole);
    const double asked = vec3_norm(wanted.v) + reach_of(s, r) * vec3_norm(wanted.w);
    if (!(asked > allowed)) {
        return false;
    }
    const vbss_rigid_substep part = {.step_length = 1.0, .end_fraction = allowed / asked};
    r->body.target_end = vbss_rigid_target_motion(&r->body, &part).pose;
    return true;
}

void vbss_scene_limit_rigid_targets(scene_object *s, double h)
{
    bool any = false;
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_rigid *r = &s->bodies[i].rigid;
        if (s->bodies[i].kind != SCENE_BODY_RIGID || r->kind == VBSS_SCENE_RIGID_FREE ||
            r->grasper != NULL || scene_is_static_mesh(&s->bodies[i]) ||
            scene_is_plane(&s->bodies[i])) {
            continue;
        }
        const pose wanted = r->body.target_end;
        if (vbss_scene_limit_target(s, r, h)) {
            r->pending_target = wanted;
            r->has_pending_target = any = true;
        }
    }
    if (any) {
        vbss_scene_set_pin_targets(s);
    }
}

void vbss_scene_set_tool_target(scene_object *s, scene_rigid *r, pose target)
{
    r->pending_target = target;
    r->has_pending_target = true;
    if (!s->cursor.is_suspended) {
        /* now, so that a failed step leaves no pending target to undo */
        vbss_scene_apply_rigid_targets(s);
    }
}
