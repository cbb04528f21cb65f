/* The diagram of a closed polygon projected along a direction, provided that every crossing is
 * certain.
 *
 * Vertices are rotated to a frame whose z axis points to the eye. The errors of this and of all
 * later values have bounds that every decision must exceed. All polygons within rounding of this
 * one then have the same diagram, and so the same knot. */
#include "base/compiler.h"
#include "base/elementary.h"
#include "knot/projected_edges.h"
#include "knot/tuning.h"

/* ---- two edges */

/* Inserts a passage into the list of its edge, in order. */
static void add_passage(knot_projected_edges *s, uint32_t edge, uint32_t entry, double at)
{
    knot_gauss_code *code = s->code;
    uint16_t *next = code->scratch;
    uint32_t before = KNOT_NO_ENTRY, after = s->heads[edge];
    while (after != KNOT_NO_ENTRY && code->position[after] < at) {
        before = after;
        after = next[after];
    }
    code->position[entry] = at;
    next[entry] = (uint16_t)after;
    if (before == KNOT_NO_ENTRY) {
        s->heads[edge] = entry;
    } else {
        next[before] = (uint16_t)entry;
    }
}

/* Adds a crossing: entry 2 n for the over passage, 2 n + 1 for the under passage. */
static knot_diagram_status add_crossing(knot_projected_edges *s, uint32_t over, double at_over,
                                        uint32_t under, double at_under, int sign)
{
    knot_gauss_code *code = s->code;
    if (code->n == code->capacity) {
        return KNOT_DIAGRAM_FULL;
    }
    code->sign[code->n] = (int8_t)sign;
    add_passage(s, over, 2 * code->n, at_over);
    add_passage(s, under, 2 * code->n + 1, at_under);
    code->n++;
    return KNOT_DIAGRAM_REGULAR;
}

/* Sign of the crossing, the sign of the volume (from j to i) . (i x j), which is the height of i
 * above j at the crossing times their cross product d. 0 if uncertain. */
static int sign_of(const knot_projected_edges *s, uint32_t i, uint32_t j, double d)
{
    double bx = s->x[i] - s->x[j], by = s->y[i] - s->y[j], bz = s->z[i] - s->z[j];
    double nx = s->dy[i] * s->dz[j] - s->dz[i] * s->dy[j];
    double ny = s->dz[i] * s->dx[j] - s->dx[i] * s->dz[j];
    double volume = bx * nx + by * ny + bz * d;
    double i_long = fabs(s->dx[i]) + fabs(s->dy[i]) + fabs(s->dz[i]);
    double j_long = fabs(s->dx[j]) + fabs(s->dy[j]) + fabs(s->dz[j]);
    double b_long = fabs(bx) + fabs(by) + fabs(bz);
    double products = i_long * j_long + b_long * (i_long + j_long);
    double error = s->error * (8.0 * products + 64.0 * s->error * (i_long + j_long + b_long));
    double bound = vbss_max(error, KNOT_NEAR_HEIGHT * s->size * fabs(d));
    return (volume > bound) - (volume < -bound);
}

/* Positive if 0 and d are certainly on the same side of `from`. */
static double outside(double from, double d)
{
    double to = from - d;
    return vbss_max(vbss_min(from, to), -vbss_max(from, to));
}

/* Intersects two edges with overlapping boxes. They cross at the fractions from_i / d and from_j /
 * d. They are disjoint if one has both ends on the same side of the other. */
static knot_diagram_status intersect_edges(knot_projected_edges *s, uint32_t i, uint32_t j)
{
    double bx = s->x[j] - s->x[i], by = s->y[j] - s->y[i];
    double d = s->dx[i] * s->dy[j] - s->dy[i] * s->dx[j];
    double from_i = bx * s->dy[j] - by * s->dx[j], from_j = bx * s->dy[i] - by * s->dx[i];
    double bound = s->bound[i] + s->bound[j], near = KNOT_NEAR_PLACE * fabs(d);
    double outside_i = outside(from_i, d), outside_j = outside(from_j, d);
    if (vbss_max(outside_i, outside_j) > bound) {
        return KNOT_DIAGRAM_REGULAR;
    }
    /* With this bound, the error of the fractions is at most half of NEAR_PLACE. */
    if (!(4.0 * bound < near && vbss_max(outside_i, outside_j) < -near)) {
        return KNOT_DIAGRAM_DEGENERATE;
    }
    int sign = sign_of(s, i, j, d);
    if (sign == 0) {
        return KNOT_DIAGRAM_DEGENERATE;
    }
    double at_i = i + from_i / d, at_j = j + from_j / d;
    return (sign > 0) == (d > 0.0) ? add_crossing(s, i, at_i, j, at_j, sign)
                                   : add_crossing(s, j, at_j, i, at_i, sign);
}

/* ---- one edge and a group: bit mask of the edges that it may cross */

VBSS_ALWAYS_INLINE unsigned box_bits(const knot_projected_edges *s, uint32_t box, uint32_t at)
{
    lanes_mask x = lanes_or(lanes_less(lanes_splat(s->high_x[box]), lanes_load(s->low_x + at)),
                            lanes_less(lanes_load(s->high_x + at), lanes_splat(s->low_x[box])));
    lanes_mask y = lanes_or(lanes_less(lanes_splat(s->high_y[box]), lanes_load(s->low_y + at)),
                            lanes_less(lanes_load(s->high_y + at), lanes_splat(s->low_y[box])));
    return lanes_movemask(lanes_or(x, y)) ^ 15u;
}

static bool boxes_meet(const knot_projected_edges *s, uint32_t a, uint32_t b)
{
    return s->low_x[a] <= s->high_x[b] && s->low_x[b] <= s->high_x[a] &&
           s->low_y[a] <= s->high_y[b] && s->low_y[b] <= s->high_y[a];
}

static lanes outside_lanes(lanes from, lanes d)
{
    lanes to = lanes_sub(from, d), none = lanes_splat(0.0);
    return lanes_max(lanes_min(from, to), lanes_sub(none, lanes_max(from, to)));
}

/* Bit mask of the edges that intersect_edges would not find disjoint. */
static unsigned edge_bits(const knot_projected_edges *s, uint32_t i, uint32_t at)
{
    lanes ix = lanes_splat(s->dx[i]), iy = lanes_splat(s->dy[i]);
    lanes jx = lanes_load(s->dx + at), jy = lanes_load(s->dy + at);
    lanes bx = lanes_sub(lanes_load(s->x + at), lanes_splat(s->x[i]));
    lanes by = lanes_sub(lanes_load(s->y + at), lanes_splat(s->y[i]));
    lanes d = lanes_sub(lanes_times(ix, jy), lanes_times(iy, jx));
    lanes from_i = lanes_sub(lanes_times(bx, jy), lanes_times(by, jx));
    lanes from_j = lanes_sub(lanes_times(bx, iy), lanes_times(by, ix));
    lanes bound = lanes_add(lanes_load(s->bound + at), lanes_splat(s->bound[i]));
    lanes max_outside = lanes_max(outside_lanes(from_i, d), outside_lanes(from_j, d));
    return lanes_movemask(lanes_less(bound, max_outside)) ^ 15u;
}

static uint32_t after(const knot_projected_edges *s, uint32_t i)
{
    return i + 1 == s->count ? 0 : i + 1;
}

/* Bit mask of the edges from `at` on that are neither i nor adjacent to it. */
static unsigned non_neighbour_bits(const knot_projected_edges *s, uint32_t i, uint32_t at)
{
    const uint32_t same[3] = {i == 0 ? s->count - 1 : i - 1, i, after(s, i)};
    unsigned bits = 15u;
    for (int k = 0; k < 3; k++) {
        uint32_t lane = same[k] - at;
        bits &= lane < LANES ? ~(1u << lane) : 15u;
    }
    return bits;
}

/* Intersects edge i, with the given box, with the edges of a group in the mask `wanted`. Returns
 * false if the diagram is not regular. */
VBSS_ALWAYS_INLINE bool intersect_with_group(knot_projected_edges *s, uint32_t i, uint32_t box,
                                             uint32_t group, unsigned wanted)
{
    uint32_t at = LANES * group;
    unsigned bits = box_bits(s, box, at) & wanted;
    s->groups_tested++;
    if (bits != 0) {
        bits &= non_neighbour_bits(s, i, at);
    }
    if (bits != 0) {
        bits &= edge_bits(s, i, at);
    }
    for (uint32_t lane = 0; bits != 0; lane++, bits >>= 1) {
        if ((bits & 1u) != 0) {
            s->diagram = intersect_edges(s, i, at + lane);
            if (s->diagram != KNOT_DIAGRAM_REGULAR) {
                return false;
            }
        }
    }
    return true;
}

static bool intersect_groups(knot_projected_edges *s, uint32_t a, uint32_t b)
{
    for (uint32_t lane = 0; lane < LANES; lane++) {
        uint32_t i = LANES * a + lane;
        if (!intersect_with_group(s, i, i, b, a == b ? 15u & (14u << lane) : 15u)) {
            return false;
        }
    }
    return true;
}

static bool intersect_all_groups(knot_projected_edges *s)
{
    for (uint32_t a = 0; a < s->groups; a++) {
        for (uint32_t four = a / LANES * LANES; four < s->groups; four += LANES) {
            unsigned bits = box_bits(s, s->grouped + a, s->grouped + four);
            s->groups_tested++;
            for (uint32_t b = four; bits != 0; b++, bits >>= 1) {
                if ((bits & 1u) != 0 && b >= a && !intersect_groups(s, a, b)) {
                    return false;
                }
            }
        }
    }
    return true;
}

/* Intersects a long edge with all edges that have boxes, then with earlier long edges. */
static bool intersect_long_edge(knot_projected_edges *s, uint32_t k)
{
    uint32_t i = s->longs[k], box = s->spare;
    vbss_knot_projected_edges_set_box(s, i, box);
    for (uint32_t group = 0; group < s->groups; group++) {
        if (!intersect_with_group(s, i, box, group, 15u)) {
            return false;
        }
    }
    for (uint32_t l = 0; l < k && s->diagram == KNOT_DIAGRAM_REGULAR; l++) {
        uint32_t j = s->longs[l];
        vbss_knot_projected_edges_set_box(s, j, box + 1);
        if (j != after(s, i) && i != after(s, j) && boxes_meet(s, box, box + 1)) {
            s->diagram = intersect_edges(s, i, j);
        }
    }
    return s->diagram == KNOT_DIAGRAM_REGULAR;
}

/* Adjacent edges need no test: if one folds back onto the other, an end of either is on the other,
 * and the next edge shows it. */
static void intersect_all(knot_projected_edges *s)
{
    s->diagram = KNOT_DIAGRAM_REGULAR;
    bool is_regular = intersect_all_groups(s);
    for (uint32_t k = 0; k < s->long_count && is_regular; k++) {
        is_regular = intersect_long_edge(s, k);
    }
}

/* ---- the Gauss code */

/* Lists the passages in the order of the curve. Returns false if two of them are too close. */
static bool list_passages(const knot_projected_edges *s, uint16_t *order)
{
    const knot_gauss_code *code = s->code;
    uint32_t k = 0;
    for (uint32_t edge = 0; edge < s->count; edge++) {
        double last = -1.0;
        for (uint32_t entry = s->heads[edge]; entry != KNOT_NO_ENTRY;
             entry = code->scratch[entry]) {
            if (!(code->position[entry] - last > KNOT_NEAR_PLACE)) {
                return false;
            }
            last = code->position[entry];
            order[k++] = (uint16_t)entry;
        }
    }
    return true;
}

/* Moves position order[k] to k, cycle by cycle; overwrites order. */
static void permute(double *at, uint16_t *order, uint32_t count)
{
    for (uint32_t first = 0; first < count; first++) {
        double saved = at[first];
        uint32_t to = first;
        while (order[to] != first) {
            uint32_t from = order[to];
            at[to] = at[from];
            order[to] = (uint16_t)to;
            to = from;
        }
        at[to] = saved;
        order[to] = (uint16_t)to;
    }
}

/* Orders the entries along the curve. As found, each crossing has two successive entries, the over
 * passage first. */
static void order_code(knot_gauss_code *code, uint16_t *order)
{
    uint16_t *number = code->scratch, *sign = code->scratch + code->n;
    for (uint32_t c = 0; c < code->n; c++) {
        number[c] = KNOT_NO_ENTRY;
        sign[c] = code->sign[c] > 0;
    }
    uint32_t visited = 0;
    for (uint32_t k = 0; k < 2 * code->n; k++) {
        uint32_t found = order[k] / 2u;
        if (number[found] == KNOT_NO_ENTRY) {
            code->sign[visited] = sign[found] != 0 ? 1 : -1;
            number[found] = (uint16_t)visited++;
        }
        code->crossing[k] = number[found];
        code->over[k] = order[k] % 2u == 0;
    }
    permute(code->position, order, 2 * code->n);
}

knot_diagram_status vbss_knot_project(knot_projector *p, const knot_polygon *polygon,
                                      vec3 direction, knot_gauss_code *code, knot_ops *budget)
{
    knot_projected_edges s;
    uint16_t *order = code->scratch + 2 * (size_t)code->capacity;
    code->n = 0;
    *budget -= 12 * (knot_ops)polygon->count;
    if (!vbss_knot_projected_edges_init(&s, p, polygon, direction, code)) {
        return KNOT_DIAGRAM_DEGENERATE;
    }
    intersect_all(&s);
    *budget -= 3 * s.groups_tested + 33 * (knot_ops)code->n;
    if (s.diagram == KNOT_DIAGRAM_REGULAR && list_passages(&s, order)) {
        order_code(code, order);
        if (vbss_knot_gauss_code_is_planar(code)) {
            return KNOT_DIAGRAM_REGULAR;
        }
    }
    code->n = 0;
    return s.diagram == KNOT_DIAGRAM_FULL ? KNOT_DIAGRAM_FULL : KNOT_DIAGRAM_DEGENERATE;
}

/* ---- directions */

/* A spiral with irrational steps in height and longitude. Steps and start were chosen by a search:
 * the first 64 directions keep 4 degrees away from axes and diagonals. As lines, the first 4 are at
 * least 54 degrees apart, the first 12 30 degrees, and all 64 12 degrees. */
vec3 vbss_knot_direction(uint32_t k)
{
    double height = 0.8464923134032609 + k * 0.9447985576119482;
    double longitude = 0.7247961996254516 + k * 0.8008209342203975;
    double z = 2.0 * (height - floor(height)) - 1.0, sine, cosine;
    vbss_sincos(0x1.921fb54442d18p2 * (longitude - floor(longitude)), &sine, &cosine);
    double r = sqrt(1.0 - z * z);
    return vec3_unit_or(vec3_make(r * cosine, r * sine, z), vec3_make(0.0, 0.0, 1.0));
}
