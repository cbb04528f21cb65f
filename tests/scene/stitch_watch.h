/* An oracle of its own for stitches: after every step the lines of all threads are cut with all triangles of the drain. */
#ifndef VBSS_TESTS_SCENE_STITCH_WATCH_H
#define VBSS_TESTS_SCENE_STITCH_WATCH_H

#include "scene/small.h"

enum { STITCH_WATCH_HOLES = 16 };

typedef struct stitch_watch {
    uint32_t crossings, holes; /* of the last step */
    /* Of all steps: crossings at no hole of their suture; holes that are farther from their suture than touching. */
    uint64_t away, missed;
    /* Most of all steps, in distances of touching: from a crossing to its hole; from a hole to its suture. */
    double farthest, loosest;
} stitch_watch;

void stitch_watch_observe(stitch_watch *w, vbss_scene *scene, vbss_drain *drain);
/* All holes of the scene; how many. */
uint32_t stitch_watch_holes(vbss_scene *scene, vbss_scene_hole holes[STITCH_WATCH_HOLES]);
/* The thread with that number, or NULL. */
vbss_thread *stitch_watch_thread(vbss_scene *scene, uint32_t body);

#endif
