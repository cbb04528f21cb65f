/* Holes that needles have made in walls, and what is in them: holes.c, punctures.c, folds.c. */
#ifndef VBSS_SCENE_HOLES_H
#define VBSS_SCENE_HOLES_H

#include "scene/scene.h"

/* holes.c. A row a hole, in a list that has begun; how one lies in the trial state; its nodes are separators; what
 * rows have found, when a part is taken. */
bool vbss_scene_add_hole_rows(scene_object *s);
void vbss_scene_lay_hole_row(scene_object *s, contact_constraint *row);
void vbss_scene_mark_hole(const scene_object *s, const contact_constraint *row);
void vbss_scene_keep_holes(scene_object *s);
/* The next part has other places in them. */
void vbss_scene_move_holes(scene_object *s);
/* How far the suture has slid through them in the trial state. */
void vbss_scene_find_slides(scene_object *s);
/* punctures.c. After a step: who has left holes, who makes one. */
void vbss_scene_settle_holes(scene_object *s);
/* holes.c again: how holes are as a step begins; at its end, who has left them. */
void vbss_scene_note_holes(scene_object *s);
void vbss_scene_leave_holes(scene_object *s);
/* folds.c: makes holes of what goes through beside those that needles are entering. */
void vbss_scene_find_folds(scene_object *s);
/* Whether that place of a hole's needle, an arc length from the tip, is in another hole of the same wall. */
bool vbss_scene_is_in_other_hole(const scene_object *s, const suture_hole *hole, double arc);
/* One that has been made, if there is room for it, and the event. */
void vbss_scene_add_hole(scene_object *s, suture_hole *made);
void vbss_scene_forget_holes_of(scene_object *s, uint32_t number);
/* Where a thread is cut that is to be cut there: not in a hole, in which only one of the two ends could be. */
double vbss_scene_outside_holes(const scene_object *s, uint32_t thread, double arc_length);
/* Of a thread that was cut there. */
void vbss_scene_divide_holes(scene_object *s, uint32_t thread, uint32_t piece, double arc_length);
/* What is left of a thread is no curve any more: after cuts, and changes of meshes. */
void vbss_scene_leave_short_threads(scene_object *s);
/* The thread whose begin is swaged to a needle; the needle; or NULL. */
const scene_body *vbss_scene_thread_of(const scene_object *s, const scene_body *needle);
const scene_body *vbss_scene_needle_of(const scene_object *s, const scene_body *thread);

#endif
