/* Every part that a small scene takes, asked of the exact oracle. */
#ifndef VBSS_TESTS_SCENE_SMALL_WATCH_H
#define VBSS_TESTS_SCENE_SMALL_WATCH_H

#include "scene/drain_watch.h"
#include "scene/small.h"

typedef struct small_watch {
    uint64_t parts;
    uint64_t
        passed; /* pairs of axes that met in a part: of threads with themselves, of different bodies */
    uint64_t passed_drain; /* features of drains that met others, or their own */
    uint64_t below; /* axes and nodes that were under the floor's plane at the end of a part */
    double nearest_floor;          /* least height of one above it, m */
    passing_surface_report report; /* of the part in which the first passed a drain */
    drain_watch drains;
} small_watch;

void small_watch_begin(small *s, small_watch *w);
/* Asserts that nothing passed, in some parts. */
void small_watch_expect_nothing(const small_watch *w);

#endif
