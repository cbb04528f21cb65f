/* Rotation of a polygon to the frame of a direction, and boxes of its edges.
 *
 * Edges in the lanes of one group are neighbours on the curve, and the group has a box. Edges much
 * longer than most, those of a closure, have no box, because they would overlap every group. */
#include "knot/projected_edges.h"
#include "knot/tuning.h"

enum { FLAT_ARRAYS = 7, BOX_ARRAYS = 4 };

/* A coordinate in the frame is wrong by four roundings (moved, then turned) of a vector's length, which is at
 * most sqrt(3) times the largest coordinate. */
#define COORDINATE_ERROR (8.0 * 0x1p-53)

/* ---- arrays */

/* A multiple of LANES with room for at least one more. */
static uint32_t padded(uint32_t count)
{
    return count / LANES * LANES + LANES;
}

/* Two extra boxes for long edges while they are tested. */
static uint32_t padded_groups(uint32_t wide)
{
    return padded(wide / LANES) + 2;
}

void vbss_knot_projector_arrays(knot_projector *p, uint32_t capacity,
                                vbss_array arrays[KNOT_PROJECTOR_ARRAYS])
{
    uint32_t wide = padded(capacity), grouped = padded_groups(wide);
    p->capacity = capacity;
    arrays[0] = (vbss_array){&p->flat, FLAT_ARRAYS * (size_t)wide, sizeof *p->flat};
    arrays[1] = (vbss_array){&p->boxes, BOX_ARRAYS * (size_t)(wide + grouped), sizeof *p->boxes};
    arrays[2] = (vbss_array){&p->order, 2 * (size_t)capacity, sizeof *p->order};
}

static knot_projected_edges projected_edges_in(knot_projector *p, uint32_t count,
                                               knot_gauss_code *code)
{
    uint32_t wide = padded(count), all = wide + padded_groups(wide);
    double *flat = p->flat, *boxes = p->boxes;
    return (knot_projected_edges){.count = count,
                                  .groups = wide / LANES,
                                  .x = flat,
                                  .y = flat + wide,
                                  .z = flat + 2 * (size_t)wide,
                                  .dx = flat + 3 * (size_t)wide,
                                  .dy = flat + 4 * (size_t)wide,
                                  .dz = flat + 5 * (size_t)wide,
                                  .bound = flat + 6 * (size_t)wide,
                                  .low_x = boxes,
                                  .high_x = boxes + all,
                                  .low_y = boxes + 2 * (size_t)all,
                                  .high_y = boxes + 3 * (size_t)all,
                                  .grouped = wide,
                                  .spare = wide + padded(wide / LANES),
                                  .heads = p->order,
                                  .longs = p->order + count,
                                  .code = code};
}

/* ---- edges */

/* Coordinates are relative to a vertex in the middle, which does not belong to a closure. Returns
 * false if one is not finite. */
static bool rotate_to_frame(knot_projected_edges *s, const vec3 *x, vec3 direction)
{
    vec3 right = vec3_any_normal(direction), ahead = vec3_cross(direction, right);
    vec3 origin = x[s->count / 2];
    double size = 0.0;
    for (uint32_t i = 0; i < s->count; i++) {
        vec3 v = vec3_sub(x[i], origin);
        vec3 at = vec3_make(vec3_dot(right, v), vec3_dot(ahead, v), vec3_dot(direction, v));
        s->x[i] = at.x;
        s->y[i] = at.y;
        s->z[i] = at.z;
        size = vbss_max_or_nan(vbss_max_or_nan(vbss_max_or_nan(size, fabs(at.x)), fabs(at.y)),
                               fabs(at.z));
    }
    s->x[s->count] = s->x[0];
    s->y[s->count] = s->y[0];
    s->z[s->count] = s->z[0];
    s->size = size;
    s->error = COORDINATE_ERROR * size;
    return size <= DBL_MAX;
}

/* The cross product of two edges with overlapping boxes is wrong by at most 2.75 errors for each
 * difference in it, including rounding of products, plus 10 squares of the error. */
static double set_edges(knot_projected_edges *s)
{
    double sum = 0.0;
    for (uint32_t i = 0; i < s->count; i++) {
        s->dx[i] = s->x[i + 1] - s->x[i];
        s->dy[i] = s->y[i + 1] - s->y[i];
        s->dz[i] = s->z[i + 1] - s->z[i];
        double length = fabs(s->dx[i]) + fabs(s->dy[i]);
        s->bound[i] = s->error * (9.0 * length + 16.0 * s->error);
        s->heads[i] = KNOT_NO_ENTRY;
        sum += length;
    }
    for (uint32_t i = s->count; i < LANES * s->groups; i++) { /* unused lanes */
        s->dx[i] = s->dy[i] = s->bound[i] = 0.0;
        s->x[i] = i == s->count ? s->x[i] : 0.0;
        s->y[i] = i == s->count ? s->y[i] : 0.0;
    }
    return sum;
}

/* ---- boxes */

static void set_empty_box(knot_projected_edges *s, uint32_t at)
{
    s->low_x[at] = s->low_y[at] = DBL_MAX;
    s->high_x[at] = s->high_y[at] = -DBL_MAX;
}

static double longest_with_box(const knot_projected_edges *s, double sum)
{
    double mean = sum / s->count, short_sum = 0.0, shorts = 0.0;
    for (uint32_t i = 0; i < s->count; i++) {
        double length = fabs(s->dx[i]) + fabs(s->dy[i]);
        bool is_short = length <= mean;
        short_sum += is_short ? length : 0.0;
        shorts += is_short ? 1.0 : 0.0;
    }
    return shorts > 0.0 ? KNOT_LONG_EDGE_RATIO * (short_sum / shorts) : mean;
}

void vbss_knot_projected_edges_set_box(knot_projected_edges *s, uint32_t i, uint32_t to)
{
    s->low_x[to] = vbss_min(s->x[i], s->x[i + 1]) - s->error;
    s->high_x[to] = vbss_max(s->x[i], s->x[i + 1]) + s->error;
    s->low_y[to] = vbss_min(s->y[i], s->y[i + 1]) - s->error;
    s->high_y[to] = vbss_max(s->y[i], s->y[i + 1]) + s->error;
}

/* Edges longer than `longest` get no box, if they are few. */
static void box_edges(knot_projected_edges *s, double longest)
{
    uint32_t max_long = s->count / 16 + LANES;
    for (uint32_t i = 0; i < s->count; i++) {
        if (fabs(s->dx[i]) + fabs(s->dy[i]) > longest && s->long_count < max_long) {
            s->longs[s->long_count++] = i;
            set_empty_box(s, i);
        } else {
            vbss_knot_projected_edges_set_box(s, i, i);
        }
    }
    for (uint32_t i = s->count; i < s->groups * LANES; i++) {
        set_empty_box(s, i);
    }
}

static void box_groups(knot_projected_edges *s)
{
    for (uint32_t g = 0; g < s->groups; g++) {
        uint32_t to = s->grouped + g;
        set_empty_box(s, to);
        for (uint32_t i = LANES * g; i < LANES * (g + 1); i++) {
            s->low_x[to] = vbss_min(s->low_x[to], s->low_x[i]);
            s->high_x[to] = vbss_max(s->high_x[to], s->high_x[i]);
            s->low_y[to] = vbss_min(s->low_y[to], s->low_y[i]);
            s->high_y[to] = vbss_max(s->high_y[to], s->high_y[i]);
        }
    }
    for (uint32_t to = s->grouped + s->groups; to < s->spare; to++) {
        set_empty_box(s, to);
    }
}

bool vbss_knot_projected_edges_init(knot_projected_edges *s, knot_projector *p,
                                    const knot_polygon *polygon, vec3 direction,
                                    knot_gauss_code *code)
{
    *s = projected_edges_in(p, polygon->count, code);
    if (!rotate_to_frame(s, polygon->x, direction)) {
        return false;
    }
    double sum = set_edges(s);
    box_edges(s, longest_with_box(s, sum));
    box_groups(s);
    return true;
}
