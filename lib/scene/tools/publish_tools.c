/* Publishes the states of graspers and needles to the handles that hosts read. */
#include "scene/tools/tools.h"

void vbss_scene_publish_grasper(scene_object *s, scene_body *b)
{
    const scene_rigid *r = &b->rigid;
    grasper_object *g = r->grasper;
    pose tool = pose_mul(r->body.now.pose, pose_inverse(r->frame));
    /* from the centre of mass to the tip */
    vec3 arm = vec3_sub(tool.position, r->body.now.pose.position);
    bool driven = r->kind == VBSS_SCENE_RIGID_DRIVEN;
    vec3 torque = driven ? vec3_zero() : vec3_neg(r->coupling_wrench.torque);
    g->body_id = b->number;
    g->tool_pose = tool;
    g->velocity = vec3_add(r->body.now.v, vec3_cross(r->body.now.w, arm));
    g->angular_velocity = r->body.now.w;
    /* The baseline method sets its own hand force. */
    g->hand_force = driven ? vec3_zero() : vec3_neg(r->coupling_wrench.force);
    g->hand_torque =
        driven ? torque : vec3_sub(torque, vec3_cross(arm, g->hand_force)); /* about the tip */
    g->grasp_count = vbss_scene_count_grasps(s, b->number);
    g->needle = vbss_scene_has_needle_grasp(s, b->number) ? r->needle_grasp.needle : 0;
    bool squeezed = g->solenoid != 0 || g->opening <= g->config.solenoid_opening;
    g->solenoid = g->needle != 0 && squeezed;
    g->drain = vbss_scene_has_wall_grasp(s, b->number) ? r->wall_grasp.drain : 0;
    g->generation++;
    vbss_grasper_update_view(g);
}

void vbss_scene_publish_tools(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_RIGID && b->rigid.grasper != NULL) {
            vbss_scene_publish_grasper(s, b);
        } else if (b->kind == SCENE_BODY_RIGID && b->rigid.needle != NULL) {
            vbss_scene_publish_needle(b);
        }
    }
}

void vbss_scene_publish_needle(const scene_body *b)
{
    vbss_needle_set_motion(b->rigid.needle, &b->rigid.body.now, b->number);
}
