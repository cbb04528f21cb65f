/* Drains that hands pull at, the same for tests, bench and the determinism table. What hands do is worked out from the
 * number of the step alone, so that a restored drain goes on as the saved one. */
#ifndef VBSS_TESTS_SCENES_DRAIN_SCENES_H
#define VBSS_TESTS_SCENES_DRAIN_SCENES_H

#include <vblast_ss/drain.h>

typedef enum drain_scene_kind {
    DRAIN_SCENE_CLOSED, /* both marks are drawn together until the slit is shut, and held there */
    DRAIN_SCENE_POKED, /* a hand pushes the wall in beside the slit, stirs, and lets go, again and again */
    DRAIN_SCENE_TUGGED, /* hands take nodes here and there and tear at them; at last the drain comes off its block */
    DRAIN_SCENE_KINDS
} drain_scene_kind;
extern const char *const drain_scene_names[DRAIN_SCENE_KINDS];
/* Steps of 1 ms after which a scene has shown all it has. */
extern const uint32_t drain_scene_steps[DRAIN_SCENE_KINDS];

/* How fast marks are drawn together and a hand pushes, m/s. */
#define DRAIN_SCENE_SPEED 0.04

typedef struct drain_scene {
    drain_scene_kind kind;
    vbss_drain *drain;
} drain_scene;

/* The scene's own drain; callers may change its mesh, wall and limits. */
vbss_result drain_scene_config(drain_scene_kind kind, vbss_drain_config *config);
vbss_result drain_scene_create(vbss_context *context, drain_scene_kind kind,
                               const vbss_drain_config *config, drain_scene *scene);
/* What hands do before the next step, of h seconds; and that step. */
vbss_result drain_scene_drive(drain_scene *scene, double h);
vbss_result drain_scene_step(drain_scene *scene, double h);

#endif
