/* Checkpoint: copies of all state before a step, and rollback if the step fails. */
#include "base/error.h"
#include "scene/step/step.h"
#include "scene/tools/tools.h"
#include "scene/world/world.h"

#include <string.h>

vbss_result vbss_scene_checkpoint(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        b->checkpoint = (struct scene_body_checkpoint){b->next_halvings, b->group};
        if (b->kind == SCENE_BODY_THREAD) {
            thread_object *t = b->thread.thread;
            VBSS_TRY(vbss_thread_update_derived(t));
            vbss_thread_copy_state(t, &t->saved, &t->now);
            b->thread.checkpoint.needs_start_substep = t->is_acceleration_unknown;
            b->thread.checkpoint.damped_steps_left = t->damped_steps_left;
            b->thread.checkpoint.previous_h = t->previous_h;
        } else if (b->kind == SCENE_BODY_RIGID) {
            b->rigid.checkpoint.motion = b->rigid.body.now;
            b->rigid.checkpoint.coupling_wrench = b->rigid.coupling_wrench;
            if (b->rigid.surface != NULL) {
                vbss_scene_checkpoint_host_surface(b->rigid.surface);
            }
        } else if (b->kind == SCENE_BODY_DRAIN) {
            vbss_scene_checkpoint_drain(&b->drain);
        }
    }
    vbss_scene_checkpoint_tools(s);
    vbss_scene_checkpoint_statistics(s);
    s->checkpoint.logged_event_count = s->report.logged_event_count;
    s->checkpoint.lost_logged_events = s->report.lost_logged_events;
    s->checkpoint.pending_event_count = s->events.pending_count;
    s->checkpoint.lost_pending_events = s->events.pending_lost;
    s->checkpoint.cursor = s->cursor;
    s->checkpoint.blocker_count = s->report.blocker_count;
    memcpy(s->checkpoint.blockers, s->report.blockers,
           s->report.blocker_count * sizeof *s->report.blockers);
    s->checkpoint.overlap_count = s->overlap_count;
    memcpy(s->checkpoint.overlaps, s->overlaps, s->overlap_count * sizeof *s->overlaps);
    vbss_scene_checkpoint_pin_targets(s);
    vbss_contact_checkpoint(s->contacts);
    return VBSS_OK;
}

void vbss_scene_checkpoint_statistics(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_THREAD) {
            b->thread.checkpoint.statistics = b->thread.thread->statistics;
        } else if (b->kind == SCENE_BODY_DRAIN) {
            b->drain.checkpoint.statistics = b->drain.drain->statistics;
        }
    }
    s->checkpoint.statistics = s->report.statistics;
}

void vbss_scene_rollback_statistics(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_THREAD) {
            b->thread.thread->statistics = b->thread.checkpoint.statistics;
        } else if (b->kind == SCENE_BODY_DRAIN) {
            b->drain.drain->statistics = b->drain.checkpoint.statistics;
        }
    }
    s->report.statistics = s->checkpoint.statistics;
}

void vbss_scene_rollback(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        b->next_halvings = b->checkpoint.next_halvings;
        b->group = b->checkpoint.group;
        b->is_frozen = b->group != s->checkpoint.cursor.group;
        if (b->kind == SCENE_BODY_THREAD) {
            thread_object *t = b->thread.thread;
            vbss_thread_copy_state(t, &t->now, &t->saved);
            t->is_acceleration_unknown = b->thread.checkpoint.needs_start_substep;
            t->damped_steps_left = b->thread.checkpoint.damped_steps_left;
            t->previous_h = b->thread.checkpoint.previous_h;
        } else if (b->kind == SCENE_BODY_RIGID) {
            b->rigid.body.now = b->rigid.checkpoint.motion;
            b->rigid.coupling_wrench = b->rigid.checkpoint.coupling_wrench;
            if (b->rigid.surface != NULL) {
                vbss_scene_rollback_host_surface(b->rigid.surface);
            }
        } else if (b->kind == SCENE_BODY_DRAIN) {
            vbss_scene_rollback_drain(&b->drain);
        }
    }
    vbss_scene_rollback_tools(s);
    vbss_scene_rollback_statistics(s);
    s->cursor = s->checkpoint.cursor;
    s->report.blocker_count = s->checkpoint.blocker_count;
    memcpy(s->report.blockers, s->checkpoint.blockers,
           s->checkpoint.blocker_count * sizeof *s->report.blockers);
    s->cursor.is_attempt_in_memory = false;
    s->overlap_count = s->checkpoint.overlap_count;
    memcpy(s->overlaps, s->checkpoint.overlaps, s->overlap_count * sizeof *s->overlaps);
    vbss_scene_rollback_pin_targets(s);
    vbss_contact_rollback(s->contacts);
    s->report.logged_event_count = s->checkpoint.logged_event_count;
    s->report.lost_logged_events = s->checkpoint.lost_logged_events;
    s->events.pending_count = s->checkpoint.pending_event_count;
    s->events.pending_lost = s->checkpoint.lost_pending_events;
    s->report.generation++;
}

void vbss_scene_checkpoint_drain(scene_drain *b)
{
    drain_object *d = b->drain;
    size_t bytes = d->mesh.node_count * sizeof *d->x;
    memcpy(d->saved_x, d->x, bytes);
    memcpy(d->saved_v, d->v, bytes);
    memcpy(d->v_substep_start, d->v, bytes); /* in case all of its substeps are rejected */
    vbss_drain_checkpoint_tangent(d);
    b->checkpoint.statistics = d->statistics;
}

void vbss_scene_rollback_drain(scene_drain *b)
{
    drain_object *d = b->drain;
    size_t bytes = d->mesh.node_count * sizeof *d->x;
    memcpy(d->x, d->saved_x, bytes);
    memcpy(d->v, d->saved_v, bytes);
    vbss_drain_rollback_tangent(d);
    d->statistics = b->checkpoint.statistics;
}

void vbss_scene_checkpoint_tools(scene_object *s)
{
    for (uint32_t i = 0; i < s->capsule_count; i++) {
        scene_capsule *c = &s->capsules[i];
        c->checkpoint.local[0] = c->local[0];
        c->checkpoint.local[1] = c->local[1];
        /* A truncated step leaves it elsewhere than `local`. */
        c->checkpoint.local_end[0] = c->local_end[0];
        c->checkpoint.local_end[1] = c->local_end[1];
        c->checkpoint.radius = c->radius;
    }
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_rigid *r = &s->bodies[i].rigid;
        if (s->bodies[i].kind != SCENE_BODY_RIGID) {
            continue;
        }
        r->checkpoint.target_end = r->body.target_end;
        r->checkpoint.has_pending_target = r->has_pending_target;
        r->checkpoint.load = r->body.load;
        r->checkpoint.pending_load = r->pending_load;
        if (r->grasper != NULL) {
            const grasper_object *g = r->grasper;
            r->checkpoint.needle_grasp = r->needle_grasp;
            r->checkpoint.wall_grasp = r->wall_grasp;
            r->checkpoint.jaws = (struct scene_checkpoint_jaws){g->kind, g->commanded_kind,
                                                                g->jaw_angle, g->jaw_force};
        }
    }
    memcpy(s->checkpoint.thread_grasps, s->thread_grasps,
           s->config.grasp_capacity * sizeof *s->thread_grasps);
    s->checkpoint.last_grasp_id = s->last_grasp_id;
    memcpy(s->checkpoint.holes, s->holes, s->config.hole_capacity * sizeof *s->holes);
    s->checkpoint.last_hole_id = s->last_hole_id;
}

void vbss_scene_rollback_tools(scene_object *s)
{
    for (uint32_t i = 0; i < s->capsule_count; i++) {
        scene_capsule *c = &s->capsules[i];
        c->local[0] = c->checkpoint.local[0];
        c->local[1] = c->checkpoint.local[1];
        c->local_end[0] = c->checkpoint.local_end[0];
        c->local_end[1] = c->checkpoint.local_end[1];
        c->radius = c->checkpoint.radius;
    }
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_rigid *r = &s->bodies[i].rigid;
        if (s->bodies[i].kind != SCENE_BODY_RIGID) {
            continue;
        }
        r->body.target_end = r->checkpoint.target_end;
        r->has_pending_target = r->checkpoint.has_pending_target;
        r->body.load = r->checkpoint.load;
        r->pending_load = r->checkpoint.pending_load;
        if (r->grasper != NULL) {
            grasper_object *g = r->grasper;
            r->needle_grasp = r->checkpoint.needle_grasp;
            r->wall_grasp = r->checkpoint.wall_grasp;
            g->kind = r->checkpoint.jaws.kind;
            g->commanded_kind = r->checkpoint.jaws.target_kind;
            g->jaw_angle = r->checkpoint.jaws.angle;
            g->jaw_force = r->checkpoint.jaws.pressure;
        }
    }
    memcpy(s->thread_grasps, s->checkpoint.thread_grasps,
           s->config.grasp_capacity * sizeof *s->thread_grasps);
    s->last_grasp_id = s->checkpoint.last_grasp_id;
    memcpy(s->holes, s->checkpoint.holes, s->config.hole_capacity * sizeof *s->holes);
    s->last_hole_id = s->checkpoint.last_hole_id;
}
