/* Snapshot of a drain: one visitor that saves, hashes and restores its state. */
#include "base/check.h"
#include "base/stream.h"
#include "drain/drain.h"

#include <string.h>

/* The configuration that has to be equal on restore. */
static void visit_config(vbss_stream *stream, const drain_object *d)
{
    const vbss_drain_config *c = &d->config;
    const double numbers[] = {c->radius,
                              c->length,
                              c->thickness,
                              c->slit_length,
                              c->slit_opening,
                              c->mark_arc,
                              c->young_modulus,
                              c->poisson_ratio,
                              c->density,
                              c->drag,
                              c->gravity[0],
                              c->gravity[1],
                              c->gravity[2],
                              c->position[0],
                              c->position[1],
                              c->position[2],
                              d->frame.orientation.w,
                              d->frame.orientation.x,
                              d->frame.orientation.y,
                              d->frame.orientation.z,
                              c->tear_stress,
                              c->position_tolerance,
                              c->move_limit,
                              c->baseline->drain_stiffness,
                              c->baseline->drain_damping};
    const uint32_t choices[] = {(uint32_t)c->method,        (uint32_t)c->mesh,  c->mesh_divisions,
                                c->attachment_capacity,     c->iteration_limit, c->halving_limit,
                                c->baseline->drain_substeps};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        vbss_stream_expect_f64(stream, 1, numbers[i]);
    }
    for (size_t i = 0; i < sizeof choices / sizeof choices[0]; i++) {
        vbss_stream_expect(stream, 2, choices[i]);
    }
    if (c->surface != NULL) {
        vbss_stream_expect(stream, 7, d->surface_hash);
    }
}

static bool is_untrusted(const vbss_stream *stream)
{
    return stream->mode == VBSS_STREAM_READ && !stream->trusted;
}

/* Whether the values are ones that a host can set. */
static bool is_in_range(const drain_attachment *a)
{
    return vbss_max_abs(&a->target.x, 3) <= 1e3 && vbss_max_abs(&a->force.x, 3) <= 1e6 &&
           a->stiffness >= 0.0 && a->stiffness <= 1e9;
}

static void visit_attachment(vbss_stream *stream, const drain_object *d, drain_attachment *a)
{
    int32_t kind = a->kind;
    vbss_stream_u32(stream, 20, &a->id, 1);
    vbss_stream_i32(stream, 21, &kind, 1);
    vbss_stream_u32(stream, 22, &a->node, 1);
    vbss_stream_f64(stream, 23, &a->position.x, 3);
    vbss_stream_f64(stream, 24, &a->target.x, 3);
    vbss_stream_f64(stream, 25, &a->force.x, 3);
    vbss_stream_f64(stream, 26, &a->stiffness, 1);
    vbss_stream_f64(stream, 27, &a->reaction.x, 3);
    a->kind = kind;
    if (is_untrusted(stream) &&
        (kind < VBSS_DRAIN_ATTACHMENT_PIN || kind > VBSS_DRAIN_ATTACHMENT_SPRING ||
         a->node >= d->mesh.node_count || a->id > d->last_id || !is_in_range(a))) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such attachment");
    }
}

static void visit_statistics(vbss_stream *stream, vbss_drain_statistics *s)
{
    vbss_stream_u32(stream, 40, &s->torn, 1);
    vbss_stream_u64(stream, 41, &s->steps, 1);
    vbss_stream_u64(stream, 42, &s->parts, 1);
    vbss_stream_u64(stream, 43, &s->linearisations, 1);
    vbss_stream_u64(stream, 44, &s->corrections_dropped, 1);
    vbss_stream_u64(stream, 45, &s->forced, 1);
    vbss_stream_f64(stream, 46, &s->last_move, 1);
    vbss_stream_f64(stream, 47, &s->last_correction, 1);
    vbss_stream_f64(stream, 48, &s->time, 1);
}

static bool is_at_rest(const drain_object *d, uint32_t node)
{
    vec3 rest = pose_apply(d->frame, d->mesh.rest[node]);
    return vec3_distance(d->x[node], rest) == 0.0 && vec3_norm(d->v[node]) == 0.0;
}

/* Whether the id is unique, and no node is pinned twice or attached while it is anchored. */
static bool is_valid(const drain_object *d, uint32_t attachment_index)
{
    const drain_attachment *a = &d->attachments[attachment_index];
    bool valid = a->kind != VBSS_DRAIN_ATTACHMENT_PIN || vbss_drain_find_pin(d, a->node) == a;
    for (uint32_t k = 0; k < attachment_index; k++) {
        valid = valid && d->attachments[k].id != a->id;
    }
    for (uint32_t k = 0; k < d->mesh.anchor_count; k++) {
        valid = valid && (d->mesh.anchors[k] != a->node || d->torn[k] != 0);
    }
    return valid;
}

static void check_consistency(vbss_stream *stream, const drain_object *d)
{
    uint32_t torn = 0;
    bool valid = true;
    for (uint32_t i = 0; i < d->mesh.anchor_count; i++) {
        valid = valid && d->torn[i] <= 1 && (d->torn[i] != 0 || is_at_rest(d, d->mesh.anchors[i]));
        torn += d->torn[i] != 0;
    }
    for (uint32_t i = 0; i < d->config.attachment_capacity; i++) {
        valid = valid && (d->attachments[i].id == 0 || is_valid(d, i));
    }
    if (!valid || torn != d->statistics.torn) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such anchors or attachments");
    }
}

/* The shape of the matrix. Snapshots of version 1 have none, so the next linearisation assembles a new matrix. */
static void visit_tangent(vbss_stream *stream, drain_object *d)
{
    drain_tangent *now = &d->tangents[d->tangent];
    if (stream->version >= 2) {
        vbss_stream_f64(stream, 8, &now->h, 1);
        vbss_stream_u64(stream, 49, &d->statistics.matrices, 1);
    } else {
        now->h = 0.0;
        d->statistics.matrices = d->statistics.linearisations;
    }
    if (now->h != 0.0) {
        vbss_stream_f64(stream, 9, &now->shape[0].x, 3 * (size_t)d->mesh.node_count);
    }
    if (stream->mode == VBSS_STREAM_READ) {
        d->attempt_tangent = d->saved_tangent = d->tangent;
        d->factored_in = NULL;
    }
}

void vbss_drain_serialise(vbss_stream *stream, void *object)
{
    drain_object *d = object;
    size_t n = d->mesh.node_count;
    visit_config(stream, d);
    vbss_stream_f64(stream, 3, &d->x[0].x, 3 * n);
    vbss_stream_f64(stream, 4, &d->v[0].x, 3 * n);
    vbss_stream_u8(stream, 5, d->torn, d->mesh.anchor_count);
    vbss_stream_u32(stream, 6, &d->last_id, 1);
    for (uint32_t i = 0; i < d->config.attachment_capacity; i++) {
        visit_attachment(stream, d, &d->attachments[i]);
    }
    visit_statistics(stream, &d->statistics);
    visit_tangent(stream, d);
    if (is_untrusted(stream)) {
        check_consistency(stream, d);
    }
    if (stream->mode == VBSS_STREAM_READ) {
        vbss_drain_update_anchored(d);
        memset(d->contact_forces, 0, n * sizeof *d->contact_forces);
        d->is_sparsity_valid = false;
        d->generation++;
    }
    if (stream->trusted) { /* a way back leaves no mark */
        vbss_stream_u64(stream, 50, &d->generation, 1);
        vbss_stream_u64(stream, 50, &d->edit_generation, 1);
    }
}
