/* Where a needle may begin to poke at a drain: off its wall, on either side, all over it, clear of all of it. */
#ifndef VBSS_TESTS_SCENE_STAB_PLACES_H
#define VBSS_TESTS_SCENE_STAB_PLACES_H

#include "scene/needle_case.h"

/* What of the wall is before the tip. */
typedef enum stab_kind {
    STAB_FACE,
    STAB_NODE,
    STAB_SIDE,
    STAB_MARK,
    STAB_LIP,
    STAB_END,
    STAB_KINDS
} stab_kind;

typedef struct stab_place {
    stab_kind kind;
    bool inside;
    vec3 tip, direction, aside;
    uint32_t tries; /* until it was clear */
} stab_place;

/* Of the drain as it is now, and the needle; up to so far beyond touching. */
stab_place stab_places_draw(const needle_case *c, double farthest, vbss_random *random);

#endif
