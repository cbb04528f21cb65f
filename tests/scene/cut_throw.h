/* A throw drawn tight that blades close on, and go through all strands of while hands go on pulling. */
#ifndef VBSS_TEST_CUT_THROW_H
#define VBSS_TEST_CUT_THROW_H

#include "scene/cut_rig.h"
#include "fixtures/contact_scenes.h"

typedef struct cut_case {
    knot_kind kind;
    bool limited; /* as scenes are by default; else with all the work it takes */
    double length, min_cuts, clamped, paused; /* m; at most the last two, steps and s */
} cut_case;

typedef struct cut_outcome {
    double cuts, clamped, paused, fastest; /* m/s: of any node */
    double shortened; /* largest compression of a segment, relative to its length */
} cut_outcome;

/* With that share of the default limit of work, if it is limited. */
cut_outcome cut_throw(const cut_case *t, double share);
/* With the default limit of work: all that `bars` ask, but for the waiting, which is known to be `paused`, s. */
void cut_expect_within_known(const cut_case *bars, double paused);
void cut_expect_within(const cut_outcome *found, const cut_case *bars);

#endif
