/* WIND: the end of the needle that the thread is on goes round the jaws of the other tool, with the thread nearly taut. */
#include "base/elementary.h"
#include "base/pi.h"
#include "base/rotation.h"
#include "session/session.h"
#include "session/tuning.h"

static scene_grasper_info tool_of(const session_object *s, uint32_t hand)
{
    return vbss_scene_inspect_grasper(
        vbss_scene_inspect_body(s->scene, s->config.tools[hand]).grasper);
}

/* A hand without the needle winds with its tip. */
vec3 vbss_session_thread_end(const session_object *s, uint32_t hand)
{
    const vbss_needle *needle = vbss_scene_inspect_body(s->scene, s->config.needle).needle;
    vbss_grasper_state state;
    vbss_result result = vbss_grasper_get_state(
        vbss_scene_inspect_body(s->scene, s->config.tools[hand]).grasper, &state, sizeof state);
    if (needle == NULL || result != VBSS_OK || state.needle == 0) {
        return vec3_zero();
    }
    vec3 end = vbss_session_needle_point(s, vbss_session_needle_length(s));
    return pose_apply_inverse(tool_of(s, hand).pose, end);
}

double vbss_session_limb_length(const session_object *s, const session_observation *observed)
{
    const session_hole_observation *hole =
        vbss_session_find_hole(observed, s->holes[SESSION_EXIT].id);
    if (hole == NULL || hole->thread == 0) {
        return -1.0;
    }
    return s->knot.is_located ? vbss_min(hole->arc, s->knot.end_arcs[SESSION_EXIT]) : hole->arc;
}

double vbss_session_wind_radius(const session_object *s, const session_observation *observed,
                                uint32_t loop, vec3 centre, double radius, bool winds)
{
    double length = vbss_session_limb_length(s, observed);
    if (length < 0.0) {
        return vbss_min(vbss_max(radius, SESSION_WIND_RADIUS), SESSION_WIND_MAX_RADIUS);
    }
    vec3 root = vbss_session_thread_position(s, observed, length);
    double turns = vbss_max(fabs(s->coach.turns[loop]) - 0.5, 0.0);
    double wound = VBSS_TWO_PI * SESSION_WIND_NECK * turns;
    double snug = SESSION_WIND_SNUG * (length - vec3_distance(root, centre) - wound);
    /* A limb that becomes longer comes out of the stitch: a wider circle would draw the tail out. */
    double limit = winds && turns > 0.5 ? radius : SESSION_WIND_MAX_RADIUS;
    if (winds && observed->needle_pull > SESSION_WIND_PULL) {
        limit = vbss_min(limit, SESSION_WIND_NEARER * radius);
    }
    return vbss_min(vbss_max(vbss_min(snug, limit), SESSION_WIND_RADIUS), SESSION_WIND_MAX_RADIUS);
}

/* Moves a distance toward `to` by at most `step`. */
static double approach(double from, double to, double step)
{
    return from < to ? vbss_min(from + step, to) : vbss_max(from - step, to);
}

static bool has_just_lost_turns(const session_object *s)
{
    return (s->coach.open & 1ull << VBSS_SESSION_MISTAKE_TURNS_LOST) != 0 &&
           s->time - s->coach.begun[VBSS_SESSION_MISTAKE_TURNS_LOST] < SESSION_WIND_PAUSE;
}

/* A hand off the circle comes to it while it moves. */
void vbss_session_wind(session_object *s, session_aided_hand *hand, uint32_t number, double length)
{
    uint32_t loop = 1 - number;
    if (length > 0.0 && has_just_lost_turns(s)) {
        return;
    }
    const scene_grasper_info tool = tool_of(s, loop);
    vec3 back = vec3_neg(quat_rotate(tool.pose.orientation, tool.forward));
    vec3 centre = vec3_add_scaled(tool.pose.position, SESSION_WIND_BEHIND, back);
    vec3 axis = vec3_scale(back, vbss_session_wanted_sign(s));
    vec3 end = vec3_add(hand->free.position,
                        quat_rotate(hand->free.orientation, vbss_session_thread_end(s, number)));
    vec3 from = vec3_sub(end, centre);
    double aside = vec3_dot(from, axis), step = fabs(length);
    vec3 arm = vec3_add_scaled(from, -aside, axis);
    vbss_session_observe(s, &s->observation); /* the step does it once more */
    if (s->observation.has_lost_body) {
        return;
    }
    double radius = vec3_norm(arm);
    double wanted =
        vbss_session_wind_radius(s, &s->observation, loop, centre, radius, length > 0.0);
    arm = vec3_unit_or(arm, vec3_any_normal(axis));
    arm = quat_rotate(vbss_quat_from_rotation_vector(vec3_scale(axis, length / wanted)), arm);
    vec3 place = vec3_add_scaled(centre, approach(radius, wanted, step), arm);
    place = vec3_add_scaled(place, approach(aside, 0.0, step), axis);
    hand->free.position = vec3_add(hand->free.position, vec3_sub(place, end));
}
