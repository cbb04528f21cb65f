/* Asking for closest points, and the smallest distance, found by a search in long double that shares no
 * formula with the library. */
#ifndef VBSS_TESTS_COLLISION_CLOSEST_REFERENCE_H
#define VBSS_TESTS_COLLISION_CLOSEST_REFERENCE_H

#include <string.h>

#include "base/check.h"
#include "harness/harness.h"

/* Capsules are asked with the radius 0.125. */
typedef enum kind { EDGES, POINT_TRIANGLE, EDGE_TRIANGLE, CAPSULES, KINDS } kind;

static inline vbss_result closest(kind which, const double *a, const double *b, void *out,
                                  uint32_t size)
{
    switch (which) {
    case EDGES:
        return vbss_collision_closest_segments(a, b, out, size);
    case POINT_TRIANGLE:
        return vbss_collision_closest_point_triangle(a, b, out, size);
    case EDGE_TRIANGLE:
        return vbss_collision_closest_segment_triangle(a, b, out, size);
    default:
        return vbss_collision_closest_capsules(a, 0.125, b, 0.125, out, size);
    }
}

/* A point, an edge or a triangle, by its number of vertices. */
typedef struct feature {
    int count;
    double x[9];
} feature;

static inline vec3 vertex(const feature *f, int k)
{
    return vec3_load(f->x + 3 * (size_t)k);
}

static inline void set_vertex(feature *f, int k, vec3 x)
{
    vec3_store(f->x + 3 * (size_t)k, x);
}

/* The largest coordinate, relative to a's first vertex or not. */
static inline double size_of(const feature *a, const feature *b, bool relative)
{
    double size = 0.0, at[3];
    for (int k = 0; k < a->count + b->count; k++) {
        vec3 x = k < a->count ? vertex(a, k) : vertex(b, k - a->count);
        vec3_store(at, relative ? vec3_sub(x, vertex(a, 0)) : x);
        size = fmax(size, vbss_max_abs(at, 3));
    }
    return size;
}

/* ---- the reference: a distance to a convex set is convex along a line, so thirds find its least */

typedef struct location {
    long double x, y, z;
} place;

static inline place load_place(vec3 x, int power)
{
    return (place){(long double)ldexp(x.x, power), (long double)ldexp(x.y, power),
                   (long double)ldexp(x.z, power)};
}

static inline place along(place from, place to, long double share)
{
    return (place){from.x + share * (to.x - from.x), from.y + share * (to.y - from.y),
                   from.z + share * (to.z - from.z)};
}

static inline long double dot(place a, place b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline long double square_to_edge(place p, place from, place to)
{
    place e = {to.x - from.x, to.y - from.y, to.z - from.z};
    place d = {p.x - from.x, p.y - from.y, p.z - from.z};
    long double s = dot(e, e) > 0.0L ? dot(d, e) / dot(e, e) : 0.0L;
    s = s < 0.0L ? 0.0L : s > 1.0L ? 1.0L : s;
    place apart = {d.x - s * e.x, d.y - s * e.y, d.z - s * e.z};
    return dot(apart, apart);
}

typedef struct ask {
    place a[2], b[3], p;
} ask;
typedef long double (*convex)(const ask *q, long double share);

static inline long double smallest(convex f, const ask *q)
{
    long double low = 0.0L, high = 1.0L, ends = f(q, low);
    ends = f(q, high) < ends ? f(q, high) : ends;
    for (int i = 0; i < 110; i++) {
        long double third = (high - low) / 3.0L;
        if (f(q, low + third) < f(q, high - third)) {
            high -= third;
        } else {
            low += third;
        }
    }
    return f(q, low) < ends ? f(q, low) : ends;
}

static inline long double from_edge_to_edge(const ask *q, long double share)
{
    return square_to_edge(along(q->a[0], q->a[1], share), q->b[0], q->b[1]);
}

/* To the slice of the triangle that is parallel to its last edge. */
static inline long double from_point_to_slice(const ask *q, long double share)
{
    return square_to_edge(q->p, along(q->b[0], q->b[1], share), along(q->b[0], q->b[2], share));
}

static inline long double from_edge_to_triangle(const ask *q, long double share)
{
    ask at = *q;
    at.p = along(q->a[0], q->a[1], share);
    return smallest(from_point_to_slice, &at);
}

static inline double smallest_distance(const feature *a, const feature *b)
{
    ask q;
    double size = size_of(a, b, false);
    int power = size > 0.0 ? ilogb(size) : 0; /* in numbers about 1: no square underflows */
    for (int k = 0; k < 5; k++) {
        bool of_a = k < 2;
        vec3 x = of_a ? vertex(a, k % a->count) : vertex(b, (k - 2) % b->count);
        *(of_a ? &q.a[k] : &q.b[k - 2]) = load_place(x, -power);
    }
    q.p = q.a[0];
    long double square = b->count == 2   ? smallest(from_edge_to_edge, &q)
                         : a->count == 1 ? smallest(from_point_to_slice, &q)
                                         : smallest(from_edge_to_triangle, &q);
    return ldexp((double)sqrtl(square), power);
}

/* ---- what every answer is */

static inline void expect_point(const feature *f, const double weights[3], const double point[3],
                                double rounding)
{
    vec3 sum = vec3_zero();
    double all = 0.0;
    for (int k = 0; k < 3; k++) {
        assert_true(weights[k] >= -4e-16 && weights[k] <= 1.0);
        assert_true(k < f->count || weights[k] == 0.0);
        sum = k < f->count ? vec3_add_scaled(sum, weights[k], vertex(f, k)) : sum;
        all += weights[k];
    }
    expect_near(1.0, all, 4e-16);
    expect_near(0.0, vec3_distance(sum, vec3_load(point)), rounding);
}

/* The answer, whole, its distance right to a share of the size. */
static inline vbss_collision_closest expect_closest(const feature *a, const feature *b,
                                                    double share)
{
    vbss_collision_closest c;
    memset(&c, 0xff, sizeof c);
    kind which = b->count == 2 ? EDGES : a->count == 1 ? POINT_TRIANGLE : EDGE_TRIANGLE;
    expect_ok(closest(which, a->x, b->x, &c, sizeof c));
    assert_int_equal(c.struct_size, sizeof c);
    assert_int_equal(c.reserved, 0);
    double rounding = 4e-15 * size_of(a, b, false);
    expect_point(a, c.weights_a, c.point_a, rounding);
    expect_point(b, c.weights_b, c.point_b, rounding);
    vec3 apart = vec3_sub(vec3_load(c.point_b), vec3_load(c.point_a)), n = vec3_load(c.normal);
    expect_near(c.distance > 0.0 ? 1.0 : 0.0, vec3_norm(n), 1e-15);
    expect_near(0.0, vec3_distance(vec3_scale(n, c.distance), apart), rounding);
    expect_near(smallest_distance(a, b), c.distance, share * size_of(a, b, true));
    return c;
}

#endif
