/* A drain in a scene with hands that work on it, the same for tests and the determinism table. What hands do is worked out
 * from the number of the step alone, so that a restored scene goes on as the saved one. */
#ifndef VBSS_TESTS_SCENES_DRAIN_HANDS_H
#define VBSS_TESTS_SCENES_DRAIN_HANDS_H

#include <vblast_ss/scene.h>

/* The drain lies on its block, which is the floor; a thread is drawn down over it by its ends; a tool pokes the wall in
 * beside the slit, stirs, and goes back up, again and again. */
enum { DRAIN_HANDS_DRAIN = 1, DRAIN_HANDS_THREAD, DRAIN_HANDS_TOOL };
enum { DRAIN_HANDS_NODES = 33 }; /* of the thread */
#define DRAIN_HANDS_TOOL_RADIUS 1.25e-3

typedef struct drain_hands {
    vbss_scene_config config; /* of the scene; callers may change both before the bodies are made */
    vbss_drain_config drain_config;
    vbss_scene *scene;
    vbss_drain *drain;
} drain_hands;

vbss_result drain_hands_init(drain_hands *hands);
/* The scene with its bodies; the drain and the thread end with the context, or as the host wants. */
vbss_result drain_hands_create(vbss_context *context, drain_hands *hands);
/* What the hand does before the next step; and the step, of 1 ms. */
vbss_result drain_hands_drive(vbss_scene *scene);
vbss_result drain_hands_step(vbss_scene *scene);

#endif
