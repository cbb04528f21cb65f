/* Target poses of rigid bodies. While a step is suspended, new targets stay pending until the
 * next step. */
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

void vbss_scene_set_rigid_target(scene_object *s, scene_rigid *r, pose target)
{
    r->pending_target = target;
    r->has_pending_target = true;
    if (!s->cursor.is_suspended) {
        /* now, so that a failed step leaves no pending target to undo */
        vbss_scene_apply_rigid_targets(s);
    }
}
