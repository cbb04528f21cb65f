/* Forces on rigid bodies for a step; velocities and poses of free bodies. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "scene/api/api.h"
#include "scene/api/overlap.h"
#include "scene/tools/tools.h"
#include "scene/world/world.h"

#include <vblast_ss/scene_settings.h>

vbss_result vbss_scene_check_settable(const scene_object *s)
{
    return s->config.method == VBSS_METHOD_IMPLICIT
               ? VBSS_OK
               : vbss_fail(s->context, VBSS_ERROR_INCOMPATIBLE,
                           "a scene of this method cannot be changed at run time");
}

/* ---- forces */

static vbss_result check_load(const scene_object *s, const double force[3], const double *point,
                              const double *torque)
{
    VBSS_TRY(vbss_check_pointer(s->context, force, "force"));
    VBSS_TRY(vbss_check_vector(s->context, force, 1e6, "force"));
    if (point != NULL) {
        VBSS_TRY(vbss_check_vector(s->context, point, 1e3, "point"));
    }
    return torque == NULL ? VBSS_OK : vbss_check_vector(s->context, torque, 1e6, "torque");
}

vbss_result vbss_scene_apply_force(vbss_scene *scene, uint32_t body, const double force[3],
                                   const double *point, const double *torque)
{
    VBSS_ENTER(scene);
    scene_object *s;
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    VBSS_TRY(check_load(s, force, point, torque));
    VBSS_TRY(vbss_scene_check_settable(s));
    scene_body *b;
    VBSS_TRY(vbss_scene_require_body(s, body, SCENE_BODY_RIGID, &b));
    scene_rigid *r = &b->rigid;
    if (r->kind == VBSS_SCENE_RIGID_DRIVEN) {
        return vbss_fail(s->context, VBSS_ERROR_INCOMPATIBLE,
                         "body %u is driven: no force moves it", body);
    }
    vbss_edit input = {.kind = VBSS_EDIT_SETTING,
                       .words = {VBSS_EDIT_SETTING_FORCE, body, point != NULL, torque != NULL}};
    vbss_edit_set_numbers(&input, 0, force, 3);
    vbss_edit_set_numbers(&input, 3, point, 3);
    vbss_edit_set_numbers(&input, 6, torque, 3);
    VBSS_TRY(vbss_edit_begin(scene, &input));
    const vec3 f = vec3_load(force);
    r->pending_load.force = vec3_add(r->pending_load.force, f);
    if (point != NULL) {
        const vec3 arm = vec3_sub(vec3_load(point), r->body.now.pose.position);
        r->pending_load.torque = vec3_add(r->pending_load.torque, vec3_cross(arm, f));
    }
    if (torque != NULL) {
        r->pending_load.torque = vec3_add(r->pending_load.torque, vec3_load(torque));
    }
    s->report.generation++;
    return vbss_edit_end(scene, &input, VBSS_OK);
}

/* ---- motion of free bodies */

static vbss_result find_free(const scene_object *s, uint32_t body, scene_rigid **rigid)
{
    scene_body *b;
    VBSS_TRY(vbss_scene_require_body(s, body, SCENE_BODY_RIGID, &b));
    *rigid = &b->rigid;
    return b->rigid.kind == VBSS_SCENE_RIGID_FREE
               ? VBSS_OK
               : vbss_fail(s->context, VBSS_ERROR_INCOMPATIBLE, "body %u is not free", body);
}

static void publish(scene_object *s, uint32_t body)
{
    scene_body *b = vbss_scene_body(s, body);
    if (b->rigid.needle != NULL) {
        vbss_scene_publish_needle(b);
    }
    s->report.generation++;
}

static vbss_result set_velocity(scene_object *s, uint32_t body, const double velocity[3],
                                const double *angular_velocity)
{
    scene_rigid *r;
    VBSS_TRY(find_free(s, body, &r));
    const pose origin = pose_mul(r->body.now.pose, pose_inverse(r->frame));
    const vec3 arm = vec3_sub(r->body.now.pose.position, origin.position);
    if (angular_velocity != NULL) {
        r->body.now.w = vec3_load(angular_velocity);
    }
    r->body.now.v = vec3_add(vec3_load(velocity), vec3_cross(r->body.now.w, arm));
    publish(s, body);
    return VBSS_OK;
}

vbss_result vbss_scene_set_rigid_velocity(vbss_scene *scene, uint32_t body,
                                          const double velocity[3], const double *angular_velocity)
{
    VBSS_ENTER(scene);
    scene_object *s;
    scene_rigid *r;
    scene_edit edit;
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    VBSS_TRY(vbss_check_pointer(s->context, velocity, "velocity"));
    VBSS_TRY(vbss_check_vector(s->context, velocity, 1e5, "velocity"));
    if (angular_velocity != NULL) {
        VBSS_TRY(vbss_check_vector(s->context, angular_velocity, 1e6, "angular_velocity"));
    }
    VBSS_TRY(vbss_scene_check_settable(s));
    VBSS_TRY(find_free(s, body, &r));
    vbss_edit input = {.kind = VBSS_EDIT_SETTING,
                       .words = {VBSS_EDIT_SETTING_VELOCITY, body, angular_velocity != NULL}};
    vbss_edit_set_numbers(&input, 0, velocity, 3);
    vbss_edit_set_numbers(&input, 3, angular_velocity, 3);
    VBSS_TRY(vbss_scene_begin_edit(scene, &input, &edit));
    return vbss_scene_end_edit(&edit, set_velocity(s, body, velocity, angular_velocity));
}

/* What holds a body where it is; NULL: nothing. */
static const char *holder_of(const scene_object *s, uint32_t body)
{
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        if (s->pins[i].id != 0 && s->pins[i].body == body) {
            return "a pin";
        }
    }
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        if (s->holes[i].id != 0 && s->holes[i].needle == body) {
            return "a hole";
        }
    }
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_RIGID && b->rigid.grasper != NULL &&
            b->rigid.needle_grasp.needle == body) {
            return "a grasper";
        }
    }
    return NULL;
}

/* Checks that the body can move, and computes its principal frame there. */
static vbss_result check_pose(const scene_object *s, uint32_t body, const double position[3],
                              const quat *orientation, pose *at)
{
    scene_rigid *r;
    VBSS_TRY(find_free(s, body, &r));
    const char *holder = holder_of(s, body);
    if (holder != NULL) {
        return vbss_fail(s->context, VBSS_ERROR_IN_USE, "%s holds body %u", holder, body);
    }
    const pose origin = pose_mul(r->body.now.pose, pose_inverse(r->frame));
    *at = pose_mul(
        pose_make(vec3_load(position), orientation != NULL ? *orientation : origin.orientation),
        r->frame);
    if (orientation == NULL) { /* keeps the same bits; rounding would turn the body */
        at->orientation = r->body.now.pose.orientation;
    }
    scene_body moved = *vbss_scene_body(s, body);
    moved.rigid.body.now.pose = *at;
    const scene_outline there = vbss_scene_outline_of(s, &moved);
    return vbss_scene_check_overlap(s, &there, "body at its new pose");
}

static void move_to(scene_object *s, uint32_t body, pose at)
{
    scene_rigid *r = &vbss_scene_body(s, body)->rigid;
    r->body.now.pose = r->body.target_start = r->body.target_end = r->trial = at;
    for (uint32_t i = 0; i < r->capsule_count; i++) {
        scene_capsule *c = &s->capsules[r->first_capsule + i];
        vbss_scene_transform_capsule(c, at, c->now);
    }
    publish(s, body);
}

static vbss_result set_pose(scene_object *s, uint32_t body, const double position[3],
                            const quat *orientation)
{
    pose at = pose_identity();
    VBSS_TRY(check_pose(s, body, position, orientation, &at));
    move_to(s, body, at);
    return VBSS_OK;
}

vbss_result vbss_scene_set_rigid_pose(vbss_scene *scene, uint32_t body, const double position[3],
                                      const double *orientation)
{
    VBSS_ENTER(scene);
    scene_object *s;
    scene_edit edit;
    quat turned;
    pose at;
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    VBSS_TRY(vbss_check_pointer(s->context, position, "position"));
    VBSS_TRY(vbss_check_vector(s->context, position, 1e3, "position"));
    if (orientation != NULL) {
        VBSS_TRY(vbss_read_orientation(s->context, orientation, &turned));
    }
    const quat *wanted = orientation != NULL ? &turned : NULL;
    VBSS_TRY(vbss_scene_check_settable(s));
    vbss_edit input = {.kind = VBSS_EDIT_SETTING,
                       .words = {VBSS_EDIT_SETTING_POSE, body, orientation != NULL}};
    vbss_edit_set_numbers(&input, 0, position, 3);
    vbss_edit_set_numbers(&input, 3, orientation, 4);
    if (s->cursor.is_suspended) {
        VBSS_TRY(check_pose(s, body, position, wanted, &at));
    }
    VBSS_TRY(vbss_scene_begin_edit(scene, &input, &edit));
    return vbss_scene_end_edit(&edit, set_pose(s, body, position, wanted));
}
