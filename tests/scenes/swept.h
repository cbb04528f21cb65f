/* Polylines that are changed only by moves that are proved to keep their type: a vertex is inserted, removed or
 * moved over triangles that everything else stays away from by a margin. Slow, plain and far from rounding; it
 * shares nothing with the library.
 *
 * Rays belong to the line: those that go on from both ends, and one from the place in the tissue. Where they go
 * is kept too, so the type is that of the theta curve of line and tissue ray. */
#ifndef VBSS_TESTS_SCENES_SWEPT_H
#define VBSS_TESTS_SCENES_SWEPT_H

#include <stdint.h>

#include "base/linear.h"

enum { SWEPT_POINTS = 16384, SWEPT_BLOCK = 16, SWEPT_BLOCKS = SWEPT_POINTS / SWEPT_BLOCK };
#define SWEPT_RAY 1.0 /* m: so far rays go */

typedef struct swept_ray {
    uint32_t vertex; /* from there */
    vec3 end;
} swept_ray;

/* Vertices are numbered along the line once; some of them are gone. */
typedef struct swept_line {
    uint32_t slots, count; /* vertices ever; those that are left */
    uint32_t last;         /* the last vertex; the first is 0 */
    vec3 x[SWEPT_POINTS];
    double deviation[SWEPT_POINTS]; /* m: how far the curve strays from the edge after the vertex */
    bool stays[SWEPT_POINTS];
    uint32_t next[SWEPT_POINTS], previous[SWEPT_POINTS];
    vec3 low[SWEPT_BLOCKS], high[SWEPT_BLOCKS]; /* boxes of the edges that begin in a block */
    uint32_t ray_count;
    swept_ray rays[3];
    double margin; /* m */
} swept_line;

/* An empty line, and one vertex more; false when there are too many. */
void swept_begin(swept_line *line, double margin);
bool swept_put(swept_line *line, vec3 x, double deviation, bool stays);
/* Before any move: the vertices are all there. */
void swept_finish(swept_line *line);
void swept_put_ray(swept_line *line, uint32_t vertex, vec3 direction);

/* Before any move: whether the line is that of the curve whose deviations from its edges are given: no two parts come so near to
 * each other that they could change places, no corner folds back, and no ray comes near. */
bool swept_is_true(const swept_line *line);

/* Each false, with nothing changed, unless the move is proved. */
bool swept_remove(swept_line *line, uint32_t vertex);
bool swept_move(swept_line *line, uint32_t vertex, vec3 to);
/* A new vertex in the middle of the edge after one; false when there are too many. */
bool swept_split(swept_line *line, uint32_t vertex);

/* Removes vertices, those first whose neighbours' chord is near, until so many segments are left; splits the
 * longest edges when there are fewer. False when it cannot. */
bool swept_thin(swept_line *line, uint32_t segments);
/* Removes all that do not stay. */
bool swept_thin_all(swept_line *line);

/* Nothing of the line reaches the half space beyond vertex `end` (0 or last) in that direction. */
bool swept_end_is_outermost(const swept_line *line, uint32_t end, vec3 direction);

#endif
