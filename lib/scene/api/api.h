/* The handles of scenes. Only the exported functions in this folder open a handle or edit a
 * scene. */
#ifndef VBSS_SCENE_API_H
#define VBSS_SCENE_API_H

#include "scene/world/scene_data.h"

/* The kind of a scene's handle: its name, its code and version in snapshots, and how it is freed
 * and serialised. Defined in create.c. */
extern const vbss_kind vbss_scene_kind;

/* ---- handle.c */

/* Opens a scene for reading. Sets the error and returns VBSS_ERROR_INVALID_HANDLE if the handle
 * is not that of a living scene. */
vbss_result vbss_scene_open(const vbss_scene *handle, scene_object **scene);

/* Opens a scene for an edit and abandons a suspended step first. Returns
 * VBSS_ERROR_INVALID_HANDLE as vbss_scene_open does, VBSS_ERROR_BUSY inside a callback of the
 * context, or the error of that step. */
vbss_result vbss_scene_open_for_edit(vbss_scene *handle, scene_object **scene);

/* Opens a scene for a change that keeps a suspended step: a step, a target, destruction. Returns
 * VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY, the latter inside a callback of the context. */
vbss_result vbss_scene_open_mutable(vbss_scene *handle, scene_object **scene);

#endif
