/* Certified crossings of features with zero thickness. */
#ifndef VBSS_COLLISION_CCD_CROSSING_H
#define VBSS_COLLISION_CCD_CROSSING_H

#include "collision/conservative_advancement.h"

/* Returns true if the interiors of the features certainly cross within 1e-6 of time t, for exactly
 * the given doubles. False means that nothing is known. */
bool vbss_collision_certifies_crossing(const collision_relative_motion *relative, bool edges,
                                       double t);

#endif
