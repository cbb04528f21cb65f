/* Puncture: when and where a tip enters a wall. */
#include "suture/suture.h"

#include "collision/closest.h"
#include "suture/tuning.h"

bool vbss_suture_tip_punctures(const vbss_drain_config *config, const suture_tip *tip)
{
    double axial_force = -vec3_dot(tip->force, tip->direction);
    double entry_cosine = -vec3_dot(tip->normal, tip->direction);
    return axial_force >= config->puncture_force && entry_cosine >= SUTURE_MIN_ENTRY_COSINE;
}

/* Intersection of a line and a triangle: distance along the line and barycentric coordinates
 * (Moeller, Trumbore 1997). */
static bool intersects_triangle(const vec3 corner[3], vec3 from, vec3 direction, double *distance,
                                double barycentric[3])
{
    vec3 e1 = vec3_sub(corner[1], corner[0]), e2 = vec3_sub(corner[2], corner[0]);
    vec3 across = vec3_cross(direction, e2), off = vec3_sub(from, corner[0]);
    double determinant = vec3_dot(e1, across);
    if (fabs(determinant) <=
        /* parallel to the plane, or a degenerate triangle */
        1e-12 * vec3_norm(e1) * vec3_norm(e2)) {
        return false;
    }
    vec3 aside = vec3_cross(off, e1);
    barycentric[1] = vec3_dot(off, across) / determinant;
    barycentric[2] = vec3_dot(direction, aside) / determinant;
    barycentric[0] = 1.0 - barycentric[1] - barycentric[2];
    *distance = vec3_dot(e2, aside) / determinant;
    return barycentric[0] >= -SUTURE_WEIGHT_ROUNDING && barycentric[1] >= -SUTURE_WEIGHT_ROUNDING &&
           barycentric[2] >= -SUTURE_WEIGHT_ROUNDING;
}

void vbss_suture_normalise_barycentric(double barycentric[3])
{
    double sum = 0.0;
    for (int k = 0; k < 3; k++) {
        barycentric[k] = vbss_max(barycentric[k], 0.0);
        sum += barycentric[k];
    }
    for (int k = 0; k < 3; k++) {
        barycentric[k] /= sum;
    }
}

static void load_corners(const suture_wall *wall, uint32_t t, vec3 corner[3])
{
    for (int k = 0; k < 3; k++) {
        corner[k] = wall->now[wall->triangles[t][k]];
    }
}

bool vbss_suture_find_wall_crossing(const suture_wall *wall, const vec3 axis[2], suture_hole *hole,
                                    double *fraction)
{
    const vec3 direction = vec3_sub(axis[1], axis[0]);
    bool found = false;
    *fraction = 1.0;
    for (uint32_t t = 0; t < wall->triangle_count; t++) {
        vec3 corner[3];
        double distance, barycentric[3];
        load_corners(wall, t, corner);
        if (intersects_triangle(corner, axis[0], direction, &distance, barycentric) &&
            distance >= 0.0 && distance <= *fraction) {
            vbss_suture_normalise_barycentric(barycentric);
            hole->triangle = t;
            for (int k = 0; k < 3; k++) {
                hole->barycentric[k] = barycentric[k];
            }
            *fraction = distance;
            found = true;
        }
    }
    return found;
}

static double distance_to_edge(const suture_wall *wall, const uint32_t nodes[2], vec3 point)
{
    vec3 along = vec3_sub(wall->now[nodes[1]], wall->now[nodes[0]]);
    vec3 to = vec3_sub(point, wall->now[nodes[0]]);
    return vec3_norm(vec3_add_scaled(to, -closest_on_edge(along, to), along));
}

static bool has_node(const suture_wall *wall, uint32_t t, uint32_t node)
{
    const uint32_t *own = wall->triangles[t];
    return own[0] == node || own[1] == node || own[2] == node;
}

/* Checks only the free edges of this triangle and those at its corners, because the other lip may
 * lie over it. */
static bool is_at_edge(const suture_wall *wall, uint32_t t, vec3 point, double min_distance)
{
    for (size_t i = 0; i < wall->edge_count; i++) {
        const uint32_t *nodes = wall->edges + i * wall->edge_stride;
        bool near = has_node(wall, t, nodes[0]) || has_node(wall, t, nodes[1]);
        if (wall->beside_edges[i * wall->edge_stride + 1] == DRAIN_NONE && near &&
            distance_to_edge(wall, nodes, point) < min_distance) {
            return true;
        }
    }
    return false;
}

/* A hole with three fixed corners has no degree of freedom that could hold it. */
static bool is_anchored(const suture_wall *wall, uint32_t t)
{
    const uint32_t *node = wall->triangles[t];
    return wall->anchored != NULL && wall->anchored[node[0]] && wall->anchored[node[1]] &&
           wall->anchored[node[2]];
}

bool vbss_suture_is_outward(const suture_wall *wall, uint32_t triangle, vec3 direction)
{
    vec3 corner[3];
    load_corners(wall, triangle, corner);
    vec3 outside = vec3_cross(vec3_sub(corner[1], corner[0]), vec3_sub(corner[2], corner[0]));
    return vec3_dot(outside, direction) > 0.0;
}

bool vbss_suture_make_hole(const suture_wall *wall, const suture_tip *tip, double reach,
                           double wire_radius, suture_hole *hole)
{
    double axial_force = vec3_dot(tip->force, tip->direction), nearest = reach;
    vec3 transverse_force = vec3_add_scaled(tip->force, -axial_force, tip->direction);
    /* Start from the offset at which the hole's stiffness bears the transverse force of the tip. */
    vec3 from = vec3_add_scaled(tip->position, 1.0 / wall->law->hole_stiffness, transverse_force);
    bool found = false;
    for (uint32_t t = 0; t < wall->triangle_count; t++) {
        vec3 corner[3];
        double distance, barycentric[3];
        load_corners(wall, t, corner);
        if (!intersects_triangle(corner, from, tip->direction, &distance, barycentric) ||
            distance < 0.0 || !(distance < nearest)) {
            continue;
        }
        vbss_suture_normalise_barycentric(barycentric);
        nearest = distance;
        found = !is_at_edge(wall, t, vec3_add_scaled(from, distance, tip->direction),
                            SUTURE_MIN_EDGE_DISTANCE * wire_radius) &&
                !is_anchored(wall, t);
        *hole = (suture_hole){.triangle = t,
                              .barycentric = {barycentric[0], barycentric[1], barycentric[2]},
                              .is_outward = vbss_suture_is_outward(wall, t, tip->direction),
                              .entry_arc = -distance,
                              .arc = -distance,
                              .max_arc = -distance,
                              .friction_force = axial_force,
                              .transverse_force = transverse_force};
    }
    return found;
}
