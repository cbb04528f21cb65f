/* Conservative advancement in lanes; compiled twice. */
#ifndef VBSS_COLLISION_CCD_BATCH_H
#define VBSS_COLLISION_CCD_BATCH_H

#include "base/simd_dispatch.h"
#include "collision/collision.h"

/* Four questions, side by side in each of the 12 rows of start and of end, each proved to be without
 * contact until its time. */
typedef struct collision_ccd_lanes {
    const double *start, *end, *thickness;
    size_t stride;
    double time[4];
    uint32_t passes[4];
} collision_ccd_lanes;

/* What came of them; a lane is in one of the sets, or has missed. */
typedef struct collision_ccd_outcome {
    unsigned hit;
    unsigned pending;  /* four->time went on, four->passes too */
    unsigned fallback; /* nothing: ask that one alone */
    unsigned filtered; /* misses without a pass */
    double time[4], distance[4], normal[3][4], weights[4][4]; /* as a miss but for hits */
} collision_ccd_outcome;

/* A first pass, all times being 0; or a few, while at least two are open. */
void vbss_collision_advance_lanes_plain(const collision_ccd_options *options, vbss_pair_kind kind,
                                        bool first, collision_ccd_lanes *four,
                                        collision_ccd_outcome *outcome);
void vbss_collision_advance_lanes_wide(const collision_ccd_options *options, vbss_pair_kind kind,
                                       bool first, collision_ccd_lanes *four,
                                       collision_ccd_outcome *outcome);

#endif
