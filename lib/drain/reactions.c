/* Reactions: forces of attachments on the drain. */
#include "drain/drain.h"

static bool is_pin(const drain_attachment *a)
{
    return a->id != 0 && a->kind == VBSS_DRAIN_ATTACHMENT_PIN;
}

bool vbss_drain_has_pins(const drain_object *d)
{
    bool any = false;
    for (uint32_t k = 0; k < d->config.attachment_capacity; k++) {
        any = any || is_pin(&d->attachments[k]);
    }
    return any;
}

/* Forces of other attachments at the node of a pin. */
static vec3 other_forces(const drain_object *d, const drain_attachment *pin)
{
    vec3 sum = vec3_zero();
    for (uint32_t k = 0; k < d->config.attachment_capacity; k++) {
        const drain_attachment *a = &d->attachments[k];
        if (a->id != 0 && a->node == pin->node && a != pin) {
            sum = vec3_add(sum, a->reaction);
        }
    }
    return sum;
}

/* Force that is missing in the node's balance, with its inertia, N. */
static vec3 pin_force(const drain_object *d, double h, const drain_attachment *pin)
{
    uint32_t node = pin->node;
    vec3 v = d->v[node];
    vec3 acceleration = vec3_scale(vec3_sub(v, d->v_substep_start[node]), 1.0 / h);
    acceleration = vec3_sub(vec3_add_scaled(acceleration, d->config.drag, v), d->gravity);
    vec3 all = vec3_sub(vec3_scale(acceleration, d->mass[node]), d->internal_forces[node]);
    all = vec3_sub(all, d->contact_forces[node]);
    return vec3_sub(all, other_forces(d, pin));
}

void vbss_drain_update_reactions(drain_object *d, double h)
{
    for (uint32_t k = 0; k < d->config.attachment_capacity; k++) {
        drain_attachment *a = &d->attachments[k];
        vec3 extension = vec3_sub(a->position, d->x[a->node]);
        a->reaction = a->kind == VBSS_DRAIN_ATTACHMENT_SPRING  ? vec3_scale(extension, a->stiffness)
                      : a->kind == VBSS_DRAIN_ATTACHMENT_FORCE ? a->force
                                                               : vec3_zero();
    }
    for (uint32_t k = 0; k < d->config.attachment_capacity; k++) {
        drain_attachment *a = &d->attachments[k];
        if (is_pin(a)) {
            a->reaction = pin_force(d, h, a);
        }
    }
}
