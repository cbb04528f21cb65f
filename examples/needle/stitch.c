#include "needle/stitch.h"

#include <stdbool.h>

#define HOLD 0.64    /* of the needle's length from its tip: where it is taken */
#define LEAN 0.14    /* of the tool from the needle's axis, away from the drain in the end, rad */
#define UP 1.92      /* to where, in the needle's plane, rad */
#define PRESS 0.5e-3 /* jaws into the floor, so that they are on it */
#define OVER 12e-3
#define CARRY 0.1 /* m/s */
#define CAREFUL 0.03
#define DRIVE 12e-3        /* of the tip */
#define BEFORE 5e-3        /* of the mark, where the needle is brought */
#define LONGEST 27e-3      /* of the way beyond the right mark */
#define IN_LUMEN 5e-3      /* of the tip, until the left hand is ready */
#define DRAWN_BACK 2e-3    /* of it drawn back from a left wall, before the fork leaves that */
#define HELPED 2e-3        /* of it while the left hand still bears the wall */
#define OUT 8.5e-3         /* of the tip in the end */
#define ENOUGH 7e-3        /* of it, if the needle has gone as far as it goes, or drags */
#define DRAGS 3.0          /* N: the wall goes along with the needle that is in it; */
#define BACK_BY 2.5e-3     /* m, then */
#define FORK_BEYOND 1.8e-3 /* of the fork's tips past the mark */
#define FOLLOW 4e-3        /* at most, of a mark that moves */
#define LOWER 0.7e-3       /* than the left mark the fork bears it */
#define PUSH 4e-3          /* of the wall against the needle */
#define LEAD \
    0.35e-3       /* toward the slit, as the tip slides away from it on the wall before it enters */
#define FELT 2.5  /* N: a hand that feels more draws back */
#define BEARS 0.1 /* N: a hand whose fork bears the wall feels more, once that is pressed for */
#define PUSHED_OUT 10e-3 /* m beyond the right mark; a wall that is borne is pierced after 7 to 9 */
#define PRESSED 0.5      /* so many s */
#define BORNE 1.5        /* s: after that time on the fork the right wall is at rest */
#define BUMPS \
    1.5 /* N: felt on the way to the mark, more than that means that the needle is at the other tool */
#define FARTHEST_BACK 10e-3 /* of the tip before the right mark, drawn out of that wall */
#define RELIEVED \
    1.0 /* N: a needle that is drawn back to the lumen goes on back until the hand feels less, or */
#define HARDLY_IN 2e-3 /* so much of it is in the first wall */
#define MISSED 6e-3    /* of the tip beyond the right mark without a hole; it enters at 2 to 3 mm */
#define SQUARE \
    0.75 /* cosine between needle and wall, beyond which the needle was square to it once; */
#define ASLANT 0.25      /* so much of it is lost when the wall tips over */
#define NEAR 1.5e-3      /* of the tip to the middle of the wall, when it presses on that */
#define FORK_MOVED 2e-3  /* at most */
#define ELSEWHERE 0.4e-3 /* up, down, farther up: where the wall tips over it */
#define BESIDE 1e-3      /* along the drain, when all places have been tried in vain */
#define TRIMMING 0.1     /* s, in which what misses the mark is taken into the aim */
#define SLOWLY 0.5       /* through the left wall, whatever the hand */
#define NEARLY 0.4e-3    /* beside the mark: with more, slower still */
#define SPRINGS 0.05     /* s: so soon after it has entered the wall may spring off it */
#define TO_HOLES 0.3     /* s, in which the circle moves from the marks to the holes */
#define SEEING 0.1       /* s, delay of what is seen */

enum { TRIES = 5 };    /* to take it, to enter the right wall */
enum { FORKED = 10 };  /* settings of the fork under that */
enum { AGAIN = 10 };   /* to come back to the left */
enum { RESTARTS = 3 }; /* of the whole stitch */
enum { BACKS = 10 };   /* of a needle that drags */
enum { PLACES = 5 };   /* of the fork on the left wall */

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

/* ---- the right tool with the needle in it */

static pose grip(const site *s)
{
    return hold_grip(s, HOLD * s->arc * s->radius, 0.0, LEAN, UP);
}

static void steer(stitch *t, const pose *needle, double speed)
{
    hold_steer(&t->right, &t->held, needle, speed);
}

/* ---- the path of the needle */

static vec targeted(const stitch *t, int side)
{
    return v_add(v_add(t->marks[side], t->errors[side]), t->beside);
}

/* The needle with its tip at a point, straight through the wall there. */
static pose at_entry(const stitch *t)
{
    vec z = v3(0.0, 1.0, 0.0);
    vec y = v_scale(-1.0, site_normal_at_rest(&t->site, SITE_RIGHT));
    vec x = v_cross(y, z);
    return pose_of(v_along(t->entry, -t->site.radius, x), x, y, z);
}

static pose entering(const stitch *t)
{
    pose p = at_entry(t);
    return pose_turned(&p, v3(0.0, 0.0, 1.0), t->gone / t->site.radius);
}

/* The left mark as it is seen; where the needle pushes it out, it is not followed. */
static vec exit_target(const stitch *t)
{
    vec rest = site_mark_at_rest(&t->site, SITE_LEFT), n = site_normal_at_rest(&t->site, SITE_LEFT);
    vec moved = v_sub(t->marks[SITE_LEFT], rest);
    moved = v_along(moved, -larger(v_dot(moved, n), 0.0), n);
    vec up = v_cross(v3(0.0, 1.0, 0.0), n);
    vec target_at = v_along(v_add(v_add(rest, t->errors[SITE_LEFT]), t->beside), LEAD, up);
    return v_add(v_add(target_at, t->trim), v_limit(moved, FOLLOW));
}

/* From the circle on which the needle really lies to the left mark. */
static vec miss(const stitch *t)
{
    pose needle = site_needle(&t->site);
    vec to = v_sub(targeted(t, SITE_LEFT), needle.at);
    vec z = hand_rotate(needle.q, v3(0.0, 0.0, 1.0)), flat = v_across(to, z);
    vec out = v_scale(v_length(flat) - t->site.radius, v_unit(flat));
    return v_along(out, v_dot(to, z), z);
}

/* By FOLLOW at most: a needle that follows its holes without limit tears the drain off. */
static vec toward_hole(vec at_rest, vec hole, double share)
{
    return v_along(at_rest, share, v_limit(v_sub(hole, at_rest), FOLLOW));
}

/* On the circle through the first hole and the left mark, above which its centre lies, so far beyond the hole. Once the needle is in both walls, the
 * circle goes through both holes: one through the marks at rest presses on the holes, and friction drags the drain along. */
static pose crossing(const stitch *t)
{
    vec from = t->entry, to = exit_target(t);
    if (t->state == STITCH_DRAW) {
        const double share = smaller(1.0, t->since / TO_HOLES);
        from = toward_hole(from, t->hole[SITE_RIGHT], share);
        to = toward_hole(to, t->hole[SITE_LEFT], share);
    }
    vec e1 = v_unit(v_sub(from, to)), e3 = v_unit(v_across(v3(0.0, 0.0, 1.0), e1));
    double half = 0.5 * v_distance(from, to), r = t->site.radius;
    vec centre = v_along(v_mix(from, to, 0.5), sqrt(r * r - half * half), e3);
    vec x = v_unit(v_sub(from, centre)), z = v_cross(e3, e1);
    pose p = pose_of(centre, x, v_cross(z, x), z);
    return pose_turned(&p, v3(0.0, 0.0, 1.0), t->gone / r);
}

/* ---- the right hand */

static void enter_state(stitch *t, stitch_state state)
{
    t->state = state;
    t->since = 0.0;
}

static void fail(stitch *t, const char *why)
{
    t->why = why;
    enter_state(t, STITCH_FAILED);
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
        hold_go(h, &tool, CARRY);
        if (v_distance(h->at, v_add(tool.at, h->target_at)) < 1e-3) {
            enter_state(t, STITCH_LOWER);
        }
        return;
    }
    tool.at.z = low;
    hold_go(h, &tool, CAREFUL);
    if (t->state == STITCH_LOWER) {
        if (fabs(h->at.z - low) < 0.1e-3 + fabs(h->target_at.z)) {
            enter_state(t, STITCH_CLOSE);
        }
        return;
    }
    hand_open(h, 0.0);
    if (h->holds && t->since > 0.25) {
        pose now = hold_reported(h), back = pose_back(&now);
        t->held = pose_after(&back, &needle);
        t->from = now;
        enter_state(t, STITCH_LIFT);
    } else if (t->since > 0.8) {
        hand_target(h, h->nature.target_end);
        enter_state(t, STITCH_REACH);
        if (++t->tries == TRIES) {
            fail(t, "the needle is not taken");
        }
    }
}

static double felt(const hand *h)
{
    vbss_grasper_state s;
    return vbss_grasper_get_state(h->grasper, &s, sizeof s) == VBSS_OK
               ? v_length(v_load(s.hand_force))
               : 0.0;
}

/* But for what it misses its aim by. */
static bool is_there(const hand *h)
{
    return v_distance(h->at, v_add(h->goal, h->target_at)) < 1e-3;
}

/* The fork's tips have come in by the slit, and do not lie on the right wall from outside. */
static bool is_under_wall(const stitch *t)
{
    vec from = v_sub(t->left.at, t->marks[SITE_RIGHT]);
    return v_dot(from, site_normal(&t->site, SITE_RIGHT)) < 0.0;
}

static void enter_support(stitch *t, stitch_support support)
{
    t->support = support;
    t->support_since = 0.0;
}

/* The fork goes over the slit and in again, from farther on the near side, where its shaft is not in the needle's way; not always as far,
 * since from very far its jaws go over the slit's edge. */
static void set_fork_again(stitch *t)
{
    /* m, spread up to 0.05, where the shaft is clear of the needle; one seed showed that this may be too far */
    static const double nearer[TRIES] = {0.025, 0.05, 0.0125, 0.0375, 0.0};
    hand_target(&t->left, t->left.nature.target_end);
    if (t->left_is_free) {
        hand_through(&t->left,
                     v_along(STITCH_LEFT_TROCAR, -nearer[t->forked % TRIES], v3(0.0, 1.0, 0.0)));
    }
    enter_support(t, SUPPORT_OVER);
    if (++t->forked == FORKED) {
        fail(t, "the right wall is not supported");
    }
}

static void carry(stitch *t)
{
    if (t->state == STITCH_LIFT) {
        pose up = t->from;
        up.at.z += 0.03;
        hold_go(&t->right, &up, CARRY);
        if (v_distance(t->right.at, up.at) < 5e-3) {
            enter_state(t, STITCH_BRING);
        }
        return;
    }
    t->entry = targeted(t, SITE_RIGHT);
    t->gone = -BEFORE;
    pose needle = entering(t);
    if (t->state == STITCH_BRING) {
        needle.at = v_add(needle.at, v3(0.012, 0.0, 0.015));
        steer(t, &needle, CARRY);
        if (hold_off(&t->site, &needle) < 4e-3 && t->support != SUPPORT_OVER) {
            enter_state(t, STITCH_TARGET);
        }
        return;
    }
    if (t->support == SUPPORT_UNDER && felt(&t->right) > BUMPS) {
        stitch_set_error(t, SITE_RIGHT);
        enter_state(t, STITCH_BRING);
        set_fork_again(t);
        return;
    }
    if (t->support == SUPPORT_OVER) {
        enter_state(t, STITCH_BRING);
        return;
    }
    steer(t, &needle, CAREFUL);
    bool borne = t->support == SUPPORT_UNDER && t->support_since > BORNE && is_there(&t->left) &&
                 is_under_wall(t);
    if (hold_off(&t->site, &needle) < 1e-3 && borne) {
        enter_state(t, STITCH_ENTER);
    }
}

/* How the left wall gives way, as is seen and felt: it tips over the fork instead of being pierced, or leaves it, or the hand feels
 * too much, or pushes it far out. */
typedef enum yielding { HOLDS, TIPS, LEAVES, WEDGES } yielding;

static yielding check_yielding(stitch *t)
{
    pose needle = site_needle(&t->site);
    vec n = site_normal(&t->site, SITE_LEFT);
    vec from = v_sub(pose_point(&needle, v3(t->site.radius, 0.0, 0.0)), t->marks[SITE_LEFT]);
    double square = v_dot(hand_rotate(needle.q, v3(0.0, 1.0, 0.0)), n);
    bool presses = fabs(v_dot(from, n)) < NEAR;
    if (presses && square > t->square) {
        t->square = square;
        t->pressed = from;
    }
    if (presses && t->square > SQUARE && square < t->square - ASLANT) {
        return TIPS;
    }
    bool leaves = t->since > PRESSED && felt(&t->left) < BEARS;
    const bool wedges = felt(&t->right) > FELT || t->gone > PUSHED_OUT;
    return leaves ? LEAVES : wedges ? WEDGES : HOLDS;
}

/* After so many tries at the left wall the first hole may be the cause: it is aslant or far from its mark. The needle is withdrawn, and the right wall is
 * entered again. */
static void restart_if_often_tried(stitch *t)
{
    if (t->again <= AGAIN) {
        return;
    }
    if (++t->restart_count > RESTARTS) {
        fail(t, "the left wall gives way");
        return;
    }
    t->again = 0;
    t->withdraws = t->restarts = true;
}

/* The fork is set anew, so that the needle comes between its jaws, and nearer to their tips, but not beyond the mark: near its
 * edge the wall leaves it. What has left it is borne farther from its edge. */
static void try_again(stitch *t, yielding how)
{
    vec along = v3(0.0, 1.0, 0.0);
    vec up = v_cross(along, site_normal_at_rest(&t->site, SITE_LEFT));
    const int place = t->again % PLACES;
    if (place == PLACES - 1) { /* all have been tried: the usual one again, with a smaller error */
        t->fork = v3(0.0, 0.0, 0.0);
    } else if (how == LEAVES) {
        t->fork = v_along(t->fork, -LOWER, up);
    } else if (t->square > 0.0) { /* it has pressed */
        double higher = v_dot(t->pressed, up) + 0.5 * LOWER;
        double aside = v_dot(v_sub(t->pressed, t->beside), along);
        t->fork = v_scale(clamp(aside, -FORK_MOVED, FORK_MOVED), along);
        t->fork = v_along(t->fork, clamp(higher, -LOWER, LOWER), up);
        double elsewhere = ELSEWHERE * (place > 0 ? place + 1 : 0);
        t->fork = v_along(t->fork, place % 2 == 1 ? elsewhere : -elsewhere, up);
    }
    const int round = t->again / PLACES;
    if (round > 0) {
        t->fork = v_along(t->fork, round % 2 == 1 ? BESIDE : -BESIDE, along);
    }
    t->trim = v3(0.0, 0.0, 0.0);
    t->square = 0.0;
    t->again++; /* the hand has seen its error, so the next one is smaller */
    hand_target(&t->left, t->left.nature.target_end / (1 + t->again));
    t->errors[SITE_LEFT] = v_scale(0.5, t->errors[SITE_LEFT]);
    enter_state(t, STITCH_EASE);
    restart_if_often_tried(t);
}

/* Back out of the first wall. */
static bool is_out(const stitch *t)
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
        enter_state(t, STITCH_BRING);
        if (++t->missed == TRIES) {
            fail(t, "the right wall is not entered");
        }
    }
}

/* A wall that goes along with the needle instead of sliding on it is torn off in the end. So the needle goes back a little, and on again;
 * farther back only if that helps. */
static double draw_on(stitch *t, double step)
{
    const double feels = felt(&t->right);
    const bool has_gone_on = t->relieved == 0 || t->back < -BACK_BY;
    const bool helps = t->back <= 0.0 && feels < t->dragged;
    if ((has_gone_on || helps) && feels > DRAGS && t->relieved < BACKS) {
        t->relieved++;
        t->dragged = feels;
        t->back = BACK_BY;
    }
    t->back -= step;
    return t->back > 0.0 ? -step : step;
}

static void drive(stitch *t, double dt)
{
    double step = DRIVE * t->right.nature.speed * dt;
    pose needle = entering(t);
    if (t->state == STITCH_ENTER) {
        enter_wall(t, step);
        steer(t, &needle, CARRY);
        return;
    }
    if (t->withdraws && t->gone >= IN_LUMEN) {
        enter_state(t, STITCH_EASE);
    }
    bool ready = t->support == SUPPORT_ON && t->support_since > 0.4;
    bool waits = t->state == STITCH_CROSS && t->gone >= IN_LUMEN;
    if (t->state == STITCH_LEAVE) { /* the wall drives the tip aside */
        vec off = miss(t);
        t->trim = v_limit(v_along(t->trim, dt / TRIMMING, off), FOLLOW);
        step = SLOWLY * DRIVE * dt * clamp(2.0 - v_length(off) / NEARLY, 0.05, 1.0);
    }
    yielding how = t->state == STITCH_LEAVE ? check_yielding(t) : HOLDS;
    if (how != HOLDS) {
        try_again(t, how);
    }
    if (t->state == STITCH_EASE) {
        t->gone -= is_out(t) || t->gone < -FARTHEST_BACK ? 0.0 : step;
        const bool is_relieved = felt(&t->right) < RELIEVED || t->gone < HARDLY_IN;
        if (t->gone <= IN_LUMEN && is_relieved && !t->withdraws) {
            enter_state(t, STITCH_CROSS);
        }
    } else if (!waits && t->gone < LONGEST) {
        t->gone += t->state == STITCH_DRAW ? draw_on(t, step) : step;
    }
    t->along = smaller(1.0, t->along + dt / 0.5);
    pose other = crossing(t);
    needle = pose_mix(&needle, &other, t->along);
    steer(t, &needle, CARRY);
    if (waits && ready) {
        enter_state(t, STITCH_LEAVE);
    }
    const double enough = t->gone < LONGEST && t->relieved == 0 ? OUT : ENOUGH;
    if (t->state == STITCH_DRAW && t->out > enough) {
        enter_state(t, STITCH_DONE);
    }
    if (t->since > 8.0) {
        fail(t, "the left wall is not left");
    }
}

static void lead_right(stitch *t, double dt)
{
    switch (t->state) {
    case STITCH_LIE:
        if (t->since > 0.2) {
            enter_state(t, STITCH_REACH);
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

/* ---- the left hand */

/* A wall that has tipped over the fork springs back as that leaves: not onto the tip, which would catch it aslant. */
static bool is_drawn_back(const stitch *t)
{
    return t->since * DRIVE * t->right.nature.speed > DRAWN_BACK;
}

static void lead_left(stitch *t)
{
    hand *h = &t->left;
    vec right = v_add(site_mark_at_rest(&t->site, SITE_RIGHT), t->beside),
        left = v_add(site_mark_at_rest(&t->site, SITE_LEFT), t->beside);
    double off = 0.5 * t->site.wall + h->shape.driver_radius;
    vec in = v_along(right, -off + 0.2e-3, site_normal_at_rest(&t->site, SITE_RIGHT));
    vec outer = site_normal_at_rest(&t->site, SITE_LEFT);
    vec on = v_along(v_along(left, off, outer), -LOWER, v_cross(v3(0.0, 1.0, 0.0), outer));
    on = v_add(on, t->fork);
    vec direction = v_unit(v_sub(h->trocar, in)), tip = v_along(in, -FORK_BEYOND, direction);
    switch (t->support) {
    case SUPPORT_AWAY:
        if (t->since > 0.1 && t->state > STITCH_LIE) {
            hand_target(h, h->nature.target_end);
            enter_support(t, SUPPORT_OVER);
        }
        break;
    case SUPPORT_OVER:
        hand_go(h, v_along(tip, 0.02, direction), CARRY);
        if (v_distance(h->at, v_add(v_along(tip, 0.02, direction), h->target_at)) < 0.5e-3) {
            enter_support(t, SUPPORT_UNDER);
        }
        break;
    case SUPPORT_UNDER:
        hand_go(h, tip, CAREFUL);
        if (t->state <= STITCH_TARGET && t->support_since > BORNE && is_there(h) &&
            !is_under_wall(t)) {
            set_fork_again(t);
            break;
        }
        if (t->state == STITCH_CROSS && t->gone >= IN_LUMEN) {
            enter_support(t, SUPPORT_OUT);
        }
        break;
    case SUPPORT_OUT:
        hand_go(h, v_along(tip, 0.025, direction), CARRY);
        if (v_distance(h->at, v_add(v_along(tip, 0.025, direction), h->target_at)) < 1e-3) {
            hand_through(h, STITCH_LEFT_TROCAR);
            enter_support(t, SUPPORT_BESIDE);
        }
        break;
    case SUPPORT_BESIDE:
        direction = v_unit(v_sub(h->trocar, on));
        hand_go(h, v_along(on, 4e-3, direction), CARRY);
        if (t->state != STITCH_EASE &&
            v_distance(h->at, v_add(v_along(on, 4e-3, direction), h->target_at)) < 0.5e-3) {
            enter_support(t, SUPPORT_ON);
        }
        break;
    case SUPPORT_ON:
        direction = v_unit(v_sub(h->trocar, on));
        hand_go(h, v_along(on, -PUSH, direction), CAREFUL);
        if (t->state == STITCH_EASE && is_drawn_back(t)) {
            enter_support(t, SUPPORT_BESIDE);
        } else if (t->out > HELPED) {
            enter_support(t, SUPPORT_BACK);
        }
        break;
    case SUPPORT_BACK:
        if (t->state == STITCH_EASE) {
            enter_support(t, SUPPORT_BESIDE);
            break;
        }
        direction = v_unit(v_sub(h->trocar, on));
        hand_go(h, v_along(on, 0.03, direction), CARRY);
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
    lead_left(t);
    TRY(hand_step(&t->right, dt));
    return hand_step(&t->left, dt);
}

/* ---- what the step did */

static void punctured(stitch *t, uint32_t id)
{
    vbss_scene_hole hole;
    t->punctures++;
    if (!site_find_hole(&t->site, id, &hole)) {
        return;
    }
    int side = hole.outward ? SITE_LEFT : SITE_RIGHT;
    if (t->holes[side] != 0) {
        t->others++;
        return;
    }
    t->holes[side] = id;
    t->made[side] = hole;
    t->hole[side] = v_load(hole.position);
    if (side == SITE_RIGHT && t->state == STITCH_ENTER) {
        t->gone = hole.arc_length;
        t->entry = v_add(site_mark_at_rest(&t->site, SITE_RIGHT), t->beside);
        enter_state(t, STITCH_CROSS);
    } else if (side == SITE_LEFT && t->state >= STITCH_CROSS && t->state < STITCH_DRAW) {
        enter_state(t, STITCH_DRAW);
    }
}

/* To the first mark, with all that was learnt of the walls forgotten. */
static void begin_again(stitch *t)
{
    t->withdraws = t->restarts = false;
    t->beside = t->trim = t->fork = v3(0.0, 0.0, 0.0);
    t->along = t->square = 0.0;
    enter_support(t, SUPPORT_AWAY);
    enter_state(t, STITCH_BRING);
}

void stitch_mend(stitch *t)
{
    if (is_out(t)) {
        begin_again(t);
    } else {
        t->withdraws = true;
        enter_state(t, STITCH_EASE);
    }
}

/* The needle is back out of the first wall. */
static void withdrawn(stitch *t)
{
    t->holes[SITE_RIGHT] = 0;
    t->punctures = 0;
    if (t->restarts || !t->withdraws) {
        stitch_set_error(t, SITE_RIGHT);
        stitch_set_error(t, SITE_LEFT);
        begin_again(t);
    }
}

/* The tip has left its hole at that side again. */
static void lose_hole(stitch *t, int side, stitch_state then)
{
    t->holes[side] = 0;
    t->punctures--;
    t->out = side == SITE_LEFT ? 0.0 : t->out;
    enter_state(t, then);
}

/* Drawn back a little, or as the wall springs back, the needle may leave its hole in the left wall. */
static bool is_drawn_out(stitch *t, uint32_t id)
{
    const bool is = id == t->holes[SITE_LEFT];
    if (is) {
        t->back = 0.0;
        lose_hole(t, SITE_LEFT, STITCH_EASE);
        t->again++;
        restart_if_often_tried(t);
    }
    return is;
}

/* Back out of the first wall, by intention or not. */
static bool is_withdrawn(stitch *t, uint32_t id)
{
    const bool is = id == t->holes[SITE_RIGHT] && (t->mends || t->restarts || !t->withdraws);
    if (is) {
        withdrawn(t);
    }
    return is;
}

/* The wall springs back from a tip that has entered it, and now and then off it again: that goes on pressing. */
static bool sprang_off(stitch *t, uint32_t id)
{
    const int side = t->state == STITCH_DRAW ? SITE_LEFT : SITE_RIGHT;
    const bool has_just_entered = t->state == STITCH_CROSS || t->state == STITCH_DRAW;
    const bool just = has_just_entered && t->since < SPRINGS && id == t->holes[side];
    if (just) {
        lose_hole(t, side, side == SITE_RIGHT ? STITCH_ENTER : STITCH_LEAVE);
    }
    return just;
}

vbss_result stitch_observe(stitch *t)
{
    const throw_rig *rig = &t->site.rig;
    vbss_scene_hole hole;
    TRY(hand_feel(&t->right));
    TRY(hand_feel(&t->left));
    for (uint32_t i = 0; i < rig->event_count; i++) {
        const vbss_scene_event *e = &rig->events[i];
        if (e->kind == VBSS_SCENE_EVENT_PUNCTURE) {
            punctured(t, e->id);
        } else if (e->kind == VBSS_SCENE_EVENT_WITHDRAWN &&
                   (sprang_off(t, e->id) || is_drawn_out(t, e->id) || is_withdrawn(t, e->id))) {
            continue;
        } else if (e->kind == VBSS_SCENE_EVENT_TORN || e->kind == VBSS_SCENE_EVENT_WITHDRAWN) {
            t->others++;
            fail(t, e->kind == VBSS_SCENE_EVENT_TORN ? "torn out of the jaws" : "withdrawn");
        }
    }
    for (int side = 0; side < 2; side++) {
        if (t->holes[side] != 0 && site_find_hole(&t->site, t->holes[side], &hole)) {
            t->hole[side] = v_mix(t->hole[side], v_load(hole.position), 0.01);
            t->out = side == SITE_LEFT ? hole.arc_length : t->out;
        }
    }
    return VBSS_OK;
}
