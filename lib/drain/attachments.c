/* Attachments: pins, forces and springs on single nodes. */
#include "drain/drain.h"

const drain_attachment *vbss_drain_find_pin(const drain_object *d, uint32_t node)
{
    for (uint32_t i = 0; i < d->config.attachment_capacity; i++) {
        const drain_attachment *a = &d->attachments[i];
        if (a->id != 0 && a->node == node && a->kind == VBSS_DRAIN_ATTACHMENT_PIN) {
            return a;
        }
    }
    return NULL;
}

vec3 vbss_drain_attachment_position(const drain_attachment *a, double fraction)
{
    return vec3_lerp(a->position, a->target, fraction);
}

void vbss_drain_save_targets(drain_object *d)
{
    for (uint32_t i = 0; i < d->config.attachment_capacity; i++) {
        drain_attachment *a = &d->attachments[i];
        a->alternate_target = a->target;
        a->alternate_force = a->force;
    }
}

void vbss_drain_swap_targets(drain_object *d)
{
    for (uint32_t i = 0; i < d->config.attachment_capacity; i++) {
        drain_attachment *a = &d->attachments[i];
        const vec3 target = a->target, force = a->force;
        a->target = a->alternate_target;
        a->force = a->alternate_force;
        a->alternate_target = target;
        a->alternate_force = force;
    }
}

void vbss_drain_commit_attachments(drain_object *d)
{
    for (uint32_t i = 0; i < d->config.attachment_capacity; i++) {
        d->attachments[i].position = d->attachments[i].target;
    }
}
