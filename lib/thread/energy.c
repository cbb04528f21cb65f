/* Bending energy, and change of energy over a substep, of the implicit method. */
#include "thread/bending_memory.h"

/* 1/2 x^T K x = -1/2 sum of K_ij |x_i - x_j|^2 over all pairs, as the rows of K sum to zero. */
double vbss_thread_bending_energy(const thread_object *t)
{
    double energy = vbss_thread_rest_curvature_energy(t);
    if (thread_has_memory(t)) {
        energy += vbss_thread_bending_memory_energy(t);
    }
    for (uint32_t i = 0; i < t->node_count; i++) {
        for (uint32_t k = 1; k <= THREAD_CLAMP_BANDWIDTH && i + k < t->node_count; k++) {
            vec3 e = vec3_sub(t->now.x[i + k], t->now.x[i]);
            energy -= 0.5 * t->bending_matrix[i][k] * vec3_norm_squared(e);
        }
    }
    for (uint32_t c = 0; c < t->clamp_count; c++) {
        const thread_clamp *clamp = &t->clamps[c];
        vec3 from = t->now.x[clamp->node], sum = vec3_zero();
        for (uint32_t k = 0; k <= 2 * THREAD_CLAMP_BANDWIDTH; k++) {
            if (clamp->coefficient[k] != 0.0) {
                vec3 e = vec3_sub(t->now.x[clamp->node + k - THREAD_CLAMP_BANDWIDTH], from);
                sum = vec3_add_scaled(sum, clamp->coefficient[k], e);
            }
        }
        energy += vec3_dot(sum, clamp->direction);
        energy += 0.5 * clamp->own_coefficient * vec3_norm_squared(clamp->direction);
        if (c + 1 < t->clamp_count) {
            energy +=
                clamp->next_coefficient * vec3_dot(clamp->direction, t->clamps[c + 1].direction);
        }
    }
    return energy;
}

double vbss_thread_energy_change(const thread_object *t, double h)
{
    const thread_state *now = &t->now;
    double stretch = 0.0, motion = 0.0, per_time = 1.0 / h;
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        double rest = t->rest[i], tension = t->trial_tension[i], before = now->tension[i];
        vec3 v = vec3_scale(vec3_sub(t->trial[i], now->x[i]), per_time);
        stretch += rest * (tension * tension - before * before);
        motion += rest * (vec3_norm_squared(v) - vec3_norm_squared(now->v[i]));
    }
    return 0.5 * (stretch / t->config.axial_stiffness + t->config.linear_density * motion);
}
