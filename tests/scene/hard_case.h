/* What the hard cases share: a contact scene that is run under watch, measured, and told about. Every call that
 * fails, fails the test. */
#ifndef VBSS_TESTS_SCENE_HARD_CASE_H
#define VBSS_TESTS_SCENE_HARD_CASE_H

#include "harness/harness.h"
#include "oracle/knot_type.h"
#include "scene/watch.h"
#include "fixtures/contact_scenes.h"

enum { HARD_CASE_STEPS = 100000 };

typedef struct hard_case {
    const char *name;
    harness_memory memory;
    vbss_context *context;
    contact_scene scene;
    watch watch;
    double h;
    knot_type type; /* of the first thread, at first */
    bool typed;     /* it could be told */
    double
        deepest; /* overlap, measured from positions alone, as a share of the distance of touching */
    uint32_t steps;
    float cost[HARD_CASE_STEPS]; /* us; of the machine, so never asserted */
} hard_case;

/* The case must stay where it is until its end. */
void hard_begin(hard_case *c, const char *name, const contact_scene_options *options, double h);
void hard_run(hard_case *c, uint32_t steps);
/* Until all hands feel what they shall; false: not within so many steps. */
bool hard_pull(hard_case *c, uint32_t limit);
/* One line of what it was like. */
void hard_report(hard_case *c);
void hard_end(hard_case *c);

/* What every case must keep: nothing passed, all is finite, shape kept and overlap bounded except where counted. */
void hard_expect_kept(hard_case *c);
/* The first thread's knot is the one it had. */
void hard_expect_same_knot(const hard_case *c);
/* Nobody moves any more: energy does not grow, nothing is clamped. */
void hard_expect_at_rest(hard_case *c, uint32_t steps);

vbss_scene_statistics hard_statistics(const hard_case *c);
knot_type hard_knot(const hard_case *c, uint32_t thread);
const vec3 *hard_nodes(const hard_case *c, uint32_t thread);
/* All but what the floor and driven tools hold: of threads, contacts, springs of hands; J. */
double hard_energy(const hard_case *c);
double hard_fastest(const hard_case *c); /* node, m/s */

#endif
