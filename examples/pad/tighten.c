/* The second hand pulls a bite of the running suture tight, by what it feels and by how the lips look. */
#include "pad.h"

#include <math.h>

static const double guiding = 0.15 /* N: while the thread is drawn, and the needle comes down */,
                    firm = 0.3 /* N, at least: less leaves thread slack behind its holes */,
                    slack = 0.05 /* N: folded lips come back */,
                    largest = 0.5 /* N, to close the lips */, rising = 0.4 /* N/s */,
                    speed = 60e-3 /* m/s */;
/* Lips that touch are 0.40 mm apart, a fifth of the skin's thickness (docs/explanation/drain-contact.md). */
static const double touching = 0.45e-3 /* m, across the incision */,
                    folded = 0.6e-3 /* m: lips that had touched, and were pressed too hard */;
static const double lowering = 0.8 /* s: the needle comes down */, kept = 0.3 /* s, of shut lips */,
                    rest = 0.3 /* s, of lips that are flat again */,
                    patience = 6.0 /* s, more than the script has */;
static const double less = 0.8; /* of the force at which they folded */

bool pad_follows(const pad *p)
{
    return p->tension < guiding;
}

/* The lips have folded: the hand eases until they are flat, and pulls less the next time. */
static void ease(pad *p, bool is_off)
{
    pad_tightening *t = &p->tightening;
    if (is_off && t->easing == 0.0) {
        t->largest = less * fmax(p->tension, guiding);
        t->easing = PAD_STEP;
    } else if (t->easing > 0.0 && !is_off && p->tension < guiding) {
        t->easing += PAD_STEP;
    }
    if (t->easing > rest) {
        t->easing = 0.0;
        t->have_met = false;
        t->wanted = guiding;
    }
}

void pad_tighten(pad *p)
{
    pad_tightening *t = &p->tightening;
    if (p->since == 0.0) {
        *t = (pad_tightening){.largest = largest};
    }
    const vec3 across = pad_across(p, pad_place(p->bite));
    const bool is_shut = fabs(across.x) < touching;
    const double enough = fmin(firm, t->largest);
    ease(p, t->have_met && vec3_norm(across) > folded);
    t->have_met = t->have_met || is_shut;
    if (p->since <= lowering || t->easing > 0.0) {
        t->wanted = t->easing > 0.0 ? slack : guiding;
    } else if (!is_shut || t->wanted < enough) {
        t->wanted = fmin(t->wanted + rising * PAD_STEP, t->largest);
    }
    const bool is_firm = is_shut && t->wanted >= enough;
    t->shut = is_firm && t->easing == 0.0 ? t->shut + PAD_STEP : 0.0;
    const double lacking = 1.0 - p->tension / t->wanted;
    p->pulled += speed * PAD_STEP * fmax(-1.0, fmin(is_firm ? 0.0 : 1.0, 4.0 * lacking));
}

bool pad_waits(pad *p)
{
    const bool is_over = p->since > pad_phase_time(p->bite, PAD_TIGHTEN) - 2.0 * PAD_STEP;
    if (p->is_tying || p->phase != PAD_TIGHTEN || p->bite == 0 || !is_over) {
        return false;
    }
    p->tightening.waited += PAD_STEP;
    return p->tightening.shut < kept && p->tightening.waited < patience;
}
