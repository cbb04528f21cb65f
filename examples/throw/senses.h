/* What the one who ties can see: the thread, the tools, where the long limb touches the tool that it is wound
 * about, and what knot it would be. All places in the frame of the one who ties: the long limb comes out on
 * the left, W (which will pull the tail) comes from the left. */
#ifndef VBSS_EXAMPLES_THROW_SENSES_H
#define VBSS_EXAMPLES_THROW_SENSES_H

#include "throw/hand.h"

typedef struct senses {
    throw_rig *rig;
    hand *w, *c;
    vbss_knot_detector *detector, *arbiter; /* with the tools; of the bare thread */
    vec x[MAX_THREAD_NODES];
    uint32_t nodes, shift;                 /* as the rig has them */
    uint32_t tail_root, limb_root, throws; /* where both come out of drain or knot; throws tied */
    hand_pose tool_w, tool_c;
    vec held_c;          /* where C holds the limb: between its jaws, or by the needle at its end */
    const double *parts; /* of W, as the view of capsules has them */
    double tension_w, tension_c; /* N, smoothed */
    /* Of that, what draws the jaws toward where the thread comes out: one that is bent pushes. */
    double draws_w, draws_c;
    uint32_t first, last;   /* nodes of the long limb that touch W; 0: none */
    double first_s, last_s; /* where along W from its tip, m */
    double turns;           /* signed, of the long limb about W, positive the way C goes */
    /* Of the contacts of the thread with itself: their mean, in the scene; above the drain that, the lowest, the
     * highest, m. */
    vec knot;
    double knot_height, knot_lowest, knot_highest;
} senses;

vbss_result senses_create(senses *s, throw_rig *st, hand *w, hand *c);
/* Every step. */
vbss_result senses_observe(senses *s);
/* Of that: tensions, from what the hands have felt. */
void senses_feel(senses *s);
/* Less often. */
vbss_result senses_wind(senses *s);
vbss_result senses_find_knot(senses *s);
/* Where C's tip is when it holds the limb up from its root in that direction, at a share of its length. */
vec senses_tip_holding_up(const senses *s, vec direction, double share);
/* Where the drain has gone, level: the middle of the thread's places in it, which is at the origin as it lies. */
vec senses_drain(const senses *s);
/* What the thread is, or, with the tools where they are and what they hold, will be. */
typedef struct senses_knot {
    vbss_knot_state state;
    char notation[32];
    int handedness; /* of the last throw */
    double slip;    /* of it, as the detector has it */
} senses_knot;
/* After a throw: from where tail and limb are free now. */
vbss_result senses_find_roots(senses *s);
vbss_result senses_judge(senses *s, bool with_tools, senses_knot *k);

/* The thread, and not what was cut off of it. */
static inline bool senses_holds(const senses *s, const hand *h)
{
    return h->holds && h->held_thread == s->rig->thread_body;
}

static inline double senses_length(const senses *s, uint32_t from, uint32_t to)
{
    (void)s;
    return SEGMENT * ((double)to - (double)from);
}

#endif
