/* A knot whose ends are pulled apart until it bears a load: what all cases with a knot share. */
#ifndef VBSS_BENCH_CONTACT_PULLED_KNOT_H
#define VBSS_BENCH_CONTACT_PULLED_KNOT_H

#include <vblast_ss/scene.h>

#include "harness/bench.h"
#include "oracle/knot_type.h"
#include "fixtures/contact_scenes.h"

typedef struct pulled_knot {
    char name[64];
    contact_scene_options options;
    double h;            /* s */
    bool held;           /* what is timed begins when the load is reached */
    bool pinned;         /* the nodes of both strands that are nearest to a crossing, in space */
    uint32_t hold_steps; /* not held: timed too, after the load is reached */
    uint32_t max_steps;  /* to get there */
    bool whole;          /* all of them, load or not */
    void (*more)(bench_result *result); /* called after its own counters; may be NULL */

    /* of a run */
    vbss_context *context;
    contact_scene scene;
    uint32_t steps_to_load;
    bool broken; /* it did not get there: no finite state */
    /* where timing begins */
    contact_scene scene_at_begin;
    uint8_t *saved;
    uint64_t saved_bytes;
    uint64_t rejected_at_begin;
    /* measured between the steps of the first repetition */
    uint32_t samples;
    double min_distance; /* of strands, m */
    uint64_t node_sum;   /* of the same steps, all of them */
    uint32_t node_steps, max_nodes;
    double taken_up; /* m, when the load is reached or the steps are over */
} pulled_knot;

/* A method's defaults for a kind of knot, pulled at 25 mm/s an end to 2 N. */
void pulled_knot_init(pulled_knot *k, knot_kind kind, vbss_method method);
/* A stepped case of it; `k` must outlive the run. */
void pulled_knot_add(bench *b, pulled_knot *k);
/* The same without timing, for a reference: false when the load is not reached. */
bool pulled_knot_make(pulled_knot *k);
bool pulled_knot_run(pulled_knot *k);
void pulled_knot_end(pulled_knot *k);
/* Of axes of segments that are at least `apart` from each other along the thread, m. Rest lengths, or one for
 * all with NULL. */
double pulled_knot_min_distance(const vec3 *x, uint32_t nodes, const double *rest, double length,
                                double apart);
#endif
