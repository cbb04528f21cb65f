#include "scenes/puncture_scenes.h"

#include <string.h>

#include "base/elementary.h"
#include "base/error.h"
#include "base/rotation.h"
#include "scene/api/api.h"
#include "scene/world/world.h"

/* How stiffly the hand holds it, and where it begins, before the middle of the wall. */
static const vbss_rigid_coupling hand = {2e4, 20.0, 5.0, 0.02};
#define BEFORE 1e-3

enum { DRAIN = 1, NEEDLE = 2 }; /* numbers of bodies */

vbss_result puncture_scene_configs(vbss_scene_config *scene, vbss_drain_config *drain)
{
    VBSS_TRY(vbss_scene_config_init(scene, sizeof *scene));
    VBSS_TRY(vbss_drain_config_init(drain, sizeof *drain));
    scene->node_capacity = 0;
    return VBSS_OK;
}

/* The needle's frame, its tip so far before the mark, pointing straight into the wall. */
static pose first_pose(const drain_object *d, double radius)
{
    vec3 mark = d->mesh.rest[d->mesh.marks[DRAIN_RIGHT]];
    vec3 into = vec3_unit_or(vec3_make(0.0, -mark.y, -mark.z), vec3_zero());
    vec3 aside = vec3_make(0.0, into.z, -into.y); /* from the arc's centre to the tip */
    vec3 tip = vec3_add_scaled(mark, -BEFORE, into);
    quat first = quat_between(vec3_make(0.0, 1.0, 0.0), into);
    vec3 now = quat_rotate(first, vec3_make(1.0, 0.0, 0.0));
    double angle = vbss_atan2(vec3_dot(vec3_cross(now, aside), into), vec3_dot(now, aside));
    quat turn = vbss_quat_from_rotation_vector(vec3_scale(into, angle));
    return pose_make(vec3_add_scaled(tip, -radius, aside), quat_mul(turn, first));
}

static vbss_result hold_edge(vbss_drain *drain, const drain_object *d)
{
    uint32_t id;
    vbss_drain_attachment a;
    VBSS_TRY(vbss_drain_attachment_init(&a, sizeof a));
    a.node = d->mesh.slit_middle[DRAIN_RIGHT];
    vec3_store(a.position, d->x[a.node]);
    return vbss_drain_attach(drain, &a, &id);
}

static vbss_result add_needle(vbss_context *context, const drain_object *d, puncture_scene *p)
{
    vbss_needle_config c;
    scene_object *s;
    VBSS_TRY(vbss_needle_config_init(&c, sizeof c));
    pose_store(first_pose(d, c.radius), c.position, c.orientation);
    VBSS_TRY(vbss_needle_create(context, &c, &p->needle));
    VBSS_TRY(vbss_scene_add_needle(p->scene, p->needle, &p->needle_body));
    VBSS_TRY(vbss_scene_open(p->scene, &s));
    scene_rigid *r = &vbss_scene_body(s, p->needle_body)->rigid;
    r->kind = VBSS_RIGID_COUPLED; /* no tool between: what it takes is what the hand feels */
    r->body.coupling = hand;
    return VBSS_OK;
}

vbss_result puncture_scene_create(vbss_context *context, const vbss_scene_config *scene,
                                  const vbss_drain_config *drain, puncture_scene *made)
{
    drain_object *d;
    *made = (puncture_scene){.speed = PUNCTURE_SCENE_SPEED};
    VBSS_TRY(vbss_scene_create(context, scene, &made->scene));
    VBSS_TRY(vbss_drain_create(context, drain, &made->drain));
    VBSS_TRY(vbss_scene_add_drain(made->scene, made->drain, &made->drain_body));
    VBSS_TRY(vbss_drain_open(made->drain, &d));
    VBSS_TRY(hold_edge(made->drain, d));
    return add_needle(context, d, made);
}

double puncture_scene_way(double speed, uint64_t steps, double h)
{
    double way = speed * h * (double)steps;
    return vbss_min(way, 2.0 * PUNCTURE_SCENE_ON - way);
}

uint32_t puncture_scene_steps(const puncture_scene *p, double h)
{
    return (uint32_t)ceil((PUNCTURE_SCENE_ON + PUNCTURE_SCENE_BACK) / (p->speed * h));
}

vbss_result puncture_scene_aim(vbss_scene *scene, double speed, double h)
{
    scene_object *s;
    vbss_scene_statistics told;
    VBSS_TRY(vbss_scene_open(scene, &s));
    VBSS_TRY(vbss_scene_get_statistics(scene, &told, sizeof told));
    scene_rigid *r = &vbss_scene_body(s, NEEDLE)->rigid;
    double radius = r->needle->config.radius;
    pose at = first_pose(vbss_scene_body(s, DRAIN)->drain.drain, radius);
    double way = puncture_scene_way(speed, told.steps + 1, h);
    quat turn = vbss_quat_from_rotation_vector(vec3_make(0.0, 0.0, way / radius));
    at.orientation = quat_mul(at.orientation, turn);
    vbss_scene_set_rigid_target(s, r, pose_mul(at, r->frame));
    return VBSS_OK;
}

vbss_result puncture_scene_step_of(vbss_scene *scene, double speed, double h)
{
    VBSS_TRY(puncture_scene_aim(scene, speed, h));
    return vbss_scene_step(scene, h);
}

vbss_result puncture_scene_step(puncture_scene *p, double h)
{
    return puncture_scene_step_of(p->scene, p->speed, h);
}

/* The torque about the arc's centre: what holes bear across does no work along the arc. */
vbss_result puncture_scene_push(const puncture_scene *p, double *push)
{
    scene_object *s;
    VBSS_TRY(vbss_scene_open(p->scene, &s));
    const scene_rigid *r = &vbss_scene_body(s, p->needle_body)->rigid;
    pose at = vbss_needle_pose(r->needle);
    vec3 axis = quat_rotate(at.orientation, vec3_make(0.0, 0.0, 1.0));
    vec3 arm = vec3_sub(r->body.now.pose.position, at.position);
    vec3 torque = vec3_add(r->coupling_wrench.torque, vec3_cross(arm, r->coupling_wrench.force));
    *push = vec3_dot(axis, torque) / r->needle->config.radius;
    return VBSS_OK;
}

uint32_t puncture_scene_count(const puncture_scene *p, vbss_event_kind kind)
{
    vbss_view view;
    uint32_t count = 0;
    if (vbss_scene_get_view(p->scene, VBSS_SCENE_VIEW_EVENTS, &view, sizeof view) != VBSS_OK) {
        return 0;
    }
    for (uint64_t i = 0; i < view.count; i++) {
        uint32_t words[4];
        memcpy(words, (const char *)view.data + i * view.stride_bytes, sizeof words);
        count += words[0] == (uint32_t)kind;
    }
    return count;
}
