/* Throws, by the words of the coach. What the coach does not say is how tools are held and where the hand without the goal goes;
 * the guide "By mouse" does. */
#include "trainee/trainee.h"

#include <math.h>

#define BESIDE \
    32e-3 /* m, of the needle from the tool that it is to be wound about: on the near side, */
#define BELOW 12e-3   /* and lower */
#define BEHIND 10e-3  /* behind that tool's tip */
#define ABOVE 15e-3   /* over the tail */
#define TOGETHER 8e-3 /* of one hand before the other follows */
#define RISING 0.4    /* of the needle over the jaws, of its distance from them, at least */
#define NEAREST 15e-3
#define SWEPT 12e-3  /* of the tail from where it was seen, */
#define OVER 20e-3   /* then the jaws go as high */
#define GIVEN 15e-3  /* before the last part of it */
#define SPARE 3e-3   /* of the limb on that path */
#define MISSED 25e-3 /* of the jaws from a tail that they have closed beside, at most */
#define STRIDE \
    30e-3 /* of the mouse when it winds: a longer one pulls on with a limb that has become taut */
#define WAITS 130      /* frames, when turns have come off */
#define DRAWN 3e-3     /* of the tail at a time */
#define SHORTER 1e-3   /* of its jaws to the slit, in each movement, */
#define SHORT 0.75     /* down to this share: a tail that is taut drags the drain along */
#define TAKEN_UP 6e-3  /* of the limb at a time */
#define LIGHT 0.1      /* N, of the limb then */
#define TAUT 1.5e-3    /* of the limb at a time while both ends are taut, */
#define SLACK 6e-3     /* and while one is slack: it misses */
#define SLACKER 0.88   /* more of the force */
#define FAR 0.15       /* from the slit, to where the hands pull */
#define LOW 20e-3      /* of the tail below the slit, 70 mm from it */
#define ENOUGH 1.2     /* N, of both ends: pulled harder, the slit opens again */
#define GENTLE 0.8e-3  /* of each hand at a time in the end */
#define SLACKENED 1e-3 /* of each hand at a time before the tail is let go, */
#define LOCKED 0.6     /* N, of both ends then: so much the stitch itself may hold */
#define LOOSE 0.1      /* N, of an end that does not pull */
#define HANGS 1.0      /* N, of both ends while the tail is drawn: a turn hangs on the jaws */
#define NUDGED 1e-3    /* of the tail at a time then */
#define OFF 1.5e-3     /* of the slit from its place */
#define LARGEST 1.5    /* N, of both ends: pulled harder, the edges slip past each other */
#define FIRM 0.5       /* N, of both ends: gently from there */
#define HARD 1.0       /* N, of an end */
#define HARD_LATER 0.3 /* of a later throw */
#define UNLIKE 1.5     /* times the other end's tension */
#define CLEAR 18e-3    /* of the tips from each other */
#define HALF_TURN 3.14159265358979

enum {
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

/* The jaws with the turns go, and after each part the needle, so that the limb stays as long from slit to jaws to needle: a slack turn
 * falls off. */
static bool go_together(trainee *t, int loop, vec by)
{
    const int limb = 1 - loop, parts = (int)ceil(v_length(by) / TOGETHER);
    vec jaws = trainee_see(t)->tip[loop], arm = v_sub(trainee_see(t)->swage, jaws);
    const double whole = v_distance(jaws, t->slit) + v_length(arm) - SPARE;
    arm.z = fmax(arm.z, RISING * v_length(arm)); /* not into the drain */
    arm = v_unit(arm);
    for (int i = 0; i < parts; i++) {
        if (!trainee_move(t, loop, v_scale(1.0 / parts, by))) {
            return false;
        }
        jaws = trainee_see(t)->tip[loop];
        double far = fmax(whole - v_distance(jaws, t->slit), NEAREST);
        vec to = v_sub(v_along(jaws, far, arm), trainee_see(t)->swage);
        if (!trainee_move(t, limb, to)) {
            return false;
        }
        trainee_say(t, "together");
    }
    return true;
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

/* Something is tied already. */
static bool is_later(const trainee *t)
{
    return trainee_see(t)->coach.number > 0;
}

/* The needle comes nearer, so that the jaws can go on to the tail alone: the limb would be pulled, and the slit opens. */
static bool bring_needle(trainee *t, int loop)
{
    vec to = v_sub(trainee_see(t)->tip[loop], trainee_see(t)->swage);
    return trainee_move(t, 1 - loop, v_scale(GIVEN, v_unit(to)));
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
    return good && (!goes_together || !is_later(t) || bring_needle(t, loop)) &&
           trainee_turn(t, loop, toward_tail(t, loop)) && trainee_jaws(t, loop, false) &&
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
        bool good = (i > 0 || go_over_tail(t, loop)) && go_along_jaws(t, loop, -6e-3, 1e-3) &&
                    go_along_jaws(t, loop, 2e-3, 0.6e-3) && trainee_jaws(t, loop, true);
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
static bool draw_tail(trainee *t, int loop)
{
    double side = side_of(loop);
    bool turned = false;
    /* Taking up the limb, or shortening the tail, would open the throw below. */
    const bool later = is_later(t);
    vec slit = point_of(t);
    vec over =
        v_add(slit, later ? v3(-15e-3 * side, 10e-3, 30e-3) : v3(-28e-3 * side, 15e-3, 30e-3));
    if (later && v_distance(over, trainee_see(t)->tip[loop]) < CLEAR) {
        over.y = slit.y - 15e-3; /* there the other hand has a tail that stands up */
    }
    vec beside = trainee_see(t)->tip[1 - loop];
    beside.z = fmax(beside.z, over.z); /* the needle comes over the drain, not through it */
    if (!trainee_go(t, 1 - loop, beside, 5e-3) || !trainee_go(t, 1 - loop, over, 5e-3)) {
        return false;
    }
    vec arm = v_sub(trainee_see(t)->tip[loop], slit);
    double radius = sqrt(arm.x * arm.x + arm.z * arm.z), angle = atan2(arm.z, side * arm.x);
    angle += angle < -0.5 * HALF_TURN ? 2.0 * HALF_TURN : 0.0;
    double full = radius;
    const bool is_beside = angle < 0.25 * HALF_TURN; /* the tail is on its own side already */
    t->slit = slit;
    t->has_pulled = t->is_crossed = false;
    for (int i = 0; i < 60 && is_goal(t, VBSS_SESSION_GOAL_DRAW_TAIL); i++) {
        if (!turned && angle < 0.5 * HALF_TURN) {
            turned =
                trainee_turn(t, loop, v3(-side, 0.0, 0.0)); /* or the last turn hangs on them */
        }
        if ((!later || is_beside) && angle <= 0.0 && trainee_see(t)->tension[1] < LIGHT &&
            (is_beside || i % 2 == 0)) {
            if (!take_up(t, loop, slit)) {
                return false;
            }
            continue;
        }
        radius = angle <= 0.0 ? radius + DRAWN
                 : later      ? radius
                              : fmax(radius - SHORTER, SHORT * full);
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

/* Which hand rests: that of the end that bears much more, as its colour shows, or the one to whose side the slit has gone. */
typedef struct pull_plan {
    bool limb_rests, tail_rests;
} pull_plan;

static pull_plan choose_pull(const trainee *t, double off)
{
    const double *n = trainee_see(t)->tension;
    /* A throw on another one locks under an end that pulls alone. */
    const double hard = is_later(t) ? HARD_LATER : HARD;
    bool limb = n[1] > hard && n[1] > UNLIKE * n[0], tail = n[0] > hard && n[0] > UNLIKE * n[1];
    /* An end that is slack has not drawn the slit along. */
    return limb || tail ? (pull_plan){limb, tail}
                        : (pull_plan){off < -OFF && n[1] > LOOSE, off > OFF && n[0] > LOOSE};
}

/* One hand after the other pulls, the tail half as far. */
static bool pull_once(trainee *t, int loop, vec slit, pull_plan p, double step)
{
    double side = t->is_crossed ? -side_of(loop) : side_of(loop);
    vec limb = v_add(slit, v3(-side * FAR, 0.0, 7e-3)),
        tail = v_add(slit, v3(side * FAR, 0.0, -LOW * FAR / 70e-3));
    limb = v_scale(step, v_unit(v_sub(limb, trainee_see(t)->tip[1 - loop])));
    tail = v_scale(0.5 * step, v_unit(v_sub(tail, trainee_see(t)->tip[loop])));
    bool good = (p.limb_rests || trainee_move(t, 1 - loop, limb)) &&
                (p.tail_rests || trainee_move(t, loop, tail));
    trainee_say(t, p.tail_rests ? "pulled the limb" : p.limb_rests ? "pulled the tail" : "pulled");
    return good;
}

/* Both hands toward the slit in small equal parts, in turns, and a little more when nothing pulls. A part of the tension is that of the
 * stitch itself, so it need not end. */
static bool slacken(trainee *t, int loop, int parts)
{
    for (int i = 0, more = 2; i < parts && more > 0; i++) {
        for (int k = 0; k < 2; k++) {
            int which = k == 0 ? 1 - loop : loop;
            vec toward = v_unit(v_sub(t->slit, trainee_see(t)->tip[which]));
            if (!trainee_move(t, which, v_scale(SLACKENED, toward))) {
                return false;
            }
        }
        more -= stronger(t) < LOCKED ? 1 : 0;
        trainee_say(t, "slackened");
    }
    return true;
}

static bool seat(trainee *t, int loop, double home)
{
    t->has_pulled = true;
    t->is_wound = false;
    for (int i = 0; i < 60 && is_goal(t, VBSS_SESSION_GOAL_SEAT); i++) {
        const vbss_session_coaching c = trainee_see(t)->coach;
        vec slit = v_load(c.point);
        t->slit = slit;
        if (!t->is_crossed && c.direction[0] * side_of(loop) < 0.0) {
            if (!lesson_cross_hands(t, loop)) {
                return false;
            }
            continue;
        }
        double off = (t->is_crossed ? -side_of(loop) : side_of(loop)) * (slit.x - home);
        pull_plan p = choose_pull(t, c.force > 0.0 ? off : 0.0);
        if (c.length > 0.0 && weaker(t) > LARGEST) {
            if (!slacken(t, loop,
                         AGAIN)) { /* harder, the slit opens again: once more from little */
                return false;
            }
            continue;
        }
        double step = c.force > SLACKER * c.pull_force ? SLACK : weaker(t) > FIRM ? GENTLE : TAUT;
        if (!pull_once(t, loop, slit, p, step)) {
            return false;
        }
    }
    return true;
}

/* A throw that is just seated springs open again when it is let go: it is pulled a little more, then both hands give way. If it has
 * sprung open even so, it is held. */
bool lesson_release_tail(trainee *t, int loop)
{
    for (int i = 0; i < 4 && t->has_pulled && weaker(t) < ENOUGH; i++) {
        if (!pull_once(t, loop, t->slit, choose_pull(t, 0.0), GENTLE)) {
            return false;
        }
    }
    bool good = slacken(t, loop, t->has_pulled || stronger(t) > LOOSE ? PARTS : 0);
    return is_goal(t, VBSS_SESSION_GOAL_RELEASE_TAIL) ? good && lesson_leave(t, loop) : good;
}

bool lesson_throw_part(trainee *t)
{
    const vbss_session_coaching *c = &trainee_see(t)->coach;
    int actor = c->tool == VBSS_METRICS_TOOL_LEFT ? LEFT : RIGHT;
    trainee_say(t, "throw");
    if (is_goal(t, VBSS_SESSION_GOAL_WIND)) {
        return take_places(t, actor) && wind(t, actor);
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
