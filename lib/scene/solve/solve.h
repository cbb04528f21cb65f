/* One substep without collision checks: prediction, sparsity, Newton iterations, energy check,
 * commit. */
#ifndef VBSS_SCENE_SOLVE_H
#define VBSS_SCENE_SOLVE_H

#include "scene/world/scene_data.h"

/* ---- system_capacity.c */

/* The system of a scene with one more drain, or none; what it had room for goes. */
vbss_result vbss_scene_create_system(scene_object *s, const drain_object *added);

/* ---- predict.c */

/* Trial states, from where the part begins. */
void vbss_scene_predict(scene_object *s, const scene_substep *substep);

/* ---- sparsity.c */

/* Which blocks are separators, and the system's pattern. */
void vbss_scene_number_blocks(scene_object *s);
vbss_result vbss_scene_build_sparsity_pattern(scene_object *s);
void vbss_scene_set_weld_arms(scene_object *s);

/* ---- energy_check.c */

/* Whether what a search that was stopped has led to may be taken. */
bool vbss_scene_passes_energy_check(const scene_object *s, const scene_substep *substep);

/* Whether it might be, after further linearisations. */
bool vbss_scene_may_pass_energy_check(const scene_object *s, const scene_substep *substep);

/* By which a block has moved in the trial state, and what it is a node of: a thread, a drain, or neither (SCENE_BODY_NONE). */
scene_body_kind vbss_scene_find_block_displacement(const scene_object *s, uint32_t block_index,
                                                   vec3 *displacement);

/* ---- newton.c */

/* Bodies and contacts, one system; what a linearisation costs. */
uint32_t vbss_scene_linearisation_cost(const scene_object *s);
scene_substep_outcome vbss_scene_solve(scene_object *s, const scene_substep *substep);

/* Goes on where that has waited; hosts may have looked at bodies meanwhile, no more. */
scene_substep_outcome vbss_scene_resume_solve(scene_object *s, const scene_substep *substep);

/* ---- commit.c */

/* Shows the part to whoever watches; the trial state becomes the state; and what says that motion is not smooth. */
void vbss_scene_notify_substep(const scene_object *s);
void vbss_scene_commit(scene_object *s, const scene_substep *substep);
void vbss_scene_commit_capsules(scene_object *s);
void vbss_scene_request_damping(scene_object *s);

#endif
