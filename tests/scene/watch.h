/* Looks at every part of a step that a scene takes, and asks of each, exactly, whether anything passed through
 * anything: threads themselves, each other and the axes of tools; axes of tools those of other tools; any of
 * them the floor. Also whether each part begins where the last one ended, so that nothing is missed. */
#ifndef VBSS_TESTS_SCENE_WATCH_H
#define VBSS_TESTS_SCENE_WATCH_H

#include "oracle/passing.h"
#include "scene/api/api.h"
#include "scene/world/world.h"

enum { WATCH_CHAINS = 32, WATCH_NODES = 4096 };

typedef struct watch {
    uint64_t parts;
    uint64_t pairs, asked; /* of segments; of them, those that rational arithmetic decided */
    uint64_t passed;       /* pairs that met */
    uint64_t below;        /* nodes and ends of axes below the floor */
    uint64_t jumps;        /* parts that did not begin where the last ended */
    uint64_t first; /* part in which the first of all these was seen, from 1 on; 0: none was */
    passing_report report; /* of that part */
    double cost;           /* us of looking: not the scene's own */
    bool closes; /* looks at the rays along which knot_type.h closes the first thread, too */
    uint64_t
        closed_anew; /* parts in which one of them met the thread: another knot may be closed since */

    scene_object *scene;
    uint32_t count; /* of all nodes and ends of axes in the last part; 0: none yet */
    vec3 last[WATCH_NODES], start[WATCH_NODES], end[WATCH_NODES];
} watch;

/* Watches until the scene ends. After bodies came or went, or nodes were placed: begin again, counts go on. */
void watch_begin(watch *w, vbss_scene *scene);
void watch_again(watch *w);
/* Adds what another has counted. */
void watch_add(watch *w, const watch *other);
/* Of all that must be zero. */
uint64_t watch_faults(const watch *w);

#endif
