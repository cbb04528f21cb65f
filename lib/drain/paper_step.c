/* Method PAPER: the drain of VBLaST-SS (Qi et al. 2017), particles tied to their rest positions by a spring each. One
 * step in equal explicit parts, as the paper's thread:
 *   forces -> velocities (symplectic Euler) -> damping -> positions.
 * Nothing but the damping and the collision with others knows neighbours. docs/paper-drain.md tells what the paper
 * leaves open. */
#include "base/error.h"
#include "drain/drain.h"

#include <string.h>

static void prepare_masses(drain_object *d)
{
    memcpy(d->free_mass, d->mass, d->mesh.node_count * sizeof *d->mass);
    for (uint32_t k = 0; k < d->config.attachment_capacity; k++) {
        const drain_attachment *a = &d->attachments[k];
        if (a->id != 0 && a->kind == VBSS_DRAIN_ATTACHMENT_PIN) {
            d->free_mass[a->node] = 0.0;
        }
    }
}

/* A particle on its spring is stable below dt = 2 sqrt(mass / stiffness); what resists its velocity lengthens this. */
static uint32_t count_parts(const drain_object *d, double h)
{
    double rate = 0.0;
    if (d->config.paper_substeps > 0) {
        return d->config.paper_substeps;
    }
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        if (d->free_mass[i] > 0.0) {
            rate = vbss_max_or_nan(0.25 * d->config.paper_stiffness / d->free_mass[i], rate);
        }
    }
    return vbss_explicit_substep_count(h, rate);
}

/* Drag and attached springs are implicit and count as mass, as in the paper's thread. */
static void prepare_mobilities(drain_object *d, double dt)
{
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        d->mobility[i] = d->mass[i] * (1.0 + dt * d->config.drag);
    }
    for (uint32_t k = 0; k < d->config.attachment_capacity; k++) {
        const drain_attachment *a = &d->attachments[k];
        if (a->id != 0 && a->kind == VBSS_DRAIN_ATTACHMENT_SPRING) {
            d->mobility[a->node] += dt * dt * a->stiffness;
        }
    }
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        d->mobility[i] = d->free_mass[i] > 0.0 ? 1.0 / d->mobility[i] : 0.0;
    }
}

/* ---- one explicit part */

static void pull_back(drain_object *d)
{
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        d->internal_forces[i] =
            vec3_scale(vec3_sub(d->ties[i], d->x[i]), d->config.paper_stiffness);
    }
}

/* What attachments add to the forces of the springs. */
static void gather_forces(drain_object *d, double end, vec3 *sums)
{
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        sums[i] = vec3_add_scaled(d->internal_forces[i], d->mass[i], d->gravity);
    }
    for (uint32_t k = 0; k < d->config.attachment_capacity; k++) {
        const drain_attachment *a = &d->attachments[k];
        vec3 *sum = &sums[a->node];
        if (a->id != 0 && a->kind == VBSS_DRAIN_ATTACHMENT_FORCE) {
            *sum = vec3_add(*sum, a->force);
        } else if (a->id != 0 && a->kind == VBSS_DRAIN_ATTACHMENT_SPRING) {
            vec3 way = vec3_sub(vbss_drain_attachment_position(a, end), d->x[a->node]);
            *sum = vec3_add_scaled(*sum, a->stiffness, way);
        }
    }
}

static void set_velocities(drain_object *d, double dt, const vec3 *sums)
{
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        vec3 impulse = vec3_add_scaled(vec3_scale(d->v[i], d->mass[i]), dt, sums[i]);
        d->v[i] = vec3_scale(impulse, d->mobility[i]);
    }
    if (d->config.paper_damping > 0.0) {
        vbss_damp_relative_motion(d->free_mass, d->x, d->v, 0, d->mesh.node_count - 1,
                                  d->config.paper_damping);
    }
}

static void move_to(drain_object *d, uint32_t node, vec3 to)
{
    double way = vec3_distance(to, d->x[node]);
    d->statistics.last_move = vbss_max_or_nan(way, d->statistics.last_move);
    d->x[node] = to;
}

/* Pinned particles go evenly to their places. */
static void move(drain_object *d, double dt, double end)
{
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        if (d->free_mass[i] > 0.0) {
            move_to(d, i, vec3_add_scaled(d->x[i], dt, d->v[i]));
        }
    }
    for (uint32_t k = 0; k < d->config.attachment_capacity; k++) {
        const drain_attachment *a = &d->attachments[k];
        if (a->id != 0 && a->kind == VBSS_DRAIN_ATTACHMENT_PIN) {
            vec3 to = vbss_drain_attachment_position(a, end);
            d->v[a->node] = vec3_scale(vec3_sub(to, d->x[a->node]), 1.0 / dt);
            move_to(d, a->node, to);
        }
    }
}

/* ---- the step */

static void make_parts(drain_object *d, double dt, uint32_t parts)
{
    vec3 *sums = d->trial;
    for (uint32_t part = 0; part < parts; part++) {
        double end = (part + 1.0) / parts;
        memcpy(d->v_substep_start, d->v, d->mesh.node_count * sizeof *d->v);
        pull_back(d);
        gather_forces(d, end, sums);
        set_velocities(d, dt, sums);
        move(d, dt, end);
    }
}

/* A sum is finite only if all its terms are. */
static bool is_finite(const drain_object *d)
{
    double sum = 0.0;
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        sum += vec3_norm_squared(d->x[i]) + vec3_norm_squared(d->v[i]);
    }
    return sum < 1e100;
}

vbss_result vbss_drain_paper_move(drain_object *d, double h, double *part)
{
    prepare_masses(d);
    uint32_t parts = count_parts(d, h);
    *part = h / parts;
    prepare_mobilities(d, *part);
    make_parts(d, *part, parts);
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        d->v[i] = vbss_drain_flush_velocity(d->v[i]);
    }
    if (!is_finite(d)) {
        return VBSS_ERROR_NOT_FINITE;
    }
    d->statistics.parts += parts;
    return VBSS_OK;
}

void vbss_drain_paper_arrive(drain_object *d, double part)
{
    vbss_drain_commit_attachments(d);
    vbss_drain_update_reactions(d, part);
}

vbss_result vbss_drain_paper_step(drain_object *d, double h)
{
    double part;
    VBSS_TRY(vbss_drain_paper_move(d, h, &part));
    vbss_drain_paper_arrive(d, part);
    return VBSS_OK;
}

double vbss_drain_paper_energy(const drain_object *d)
{
    double sum = 0.0;
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        vec3 way = vec3_sub(d->x[i], d->ties[i]);
        sum += 0.5 * d->config.paper_stiffness * vec3_norm_squared(way);
    }
    return sum;
}
