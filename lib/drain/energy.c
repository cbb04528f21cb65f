/* Change of energy of a drain over a substep. */
#include "drain/drain.h"

/* Upper bound: the force of a pin is known only for the last assembly. */
static double max_attachment_work(const drain_object *d)
{
    double sum = 0.0;
    for (uint32_t k = 0; k < d->config.attachment_capacity; k++) {
        const drain_attachment *a = &d->attachments[k];
        if (a->id == 0) {
            continue;
        }
        double displacement = vec3_norm(vec3_sub(d->trial[a->node], d->x[a->node]));
        double max_extension = vec3_norm(vec3_sub(a->target, d->x[a->node])) + displacement;
        sum += displacement *
               (a->kind == VBSS_DRAIN_ATTACHMENT_SPRING  ? a->stiffness * max_extension
                : a->kind == VBSS_DRAIN_ATTACHMENT_FORCE ? vec3_norm(a->force)
                                                         : vec3_norm(d->internal_forces[a->node]));
    }
    return sum;
}

double vbss_drain_energy_change(const drain_object *d, double h)
{
    double change = vbss_shell_energy(&d->shell, d->trial) - vbss_shell_energy(&d->shell, d->x);
    double per_time = 1.0 / h;
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        vec3 displacement = vec3_sub(d->trial[i], d->x[i]), v = vec3_scale(displacement, per_time);
        double squares = vec3_norm_squared(v) - vec3_norm_squared(d->v[i]);
        change += d->mass[i] * (0.5 * squares - vec3_dot(d->gravity, displacement));
    }
    return change - max_attachment_work(d);
}
