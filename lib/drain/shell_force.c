/* Forces of a shell, in groups of four patches. */
#include "drain/shell_strain.h"

void VBSS_WIDE_NAME(vbss_shell_add_forces)(const vbss_shell *shell, const vec3 *x, vec3 *forces)
{
    for (uint32_t k = 0; k < shell->group_count; k++) {
        const vbss_shell_group *g = &shell->groups[k];
        shell_shape shape;
        lanes stress[3], bending_gradient[3], foot[3][3];
        vlanes force[SHELL_NODES];
        shell_set_shape(g, x, &shape);
        shell_set_stress(g, &shape, stress);
        shell_set_bending_gradient(g, &shape, bending_gradient);
        shell_set_feet(&shape, foot);
        shell_set_forces(g, &shape, stress, bending_gradient, foot, force);
        shell_scatter_forces(g, shell_lanes_used(shell, k), force, forces);
    }
}
