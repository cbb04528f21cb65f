/* An attempt at a part of a step, in order: predict.c, pattern.c, solve.c, believe.c, guard.c, commit.c or clamp.c; drains.c is in each. */
#ifndef VBSS_SCENE_ATTEMPT_H
#define VBSS_SCENE_ATTEMPT_H

#include "scene/scene.h"

/* drains.c: in a step, each stage of it. */
void vbss_scene_release_drain(scene_object *s, scene_body *b);
void vbss_scene_keep_drain(scene_drain *b);
void vbss_scene_return_drain(scene_drain *b);
void vbss_scene_aim_drain(scene_drain *b, const scene_part *part);
void vbss_scene_shorten_drain(scene_drain *b, double share);
void vbss_scene_arrive_drains(scene_object *s, double h);
void vbss_scene_paper_arrive_drain(scene_drain *b, double h);
/* predict.c: trial states, from where the part begins. */
void vbss_scene_predict(scene_object *s, const scene_part *part);
/* pattern.c: which blocks are separators, and the system's pattern. */
void vbss_scene_number_blocks(scene_object *s);
vbss_result vbss_scene_build_pattern(scene_object *s);
void vbss_scene_set_weld_arms(scene_object *s);
/* believe.c: whether what a search that was stopped has led to may be taken. */
bool vbss_scene_believes(const scene_object *s, const scene_part *part);
/* Whether it might be, after further linearisations. */
bool vbss_scene_may_yet_believe(const scene_object *s, const scene_part *part);
/* By which a block has moved in the trial state, and what it is a node of: a thread, a drain, or neither (BODY_GONE). */
body_kind vbss_scene_find_way(const scene_object *s, uint32_t number, vec3 *way);
/* solve.c: bodies and contacts, one system; what a linearisation costs. */
uint32_t vbss_scene_linearisation_cost(const scene_object *s);
scene_verdict vbss_scene_solve(scene_object *s, const scene_part *part);
/* Goes on where that has waited; hosts may have looked at bodies meanwhile, no more. */
scene_verdict vbss_scene_solve_on(scene_object *s, const scene_part *part);
/* guard.c */
scene_verdict vbss_scene_guard(scene_object *s);
/* commit.c: shows the part to whoever watches; the trial state becomes the state; and what says that motion is not smooth. */
void vbss_scene_show_part(const scene_object *s);
void vbss_scene_commit(scene_object *s, const scene_part *part);
void vbss_scene_commit_capsules(scene_object *s);
void vbss_scene_unsettle(scene_object *s);
/* clamp.c: as much of the trial state as does no harm becomes the state. Returns the share. */
double vbss_scene_clamp(scene_object *s, scene_verdict verdict, const scene_part *part);
/* Nothing moves after an attempt that was not accepted: rows, which are shown, say what contact does where things are. */
void vbss_scene_stay(scene_object *s);

#endif
