/* How the left wall gives way to the needle, and what the hands try next. */
#include "needle/stitch_parts.h"

#define FELT 2.5  /* N: a hand that feels more draws back */
#define BEARS 0.1 /* N: a hand whose fork bears the wall feels more, once that is pressed for */
#define PUSHED_OUT 10e-3 /* m beyond the right mark; a wall that is borne is pierced after 7 to 9 */
#define PRESSED 0.5      /* so many s */
#define SQUARE \
    0.75 /* cosine between needle and wall, beyond which the needle was square to it once; */
#define ASLANT 0.25      /* so much of it is lost when the wall tips over */
#define NEAR 1.5e-3      /* of the tip to the middle of the wall, when it presses on that */
#define FORK_MOVED 2e-3  /* at most */
#define ELSEWHERE 0.4e-3 /* up, down, farther up: where the wall tips over it */
#define BESIDE 1e-3      /* along the drain, when all places have been tried in vain */

enum { AGAIN = 10 };   /* to come back to the left */
enum { RESTARTS = 3 }; /* of the whole stitch */
enum { PLACES = 5 };   /* of the fork on the left wall */

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
    bool leaves = t->since > PRESSED && stitch_felt(&t->left) < BEARS;
    const bool wedges = stitch_felt(&t->right) > FELT || t->gone > PUSHED_OUT;
    return leaves ? LEAVES : wedges ? WEDGES : HOLDS;
}

/* The needle is withdrawn, and the right wall is entered again: the first hole may be the cause, since it is oblique or far from its mark. */
void stitch_restart(stitch *t)
{
    if (++t->restart_count > RESTARTS) {
        stitch_fail(t, "the left wall gives way");
        return;
    }
    t->again = t->fork_returns = t->relieved = 0;
    t->withdraws = t->restarts = true;
    stitch_enter_state(t, STITCH_EASE);
}

void stitch_restart_if_often_tried(stitch *t)
{
    if (t->again > AGAIN) {
        stitch_restart(t);
    }
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
        t->fork = v_along(t->fork, -STITCH_FORK_LOWER, up);
    } else if (t->square > 0.0) { /* it has pressed */
        double higher = v_dot(t->pressed, up) + 0.5 * STITCH_FORK_LOWER;
        double aside = v_dot(v_sub(t->pressed, t->beside), along);
        t->fork = v_scale(clamp(aside, -FORK_MOVED, FORK_MOVED), along);
        t->fork = v_along(t->fork, clamp(higher, -STITCH_FORK_LOWER, STITCH_FORK_LOWER), up);
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
    stitch_enter_state(t, STITCH_EASE);
    stitch_restart_if_often_tried(t);
}

void stitch_retry_if_wall_yields(stitch *t)
{
    const yielding how = check_yielding(t);
    if (how != HOLDS) {
        try_again(t, how);
    }
}
