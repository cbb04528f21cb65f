/* After the last throw: W lets the tail go, is exchanged for shears away from the knot, and cuts both ends short. C
 * holds the limb up for it, all but slack; the tail stands out by itself. */
#ifndef VBSS_EXAMPLES_THROW_CUT_H
#define VBSS_EXAMPLES_THROW_CUT_H

#include "throw/catch.h"
#include "throw/ease.h"

typedef enum cut_state {
    CUT_EASE,     /* hardly taut any longer */
    CUT_RELEASE,  /* W lets the tail go and withdraws */
    CUT_LEAVE,    /* to where tools are exchanged */
    CUT_EXCHANGE, /* shears for jaws */
    CUT_LIMB,     /* which C holds up */
    CUT_AWAY,     /* C with the piece */
    CUT_TAIL,     /* which nobody holds */
    CUT_WITHDRAW,
    CUT_DONE,
    CUT_FAILED,
    CUT_STATES
} cut_state;

typedef struct cut_run {
    senses *see;
    cut_state state;
    double since;
    catch_run grip;
    uint32_t cuts;               /* before this one */
    int ends;                    /* cut so far */
    double left_tail, left_limb; /* m from the knot, as cut */
    vec from, back;              /* where W lets go, and how it withdraws */
    double clear; /* m off the drain, where blades may cut; 0 from cut_begin: anywhere */
    ease_run easing;
} cut_run;

vbss_result cut_begin(cut_run *t, senses *see);
const char *cut_state_name(cut_state state);
vbss_result cut_step(cut_run *t, double dt);

#endif
