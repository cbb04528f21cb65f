#include "scripted/hand.h"

#include "base/error.h"
#include "base/rotation.h"

static const double beyond = 2e-3; /* m, of jaws over the needle */

static quat turn_about_z(double angle)
{
    return vbss_quat_from_rotation_vector(vec3_make(0.0, 0.0, angle));
}

pose scripted_needle(vec3 centre, double turned)
{
    return pose_make(centre, turn_about_z(turned));
}

/* The shaft leans about the tangent of the circle, so that the needle stays across the jaws. */
pose scripted_tool(const scripted_hand *hand, vec3 centre)
{
    const quat radial = turn_about_z(hand->angle);
    const vec3 needle = vec3_add(centre, quat_rotate(radial, vec3_make(SCRIPTED_RADIUS, 0.0, 0.0)));
    const quat half = hand->side > 0.0 ? quat_identity() : quat_make(0.0, 1.0, 0.0, 0.0);
    const quat leaning = vbss_quat_from_rotation_vector(vec3_make(0.0, hand->lean, 0.0));
    const quat turn = quat_mul(quat_mul(radial, half), leaning);
    const vec3 tip =
        vec3_add_scaled(needle, hand->back - beyond, quat_rotate(turn, vec3_make(0.0, 0.0, 1.0)));
    return pose_make(vec3_add(tip, hand->tip), turn);
}

vbss_result scripted_add_hand(vbss_context *context, vbss_scene *scene, scripted_hand *hand,
                              vec3 centre, double shaft)
{
    vbss_grasper_config config = vbss_grasper_config_default();
    double position[3], orientation[4];
    config.stiffness = 2000.0;
    config.damping = 10.0;
    config.closing_force = 20.0;
    config.grip_friction = 1.0;
    config.needle_torque = 0.2;
    config.shaft_radius = shaft > 0.0 ? shaft : config.shaft_radius;
    pose_store(scripted_tool(hand, centre), position, orientation);
    VBSS_TRY(vbss_grasper_create(context, &config, &hand->tool));
    VBSS_TRY(vbss_grasper_set_target(hand->tool, position, orientation));
    VBSS_TRY(vbss_grasper_set_opening(hand->tool, SCRIPTED_OPENING));
    return vbss_scene_add_grasper(scene, hand->tool, &hand->body);
}

vbss_result scripted_place_hand(scripted_hand *hand, vec3 centre, double opening)
{
    double position[3], orientation[4];
    pose_store(scripted_tool(hand, centre), position, orientation);
    VBSS_TRY(vbss_grasper_set_target(hand->tool, position, orientation));
    return vbss_grasper_set_opening(hand->tool, opening);
}
