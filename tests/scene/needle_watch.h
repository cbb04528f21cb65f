/* Every substep of a needle beside a drain, and of threads that follow it, asked of the exact oracle: their axes meet no
 * triangle and no side, but for those of both that are near a hole. */
#ifndef VBSS_TESTS_SCENE_NEEDLE_WATCH_H
#define VBSS_TESTS_SCENE_NEEDLE_WATCH_H

#include "scene/needle_case.h"

enum { NEEDLE_WATCH_CAPSULES = 512, NEEDLE_WATCH_TRIANGLES = 512, NEEDLE_WATCH_SIDES = 768 };

typedef struct needle_watch {
    const needle_case *of;  /* NULL: of no case */
    uint32_t needle, drain; /* numbers of the bodies */
    bool threads;           /* all threads of the scene are watched as the needle is */
    double touching;        /* a crossing is that near to its hole, m, */
    double give;            /* and farther by so much for each N that the hole bears across, m/N */
    uint64_t parts, asked;  /* pairs that exact arithmetic decided */
    uint64_t passed;        /* pairs that met */
    passing_surface_report
        report; /* of the first part in which some did: capsule; triangle or side of the drain */
    /* what is near, of one part */
    uint32_t triangles[3 * NEEDLE_WATCH_TRIANGLES], sides[2 * NEEDLE_WATCH_SIDES];
    uint32_t triangle_names[NEEDLE_WATCH_TRIANGLES], side_names[NEEDLE_WATCH_SIDES];
} needle_watch;

/* A substep that the scene takes. */
void needle_watch_observe(needle_watch *w, const scene_object *s);
/* From now on; of a scene that has been made. */
void needle_watch_begin(needle_watch *w, const needle_case *c);

#endif
