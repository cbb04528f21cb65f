/* Assembly: the drain's part of a system, backward Euler about the trial state,
 *
 *   (M (1 + drag h) / h^2 + K) u = f + M (g + v / h) - M (1 + drag h) / h^2 (trial - x)
 *
 * with the shell's forces f, its positive semi-definite tangent K, and the increment u of the
 * trial state. */
#include "drain/drain.h"

#include <string.h>

/* A stiffness of 1e30 N/m dominates the equation of a pinned node. Elimination then moves its displacement to the
 * right-hand sides of its neighbours, where prescribed motion belongs. */
#define PENALTY_STIFFNESS 1e30

static double inertia_of(const drain_object *d, const drain_substep *substep, uint32_t node)
{
    return d->mass[node] * (1.0 + d->config.drag * substep->h) / (substep->h * substep->h);
}

static vec3 node_residual(const drain_object *d, const drain_substep *substep, uint32_t node)
{
    vec3 displacement = vec3_sub(d->trial[node], d->x[node]);
    vec3 free_acceleration = vec3_add_scaled(d->gravity, 1.0 / substep->h, d->v[node]);
    vec3 sum = vec3_add_scaled(d->internal_forces[node], d->mass[node], free_acceleration);
    return vec3_add_scaled(sum, -inertia_of(d, substep, node), displacement);
}

static void set_rhs(drain_object *d, const drain_substep *substep, vbss_system *s, uint32_t first)
{
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        s->rhs[first + d->order.block_index[i]] = node_residual(d, substep, i);
    }
    for (uint32_t k = 0; k < d->config.attachment_capacity; k++) {
        const drain_attachment *a = &d->attachments[k];
        vec3 *rhs = &s->rhs[first + d->order.block_index[a->node]];
        vec3 extension =
            vec3_sub(vbss_drain_attachment_position(a, substep->end_fraction), d->trial[a->node]);
        if (a->id == 0) {
            continue;
        }
        if (a->kind == VBSS_DRAIN_ATTACHMENT_FORCE) {
            *rhs = vec3_add(*rhs, a->force);
        } else if (a->kind == VBSS_DRAIN_ATTACHMENT_SPRING) {
            *rhs = vec3_add_scaled(*rhs, a->stiffness, extension);
        }
    }
    for (uint32_t k = 0; k < d->config.attachment_capacity; k++) {
        const drain_attachment *a = &d->attachments[k];
        if (a->id != 0 && a->kind == VBSS_DRAIN_ATTACHMENT_PIN) {
            vec3 to = vbss_drain_attachment_position(a, substep->end_fraction);
            s->rhs[first + d->order.block_index[a->node]] =
                vec3_scale(vec3_sub(to, d->trial[a->node]), PENALTY_STIFFNESS);
        }
    }
}

static void add_to_diagonal(block *b, double stiffness)
{
    b->column[0] = lanes_add(b->column[0], lanes_make(stiffness, 0.0, 0.0));
    b->column[1] = lanes_add(b->column[1], lanes_make(0.0, stiffness, 0.0));
    b->column[2] = lanes_add(b->column[2], lanes_make(0.0, 0.0, stiffness));
}

static void set_diagonal(drain_object *d, const drain_substep *substep, vbss_system *s,
                         uint32_t first)
{
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        block *b = &s->diagonal[first + d->order.block_index[i]];
        *b = d->diagonal[i];
        add_to_diagonal(b, inertia_of(d, substep, i));
    }
    for (uint32_t k = 0; k < d->config.attachment_capacity; k++) {
        const drain_attachment *a = &d->attachments[k];
        double added_stiffness = a->kind == VBSS_DRAIN_ATTACHMENT_PIN      ? PENALTY_STIFFNESS
                                 : a->kind == VBSS_DRAIN_ATTACHMENT_SPRING ? a->stiffness
                                                                           : 0.0;
        if (a->id != 0) {
            add_to_diagonal(&s->diagonal[first + d->order.block_index[a->node]], added_stiffness);
        }
    }
}

static void clear_couplings(const drain_object *d, vbss_system *s)
{
    block *first = &s->off_diagonal[d->order.first_coupling];
    memset(&s->off_diagonal[VBSS_NO_COUPLING], 0, sizeof *s->off_diagonal);
    memset(first, 0, d->order.coupling_count * sizeof *first);
}

void vbss_drain_compute_internal_forces(drain_object *d, const vec3 *x)
{
    memset(d->internal_forces, 0, d->mesh.node_count * sizeof *d->internal_forces);
    vbss_shell_add_forces(&d->shell, x, d->internal_forces);
}

/* Also sets the internal forces of the tangent's shape. */
static void set_matrix(drain_object *d, const drain_substep *substep, vbss_system *s,
                       uint32_t first)
{
    const vec3 *shape = d->tangents[d->attempt_tangent].shape;
    clear_couplings(d, s);
    memset(d->internal_forces, 0, d->mesh.node_count * sizeof *d->internal_forces);
    memset(d->diagonal, 0, d->mesh.node_count * sizeof *d->diagonal);
    vbss_shell_assemble(&d->shell, shape, d->internal_forces, d->diagonal, s->off_diagonal);
    set_diagonal(d, substep, s, first);
}

void vbss_drain_assemble(drain_object *d, const drain_substep *substep, vbss_system *s,
                         uint32_t first)
{
    if (d->factored_in != s) {
        set_matrix(d, substep, s, first);
    }
    if (d->keeps_tangent) {
        vbss_drain_compute_internal_forces(d, d->trial);
    }
    set_rhs(d, substep, s, first);
}

void vbss_drain_assemble_rhs(drain_object *d, const drain_substep *substep, vbss_system *s,
                             uint32_t first)
{
    vbss_drain_compute_internal_forces(d, d->trial);
    set_rhs(d, substep, s, first);
}
