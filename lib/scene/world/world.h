/* The bodies of a scene: look-up by number, poses, features, points of walls, pins, targets, events
 * and the work budget. */
#ifndef VBSS_SCENE_WORLD_H
#define VBSS_SCENE_WORLD_H

#include "scene/tuning.h"
#include "scene/world/host_surface.h"
#include "scene/world/scene_data.h"

/* Number of arrays that a scene allocates for each drain. */
enum { SCENE_DRAIN_ARRAYS = 6 };

/* A material point of a drain's wall, in the middle of its thickness. */
typedef struct scene_wall_point {
    vec3 now, rest; /* position at `time`, and in the undeformed drain, m */
    double time;    /* 0 to 1 within the substep; 0: its start */
} scene_wall_point;

/* Whether feature a of contacts of this kind is a point: a node of a thread or drain, or an end
 * of a capsule. */
static inline bool scene_is_node_contact(uint32_t kind)
{
    return kind == VBSS_SCENE_CONTACT_NODE_CAPSULE || kind == VBSS_SCENE_CONTACT_NODE_FLOOR ||
           kind == VBSS_SCENE_CONTACT_POINT_FACE;
}

/* Whether feature b of contacts of this kind is a triangle or a side of a drain or static mesh. */
static inline bool scene_is_surface_contact(uint32_t kind)
{
    return kind == VBSS_SCENE_CONTACT_POINT_FACE || kind == VBSS_SCENE_CONTACT_SIDES;
}

/* Whether feature a of contacts of this kind is a line: a segment, a capsule or a side. */
static inline bool scene_is_segment_contact(uint32_t kind)
{
    return kind == VBSS_SCENE_CONTACT_SEGMENTS || kind == VBSS_SCENE_CONTACT_SEGMENT_CAPSULE ||
           kind == VBSS_SCENE_CONTACT_SIDES;
}

/* The kind of a body that takes part in the present substep; SCENE_BODY_NONE if it is frozen. */
static inline scene_body_kind scene_active_kind(const scene_body *b)
{
    return b->is_frozen ? SCENE_BODY_NONE : b->kind;
}

/* Whether a body takes part in the present substep. The floor (NULL) does not. */
static inline bool scene_is_active(const scene_body *b)
{
    return b != NULL && !b->is_frozen;
}

/* Whether the motion of a body in this substep is known: it is frozen, driven, or the world. */
static inline bool scene_is_prescribed(const scene_body *b)
{
    return b == NULL || b->is_frozen ||
           (b->kind == SCENE_BODY_RIGID && b->rigid.kind == VBSS_SCENE_RIGID_DRIVEN);
}

/* Whether a body is a static mesh. The floor (NULL) is not. */
static inline bool scene_is_static_mesh(const scene_body *b)
{
    return b != NULL && b->kind == SCENE_BODY_RIGID && b->rigid.is_static_mesh;
}

/* Whether a body is a rigid body whose shape is a mesh. The floor (NULL) is not. */
static inline bool scene_is_rigid_mesh(const scene_body *b)
{
    return b != NULL && b->kind == SCENE_BODY_RIGID && b->rigid.is_rigid_mesh;
}

/* Whether a body is a plane that the host added. The floor (NULL) is not. */
static inline bool scene_is_plane(const scene_body *b)
{
    return b != NULL && b->kind == SCENE_BODY_RIGID && b->rigid.is_plane;
}

/* The plane of a body, or that of the floor (NULL). */
static inline scene_plane scene_plane_of(const scene_object *s, const scene_body *b)
{
    return b != NULL ? b->rigid.plane : (scene_plane){s->floor_normal, s->config.floor_height};
}

/* Height of a point over a plane, m. */
static inline double scene_height_over(scene_plane plane, vec3 point)
{
    return vec3_dot(plane.normal, point) - plane.height;
}

/* The motion of a host surface; NULL for any other body, and for the floor (NULL). */
static inline scene_host_surface *scene_host_surface_of(const scene_body *b)
{
    return b != NULL && b->kind == SCENE_BODY_RIGID ? b->rigid.surface : NULL;
}

/* Whether a body is a static mesh, a rigid mesh or a host surface. The floor (NULL) is none. */
static inline bool scene_is_mesh(const scene_body *b)
{
    return scene_is_static_mesh(b) || scene_is_rigid_mesh(b) || scene_host_surface_of(b) != NULL;
}

/* Whether a body is a surface of triangles: a drain, or a mesh as above. */
static inline bool scene_has_triangles(const scene_body *b)
{
    return b != NULL && (b->kind == SCENE_BODY_DRAIN || scene_is_mesh(b));
}

/* Whether a body is a needle. */
static inline bool scene_is_needle(const scene_body *b)
{
    return b != NULL && b->kind == SCENE_BODY_RIGID && b->rigid.needle != NULL;
}

/* Whether a body can have holes: a drain or host surface. The floor (NULL) cannot. */
static inline bool scene_is_wall(const scene_body *b)
{
    return b != NULL && (b->kind == SCENE_BODY_DRAIN || scene_host_surface_of(b) != NULL);
}

/* Whether tips of needles enter a wall by force. */
static inline bool scene_is_pierceable(const scene_body *b)
{
    return b->kind == SCENE_BODY_DRAIN ||
           (scene_host_surface_of(b) != NULL && b->rigid.surface->law.puncture_force > 0.0);
}

/* Vertices of a mesh at one moment. */
typedef struct scene_vertices {
    const vec3 *x;  /* m */
    const pose *at; /* pose of their frame; NULL: they are in the world */
} scene_vertices;

static inline vec3 scene_vertex(scene_vertices v, uint32_t index)
{
    return v.at == NULL ? v.x[index] : pose_apply(*v.at, v.x[index]);
}

/* Vertices of a mesh now: at the start of the substep. */
static inline scene_vertices scene_mesh_vertices(const scene_object *s, const scene_body *mesh)
{
    const scene_host_surface *h = mesh->rigid.surface;
    const collision_shape *shape = s->collision->shapes[mesh->shape];
    if (mesh->rigid.is_rigid_mesh) {
        return (scene_vertices){shape->posed->local, &mesh->rigid.body.now.pose};
    }
    return (scene_vertices){h != NULL ? h->now : shape->start, NULL};
}

/* The same at the end of the substep. */
static inline scene_vertices scene_mesh_trial_vertices(const scene_object *s,
                                                       const scene_body *mesh)
{
    const scene_host_surface *h = mesh->rigid.surface;
    const collision_shape *shape = s->collision->shapes[mesh->shape];
    if (mesh->rigid.is_rigid_mesh) {
        return (scene_vertices){shape->posed->local, &mesh->rigid.trial};
    }
    return (scene_vertices){h != NULL ? h->trial : shape->start, NULL};
}

/* Whether an entry of the list of thread grasps holds its strand. Other entries are unused, or
 * exclude a strand from contact with the jaws. */
static inline bool scene_holds_strand(const scene_thread_grasp *g)
{
    return g->id != 0 && !g->is_released && !g->is_uncuttable;
}

/* The geometry of one of the scene's contact constraints. */
static inline scene_contact_geometry *scene_geometry_of(const scene_object *s,
                                                        const contact_constraint *constraint)
{
    return &s->step.contact_geometries[constraint->geometry];
}

/* The handle of the scene's collision object, for functions of the public interface. */
static inline vbss_collision *scene_collision(scene_object *s)
{
    return (vbss_collision *)&s->collision_slot;
}

/* ---- body_lookup.c */

/* Finds the body with a number, of any kind. VBSS_ERROR_NOT_FOUND if there is none. */
vbss_result vbss_scene_require_any_body(const scene_object *s, uint32_t number, scene_body **body);

/* Finds the body with a number and a kind. VBSS_ERROR_NOT_FOUND if there is no body with the
 * number, VBSS_ERROR_INCOMPATIBLE if it is of another kind. */
vbss_result vbss_scene_require_body(const scene_object *s, uint32_t number, scene_body_kind kind,
                                    scene_body **body);

/* Returns the body with a number, of any kind, or NULL. Sets no error. */
scene_body *vbss_scene_body(const scene_object *s, uint32_t number);

/* Gives a body its number, 1 to SCENE_MAX_SHAPES, and enters it in the table of numbers. */
void vbss_scene_set_body_number(scene_object *s, scene_body *b, uint32_t number);

/* Whether the scene has a body of this kind. */
bool vbss_scene_has_body_kind(const scene_object *s, scene_body_kind kind);

/* Slot of the handle of a body; NULL if it has none. */
vbss_slot *vbss_scene_slot_of_body(const scene_body *b);

/* Finds a free entry for a body of this kind. VBSS_ERROR_CAPACITY if the scene has as many as its
 * configuration allows, pieces of threads that may yet be cut included. */
vbss_result vbss_scene_find_free_body(scene_object *s, scene_body_kind kind, scene_body **body);

/* Makes the entry `b` a body of this kind with a new number, which is stored in `number` as well.
 * `shape` is its shape in the collision object. */
void vbss_scene_register_body(scene_object *s, scene_body *b, scene_body_kind kind, uint32_t shape,
                              uint32_t *number);

/* Numbers the nodes of all threads consecutively, in the order of the bodies: sets first_node of
 * each thread and node_count of the scene. */
void vbss_scene_number_nodes(scene_object *s);

/* ---- body_kinematics.c */

/* Computes the ends of a capsule's axis in the world for a pose of its body's principal frame. */
void vbss_scene_transform_capsule(const scene_capsule *capsule, pose at, vec3 axis[2]);

/* Sets the trial ends of a capsule's axis for a trial pose of its body's principal frame. */
void vbss_scene_transform_trial_capsule(scene_capsule *capsule, pose at);

/* Moves a capsule within its body's frame to its position at the end of the step. */
void vbss_scene_snap_capsule_to_target(scene_capsule *capsule);

/* Returns the pose of a needle that hosts see, from the pose of its principal frame. */
pose vbss_scene_needle_frame(const scene_rigid *r, pose principal);

/* Returns the pose of a grasper's jaws in the world, from the pose of its principal frame. */
pose vbss_scene_jaw_frame(const scene_rigid *r, pose principal);

/* ---- features.c */

/* Lists the nodes of a feature of a drain or static mesh and returns their number, 1 to 3. The
 * feature is on side b of a contact of this kind if is_b, otherwise on side a. */
uint32_t vbss_scene_surface_feature_nodes(const scene_object *s, const scene_body *surface,
                                          uint32_t kind, bool is_b, uint32_t feature,
                                          uint32_t nodes[3]);

/* Whether the body is a thread or a needle. */
bool vbss_scene_is_suture(const scene_body *b);

/* Returns the arc length of a point, m. It begins at the first node of a thread, at rest, or at the
 * tip of a needle. `segment` is a segment of the thread or a capsule of the needle; `fraction` is
 * the position on it, 0 to 1. */
double vbss_scene_suture_arc_length(const scene_body *suture, uint32_t segment, double fraction);

/* Whether a point at this arc length, m from the tip, belongs to the tip of the needle. */
bool vbss_scene_is_at_tip(const scene_body *needle, double arc);

/* Finds the ends of a segment of a thread, of the axis of a capsule, or of a side of a drain, at
 * the start of the substep. `number` is the body number. Returns false if there is no such body. */
bool vbss_scene_feature_segment(const scene_object *s, uint32_t number, uint32_t feature,
                                vec3 axis[2]);

/* ---- wall_point.c */

/* The wall of a drain or host surface, in which holes are. A host surface has no shape at rest: it is that of
 * now. */
suture_wall vbss_scene_wall_of(const scene_body *b);

/* Returns a point in a triangle of a drain at the start of the substep. `weights` are its
 * barycentric coordinates. */
scene_wall_point vbss_scene_wall_point(const scene_body *wall_body, uint32_t triangle,
                                       const double weights[3]);

/* Returns a point on a side of a drain at the start of the substep. `fraction` is the position
 * between its two nodes, 0 to 1. */
scene_wall_point vbss_scene_wall_point_on_edge(const scene_body *wall_body, const uint32_t node[2],
                                               double fraction);

/* Returns a point in a triangle of a drain at a time within the substep, 0 to 1. `weights` are its
 * barycentric coordinates. The nodes move along straight lines to the trial state. */
scene_wall_point vbss_scene_wall_point_at_time(const scene_body *wall_body, uint32_t triangle,
                                               const double weights[3], double time);

/* Returns a point on a side of a drain at a time within the substep, 0 to 1. `fraction` is the
 * position between its two nodes, 0 to 1. The nodes move along straight lines to the trial
 * state. */
scene_wall_point vbss_scene_wall_point_on_edge_at_time(const scene_body *wall_body,
                                                       const uint32_t node[2], double fraction,
                                                       double time);

/* ---- pins.c */

/* Pins a node of a thread to a body where the node is now. Stores the id in `pin`. Errors are those
 * of vbss_scene_pin_node. */
void vbss_scene_remove_pins_of(scene_object *s, uint32_t number);

/* Whether a pin still constrains its node. It does not if the host has detached its attachment. */
bool vbss_scene_pin_holds(const scene_object *s, const scene_pin *pin);

/* Returns the weld of a thread's node, or NULL. */
const scene_pin *vbss_scene_find_weld(const scene_object *s, uint32_t thread, uint32_t node);

/* Sets the targets of all pinned nodes that are attachments to where their bodies will be at the
 * end of the step. */
void vbss_scene_set_pin_targets(scene_object *s);

/* Copies the targets of all pinned nodes that are attachments to the checkpoint. */
void vbss_scene_checkpoint_pin_targets(scene_object *s);

/* Restores these targets from the checkpoint. */
void vbss_scene_rollback_pin_targets(scene_object *s);

/* Pins a node to a body (number; 0: the world). `point` is in the frame of the body that hosts see;
 * NULL: where the node is. Checks all arguments and sets the error text; on failure nothing
 * changes. */
vbss_result vbss_scene_pin_node(scene_object *s, uint32_t thread, uint32_t node, uint32_t body,
                                const double *point, uint32_t *pin);

/* Checks the arguments of vbss_scene_pin_node, and that there is room for another pin. */
vbss_result vbss_scene_check_pin(const scene_object *s, uint32_t thread, uint32_t node,
                                 uint32_t body, const double *point);

/* Whether the scene has a pin with this id. */
bool vbss_scene_has_pin(const scene_object *s, uint32_t pin);

/* Removes a pin by its id. Returns false if there is no such pin. */
bool vbss_scene_unpin_node(scene_object *s, uint32_t pin);

/* ---- targets.c */

/* Sets the target pose of a rigid body, in its principal frame, for the end of the next step.
 * While a step is suspended, the target stays pending until the next step begins. */
void vbss_scene_set_tool_target(scene_object *s, scene_rigid *r, pose target);

/* Makes all pending targets the targets of the step, together with those of pinned nodes. */
void vbss_scene_apply_rigid_targets(scene_object *s);

/* Makes the forces and torques that wait for the next step those of the step that begins. */
void vbss_scene_apply_loads(scene_object *s);

/* Moves the target at the end of a step of length h, s, towards that at its start, so that no point
 * of the body is asked to move faster than speed_limit. Returns whether it moved. A method that
 * drives tools has no limit. */
bool vbss_scene_limit_target(const scene_object *s, scene_rigid *r, double h);

/* Limits the targets of all bodies except graspers, whose targets the host sets in each step. The rest of
 * a motion stays pending for the next step. */
void vbss_scene_limit_rigid_targets(scene_object *s, double h);

/* ---- events.c */

/* Kinds of events in logs that hosts get in another form: a step was truncated or paused, with the lost
 * share of the step in 65536ths; events exceeded the capacity, with their number. Chosen with the format
 * of logs: VBSS_RECORD_EVENT_TIME_LOST and VBSS_RECORD_EVENT_LOST. */
enum { SCENE_LOGGED_TIME_LOST = 3, SCENE_LOGGED_LOST = 4 };

/* Adds an event of the present step, or of an edit. `logged_number` is the last of its four words in
 * logs: the id, the arc length in um, or the lost share of the step in 65536ths. An event beyond
 * config.event_capacity is counted as lost. */
void vbss_scene_add_event(scene_object *s, const vbss_scene_event *event, uint32_t logged_number);

/* Adds an event with a position. */
void vbss_scene_add_event_at(scene_object *s, vbss_scene_event *event, vec3 position,
                             uint32_t logged_number);

/* Adds VBSS_SCENE_EVENT_CUT at an arc length of a thread, m from its first node. `piece` is the body that
 * was cut off; NULL: the thread was not cut, as no piece was left. */
void vbss_scene_emit_cut_event(scene_object *s, const scene_body *thread, const scene_body *piece,
                               double arc_length, vec3 position);

/* Moves the events of the present step, from index `from` on, to the list that hosts take from. `h` is
 * the length of the call of vbss_scene_step that has not been counted yet, s; 0: between two calls. */
void vbss_scene_publish_events(scene_object *s, uint32_t from, double h);

/* Takes the oldest event out of the list that hosts take from. Returns false if there is none. */
bool vbss_scene_take_event(scene_object *s, vbss_scene_event *event);

/* Clears the events that the last call has for the log. */
void vbss_scene_clear_logged_events(scene_object *s);

/* If events for the log were lost, replaces the last one by SCENE_LOGGED_LOST with their number. */
void vbss_scene_log_lost_events(scene_object *s);

/* ---- filters.c */

/* Settings of the scene as it was created. */
scene_settings vbss_scene_created_settings(const scene_object *s);

/* The filter of a new body, which collides with all others: category bit 0, every bit of the
 * mask. */
scene_filter vbss_scene_default_filter(void);

/* The filter of a body; NULL: that of the floor. */
const scene_filter *vbss_scene_filter_of(const scene_object *s, const scene_body *b);

/* Whether two bodies collide according to their filters. NULL: the floor. A body always collides
 * with itself. */
bool vbss_scene_do_collide(const scene_object *s, const scene_body *a, const scene_body *b);

/* Removes the candidate pairs of bodies that do not collide. The order of the others stays. */
void vbss_scene_filter_candidates(scene_object *s);

/* ---- driven_overlaps.c */

/* Lists the driven bodies that a new driven body overlaps. At most SCENE_MAX_OVERLAPS are listed;
 * others hold each other back. */
void vbss_scene_list_overlaps_of(scene_object *s, const scene_body *b);

/* Removes pairs that have come apart, or that no longer exist, from the list. */
void vbss_scene_drop_ended_overlaps(scene_object *s);

/* Whether two bodies are a pair of the list. */
bool vbss_scene_is_overlap(const scene_object *s, const scene_body *a, const scene_body *b);

/* ---- blockers.c */

/* Records that two bodies (numbers; 0: unknown, or the floor) hold back their island for `lost_time`,
 * s. The first record of a pair emits an event and logs a warning. */
void vbss_scene_record_blocker(scene_object *s, vbss_scene_blocker_cause cause,
                               scene_touching_pair bodies, double lost_time);

/* Ends blockers whose bodies have moved freely for a while; emits an event for each. */
void vbss_scene_end_blockers(scene_object *s);

/* ---- work_budget.c */

/* Operations of a budget, us, on a core that does `operations_per_us`: the nearest integer, a number of 32
 * bits if both are valid (api/solver_options.c). */
double vbss_scene_count_operations(double budget_us, double operations_per_us);

/* Estimates the operations of an attempt before its first linearisation, from the candidates of the
 * last attempt. */
uint32_t vbss_scene_attempt_cost(const scene_object *s);

/* Whether the attempts of this step have an operation budget. Those of the first step of a scene have
 * none, because bodies may overlap as the host has placed them. */
bool vbss_scene_has_step_budget(const scene_object *s);
/* Whether steps have a budget: the mode is real time, and the host has not turned it off. */
bool vbss_scene_limits_steps(const scene_object *s);

/* Whether a step with this number of operations and attempts has reached its limits, between two
 * attempts. The limits of the first step are larger. */
bool vbss_scene_is_beyond_step_limits(const scene_object *s, uint64_t operations,
                                      uint32_t attempts);

/* Counts operations of the present step. An operation costs about as much as a product of two
 * blocks. */
void vbss_scene_charge_budget(scene_object *s, uint32_t operations);

/* Whether the operation budget of the step is exhausted. */
bool vbss_scene_is_over_budget(const scene_object *s);

/* ---- disown_body.c */

/* Gives the handle of a thread back to the host. The body entry stays as it is. */
void vbss_scene_disown_thread(scene_body *body);

/* Gives the handle of a drain back to the host and releases the scene's arrays for it. */
void vbss_scene_disown_drain(scene_object *s, scene_body *b);

/* Gives the handle of a grasper back to the host. The body entry stays as it is. */
void vbss_scene_disown_grasper(scene_body *b);

/* Gives the handle of a needle back to the host. The body entry stays as it is. */
void vbss_scene_disown_needle(scene_body *b);

/* ---- static_mesh.c */

/* Allocates the arrays of a static mesh, lists the triangles at each vertex and edge, and refuses a one-sided mesh
 * whose triangles are not wound alike. After an error nothing is allocated. */
vbss_result vbss_scene_create_static_mesh(scene_object *s, scene_static_mesh *m,
                                          const collision_shape *shape);

/* Releases what that has allocated. `shape`: of the mesh. */
void vbss_scene_release_mesh_arrays(scene_object *s, scene_static_mesh *m,
                                    const collision_shape *shape);

/* Releases the scene's memory for a static mesh or host surface; for other bodies it does nothing. */
void vbss_scene_release_static_mesh(scene_object *s, scene_body *b);

/* Lists the arrays of a scene for a drain with this number of nodes, to allocate or release
 * them. */
void vbss_scene_list_drain_arrays(scene_drain *b, uint32_t nodes,
                                  vbss_array arrays[SCENE_DRAIN_ARRAYS]);

#endif
