/* Bending with memory: plastic and viscous curvature of the implicit method.
 * docs/explanation/bending-memory.md has the model.
 *
 * A step:
 *
 *   predict -> [update_bending_memory -> assemble -> solve -> apply increment] until converged
 *   -> commit_bending_memory
 *
 * Each function may be called only if thread_has_memory. */
#ifndef VBSS_THREAD_BENDING_MEMORY_H
#define VBSS_THREAD_BENDING_MEMORY_H

#include "thread/thread.h"

/* Whether bending has a plastic or a viscous part. */
static inline bool thread_has_memory(const thread_object *t)
{
    return t->config.yield_curvature > 0.0 || t->config.relaxation_ratio > 0.0;
}

/* Computes bend_responses from the trial state, for a substep of `h` seconds. */
void vbss_thread_update_bending_memory(thread_object *t, double h);

/* Largest distance, m, by which moments that bend_responses did not foresee would move a node of the
 * trial state. */
double vbss_thread_bending_memory_residual(const thread_object *t, const vbss_integration *in);

/* Makes plastic and viscous curvatures at the end of a substep of `h` seconds the state, and turns
 * their planes with the thread. Before the trial positions become the positions. */
void vbss_thread_commit_bending_memory(thread_object *t, double h);

/* Puts the memory of each bend into the plane of the current bend, on the same side, after a host has set
 * positions. Needs derived data. */
void vbss_thread_orient_bending_memory(thread_object *t);

/* Part of the bending energy that memory adds, J. */
double vbss_thread_bending_memory_energy(const thread_object *t);

/* Force that memory adds on one node in the current state, N. */
vec3 vbss_thread_bending_memory_force(const thread_object *t, uint32_t node);

/* Gradient of that energy with the direction of the clamp at a node, N m. */
vec3 vbss_thread_bending_memory_gradient(const thread_object *t, uint32_t node);

#endif
