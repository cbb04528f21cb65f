/* Attachments: pins, clamps, springs, forces and masses on single nodes. */
#include "base/error.h"
#include "thread/thread.h"

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
