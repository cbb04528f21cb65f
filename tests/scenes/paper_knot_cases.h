/* Eight ways in which a thread lies about a tool, and what the paper's loop search makes of them: the same
 * for tests and bench. docs/paper-knots.md tells why it is wrong where it is.
 *
 * The tool comes down the z axis, tip at the origin. Each thread is given in cylinder coordinates by the
 * turns about that axis, so that these are known. */
#ifndef VBSS_TESTS_SCENES_PAPER_KNOT_CASES_H
#define VBSS_TESTS_SCENES_PAPER_KNOT_CASES_H

#include <vblast_ss/knot.h>

#include "base/linear.h"

typedef enum paper_knot_kind {
    PAPER_KNOT_A,  /* one turn */
    PAPER_KNOT_B,  /* two turns spiralling outward over the radial strand that comes in */
    PAPER_KNOT_C,  /* two turns of an exact helix, 16 segments a turn */
    PAPER_KNOT_C2, /* the same in 31 segments */
    PAPER_KNOT_D,  /* one turn, then one back */
    PAPER_KNOT_E,  /* one turn whose end crosses the curled standing part three times */
    PAPER_KNOT_F,  /* A, 20 mm beyond the tip */
    PAPER_KNOT_G,  /* two turns, inward, then outward */
    PAPER_KNOT_H,  /* A, on the floor 45 mm below the tip */
    PAPER_KNOT_KINDS
} paper_knot_kind;

typedef struct paper_knot_case {
    const char *name;
    uint32_t loops;    /* that the paper counts as closed round the tool */
    uint32_t rejected; /* loops that it finds and rejects */
    double turns;      /* signed, about the tool's line, that the thread does make, to 0.005 */
    bool beside_tool;  /* false: all of it lies beyond the tip */
} paper_knot_case;
extern const paper_knot_case paper_knot_cases[PAPER_KNOT_KINDS];

/* Enough for all. */
enum { PAPER_KNOT_POINTS = 128 };

/* The thread; returns how many points it has. */
uint32_t paper_knot_make(paper_knot_kind kind, vec3 points[PAPER_KNOT_POINTS]);
/* The tool, which holds nothing. */
vbss_knot_tool paper_knot_tool(void);

#endif
