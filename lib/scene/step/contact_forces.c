/* Forces of contacts and pins on rigid bodies, and the published views of contacts. */
#include "scene/step/step.h"
#include "scene/tools/tools.h"
#include "scene/world/method.h"
#include "scene/world/world.h"

#include <string.h>

void vbss_scene_add_force(scene_body *b, vec3 point, vec3 force)
{
    if (b != NULL && b->kind == SCENE_BODY_RIGID) {
        scene_rigid *r = &b->rigid;
        vec3 arm = vec3_sub(point, r->body.now.pose.position);
        r->force = vec3_add(r->force, force);
        r->torque = vec3_add(r->torque, vec3_cross(arm, force));
    }
}

static void copy_view(scene_report *r, uint32_t to, uint32_t from)
{
    memcpy(r->contact_features[to], r->contact_features[from], sizeof r->contact_features[to]);
    r->contact_points[to] = r->contact_points[from];
    r->contact_normals[to] = r->contact_normals[from];
    r->contact_forces[to] = r->contact_forces[from];
    r->contact_gaps[to] = r->contact_gaps[from];
}

/* Removes the contacts of the step before, which groups that wait still show. */
static void remove_old_contacts(scene_report *r)
{
    for (uint32_t i = r->old_contact_count; i < r->contact_count; i++) {
        copy_view(r, i - r->old_contact_count, i);
    }
    r->contact_count -= r->old_contact_count;
    r->old_contact_count = 0;
}

void vbss_scene_publish_contact(scene_object *s, const scene_contact_record *contact)
{
    /* All groups together may have more contacts than the views can show. */
    if (s->report.contact_count == s->config.contact_capacity) {
        remove_old_contacts(&s->report);
    }
    if (s->report.contact_count == s->config.contact_capacity) {
        return;
    }
    uint32_t i = s->report.contact_count++;
    const contact_key *key = &contact->key;
    const uint32_t features[5] = {key->kind, key->body_a, key->feature_a, key->body_b,
                                  key->feature_b};
    for (int k = 0; k < 5; k++) {
        s->report.contact_features[i][k] = features[k];
    }
    s->report.contact_points[i] = contact->point;
    s->report.contact_normals[i] = contact->normal;
    s->report.contact_forces[i] = contact->force;
    s->report.contact_gaps[i] = contact->gap;
}

/* The rigid body that a block belongs to: by its translation block, or by a pin that holds
 * the node. */
static scene_body *rigid_body_of_block(scene_object *s, uint32_t block_index)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *body = &s->bodies[i];
        if (body->kind == SCENE_BODY_RIGID && (body->rigid.blocks.first == block_index ||
                                               scene_is_vertex_block(&body->rigid, block_index))) {
            return body;
        }
    }
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        const scene_pin *p = &s->pins[i];
        if (p->attachment != 0 && vbss_scene_pin_holds(s, p) &&
            vbss_scene_body(s, p->thread)->thread.first_block + p->node == block_index) {
            return vbss_scene_body(s, p->body);
        }
    }
    return NULL;
}

bool vbss_scene_find_contact_force(const contact_set *set, uint32_t i, vec3 *force)
{
    const contact_constraint *constraint = &set->constraints[i];
    contact_solution solution = constraint->solution;
    /* After a search that was stopped, bodies are balanced with this force, not with that of the
     * contact law. */
    if (set->is_stopped_early && !constraint->is_bilateral) {
        *force = set->current[i].force;
        return vec3_norm_squared(*force) > 0.0;
    }
    /* Its force follows from the current geometry, which may be newer than the stored solution. */
    if (constraint->is_bilateral) {
        (void)vbss_contact_update_solution(constraint, vec3_zero(), &solution);
    }
    *force = vec3_add_scaled(solution.tangential_force, solution.normal_force, constraint->normal);
    return constraint->solution.status != CONTACT_OPEN;
}

void vbss_scene_publish_constraints(scene_object *s)
{
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        const contact_constraint *constraint = &s->contacts->constraints[i];
        vec3 force;
        if (!vbss_scene_find_contact_force(s->contacts, i, &force)) {
            continue;
        }
        const vec3 point = scene_geometry_of(s, constraint)->point;
        const double gap = constraint->gap - constraint->recovery_allowance;
        const scene_contact_record contact = {constraint->key, constraint->normal, force, point,
                                              gap};
        vbss_scene_publish_contact(s, &contact);
        scene_body *other = vbss_scene_body(s, constraint->key.body_b);
        if (scene_is_plane(other) || scene_is_static_mesh(other)) { /* no part of the system */
            vbss_scene_add_force(other, point, vec3_neg(force));
        }
        /* The forces after a rejected attempt are no solution: a host with a model would integrate them. */
        if (!s->cursor.is_behind_targets) {
            vbss_scene_add_surface_forces(s, constraint, force);
        }
        for (uint32_t k = 0; k < constraint->jacobian_block_count; k++) {
            const contact_jacobian_block *jacobian_block = &constraint->jacobian[k];
            if (!jacobian_block->is_rotation) {
                vbss_scene_add_force(rigid_body_of_block(s, jacobian_block->block), point,
                                     vec3_scale(force, jacobian_block->weight));
            }
        }
    }
}

/* The body holds the node against what the thread and its inertia do. */
static void add_pin_forces(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.pin_capacity; i++) {
        const scene_pin *p = &s->pins[i];
        scene_body *b = vbss_scene_body(s, p->body);
        if (b == NULL || !vbss_scene_pin_holds(s, p) ||
            !scene_is_active(vbss_scene_body(s, p->thread))) {
            continue;
        }
        const thread_object *t = vbss_scene_body(s, p->thread)->thread.thread;
        vec3 constraint_force = t->method->constraint_force(t, p->node);
        vbss_scene_add_force(b, t->now.x[p->node], vec3_neg(constraint_force));
    }
}

/* Removes the contacts of bodies that took part in the last substep from the views. New ones
 * follow. */
static void remove_renewed_contacts(scene_object *s)
{
    scene_report *r = &s->report;
    uint32_t count = 0, old_count = 0;
    for (uint32_t i = 0; s->cursor.group_count > 1 && i < r->contact_count; i++) {
        const uint32_t *features = r->contact_features[i];
        const scene_body *a = vbss_scene_body(s, features[1]), *b = vbss_scene_body(s, features[3]);
        if (a == NULL || scene_is_active(a) || scene_is_active(b)) {
            continue;
        }
        if (count < i) {
            copy_view(r, count, i);
        }
        old_count += i < r->old_contact_count;
        count++;
    }
    r->contact_count = count;
    r->old_contact_count = old_count;
}

void vbss_scene_collect_forces(scene_object *s)
{
    remove_renewed_contacts(s);
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (scene_active_kind(&s->bodies[i]) == SCENE_BODY_RIGID) {
            s->bodies[i].rigid.force = s->bodies[i].rigid.torque = vec3_zero();
            if (s->bodies[i].rigid.surface != NULL && !s->cursor.is_behind_targets) {
                vbss_scene_clear_surface_forces(s->bodies[i].rigid.surface);
            }
        }
    }
    s->method->publish_contacts(s);
    add_pin_forces(s);
    vbss_scene_add_section_torques(s);
    if (s->cursor.group + 1 >= s->cursor.group_count) { /* no group waits */
        s->report.statistics.contacts = s->report.contact_count;
    }
}
