/* A polyline, and how it winds about one tool: nothing that is told may be nonsense. */
#ifndef VBSS_TESTS_KNOT_WINDING_RIG_H
#define VBSS_TESTS_KNOT_WINDING_RIG_H

#include "harness/harness.h"
#include "knot/knot.h"

#define PI 3.141592653589793

enum { MAX_COUNT = 400 };

typedef struct line {
    vec3 points[MAX_COUNT];
    uint32_t count;
} line;

static inline knot_winding wind(const line *l, knot_tool tool)
{
    line copy = *l;
    knot_input scene = {.point_count = copy.count,
                        .tool_count = 1,
                        .tissue_place = -1.0,
                        .points = copy.points,
                        .tools = &tool};
    knot_winding winding;
    vbss_knot_measure_winding(&scene, 0, &winding);
    assert_true(isfinite(winding.turns) && isfinite(winding.run_turns));
    for (int k = 0; k < 2; k++) {
        assert_true(isfinite(winding.run_heights[k]));
        assert_true(winding.run_places[k] >= 0.0 && winding.run_places[k] <= copy.count - 1);
    }
    assert_in_range(winding.sense + 1, 0, 2);
    return winding;
}

#endif
