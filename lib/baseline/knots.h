/* Knots by VBLaST-SS (Qi et al. 2017): method PROJECTION of detectors. docs/paper-knots.md tells what the paper leaves
 * open. */
#ifndef VBSS_BASELINE_KNOTS_H
#define VBSS_BASELINE_KNOTS_H

#include "base/random.h"
#include "knot/knot.h"

/* A loop about a tool: the projections of segments `first` and `last` cross. */
typedef struct baseline_loop {
    uint32_t tool, first, last, inside; /* as the view shows them */
    vec3 meeting[2];                    /* where the pair's projections cross, on each segment */
    bool first_is_above;
} baseline_loop;

typedef struct baseline_loops {
    uint32_t capacity; /* of points */
    uint32_t loop_count, loop_capacity;
    baseline_loop *loops;
    double *flat;        /* x of all points, then y, then heights, m; `capacity` of each */
    vbss_random *random; /* of the detector */
} baseline_loops;

typedef struct baseline_detector {
    baseline_loops loops;
    uint32_t *rows; /* x 4: the loops as the view shows them */
} baseline_detector;

/* Loops of a tool that one segment crosses so that they tie, and crossings that do not. */
typedef struct baseline_throw {
    uint32_t loops, undone;
    bool first_is_above, inside_out; /* of the crossing that ties most */
    uint32_t segment;
} baseline_throw;

/* ---- knot_throws.c */
baseline_throw vbss_baseline_find_throws(baseline_loops *p, const vbss_knot_config *config,
                                         const knot_input *scene, uint32_t tool);

/* ---- knot_loops.c */

/* Arrays of a search in threads of so many points. */
enum { BASELINE_LOOP_ARRAYS = 2 };
void vbss_baseline_list_loop_arrays(baseline_loops *p, uint32_t capacity,
                                    vbss_array arrays[BASELINE_LOOP_ARRAYS]);

/* Appends the loops about a tool to p->loops, whether the tool is inside or not. */
void vbss_baseline_find_loops(baseline_loops *p, const vbss_knot_config *config,
                              const knot_input *scene, uint32_t tool);

typedef struct plane_point {
    double x, y;
} plane_point;

/* The plane P normal to a tool, whose axis crosses it at the origin of its coordinates; heights above
 * it grow towards the handle. */
typedef struct projection_plane {
    vec3 at, x, y, up;
} projection_plane;
projection_plane vbss_baseline_projection_plane(const vbss_knot_config *config,
                                                const knot_tool *tool);
plane_point vbss_baseline_project_point(const projection_plane *plane, vec3 point);
double vbss_baseline_plane_height(const projection_plane *plane, vec3 point);
/* All of the thread: x, y and height of each point, in p->flat. */
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

/* Even-odd rule with a ray in a random direction, for the polygon from the meeting point through the points
 * after the first segment of the pair to the last segment's begin. */
bool vbss_baseline_is_inside_loop(baseline_loops *p, plane_point meeting, uint32_t first,
                                  uint32_t last, plane_point point);

#endif
