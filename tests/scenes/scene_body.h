/* A scene in motion behind the harness' description of a stepped body. */
#ifndef VBSS_TESTS_SCENES_SCENE_BODY_H
#define VBSS_TESTS_SCENES_SCENE_BODY_H

#include "base/error.h"
#include "harness/harness.h"
#include "scene/api/api.h"
#include "scene/world/world.h"
#include "scenes/scene_scenes.h"

static inline vbss_result scene_body_create(vbss_context *context, void *user, void **handle)
{
    const scene_scene_kind *kind = user;
    vbss_scene *scene = NULL;
    VBSS_TRY(scene_scene_create(context, *kind, &scene));
    *handle = scene;
    return VBSS_OK;
}

static inline vbss_result scene_body_step_knot(void *handle)
{
    return scene_scene_step(handle, SCENE_SCENE_KNOT);
}

static inline vbss_result scene_body_step_tools(void *handle)
{
    return scene_scene_step(handle, SCENE_SCENE_TOOLS);
}

static inline vbss_result scene_body_destroy(void *handle)
{
    return vbss_scene_destroy(handle);
}

static inline harness_body scene_as_body(void *kind)
{
    const scene_scene_kind *which = kind;
    harness_body body = {"scene",
                         &vbss_scene_kind,
                         scene_body_create,
                         NULL,
                         *which == SCENE_SCENE_KNOT ? scene_body_step_knot : scene_body_step_tools,
                         scene_body_destroy,
                         kind};
    return body;
}

#endif
