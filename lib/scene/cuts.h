/* Threads that are cut: what it needs is taken beforehand (piece_pool.c), cuts.c divides them. */
#ifndef VBSS_SCENE_CUTS_H
#define VBSS_SCENE_CUTS_H

#include "scene/scene.h"

/* piece_pool.c: what cuts need, taken when a thread is added. Whether there is room for it and its pieces; their
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
/* State: whether there is a piece, and what only pieces have; then, when all bodies are read, what follows from
 * their numbers of nodes. */
void vbss_scene_serialise_piece(vbss_stream *stream, scene_object *s, scene_body *b);
void vbss_scene_restore_pieces(vbss_stream *stream, scene_object *s);

/* cuts.c. Divides a thread between steps, or at the very end of one. Untold: VBSS_ERROR_OUT_OF_RANGE at an end,
 * where nothing is cut; VBSS_ERROR_CAPACITY when no cut is left, which is an event. */
vbss_result vbss_scene_apply_cut(scene_object *s, scene_body *thread, double arc_length,
                                 scene_body **piece);
void vbss_scene_emit_cut_event(scene_object *s, const scene_body *thread, const scene_body *piece,
                               double arc_length);
/* Whether two segments of threads are so near across a cut that they do not touch: the ends at a cut begin in
 * the same place. Until they have come apart, which is seen at the end of a step. */
bool vbss_scene_is_excluded_across_cut(const scene_object *s, const scene_body *a,
                                       uint32_t segment_a, const scene_body *b, uint32_t segment_b);
void vbss_scene_update_cut_exclusions(scene_object *s);

#endif
