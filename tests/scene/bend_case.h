/* What the tests of bends share: one bend, pulled until it is decided whether it holds. */
#ifndef VBSS_TESTS_SCENE_BEND_CASE_H
#define VBSS_TESTS_SCENE_BEND_CASE_H

#include "fixtures/bend.h"
#include "harness/harness.h"

typedef struct bend_outcome {
    bend_result result;
    double force;     /* mean in the window if it slips, N */
    double overlap;   /* deepest of all steps, diameters */
    uint64_t clamped; /* truncated substeps */
} bend_outcome;

bend_outcome bend_case_run(bend_kind kind, double friction, double step, double segment,
                           vbss_scene_mode mode);

#endif
