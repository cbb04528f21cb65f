/* Contact constraints of a substep. Pipeline: motion bounds -> broad phase -> narrow phase ->
 * contacts, constraints of grasps and holes -> duplicates removed -> warm start. */
#ifndef VBSS_SCENE_CONTACTS_H
#define VBSS_SCENE_CONTACTS_H

#include "scene/tuning.h"
#include "scene/world/world.h"

/* Radius of one feature of a candidate pair, m. Lips are thinner than this against another wall. */
static inline double scene_feature_radius(const scene_object *s, const collision_candidate *q,
                                          bool is_b)
{
    const uint32_t shape = is_b ? q->shape_b : q->shape_a, feature = is_b ? q->b : q->a;
    const scene_body *b = &s->bodies[s->body_of_shape[shape]];
    if (b->kind == SCENE_BODY_RIGID && !scene_is_mesh(b)) {
        bool is_point = q->kind == VBSS_COLLISION_PAIR_POINT_TRIANGLE; /* a capsule end */
        return s->capsules[b->rigid.first_capsule + (is_point ? feature / 2 : feature)].radius;
    }
    return b->kind == SCENE_BODY_THREAD ? b->thread.thread->config.radius
                                        : s->collision->shapes[shape]->radius;
}

/* Whether the surfaces of a candidate pair stay farther apart than `distance` (m) while their
 * vertices move from start to end. Uses the separation cache; false only means "not known". */
static inline bool scene_is_known_apart(const scene_object *s, const collision_candidate *q,
                                        double distance)
{
    distance += scene_feature_radius(s, q, false) + scene_feature_radius(s, q, true);
    return vbss_collision_stays_separated(s->collision, q, distance);
}

/* The same by measurement where the cache does not suffice, for decisions that change the state. */
static inline bool scene_stays_apart(const scene_object *s, const collision_candidate *q,
                                     double distance)
{
    distance += scene_feature_radius(s, q, false) + scene_feature_radius(s, q, true);
    return vbss_collision_is_separated(s->collision, q, distance);
}

/* An interval of a needle capsule's axis outside all holes, and the part of a drain's edge between
 * the planes across its two ends. An interval that is cut off at a hole has no rounded end that
 * could push the wall along the needle. */
typedef struct scene_axis_interval {
    bool started;   /* false before the first interval is found */
    double end_arc; /* arc length from the tip at which the interval ends, m */
    /* [0] on the capsule's axis, [1] on the drain's edge: start and end, as fractions 0..1 */
    double bounds[2][2];
} scene_axis_interval;

/* Shortens an axis to an interval of fractions 0..1. */
static inline void scene_clip_axis(vec3 axis[2], const double interval[2])
{
    vec3 start = axis[0];
    axis[0] = vec3_lerp(start, axis[1], interval[0]);
    axis[1] = vec3_lerp(start, axis[1], interval[1]);
}

/* A sphere that may touch a plane: a node, or the end of a capsule. */
typedef struct scene_sphere {
    const scene_body *body;
    vec3 x, displacement; /* centre, and its expected displacement, m */
    double radius;        /* m */
} scene_sphere;

/* Two features that may touch, and how far their vertices may move. b is NULL: the floor. */
typedef struct scene_contact_pair {
    const scene_body *a, *b;
    const vec3 *displacements_a, *displacements_b;
    uint32_t count_a, count_b;
    const collision_candidate *candidate; /* pair that the broad phase found, or NULL */
} scene_contact_pair;

/* ---- pin_exclusion.c */

/* Whether a thread segment is excluded from contact with a capsule of a rigid body. It is within
 * the exclusion arc of a pin on that body, or of a grasp if the capsule is a jaw.
 * `contact_distance` in m. */
bool vbss_scene_is_excluded_at_pin(const scene_object *s, const scene_body *thread,
                                   uint32_t segment, const scene_body *rigid, uint32_t capsule,
                                   double contact_distance);

/* ---- hole_exclusion.c */

/* Contact scale, 0..1: the fraction of the contact distance at which a point of a body touches a
 * point of a wall. It is 0 in a hole that the suture passes through and in jaws that grasp the
 * wall, and 1 away from both. If `is_point`, `feature` is a node or a capsule end; otherwise the
 * point is at `fraction` (0..1) of segment or capsule `feature`. `reach`: radius around a hole
 * within which a needle does not touch the wall, m. */
double vbss_scene_contact_scale_at(const scene_object *s, const scene_body *body, bool is_point,
                                   uint32_t feature, double fraction, const scene_body *wall_body,
                                   const scene_wall_point *wall_point, double reach);

/* Contact scale of a contact constraint, 0..1, at its closest points. 1 unless feature b belongs to
 * a drain or host surface and feature a does not. */
double vbss_scene_contact_scale_of(const scene_object *s, const contact_constraint *constraint);

/* Finds the next interval of a needle capsule's axis outside all holes of a wall, and the
 * part of the wall's edge beside it. `reach`: radius around a hole within which the needle
 * does not touch the wall, m. Start with `interval->started` false. Returns false if there is
 * no further interval. */
bool vbss_scene_next_axis_interval(const scene_object *s, const scene_body *needle,
                                   uint32_t capsule, const scene_body *wall_body, uint32_t edge,
                                   double reach, scene_axis_interval *interval);

/* ---- mesh_contacts.c */

/* Whether one feature of a pair belongs to a one-sided mesh, and the other feature is behind it at
 * the start of the substep. Such a pair does not collide. */
bool vbss_scene_is_behind_mesh(const scene_object *s, const collision_candidate *q);

/* Normal of a contact with the edge of a mesh whose vertices are at `x`. `separation`: from the point at fraction
 * `at` of the edge to the closest point of the other body. If that body is over a triangle beside the edge, and not below its
 * plane, the triangle's normal, otherwise the direction of the separation; zero if there is none. */
vec3 vbss_scene_mesh_normal(const scene_object *s, const scene_body *mesh, scene_vertices x,
                            uint32_t edge, double at, double contact_distance, vec3 separation);

/* ---- motion_bounds.c */

/* Sets the expected displacement of every node and capsule end in the substep, m. It is
 * extrapolated from velocities and targets, or taken from the rejected attempt if
 * `substep->uses_trial_motion`. Also sets the positions of capsules at the start of the substep. */
void vbss_scene_set_motion_bounds(scene_object *s, const scene_substep *substep);

/* Sets them to zero for all bodies, as if nothing moved. */
void vbss_scene_set_bounds_at_rest(scene_object *s);

/* ---- broad_phase.c */

/* Lists all pairs of features that collide and whose swept boxes overlap, for shapes that have been moved already.
 * Pairs of two edges come first; their number goes to `edge_pair_count`. Fails if the list of
 * candidates is full. */
vbss_result vbss_scene_run_broad_phase(scene_object *s);

/* Sweeps all collision shapes along their expected displacements, then runs the broad phase. Fails
 * if the list of candidates is full. */
vbss_result vbss_scene_find_candidates(scene_object *s);

/* ---- jacobian.c */

/* Adds the Jacobian of a thread node: one translation block, or the blocks of the rigid body that
 * the node is welded to. `weight` is signed: positive on side a, negative on side b. */
void vbss_scene_add_node_jacobian(const scene_object *s, contact_constraint *constraint,
                                  const scene_body *b, uint32_t node, double weight);

/* Adds translation and rotation blocks of a rigid body for a point of it, in world coordinates at
 * the trial state. `weight` is signed. */
void vbss_scene_add_rigid_jacobian(contact_constraint *constraint, const scene_rigid *r, vec3 point,
                                   double weight);

/* Adds the Jacobian block of a translation. `b`: index of the block in the system. */
void vbss_scene_add_jacobian_block(contact_constraint *constraint, uint32_t b, double weight);

/* ---- bilateral_constraints.c */

/* Sets the geometry of a spring from the current point of a grasped body to its target in the jaws
 * of `tool`, both at the trial state. Clears the Jacobian; the caller adds stiffness and Jacobian
 * blocks. The normal is the closing axis of the jaws. */
void vbss_scene_set_spring_geometry(const scene_object *s, contact_constraint *constraint,
                                    const scene_rigid *tool, vec3 current, vec3 target);

/* Adds a bilateral constraint with zero geometry. NULL: the contact set is full. */
contact_constraint *vbss_scene_add_bilateral_constraint(scene_object *s, const contact_key *key);

/* ---- hole_constraints.c */

/* Adds one constraint for each hole. False: the contact set is full. */
bool vbss_scene_add_hole_constraints(scene_object *s);

/* Updates gap and Jacobian of a hole's constraint to the trial state. The first call of a substep
 * also chooses the thread span that the hole may slide along, and sets the yield limit. */
void vbss_scene_update_hole_constraint(scene_object *s, contact_constraint *constraint);

/* ---- grasp_constraints.c */

/* Adds GRASPER_NEEDLE_POINTS constraints for each grasped needle. False: the contact set
 * is full. */
bool vbss_scene_add_needle_grasp_constraints(scene_object *s);

/* Adds up to SCENE_WALL_GRASP_POINTS constraints for each grasped wall. False: the contact set
 * is full. */
bool vbss_scene_add_wall_grasp_constraints(scene_object *s);

/* Adds GRASPER_THREAD_POINTS constraints for each grasped thread. False: the contact set
 * is full. */
bool vbss_scene_add_thread_grasp_constraints(scene_object *s);

/* Updates gap and Jacobian of any bilateral constraint to the trial state. */
void vbss_scene_update_bilateral_constraint(scene_object *s, contact_constraint *constraint);

/* ---- narrow_phase.c */

/* Finds closest points, normal, contact distance and gap of two features at the start of the
 * substep. `b` is a plane, or NULL for the floor, if the contact is one with a plane. Returns false if the gap is not below `reach` (m), or if a
 * neighbouring feature covers the closest point. */
bool vbss_scene_run_narrow_phase(const scene_object *s, contact_constraint *constraint,
                                 const scene_body *a, const scene_body *b, double reach);

/* Sets friction, stiffness and augmentation of all contacts, then their gaps and Jacobians at the
 * trial state. The normals stay those of the narrow phase. */
void vbss_scene_init_contacts(scene_object *s, const scene_substep *substep);

/* Updates gaps and Jacobians of all constraints to the trial state. The normals stay. */
void vbss_scene_refresh_contacts(scene_object *s);

/* Updates normals, gaps and Jacobians of all constraints to the trial state. Friction forces turn
 * with the normals. */
void vbss_scene_refresh_normals(scene_object *s);

/* Updates the gaps of all contacts to the trial state, from closest points that are found again.
 * Nothing else changes. */
void vbss_scene_measure_gaps(scene_object *s);

/* ---- add_contact.c */

/* Adds a contact constraint if its two features may touch in the substep. Pairs whose features are
 * both prescribed get none. False: the contact set is full. */
bool vbss_scene_add_contact(scene_object *s, const contact_key *key, const scene_contact_pair *m);

/* Adds a contact constraint of a sphere and a plane (NULL: the floor), if they may touch in the
 * substep. False: the contact set is full. */
bool vbss_scene_add_plane_contact(scene_object *s, const contact_key *key,
                                  const scene_sphere *sphere, const scene_body *plane);

/* ---- surface_contacts.c */

/* Adds the contact of a candidate pair with a drain on one or both sides, if its features may
 * touch. False: the contact set is full. */
bool vbss_scene_add_surface_contact(scene_object *s, const collision_candidate *q);

/* Adds contacts of a drain's nodes with a plane (NULL: the floor). False: the contact set is full. */
bool vbss_scene_add_drain_plane_contacts(scene_object *s, const scene_body *b,
                                         const scene_body *plane);

/* ---- duplicate_contacts.c */

/* Removes all but one of the contacts about the same two points. The contact set must be sorted. */
void vbss_scene_remove_duplicate_contacts(scene_object *s);

/* ---- contact_rolls.c: threads with friction torque */

/* Chooses the segments that the contacts of the substep may roll. Others do not roll by themselves. */
void vbss_scene_choose_rolls(scene_object *s);

/* Adds the rolls of one side of a contact to its Jacobian and to its displacement. Does nothing if that
 * side is no such thread; `b` is NULL for the floor. */
void vbss_scene_add_roll_jacobian(const scene_object *s, contact_constraint *constraint,
                                  const scene_body *b, bool is_b);

/* ---- sliding_contacts.c */

/* Moves each contact of two threads to where the threads are expected to cross at the end of the substep. For substeps
 * that are whole steps, without a budget. */
void vbss_scene_predict_slides(scene_object *s);
/* Moves a sliding contact to where the threads cross in the trial state, on the same segments. */
void vbss_scene_update_slide(const scene_object *s, contact_constraint *constraint);
/* Sets the derivatives of the weights of the blocks from `first` on, which are the nodes of a segment, as the contact
 * point moves along the thread. Blocks of welded nodes get none. */
void vbss_scene_set_slide_derivatives(contact_constraint *constraint, uint32_t first,
                                      const scene_body *thread, uint32_t segment,
                                      bool is_on_side_b);

/* ---- create_contacts.c */

/* Creates all constraints of a substep: contacts of features that may touch, grasps and holes. Sets
 * capsule targets, motion bounds and contact flags of threads on the way. False: no capacity for
 * candidates or constraints. */
bool vbss_scene_create_contacts(scene_object *s, const scene_substep *substep);

/* ---- warm_start.c */

/* Gives contacts the status and forces that they had in the last substep, also where they slid to
 * an adjacent feature. Then bounds the speed at which overlaps that no force accounts for are removed. */
void vbss_scene_warm_start_contacts(scene_object *s, const scene_substep *substep);

#endif
