/* What tools take, hold and cut: tools.c, and a file each for threads (grasps.c), needles (needles.c, holds.c), walls (pinches.c), the
 * rows of all that is held (grasp_rows.c) and blades (shears.c). */
#ifndef VBSS_SCENE_TOOLS_H
#define VBSS_SCENE_TOOLS_H

#include "scene/scene.h"

/* tools.c: what graspers were told, before a step; what became of it, after; and as it was. */
void vbss_scene_keep_tools(scene_object *s);
void vbss_scene_return_tools(scene_object *s);
void vbss_scene_take_tools(scene_object *s, double h);
void vbss_scene_aim_capsules(scene_object *s, const scene_part *part);
void vbss_scene_settle_tools(scene_object *s, double h);
/* To hosts: where tools and needles are, what they hold. */
void vbss_scene_show_tools(scene_object *s);
void vbss_scene_release_grasper(scene_body *b);

/* grasps.c: the angle of a tool's jaws after the step, stopped by what they then hold; what it lets go as it
 * opens; what happened to all that is held. */
double vbss_scene_close_jaws(scene_object *s, scene_body *tool, double h);
void vbss_scene_let_go(scene_object *s, const scene_body *tool);
void vbss_scene_settle_grasps(scene_object *s, double h);
/* Those of what was let go that is clear of the jaws. */
void vbss_scene_forget_clear_grasps(scene_object *s);
/* A place for one more, or NULL. */
scene_grasp *vbss_scene_free_grasp(const scene_object *s);
uint32_t vbss_scene_count_grasps(const scene_object *s, uint32_t tool);
/* An event, with the place in micrometres. */
void vbss_scene_tell_grasp(scene_object *s, vbss_event_kind kind, const scene_grasp *g);
void vbss_scene_forget_grasps_of(scene_object *s, uint32_t number);
/* Whether a segment is so near to what is held, along the thread, that the jaws do not touch it. */
bool vbss_scene_is_held_at(const scene_object *s, const scene_grasp *g, uint32_t segment,
                           double touching);

/* needles.c: the needle's frame, which the host sees, from that of its principal axes. */
pose vbss_scene_needle_at(const scene_rigid *r, pose principal);
void vbss_scene_show_needle(const scene_body *b);
void vbss_scene_release_needle(scene_body *b);
/* holds.c: whether a tool holds a needle; one that is between its jaws; which it takes, and lets go as it opens; what
 * happened to all that is held; nothing of a tool or needle is any more. */
bool vbss_scene_holds_needle(const scene_object *s, uint32_t tool);
bool vbss_scene_find_needle(const scene_object *s, const scene_body *tool, scene_hold *found);
void vbss_scene_take_needle(scene_object *s, scene_body *tool, const scene_hold *found);
void vbss_scene_let_needle_go(scene_object *s, scene_body *tool);
void vbss_scene_settle_holds(scene_object *s, double h);
void vbss_scene_forget_holds_of(scene_object *s, uint32_t number);
void vbss_scene_show_hold(const scene_object *s, const scene_body *tool, vbss_grasp *grasp);
/* Whether a segment of a needle is so near to what is held, along its arc, that it does not touch that capsule of the
 * tool. */
bool vbss_scene_is_in_jaws(const scene_object *s, const scene_body *needle, uint32_t segment,
                           const scene_body *tool, uint32_t capsule);
/* Three rows a hold, in a list that has begun; how one lies in the trial state. */
bool vbss_scene_add_hold_rows(scene_object *s);
void vbss_scene_lay_hold_row(scene_object *s, contact_constraint *row);

/* pinches.c: the same of the wall of a drain, of which `point` is one. */
bool vbss_scene_pinches(const scene_object *s, uint32_t tool);
bool vbss_scene_find_wall(const scene_object *s, const scene_body *tool, scene_pinch *found);
void vbss_scene_take_wall(scene_object *s, scene_body *tool, const scene_pinch *found);
void vbss_scene_let_wall_go(scene_object *s, scene_body *tool);
void vbss_scene_settle_pinches(scene_object *s, double h);
void vbss_scene_forget_pinches_of(scene_object *s, uint32_t number);
void vbss_scene_show_pinch(const scene_object *s, const scene_body *tool, vbss_grasp *grasp);
bool vbss_scene_is_pinched(const scene_object *s, const scene_body *drain, vec3 point,
                           const scene_body *tool, uint32_t capsule);
bool vbss_scene_add_pinch_rows(scene_object *s);
void vbss_scene_lay_pinch_row(scene_object *s, contact_constraint *row);
void vbss_scene_mark_pinched(const scene_object *s, const contact_constraint *row);

/* grasp_rows.c: three rows a grasp, in a list that has begun; how one lies in the trial state, all of it or what
 * a linearisation changes; a point of a thread that is held; the jaws' frame in the world. */
bool vbss_scene_add_grasp_rows(scene_object *s);
/* What is held is here in the trial state, and shall be there, in the jaws: a spring between the two, whose stiffness and terms
 * who calls it adds. */
void vbss_scene_lay_spring(contact_constraint *row, const scene_rigid *tool, vec3 here, vec3 there);
/* A row that ties two places, of whatever is held or pierced. False: no room. */
contact_constraint *vbss_scene_add_tie(scene_object *s, const contact_key *key);
void vbss_scene_lay_grasp_row(scene_object *s, contact_constraint *row);
vec3 vbss_scene_held_point(const scene_grasp *g, const thread_object *t, const vec3 *x,
                           uint32_t point);
pose vbss_scene_jaws_of(const scene_rigid *r, pose principal);

/* shears.c. What cannot be cut is let through, at that angle of the blades; false: it can be, or there is no room to
 * remember it. */
bool vbss_scene_let_through(scene_object *s, uint32_t tool, const scene_strand *at, double angle);
void vbss_scene_note_cut(scene_object *s, const scene_strand *at);
void vbss_scene_make_cuts(scene_object *s);

#endif
