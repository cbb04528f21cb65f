/* A thread in a hole of a host surface. Two tools draw it to and fro through the hole at random speeds, in random
 * directions. After every step its crossings of the surface are counted and measured. */
#ifndef VBSS_TESTS_SCENE_HOLE_LIFE_H
#define VBSS_TESTS_SCENE_HOLE_LIFE_H

#include "base/random.h"
#include "harness/harness.h"

typedef struct hole_life_result {
    uint64_t steps, clamped;
    /* Steps in which the thread crosses the surface several times, of which one is where contact is complete. */
    uint64_t several;
    uint64_t
        far; /* steps with a crossing that is farther from the hole than 4 contact distances and 1.2 segments */
    double slid;     /* through holes, m */
    double farthest; /* crossing from its hole, m */
} hole_life_result;

typedef struct hole_life_hands {
    double speed;  /* largest of the tools, m/s */
    double thrown; /* every 20 steps the thread gets a velocity up to this, m/s; 0: never */
} hole_life_hands;

/* Lives that number of steps, less if the thread leaves its hole, and adds to the result. */
vbss_result hole_life_run(vbss_random *random, uint32_t steps, const hole_life_hands *hands,
                          hole_life_result *result);

#endif
