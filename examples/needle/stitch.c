/* What both hands do next: the right one takes the needle, brings it, and drives it through. */
#include "needle/stitch_parts.h"

#define HOLD 0.64    /* of the needle's length from its tip: where it is taken */
#define LEAN 0.14    /* of the tool from the needle's axis, away from the drain in the end, rad */
#define UP 1.92      /* to where, in the needle's plane, rad */
#define PRESS 0.5e-3 /* jaws into the floor, so that they are on it */
#define OVER 12e-3
#define OFF_FLOOR 3e-3 /* m, of the shaft */
#define BEFORE 5e-3    /* of the mark, where the needle is brought */
#define LONGEST 27e-3  /* of the way beyond the right mark */
#define OUT 8.5e-3     /* of the tip in the end */
#define ENOUGH 7e-3    /* of it, if the needle has gone as far as it goes, or drags */
#define DRAGS 3.0      /* N: the wall goes along with the needle that is in it; */
#define BACK_BY 2.5e-3 /* m, then */
#define LOCKED 4e-3    /* m, that the walls have gone along with the needle */
#define PATIENCE 8.0   /* s, of every state in the drain */
#define ON_WALL 0.4    /* s: after that time there the fork bears the left wall */
#define BUMPS \
    1.5 /* N: felt on the way to the mark, more than that means that the needle is at the other tool */
#define FARTHEST_BACK 10e-3 /* of the tip before the right mark, drawn out of that wall */
#define RELIEVED \
    1.0 /* N: a needle that is drawn back to the lumen goes on back until the hand feels less, or */
#define HARDLY_IN 2e-3 /* so much of it is in the first wall */
#define MISSED 6e-3    /* of the tip beyond the right mark without a hole; it enters at 2 to 3 mm */
#define TRIMMING 0.1   /* s, time constant of the correction of the aim */
#define SLOWLY 0.5     /* through the left wall, whatever the hand */
#define NEARLY 0.4e-3  /* beside the mark: with more, slower still */
#define SEEING 0.1     /* s, time constant of vision */

enum { TRIES = 5 };        /* to take it, to enter the right wall */
enum { FORK_RETURNS = 2 }; /* of the fork, for a needle that locks */
enum { BACKS = 10 };       /* of a needle that drags */

static const char *const names[] = {"lie",   "reach", "lower", "close", "lift", "bring", "aim",
                                    "enter", "cross", "leave", "ease",  "draw", "done",  "failed"};

const char *stitch_name(stitch_state state)
{
    return names[state];
}

const hand *stitch_hand(const stitch *t, int side)
{
    return mirror_side(t->site.rig.mirrored, side) == SITE_LEFT ? &t->left : &t->right;
}

void stitch_enter_state(stitch *t, stitch_state state)
{
    t->state = state;
    t->since = 0.0;
}

void stitch_fail(stitch *t, const char *why)
{
    t->why = why;
    stitch_enter_state(t, STITCH_FAILED);
}

double stitch_felt(const hand *h)
{
    vbss_grasper_state s;
    return vbss_grasper_get_state(h->grasper, &s, sizeof s) == VBSS_OK
               ? v_length(v_load(s.hand_force))
               : 0.0;
}

/* But for what it misses its aim by. */
bool stitch_is_there(const hand *h)
{
    return v_distance(h->at, v_add(h->goal, h->target_at)) < 1e-3;
}

static pose grip(const site *s)
{
    return hold_grip(s, HOLD * s->arc * s->radius, 0.0, LEAN, UP);
}

/* The tool lies nearly along the needle's axis, and goes down behind as the needle turns. Where its shaft would come to the floor the hand raises it, and
 * the needle leans with it, about its centre: a shaft on the floor is a lever that lifts the drain. */
static void steer(stitch *t, const pose *needle, double speed)
{
    hand *h = &t->right;
    const pose back = pose_back(&t->held);
    pose tool = pose_after(needle, &back);
    const vec up = v3(0.0, 0.0, 1.0), shaft = hand_rotate(tool.q, up);
    const double lowest = t->site.floor + h->shape.shaft_radius + OFF_FLOOR;
    const double rise = clamp((lowest - tool.at.z) / h->shape.shaft_length, -1.0, 1.0);
    if (shaft.z < rise) {
        const double angle = vbss_acos(shaft.z) - vbss_acos(rise);
        const pose raised = pose_about(needle->at, v_unit(v_cross(shaft, up)), angle);
        tool = pose_after(&raised, &tool);
    }
    hold_go(h, &tool, speed);
}

static void take(stitch *t)
{
    hand *h = &t->right;
    pose needle = site_needle(&t->site), local = grip(&t->site);
    pose tool = pose_after(&needle, &local);
    double low = t->site.floor + h->shape.driver_radius - PRESS;
    if (t->state == STITCH_REACH) {
        hand_open(h, STITCH_JAW_WIDE);
        tool.at.z += OVER;
        hold_go(h, &tool, STITCH_CARRY);
        if (v_distance(h->at, v_add(tool.at, h->target_at)) < 1e-3) {
            stitch_enter_state(t, STITCH_LOWER);
        }
        return;
    }
    tool.at.z = low;
    hold_go(h, &tool, STITCH_CAREFUL);
    if (t->state == STITCH_LOWER) {
        if (fabs(h->at.z - low) < 0.1e-3 + fabs(h->target_at.z)) {
            stitch_enter_state(t, STITCH_CLOSE);
        }
        return;
    }
    hand_open(h, 0.0);
    if (h->holds && t->since > 0.25) {
        pose now = hold_reported(h), back = pose_back(&now);
        t->held = pose_after(&back, &needle);
        t->from = now;
        stitch_enter_state(t, STITCH_LIFT);
    } else if (t->since > 0.8) {
        hand_target(h, h->nature.target_end);
        stitch_enter_state(t, STITCH_REACH);
        if (++t->tries == TRIES) {
            stitch_fail(t, "the needle is not taken");
        }
    }
}

static void carry(stitch *t)
{
    if (t->state == STITCH_LIFT) {
        pose up = t->from;
        up.at.z += 0.03;
        hold_go(&t->right, &up, STITCH_CARRY);
        if (v_distance(t->right.at, up.at) < 5e-3) {
            stitch_enter_state(t, STITCH_BRING);
        }
        return;
    }
    t->entry = stitch_targeted(t, SITE_RIGHT);
    t->gone = -BEFORE;
    pose needle = stitch_entering(t);
    if (t->state == STITCH_BRING) {
        needle.at = v_add(needle.at, v3(0.012, 0.0, 0.015));
        steer(t, &needle, STITCH_CARRY);
        if (hold_off(&t->site, &needle) < 4e-3 && t->support != SUPPORT_OVER) {
            stitch_enter_state(t, STITCH_TARGET);
        }
        return;
    }
    if (t->support == SUPPORT_UNDER && stitch_felt(&t->right) > BUMPS) {
        stitch_set_error(t, SITE_RIGHT);
        stitch_enter_state(t, STITCH_BRING);
        stitch_set_fork_again(t);
        return;
    }
    if (t->support == SUPPORT_OVER) {
        stitch_enter_state(t, STITCH_BRING);
        return;
    }
    steer(t, &needle, STITCH_CAREFUL);
    bool borne = t->support == SUPPORT_UNDER && t->support_since > STITCH_BORNE &&
                 stitch_is_there(&t->left) && stitch_is_under_wall(t);
    if (hold_off(&t->site, &needle) < 1e-3 && borne) {
        stitch_enter_state(t, STITCH_ENTER);
    }
}

/* Back out of the first wall. */
bool stitch_is_out(const stitch *t)
{
    return t->state == STITCH_EASE && t->holes[SITE_RIGHT] == 0;
}

/* Presses on the right wall. A tip that slides along it or misses it goes back the way it came, and the hand aims again. */
static void enter_wall(stitch *t, double step)
{
    if (t->gone > MISSED) {
        t->misses = true;
    }
    t->gone += t->misses ? -step : step;
    if (t->misses && t->gone <= -BEFORE) {
        t->misses = false;
        stitch_set_error(t, SITE_RIGHT);
        stitch_enter_state(t, STITCH_BRING);
        if (++t->missed == TRIES) {
            stitch_fail(t, "the right wall is not entered");
        }
    }
}

/* How far the walls have gone along with the needle since it came out of the left one, m. */
static double along_with_needle(const stitch *t)
{
    return t->gone - t->out - t->ahead;
}

/* Held by two holes near to each other, a needle locks, and the drain goes along. It goes back as far, and on again when the fork bears the left wall. */
static double wait_for_fork(stitch *t, double step)
{
    t->back -= step;
    t->awaits_fork = t->support != SUPPORT_ON || t->support_since < ON_WALL;
    return t->back > 0.0 ? -step : 0.0;
}

/* A wall that goes along with the needle instead of sliding on it is torn off in the end. So the needle goes back a little, and on again;
 * farther back only if that helps. */
static double draw_on(stitch *t, double step)
{
    const double feels = stitch_felt(&t->right), along = along_with_needle(t);
    const bool has_gone_on = t->relieved == 0 || t->back < -BACK_BY;
    const bool helps = t->back <= 0.0 && feels < t->dragged;
    if (t->awaits_fork) {
        return wait_for_fork(t, step);
    }
    if (along > LOCKED && t->fork_returns < FORK_RETURNS) {
        t->fork_returns++;
        t->awaits_fork = true;
        t->back = along;
        t->since = 0.0;
        stitch_enter_support(t, SUPPORT_BESIDE);
    } else if ((has_gone_on || helps) && feels > DRAGS && t->relieved < BACKS) {
        t->relieved++;
        t->dragged = feels;
        t->back = BACK_BY;
    }
    t->back -= step;
    return t->back > 0.0 ? -step : step;
}

static void drive(stitch *t, double dt)
{
    double step = STITCH_DRIVE * t->right.nature.speed * dt;
    pose needle = stitch_entering(t);
    if (t->state == STITCH_ENTER) {
        enter_wall(t, step);
        steer(t, &needle, STITCH_CARRY);
        return;
    }
    if (t->withdraws && t->gone >= STITCH_IN_LUMEN) {
        stitch_enter_state(t, STITCH_EASE);
    }
    bool ready = t->support == SUPPORT_ON && t->support_since > ON_WALL;
    bool waits = t->state == STITCH_CROSS && t->gone >= STITCH_IN_LUMEN;
    if (t->state == STITCH_LEAVE) { /* the wall drives the tip aside */
        vec off = stitch_miss(t);
        t->trim = v_limit(v_along(t->trim, dt / TRIMMING, off), STITCH_FOLLOW);
        step = SLOWLY * STITCH_DRIVE * dt * clamp(2.0 - v_length(off) / NEARLY, 0.05, 1.0);
    }
    if (t->state == STITCH_LEAVE) {
        stitch_retry_if_wall_yields(t);
    }
    if (t->state == STITCH_EASE) {
        t->gone -= stitch_is_out(t) || t->gone < -FARTHEST_BACK ? 0.0 : step;
        const bool is_relieved = stitch_felt(&t->right) < RELIEVED || t->gone < HARDLY_IN;
        if (t->gone <= STITCH_IN_LUMEN && is_relieved && !t->withdraws) {
            stitch_enter_state(t, STITCH_CROSS);
        }
    } else if (!waits && t->gone < LONGEST) {
        t->gone += t->state == STITCH_DRAW ? draw_on(t, step) : step;
    }
    t->along = smaller(1.0, t->along + dt / 0.5);
    pose other = stitch_crossing(t);
    needle = pose_mix(&needle, &other, t->along);
    steer(t, &needle, STITCH_CARRY);
    if (waits && ready) {
        stitch_enter_state(t, STITCH_LEAVE);
    }
    const double enough = t->gone < LONGEST && t->relieved == 0 ? OUT : ENOUGH;
    if (t->state == STITCH_DRAW && t->out > enough) {
        stitch_enter_state(t, STITCH_DONE);
    }
    if (t->since > PATIENCE && t->state == STITCH_DRAW) {
        stitch_restart(t);
    } else if (t->since > PATIENCE) {
        stitch_fail(t, "the left wall is not left");
    }
}

static void lead_right(stitch *t, double dt)
{
    switch (t->state) {
    case STITCH_LIE:
        if (t->since > 0.2) {
            stitch_enter_state(t, STITCH_REACH);
        }
        break;
    case STITCH_REACH:
    case STITCH_LOWER:
    case STITCH_CLOSE:
        take(t);
        break;
    case STITCH_LIFT:
    case STITCH_BRING:
    case STITCH_TARGET:
        carry(t);
        break;
    case STITCH_ENTER:
    case STITCH_CROSS:
    case STITCH_LEAVE:
    case STITCH_EASE:
    case STITCH_DRAW:
        drive(t, dt);
        break;
    case STITCH_DONE:
    case STITCH_FAILED:
        break;
    }
}

vbss_result stitch_lead(stitch *t, double dt)
{
    t->since += dt;
    t->support_since += dt;
    if (t->state > STITCH_CLOSE) {
        hold_see(&t->held, &t->right, &t->site, dt);
    }
    for (int side = 0; side < 2; side++) {
        t->marks[side] = v_mix(t->marks[side], site_mark(&t->site, side), dt / SEEING);
    }
    lead_right(t, dt);
    stitch_lead_left(t);
    TRY(hand_step(&t->right, dt));
    return hand_step(&t->left, dt);
}
