/* The exact decision for zero thickness. */
#ifndef VBSS_COLLISION_EXACT_H
#define VBSS_COLLISION_EXACT_H

#include "collision/collision.h"
#include "collision/integers.h"

typedef enum exact_truth {
    EXACT_MISS,
    EXACT_HIT,
    EXACT_UNKNOWN /* the magnitudes differ by more than the memory for integers holds */
} exact_truth;

/* Whether the features meet at some time from 0 to 1, the given doubles taken as they are. */
exact_truth vbss_collision_exact(const collision_question *question, workspace *w);

#endif
