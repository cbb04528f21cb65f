/* The pull from behind: both hands go round the slit to where the throw below was pulled from, the tail's hand by the near side and the
 * needle's hand by the far one, with both ends slack. From there what is below is drawn tight again; pulled flat it stays open. */
#include "trainee/trainee.h"

#include <math.h>

#define SHARE 0.75   /* of an end's length: its hand is so far from the slit on its path */
#define LOW 4e-3     /* m over the slit, of the tail's hand, */
#define HIGH 25e-3   /* of the needle's hand on its path, */
#define LOWERED 8e-3 /* and at its end */
#define OVER 4e-3    /* of both hands as they come round with tense ends */
#define LIGHT 0.5    /* N, of an end: a little more, */
#define HEAVY 1.5    /* and a little less */
#define MORE 1e-3    /* m, outward */

enum { PARTS = 4, TENSE_PARTS = 20 };

static const double pi = 3.14159265358979;

/* Half a round about the slit, from the side at `from` (-1: left), by the side at `by` (-1: near), at that distance and height. */
static bool go_round(trainee *t, int which, double from, double by, double far, double height)
{
    for (int i = 0; i <= PARTS; i++) {
        double angle = pi * i / PARTS;
        vec to = v_add(t->slit, v3(from * far * cos(angle), by * far * sin(angle), height));
        if (!trainee_go(t, which, to, 3e-3)) {
            return false;
        }
        trainee_say(t, "round the slit");
    }
    return true;
}

static double distance_from_slit(const trainee *t, int which)
{
    return v_distance(trainee_see(t)->tip[which], t->slit);
}

bool lesson_cross_hands(trainee *t, int loop)
{
    int limb = 1 - loop;
    double side = loop == LEFT ? -1.0 : 1.0;
    double of_tail = SHARE * distance_from_slit(t, loop),
           of_limb = SHARE * distance_from_slit(t, limb);
    /* No shaft lies over the slit: the tail's tool comes from the near side, the needle's from above. */
    bool good = trainee_go(t, limb, v_add(t->slit, v3(-side * of_limb, 0.0, HIGH)), 5e-3) &&
                trainee_turn(t, limb, v_unit(v3(side, 0.0, -0.5))) &&
                trainee_go(t, loop, v_add(t->slit, v3(side * of_tail, 0.0, LOW)), 3e-3) &&
                trainee_turn(t, loop, v_unit(v3(-0.2 * side, 0.9, -0.35))) &&
                go_round(t, loop, side, -1.0, of_tail, LOW) &&
                go_round(t, limb, -side, 1.0, of_limb, HIGH) &&
                trainee_go(t, limb, v_add(t->slit, v3(side * of_limb, 0.0, LOWERED)), 5e-3);
    t->is_crossed = true;
    trainee_say(t, "hands crossed");
    return good;
}

/* ---- and round again, with both ends tense */

/* Keeps the tension of an end: outward or inward. */
static bool hold_tension(trainee *t, int which, int end)
{
    double tension = trainee_see(t)->tension[end];
    double more = tension < LIGHT ? MORE : tension > HEAVY ? -MORE : 0.0;
    vec out = v_sub(trainee_see(t)->tip[which], t->slit);
    return more == 0.0 || trainee_move(t, which, v_scale(more, v_unit(v3(out.x, out.y, 0.0))));
}

/* A part of the half round, about the slit as it is seen, at the hand's distance from it. */
static bool go_part(trainee *t, int which, double turn)
{
    vec out = v_sub(trainee_see(t)->tip[which], t->slit);
    vec to = v3(out.x * cos(turn) - out.y * sin(turn), out.x * sin(turn) + out.y * cos(turn),
                out.z < OVER ? OVER : out.z);
    return trainee_move(t, which, v_sub(to, out));
}

static bool has_come_round(const trainee *t, int loop)
{
    double own = loop == LEFT ? -1.0 : 1.0;
    vec tail = v_sub(trainee_see(t)->tip[loop], t->slit),
        limb = v_sub(trainee_see(t)->tip[1 - loop], t->slit);
    return own * tail.x > 0.0 && own * limb.x < 0.0 && fabs(tail.y) < 0.15 * fabs(tail.x) &&
           fabs(limb.y) < 0.15 * fabs(limb.x);
}

/* What is left to turn until a hand is on its own side, a part of the half round at most. */
static double left_to_turn(const trainee *t, int which, double own, double turn)
{
    vec out = v_sub(trainee_see(t)->tip[which], t->slit);
    double left = atan2(-own * out.y, own * out.x);
    left = turn > 0.0 && left < -0.5 * pi ? left + 2.0 * pi : left;
    left = turn < 0.0 && left > 0.5 * pi ? left - 2.0 * pi : left;
    return fabs(left) < fabs(turn) || left * turn < 0.0 ? left : turn;
}

bool lesson_come_round(trainee *t, int loop)
{
    double side = loop == LEFT ? -1.0 : 1.0, turn = side * pi / TENSE_PARTS;
    for (int i = 0; i < TENSE_PARTS + 4 && !has_come_round(t, loop); i++) {
        t->slit = v_load(trainee_see(t)->coach.point);
        if (!go_part(t, 1 - loop, left_to_turn(t, 1 - loop, -side, turn)) ||
            !go_part(t, loop, left_to_turn(t, loop, side, turn)) || !hold_tension(t, loop, 0) ||
            !hold_tension(t, 1 - loop, 1)) {
            return false;
        }
        trainee_say(t, "comes round");
    }
    t->is_crossed = false;
    return true;
}
