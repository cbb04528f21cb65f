/* Throws, by the words of the coach. What the coach does not say is how tools are held and where the hand without the goal goes;
 * the guide "By mouse" does. */
#include "trainee/trainee.h"

#include <math.h>

#define BESIDE \
    32e-3 /* m, of the needle from the tool that it is to be wound about: on the near side, */
#define BELOW 12e-3    /* and lower */
#define BEHIND 10e-3   /* behind that tool's tip */
#define ABOVE 15e-3    /* over the tail */
#define TOGETHER 16e-3 /* of the jaws at a time, while the needle goes along */
#define SWEPT 12e-3    /* of the tail from where it was seen, */
#define OVER 20e-3     /* then the jaws go as high */
#define MISSED 25e-3   /* of the jaws from a tail that they have closed beside, at most */
#define STRIDE \
    30e-3 /* of the mouse when it winds: a longer one pulls on with a limb that has become taut */
#define WAITS 130       /* frames, when turns have come off */
#define DRAWN 3e-3      /* of the tail at a time */
#define LIMB_DRAWN 5e-3 /* of the limb */
#define SHORTER 1e-3    /* of its jaws to the slit, in each movement, */
#define SHORT 0.75      /* down to this share: a tail that is taut drags the drain along */
#define SHORT_THIRD 0.9
#define TAKEN_UP 6e-3   /* of the limb at a time in the first throw */
#define LIGHT 0.1       /* N, of the limb then */
#define TAUT 0.8e-3     /* of each hand at a time while both ends are taut, */
#define SLACK 5e-3      /* and while one is slack: it misses */
#define VERY_SLACK 0.04 /* N */
#define HALF_SLACK 2e-3
#define SLACKER 0.75   /* more of the force */
#define FAR 0.15       /* from the slit, to where the hands pull */
#define ENOUGH 1.0     /* N, of both ends: pulled harder, the slit opens again */
#define GENTLE 0.4e-3  /* of each hand at a time in the end */
#define SLACKENED 1e-3 /* of each hand at a time before the tail is let go, */
#define LOCKED 0.6     /* N, of both ends then: so much the stitch itself may hold */
#define LOOSE 0.1      /* N, of an end that does not pull */
#define HANGS 1.0      /* N, of both ends while the tail is drawn: a turn hangs on the jaws */
#define NUDGED 1e-3    /* of the tail at a time then */
#define OFF 1.5e-3     /* of the slit from its place */
#define LARGEST 1.5    /* N, of both ends: pulled harder, the edges slip past each other */
#define FIRM 0.5       /* N, of both ends: gently from there */
#define CLOSING 2e-3   /* of the limb at a time before both ends are pulled */
#define CLOSED 0.22    /* N, of an end then: from there both are pulled */
#define RAISED \
    1.22 /* rad, of the tail of a later throw on its path from its own side: it stays there */
#define TILT 1.2 /* rad, of that path from upright to the near side */
#define MIN_HEIGHT 5e-3
#define NEARLY 1e-3 /* of a tail that was taut, so much shorter: it is straight and slack */
#define FELT 0.04   /* N, of a tail that becomes straight */
#define HALF_TURN 3.14159265358979

enum {
    LOOSENED = 5, /* of the hands toward the slit when nothing pulls */
    PARTS = 16,
    AGAIN = 5
}; /* of slackening, before the tail is let go, and before a further pull */

static bool is_goal(const trainee *t, vbss_session_goal goal)
{
    return trainee_see(t)->coach.goal == goal;
}

static vec point_of(const trainee *t)
{
    return v_load(trainee_see(t)->coach.point);
}

static double weaker(const trainee *t)
{
    return fmin(trainee_see(t)->tension[0], trainee_see(t)->tension[1]);
}

static double stronger(const trainee *t)
{
    return fmax(trainee_see(t)->tension[0], trainee_see(t)->tension[1]);
}

/* Of x, on the hand's own side. */
static double side_of(int side)
{
    return side == LEFT ? -1.0 : 1.0;
}

/* The jaws with the turns go, and the needle goes along: a slack turn falls off. */
static bool go_together(trainee *t, int loop, vec by)
{
    const int parts = (int)ceil(v_length(by) / TOGETHER);
    const vec from = trainee_see(t)->tip[loop];
    bool good = trainee_follow(t, true);
    for (int i = 1; i <= parts && good; i++) {
        vec to = v_along(from, (double)i / parts, by);
        good = trainee_move(t, loop, v_sub(to, trainee_see(t)->tip[loop]));
        trainee_say(t, "together");
    }
    return good;
}

/* Under the place of the other tool, on the near side. */
static vec under(const trainee *t, vec inward)
{
    return v_along(v_add(point_of(t), v3(0.0, -BESIDE, -BELOW)), -BEHIND, inward);
}

/* The tools point at each other, the needle is on the near side and low, and the other tool goes over the limb to its place. The needle
 * comes nearer before it turns: with a taut limb its end would draw the tail out. The coach's point moves with a drain that the limb has
 * drawn aside, so each movement sees it anew. */
static bool take_places(trainee *t, int limb)
{
    int loop = 1 - limb;
    vec inward = v3(-side_of(loop), 0.0, 0.0);
    bool good = trainee_jaws(t, loop, true) && trainee_go(t, limb, under(t, inward), 6e-3) &&
                trainee_turn(t, limb, v_scale(-1.0, inward)) &&
                trainee_go(t, limb, under(t, inward), 3e-3) && trainee_turn(t, loop, inward) &&
                trainee_go(t, loop, v_along(point_of(t), -40e-3, inward), 6e-3) &&
                trainee_go(t, loop, point_of(t), 2e-3) &&
                trainee_go(t, limb, under(t, inward), 3e-3);
    trainee_say(t, "in place");
    return good;
}

/* The aid stops; the thread comes to rest meanwhile. */
static bool heed_lost_turns(trainee *t)
{
    t->warned = trainee_see(t)->coach.mistake_time;
    trainee_say(t, "turns lost");
    return trainee_wait(t, WAITS);
}

/* The mouse goes on to the left, from the first mark to the second. */
static bool wind(trainee *t, int limb)
{
    bool good = trainee_aid(t, VBSS_SESSION_AID_WIND);
    t->is_wound = true;
    t->has_pulled = false;
    for (int i = 0; i < 40 && good && is_goal(t, VBSS_SESSION_GOAL_WIND); i++) {
        const vbss_session_coaching *c = &trainee_see(t)->coach;
        double left = fmin(fmax(c->arc_angle * c->arc_radius, 10e-3), STRIDE);
        good = c->mistake == VBSS_SESSION_MISTAKE_TURNS_LOST && c->mistake_time > t->warned
                   ? heed_lost_turns(t)
                   : trainee_move(t, limb, v3(-left, 0.0, 0.0));
        trainee_say(t, "wound");
    }
    return good && trainee_aid(t, VBSS_SESSION_AID_WIND);
}

/* Down and outward along the tail: so the jaws open level, and a tail on the floor is between them. */
static vec toward_tail(const trainee *t, int loop)
{
    vec inward = v_load(trainee_see(t)->coach.direction);
    vec out = v3(-inward.x, -inward.y, 0.0);
    out = v_length(out) < 0.5 ? v3(-side_of(loop), 0.2, 0.0) : v_unit(out);
    out = out.x * side_of(loop) > 0.0 ? v_scale(-1.0, out)
                                      : out; /* jaws that turn round lose the turns */
    return v_unit(v_add(v_scale(0.6, out), v3(0.0, 0.0, -0.8)));
}

/* The limb sweeps a tail along; jaws go after it over the drain, not through it. */
static bool go_after_tail(trainee *t, int loop, vec down)
{
    vec by = v_sub(v_along(point_of(t), -ABOVE, down), trainee_see(t)->tip[loop]);
    if (v_length(by) < SWEPT || !is_goal(t, VBSS_SESSION_GOAL_TAKE_TAIL)) {
        return true;
    }
    vec up = v3(0.0, 0.0, fmax(OVER - trainee_see(t)->tip[loop].z, 0.0));
    trainee_say(t, "after the tail");
    return go_together(t, loop, up) && go_together(t, loop, v3(by.x, by.y, 0.0));
}

/* The needle goes along, so that the turns stay. */
static bool go_over_tail(trainee *t, int loop)
{
    vec down = toward_tail(t, loop);
    vec above = v_along(point_of(t), -ABOVE, down);
    vec by = v_sub(above, trainee_see(t)->tip[loop]);
    bool goes_together = t->is_wound && v_length(by) > MISSED;
    bool good = goes_together ? go_together(t, loop, by) && go_after_tail(t, loop, down)
                              : trainee_go(t, loop, above, 3e-3);
    return good && trainee_turn(t, loop, toward_tail(t, loop)) && trainee_jaws(t, loop, false) &&
           trainee_roll_across(t, loop, v_load(trainee_see(t)->coach.direction));
}

static bool go_along_jaws(trainee *t, int loop, double beyond, double near)
{
    return !is_goal(t, VBSS_SESSION_GOAL_TAKE_TAIL) ||
           trainee_go(t, loop, v_along(point_of(t), beyond, trainee_see(t)->jaws[loop]), near);
}

static bool take_tail(trainee *t, int loop)
{
    for (int i = 0; i < 5 && is_goal(t, VBSS_SESSION_GOAL_TAKE_TAIL); i++) {
        /* A further try stays near the tail: the limb is snug, and would be pulled. */
        bool good = (i > 0 ? trainee_roll_across(t, loop, v_load(trainee_see(t)->coach.direction))
                           : go_over_tail(t, loop)) &&
                    go_along_jaws(t, loop, -6e-3, 1e-3) && go_along_jaws(t, loop, 2e-3, 0.6e-3) &&
                    trainee_jaws(t, loop, true);
        trainee_say(t, "closed on the tail");
        if (!good || trainee_see(t)->holds[loop] || !is_goal(t, VBSS_SESSION_GOAL_TAKE_TAIL)) {
            return good;
        }
        if (!trainee_jaws(t, loop, false)) {
            return false;
        }
    }
    return true;
}

/* Where an end is pulled, from the slit: on its own side, or on the other one if the hands have changed sides. Of a later throw also at 45
 * degrees, so that the ends do not go back over the throw below: the tail toward the near side, the limb to the far one. */
static vec pull_direction(const trainee *t, int loop, bool is_tail)
{
    double side = (t->is_crossed ? -1.0 : 1.0) * (is_tail ? 1.0 : -1.0);
    bool is_askew = t->is_later && !t->is_crossed;
    vec to = is_tail ? v3(side * side_of(loop), is_askew ? -1.0 : 0.0, -0.2)
                     : v3(side * side_of(loop), is_askew ? 1.0 : 0.0, 0.05);
    return v_unit(to);
}

static vec pull_from(const trainee *t, int loop, bool is_tail)
{
    vec to = v_along(t->slit, FAR, pull_direction(t, loop, is_tail));
    return v_unit(v_sub(to, trainee_see(t)->tip[is_tail ? loop : 1 - loop]));
}

/* The needle's hand alone goes outward, so that the turn comes off the jaws and runs down to the throw below. */
static bool draw_limb(trainee *t, int loop, double by)
{
    bool good = trainee_follow(t, false) &&
                trainee_move(t, 1 - loop, v_scale(by, pull_from(t, loop, false)));
    trainee_say(t, "drawn by the limb");
    return good;
}

/* The place of the tail's jaws on their path about the slit, 0: on their own side. That of a later throw leads over the near side. */
static vec tail_place(const trainee *t, int loop, double radius, double angle)
{
    double tilt = t->is_later && angle > 0.0 ? TILT : 0.0, up = radius * sin(angle);
    vec from = v3(side_of(loop) * radius * cos(angle), -up * sin(tilt), up * cos(tilt));
    from.z = tilt > 0.0 ? fmax(from.z, MIN_HEIGHT) : from.z;
    return v_add(t->slit, from);
}

/* The limb's hand goes outward, until it feels the thread: that draws the last turn off the jaws. */
static bool take_up(trainee *t, int loop, vec slit)
{
    vec out = v_add(slit, v3(-side_of(loop) * FAR, 0.0, 0.0));
    bool good = trainee_move(t, 1 - loop,
                             v_scale(TAKEN_UP, v_unit(v_sub(out, trainee_see(t)->tip[1 - loop]))));
    trainee_say(t, "taken up");
    return good;
}

/* The limb is slack over the slit, and the tail goes over it to its own side; past
 * the slit the jaws point inward. */
static bool draw_first_tail(trainee *t, int loop)
{
    double side = side_of(loop);
    bool turned = false;
    vec slit = point_of(t);
    const vec over = v_add(slit, v3(-28e-3 * side, 15e-3, 30e-3));
    vec beside = trainee_see(t)->tip[1 - loop];
    beside.z = fmax(beside.z, over.z); /* the needle comes over the drain, not through it */
    if (!trainee_follow(t, false) || !trainee_go(t, 1 - loop, beside, 5e-3) ||
        !trainee_go(t, 1 - loop, over, 5e-3)) {
        return false;
    }
    vec arm = v_sub(trainee_see(t)->tip[loop], slit);
    double radius = sqrt(arm.x * arm.x + arm.z * arm.z), angle = atan2(arm.z, side * arm.x);
    angle += angle < -0.5 * HALF_TURN ? 2.0 * HALF_TURN : 0.0;
    double full = radius;
    t->slit = slit;
    t->has_pulled = t->is_crossed = false;
    for (int i = 0; i < 60 && is_goal(t, VBSS_SESSION_GOAL_DRAW_TAIL); i++) {
        if (!turned && angle < 0.5 * HALF_TURN) {
            turned =
                trainee_turn(t, loop, v3(-side, 0.0, 0.0)); /* or the last turn hangs on them */
        }
        if (angle <= 0.0 && trainee_see(t)->tension[1] < LIGHT && i % 2 == 0) {
            if (!take_up(t, loop, slit)) {
                return false;
            }
            continue;
        }
        radius = angle <= 0.0 ? radius + DRAWN : fmax(radius - SHORTER, SHORT * full);
        angle -= angle > 0.0 ? DRAWN / radius : 0.0;
        vec to = v_add(slit, v3(side * radius * cos(angle), 0.0, radius * sin(angle)));
        vec by = v_sub(to, trainee_see(t)->tip[loop]);
        if (!trainee_move(t, loop, weaker(t) > HANGS ? v_limit(by, NUDGED) : by)) {
            return false;
        }
        trainee_say(t, "drawn");
    }
    return true;
}

/* The tail goes over the slit to its own side, and the needle goes along; past the slit the jaws point inward. The tail of a later throw
 * stays up: laid over the throw below, it would open that one. */
static bool draw_later_tail(trainee *t, int loop)
{
    double side = side_of(loop);
    bool turned = false;
    vec slit = point_of(t);
    vec arm = v_sub(trainee_see(t)->tip[loop], slit);
    double radius = v_length(arm), angle = atan2(arm.z, side * arm.x);
    angle += angle < -0.5 * HALF_TURN ? 2.0 * HALF_TURN : 0.0;
    const double shortest = (trainee_see(t)->coach.number > 1 ? SHORT_THIRD : SHORT) * radius;
    t->slit = slit;
    t->has_pulled = t->is_crossed = false;
    if (!trainee_follow(t, true)) {
        return false;
    }
    for (int i = 0; i < 60 && is_goal(t, VBSS_SESSION_GOAL_DRAW_TAIL); i++) {
        if (!turned && angle < 0.5 * HALF_TURN) {
            turned =
                trainee_turn(t, loop, v3(-side, 0.0, 0.0)); /* or the last turn hangs on them */
        }
        if (angle <= RAISED) {
            if (!draw_limb(t, loop, LIMB_DRAWN)) {
                return false;
            }
            continue;
        }
        radius = angle <= 0.0 ? radius + DRAWN : fmax(radius - SHORTER, shortest);
        angle -= angle > 0.0 ? DRAWN / radius : 0.0;
        vec by = v_sub(tail_place(t, loop, radius, angle), trainee_see(t)->tip[loop]);
        if (!trainee_move(t, loop, weaker(t) > HANGS ? v_limit(by, NUDGED) : by)) {
            return false;
        }
        trainee_say(t, "drawn");
    }
    return true;
}

static bool draw_tail(trainee *t, int loop)
{
    return t->is_later ? draw_later_tail(t, loop) : draw_first_tail(t, loop);
}

/* The hand of the end that bears less pulls, and the other one follows. A slit that has gone to the side of one hand is drawn back by the
 * other hand alone. */
static bool pull_once(trainee *t, int loop, double off, double step)
{
    const double *n = trainee_see(t)->tension;
    bool is_off = fabs(off) > OFF && weaker(t) > LOOSE;
    bool pulls_tail = is_off ? off < 0.0 : n[0] < n[1];
    int which = pulls_tail ? loop : 1 - loop;
    bool good = trainee_follow(t, !is_off) &&
                trainee_move(t, which, v_scale(step, pull_from(t, loop, pulls_tail)));
    trainee_say(t, pulls_tail ? "pulled by the tail" : "pulled by the limb");
    return good;
}

/* Both hands toward the slit, and more when nothing pulls. A part of the tension is that of the stitch itself, so it need not
 * end. */
static bool slacken(trainee *t, int loop, int parts)
{
    if (parts > 0 && !trainee_follow(t, true)) {
        return false;
    }
    for (int i = 0, more = t->is_later ? LOOSENED : 2; i < parts && more > 0; i++) {
        const double *n = trainee_see(t)->tension;
        int which = n[0] > n[1] ? loop : 1 - loop;
        vec toward = v_unit(v_sub(t->slit, trainee_see(t)->tip[which]));
        if (!trainee_move(t, which, v_scale(SLACKENED, toward))) {
            return false;
        }
        more -= stronger(t) < LOCKED ? 1 : 0;
        trainee_say(t, "slackened");
    }
    return true;
}

/* The turn of a later throw is drawn round the tail, before both ends are pulled. */
static bool close_turn(trainee *t, int loop)
{
    for (int i = 0; i < 20 && stronger(t) < CLOSED; i++) {
        if (!draw_limb(t, loop, CLOSING)) {
            return false;
        }
    }
    return true;
}

static bool seat(trainee *t, int loop, double home)
{
    const bool is_open = t->is_later && !t->has_pulled && !t->is_crossed;
    t->has_pulled = true;
    t->is_wound = false;
    if (is_open && !close_turn(t, loop)) {
        return false;
    }
    for (int i = 0; i < 60 && is_goal(t, VBSS_SESSION_GOAL_SEAT); i++) {
        const vbss_session_coaching c = trainee_see(t)->coach;
        vec slit = v_load(c.point);
        t->slit = slit;
        if (!t->is_crossed && c.direction[0] * side_of(loop) < 0.0) {
            if (!trainee_follow(t, false) || !lesson_cross_hands(t, loop)) {
                return false;
            }
            continue;
        }
        double off = (t->is_crossed ? -side_of(loop) : side_of(loop)) * (slit.x - home);
        if (c.length > 0.0 && weaker(t) > LARGEST) {
            if (!slacken(t, loop,
                         AGAIN)) { /* harder, the slit opens again: once more from little */
                return false;
            }
            continue;
        }
        double step = weaker(t) < VERY_SLACK             ? SLACK
                      : c.force > SLACKER * c.pull_force ? HALF_SLACK
                      : weaker(t) > FIRM                 ? GENTLE
                                                         : TAUT;
        if (!pull_once(t, loop, c.force > 0.0 ? off : 0.0, step)) {
            return false;
        }
    }
    return true;
}

/* The slack tail becomes straight: a bent one whips out when it is let go, and opens the throw. It is drawn until it bears a little more. */
static bool straighten(trainee *t, int loop, double length)
{
    const double at_rest = trainee_see(t)->tension[0];
    if (!trainee_follow(t, false)) {
        return false;
    }
    for (int i = 0; i < PARTS; i++) {
        vec arm = v_sub(trainee_see(t)->tip[loop], t->slit);
        double missing = length - v_length(arm);
        bool is_straight = trainee_see(t)->tension[0] > 1.5 * at_rest + FELT || missing < 0.0;
        double by = is_straight ? -0.5 * SLACKENED : fmin(SLACKENED, missing);
        if (!trainee_move(t, loop, v_scale(by, v_unit(arm)))) {
            return false;
        }
        if (is_straight) {
            break;
        }
    }
    trainee_say(t, "straightened");
    return true;
}

/* A throw that is just seated springs open again when it is let go: it is pulled a little more, then both hands give way. If it has
 * sprung open even so, it is held. */
bool lesson_release_tail(trainee *t, int loop)
{
    for (int i = 0; i < 4 && t->has_pulled && weaker(t) < ENOUGH; i++) {
        if (!pull_once(t, loop, 0.0, GENTLE)) {
            return false;
        }
    }
    double far = v_distance(trainee_see(t)->tip[loop], t->slit);
    bool good = slacken(t, loop, t->has_pulled || stronger(t) > LOOSE ? PARTS : 0);
    good = good && (!t->has_pulled || straighten(t, loop, far - NEARLY));
    return is_goal(t, VBSS_SESSION_GOAL_RELEASE_TAIL)
               ? good && trainee_follow(t, false) && lesson_leave(t, loop)
               : good;
}

bool lesson_throw_part(trainee *t)
{
    const vbss_session_coaching *c = &trainee_see(t)->coach;
    int actor = c->tool == VBSS_METRICS_TOOL_LEFT ? LEFT : RIGHT;
    trainee_say(t, "throw");
    t->is_later = c->number > 0; /* something is tied already */
    if (is_goal(t, VBSS_SESSION_GOAL_WIND)) {
        return trainee_follow(t, false) && take_places(t, actor) && wind(t, actor);
    }
    if (is_goal(t, VBSS_SESSION_GOAL_TAKE_TAIL)) {
        return take_tail(t, actor);
    }
    if (is_goal(t, VBSS_SESSION_GOAL_DRAW_TAIL)) {
        t->home = point_of(t).x;
        return draw_tail(t, actor);
    }
    if (is_goal(t, VBSS_SESSION_GOAL_SEAT)) {
        return seat(t, actor, t->home);
    }
    return is_goal(t, VBSS_SESSION_GOAL_RELEASE_TAIL) && trainee_jaws(t, actor, false);
}

void lesson_throw(trainee *t)
{
    (void)trainee_finish_motion(t);
    for (int i = 0; i < 30 && lesson_throw_part(t); i++) {
    }
}
