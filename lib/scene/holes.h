/* Holes that needles have made in walls, and what is in them: holes.c, punctures.c, fold_punctures.c. */
#ifndef VBSS_SCENE_HOLES_H
#define VBSS_SCENE_HOLES_H

#include "scene/scene.h"

/* holes.c. A row a hole, in a list that has begun; how one lies in the trial state; its nodes are separators; what
 * rows have found, when a part is taken. */
bool vbss_scene_add_hole_constraints(scene_object *s);
void vbss_scene_update_hole_constraint(scene_object *s, contact_constraint *constraint);
void vbss_scene_add_hole_separators(const scene_object *s, const contact_constraint *constraint);
void vbss_scene_commit_holes(scene_object *s);
/* The next part has other places in them. */
void vbss_scene_advance_holes(scene_object *s);
/* How far the suture has slid through them in the trial state. */
void vbss_scene_find_trial_slides(scene_object *s);
/* punctures.c. After a step: who has left holes, who makes one. */
void vbss_scene_update_holes(scene_object *s);
/* holes.c again: how holes are as a step begins; at its end, who has left them. */
void vbss_scene_record_holes_before_step(scene_object *s);
void vbss_scene_close_exited_holes(scene_object *s);
/* fold_punctures.c: makes holes of what goes through beside those that needles are entering. */
void vbss_scene_find_fold_punctures(scene_object *s);
/* Whether that place of a hole's needle, an arc length from the tip, is in another hole of the same wall. */
bool vbss_scene_is_in_other_hole(const scene_object *s, const suture_hole *hole, double arc);
/* One that has been made, if there is room for it, and the event. */
void vbss_scene_add_hole(scene_object *s, suture_hole *made);
void vbss_scene_remove_holes_of(scene_object *s, uint32_t number);
/* Where a thread is cut that is to be cut there: not in a hole, in which only one of the two ends could be. */
double vbss_scene_move_cut_out_of_holes(const scene_object *s, uint32_t thread, double arc_length);
/* Of a thread that was cut there. */
void vbss_scene_divide_holes(scene_object *s, uint32_t thread, uint32_t piece, double arc_length);
/* What is left of a thread is no curve any more: after cuts, and changes of meshes. */
void vbss_scene_close_holes_of_short_threads(scene_object *s);
/* The thread whose begin is swaged to a needle; the needle; or NULL. */
const scene_body *vbss_scene_swaged_thread(const scene_object *s, const scene_body *needle);
const scene_body *vbss_scene_swaged_needle(const scene_object *s, const scene_body *thread);

#endif
