/* Method PROJECTION, criterion 1: loops of the thread that close around a tool in the projection
 * along it (Qi et al. 2017, section 5, algorithm 4). The method keeps the misses and false
 * detections of the paper: docs/explanation/paper-knots.md.
 *
 * As in the paper, the line of the tool has no ends, and a loop ends at the first segment that
 * crosses it. The search for the next loop starts after that segment. The paper does not define
 * at which end segment 0 is. */
#include "baseline/knots.h"

#include "base/elementary.h"
#include "base/lanes.h"
#include "base/pi.h"

/* A loop takes at least three segments, so all loops of sixteen tools fit. Derived. */
enum { MAX_TOOLS = 16, LOOP_SEGMENTS = 3 };

void vbss_baseline_list_loop_arrays(baseline_loops *p, uint32_t capacity,
                                    vbss_array arrays[BASELINE_LOOP_ARRAYS])
{
    p->capacity = capacity;
    p->loop_capacity = MAX_TOOLS * (capacity / LOOP_SEGMENTS);
    arrays[0] = (vbss_array){&p->loops, p->loop_capacity, sizeof *p->loops};
    /* The last load of lanes may read beyond the last point. */
    arrays[1] = (vbss_array){&p->flat, 3 * (size_t)capacity + LANES, sizeof *p->flat};
}

/* ---- the projection */

projection_plane vbss_baseline_projection_plane(const vbss_knot_detector_config *config,
                                                const knot_tool *tool)
{
    vec3 tip = tool->axis[tool->point_count - 1], behind = tool->axis[tool->point_count - 2];
    projection_plane plane;
    plane.up = vec3_unit_or(vec3_sub(behind, tip), vec3_make(0.0, 0.0, 1.0));
    plane.at = vec3_add_scaled(tip, config->plane_offset, plane.up);
    plane.x = vec3_any_normal(plane.up);
    plane.y = vec3_cross(plane.up, plane.x);
    return plane;
}

plane_point vbss_baseline_project_point(const projection_plane *plane, vec3 point)
{
    vec3 r = vec3_sub(point, plane->at);
    plane_point flat = {vec3_dot(r, plane->x), vec3_dot(r, plane->y)};
    return flat;
}

double vbss_baseline_plane_height(const projection_plane *plane, vec3 point)
{
    return vec3_dot(vec3_sub(point, plane->at), plane->up);
}

void vbss_baseline_project_thread(baseline_loops *p, const projection_plane *plane,
                                  const knot_input *scene)
{
    double *x = p->flat, *y = x + p->capacity, *heights = y + p->capacity;
    for (uint32_t k = 0; k < scene->point_count; k++) {
        plane_point flat = vbss_baseline_project_point(plane, scene->points[k]);
        x[k] = flat.x;
        y[k] = flat.y;
        heights[k] = vbss_baseline_plane_height(plane, scene->points[k]);
    }
}

/* ---- the even-odd rule */

/* Returns a corner in the coordinates of the ray: the distance along it, and the distance to its
 * left. */
static inline plane_point from_ray(plane_point ray, double x, double y)
{
    plane_point seen = {ray.x * x + ray.y * y, ray.x * y - ray.y * x};
    return seen;
}

/* Returns whether the ray meets an edge. One end must be on its left and the other not, so that
 * a corner on the ray counts once. */
static inline bool ray_meets(plane_point a, plane_point b)
{
    if ((a.y < 0.0) == (b.y < 0.0)) {
        return false;
    }
    double along = a.x * b.y - b.x * a.y; /* multiplied by b.y - a.y */
    return b.y > a.y ? along > 0.0 : along < 0.0;
}

bool vbss_baseline_is_inside_loop(baseline_loops *p, plane_point meeting, uint32_t first,
                                  uint32_t last, plane_point point)
{
    const double *x = projected_x(p), *y = projected_y(p);
    plane_point ray;
    vbss_sincos(VBSS_TWO_PI * vbss_random_uniform(p->random), &ray.y, &ray.x);
    plane_point begin = from_ray(ray, meeting.x - point.x, meeting.y - point.y), a = begin;
    bool odd = false;
    for (uint32_t k = first + 1; k <= last; k++) {
        plane_point b = from_ray(ray, x[k] - point.x, y[k] - point.y);
        odd ^= ray_meets(a, b);
        a = b;
    }
    return odd ^ ray_meets(a, begin);
}

/* ---- algorithm 4 */

static inline double cross(double ax, double ay, double bx, double by)
{
    return ax * by - ay * bx;
}

/* Returns whether the projections of two segments cross; if so, sets the fractions s and u of
 * both. A point on the line of the other segment counts as left of it, so a crossing at a point
 * belongs to one segment only. */
static bool segments_cross(const baseline_loops *p, uint32_t i, uint32_t j, double *s, double *u)
{
    const double *x = projected_x(p), *y = projected_y(p);
    double ax = x[i + 1] - x[i], ay = y[i + 1] - y[i];
    double bx = x[j + 1] - x[j], by = y[j + 1] - y[j];
    double a0 = cross(bx, by, x[i] - x[j], y[i] - y[j]);
    double a1 = cross(bx, by, x[i + 1] - x[j], y[i + 1] - y[j]);
    double b0 = cross(ax, ay, x[j] - x[i], y[j] - y[i]);
    double b1 = cross(ax, ay, x[j + 1] - x[i], y[j + 1] - y[i]);
    if ((a0 < 0.0) == (a1 < 0.0) || (b0 < 0.0) == (b1 < 0.0)) {
        return false;
    }
    *s = a0 / (a0 - a1);
    *u = b0 / (b0 - b1);
    return true;
}

/* Returns a bit mask of the four segments from j on whose boxes overlap that of segment i. */
static inline unsigned near_four(const baseline_loops *p, const lanes box[4], uint32_t j)
{
    const double *x = projected_x(p) + j, *y = projected_y(p) + j;
    lanes x0 = lanes_load(x), x1 = lanes_load(x + 1), y0 = lanes_load(y), y1 = lanes_load(y + 1);
    lanes_mask across =
        lanes_or(lanes_less(lanes_max(x0, x1), box[0]), lanes_less(box[1], lanes_min(x0, x1)));
    lanes_mask along =
        lanes_or(lanes_less(lanes_max(y0, y1), box[2]), lanes_less(box[3], lanes_min(y0, y1)));
    return 15u & ~lanes_movemask(lanes_or(across, along));
}

/* Searches from segment i toward the end of the tail for the first segment that crosses i and is
 * not adjacent to it. Returns i if there is none. */
static uint32_t next_crossing(const baseline_loops *p, uint32_t i, double *s, double *u)
{
    const double *x = projected_x(p), *y = projected_y(p);
    lanes box[4] = {lanes_splat(vbss_min(x[i], x[i + 1])), lanes_splat(vbss_max(x[i], x[i + 1])),
                    lanes_splat(vbss_min(y[i], y[i + 1])), lanes_splat(vbss_max(y[i], y[i + 1]))};
    for (uint32_t end = i - 1; end > 0;) {
        uint32_t begin = end > LANES ? end - LANES : 0;
        unsigned near = near_four(p, box, begin);
        for (uint32_t j = end; near != 0 && j-- > begin;) {
            if ((near >> (j - begin) & 1u) != 0 && segments_cross(p, i, j, s, u)) {
                return j;
            }
        }
        end = begin;
    }
    return i;
}

static void record(baseline_loops *p, const projection_plane *plane, const knot_input *scene,
                   uint32_t tool, uint32_t i, uint32_t j, double s, double u)
{
    const vec3 *x = scene->points;
    baseline_loop loop = {.tool = tool, .first = j, .last = i};
    loop.meeting[0] = vec3_lerp(x[j], x[j + 1], u);
    loop.meeting[1] = vec3_lerp(x[i], x[i + 1], s);
    loop.first_is_above = vbss_baseline_plane_height(plane, loop.meeting[0]) >
                          vbss_baseline_plane_height(plane, loop.meeting[1]);
    plane_point t = {0.0, 0.0}, meeting = vbss_baseline_project_point(plane, loop.meeting[0]);
    loop.inside = vbss_baseline_is_inside_loop(p, meeting, j, i, t) ? 1 : 0;
    p->loops[p->loop_count++] = loop;
}

/* The paper's segment 0 is the last segment here, at the end of the long limb. */
void vbss_baseline_find_loops(baseline_loops *p, const vbss_knot_detector_config *config,
                              const knot_input *scene, uint32_t tool)
{
    projection_plane plane = vbss_baseline_projection_plane(config, &scene->tools[tool]);
    vbss_baseline_project_thread(p, &plane, scene);
    uint32_t left = scene->point_count - 1; /* segments 0 to left - 1 are unused */
    while (left >= LOOP_SEGMENTS && p->loop_count < p->loop_capacity) {
        double s, u;
        uint32_t i = left - 1, j = next_crossing(p, i, &s, &u);
        if (j < i) {
            record(p, &plane, scene, tool, i, j, s, u);
        }
        left = j;
    }
}
