/* What passes through the drains of a scene in a part that it takes, asked of the exact oracle. */
#ifndef VBSS_TESTS_SCENE_DRAIN_WATCH_H
#define VBSS_TESTS_SCENE_DRAIN_WATCH_H

#include "oracle/surface.h"
#include "scene/api/api.h"
#include "scene/world/world.h"

enum { DRAIN_WATCH_DRAINS = 2, DRAIN_WATCH_NODES = 256 };

/* The sides of a drain, and which of its nodes are too near along its surface to touch. */
typedef struct drain_watch_near {
    const drain_object *drain;
    uint32_t sides[3 * DRAIN_WATCH_NODES][2];
    uint64_t near[DRAIN_WATCH_NODES][DRAIN_WATCH_NODES / 64];
} drain_watch_near;

typedef struct drain_watch {
    uint32_t count;
    drain_watch_near drains[DRAIN_WATCH_DRAINS];
} drain_watch;

/* Pairs that met between the begin and the trial state: threads and tools, and each drain, with each drain. What is known
 * of a drain is worked out when it is seen first. */
uint64_t drain_watch_passed(drain_watch *w, const scene_object *s, const passing_chain *chains,
                            size_t chain_count, passing_surface_report *report);

#endif
