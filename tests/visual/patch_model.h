/* The curved patches of a drain, one point at a time: the model of lib/visual/wall_simd.c. */
#ifndef VBSS_TESTS_VISUAL_PATCH_MODEL_H
#define VBSS_TESTS_VISUAL_PATCH_MODEL_H

#include "base/linear.h"

/* An edge of a patch: a cubic Bezier curve with end points (corners) and control points, m, and
 * quadratic normals with a control normal in the middle, unit. */
typedef struct model_edge {
    vec3 corner[2], control[2], normal[2], middle_normal;
} model_edge;

model_edge model_make_edge(const vec3 x[2], const vec3 normals[2]);
/* Point and unit normal at a fraction of the edge. */
vec3 model_edge_point(const model_edge *edge, double fraction, vec3 *normal);

typedef struct model_patch {
    model_edge edges[3]; /* edge k runs from corner k to the next one */
    vec3 centre;         /* inner control point, m */
} model_patch;

model_patch model_make_patch(const model_edge edges[3]);
/* Point and unit normal at barycentric coordinates. */
vec3 model_patch_point(const model_patch *patch, const double weights[3], vec3 *normal);

#endif
