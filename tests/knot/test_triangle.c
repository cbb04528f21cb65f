/* A segment that is said to miss a triangle misses it: against integers. */
#include "harness/harness.h"

#include "knot/knot.h"

/* ---- the truth, of points with whole coordinates below 2^41 */

__extension__ typedef __int128 wide;
typedef struct point {
    int64_t x[3];
} point;

static bool same(point p, point q)
{
    return p.x[0] == q.x[0] && p.x[1] == q.x[1] && p.x[2] == q.x[2];
}

static point minus(point p, point q)
{
    point r = {{p.x[0] - q.x[0], p.x[1] - q.x[1], p.x[2] - q.x[2]}};
    return r;
}

static int sign(wide n)
{
    return (n > 0) - (n < 0);
}

static wide cross_part(point u, point v, int axis)
{
    int i = (axis + 1) % 3, j = (axis + 2) % 3;
    return (wide)u.x[i] * v.x[j] - (wide)u.x[j] * v.x[i];
}

/* An axis along which u x v is not zero, or -1. */
static int axis_of(point u, point v)
{
    for (int axis = 0; axis < 3; axis++) {
        if (cross_part(u, v, axis) != 0) {
            return axis;
        }
    }
    return -1;
}

static int volume(point a, point b, point c, point d)
{
    point u = minus(a, d), v = minus(b, d), w = minus(c, d);
    wide sum = 0;
    for (int axis = 0; axis < 3; axis++) {
        sum += u.x[axis] * cross_part(v, w, axis);
    }
    return sign(sum);
}

static int side(point a, point b, point p, int axis)
{
    return sign(cross_part(minus(b, a), minus(p, a), axis));
}

static bool in_segment(point x, point p, point q)
{
    if (axis_of(minus(q, p), minus(x, p)) >= 0) {
        return false;
    }
    for (int k = 0; k < 3; k++) {
        if ((x.x[k] < p.x[k] && x.x[k] < q.x[k]) || (x.x[k] > p.x[k] && x.x[k] > q.x[k])) {
            return false;
        }
    }
    return true;
}

static bool segments_meet(point a, point b, point p, point q)
{
    if (in_segment(a, p, q) || in_segment(b, p, q) || in_segment(p, a, b) || in_segment(q, a, b)) {
        return true;
    }
    int axis = axis_of(minus(b, a), minus(q, p));
    return axis >= 0 && volume(a, b, p, q) == 0 && side(a, b, p, axis) * side(a, b, q, axis) < 0 &&
           side(p, q, a, axis) * side(p, q, b, axis) < 0;
}

static bool in_triangle(point x, point a, point b, point c)
{
    if (in_segment(x, a, b) || in_segment(x, b, c) || in_segment(x, c, a)) {
        return true;
    }
    int axis = axis_of(minus(b, a), minus(c, a));
    if (axis < 0 || volume(x, a, b, c) != 0) {
        return false;
    }
    int ab = side(a, b, x, axis), bc = side(b, c, x, axis), ca = side(c, a, x, axis);
    return ab == bc && bc == ca;
}

static bool pierces(point a, point b, point c, point p, point q)
{
    int ab = volume(p, q, a, b), bc = volume(p, q, b, c), ca = volume(p, q, c, a);
    return volume(a, b, c, p) * volume(a, b, c, q) < 0 && ab != 0 && ab == bc && bc == ca;
}

/* Of a segment from corner s of the triangle s, t, u. */
static bool truly_leaves(point s, point t, point u, point q)
{
    if (same(s, q)) {
        return true;
    }
    return !in_triangle(q, s, t, u) && (same(t, s) || !in_segment(t, s, q)) &&
           (same(u, s) || !in_segment(u, s, q)) &&
           (in_segment(s, t, u) || !segments_meet(s, q, t, u));
}

static bool truly_misses(point a, point b, point c, point p, point q)
{
    const point corners[5] = {a, b, c, a, b}, ends[3] = {p, q, p};
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 2; k++) {
            if (same(corners[i], ends[k])) {
                return truly_leaves(corners[i], corners[i + 1], corners[i + 2], ends[k + 1]);
            }
        }
    }
    return !in_triangle(p, a, b, c) && !in_triangle(q, a, b, c) && !segments_meet(a, b, p, q) &&
           !segments_meet(b, c, p, q) && !segments_meet(c, a, p, q) && !pierces(a, b, c, p, q);
}

/* ---- questions */

typedef struct tally {
    uint64_t misses, certain;
} tally;

static vec3 in_space(point p, double scale)
{
    return vec3_make((double)p.x[0] * scale, (double)p.x[1] * scale, (double)p.x[2] * scale);
}

/* In several orders of corners and ends. */
static void ask(const point x[5], double scale, tally *t)
{
    bool truth = truly_misses(x[0], x[1], x[2], x[3], x[4]);
    t->misses += truth;
    vec3 v[5];
    for (int i = 0; i < 5; i++) {
        v[i] = in_space(x[i], scale);
    }
    bool said = vbss_knot_segment_misses_triangle(v[0], v[1], v[2], v[3], v[4]);
    bool otherwise = vbss_knot_segment_misses_triangle(v[1], v[2], v[0], v[4], v[3]) ||
                     vbss_knot_segment_misses_triangle(v[2], v[1], v[0], v[3], v[4]);
    t->certain += said;
    assert_true(truth || (!said && !otherwise));
}

static int64_t draw(harness_source *source, int64_t size)
{
    return (int64_t)harness_draw_below(source, (uint32_t)(2 * size + 1)) - size;
}

/* Coordinates in [-size, size], some axes zero, some points the same. */
static void draw_small(harness_source *source, int64_t size, int axes, bool shared, point x[5])
{
    for (int i = 0; i < 5; i++) {
        for (int k = 0; k < 3; k++) {
            x[i].x[k] = k < axes ? draw(source, size) : 0;
        }
    }
    if (shared) {
        uint32_t corner = harness_draw_below(source, 3), end = 3 + harness_draw_below(source, 2);
        x[end] = x[corner];
    }
}

enum { QUESTIONS = 2000 };

static void small_numbers(harness_source *source, void *user)
{
    (void)user;
    static const double scales[] = {1.0, 0x1p-10, 0x1p-359, 0x1p40};
    tally t = {0, 0};
    for (int i = 0; i < QUESTIONS; i++) {
        point x[5];
        int64_t size = 1 + (int64_t)harness_draw_below(source, 8);
        int axes = 1 + (int)harness_draw_below(source, 3);
        draw_small(source, size, axes, harness_draw_below(source, 2) == 0, x);
        ask(x, scales[harness_draw_below(source, 4)], &t);
    }
    assert_true(t.misses > 0);
}

static void empty_triangle_is_never_false_positive(void **state)
{
    (void)state;
    harness_property("small numbers", 1000, small_numbers, NULL);
}

/* Points near one line or plane, by distances of all sizes: there rounding decides. */
static void nearly_degenerate(harness_source *source, void *user)
{
    (void)user;
    tally t = {0, 0};
    for (int i = 0; i < QUESTIONS; i++) {
        point frame[2], x[5];
        for (int f = 0; f < 2; f++) {
            int64_t size = INT64_C(1) << harness_draw_below(source, 31);
            for (int k = 0; k < 3; k++) {
                frame[f].x[k] = draw(source, size);
            }
        }
        for (int j = 0; j < 5; j++) {
            int64_t s = draw(source, 300), r = draw(source, 3),
                    noise = (INT64_C(1) << harness_draw_below(source, 30)) / 64;
            for (int k = 0; k < 3; k++) {
                x[j].x[k] = s * frame[0].x[k] + r * frame[1].x[k] + draw(source, noise);
            }
        }
        if (harness_draw_below(source, 2) == 0) {
            x[3] = x[harness_draw_below(source, 3)];
        }
        ask(x, 0x1p-41, &t);
    }
    assert_true(t.misses > 0 && t.certain > 0);
}

static void empty_triangle_is_never_false_positive_at_rounding(void **state)
{
    (void)state;
    harness_property("nearly degenerate", 300, nearly_degenerate, NULL);
}

/* Of misses of points with coordinates in [-8, 8] on so many axes. */
static double certain_share(int axes, bool shared)
{
    vbss_random random;
    vbss_random_seed(&random, 7, (uint64_t)axes);
    harness_source source = {.random = random};
    tally t = {0, 0};
    for (int i = 0; i < 100000; i++) {
        point x[5];
        draw_small(&source, 8, axes, shared, x);
        ask(x, 1e-3, &t);
    }
    return (double)t.certain / (double)t.misses;
}

static void empty_triangle_is_mostly_found(void **state)
{
    (void)state;
    assert_true(certain_share(3, false) > 0.9999);
    assert_true(certain_share(3, true) > 0.9995);
    assert_true(certain_share(2, false) > 0.9995);
    assert_true(certain_share(2, true) > 0.99);
    assert_true(certain_share(1, false) == 1.0);
    assert_true(certain_share(1, true) == 1.0);
}

/* ---- what it is asked in a reduction */

static const vec3 A = {0.0, 0.0, 0.0}, B = {2.0, 1.0, 0.0}, C = {4.0, 0.0, 0.0};

static void planar_curve_continues(void **state)
{
    (void)state;
    assert_true(vbss_knot_segment_misses_triangle(A, B, C, vec3_make(-2.0, 1.0, 0.0), A));
    assert_true(vbss_knot_segment_misses_triangle(A, B, C, C, vec3_make(4.0, 3.0, 0.0)));
    assert_true(vbss_knot_segment_misses_triangle(A, B, C, vec3_make(0.0, 1.0, 0.0),
                                                  vec3_make(2.0, 2.0, 0.0)));
}

static void straight_curve_continues(void **state)
{
    (void)state;
    vec3 step = vec3_make(0.1, -0.3, 0.7), x[5];
    for (int i = 0; i < 5; i++) {
        x[i] = vec3_scale(step, i);
    }
    assert_true(vbss_knot_segment_misses_triangle(x[1], x[2], x[3], x[0], x[1]));
    assert_true(vbss_knot_segment_misses_triangle(x[1], x[2], x[3], x[3], x[4]));
    assert_true(vbss_knot_segment_misses_triangle(x[0], x[1], x[2], x[3], x[4]));
}

static void fold_back_is_detected(void **state)
{
    (void)state;
    assert_false(vbss_knot_segment_misses_triangle(A, B, C, C, A));
    assert_false(vbss_knot_segment_misses_triangle(A, B, C, C, vec3_make(2.0, 0.0, 0.0)));
    assert_false(vbss_knot_segment_misses_triangle(A, B, C, A, vec3_make(4.0, 2.0, 0.0)));
    assert_false(vbss_knot_segment_misses_triangle(A, B, C, A, vec3_make(4.0, 1.0, 0.0)));
}

static void coincident_points_are_allowed(void **state)
{
    (void)state;
    vec3 far = vec3_make(-1.0, -1.0, 0.0);
    assert_true(vbss_knot_segment_misses_triangle(A, A, C, far, A));
    assert_true(vbss_knot_segment_misses_triangle(A, A, A, far, A));
    assert_true(vbss_knot_segment_misses_triangle(A, B, C, far, far));
    assert_true(vbss_knot_segment_misses_triangle(A, B, C, A, A));
    assert_false(vbss_knot_segment_misses_triangle(A, C, C, B, vec3_make(2.0, -1.0, 0.0)));
    assert_false(vbss_knot_segment_misses_triangle(A, B, C, vec3_make(2.0, 0.5, 0.0),
                                                   vec3_make(2.0, 0.5, 0.0)));
}

int test_triangle(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(empty_triangle_is_never_false_positive),
        harness_test(empty_triangle_is_never_false_positive_at_rounding),
        harness_test(empty_triangle_is_mostly_found),
        harness_test(planar_curve_continues),
        harness_test(straight_curve_continues),
        harness_test(fold_back_is_detected),
        harness_test(coincident_points_are_allowed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
