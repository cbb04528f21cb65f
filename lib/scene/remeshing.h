/* Threads of a scene whose meshes adapt themselves: remeshing.c finds what is wanted and what is near, renumber.c takes
 * all that names nodes and segments along. */
#ifndef VBSS_SCENE_REMESHING_H
#define VBSS_SCENE_REMESHING_H

#include "scene/scene.h"
#include "thread/remesh.h"

/* A node that comes, in the middle of segment `at`, or node `at` that goes. */
typedef struct mesh_change {
    uint32_t at;
    bool removes;
    double max_shift; /* for its neighbours and itself, m */
} mesh_change;

/* remeshing.c: threads refine and coarsen themselves, at the very end of a step. */
void vbss_scene_adapt_meshes(scene_object *s);
/* Whether the number of a thread's nodes may change while it is in the scene. */
static inline bool scene_thread_resizes(const thread_object *t)
{
    return t->config.cut_capacity > 0 || t->config.mesh == VBSS_MESH_ADAPTIVE;
}

/* renumber.c: makes the change, with pins, grasps and views of contacts. False: it takes more room. What contact
 * remembers is in order again only after the last of them. */
bool vbss_scene_apply_mesh_change(scene_object *s, const scene_body *thread,
                                  const mesh_change *change);
void vbss_scene_sort_warm_start(scene_object *s);

#endif
