/* A closed polygon seen along a direction, its edges side by side in lanes and in boxes. For projection.c. */
#ifndef VBSS_KNOT_PROJECTED_EDGES_H
#define VBSS_KNOT_PROJECTED_EDGES_H

#include "base/lanes.h"
#include "knot/knot.h"

enum { KNOT_NO_ENTRY = 0xffff };

typedef struct knot_projected_edges {
    uint32_t count;       /* of edges; edge i begins at vertex i */
    uint32_t groups;      /* of LANES edges each */
    double *x, *y, *z;    /* of vertices; the first stands again behind the last */
    double *dx, *dy, *dz; /* along edges */
    double *bound;        /* those of two edges add up to what their turns may be wrong by */
    double *low_x, *high_x, *low_y, *high_y; /* of edges, then of groups from `grouped` on */
    uint32_t grouped, spare;
    double size, error;          /* largest coordinate; what any may be wrong by */
    uint32_t *longs, long_count; /* edges without boxes */
    uint32_t *heads;             /* of each edge: its first passage */
    knot_gauss_code *code;
    knot_diagram_status diagram; /* what it is so far */
    int64_t groups_tested;       /* groups of edges that one edge was compared with */
} knot_projected_edges;

/* False: some coordinates are no numbers. */
bool vbss_knot_projected_edges_init(knot_projected_edges *edges, knot_projector *p,
                                    const knot_polygon *polygon, vec3 direction,
                                    knot_gauss_code *code);
/* Two boxes from `spare` on are for edges that have none of their own. */
void vbss_knot_projected_edges_set_box(knot_projected_edges *edges, uint32_t edge, uint32_t to);

#endif
