/* Begin and end of a step: targets and tools before the first substep; forces, events, holes,
 * tools, cuts and meshes after the last. */
#include "scene/step/groups.h"
#include "scene/step/step.h"
#include "scene/tissue/tissue.h"
#include "scene/tools/tools.h"
#include "scene/topology/topology.h"
#include "scene/world/world.h"

#include <string.h>

static void record_operations(scene_object *s)
{
    vbss_scene_statistics *c = &s->report.statistics;
    uint64_t operations = s->contacts->counters.operations;
    c->operations += operations;
    c->most_operations = operations > c->most_operations ? operations : c->most_operations;
}

void vbss_scene_begin_step(scene_object *s, double h)
{
    scene_step_cursor *cursor = &s->cursor;
    cursor->substep = (scene_substep){.step_length = h};
    vbss_scene_set_substep_limits(s);
    vbss_scene_record_holes_before_step(s);
    vbss_scene_apply_rigid_targets(s);
    vbss_scene_apply_host_surfaces(s);
    vbss_scene_apply_loads(s);
    vbss_scene_hold_sections(s, h);
    vbss_scene_limit_rigid_targets(s, h);
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_THREAD) {
            b->thread.thread->statistics.last_iterations = 0;
        } else if (b->kind == SCENE_BODY_DRAIN) {
            b->drain.drain->statistics.last_move = 0.0;
        }
    }
    vbss_scene_apply_tool_targets(s, h);
    vbss_scene_drop_ended_overlaps(s);
    vbss_scene_begin_first_group(s);
    s->report.old_contact_count = s->report.contact_count;
    s->contacts->counters.operations = 0;
}

static void finish_motion(scene_object *s, double h)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (!b->is_frozen && !s->cursor.is_paused) {
            b->next_halvings = 0;
        }
        if (scene_active_kind(b) == SCENE_BODY_THREAD) {
            thread_object *t = b->thread.thread;
            vbss_thread_finish_step(t, h);
            t->damped_steps_left -= t->damped_steps_left > 0;
            b->thread.contact_free_steps =
                b->thread.has_contacts
                    ? 0
                    : b->thread.contact_free_steps + (b->thread.contact_free_steps < 16);
            for (uint32_t k = 0; s->cursor.is_behind_targets && k < t->config.attachment_capacity;
                 k++) {
                thread_attachment *a = &t->attachments[k];
                if (a->id != 0 && vbss_thread_prescribes_motion(a->kind)) {
                    /* The node lags behind; the next step starts from here. */
                    a->position = t->now.x[a->node];
                }
            }
        } else if (scene_active_kind(b) == SCENE_BODY_RIGID) {
            scene_rigid *r = &b->rigid;
            r->body.target_start = r->kind == VBSS_SCENE_RIGID_DRIVEN && s->cursor.is_behind_targets
                                       ? r->body.now.pose
                                       : r->body.target_end;
            if (r->surface != NULL) {
                vbss_scene_finish_host_surface(r->surface, s->cursor.is_behind_targets);
            }
        }
    }
}

/* Slips, tears and releases grasps, makes cuts, and publishes the tools. */
static void update_tools(scene_object *s, double h)
{
    vbss_scene_update_thread_grasps(s, h);
    vbss_scene_update_needle_grasps(s, h);
    vbss_scene_update_wall_grasps(s, h);
    vbss_scene_make_cuts(s);
    vbss_scene_publish_tools(s);
}

/* Sums the contact forces on each node of a drain, N. */
static void accumulate_contact_forces(scene_object *s, scene_drain *b)
{
    drain_object *d = b->drain;
    uint32_t n = d->mesh.node_count;
    memset(d->contact_forces, 0, n * sizeof *d->contact_forces);
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        const contact_constraint *constraint = &s->contacts->constraints[i];
        vec3 force;
        bool has_force = vbss_scene_find_contact_force(s->contacts, i, &force);
        for (uint32_t k = 0; has_force && k < constraint->jacobian_block_count; k++) {
            const contact_jacobian_block *t = &constraint->jacobian[k];
            if (t->block >= b->first_block && t->block - b->first_block < n) {
                uint32_t node = d->order.node[t->block - b->first_block];
                d->contact_forces[node] =
                    vec3_add_scaled(d->contact_forces[node], t->weight, force);
            }
        }
    }
}

/* Pins that lag behind their targets start the next step from where they are. */
static void restart_pins_here(drain_object *d)
{
    for (uint32_t k = 0; k < d->config.attachment_capacity; k++) {
        drain_attachment *a = &d->attachments[k];
        if (a->id != 0 && a->kind == VBSS_DRAIN_ATTACHMENT_PIN) {
            a->position = d->x[a->node];
        }
    }
}

static void finish_drains(scene_object *s, double h)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_drain *b = &s->bodies[i].drain;
        if (scene_active_kind(&s->bodies[i]) == SCENE_BODY_DRAIN) {
            accumulate_contact_forces(s, b);
            if (s->cursor.is_behind_targets) { /* the last forces are those of a rejected attempt */
                vbss_drain_compute_internal_forces(b->drain, b->drain->x);
            }
            vbss_drain_finish_substeps(b->drain, b->substep.h);
            if (s->cursor.is_behind_targets) {
                restart_pins_here(b->drain);
            }
            vbss_drain_finish_step(b->drain, h);
        }
    }
}

void vbss_scene_finish_group(scene_object *s)
{
    const double h = s->cursor.substep.step_length;
    finish_motion(s, h);
    finish_drains(s, h);
    vbss_scene_collect_forces(s);
    vbss_scene_update_holes(s);
}

void vbss_scene_finish_step(scene_object *s)
{
    const double h = s->cursor.substep.step_length;
    finish_motion(s, h);
    finish_drains(s, h);
    vbss_scene_update_cut_exclusions(s);
    vbss_scene_update_touching_pairs(s);
    vbss_scene_collect_forces(s);
    vbss_scene_locate_touch_events(s);
    vbss_scene_update_holes(s);
    vbss_scene_release_groups(s);
    update_tools(s, h);
    vbss_scene_adapt_meshes(s);
    vbss_scene_close_holes_of_short_threads(s);
    vbss_scene_end_blockers(s);
    record_operations(s);
    s->report.statistics.rows = s->contacts->count;
    s->report.statistics.state_solves = s->contacts->counters.solves;
    s->report.statistics.loose_states = s->contacts->counters.inexact;
    s->report.statistics.separators = s->system->unknown_count - s->system->interior_count;
}
