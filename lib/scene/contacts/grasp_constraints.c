/* Bilateral constraints that hold threads, needles and walls in the jaws of graspers.
 *
 * Each is a spring from a point of the grasped body to its target in the jaws. Gap and tangential
 * displacement are measured from the target, so the constraint has no memory: only the grasp itself
 * has state. */
#include "scene/contacts/contacts.h"
#include "scene/tools/tools.h"
#include "scene/world/world.h"

static void update_thread_grasp_constraint(scene_object *s, contact_constraint *constraint)
{
    const scene_thread_grasp *g =
        &s->thread_grasps[constraint->key.feature_a / GRASPER_THREAD_POINTS];
    const scene_body *b = vbss_scene_body(s, g->thread);
    const scene_rigid *r = &vbss_scene_body(s, g->tool)->rigid;
    const thread_object *t = b->thread.thread;
    uint32_t point = constraint->key.feature_a % GRASPER_THREAD_POINTS;
    scene_grip_location p = vbss_scene_locate_grip_point(t, g, point);
    vec3 target = pose_apply(vbss_scene_jaw_frame(r, r->trial), g->grip.anchor[point]);
    vec3 current = vec3_lerp(t->trial[p.segment], t->trial[p.segment + 1], p.fraction);
    vbss_scene_set_spring_geometry(s, constraint, r, current, target);
    constraint->stiffness = GRASPER_NORMAL_STIFFNESS_RATIO *
                            (r->grasper->config.grip_stiffness / GRASPER_THREAD_POINTS);
    constraint->tangential_stiffness_ratio = 1.0 / GRASPER_NORMAL_STIFFNESS_RATIO;
    vbss_scene_add_node_jacobian(s, constraint, b, p.segment, 1.0 - p.fraction);
    vbss_scene_add_node_jacobian(s, constraint, b, p.segment + 1, p.fraction);
    vbss_scene_add_rigid_jacobian(constraint, r, target, -1.0);
}

static void update_needle_grasp_constraint(scene_object *s, contact_constraint *constraint)
{
    const scene_rigid *needle = &vbss_scene_body(s, constraint->key.body_a)->rigid;
    const scene_rigid *tool = &vbss_scene_body(s, constraint->key.body_b)->rigid;
    const scene_clamp_corner c = vbss_scene_clamp_corner(needle, needle->trial, tool, tool->trial,
                                                         constraint->key.feature_a);
    vbss_scene_set_spring_geometry(s, constraint, tool, c.needle_point, c.jaw_point);
    constraint->stiffness = vbss_grasper_needle_clamp_stiffness(tool->grasper);
    constraint->tangential_stiffness_ratio = 0.0; /* isotropic */
    vbss_scene_add_rigid_jacobian(constraint, needle, c.needle_point, 1.0);
    vbss_scene_add_rigid_jacobian(constraint, tool, c.jaw_point, -1.0);
}

static void update_wall_grasp_constraint(scene_object *s, contact_constraint *constraint)
{
    const scene_drain *b = &vbss_scene_body(s, constraint->key.body_a)->drain;
    const scene_rigid *tool = &vbss_scene_body(s, constraint->key.body_b)->rigid;
    const scene_wall_grasp *p = &tool->wall_grasp;
    const drain_object *d = b->drain;
    uint32_t k = constraint->key.feature_a;
    vec3 target = pose_apply(vbss_scene_jaw_frame(tool, tool->trial), p->points_in_jaws[k]);
    vbss_scene_set_spring_geometry(s, constraint, tool,
                                   vbss_scene_wall_grasp_point(p, d, d->trial, k), target);
    constraint->stiffness = vbss_scene_wall_grasp_stiffness(tool->grasper, p);
    constraint->tangential_stiffness_ratio = 0.0; /* isotropic */
    for (uint32_t i = 0; i < 3; i++) {
        uint32_t order_index = d->order.block_index[d->mesh.triangles[p->triangle[k]][i]];
        constraint->jacobian[constraint->jacobian_block_count++] = (contact_jacobian_block){
            .block = b->first_block + order_index, .weight = p->weights[k][i]};
    }
    vbss_scene_add_rigid_jacobian(constraint, tool, target, -1.0);
}

void vbss_scene_update_bilateral_constraint(scene_object *s, contact_constraint *constraint)
{
    if (constraint->key.kind == VBSS_SCENE_CONTACT_HOLE) {
        vbss_scene_update_hole_constraint(s, constraint);
        return;
    }
    scene_body_kind kind = vbss_scene_body(s, constraint->key.body_a)->kind;
    if (kind == SCENE_BODY_RIGID) {
        update_needle_grasp_constraint(s, constraint);
        return;
    }
    if (kind == SCENE_BODY_DRAIN) {
        update_wall_grasp_constraint(s, constraint);
        return;
    }
    update_thread_grasp_constraint(s, constraint);
}

bool vbss_scene_add_thread_grasp_constraints(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        const scene_thread_grasp *g = &s->thread_grasps[i];
        bool is_active = scene_holds_strand(g) && !vbss_scene_body(s, g->thread)->is_frozen;
        for (uint32_t k = 0; is_active && k < GRASPER_THREAD_POINTS; k++) {
            const contact_key key = {VBSS_SCENE_CONTACT_GRASP, g->thread,
                                     GRASPER_THREAD_POINTS * i + k, g->tool, 0};
            if (vbss_scene_add_bilateral_constraint(s, &key) == NULL) {
                return false;
            }
        }
    }
    return true;
}

bool vbss_scene_add_needle_grasp_constraints(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        bool is_active = !b->is_frozen && vbss_scene_has_needle_grasp(s, b->number);
        for (uint32_t k = 0; is_active && k < GRASPER_NEEDLE_POINTS; k++) {
            const contact_key key = {VBSS_SCENE_CONTACT_GRASP, b->rigid.needle_grasp.needle, k,
                                     b->number, 0};
            if (vbss_scene_add_bilateral_constraint(s, &key) == NULL) {
                return false;
            }
        }
    }
    return true;
}

bool vbss_scene_add_wall_grasp_constraints(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->is_frozen || !vbss_scene_has_wall_grasp(s, b->number)) {
            continue;
        }
        for (uint32_t k = 0; k < b->rigid.wall_grasp.point_count; k++) {
            const contact_key key = {VBSS_SCENE_CONTACT_GRASP, b->rigid.wall_grasp.drain, k,
                                     b->number, 0};
            if (vbss_scene_add_bilateral_constraint(s, &key) == NULL) {
                return false;
            }
        }
    }
    return true;
}
