/* Mistakes that the surgeon makes knowingly, what the session must say of them, and what becomes of them. */
#ifndef VBSS_EXAMPLES_SURGEON_MISTAKE_H
#define VBSS_EXAMPLES_SURGEON_MISTAKE_H

#include <stdbool.h>

#include <vblast_ss/session_coaching.h>

#include "throw/throw.h"

typedef enum surgeon_mistake {
    SURGEON_NO_MISTAKE,
    SURGEON_WITHDRAWN, /* the needle is drawn back out of the first wall */
    SURGEON_MISSED, /* both walls are pierced 3 mm beside their marks, and the fork is set there */
    SURGEON_TORN,   /* the needle is in both walls, and the hand lifts it */
    SURGEON_IDLE,   /* nothing is done, until the time is up */
    SURGEON_SLACK,  /* the first throw is not drawn tight */
    SURGEON_KEPT,   /* the right hand keeps the needle, and winds the second throw, too */
    SURGEON_GRANNY, /* the second throw is wound the other way */
    /* in the first throw: */
    SURGEON_HANDLE,   /* each turn is nearer to the handle than the last */
    SURGEON_COUNTER,  /* the last turns are wound back again */
    SURGEON_BIGHT,    /* the tail is taken in its middle */
    SURGEON_DROPPED,  /* the tail is let go before its end is through */
    SURGEON_ONE_SIDED /* one hand alone pulls */
} surgeon_mistake;

/* What becomes of a mistake if the coach is followed. */
typedef enum surgeon_remedy {
    REMEDY_WORKS, /* the coach takes it back */
    REMEDY_NONE,  /* the coach says that it cannot be mended, and the task goes on */
    REMEDY_FAILED /* the task has failed */
} surgeon_remedy;

const char *surgeon_mistake_name(surgeon_mistake mistake);
/* SURGEON_NO_MISTAKE: there is none of that name. */
surgeon_mistake surgeon_mistake_named(const char *name);
/* What shall be said of it, in words. */
const char *surgeon_mistake_wanted(surgeon_mistake mistake);
/* What the hands do wrong in a throw; THROW_NO_MISTAKE: it is not one of a throw. */
throw_mistake surgeon_mistake_in_throw(surgeon_mistake mistake);
/* Under what name the coach gives it first. */
vbss_session_mistake surgeon_mistake_coached(surgeon_mistake mistake);
surgeon_remedy surgeon_mistake_remedy(surgeon_mistake mistake);
/* Whether the session says so, after the surgeon has stopped. */
bool surgeon_mistake_is_reported(surgeon_mistake mistake, vbss_session *session,
                                 vbss_metrics *metrics);
/* Whether the coach has said so and, if it can be mended, has taken it back since. */
bool surgeon_mistake_is_mended(surgeon_mistake mistake, vbss_session *session);

#endif
