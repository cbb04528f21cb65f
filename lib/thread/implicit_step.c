/* Implicit step of a thread on its own: predict -> [strains -> assemble -> solve] until converged
 * -> commit.
 *
 * The prediction is inertial, so one linearisation is enough while the motion is smooth. Where a
 * motion starts, as after creation or an edit, a very short substep of backward Euler finds the
 * accelerations first. A substep that does not converge is undone and repeated at half its size by
 * backward Euler. */
#include "base/error.h"
#include "thread/bending_memory.h"
#include "thread/tuning.h"
#include "thread/twist.h"

#include <string.h>

/* More compression than any thread carries. */
#define UNLIMITED_COMPRESSION (-1e30)

/* ---- one substep */

typedef enum newton_result { CONVERGED, NOT_CONVERGED, DIVERGED } newton_result;

static bool solve(thread_object *t, const thread_substep *substep)
{
    vbss_system_clear(t->system);
    if (thread_has_memory(t)) {
        vbss_thread_update_bending_memory(t, substep->integration->h);
    }
    if (thread_has_twist(t)) {
        vbss_thread_update_twist(t, substep);
    }
    VBSS_WIDE_CALL(t->system->wide, vbss_thread_assemble, t, substep, t->system, 0);
    if (!vbss_system_condense(t->system)) {
        return false;
    }
    vbss_system_load_schur_complement(t->system);
    return vbss_system_solve(t->system);
}

/* The next smaller amount of compression in the stiffness, after a negative pivot. With all
 * compression convergence is quadratic. Then follow the buckling load inside a straight thread,
 * that of a free end (each reduced by a tenth, as lengths and bends differ), and none. */
static double raise_min_tension(const thread_substep *substep)
{
    double inside = -THREAD_INNER_COMPRESSION * substep->buckling_load,
           at_end = -THREAD_END_COMPRESSION * substep->buckling_load;
    return substep->min_tension < inside ? inside : substep->min_tension < at_end ? at_end : 0.0;
}

static double largest_increment(const thread_object *t)
{
    double largest = 0.0;
    for (uint32_t i = 0; i < t->node_count; i++) {
        largest = vbss_max_or_nan(vec3_norm(t->system->solution[i]), largest);
    }
    return largest;
}

static newton_result run_newton(thread_object *t, thread_substep *substep)
{
    /* The direction of rest curvature may flip for ever where a thread is nearly straight. So its
     * forces are constant after some linearisations. */
    const bool curved = t->config.rest_curvature > 0.0;
    if (curved) {
        vbss_thread_update_rest_curvature_forces(t);
    }
    for (uint32_t k = 0; k < t->config.iteration_limit; k++) {
        t->statistics.iterations++;
        t->statistics.last_iterations++;
        while (!solve(t, substep)) {
            if (substep->min_tension == 0.0) {
                return DIVERGED;
            }
            substep->min_tension = raise_min_tension(substep);
            t->statistics.softened++;
        }
        double residual = vbss_thread_apply_increment(t, substep, t->system->solution);
        if (curved && k < THREAD_REST_CURVATURE_UPDATES) {
            /* These forces lag behind the shape, so convergence needs small increments, too. */
            residual = vbss_max_or_nan(largest_increment(t), residual);
            vbss_thread_update_rest_curvature_forces(t);
            /* The forces are constant from now on. */
            t->statistics.softened += k + 1 == THREAD_REST_CURVATURE_UPDATES;
        }
        vbss_thread_compute_strains(t, t->trial, t->strains);
        double error = vbss_thread_record_stretch(t, t->trial_tension);
        if (!(error < 1e100)) {
            return DIVERGED;
        }
        if (error <= t->config.stretch_tolerance && residual <= t->config.position_tolerance) {
            return CONVERGED;
        }
    }
    return NOT_CONVERGED;
}

/* ---- the step: substeps with attachments at evenly spaced targets */

typedef struct substep_attempt {
    vbss_integration integration;
    bool is_damped;     /* uses backward Euler */
    bool is_acceptable; /* not far from the start of the substep */
    newton_result result;
} substep_attempt;

static substep_attempt try_substep(thread_object *t, double h, double start, double end)
{
    substep_attempt a;
    double length = h * (end - start), previous_h = t->previous_h;
    /* Accelerations of a substep of very different length would gain energy. */
    bool has_new_length = previous_h > 0.0 && !(length < THREAD_MAX_LENGTH_RATIO * previous_h &&
                                                previous_h < THREAD_MAX_LENGTH_RATIO * length);
    thread_substep substep = {&a.integration, h, end, UNLIMITED_COMPRESSION, 0.0, 0.0};
    a.is_damped = t->is_acceleration_unknown || t->damped_steps_left > 0 || has_new_length;
    if (!a.is_damped) {
        a.integration = vbss_integration_generalised_alpha(length, t->config.spectral_radius);
        a.is_damped = !vbss_thread_predict(t, &substep);
        t->damped_steps_left = a.is_damped ? THREAD_DAMPED_STEPS + 1 : 0; /* it was 0 */
    }
    if (a.is_damped) {
        a.integration = vbss_integration_backward_euler(length);
        (void)vbss_thread_predict(t, &substep);
    }
    substep.buckling_load = vbss_thread_buckling_load(t, a.integration.inertia);
    a.result = run_newton(t, &substep);
    a.is_acceptable = a.result != DIVERGED &&
                      vbss_thread_strain_beyond_tension(t) <= substep.max_acceptable_strain;
    return a;
}

static double min_substep_fraction(const thread_object *t)
{
    double fraction = 1.0;
    for (uint32_t k = 0; k < t->config.halving_limit; k++) {
        fraction *= 0.5;
    }
    return fraction;
}

/* Runs substeps to the end of the step. Their sizes are powers of 1/2, so they sum to 1 exactly.
 * False: no finite state was found. */
static bool run_substeps(thread_object *t, double h)
{
    const double min_fraction = min_substep_fraction(t);
    double start = 0.0, fraction = t->is_acceleration_unknown ? THREAD_START_FRACTION : 1.0;
    while (start < 1.0) {
        double end = start + fraction < 1.0 ? start + fraction : 1.0;
        bool is_smallest =
            fraction <=
            (t->is_acceleration_unknown ? THREAD_START_FRACTION * min_fraction : min_fraction);
        substep_attempt a = try_substep(t, h, start, end);
        if (a.result != CONVERGED && !is_smallest) {
            t->statistics.rejections++;
            t->damped_steps_left = THREAD_DAMPED_STEPS + 1;
            fraction *= 0.5;
            continue;
        }
        if (a.result != CONVERGED) {
            t->statistics.forced++;
            if (!a.is_acceptable && !vbss_thread_freeze_trial(t)) {
                if (start > 0.0) {
                    vbss_thread_copy_state(t, &t->now, &t->saved);
                }
                return false;
            }
        }
        if (start == 0.0 && end < 1.0) {
            vbss_thread_copy_state(t, &t->saved, &t->now);
        }
        vbss_thread_commit(t, &a.integration);
        t->statistics.first_order += a.is_damped;
        fraction = t->is_acceleration_unknown ? 1.0 : fraction;
        /* A start tells nothing about the usual length. */
        t->previous_h = t->is_acceleration_unknown ? 0.0 : a.integration.h;
        t->is_acceleration_unknown = false;
        start = end;
    }
    return true;
}

vbss_result vbss_thread_implicit_step(thread_object *t, double h)
{
    const vbss_thread_statistics before = t->statistics;
    const bool is_acceleration_unknown = t->is_acceleration_unknown;
    const uint32_t damped_steps_left = t->damped_steps_left;
    const double previous_h = t->previous_h;
    t->statistics.last_iterations = 0;
    if (!run_substeps(t, h)) {
        t->statistics = before;
        t->is_acceleration_unknown = is_acceleration_unknown;
        t->damped_steps_left = damped_steps_left;
        t->previous_h = previous_h;
        return vbss_fail(t->context, VBSS_ERROR_NOT_FINITE,
                         "thread step: no finite state after step %llu",
                         (unsigned long long)before.steps);
    }
    t->damped_steps_left -= t->damped_steps_left > 0;
    if (t->statistics.last_iterations > THREAD_MAX_SMOOTH_ITERATIONS &&
        t->damped_steps_left < THREAD_DAMPED_STEPS) {
        t->damped_steps_left = THREAD_DAMPED_STEPS;
    }
    return VBSS_OK;
}
