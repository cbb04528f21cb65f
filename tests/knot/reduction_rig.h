/* What the tests of reductions share: a polygon with obstacles, its reduction, and the same done plainly. */
#ifndef VBSS_TESTS_KNOT_REDUCTION_RIG_H
#define VBSS_TESTS_KNOT_REDUCTION_RIG_H

#include "harness/harness.h"

#include "knot/knot.h"

enum { REDUCTION_MAX = 1024 };

/* One for all tests: fixtures of groups. */
typedef struct reduction_rig {
    vbss_context *context;
    knot_reduction reduction;
    vbss_array arrays[KNOT_REDUCTION_ARRAYS];
    knot_polygon polygon; /* its arrays are x, place and stays */
    vec3 x[REDUCTION_MAX];
    double place[REDUCTION_MAX];
    uint8_t stays[REDUCTION_MAX];
    knot_edge obstacles[REDUCTION_MAX];
    uint32_t obstacle_count;
} reduction_rig;
extern reduction_rig reduction_r;
int reduction_make_rig(void **state);
int reduction_end_rig(void **state);

/* An empty polygon without obstacles, and what is put in. */
void reduction_start(bool closed);
void reduction_add(vec3 x, bool stays);
void reduction_add_obstacle(vec3 begin, vec3 end);

/* In slices of so much work each, or at once. */
void reduction_reduce_in_slices(knot_ops slice);
void reduction_reduce(void);

/* A polygon put aside. */
typedef struct reduction_plain {
    uint32_t count;
    vec3 x[REDUCTION_MAX];
    double place[REDUCTION_MAX];
    uint8_t stays[REDUCTION_MAX];
} reduction_plain;
void reduction_take(reduction_plain *p);
void reduction_put(const reduction_plain *p);
void reduction_expect(const reduction_plain *p); /* that the polygon is this one, to the bit */
/* Between the rig's obstacles and closed as its polygon is: every edge is asked, none is remembered. */
bool reduction_is_free(const reduction_plain *p, uint32_t i);
void reduction_reduce_plainly(reduction_plain *p);

#endif
