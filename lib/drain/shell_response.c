/* Response of a shell: strains, stresses, energies, and inverted triangles. */
#include <stddef.h>

#include "drain/shell_strain.h"
#include "drain/tuning.h"

/* Bending moment and energy: stiffness times curvature. */
static void set_moment(const vbss_shell_group *g, int lane, vbss_shell_response *s)
{
    static const int symmetric_index[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};
    s->bending_energy = 0.0;
    for (int r = 0; r < 3; r++) {
        s->bending_moment[r] = 0.0;
        for (int c = 0; c < 3; c++) {
            s->bending_moment[r] +=
                lanes_at(g->plate_stiffness[symmetric_index[r][c]], lane) * s->curvature[c];
        }
        s->bending_energy += 0.5 * lanes_at(g->area, lane) * s->bending_moment[r] * s->curvature[r];
    }
}

static void set_response(const vbss_shell_group *g, const shell_shape *p, const lanes stress[3],
                         int lane, vbss_shell_response *s)
{
    s->membrane_energy = 0.0;
    for (int k = 0; k < 3; k++) {
        double stretched = lanes_at(lanes_sub(p->metric[k], g->metric[k]), lane);
        s->strain[k] = k < 2 ? 0.5 * stretched : stretched;
        s->membrane_force[k] = lanes_at(stress[k], lane) / lanes_at(g->area, lane);
        s->membrane_energy += 0.5 * lanes_at(stress[k], lane) * s->strain[k];
        s->curvature[k] = 0.0;
        for (int m = 0; m < 3; m++) {
            double height_change = lanes_at(lanes_sub(p->height[m], g->height[m]), lane);
            s->curvature[k] += lanes_at(g->curvature_per_height[m][k], lane) * height_change;
        }
    }
    set_moment(g, lane, s);
}

/* Only its neighbours tell which way a triangle should face. The tangents at the middle of an edge
 * span the area of both triangles together. If it points against the triangle, the patch has no
 * orientation and its strains are meaningless. If two triangles are folded onto each other, at
 * least the smaller one is inverted. */
bool vbss_shell_is_inverted(const vbss_shell *shell, uint32_t triangle, const vec3 *x)
{
    const vbss_shell_group *g = &shell->groups[triangle / LANES];
    int lane = (int)(triangle % LANES);
    vec3 at[SHELL_NODES];
    for (int n = 0; n < SHELL_NODES; n++) {
        at[n] = x[g->node[n][lane]];
    }
    vec3 own = vec3_cross(vec3_sub(at[1], at[0]), vec3_sub(at[2], at[0]));
    bool inverted = !(vec3_norm(own) > DRAIN_INVERTED_AREA_RATIO * lanes_at(g->area, lane));
    for (int s = 0; s < 3; s++) {
        vec3 along = vec3_sub(at[(s + 1) % 3], at[(s + 2) % 3]);
        vec3 across = vec3_sub(at[3 + s], at[s]);
        bool is_free = (g->free_edges[lane] >> s & 1u) != 0;
        inverted = inverted || (!is_free && !(vec3_dot(vec3_cross(along, across), own) > 0.0));
    }
    return inverted;
}

static void measure_group(const vbss_shell *shell, uint32_t k, const vec3 *x,
                          vbss_shell_response responses[LANES])
{
    const vbss_shell_group *g = &shell->groups[k];
    shell_shape shape;
    lanes stress[3];
    shell_set_shape(g, x, &shape);
    shell_set_stress(g, &shape, stress);
    for (int lane = 0; lane < shell_lanes_used(shell, k); lane++) {
        set_response(g, &shape, stress, lane, &responses[lane]);
    }
}

double vbss_shell_energy(const vbss_shell *shell, const vec3 *x)
{
    double energy = 0.0;
    for (uint32_t k = 0; k < shell->group_count; k++) {
        vbss_shell_response responses[LANES];
        measure_group(shell, k, x, responses);
        for (int lane = 0; lane < shell_lanes_used(shell, k); lane++) {
            energy += responses[lane].membrane_energy + responses[lane].bending_energy;
        }
    }
    return energy;
}

void vbss_shell_compute_responses(const vbss_shell *shell, const vec3 *x,
                                  vbss_shell_response *responses)
{
    for (uint32_t k = 0; k < shell->group_count; k++) {
        measure_group(shell, k, x, &responses[(size_t)LANES * k]);
    }
    for (uint32_t i = 0; i < shell->triangle_count; i++) {
        responses[i].is_inverted = vbss_shell_is_inverted(shell, i, x);
    }
}
