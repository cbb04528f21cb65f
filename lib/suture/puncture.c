/* When and where a tip enters a wall. */
#include "suture/suture.h"

#include "collision/closest.h"

/* Beyond this from the free edge, in radii of the wire, there is wall all round it. */
#define FROM_EDGE 1.0
/* A line through a side meets one of its triangles, however weights are rounded. */
#define ROUNDING 1e-9

bool vbss_suture_enters(const vbss_drain_config *config, const suture_tip *tip)
{
    double pressed = -vec3_dot(tip->force, tip->direction);
    double into = -vec3_dot(tip->normal, tip->direction);
    return pressed >= config->puncture_force && into >= SUTURE_LEAST_INTO;
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
    return weights[0] >= -ROUNDING && weights[1] >= -ROUNDING && weights[2] >= -ROUNDING;
}

void vbss_suture_round_off(double weights[3])
{
    double sum = 0.0;
    for (int k = 0; k < 3; k++) {
        weights[k] = vbss_max(weights[k], 0.0);
        sum += weights[k];
    }
    for (int k = 0; k < 3; k++) {
        weights[k] /= sum;
    }
}

static void corners_of(const drain_object *d, uint32_t t, vec3 corner[3])
{
    for (int k = 0; k < 3; k++) {
        corner[k] = d->x[d->mesh.triangles[t][k]];
    }
}

bool vbss_suture_goes_through(const drain_object *d, const vec3 axis[2], suture_hole *where,
                              double *share)
{
    const vec3 way = vec3_sub(axis[1], axis[0]);
    bool found = false;
    *share = 1.0;
    for (uint32_t t = 0; t < d->mesh.triangle_count; t++) {
        vec3 corner[3];
        double far, weights[3];
        corners_of(d, t, corner);
        if (meets(corner, axis[0], way, &far, weights) && far >= 0.0 && far <= *share) {
            vbss_suture_round_off(weights);
            where->triangle = t;
            for (int k = 0; k < 3; k++) {
                where->weights[k] = weights[k];
            }
            *share = far;
            found = true;
        }
    }
    return found;
}

static double distance_to_side(const drain_object *d, const drain_side *side, vec3 point)
{
    vec3 along = vec3_sub(d->x[side->nodes[1]], d->x[side->nodes[0]]);
    vec3 to = vec3_sub(point, d->x[side->nodes[0]]);
    return vec3_norm(vec3_add_scaled(to, -closest_on_edge(along, to), along));
}

static bool has_node(const drain_object *d, uint32_t t, uint32_t node)
{
    const uint32_t *own = d->mesh.triangles[t];
    return own[0] == node || own[1] == node || own[2] == node;
}

/* Free sides of the triangle, and those that end at its corners: not the other lip that lies over it. */
static bool is_at_edge(const drain_object *d, uint32_t t, vec3 point, double least)
{
    for (uint32_t i = 0; i < d->mesh.side_count; i++) {
        const drain_side *side = &d->mesh.sides[i];
        bool near = has_node(d, t, side->nodes[0]) || has_node(d, t, side->nodes[1]);
        if (side->triangles[1] == DRAIN_NONE && near && distance_to_side(d, side, point) < least) {
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

bool vbss_suture_goes_outward(const drain_object *d, uint32_t triangle, vec3 way)
{
    vec3 corner[3];
    corners_of(d, triangle, corner);
    vec3 outside = vec3_cross(vec3_sub(corner[1], corner[0]), vec3_sub(corner[2], corner[0]));
    return vec3_dot(outside, way) > 0.0;
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
        vbss_suture_round_off(weights);
        nearest = far;
        found = !is_at_edge(d, t, vec3_add_scaled(from, far, tip->direction),
                            FROM_EDGE * wire_radius) &&
                !is_anchored(d, t);
        *hole = (suture_hole){.triangle = t,
                              .weights = {weights[0], weights[1], weights[2]},
                              .outward = vbss_suture_goes_outward(d, t, tip->direction),
                              .entry = -far,
                              .arc = -far,
                              .deepest = -far,
                              .held = pressed,
                              .across = aside};
    }
    return found;
}
