/* Limbs that lie about: longer lines of the same type. */
#ifndef VBSS_TESTS_SCENES_CLUTTER_H
#define VBSS_TESTS_SCENES_CLUTTER_H

#include <stdint.h>

#include "scenes/throw_stack.h"

/* A limb goes on from its end: it climbs all the time along `up`, above everything else, and so cannot be knotted,
 * wanders to and fro over a place with curls on its way, and ends straight up. */
typedef struct clutter {
    bool tail;       /* which limb */
    vec3 up;         /* unit */
    vec3 over;       /* the place */
    double reach;    /* m: it stays so near to the axis through that place along `up` */
    double slope;    /* how steep it is; 0.05 and less lies in flat coils */
    uint32_t passes; /* how often it turns */
} clutter;
/* False when something lies higher than that end, when it would come beyond the other end, or when there are
 * too many points. */
bool clutter_limb(thread_line *line, const clutter *how, uint64_t seed);

/* A throw of the limb round itself, tied a little beyond its end; it goes on straight behind that, m. False when there
 * are too many points. */
bool clutter_throw(thread_line *line, bool tail, int wraps, int sign, double size, double behind);

/* A limb loses a share of its way from its end to the tissue (or to the middle). */
void clutter_cut(thread_line *line, bool tail, double share);

#endif
