/* Between two throws: both hands ease, the tail is let go, and the needle goes into the other hand. Afterwards who pulled
 * the tail has the needle, and both see the world in a mirror, so that the next throw is the same work. */
#ifndef VBSS_EXAMPLES_SURGEON_HAND_OVER_H
#define VBSS_EXAMPLES_SURGEON_HAND_OVER_H

#include "needle/stitch.h"
#include "throw/ease.h"

typedef enum hand_over_state {
    HAND_OVER_EASE,       /* nothing is taut any longer */
    HAND_OVER_STRAIGHTEN, /* W draws the slack out of the tail */
    HAND_OVER_RELEASE,    /* W lets the tail go and withdraws */
    HAND_OVER_SPRUNG,     /* it has: the throw has sprung open, and is to be pulled again */
    HAND_OVER_OFFER,      /* C holds the needle up */
    HAND_OVER_ASK,        /* W comes to before it */
    HAND_OVER_ACCEPT,     /* its jaws on either side */
    HAND_OVER_TAKE,
    HAND_OVER_GIVE, /* C lets go and leaves */
    HAND_OVER_DONE,
    HAND_OVER_FAILED
} hand_over_state;

typedef struct hand_over {
    stitch *stitch;
    senses *see;
    hand_over_state state;
    double since;
    const char *why;
    bool again;  /* a throw that springs open as the tail is let go is to be pulled again */
    double slit; /* as it is, m */
    uint32_t tail_root, limb_root; /* where tail and limb came out of the knot */
    double slit_held, gape_held;   /* of slit and throw before the tail was let go, m */
    bool kept; /* the needle stays where it is; the tail is let go all the same */
    ease_run easing;
    vec from, from_handle; /* where W lets go, and how it withdraws */
    pose held;             /* the needle in the frame of what its bearer was told */
    pose offered;
    pose back; /* of the tool that leaves */
} hand_over;

vbss_result hand_over_begin(hand_over *o, stitch *t, senses *see);
/* With no tail in W's jaws: the needle changes hands. */
vbss_result hand_over_begin_at_needle(hand_over *o, stitch *t, senses *see);
vbss_result hand_over_step(hand_over *o, double dt);
const char *hand_over_name(hand_over_state state);

#endif
