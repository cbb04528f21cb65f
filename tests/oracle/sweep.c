#include "oracle/sweep.h"

#include <stddef.h>

#include "oracle/oracle.h"

/* Time is halved this often before exact arithmetic is asked. */
enum { HALVINGS = 6 };
/* Of two features, both states. */
enum { MAX_ENDS = 6 };

/* ---- boxes */

static vec3 lesser_of(vec3 a, vec3 b)
{
    return vec3_make(vbss_min(a.x, b.x), vbss_min(a.y, b.y), vbss_min(a.z, b.z));
}

static vec3 greater_of(vec3 a, vec3 b)
{
    return vec3_make(vbss_max(a.x, b.x), vbss_max(a.y, b.y), vbss_max(a.z, b.z));
}

static bool is_finite(const sweep *s)
{
    bool finite = true;
    for (uint32_t i = 0; i < s->corners; i++) {
        finite = finite && vec3_is_finite(s->start[i]) && vec3_is_finite(s->end[i]);
    }
    return finite;
}

sweep sweep_make(const vec3 *start, const vec3 *end, const uint32_t *nodes, uint32_t corners)
{
    sweep s = {.corners = corners};
    s.low = s.high = start[nodes[0]];
    for (uint32_t i = 0; i < corners; i++) {
        s.start[i] = start[nodes[i]];
        s.end[i] = end[nodes[i]];
        s.low = lesser_of(s.low, lesser_of(s.start[i], s.end[i]));
        s.high = greater_of(s.high, greater_of(s.start[i], s.end[i]));
    }
    if (!is_finite(&s)) {
        s.low = vec3_make(-HUGE_VAL, -HUGE_VAL, -HUGE_VAL);
        s.high = vec3_make(HUGE_VAL, HUGE_VAL, HUGE_VAL);
    }
    return s;
}

bool sweep_boxes_apart(const sweep *a, const sweep *b)
{
    return a->high.x < b->low.x || b->high.x < a->low.x || a->high.y < b->low.y ||
           b->high.y < a->low.y || a->high.z < b->low.z || b->high.z < a->low.z;
}

void sweep_boxes_join(sweep *a, const sweep *b)
{
    a->low = lesser_of(a->low, b->low);
    a->high = greater_of(a->high, b->high);
}

/* ---- a plane between two sweeps, or between parts of them in time
 *
 * Any direction n may be tried: if all ends of a are further along n than all ends of b, at both times,
 * nothing meets between these times. In floating point, u = 2^-53, M the largest coordinate: an end at time t
 * is known to 2.1 u M a coordinate, its place along n to 5.5 u M |n|_1 with the rounding of products and
 * sums; so 16 u M |n|_1 is more than twice that, and TINY more than any underflow. */

#define ROUNDING (16.0 * 0x1p-53)
#define TINY 1e-290

static double reach(const sweep *s)
{
    vec3 a = greater_of(s->high, vec3_neg(s->low));
    return vbss_max(a.x, vbss_max(a.y, a.z));
}

static double clamp(double x)
{
    return x < 0.0 ? 0.0 : x > 1.0 ? 1.0 : x;
}

/* From a point of b to one of a: nearly the closest ones. A choice, which need not be right. */
static vec3 between_edges(const vec3 a[2], const vec3 b[2])
{
    vec3 along_a = vec3_sub(a[1], a[0]), along_b = vec3_sub(b[1], b[0]),
         from_b = vec3_sub(a[0], b[0]);
    double aa = vec3_dot(along_a, along_a), bb = vec3_dot(along_b, along_b);
    double ab = vec3_dot(along_a, along_b), ar = vec3_dot(along_a, from_b);
    double br = vec3_dot(along_b, from_b), d = aa * bb - ab * ab;
    double s = d > 0.0 ? clamp((ab * br - bb * ar) / d) : 0.5;
    double t = bb > 0.0 ? clamp((ab * s + br) / bb) : 0.0;
    s = aa > 0.0 ? clamp((ab * t - ar) / aa) : 0.0;
    return vec3_add_scaled(vec3_add_scaled(from_b, s, along_a), -t, along_b);
}

/* The same of a point and a triangle: above it along its normal, else from its nearest side. */
static vec3 between_point_and_triangle(vec3 p, const vec3 b[3])
{
    const vec3 point[2] = {p, p};
    vec3 normal = vec3_cross(vec3_sub(b[1], b[0]), vec3_sub(b[2], b[0])), nearest = vec3_zero();
    bool within = true;
    for (int i = 0; i < 3; i++) {
        const vec3 side[2] = {b[i], b[(i + 1) % 3]};
        vec3 in = vec3_cross(normal, vec3_sub(side[1], side[0])), to = between_edges(point, side);
        within = within && vec3_dot(in, vec3_sub(p, side[0])) >= 0.0;
        if (i == 0 || vec3_dot(to, to) < vec3_dot(nearest, nearest)) {
            nearest = to;
        }
    }
    bool below = vec3_dot(normal, vec3_sub(p, b[0])) < 0.0;
    return !within ? nearest : below ? vec3_neg(normal) : normal;
}

static vec3 between(uint32_t corners, const vec3 *a, const vec3 *b)
{
    return corners == 2 ? between_edges(a, b) : between_point_and_triangle(a[0], b);
}

static void at_time(const sweep *s, double t, vec3 *corners)
{
    for (uint32_t i = 0; i < s->corners; i++) {
        corners[i] = vec3_lerp(s->start[i], s->end[i], t);
    }
}

static bool apart_from_to(const sweep *a, const sweep *b, double from, double to, double limit)
{
    vec3 ends_a[MAX_ENDS], ends_b[MAX_ENDS], middle_a[3], middle_b[3];
    at_time(a, from, ends_a);
    at_time(a, to, ends_a + a->corners);
    at_time(b, from, ends_b);
    at_time(b, to, ends_b + b->corners);
    at_time(a, 0.5 * (from + to), middle_a);
    at_time(b, 0.5 * (from + to), middle_b);
    vec3 n = between(a->corners, middle_a, middle_b);
    double nearest = HUGE_VAL, furthest = -HUGE_VAL;
    for (uint32_t i = 0; i < 2 * a->corners; i++) {
        nearest = vbss_min(nearest, vec3_dot(n, ends_a[i]));
    }
    for (uint32_t i = 0; i < 2 * b->corners; i++) {
        furthest = vbss_max(furthest, vec3_dot(n, ends_b[i]));
    }
    return nearest - furthest > ROUNDING * limit * (fabs(n.x) + fabs(n.y) + fabs(n.z)) + TINY;
}

/* Step by step through time: as long as can be proven, halving what cannot. */
static bool proven_apart(const sweep *a, const sweep *b)
{
    double largest = vbss_max(reach(a), reach(b)), time = 0.0, step = 1.0;
    while (time < 1.0) {
        if (apart_from_to(a, b, time, time + step, largest)) {
            time += step;
            step = vbss_min(2.0 * step, 1.0 - time);
        } else if (step > 1.0 / (1 << HALVINGS)) {
            step *= 0.5;
        } else {
            return false;
        }
    }
    return true;
}

/* ---- the exact answer */

static void put(collision_query *query, const sweep *s, uint32_t first)
{
    for (uint32_t i = 0; i < s->corners; i++) {
        size_t at = 3 * ((size_t)first + i);
        vec3_store(query->start + at, s->start[i]);
        vec3_store(query->end + at, s->end[i]);
    }
}

bool sweep_meets(const sweep *a, const sweep *b, bool *asked)
{
    *asked = !proven_apart(a, b);
    if (!*asked) {
        return false;
    }
    if (!is_finite(a) || !is_finite(b)) {
        return true;
    }
    collision_query query = {.kind = a->corners == 2 ? VBSS_COLLISION_PAIR_EDGE_EDGE
                                                     : VBSS_COLLISION_PAIR_POINT_TRIANGLE};
    put(&query, a, 0);
    put(&query, b, a->corners);
    return oracle_meets(&query);
}
