/* As everything was before a step, if it fails. */
#include "base/error.h"
#include "scene/attempt.h"
#include "scene/scene.h"
#include "scene/step.h"
#include "scene/tools.h"

vbss_result vbss_scene_keep(scene_object *s)
{
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == BODY_THREAD) {
            thread_object *t = b->thread.thread;
            VBSS_TRY(vbss_thread_update_derived(t));
            vbss_thread_copy_state(t, &t->saved, &t->now);
            b->thread.kept = t->statistics;
            b->thread.kept_fresh = t->is_acceleration_unknown;
            b->thread.kept_settling = t->damped_steps_left;
            b->thread.kept_part = t->previous_h;
        } else if (b->kind == BODY_RIGID) {
            b->rigid.kept = b->rigid.body.now;
            b->rigid.kept_pull = b->rigid.pull;
        } else if (b->kind == BODY_DRAIN) {
            vbss_scene_keep_drain(&b->drain);
        }
    }
    vbss_scene_keep_tools(s);
    s->kept = s->statistics;
    s->kept_pace = s->pace;
    s->kept_event_count = s->event_count;
    s->kept_lost_events = s->lost_events;
    s->kept_way = s->way;
    vbss_contact_checkpoint(s->contacts);
    return VBSS_OK;
}

void vbss_scene_return_statistics(scene_object *s)
{
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == BODY_THREAD) {
            b->thread.thread->statistics = b->thread.kept;
        } else if (b->kind == BODY_DRAIN) {
            b->drain.drain->statistics = b->drain.kept;
        }
    }
    s->statistics = s->kept;
}

void vbss_scene_go_back(scene_object *s)
{
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == BODY_THREAD) {
            thread_object *t = b->thread.thread;
            vbss_thread_copy_state(t, &t->now, &t->saved);
            t->is_acceleration_unknown = b->thread.kept_fresh;
            t->damped_steps_left = b->thread.kept_settling;
            t->previous_h = b->thread.kept_part;
        } else if (b->kind == BODY_RIGID) {
            b->rigid.body.now = b->rigid.kept;
            b->rigid.pull = b->rigid.kept_pull;
        } else if (b->kind == BODY_DRAIN) {
            vbss_scene_return_drain(&b->drain);
        }
    }
    vbss_scene_return_tools(s);
    vbss_scene_return_statistics(s);
    s->pace = s->kept_pace;
    s->way = s->kept_way;
    s->way.at_hand = false;
    vbss_contact_rollback(s->contacts);
    s->event_count = s->kept_event_count;
    s->lost_events = s->kept_lost_events;
    s->generation++;
}
