/* What a moving point, edge or triangle may touch, and whether two of them meet: a bound in floating point, with a
 * proof, for nearly all, rational arithmetic (oracle.h) for the rest. */
#ifndef VBSS_TESTS_ORACLE_SWEEP_H
#define VBSS_TESTS_ORACLE_SWEEP_H

#include <stdint.h>

#include "base/linear.h"

/* Corners move in straight lines, all at the same time: at any time it lies among its corners of both states, and so
 * in their box, which is exact. */
typedef struct sweep {
    vec3 start[3], end[3];
    uint32_t corners; /* 1: a point, 2: an edge, 3: a triangle */
    vec3 low, high;
} sweep;

/* Corners start[nodes[i]]; end. With a coordinate that is not finite it is in everybody's way. */
sweep sweep_make(const vec3 *start, const vec3 *end, const uint32_t *nodes, uint32_t corners);
bool sweep_boxes_apart(const sweep *a, const sweep *b);
/* The box of a becomes that of both. */
void sweep_boxes_join(sweep *a, const sweep *b);
/* Two edges, or a point and a triangle: whether they have a point in common at some time, touching included. Asked:
 * exact arithmetic has decided. */
bool sweep_meets(const sweep *a, const sweep *b, bool *asked);

#endif
