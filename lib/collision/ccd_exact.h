/* Exact predicate for features with zero thickness. */
#ifndef VBSS_COLLISION_CCD_EXACT_H
#define VBSS_COLLISION_CCD_EXACT_H

#include "collision/collision.h"
#include "collision/integers.h"

typedef enum exact_result {
    COLLISION_EXACT_MISS,
    COLLISION_EXACT_HIT,
    COLLISION_EXACT_UNKNOWN /* the exponents differ by more than the workspace can hold */
} exact_result;

/* Whether the features meet at some time from 0 to 1, for exactly the given doubles. */
exact_result vbss_collision_decide_exactly(const collision_ccd_query *query, workspace *w);

#endif
