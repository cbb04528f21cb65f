/* An attempt at a part of a step, in order: predict.c, sparsity.c, newton.c, energy_check.c, ccd.c, commit.c or truncate_substep.c; drains.c is in each. */
#ifndef VBSS_SCENE_SUBSTEP_H
#define VBSS_SCENE_SUBSTEP_H

#include "scene/scene.h"

/* drains.c: in a step, each stage of it. */
void vbss_scene_disown_drain(scene_object *s, scene_body *b);
void vbss_scene_checkpoint_drain(scene_drain *b);
void vbss_scene_rollback_drain(scene_drain *b);
void vbss_scene_set_drain_displacements(scene_drain *b, const scene_substep *substep);
void vbss_scene_truncate_drain(scene_drain *b, double fraction);
void vbss_scene_finish_drains(scene_object *s, double h);
void vbss_scene_paper_arrive_drain(scene_drain *b, double h);
/* predict.c: trial states, from where the part begins. */
void vbss_scene_predict(scene_object *s, const scene_substep *substep);
/* sparsity.c: which blocks are separators, and the system's pattern. */
void vbss_scene_number_blocks(scene_object *s);
vbss_result vbss_scene_build_sparsity_pattern(scene_object *s);
void vbss_scene_set_weld_arms(scene_object *s);
/* energy_check.c: whether what a search that was stopped has led to may be taken. */
bool vbss_scene_passes_energy_check(const scene_object *s, const scene_substep *substep);
/* Whether it might be, after further linearisations. */
bool vbss_scene_may_pass_energy_check(const scene_object *s, const scene_substep *substep);
/* By which a block has moved in the trial state, and what it is a node of: a thread, a drain, or neither (SCENE_BODY_NONE). */
scene_body_kind vbss_scene_find_block_displacement(const scene_object *s, uint32_t block_index,
                                                   vec3 *displacement);
/* newton.c: bodies and contacts, one system; what a linearisation costs. */
uint32_t vbss_scene_linearisation_cost(const scene_object *s);
scene_substep_outcome vbss_scene_solve(scene_object *s, const scene_substep *substep);
/* Goes on where that has waited; hosts may have looked at bodies meanwhile, no more. */
scene_substep_outcome vbss_scene_resume_solve(scene_object *s, const scene_substep *substep);
/* ccd.c */
scene_substep_outcome vbss_scene_run_ccd(scene_object *s);
/* commit.c: shows the part to whoever watches; the trial state becomes the state; and what says that motion is not smooth. */
void vbss_scene_notify_substep(const scene_object *s);
void vbss_scene_commit(scene_object *s, const scene_substep *substep);
void vbss_scene_commit_capsules(scene_object *s);
void vbss_scene_request_damping(scene_object *s);
/* truncate_substep.c: as much of the trial state as does no harm becomes the state. Returns the share. */
double vbss_scene_truncate_substep(scene_object *s, scene_substep_outcome outcome,
                                   const scene_substep *substep);
/* Nothing moves after an attempt that was not accepted: rows, which are shown, say what contact does where things are. */
void vbss_scene_reject_substep(scene_object *s);

#endif
