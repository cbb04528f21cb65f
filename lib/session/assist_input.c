/* The aids between the input of a hand and the target of its tool. Each changes the movement of one step:
 *   AUTO_HOLD -> HOVER -> ARC or WIND, else as the hand moves -> FOLLOW -> SNAP_ROLL
 * The result follows from the input, the state of the scene and the state of the aids alone. */
#include "base/elementary.h"
#include "base/pi.h"
#include "base/rotation.h"
#include "session/session.h"
#include "session/tuning.h"

static bool is_on(const session_object *s, uint32_t aid)
{
    return (s->assistance.set.aids & aid) != 0;
}

/* ---- the scene */

static vbss_grasper *grasper_of(const session_object *s, uint32_t hand)
{
    return vbss_scene_inspect_body(s->scene, s->config.tools[hand]).grasper;
}

/* Directions at the drain, unit vectors. */
typedef struct task_axes {
    vec3 up, along; /* out of the tissue; along the slit */
    vec3 onward;    /* from the first mark of the stitch to the second */
    vec3 slit;      /* its middle, between the marks */
} task_axes;

static task_axes read_axes(const session_object *s, uint32_t hand)
{
    const vbss_drain *drain = vbss_scene_inspect_body(s->scene, s->config.drain).drain;
    task_axes a = {vec3_make(0.0, 0.0, 1.0), vec3_make(0.0, 1.0, 0.0), vec3_make(1.0, 0.0, 0.0),
                   vec3_zero()};
    if (drain == NULL) {
        return a;
    }
    const scene_drain_info d = vbss_scene_inspect_drain(drain);
    vec3 marks[2] = {d.positions[d.marks[0]], d.positions[d.marks[1]]};
    vec3 across = vec3_unit_or(vec3_sub(marks[1], marks[0]), a.onward);
    a.slit = vec3_lerp(marks[0], marks[1], 0.5);
    vec3 up = vec3_sub(a.slit, d.centre);
    uint32_t first = vbss_session_mark_of(s, hand, SESSION_ENTRY);
    a.up = vec3_unit_or(vec3_add_scaled(up, -vec3_dot(up, across), across), a.up);
    a.along = vec3_cross(a.up, across);
    a.onward = first == 0 ? across : vec3_neg(across);
    return a;
}

/* How far the hand has moved along the direction of ARC and WIND. */
static double move_along(const session_object *s, const task_axes *axes, vec3 motion)
{
    return vec3_dot(motion, vec3_unit_or(vec3_load(s->assistance.set.direction), axes->onward));
}

static bool holds_needle(const session_object *s, uint32_t hand)
{
    return (s->holding_tools.value >> hand & 1u) != 0;
}

static bool is_throwing(const session_object *s)
{
    return s->phase >= VBSS_SESSION_PHASE_THROW_1 && s->phase <= VBSS_SESSION_PHASE_THROW_3;
}

/* ---- AUTO_HOLD */

static double angle_between(quat a, quat b)
{
    return vec3_norm(vbss_quat_to_rotation_vector(quat_mul(a, quat_conjugate(b))));
}

/* Returns whether the hand is idle. */
static bool hold(const session_object *s, session_aided_hand *hand, double h,
                 const session_input *input)
{
    const vbss_session_assistance *set = &s->assistance.set;
    bool was_idle = hand->rest_time >= set->hold_time;
    bool rests =
        vec3_distance(input->pose.position, hand->rest.position) <= set->hold_distance &&
        angle_between(input->pose.orientation, hand->rest.orientation) <= SESSION_REST_ANGLE;
    bool grips = was_idle && fabs(input->opening - hand->opening) > SESSION_HOLD_OPENING;
    if (!is_on(s, VBSS_SESSION_AID_AUTO_HOLD) || !rests || grips) {
        hand->rest = input->pose;
        hand->rest_time = 0.0;
    } else {
        hand->rest_time += h;
    }
    if (hand->rest_time < set->hold_time || !is_on(s, VBSS_SESSION_AID_AUTO_HOLD)) {
        hand->opening = input->opening;
        return false;
    }
    return true;
}

/* ---- HOVER */

static vec3 hover(const session_object *s, session_aided_hand *hand, double h, vec3 up, vec3 motion)
{
    double rise = vec3_dot(motion, up);
    if (!is_on(s, VBSS_SESSION_AID_HOVER)) {
        hand->climb = 0.0;
        return motion;
    }
    hand->climb += (rise - hand->climb * h) / (SESSION_CLIMB_TIME + h);
    bool sinks = hand->climb < 0.0 && -hand->climb < s->assistance.set.sink_speed && rise < 0.0;
    return sinks ? vec3_add_scaled(motion, -rise, up) : motion;
}

/* ---- ARC */

static bool is_driving(const session_object *s, uint32_t hand)
{
    return is_on(s, VBSS_SESSION_AID_ARC) && holds_needle(s, hand) && !is_throwing(s) &&
           vbss_scene_inspect_body(s->scene, s->config.needle).needle != NULL;
}

/* The arc of the needle as it is when the aid begins: a needle that bends its grasp does not move it. */
static void drive(const session_object *s, session_aided_hand *hand, double length)
{
    const scene_needle_info needle =
        vbss_scene_inspect_needle(vbss_scene_inspect_body(s->scene, s->config.needle).needle);
    if (hand->is_on_arc == 0) {
        hand->is_on_arc = 1;
        hand->arc_centre = needle.pose.position;
        hand->arc_axis = quat_rotate(needle.pose.orientation, vec3_make(0.0, 0.0, 1.0));
    }
    quat turn =
        vbss_quat_from_rotation_vector(vec3_scale(hand->arc_axis, length / needle.arc_radius));
    vec3 arm = vec3_sub(hand->free.position, hand->arc_centre);
    hand->free.position = vec3_add(hand->arc_centre, quat_rotate(turn, arm));
    hand->free.orientation = quat_unit(quat_mul(turn, hand->free.orientation));
}

/* ---- WIND */

static bool is_winding(const session_object *s, uint32_t hand)
{
    return is_on(s, VBSS_SESSION_AID_WIND) && is_throwing(s) && holds_needle(s, hand) &&
           !holds_needle(s, 1 - hand) && grasper_of(s, 1 - hand) != NULL;
}

/* ---- SNAP_ROLL */

static double wrap(double angle)
{
    return angle - VBSS_TWO_PI * floor(angle / VBSS_TWO_PI + 0.5);
}

/* Roll of a tool about its shaft from where its jaws open along the slit. */
static double roll_of(quat orientation, vec3 along)
{
    vec3 shaft = quat_rotate(orientation, vec3_make(0.0, 0.0, 1.0));
    vec3 jaws = quat_rotate(orientation, vec3_make(1.0, 0.0, 0.0));
    vec3 zero = vec3_add_scaled(along, -vec3_dot(along, shaft), shaft);
    zero = vec3_unit_or(zero, vec3_any_normal(shaft));
    return vbss_atan2(vec3_dot(vec3_cross(zero, jaws), shaft), vec3_dot(zero, jaws));
}

/* Moves a distance toward `to` by at most `step`. */
static double approach(double from, double to, double step)
{
    return from < to ? vbss_min(from + step, to) : vbss_max(from - step, to);
}

static quat roll_by(quat orientation, double angle)
{
    return quat_unit(
        quat_mul(orientation, vbss_quat_from_rotation_vector(vec3_make(0.0, 0.0, angle))));
}

/* While a needle is driven its arc decides. */
static void snap(const session_object *s, session_aided_hand *hand, double h, vec3 along)
{
    double step = s->assistance.set.roll_step;
    if (!is_on(s, VBSS_SESSION_AID_SNAP_ROLL) || hand->is_on_arc != 0) {
        hand->free.orientation = hand->roll != 0.0 ? roll_by(hand->free.orientation, hand->roll)
                                                   : hand->free.orientation;
        hand->roll = hand->snapped = 0.0;
        return;
    }
    double roll = roll_of(hand->free.orientation, along);
    if (fabs(wrap(roll - hand->snapped)) > (0.5 + SESSION_SNAP_MARGIN) * step) {
        hand->snapped = wrap(step * floor(roll / step + 0.5));
    }
    double missing = wrap(hand->snapped - roll - hand->roll);
    hand->roll = wrap(hand->roll + approach(0.0, missing, SESSION_SNAP_SPEED * h));
}

/* ---- the input of a step */

/* The step in which the first aid is on moves nothing: the tool stays where it was. */
static void begin(const session_object *s, session_aided_hand *hand, uint32_t number,
                  const session_input *input)
{
    vbss_grasper_state tool;
    hand->is_relative = 1;
    hand->input = hand->rest = hand->free = input->pose;
    hand->opening = input->opening;
    if (vbss_grasper_get_state(grasper_of(s, number), &tool, sizeof tool) == VBSS_OK) {
        const double *q = tool.target_orientation;
        hand->free = pose_make(vec3_load(tool.target_position),
                               quat_unit(quat_make(q[0], q[1], q[2], q[3])));
    }
}

static void move(session_object *s, session_aided_hand *hand, uint32_t number,
                 const task_axes *axes, pose motion)
{
    bool drives = is_driving(s, number);
    hand->is_on_arc = drives ? hand->is_on_arc : 0;
    if (drives) {
        drive(s, hand, move_along(s, axes, motion.position));
        return;
    }
    hand->free.orientation = quat_unit(quat_mul(motion.orientation, hand->free.orientation));
    if (is_winding(s, number)) {
        vbss_session_wind(s, hand, number, move_along(s, axes, motion.position));
    } else {
        hand->free.position = vec3_add(hand->free.position, motion.position);
    }
}

/* A mouse that is not moved differs by rounding. */
static bool is_still(pose motion)
{
    return vec3_norm(motion.position) < SESSION_STILL &&
           vec3_norm(vbss_quat_to_rotation_vector(motion.orientation)) < SESSION_STILL;
}

void vbss_session_assist(session_object *s, uint32_t hand, double h, session_input *input)
{
    session_aided_hand *a = &s->assistance.hands[hand];
    const task_axes axes = read_axes(s, hand);
    if (a->is_relative == 0) {
        begin(s, a, hand, input);
    }
    bool is_idle = hold(s, a, h, input);
    pose motion = {
        vec3_sub(input->pose.position, a->input.position),
        quat_unit(quat_mul(input->pose.orientation, quat_conjugate(a->input.orientation)))};
    a->input = input->pose;
    bool rests = is_idle || is_still(motion);
    if (!is_idle) {
        motion.position = hover(s, a, h, axes.up, motion.position);
        move(s, a, hand, &axes, motion);
    }
    vbss_session_follow(s, hand, h, rests, axes.slit, axes.up);
    snap(s, a, h, axes.along);
    input->pose = pose_make(a->free.position, a->roll != 0.0 ? roll_by(a->free.orientation, a->roll)
                                                             : a->free.orientation);
    input->opening = a->opening;
}
