/* Every substep of a scene of the task, asked of the exact oracle: threads, needle, tools and drain pass through nothing, but for
 * the needle and its thread at their holes. It also keeps the largest speed of any node. */
#ifndef VBSS_TESTS_SCENE_TASK_WATCH_H
#define VBSS_TESTS_SCENE_TASK_WATCH_H

#include "scene/needle_watch.h"

typedef struct task_watch {
    needle_watch needle; /* needle and threads against the drain */
    drain_watch drains;  /* tools against the drain, and the drain against itself */
    uint64_t substeps;
    uint64_t passed;       /* pairs of threads, needle and tools that met */
    uint64_t passed_drain; /* features of the drain that met a tool or each other */
    uint64_t below;        /* nodes and ends of axes below the floor */
    double fastest;        /* node of a thread or drain, m/s */
} task_watch;

/* From now on; of a scene with one needle and one drain. */
void task_watch_begin(task_watch *w, vbss_scene *scene);
/* Asserts that nothing passed, in some substeps. */
void task_watch_expect_nothing(const task_watch *w);

#endif
