/* Method VBLAST: the continuous collision test of VBLaST-SS (Qi et al. 2017, algorithm 1),
 * extended to a point and a triangle. It keeps the misses and false hits of the paper:
 * docs/explanation/paper-collision.md.
 *
 * The vector w leads from b to a: between the lines of two edges, or from the plane of the
 * triangle to the point. Edges count as parallel below the paper's eps_E, the only number that
 * depends on the unit of length. The code converts eps_E to the unit of the coordinates. */
#include "collision/collision.h"

#include "collision/closest.h"

/* w = height n / nn. Division and square root are deferred until a result needs them. */
typedef struct shortest {
    vec3 n;
    double height, nn;
} shortest;

/* Returns w for features with the normal n; r leads from a to b. Where n is zero, the paper
 * divides 0 by 0; here the sign test then reports a miss. */
static inline shortest shortest_along(vec3 n, vec3 r)
{
    shortest w = {n, -vec3_dot(r, n), vec3_norm_squared(n)};
    return w;
}

/* Returns the vector from a to b; nn must not be zero. */
static inline vec3 from_a_to_b(const shortest *w)
{
    return vec3_scale(w->n, -w->height / w->nn);
}

/* ---- steps (i) and (ii) of both kinds */

static inline bool near_at_end(vec3 apart, double thickness, collision_ccd_result *answer)
{
    double square = vec3_norm_squared(apart);
    if (!(square < thickness * thickness)) {
        return false;
    }
    answer->hit = 1;
    answer->distance = sqrt(square);
    answer->normal = vec3_unit_or(apart, vec3_zero());
    return true;
}

/* Computes the time at which w, assumed linear, is zero. Returns false if its signs show no
 * crossing. */
static inline bool linear_time(const shortest *first, const shortest *last,
                               collision_ccd_result *answer, collision_counters *counters,
                               double *time)
{
    if (!(first->height * last->height * vec3_dot(first->n, last->n) < 0.0)) {
        counters->sign_tests_ended++;
        return false;
    }
    /* |w| is |height| / sqrt(nn); both lengths are multiplied by both roots. */
    double before = fabs(first->height) * sqrt(last->nn),
           after = fabs(last->height) * sqrt(first->nn);
    *time = before / (before + after);
    answer->passes = 1;
    return true;
}

/* Sets the result of a crossing. The features are assumed to touch at that time, so w at the
 * start gives the side. n is normal to both features, or zero if their normal is not unique. */
static void set_crossing_result(collision_ccd_result *answer, double time, double distance, vec3 n,
                                const shortest *first)
{
    vec3 back = first->height > 0.0 ? vec3_neg(first->n) : first->n; /* from a to b */
    vec3 across = vec3_dot(n, back) < 0.0 ? vec3_neg(n) : n;
    answer->hit = 1;
    answer->time = time;
    answer->distance = distance;
    answer->normal = vec3_unit_or(across, vec3_unit_or(back, vec3_zero()));
}

/* ---- edges */

typedef struct edge_lines {
    vec3 a, b, r; /* edges, and the vector from the start of a to the start of b */
    double aa, ab, bb, ar, determinant;
    bool parallel;
} edge_lines;

static inline edge_lines edge_lines_of(vec3 a0, vec3 a1, vec3 b0, vec3 b1, double eps)
{
    edge_lines l;
    l.a = vec3_sub(a1, a0);
    l.b = vec3_sub(b1, b0);
    l.r = vec3_sub(b0, a0);
    l.aa = vec3_norm_squared(l.a);
    l.bb = vec3_norm_squared(l.b);
    l.ab = vec3_dot(l.a, l.b);
    l.ar = vec3_dot(l.a, l.r);
    l.determinant = l.aa * l.bb - l.ab * l.ab;
    l.parallel = l.determinant < eps;
    return l;
}

/* Returns the paper's s_j for parallel edges, d / b. It is NaN for edges of zero length, and for
 * edges that count as parallel although they are perpendicular. NaN lies inside no edge and has
 * no sign. */
static inline double parallel_foot(const edge_lines *l)
{
    return l->ab != 0.0 ? -l->ar / l->ab : (double)NAN;
}

static inline shortest shortest_of_lines(const edge_lines *l)
{
    if (l->parallel) {
        shortest w = {vec3_neg(vec3_add_scaled(l->r, parallel_foot(l), l->b)), 1.0, 1.0};
        w.height = w.nn = vec3_norm_squared(w.n);
        return w;
    }
    return shortest_along(vec3_cross(l->a, l->b), l->r);
}

/* Returns whether both feet of w are inside their edges; if so, sets their fractions s and u. */
static inline bool feet_inside(const edge_lines *l, double *s, double *u)
{
    if (l->parallel) {
        *s = 0.0;
        *u = parallel_foot(l);
        return *u >= 0.0 && *u <= 1.0;
    }
    double br = vec3_dot(l->b, l->r), whole = l->determinant;
    double of_a = l->ar * l->bb - l->ab * br, of_b = l->ab * l->ar - l->aa * br;
    if (!(whole > 0.0 && of_a >= 0.0 && of_a <= whole && of_b >= 0.0 && of_b <= whole)) {
        return false;
    }
    *s = of_a / whole;
    *u = of_b / whole;
    return true;
}

static void set_edge_weights(collision_ccd_result *answer, double s, double u)
{
    answer->weights[0] = 1.0 - s;
    answer->weights[1] = s;
    answer->weights[2] = 1.0 - u;
    answer->weights[3] = u;
}

static void test_edges(double eps, const collision_ccd_query *question,
                       collision_ccd_result *answer, collision_counters *counters)
{
    const vec3 *x = question->start, *y = question->end;
    edge_lines last = edge_lines_of(y[0], y[1], y[2], y[3], eps);
    shortest w1 = shortest_of_lines(&last);
    double s, u, time, thickness = question->thickness;
    if (thickness > 0.0) { /* step (i) */
        bool inside = feet_inside(&last, &s, &u) && w1.nn > 0.0;
        vec3 apart =
            inside ? from_a_to_b(&w1) : closest_between_edges(last.a, last.b, last.r, &s, &u);
        if (near_at_end(apart, thickness, answer)) {
            set_edge_weights(answer, s, u);
            return;
        }
    }
    edge_lines first = edge_lines_of(x[0], x[1], x[2], x[3], eps);
    shortest w0 = shortest_of_lines(&first);
    if (!linear_time(&w0, &w1, answer, counters, &time)) { /* step (ii a) */
        return;
    }
    edge_lines then = edge_lines_of(vec3_lerp(x[0], y[0], time), vec3_lerp(x[1], y[1], time),
                                    vec3_lerp(x[2], y[2], time), vec3_lerp(x[3], y[3], time), eps);
    if (feet_inside(&then, &s, &u)) { /* step (ii b) */
        double distance = vec3_norm(edge_separation(then.a, then.b, then.r, s, u));
        vec3 n = then.parallel ? vec3_zero() : vec3_cross(then.a, then.b);
        set_crossing_result(answer, time, distance, n, &w0);
        set_edge_weights(answer, s, u);
    }
}

/* ---- a point and a triangle */

typedef struct point_plane {
    vec3 f[3], e1, e2; /* corners relative to the point; edges from the first corner */
    vec3 n;            /* normal of the plane; its length is twice the area */
    double nn;
} point_plane;

static inline point_plane point_plane_of(vec3 p, vec3 b0, vec3 b1, vec3 b2)
{
    point_plane q;
    q.f[0] = vec3_sub(b0, p);
    q.f[1] = vec3_sub(b1, p);
    q.f[2] = vec3_sub(b2, p);
    q.e1 = vec3_sub(b1, b0);
    q.e2 = vec3_sub(b2, b0);
    q.n = vec3_cross(q.e1, q.e2);
    q.nn = vec3_norm_squared(q.n);
    return q;
}

/* Returns whether the foot of w is inside the triangle; if so, sets its area coordinates. */
static inline bool foot_inside(const point_plane *q, double weights[3])
{
    double w1 = vec3_dot(vec3_cross(q->e2, q->f[0]), q->n);
    double w2 = vec3_dot(vec3_cross(q->f[0], q->e1), q->n), w0 = q->nn - w1 - w2;
    if (!(q->nn > 0.0 && w0 >= 0.0 && w1 >= 0.0 && w2 >= 0.0)) {
        return false;
    }
    weights[0] = w0 / q->nn;
    weights[1] = w1 / q->nn;
    weights[2] = w2 / q->nn;
    return true;
}

static void set_corner_weights(collision_ccd_result *answer, const double weights[3])
{
    answer->weights[0] = 1.0;
    for (int k = 0; k < 3; k++) {
        answer->weights[k + 1] = weights[k];
    }
}

static void test_point_triangle(const collision_ccd_query *question, collision_ccd_result *answer,
                                collision_counters *counters)
{
    const vec3 *x = question->start, *y = question->end;
    point_plane last = point_plane_of(y[0], y[1], y[2], y[3]);
    shortest w1 = shortest_along(last.n, last.f[0]);
    double weights[3], time, thickness = question->thickness;
    if (thickness > 0.0) { /* step (i) */
        vec3 apart =
            foot_inside(&last, weights) ? from_a_to_b(&w1) : closest_on_triangle(last.f, weights);
        if (near_at_end(apart, thickness, answer)) {
            set_corner_weights(answer, weights);
            return;
        }
    }
    point_plane first = point_plane_of(x[0], x[1], x[2], x[3]);
    shortest w0 = shortest_along(first.n, first.f[0]);
    if (!linear_time(&w0, &w1, answer, counters, &time)) { /* step (ii a) */
        return;
    }
    point_plane then = point_plane_of(vec3_lerp(x[0], y[0], time), vec3_lerp(x[1], y[1], time),
                                      vec3_lerp(x[2], y[2], time), vec3_lerp(x[3], y[3], time));
    if (foot_inside(&then, weights)) { /* step (ii b) */
        shortest w = shortest_along(then.n, then.f[0]);
        set_crossing_result(answer, time, fabs(w.height) / sqrt(w.nn), then.n, &w0);
        set_corner_weights(answer, weights);
    }
}

static void test_pair(const collision_ccd_options *rules, const collision_ccd_query *question,
                      collision_ccd_result *answer, collision_counters *counters)
{
    if (question->kind == VBSS_COLLISION_PAIR_POINT_TRIANGLE) {
        test_point_triangle(question, answer, counters);
    } else {
        double square = rules->length_unit * rules->length_unit;
        test_edges(rules->parallel_threshold * square * square, question, answer, counters);
    }
}

const collision_ccd_method vbss_baseline_ccd = {test_pair, VBSS_COLLISION_DECISION_CLAIMED, false};
