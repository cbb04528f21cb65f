/* Whether a segment certainly misses a triangle.
 *
 * Every certificate is a linear function of space or of a coordinate plane that separates the two:
 * if it is positive on one and not positive on the other, they have no common point. Comparisons of
 * coordinates are exact. Computed values have an error bound, and a value within its bound decides
 * nothing. Only the certificate by volumes combines several functions. */
#include "knot/knot.h"
#include "knot/triangle.h"

static bool same(vec3 p, vec3 q)
{
    return p.x == q.x && p.y == q.y && p.z == q.z;
}

/* ---- values with error bounds */

typedef struct error_interval {
    double low, high;
} error_interval;

static error_interval error_interval_make(double value, double size)
{
    double error = KNOT_CLEARANCE * size + KNOT_UNDERFLOW;
    error_interval r = {value - error, value + error};
    return r;
}

/* (t - s) x (x - s) */
static error_interval orient2d(const double s[2], const double t[2], const double x[2])
{
    double u = t[0] - s[0], v = t[1] - s[1], p = x[0] - s[0], q = x[1] - s[1];
    return error_interval_make(u * q - v * p, (fabs(u) + fabs(v)) * (fabs(p) + fabs(q)));
}

/* (t - s) . (x - s) */
static error_interval dot(vec3 s, vec3 t, vec3 x)
{
    double i = (t.x - s.x) * (x.x - s.x), j = (t.y - s.y) * (x.y - s.y),
           k = (t.z - s.z) * (x.z - s.z);
    return error_interval_make(i + j + k, fabs(i) + fabs(j) + fabs(k));
}

static bool certainly_apart(error_interval v, error_interval w)
{
    return (v.low > 0.0 && w.high < 0.0) || (v.high < 0.0 && w.low > 0.0);
}

static bool certainly_alike(error_interval v, error_interval w)
{
    return (v.low > 0.0 && w.low > 0.0) || (v.high < 0.0 && w.high < 0.0);
}

static void drop(int axis, vec3 v, double flat[2])
{
    flat[0] = axis == 0 ? v.y : v.x;
    flat[1] = axis == 2 ? v.y : v.z;
}

/* ---- a segment from corner s of the triangle s, t, u to q */

/* Whether a coordinate separates them: it is zero at s, positive (or not negative) at q, and not
 * positive (negative) at t and u. */
static bool leaves_along(double s, double t, double u, double q)
{
    return (q > s && t <= s && u <= s) || (q < s && t >= s && u >= s) ||
           (q >= s && t < s && u < s) || (q <= s && t > s && u > s);
}

static bool leaves_in_view(const double s[2], const double t[2], const double u[2],
                           const double q[2])
{
    error_interval tu = orient2d(s, t, u), tq = orient2d(s, t, q);
    if (certainly_apart(tu, tq)) {
        return true;
    }
    error_interval uq = orient2d(s, u, q);
    /* orient2d(s, u, t) is -tu. q is outside the angle at s if it is beyond su, or on the same side
     * of st and su. */
    error_interval ut = {-tu.high, -tu.low};
    return certainly_apart(ut, uq) || certainly_alike(tq, uq);
}

static bool leaves(vec3 s, vec3 t, vec3 u, vec3 q)
{
    for (int axis = 0; axis < 3; axis++) {
        double flat[4][2];
        drop(axis, s, flat[0]);
        drop(axis, t, flat[1]);
        drop(axis, u, flat[2]);
        drop(axis, q, flat[3]);
        if (leaves_in_view(flat[0], flat[1], flat[2], flat[3])) {
            return true;
        }
    }
    error_interval qt = dot(s, q, t), qu = dot(s, q, u);
    if (qt.high < 0.0 && qu.high < 0.0) {
        return true;
    }
    error_interval tu = dot(s, t, u);
    return tu.low > 0.0 && (qt.high < 0.0 || qu.high < 0.0);
}

static bool misses_from_corner(const knot_triangle *triangle, vec3 s, vec3 t, vec3 u, vec3 q)
{
    if (same(s, q)) {
        return true;
    }
    return knot_triangle_side(triangle, q) != 0 || leaves_along(s.x, t.x, u.x, q.x) ||
           leaves_along(s.y, t.y, u.y, q.y) || leaves_along(s.z, t.z, u.z, q.z) ||
           leaves(s, t, u, q);
}

/* ---- a segment without a common corner */

/* Whether the line through a and b separates the segment from the triangle. */
static bool line_separates(const double a[2], const double b[2], const double c[2],
                           const double p[2], const double q[2])
{
    error_interval vc = orient2d(a, b, c), vp = orient2d(a, b, p), vq = orient2d(a, b, q);
    return (vp.low > 0.0 && vq.low > 0.0 && vp.low > vc.high && vq.low > vc.high) ||
           (vp.high < 0.0 && vq.high < 0.0 && vp.high < vc.low && vq.high < vc.low);
}

static bool apart_in_view(const double a[2], const double b[2], const double c[2],
                          const double p[2], const double q[2])
{
    error_interval va = orient2d(p, q, a), vb = orient2d(p, q, b);
    return (certainly_alike(va, vb) && certainly_alike(va, orient2d(p, q, c))) ||
           line_separates(a, b, c, p, q) || line_separates(b, c, a, p, q) ||
           line_separates(c, a, b, p, q);
}

static bool apart_in_some_view(const knot_triangle *t, vec3 p, vec3 q)
{
    for (int axis = 0; axis < 3; axis++) {
        double flat[5][2];
        drop(axis, t->a, flat[0]);
        drop(axis, t->b, flat[1]);
        drop(axis, t->c, flat[2]);
        drop(axis, p, flat[3]);
        drop(axis, q, flat[4]);
        if (apart_in_view(flat[0], flat[1], flat[2], flat[3], flat[4])) {
            return true;
        }
    }
    return false;
}

static bool apart_along(double a, double b, double c, double p, double q)
{
    double low = vbss_min(a, vbss_min(b, c)), high = vbss_max(a, vbss_max(b, c));
    double first = vbss_min(p, q), last = vbss_max(p, q);
    double clear = KNOT_CLEARANCE * (vbss_max(high, last) - vbss_min(low, first));
    return last < low - clear || first > high + clear;
}

/* Whether the line of the segment misses the triangle: two of its volumes with ab, bc and ca differ
 * in sign.
 *
 * A point of the line in the triangle, with weights la, lb, lc, has lb ab = lc ca, lc bc = la ab
 * and la ca = lb bc. If two volumes differ in sign, all weight is on the corner between those two
 * edges. That corner is then on the line, but then both volumes are zero. */
static bool line_passes(const knot_triangle *t, vec3 p, vec3 q, bool *hits)
{
    vec3 d = vec3_sub(q, p), a = vec3_sub(t->a, p), b = vec3_sub(t->b, p), c = vec3_sub(t->c, p);
    area da = area_of(d, a), db = area_of(d, b);
    int ab = clear_side(&da, b), bc = clear_side(&db, c), ca = -clear_side(&da, c);
    *hits = ab * bc * ca != 0;
    return ab * bc < 0 || ab * ca < 0 || bc * ca < 0;
}

bool vbss_knot_triangle_misses(const knot_triangle *t, vec3 p, vec3 q)
{
    int sides = knot_triangle_side(t, p) * knot_triangle_side(t, q);
    if (sides > 0) {
        return true;
    }
    if (same(p, t->a)) {
        return misses_from_corner(t, t->a, t->b, t->c, q);
    }
    if (same(p, t->c)) {
        return misses_from_corner(t, t->c, t->a, t->b, q);
    }
    if (same(p, t->b)) {
        return misses_from_corner(t, t->b, t->c, t->a, q);
    }
    if (same(q, t->a)) {
        return misses_from_corner(t, t->a, t->b, t->c, p);
    }
    if (same(q, t->c)) {
        return misses_from_corner(t, t->c, t->a, t->b, p);
    }
    if (same(q, t->b)) {
        return misses_from_corner(t, t->b, t->c, t->a, p);
    }
    bool line_hits = false;
    if (line_passes(t, p, q, &line_hits)) {
        return true;
    }
    return !(line_hits && sides < 0) &&
           (apart_along(t->a.x, t->b.x, t->c.x, p.x, q.x) ||
            apart_along(t->a.y, t->b.y, t->c.y, p.y, q.y) ||
            apart_along(t->a.z, t->b.z, t->c.z, p.z, q.z) || apart_in_some_view(t, p, q));
}

bool vbss_knot_segment_misses_triangle(vec3 a, vec3 b, vec3 c, vec3 p, vec3 q)
{
    knot_triangle t = knot_triangle_make(a, b, c);
    return vbss_knot_triangle_misses(&t, p, q);
}
