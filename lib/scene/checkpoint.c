/* As everything was before a step, if it fails. */
#include "base/error.h"
#include "scene/substep.h"
#include "scene/scene.h"
#include "scene/step.h"
#include "scene/tools.h"

vbss_result vbss_scene_checkpoint(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_THREAD) {
            thread_object *t = b->thread.thread;
            VBSS_TRY(vbss_thread_update_derived(t));
            vbss_thread_copy_state(t, &t->saved, &t->now);
            b->thread.checkpoint_statistics = t->statistics;
            b->thread.checkpoint_needs_start_substep = t->is_acceleration_unknown;
            b->thread.checkpoint_damped_steps_left = t->damped_steps_left;
            b->thread.checkpoint_previous_h = t->previous_h;
        } else if (b->kind == SCENE_BODY_RIGID) {
            b->rigid.checkpoint_motion = b->rigid.body.now;
            b->rigid.checkpoint_coupling_wrench = b->rigid.coupling_wrench;
        } else if (b->kind == SCENE_BODY_DRAIN) {
            vbss_scene_checkpoint_drain(&b->drain);
        }
    }
    vbss_scene_checkpoint_tools(s);
    s->checkpoint_statistics = s->statistics;
    s->checkpoint_next_initial_size = s->next_initial_size;
    s->checkpoint_event_count = s->event_count;
    s->checkpoint_lost_events = s->lost_events;
    s->checkpoint_cursor = s->cursor;
    vbss_contact_checkpoint(s->contacts);
    return VBSS_OK;
}

void vbss_scene_rollback_statistics(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_THREAD) {
            b->thread.thread->statistics = b->thread.checkpoint_statistics;
        } else if (b->kind == SCENE_BODY_DRAIN) {
            b->drain.drain->statistics = b->drain.checkpoint_statistics;
        }
    }
    s->statistics = s->checkpoint_statistics;
}

void vbss_scene_rollback(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_THREAD) {
            thread_object *t = b->thread.thread;
            vbss_thread_copy_state(t, &t->now, &t->saved);
            t->is_acceleration_unknown = b->thread.checkpoint_needs_start_substep;
            t->damped_steps_left = b->thread.checkpoint_damped_steps_left;
            t->previous_h = b->thread.checkpoint_previous_h;
        } else if (b->kind == SCENE_BODY_RIGID) {
            b->rigid.body.now = b->rigid.checkpoint_motion;
            b->rigid.coupling_wrench = b->rigid.checkpoint_coupling_wrench;
        } else if (b->kind == SCENE_BODY_DRAIN) {
            vbss_scene_rollback_drain(&b->drain);
        }
    }
    vbss_scene_rollback_tools(s);
    vbss_scene_rollback_statistics(s);
    s->next_initial_size = s->checkpoint_next_initial_size;
    s->cursor = s->checkpoint_cursor;
    s->cursor.is_attempt_in_memory = false;
    vbss_contact_rollback(s->contacts);
    s->event_count = s->checkpoint_event_count;
    s->lost_events = s->checkpoint_lost_events;
    s->generation++;
}
