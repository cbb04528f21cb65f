/* A free tool follows where its hand shall be, and feels the thread in its jaws. */
#include <math.h>

#include "base/elementary.h"
#include "base/error.h"
#include "base/rotation.h"
#include "tie.h"

static const double lag = 0.04 /* s */, acceleration = 1.5 /* m/s^2 */,
                    turning = 4.0 /* rad/s, limit */, smooth = 0.1;

vec3 tie_limited(vec3 v, double limit)
{
    const double length = vec3_norm(v);
    return length > limit ? vec3_scale(v, limit / length) : v;
}

void tie_take_over(tie_hand *h, scripted_hand *of, double opening)
{
    vbss_grasper_state s;
    *h = (tie_hand){.of = of, .opening = opening, .speed = 0.1};
    (void)vbss_grasper_get_state(of->tool, &s, sizeof s);
    h->at = h->goal = vec3_load(s.target_position);
    h->turn = h->wanted_turn = quat_make(s.target_orientation[0], s.target_orientation[1],
                                         s.target_orientation[2], s.target_orientation[3]);
}

void tie_go(tie_hand *h, vec3 tip, double speed)
{
    h->goal = tip;
    h->speed = speed;
}

void tie_turn(tie_hand *h, vec3 handle, vec3 across)
{
    const vec3 z = vec3_unit_or(handle, vec3_make(0.0, 1.0, 0.0));
    const vec3 level = vec3_add_scaled(across, -vec3_dot(across, z), z);
    const vec3 x = vec3_unit_or(level, vec3_any_normal(z));
    const quat upright = quat_between(vec3_make(0.0, 0.0, 1.0), z);
    const vec3 now = quat_rotate(upright, vec3_make(1.0, 0.0, 0.0));
    const double roll = vbss_arc_tangent(vec3_dot(vec3_cross(now, x), z), vec3_dot(now, x));
    h->wanted_turn = quat_mul(vbss_quat_from_rotation_vector(vec3_scale(z, roll)), upright);
}

static void turn(tie_hand *h, double dt)
{
    const quat to = quat_mul(h->wanted_turn, quat_conjugate(h->turn));
    const vec3 rotation =
        vbss_quat_to_rotation_vector(to.w < 0.0 ? quat_make(-to.w, -to.x, -to.y, -to.z) : to);
    const vec3 step = tie_limited(vec3_scale(rotation, dt / lag), turning * dt);
    h->turn = quat_unit(quat_mul(vbss_quat_from_rotation_vector(step), h->turn));
}

vbss_result tie_move(tie_hand *h, double dt)
{
    double position[3], orientation[4];
    const vec3 to = vec3_sub(h->goal, h->at);
    const double stop = sqrt(1.4 * acceleration * vec3_norm(to)); /* from where it can still stop */
    const vec3 wanted = tie_limited(vec3_scale(to, 1.0 / lag), fmin(h->speed, stop));
    const vec3 change = tie_limited(vec3_sub(wanted, h->velocity), acceleration * dt);
    h->velocity = vec3_add(h->velocity, change);
    h->at = vec3_add_scaled(h->at, dt, h->velocity);
    turn(h, dt);
    pose_store(pose_make(h->at, h->turn), position, orientation);
    VBSS_TRY(vbss_grasper_set_target(h->of->tool, position, orientation));
    return vbss_grasper_set_opening(h->of->tool, h->opening);
}

vbss_result tie_feel(tie_hand *h, vbss_scene *scene, const tie_thread *thread)
{
    vbss_grasper_state s;
    vbss_scene_grasp grasp;
    VBSS_TRY(vbss_grasper_get_state(h->of->tool, &s, sizeof s));
    const quat q =
        quat_make(s.orientation[0], s.orientation[1], s.orientation[2], s.orientation[3]);
    h->tip = vec3_load(s.position);
    h->handle = quat_rotate(q, vec3_make(0.0, 0.0, 1.0));
    h->across = quat_rotate(q, vec3_make(1.0, 0.0, 0.0));
    h->holds = false;
    double force = 0.0;
    for (uint32_t i = 0; i < s.grasp_count; i++) {
        VBSS_TRY(vbss_scene_get_grasp(scene, h->of->body, i, &grasp, sizeof grasp));
        if (grasp.body == thread->body && !h->holds) {
            h->holds = true;
            h->node = (uint32_t)(grasp.arc_length / thread->segment + 0.5);
            h->jaws = vec3_load(grasp.position);
            force = vec3_norm(vec3_load(grasp.force));
        }
    }
    h->tension += smooth * (force - h->tension);
    return VBSS_OK;
}
