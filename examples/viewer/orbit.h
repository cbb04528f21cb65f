/* A camera that keys move round a place. */
#ifndef VBSS_EXAMPLES_VIEWER_ORBIT_H
#define VBSS_EXAMPLES_VIEWER_ORBIT_H

#include <stdbool.h>

#include "window.h"

typedef struct orbit {
    point3 target;
    float at_first[2]; /* aside, away */
    float aside, down, away;
} orbit;

void orbit_begin(orbit *b, point3 target, float aside, float away);
/* Moves while its keys are down: arrows turn, page up and page down go nearer and away, home goes back. True: it has moved. */
bool orbit_step(orbit *b, const window *w, float seconds);
camera orbit_camera(const orbit *b);

#endif
