/* Twist of the implicit method: quasi-static, with one torque between two clamps.
 * docs/explanation/twist.md has the model.
 *
 * A span is the thread between two clamps that follow each other. Its twist is the angle by which the
 * section turns along it, in excess of parallel transport along the chords.
 *
 * A step:
 *
 *   predict -> begin_twist -> [update_twist -> assemble -> solve -> apply increment] until converged
 *   -> commit_twist
 *
 * Each function may be called only if thread_has_twist. */
#ifndef VBSS_THREAD_TWIST_H
#define VBSS_THREAD_TWIST_H

#include "thread/thread.h"

/* Whether the thread resists twist. */
static inline bool thread_has_twist(const thread_object *t)
{
    return t->config.torsional_stiffness > 0.0;
}

/* ---- twist_spans.c */

/* Place where the thread turns, inside a span or at one of its ends. */
typedef struct thread_turn {
    vec3 before, after; /* unit: of the chords, or of the clamp at an end */
    /* 1 / length of these chords, 1/m; 0 at a clamp, whose direction no node changes */
    double inverse_before, inverse_after;
    /* before x after / (1 + their product): half the curvature binormal */
    vec3 half_binormal;
    double inverse_fold; /* 1 / (1 + their product) */
    vec3 mean; /* (before + after) / (1 + their product): unit if the thread is straight */
} thread_turn;

/* The turn of a span at a node from span->low to span->high, with the nodes at `x`. */
thread_turn vbss_thread_turn(const vec3 *x, const thread_twist_span *span, uint32_t node);

/* The span between clamps `index` and `index` + 1, as the state has it. */
thread_twist_span vbss_thread_twist_span(const thread_object *t, uint32_t index);

/* Moves a director along the whole span by parallel transport, with the nodes at `x`. */
vec3 vbss_thread_transport(const vec3 *x, const thread_twist_span *span, vec3 director);

/* Adds a clamp to the state, or takes it out: its attachment is in, or still in, the list. The twist
 * per length of the thread around it does not change. */
void vbss_thread_add_twist_clamp(thread_object *t, uint32_t attachment);
void vbss_thread_remove_twist_clamp(thread_object *t, uint32_t attachment);

/* Prepares a substep: spans with their clamps at its end. A function of the state and of the clamps. */
void vbss_thread_begin_twist(thread_object *t);

/* Sets the twist of a span with the nodes at `x`, which is the one nearest to that of the state. */
void vbss_thread_set_twist(const thread_object *t, const vec3 *x, thread_twist_span *span);

/* Makes the twist of the trial state the state. Before the trial positions become the positions. */
void vbss_thread_commit_twist(thread_object *t);

/* Twist per length of each segment, 1/m, and a unit vector across it that is fixed to the material. */
void vbss_thread_fill_twist_views(thread_object *t);

/* ---- twist.c */

/* Computes twist_forces, twist_couplings and twist_stiffness from the trial state. */
void vbss_thread_update_twist(thread_object *t, const thread_substep *substep);

/* Largest distance, m, by which forces that the last update did not foresee would move a node of the trial
 * state. It was reached by the increments `u`. */
double vbss_thread_twist_residual(thread_object *t, const vbss_integration *in, const vec3 *u);

/* Energy of twist in the current state, J. */
double vbss_thread_twist_energy(const thread_object *t);

/* Force of twist on one node in the current state, N. */
vec3 vbss_thread_twist_force(const thread_object *t, uint32_t node);

/* Torque with which a clamp balances twist in the current state, N m. */
vec3 vbss_thread_twist_torque(const thread_object *t, uint32_t clamp);

#endif
