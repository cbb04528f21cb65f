/* Attachments: pins, clamps, springs, forces, masses and rolls on single nodes. */
#include "base/error.h"
#include "thread/twist.h"

bool vbss_thread_prescribes_motion(vbss_thread_attachment_kind kind)
{
    return kind == VBSS_THREAD_ATTACHMENT_PIN || kind == VBSS_THREAD_ATTACHMENT_CLAMP;
}

bool vbss_thread_is_clamped(const thread_object *t, uint32_t node)
{
    uint32_t prescribed_by = t->prescribed_by[node];
    return prescribed_by != 0 &&
           t->attachments[prescribed_by - 1].kind == VBSS_THREAD_ATTACHMENT_CLAMP;
}

vbss_result vbss_thread_find_attachment(thread_object *t, uint32_t id, thread_attachment **found)
{
    for (uint32_t i = 0; id != 0 && i < t->config.attachment_capacity; i++) {
        if (t->attachments[i].id == id) {
            *found = &t->attachments[i];
            return VBSS_OK;
        }
    }
    *found = NULL;
    return vbss_fail(t->context, VBSS_ERROR_NOT_FOUND, "the thread has no attachment %u", id);
}

void vbss_thread_save_target(thread_attachment *a)
{
    a->alternate_target = a->target;
    a->alternate_direction = a->target_direction;
    a->alternate_force = a->force;
    a->alternate_roll = a->target_roll;
}

/* ---- positions and targets */

vec3 vbss_thread_attachment_position(const thread_attachment *a, double fraction)
{
    return vec3_lerp(a->position, a->target, fraction);
}

vec3 vbss_thread_attachment_direction(const thread_attachment *a, double fraction)
{
    /* Opposite directions: the old one in the first half of the step, the new one in the second. */
    return vec3_unit_or(vec3_lerp(a->direction, a->target_direction, fraction),
                        fraction < 0.5 ? a->direction : a->target_direction);
}

static void swap(vec3 *one, vec3 *other)
{
    vec3 saved = *one;
    *one = *other;
    *other = saved;
}

void vbss_thread_save_targets(thread_object *t)
{
    for (uint32_t i = 0; i < t->config.attachment_capacity; i++) {
        vbss_thread_save_target(&t->attachments[i]);
    }
}

void vbss_thread_swap_targets(thread_object *t)
{
    for (uint32_t i = 0; i < t->config.attachment_capacity; i++) {
        thread_attachment *a = &t->attachments[i];
        swap(&a->target, &a->alternate_target);
        swap(&a->target_direction, &a->alternate_direction);
        swap(&a->force, &a->alternate_force);
        const double roll = a->target_roll;
        a->target_roll = a->alternate_roll;
        a->alternate_roll = roll;
    }
}

void vbss_thread_commit_attachments(thread_object *t, double h)
{
    for (uint32_t i = 0; i < t->config.attachment_capacity; i++) {
        thread_attachment *a = &t->attachments[i];
        a->velocity = vec3_scale(vec3_sub(a->target, a->position), 1.0 / h);
        a->position = a->target;
        a->direction = a->target_direction;
        a->roll = a->target_roll;
    }
}

/* ---- holders of the section */

void vbss_thread_list_section_holders(thread_object *t)
{
    t->holder_count = 0;
    for (uint32_t i = 0; i < t->config.attachment_capacity; i++) {
        const thread_attachment *a = &t->attachments[i];
        if (a->id == 0 || !thread_holds_section(a)) {
            continue;
        }
        uint32_t k = t->holder_count++;
        for (; k > 0 && t->holders[k - 1].node > a->node; k--) {
            t->holders[k] = t->holders[k - 1];
        }
        t->holders[k] =
            (thread_section_holder){.attachment_index = i,
                                    .node = a->node,
                                    .is_clamp = a->kind == VBSS_THREAD_ATTACHMENT_CLAMP};
    }
    vbss_thread_set_section_holders(t, 0.0);
}

void vbss_thread_set_section_holders(thread_object *t, double fraction)
{
    for (uint32_t k = 0; k < t->holder_count; k++) {
        thread_section_holder *holder = &t->holders[k];
        const thread_attachment *a = &t->attachments[holder->attachment_index];
        holder->roll = a->roll + fraction * (a->target_roll - a->roll);
        if (holder->is_clamp) {
            holder->direction = vbss_thread_attachment_direction(a, fraction);
        }
    }
}
