/* A throw being tied round a tool, at random but by formula: what the paper's method of finding throws was
 * tuned on. For tests and bench; docs/paper-knots.md.
 *
 * The tool comes down the z axis, tip at the origin. Point 0 is the tail's end; the thread goes through
 * the tissue once, to one side of the tool. */
#ifndef VBSS_TESTS_SCENES_PAPER_TYING_H
#define VBSS_TESTS_SCENES_PAPER_TYING_H

#include <vblast_ss/knot.h>

#include "base/linear.h"

typedef enum paper_tying_stage {
    PAPER_TYING_WRAPPED, /* the tail lies free, its end near the tip */
    PAPER_TYING_GRASPED, /* the jaws, 2 mm behind the tip, hold it 3.5 mm from its end */
    PAPER_TYING_DRAWN    /* and have drawn it through the turns, which are off the tip */
} paper_tying_stage;

typedef struct paper_tying {
    paper_tying_stage stage;
    uint32_t wraps;      /* 0 to 2; turns are half a turn more, give or take a fifth */
    bool towards_handle; /* the turns advance the wrong way, which ties nothing */
    double tilt;         /* DRAWN: of the tail from the tool's line, at most, rad */
    double segment;      /* length, about, m */
} paper_tying;

enum { PAPER_TYING_POINTS = 640 };

/* Returns how many points the thread has. */
uint32_t paper_tying_make(const paper_tying *tying, uint64_t seed, vec3 points[PAPER_TYING_POINTS]);

#endif
