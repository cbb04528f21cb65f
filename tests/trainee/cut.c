#include "trainee/trainee.h"

#include <math.h>

#define ABOVE 12e-3 /* m, above the thing to cut */
/* m, from the tip of the blades to the thread: closing blades lose a thread that is nearer. The tail lies on the drain, which
 * the blades would push away. */
#define THREAD_IN_BLADES 2.5e-3
#define TAIL_IN_BLADES 1.2e-3
#define DEEPER 0.8e-3     /* m, at each further try */
#define FARTHER 2e-3      /* m, from the knot, at each try after those */
#define BESIDE 1.5e-3     /* m, along the thread: so far off is good enough */
#define UPRIGHT 0.6       /* rise of the needle's thread where it is cut, for each metre of it */
#define STEEP 0.3         /* fall of blades, at least, of their level length */
#define LIFT_TENSION 0.15 /* N */
#define LIFTED 3e-3       /* m at a time: a thread that is lifted too far opens the slit */

enum {
    LIFTS = 10, /* of the needle's thread, in all */
    TRIES =
        5 /* at the point of the coach: there the thread may lie so close to the drain that blades push both away */
};

/* Where the blades point so that they lie across the thread: else the knot is between them, too. From level blades the shaft would come to
 * the floor. */
static vec across_thread(vec jaws, vec thread)
{
    double flat = hypot(jaws.x, jaws.y);
    jaws = jaws.z > -STEEP * flat ? v_unit(v3(jaws.x, jaws.y, -flat)) : jaws;
    vec square = v_along(jaws, -v_dot(jaws, thread), thread), down = v3(0.0, 0.0, -1.0);
    return v_unit(v_length(square) > 0.5 ? square : v_along(down, -v_dot(down, thread), thread));
}

/* Open blades that touch the drain push it along, and the thread runs through them. */
static bool slide_along_thread(trainee *t, int side)
{
    const sight now = *trainee_see(t), *s = &now;
    vec along = v_load(s->coach.direction);
    double off = v_dot(v_sub(v_load(s->coach.point), s->tip[side]), along);
    if (s->coach.goal != VBSS_SESSION_GOAL_CUT || fabs(off) < BESIDE) {
        return true;
    }
    trainee_say(t, "along the thread");
    return trainee_move(t, side, v_scale(0.8 * off, along));
}

/* The needle's thread lies level, between drain and blades: the other hand lifts it. */
static bool lift_thread(trainee *t, int side, int *lifts)
{
    bool good = true;
    for (; *lifts < LIFTS && good; ++*lifts) {
        const sight now = *trainee_see(t), *s = &now;
        if (s->coach.goal != VBSS_SESSION_GOAL_CUT || s->coach.number == 0 || !s->holds[1 - side] ||
            s->coach.direction[2] > UPRIGHT || s->tension[1] > LIFT_TENSION) {
            break;
        }
        trainee_say(t, "lift the thread");
        good = trainee_move(t, 1 - side, v3(0.0, 0.0, LIFTED));
    }
    return good;
}

/* The point of the coach, or one that much farther from the slit. */
static vec place_of_cut(const trainee *t, double farther)
{
    vec at = v_load(trainee_see(t)->coach.point), along = v_load(trainee_see(t)->coach.direction);
    double outward = v_dot(along, v_sub(at, t->slit)) > 0.0 ? 1.0 : -1.0;
    return v_along(at, outward * farther, along);
}

/* One try; false: the exercise has ended. */
static bool try_cut(trainee *t, int side, double depth, double farther, int *lifts)
{
    bool good = lift_thread(t, side, lifts);
    const sight now = *trainee_see(t), *s = &now;
    vec at = place_of_cut(t, farther), thread = v_load(s->coach.direction);
    good = good && trainee_jaws(t, side, false) &&
           trainee_go(t, side, v_along(at, -2.0 * ABOVE, s->jaws[side]), 2e-3) &&
           trainee_turn(t, side, across_thread(trainee_see(t)->jaws[side], thread));
    vec along = trainee_see(t)->jaws[side];
    good = good && trainee_go(t, side, v_along(at, -2.0 * ABOVE, along), 2e-3) &&
           trainee_roll_across(t, side, thread) &&
           trainee_go(t, side, v_along(at, -ABOVE, along), 1e-3);
    at = place_of_cut(t, farther);
    return good && trainee_go(t, side, v_along(at, depth, along), 0.6e-3) &&
           (farther > 0.0 || slide_along_thread(t, side)) &&
           (trainee_see(t)->coach.goal != VBSS_SESSION_GOAL_CUT || trainee_jaws(t, side, true));
}

/* The hand that the coach names opens, goes aside, takes shears, and cuts at the point of the coach. */
void lesson_cut(trainee *t)
{
    uint32_t limb = UINT32_MAX;
    double depth = 0.0;
    int lifts = 0, tries = 0;
    bool good = trainee_finish_motion(t);
    for (int i = 0; i < 30 && good; i++) {
        const sight now = *trainee_see(t), *s = &now;
        int side = s->coach.tool == VBSS_METRICS_TOOL_LEFT ? LEFT : RIGHT;
        trainee_say(t, "cut");
        if (s->coach.goal == VBSS_SESSION_GOAL_TAKE_SHEARS) {
            good = trainee_jaws(t, side, false) &&
                   trainee_go(t, side, v3(side == LEFT ? -0.06 : 0.06, -0.01, 0.06), 5e-3) &&
                   trainee_jaws(t, side, true) && trainee_exchange(t, side);
        } else if (s->coach.goal == VBSS_SESSION_GOAL_CUT) {
            const double first = s->coach.number == 0 ? TAIL_IN_BLADES : THREAD_IN_BLADES;
            const bool is_repeated = s->coach.number == limb;
            tries = is_repeated ? tries + 1 : 0;
            depth = is_repeated && tries < TRIES ? depth + DEEPER : first;
            limb = s->coach.number;
            good = try_cut(t, side, depth, FARTHER * fmax(tries - TRIES + 1, 0), &lifts);
        } else if (s->coach.goal == VBSS_SESSION_GOAL_RELEASE_TAIL) {
            good = lesson_release_tail(t, side);
        } else if (s->coach.goal == VBSS_SESSION_GOAL_SEAT ||
                   s->coach.goal == VBSS_SESSION_GOAL_TAKE_TAIL) {
            break; /* the slit has opened */
        } else {
            good = trainee_wait(t, 20);
        }
    }
}
