/* One step of the baseline thread in equal explicit substeps:
 *   forces -> velocities (symplectic Euler) -> damping -> positions -> projection, velocities.
 * A section whose projection does not converge keeps the positions from before the projection.
 * Its prescribed nodes are at their targets; it may be stretched, and its springs pull it back. */
#include "base/error.h"
#include "baseline/divergence.h"
#include "baseline/explicit_substeps.h"
#include "baseline/thread.h"
#include "thread/tuning.h"

static uint32_t count_parts(thread_object *t, double h)
{
    if (t->config.baseline->thread_substeps > 0) {
        return t->config.baseline->thread_substeps;
    }
    return vbss_baseline_substep_count(h, vbss_baseline_thread_rate(t));
}

static void prepare_masses(thread_object *t)
{
    for (uint32_t i = 0; i < t->node_count; i++) {
        baseline_thread_row *row = &t->baseline->rows[i];
        row->inverse_mass = t->prescribed_by[i] != 0 ? 0.0 : 1.0 / t->mass[i];
        row->inverse_rest = i + 1 < t->node_count ? 1.0 / t->rest[i] : 0.0;
        row->resistance = t->config.drag * t->mass[i];
    }
}

/* Drag and attached springs resist a velocity, so they count as mass. They are implicit and act
 * at the end of the substep, so that a thread at rest is in equilibrium. An explicit spring
 * would need dt below 2 sqrt(mass / stiffness). */
static void resist(thread_object *t, double dt)
{
    for (uint32_t place = 0; place < t->config.attachment_capacity; place++) {
        const thread_attachment *a = &t->attachments[place];
        if (a->id != 0 && a->kind == VBSS_THREAD_ATTACHMENT_SPRING) {
            t->baseline->rows[a->node].resistance += a->damping + dt * a->stiffness;
        }
    }
    for (uint32_t i = 0; i < t->node_count; i++) {
        baseline_thread_row *row = &t->baseline->rows[i];
        if (t->prescribed_by[i] == 0) {
            row->inverse_mass = 1.0 / (t->mass[i] + dt * row->resistance);
        }
    }
}

static void prepare_springs(thread_object *t, double dt)
{
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        double mobility = t->baseline->rows[i].inverse_mass + t->baseline->rows[i + 1].inverse_mass;
        double stiffness = t->config.baseline->thread_stiffness;
        if (stiffness == 0.0 && mobility > 0.0) {
            double max_stiffness = t->config.axial_stiffness / t->rest[i];
            stiffness = 2.0 * BASELINE_SPRING_FRACTION / (dt * dt * mobility);
            stiffness = stiffness < max_stiffness ? stiffness : max_stiffness;
        }
        t->baseline->rows[i].stiffness = stiffness;
    }
}

/* ---- one explicit substep */

static void gather_forces(thread_object *t, double h, double begin, double end, vec3 *forces)
{
    vbss_thread_compute_strains(t, t->now.x, t->strains);
    for (uint32_t i = 0; i < t->node_count; i++) {
        forces[i] = vec3_scale(t->gravity, t->mass[i]);
    }
    vbss_baseline_add_internal_forces(t, begin, forces);
    for (uint32_t place = 0; place < t->config.attachment_capacity; place++) {
        const thread_attachment *a = &t->attachments[place];
        vec3 *force = &forces[a->node];
        if (a->id != 0 && a->kind == VBSS_THREAD_ATTACHMENT_FORCE) {
            *force = vec3_add(*force, a->force);
        } else if (a->id != 0 && a->kind == VBSS_THREAD_ATTACHMENT_SPRING) {
            vec3 stretch = vec3_sub(vbss_thread_attachment_position(a, end), t->now.x[a->node]);
            vec3 displacement = vec3_sub(a->target, a->position);
            *force = vec3_add_scaled(*force, a->stiffness, stretch);
            *force = vec3_add_scaled(*force, a->damping / h, displacement);
        }
    }
}

static void move_nodes(thread_object *t, double dt, double end, const vec3 *forces)
{
    const thread_state *m = &t->now;
    for (uint32_t i = 0; i < t->node_count; i++) {
        if (t->prescribed_by[i] == 0) {
            vec3 impulse = vec3_add_scaled(vec3_scale(m->v[i], t->mass[i]), dt, forces[i]);
            m->v[i] = vec3_scale(impulse, t->baseline->rows[i].inverse_mass);
        }
    }
    if (t->config.baseline->thread_damping > 0.0) {
        vbss_thread_damp_sections(t, t->config.baseline->thread_damping);
    }
    for (uint32_t i = 0; i < t->node_count; i++) {
        vec3 to = vec3_add_scaled(m->x[i], dt, m->v[i]);
        if (t->prescribed_by[i] != 0) {
            to = vbss_thread_attachment_position(&t->attachments[t->prescribed_by[i] - 1], end);
            m->v[i] = vec3_scale(vec3_sub(to, m->x[i]), 1.0 / dt);
        }
        m->x[i] = to;
    }
}

static void project_sections(thread_object *t, double dt, vec3 *forces)
{
    for (uint32_t s = 0; s < t->section_count; s++) {
        uint32_t last = s + 1 < t->section_count ? t->sections[s + 1] : t->node_count - 1;
        if (!vbss_baseline_project_section(t, t->sections[s], last, dt, forces)) {
            t->baseline->counts.failed_projections++;
        }
    }
}

/* ---- the step */

/* Stores accelerations, constraint forces and tensions of the last substep. now.q holds the
 * velocities before it. */
static void note_forces(thread_object *t, double dt, const vec3 *forces)
{
    const thread_state *m = &t->now;
    for (uint32_t i = 0; i < t->node_count; i++) {
        m->q[i] = vec3_scale(vec3_sub(m->v[i], m->q[i]), 1.0 / dt);
        m->a[i] = vec3_zero();
        if (t->prescribed_by[i] != 0) {
            vec3 force = vec3_sub(vec3_scale(m->q[i], t->mass[i]), forces[i]);
            m->a[i] = vec3_add_scaled(force, t->baseline->rows[i].resistance, m->v[i]);
        }
    }
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        const baseline_thread_row *row = &t->baseline->rows[i];
        m->tension[i] = row->stiffness * t->strains[i].elongation + row->multiplier / (dt * dt);
    }
}

void vbss_baseline_record_stretch(thread_object *t)
{
    vbss_thread_statistics *s = &t->statistics;
    vbss_thread_compute_strains(t, t->now.x, t->strains);
    s->last_stretch = s->last_stretch_error = 0.0;
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        double stretch = t->strains[i].elongation / t->rest[i], error = fabs(stretch);
        s->last_stretch = stretch > s->last_stretch ? stretch : s->last_stretch;
        s->last_stretch_error = error > s->last_stretch_error ? error : s->last_stretch_error;
    }
    s->stretch_error =
        s->last_stretch_error > s->stretch_error ? s->last_stretch_error : s->stretch_error;
}

static vec3 still(vec3 v)
{
    bool moving = fabs(v.x) > VBSS_FLUSH_THRESHOLD || fabs(v.y) > VBSS_FLUSH_THRESHOLD ||
                  fabs(v.z) > VBSS_FLUSH_THRESHOLD;
    return moving ? v : vec3_zero();
}

static void note_counts(thread_object *t, uint32_t parts)
{
    const baseline_thread_counts *counts = &t->baseline->counts;
    vbss_baseline_statistics *s = &t->baseline->statistics;
    t->statistics.substeps += parts;
    s->projection_iterations += counts->iterations;
    s->last_projection_iterations = counts->iterations;
    s->failed_projections += counts->failed_projections;
}

vbss_result vbss_baseline_thread_step(thread_object *t, double h)
{
    vec3 *forces = t->a_predicted;
    vbss_thread_copy_state(t, &t->saved, &t->now);
    vbss_thread_compute_strains(t, t->now.x, t->strains);
    prepare_masses(t);
    uint32_t parts = count_parts(t, h);
    double dt = h / parts;
    resist(t, dt);
    prepare_springs(t, dt);
    t->baseline->counts = (baseline_thread_counts){0};
    for (uint32_t part = 0; part < parts; part++) {
        double begin = (double)part / parts, end = (part + 1.0) / parts;
        for (uint32_t i = 0; part + 1 == parts && i < t->node_count; i++) {
            t->now.q[i] = t->now.v[i];
        }
        gather_forces(t, h, begin, end, forces);
        move_nodes(t, dt, end, forces);
        project_sections(t, dt, forces);
    }
    note_forces(t, dt, forces);
    for (uint32_t i = 0; i < t->node_count; i++) {
        t->now.v[i] = still(t->now.v[i]);
    }
    vbss_result result = vbss_baseline_check_thread(t);
    if (result != VBSS_OK) {
        vbss_thread_copy_state(t, &t->now, &t->saved);
        return result;
    }
    note_counts(t, parts);
    vbss_baseline_record_stretch(t);
    return VBSS_OK;
}

/* The force is stored with the state, so a restored thread returns the same value. */
vec3 vbss_baseline_constraint_force(const thread_object *t, uint32_t node)
{
    return t->now.a[node];
}
