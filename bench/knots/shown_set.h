/* Many configurations of a family: a pool of threads, which are slow to make, each shown turned at random, as it is, mirrored,
 * walked from its other end, or both. To projections, signs and reductions each of them is another thread. */
#ifndef VBSS_BENCH_KNOTS_SHOWN_SET_H
#define VBSS_BENCH_KNOTS_SHOWN_SET_H

#include <vblast_ss/knot.h>

#include "fixtures/knot_families.h"

typedef struct shown_set {
    const family *family;
    uint32_t segments, count;
    family_case *cases;      /* what is shown, with its truth */
    vbss_knot_input *inputs; /* which do not copy the points */
} shown_set;

/* One set is kept: asked for again it is not made anew. NULL when the family cannot be made of so few segments. */
const shown_set *shown_set_of(const family *of, uint32_t segments, uint32_t count);
void shown_set_end(void);

#endif
