/* Sets targets of rigid bodies and describes their states. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "scene/api/api.h"
#include "scene/world/world.h"

_Static_assert(sizeof(vbss_scene_rigid_state) == 264, "published size");

static const uint32_t state_sizes[] = {264, 0};
static const vbss_layout state_layout = {"vbss_scene_rigid_state", NULL, state_sizes};

vbss_result vbss_scene_set_rigid_target(vbss_scene *scene, uint32_t body, const double position[3],
                                        const double *orientation)
{
    VBSS_ENTER(scene);
    scene_object *s;
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    VBSS_TRY(vbss_check_pointer(s->context, position, "position"));
    scene_body *b;
    VBSS_TRY(vbss_scene_require_body(s, body, SCENE_BODY_RIGID, &b));
    scene_rigid *r = &b->rigid;
    pose previous = r->has_pending_target ? r->pending_target : r->body.target_end,
         target = pose_mul(previous, pose_inverse(r->frame));
    if (r->grasper != NULL) {
        return vbss_fail(s->context, VBSS_ERROR_INCOMPATIBLE,
                         "body %u is a grasper: it goes where vbss_grasper_set_target says", body);
    }
    if ((scene_is_mesh(b) && !r->is_rigid_mesh) || r->is_plane) {
        return vbss_fail(s->context, VBSS_ERROR_INCOMPATIBLE,
                         r->is_plane         ? "body %u is a plane"
                         : r->is_static_mesh ? "body %u is a static mesh"
                                             : "body %u moves as vbss_scene_move_surface says",
                         body);
    }
    if (r->kind == VBSS_SCENE_RIGID_FREE) {
        return vbss_fail(s->context, VBSS_ERROR_INCOMPATIBLE, "body %u is free", body);
    }
    VBSS_TRY(vbss_check_vector(s->context, position, 1e3, "position"));
    if (orientation != NULL) {
        VBSS_TRY(vbss_read_orientation(s->context, orientation, &target.orientation));
    }
    vbss_edit input = {.kind = VBSS_EDIT_RIGID_TARGET, .words = {body, orientation != NULL}};
    vbss_edit_set_numbers(&input, 0, position, 3);
    vbss_edit_set_numbers(&input, 3, orientation, 4);
    VBSS_TRY(vbss_edit_begin(scene, &input));
    const double jump = vec3_distance(vec3_load(position), target.position);
    if (!r->has_jumped && jump > VBSS_LIKELY_JUMP) {
        r->has_jumped = true; /* a host with the wrong unit is warned once, not each step */
        vbss_warn_if_unlikely(s->context, jump, VBSS_LIKELY_JUMP, "the way to position", "m", "mm");
    }
    target.position = vec3_load(position);
    target = pose_mul(target, r->frame);
    if (orientation == NULL) { /* keeps the same bits; rounding would turn the body */
        target.orientation = previous.orientation;
    }
    vbss_scene_set_tool_target(s, r, target);
    s->report.generation++;
    return vbss_edit_end(scene, &input, VBSS_OK);
}

vbss_result vbss_scene_get_rigid(vbss_scene *scene, uint32_t body, vbss_scene_rigid_state *state,
                                 uint32_t struct_size)
{
    VBSS_ENTER(scene);
    scene_object *s;
    VBSS_TRY(vbss_scene_open(scene, &s));
    scene_body *b;
    VBSS_TRY(vbss_scene_require_body(s, body, SCENE_BODY_RIGID, &b));
    const scene_rigid *r = &b->rigid;
    vbss_scene_rigid_state own = {.struct_size = sizeof own, .kind = r->kind};
    pose back = pose_inverse(r->frame), at = pose_mul(r->body.now.pose, back);
    vec3 to_centre = vec3_sub(r->body.now.pose.position, at.position);
    vec3 hand = r->kind == VBSS_SCENE_RIGID_DRIVEN ? r->force : vec3_neg(r->coupling_wrench.force);
    vec3 turn =
        r->kind == VBSS_SCENE_RIGID_DRIVEN ? r->torque : vec3_neg(r->coupling_wrench.torque);
    pose_store(at, own.position, own.orientation);
    pose_store(pose_mul(r->has_pending_target ? r->pending_target : r->body.target_end, back),
               own.target_position, own.target_orientation);
    vec3_store(own.velocity, vec3_sub(r->body.now.v, vec3_cross(r->body.now.w, to_centre)));
    vec3_store(own.angular_velocity, r->body.now.w);
    vec3_store(own.hand_force, hand);
    vec3_store(own.hand_torque, vec3_add(turn, vec3_cross(to_centre, hand)));
    vec3_store(own.contact_force, r->force);
    vec3_store(own.contact_torque, vec3_add(r->torque, vec3_cross(to_centre, r->force)));
    return vbss_struct_write(s->context, &state_layout, &own, state, struct_size);
}
