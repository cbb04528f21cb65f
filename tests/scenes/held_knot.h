/* How much a knot holds: it is tied round a cylinder, both ends are let go, and the cylinder grows until the knot
 * gives way or bears its limit. The same for tests and bench; the protocol and what came of it are told in
 * docs/knot-holding.md.
 *
 * A second rod lies within the cylinder. The two go asunder across the way to the knot, so that it lies free
 * between them, and as fast as their outline gains what the perimeter of a growing cylinder does. */
#ifndef VBSS_TESTS_SCENES_HELD_KNOT_H
#define VBSS_TESTS_SCENES_HELD_KNOT_H

#include <vblast_ss/scene.h>

#include "base/linear.h"
#include "scenes/tied_knot.h"

typedef struct held_knot_options {
    tied_knot_options tied; /* knot, friction, seating */
    double disturbance;     /* of the nodes, smooth along the thread, m: root of the mean square */
    uint64_t seed;          /* of the disturbance */
    double step;            /* s */
    double growth;          /* of the cylinder's radius, m/s */
    double most_growth;     /* m */
    double slip;            /* of line: a tail is drawn in by it, or the loop has gained it; m */
    double limit;           /* of the loop's tension, N */
} held_knot_options;

typedef enum held_knot_end {
    HELD_KNOT_GREW,       /* as far as the cylinder may grow */
    HELD_KNOT_SLIPPED,    /* a tail was drawn in by the slip */
    HELD_KNOT_HELD,       /* the loop bears the limit */
    HELD_KNOT_OPEN,       /* no strand touches another any more */
    HELD_KNOT_NOT_SEATED, /* the hands did not feel their load */
    HELD_KNOT_STUCK /* the guard cut step after step short: what was found counts for nothing */
} held_knot_end;
extern const char *const held_knot_ends[];

/* Arc lengths, m: where the tails leave the knot, and where its loop begins and ends. */
typedef struct held_knot_edges {
    double tails[2], loop[2];
} held_knot_edges;

typedef struct held_knot {
    held_knot_options options;
    tied_knot tied;
    uint32_t rods[2]; /* numbers of bodies */
    vec3 way;         /* unit: the second rod goes there, the first one back */
    double grown;     /* of the radius, m */
    uint32_t growing_steps;
    uint64_t clamped;        /* parts of steps, so far */
    uint32_t clamped_steps;  /* one after the other, until now */
    held_knot_edges edges;   /* now */
    held_knot_edges seated;  /* under the hands' load */
    held_knot_edges resting; /* when the cylinder began to grow */
    double tension;          /* of the loop beside the knot, N */
    /* Its largest before a tail was drawn in by the slip, which may go no further than a throw that opens; and before
     * the cylinder's perimeter has grown by it, so that line must have gone through the knot. N */
    double holds, holds_through;
    held_knot_end end;
} held_knot;

/* A kind of knot, 2 mm round, of thread with that friction; all hands pull with `force` N. */
vbss_result held_knot_init(held_knot_options *options, knot_kind kind, double force,
                           double friction);
/* One of many alike: force and speed of the hands within a tenth of what they were, and a disturbance. */
void held_knot_vary(held_knot_options *options, uint64_t seed);
/* On failure what was made so far goes with the context. */
vbss_result held_knot_create(vbss_context *context, const held_knot_options *options,
                             held_knot *knot);
vbss_result held_knot_destroy(held_knot *knot);

/* The whole of it, or in two: tied, let go, at rest, with `end` GREW if that went well; then a step of growing,
 * which tells whether it goes on. */
vbss_result held_knot_run(held_knot *knot);
vbss_result held_knot_tie(held_knot *knot);
vbss_result held_knot_grow(held_knot *knot, bool *goes_on);

/* m of the longer of what was drawn in of the tails between two looks. */
double held_knot_drawn_in(const held_knot_edges *before, const held_knot_edges *after);
/* m of line in the knot, without tails and loop. */
double held_knot_inside(const held_knot_edges *edges);
/* The nodes of knot and loop with as much of the tails as a surgeon leaves, until the next step. */
vbss_result held_knot_strand(const held_knot *knot, const vec3 **x, uint32_t *count);

#endif
