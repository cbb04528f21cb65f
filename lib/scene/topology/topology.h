/* Changes of topology: cuts of threads, the pieces that they cut off, and adaptive meshes. */
#ifndef VBSS_SCENE_TOPOLOGY_H
#define VBSS_SCENE_TOPOLOGY_H

#include "scene/world/scene_data.h"

/* Nodes that a cut adds, as it goes through a segment. Derived. */
enum { SCENE_NODES_PER_CUT = 2 };

/* A change of a thread's mesh: a new node in the middle of segment `at`, or the removal of node
 * `at`. */
typedef struct mesh_change {
    uint32_t at;
    bool removes;
    double max_shift; /* largest displacement of the nodes around the change, m */
} mesh_change;

/* Whether the number of a thread's nodes can change while the thread is in a scene. */
static inline bool scene_thread_resizes(const thread_object *t)
{
    return t->config.cut_capacity > 0 || t->config.mesh == VBSS_THREAD_MESH_ADAPTIVE;
}

/* ---- cut_exclusion.c */

/* Whether two segments of different threads are excluded from contact because they are near each
 * other across a cut, measured along the threads. The two ends at a cut start at the same point;
 * the exclusion lasts until they are apart. */
bool vbss_scene_is_excluded_across_cut(const scene_object *s, const scene_body *a,
                                       uint32_t segment_a, const scene_body *b, uint32_t segment_b);

/* After a step: ends the exclusion at each cut whose ends are apart. */
void vbss_scene_update_cut_exclusions(scene_object *s);

/* ---- piece_pool.c */

/* Checks that the scene has room for a thread and for all pieces that may be cut from it. Sets the
 * error VBSS_ERROR_CAPACITY if it has not. */
vbss_result vbss_scene_check_thread_capacity(const scene_object *s, const thread_object *t);

/* Creates disabled shapes for the pieces of a thread; their numbers follow `shape`, which is
 * that of the thread. On failure removes all of them and the thread's shape. */
vbss_result vbss_scene_create_piece_shapes(scene_object *s, const thread_object *t, uint32_t shape);

/* Reserves a body entry with a spare thread for each piece. `first_shape` is the first of their
 * shapes. */
void vbss_scene_add_spares(scene_object *s, thread_object *t, uint32_t first_shape);

/* Returns the spare threads of a family to their pool, and removes their entries and shapes, if
 * no thread of the family is left in the scene. A family is a thread and all its pieces. */
void vbss_scene_return_spares(scene_object *s, const thread_piece_pool *family);

/* Returns one spare thread to its pool and frees its entry. The shape stays. */
void vbss_scene_return_spare(scene_body *b);

/* Returns the first entry that is reserved for a piece of this thread, or NULL. */
scene_body *vbss_scene_find_spare(const scene_object *s, const scene_body *thread);

/* Makes a reserved entry a body of the scene. Its number, nodes and shape are still to be set. */
void vbss_scene_activate_piece(scene_object *s, scene_body *piece);

/* Makes a piece a reserved entry again and disables its shape. */
void vbss_scene_deactivate_piece(scene_object *s, scene_body *piece);

/* Whether the entry is reserved for a piece that has not been cut off. */
bool vbss_scene_is_spare_piece(const scene_body *b);

/* ---- cuts.c */

/* Checks a cut with the results of vbss_scene_apply_cut. The lack of a piece is an event already;
 * nothing else changes. */
vbss_result vbss_scene_check_cut(scene_object *s, const scene_body *thread, double arc_length);

/* Cuts a thread between steps or at the end of one, and adds the event. `arc_length` is from its
 * first node at rest, m; `piece` receives the new body. Sets no error text. Returns
 * VBSS_ERROR_OUT_OF_RANGE if the cut is at an end of the thread, VBSS_ERROR_CAPACITY if the pool
 * has no piece left. */
vbss_result vbss_scene_apply_cut(scene_object *s, scene_body *thread, double arc_length,
                                 scene_body **piece);

/* Makes the scheduled cuts at the end of a step. */
void vbss_scene_make_cuts(scene_object *s);

/* ---- renumber.c */

/* Changes the mesh of a thread and renumbers its features in warm start, pins, grasps and
 * contact views. Returns false, without a change, if it would move nodes by more than max_shift.
 * After the last change of a thread call vbss_scene_sort_warm_start. */
bool vbss_scene_apply_mesh_change(scene_object *s, const scene_body *thread,
                                  const mesh_change *change);

/* Sorts the warm start by keys after mesh changes, and removes duplicate and obsolete entries. */
void vbss_scene_sort_warm_start(scene_object *s);

/* ---- remeshing.c */

/* At the end of a step: refines and coarsens the adaptive meshes of all threads. */
void vbss_scene_adapt_meshes(scene_object *s);

#endif
