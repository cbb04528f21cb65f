/* The faces of a plane diagram, for matrices that have a row a face. */
#ifndef VBSS_KNOT_FACES_H
#define VBSS_KNOT_FACES_H

#include "knot/knot.h"

/* At a crossing, seen with both strands going ahead. */
enum { KNOT_FRONT, KNOT_LEFT, KNOT_BACK, KNOT_RIGHT, KNOT_CORNERS };

/* Faces 0 to even - 1 are those of one colour of the chessboard, the others up to count - 1 those of the other;
 * faces that share an arc differ. Of each crossing those at its corners are in index[KNOT_CORNERS * crossing + corner].
 * False: the diagram is not plane (count is not n + 2), or has no crossing. All of `index` is overwritten; what is
 * behind index[KNOT_CORNERS * n] is free afterwards. */
typedef struct knot_faces {
    uint32_t count, even;
} knot_faces;
bool vbss_knot_find_faces(const knot_algebra *algebra, const knot_gauss_code *code,
                          knot_faces *faces);

#endif
