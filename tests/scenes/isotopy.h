/* Random isotopies of threads: the knot, and where it lies with regard to the tissue, stay as they are, and that is
 * proved, not hoped.
 *
 * First diffeomorphisms of space: swirls (about an axis, by an angle that decays to nothing within a ball), pushes
 * (by a vector that decays so slowly that nothing folds) and twists about the tissue's ray, none of which moves
 * the rays that go on from the ends and into the tissue. The line is refined until each edge is nearly what
 * its image is, and then no two parts may be as near to each other as that. Then vertices are removed down to
 * the segments wanted, and moved at random, only where the triangles swept are free (swept.h). */
#ifndef VBSS_TESTS_SCENES_ISOTOPY_H
#define VBSS_TESTS_SCENES_ISOTOPY_H

#include <stdint.h>

#include "scenes/throw_stack.h"

typedef struct isotopy {
    uint64_t seed;
    double strength;   /* 0: none, only other segments; 1: violent */
    uint32_t segments; /* of the result */
    double jumps; /* moves of single vertices that are tried, a segment; they crumple the line */
    double jump;  /* m: about so far */
    bool turned;  /* the whole is turned at random in the end */
} isotopy;

/* Strength 0.3, 240 segments, no jumps (of 0.5 mm), turned. */
void isotopy_init(isotopy *way, uint64_t seed);
/* False: eight draws could not be proved. Both ends stay outermost: beyond each lies a half
 * space with nothing in it, square to its limb as it was. `to` may be `from`. */
bool isotopy_apply(const isotopy *way, const thread_line *from, thread_line *to);

#endif
