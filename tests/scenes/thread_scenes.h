/* Threads in motion, the same for tests, bench and the determinism table. What hands do is worked out
 * from the number of the step alone, so that a restored thread goes on as the saved one. */
#ifndef VBSS_TESTS_SCENES_THREAD_SCENES_H
#define VBSS_TESTS_SCENES_THREAD_SCENES_H

#include <vblast_ss/thread.h>

typedef enum thread_scene_kind {
    THREAD_SCENE_RELEASE, /* a cantilever let go */
    THREAD_SCENE_TUGGED,  /* two hands, springs, a mass, a force, a pin that comes and goes */
    THREAD_SCENE_CUT      /* the same, cut in flight; each hand keeps its part */
} thread_scene_kind;

/* The step before which THREAD_SCENE_CUT is cut. */
enum { THREAD_SCENE_CUT_STEP = 40 };

typedef struct thread_scene {
    thread_scene_kind kind;
    vbss_thread *thread, *piece; /* piece: NULL until the cut */
    uint64_t steps;
} thread_scene;

/* The scene's own thread; callers may change it, such as its method or segment_count (from 12 on). */
vbss_result thread_scene_config(thread_scene_kind kind, vbss_thread_config *config);
vbss_result thread_scene_create(vbss_context *context, thread_scene_kind kind,
                                const vbss_thread_config *config, thread_scene *scene);
/* Hands, cut, and a step of h seconds of all parts. */
vbss_result thread_scene_step(thread_scene *scene, double h);
/* Of all parts. */
vbss_result thread_scene_hash(const thread_scene *scene, uint64_t *hash);

#endif
