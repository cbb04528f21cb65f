/* The thread of a moment of a story, by formula. For wrap_scripts.c. */
#ifndef VBSS_TESTS_SCENES_WRAP_PATH_H
#define VBSS_TESTS_SCENES_WRAP_PATH_H

#include "scenes/knot_path.h"
#include "scenes/throw_stack.h"

/* Along W's axis, m: loops lie between -LOOPS and LOOPS; the tail comes up at RISE; N is at FRONT. */
#define WRAP_LOOPS 3e-3
#define WRAP_RISE (-8e-3)
#define WRAP_FRONT (-20e-3)
#define WRAP_ABOVE 8e-3 /* W's axis above the knot */

typedef struct wrap_state {
    knot_pile below;       /* throws that are there already; none: the bare drain */
    double turns;          /* of the limb about the axis, signed */
    double there_and_back; /* turns beside these that are taken back at once */
    bool to_handle;        /* wound towards the handle */
    double radius;         /* of the loops */
    double lift;           /* of the tail, from the tissue (0) to the axis (1) */
    double jaws;           /* along the axis: where the tail is held, when it is lifted */
    double hanging;        /* of it beyond the jaws, m */
    double swing;          /* of that from back to ahead, 0 to 1 */
    double pulled;         /* N outward, 0 to 1 */
    double flat; /* from the limb round the tail (0) over both alike (0.5) to the reverse (1) */
    double limb_left; /* of drain, throws and limb, 0 to 1: of their length */
} wrap_state;

/* How high W's axis is, m. */
double wrap_axis_height(const wrap_state *state);
/* The thread on so many segments. `jaws` is the place where it is held. False when they do not show it. */
bool wrap_path(const wrap_state *state, uint32_t segments, thread_line *line, double *jaws);

#endif
