/* Truncation, the last resort: if no attempt is accepted, the safe fraction of the trial state
 * becomes the state.
 *
 * All bodies move by the same fraction of their displacement, tools as well. So nothing is torn,
 * and the path is the first part of one that CCD has tested. Bodies lose most of their velocity.
 * Statistics count truncations and the time that was lost. */
#include "base/rotation.h"
#include "scene/ccd/ccd.h"
#include "scene/contacts/contacts.h"
#include "scene/solve/solve.h"
#include "scene/tissue/tissue.h"
#include "scene/tuning.h"
#include "scene/world/world.h"

/* Fraction of the trial displacement that is safe; 0 if the trial state is unusable. Threads whose
 * tension decreases are not asked for their stretch: one that an earlier truncation has stretched
 * could never recover. */
static double find_safe_fraction(scene_object *s, scene_substep_outcome outcome)
{
    double stretch = 0.0;
    for (uint32_t i = 0; i < s->body_count; i++) {
        const thread_object *t = s->bodies[i].thread.thread;
        if (scene_active_kind(&s->bodies[i]) == SCENE_BODY_THREAD &&
            !vbss_thread_max_tension_decreased(t)) {
            stretch = vbss_max_or_nan(vbss_thread_strain_beyond_tension(t), stretch);
        }
    }
    if (outcome == SCENE_SUBSTEP_SINGULAR || outcome == SCENE_SUBSTEP_OUT_OF_CAPACITY ||
        !(stretch <= SCENE_MAX_TRIAL_STRETCH)) {
        return 0.0;
    }
    scene_substep_outcome ccd_outcome = vbss_scene_run_ccd(s);
    if (ccd_outcome != SCENE_SUBSTEP_ACCEPTED && ccd_outcome != SCENE_SUBSTEP_CCD_HIT) {
        return 0.0; /* not all of the motion was tested */
    }
    return s->step.time_of_impact < 1.0 ? SCENE_SAFE_FRACTION * s->step.time_of_impact : 1.0;
}

/* ---- truncation of the trial state */

static void truncate_thread(thread_object *t, double fraction)
{
    for (uint32_t i = 0; i < t->node_count; i++) {
        /* With fraction 0 the trial state may not even be finite. */
        vec3 displacement = fraction > 0.0 ? vec3_sub(t->trial[i], t->now.x[i]) : vec3_zero();
        t->trial[i] = vec3_add_scaled(t->now.x[i], fraction, displacement);
    }
}

static void truncate_rigid(scene_object *s, scene_rigid *r, double fraction)
{
    const pose start = r->body.now.pose, full = r->trial;
    r->trial = start;
    if (fraction > 0.0) {
        vec3 displacement = vec3_sub(full.position, start.position);
        vec3 rotation = vbss_quat_to_rotation_vector(
            quat_mul(full.orientation, quat_conjugate(start.orientation)));
        r->trial.position = vec3_add_scaled(start.position, fraction, displacement);
        r->trial.orientation = quat_unit(quat_mul(
            vbss_quat_from_rotation_vector(vec3_scale(rotation, fraction)), start.orientation));
    }
    if (r->surface != NULL) {
        vbss_scene_truncate_host_surface(r->surface, fraction);
    }
    for (uint32_t c = 0; c < r->capsule_count; c++) {
        scene_capsule *capsule = &s->capsules[r->first_capsule + c];
        for (int k = 0; k < 2; k++) {
            vec3 displacement = vec3_sub(capsule->local_trial[k], capsule->local[k]);
            capsule->local_trial[k] = vec3_add_scaled(capsule->local[k], fraction, displacement);
        }
        vbss_scene_transform_trial_capsule(capsule, r->trial);
    }
}

/* ---- commit of the truncated state */

static void commit_truncated_thread(thread_object *t, double h)
{
    for (uint32_t i = 0; i < t->node_count; i++) {
        vec3 displacement = vec3_sub(t->trial[i], t->now.x[i]);
        t->now.x[i] = t->trial[i];
        t->now.v[i] = vec3_scale(displacement, SCENE_VELOCITY_FRACTION / h);
        t->now.a[i] = t->now.q[i] = vec3_zero();
    }
    vbss_thread_compute_strains(t, t->now.x, t->strains);
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        t->now.tension[i] =
            t->config.axial_stiffness * t->strains[i].elongation * t->inverse_rest[i];
    }
    (void)vbss_thread_record_stretch(t, t->now.tension);
    t->is_acceleration_unknown = true;
    t->statistics.substeps++;
    t->statistics.forced++;
}

static void commit_truncated_rigid(scene_rigid *r, double h)
{
    vbss_rigid_motion *now = &r->body.now;
    vec3 displacement = vec3_sub(r->trial.position, now->pose.position);
    vec3 rotation = vbss_quat_to_rotation_vector(
        quat_mul(r->trial.orientation, quat_conjugate(now->pose.orientation)));
    now->pose = r->trial;
    now->v = vec3_scale(displacement, SCENE_VELOCITY_FRACTION / h);
    now->w = vec3_scale(rotation, SCENE_VELOCITY_FRACTION / h);
}

static void commit_truncated_drain(drain_object *d, double h)
{
    vbss_drain_commit(d, h);
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        d->v[i] = vec3_scale(d->v[i], SCENE_VELOCITY_FRACTION);
    }
}

static void truncate_drain(scene_drain *b, double fraction)
{
    drain_object *d = b->drain;
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        /* With fraction 0 the trial state may not even be finite. */
        vec3 displacement = fraction > 0.0 ? vec3_sub(d->trial[i], d->x[i]) : vec3_zero();
        d->trial[i] = vec3_add_scaled(d->x[i], fraction, displacement);
    }
}

static void truncate_bodies(scene_object *s, double fraction)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (scene_active_kind(&s->bodies[i]) == SCENE_BODY_THREAD) {
            truncate_thread(s->bodies[i].thread.thread, fraction);
        } else if (scene_active_kind(&s->bodies[i]) == SCENE_BODY_RIGID) {
            truncate_rigid(s, &s->bodies[i].rigid, fraction);
        } else if (scene_active_kind(&s->bodies[i]) == SCENE_BODY_DRAIN) {
            truncate_drain(&s->bodies[i].drain, fraction);
        }
    }
}

/* Largest strain with the nodes at `x`: extension for sign 1, compression for -1. */
static double max_strain(thread_object *t, const vec3 *x, double sign)
{
    double largest = 0.0;
    vbss_thread_compute_strains(t, x, t->strains);
    for (uint32_t i = 0; i + 1 < t->node_count; i++) {
        largest = vbss_max(sign * t->strains[i].elongation * t->inverse_rest[i], largest);
    }
    return largest;
}

static bool increases_strain(thread_object *t, double sign, double tolerance)
{
    return max_strain(t, t->trial, sign) > max_strain(t, t->now.x, sign) + tolerance;
}

/* Whether truncation strains a thread. Nodes move along straight lines, so a segment that turns by 90 degrees is
 * 29 % shorter halfway. Its compression would be a force of hundreds of newtons, and more energy than all else has.
 * The lengths of a trial state that did not converge would likewise be tensions that no hand pulls with. */
static bool strains_threads(scene_object *s)
{
    const double tolerance = s->solver.stretch_tolerance;
    for (uint32_t i = 0; i < s->body_count; i++) {
        thread_object *t = s->bodies[i].thread.thread;
        if (scene_active_kind(&s->bodies[i]) == SCENE_BODY_THREAD &&
            (increases_strain(t, -1.0, tolerance) || increases_strain(t, 1.0, tolerance))) {
            return true;
        }
    }
    return false;
}

/* CCD has tested straight paths, but a shorter rotation does not stay on them: so it tests the
 * truncated state, too. */
static double truncate_until_safe(scene_object *s, double fraction)
{
    truncate_bodies(s, fraction);
    for (uint32_t k = 0; k < SCENE_MAX_TRUNCATIONS && fraction > 0.0; k++) {
        if (!strains_threads(s) && vbss_scene_run_ccd(s) == SCENE_SUBSTEP_ACCEPTED) {
            return fraction;
        }
        truncate_bodies(s, 0.5);
        fraction *= 0.5;
    }
    truncate_bodies(s, 0.0);
    return 0.0;
}

/* Sets contact forces from the state as it is, not from the rejected attempt. */
static void rebuild_contacts(scene_object *s)
{
    vbss_scene_refresh_normals(s);
    s->contacts->is_stopped_early = false; /* the forces below are not those of a search */
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        contact_constraint *constraint = &s->contacts->constraints[i];
        if (constraint->is_bilateral) {
            contact_solution solution;
            (void)vbss_contact_update_solution(constraint, vec3_zero(), &solution);
            constraint->solution = solution;
            continue;
        }
        double normal_force = vbss_max(-constraint->stiffness * constraint->gap, 0.0),
               friction_limit = constraint->friction * normal_force;
        vec3 friction_force =
            vbss_contact_rotate_to_tangent_plane(constraint->previous_force, constraint->normal);
        double magnitude = vec3_norm(friction_force);
        constraint->solution = (contact_solution){
            .status = normal_force > 0.0 ? CONTACT_STICK : CONTACT_OPEN,
            .normal_force = normal_force,
            .tangential_force = magnitude > friction_limit
                                    ? vec3_scale(friction_force, friction_limit / magnitude)
                                    : friction_force};
    }
}

void vbss_scene_reject_substep(scene_object *s)
{
    truncate_bodies(s, 0.0);
    rebuild_contacts(s);
}

double vbss_scene_truncate_substep(scene_object *s, scene_substep_outcome outcome,
                                   const scene_substep *substep)
{
    const vbss_rigid_substep p = {substep->step_length, substep->start_fraction,
                                  substep->end_fraction};
    double fraction = truncate_until_safe(s, find_safe_fraction(s, outcome));
    vbss_scene_notify_substep(s);
    rebuild_contacts(s);
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (scene_active_kind(&s->bodies[i]) == SCENE_BODY_THREAD) {
            commit_truncated_thread(s->bodies[i].thread.thread, substep->h);
        } else if (scene_active_kind(&s->bodies[i]) == SCENE_BODY_RIGID) {
            scene_rigid *r = &s->bodies[i].rigid;
            commit_truncated_rigid(r, substep->h);
            r->coupling_wrench = vbss_rigid_coupling_wrench(&r->body, &p, &r->body.now);
        } else if (scene_active_kind(&s->bodies[i]) == SCENE_BODY_DRAIN) {
            commit_truncated_drain(s->bodies[i].drain.drain, substep->h);
        }
    }
    vbss_scene_commit_capsules(s);
    vbss_scene_commit_host_surfaces(s, false);
    vbss_scene_advance_holes(s);
    s->report.statistics.parts++;
    s->report.statistics.clamped++;
    return fraction;
}
