/* The knot type of a thread: invariants of the closed curve that a polyline makes when its ends go out along
 * rays from its middle and are joined far away. Exact but for the choice of a projection, which must be
 * plain and confirmed by a second one. Shares nothing with the library's own detection. */
#ifndef VBSS_TESTS_ORACLE_KNOT_TYPE_H
#define VBSS_TESTS_ORACLE_KNOT_TYPE_H

#include <stddef.h>

#include "fixtures/knots.h"

/* The invariants; equal for equal knots. They tell apart all sums of at most four throws of at most three
 * wraps. Of a mirror image v3 has the other sign. */
typedef struct knot_type {
    int64_t determinant;
    int64_t v2, v3; /* Vassiliev's of degree 2 and 3; right-handed 3_1: 1, 1 */
} knot_type;

/* False, and zeros, when it is uncertain: two generic projections disagree, eight are degenerate, or they
 * have too many crossings. n >= 2; consecutive points differ. */
bool knot_type_of(const vec3 *x, size_t n, knot_type *type);
bool knot_type_same(knot_type a, knot_type b);

/* Of stacked throws with wraps[i] and handedness signs[i] (+1: right-handed); no throw is the unknot. */
knot_type knot_type_of_throws(uint32_t throws, const int *wraps, const int *signs);
/* Of the scenes' knots. */
knot_type knot_type_of_kind(knot_kind kind, bool mirrored);

#endif
