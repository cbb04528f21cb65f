/* Saves, hashes and restores a scene. A stream visits the state field by field: depending on its
 * mode it writes, hashes or reads them. If it reads an invalid value, it is refused with
 * VBSS_ERROR_CORRUPT, and the caller returns the scene to the state before. */
#ifndef VBSS_SCENE_SNAPSHOT_H
#define VBSS_SCENE_SNAPSHOT_H

#include "scene/world/scene_data.h"

/* ---- config_fields.c */

/* Visits a configuration, its parameters of the baseline and its options of the solver, to which it
 * points afterwards. Reading one of an older version sets the missing fields to what scenes of that
 * version had. */
void vbss_scene_visit_config(vbss_stream *stream, vbss_scene_config *config,
                             vbss_baseline_config *baseline, vbss_solver_options *solver);

/* Name of the first field that must be equal in scenes that accept each other's states, and is not;
 * NULL: there is none. */
const char *vbss_scene_find_config_difference(const vbss_scene_config *a,
                                              const vbss_scene_config *b);

/* ---- snapshot_suspended.c */

/* Visits the cursor, and the rest of a suspended step if there is one. */
void vbss_scene_visit_cursor(vbss_stream *stream, scene_object *s);

/* Visits what hosts see of the last step: events, contact views and the generation. Only the way
 * back from a refused call has them. */
void vbss_scene_visit_report(vbss_stream *stream, scene_object *s);

/* ---- snapshot_settings.c */

/* Whether a host has set something at run time that the state must keep: without that, states have
 * the same bytes as in older libraries, whose logs have their hashes. */
bool vbss_scene_has_settings(const scene_object *s);

/* Visits what a host has set at run time. Without settings, reading sets the values with which the
 * scene and its bodies were created. */
void vbss_scene_visit_settings(vbss_stream *stream, scene_object *s, bool has_settings);

/* Whether a host has set other budgets at run time than the scene was created with. */
bool vbss_scene_has_budgets(const scene_object *s);

/* Visits the budgets, operations. Without them, reading sets those with which the scene was created. */
void vbss_scene_visit_budgets(vbss_stream *stream, scene_object *s, bool has_budgets);

/* ---- snapshot_pieces.c */

/* Visits whether an entry that is reserved for a piece has one, and the fields that only pieces
 * have. Reading activates or deactivates the piece accordingly. */
void vbss_scene_serialise_piece(vbss_stream *stream, scene_object *s, scene_body *b);

/* After all bodies have been read: checks that they fit into the scene, resizes the shapes of
 * threads, and numbers the nodes. */
void vbss_scene_restore_pieces(vbss_stream *stream, scene_object *s);

/* ---- snapshot_host_surface.c */

/* Visits the state of a host surface. Reading refuses another mesh, and positions that no host can give. */
void vbss_scene_serialise_host_surface(vbss_stream *stream, scene_rigid *r);

/* ---- snapshot.c */

/* Visits the whole state of a scene. `object` is a scene_object. */
void vbss_scene_serialise(vbss_stream *stream, void *object);

#endif
