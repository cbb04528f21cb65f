/* Closing jaws on the thread: open they come along their own line, with the thread between them. */
#ifndef VBSS_EXAMPLES_THROW_CATCH_H
#define VBSS_EXAMPLES_THROW_CATCH_H

#include "throw/senses.h"

typedef enum catch_state {
    CATCH_COME,    /* to before the place */
    CATCH_ADVANCE, /* the thread between the jaws */
    CATCH_CLOSE,
    CATCH_BACK, /* off what they push, to come again */
    CATCH_HELD,
    CATCH_MISSED
} catch_state;

typedef struct catch_run {
    senses *see;
    hand *hand;
    catch_state state;
    uint32_t node;  /* where it shall be held */
    double behind;  /* m from the tip to it */
    double opening; /* of the handle, before */
    double speed;   /* m/s, on the way there */
    bool resolute;  /* closes in the end even if the thread is not quite between */
    double minds;   /* N: feeling more, they draw back; 0: nothing */
    vec correction; /* of the aim, by what is seen */
    vec begun;      /* the tip, when it began to advance */
    vec off;        /* to where it goes back */
    double pushed;  /* s, that the hand has felt more than it should */
    double since;
    int tries;
} catch_run;

void catch_begin(catch_run *t, senses *see, hand *h, uint32_t node, double opening, double speed);
void catch_step(catch_run *t, double dt);
/* To where the jaws' handle's end shall point so that they close across the thread at a node, clear of drain and
 * floor, without much rolling. */
vec catch_point(const senses *s, const hand *h, uint32_t node);

#endif
