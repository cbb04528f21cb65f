/* Strain and stress of a group of four patches, shared by forces, tangent and responses.
 *
 * Membrane: the metric is the mean of those at the middles of the edges (Flores, Onate 2005).
 * Bending: the mean second derivative over the triangle by the divergence theorem, along its
 * normal. The corners lie in the triangle's plane, so only the heights of nodes 3 4 5 above it
 * remain: k = sum curvature_per_height (height - height at rest). */
#ifndef VBSS_DRAIN_SHELL_STRAIN_H
#define VBSS_DRAIN_SHELL_STRAIN_H

#include "base/vlanes.h"
#include "drain/shell.h"

typedef struct shell_shape {
    vlanes arm[SHELL_NODES]; /* relative to node 0 */
    vlanes tangent[3][2];    /* at the middle of each edge, over sqrt 3 */
    vlanes normal;
    lanes twice_area;
    lanes metric[3], height[3];
} shell_shape;

static inline vlanes shell_gather(const vec3 *x, const uint32_t node[LANES])
{
    double all[3][LANES];
    for (int i = 0; i < LANES; i++) {
        const vec3 *at = &x[node[i]];
        all[0][i] = at->x;
        all[1][i] = at->y;
        all[2][i] = at->z;
    }
    vlanes v = {lanes_load(all[0]), lanes_load(all[1]), lanes_load(all[2])};
    return v;
}

static inline void shell_set_shape(const vbss_shell_group *g, const vec3 *x, shell_shape *p)
{
    vlanes origin = shell_gather(x, g->node[0]);
    p->arm[0] = v_sub(origin, origin);
    for (int n = 1; n < SHELL_NODES; n++) {
        p->arm[n] = v_sub(shell_gather(x, g->node[n]), origin);
    }
    for (int k = 0; k < 3; k++) {
        p->metric[k] = lanes_splat(0.0);
    }
    for (int s = 0; s < 3; s++) {
        for (int a = 0; a < 2; a++) {
            vlanes t = v_scale(p->arm[1], g->gradient[s][0][a]);
            t = v_add_scaled(t, g->gradient[s][1][a], p->arm[2]);
            p->tangent[s][a] = v_add_scaled(t, g->gradient[s][2][a], p->arm[3 + s]);
        }
        const vlanes *t = p->tangent[s];
        p->metric[0] = lanes_add(p->metric[0], v_dot(t[0], t[0]));
        p->metric[1] = lanes_add(p->metric[1], v_dot(t[1], t[1]));
        p->metric[2] = lanes_add(p->metric[2], v_dot(t[0], t[1]));
    }
    vlanes area = v_cross(p->arm[1], p->arm[2]);
    p->twice_area = lanes_sqrt(v_dot(area, area));
    /* A triangle without area has no normal, and no bending until it has one. */
    lanes bound = lanes_max(p->twice_area, lanes_splat(1e-100));
    p->normal = v_scale(area, lanes_div(lanes_splat(1.0), bound));
    for (int m = 0; m < 3; m++) {
        p->height[m] = v_dot(p->arm[3 + m], p->normal);
    }
}

/* Stress times area, 11, 22, 12: gradient of the membrane energy with e11, e22 and 2 e12. */
static inline void shell_set_stress(const vbss_shell_group *g, const shell_shape *p,
                                    lanes stress[3])
{
    lanes half = lanes_splat(0.5);
    lanes e11 = lanes_times(half, lanes_sub(p->metric[0], g->metric[0]));
    lanes e22 = lanes_times(half, lanes_sub(p->metric[1], g->metric[1]));
    lanes shear = lanes_times(g->root_shear, g->root_shear);
    lanes sum = lanes_times(lanes_times(g->root_sum, g->root_sum), lanes_add(e11, e22));
    lanes difference = lanes_times(shear, lanes_sub(e11, e22));
    stress[0] = lanes_add(sum, difference);
    stress[1] = lanes_sub(sum, difference);
    stress[2] = lanes_times(shear, lanes_sub(p->metric[2], g->metric[2]));
}

/* Gradient of the bending energy with the heights. */
static inline void shell_set_bending_gradient(const vbss_shell_group *g, const shell_shape *p,
                                              lanes bending_gradient[3])
{
    lanes height_change[3];
    for (int m = 0; m < 3; m++) {
        height_change[m] = lanes_sub(p->height[m], g->height[m]);
    }
    const lanes *b = g->bending_stiffness;
    bending_gradient[0] = lanes_add(
        lanes_add(lanes_times(b[0], height_change[0]), lanes_times(b[3], height_change[1])),
        lanes_times(b[4], height_change[2]));
    bending_gradient[1] = lanes_add(
        lanes_add(lanes_times(b[3], height_change[0]), lanes_times(b[1], height_change[1])),
        lanes_times(b[5], height_change[2]));
    bending_gradient[2] = lanes_add(
        lanes_add(lanes_times(b[4], height_change[0]), lanes_times(b[5], height_change[1])),
        lanes_times(b[2], height_change[2]));
}

/* The foot of node 3 + m in the triangle's plane is sum foot[m][i] (corner i). It moves along the
 * normal as the corners do. */
static inline void shell_set_feet(const shell_shape *p, lanes foot[3][3])
{
    lanes bound = lanes_max(p->twice_area, lanes_splat(1e-100));
    lanes inverse = lanes_div(lanes_splat(1.0), bound);
    vlanes to_1 = v_scale(v_cross(p->arm[2], p->normal), inverse);
    vlanes to_2 = v_scale(v_cross(p->normal, p->arm[1]), inverse);
    for (int m = 0; m < 3; m++) {
        foot[m][1] = v_dot(p->arm[3 + m], to_1);
        foot[m][2] = v_dot(p->arm[3 + m], to_2);
        foot[m][0] = lanes_sub(lanes_sub(lanes_splat(1.0), foot[m][1]), foot[m][2]);
    }
}

/* Forces on the six nodes. Node 0 gets the opposite of all others, so there is no net force. */
static inline void shell_set_forces(const vbss_shell_group *g, const shell_shape *p,
                                    const lanes stress[3], const lanes bending_gradient[3],
                                    lanes foot[3][3], vlanes force[SHELL_NODES])
{
    vlanes none = p->arm[0];
    force[1] = force[2] = none;
    for (int s = 0; s < 3; s++) {
        /* stress times tangents: gradient of the energy with each tangent */
        const vlanes *t = p->tangent[s];
        vlanes to_1 = v_add_scaled(v_scale(t[0], stress[0]), stress[2], t[1]);
        vlanes to_2 = v_add_scaled(v_scale(t[0], stress[2]), stress[1], t[1]);
        for (int k = 0; k < 3; k++) {
            vlanes gradient =
                v_add_scaled(v_scale(to_1, g->gradient[s][k][0]), g->gradient[s][k][1], to_2);
            int n = k < 2 ? 1 + k : 3 + s;
            force[n] = k < 2 ? v_sub(force[n], gradient) : v_sub(none, gradient);
        }
    }
    for (int m = 0; m < 3; m++) {
        vlanes along = v_scale(p->normal, bending_gradient[m]);
        force[3 + m] = v_sub(force[3 + m], along);
        force[1] = v_add_scaled(force[1], foot[m][1], along);
        force[2] = v_add_scaled(force[2], foot[m][2], along);
    }
    force[0] = none;
    for (int n = 1; n < SHELL_NODES; n++) {
        force[0] = v_sub(force[0], force[n]);
    }
}

/* Number of lanes in use; the last group may have fewer than LANES. */
static inline int shell_lanes_used(const vbss_shell *shell, uint32_t group)
{
    uint32_t left = shell->triangle_count - LANES * group;
    return left < LANES ? (int)left : LANES;
}

static inline void shell_scatter_forces(const vbss_shell_group *g, int used,
                                        const vlanes force[SHELL_NODES], vec3 *forces)
{
    for (int n = 0; n < SHELL_NODES; n++) {
        double all[3][LANES];
        lanes_store(all[0], force[n].x);
        lanes_store(all[1], force[n].y);
        lanes_store(all[2], force[n].z);
        for (int i = 0; i < used; i++) {
            vec3 *to = &forces[g->node[n][i]];
            *to = vec3_add(*to, vec3_make(all[0][i], all[1][i], all[2][i]));
        }
    }
}

#endif
