/* The needle in the whole task, by the words of the coach: taken, driven through both marks, passed from hand to hand, and drawn with its
 * thread. The coach says where; how the jaws are rolled follows from the needle as it is seen. */
#include "trainee/trainee.h"

#include <math.h>

#define BEFORE 20e-3    /* m, of the jaws from the needle along themselves, before they come; */
#define OFF_AGAIN 40e-3 /* after they have opened */
#define PARK 60e-3
#define OUTSIDE 12e-3 /* of the tip from the mark, before it comes to it */
#define LEAN 0.3      /* rad, of a tool away from the one that holds the needle */
#define STRIDE 2.5e-3 /* m, of the mouse while the needle is on its arc */
#define MISSES 0.7e-3 /* of the arc beside the mark: it is shifted */
#define LIFTED 12e-3  /* of the needle in the drain: from then on it is lifted, too */
#define LIFT 30e-3    /* of a needle that is out of the drain */
#define STICKS 0.12   /* N: the tail */
#define STUCK 1.2e-3  /* of a thread at a time that sticks */
#define DRAWN 20e-3   /* of the thread at a time */
#define UNDER 0.8e-3  /* m, from the mark to jaws in the wall's lee */
#define ASIDE 1.3e-3  /* along the drain */
#define BEYOND 1.8e-3 /* of their tips past the mark */
#define AHEAD 3e-3    /* of the tip to the second mark: the arc is not shifted any more */

static vec point_of(const trainee *t)
{
    return v_load(trainee_see(t)->coach.point);
}

static bool is_goal(const trainee *t, vbss_session_goal goal)
{
    return trainee_see(t)->coach.goal == goal;
}

/* ---- a needle is taken */

typedef struct seen_needle {
    vec centre, axis; /* of its circle */
} seen_needle;

/* The circle through its tip, the place that the coach shows, and the end with the thread. */
static seen_needle see_needle(const trainee *t)
{
    const sight *s = trainee_see(t);
    vec a = s->needle, ab = v_sub(point_of(t), a), ac = v_sub(s->swage, a), n = v_cross(ab, ac);
    vec up = v_add(v_scale(v_dot(ab, ab), v_cross(ac, n)), v_scale(v_dot(ac, ac), v_cross(n, ab)));
    return (seen_needle){v_along(a, 0.5 / v_dot(n, n), up), v_unit(n)};
}

/* Along the needle's axis, not from behind the drain, and not from below. */
static vec choose_direction(const trainee *t, double lean)
{
    vec d = v_load(trainee_see(t)->coach.direction);
    d = v_dot(d, v3(0.0, 1.0, -1.0)) < 0.0 ? v_scale(-1.0, d) : d;
    vec out = v_unit(v_across(v_sub(point_of(t), see_needle(t).centre), d));
    return v_unit(v_along(d, -lean, out));
}

static bool approach_needle(trainee *t, int side, vec direction)
{
    vec axis = v_load(trainee_see(t)->coach.direction);
    vec tangent = v_unit(v_cross(axis, v_sub(point_of(t), see_needle(t).centre)));
    return trainee_jaws(t, side, false) &&
           trainee_go(t, side, v_along(point_of(t), -2.0 * BEFORE, direction), 3e-3) &&
           trainee_turn(t, side, direction) && trainee_roll_across(t, side, tangent) &&
           trainee_go(t, side, v_along(point_of(t), -BEFORE, trainee_see(t)->jaws[side]), 1e-3) &&
           trainee_go(t, side, point_of(t), 0.5e-3) && trainee_jaws(t, side, true);
}

/* The tool that supports the wall comes out of the slit. */
static bool go_out(trainee *t, int helper)
{
    t->helps = false;
    for (int i = 0; i < 5; i++) {
        if (!trainee_move(t, helper, v_scale(-0.25 * BEFORE, trainee_see(t)->jaws[helper]))) {
            return false;
        }
    }
    return true;
}

bool lesson_take(trainee *t, int side, double lean)
{
    if (t->helps && !go_out(t, side)) {
        return false;
    }
    vbss_session_goal goal = trainee_see(t)->coach.goal;
    for (int i = 0; i < 6 && is_goal(t, goal) && !trainee_see(t)->has_needle[side]; i++) {
        bool good = approach_needle(t, side, choose_direction(t, lean));
        trainee_say(t, "closed on the needle");
        if (!good) {
            return false;
        }
        if (!trainee_see(t)->has_needle[side] &&
            !(trainee_jaws(t, side, false) &&
              trainee_move(t, side, v_scale(-BEFORE, trainee_see(t)->jaws[side])))) {
            return false;
        }
    }
    return trainee_wait(t, 10);
}

/* The jaws open and go back along themselves. */
bool lesson_leave(trainee *t, int side)
{
    return trainee_jaws(t, side, false) &&
           trainee_move(t, side, v_scale(-OFF_AGAIN, trainee_see(t)->jaws[side]));
}

/* To its own side, where no needle comes past. */
bool lesson_park(trainee *t, int side)
{
    return trainee_go(t, side, v3(side == LEFT ? -PARK : PARK, -30e-3, PARK), 8e-3);
}

/* ---- the other tool supports the wall beside the mark: closed, as open jaws are wider than the slit, and as a needle between them is
 * taken */

/* Down into the slit, from its own side. */
static vec into_slit(int helper)
{
    return v_unit(v3(helper == LEFT ? 0.84 : -0.84, 0.1, -0.54));
}

static bool prepare_help(trainee *t, int helper, vec tip, vec d)
{
    return trainee_go(t, helper, v_along(tip, -BEFORE, d), 1.5e-3) &&
           trainee_turn_well(t, helper, d) &&
           trainee_go(t, helper, v_along(tip, -BEFORE, d), 0.6e-3);
}

/* A long movement misses the slit. */
static bool go_in(trainee *t, int helper, vec tip, vec d)
{
    static const double left[] = {9e-3, 6e-3, 4e-3, 2e-3, 0.0};
    for (size_t i = 0; i < sizeof left / sizeof left[0]; i++) {
        if (!trainee_go(t, helper, v_along(tip, -left[i], d), 0.5e-3)) {
            return false;
        }
        trainee_say(t, "in");
    }
    return true;
}

/* In by the slit, and under its edge. */
static bool support_first(trainee *t, int helper)
{
    vec d = into_slit(helper), in = v_load(trainee_see(t)->coach.direction);
    vec tip = v_along(v_along(point_of(t), UNDER, in), BEYOND, d);
    tip.y += ASIDE;
    bool good = trainee_jaws(t, helper, true) && prepare_help(t, helper, tip, d) &&
                go_in(t, helper, tip, d);
    t->helps = true;
    trainee_say(t, "under the mark");
    return good;
}

/* ---- through the drain */

static bool go_outside(trainee *t, int side)
{
    for (int i = 0; i < 6; i++) {
        vec in = v_load(trainee_see(t)->coach.direction);
        vec to = v_sub(v_along(point_of(t), -OUTSIDE, in), trainee_see(t)->needle);
        if (v_length(to) < 2e-3) {
            break;
        }
        if (!trainee_move(t, side, to)) {
            return false;
        }
        trainee_say(t, "before the mark");
    }
    return true;
}

/* Turned at the wall, the needle would pierce it anywhere. */
static bool go_back(trainee *t, int side)
{
    vec in = v_load(trainee_see(t)->coach.direction);
    return v_distance(trainee_see(t)->needle, point_of(t)) > OUTSIDE ||
           trainee_move(t, side, v_scale(-OUTSIDE, in));
}

/* A needle from the floor becomes upright across the drain, with its tip outside the mark. */
bool lesson_reach_mark(trainee *t, int side)
{
    if (!go_back(t, side)) {
        return false;
    }
    if (trainee_see(t)->needle.z < -5e-3 && !trainee_move(t, side, v3(0.0, 0.0, LIFT))) {
        return false;
    }
    bool good = trainee_turn(t, side, v3(0.0, 1.0, 0.0)) && lesson_turn_square(t);
    good = good && support_first(t, 1 - side);
    for (int i = 0; i < 3 && good; i++) {
        good = go_outside(t, side);
        if (trainee_see(t)->coach.angle < 0.15) {
            break;
        }
        good = good && lesson_turn_square(t);
    }
    return good;
}

/* The centre of the needle's circle if it went through both marks, above them. */
static vec through_both(const vbss_session_coaching *c, vec entry)
{
    vec axis = v_load(c->arc_axis), exit = v_load(c->point);
    vec flat = v_across(v_sub(exit, entry), axis), middle = v_along(entry, 0.5, flat);
    double half = 0.5 * v_length(flat), r = c->arc_radius;
    vec up = v_unit(v_cross(axis, flat));
    up = up.z < 0.0 ? v_scale(-1.0, up) : up;
    vec centre = v_along(middle, sqrt(fmax(r * r - half * half, 0.0)), up);
    return v_along(centre, 0.5 * v_dot(v_sub(exit, entry), axis), axis);
}

/* Shifts the needle until the arc that the coach shows goes through the mark. */
static bool shift_arc(trainee *t, int side)
{
    for (int i = 0; i < 4 && is_goal(t, VBSS_SESSION_GOAL_DRIVE); i++) {
        const vbss_session_coaching *c = &trainee_see(t)->coach;
        vec by = v_sub(through_both(c, t->entry), v_load(c->arc_centre));
        trainee_say(t, "arc");
        if (c->offset < MISSES) {
            break;
        }
        if (!trainee_move(t, side, v_limit(by, 3e-3))) {
            return false;
        }
    }
    return true;
}

/* With the aid, until the coach has another goal, or the mark is near. */
static bool turn_on(trainee *t, int side, int strides, double near)
{
    vbss_session_goal goal = trainee_see(t)->coach.goal;
    bool good = trainee_aid(t, VBSS_SESSION_AID_ARC);
    for (int i = 0; i < strides && good && is_goal(t, goal); i++) {
        const vbss_session_coaching *c = &trainee_see(t)->coach;
        double left = c->arc_angle * c->arc_radius - near;
        if (goal == VBSS_SESSION_GOAL_DRIVE && left < 0.0) {
            break;
        }
        good = trainee_move(t, side, v3(-STRIDE, 0.0, 0.0));
        trainee_say(t, "drive");
    }
    return good && trainee_aid(t, VBSS_SESSION_AID_ARC);
}

bool lesson_drive(trainee *t, int side)
{
    bool good = turn_on(t, side, 2, AHEAD) && shift_arc(t, side);
    return good && turn_on(t, side, 6, -OUTSIDE);
}

bool lesson_turn_on(trainee *t, int side)
{
    return turn_on(t, side, 20, 0.0);
}

/* Its last part is lifted out as it turns: a whole turn of the needle does not fit beside the drain. */
bool lesson_draw_needle(trainee *t, int side)
{
    bool lifts = trainee_see(t)->coach.length < LIFTED;
    bool good = turn_on(t, side, 1, 0.0);
    if (lifts && good && is_goal(t, VBSS_SESSION_GOAL_DRAW_NEEDLE)) {
        good = trainee_move(t, side, v_scale(0.8 * STRIDE, v_unit(v3(-0.5, 0.0, 0.9))));
        trainee_say(t, "lifted");
    }
    return good;
}

/* ---- the thread */

bool lesson_lift(trainee *t, int side)
{
    return trainee_move(t, side, v3(0.0, 0.0, LIFT));
}

/* Away from the hole, less the nearer the tail is to its length. A tail that sticks under the drain is drawn little by little: when it
 * comes free, the drain springs back and draws it in. */
bool lesson_draw_thread(trainee *t, int side)
{
    const vbss_session_coaching *c = &trainee_see(t)->coach;
    vec away = v_unit(v3(side == LEFT ? -0.25 : 0.25, -0.2, 1.0));
    vec hole = point_of(t), tip = trainee_see(t)->tip[side];
    double reach = trainee_see(t)->tension[1] > STICKS ? STUCK : DRAWN;
    double far = v_distance(tip, hole) + fmin(0.7 * c->length + 0.7e-3, reach);
    bool good = trainee_move(t, side, v_limit(v_sub(v_along(hole, far, away), tip), 1.5 * reach));
    trainee_say(t, "drawn");
    return good;
}

/* The jaws come to the tail from above, beside its hole, open across it. */
static bool take_root(trainee *t, int side)
{
    vec d = v_unit(v3(side == LEFT ? 0.5 : -0.5, 0.1, -0.85)), at = point_of(t);
    return trainee_jaws(t, side, false) &&
           trainee_go(t, side, v_along(at, -2.0 * BEFORE, d), 3e-3) && trainee_turn(t, side, d) &&
           trainee_roll_across(t, side, v_load(trainee_see(t)->coach.direction)) &&
           trainee_go(t, side, v_along(point_of(t), -6e-3, d), 1e-3) &&
           trainee_go(t, side, v_along(point_of(t), 2e-3, d), 0.6e-3) &&
           trainee_jaws(t, side, true);
}

/* The needle's hand gives way first: a taut thread draws the stitch together. */
bool lesson_lengthen_tail(trainee *t, int side)
{
    vec slack = v_unit(v_sub(point_of(t), trainee_see(t)->tip[1 - side]));
    bool good = trainee_move(t, 1 - side, v_scale(BEFORE, slack));
    for (int i = 0; i < 5 && good && !trainee_see(t)->holds[side]; i++) {
        good = take_root(t, side);
        trainee_say(t, "closed on the tail");
    }
    for (int i = 0; i < 10 && good && is_goal(t, VBSS_SESSION_GOAL_LENGTHEN_TAIL); i++) {
        good = trainee_move(t, side, v_scale(STUCK, v_load(trainee_see(t)->coach.direction)));
        trainee_say(t, "drawn back");
    }
    return good;
}
