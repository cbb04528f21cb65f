/* Both hands go back toward the knot until neither end draws at it any longer: slowly, so that it stays as it was pulled. */
#ifndef VBSS_EXAMPLES_THROW_EASE_H
#define VBSS_EXAMPLES_THROW_EASE_H

#include "throw/senses.h"

typedef struct ease_run {
    vec carrot_w, carrot_c;         /* where they go */
    double slack_w, slack_c, since; /* s; for so long */
} ease_run;

void ease_begin(ease_run *e, const senses *s);
/* True: both are slack, or it has taken too long. */
bool ease_step(ease_run *e, senses *s, double dt);

#endif
