/* Reactions: forces and torques of attachments on the thread, computed at the end of each step. */
#include "thread/bending_memory.h"
#include "thread/twist.h"

/* Gradient of the stretching energy with a clamp's direction, on which the length of its
 * arcs depends. */
static vec3 arc_gradient(const thread_object *t, uint32_t clamp)
{
    uint32_t node = t->clamps[clamp].node, segments = t->node_count - 1;
    uint32_t end = node + 2 < segments ? node + 2 : segments;
    vec3 gradient = vec3_zero();
    for (uint32_t i = node < 2 ? 0 : node - 2; i < end; i++) {
        const thread_arc *arc = &t->arcs[i];
        for (int c = 0; c < 2; c++) {
            if (arc->clamp_coefficient[c] != 0.0 && arc->clamp_index[c] == clamp) {
                double coefficient =
                    2.0 * arc->length_coefficient * t->now.tension[i] * arc->clamp_coefficient[c];
                gradient = vec3_add_scaled(gradient, coefficient, t->strains[i].curvature);
            }
        }
    }
    return gradient;
}

static vec3 clamp_torque(const thread_object *t, uint32_t c)
{
    const thread_clamp *clamp = &t->clamps[c];
    /* Gradient of the energy with the direction. The torque is the direction times the gradient. */
    vec3 gradient =
        vec3_add(arc_gradient(t, c), vbss_thread_rest_curvature_gradient(t, clamp->node));
    if (thread_has_memory(t)) {
        gradient = vec3_add(gradient, vbss_thread_bending_memory_gradient(t, clamp->node));
    }
    gradient = vec3_add_scaled(gradient, clamp->own_coefficient, clamp->direction);
    if (c + 1 < t->clamp_count) {
        gradient = vec3_add_scaled(gradient, clamp->next_coefficient, t->clamps[c + 1].direction);
    }
    if (c > 0) {
        gradient = vec3_add_scaled(gradient, t->clamps[c - 1].next_coefficient,
                                   t->clamps[c - 1].direction);
    }
    for (uint32_t k = 0; k <= 2 * THREAD_CLAMP_BANDWIDTH; k++) {
        if (clamp->coefficient[k] != 0.0) {
            gradient = vec3_add_scaled(gradient, clamp->coefficient[k],
                                       t->now.x[clamp->node + k - THREAD_CLAMP_BANDWIDTH]);
        }
    }
    return vec3_cross(clamp->direction, gradient);
}

vec3 vbss_thread_implicit_reaction_torque(const thread_object *t, uint32_t node)
{
    for (uint32_t c = 0; c < t->clamp_count; c++) {
        if (t->clamps[c].node == node) {
            const vec3 torque = clamp_torque(t, c);
            return thread_has_twist(t) ? vec3_add(torque, vbss_thread_twist_torque(t, node))
                                       : torque;
        }
    }
    return vec3_zero();
}

static vec3 spring_force(const thread_object *t, const thread_attachment *a)
{
    vec3 extension = vec3_sub(a->position, t->now.x[a->node]);
    vec3 relative_velocity = vec3_sub(a->velocity, t->now.v[a->node]);
    return vec3_add_scaled(vec3_scale(extension, a->stiffness), a->damping, relative_velocity);
}

/* Forces of loads and springs at a node that another attachment prescribes. */
static vec3 other_forces(const thread_object *t, uint32_t node)
{
    vec3 sum = vec3_zero();
    for (uint32_t i = 0; i < t->config.attachment_capacity; i++) {
        const thread_attachment *a = &t->attachments[i];
        if (a->id != 0 && a->node == node && a->kind == VBSS_THREAD_ATTACHMENT_FORCE) {
            sum = vec3_add(sum, a->force);
        } else if (a->id != 0 && a->node == node && a->kind == VBSS_THREAD_ATTACHMENT_SPRING) {
            sum = vec3_add(sum, spring_force(t, a));
        }
    }
    return sum;
}

vec3 vbss_thread_implicit_reaction_force(const thread_object *t, uint32_t node)
{
    return vec3_sub(vbss_thread_implicit_constraint_force(t, node), other_forces(t, node));
}

static void update_reaction(const thread_object *t, thread_attachment *a)
{
    a->reaction_torque = vec3_zero();
    if (vbss_thread_prescribes_motion(a->kind)) {
        /* Without loads and springs at the node. */
        a->reaction = t->method->reaction_force(t, a->node);
        a->reaction_torque = t->method->reaction_torque(t, a->node);
    } else if (a->kind == VBSS_THREAD_ATTACHMENT_FORCE) {
        a->reaction = a->force;
    } else if (a->kind == VBSS_THREAD_ATTACHMENT_SPRING) {
        a->reaction = spring_force(t, a);
    } else if (a->kind == VBSS_THREAD_ATTACHMENT_ROLL) {
        a->reaction = vec3_zero();
        a->reaction_torque = vbss_thread_twist_torque(t, a->node);
    } else {
        vec3 slowed = vec3_add_scaled(t->now.q[a->node], t->config.drag, t->now.v[a->node]);
        a->reaction = vec3_scale(vec3_sub(t->gravity, slowed), a->mass);
    }
}

void vbss_thread_update_reactions(thread_object *t)
{
    for (uint32_t i = 0; i < t->config.attachment_capacity; i++) {
        if (t->attachments[i].id != 0) {
            update_reaction(t, &t->attachments[i]);
        }
    }
}
