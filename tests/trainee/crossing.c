/* The pull from behind: both hands go round the slit to where the throw below was pulled from, the tail's hand by the near side and the
 * needle's hand by the far one, with both ends slack. Pulled from
 * there, the new throw draws the one below tight. Pulled with each hand on its own side, it leaves that one open. */
#include "trainee/trainee.h"

#include <math.h>

#define SHARE 0.75   /* of an end's length: its hand is so far from the slit on its path */
#define LOW 4e-3     /* m over the slit, of the tail's hand, */
#define HIGH 25e-3   /* of the needle's hand on its path, */
#define LOWERED 8e-3 /* and at its end */

enum { PARTS = 4 };

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
