/* Rows, of which each is a place where two features may touch: who finds them (candidates.c, surfaces.c, doubles.c), what they remember
 * (recall.c), how they lie (features.c). */
#ifndef VBSS_SCENE_ROWS_H
#define VBSS_SCENE_ROWS_H

#include "scene/scene.h"

/* Contacts whose feature a, if it is of a thread, is a node; a segment. */
static inline bool scene_is_of_node(uint32_t kind)
{
    return kind == VBSS_CONTACT_NODE_CAPSULE || kind == VBSS_CONTACT_NODE_FLOOR ||
           kind == VBSS_CONTACT_POINT_FACE;
}

static inline bool scene_is_of_surface(uint32_t kind)
{
    return kind == VBSS_CONTACT_POINT_FACE || kind == VBSS_CONTACT_SIDES;
}

static inline bool scene_is_of_segment(uint32_t kind)
{
    return kind == VBSS_CONTACT_SEGMENTS || kind == VBSS_CONTACT_SEGMENT_CAPSULE ||
           kind == VBSS_CONTACT_SIDES;
}

/* Ways are taken for so much longer than a part: velocities change within it. */
#define SCENE_AHEAD 1.2
/* candidates.c: rows of what might touch. False: no room. */
bool vbss_scene_find_rows(scene_object *s, const scene_part *part);
/* All pairs of features whose boxes meet where their shapes were moved to. */
vbss_result vbss_scene_find_pairs(scene_object *s);
/* Adds that row if its features may touch in the part. What they do in it is what their vertices do. b is NULL: the floor,
 * which does nothing. False: no room. */
typedef struct scene_meeting {
    const scene_body *a, *b;
    const vec3 *ways_a, *ways_b;
    uint32_t count_a, count_b;
    const collision_candidate *pair; /* whose axes the row is about; NULL: none */
} scene_meeting;
bool vbss_scene_add_row(scene_object *s, const contact_key *key, const scene_meeting *m);
/* The same of a point with a radius and the floor. */
bool vbss_scene_add_floor_row(scene_object *s, const contact_key *key, const scene_body *b, vec3 x,
                              double radius, vec3 way);
/* The floor, a driven body, nodes that are all held: nothing about them can be changed. */
bool vbss_scene_is_given(const scene_object *s, const scene_body *b, uint32_t kind, bool is_b,
                         uint32_t feature);
/* doubles.c: of rows about the same two points, in a list that is sorted, one stays. */
void vbss_scene_remove_doubles(scene_object *s);
/* surfaces.c: rows of a pair of which one or both are of drains; of a drain and the floor. */
bool vbss_scene_add_surface_row(scene_object *s, const collision_candidate *q);
bool vbss_scene_add_drain_floor_rows(scene_object *s, const scene_body *b);
/* Nodes of a feature of a drain; returns how many. */
uint32_t vbss_scene_nodes_of(const scene_object *s, const scene_body *drain, uint32_t kind,
                             bool is_b, uint32_t feature, uint32_t nodes[3]);
/* recall.c: what the rows remember of the last part. */
void vbss_scene_recall_rows(scene_object *s, const scene_part *part);
/* features.c: how the sides of a row lie at the begin of the part (b is NULL: the floor); false: too far apart to touch in it. */
bool vbss_scene_lay_row(const scene_object *s, contact_constraint *row, const scene_body *a,
                        const scene_body *b, double reach);
/* Terms of a node, and of a point of a rigid body. */
void vbss_scene_add_node_term(const scene_object *s, contact_constraint *row, const scene_body *b,
                              uint32_t node, double weight);
void vbss_scene_add_rigid_terms(contact_constraint *row, const scene_rigid *r, vec3 point,
                                double weight);
/* All that a row is beside that, in the trial state; and what a further linearisation changes. The normal
 * stays. */
void vbss_scene_set_rows(scene_object *s, const scene_part *part);
void vbss_scene_refresh_rows(scene_object *s);
/* As they lie in the trial state, with the normals that they have there. */
void vbss_scene_lay_rows_again(scene_object *s);
/* Gaps in the trial state, whatever the normals. */
void vbss_scene_measure_gaps(scene_object *s);

#endif
