/* Scenes of the suite `tuning`: five of the golden scenes, with as many steps. */
#ifndef VBSS_BENCH_TUNING_SCENES_H
#define VBSS_BENCH_TUNING_SCENES_H

#include <vblast_ss/scene.h>

enum { TUNING_SCENES = 5 };

typedef struct tuning_outcome {
    int32_t result; /* of the step that failed, or VBSS_OK */
    uint32_t steps;
    uint64_t hash;          /* after the last step */
    double attempts;        /* a step, mean */
    double penetration;     /* largest, m */
    double stretch;         /* largest error of a length, relative */
    double cpu_us, wall_us; /* a step, mean */
} tuning_outcome;

typedef struct tuning_scene {
    const char *name; /* of the golden scene */
    uint32_t steps;
    vbss_result (*run)(vbss_context *context, uint32_t steps, tuning_outcome *outcome);
} tuning_scene;

extern const tuning_scene tuning_scenes[TUNING_SCENES];

#endif
