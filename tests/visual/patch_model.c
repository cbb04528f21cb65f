/* Curved PN triangles (Vlachos, Peters, Boyd and Mitchell 2001), after the paper. */
#include "patch_model.h"

/* The point at a third of the edge, projected into the tangent plane of the corner. */
static vec3 control_point(vec3 corner, vec3 other, vec3 normal)
{
    vec3 chord = vec3_sub(other, corner);
    vec3 flat = vec3_add_scaled(chord, -vec3_dot(chord, normal), normal);
    return vec3_add_scaled(corner, 1.0 / 3.0, flat);
}

model_edge model_make_edge(const vec3 x[2], const vec3 normals[2])
{
    model_edge s = {{x[0], x[1]},
                    {control_point(x[0], x[1], normals[0]), control_point(x[1], x[0], normals[1])},
                    {normals[0], normals[1]},
                    vec3_add(normals[0], normals[1])};
    vec3 chord = vec3_sub(x[1], x[0]);
    double length = vec3_norm_squared(chord);
    if (length > 0.0) { /* reflected in the middle plane, so that an inflection is followed */
        s.middle_normal = vec3_add_scaled(s.middle_normal,
                                          -2.0 * vec3_dot(chord, s.middle_normal) / length, chord);
    }
    s.middle_normal = vec3_unit_or(s.middle_normal, normals[0]);
    return s;
}

vec3 model_edge_point(const model_edge *edge, double fraction, vec3 *normal)
{
    double b = fraction, a = 1.0 - fraction;
    if (a == 0.0 || b == 0.0) { /* equal to the bit for all edges at this corner */
        *normal = edge->normal[a == 0.0];
        return edge->corner[a == 0.0];
    }
    vec3 n = vec3_scale(edge->normal[0], a * a);
    n = vec3_add_scaled(n, a * b, edge->middle_normal);
    n = vec3_add_scaled(n, b * b, edge->normal[1]);
    *normal = vec3_unit_or(n, edge->normal[0]);
    vec3 x = vec3_scale(edge->corner[0], a * a * a);
    x = vec3_add_scaled(x, 3.0 * a * a * b, edge->control[0]);
    x = vec3_add_scaled(x, 3.0 * a * b * b, edge->control[1]);
    return vec3_add_scaled(x, b * b * b, edge->corner[1]);
}

model_patch model_make_patch(const model_edge edges[3])
{
    model_patch p = {{edges[0], edges[1], edges[2]}, vec3_zero()};
    vec3 controls = vec3_zero(), corners = vec3_zero();
    for (int k = 0; k < 3; k++) {
        controls = vec3_add(controls, vec3_add(edges[k].control[0], edges[k].control[1]));
        corners = vec3_add(corners, edges[k].corner[0]);
    }
    p.centre = vec3_add_scaled(vec3_scale(controls, 0.25), -1.0 / 6.0, corners);
    return p;
}

vec3 model_patch_point(const model_patch *patch, const double weights[3], vec3 *normal)
{
    vec3 x = vec3_scale(patch->centre, 6.0 * weights[0] * weights[1] * weights[2]);
    vec3 n = vec3_zero();
    for (int k = 0; k < 3; k++) {
        const model_edge *s = &patch->edges[k];
        double a = weights[k], b = weights[k == 2 ? 0 : k + 1];
        x = vec3_add_scaled(x, a * a * a, s->corner[0]);
        x = vec3_add_scaled(x, 3.0 * a * a * b, s->control[0]);
        x = vec3_add_scaled(x, 3.0 * a * b * b, s->control[1]);
        n = vec3_add_scaled(n, a * a, s->normal[0]);
        n = vec3_add_scaled(n, a * b, s->middle_normal);
    }
    *normal = vec3_unit_or(n, patch->edges[0].normal[0]);
    return x;
}
