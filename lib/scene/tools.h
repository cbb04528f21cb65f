/* What tools take, hold and cut: tools.c, and a file each for threads (grasp_thread.c), needles (needles.c, grasp_needle.c), walls (grasp_wall.c), the
 * rows of all that is held (grasp_constraints.c) and blades (shears.c). */
#ifndef VBSS_SCENE_TOOLS_H
#define VBSS_SCENE_TOOLS_H

#include "scene/scene.h"

/* tools.c: what graspers were told, before a step; what became of it, after; and as it was. */
void vbss_scene_checkpoint_tools(scene_object *s);
void vbss_scene_rollback_tools(scene_object *s);
void vbss_scene_apply_tool_targets(scene_object *s, double h);
void vbss_scene_set_capsule_trials(scene_object *s, const scene_substep *substep);
void vbss_scene_update_tools(scene_object *s, double h);
/* To hosts: where tools and needles are, what they hold. */
void vbss_scene_publish_tools(scene_object *s);
void vbss_scene_disown_grasper(scene_body *b);

/* grasp_thread.c: the angle of a tool's jaws after the step, stopped by what they then hold; what it lets go as it
 * opens; what happened to all that is held. */
double vbss_scene_close_jaws(scene_object *s, scene_body *tool, double h);
void vbss_scene_release_thread_grasps(scene_object *s, const scene_body *tool);
void vbss_scene_update_thread_grasps(scene_object *s, double h);
/* Those of what was let go that is clear of the jaws. */
void vbss_scene_remove_clear_thread_grasps(scene_object *s);
/* A place for one more, or NULL. */
scene_thread_grasp *vbss_scene_find_free_grasp(const scene_object *s);
uint32_t vbss_scene_count_grasps(const scene_object *s, uint32_t tool);
/* An event, with the place in micrometres. */
void vbss_scene_emit_grasp_event(scene_object *s, vbss_event_kind kind,
                                 const scene_thread_grasp *g);
void vbss_scene_remove_thread_grasps_of(scene_object *s, uint32_t number);
/* Whether a segment is so near to what is held, along the thread, that the jaws do not touch it. */
bool vbss_scene_is_segment_in_grasp(const scene_object *s, const scene_thread_grasp *g,
                                    uint32_t segment, double contact_distance);

/* needles.c: the needle's frame, which the host sees, from that of its principal axes. */
pose vbss_scene_needle_frame(const scene_rigid *r, pose principal);
void vbss_scene_publish_needle(const scene_body *b);
void vbss_scene_disown_needle(scene_body *b);
/* grasp_needle.c: whether a tool holds a needle; one that is between its jaws; which it takes, and lets go as it opens; what
 * happened to all that is held; nothing of a tool or needle is any more. */
bool vbss_scene_has_needle_grasp(const scene_object *s, uint32_t tool);
bool vbss_scene_find_needle_in_jaws(const scene_object *s, const scene_body *tool,
                                    scene_needle_grasp *found);
void vbss_scene_grasp_needle(scene_object *s, scene_body *tool, const scene_needle_grasp *found);
void vbss_scene_release_needle_grasp(scene_object *s, scene_body *tool);
void vbss_scene_update_needle_grasps(scene_object *s, double h);
void vbss_scene_remove_needle_grasps_of(scene_object *s, uint32_t number);
void vbss_scene_describe_needle_grasp(const scene_object *s, const scene_body *tool,
                                      vbss_grasp *grasp);
/* Whether a segment of a needle is so near to what is held, along its arc, that it does not touch that capsule of the
 * tool. */
bool vbss_scene_is_needle_in_grasp(const scene_object *s, const scene_body *needle,
                                   uint32_t segment, const scene_body *tool, uint32_t capsule);
/* Three rows a hold, in a list that has begun; how one lies in the trial state. */
bool vbss_scene_add_needle_grasp_constraints(scene_object *s);
void vbss_scene_update_needle_grasp_constraint(scene_object *s, contact_constraint *constraint);

/* grasp_wall.c: the same of the wall of a drain, of which `point` is one. */
bool vbss_scene_has_wall_grasp(const scene_object *s, uint32_t tool);
bool vbss_scene_find_wall_in_jaws(const scene_object *s, const scene_body *tool,
                                  scene_wall_grasp *found);
void vbss_scene_grasp_wall(scene_object *s, scene_body *tool, const scene_wall_grasp *found);
void vbss_scene_release_wall_grasp(scene_object *s, scene_body *tool);
void vbss_scene_update_wall_grasps(scene_object *s, double h);
void vbss_scene_remove_wall_grasps_of(scene_object *s, uint32_t number);
void vbss_scene_describe_wall_grasp(const scene_object *s, const scene_body *tool,
                                    vbss_grasp *grasp);
bool vbss_scene_is_wall_in_grasp(const scene_object *s, const scene_body *drain, vec3 point,
                                 const scene_body *tool, uint32_t capsule);
bool vbss_scene_add_wall_grasp_constraints(scene_object *s);
void vbss_scene_update_wall_grasp_constraint(scene_object *s, contact_constraint *constraint);
void vbss_scene_add_wall_grasp_separators(const scene_object *s,
                                          const contact_constraint *constraint);

/* grasp_constraints.c: three rows a grasp, in a list that has begun; how one lies in the trial state, all of it or what
 * a linearisation changes; a point of a thread that is held; the jaws' frame in the world. */
bool vbss_scene_add_thread_grasp_constraints(scene_object *s);
/* What is held is here in the trial state, and shall be there, in the jaws: a spring between the two, whose stiffness and terms
 * who calls it adds. */
void vbss_scene_set_spring_geometry(contact_constraint *constraint, const scene_rigid *tool,
                                    vec3 current, vec3 target);
/* A row that ties two places, of whatever is held or pierced. False: no room. */
contact_constraint *vbss_scene_add_bilateral_constraint(scene_object *s, const contact_key *key);
void vbss_scene_update_bilateral_constraint(scene_object *s, contact_constraint *constraint);
vec3 vbss_scene_grip_point(const scene_thread_grasp *g, const thread_object *t, const vec3 *x,
                           uint32_t point);
pose vbss_scene_jaw_frame(const scene_rigid *r, pose principal);

/* shears.c. What cannot be cut is let through, at that angle of the blades; false: it can be, or there is no room to
 * remember it. */
bool vbss_scene_exclude_uncuttable(scene_object *s, uint32_t tool, const scene_strand *at,
                                   double angle);
void vbss_scene_schedule_cut(scene_object *s, const scene_strand *at);
void vbss_scene_make_cuts(scene_object *s);

#endif
