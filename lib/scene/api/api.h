/* Scene handles. Only the exported functions in this folder open a handle or edit a scene. */
#ifndef VBSS_SCENE_API_H
#define VBSS_SCENE_API_H

#include "scene/world/scene_data.h"

extern const vbss_kind vbss_scene_kind;

/* ---- handle.c */

/* Opens a scene for reading. */
vbss_result vbss_scene_open(const vbss_scene *handle, scene_object **scene);

/* Opens a scene for editing. A suspended step is ended first. */
vbss_result vbss_scene_open_for_edit(vbss_scene *handle, scene_object **scene);

/* Opens a scene for a change that does not end a suspended step. */
vbss_result vbss_scene_open_mutable(vbss_scene *handle, scene_object **scene);

#endif
