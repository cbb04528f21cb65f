/* Tools in a scene: their targets and jaws, the grasps of threads, needles and walls, the cuts of
 * shears, and the data that hosts see. */
#ifndef VBSS_SCENE_TOOLS_H
#define VBSS_SCENE_TOOLS_H

#include "scene/world/scene_data.h"

/* A point of a thread: a segment and the position on it, 0 to 1. */
typedef struct scene_grip_location {
    uint32_t segment;
    double fraction;
} scene_grip_location;

/* A strand between open jaws: the point of a thread that is nearest to the middle of the jaws. */
typedef struct scene_strand_candidate {
    const scene_body *thread;
    uint32_t segment;
    grasper_jaw_point at; /* position on the segment and in the jaws */
    double diameter;      /* diameter of the thread, m */
    double angle;         /* jaw angle at which both jaws touch it and the strands beside it, rad */
} scene_strand_candidate;

/* The strands between the jaws of a tool. */
typedef struct scene_jaw_query {
    const grasper_object *grasper;
    uint32_t tool; /* body number */
    pose jaws;     /* jaws' frame in the world */
    scene_strand_candidate strands[SCENE_MAX_STRANDS];
    uint32_t count;
} scene_jaw_query;

/* A corner of the clamp that holds a needle: as a point of the jaws and as a point of the
 * needle. The clamp's spring pulls the two together. In the world, m. */
typedef struct scene_clamp_corner {
    vec3 jaw_point, needle_point;
} scene_clamp_corner;

/* ---- grasp_events.c */

/* What an event says of a grasp. */
typedef struct scene_grasp_event {
    vbss_scene_grasp grasp;
    uint32_t tool;          /* body number */
    uint32_t triangle;      /* of a drain; 0: another body */
    uint32_t logged_number; /* last word of the event in logs */
} scene_grasp_event;
/* Adds an event of this kind with the bodies, the place and the force of a grasp. */
void vbss_scene_emit_grasp_event(scene_object *s, vbss_scene_event_kind kind,
                                 const scene_grasp_event *of);

/* ---- grasp_query.c */

/* Returns an unused entry in the list of thread grasps, or NULL. */
scene_thread_grasp *vbss_scene_find_free_grasp(const scene_object *s);

/* Returns the number of active grasps of a tool: strands of threads, a needle, a wall. */
uint32_t vbss_scene_count_grasps(const scene_object *s, uint32_t tool);

/* Whether a tool grasps a needle and has not released it. In the baseline method the tool must also
 * be the one that the needle follows. */
bool vbss_scene_has_needle_grasp(const scene_object *s, uint32_t tool);

/* Whether a tool grasps a wall and has not released it. */
bool vbss_scene_has_wall_grasp(const scene_object *s, uint32_t tool);

/* Whether `g` is a grasp of this tool that has not been released. In the baseline method the
 * tool must also be the one that holds the node. */
bool vbss_scene_is_active_grasp(const scene_object *s, uint32_t tool, const scene_thread_grasp *g);

/* Returns the needle of a grasp, which must have one. */
scene_rigid *vbss_scene_held_needle(const scene_object *s, const scene_needle_grasp *grasp);

/* ---- grip_points.c */

/* Returns the position of point `point` of a grasp, 0 to GRASPER_THREAD_POINTS - 1, on the
 * thread whose nodes are at `x`. */
vec3 vbss_scene_grip_point(const scene_thread_grasp *g, const thread_object *t, const vec3 *x,
                           uint32_t point);

/* Finds segment and fraction of point `point` of a grasp, 0 to GRASPER_THREAD_POINTS - 1. Points
 * beyond an end of the thread are at that end. */
scene_grip_location vbss_scene_locate_grip_point(const thread_object *t,
                                                 const scene_thread_grasp *g, uint32_t point);

/* ---- grasp_thread.c */

/* Releases the threads that a tool grasps if its handle opens the jaws beyond them. */
void vbss_scene_release_thread_grasps(scene_object *s, const scene_body *tool);

/* After a step of length h: lets grasped threads slide or be torn out, and removes the grasps of
 * released threads that are clear of the jaws. */
void vbss_scene_update_thread_grasps(scene_object *s, double h);

/* Removes the grasps of released threads that are clear of the jaws. */
void vbss_scene_remove_clear_thread_grasps(scene_object *s);

/* Removes all grasps of a thread, or of a tool, given by its number. */
void vbss_scene_remove_thread_grasps_of(scene_object *s, uint32_t number);

/* Whether a segment of the thread lies so near to the grasp, along the thread, that it is
 * excluded from contact with the jaws. `contact_distance` is that of the thread and a jaw, m. */
bool vbss_scene_is_segment_in_grasp(const scene_object *s, const scene_thread_grasp *g,
                                    uint32_t segment, double contact_distance);

/* Adds an event of this kind of a thread's grasp. */
void vbss_scene_emit_thread_grasp_event(scene_object *s, vbss_scene_event_kind kind,
                                        const scene_thread_grasp *g);

/* Describes a thread's grasp for hosts, in all fields but the size. */
void vbss_scene_describe_thread_grasp(const scene_object *s, const scene_thread_grasp *g,
                                      vbss_scene_grasp *grasp);

/* Returns the arc length of the middle of a grasp, from the thread's first node at rest, m. */
double vbss_scene_grasp_arc(const scene_object *s, const scene_thread_grasp *g);

/* Finds the strands between the open jaws of a tool, up to SCENE_MAX_STRANDS, with the jaw angle at
 * which both jaws touch each of them. */
void vbss_scene_find_strands(const scene_object *s, const scene_body *tool, scene_jaw_query *m);

/* Grasps a strand that was found between the jaws, and adds the event. If the list of grasps is
 * full, the strand stays free and the event says so. */
void vbss_scene_grasp_strand(scene_object *s, const scene_body *tool, const scene_jaw_query *m,
                             const scene_strand_candidate *found);

/* ---- grasp_needle.c */

/* Finds the needle between the open jaws of a tool that is nearest to their middle. Returns
 * false if there is none; found->needle is 0 then. */
bool vbss_scene_find_needle_in_jaws(const scene_object *s, const scene_body *tool,
                                    scene_needle_grasp *found);

/* Grasps a needle that was found between the jaws, and adds the event. */
void vbss_scene_grasp_needle(scene_object *s, scene_body *tool, const scene_needle_grasp *found);

/* Releases the needle that a tool grasps if its handle opens the jaws beyond it. */
void vbss_scene_release_needle_grasp(scene_object *s, scene_body *tool);

/* After a step of length h: lets grasped needles slide, turn or be torn out, and removes the
 * grasps of released needles that are clear of the jaws. */
void vbss_scene_update_needle_grasps(scene_object *s, double h);

/* Removes all grasps of a needle, or of a tool, given by its number. */
void vbss_scene_remove_needle_grasps_of(scene_object *s, uint32_t number);

/* Adds an event of this kind of the needle in the jaws of a tool. */
void vbss_scene_emit_needle_grasp_event(scene_object *s, vbss_scene_event_kind kind,
                                        const scene_body *tool);

/* Describes a needle's grasp for hosts, in all fields but the size. */
void vbss_scene_describe_needle_grasp(const scene_object *s, const scene_body *tool,
                                      vbss_scene_grasp *grasp);

/* Whether a capsule of a needle lies so near to a tool's grasp, along the arc, that it is
 * excluded from contact with a capsule of the tool, which must be a jaw. `segment` is the
 * needle's capsule. */
bool vbss_scene_is_needle_in_grasp(const scene_object *s, const scene_body *needle,
                                   uint32_t segment, const scene_body *tool, uint32_t capsule);

/* Returns corner `k` of the clamp that holds a needle, 0 to GRASPER_NEEDLE_POINTS - 1, for poses
 * of the principal frames of both bodies. */
scene_clamp_corner vbss_scene_clamp_corner(const scene_rigid *needle, pose needle_principal,
                                           const scene_rigid *tool, pose tool_principal,
                                           uint32_t k);

/* ---- grasp_wall.c */

/* Finds a wall between the open jaws of a tool. Returns false if there is none; found->drain is 0
 * then. */
bool vbss_scene_find_wall_in_jaws(const scene_object *s, const scene_body *tool,
                                  scene_wall_grasp *found);

/* Grasps a wall that was found between the jaws, and adds the event. */
void vbss_scene_grasp_wall(scene_object *s, scene_body *tool, const scene_wall_grasp *found);

/* Releases the wall that a tool grasps if its handle opens the jaws beyond it. */
void vbss_scene_release_wall_grasp(scene_object *s, scene_body *tool);

/* After a step of length h: lets grasped walls slide or be torn out, and removes the grasps of
 * released walls that are clear of the jaws. */
void vbss_scene_update_wall_grasps(scene_object *s, double h);

/* Removes all grasps of a drain, or of a tool, given by its number. */
void vbss_scene_remove_wall_grasps_of(scene_object *s, uint32_t number);

/* Describes a wall's grasp for hosts, in all fields but size and arc length. */
void vbss_scene_describe_wall_grasp(const scene_object *s, const scene_body *tool,
                                    vbss_scene_grasp *grasp);

/* Whether a point of a wall lies so near to a tool's grasp that it is excluded from contact with a
 * capsule of the tool, which must be a jaw. */
bool vbss_scene_is_wall_in_grasp(const scene_object *s, const scene_body *drain, vec3 point,
                                 const scene_body *tool, uint32_t capsule);

/* Returns point `k` of a wall grasp, 0 to point_count - 1, on the drain whose nodes are at `x`. */
vec3 vbss_scene_wall_grasp_point(const scene_wall_grasp *p, const drain_object *d, const vec3 *x,
                                 uint32_t k);

/* Returns the stiffness of one point of a wall grasp, N/m. The points share that of the clamp. */
double vbss_scene_wall_grasp_stiffness(const grasper_object *g, const scene_wall_grasp *p);

/* ---- shears.c */

/* Excludes a strand that shears cannot cut from contact with them, until the blades open beyond
 * `angle`. Returns false if the strand can be cut, or if the list of grasps is full. If only
 * a spare piece is missing, adds the event of a cut without a piece. */
bool vbss_scene_exclude_uncuttable(scene_object *s, uint32_t tool, const scene_strand *at,
                                   double angle);

/* Schedules a cut for the end of the step. Beyond SCENE_MAX_CUTS the strand is left to the next
 * step. */
void vbss_scene_schedule_cut(scene_object *s, const scene_strand *at);

/* Whether a cut at this arc length would be less than the thread's diameter from an end, or
 * would leave too short a segment. Shears make no such cut, nor cut the new ends between their
 * blades again. */
bool vbss_scene_is_at_thread_end(const thread_object *t, double arc);

/* ---- jaws.c */

/* Sets the trial positions of all capsules in the frames of their bodies. Each covers the
 * fraction of its remaining path that the substep has of the remaining step. */
void vbss_scene_set_capsule_trials(scene_object *s, const scene_substep *substep);

/* Returns the jaw angle of a tool at the end of a step of length h, rad. Objects between closing
 * jaws stop them; the jaws then grasp these objects, and shears schedule cuts. */
double vbss_scene_close_jaws(scene_object *s, scene_body *tool, double h);

/* Sets the positions of a grasper's capsules at the end of the step, and their radii, for a jaw
 * angle in rad. */
void vbss_scene_set_capsule_targets(scene_object *s, const scene_rigid *r, double angle);

/* ---- tool_targets.c */

/* Before a step of length h: exchanges instruments, sets target poses and jaw angles, and makes and
 * releases grasps. */
void vbss_scene_apply_tool_targets(scene_object *s, double h);

/* Sets the targets of pinned nodes if a grasper carries one of them (baseline method only). */
void vbss_scene_move_jaws(scene_object *s, scene_body *tool, double h);

/* ---- publish_tools.c */

/* Publishes poses, forces and grasps of all graspers, and poses of all needles, for hosts. */
void vbss_scene_publish_tools(scene_object *s);

/* Publishes the pose and velocity of a needle for hosts. */
void vbss_scene_publish_needle(const scene_body *b);

/* Publishes pose, velocity, hand force and grasps of a grasper for hosts. */
void vbss_scene_publish_grasper(scene_object *s, scene_body *b);

/* ---- section_holders.c */

/* Before a step of `h` seconds: lets pins on rigid bodies and grasps hold the sections of threads with twist, rolls these
 * with their bodies, and loads the bodies with their torques. */
void vbss_scene_hold_sections(scene_object *s, double h);

/* Adds the torques of sections to those of contacts and pins on rigid bodies. */
void vbss_scene_add_section_torques(scene_object *s);

#endif
