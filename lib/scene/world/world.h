/* The bodies of a scene: look-up by number, poses and features, points of walls, pins, targets,
 * events, the work budget. */
#ifndef VBSS_SCENE_WORLD_H
#define VBSS_SCENE_WORLD_H

#include "scene/world/scene_data.h"

/* A tip touches within so many radii of the wire from its end. */
#define SCENE_TIP_LENGTH_RATIO 1.0

/* Arrays that a scene allocates for a drain. */
enum { SCENE_DRAIN_ARRAYS = 6 };

/* A point of a drain's wall, now and at rest. */
typedef struct scene_wall_point {
    vec3 now, rest;
    double time; /* of the part: 0, its begin */
} scene_wall_point;

/* Contacts whose feature a, if it is of a thread, is a node; a segment. */
static inline bool scene_is_node_contact(uint32_t kind)
{
    return kind == VBSS_CONTACT_NODE_CAPSULE || kind == VBSS_CONTACT_NODE_FLOOR ||
           kind == VBSS_CONTACT_POINT_FACE;
}

static inline bool scene_is_surface_contact(uint32_t kind)
{
    return kind == VBSS_CONTACT_POINT_FACE || kind == VBSS_CONTACT_SIDES;
}

static inline bool scene_is_segment_contact(uint32_t kind)
{
    return kind == VBSS_CONTACT_SEGMENTS || kind == VBSS_CONTACT_SEGMENT_CAPSULE ||
           kind == VBSS_CONTACT_SIDES;
}

/* The scene's own collision object, by its handle. */
static inline vbss_collision *scene_collision(scene_object *s)
{
    return (vbss_collision *)&s->collision_slot;
}

/* ---- body_lookup.c */

/* The living body of a number; NULL and VBSS_ERROR_OUT_OF_RANGE, told. The thread of a number; the
 * rigid body. */
scene_body *vbss_scene_require_body(const scene_object *s, uint32_t number, scene_body_kind kind);

/* The same, untold. */
scene_body *vbss_scene_body(const scene_object *s, uint32_t number);

/* Whether there is one of that kind. */
bool vbss_scene_has_body_kind(const scene_object *s, scene_body_kind kind);

/* A place for one more body of that kind, or NULL, told; which then gets its number. */
scene_body *vbss_scene_find_free_body(scene_object *s, scene_body_kind kind);
void vbss_scene_register_body(scene_object *s, scene_body *b, scene_body_kind kind, uint32_t shape,
                              uint32_t *number);

/* Nodes of threads stand one behind the other in the order of their places. */
void vbss_scene_number_nodes(scene_object *s);

/* ---- body_kinematics.c */

/* Where the axis of a capsule is when its body is there; and at the end of the part. */
void vbss_scene_transform_capsule(const scene_capsule *capsule, pose at, vec3 axis[2]);
void vbss_scene_transform_trial_capsule(scene_capsule *capsule, pose at);

/* Moves a capsule to its position at the end of the step, in the frame of its body. */
void vbss_scene_snap_capsule_to_target(scene_capsule *capsule);

/* The frame of a needle that hosts see, from the pose of its principal axes. */
pose vbss_scene_needle_frame(const scene_rigid *r, pose principal);

/* The frame of a grasper's jaws in the world, from the pose of its principal axes. */
pose vbss_scene_jaw_frame(const scene_rigid *r, pose principal);

/* ---- features.c */

/* Nodes of a feature of a drain; returns how many. */
uint32_t vbss_scene_drain_feature_nodes(const scene_object *s, const scene_body *drain,
                                        uint32_t kind, bool is_b, uint32_t feature,
                                        uint32_t nodes[3]);

/* Whether the body is a thread or a needle. */
bool vbss_scene_is_suture(const scene_body *b);

/* The arc length of a place on a segment of a thread or a capsule of a needle; whether that is its tip. */
double vbss_scene_suture_arc_length(const scene_body *suture, uint32_t segment, double fraction);
bool vbss_scene_is_at_tip(const scene_body *needle, double arc);

/* Where a segment of a thread, the axis of a capsule or a side of a drain is; false: there is no such body. */
bool vbss_scene_feature_segment(const scene_object *s, uint32_t number, uint32_t feature,
                                vec3 axis[2]);

/* ---- wall_point.c */

/* A point of a drain's wall, at the start of the substep: in a triangle, by the weights of its
 * corners. */
scene_wall_point vbss_scene_wall_point(const scene_body *drain, uint32_t triangle,
                                       const double weights[3]);

/* A point of a drain's wall, at the start of the substep: on a side, by a fraction 0..1 from its
 * first node. */
scene_wall_point vbss_scene_wall_point_on_edge(const scene_body *drain, const uint32_t node[2],
                                               double fraction);

/* The same point of a triangle at a time 0..1 within the substep. */
scene_wall_point vbss_scene_wall_point_at_time(const scene_body *drain, uint32_t triangle,
                                               const double weights[3], double time);

/* The same point of a side at a time 0..1 within the substep. */
scene_wall_point vbss_scene_wall_point_on_edge_at_time(const scene_body *drain,
                                                       const uint32_t node[2], double fraction,
                                                       double time);

/* ---- pins.c */

/* Pins a node where it is, within a step. */
vbss_result vbss_scene_pin_in_step(scene_object *s, uint32_t thread, uint32_t node, uint32_t body,
                                   uint32_t *pin);
void vbss_scene_unpin_in_step(scene_object *s, uint32_t pin);
void vbss_scene_remove_pins_of(scene_object *s, uint32_t number);

/* Whether it still holds its node: the host may have detached the attachment. */
bool vbss_scene_pin_holds(const scene_object *s, const scene_pin *pin);

/* The weld of a node, or NULL. */
const scene_pin *vbss_scene_find_weld(const scene_object *s, uint32_t thread, uint32_t node);

/* Attached nodes shall be where their driven bodies will be. */
void vbss_scene_set_pin_targets(scene_object *s);

/* Pins a node to a body (number; 0: the world). `point`: in the frame of the body that hosts see,
 * NULL: where the node is. Checks all arguments and sets the error text; on failure nothing
 * changes. */
vbss_result vbss_scene_pin_node(scene_object *s, uint32_t thread, uint32_t node, uint32_t body,
                                const double *point, uint32_t *pin);

/* False: there is no such pin. */
bool vbss_scene_unpin_node(scene_object *s, uint32_t pin);

/* ---- targets.c */

/* Where a rigid body, its principal frame, shall be after the next step; while a step waits that is kept until the next begins. */
void vbss_scene_set_rigid_target(scene_object *s, scene_rigid *r, pose target);
void vbss_scene_apply_rigid_targets(scene_object *s);

/* ---- events.c */

/* Adds the event of a cut. `piece` NULL: the thread was not cut. */
void vbss_scene_emit_cut_event(scene_object *s, const scene_body *thread, const scene_body *piece,
                               double arc_length);

/* Clears the list of events. */
void vbss_scene_clear_events(scene_object *s);

/* Adds an event; where there is no room it is counted as lost. */
void vbss_scene_add_event(scene_object *s, vbss_event_kind kind, uint32_t a, uint32_t b,
                          uint32_t number);

/* Replaces the last event by one that says how many were lost, if any were. */
void vbss_scene_write_lost_event(scene_object *s);

/* ---- work_budget.c */

/* What an attempt costs before it is solved, as the last one did; whether steps have a limit of work. */
uint32_t vbss_scene_attempt_cost(const scene_object *s);
bool vbss_scene_has_step_budget(const scene_object *s);

/* Work that is done, in products of blocks; whether no more may be. */
void vbss_scene_charge_budget(scene_object *s, uint32_t operations);
bool vbss_scene_is_over_budget(const scene_object *s);

/* ---- disown_body.c */

/* The thread's handle is free again. */
void vbss_scene_disown_thread(scene_body *body);

/* The drain's handle is free again, and the scene's arrays for it are released. */
void vbss_scene_disown_drain(scene_object *s, scene_body *b);

/* The grasper's handle is free again. */
void vbss_scene_disown_grasper(scene_body *b);

/* The needle's handle is free again. */
void vbss_scene_disown_needle(scene_body *b);

/* The arrays that a scene allocates for a drain of so many nodes. */
void vbss_scene_list_drain_arrays(scene_drain *b, uint32_t nodes,
                                  vbss_array arrays[SCENE_DRAIN_ARRAYS]);

#endif
