/* The drain's part of a system: backward Euler about the trial state,
 *   (M (1 + drag h) / h^2 + K) u = f + M (g + v / h) - M (1 + drag h) / h^2 (trial - x),
 * with the shell's forces f and its positive semi-definite tangent K, u what the trial state is moved by. */
#include "drain/drain.h"

#include <string.h>

/* A pinned node's equation is overruled: of 1e30 N/m nothing else is left. Elimination then takes its way to the
 * right-hand sides of its neighbours, where prescribed motion belongs. */
#define OVERRULED 1e30

static double inertia_of(const drain_object *d, const drain_stage *stage, uint32_t node)
{
    return d->mass[node] * (1.0 + d->config.drag * stage->h) / (stage->h * stage->h);
}

static vec3 balance(const drain_object *d, const drain_stage *stage, uint32_t node)
{
    vec3 moved = vec3_sub(d->trial[node], d->x[node]);
    vec3 thrown = vec3_add_scaled(d->gravity, 1.0 / stage->h, d->v[node]);
    vec3 sum = vec3_add_scaled(d->forces[node], d->mass[node], thrown);
    return vec3_add_scaled(sum, -inertia_of(d, stage, node), moved);
}

static void set_rhs(drain_object *d, const drain_stage *stage, vbss_system *s, uint32_t first)
{
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        s->rhs[first + d->order.place[i]] = balance(d, stage, i);
    }
    for (uint32_t k = 0; k < d->config.attachment_capacity; k++) {
        const drain_attachment *a = &d->attachments[k];
        vec3 *rhs = &s->rhs[first + d->order.place[a->node]];
        vec3 way = vec3_sub(vbss_drain_attachment_position(a, stage->part_end), d->trial[a->node]);
        if (a->id == 0) {
            continue;
        }
        if (a->kind == VBSS_DRAIN_ATTACHMENT_FORCE) {
            *rhs = vec3_add(*rhs, a->force);
        } else if (a->kind == VBSS_DRAIN_ATTACHMENT_SPRING) {
            *rhs = vec3_add_scaled(*rhs, a->stiffness, way);
        }
    }
    for (uint32_t k = 0; k < d->config.attachment_capacity; k++) {
        const drain_attachment *a = &d->attachments[k];
        if (a->id != 0 && a->kind == VBSS_DRAIN_ATTACHMENT_PIN) {
            vec3 to = vbss_drain_attachment_position(a, stage->part_end);
            s->rhs[first + d->order.place[a->node]] =
                vec3_scale(vec3_sub(to, d->trial[a->node]), OVERRULED);
        }
    }
}

static void add_to_diagonal(block *b, double stiffness)
{
    b->column[0] = lanes_add(b->column[0], lanes_make(stiffness, 0.0, 0.0));
    b->column[1] = lanes_add(b->column[1], lanes_make(0.0, stiffness, 0.0));
    b->column[2] = lanes_add(b->column[2], lanes_make(0.0, 0.0, stiffness));
}

static void set_diagonal(drain_object *d, const drain_stage *stage, vbss_system *s, uint32_t first)
{
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        block *b = &s->diagonal[first + d->order.place[i]];
        *b = d->diagonal[i];
        add_to_diagonal(b, inertia_of(d, stage, i));
    }
    for (uint32_t k = 0; k < d->config.attachment_capacity; k++) {
        const drain_attachment *a = &d->attachments[k];
        double more = a->kind == VBSS_DRAIN_ATTACHMENT_PIN      ? OVERRULED
                      : a->kind == VBSS_DRAIN_ATTACHMENT_SPRING ? a->stiffness
                                                                : 0.0;
        if (a->id != 0) {
            add_to_diagonal(&s->diagonal[first + d->order.place[a->node]], more);
        }
    }
}

static void empty_couplings(const drain_object *d, vbss_system *s)
{
    block *first = &s->off_diagonal[d->order.first_coupling];
    memset(&s->off_diagonal[VBSS_NO_COUPLING], 0, sizeof *s->off_diagonal);
    memset(first, 0, d->order.coupling_count * sizeof *first);
}

void vbss_drain_find_forces(drain_object *d, const vec3 *x)
{
    memset(d->forces, 0, d->mesh.node_count * sizeof *d->forces);
    vbss_shell_add_forces(&d->shell, x, d->forces);
}

void vbss_drain_assemble(drain_object *d, const drain_stage *stage, vbss_system *s, uint32_t first)
{
    empty_couplings(d, s);
    memset(d->forces, 0, d->mesh.node_count * sizeof *d->forces);
    memset(d->diagonal, 0, d->mesh.node_count * sizeof *d->diagonal);
    vbss_shell_assemble(&d->shell, d->trial, d->forces, d->diagonal, s->off_diagonal);
    set_diagonal(d, stage, s, first);
    set_rhs(d, stage, s, first);
}

void vbss_drain_assemble_rhs(drain_object *d, const drain_stage *stage, vbss_system *s,
                             uint32_t first)
{
    vbss_drain_find_forces(d, d->trial);
    set_rhs(d, stage, s, first);
}
