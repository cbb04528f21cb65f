/* Directional conservative advancement: a continuous test whose misses are proofs.
 *
 * A fixed direction n separates the features by at least g between two times if it does so at both,
 * because n times the vector between two vertices is linear in time. Each pass takes n along the
 * shortest vector, advances to the time where n no longer separates by more than D, and takes a new
 * n there. If time 1 is reached, the result is a miss; if the features are close enough, a hit.
 * docs/explanation/collision-proof.md has the proof, with rounding. */
#include "collision/collision.h"

#include "collision/closest.h"
#include "collision/conservative_advancement.h"
#include "collision/ccd_crossing.h"
#include "collision/ccd_exact.h"

/* Componentwise maximum of magnitudes. */
static inline vec3 larger_magnitudes(vec3 a, vec3 b)
{
    return vec3_make(vbss_max(fabs(a.x), fabs(b.x)), vbss_max(fabs(a.y), fabs(b.y)),
                     vbss_max(fabs(a.z), fabs(b.z)));
}

static inline double largest_of(vec3 magnitudes)
{
    return vbss_max(vbss_max(magnitudes.x, magnitudes.y), magnitudes.z);
}

static inline void set_relative_start(const collision_ccd_query *q, collision_relative_motion *m)
{
    m->start[0] = vec3_sub(q->start[1], q->start[0]);
    m->start[1] = vec3_sub(q->start[2], q->start[0]);
    m->start[2] = vec3_sub(q->start[3], q->start[0]);
}

/* Sets the end positions and the size; the start must be set. */
static inline void set_relative_end(const collision_ccd_query *q, collision_relative_motion *m)
{
    vec3 largest[3];
    for (int k = 0; k < 3; k++) {
        m->end[k] = vec3_sub(q->end[k + 1], q->end[0]);
        largest[k] = larger_magnitudes(m->start[k], m->end[k]);
    }
    m->size = largest_of(larger_magnitudes(larger_magnitudes(largest[0], largest[1]), largest[2]));
}

/* Closest points at one time. */
typedef struct closest_points {
    vec3 separation; /* from a to b */
    double distance_squared;
    double weights[4];
} closest_points;

/* Vertices 1, 2 and 3 are at p, q and r. */
VBSS_ALWAYS_INLINE void closest_at_positions(bool edges, vec3 p, vec3 q, vec3 r,
                                             closest_points *now)
{
    double *w = now->weights;
    if (edges) {
        now->separation = closest_between_edges(p, vec3_sub(r, q), q, &w[1], &w[3]);
        w[0] = 1.0 - w[1];
        w[2] = 1.0 - w[3];
    } else {
        const vec3 corners[3] = {p, q, r};
        w[0] = 1.0;
        now->separation = closest_on_triangle(corners, &w[1]);
    }
    now->distance_squared = vec3_norm_squared(now->separation);
}

VBSS_ALWAYS_INLINE void closest_at_time(const collision_relative_motion *m, bool edges, double t,
                                        closest_points *now)
{
    closest_at_positions(edges, relative_at(m, 0, t), relative_at(m, 1, t), relative_at(m, 2, t),
                         now);
}

/* ---- certificates: projections of the vertices on a direction n, at the start (0) and the end
 * (1) */

typedef struct projection {
    double p0, p1, q0, q1, r0, r1;
} projection;

static inline projection project(const collision_relative_motion *m, vec3 n)
{
    projection g = {vec3_dot(n, m->start[0]), vec3_dot(n, m->end[0]),   vec3_dot(n, m->start[1]),
                    vec3_dot(n, m->end[1]),   vec3_dot(n, m->start[2]), vec3_dot(n, m->end[2])};
    return g;
}

/* Smallest gap of all pairs: q and r of b minus 0 and p of a; or the corners p, q and r minus the
 * point. */
VBSS_ALWAYS_INLINE double min_pair_gap(bool edges, double p, double q, double r)
{
    double min_gap = vbss_min(q, r);
    return edges ? min_gap - vbss_max(p, 0.0) : vbss_min(min_gap, p);
}

/* Whether n separates by `clearance` from start to end; `square` is |n|^2. This proves most misses
 * and needs no square root. */
VBSS_ALWAYS_INLINE bool separates_throughout(const projection *g, bool edges, double clearance,
                                             double square)
{
    double min_gap = vbss_min(min_pair_gap(edges, g->p0, g->q0, g->r0),
                              min_pair_gap(edges, g->p1, g->q1, g->r1));
    return min_gap > 0.0 && min_gap * min_gap >= clearance * clearance * square;
}

static inline double projected(double g0, double g1, double t)
{
    return g0 + t * (g1 - g0);
}

/* Rate at which the gap of a pair falls below `clearance`: its deficit at the end divided by its
 * surplus now. The pair with the largest rate is the first to fall. */
static inline double max_slope(double steepest, double now, double end, double clearance)
{
    double lack = clearance - end, spare = now - clearance;
    if (spare == 0.0) { /* as the division would give */
        return lack > 0.0 ? (double)INFINITY : steepest;
    }
    return vbss_max(lack / spare, steepest);
}

/* Time until which all pairs are separated by `clearance`, starting at t: above 1 if until the end,
 * -1 if they are not separated at t. If `clearance` is |n| times a distance, n separates by that
 * distance. */
VBSS_ALWAYS_INLINE double separates_until(const projection *g, bool edges, double t,
                                          double clearance)
{
    double p = projected(g->p0, g->p1, t), q = projected(g->q0, g->q1, t);
    double r = projected(g->r0, g->r1, t);
    if (!(min_pair_gap(edges, p, q, r) >= clearance)) {
        return -1.0;
    }
    double steepest = max_slope(max_slope(0.0, q, g->q1, clearance), r, g->r1, clearance);
    if (edges) {
        double others = max_slope(0.0, q - p, g->q1 - g->p1, clearance);
        steepest = vbss_max(steepest, max_slope(others, r - p, g->r1 - g->p1, clearance));
    } else {
        steepest = max_slope(steepest, p, g->p1, clearance);
    }
    return steepest > 0.0 ? t + (1.0 - t) / (1.0 + steepest) : 2.0;
}

/* Tries other directions if the shortest vector was too inaccurate: the common normal, and for
 * edges the shortest vector made normal to the longer edge. */
VBSS_NEVER_INLINE double separates_until_fallback(const collision_relative_motion *m, bool edges,
                                                  const closest_points *now, double t,
                                                  double clearance, vec3 *direction)
{
    vec3 a = relative_at(m, 0, t), q = relative_at(m, 1, t), b = vec3_sub(relative_at(m, 2, t), q);
    vec3 others[2];
    others[0] = vec3_cross(edges ? a : vec3_sub(q, a), b);
    int count = 1;
    if (edges) {
        vec3 longer = vec3_norm_squared(a) > vec3_norm_squared(b) ? a : b;
        double square = vec3_norm_squared(longer);
        if (square > 0.0) {
            double along = vec3_dot(now->separation, longer) / square;
            others[count++] = vec3_add_scaled(now->separation, -along, longer);
        }
    }
    for (int k = 0; k < count; k++) {
        double length = vec3_norm(others[k]);
        if (!(length > 1e-140)) { /* the square of a shorter vector would underflow */
            continue;
        }
        double sign = vec3_dot(others[k], now->separation) < 0.0 ? -1.0 : 1.0;
        vec3 n = vec3_scale(others[k], sign);
        projection g = project(m, n);
        double until = separates_until(&g, edges, t, clearance * length);
        if (until > t) {
            *direction = n;
            return until;
        }
    }
    return -1.0;
}

static inline void set_hit(collision_ccd_result *result, vbss_collision_decision decision, double t,
                           const closest_points *now, double distance, vec3 normal)
{
    result->hit = 1;
    result->decision = decision;
    result->time = t;
    result->distance = distance;
    result->normal = normal;
    for (int k = 0; k < 4; k++) {
        result->weights[k] = now->weights[k];
    }
}

/* Normal of a hit: along the shortest vector. If that vector is within rounding error, along the
 * last certified direction, if there was one. */
static inline vec3 normal_of(const closest_points *now, double distance, double rounding_square,
                             vec3 last)
{
    if (now->distance_squared < rounding_square || distance <= 1e-150) {
        vec3 before = vec3_unit_or(last, vec3_zero());
        return vec3_norm_squared(before) > 0.0 ? before : vec3_unit_or(now->separation, before);
    }
    return vec3_scale(now->separation, 1.0 / distance);
}

/* Advances from the start, where the features are not yet a hit. */
VBSS_ALWAYS_INLINE void advance(const collision_relative_motion *m,
                                const collision_ccd_options *options, bool edges, uint32_t limit,
                                double thickness, closest_points *now, collision_ccd_result *result)
{
    conservative_bounds bounds = conservative_bounds_of(options->tolerance, thickness, m->size);
    double t = 0.0;
    vec3 last = vec3_zero();
    for (;; result->passes++) {
        if (now->distance_squared <= bounds.near_square) {
            double distance = sqrt(now->distance_squared);
            vec3 normal = normal_of(now, distance, bounds.rounding_square, last);
            set_hit(result, VBSS_COLLISION_DECISION_PROVED, t, now, distance, normal);
            return;
        }
        vec3 n = now->separation; /* not normalised, which would cost more than the rest */
        projection g = project(m, n);
        if (separates_throughout(&g, edges, bounds.clearance, now->distance_squared)) {
            return;
        }
        double distance = sqrt(now->distance_squared);
        double until = separates_until(&g, edges, t, bounds.clearance * distance);
        if (!(until > t)) {
            until = separates_until_fallback(m, edges, now, t, bounds.clearance, &n);
        }
        if (until > 1.0) {
            return;
        }
        last = n;
        if (!(until > t) || result->passes >= limit) {
            vec3 normal = vec3_unit_or(n, vec3_zero());
            set_hit(result, VBSS_COLLISION_DECISION_UNDECIDED, t, now, distance, normal);
            return;
        }
        t = until;
        closest_at_time(m, edges, t, now);
    }
}

/* Features within D and its tolerance at the start are a hit, whatever follows. */
VBSS_ALWAYS_INLINE bool hits_at_start(const collision_relative_motion *m,
                                      const collision_ccd_options *options, bool edges,
                                      double thickness, closest_points *now,
                                      collision_ccd_result *result)
{
    closest_at_positions(edges, m->start[0], m->start[1], m->start[2], now);
    result->passes = 1;
    double near = thickness + COLLISION_HIT_FRACTION * (options->tolerance * thickness);
    if (!(now->distance_squared <= near * near)) {
        return false;
    }
    double distance = sqrt(now->distance_squared);
    vec3 normal = normal_of(now, distance, 0.0, vec3_zero());
    set_hit(result, VBSS_COLLISION_DECISION_PROVED, 0.0, now, distance, normal);
    return true;
}

/* Not inlined, to keep the common decision at the start small. */
VBSS_NEVER_INLINE void advance_edges(const collision_relative_motion *m,
                                     const collision_ccd_options *options, uint32_t limit,
                                     double thickness, closest_points *now,
                                     collision_ccd_result *result)
{
    advance(m, options, true, limit, thickness, now, result);
}

VBSS_NEVER_INLINE void advance_triangle(const collision_relative_motion *m,
                                        const collision_ccd_options *options, uint32_t limit,
                                        double thickness, closest_points *now,
                                        collision_ccd_result *result)
{
    advance(m, options, false, limit, thickness, now, result);
}

VBSS_ALWAYS_INLINE void run_test(const collision_ccd_options *options, uint32_t limit,
                                 const collision_ccd_query *query, bool edges,
                                 collision_ccd_result *result)
{
    collision_relative_motion m;
    closest_points now;
    set_relative_start(query, &m);
    if (hits_at_start(&m, options, edges, query->thickness, &now, result)) {
        return;
    }
    set_relative_end(query, &m);
    if (edges) {
        advance_edges(&m, options, limit, query->thickness, &now, result);
    } else {
        advance_triangle(&m, options, limit, query->thickness, &now, result);
    }
}

/* Runs the test with at most `limit` passes. */
static void run_test_of_kind(const collision_ccd_options *options, uint32_t limit,
                             const collision_ccd_query *query, collision_ccd_result *result)
{
    if (query->kind == VBSS_COLLISION_PAIR_EDGE_EDGE) {
        run_test(options, limit, query, true, result);
    } else {
        run_test(options, limit, query, false, result);
    }
}

/* ---- zero thickness */

static double largest(vec3 a, vec3 b)
{
    return largest_of(larger_magnitudes(a, b));
}

/* The volume of the four vertices is a cubic in time. If all its Bernstein coefficients are on one
 * side of zero by more than their rounding error, the vertices are never coplanar. */
static bool never_coplanar(const collision_relative_motion *m)
{
    vec3 yz0 = vec3_cross(m->start[1], m->start[2]), yz1 = vec3_cross(m->end[1], m->end[2]);
    vec3 mixed = vec3_add(vec3_cross(m->start[1], m->end[2]), vec3_cross(m->end[1], m->start[2]));
    double first = vec3_dot(m->start[0], yz0), last = vec3_dot(m->end[0], yz1);
    /* 3 times the coefficient */
    double second = vec3_dot(m->end[0], yz0) + vec3_dot(m->start[0], mixed);
    double third = vec3_dot(m->start[0], yz1) + vec3_dot(m->end[0], mixed);
    double bound = largest(m->start[0], m->end[0]) * largest(m->start[1], m->end[1]) *
                   largest(m->start[2], m->end[2]) * VOLUME_ROUNDING;
    if (!(bound > VOLUME_UNDERFLOW)) {
        return false;
    }
    return (first > bound && last > bound && second > 3.0 * bound && third > 3.0 * bound) ||
           (first < -bound && last < -bound && second < -3.0 * bound && third < -3.0 * bound);
}

bool vbss_collision_proves_separation(const collision_ccd_query *query)
{
    static const collision_ccd_options options = {.tolerance = 0.0};
    collision_ccd_result result = vbss_collision_ccd_miss(VBSS_COLLISION_DECISION_PROVED);
    run_test_of_kind(&options, COLLISION_ZERO_PASS_LIMIT, query, &result);
    return result.hit == 0;
}

/* Decides whether features meet that are not proved to stay apart. */
static exact_result decide_exactly(const collision_ccd_options *options,
                                   const collision_ccd_query *query,
                                   const collision_relative_motion *m, double t,
                                   collision_counters *counters)
{
    if (vbss_collision_certifies_crossing(m, query->kind == VBSS_COLLISION_PAIR_EDGE_EDGE, t)) {
        return COLLISION_EXACT_HIT;
    }
    workspace w = {.limbs = options->limbs, .capacity = options->limb_count};
    counters->exact++;
    return vbss_collision_decide_exactly(query, &w);
}

static void run_zero_thickness(const collision_ccd_options *options,
                               const collision_ccd_query *query, collision_ccd_result *result,
                               collision_counters *counters)
{
    collision_relative_motion m;
    set_relative_start(query, &m);
    set_relative_end(query, &m);
    if (never_coplanar(&m)) {
        return;
    }
    uint32_t limit = conservative_pass_limit(options->pass_limit, 0.0);
    run_test_of_kind(options, limit, query, result);
    if (result->hit == 0) {
        return;
    }
    exact_result truth = decide_exactly(options, query, &m, result->time, counters);
    if (truth == COLLISION_EXACT_MISS) {
        uint32_t passes = result->passes;
        *result = vbss_collision_ccd_miss(VBSS_COLLISION_DECISION_EXACT);
        result->passes = passes;
        return;
    }
    if (result->decision == VBSS_COLLISION_DECISION_UNDECIDED && options->pass_limit > limit) {
        /* The limit stopped the first run. Continue to the contact if it is not too far. */
        limit = options->pass_limit < COLLISION_ZERO_HIT_PASS_LIMIT ? options->pass_limit
                                                                    : COLLISION_ZERO_HIT_PASS_LIMIT;
        *result = vbss_collision_ccd_miss(VBSS_COLLISION_DECISION_PROVED);
        run_test_of_kind(options, limit, query, result);
    }
    if (result->hit != 0) { /* otherwise further passes have proved a miss */
        result->decision = truth == COLLISION_EXACT_HIT ? VBSS_COLLISION_DECISION_EXACT
                                                        : VBSS_COLLISION_DECISION_UNDECIDED;
    }
}

void vbss_collision_run_conservative(const collision_ccd_options *options,
                                     const collision_ccd_query *query, collision_ccd_result *result,
                                     collision_counters *counters)
{
    if (query->thickness == 0.0) {
        run_zero_thickness(options, query, result, counters);
    } else {
        run_test_of_kind(options, options->pass_limit, query, result);
    }
    counters->passes += result->passes;
}
