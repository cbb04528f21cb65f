/* Conservative advancement of four queries in SIMD lanes, with the same bits as
 * conservative_advancement.c.
 *
 * Each function corresponds to one there or in closest.h, with selections in place of branches.
 * Rare cases (directions that prove nothing, exact arithmetic) are left to the scalar code. */
#include "base/vlanes.h"
#include "collision/closest.h"
#include "collision/conservative_advancement.h"
#include "collision/ccd_batch.h"
#include "collision/tuning.h"

static inline lanes clamp_unit_lanes(lanes x)
{
    return lanes_min(lanes_max(x, lanes_splat(0.0)), lanes_splat(1.0));
}

/* ---- queries */

typedef struct relative_lanes {
    vlanes start[3], end[3];
    lanes size;
} relative_lanes;

static inline vlanes larger_magnitudes(vlanes a, vlanes b)
{
    vlanes r = {lanes_max(lanes_abs(a.x), lanes_abs(b.x)),
                lanes_max(lanes_abs(a.y), lanes_abs(b.y)),
                lanes_max(lanes_abs(a.z), lanes_abs(b.z))};
    return r;
}

static inline lanes largest_of(vlanes magnitudes)
{
    return lanes_max(lanes_max(magnitudes.x, magnitudes.y), magnitudes.z);
}

static inline vlanes load_vertex(const double *rows, size_t stride, size_t vertex)
{
    const double *at = rows + 3 * vertex * stride;
    vlanes v = {lanes_load(at), lanes_load(at + stride), lanes_load(at + 2 * stride)};
    return v;
}

static inline void load_relative(const double *start, const double *end, size_t stride,
                                 relative_lanes *m)
{
    vlanes start0 = load_vertex(start, stride, 0), end0 = load_vertex(end, stride, 0);
    vlanes largest[3];
    for (size_t k = 0; k < 3; k++) {
        m->start[k] = v_sub(load_vertex(start, stride, k + 1), start0);
        m->end[k] = v_sub(load_vertex(end, stride, k + 1), end0);
        largest[k] = larger_magnitudes(m->start[k], m->end[k]);
    }
    m->size = largest_of(larger_magnitudes(larger_magnitudes(largest[0], largest[1]), largest[2]));
}

/* ---- closest points */

typedef struct closest_points_lanes {
    vlanes separation;
    lanes distance_squared, weights[4];
} closest_points_lanes;

static inline lanes closest_on_edge_lanes(vlanes e, vlanes to)
{
    lanes zero = lanes_splat(0.0), ee = v_dot(e, e);
    return lanes_select(lanes_less(zero, ee), clamp_unit_lanes(lanes_div(v_dot(e, to), ee)), zero);
}

static inline vlanes edge_separation_lanes(vlanes a, vlanes b, vlanes r, lanes s, lanes u)
{
    return v_sub(v_add_scaled(r, u, b), v_scale(a, s));
}

typedef struct edge_products_lanes {
    lanes aa, bb, ab, ar, br;
} edge_products_lanes;

static inline void closest_from_lanes(const edge_products_lanes *p, lanes line_s, lanes *s,
                                      lanes *u)
{
    lanes zero = lanes_splat(0.0), one = lanes_splat(1.0), first = clamp_unit_lanes(line_s);
    lanes inverse_aa = lanes_div(one, p->aa), inverse_bb = lanes_div(one, p->bb);
    lanes along = lanes_times(lanes_sub(lanes_times(first, p->ab), p->br), inverse_bb);
    *u = clamp_unit_lanes(along);
    lanes again = lanes_times(lanes_add(lanes_times(*u, p->ab), p->ar), inverse_aa);
    lanes_mask beyond = lanes_or(lanes_less(along, zero), lanes_less(one, along));
    *s = lanes_select(beyond, clamp_unit_lanes(again), first);
}

/* Replaces the results in the lanes of `which`. */
static inline void closest_parallel_edges_lanes(lanes_mask which, const edge_products_lanes *p,
                                                vlanes a, vlanes b, vlanes r, lanes *s, lanes *u,
                                                vlanes *separation)
{
    lanes zero = lanes_splat(0.0), s_best, u_best;
    vlanes n = v_cross(a, b);
    lanes nn = v_dot(n, n);
    lanes_mask angle = lanes_less(zero, nn);
    closest_from_lanes(p, lanes_div(v_dot(v_cross(r, b), n), nn), &s_best, &u_best);
    s_best = lanes_select(angle, s_best, zero);
    u_best = lanes_select(angle, u_best, zero);
    vlanes best = edge_separation_lanes(a, b, r, s_best, u_best);
    lanes min_squared = v_dot(best, best);
    for (int end = 0; end < 4; end++) {
        lanes at = lanes_splat((double)(end & 1)), s_end = at, u_end = at;
        if (end < 2) {
            u_end = closest_on_edge_lanes(b, v_sub(v_scale(a, at), r));
        } else {
            s_end = closest_on_edge_lanes(a, v_add_scaled(r, at, b));
        }
        vlanes to = edge_separation_lanes(a, b, r, s_end, u_end);
        lanes square = v_dot(to, to);
        lanes_mask nearer = lanes_less(square, min_squared);
        min_squared = lanes_select(nearer, square, min_squared);
        best = v_select(nearer, to, best);
        s_best = lanes_select(nearer, s_end, s_best);
        u_best = lanes_select(nearer, u_end, u_best);
    }
    *s = lanes_select(which, s_best, *s);
    *u = lanes_select(which, u_best, *u);
    *separation = v_select(which, best, *separation);
}

static inline void closest_between_edges_lanes(vlanes a, vlanes b, vlanes r,
                                               closest_points_lanes *now)
{
    lanes one = lanes_splat(1.0), s, u;
    edge_products_lanes p = {v_dot(a, a), v_dot(b, b), v_dot(a, b), v_dot(a, r), v_dot(b, r)};
    lanes determinant = lanes_sub(lanes_times(p.aa, p.bb), lanes_times(p.ab, p.ab));
    lanes limit = lanes_times(lanes_times(lanes_splat(CLOSEST_PARALLEL), p.aa), p.bb);
    lanes first = lanes_sub(lanes_times(p.ar, p.bb), lanes_times(p.ab, p.br));
    closest_from_lanes(&p, lanes_div(first, determinant), &s, &u);
    now->separation = edge_separation_lanes(a, b, r, s, u);
    lanes_mask parallel = lanes_not(lanes_less(limit, determinant));
    if (lanes_movemask(parallel) != 0) {
        closest_parallel_edges_lanes(parallel, &p, a, b, r, &s, &u, &now->separation);
    }
    now->weights[0] = lanes_sub(one, s);
    now->weights[1] = s;
    now->weights[2] = lanes_sub(one, u);
    now->weights[3] = u;
}

static inline void closest_on_triangle_lanes(const vlanes f[3], closest_points_lanes *now)
{
    lanes zero = lanes_splat(0.0), one = lanes_splat(1.0);
    lanes *w = &now->weights[1];
    vlanes best = f[0];
    lanes min_squared = v_dot(f[0], f[0]);
    w[0] = one;
    w[1] = w[2] = zero;
    for (int k = 0; k < 3; k++) {
        vlanes from = f[k], e = v_sub(f[(k + 1) % 3], from);
        lanes s = closest_on_edge_lanes(e, v_scale(from, lanes_splat(-1.0)));
        vlanes to = v_add_scaled(from, s, e);
        lanes square = v_dot(to, to);
        lanes_mask nearer = lanes_less(square, min_squared);
        min_squared = lanes_select(nearer, square, min_squared);
        best = v_select(nearer, to, best);
        w[k] = lanes_select(nearer, lanes_sub(one, s), w[k]);
        w[(k + 1) % 3] = lanes_select(nearer, s, w[(k + 1) % 3]);
        w[(k + 2) % 3] = lanes_select(nearer, zero, w[(k + 2) % 3]);
    }
    vlanes e1 = v_sub(f[1], f[0]), e2 = v_sub(f[2], f[0]), n = v_cross(e1, e2);
    lanes nn = v_dot(n, n);
    lanes w2 = v_dot(v_cross(f[0], e1), n), w1 = v_dot(v_cross(e2, f[0]), n);
    lanes_mask foot = lanes_and(lanes_and(lanes_less(zero, nn), lanes_less(zero, w1)),
                                lanes_and(lanes_less(zero, w2), lanes_less(lanes_add(w1, w2), nn)));
    lanes v1 = lanes_div(w1, nn), v2 = lanes_div(w2, nn);
    vlanes to = v_add_scaled(v_add_scaled(f[0], v1, e1), v2, e2);
    foot = lanes_and(foot, lanes_less(v_dot(to, to), min_squared));
    now->separation = v_select(foot, to, best);
    w[0] = lanes_select(foot, lanes_sub(lanes_sub(one, v1), v2), w[0]);
    w[1] = lanes_select(foot, v1, w[1]);
    w[2] = lanes_select(foot, v2, w[2]);
    now->weights[0] = one;
}

static inline void closest_at_time(const relative_lanes *m, bool edges, bool first, lanes t,
                                   closest_points_lanes *now)
{
    vlanes at[3];
    for (int k = 0; k < 3; k++) {
        at[k] = first ? m->start[k] : v_add_scaled(m->start[k], t, v_sub(m->end[k], m->start[k]));
    }
    if (edges) {
        closest_between_edges_lanes(at[0], v_sub(at[2], at[1]), at[1], now);
    } else {
        closest_on_triangle_lanes(at, now);
    }
    now->distance_squared = v_dot(now->separation, now->separation);
}

/* ---- certificates */

typedef struct projection_lanes {
    lanes p0, p1, q0, q1, r0, r1;
} projection_lanes;

static inline lanes min_pair_gap(bool edges, lanes p, lanes q, lanes r)
{
    lanes min_gap = lanes_min(q, r);
    return edges ? lanes_sub(min_gap, lanes_max(p, lanes_splat(0.0))) : lanes_min(min_gap, p);
}

static inline lanes_mask separates_throughout(const projection_lanes *g, bool edges,
                                              lanes clearance, lanes square)
{
    lanes min_gap = lanes_min(min_pair_gap(edges, g->p0, g->q0, g->r0),
                              min_pair_gap(edges, g->p1, g->q1, g->r1));
    lanes needed = lanes_times(lanes_times(clearance, clearance), square);
    lanes_mask too_little = lanes_less(lanes_times(min_gap, min_gap), needed);
    return lanes_and(lanes_less(lanes_splat(0.0), min_gap), lanes_not(too_little));
}

static inline lanes projected(lanes g0, lanes g1, lanes t)
{
    return lanes_add(g0, lanes_times(t, lanes_sub(g1, g0)));
}

static inline lanes max_slope(lanes steepest, lanes now, lanes end, lanes clearance)
{
    return lanes_max(lanes_div(lanes_sub(clearance, end), lanes_sub(now, clearance)), steepest);
}

static inline lanes separates_until(const projection_lanes *g, bool edges, lanes t, lanes clearance)
{
    lanes p = projected(g->p0, g->p1, t), q = projected(g->q0, g->q1, t);
    lanes r = projected(g->r0, g->r1, t), zero = lanes_splat(0.0), one = lanes_splat(1.0);
    lanes steepest = max_slope(max_slope(zero, q, g->q1, clearance), r, g->r1, clearance);
    if (edges) {
        lanes others = max_slope(zero, lanes_sub(q, p), lanes_sub(g->q1, g->p1), clearance);
        others = max_slope(others, lanes_sub(r, p), lanes_sub(g->r1, g->p1), clearance);
        steepest = lanes_max(steepest, others);
    } else {
        steepest = max_slope(steepest, p, g->p1, clearance);
    }
    lanes falls = lanes_add(t, lanes_div(lanes_sub(one, t), lanes_add(one, steepest)));
    lanes until = lanes_select(lanes_less(zero, steepest), falls, lanes_splat(2.0));
    return lanes_select(lanes_less(min_pair_gap(edges, p, q, r), clearance), lanes_splat(-1.0),
                        until);
}

/* ---- zero thickness */

static inline lanes_mask never_coplanar(const relative_lanes *m)
{
    vlanes yz0 = v_cross(m->start[1], m->start[2]), yz1 = v_cross(m->end[1], m->end[2]);
    vlanes mixed = v_add(v_cross(m->start[1], m->end[2]), v_cross(m->end[1], m->start[2]));
    lanes first = v_dot(m->start[0], yz0), last = v_dot(m->end[0], yz1);
    lanes second = lanes_add(v_dot(m->end[0], yz0), v_dot(m->start[0], mixed));
    lanes third = lanes_add(v_dot(m->start[0], yz1), v_dot(m->end[0], mixed));
    lanes bound = largest_of(larger_magnitudes(m->start[0], m->end[0]));
    for (int k = 1; k < 3; k++) {
        bound = lanes_times(bound, largest_of(larger_magnitudes(m->start[k], m->end[k])));
    }
    bound = lanes_times(bound, lanes_splat(VOLUME_ROUNDING));
    lanes thrice = lanes_times(lanes_splat(3.0), bound), zero = lanes_splat(0.0);
    lanes minus = lanes_sub(zero, bound), minus_thrice = lanes_sub(zero, thrice);
    lanes_mask above = lanes_and(lanes_and(lanes_less(bound, first), lanes_less(bound, last)),
                                 lanes_and(lanes_less(thrice, second), lanes_less(thrice, third)));
    lanes_mask below =
        lanes_and(lanes_and(lanes_less(first, minus), lanes_less(last, minus)),
                  lanes_and(lanes_less(second, minus_thrice), lanes_less(third, minus_thrice)));
    return lanes_and(lanes_less(lanes_splat(VOLUME_UNDERFLOW), bound), lanes_or(above, below));
}

/* ---- the advance */

typedef struct bounds_lanes {
    lanes clearance, near_square, rounding_square;
} bounds_lanes;

static inline bounds_lanes bounds_of(double tolerance, lanes thickness, lanes size)
{
    lanes min_tolerance = lanes_times(lanes_splat(MIN_TOLERANCE), lanes_add(size, thickness));
    lanes whole = lanes_max(lanes_times(lanes_splat(tolerance), thickness), min_tolerance);
    lanes near = lanes_add(thickness, lanes_times(lanes_splat(COLLISION_HIT_FRACTION), whole));
    lanes_mask tiny = lanes_and(lanes_less(thickness, lanes_splat(COLLISION_MIN_THICKNESS)),
                                lanes_less(size, lanes_splat(TINY_SIZE)));
    lanes rounding = lanes_times(lanes_splat(ROUNDING_FRACTION), size);
    bounds_lanes b = {
        lanes_add(thickness, lanes_times(lanes_splat(0.5), whole)),
        lanes_select(tiny, lanes_splat(DBL_MAX), lanes_times(near, near)),
        lanes_times(rounding, rounding),
    };
    return b;
}

/* Stores the hits; the other lanes get the values of a miss. */
static inline void store_hits(const closest_points_lanes *now, lanes t, lanes distance,
                              lanes_mask hit, collision_ccd_outcome *outcome)
{
    lanes zero = lanes_splat(0.0), one = lanes_splat(1.0), inverse = lanes_div(one, distance);
    lanes_store(outcome->time, lanes_select(hit, t, one));
    lanes_store(outcome->distance, lanes_select(hit, distance, zero));
    lanes_store(outcome->normal[0],
                lanes_select(hit, lanes_times(now->separation.x, inverse), zero));
    lanes_store(outcome->normal[1],
                lanes_select(hit, lanes_times(now->separation.y, inverse), zero));
    lanes_store(outcome->normal[2],
                lanes_select(hit, lanes_times(now->separation.z, inverse), zero));
    for (int k = 0; k < 4; k++) {
        lanes_store(outcome->weights[k], lanes_select(hit, now->weights[k], zero));
    }
}

static inline void advance(const collision_ccd_options *options, bool edges, bool first,
                           collision_ccd_lanes *four, collision_ccd_outcome *outcome)
{
    relative_lanes m;
    load_relative(four->start, four->end, four->stride, &m);
    lanes zero = lanes_splat(0.0), one = lanes_splat(1.0), t = lanes_load(four->time);
    lanes thickness = lanes_load(four->thickness);
    bounds_lanes bounds = bounds_of(options->tolerance, thickness, m.size);
    lanes_mask none = lanes_less(zero, zero), hit = none, fallback = none,
               pending = lanes_not(none);
    lanes_mask exact = lanes_not(lanes_less(zero, thickness)), filtered = none;
    if (first && lanes_movemask(exact) != 0) {
        filtered = lanes_and(exact, never_coplanar(&m));
        pending = lanes_not(filtered);
    }
    closest_points_lanes now;
    unsigned pending_bits = lanes_movemask(pending), rounds = 0;
    do {
        closest_at_time(&m, edges, first, t, &now);
        vlanes n = now.separation;
        projection_lanes g = {v_dot(n, m.start[0]), v_dot(n, m.end[0]),   v_dot(n, m.start[1]),
                              v_dot(n, m.end[1]),   v_dot(n, m.start[2]), v_dot(n, m.end[2])};
        for (int i = 0; i < LANES; i++) {
            four->passes[i] = (first ? 0 : four->passes[i]) + (pending_bits >> i & 1u);
        }
        lanes_mask far = lanes_less(bounds.near_square, now.distance_squared);
        hit = lanes_or(hit, lanes_and(pending, lanes_not(far)));
        pending = lanes_and(pending, far);
        pending = lanes_and(pending, lanes_not(separates_throughout(&g, edges, bounds.clearance,
                                                                    now.distance_squared)));
        pending_bits = lanes_movemask(pending);
        if (pending_bits != 0) {
            lanes clearance = lanes_times(bounds.clearance, lanes_sqrt(now.distance_squared));
            lanes until = separates_until(&g, edges, t, clearance);
            lanes_mask onward = lanes_less(t, until), to_end = lanes_less(one, until);
            fallback = lanes_or(fallback, lanes_and(pending, lanes_not(onward)));
            pending = lanes_and(lanes_and(pending, onward), lanes_not(to_end));
            pending_bits = lanes_movemask(pending);
            /* A finished lane keeps its time, so the closest points of a hit are those of its last
             * pass. */
            t = lanes_select(pending, until, t);
        }
    } while (!first && (pending_bits & (pending_bits - 1)) != 0 &&
             ++rounds < COLLISION_LANE_ROUNDS);
    lanes distance = lanes_sqrt(now.distance_squared);
    /* Vectors within rounding error, and zero thickness, are left to the scalar code. */
    lanes_mask rounding = lanes_or(lanes_less(now.distance_squared, bounds.rounding_square),
                                   lanes_less(now.distance_squared, lanes_splat(1e-300)));
    lanes_mask difficult = lanes_and(hit, lanes_or(rounding, exact));
    hit = lanes_and(hit, lanes_not(difficult));
    outcome->fallback = lanes_movemask(lanes_or(fallback, difficult));
    outcome->hit = lanes_movemask(hit);
    outcome->pending = pending_bits;
    outcome->filtered = lanes_movemask(filtered);
    lanes_store(four->time, t);
    store_hits(&now, t, distance, hit, outcome);
}

void VBSS_WIDE_NAME(vbss_collision_advance_lanes)(const collision_ccd_options *options,
                                                  vbss_collision_pair_kind kind, bool first,
                                                  collision_ccd_lanes *four,
                                                  collision_ccd_outcome *outcome)
{
    if (kind == VBSS_COLLISION_PAIR_EDGE_EDGE) {
        if (first) {
            advance(options, true, true, four, outcome);
        } else {
            advance(options, true, false, four, outcome);
        }
    } else if (first) {
        advance(options, false, true, four, outcome);
    } else {
        advance(options, false, false, four, outcome);
    }
}
