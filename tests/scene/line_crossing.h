/* Where a segment crosses a triangle. */
#ifndef VBSS_TESTS_SCENE_LINE_CROSSING_H
#define VBSS_TESTS_SCENE_LINE_CROSSING_H

#include <stdbool.h>

#include "base/linear.h"

/* Whether it does; `weights` are those of the triangle's corners. The signs of three volumes decide, so nothing is
 * divided by a number that may vanish. */
static inline bool line_crosses_triangle(vec3 from, vec3 to, const vec3 corner[3],
                                         double weights[3])
{
    vec3 displacement = vec3_sub(to, from);
    double volume[3], sum = 0.0;
    vec3 normal = vec3_cross(vec3_sub(corner[1], corner[0]), vec3_sub(corner[2], corner[0]));
    double before = vec3_dot(normal, vec3_sub(from, corner[0]));
    double after = vec3_dot(normal, vec3_sub(to, corner[0]));
    if ((before >= 0.0) == (after >= 0.0)) {
        return false;
    }
    for (int k = 0; k < 3; k++) {
        vec3 a = vec3_sub(corner[(k + 1) % 3], from), b = vec3_sub(corner[(k + 2) % 3], from);
        volume[k] = vec3_dot(displacement, vec3_cross(a, b));
        sum += volume[k];
    }
    for (int k = 0; k < 3; k++) {
        weights[k] = volume[k] / sum;
        if (!(weights[k] >= 0.0)) {
            return false;
        }
    }
    return true;
}

#endif
