/* Holes in the walls of drains and host surfaces: how needles make them, and the sutures that slide through them.
 * A suture is a needle, a thread, or a needle with a thread swaged to its end. */
#ifndef VBSS_SCENE_TISSUE_H
#define VBSS_SCENE_TISSUE_H

#include "scene/tuning.h"
#include "scene/world/scene_data.h"

/* The wall of a hole and the suture that passes through it. */
typedef struct scene_hole_context {
    const scene_body *needle, *thread; /* parts of the suture; NULL: it has no such part */
    const scene_body *wall_body;
    suture_wall wall;
    suture_curve now, trial; /* centre line of the suture, now and in the trial state */
    double arc;              /* arc length of the hole along that curve, m */
} scene_hole_context;

/* ---- hole_context.c */

/* Stores the forces of all holes when a substep is committed. */
void vbss_scene_commit_holes(scene_object *s);

/* After a substep: moves each hole to the point of its suture that now passes through it. */
void vbss_scene_advance_holes(scene_object *s);

/* Sets trial_slide of all holes: how far their sutures slide through them by the trial state, m. */
void vbss_scene_find_trial_slides(scene_object *s);

/* Returns the thread whose first node is swaged to the end of a needle, or NULL. */
const scene_body *vbss_scene_swaged_thread(const scene_object *s, const scene_body *needle);

/* Returns the needle to whose end the first node of a thread is swaged, or NULL. */
const scene_body *vbss_scene_swaged_needle(const scene_object *s, const scene_body *thread);

/* Whether a hole takes part in the present substep: it exists, and neither its wall nor its suture is frozen. */
bool vbss_scene_is_hole_active(const scene_object *s, const suture_hole *hole);

/* Returns the wall of a hole and the suture in it. */
scene_hole_context vbss_scene_get_hole_context(const scene_object *s, const suture_hole *hole);

/* Returns the point of the suture that is in the hole now: the nearest one downhill from its arc
 * length. */
suture_curve_point vbss_scene_hole_curve_point(const scene_hole_context *p,
                                               const suture_hole *hole);

/* Moves a hole to an arc length along its suture, m from the tip, and sets whether the needle or
 * the thread is in it. At the swage that changes with a hysteresis of SCENE_HOLE_EXIT_DISTANCE. */
void vbss_scene_move_hole_to(suture_hole *hole, const scene_hole_context *p, double arc);

/* ---- holes.c */

/* Records id and needle of each hole when a step begins. */
void vbss_scene_record_holes_before_step(scene_object *s);

/* After a step: removes the holes that their sutures have left, and adds the events. Also adds the
 * events of needles that have passed through a hole or returned into it. */
void vbss_scene_close_exited_holes(scene_object *s, bool relocates);

/* Whether a point of a hole's needle, given by its arc length from the tip in m, is in another
 * hole of the same wall. */
bool vbss_scene_is_in_other_hole(const scene_object *s, const suture_hole *hole, double arc);

/* Adds an event of a hole and the suture in it. */
void vbss_scene_emit_hole_event(scene_object *s, vbss_scene_event_kind kind,
                                const suture_hole *hole, double value);

/* Adds a hole and its event, with the force along the tip that made it, N. Sets the id of `made`. If the
 * list is full, adds VBSS_SCENE_EVENT_HOLE_LOST and no hole. */
void vbss_scene_add_hole(scene_object *s, suture_hole *made, double force);

/* Removes all holes of a needle, thread or wall, given by its number. Adds no event. */
void vbss_scene_remove_holes_of(scene_object *s, uint32_t number);

/* Returns the arc length of a cut, m, moved out of all holes: only one of its two ends could be
 * in one. */
double vbss_scene_move_cut_out_of_holes(const scene_object *s, uint32_t thread, double arc_length);

/* After a cut of a thread at this arc length: gives the holes beyond it to the piece. */
void vbss_scene_divide_holes(scene_object *s, uint32_t thread, uint32_t piece, double arc_length);

/* After cuts and mesh changes: closes the holes of threads with fewer than three nodes, which
 * have no curve, and adds the events. */
void vbss_scene_close_holes_of_short_threads(scene_object *s);

/* Returns an unused entry in the list of holes, or NULL. */
suture_hole *vbss_scene_find_free_hole(scene_object *s);

/* ---- fold_punctures.c */

/* After a step: adds a hole where a needle that is entering a hole passes through the wall a second
 * time beside it. */
void vbss_scene_find_fold_punctures(scene_object *s);

/* ---- tears.c */

/* Whether the thread of a hole can tear the wall. */
bool vbss_scene_can_tear(const scene_hole_context *p, const suture_hole *hole);

/* Whether a hole has torn up to a free edge of the wall, and its thread is beyond this edge: it has no
 * force. */
bool vbss_scene_is_hole_torn_open(const scene_object *s, const suture_hole *hole);

/* Whether a hole would tear as far as its constraint lets it in this substep: shorter substeps follow the
 * pull. */
bool vbss_scene_tears_too_far(const scene_object *s);

/* When a substep is committed: moves a hole through the wall by the yield of its constraint. */
void vbss_scene_tear_hole(scene_object *s, suture_hole *hole, const contact_constraint *constraint);

/* After a step: adds the events of tears, and removes the holes that threads have left at a free edge. */
void vbss_scene_update_tears(scene_object *s);

/* ---- punctures.c */

/* After a step: closes the holes that sutures have left, and makes a hole where the tip of a needle
 * presses on a wall hard enough. */
void vbss_scene_update_holes(scene_object *s);

#endif
