#include "throw/ease.h"

#include <math.h>

#define TAUT 0.03    /* N: less is slack */
#define A_MOMENT 0.3 /* s, that an end is */
#define LONGEST 3.0  /* s */

void ease_begin(ease_run *e, const senses *s)
{
    *e = (ease_run){.carrot_w = s->tool_w.tip, .carrot_c = s->tool_c.tip};
}

bool ease_step(ease_run *e, senses *s, double dt)
{
    e->since += dt;
    e->slack_w = s->draws_w < TAUT ? e->slack_w + dt : 0.0;
    e->slack_c = s->draws_c < TAUT ? e->slack_c + dt : 0.0;
    if (e->slack_w < A_MOMENT) {
        hand_yield(s->w, &s->tool_w, &e->carrot_w, s->x[s->tail_root], s->draws_w, dt);
    }
    if (e->slack_c < A_MOMENT) {
        hand_yield(s->c, &s->tool_c, &e->carrot_c, s->x[s->limb_root], s->draws_c, dt);
    }
    return smaller(e->slack_w, e->slack_c) >= A_MOMENT || e->since > LONGEST;
}
