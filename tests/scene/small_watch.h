/* Every part that a small scene takes, asked of the exact oracle. */
#ifndef VBSS_TESTS_SCENE_SMALL_WATCH_H
#define VBSS_TESTS_SCENE_SMALL_WATCH_H

#include "scene/small.h"

typedef struct small_watch {
    uint64_t parts;
    uint64_t
        passed; /* pairs of axes that met in a part: of threads with themselves, of different bodies */
    uint64_t below;       /* axes that were under the floor's plane at the end of a part */
    double nearest_floor; /* least height of an axis above it, m */
} small_watch;

void small_watch_begin(small *s, small_watch *w);
/* Asserts that nothing passed, in some parts. */
void small_watch_expect_nothing(const small_watch *w);

#endif
