/* The barrel of a wide lens: where in its picture something is. */
#ifndef VBSS_EXAMPLES_VIEWER_BARREL_H
#define VBSS_EXAMPLES_VIEWER_BARREL_H

#include <stdbool.h>

#include "matrix.h"

/* What is seen at p is at p (1 + BARREL |p|^2) / BARREL_SPREAD without it; 1 at the upper edge. */
#define BARREL 0.07F
#define BARREL_SPREAD 1.12F

/* From a place without the lens to the one with it; both -1 to 1, right and up. The cubic is solved by repetition: it is nearly 1. */
static inline void barrel_bend(float aspect, float place[2])
{
    enum { ROUNDS = 12 };
    const float x = place[0] * BARREL_SPREAD, y = place[1] * BARREL_SPREAD;
    place[0] = x;
    place[1] = y;
    for (int i = 0; i < ROUNDS; i++) {
        float across = place[0] * aspect, r2 = across * across + place[1] * place[1];
        float share = 1.0F / (1.0F + BARREL * r2);
        place[0] = x * share;
        place[1] = y * share;
    }
}

/* Where a place of the world is in the picture; false: behind the lens. */
static inline bool barrel_place(const matrix4 *seen, float aspect, const double at[3],
                                float place[2])
{
    const float *m = seen->m, x = (float)at[0], y = (float)at[1], z = (float)at[2];
    const float w = m[3] * x + m[7] * y + m[11] * z + m[15];
    if (w <= 0.0F) {
        return false;
    }
    place[0] = (m[0] * x + m[4] * y + m[8] * z + m[12]) / w;
    place[1] = (m[1] * x + m[5] * y + m[9] * z + m[13]) / w;
    barrel_bend(aspect, place);
    return true;
}

#endif
