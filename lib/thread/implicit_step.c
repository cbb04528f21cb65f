/* Method OURS, one step: predict -> (measure -> assemble -> solve) until good -> commit.
 *
 * The prediction is inertial, so the first linearisation starts close and one is enough while the
 * motion is smooth. Where a motion starts (a new thread, a changed attachment), a very short step of
 * backward Euler finds the accelerations first. A try that does not converge is undone and made again
 * in halves, by backward Euler. */
#include "base/error.h"
#include "thread/thread.h"

#include <string.h>

/* The first part of a step in which a motion starts, as a share of it. */
#define FIRST_PART (1.0 / 64.0)
/* A step that needs more linearisations is no smooth motion; the next ones are made by backward Euler,
 * which damps what it cannot resolve. */
enum { SMOOTH_ITERATIONS = 4, SETTLING_STEPS = 2 };
/* Linearisations in which the pull of rest curvature follows the shape. */
enum { REST_PULL_UPDATES = 30 };
/* More compression than any thread carries. */
#define ALL_OF_THE_COMPRESSION (-1e30)

/* ---- one try */

typedef enum outcome { CONVERGED, UNCONVERGED, BROKEN } outcome;

static bool solve(thread_object *t, const thread_stage *stage)
{
    vbss_system_clear(t->system);
    VBSS_WIDE_CALL(t->system->wide, vbss_thread_assemble, t, stage, t->system, 0);
    if (!vbss_system_condense(t->system)) {
        return false;
    }
    vbss_system_load_schur_complement(t->system);
    return vbss_system_solve(t->system);
}

/* With all of the compression convergence is quadratic; where the stiffness is not positive then, with
 * what a straight thread carries inside, at a free end (a tenth less, as lengths and bends differ), and
 * with none. */
static double with_less_compression(const thread_stage *stage)
{
    double inside = -1.8 * stage->carried, at_end = -0.9 * stage->carried;
    return stage->least_pull < inside ? inside : stage->least_pull < at_end ? at_end : 0.0;
}

static double largest_increment(const thread_object *t)
{
    double largest = 0.0;
    for (uint32_t i = 0; i < t->node_count; i++) {
        largest = vbss_max_or_nan(vec3_norm(t->system->solution[i]), largest);
    }
    return largest;
}

static outcome iterate(thread_object *t, thread_stage *stage)
{
    /* Where a thread is nearly straight the direction of that pull may flip for ever, so it stays after some
     * linearisations. */
    const bool curved = t->config.rest_curvature > 0.0;
    if (curved) {
        vbss_thread_update_rest_pull(t);
    }
    for (uint32_t k = 0; k < t->config.iteration_limit; k++) {
        t->statistics.iterations++;
        t->statistics.last_iterations++;
        while (!solve(t, stage)) {
            if (stage->least_pull == 0.0) {
                return BROKEN;
            }
            stage->least_pull = with_less_compression(stage);
            t->statistics.softened++;
        }
        double left = vbss_thread_advance(t, stage, t->system->solution);
        if (curved && k < REST_PULL_UPDATES) {
            /* The pull follows the shape late: nothing is known until the shape stands. */
            left = vbss_max_or_nan(largest_increment(t), left);
            vbss_thread_update_rest_pull(t);
            t->statistics.softened += k + 1 == REST_PULL_UPDATES; /* from now on it stays */
        }
        vbss_thread_measure(t, t->trial, t->strains);
        double error = vbss_thread_note_stretch(t, t->trial_tension);
        if (!(error < 1e100)) {
            return BROKEN;
        }
        if (error <= t->config.stretch_tolerance && left <= t->config.position_tolerance) {
            return CONVERGED;
        }
    }
    return UNCONVERGED;
}

/* ---- the step: parts, which attachments cross evenly */

typedef struct attempt {
    vbss_integration integration;
    bool damped; /* by backward Euler */
    bool sound;  /* not far from where the try started */
    outcome found;
} attempt;

static attempt try_part(thread_object *t, double h, double begin, double end)
{
    attempt a;
    double length = h * (end - begin), last = t->last_part;
    /* Accelerations carried over from a step of quite another length would gain energy. */
    bool another = last > 0.0 && !(length < 2.1 * last && last < 2.1 * length);
    thread_stage stage = {&a.integration, h, end, ALL_OF_THE_COMPRESSION, 0.0, 0.0};
    a.damped = t->fresh || t->settling > 0 || another;
    if (!a.damped) {
        a.integration = vbss_integration_generalised_alpha(length, t->config.spectral_radius);
        a.damped = !vbss_thread_predict(t, &stage);
        t->settling = a.damped ? SETTLING_STEPS + 1 : 0; /* it was 0 */
    }
    if (a.damped) {
        a.integration = vbss_integration_backward_euler(length);
        (void)vbss_thread_predict(t, &stage);
    }
    stage.carried = vbss_thread_carried_load(t, a.integration.inertia);
    a.found = iterate(t, &stage);
    a.sound = a.found != BROKEN && vbss_thread_strain_beyond_tension(t) <= stage.sound_strain;
    return a;
}

static double smallest_part(const thread_object *t)
{
    double part = 1.0;
    for (uint32_t k = 0; k < t->config.halving_limit; k++) {
        part *= 0.5;
    }
    return part;
}

/* The parts are dyadic, so they sum to 1 exactly. False: no finite state was found. */
static bool make_parts(thread_object *t, double h)
{
    const double smallest = smallest_part(t);
    double begin = 0.0, part = t->fresh ? FIRST_PART : 1.0;
    while (begin < 1.0) {
        double end = begin + part < 1.0 ? begin + part : 1.0;
        bool last_chance = part <= (t->fresh ? FIRST_PART * smallest : smallest);
        attempt a = try_part(t, h, begin, end);
        if (a.found != CONVERGED && !last_chance) {
            t->statistics.rejections++;
            t->settling = SETTLING_STEPS + 1;
            part *= 0.5;
            continue;
        }
        if (a.found != CONVERGED) {
            t->statistics.forced++;
            if (!a.sound && !vbss_thread_stop(t)) {
                if (begin > 0.0) {
                    vbss_thread_copy_motion(t, &t->now, &t->kept);
                }
                return false;
            }
        }
        if (begin == 0.0 && end < 1.0) {
            vbss_thread_copy_motion(t, &t->kept, &t->now);
        }
        vbss_thread_commit(t, &a.integration);
        t->statistics.first_order += a.damped;
        part = t->fresh ? 1.0 : part;
        t->last_part = t->fresh ? 0.0 : a.integration.h; /* a start says nothing of lengths */
        t->fresh = false;
        begin = end;
    }
    return true;
}

vbss_result vbss_thread_implicit_step(thread_object *t, double h)
{
    const vbss_thread_statistics before = t->statistics;
    const bool fresh = t->fresh;
    const uint32_t settling = t->settling;
    const double last_part = t->last_part;
    t->statistics.last_iterations = 0;
    if (!make_parts(t, h)) {
        t->statistics = before;
        t->fresh = fresh;
        t->settling = settling;
        t->last_part = last_part;
        return vbss_fail(t->context, VBSS_ERROR_NOT_FINITE,
                         "thread step: no finite state after step %llu",
                         (unsigned long long)before.steps);
    }
    t->settling -= t->settling > 0;
    if (t->statistics.last_iterations > SMOOTH_ITERATIONS && t->settling < SETTLING_STEPS) {
        t->settling = SETTLING_STEPS;
    }
    return VBSS_OK;
}
