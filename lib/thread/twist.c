/* Energy, forces and stiffness of twist.
 *
 * The energy of a span of length L is GJ/2 L (twist / L - rest_twist)^2, and its derivative with the
 * twist is the torque. The gradient of the twist with a chord's vector e is half the curvature binormal at
 * either end over |e| (Bergou et al. 2008). The stiffness has two parts: torque times the exact second
 * derivative of the twist, which couples neighbours and is not definite; and GJ/L gradient gradient^T,
 * which couples all nodes of the span. A diagonal matrix that is never smaller replaces the second, so
 * that the band of the matrix stays and the torque converges. */
#include "thread/tuning.h"
#include "thread/twist.h"

#include <string.h>

/* ---- one turn */

/* Adds the gradient of the twist with the three nodes around a turn, times a factor. */
static void add_gradient(vec3 *gradient, uint32_t node, const thread_turn *turn, double factor)
{
    const vec3 before = vec3_scale(turn->half_binormal, factor * turn->inverse_before),
               after = vec3_scale(turn->half_binormal, factor * turn->inverse_after);
    if (turn->inverse_before > 0.0) {
        gradient[node - 1] = vec3_sub(gradient[node - 1], before);
    }
    gradient[node] = vec3_add(gradient[node], vec3_sub(before, after));
    if (turn->inverse_after > 0.0) {
        gradient[node + 1] = vec3_add(gradient[node + 1], after);
    }
}

/* a b^T + b a^T */
static mat3 symmetric_product(vec3 a, vec3 b)
{
    return mat3_add(mat3_outer(a, b), mat3_outer(b, a));
}

/* Second derivatives of the twist with the vectors of both chords, times the torque. The antisymmetric
 * part of the derivative with one chord cancels between its two ends. */
static thread_twist_stiffness stiffness_of(const thread_turn *turn, double torque)
{
    const double before = turn->inverse_before, after = turn->inverse_after;
    const mat3 mixed = mat3_add_scaled(mat3_scale(mat3_cross(turn->before), turn->inverse_fold),
                                       -1.0, mat3_outer(turn->half_binormal, turn->mean));
    return (thread_twist_stiffness){
        .before =
            mat3_scale(symmetric_product(turn->half_binormal, vec3_add(turn->before, turn->mean)),
                       -0.5 * torque * before * before),
        .mixed = mat3_scale(mixed, torque * before * after),
        .after =
            mat3_scale(symmetric_product(turn->half_binormal, vec3_add(turn->after, turn->mean)),
                       -0.5 * torque * after * after),
        .has_before = before > 0.0,
        .has_after = after > 0.0,
    };
}

/* ---- a linearisation */

/* A node is in at most two spans between holders; with friction torque in three, as each of the turns about
 * it may be in a span of its own. */
static size_t coupling_slot(const thread_object *t, const thread_twist_span *span, uint32_t node)
{
    if (!thread_has_friction_torque(t)) {
        return node == span->low;
    }
    const uint32_t last = thread_last_turn(span), turn = node + 1 < last ? node + 1 : last;
    return turn + 1 - node;
}

/* Sets the couplings w of a span's nodes from the gradient of its twist. The sum of their w w^T is at least
 * stiffness gradient gradient^T (Cauchy and Schwarz). */
static void set_couplings(thread_object *t, const thread_twist_span *span, const vec3 *gradient)
{
    const double stiffness = t->config.torsional_stiffness / span->length;
    double sum = 0.0;
    for (uint32_t i = span->low; i <= span->high; i++) {
        sum += vec3_norm(gradient[i]);
    }
    for (uint32_t i = span->low; i <= span->high; i++) {
        const double norm = vec3_norm(gradient[i]);
        const double factor = norm > 0.0 ? sqrt(stiffness * sum / norm) : 0.0;
        const size_t slot = coupling_slot(t, span, i);
        t->twist_couplings[t->coupling_slots * (size_t)i + slot] = vec3_scale(gradient[i], factor);
    }
}

/* A span whose twist is part of the matrix needs no couplings but its gradients. */
static void keep_gradients(thread_object *t, uint32_t k, const vec3 *gradient)
{
    const thread_twist_span *span = &t->twist_spans[k];
    memcpy(t->span_gradients[k], gradient + span->low,
           (span->high - span->low + 1) * sizeof *gradient);
}

void vbss_thread_update_twist(thread_object *t, const thread_substep *substep)
{
    const size_t n = t->node_count;
    /* With no compression left in the matrix, the part that is not definite goes too. */
    const bool has_stiffness = substep->min_tension < 0.0;
    memset(t->twist_forces, 0, n * sizeof *t->twist_forces);
    memset(t->twist_couplings, 0, t->coupling_slots * n * sizeof *t->twist_couplings);
    memset(t->twist_stiffness, 0, 2 * n * sizeof *t->twist_stiffness);
    for (uint32_t k = 0; k < t->twist_span_count; k++) {
        thread_twist_span *span = &t->twist_spans[k];
        vec3 *gradient = t->twist_scratch;
        vbss_thread_set_twist(t, t->trial, span);
        memset(gradient + span->low, 0, (span->high - span->low + 1) * sizeof *gradient);
        for (uint32_t i = thread_first_turn(span); i <= thread_last_turn(span); i++) {
            const thread_turn turn = vbss_thread_turn(t->trial, span, i);
            add_gradient(t->twist_forces, i, &turn, -span->torque);
            add_gradient(gradient, i, &turn, 1.0);
            if (has_stiffness) {
                t->twist_stiffness[2 * (size_t)i + (i == span->low)] =
                    stiffness_of(&turn, span->torque);
            }
        }
        if (thread_has_friction_torque(t) && t->is_span_exact[k] != 0) {
            keep_gradients(t, k, gradient);
        } else if (thread_last_turn(span) >= thread_first_turn(span)) {
            set_couplings(t, span, gradient);
        }
    }
}

/* Takes the forces of one turn's stiffness for the increments `u` from `forces`. */
static void subtract_stiffness(const thread_twist_stiffness *s, uint32_t node, const vec3 *u,
                               vec3 *forces)
{
    const vec3 before = s->has_before ? vec3_sub(u[node], u[node - 1]) : vec3_zero(),
               after = s->has_after ? vec3_sub(u[node + 1], u[node]) : vec3_zero();
    const vec3 of_before =
        vec3_add(mat3_mul_vec3(s->before, before), mat3_mul_vec3(s->mixed, after));
    const vec3 of_after =
        vec3_add(mat3_transpose_mul_vec3(s->mixed, before), mat3_mul_vec3(s->after, after));
    if (s->has_before) {
        forces[node - 1] = vec3_add(forces[node - 1], of_before);
        forces[node] = vec3_sub(forces[node], of_before);
    }
    if (s->has_after) {
        forces[node] = vec3_add(forces[node], of_after);
        forces[node + 1] = vec3_sub(forces[node + 1], of_after);
    }
}

double vbss_thread_twist_residual(thread_object *t, const vbss_integration *in, const vec3 *u)
{
    vec3 *error = t->twist_scratch;
    memcpy(error, t->twist_forces, t->node_count * sizeof *error);
    for (uint32_t i = 0; i < t->node_count; i++) {
        for (size_t k = 0; k < t->coupling_slots; k++) {
            const vec3 w = t->twist_couplings[t->coupling_slots * (size_t)i + k];
            error[i] = vec3_add_scaled(error[i], -vec3_dot(w, u[i]), w);
        }
        for (size_t side = 0; side < 2; side++) {
            subtract_stiffness(&t->twist_stiffness[2 * (size_t)i + side], i, u, error);
        }
    }
    for (uint32_t k = 0; k < t->twist_span_count; k++) {
        thread_twist_span *span = &t->twist_spans[k];
        vbss_thread_set_twist(t, t->trial, span);
        for (uint32_t i = thread_first_turn(span); i <= thread_last_turn(span); i++) {
            const thread_turn turn = vbss_thread_turn(t->trial, span, i);
            add_gradient(error, i, &turn, span->torque);
        }
    }
    const double mobility = 1.0 / (in->inertia * t->config.linear_density);
    double largest = 0.0;
    for (uint32_t i = 0; i < t->node_count; i++) {
        if (t->prescribed_by[i] == 0 && t->welded[i] == 0) {
            const double inverse_rest = t->inverse_rest[i > 0 ? i - 1 : 0];
            largest = vbss_max_or_nan(vec3_norm(error[i]) * mobility * inverse_rest, largest);
        }
    }
    return largest;
}

/* ---- the current state */

double vbss_thread_twist_energy(const thread_object *t)
{
    const uint32_t spans = vbss_thread_count_spans(t);
    double energy = 0.0;
    for (uint32_t k = 0; k < spans; k++) {
        const thread_twist_span span = vbss_thread_twist_span(t, k);
        energy += 0.5 * span.length * span.torque * span.torque / t->config.torsional_stiffness;
    }
    return energy;
}

vec3 vbss_thread_twist_force(const thread_object *t, uint32_t node)
{
    const uint32_t spans = vbss_thread_count_spans(t);
    vec3 force = vec3_zero();
    for (uint32_t k = 0; k < spans; k++) {
        const thread_twist_span span = vbss_thread_twist_span(t, k);
        if (node < span.low || node > span.high) {
            continue;
        }
        const uint32_t low = thread_first_turn(&span), high = thread_last_turn(&span);
        const uint32_t first = node > low ? node - 1 : low, last = node < high ? node + 1 : high;
        for (uint32_t i = first; i <= last; i++) {
            const thread_turn turn = vbss_thread_turn(t->now.x, &span, i);
            const double before = turn.inverse_before, after = turn.inverse_after;
            const double coefficient = i < node ? after : i > node ? -before : before - after;
            force = vec3_add_scaled(force, -span.torque * coefficient, turn.half_binormal);
        }
    }
    return force;
}

/* Torque of an end of a span on its holder, along the thread there. */
static vec3 end_torque(const thread_object *t, const thread_twist_span *span, int end)
{
    if (!span->is_clamped[end]) {
        return vec3_scale(span->direction[end], span->torque);
    }
    const thread_turn turn = vbss_thread_turn(t->now.x, span, end == 0 ? span->low : span->high);
    return vec3_scale(turn.mean, span->torque);
}

vec3 vbss_thread_twist_torque(const thread_object *t, uint32_t node)
{
    const uint32_t spans = vbss_thread_count_spans(t);
    vec3 sum = vec3_zero();
    for (uint32_t k = 0; k < spans; k++) {
        const thread_twist_span span = vbss_thread_twist_span(t, k);
        if (span.high == node && span.roll_segment[1] == THREAD_NO_ROLL) {
            sum = vec3_add(sum, end_torque(t, &span, 1));
        } else if (span.low == node && span.roll_segment[0] == THREAD_NO_ROLL) {
            sum = vec3_sub(sum, end_torque(t, &span, 0));
        }
    }
    return sum;
}
