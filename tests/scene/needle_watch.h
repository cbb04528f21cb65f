/* Every part that a needle takes beside a drain, asked of the exact oracle: its axes meet no triangle and no side on the way,
 * but for those of both that are near a hole. What drives by at a step's end only would not show it. */
#ifndef VBSS_TESTS_SCENE_NEEDLE_WATCH_H
#define VBSS_TESTS_SCENE_NEEDLE_WATCH_H

#include "scene/needle_case.h"

enum { NEEDLE_WATCH_CAPSULES = 64, NEEDLE_WATCH_TRIANGLES = 512, NEEDLE_WATCH_SIDES = 768 };

typedef struct needle_watch {
    const needle_case *of;
    uint64_t parts, asked; /* pairs that exact arithmetic decided */
    uint64_t passed;       /* pairs that met */
    passing_surface_report
        report; /* of the first part in which some did: capsule; triangle or side of the drain */
    /* what is near, of one part */
    uint32_t triangles[3 * NEEDLE_WATCH_TRIANGLES], sides[2 * NEEDLE_WATCH_SIDES];
    uint32_t triangle_names[NEEDLE_WATCH_TRIANGLES], side_names[NEEDLE_WATCH_SIDES];
} needle_watch;

/* From now on; of a scene that has been made. */
void needle_watch_begin(needle_watch *w, const needle_case *c);

#endif
