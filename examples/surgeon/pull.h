/* The left hand takes the needle's tip, draws the needle out of both walls along its arc and hands it back; the right hand draws
 * the thread after it until the tail is short. */
#ifndef VBSS_EXAMPLES_SURGEON_PULL_H
#define VBSS_EXAMPLES_SURGEON_PULL_H

#include "needle/stitch.h"

#define PULL_TAIL 18.5e-3 /* length of the tail in the end, m */

typedef enum pull_state {
    PULL_REACH, /* the left hand to before the tip */
    PULL_ONTO,  /* its jaws on either side */
    PULL_CLOSE,
    PULL_PART, /* the right hand lets go and leaves */
    PULL_TURN, /* the needle out of both walls, along its arc */
    PULL_LIFT,
    PULL_OFFER,  /* where the right hand can take it */
    PULL_ASK,    /* that comes */
    PULL_ACCEPT, /* its jaws on either side */
    PULL_TAKE,
    PULL_GIVE, /* the left hand lets go and leaves */
    PULL_DRAW, /* until the tail is short */
    PULL_EASE, /* until the thread is slack, so that the slit stands open again */
    PULL_DONE,
    PULL_FAILED
} pull_state;

typedef struct pull_run {
    stitch *stitch;
    pull_state state;
    double since;
    const char *why;
    pose held;         /* the needle in the frame of the pose that its bearer is commanded to */
    pose from;         /* of the needle, when a motion begins */
    pose back;         /* of a tool that leaves */
    double turned;     /* rad */
    double drawn;      /* m, of the swage from the left hole */
    double retraction; /* m, back from there */
    double slack;      /* s, that the right hand has felt nothing */
    double tail;       /* m, as seen */
    bool jammed;       /* the tail is longer than it should be, and holds */
} pull_run;

void pull_begin(pull_run *p, stitch *t);
void pull_step(pull_run *p, double dt);
/* From the right hole on; -1: no thread is in it. */
double pull_tail(const stitch *t);
const char *pull_name(pull_state state);

#endif
