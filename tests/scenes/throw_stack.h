/* Stacks of throws tied over tissue, as polylines: what detectors of knots are shown, with its truth.
 *
 * Frame: throws are stacked along +z over the loop that goes through the tissue; away from the knot, into the
 * tissue, is -z. The tail limb leaves towards -x, the long limb towards +x, both straight. Places on a line are
 * numbers: that of a segment plus the share of it, as in vblast_ss/knot.h. */
#ifndef VBSS_TESTS_SCENES_THROW_STACK_H
#define VBSS_TESTS_SCENES_THROW_STACK_H

#include <stdint.h>

#include "base/linear.h"

enum { STACK_THROWS = 8, STACK_POINTS = 2001 };

/* A thread, from the tail's end to the long limb's. */
typedef struct thread_line {
    uint32_t count; /* of points */
    vec3 x[STACK_POINTS];
    vec3 holes[2];         /* where it goes into tissue and out of it: points of the polyline */
    double hole_places[2]; /* ascending */
    double tissue_place;   /* between them; negative (as theirs are): no tissue */
    vec3 away;             /* unit: a ray from the tissue's place that way meets nothing */
} thread_line;

typedef struct throw_stack {
    uint32_t throws;         /* 0 to 8; none: the ends cross above the tissue */
    int wraps[STACK_THROWS]; /* 1 to 3 (0: a mere crossing), from the tissue outward */
    int signs[STACK_THROWS]; /* +1: right-handed */
    double
        size; /* m; strands lie half of it apart; 0.7e-3 (moderately tight) to 3e-3; default 1e-3 */
    double depth;      /* m, of the loop below the knot, at least 4 sizes; default 4e-3 */
    double drain;      /* m, between the holes along the thread; default 3e-3 */
    double tail;       /* m, of the straight tail limb; default 15e-3 */
    double limb;       /* m, of the long one; default 60e-3 */
    uint32_t segments; /* 30 to 2000; default 240 */
    double coarseness; /* segments of the limbs are so many times longer, 1 to 10; default 3 */
    double unevenness; /* 0 (default): smooth; up to 0.9: lengths vary by this share, at random */
    uint64_t seed;     /* of that; default 1 */
} throw_stack;

/* The defaults of no throw. */
void throw_stack_init(throw_stack *stack);
/* Adds one. */
void throw_stack_add(throw_stack *stack, int wraps, int sign);
/* False when the stack makes no sense, or when its segments are too few to show its knot: a line that is made
 * is proved to have the type of the curve. */
bool throw_stack_make(const throw_stack *stack, thread_line *line);

/* The point at a place. */
vec3 thread_line_at(const thread_line *line, double place);
/* Forgets the tissue. */
void thread_line_leave_tissue(thread_line *line);
/* The same thread from the other end on; mirrored at the plane x = 0: left becomes right. */
void thread_line_reverse(thread_line *line);
void thread_line_mirror(thread_line *line);

#endif
