/* Faces of a planar diagram, for matrices with one row for each face. */
#ifndef VBSS_KNOT_FACES_H
#define VBSS_KNOT_FACES_H

#include "knot/knot.h"

/* Faces at a crossing, seen with both strands going forward. */
enum { KNOT_FRONT, KNOT_LEFT, KNOT_BACK, KNOT_RIGHT, KNOT_CORNERS };

/* Finds the faces. Faces 0 to even - 1 have one colour of the checkerboard, the others up to count
 * - 1 the other; faces that share an arc differ in colour. algebra->index[KNOT_CORNERS * crossing +
 * corner] is the face at a corner. Returns false if the diagram is not planar (count is not n + 2)
 * or has no crossing. Overwrites all of `index`; entries after KNOT_CORNERS * n are free
 * afterwards. */
typedef struct knot_faces {
    uint32_t count, even;
} knot_faces;
bool vbss_knot_find_faces(const knot_algebra *algebra, const knot_gauss_code *code,
                          knot_faces *faces);

#endif
