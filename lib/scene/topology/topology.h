/* Changes of topology: cuts, pieces that are cut off, adaptive meshes of threads. */
#ifndef VBSS_SCENE_TOPOLOGY_H
#define VBSS_SCENE_TOPOLOGY_H

#include "scene/world/scene_data.h"

/* Nodes that a cut adds, as it goes through a segment. */
enum { SCENE_NODES_PER_CUT = 2 };

/* A node that comes, in the middle of segment `at`, or node `at` that goes. */
typedef struct mesh_change {
    uint32_t at;
    bool removes;
    double max_shift; /* for its neighbours and itself, m */
} mesh_change;

/* Whether the number of a thread's nodes may change while it is in the scene. */
static inline bool scene_thread_resizes(const thread_object *t)
{
    return t->config.cut_capacity > 0 || t->config.mesh == VBSS_MESH_ADAPTIVE;
}

/* ---- cut_exclusion.c */

/* Whether two segments of threads are so near across a cut that they do not touch: the ends at a cut begin in
 * the same place. Until they have come apart, which is seen at the end of a step. */
bool vbss_scene_is_excluded_across_cut(const scene_object *s, const scene_body *a,
                                       uint32_t segment_a, const scene_body *b, uint32_t segment_b);
void vbss_scene_update_cut_exclusions(scene_object *s);

/* ---- piece_pool.c */

/* What cuts need, taken when a thread is added. Whether there is room for it and its pieces; their
 * shapes, after that of the thread, which goes as well if they cannot be made; their places. */
vbss_result vbss_scene_check_thread_capacity(const scene_object *s, const thread_object *t);
vbss_result vbss_scene_create_piece_shapes(scene_object *s, const thread_object *t, uint32_t shape);
void vbss_scene_add_spares(scene_object *s, thread_object *t, uint32_t first_shape);

/* When none of the family is left. */
void vbss_scene_return_spares(scene_object *s, const thread_piece_pool *family);
void vbss_scene_return_spare(scene_body *b);

/* The first place for a piece of that thread, or NULL; makes it a body, and undoes that. */
scene_body *vbss_scene_find_spare(const scene_object *s, const scene_body *thread);
void vbss_scene_activate_piece(scene_object *s, scene_body *piece);
void vbss_scene_deactivate_piece(scene_object *s, scene_body *piece);

/* Whether the entry is reserved for a piece that has not been cut off. */
bool vbss_scene_is_spare_piece(const scene_body *b);

/* ---- cuts.c */

/* Cuts a thread between steps, or at the very end of one, with the event. No error text is set.
 * VBSS_ERROR_OUT_OF_RANGE: at an end of the thread, nothing is cut. VBSS_ERROR_CAPACITY: no piece
 * is left in the pool. */
vbss_result vbss_scene_apply_cut(scene_object *s, scene_body *thread, double arc_length,
                                 scene_body **piece);

/* Makes the cuts that were recorded during the step. */
void vbss_scene_make_cuts(scene_object *s);

/* ---- renumber.c */

/* Makes the change, with pins, grasps and views of contacts. False: it takes more room. What contact
 * remembers is in order again only after the last of them. */
bool vbss_scene_apply_mesh_change(scene_object *s, const scene_body *thread,
                                  const mesh_change *change);
void vbss_scene_sort_warm_start(scene_object *s);

/* ---- remeshing.c */

/* Threads refine and coarsen themselves, at the very end of a step. */
void vbss_scene_adapt_meshes(scene_object *s);

#endif
