/* FOLLOW: while a throw is tied, the tool of a hand that rests follows the other one, for inputs that move one tool at a time. While the ends
 * are pulled or slackened it moves opposite to the other one; while jaws with turns on them move, the needle goes along, so that the limb
 * stays as long from the slit over the jaws to the needle. */
#include "session/session.h"
#include "session/tuning.h"

typedef struct follow_step {
    const session_object *s;
    const session_observation *observed;
    session_aided_hand *hand; /* that follows */
    uint32_t number;          /* its */
    vec3 slit, up;            /* its middle; unit: out of the tissue */
    pose from, to;            /* of the other tool */
} follow_step;

static bool holds_needle(const session_object *s, uint32_t hand)
{
    return (s->holding_tools.value >> hand & 1u) != 0;
}

static bool holds_thread(const session_object *s, uint32_t hand)
{
    return (s->coach.holding_thread >> hand & 1u) != 0;
}

static bool is_goal(const session_object *s, vbss_session_goal goal)
{
    return vbss_session_current_goal(s).goal == goal;
}

/* ---- along */

static bool goes_along(const follow_step *f)
{
    uint32_t loop = 1 - f->number;
    bool is_wound =
        is_goal(f->s, VBSS_SESSION_GOAL_TAKE_TAIL)
            ? !holds_thread(f->s, loop)
            : is_goal(f->s, VBSS_SESSION_GOAL_DRAW_TAIL) && vbss_session_next_throw(f->s) > 0;
    return is_wound && holds_needle(f->s, f->number) && !holds_needle(f->s, loop) &&
           fabs(f->s->coach.turns[loop]) > SESSION_WOUND_TURNS;
}

/* Where the turns lie on the other tool. */
static vec3 neck_of(const follow_step *f, pose tip)
{
    const vbss_grasper *tool =
        vbss_scene_inspect_body(f->s->scene, f->s->config.tools[1 - f->number]).grasper;
    vec3 forward = vbss_scene_inspect_grasper(tool).forward;
    return vec3_add_scaled(tip.position, -SESSION_WIND_BEHIND,
                           quat_rotate(tip.orientation, forward));
}

/* The needle stays in the direction from the jaws that it has when they begin to go. */
static void go_along(const follow_step *f)
{
    session_aided_hand *a = f->hand;
    vec3 from = neck_of(f, f->from), to = neck_of(f, f->to);
    vec3 end = pose_apply(a->free, vbss_session_thread_end(f->s, f->number));
    vec3 arm = vec3_sub(end, from);
    if (a->limb_length == 0.0) {
        a->limb_length = vec3_distance(from, f->slit) + vec3_norm(arm) - SESSION_FOLLOW_SLACK;
        /* A limb that leads down would sweep the tail. */
        double low = SESSION_FOLLOW_RISE * vec3_norm(arm) - vec3_dot(arm, f->up);
        a->arm = vec3_unit_or(vec3_add_scaled(arm, vbss_max(low, 0.0), f->up), f->up);
    }
    if (f->observed->needle_pull > SESSION_FOLLOW_LIGHT) { /* taut all the same: nearer */
        a->limb_length -= vec3_distance(from, to);
    }
    double length = vbss_max(a->limb_length - vec3_distance(to, f->slit), SESSION_FOLLOW_NEAREST);
    arm = vec3_scale(a->arm, length);
    double low = SESSION_FOLLOW_CLEAR - vec3_dot(vec3_sub(vec3_add(to, arm), f->slit), f->up);
    arm = vec3_add_scaled(arm, vbss_max(low, 0.0), f->up); /* over the drain, not through it */
    vec3 by = vec3_sub(vec3_add_scaled(to, length, vec3_unit_or(arm, f->up)), end);
    double limit = SESSION_FOLLOW_FASTEST * vec3_distance(from, to), size = vec3_norm(by);
    a->free.position = vec3_add_scaled(a->free.position, size > limit ? limit / size : 1.0, by);
}

/* ---- opposite */

static bool goes_opposite(const follow_step *f)
{
    const session_object *s = f->s;
    bool pulls = is_goal(s, VBSS_SESSION_GOAL_SEAT) || is_goal(s, VBSS_SESSION_GOAL_RELEASE_TAIL);
    uint32_t limb = holds_needle(s, 0) ? 0 : 1;
    return pulls && holds_needle(s, limb) && !holds_needle(s, 1 - limb) &&
           holds_thread(s, 1 - limb);
}

/* Mean tension of the thread beside a tool: a tied throw keeps some in the limbs beside the stitch. */
static double felt_tension(const follow_step *f, uint32_t hand)
{
    const session_observation *o = f->observed;
    const vbss_thread *thread = vbss_scene_inspect_body(f->s->scene, o->thread).thread;
    if (thread == NULL) {
        return 0.0;
    }
    const scene_thread_info t = vbss_scene_inspect_thread(thread);
    double held = o->tools[hand].held_arc >= 0.0 ? o->tools[hand].held_arc : t.length;
    double end = holds_needle(f->s, hand) ? SESSION_PULL_SPAN : held;
    double arc = 0.0, sum = 0.0, span = 0.0;
    for (uint32_t i = 0; i + 1 < t.node_count && arc < end; i++) {
        double length = arc > end - SESSION_PULL_SPAN ? t.rest_lengths[i] : 0.0;
        sum += length * t.tensions[i];
        span += length;
        arc += t.rest_lengths[i];
    }
    return span > 0.0 ? vbss_max(sum / span, 0.0) : 0.0;
}

/* Of the movement: less for the end that bears more while both are pulled, until it gives way, and more while both give way. */
static double find_share(const follow_step *f, vec3 moved)
{
    double own = felt_tension(f, f->number), other = felt_tension(f, 1 - f->number);
    bool pulls = vec3_dot(moved, vec3_sub(f->from.position, f->slit)) > 0.0;
    double unlike = pulls ? other - own : own - other;
    unlike /=
        vbss_min(SESSION_FOLLOW_UNLIKE_SLACK + 0.3 * vbss_min(own, other), SESSION_FOLLOW_UNLIKE);
    double limit = pulls && other < SESSION_FOLLOW_LIGHT ? 0.0 : 2.0; /* slack is taken up alone */
    return vbss_min(vbss_max(1.0 + unlike, pulls ? -1.0 : 0.0), limit);
}

/* At the same height: the tail's tool is near the floor. */
static void go_opposite(const follow_step *f)
{
    vec3 moved = vec3_sub(f->to.position, f->from.position), before = f->hand->free.position;
    vec3 by = vec3_add_scaled(vec3_neg(moved), vec3_dot(moved, f->up), f->up);
    vec3 place = vec3_add_scaled(before, find_share(f, moved), by);
    double far = vec3_distance(place, f->slit);
    if (far < SESSION_FOLLOW_FARTHEST || far < vec3_distance(before, f->slit)) {
        f->hand->free.position = place;
    }
}

/* ---- a step */

void vbss_session_follow(session_object *s, uint32_t number, double h, bool rests, vec3 slit,
                         vec3 up)
{
    session_aided_hand *a = &s->assistance.hands[number];
    const session_aided_hand *other = &s->assistance.hands[1 - number];
    bool is_on = (s->assistance.set.aids & (uint32_t)VBSS_SESSION_AID_FOLLOW) != 0;
    const follow_step f = {s, &s->observation, a, number, slit, up, a->other, other->free};
    bool knew_other = a->knows_other != 0;
    a->other = other->free;
    a->knows_other = is_on && other->is_relative != 0;
    a->still_time = rests && is_on ? a->still_time + h : 0.0;
    bool follows = a->still_time >= SESSION_FOLLOW_REST && knew_other && a->knows_other != 0;
    if (!follows || !goes_along(&f)) {
        a->limb_length = 0.0;
    }
    if (!follows || other->still_time >= SESSION_FOLLOW_REST) {
        return;
    }
    if (!goes_along(&f) && !goes_opposite(&f)) {
        return;
    }
    vbss_session_observe(s, &s->observation); /* the step does it once more */
    if (s->observation.has_lost_body) {
        return;
    }
    if (goes_along(&f)) {
        go_along(&f);
    } else {
        go_opposite(&f);
    }
}
