/* Snapshot of a thread: one visitor that saves, hashes and restores its state. */
#include "base/stream.h"
#include "thread/bending_memory.h"
#include "thread/remesh.h"
#include "thread/tuning.h"
#include "thread/twist.h"

#include <string.h>

/* The configuration that has to be equal on restore. Capacities may differ. */
static void visit_config(vbss_stream *stream, const thread_object *t)
{
    const vbss_thread_config *c = &t->config;
    const double numbers[] = {
        c->radius,
        c->linear_density,
        c->axial_stiffness,
        c->bending_stiffness,
        c->rest_curvature,
        c->gravity[0],
        c->gravity[1],
        c->gravity[2],
        c->drag,
        c->damping,
        c->spectral_radius,
        c->stretch_tolerance,
        c->position_tolerance,
        c->baseline->thread_stiffness,
        c->baseline->thread_damping,
        c->baseline->thread_tolerance,
    };
    const uint32_t choices[] = {
        (uint32_t)c->method,          (uint32_t)c->bending,
        c->iteration_limit,           c->halving_limit,
        c->baseline->thread_substeps, c->baseline->thread_iteration_limit,
        c->attachment_capacity,       c->segment_count,
    };
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        vbss_stream_expect_f64(stream, 1, numbers[i]);
    }
    for (size_t i = 0; i < sizeof choices / sizeof choices[0]; i++) {
        vbss_stream_expect(stream, 2, choices[i]);
    }
}

/* Adaptive mesh only: its configuration and the state of remeshing. */
static void visit_mesh(vbss_stream *stream, thread_object *t)
{
    const vbss_thread_config *c = &t->config;
    const double numbers[] = {c->finest_length, c->coarsest_length, c->refine_angle,
                              c->coarsen_angle, c->near_distance,   c->clear_distance};
    vbss_thread_statistics *s = &t->statistics;
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        vbss_stream_expect_f64(stream, 60, numbers[i]);
    }
    vbss_stream_expect(stream, 61, c->mesh_operations);
    vbss_stream_u32(stream, 62, &t->next_segment_to_check, 1);
    vbss_stream_u64(stream, 63, &s->refined, 6); /* refined .. refused_near */
    vbss_stream_u32(stream, 64, &s->most_nodes, 1);
}

static bool is_unit(vec3 v)
{
    return fabs(vec3_norm_squared(v) - 1.0) < 1e-6;
}

/* Bending with memory only: its configuration and state. */
static void visit_memory(vbss_stream *stream, thread_object *t)
{
    const vbss_thread_config *c = &t->config;
    const double numbers[] = {c->yield_curvature, c->yield_hardening, c->relaxation_ratio,
                              c->relaxation_time};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        vbss_stream_expect_f64(stream, 80, numbers[i]);
    }
    const size_t sides = 2 * (size_t)t->node_count;
    vbss_stream_f64(stream, 81, &t->now.bend[0].plane.x,
                    sides * (sizeof *t->now.bend / sizeof(double)));
    vbss_stream_f64(stream, 82, &t->now.dissipated_energy, 1);
    bool is_valid = t->now.dissipated_energy >= 0.0;
    for (size_t i = 0; i < sides; i++) {
        const vec3 plane = t->now.bend[i].plane;
        is_valid = is_valid && (vec3_norm_squared(plane) == 0.0 || is_unit(plane));
    }
    if (!is_valid && stream->mode == VBSS_STREAM_READ && !stream->trusted) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such memory of bends");
    }
}

/* Twist only: its configuration and state. */
static void visit_twist(vbss_stream *stream, thread_object *t)
{
    const uint32_t capacity = t->config.attachment_capacity;
    vbss_stream_expect_f64(stream, 90, t->config.torsional_stiffness);
    vbss_stream_expect_f64(stream, 90, t->config.rest_twist);
    bool is_valid = true;
    for (uint32_t i = 0; i < capacity; i++) {
        thread_attachment *a = &t->attachments[i];
        thread_section_frame *frame = &t->now.frames[i];
        vbss_stream_f64(stream, 91, &a->roll, 1);
        vbss_stream_f64(stream, 92, &a->target_roll, 1);
        vbss_stream_f64(stream, 93, &frame->direction.x, sizeof *frame / sizeof(double));
        vbss_stream_u32(stream, 94, &a->owner, 1);
        vbss_stream_f64(stream, 95, &a->owner_orientation.w, 4);
        is_valid = is_valid && (a->id == 0 || !thread_holds_section(a) ||
                                (is_unit(frame->direction) && is_unit(frame->director)));
    }
    if (!is_valid && stream->mode == VBSS_STREAM_READ && !stream->trusted) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such frame of a section");
    }
}

/* Friction torque only: its state. */
static void visit_contact_rolls(vbss_stream *stream, thread_object *t)
{
    const size_t segments = t->node_count > 0 ? t->node_count - 1 : 0;
    vbss_stream_expect(stream, 96, t->config.friction_torque);
    vbss_stream_f64(stream, 97, t->now.half_twists, 2 * segments);
    vbss_stream_f64(stream, 98, t->now.held_rolls, t->config.attachment_capacity);
}

/* Refuses a snapshot in which two attachments prescribe one node. */
static void check_prescribed_nodes(vbss_stream *stream, const thread_object *t)
{
    for (uint32_t i = 0; i < t->config.attachment_capacity; i++) {
        const thread_attachment *a = &t->attachments[i];
        for (uint32_t k = 0; k < i && a->id != 0 && vbss_thread_prescribes_motion(a->kind); k++) {
            const thread_attachment *b = &t->attachments[k];
            if (b->id != 0 && vbss_thread_prescribes_motion(b->kind) && b->node == a->node) {
                vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "a node is held twice");
            }
        }
    }
}

static void visit_attachment(vbss_stream *stream, const thread_object *t, thread_attachment *a)
{
    int32_t kind = a->kind;
    vbss_stream_u32(stream, 20, &a->id, 1);
    vbss_stream_i32(stream, 21, &kind, 1);
    vbss_stream_u32(stream, 22, &a->node, 1);
    vbss_stream_f64(stream, 23, &a->position.x, 3);
    vbss_stream_f64(stream, 24, &a->target.x, 3);
    vbss_stream_f64(stream, 25, &a->direction.x, 3);
    vbss_stream_f64(stream, 26, &a->target_direction.x, 3);
    vbss_stream_f64(stream, 27, &a->force.x, 3);
    vbss_stream_f64(stream, 28, &a->stiffness, 1);
    vbss_stream_f64(stream, 29, &a->damping, 1);
    vbss_stream_f64(stream, 30, &a->mass, 1);
    vbss_stream_f64(stream, 31, &a->velocity.x, 3);
    vbss_stream_f64(stream, 32, &a->reaction.x, 3);
    vbss_stream_f64(stream, 33, &a->reaction_torque.x, 3);
    a->kind = kind;
    if (a->id == 0 || stream->trusted || stream->mode != VBSS_STREAM_READ) {
        return;
    }
    bool clamp = kind == VBSS_THREAD_ATTACHMENT_CLAMP;
    if (clamp && !(is_unit(a->direction) && is_unit(a->target_direction))) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such direction");
    }
    if (kind < VBSS_THREAD_ATTACHMENT_PIN || kind > VBSS_THREAD_ATTACHMENT_ROLL ||
        a->node >= t->node_count || a->id > t->last_id || !(a->stiffness >= 0.0) ||
        !(a->damping >= 0.0) || !(a->mass >= 0.0)) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such attachment");
    }
}

/* Counters of method VBLAST have the places in the stream that its snapshots have always used; the
 * other method has a zero there, or counters of its own. */
static void visit_statistics(vbss_stream *stream, thread_object *t)
{
    vbss_thread_statistics *s = &t->statistics;
    vbss_baseline_statistics *own = t->method->baseline_statistics(t);
    vbss_stream_u32(stream, 40,
                    own != NULL ? &own->last_projection_iterations : &s->last_iterations, 1);
    vbss_stream_u64(stream, 41, &s->steps, 1);
    vbss_stream_u64(stream, 42, own != NULL ? &own->projection_iterations : &s->iterations, 1);
    vbss_stream_u64(stream, 43, &s->substeps, 1);
    vbss_stream_u64(stream, 44, &s->first_order, 1);
    vbss_stream_u64(stream, 45, &s->rejections, 1);
    vbss_stream_u64(stream, 46, &s->forced, 1);
    if (own != NULL) {
        vbss_stream_u64(stream, 47, &own->failed_projections, 1);
    } else {
        vbss_stream_expect(stream, 47, 0);
    }
    vbss_stream_u64(stream, 52, &s->softened, 1);
    vbss_stream_f64(stream, 48, &s->last_stretch_error, 1);
    vbss_stream_f64(stream, 49, &s->stretch_error, 1);
    vbss_stream_f64(stream, 50, &s->last_stretch, 1);
    vbss_stream_f64(stream, 51, &s->time, 1);
}

static void check_rest(vbss_stream *stream, const thread_object *t)
{
    bool is_valid = t->node_count >= 2;
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        is_valid = is_valid && t->rest[i] >= THREAD_MIN_REST_LENGTH && t->rest[i] <= 1e3;
    }
    if (!is_valid && stream->mode == VBSS_STREAM_READ && !stream->trusted) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such rest lengths");
    }
}

void vbss_thread_serialise(vbss_stream *stream, void *object)
{
    thread_object *t = object;
    uint8_t is_acceleration_unknown = t->is_acceleration_unknown, is_in_setup = t->is_in_setup;
    visit_config(stream, t);
    vbss_stream_count(stream, 3, &t->node_count, t->node_capacity);
    size_t n = t->node_count, segments = n > 0 ? n - 1 : 0;
    vbss_stream_f64(stream, 4, t->rest, segments);
    check_rest(stream, t);
    vbss_stream_f64(stream, 5, &t->now.x[0].x, 3 * n);
    vbss_stream_f64(stream, 6, &t->now.v[0].x, 3 * n);
    vbss_stream_f64(stream, 7, &t->now.a[0].x, 3 * n);
    vbss_stream_f64(stream, 8, &t->now.q[0].x, 3 * n);
    vbss_stream_f64(stream, 9, t->now.tension, segments);
    vbss_stream_u8(stream, 10, &is_acceleration_unknown, 1);
    vbss_stream_u32(stream, 11, &t->damped_steps_left, 1);
    vbss_stream_u32(stream, 12, &t->last_id, 1);
    vbss_stream_f64(stream, 13, &t->previous_h, 1);
    if (!(t->previous_h >= 0.0) || t->damped_steps_left > 16) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such length of a step");
    }
    vbss_stream_u8(stream, 14, &is_in_setup, 1);
    if (is_acceleration_unknown > 1 || is_in_setup > 1) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such flag");
    }
    for (uint32_t i = 0; i < t->config.attachment_capacity; i++) {
        visit_attachment(stream, t, &t->attachments[i]);
    }
    if (stream->mode == VBSS_STREAM_READ && !stream->trusted) {
        check_prescribed_nodes(stream, t);
    }
    visit_statistics(stream, t);
    if (thread_is_adaptive(t)) {
        visit_mesh(stream, t);
    }
    if (thread_has_memory(t)) {
        visit_memory(stream, t);
    }
    if (thread_has_twist(t)) {
        visit_twist(stream, t);
    }
    if (thread_has_friction_torque(t)) {
        visit_contact_rolls(stream, t);
    }
    if (stream->mode == VBSS_STREAM_READ) {
        t->is_acceleration_unknown = is_acceleration_unknown != 0;
        t->is_in_setup = is_in_setup != 0;
        t->is_derived_valid = false;
        t->generation++;
    }
    if (stream->trusted) { /* a way back leaves no mark */
        vbss_stream_u64(stream, 70, &t->generation, 1);
        vbss_stream_u64(stream, 70, &t->edit_generation, 1);
    }
}

void vbss_thread_copy_state(const thread_object *t, thread_state *to, const thread_state *from)
{
    size_t bytes = t->node_count * sizeof(vec3);
    memcpy(to->x, from->x, bytes);
    memcpy(to->v, from->v, bytes);
    memcpy(to->a, from->a, bytes);
    memcpy(to->q, from->q, bytes);
    memcpy(to->tension, from->tension, t->node_count * sizeof(double));
    to->dissipated_energy = from->dissipated_energy;
    if (thread_has_memory(t)) {
        memcpy(to->bend, from->bend, 2 * (size_t)t->node_count * sizeof *to->bend);
    }
    if (thread_has_twist(t)) {
        memcpy(to->frames, from->frames, t->config.attachment_capacity * sizeof *to->frames);
    }
    if (thread_has_friction_torque(t)) {
        memcpy(to->half_twists, from->half_twists,
               2 * (size_t)(t->node_count - 1) * sizeof *to->half_twists);
        memcpy(to->held_rolls, from->held_rolls,
               t->config.attachment_capacity * sizeof *to->held_rolls);
    }
}
