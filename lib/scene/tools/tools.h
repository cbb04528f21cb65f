/* Graspers, needle drivers and shears: targets, jaws, what they grasp and cut, and what hosts are
 * shown of it. */
#ifndef VBSS_SCENE_TOOLS_H
#define VBSS_SCENE_TOOLS_H

#include "scene/world/scene_data.h"

/* Where along the thread a point is held: on a segment, and which share of it. */
typedef struct scene_grip_location {
    uint32_t segment;
    double fraction;
} scene_grip_location;

/* A place of a thread between open jaws. */
typedef struct scene_strand_candidate {
    const scene_body *thread;
    uint32_t segment;
    grasper_jaw_point at;
    double diameter;
    double angle; /* at which the jaws touch it from both sides, with what lies across from it */
} scene_strand_candidate;

typedef struct scene_jaw_query {
    const grasper_object *grasper;
    uint32_t tool;
    pose jaws;
    scene_strand_candidate strands[SCENE_MAX_STRANDS];
    uint32_t count;
} scene_jaw_query;

/* A corner of the clamp, and where the needle has it when both are there. */
typedef struct scene_clamp_corner {
    vec3 jaw_point, needle_point;
} scene_clamp_corner;

/* ---- grasp_query.c */

/* A place for one more, or NULL. */
scene_thread_grasp *vbss_scene_find_free_grasp(const scene_object *s);
uint32_t vbss_scene_count_grasps(const scene_object *s, uint32_t tool);

/* Whether a tool grasps a needle. */
bool vbss_scene_has_needle_grasp(const scene_object *s, uint32_t tool);

/* Whether a tool grasps a wall. */
bool vbss_scene_has_wall_grasp(const scene_object *s, uint32_t tool);

/* Whether a tool holds by that grasp. In the baseline method a grasp may wait while another tool
 * leads. */
bool vbss_scene_is_active_grasp(const scene_object *s, uint32_t tool, const scene_thread_grasp *g);

/* The needle in a grasp. */
scene_rigid *vbss_scene_held_needle(const scene_object *s, const scene_needle_grasp *grasp);

/* ---- grip_points.c */

/* Where point `point` of a grip is on the thread whose nodes are at `x`. */
vec3 vbss_scene_grip_point(const scene_thread_grasp *g, const thread_object *t, const vec3 *x,
                           uint32_t point);

/* Segment and fraction of point `point` of a grip, 0 .. GRIP_POINTS - 1. */
scene_grip_location vbss_scene_locate_grip_point(const thread_object *t,
                                                 const scene_thread_grasp *g, uint32_t point);

/* ---- grasp_thread.c */

/* Releases the threads of a tool whose jaws open beyond them. */
void vbss_scene_release_thread_grasps(scene_object *s, const scene_body *tool);

/* After a step: grasped threads slide or are torn out, released ones are forgotten once they are
 * clear of the jaws. */
void vbss_scene_update_thread_grasps(scene_object *s, double h);

/* Those of what was let go that is clear of the jaws. */
void vbss_scene_remove_clear_thread_grasps(scene_object *s);

/* An event, with the place in micrometres. */
void vbss_scene_emit_grasp_event(scene_object *s, vbss_event_kind kind,
                                 const scene_thread_grasp *g);
void vbss_scene_remove_thread_grasps_of(scene_object *s, uint32_t number);

/* Whether a segment is so near to what is held, along the thread, that the jaws do not touch it. */
bool vbss_scene_is_segment_in_grasp(const scene_object *s, const scene_thread_grasp *g,
                                    uint32_t segment, double contact_distance);

/* Arc length of the middle of a grasp along its thread, m. */
double vbss_scene_grasp_arc(const scene_object *s, const scene_thread_grasp *g);

/* Threads between the open jaws of a tool, with the jaw angle at which each is touched from both
 * sides. */
void vbss_scene_find_strands(const scene_object *s, const scene_body *tool, scene_jaw_query *m);

/* Grasps a thread that was found between the jaws, with its event. */
void vbss_scene_grasp_strand(scene_object *s, const scene_body *tool, const scene_jaw_query *m,
                             const scene_strand_candidate *found);

/* ---- grasp_needle.c */

/* The needle between the open jaws of a tool, if there is one. */
bool vbss_scene_find_needle_in_jaws(const scene_object *s, const scene_body *tool,
                                    scene_needle_grasp *found);

/* Grasps a needle that was found between the jaws, with its event. */
void vbss_scene_grasp_needle(scene_object *s, scene_body *tool, const scene_needle_grasp *found);

/* Releases the needle of a tool whose jaws open beyond it. */
void vbss_scene_release_needle_grasp(scene_object *s, scene_body *tool);

/* After a step: grasped needles slide, turn or are torn out, released ones are forgotten once they
 * are clear of the jaws. */
void vbss_scene_update_needle_grasps(scene_object *s, double h);

/* Removes all grasps of a needle, or of a tool, that leaves the scene. */
void vbss_scene_remove_needle_grasps_of(scene_object *s, uint32_t number);

/* Fills in a needle's grasp for hosts. */
void vbss_scene_describe_needle_grasp(const scene_object *s, const scene_body *tool,
                                      vbss_grasp *grasp);

/* Whether a segment of a needle is so near to what is held, along its arc, that it does not touch that capsule of the
 * tool. */
bool vbss_scene_is_needle_in_grasp(const scene_object *s, const scene_body *needle,
                                   uint32_t segment, const scene_body *tool, uint32_t capsule);

/* Corner `k` of the clamp that holds a needle, at given poses of the principal axes of both. */
scene_clamp_corner vbss_scene_clamp_corner(const scene_rigid *needle, pose needle_principal,
                                           const scene_rigid *tool, pose tool_principal,
                                           uint32_t k);

/* ---- grasp_wall.c */

/* The wall between the open jaws of a tool, if there is one. */
bool vbss_scene_find_wall_in_jaws(const scene_object *s, const scene_body *tool,
                                  scene_wall_grasp *found);

/* Grasps a wall that was found between the jaws, with its event. */
void vbss_scene_grasp_wall(scene_object *s, scene_body *tool, const scene_wall_grasp *found);

/* Releases the wall of a tool whose jaws open beyond it. */
void vbss_scene_release_wall_grasp(scene_object *s, scene_body *tool);

/* After a step: grasped walls slide or are torn out, released ones are forgotten once they are
 * clear of the jaws. */
void vbss_scene_update_wall_grasps(scene_object *s, double h);

/* Removes all grasps of a drain, or of a tool, that leaves the scene. */
void vbss_scene_remove_wall_grasps_of(scene_object *s, uint32_t number);

/* Fills in a wall's grasp for hosts. */
void vbss_scene_describe_wall_grasp(const scene_object *s, const scene_body *tool,
                                    vbss_grasp *grasp);

/* Whether a point of a wall is so near to where a tool grasps it that it does not touch that
 * capsule of the tool. */
bool vbss_scene_is_wall_in_grasp(const scene_object *s, const scene_body *drain, vec3 point,
                                 const scene_body *tool, uint32_t capsule);

/* Point `k` of a wall grasp on the drain whose nodes are at `x`. */
vec3 vbss_scene_wall_grasp_point(const scene_wall_grasp *p, const drain_object *d, const vec3 *x,
                                 uint32_t k);

/* Stiffness of one point of a wall grasp, N/m: the points share that of the clamp. */
double vbss_scene_wall_grasp_stiffness(const grasper_object *g, const scene_wall_grasp *p);

/* ---- shears.c */

/* What shears cannot cut is excluded from contact with them, at that angle of the blades. False: it
 * can be cut, or there is no room to remember it. */
bool vbss_scene_exclude_uncuttable(scene_object *s, uint32_t tool, const scene_strand *at,
                                   double angle);

/* Records a cut, which is made after the step. */
void vbss_scene_schedule_cut(scene_object *s, const scene_strand *at);

/* Blades do not slice off less than a thread is thick: neither the ends of what they have just cut, which still lie
 * between them, nor what would be too short for a segment. */
bool vbss_scene_is_at_thread_end(const thread_object *t, double arc);

/* ---- jaws.c */

/* Sets where the capsules of all tools are at the end of the substep: they cover the same fraction
 * of their remaining path as their bodies do. */
void vbss_scene_set_capsule_trials(scene_object *s, const scene_substep *substep);

/* The jaw angle of a tool after the step, stopped by what the jaws then grasp or cut. */
double vbss_scene_close_jaws(scene_object *s, scene_body *tool, double h);

/* Sets where the capsules of a grasper are at the end of the step, in its principal frame, for a
 * jaw angle. */
void vbss_scene_set_capsule_targets(scene_object *s, const scene_rigid *r, double angle);

/* ---- tool_targets.c */

/* Before a step: exchanges instruments, sets target poses and jaw angles, grasps and releases. */
void vbss_scene_apply_tool_targets(scene_object *s, double h);

/* Moves the targets of pinned nodes that graspers carry (baseline method only). */
void vbss_scene_set_carried_targets(scene_object *s);

/* ---- publish_tools.c */

/* Shows hosts where all graspers and needles are and what they hold. */
void vbss_scene_publish_tools(scene_object *s);

/* Shows hosts where a needle is. */
void vbss_scene_publish_needle(const scene_body *b);

/* Shows hosts where a grasper is and what it holds. */
void vbss_scene_publish_grasper(scene_object *s, scene_body *b);

#endif
