/* When and where a tip enters a wall. */
#include "suture/suture.h"

/* Along the wall rather than into it: cosine between the tip's way and the inner normal below which it only slides. */
#define LEAST_INTO 0.3
/* Beyond this from the free edge, in radii of the wire, there is wall all round it. */
#define FROM_EDGE 1.0

bool vbss_suture_enters(const vbss_drain_config *config, const suture_tip *tip)
{
    double pressed = -vec3_dot(tip->force, tip->direction);
    double into = -vec3_dot(tip->normal, tip->direction);
    return pressed >= config->puncture_force && into >= LEAST_INTO;
}

/* Where a line meets a triangle: how far on, and the weights of the corners there. Moeller and Trumbore 1997. */
static bool meets(const vec3 corner[3], vec3 from, vec3 way, double *far, double weights[3])
{
    vec3 e1 = vec3_sub(corner[1], corner[0]), e2 = vec3_sub(corner[2], corner[0]);
    vec3 across = vec3_cross(way, e2), off = vec3_sub(from, corner[0]);
    double size = vec3_dot(e1, across);
    if (fabs(size) <= 1e-12 * vec3_norm(e1) * vec3_norm(e2)) { /* in its plane, or no triangle */
        return false;
    }
    vec3 aside = vec3_cross(off, e1);
    weights[1] = vec3_dot(off, across) / size;
    weights[2] = vec3_dot(way, aside) / size;
    weights[0] = 1.0 - weights[1] - weights[2];
    *far = vec3_dot(e2, aside) / size;
    return weights[0] >= 0.0 && weights[1] >= 0.0 && weights[2] >= 0.0;
}

static void corners_of(const drain_object *d, uint32_t t, vec3 corner[3])
{
    for (int k = 0; k < 3; k++) {
        corner[k] = d->x[d->mesh.triangles[t][k]];
    }
}

/* Height of the point over the side beyond which there is nothing. */
static bool is_at_edge(const drain_object *d, uint32_t t, const double weights[3], double least)
{
    vec3 corner[3];
    corners_of(d, t, corner);
    for (int k = 0; k < 3; k++) {
        vec3 side = vec3_sub(corner[(k + 2) % 3], corner[(k + 1) % 3]);
        vec3 up = vec3_sub(corner[k], corner[(k + 1) % 3]);
        double height = vec3_norm(vec3_cross(side, up)) / vec3_norm(side);
        if (d->mesh.opposite[t][k] == DRAIN_NONE && weights[k] * height < least) {
            return true;
        }
    }
    return false;
}

/* Nothing holds a hole whose corners do not move. */
static bool is_anchored(const drain_object *d, uint32_t t)
{
    const uint32_t *node = d->mesh.triangles[t];
    return d->anchored[node[0]] && d->anchored[node[1]] && d->anchored[node[2]];
}

bool vbss_suture_make_hole(const drain_object *d, const suture_tip *tip, double reach,
                           double wire_radius, suture_hole *hole)
{
    double pressed = vec3_dot(tip->force, tip->direction), nearest = reach;
    vec3 aside = vec3_add_scaled(tip->force, -pressed, tip->direction);
    /* So far aside it bears what it has borne across. */
    vec3 from = vec3_add_scaled(tip->position, 1.0 / d->config.hole_stiffness, aside);
    bool found = false;
    for (uint32_t t = 0; t < d->mesh.triangle_count; t++) {
        vec3 corner[3];
        double far, weights[3];
        corners_of(d, t, corner);
        if (!meets(corner, from, tip->direction, &far, weights) || far < 0.0 || !(far < nearest)) {
            continue;
        }
        vec3 outside = vec3_cross(vec3_sub(corner[1], corner[0]), vec3_sub(corner[2], corner[0]));
        nearest = far;
        found = !is_at_edge(d, t, weights, FROM_EDGE * wire_radius) && !is_anchored(d, t);
        *hole = (suture_hole){.triangle = t,
                              .weights = {weights[0], weights[1], weights[2]},
                              .outward = vec3_dot(outside, tip->direction) > 0.0,
                              .entry = -far,
                              .arc = -far,
                              .deepest = -far,
                              .held = pressed,
                              .across = aside};
    }
    return found;
}
