/* A step: substeps, time slices, checkpoint, and what follows its last substep. */
#ifndef VBSS_SCENE_STEP_H
#define VBSS_SCENE_STEP_H

#include "scene/world/scene_data.h"

/* ---- checkpoint.c */

/* Takes down how everything is, goes back there; counters alone. */
vbss_result vbss_scene_checkpoint(scene_object *s);
void vbss_scene_rollback(scene_object *s);
void vbss_scene_rollback_statistics(scene_object *s);

/* Stores a drain's state in the checkpoint. */
void vbss_scene_checkpoint_drain(scene_drain *b);

/* Restores a drain's state from the checkpoint. */
void vbss_scene_rollback_drain(scene_drain *b);

/* Stores the state of tools, grasps and holes in the checkpoint. */
void vbss_scene_checkpoint_tools(scene_object *s);

/* Restores the state of tools, grasps and holes from the checkpoint. */
void vbss_scene_rollback_tools(scene_object *s);

/* ---- attempt.c */

/* Attempts the substep of the cursor, or resumes the attempt that was suspended. */
scene_substep_outcome vbss_scene_run_attempt(scene_object *s);

/* Counts why an attempt was rejected. */
void vbss_scene_count_rejection(scene_object *s, scene_substep_outcome outcome);

/* ---- substeps.c */

/* Runs the substeps of a step, to its end or until it is suspended (scene_way::waits). */
vbss_result vbss_scene_run_substeps(scene_object *s);

/* The rest of a step that waits is left out: its end may follow. */
void vbss_scene_abandon_step(scene_object *s);

/* How small parts of its steps may be. */
void vbss_scene_set_substep_limits(scene_object *s);

/* Whether a step may be made of parts of that size. */
bool vbss_scene_is_substep_size(const scene_object *s, double size);

/* ---- touch_events.c */

/* Events of pairs of bodies that began or ceased to touch in the step. */
void vbss_scene_update_touching_pairs(scene_object *s);

/* ---- contact_forces.c */

/* The force of a row on its first side, N, with which all balances, and whether it bears any; what contacts and pins do to
 * the rigid bodies; views of contacts. */
bool vbss_scene_find_contact_force(const contact_set *set, uint32_t i, vec3 *force);
void vbss_scene_collect_forces(scene_object *s);

/* ---- step.c */

/* Begins a step: targets of bodies and tools, counters, the size of the first substep. */
void vbss_scene_begin_step(scene_object *s, double h);

/* What follows the last substep: forces, events, holes, tools, cuts, meshes, counters. */
void vbss_scene_finish_step(scene_object *s);

/* The end of a step for a drain of the baseline method. */
void vbss_scene_paper_arrive_drain(scene_drain *b, double h);

/* ---- time_slice.c */

/* Ends the step that waits, if one does, without what is left of it. */
vbss_result vbss_scene_abandon_suspended_step(scene_object *s);

/* A number that grows whenever a host changes a thread or drain. */
uint64_t vbss_scene_count_edits(const scene_object *s);

/* One call of vbss_scene_step by the implicit method: the suspended step first, then the next, as
 * far as the budget of a call allows. */
vbss_result vbss_scene_ours_step(scene_object *s, double h);

#endif
