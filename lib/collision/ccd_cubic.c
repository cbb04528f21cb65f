/* Method CUBIC, the usual method of physics engines, in plain double.
 *
 * The four vertices are coplanar where p(t) = r.(e x f) is zero, a cubic in time: r leads from a to
 * b, and e and f are the two edges, or two sides of the triangle. For each root in [0, 1], in
 * order, the method tests whether the closest points are inside the features. With a thickness it
 * also tests the distance at the end.
 *
 * There are no tolerances. The method therefore misses contacts where rounding moves a root or a
 * point across a border, where p is zero at all times, and where edges are parallel at the root. */
#include "collision/collision.h"

#include "collision/closest.h"

typedef struct spanned {
    vec3 r, e, f;
} spanned;

static inline spanned spanned_by(vec3 v0, vec3 v1, vec3 v2, vec3 v3, bool edges)
{
    spanned s;
    s.r = edges ? vec3_sub(v2, v0) : vec3_sub(v1, v0);
    s.e = edges ? vec3_sub(v1, v0) : vec3_sub(v2, v1);
    s.f = edges ? vec3_sub(v3, v2) : vec3_sub(v3, v1);
    return s;
}

/* ---- the cubic */

typedef struct cubic {
    double k0, k1, k2, k3;
    /* p(1) from the vertices at the end: the sum of the coefficients is less accurate */
    double end;
} cubic;

static inline cubic cubic_of(const spanned *from, const spanned *to)
{
    vec3 dr = vec3_sub(to->r, from->r), de = vec3_sub(to->e, from->e),
         df = vec3_sub(to->f, from->f);
    vec3 n0 = vec3_cross(from->e, from->f), n2 = vec3_cross(de, df);
    vec3 n1 = vec3_add(vec3_cross(from->e, df), vec3_cross(de, from->f));
    cubic c;
    c.k0 = vec3_dot(from->r, n0);
    c.k1 = vec3_dot(from->r, n1) + vec3_dot(dr, n0);
    c.k2 = vec3_dot(from->r, n2) + vec3_dot(dr, n1);
    c.k3 = vec3_dot(dr, n2);
    c.end = vec3_dot(to->r, vec3_cross(to->e, to->f));
    return c;
}

/* All Bernstein coefficients have one sign, so there is no root. */
static inline bool never_zero(const cubic *c)
{
    double b1 = c->k0 + c->k1 * (1.0 / 3.0), b2 = c->k0 + (2.0 * c->k1 + c->k2) * (1.0 / 3.0);
    return (c->k0 > 0.0 && b1 > 0.0 && b2 > 0.0 && c->end > 0.0) ||
           (c->k0 < 0.0 && b1 < 0.0 && b2 < 0.0 && c->end < 0.0);
}

static inline double value(const cubic *c, double t)
{
    return ((c->k3 * t + c->k2) * t + c->k1) * t + c->k0;
}

/* Times in (0, 1) of the extrema of p, ascending; p is monotone between them. */
static int turning_points(const cubic *c, double at[2])
{
    double a = 3.0 * c->k3, b = c->k2, d = c->k1; /* p' = a t^2 + 2 b t + d */
    double square = b * b - a * d;
    if (!(square > 0.0)) {
        return 0;
    }
    double q = -(b + (b < 0.0 ? -sqrt(square) : sqrt(square)));
    double first = a != 0.0 ? q / a : -1.0, second = q != 0.0 ? d / q : -1.0;
    if (first > second) {
        double larger = first;
        first = second;
        second = larger;
    }
    int count = 0;
    if (first > 0.0 && first < 1.0) {
        at[count++] = first;
    }
    if (second > 0.0 && second < 1.0) {
        at[count++] = second;
    }
    return count;
}

/* Root in a monotone interval whose ends have different signs: Newton's method, with bisection
 * where it would leave the bracket or converges slowly. */
static double root_between(const cubic *c, double low, double at_low, double high, double at_high)
{
    double t = low + (high - low) * (at_low / (at_low - at_high)), last_step = high - low;
    for (int pass = 0; pass < 100; pass++) {
        double here = value(c, t), slope = (3.0 * c->k3 * t + 2.0 * c->k2) * t + c->k1;
        if ((here < 0.0) == (at_low < 0.0)) {
            low = t;
        } else {
            high = t;
        }
        double step = slope != 0.0 ? here / slope : last_step, next = t - step;
        if (!(next >= low && next <= high && fabs(step) <= 0.5 * last_step)) {
            next = 0.5 * (low + high);
        }
        last_step = fabs(next - t);
        t = next;
        if (last_step <= DBL_EPSILON * t) {
            break;
        }
    }
    return t;
}

/* ---- inside test */

/* Weights of the point where the lines meet, or where the line along n meets the plane. Returns
 * false if it is outside the features, or for parallel edges. Divides only once the result is
 * known. */
static inline bool edges_meet(const spanned *s, vec3 n, double weights[4])
{
    double nn = vec3_norm_squared(n);
    double a = vec3_dot(vec3_cross(s->r, s->f), n), b = vec3_dot(vec3_cross(s->r, s->e), n);
    if (!(nn > 0.0 && a >= 0.0 && a <= nn && b >= 0.0 && b <= nn)) {
        return false;
    }
    weights[1] = a / nn;
    weights[0] = 1.0 - weights[1];
    weights[3] = b / nn;
    weights[2] = 1.0 - weights[3];
    return true;
}

static inline bool point_meets(const spanned *s, vec3 n, double weights[4])
{
    double nn = vec3_norm_squared(n);
    double u = vec3_dot(vec3_cross(s->f, s->r), n), v = vec3_dot(vec3_cross(s->r, s->e), n);
    if (!(nn > 0.0 && u >= 0.0 && v >= 0.0 && u + v <= nn)) {
        return false;
    }
    weights[0] = 1.0;
    weights[2] = u / nn;
    weights[3] = v / nn;
    weights[1] = clamp_unit(1.0 - weights[2] - weights[3]);
    return true;
}

/* `side` is the sign of p before this root, or after it for a root at 0. */
static bool test_root(const collision_ccd_query *q, double t, double side,
                      collision_ccd_result *result)
{
    const vec3 *x = q->start, *y = q->end;
    bool edges = q->kind == VBSS_COLLISION_PAIR_EDGE_EDGE;
    spanned s = spanned_by(vec3_lerp(x[0], y[0], t), vec3_lerp(x[1], y[1], t),
                           vec3_lerp(x[2], y[2], t), vec3_lerp(x[3], y[3], t), edges);
    vec3 n = vec3_cross(s.e, s.f);
    double *w = result->weights;
    result->passes++;
    if (!(edges ? edges_meet(&s, n, w) : point_meets(&s, n, w))) {
        return false;
    }
    result->hit = 1;
    result->time = t;
    vec3 unit = vec3_unit_or(n, vec3_zero());
    result->distance = fabs(vec3_dot(s.r, unit));
    result->normal = side > 0.0 ? unit : side < 0.0 ? vec3_neg(unit) : vec3_zero();
    return true;
}

static bool test_roots(const collision_ccd_query *q, const cubic *c, collision_ccd_result *result)
{
    double at[4] = {0.0}, height[4] = {c->k0};
    int last = turning_points(c, at + 1) + 1;
    at[last] = 1.0;
    height[last] = c->end;
    for (int k = 1; k < last; k++) {
        height[k] = value(c, at[k]);
    }
    if (height[0] == 0.0 && test_root(q, 0.0, height[1], result)) {
        return true;
    }
    for (int k = 0; k < last; k++) {
        double from = height[k], to = height[k + 1];
        if (to == 0.0) {
            if (test_root(q, at[k + 1], from, result)) {
                return true;
            }
        } else if ((from < 0.0 && to > 0.0) || (from > 0.0 && to < 0.0)) {
            if (test_root(q, root_between(c, at[k], from, at[k + 1], to), from, result)) {
                return true;
            }
        }
    }
    return false;
}

/* ---- distance at the end */

static void test_end(const collision_ccd_query *q, collision_ccd_result *result)
{
    const vec3 *y = q->end;
    vec3 to1 = vec3_sub(y[1], y[0]), to2 = vec3_sub(y[2], y[0]), to3 = vec3_sub(y[3], y[0]),
         separation;
    double weights[4] = {1.0};
    if (q->kind == VBSS_COLLISION_PAIR_EDGE_EDGE) {
        separation =
            closest_between_edges(to1, vec3_sub(y[3], y[2]), to2, &weights[1], &weights[3]);
        weights[0] = 1.0 - weights[1];
        weights[2] = 1.0 - weights[3];
    } else {
        const vec3 corners[3] = {to1, to2, to3};
        separation = closest_on_triangle(corners, &weights[1]);
    }
    double distance = vec3_norm(separation);
    if (distance <= q->thickness) {
        result->hit = 1;
        result->distance = distance;
        result->normal = vec3_unit_or(separation, vec3_zero());
        for (int k = 0; k < 4; k++) {
            result->weights[k] = weights[k];
        }
    }
}

void vbss_collision_run_cubic(const collision_ccd_options *options,
                              const collision_ccd_query *query, collision_ccd_result *result,
                              collision_counters *counters)
{
    (void)options;
    (void)counters;
    const vec3 *x = query->start, *y = query->end;
    bool edges = query->kind == VBSS_COLLISION_PAIR_EDGE_EDGE;
    spanned from = spanned_by(x[0], x[1], x[2], x[3], edges);
    spanned to = spanned_by(y[0], y[1], y[2], y[3], edges);
    cubic c = cubic_of(&from, &to);
    bool found = !never_zero(&c) && test_roots(query, &c, result);
    if (!found && query->thickness > 0.0) {
        test_end(query, result);
    }
}
