/* Knots of VBLaST-SS (Qi et al. 2017): method PROJECTION of detectors. docs/explanation/paper-knots.md lists
 * the points that the paper leaves open. */
#ifndef VBSS_BASELINE_KNOTS_H
#define VBSS_BASELINE_KNOTS_H

#include "base/random.h"
#include "knot/knot.h"

/* A loop in the projection along a tool, where segments `first` and `last` cross. */
typedef struct baseline_loop {
    uint32_t tool, first, last, inside; /* inside: 1 if the loop surrounds the tool */
    vec3 meeting[2];                    /* where the projections cross, on each segment */
    bool first_is_above;
} baseline_loop;

typedef struct baseline_loops {
    uint32_t capacity; /* largest number of points */
    uint32_t loop_count, loop_capacity;
    baseline_loop *loops;
    double *flat;        /* x of all points, then y, then heights, m; `capacity` numbers each */
    vbss_random *random; /* generator of the detector */
} baseline_loops;

typedef struct baseline_detector {
    baseline_loops loops;
    uint32_t *rows; /* the loops for the view, four numbers each */
} baseline_detector;

/* Loops of one tool that one segment ties; `undone` counts crossings of loops that tie nothing. */
typedef struct baseline_throw {
    uint32_t loops, undone;
    bool first_is_above, inside_out; /* at the crossing that ties the most loops */
    uint32_t segment;
} baseline_throw;

/* ---- knot_throws.c */
baseline_throw vbss_baseline_find_throws(baseline_loops *p, const vbss_knot_detector_config *config,
                                         const knot_input *scene, uint32_t tool);

/* ---- knot_loops.c */

enum { BASELINE_LOOP_ARRAYS = 2 };
/* Lists the arrays of a loop search in threads of `capacity` points. */
void vbss_baseline_list_loop_arrays(baseline_loops *p, uint32_t capacity,
                                    vbss_array arrays[BASELINE_LOOP_ARRAYS]);

/* Appends the loops in the projection along a tool to p->loops, whether they surround it or not. */
void vbss_baseline_find_loops(baseline_loops *p, const vbss_knot_detector_config *config,
                              const knot_input *scene, uint32_t tool);

typedef struct plane_point {
    double x, y;
} plane_point;

/* The plane P, normal to a tool. The axis of the tool crosses it at the origin of its
 * coordinates, and heights above it grow towards the handle. */
typedef struct projection_plane {
    vec3 at, x, y, up;
} projection_plane;
projection_plane vbss_baseline_projection_plane(const vbss_knot_detector_config *config,
                                                const knot_tool *tool);
plane_point vbss_baseline_project_point(const projection_plane *plane, vec3 point);
double vbss_baseline_plane_height(const projection_plane *plane, vec3 point);
/* Projects all points of the thread: x, y and height of each point, in p->flat. */
void vbss_baseline_project_thread(baseline_loops *p, const projection_plane *plane,
                                  const knot_input *scene);

static inline const double *projected_x(const baseline_loops *p)
{
    return p->flat;
}

static inline const double *projected_y(const baseline_loops *p)
{
    return p->flat + p->capacity;
}

static inline const double *projected_heights(const baseline_loops *p)
{
    return p->flat + 2 * (size_t)p->capacity;
}

/* Returns whether a point is inside a loop, by the even-odd rule with a ray in a random
 * direction. The polygon runs from the meeting point through the points after the pair's first
 * segment to the start of its last segment. */
bool vbss_baseline_is_inside_loop(baseline_loops *p, plane_point meeting, uint32_t first,
                                  uint32_t last, plane_point point);

#endif
