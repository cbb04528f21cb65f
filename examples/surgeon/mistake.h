/* Mistakes that the surgeon makes knowingly, and what the session must say of them. */
#ifndef VBSS_EXAMPLES_SURGEON_MISTAKE_H
#define VBSS_EXAMPLES_SURGEON_MISTAKE_H

#include <stdbool.h>

#include <vblast_ss/session_coaching.h>

typedef enum surgeon_mistake {
    SURGEON_NO_MISTAKE,
    SURGEON_WITHDRAWN, /* the needle is drawn back out of the first wall */
    SURGEON_MISSED, /* both walls are pierced 3 mm beside their marks, and the fork is set there */
    SURGEON_TORN,   /* the needle is in both walls, and the hand lifts it */
    SURGEON_IDLE,   /* nothing is done, until the time is up */
    SURGEON_SLACK,  /* the first throw is not drawn tight */
    SURGEON_KEPT    /* the right hand keeps the needle, and winds the second throw, too */
} surgeon_mistake;

const char *surgeon_mistake_name(surgeon_mistake mistake);
/* SURGEON_NO_MISTAKE: there is none of that name. */
surgeon_mistake surgeon_mistake_named(const char *name);
/* What shall be said of it, in words. */
const char *surgeon_mistake_wanted(surgeon_mistake mistake);
/* Whether the session says so, after the surgeon has stopped. */
bool surgeon_mistake_is_reported(surgeon_mistake mistake, vbss_session *session,
                                 vbss_metrics *metrics);

#endif
