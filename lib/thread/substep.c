/* Trial state of a substep, for a thread on its own or in a scene: prediction, increments,
 * commit. */
#include "thread/bending_memory.h"
#include "thread/tuning.h"
#include "thread/twist.h"

#include <string.h>

/* Whether the prediction reverses a segment. It would stay reversed as a fold that no force
 * has made. */
static bool flips_segment(const thread_object *t)
{
    const vec3 *x = t->now.x, *y = t->trial;
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        if (vec3_dot(vec3_sub(x[i + 1], x[i]), vec3_sub(y[i + 1], y[i])) < 0.0) {
            return true;
        }
    }
    return false;
}

void vbss_thread_reset_trial(thread_object *t)
{
    for (uint32_t i = 0; i < t->node_count; i++) {
        t->trial[i] = t->prescribed_by[i] != 0 ? t->trial[i] : t->now.x[i];
    }
}

double vbss_thread_strain_beyond_tension(const thread_object *t)
{
    double largest = 0.0, compliance = 1.0 / t->config.axial_stiffness;
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        double strain = t->strains[i].elongation * t->inverse_rest[i];
        double excess_strain = fabs(strain - t->now.tension[i] * compliance);
        largest = vbss_max_or_nan(excess_strain, largest);
    }
    return largest;
}

bool vbss_thread_max_tension_decreased(const thread_object *t)
{
    double now = 0.0, trial = 0.0;
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        now = vbss_max_or_nan(fabs(t->now.tension[i]), now);
        trial = vbss_max_or_nan(fabs(t->strains[i].elongation) * t->inverse_rest[i], trial);
    }
    return trial * t->config.axial_stiffness < now;
}

/* If a taut thread is released or an end jerks, past accelerations are useless and would add
 * energy. The old positions replace a prediction that would be a bad start. */
bool vbss_thread_predict(thread_object *t, thread_substep *substep)
{
    vbss_integration_predict(substep->integration, 3 * (size_t)t->node_count, &t->now.x->x,
                             &t->now.v->x, &t->now.a->x, &t->now.q->x, &t->x_predicted->x,
                             &t->v_predicted->x, &t->a_predicted->x);
    memcpy(t->trial, t->x_predicted, t->node_count * sizeof *t->trial);
    memcpy(t->trial_tension, t->now.tension, t->node_count * sizeof *t->trial_tension);
    for (uint32_t k = 0; k < t->config.attachment_capacity; k++) {
        const thread_attachment *a = &t->attachments[k];
        if (a->id != 0 && t->prescribed_by[a->node] == k + 1) {
            t->trial[a->node] = vbss_thread_attachment_position(a, substep->end_fraction);
        }
    }
    vbss_thread_set_clamp_directions(t, substep->end_fraction);
    if (thread_has_twist(t)) {
        vbss_thread_begin_twist(t);
    }
    vbss_thread_compute_strains(t, t->trial, t->strains);
    double strain = vbss_thread_strain_beyond_tension(t);
    bool is_rejected = !(strain <= THREAD_MAX_PREDICTION_STRAIN) || flips_segment(t);
    if (is_rejected) {
        vbss_thread_reset_trial(t);
        vbss_thread_compute_strains(t, t->trial, t->strains);
        strain = vbss_thread_strain_beyond_tension(t);
        t->statistics.softened++;
    }
    substep->max_acceptable_strain = strain + THREAD_MAX_PREDICTION_STRAIN;
    return !is_rejected &&
           strain <= (t->previous_h == 0.0 ? THREAD_STARTING_STRAIN : THREAD_SMOOTH_STRAIN);
}

double vbss_thread_apply_increment(thread_object *t, const thread_substep *substep, const vec3 *u)
{
    const vbss_integration *in = substep->integration;
    double largest = 0.0, mobility = 1.0 / (in->inertia * t->config.linear_density);
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        const thread_strain *s = &t->strains[i];
        const thread_arc *arc = &t->arcs[i];
        double inverse_rest = t->inverse_rest[i],
               stiffness = t->config.axial_stiffness * inverse_rest;
        vec3 e = vec3_sub(u[i + 1], u[i]);
        double along = vec3_dot(s->tangent, e), elongation_change = along;
        if (arc->length_coefficient > 0.0) {
            vec3 curvature_change = vec3_zero();
            for (uint32_t a = 0; a < 4; a++) {
                if (arc->coefficient[a] != 0.0) {
                    curvature_change =
                        vec3_add_scaled(curvature_change, arc->coefficient[a], u[i + a - 1]);
                }
            }
            elongation_change +=
                2.0 * arc->length_coefficient * vec3_dot(s->curvature, curvature_change);
        }
        double tension = stiffness * (s->elongation + elongation_change);
        double old = t->trial_tension[i];
        double bounded_tension = old > substep->min_tension ? old : substep->min_tension;
        vec3 across = vec3_add_scaled(e, -along, s->tangent);
        double rotation = vec3_norm(across) * inverse_rest;
        /* The geometric stiffness used the old tension, and is of first order. */
        double residual =
            rotation * (fabs(tension - bounded_tension) + 0.5 * fabs(tension) * rotation);
        residual *= mobility * inverse_rest;
        largest = vbss_max_or_nan(residual, largest);
        t->trial_tension[i] = tension;
    }
    for (uint32_t i = 0; i < t->node_count; i++) {
        t->trial[i] = vec3_add(t->trial[i], u[i]);
    }
    if (thread_has_memory(t)) {
        largest = vbss_max_or_nan(vbss_thread_bending_memory_residual(t, in), largest);
    }
    if (thread_has_twist(t)) {
        largest = vbss_max_or_nan(vbss_thread_twist_residual(t, in, u), largest);
    }
    return largest;
}

double vbss_thread_linearisation_error(const thread_object *t, const vec3 *u)
{
    double largest = 0.0;
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        vec3 e = vec3_sub(u[i + 1], u[i]), now = vec3_sub(t->trial[i + 1], t->trial[i]);
        double elongation_change = vec3_norm(vec3_add(now, e)) - vec3_norm(now);
        double error =
            fabs(elongation_change - vec3_dot(t->strains[i].tangent, e)) * t->inverse_rest[i];
        largest = vbss_max_or_nan(error, largest);
    }
    return largest;
}

bool vbss_thread_freeze_trial(thread_object *t)
{
    vbss_thread_reset_trial(t);
    vbss_thread_compute_strains(t, t->trial, t->strains);
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        t->trial_tension[i] =
            t->config.axial_stiffness * t->strains[i].elongation * t->inverse_rest[i];
    }
    for (uint32_t i = 0; i < t->node_count; i++) {
        t->x_predicted[i] = t->trial[i];
        t->v_predicted[i] = t->a_predicted[i] = vec3_zero();
    }
    double largest = vbss_thread_strain_beyond_tension(t);
    (void)vbss_thread_record_stretch(t, t->trial_tension);
    return largest < 1e100;
}

/* The velocity of a prescribed node is its displacement over the substep. With the recursion of the
 * integrator it would ring. */
static void set_prescribed_motion(thread_object *t, const vbss_integration *in)
{
    for (uint32_t i = 0; i < t->node_count; i++) {
        if (t->prescribed_by[i] != 0) {
            vec3 velocity = vec3_scale(vec3_sub(t->trial[i], t->now.x[i]), 1.0 / in->h);
            vec3 acceleration = vec3_scale(vec3_sub(velocity, t->now.v[i]), 1.0 / in->h);
            vec3 displacement = vec3_scale(acceleration, 1.0 / in->inertia);
            t->x_predicted[i] = vec3_sub(t->trial[i], displacement);
            t->v_predicted[i] = vec3_add_scaled(velocity, -in->velocity_factor, displacement);
            t->a_predicted[i] =
                vec3_add_scaled(acceleration, -in->acceleration_factor, displacement);
        }
    }
}

void vbss_thread_commit(thread_object *t, const vbss_integration *in)
{
    set_prescribed_motion(t, in);
    if (thread_has_memory(t)) {
        vbss_thread_commit_bending_memory(t, in->h);
    }
    if (thread_has_twist(t)) {
        vbss_thread_commit_twist(t);
    }
    memcpy(t->now.x, t->trial, t->node_count * sizeof *t->trial);
    memcpy(t->now.tension, t->trial_tension, t->node_count * sizeof *t->trial_tension);
    vbss_integration_correct(in, 3 * (size_t)t->node_count, &t->trial->x, &t->x_predicted->x,
                             &t->v_predicted->x, &t->a_predicted->x, &t->now.v->x, &t->now.a->x,
                             &t->now.q->x);
    if (t->config.damping > 0.0) {
        /* implicit, so any damping rate is stable */
        double damping_fraction = t->config.damping * in->h / (1.0 + t->config.damping * in->h);
        vbss_thread_damp_sections(t, damping_fraction);
    }
    vbss_thread_statistics *s = &t->statistics;
    s->substeps++;
    s->stretch_error =
        s->last_stretch_error > s->stretch_error ? s->last_stretch_error : s->stretch_error;
}

/* sqrt(EI k) at a free end, with k = inertia * linear density; twice that inside. Less if the
 * buckling wave would be shorter than two segments. */
double vbss_thread_buckling_load(const thread_object *t, double inertia)
{
    double foundation = inertia * t->config.linear_density, bending = t->config.bending_stiffness;
    /* Its squared wave number, 1/m^2. */
    double l = t->min_rest_length, shortest_wave = 4.0 / (l * l);
    double load = sqrt(bending * foundation);
    if (foundation > bending * shortest_wave * shortest_wave) {
        load = 0.5 * (bending * shortest_wave + foundation / shortest_wave);
    }
    return load;
}
