/* Holes in walls and the suture in them. */
#ifndef VBSS_SCENE_TISSUE_H
#define VBSS_SCENE_TISSUE_H

#include "scene/world/scene_data.h"

/* A tip that is so much further out than when it entered has left: tremor does not make a hole twice; so does an end of the
 * suture, and the swage changes sides. m. */
#define SCENE_HOLE_EXIT_DISTANCE 0.2e-3

typedef struct scene_hole_context {
    const scene_body *needle, *thread; /* NULL: none */
    const scene_drain *drain;
    suture_curve now, trial;
    double arc; /* of the hole, along the line */
} scene_hole_context;

/* ---- hole_context.c */

/* Stores the friction of each hole when a substep is accepted. */
void vbss_scene_commit_holes(scene_object *s);

/* The next part has other places in them. */
void vbss_scene_advance_holes(scene_object *s);

/* How far the suture has slid through them in the trial state. */
void vbss_scene_find_trial_slides(scene_object *s);

/* The thread whose begin is swaged to a needle; the needle; or NULL. */
const scene_body *vbss_scene_swaged_thread(const scene_object *s, const scene_body *needle);
const scene_body *vbss_scene_swaged_needle(const scene_object *s, const scene_body *thread);

/* What passes through a hole: needle, thread, and the line of both, now and in the trial state. */
scene_hole_context vbss_scene_get_hole_context(const scene_object *s, const suture_hole *hole);

/* The point of the suture that is in the hole now. */
suture_curve_point vbss_scene_hole_curve_point(const scene_hole_context *p,
                                               const suture_hole *hole);

/* Sets where along the suture a hole is, and whether needle or thread is in it. Near the swage it
 * keeps the one that was in it, with hysteresis. */
void vbss_scene_move_hole_to(suture_hole *hole, const scene_hole_context *p, double arc);

/* ---- holes.c */

/* How holes are as a step begins; at its end, who has left them. */
void vbss_scene_record_holes_before_step(scene_object *s);
void vbss_scene_close_exited_holes(scene_object *s);

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

/* An unused entry in the list of holes, or NULL. */
suture_hole *vbss_scene_find_free_hole(scene_object *s);

/* ---- fold_punctures.c */

/* Makes holes of what goes through beside those that needles are entering. */
void vbss_scene_find_fold_punctures(scene_object *s);

/* ---- punctures.c */

/* After a step: who has left holes, who makes one. */
void vbss_scene_update_holes(scene_object *s);

#endif
