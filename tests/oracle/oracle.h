/* Exact truth of continuous collision queries by rational arithmetic (GMP). Slow and simple; shares no
 * code and no idea with the library's own exact decision. */
#ifndef VBSS_TESTS_ORACLE_H
#define VBSS_TESTS_ORACLE_H

#include <stdbool.h>

#include "fixtures/collision_sets.h"

/* D = 0: whether the features meet at some time in [0, 1]. The query's own `hit` is not read. */
bool oracle_meets(const collision_query *query);
/* Whether they meet at some time in [0, 1] that is smaller than t. */
bool oracle_meets_before(const collision_query *query, double t);
/* Whether they meet at time t, which may be any, taken exactly. */
bool oracle_meets_at(const collision_query *query, double t);

#endif
