/* Curved patches over triangles with normals at their corners (Vlachos, Peters, Boyd and Mitchell,
 * Curved PN Triangles, 2001): a cubic surface with quadratic normals. The curve of an edge depends
 * on its own corners only, so neighbouring patches share it. */
#include "visual/visual.h"

/* The point at a third of the edge, projected into the tangent plane of the corner. */
static vec3 control_point(vec3 corner, vec3 other, vec3 normal)
{
    vec3 chord = vec3_sub(other, corner);
    vec3 flat = vec3_add_scaled(chord, -vec3_dot(chord, normal), normal);
    return vec3_add_scaled(corner, 1.0 / 3.0, flat);
}

visual_edge vbss_visual_make_edge(const vec3 x[2], const vec3 normals[2])
{
    visual_edge s = {{x[0], x[1]},
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

vec3 vbss_visual_edge_point(const visual_edge *edge, double fraction, vec3 *normal)
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

double vbss_visual_edge_chord_error(const visual_edge *edge)
{
    /* An eighth of the largest second derivative. That of a cubic is largest at an end. */
    vec3 middle = vec3_sub(edge->control[1], edge->control[0]);
    vec3 start = vec3_sub(middle, vec3_sub(edge->control[0], edge->corner[0]));
    vec3 end = vec3_sub(vec3_sub(edge->corner[1], edge->control[1]), middle);
    return 0.75 * sqrt(vbss_max(vec3_norm_squared(start), vec3_norm_squared(end)));
}

visual_patch vbss_visual_make_patch(const visual_edge edges[3])
{
    visual_patch p = {{edges[0], edges[1], edges[2]}, vec3_zero()};
    vec3 controls = vec3_zero(), corners = vec3_zero();
    for (int k = 0; k < 3; k++) {
        controls = vec3_add(controls, vec3_add(edges[k].control[0], edges[k].control[1]));
        corners = vec3_add(corners, edges[k].corner[0]);
    }
    p.centre = vec3_add_scaled(vec3_scale(controls, 0.25), -1.0 / 6.0, corners);
    return p;
}

vec3 vbss_visual_patch_point(const visual_patch *patch, const double weights[3], vec3 *normal)
{
    vec3 x = vec3_scale(patch->centre, 6.0 * weights[0] * weights[1] * weights[2]);
    vec3 n = vec3_zero();
    for (int k = 0; k < 3; k++) {
        const visual_edge *s = &patch->edges[k];
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
