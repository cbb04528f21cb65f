/* Scenes of a drain and what touches it, the same for tests, bench and pictures. What hands do is worked out from the number
 * of the step alone, so that a restored scene goes on as the saved one. */
#ifndef VBSS_TESTS_SCENES_TISSUE_SCENES_H
#define VBSS_TESTS_SCENES_TISSUE_SCENES_H

#include <vblast_ss/scene.h>

#include "base/linear.h"

typedef enum tissue_scene_kind {
    TISSUE_SCENE_POKED, /* a probe pushes the wall in beside the slit, stirs, and leaves, again and again */
    TISSUE_SCENE_PINCHED,  /* a rod along the drain presses it flat on its own bottom, and leaves */
    TISSUE_SCENE_SHUT,     /* the marks are drawn together until the lips press on each other */
    TISSUE_SCENE_OPENED,   /* two probes, one behind each lip, pull the slit open */
    TISSUE_SCENE_INVERTED, /* a wide ball pushes the top down into the lumen, and leaves it there */
    TISSUE_SCENE_LIFTED, /* a rod through the lumen is lifted until the drain comes off its block */
    TISSUE_SCENE_LADEN,  /* a thread lies over it, weights pull at both ends */
    TISSUE_SCENE_KINDS
} tissue_scene_kind;
extern const char *const tissue_scene_names[TISSUE_SCENE_KINDS];
/* Steps of 1 ms after which a scene has shown all it has. */
extern const uint32_t tissue_scene_steps[TISSUE_SCENE_KINDS];

enum { TISSUE_TOOLS = 2 };
typedef struct tissue_scene {
    tissue_scene_kind kind;
    vbss_scene *scene;
    vbss_drain *drain;
    vbss_thread *thread;                                   /* LADEN; else NULL */
    uint32_t drain_body, thread_body, tools[TISSUE_TOOLS]; /* numbers; 0: there is none */
} tissue_scene;

/* The scene's own configurations; callers may change limits, mesh and wall. */
vbss_result tissue_scene_configs(tissue_scene_kind kind, vbss_method method,
                                 vbss_scene_config *scene, vbss_drain_config *drain);
vbss_result tissue_scene_create(vbss_context *context, tissue_scene_kind kind,
                                const vbss_scene_config *scene, const vbss_drain_config *drain,
                                tissue_scene *made);
/* Where the axis of a tool is now; returns its radius, 0: there is none. */
double tissue_scene_tool(const tissue_scene *t, int which, vec3 axis[2]);
/* SHUT: marks go where hands have them at that time, s. */
vbss_result tissue_scene_shut(tissue_scene *t, double at);
/* What hands do, and a step of h seconds. */
vbss_result tissue_scene_step(tissue_scene *t, double h);

#endif
