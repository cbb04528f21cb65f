/* Conservative advancement of four queries in SIMD lanes; compiled for any processor and for
 * AVX2. */
#ifndef VBSS_COLLISION_CCD_BATCH_H
#define VBSS_COLLISION_CCD_BATCH_H

#include "base/simd_dispatch.h"
#include "collision/collision.h"

/* Four queries, adjacent in each of the 12 rows of start and end. Each is proved to be free of
 * contact until its time. */
typedef struct collision_ccd_lanes {
    const double *start, *end, *thickness;
    size_t stride;
    double time[4];
    uint32_t passes[4];
} collision_ccd_lanes;

/* Result of a pass. A lane whose bit is in none of the sets is a miss. */
typedef struct collision_ccd_outcome {
    unsigned hit;
    unsigned pending;  /* no result yet; time and passes of the lane have advanced */
    unsigned fallback; /* no result; the scalar code must run this query */
    unsigned filtered; /* misses found without a pass */
    /* those of a hit; a lane without a hit has the values of a miss */
    double time[4], distance[4], normal[3][4], weights[4][4];
} collision_ccd_outcome;

/* If `first` is set, makes one pass from time 0. Otherwise makes a few passes, as long as at least
 * two lanes are pending. */
void vbss_collision_advance_lanes_plain(const collision_ccd_options *options,
                                        vbss_collision_pair_kind kind, bool first,
                                        collision_ccd_lanes *four, collision_ccd_outcome *outcome);
void vbss_collision_advance_lanes_wide(const collision_ccd_options *options,
                                       vbss_collision_pair_kind kind, bool first,
                                       collision_ccd_lanes *four, collision_ccd_outcome *outcome);

#endif
