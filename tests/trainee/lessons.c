#include "trainee/trainee.h"

#include <math.h>

#define ABOVE 12e-3 /* m, above the thing to take */

enum { PUSHES = 15 }; /* through a wall that another tool supports already */

/* The coach gives the place; how the jaws have to be rolled he does not say, so they are tried. */
void lesson_take_needle(trainee *t)
{
    static const double rolls[] = {0.0, 0.8, 0.8, 0.8};
    (void)trainee_finish_motion(t);
    for (int i = 0; i < 8; i++) {
        const sight now = *trainee_see(t), *s = &now;
        vec at = v_load(s->coach.point);
        trainee_say(t, "over it");
        if (s->coach.goal != VBSS_SESSION_GOAL_TAKE_NEEDLE || !trainee_jaws(t, RIGHT, false) ||
            !trainee_roll(t, RIGHT, rolls[i % 4]) ||
            !trainee_go(t, RIGHT, v_add(at, v3(0.0, 0.0, ABOVE)), 1e-3) ||
            !trainee_go(t, RIGHT, at, 0.5e-3) || !trainee_jaws(t, RIGHT, true)) {
            break;
        }
        trainee_say(t, "closed");
        if (trainee_see(t)->has_needle[RIGHT]) {
            break;
        }
        if (!trainee_jaws(t, RIGHT, false) || !trainee_move(t, RIGHT, v3(0.0, 0.0, ABOVE))) {
            break;
        }
    }
    (void)(trainee_move(t, RIGHT, v3(0.0, 0.0, 20e-3)) && trainee_wait(t, 100));
}

/* The tip before the mark. False: the exercise has ended. */
static bool bring_tip(trainee *t)
{
    for (int i = 0; i < 12; i++) {
        const sight now = *trainee_see(t), *s = &now;
        vec to =
            v_sub(v_along(v_load(s->coach.point), -0.8e-3, v_load(s->coach.direction)), s->needle);
        trainee_say(t, "to the mark");
        if (v_length(to) < 0.35e-3) {
            return true;
        }
        if (!trainee_move(t, RIGHT, to)) {
            return false;
        }
    }
    return true;
}

/* The jaws lie square to the needle, so their roll turns it in its plane. Which sense is right shows in the angle of the coach. */
bool lesson_turn_square(trainee *t)
{
    double sign = 1.0, before = trainee_see(t)->coach.angle;
    for (int i = 0; i < 4 && before > 0.12; i++) {
        if (!trainee_roll(t, RIGHT, sign * before)) {
            return false;
        }
        double now = trainee_see(t)->coach.angle;
        sign = now > before ? -sign : sign;
        before = now;
    }
    trainee_say(t, "turned");
    return true;
}

/* Straight through the wall, as the coach says, and back to the mark when the tip slides along the wall; then the aid keeps the
 * needle on its arc. */
bool lesson_pierce(trainee *t, int pushes)
{
    bool is_at = lesson_turn_square(t) && bring_tip(t);
    for (int i = 0; i < pushes && is_at; i++) {
        const sight now = *trainee_see(t), *s = &now;
        vec in = v_load(s->coach.direction);
        vec aside = v_sub(v_load(s->coach.point), s->needle);
        aside = v_along(aside, -v_dot(aside, in), in);
        trainee_say(t, "push");
        if (s->coach.goal != VBSS_SESSION_GOAL_PIERCE &&
            s->coach.goal != VBSS_SESSION_GOAL_REACH_MARK) {
            break;
        }
        is_at = v_length(aside) > 0.9e-3
                    ? trainee_move(t, RIGHT, v_scale(-3e-3, in)) && bring_tip(t)
                    : trainee_move(t, RIGHT, v_along(aside, 1.2e-3, in));
    }
    return is_at;
}

void lesson_pass_mark(trainee *t)
{
    (void)trainee_finish_motion(t);
    if (!lesson_pierce(t, PUSHES) || !trainee_aid(t, VBSS_SESSION_AID_ARC)) {
        return;
    }
    for (int i = 0; i < 20 && trainee_move(t, RIGHT, v3(-2e-3, 0.0, 0.0)); i++) {
        trainee_say(t, "drive");
    }
}
