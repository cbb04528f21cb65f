/* Substep of a drain, on its own or in a scene: trial state, increments, commit, end of
 * the step. */
#include "drain/drain.h"

#include <string.h>

void vbss_drain_reset_trial(drain_object *d)
{
    memcpy(d->trial, d->x, d->mesh.node_count * sizeof *d->trial);
}

double vbss_drain_largest_increment(const drain_object *d, const vbss_system *s, uint32_t first)
{
    double largest = 0.0;
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        largest = vbss_max_or_nan(vec3_norm(s->solution[first + i]), largest);
    }
    return largest;
}

void vbss_drain_apply_increment(drain_object *d, const vbss_system *s, uint32_t first)
{
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        d->trial[i] = vec3_add(d->trial[i], s->solution[first + d->order.block_index[i]]);
    }
}

void vbss_drain_commit(drain_object *d, double h)
{
    double max_displacement = 0.0;
    vbss_drain_commit_tangent(d);
    memcpy(d->v_substep_start, d->v, d->mesh.node_count * sizeof *d->v);
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        vec3 displacement = vec3_sub(d->trial[i], d->x[i]);
        max_displacement = vbss_max_or_nan(vec3_norm(displacement), max_displacement);
        d->v[i] = vbss_drain_flush_velocity(vec3_scale(displacement, 1.0 / h));
        d->x[i] = d->trial[i];
    }
    d->statistics.last_move = vbss_max_or_nan(max_displacement, d->statistics.last_move);
    d->statistics.parts++;
}

void vbss_drain_finish_substeps(drain_object *d, double h)
{
    vbss_drain_commit_attachments(d);
    if (vbss_drain_has_pins(d)) {
        /* The last assembly was for another state. */
        vbss_drain_compute_internal_forces(d, d->x);
    }
    vbss_drain_update_reactions(d, h);
    vbss_drain_tear_anchor(d, d->internal_forces);
}

void vbss_drain_finish_step(drain_object *d, double h)
{
    d->statistics.steps++;
    d->statistics.time += h;
    d->generation++;
}
