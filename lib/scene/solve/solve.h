/* Solution of one substep: system capacity, prediction, sparsity, Newton iterations, energy check,
 * commit. Contacts must be created before, and CCD follows before the commit. */
#ifndef VBSS_SCENE_SOLVE_H
#define VBSS_SCENE_SOLVE_H

#include "scene/world/scene_data.h"

/* ---- system_capacity.c */

/* Replaces the system by one with capacity for all drains and compliant surfaces of the scene, `added` (NULL: no
 * further drain), and another `added_blocks` blocks. The next substep builds the pattern again. VBSS_ERROR_OUT_OF_MEMORY:
 * nothing changes. */
vbss_result vbss_scene_create_system(scene_object *s, const drain_object *added,
                                     uint32_t added_blocks);

/* Blocks that a host surface needs for the vertices that are touched at a time. */
uint32_t vbss_scene_surface_blocks(const scene_host_surface *h);

/* Makes room for the rolls of a thread with friction torque that is added; of one without does nothing.
 * VBSS_ERROR_OUT_OF_MEMORY: nothing changes. */
vbss_result vbss_scene_reserve_rolls(scene_object *s, const thread_object *t);

/* ---- rolls.c: rolls of threads with friction torque
 *
 * Three segments share a block behind those of the nodes. Its unknowns are displacements of the thread's
 * surface, radius times roll, m. */

/* Number of blocks for the rolls of a thread. */
uint32_t vbss_scene_count_roll_blocks(const thread_object *t);

/* Registers these blocks; those without a roll are prescribed. */
vbss_result vbss_scene_register_rolls(scene_object *s, const scene_thread *b);

/* Finds the spans whose twist the springs contain with their nodes: a function of what determines the pattern
 * of the bodies. */
void vbss_scene_mark_exact_spans(scene_object *s);

/* Lists the springs of all threads and couples their blocks; finds the indices of the springs' blocks after
 * the analysis. VBSS_ERROR_CAPACITY. */
vbss_result vbss_scene_register_roll_springs(scene_object *s);
void vbss_scene_find_roll_spring_indices(scene_object *s);

/* Assembles torques and springs of a thread, after its twist was updated. */
void vbss_scene_assemble_rolls(scene_object *s, const scene_thread *b);

/* Adds the increments of the rolls to the trial state of a thread. */
void vbss_scene_advance_rolls(const scene_object *s, const scene_thread *b);

/* ---- predict.c */

/* Sets integration scheme and trial state of every body for the substep. Threads without
 * contacts start from a prediction, driven bodies from their targets, all others from the
 * committed state. */
void vbss_scene_predict(scene_object *s, const scene_substep *substep);

/* ---- surface_compliance.c */

/* Lists the vertices of compliant surfaces that contacts touch. */
void vbss_scene_list_touched_vertices(scene_object *s);

/* Moves all other vertices of compliant surfaces to where the host has prescribed, as no force deflects them. */
void vbss_scene_release_untouched_vertices(scene_object *s);

/* Registers a block for each of the touched vertices. VBSS_ERROR_CAPACITY: more than SCENE_MAX_TOUCHED_VERTICES. */
vbss_result vbss_scene_register_touched_vertices(scene_object *s, const scene_rigid *r);

/* Adds stiffness and forces of their compliance to the system. */
void vbss_scene_assemble_surface(const scene_object *s, const scene_rigid *r);

/* Adds their increments to the trial positions. */
void vbss_scene_advance_surface(const scene_object *s, const scene_rigid *r);

/* ---- sparsity.c */

/* Assigns system blocks to bodies in the order in which they are registered. Constraints need the
 * numbers before the pattern is built. */
void vbss_scene_number_blocks(scene_object *s);

/* Chooses separators and builds the system's sparsity pattern if it has changed since the last
 * substep. Fails if the system's capacity is exceeded. */
vbss_result vbss_scene_build_sparsity_pattern(scene_object *s);

/* Builds the pattern of the bodies alone before a step. Nothing else changes. */
vbss_result vbss_scene_prepare_pattern(scene_object *s);

/* Sets the arms of welds to the orientations of the trial state. */
void vbss_scene_set_weld_arms(scene_object *s);

/* ---- energy_check.c */

/* Whether a substep's energy gain is within tolerance. True if no check is needed. */
bool vbss_scene_passes_energy_check(const scene_object *s, const scene_substep *substep);

/* Whether further linearisations may still bring the energy gain within tolerance. */
bool vbss_scene_may_pass_energy_check(const scene_object *s, const scene_substep *substep);

/* Finds the displacement of a system block since the start of the substep, m. Returns the kind of
 * its body: thread or drain. SCENE_BODY_NONE: another block, and `displacement` is not set. */
scene_body_kind vbss_scene_find_block_displacement(const scene_object *s, uint32_t block_index,
                                                   vec3 *displacement);

/* ---- newton.c */

/* Cost of one linearisation, in operations. */
uint32_t vbss_scene_linearisation_cost(const scene_object *s);

/* Solves a substep by Newton iterations from the predicted trial state. Returns ACCEPTED,
 * NO_ACTIVE_SET, NOT_CONVERGED, PENETRATION, SINGULAR or SUSPENDED. */
scene_substep_outcome vbss_scene_solve(scene_object *s, const scene_substep *substep);

/* Computes the strains and clamp directions of the suspended attempt in memory, which queries of
 * threads have overwritten with those of the present state. */
void vbss_scene_recompute_strains(scene_object *s, const scene_substep *substep);

/* Resumes a solve that was suspended. Between the calls hosts may have read from bodies, but not
 * edited them. Returns one of the outcomes of vbss_scene_solve. */
scene_substep_outcome vbss_scene_resume_solve(scene_object *s, const scene_substep *substep);

/* ---- commit.c */

/* Calls the observer of substeps, if there is one; trial state and committed state are
 * still apart. */
void vbss_scene_notify_substep(const scene_object *s);

/* Makes the trial state of all bodies, holes and contacts the state. Calls the observer first. */
void vbss_scene_commit(scene_object *s, const scene_substep *substep);

/* Makes the trial positions of capsules in their bodies the current ones. */
void vbss_scene_commit_capsules(scene_object *s);

/* Integrates a body, if it is a thread, by backward Euler for a few steps, after a substep had to
 * be halved. */
void vbss_scene_request_damping_of(scene_body *b);

/* Requests damping for all bodies that take part in the present substep. */
void vbss_scene_request_damping(scene_object *s);

#endif
