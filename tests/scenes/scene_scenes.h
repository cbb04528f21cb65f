/* Scenes in motion, the same for tests, bench and the determinism table. What hands do is worked out from
 * the number of the step alone, so that a restored scene goes on as the saved one. */
#ifndef VBSS_TESTS_SCENES_SCENE_SCENES_H
#define VBSS_TESTS_SCENES_SCENE_SCENES_H

#include <vblast_ss/scene.h>

typedef enum scene_scene_kind {
    SCENE_SCENE_KNOT, /* two hands pull an overhand knot tight */
    /* A thread falls on a sloping floor and is pressed there by a tool; another tool presses on the first; a
     * needle falls, with a thread welded to it; a stick is driven through; another thread swings. */
    SCENE_SCENE_TOOLS,
    /* The knot on a coarse mesh that adapts itself; one end of it is cut off. */
    SCENE_SCENE_MESH
} scene_scene_kind;

/* Its threads end with the context, or as the host wants. */
vbss_result scene_scene_create(vbss_context *context, scene_scene_kind kind, vbss_scene **scene);
/* What hands do before the next step. */
vbss_result scene_scene_drive(vbss_scene *scene, scene_scene_kind kind);
/* And the step, of 1 ms. */
vbss_result scene_scene_step(vbss_scene *scene, scene_scene_kind kind);

#endif
