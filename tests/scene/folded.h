/* How many triangles of a drain are turned over or collapsed, counted from positions alone: one whose neighbour is folded
 * back over it so far that it reaches beyond it, or that has less than a hundredth of its area at rest. */
#ifndef VBSS_TESTS_SCENE_FOLDED_H
#define VBSS_TESTS_SCENE_FOLDED_H

#include <vblast_ss/drain.h>

uint32_t folded_triangles(const vbss_drain *drain);

#endif
