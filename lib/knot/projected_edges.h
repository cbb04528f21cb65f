/* A closed polygon projected along a direction, with its edges in SIMD lanes and their boxes, for
 * projection.c. */
#ifndef VBSS_KNOT_PROJECTED_EDGES_H
#define VBSS_KNOT_PROJECTED_EDGES_H

#include "base/lanes.h"
#include "knot/knot.h"

enum { KNOT_NO_ENTRY = 0xffff };

typedef struct knot_projected_edges {
    uint32_t count;       /* number of edges; edge i starts at vertex i */
    uint32_t groups;      /* number of groups of LANES edges */
    double *x, *y, *z;    /* vertices; the first is repeated after the last */
    double *dx, *dy, *dz; /* edge vectors */
    double *bound;        /* the sum for two edges bounds the error of their cross product */
    /* boxes of edges, then of groups from index `grouped` on */
    double *low_x, *high_x, *low_y, *high_y;
    uint32_t grouped, spare;
    double size, error;          /* largest coordinate, and error bound of any coordinate */
    uint32_t *longs, long_count; /* edges without boxes */
    uint32_t *heads;             /* edge -> its first passage */
    knot_gauss_code *code;
    knot_diagram_status diagram; /* status so far */
    int64_t groups_tested;       /* number of groups that an edge was compared with */
} knot_projected_edges;

/* Projects the polygon. Returns false if a coordinate is not finite. */
bool vbss_knot_projected_edges_init(knot_projected_edges *edges, knot_projector *p,
                                    const knot_polygon *polygon, vec3 direction,
                                    knot_gauss_code *code);
/* Sets a box from an edge. Two boxes from index `spare` on are for edges without a box of their
 * own. */
void vbss_knot_projected_edges_set_box(knot_projected_edges *edges, uint32_t edge, uint32_t to);

#endif
