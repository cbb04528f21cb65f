/* A needle that a hand turns through both walls of a drain and back out, the same for tests, bench and pictures: square to
 * the wall into the right mark, while the other hand holds the edge of the slit beside it. What hands do is worked out from
 * the number of the step alone, so that a restored scene goes on as the saved one. */
#ifndef VBSS_TESTS_SCENES_PUNCTURE_SCENES_H
#define VBSS_TESTS_SCENES_PUNCTURE_SCENES_H

#include <vblast_ss/scene.h>

typedef struct puncture_scene {
    vbss_scene *scene;
    vbss_drain *drain;
    vbss_needle *needle;
    uint32_t drain_body, needle_body;
    double speed; /* of the tip, m/s: change it before the first step */
} puncture_scene;

/* Of the tip along its arc: on, then back, m. */
#define PUNCTURE_SCENE_ON 18e-3
#define PUNCTURE_SCENE_BACK 23e-3
/* Unless it is changed, m/s. */
#define PUNCTURE_SCENE_SPEED 0.02

vbss_result puncture_scene_configs(vbss_scene_config *scene, vbss_drain_config *drain);
vbss_result puncture_scene_create(vbss_context *context, const vbss_scene_config *scene,
                                  const vbss_drain_config *drain, puncture_scene *made);
/* What hands do, and a step of h seconds; of a scene that was made like this, whoever has it. */
vbss_result puncture_scene_step(puncture_scene *p, double h);
vbss_result puncture_scene_step_of(vbss_scene *scene, double speed, double h);
/* What hands do before a step, alone. */
vbss_result puncture_scene_aim(vbss_scene *scene, double speed, double h);
/* Steps of h until all is over. */
uint32_t puncture_scene_steps(const puncture_scene *p, double h);
/* How far the tip is told to be on its arc, from where it began, after so many steps. */
double puncture_scene_way(double speed, uint64_t steps, double h);
/* What the hand drives it with along its arc, N; below 0 it holds it back. */
vbss_result puncture_scene_push(const puncture_scene *p, double *push);
/* Events of that kind in the last step. */
uint32_t puncture_scene_count(const puncture_scene *p, vbss_event_kind kind);

#endif
