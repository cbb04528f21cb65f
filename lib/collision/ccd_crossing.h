/* Certain crossings of zero thickness. */
#ifndef VBSS_COLLISION_CCD_CROSSING_H
#define VBSS_COLLISION_CCD_CROSSING_H

#include "collision/conservative_advancement.h"

/* True: the interiors of the features cross within 1e-6 of time t, the given doubles taken as they are.
 * False: nothing is known. */
bool vbss_collision_certifies_crossing(const collision_relative_motion *relative, bool edges,
                                       double t);

#endif
