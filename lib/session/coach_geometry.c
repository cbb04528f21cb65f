/* Geometry and distances of a goal, from the present state of the scene. */
#include "base/elementary.h"
#include "base/pi.h"
#include "session/session.h"
#include "session/tuning.h"

/* ---- needle */

static scene_needle_info read_needle(const session_object *s)
{
    return vbss_scene_inspect_needle(vbss_scene_inspect_body(s->scene, s->config.needle).needle);
}

static vec3 point_on_needle(const scene_needle_info *needle, double arc_length)
{
    return pose_apply(needle->pose, vbss_scene_inspect_needle_point(needle, arc_length).position);
}

static vec3 needle_axis(const scene_needle_info *needle)
{
    return quat_rotate(needle->pose.orientation, vec3_make(0.0, 0.0, 1.0));
}

/* Angle about the needle's axis from its tip to a position, -pi to pi. */
static double angle_on_needle(const scene_needle_info *needle, vec3 position)
{
    vec3 local = pose_apply_inverse(needle->pose, position);
    return vbss_atan2(local.y, local.x);
}

double vbss_session_needle_arc(const session_object *s, vec3 position)
{
    const scene_needle_info needle = read_needle(s);
    double back = -angle_on_needle(&needle, position);
    /* Opposite to the middle of the needle, angles jump. */
    back += back < 0.5 * needle.arc - VBSS_PI ? VBSS_TWO_PI : 0.0;
    return needle.arc_radius * vbss_min(vbss_max(back, 0.0), needle.arc);
}

vec3 vbss_session_needle_point(const session_object *s, double arc_length)
{
    const scene_needle_info needle = read_needle(s);
    return point_on_needle(&needle, arc_length);
}

double vbss_session_needle_length(const session_object *s)
{
    return read_needle(s).length;
}

/* ---- drain */

/* Directions of the task at the slit. */
typedef struct task_frame {
    vec3 slit, centre; /* m */
    vec3 marks[2];     /* m */
    vec3 up, across;   /* unit; out of the tissue, from the left mark to the right one */
} task_frame;

static scene_drain_info read_drain(const session_object *s)
{
    return vbss_scene_inspect_drain(vbss_scene_inspect_body(s->scene, s->config.drain).drain);
}

/* `outward`: from the centre to the slit. */
static void set_directions(task_frame *f, vec3 outward)
{
    f->up = vec3_unit_or(outward, vec3_make(0.0, 0.0, 1.0));
    vec3 across = vec3_sub(f->marks[1], f->marks[0]);
    f->across = vec3_unit_or(vec3_add_scaled(across, -vec3_dot(across, f->up), f->up),
                             vec3_any_normal(f->up));
}

static task_frame read_frame(const session_object *s, const session_observation *observed)
{
    const scene_drain_info drain = read_drain(s);
    task_frame f = {.slit = vec3_lerp(observed->lips[0], observed->lips[1], 0.5),
                    .centre = drain.centre};
    for (int k = 0; k < 2; k++) {
        f.marks[k] = drain.positions[drain.marks[k]];
    }
    set_directions(&f, vec3_neg(observed->into_tissue));
    return f;
}

static vec3 position_at_rest(const scene_drain_info *drain, uint32_t node)
{
    return vec3_add(drain->centre, quat_rotate(drain->orientation, drain->rest_positions[node]));
}

/* Of the drain that nothing drags along. */
static task_frame read_frame_at_rest(const session_object *s)
{
    const scene_drain_info drain = read_drain(s);
    task_frame f = {.slit = vec3_lerp(position_at_rest(&drain, drain.slit_middle[0]),
                                      position_at_rest(&drain, drain.slit_middle[1]), 0.5),
                    .centre = drain.centre};
    for (int k = 0; k < 2; k++) {
        f.marks[k] = position_at_rest(&drain, drain.marks[k]);
    }
    set_directions(&f, vec3_sub(f.slit, f.centre));
    return f;
}

/* Unit vector from a mark into the wall. */
static vec3 into_wall(const task_frame *f, uint32_t mark)
{
    vec3 axis = vec3_cross(f->across, f->up), out = vec3_sub(f->marks[mark], f->centre);
    return vec3_neg(vec3_unit_or(vec3_add_scaled(out, -vec3_dot(out, axis), axis), f->up));
}

/* Unit vector to the side of a hand. */
static vec3 own_side(const task_frame *f, uint32_t hand)
{
    return hand == VBSS_METRICS_TOOL_LEFT ? vec3_neg(f->across) : f->across;
}

double vbss_session_mark_distance(const session_object *s, uint32_t mark)
{
    const scene_needle_info needle = read_needle(s);
    const scene_drain_info drain = read_drain(s);
    return vec3_distance(point_on_needle(&needle, 0.0), drain.positions[drain.marks[mark]]);
}

uint32_t vbss_session_mark_of(const session_object *s, uint32_t hand, uint32_t side)
{
    uint32_t entry =
        s->holes[SESSION_ENTRY].id != 0 ? s->holes[SESSION_ENTRY].mark : (uint32_t)(hand == 1);
    return side == SESSION_ENTRY ? entry : 1 - entry;
}

/* ---- tools and thread */

/* Unit vector in which the jaws of a tool point. */
static vec3 jaw_direction(const session_object *s, uint32_t tool)
{
    const scene_body_info body = vbss_scene_inspect_body(s->scene, session_tool_number(s, tool));
    const scene_grasper_info g = vbss_scene_inspect_grasper(body.grasper);
    return quat_rotate(g.pose.orientation, g.forward);
}

/* Distance from a point to the part of the jaws that grasps. */
static double distance_from_jaws(const session_object *s, const session_observation *observed,
                                 uint32_t tool, vec3 point)
{
    vec3 tip = observed->tools[tool].tip, back = vec3_neg(jaw_direction(s, tool));
    double along = vec3_dot(vec3_sub(point, tip), back);
    along = vbss_min(vbss_max(along, 0.0), SESSION_JAW_REACH);
    return vec3_distance(point, vec3_add_scaled(tip, along, back));
}

typedef struct thread_point {
    vec3 position, direction; /* m; unit, away from the needle */
} thread_point;

static thread_point point_on_thread(const session_object *s, const session_observation *observed,
                                    double arc)
{
    const scene_thread_info t =
        vbss_scene_inspect_thread(vbss_scene_inspect_body(s->scene, observed->thread).thread);
    uint32_t segment = 0;
    while (segment + 2 < t.node_count && arc > t.rest_lengths[segment]) {
        arc -= t.rest_lengths[segment++];
    }
    double fraction = vbss_min(vbss_max(arc / t.rest_lengths[segment], 0.0), 1.0);
    vec3 from = t.positions[segment], to = t.positions[segment + 1];
    return (thread_point){vec3_lerp(from, to, fraction),
                          vec3_unit_or(vec3_sub(to, from), vec3_make(0.0, 0.0, 1.0))};
}

vec3 vbss_session_thread_position(const session_object *s, const session_observation *observed,
                                  double arc)
{
    return point_on_thread(s, observed, arc).position;
}

/* ---- parts of a description */

static void set_point(vbss_session_coaching *c, vec3 point)
{
    vec3_store(c->point, point);
    c->geometry |= (uint32_t)VBSS_SESSION_GEOMETRY_POINT;
}

static void set_direction(vbss_session_coaching *c, vec3 direction)
{
    vec3_store(c->direction, direction);
    c->geometry |= (uint32_t)VBSS_SESSION_GEOMETRY_DIRECTION;
}

static void set_arc(vbss_session_coaching *c, vec3 centre, vec3 axis, vec3 start, double radius,
                    double angle)
{
    vec3_store(c->arc_centre, centre);
    vec3_store(c->arc_axis, axis);
    vec3_store(c->arc_start, start);
    c->arc_radius = radius;
    c->arc_angle = vbss_max(angle, 0.0);
    c->geometry |= (uint32_t)VBSS_SESSION_GEOMETRY_ARC;
}

/* The needle's own arc from its tip on. */
static void set_needle_arc(vbss_session_coaching *c, const scene_needle_info *needle, double angle)
{
    set_arc(c, needle->pose.position, needle_axis(needle), point_on_needle(needle, 0.0),
            needle->arc_radius, angle);
}

static double angle_between(vec3 a, vec3 b)
{
    return vbss_acos(vbss_min(vbss_max(vec3_dot(a, b), -1.0), 1.0));
}

/* ---- goals of the needle */

static void describe_taking(const session_object *s, const session_observation *observed,
                            uint32_t hand, double arc_length, vbss_session_coaching *c)
{
    const scene_needle_info needle = read_needle(s);
    vec3 point = point_on_needle(&needle, arc_length), axis = needle_axis(&needle);
    vec3 jaws = jaw_direction(s, hand);
    vec3 direction = vec3_dot(axis, jaws) < 0.0 ? vec3_neg(axis) : axis;
    set_point(c, point);
    set_direction(c, direction);
    c->distance = distance_from_jaws(s, observed, hand, point);
    c->angle = angle_between(jaws, direction);
}

/* Where a hand takes the needle from the other one. */
static double hand_over_arc(const session_object *s, const session_observation *observed,
                            uint32_t hand)
{
    double length = read_needle(s).length;
    if (s->throw_count == 0) { /* it goes back to the hand that winds first */
        return SESSION_HOLD_RATIO * length;
    }
    double held = vbss_session_needle_arc(s, observed->tools[1 - hand].tip);
    return length * (held < SESSION_HAND_OVER_LIMIT * length ? SESSION_HAND_OVER_TIP_RATIO
                                                             : SESSION_HAND_OVER_RATIO);
}

static void describe_entry(const session_object *s, const session_observation *observed,
                           session_goal goal, vbss_session_coaching *c)
{
    const scene_needle_info needle = read_needle(s);
    const task_frame f = read_frame(s, observed);
    vec3 tip_direction = quat_rotate(needle.pose.orientation, vec3_make(0.0, 1.0, 0.0));
    c->number = vbss_session_mark_of(s, goal.tool, SESSION_ENTRY);
    set_point(c, f.marks[c->number]);
    set_direction(c, into_wall(&f, c->number));
    if (goal.goal == VBSS_SESSION_GOAL_PIERCE) {
        set_needle_arc(c, &needle, 0.5 * needle.arc);
    }
    c->distance = vec3_distance(point_on_needle(&needle, 0.0), f.marks[c->number]);
    c->angle = angle_between(tip_direction, into_wall(&f, c->number));
}

static void describe_drive(const session_object *s, const session_observation *observed,
                           session_goal goal, vbss_session_coaching *c)
{
    const scene_needle_info needle = read_needle(s);
    const task_frame f = read_frame(s, observed);
    c->number = vbss_session_mark_of(s, goal.tool, SESSION_EXIT);
    vec3 mark = f.marks[c->number], local = pose_apply_inverse(needle.pose, mark);
    double angle = angle_on_needle(&needle, mark);
    angle += angle < -0.5 * VBSS_PI ? VBSS_TWO_PI : 0.0; /* just behind the tip it is passed */
    double off_radius = sqrt(local.x * local.x + local.y * local.y) - needle.arc_radius;
    set_point(c, mark);
    set_needle_arc(c, &needle, angle);
    c->angle = c->arc_angle;
    c->distance = vec3_distance(point_on_needle(&needle, 0.0), mark);
    c->offset = sqrt(off_radius * off_radius + local.z * local.z);
}

/* The needle turns on along its arc: until its tip can be taken, or until all of it is out. */
static void describe_turning(const session_object *s, const session_observation *observed,
                             session_goal goal, vbss_session_coaching *c)
{
    const scene_needle_info needle = read_needle(s);
    const session_hole_observation *out =
        vbss_session_find_hole(observed, s->holes[SESSION_EXIT].id);
    double length = out != NULL ? out->distance_from_tip : 0.0;
    double end = goal.goal == VBSS_SESSION_GOAL_EXPOSE_TIP ? SESSION_TIP_OUT : needle.length;
    c->length = vbss_max(end - length, 0.0);
    set_needle_arc(c, &needle, c->length / needle.arc_radius);
}

static void describe_drawing(const session_object *s, const session_observation *observed,
                             vbss_session_coaching *c)
{
    const task_frame f = read_frame(s, observed);
    const session_hole_observation *out =
        vbss_session_find_hole(observed, s->holes[SESSION_EXIT].id);
    set_point(c, out != NULL ? out->position : f.slit);
    set_direction(c, f.up);
    c->length = vbss_max(s->tail_length - s->config.tail_high, 0.0);
}

/* The tail is taken beside its hole, and drawn out along itself. */
static void describe_lengthening(const session_object *s, const session_observation *observed,
                                 uint32_t hand, vbss_session_coaching *c)
{
    const double end = observed->thread_length;
    const thread_point p =
        point_on_thread(s, observed, vbss_min(end - s->tail_length + SESSION_TAIL_ROOT, end));
    set_point(c, p.position);
    set_direction(c, p.direction);
    c->distance = distance_from_jaws(s, observed, hand, p.position);
    c->length = vbss_max(s->config.tail_low - s->tail_length, 0.0);
}

/* ---- goals of the throws */

/* Of the tip of the tool that is wound about. What is left of the limb to wind limits the height, and from a low place the path to the
 * tail is short. */
static vec3 winding_place(const session_object *s, const session_observation *observed,
                          const task_frame *rest, vec3 inward)
{
    static const double beyond[] = {SESSION_WIND_BEYOND, SESSION_WIND_BEYOND_SECOND,
                                    SESSION_WIND_BEYOND_THIRD};
    const double room = vbss_session_limb_length(s, observed) - SESSION_WIND_ROOM;
    const double height = vbss_min(vbss_max(room, SESSION_WIND_LOW), SESSION_WIND_HIGH);
    const uint32_t number = vbss_session_next_throw(s);
    return vec3_add_scaled(vec3_add_scaled(rest->slit, beyond[number < 2 ? number : 2], inward),
                           height, rest->up);
}

static void describe_winding(const session_object *s, const session_observation *observed,
                             session_goal goal, vbss_session_coaching *c)
{
    const task_frame f = read_frame_at_rest(s);
    uint32_t loop = 1 - goal.tool;
    double sign = vbss_session_wanted_sign(s);
    vec3 tip = observed->tools[loop].tip, back = vec3_neg(jaw_direction(s, loop));
    vec3 inward = vec3_neg(own_side(&f, loop));
    vec3 centre = vec3_add_scaled(tip, SESSION_WIND_BEHIND, back);
    const scene_needle_info needle = read_needle(s);
    vec3 from = vec3_sub(point_on_needle(&needle, needle.length), centre);
    from = vec3_add_scaled(from, -vec3_dot(from, back), back);
    double radius = vbss_session_wind_radius(s, observed, loop, centre, vec3_norm(from), false);
    vec3 start = vec3_add_scaled(centre, radius, vec3_unit_or(from, vec3_any_normal(back)));
    c->number = vbss_session_next_throw(s);
    double wanted = vbss_session_wanted_wraps(s) + SESSION_TURNS_BEYOND;
    c->turns = vbss_max(wanted - sign * s->coach.turns[loop], 0.0);
    set_point(c, winding_place(s, observed, &f, inward));
    set_direction(c, inward);
    set_arc(c, centre, vec3_scale(back, sign), start, radius, VBSS_TWO_PI * c->turns);
    c->distance = vec3_distance(tip, vec3_load(c->point));
}

/* Whether the drain lies over a place, or so much beside it, m. */
static bool is_under_drain(const task_frame *f, vec3 position, double reach)
{
    const vec3 from = vec3_sub(position, f->centre);
    return vec3_dot(from, f->up) < 0.0 && fabs(vec3_dot(from, f->across)) < reach;
}

/* Near the end of the tail; if that is under the drain, where jaws reach it beside the drain. */
static thread_point find_tail_hold(const session_object *s, const session_observation *observed)
{
    const task_frame f = read_frame(s, observed);
    const double end = observed->thread_length, radius = observed->drain_radius;
    const double limit = SESSION_TAIL_HOLD_MAX * s->config.tail_reach;
    const thread_point p = point_on_thread(s, observed, end - SESSION_TAIL_HOLD);
    thread_point q = p;
    double hold = SESSION_TAIL_HOLD;
    if (!is_under_drain(&f, p.position, radius)) {
        return p;
    }
    while (hold < limit && is_under_drain(&f, q.position, radius + SESSION_TAIL_CLEAR)) {
        hold += SESSION_TAIL_HOLD_STEP;
        q = point_on_thread(s, observed, end - hold);
    }
    return hold < limit ? q : p;
}

static void describe_tail(const session_object *s, const session_observation *observed,
                          session_goal goal, vbss_session_coaching *c)
{
    const thread_point p = find_tail_hold(s, observed);
    c->number = vbss_session_next_throw(s);
    set_point(c, p.position);
    set_direction(c, vec3_neg(p.direction));
    c->distance = distance_from_jaws(s, observed, goal.tool, p.position);
}

/* The path of the tail: from the jaws in an arc over the slit down to the side of the hand. There the arc ends, and the
 * direction remains. */
static void describe_tail_drawing(const session_object *s, const session_observation *observed,
                                  session_goal goal, vbss_session_coaching *c)
{
    const task_frame f = read_frame(s, observed);
    const vec3 own = own_side(&f, goal.tool),
               from = vec3_sub(observed->tools[goal.tool].tip, f.slit);
    const double along = vec3_dot(from, own), above = vec3_dot(from, f.up);
    double angle = vbss_atan2(above, along);
    angle += angle < -0.5 * VBSS_PI ? VBSS_TWO_PI : 0.0; /* low on the other side */
    c->number = vbss_session_next_throw(s);
    set_point(c, f.slit);
    set_direction(c, own);
    if (angle > 0.0) {
        const vec3 arm = vec3_add_scaled(vec3_scale(own, along), above, f.up);
        set_arc(c, f.slit, vec3_cross(f.up, own), vec3_add(f.slit, arm), vec3_norm(arm), angle);
    }
    c->turns = fabs(s->coach.turns[goal.tool]);
}

bool vbss_session_are_crossed(const session_object *s, const session_observation *observed,
                              uint32_t loop)
{
    const task_frame f = read_frame(s, observed);
    vec3 apart = vec3_sub(observed->tools[loop].tip, observed->tools[1 - loop].tip);
    return vec3_dot(apart, own_side(&f, loop)) < 0.0;
}

/* A throw that hangs loose over an open slit although it was pulled flat is pulled from behind, where the throw below was pulled from: it
 * runs down and draws that one tight. Hands that pull from there go on. If the throw below was pulled so, that is each hand's own side. */
bool vbss_session_pulls_from_behind(const session_object *s, const session_observation *observed,
                                    uint32_t loop)
{
    if (s->throw_count < 2 || (s->coach.from_behind >> (s->throw_count - 2) & 1u) != 0) {
        return false;
    }
    double stronger = vbss_max(observed->tension[0], observed->tension[1]);
    bool hangs_loose = (s->coach.open & 1ull << VBSS_SESSION_MISTAKE_SLACK) != 0 &&
                       s->time - s->coach.begun[VBSS_SESSION_MISTAKE_SLACK] > SESSION_LOOSE_TIME;
    bool is_open = observed->signed_gap > SESSION_OPEN_RATIO * s->config.seat_gap;
    return vbss_session_are_crossed(s, observed, loop) ? is_open || stronger >= s->config.seat_force
                                                       : is_open && hangs_loose;
}

static void describe_seat(const session_object *s, const session_observation *observed,
                          session_goal goal, vbss_session_coaching *c)
{
    const task_frame f = read_frame(s, observed);
    c->number = s->throw_count - 1;
    set_point(c, f.slit);
    const vec3 own = own_side(&f, goal.tool);
    bool from_behind = vbss_session_pulls_from_behind(s, observed, goal.tool);
    set_direction(c, from_behind ? vec3_neg(own) : own);
    c->geometry |= (uint32_t)VBSS_SESSION_GEOMETRY_PULL;
    c->pull_force = SESSION_PULL_RATIO * s->config.seat_force;
    double weaker = vbss_min(observed->tension[0], observed->tension[1]);
    c->force = vbss_max(c->pull_force - weaker, 0.0);
    c->length = vbss_max(observed->signed_gap - s->config.seat_gap, 0.0);
}

static void describe_cut(const session_object *s, const session_observation *observed,
                         session_goal goal, vbss_session_coaching *c)
{
    c->number = (s->cut_limbs & 1u) == 0 ? SESSION_ENTRY : SESSION_EXIT;
    const session_hole_observation *hole = vbss_session_find_hole(observed, s->holes[c->number].id);
    double root = s->knot.is_located ? s->knot.end_arcs[c->number] : hole != NULL ? hole->arc : 0.0;
    double sign = c->number == SESSION_ENTRY ? 1.0 : -1.0;
    const thread_point p = point_on_thread(s, observed, root + sign * SESSION_CUT_LENGTH);
    uint32_t tool = goal.tool < SESSION_HANDS ? goal.tool : SESSION_HANDS;
    set_point(c, p.position);
    set_direction(c, vec3_scale(p.direction, sign));
    c->distance = distance_from_jaws(s, observed, tool, p.position);
}

/* ---- all goals */

void vbss_session_describe_goal(const session_object *s, const session_observation *observed,
                                session_goal goal, vbss_session_coaching *coaching)
{
    switch (goal.goal) {
    case VBSS_SESSION_GOAL_TAKE_NEEDLE:
        describe_taking(s, observed, goal.tool, SESSION_HOLD_RATIO * read_needle(s).length,
                        coaching);
        break;
    case VBSS_SESSION_GOAL_REACH_MARK:
    case VBSS_SESSION_GOAL_PIERCE:
        describe_entry(s, observed, goal, coaching);
        break;
    case VBSS_SESSION_GOAL_DRIVE:
        describe_drive(s, observed, goal, coaching);
        break;
    case VBSS_SESSION_GOAL_TAKE_TIP:
        describe_taking(s, observed, goal.tool, SESSION_TIP_HOLD, coaching);
        break;
    case VBSS_SESSION_GOAL_EXPOSE_TIP:
    case VBSS_SESSION_GOAL_DRAW_NEEDLE:
        describe_turning(s, observed, goal, coaching);
        break;
    case VBSS_SESSION_GOAL_DRAW_THREAD:
        describe_drawing(s, observed, coaching);
        break;
    case VBSS_SESSION_GOAL_LENGTHEN_TAIL:
        describe_lengthening(s, observed, goal.tool, coaching);
        break;
    case VBSS_SESSION_GOAL_WIND:
        describe_winding(s, observed, goal, coaching);
        break;
    case VBSS_SESSION_GOAL_TAKE_TAIL:
        describe_tail(s, observed, goal, coaching);
        break;
    case VBSS_SESSION_GOAL_DRAW_TAIL:
        describe_tail_drawing(s, observed, goal, coaching);
        break;
    case VBSS_SESSION_GOAL_SEAT:
        describe_seat(s, observed, goal, coaching);
        break;
    case VBSS_SESSION_GOAL_HAND_OVER:
        coaching->number = s->throw_count > 0 ? s->throw_count - 1 : 0;
        describe_taking(s, observed, goal.tool, hand_over_arc(s, observed, goal.tool), coaching);
        break;
    case VBSS_SESSION_GOAL_CUT:
        describe_cut(s, observed, goal, coaching);
        break;
    case VBSS_SESSION_GOAL_RELEASE_NEEDLE:
    case VBSS_SESSION_GOAL_RELEASE_TAIL:
        set_point(coaching, observed->tools[goal.tool].tip);
        break;
    default:
        break;
    }
}
