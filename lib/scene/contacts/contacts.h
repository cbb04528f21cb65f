/* Contact constraints: motion bounds, broad phase, narrow phase, bilateral constraints of grasps
 * and holes, warm start. */
#ifndef VBSS_SCENE_CONTACTS_H
#define VBSS_SCENE_CONTACTS_H

#include "scene/world/world.h"

/* Of one feature of a pair, wherever it is round; a lip is thinner. */
static inline double scene_feature_radius(const scene_object *s, const collision_candidate *q,
                                          bool is_b)
{
    const uint32_t shape = is_b ? q->shape_b : q->shape_a, feature = is_b ? q->b : q->a;
    const scene_body *b = &s->bodies[s->body_of_shape[shape]];
    if (b->kind == SCENE_BODY_RIGID) {
        bool is_point = q->kind == VBSS_PAIR_POINT_TRIANGLE; /* the end of a capsule */
        return s->capsules[b->rigid.first_capsule + (is_point ? feature / 2 : feature)].radius;
    }
    return b->kind == SCENE_BODY_THREAD ? b->thread.thread->config.radius
                                        : s->collision->shapes[shape]->radius;
}

/* Whether their surfaces stay farther apart than that while their nodes go where the shapes are moved to. */
static inline bool scene_is_known_apart(const scene_object *s, const collision_candidate *q,
                                        double distance)
{
    distance += scene_feature_radius(s, q, false) + scene_feature_radius(s, q, true);
    return vbss_collision_stays_separated(s->collision, q, distance);
}

/* An interval of a needle capsule's axis beside its holes, and the part of a drain's side between
 * the planes across its ends. What is cut there has no end that could push the wall along. */
typedef struct scene_axis_interval {
    bool started;        /* false, and the first one is found */
    double end_arc;      /* where it ends, m from the tip */
    double bounds[2][2]; /* from and to which share of the capsule's axis, of the side */
} scene_axis_interval;
static inline void scene_clip_axis(vec3 axis[2], const double interval[2])
{
    vec3 start = axis[0];
    axis[0] = vec3_lerp(start, axis[1], interval[0]);
    axis[1] = vec3_lerp(start, axis[1], interval[1]);
}

/* Ways are taken for so much longer than a part: velocities change within it. */
#define SCENE_EXTRAPOLATION_RATIO 1.2
/* Two features that may touch, and how far their vertices may move. b is NULL: the floor. */
typedef struct scene_contact_pair {
    const scene_body *a, *b;
    const vec3 *displacements_a, *displacements_b;
    uint32_t count_a, count_b;
    const collision_candidate *candidate; /* whose axes the row is about; NULL: none */
} scene_contact_pair;

/* ---- pin_exclusion.c */

/* Whether a segment is so near to a pin on the body, or to the jaws' grasp, along the thread, that it does not
 * touch that capsule of it. */
bool vbss_scene_is_excluded_at_pin(const scene_object *s, const scene_body *thread,
                                   uint32_t segment, const scene_body *rigid, uint32_t capsule,
                                   double contact_distance);

/* ---- hole_exclusion.c */

/* The fraction of the contact distance at which a place of a body touches a point of a wall: 0 in a
 * hole that the suture is in, or in jaws that grasp the wall; 1 away from them. `point`: `feature`
 * is a node or the end of a capsule; otherwise `share` is the place on the segment. `reach`: radius
 * round a hole within which nothing touches, m. */
double vbss_scene_contact_scale_at(const scene_object *s, const scene_body *body, bool is_point,
                                   uint32_t feature, double fraction, const scene_body *drain,
                                   const scene_wall_point *wall_point, double reach);

/* The same fraction for a contact constraint. */
double vbss_scene_contact_scale_of(const scene_object *s, const contact_constraint *constraint);

/* The next interval of a needle capsule's axis outside all holes in a drain, and the part of the
 * drain's side beside it. `reach`: radius round a hole within which nothing touches, m. False:
 * there is none. */
bool vbss_scene_next_axis_interval(const scene_object *s, const scene_body *needle,
                                   uint32_t capsule, const scene_body *drain, uint32_t edge,
                                   double reach, scene_axis_interval *interval);

/* ---- motion_bounds.c */

/* Sets how far each vertex may move in the substep. */
void vbss_scene_set_motion_bounds(scene_object *s, const scene_substep *substep);

/* ---- broad_phase.c */

/* All pairs of features whose boxes meet where their shapes were moved to. */
vbss_result vbss_scene_run_broad_phase(scene_object *s);

/* Moves all collision shapes along their motion bounds and lists the pairs of features whose swept
 * boxes meet. */
vbss_result vbss_scene_find_candidates(scene_object *s);

/* ---- jacobian.c */

/* Terms of a node, and of a point of a rigid body. */
void vbss_scene_add_node_jacobian(const scene_object *s, contact_constraint *constraint,
                                  const scene_body *b, uint32_t node, double weight);
void vbss_scene_add_rigid_jacobian(contact_constraint *constraint, const scene_rigid *r, vec3 point,
                                   double weight);

/* Adds the Jacobian block of a translation. */
void vbss_scene_add_jacobian_block(contact_constraint *constraint, uint32_t b, double weight);

/* ---- bilateral_constraints.c */

/* What is held is here in the trial state, and shall be there, in the jaws: a spring between the two, whose stiffness and terms
 * who calls it adds. */
void vbss_scene_set_spring_geometry(contact_constraint *constraint, const scene_rigid *tool,
                                    vec3 current, vec3 target);

/* Adds a bilateral constraint. NULL: no room. */
contact_constraint *vbss_scene_add_bilateral_constraint(scene_object *s, const contact_key *key);

/* ---- hole_constraints.c */

/* Adds a constraint a hole. False: no room. */
bool vbss_scene_add_hole_constraints(scene_object *s);

/* Updates gap and Jacobian of a hole's constraint in the trial state. */
void vbss_scene_update_hole_constraint(scene_object *s, contact_constraint *constraint);

/* ---- grasp_constraints.c */

/* Adds three constraints a grasped needle. False: no room. */
bool vbss_scene_add_needle_grasp_constraints(scene_object *s);

/* Adds up to three constraints a grasped wall. False: no room. */
bool vbss_scene_add_wall_grasp_constraints(scene_object *s);

/* Adds three constraints a grasped thread. False: no room. */
bool vbss_scene_add_thread_grasp_constraints(scene_object *s);

/* Updates gap and Jacobian of any bilateral constraint in the trial state. */
void vbss_scene_update_bilateral_constraint(scene_object *s, contact_constraint *constraint);

/* ---- narrow_phase.c */

/* How the sides of a row lie at the begin of the part (b is NULL: the floor); false: too far apart to touch in it. */
bool vbss_scene_run_narrow_phase(const scene_object *s, contact_constraint *constraint,
                                 const scene_body *a, const scene_body *b, double reach);

/* All that a row is beside that, in the trial state; and what a further linearisation changes. The normal
 * stays. */
void vbss_scene_init_contacts(scene_object *s, const scene_substep *substep);
void vbss_scene_refresh_contacts(scene_object *s);

/* As they lie in the trial state, with the normals that they have there. */
void vbss_scene_refresh_normals(scene_object *s);

/* Gaps in the trial state, whatever the normals. */
void vbss_scene_measure_gaps(scene_object *s);

/* ---- add_contact.c */

/* Adds a contact constraint if its two features may touch in the substep. False: no room. */
bool vbss_scene_add_contact(scene_object *s, const contact_key *key, const scene_contact_pair *m);

/* The same of a point with a radius and the floor. */
bool vbss_scene_add_floor_contact(scene_object *s, const contact_key *key, const scene_body *b,
                                  vec3 x, double radius, vec3 displacement);

/* ---- surface_contacts.c */

/* Rows of a pair of which one or both are of drains; of a drain and the floor. */
bool vbss_scene_add_surface_contact(scene_object *s, const collision_candidate *q);
bool vbss_scene_add_drain_floor_contacts(scene_object *s, const scene_body *b);

/* ---- duplicate_contacts.c */

/* Of rows about the same two points, in a list that is sorted, one stays. */
void vbss_scene_remove_duplicate_contacts(scene_object *s);

/* ---- create_contacts.c */

/* Rows of what might touch. False: no room. */
bool vbss_scene_create_contacts(scene_object *s, const scene_substep *substep);

/* ---- warm_start.c */

/* What the rows remember of the last part. */
void vbss_scene_warm_start_contacts(scene_object *s, const scene_substep *substep);

#endif
