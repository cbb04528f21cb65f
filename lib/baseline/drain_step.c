/* One step of the baseline drain in equal explicit substeps, like the baseline thread:
 *   forces -> velocities (symplectic Euler) -> damping -> positions.
 * Only the damping and contacts with other bodies couple neighbouring particles. */
#include "base/error.h"
#include "base/memory.h"
#include "baseline/divergence.h"
#include "baseline/drain.h"
#include "baseline/explicit_substeps.h"

#include <string.h>

static void prepare_masses(drain_object *d)
{
    memcpy(d->baseline->free_mass, d->mass, d->mesh.node_count * sizeof *d->mass);
    for (uint32_t k = 0; k < d->config.attachment_capacity; k++) {
        const drain_attachment *a = &d->attachments[k];
        if (a->id != 0 && a->kind == VBSS_DRAIN_ATTACHMENT_PIN) {
            d->baseline->free_mass[a->node] = 0.0;
        }
    }
}

/* A particle on its spring is stable below dt = 2 sqrt(mass / stiffness). Drag and attached
 * springs only raise this limit. */
static uint32_t count_parts(const drain_object *d, double h)
{
    double rate = 0.0;
    if (d->config.baseline->drain_substeps > 0) {
        return d->config.baseline->drain_substeps;
    }
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        if (d->baseline->free_mass[i] > 0.0) {
            rate = vbss_max_or_nan(
                0.25 * d->config.baseline->drain_stiffness / d->baseline->free_mass[i], rate);
        }
    }
    return vbss_baseline_substep_count(h, rate);
}

/* Drag and attached springs are implicit and count as mass, as in the baseline thread. */
static void prepare_mobilities(drain_object *d, double dt)
{
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        d->baseline->mobility[i] = d->mass[i] * (1.0 + dt * d->config.drag);
    }
    for (uint32_t k = 0; k < d->config.attachment_capacity; k++) {
        const drain_attachment *a = &d->attachments[k];
        if (a->id != 0 && a->kind == VBSS_DRAIN_ATTACHMENT_SPRING) {
            d->baseline->mobility[a->node] += dt * dt * a->stiffness;
        }
    }
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        d->baseline->mobility[i] =
            d->baseline->free_mass[i] > 0.0 ? 1.0 / d->baseline->mobility[i] : 0.0;
    }
}

/* ---- one explicit substep */

static void pull_back(drain_object *d)
{
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        d->internal_forces[i] = vec3_scale(vec3_sub(d->baseline->rest[i], d->x[i]),
                                           d->config.baseline->drain_stiffness);
    }
}

/* Adds gravity and the forces of attachments to the forces of the springs. */
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
            vec3 stretch = vec3_sub(vbss_drain_attachment_position(a, end), d->x[a->node]);
            *sum = vec3_add_scaled(*sum, a->stiffness, stretch);
        }
    }
}

static void set_velocities(drain_object *d, double dt, const vec3 *sums)
{
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        vec3 impulse = vec3_add_scaled(vec3_scale(d->v[i], d->mass[i]), dt, sums[i]);
        d->v[i] = vec3_scale(impulse, d->baseline->mobility[i]);
    }
    if (d->config.baseline->drain_damping > 0.0) {
        vbss_damp_relative_motion(d->baseline->free_mass, d->x, d->v, 0, d->mesh.node_count - 1,
                                  d->config.baseline->drain_damping);
    }
}

static void move_to(drain_object *d, uint32_t node, vec3 to)
{
    double distance = vec3_distance(to, d->x[node]);
    d->baseline->last_move = vbss_max_or_nan(distance, d->baseline->last_move);
    d->x[node] = to;
}

/* Moves free particles with their velocities, and pinned ones evenly towards their targets. */
static void move(drain_object *d, double dt, double end)
{
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        if (d->baseline->free_mass[i] > 0.0) {
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

vbss_result vbss_baseline_move_drain(drain_object *d, double h)
{
    d->baseline->last_move = 0.0;
    prepare_masses(d);
    uint32_t parts = count_parts(d, h);
    double dt = h / parts;
    d->baseline->explicit_step = dt;
    prepare_mobilities(d, dt);
    make_parts(d, dt, parts);
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        d->v[i] = vbss_drain_flush_velocity(d->v[i]);
    }
    VBSS_TRY(vbss_baseline_check_drain(d));
    d->statistics.parts += parts;
    d->statistics.last_move = d->baseline->last_move;
    return VBSS_OK;
}

void vbss_baseline_finish_drain(drain_object *d)
{
    vbss_drain_commit_attachments(d);
    vbss_drain_update_reactions(d, d->baseline->explicit_step);
}

/* ---- the method */

static vbss_result step_drain(drain_object *d, double h)
{
    VBSS_TRY(vbss_baseline_move_drain(d, h));
    vbss_baseline_finish_drain(d);
    return VBSS_OK;
}

static void add_energies(drain_object *d, vbss_drain_energies *energies)
{
    double sum = 0.0;
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        vec3 displacement = vec3_sub(d->x[i], d->baseline->rest[i]);
        sum += 0.5 * d->config.baseline->drain_stiffness * vec3_norm_squared(displacement);
    }
    energies->springs = sum;
}

static drain_mesh_kind mesh_kind(const vbss_drain_config *config)
{
    (void)config;
    return DRAIN_MESH_6X12;
}

enum { ARRAY_COUNT = 3 };

static void list_arrays(const drain_object *d, vbss_array arrays[ARRAY_COUNT])
{
    baseline_drain *own = d->baseline;
    size_t n = d->mesh.node_count;
    arrays[0] = (vbss_array){&own->rest, n, sizeof *own->rest};
    arrays[1] = (vbss_array){&own->free_mass, n, sizeof *own->free_mass};
    arrays[2] = (vbss_array){&own->mobility, n, sizeof *own->mobility};
}

static vbss_result create_drain(drain_object *d)
{
    vbss_array arrays[ARRAY_COUNT];
    d->baseline = vbss_allocate(d->context, 1, sizeof *d->baseline, "drain");
    if (d->baseline == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    list_arrays(d, arrays);
    VBSS_TRY(vbss_allocate_arrays(d->context, arrays, ARRAY_COUNT, "drain"));
    memcpy(d->baseline->rest, d->x, d->mesh.node_count * sizeof *d->x);
    return VBSS_OK;
}

static void destroy_drain(vbss_context *context, drain_object *d)
{
    vbss_array arrays[ARRAY_COUNT];
    if (d->baseline != NULL) {
        list_arrays(d, arrays);
        vbss_release_arrays(context, arrays, ARRAY_COUNT);
        vbss_release(context, d->baseline, 1, sizeof *d->baseline);
    }
}

const drain_method vbss_baseline_drain = {
    .mesh_kind = mesh_kind,
    .create_drain = create_drain,
    .destroy_drain = destroy_drain,
    .step_drain = step_drain,
    .add_energies = add_energies,
    .is_surface = true,
};
