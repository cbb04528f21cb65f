/* Rows, of which each is a place where two features may touch: who finds them (broad_phase.c, surface_contacts.c, duplicate_contacts.c), what they remember
 * (warm_start.c), how they lie (narrow_phase.c). */
#ifndef VBSS_SCENE_CONTACTS_H
#define VBSS_SCENE_CONTACTS_H

#include "scene/scene.h"

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

/* Ways are taken for so much longer than a part: velocities change within it. */
#define SCENE_EXTRAPOLATION_RATIO 1.2
/* broad_phase.c: rows of what might touch. False: no room. */
bool vbss_scene_create_contacts(scene_object *s, const scene_substep *substep);
/* All pairs of features whose boxes meet where their shapes were moved to. */
vbss_result vbss_scene_run_broad_phase(scene_object *s);
/* Adds that row if its features may touch in the part. What they do in it is what their vertices do. b is NULL: the floor,
 * which does nothing. False: no room. */
typedef struct scene_contact_pair {
    const scene_body *a, *b;
    const vec3 *displacements_a, *displacements_b;
    uint32_t count_a, count_b;
    const collision_candidate *candidate; /* whose axes the row is about; NULL: none */
} scene_contact_pair;
bool vbss_scene_add_contact(scene_object *s, const contact_key *key, const scene_contact_pair *m);
/* The same of a point with a radius and the floor. */
bool vbss_scene_add_floor_contact(scene_object *s, const contact_key *key, const scene_body *b,
                                  vec3 x, double radius, vec3 displacement);
/* The floor, a driven body, nodes that are all held: nothing about them can be changed. */
bool vbss_scene_is_feature_prescribed(const scene_object *s, const scene_body *b, uint32_t kind,
                                      bool is_b, uint32_t feature);
/* duplicate_contacts.c: of rows about the same two points, in a list that is sorted, one stays. */
void vbss_scene_remove_duplicate_contacts(scene_object *s);
/* surface_contacts.c: rows of a pair of which one or both are of drains; of a drain and the floor. */
bool vbss_scene_add_surface_contact(scene_object *s, const collision_candidate *q);
bool vbss_scene_add_drain_floor_contacts(scene_object *s, const scene_body *b);
/* Nodes of a feature of a drain; returns how many. */
uint32_t vbss_scene_drain_feature_nodes(const scene_object *s, const scene_body *drain,
                                        uint32_t kind, bool is_b, uint32_t feature,
                                        uint32_t nodes[3]);
/* warm_start.c: what the rows remember of the last part. */
void vbss_scene_warm_start_contacts(scene_object *s, const scene_substep *substep);
/* narrow_phase.c: how the sides of a row lie at the begin of the part (b is NULL: the floor); false: too far apart to touch in it. */
bool vbss_scene_run_narrow_phase(const scene_object *s, contact_constraint *constraint,
                                 const scene_body *a, const scene_body *b, double reach);
/* Terms of a node, and of a point of a rigid body. */
void vbss_scene_add_node_jacobian(const scene_object *s, contact_constraint *constraint,
                                  const scene_body *b, uint32_t node, double weight);
void vbss_scene_add_rigid_jacobian(contact_constraint *constraint, const scene_rigid *r, vec3 point,
                                   double weight);
/* All that a row is beside that, in the trial state; and what a further linearisation changes. The normal
 * stays. */
void vbss_scene_init_contacts(scene_object *s, const scene_substep *substep);
void vbss_scene_refresh_contacts(scene_object *s);
/* As they lie in the trial state, with the normals that they have there. */
void vbss_scene_refresh_normals(scene_object *s);
/* Gaps in the trial state, whatever the normals. */
void vbss_scene_measure_gaps(scene_object *s);

#endif
