/* The whole task by the scripted trainee: what the coach asks for next is done next. */
#include "trainee/trainee.h"

#include <stdio.h>

#define OFFERED 40e-3 /* m, beside the slit, */
#define HIGH 60e-3    /* and above it */
#define OVER 25e-3    /* higher still: over the needle that the other hand has on this one's side */

enum { LONGEST = 400 }; /* goals and repeats of them */
enum { PUSHES = 5 };    /* after these the wall needs its support again */

/* A hand that holds the needle while the other one comes. */
static double lean_of(const trainee *t, int side)
{
    return trainee_see(t)->has_needle[1 - side] ? 0.3 : 0.0;
}

/* The needle is held up on its own side, or where it is after a pull from behind, with its thread slack, and the other hand comes over the drain, not through it. */
static bool hand_over(trainee *t, int side)
{
    double own = (side == LEFT) != t->is_crossed ? 1.0 : -1.0;
    bool is_tied = t->slit.z != 0.0, good = true;
    if (is_tied) {
        good = trainee_go(t, 1 - side, v3(own * OFFERED, -15e-3, HIGH), 10e-3);
    } else if (trainee_see(t)->needle.z < 20e-3) {
        good = lesson_lift(t, 1 - side);
    }
    double low = HIGH + (t->is_crossed ? OVER : 0.0) - trainee_see(t)->tip[side].z;
    if (good && low > 5e-3) {
        good = trainee_move(t, side, v3(0.0, 0.0, low));
    }
    return good && lesson_take(t, side, lean_of(t, side));
}

/* The slit has opened while the shears were taken: they would cut the tail that the coach asks for. The coach does not say that. */
static bool put_shears_back(trainee *t, int side)
{
    vbss_session_goal goal = trainee_see(t)->coach.goal;
    if (!trainee_see(t)->shears[side] || goal == VBSS_SESSION_GOAL_TAKE_SHEARS ||
        goal == VBSS_SESSION_GOAL_CUT) {
        return true;
    }
    trainee_say(t, "no shears");
    return lesson_park(t, side) && trainee_jaws(t, side, true) && trainee_exchange(t, side);
}

/* False: the task has ended. */
static bool follow(trainee *t, int side)
{
    if (!put_shears_back(t, side)) {
        return false;
    }
    switch (trainee_see(t)->coach.goal) {
    case VBSS_SESSION_GOAL_TAKE_NEEDLE:
        return lesson_take(t, side, 0.0);
    case VBSS_SESSION_GOAL_REACH_MARK:
    case VBSS_SESSION_GOAL_PIERCE:
        t->entry = v_load(trainee_see(t)->coach.point);
        return lesson_reach_mark(t, side) && lesson_pierce(t, PUSHES);
    case VBSS_SESSION_GOAL_DRIVE:
        return lesson_drive(t, side);
    case VBSS_SESSION_GOAL_EXPOSE_TIP:
        return lesson_turn_on(t, side);
    case VBSS_SESSION_GOAL_DRAW_NEEDLE:
        return lesson_draw_needle(t, side);
    case VBSS_SESSION_GOAL_TAKE_TIP:
        return lesson_take(t, side, lean_of(t, side));
    case VBSS_SESSION_GOAL_HAND_OVER:
        return hand_over(t, side);
    case VBSS_SESSION_GOAL_RELEASE_NEEDLE:
        return lesson_leave(t, side) && lesson_park(t, side);
    case VBSS_SESSION_GOAL_RELEASE_TAIL:
        return lesson_release_tail(t, side);
    case VBSS_SESSION_GOAL_DRAW_THREAD:
        return lesson_draw_thread(t, side);
    case VBSS_SESSION_GOAL_LENGTHEN_TAIL:
        return lesson_lengthen_tail(t, side);
    case VBSS_SESSION_GOAL_TAKE_SHEARS:
    case VBSS_SESSION_GOAL_CUT:
        lesson_cut(t);
        return trainee_wait(t, 1);
    default:
        return lesson_throw_part(t) && trainee_wait(t, 1);
    }
}

void lesson_whole_task(trainee *t)
{
    (void)trainee_finish_motion(t);
    vbss_session_goal before = trainee_see(t)->coach.goal;
    for (int i = 0; i < LONGEST && trainee_phase(t) < t->until; i++) {
        const vbss_session_coaching *c = &trainee_see(t)->coach;
        int side = c->tool == VBSS_METRICS_TOOL_LEFT ? LEFT : RIGHT;
        if (c->goal != before) {
            before = c->goal;
            trainee_save(t);
        }
        trainee_say(t, "task");
        if (!follow(t, side) || !trainee_wait(t, 5)) {
            return;
        }
    }
}
