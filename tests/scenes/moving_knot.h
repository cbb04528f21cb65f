/* A throw that is tied and comes undone again, by formula: the long limb is wound round a grasper, which takes the
 * tail, draws it through and lets go; then the tail slips back. Each of four times with other wraps or to the other
 * side; the third time the limb is wound towards the handle, which ties nothing.
 * For tests and the determinism table: what is shown is worked out from the number of the step alone, so that a
 * restored detector goes on as the saved one.
 *
 * Frame: the grasper lies along the x axis with its tip towards +x; the tissue is below, at -z. */
#ifndef VBSS_TESTS_SCENES_MOVING_KNOT_H
#define VBSS_TESTS_SCENES_MOVING_KNOT_H

#include <vblast_ss/knot.h>

enum {
    MOVING_KNOT_POINTS = 73,
    MOVING_KNOT_TOOLS = 2,
    /* Steps at which parts of a throw begin; a throw has PERIOD steps. */
    MOVING_KNOT_TAKEN = 30, /* wound; the grasper reaches for the tail */
    MOVING_KNOT_DRAWN = 40, /* holds it, and draws */
    MOVING_KNOT_RELEASED = 60,
    MOVING_KNOT_SLIPPING = 70,
    MOVING_KNOT_PERIOD = 90
};

/* Must stay where it is while `input` is used. */
typedef struct moving_knot {
    double points[MOVING_KNOT_POINTS][3];
    vbss_knot_tool tools[MOVING_KNOT_TOOLS];
    vbss_knot_input input;
} moving_knot;

/* Small capacities; a reading begins every 3 steps, if the last one has ended. */
vbss_result moving_knot_config(vbss_knot_config *config);
vbss_result moving_knot_show(uint64_t step, moving_knot *shown);
/* Of the throw that is tied when this is shown; 0 wraps: nothing is. */
int32_t moving_knot_wraps(uint64_t step);
int32_t moving_knot_handedness(uint64_t step);
/* Shows what comes after the steps that the detector has taken. */
vbss_result moving_knot_step(vbss_knot_detector *detector);
/* Of any detector's state and of all that hosts can see after a step. */
vbss_result moving_knot_hash(vbss_knot_detector *detector, uint64_t *hash);

#endif
