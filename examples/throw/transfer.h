/* Between two throws: the tail is let go, and the limb changes hands, as it does between the throws of a square
 * knot. Afterwards who held the tail is C and who held the limb is W, and both see the world in a mirror. */
#ifndef VBSS_EXAMPLES_THROW_TRANSFER_H
#define VBSS_EXAMPLES_THROW_TRANSFER_H

#include "throw/catch.h"

typedef enum transfer_state {
    TRANSFER_EASE,    /* nothing is taut any longer */
    TRANSFER_RELEASE, /* W lets the tail go and withdraws */
    TRANSFER_OFFER,   /* C holds the limb up */
    TRANSFER_TAKE,    /* W takes the limb, beyond C's jaws */
    TRANSFER_GIVE,    /* C lets go and withdraws */
    TRANSFER_DONE,
    TRANSFER_FAILED
} transfer_state;

typedef struct transfer_run {
    senses *see;
    transfer_state state;
    double since;
    int tries, misses; /* to be rid of the limb; to take it */
    catch_run grip;
    vec from, back, aside; /* where a hand lets go or missed, and how it withdraws */
} transfer_run;

void transfer_begin(transfer_run *t, senses *see);
const char *transfer_state_name(transfer_state state);
vbss_result transfer_step(transfer_run *t, double dt);

#endif
