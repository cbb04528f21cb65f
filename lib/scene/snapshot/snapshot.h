/* Saving, hashing and restoring a scene. */
#ifndef VBSS_SCENE_SNAPSHOT_H
#define VBSS_SCENE_SNAPSHOT_H

#include "scene/world/scene_data.h"

/* ---- snapshot_suspended.c */

void vbss_scene_visit_cursor(vbss_stream *stream, scene_object *s);

/* ---- snapshot_pieces.c */

/* State: whether there is a piece, and what only pieces have; then, when all bodies are read, what follows from
 * their numbers of nodes. */
void vbss_scene_serialise_piece(vbss_stream *stream, scene_object *s, scene_body *b);
void vbss_scene_restore_pieces(vbss_stream *stream, scene_object *s);

/* ---- snapshot.c */

void vbss_scene_serialise(vbss_stream *stream, void *object);

#endif
