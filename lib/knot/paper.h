/* Projection along a tool, shared by both criteria of method PROJECTION (paper_loops.c,
 * paper_throws.c). */
#ifndef VBSS_KNOT_PAPER_H
#define VBSS_KNOT_PAPER_H

#include "knot/knot.h"

typedef struct paper_point {
    double x, y;
} paper_point;

/* The plane P normal to a tool. The tool's axis crosses it at the origin of its coordinates;
 * heights above it increase toward the handle. */
typedef struct paper_plane {
    vec3 at, x, y, up;
} paper_plane;
paper_plane vbss_knot_paper_plane(const vbss_knot_config *config, const knot_tool *tool);
paper_point vbss_knot_paper_flat(const paper_plane *plane, vec3 point);
double vbss_knot_paper_height(const paper_plane *plane, vec3 point);
/* Projects the whole thread: x, y and height of each point, to p->flat. */
void vbss_knot_paper_project(knot_paper *p, const paper_plane *plane, const knot_input *scene);

static inline const double *paper_x(const knot_paper *p)
{
    return p->flat;
}

static inline const double *paper_y(const knot_paper *p)
{
    return p->flat + p->capacity;
}

static inline const double *paper_heights(const knot_paper *p)
{
    return p->flat + 2 * (size_t)p->capacity;
}

/* Even-odd rule with a ray in a random direction. The polygon runs from the crossing point of a
 * pair of segments through the points after the first segment to the start of the last segment. */
bool vbss_knot_paper_inside(knot_paper *p, paper_point meeting, uint32_t first, uint32_t last,
                            paper_point point);

#endif
