/* Runs a step, in time slices if it has a budget:
 *
 *   apply tool targets
 *   -> [motion bounds -> broad phase -> contacts -> predict -> warm start -> Newton -> CCD -> commit]
 *      per substep
 *   -> events, forces
 *
 * step.c begins and finishes a step, substeps.c repeats or truncates rejected substeps, attempt.c
 * is one attempt at a substep. */
#ifndef VBSS_SCENE_STEP_H
#define VBSS_SCENE_STEP_H

#include "scene/world/scene_data.h"

/* ---- checkpoint.c */

/* Copies all state that a step changes. Fails only if a thread's derived data cannot be computed;
 * then the step must not run. */
vbss_result vbss_scene_checkpoint(scene_object *s);

/* Restores the state of the last checkpoint after a step failed. */
void vbss_scene_rollback(scene_object *s);

/* Copies the statistics, nothing else. */
void vbss_scene_checkpoint_statistics(scene_object *s);

/* Restores the statistics of the last checkpoint, nothing else. */
void vbss_scene_rollback_statistics(scene_object *s);

/* Copies positions, velocities and statistics of a drain to its checkpoint. */
void vbss_scene_checkpoint_drain(scene_drain *b);

/* Restores positions, velocities and statistics of a drain from its checkpoint. */
void vbss_scene_rollback_drain(scene_drain *b);

/* Copies capsules, jaws, grasps and holes to the checkpoint. */
void vbss_scene_checkpoint_tools(scene_object *s);

/* Restores capsules, jaws, grasps and holes from the checkpoint. */
void vbss_scene_rollback_tools(scene_object *s);

/* ---- prepare.c */

/* Does what the next step would do for the bodies alone, unless a step is suspended or the pattern
 * of an earlier step is still valid. VBSS_ERROR_CAPACITY: candidates or matrix. */
vbss_result vbss_scene_prepare_step(scene_object *s);

/* ---- attempt.c */

/* Attempts the cursor's substep, or resumes the attempt that was suspended. Returns any outcome;
 * with ACCEPTED the trial state is ready to commit. */
scene_substep_outcome vbss_scene_run_attempt(scene_object *s);

/* Counts a rejected attempt by its outcome. */
void vbss_scene_count_rejection(scene_object *s, scene_substep_outcome outcome);

/* ---- substeps.c */

/* Runs substeps to the end of the step, or until the step is suspended (`cursor.is_suspended`). An
 * overdue step is not suspended if other bodies wait for it; the limit of the call is then 0.
 * VBSS_ERROR_CAPACITY: candidates or contacts exceed their capacity; the caller rolls back. */
vbss_result vbss_scene_run_substeps(scene_object *s, bool is_overdue);

/* Abandons the rest of a suspended step: all bodies stay where they are. vbss_scene_finish_step
 * may follow. */
void vbss_scene_abandon_step(scene_object *s);

/* Sets the minimum substep sizes of the cursor, as fractions of a step. */
void vbss_scene_set_substep_limits(scene_object *s);

/* Whether `size`, a fraction of a step, is one that a substep can have: a power of 1/2, not below
 * the minimum. */
bool vbss_scene_is_substep_size(const scene_object *s, double size);

/* ---- touch_events.c */

/* Gives the events of pairs that began to touch the place and the force of their strongest contact, when
 * the views have the contacts of the step. */
void vbss_scene_locate_touch_events(scene_object *s);

/* Emits an event for each pair of bodies that began or ceased to touch in the step. */
void vbss_scene_update_touching_pairs(scene_object *s);

/* Inserts a pair of bodies that touch, once. */
void vbss_scene_insert_touching_pair(scene_object *s, scene_touching_pair touching_pair);

/* By the implicit method: inserts the pairs of the contacts that bear. */
void vbss_scene_list_touching_pairs(scene_object *s);

/* ---- contact_forces.c */

/* Finds the force of constraint `i` on its side a, N. It is the force for which the bodies are
 * balanced. Returns false if the constraint is open. */
bool vbss_scene_find_contact_force(const contact_set *set, uint32_t i, vec3 *force);

/* Sums the forces and torques of contacts and pins on rigid bodies, and publishes the views
 * of contacts. */
void vbss_scene_collect_forces(scene_object *s);

/* Adds a contact to the views. */
void vbss_scene_publish_contact(scene_object *s, const scene_contact_record *contact);

/* Begins a step of length `h` (s): sets the cursor, targets of bodies and tools, and counters. */
void vbss_scene_add_force(scene_body *b, vec3 point, vec3 force);

/* Finishes a step after its last substep: forces, events, holes, grasps, cuts, meshes,
 * statistics. */
void vbss_scene_publish_constraints(scene_object *s);

/* Finishes a step of a drain in the baseline method; `h`: length of the step, s. */
void vbss_scene_begin_step(scene_object *s, double h);

/* What follows the last substep of a group while others wait: motion, forces, holes. */
void vbss_scene_finish_group(scene_object *s);

/* What follows the last substep: forces, events, holes, tools, cuts, meshes, counters. */
void vbss_scene_finish_step(scene_object *s);

/* ---- time_slice.c */

/* Abandons the suspended step, if there is one, and finishes it. Fails only if the checkpoint
 * fails; then nothing changes. */
vbss_result vbss_scene_abandon_suspended_step(scene_object *s);

/* Sum of the edit generations of all threads and drains: it grows with each edit by a host. */
uint64_t vbss_scene_count_edits(const scene_object *s);

/* One call of vbss_scene_step by the implicit method, `h` in s. Resumes the suspended step first,
 * then begins further steps as far as the budget of a call allows. On failure the step that failed
 * is rolled back. */
vbss_result vbss_scene_implicit_step(scene_object *s, double h);

#endif
