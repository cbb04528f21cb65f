/* The smallest distance of two moving features over time, by branch and bound on sampled distances.
 *
 * For a fixed pair of points on the features the vector between them, r, is linear in time, so between
 * two times r(t) = (1 - w) r0 + w r1 and
 *     |r(t)|^2 = (1 - w) |r0|^2 + w |r1|^2 - w (1 - w) |r1 - r0|^2.
 * |r0| and |r1| are at least the distances d0 and d1 of the features at these times, and |r1 - r0| is at
 * most M, the largest relative displacement of a vertex of a and one of b. Hence the square of the distance
 * is at least (1 - w) d0^2 + w d1^2 - w (1 - w) M^2: a bound that closes with the square of the interval. */
#include "scenes/collision_build.h"

/* Long double, so that 1e-10 stands far above rounding. Where it is no wider than double, 1e-10 still
 * does. */
typedef long double real;
typedef struct point {
    real x, y, z;
} point;

static point minus(point a, point b)
{
    return (point){a.x - b.x, a.y - b.y, a.z - b.z};
}

static point plus_scaled(point a, real s, point b)
{
    return (point){a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}

static real dot(point a, point b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static point cross(point a, point b)
{
    return (point){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static real clamp(real x)
{
    return x < 0.0L ? 0.0L : x > 1.0L ? 1.0L : x;
}

static real smaller(real a, real b)
{
    return b < a ? b : a;
}

/* ---- squared distances. Each candidate joins two real points of the features, so none is too small;
 * together they hold the smallest. */

static real origin_to_edge(point from, point to)
{
    point e = minus(to, from);
    real ee = dot(e, e);
    point nearest = plus_scaled(from, ee > 0.0L ? clamp(-dot(from, e) / ee) : 0.0L, e);
    return dot(nearest, nearest);
}

static real edge_to_edge(const point x[4])
{
    point a = minus(x[1], x[0]), b = minus(x[3], x[2]), r = minus(x[0], x[2]);
    real best = origin_to_edge(minus(x[2], x[0]), minus(x[3], x[0]));
    best = smaller(best, origin_to_edge(minus(x[2], x[1]), minus(x[3], x[1])));
    best = smaller(best, origin_to_edge(minus(x[0], x[2]), minus(x[1], x[2])));
    best = smaller(best, origin_to_edge(minus(x[0], x[3]), minus(x[1], x[3])));
    real aa = dot(a, a), ab = dot(a, b), bb = dot(b, b), ar = dot(a, r), br = dot(b, r);
    real determinant = aa * bb - ab * ab;
    if (determinant > 0.0L) {
        real s = clamp((ab * br - bb * ar) / determinant);
        real u = clamp((aa * br - ab * ar) / determinant);
        point apart = plus_scaled(plus_scaled(r, s, a), -u, b);
        best = smaller(best, dot(apart, apart));
    }
    return best;
}

static real point_to_triangle(const point x[4])
{
    point f[3] = {minus(x[1], x[0]), minus(x[2], x[0]), minus(x[3], x[0])};
    real best = origin_to_edge(f[0], f[1]);
    best = smaller(best, origin_to_edge(f[1], f[2]));
    best = smaller(best, origin_to_edge(f[2], f[0]));
    point n = cross(minus(f[1], f[0]), minus(f[2], f[0]));
    real w[3] = {dot(n, cross(f[1], f[2])), dot(n, cross(f[2], f[0])), dot(n, cross(f[0], f[1]))};
    real sum = w[0] + w[1] + w[2];
    if (w[0] >= 0.0L && w[1] >= 0.0L && w[2] >= 0.0L && sum > 0.0L) {
        point foot = plus_scaled(plus_scaled(f[0], w[1] / sum, minus(f[1], f[0])), w[2] / sum,
                                 minus(f[2], f[0]));
        best = smaller(best, dot(foot, foot));
    }
    return best;
}

static point at_time(const collision_query *query, int vertex, real t)
{
    size_t first = (size_t)vertex * 3;
    const double *p = &query->start[first], *q = &query->end[first];
    real u = 1.0L - t;
    return (point){u * (real)p[0] + t * (real)q[0], u * (real)p[1] + t * (real)q[1],
                   u * (real)p[2] + t * (real)q[2]};
}

long double collision_distance(const collision_query *query, long double t)
{
    point x[4];
    for (int i = 0; i < 4; i++) {
        x[i] = at_time(query, i, t);
    }
    return sqrtl(query->kind == VBSS_PAIR_EDGE_EDGE ? edge_to_edge(x) : point_to_triangle(x));
}

/* ---- branch and bound */

/* How much smaller than `best` the smallest distance may be: the first is enough unless it leaves open
 * on which side of D the smallest distance lies. Features that slide along each other at a constant
 * distance cost the square root of its inverse. */
static const real slacks[2] = {1e-9L, 1e-11L};

typedef struct search {
    const collision_query *query;
    real speed; /* largest relative speed of two vertices */
    real best;  /* smallest distance so far */
    real hit;   /* a distance below this ends the search */
    real clear; /* nobody asks by how much a distance is above this */
    real slack;
} search;

static real relative_speed(const collision_query *query)
{
    point v[4];
    for (int i = 0; i < 4; i++) {
        v[i] = minus(at_time(query, i, 1.0L), at_time(query, i, 0.0L));
    }
    int a_count = query->kind == VBSS_PAIR_EDGE_EDGE ? 2 : 1;
    real largest = 0.0L;
    for (int i = 0; i < a_count; i++) {
        for (int j = a_count; j < 4; j++) {
            point apart = minus(v[j], v[i]);
            real square = dot(apart, apart);
            largest = square > largest ? square : largest;
        }
    }
    return sqrtl(largest);
}

static real lower_bound(real d0, real d1, real m)
{
    real q0 = d0 * d0, q1 = d1 * d1, mm = m * m;
    if (fabsl(q0 - q1) >= mm) { /* smallest at an end */
        return smaller(d0, d1);
    }
    real half = (mm + q0 - q1) / (2.0L * m);
    real square = q0 - half * half;
    return square > 0.0L ? sqrtl(square) : 0.0L;
}

static void look(search *s, real t0, real d0, real t1, real d1)
{
    if (s->best < s->hit ||
        lower_bound(d0, d1, s->speed * (t1 - t0)) > smaller(s->best - s->slack, s->clear)) {
        return;
    }
    real t = 0.5L * (t0 + t1);
    if (!(t0 < t && t < t1)) {
        return;
    }
    real d = collision_distance(s->query, t);
    s->best = smaller(s->best, d);
    if (d0 < d1) { /* the nearer half first: what it finds may spare the other */
        look(s, t0, d0, t, d);
        look(s, t, d, t1, d1);
    } else {
        look(s, t, d, t1, d1);
        look(s, t0, d0, t, d);
    }
}

bool collision_truth(collision_query *query)
{
    real thickness = (real)query->thickness;
    search s = {.query = query, .speed = relative_speed(query), .slack = (real)INFINITY};
    s.hit = thickness - (real)COLLISION_UNCERTAIN;
    s.clear = 1.01L * thickness;
    real d0 = collision_distance(query, 0.0L), d1 = collision_distance(query, 1.0L);
    s.best = smaller(d0, d1);
    for (int i = 0; i < 2 && s.best - 2.0L * s.slack <= thickness; i++) {
        s.slack = slacks[i];
        look(&s, 0.0L, d0, 1.0L, d1);
    }
    query->hit = s.best <= thickness;
    query->clearance = (double)(s.best - thickness);
    return fabsl(s.best - thickness) >= (real)COLLISION_UNCERTAIN;
}
