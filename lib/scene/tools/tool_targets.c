/* Applies the targets of tools before a step: exchange of instruments, pose, jaw angle. */
#include "scene/tools/tools.h"
#include "scene/world/method.h"
#include "scene/world/world.h"

static void exchange_instrument(scene_object *s, scene_body *b)
{
    grasper_object *g = b->rigid.grasper;
    const vbss_grasper_config *c = &g->config;
    if (g->commanded_kind == g->kind) {
        return;
    }
    pose tool = pose_mul(b->rigid.body.now.pose, pose_inverse(b->rigid.frame));
    double far = vec3_distance(tool.position, vec3_load(c->exchange_centre));
    bool allowed = vbss_scene_count_grasps(s, b->number) == 0 && far >= c->exchange_distance;
    vbss_grasper_kind before = g->kind, wanted = g->commanded_kind;
    pose target;
    g->kind = allowed ? wanted : before;
    /* the new jaws may have another bend */
    if (!vbss_grasper_apply_trocar(g, g->commanded_pose, &target)) {
        g->kind = before;
        allowed = false;
    }
    g->commanded_kind = g->kind;
    if (allowed) { /* the grasps of released objects belong to the old jaws */
        vbss_scene_remove_thread_grasps_of(s, b->number);
        vbss_scene_remove_needle_grasps_of(s, b->number);
        vbss_scene_remove_wall_grasps_of(s, b->number);
    }
    vbss_scene_event event = {.kind = allowed ? VBSS_SCENE_EVENT_EXCHANGED
                                              : VBSS_SCENE_EVENT_NOT_EXCHANGED,
                              .body_a = b->number,
                              .id = (uint32_t)wanted};
    vbss_scene_add_event_at(s, &event, tool.position, event.id);
}

void vbss_scene_move_jaws(scene_object *s, scene_body *tool, double h)
{
    vbss_scene_release_thread_grasps(s, tool);
    vbss_scene_release_needle_grasp(s, tool);
    vbss_scene_release_wall_grasp(s, tool);
    tool->rigid.grasper->jaw_angle = vbss_scene_close_jaws(s, tool, h);
}

static void apply_target(scene_object *s, scene_body *b, double h)
{
    scene_rigid *r = &b->rigid;
    grasper_object *g = r->grasper;
    pose target;
    exchange_instrument(s, b);
    if (vbss_grasper_apply_trocar(g, g->commanded_pose,
                                  &target)) { /* cannot fail: checked when the host set it */
        r->body.target_end = pose_mul(target, r->frame);
        (void)vbss_scene_limit_target(s, r, h);
    }
    s->method->move_jaws(s, b, h);
    g->jaw_force = vbss_scene_count_grasps(s, b->number) > 0
                       ? vbss_grasper_jaw_force_at(g, g->jaw_angle)
                       : 0.0;
    vbss_scene_set_capsule_targets(s, r, g->jaw_angle);
}

void vbss_scene_apply_tool_targets(scene_object *s, double h)
{
    s->step.cut_count = 0;
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_RIGID && b->rigid.grasper != NULL) {
            apply_target(s, b, h);
        }
    }
}
