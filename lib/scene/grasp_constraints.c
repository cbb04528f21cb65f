/* Rows that hold threads in the jaws of graspers: three springs a grasp, the same in all directions.
 *
 * A row is bilateral: its gap and what it has slid are where the thread's point is, seen from where it is
 * held, so that nothing of it is remembered but what the grasp itself knows. */
#include "scene/holes.h"
#include "scene/contacts.h"
#include "scene/scene.h"
#include "scene/tools.h"

/* Where along the thread a point is held: on a segment, and which share of it. */
typedef struct location {
    uint32_t segment;
    double fraction;
} location;

/* From the segment of the grasp's middle, which is at hand. */
static location location_on_thread(const thread_object *t, const scene_thread_grasp *g,
                                   double offset)
{
    location p = {g->segment, g->segment_offset + offset};
    while (p.fraction < 0.0 && p.segment > 0) {
        p.fraction += t->rest[--p.segment];
    }
    while (p.fraction > t->rest[p.segment] && p.segment + 2 < t->node_count) {
        p.fraction -= t->rest[p.segment++];
    }
    p.fraction /= t->rest[p.segment];
    p.fraction = p.fraction < 0.0   ? 0.0
                 : p.fraction > 1.0 ? 1.0
                                    : p.fraction; /* the thread ends before */
    return p;
}

static location location_of_grip_point(const thread_object *t, const scene_thread_grasp *g,
                                       uint32_t point)
{
    double half = 0.5 * (GRASPER_THREAD_POINTS - 1) * g->point_spacing;
    return location_on_thread(t, g, g->point_spacing * point - half);
}

vec3 vbss_scene_grip_point(const scene_thread_grasp *g, const thread_object *t, const vec3 *x,
                           uint32_t point)
{
    location p = location_of_grip_point(t, g, point);
    return vec3_lerp(x[p.segment], x[p.segment + 1], p.fraction);
}

pose vbss_scene_jaw_frame(const scene_rigid *r, pose principal)
{
    pose tool = pose_mul(principal, pose_inverse(r->frame));
    return pose_mul(tool, vbss_grasper_jaw_frame(r->grasper));
}

void vbss_scene_set_spring_geometry(contact_constraint *constraint, const scene_rigid *tool,
                                    vec3 current, vec3 target)
{
    pose jaws = vbss_scene_jaw_frame(tool, tool->trial);
    constraint->normal = quat_rotate(jaws.orientation, vec3_make(1.0, 0.0, 0.0));
    constraint->relative_displacement = vec3_sub(current, target);
    constraint->gap = vec3_dot(constraint->normal, constraint->relative_displacement);
    constraint->point = target;
    constraint->jacobian_block_count = 0;
    constraint->friction = 1.0; /* it has a stiffness along the plane too */
    constraint->previous_force = constraint->solution.tangential_force = vec3_zero();
    constraint->solution.status = CONTACT_STICK;
}

static void update_thread_grasp_constraint(scene_object *s, contact_constraint *constraint)
{
    const scene_thread_grasp *g =
        &s->thread_grasps[constraint->key.feature_a / GRASPER_THREAD_POINTS];
    const scene_body *b = vbss_scene_body(s, g->thread);
    const scene_rigid *r = &vbss_scene_body(s, g->tool)->rigid;
    const thread_object *t = b->thread.thread;
    uint32_t point = constraint->key.feature_a % GRASPER_THREAD_POINTS;
    location p = location_of_grip_point(t, g, point);
    vec3 target = pose_apply(vbss_scene_jaw_frame(r, r->trial), g->grip.anchor[point]);
    vec3 current = vec3_lerp(t->trial[p.segment], t->trial[p.segment + 1], p.fraction);
    vbss_scene_set_spring_geometry(constraint, r, current, target);
    constraint->stiffness = GRASPER_NORMAL_STIFFNESS_RATIO *
                            (r->grasper->config.grip_stiffness / GRASPER_THREAD_POINTS);
    constraint->tangential_stiffness_ratio = 1.0 / GRASPER_NORMAL_STIFFNESS_RATIO;
    constraint->barycentric[0] = p.fraction;
    vbss_scene_add_node_jacobian(s, constraint, b, p.segment, 1.0 - p.fraction);
    vbss_scene_add_node_jacobian(s, constraint, b, p.segment + 1, p.fraction);
    vbss_scene_add_rigid_jacobian(constraint, r, target, -1.0);
}

void vbss_scene_update_bilateral_constraint(scene_object *s, contact_constraint *constraint)
{
    if (constraint->key.kind == VBSS_CONTACT_HOLE) {
        vbss_scene_update_hole_constraint(s, constraint);
        return;
    }
    scene_body_kind kind = vbss_scene_body(s, constraint->key.body_a)->kind;
    if (kind == SCENE_BODY_RIGID) {
        vbss_scene_update_needle_grasp_constraint(s, constraint);
        return;
    }
    if (kind == SCENE_BODY_DRAIN) {
        vbss_scene_update_wall_grasp_constraint(s, constraint);
        return;
    }
    update_thread_grasp_constraint(s, constraint);
}

contact_constraint *vbss_scene_add_bilateral_constraint(scene_object *s, const contact_key *key)
{
    contact_constraint *constraint = vbss_contact_add(s->contacts, key);
    if (constraint != NULL) {
        constraint->is_bilateral = true;
        constraint->thickness = 1.0; /* it overlaps nothing */
    }
    return constraint;
}

bool vbss_scene_add_thread_grasp_constraints(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        const scene_thread_grasp *g = &s->thread_grasps[i];
        for (uint32_t k = 0; g->id != 0 && !g->is_released && k < GRASPER_THREAD_POINTS; k++) {
            const contact_key key = {VBSS_CONTACT_GRASP, g->thread, GRASPER_THREAD_POINTS * i + k,
                                     g->tool, 0};
            if (vbss_scene_add_bilateral_constraint(s, &key) == NULL) {
                return false;
            }
        }
    }
    return true;
}
