/* Curved patches over triangles that know their corners' normals (Vlachos, Peters, Boyd and Mitchell, Curved PN Triangles, 2001):
 * a cubic through the corners, and normals that vary as a quadratic. A side's curve follows from its own corners
 * only, so that neighbours share it. */
#include "visual/visual.h"

/* At a third of the way, in the plane of the corner's normal. */
static vec3 inner_point(vec3 corner, vec3 other, vec3 normal)
{
    vec3 way = vec3_sub(other, corner);
    vec3 flat = vec3_add_scaled(way, -vec3_dot(way, normal), normal);
    return vec3_add_scaled(corner, 1.0 / 3.0, flat);
}

visual_side vbss_visual_side(const vec3 x[2], const vec3 normals[2])
{
    visual_side s = {{x[0], x[1]},
                     {inner_point(x[0], x[1], normals[0]), inner_point(x[1], x[0], normals[1])},
                     {normals[0], normals[1]},
                     vec3_add(normals[0], normals[1])};
    vec3 way = vec3_sub(x[1], x[0]);
    double length = vec3_norm_squared(way);
    if (length > 0.0) { /* mirrored in the plane between the corners, which follows an inflection */
        s.middle = vec3_add_scaled(s.middle, -2.0 * vec3_dot(way, s.middle) / length, way);
    }
    s.middle = vec3_unit_or(s.middle, normals[0]);
    return s;
}

vec3 vbss_visual_side_point(const visual_side *side, double share, vec3 *normal)
{
    double b = share, a = 1.0 - share;
    if (a == 0.0 || b == 0.0) { /* to the bit what other sides have at this corner */
        *normal = side->normal[a == 0.0];
        return side->corner[a == 0.0];
    }
    vec3 n = vec3_scale(side->normal[0], a * a);
    n = vec3_add_scaled(n, a * b, side->middle);
    n = vec3_add_scaled(n, b * b, side->normal[1]);
    *normal = vec3_unit_or(n, side->normal[0]);
    vec3 x = vec3_scale(side->corner[0], a * a * a);
    x = vec3_add_scaled(x, 3.0 * a * a * b, side->inner[0]);
    x = vec3_add_scaled(x, 3.0 * a * b * b, side->inner[1]);
    return vec3_add_scaled(x, b * b * b, side->corner[1]);
}

double vbss_visual_side_rise(const visual_side *side)
{
    /* An eighth of the largest second derivative, which a cubic has at an end. */
    vec3 middle = vec3_sub(side->inner[1], side->inner[0]);
    vec3 begin = vec3_sub(middle, vec3_sub(side->inner[0], side->corner[0]));
    vec3 end = vec3_sub(vec3_sub(side->corner[1], side->inner[1]), middle);
    return 0.75 * sqrt(vbss_max(vec3_norm_squared(begin), vec3_norm_squared(end)));
}

visual_patch vbss_visual_patch(const visual_side sides[3])
{
    visual_patch p = {{sides[0], sides[1], sides[2]}, vec3_zero()};
    vec3 inner = vec3_zero(), corners = vec3_zero();
    for (int k = 0; k < 3; k++) {
        inner = vec3_add(inner, vec3_add(sides[k].inner[0], sides[k].inner[1]));
        corners = vec3_add(corners, sides[k].corner[0]);
    }
    p.centre = vec3_add_scaled(vec3_scale(inner, 0.25), -1.0 / 6.0, corners);
    return p;
}

vec3 vbss_visual_patch_point(const visual_patch *patch, const double weights[3], vec3 *normal)
{
    vec3 x = vec3_scale(patch->centre, 6.0 * weights[0] * weights[1] * weights[2]);
    vec3 n = vec3_zero();
    for (int k = 0; k < 3; k++) {
        const visual_side *s = &patch->sides[k];
        double a = weights[k], b = weights[k == 2 ? 0 : k + 1];
        x = vec3_add_scaled(x, a * a * a, s->corner[0]);
        x = vec3_add_scaled(x, 3.0 * a * a * b, s->inner[0]);
        x = vec3_add_scaled(x, 3.0 * a * b * b, s->inner[1]);
        n = vec3_add_scaled(n, a * a, s->normal[0]);
        n = vec3_add_scaled(n, a * b, s->middle);
    }
    *normal = vec3_unit_or(n, patch->sides[0].normal[0]);
    return x;
}
