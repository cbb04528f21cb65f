/* Closest points of two features, in coordinates relative to the first vertex. The functions are
 * inline because every test starts with them.
 *
 * The returned vector always joins two points of the features, up to rounding. Its length is
 * therefore never below their distance, however inaccurate the weights are. */
#ifndef VBSS_COLLISION_CLOSEST_H
#define VBSS_COLLISION_CLOSEST_H

#include "base/compiler.h"
#include "base/linear.h"
#include "collision/tuning.h"

/* x clamped to [0, 1]; 0 for NaN. */
static inline double clamp_unit(double x)
{
    double positive = x > 0.0 ? x : 0.0;
    return positive < 1.0 ? positive : 1.0;
}

/* Position along e, as a fraction from its start, that is closest to the point `to` relative to
 * that start; 0 for an edge of zero length. */
static inline double closest_on_edge(vec3 e, vec3 to)
{
    double ee = vec3_norm_squared(e);
    return ee > 0.0 ? clamp_unit(vec3_dot(e, to) / ee) : 0.0;
}

/* Vector from the point s of edge a to the point u of edge b; r leads from the start of a to that
 * of b. */
static inline vec3 edge_separation(vec3 a, vec3 b, vec3 r, double s, double u)
{
    return vec3_sub(vec3_add_scaled(r, u, b), vec3_scale(a, s));
}

/* Dot products of two edges a and b and the vector r between their starts. */
typedef struct edge_products {
    double aa, bb, ab, ar, br;
} edge_products;

VBSS_ALWAYS_INLINE edge_products products_of_edges(vec3 a, vec3 b, vec3 r)
{
    edge_products p = {vec3_norm_squared(a), vec3_norm_squared(b), vec3_dot(a, b), vec3_dot(a, r),
                       vec3_dot(b, r)};
    return p;
}

/* Starts with the closest point s of the lines, then computes u, and s again if u is clamped. The
 * divisions are independent of each other. */
VBSS_ALWAYS_INLINE void closest_from(edge_products p, double line_s, double *s, double *u)
{
    double inverse_aa = 1.0 / p.aa, inverse_bb = 1.0 / p.bb;
    *s = clamp_unit(line_s);
    double along = (*s * p.ab - p.br) * inverse_bb;
    *u = clamp_unit(along);
    if (along < 0.0 || along > 1.0) {
        *s = clamp_unit((*u * p.ab + p.ar) * inverse_aa);
    }
}

/* Parallel edges: the best of the closest points of the lines, by cross products, and of the four
 * ends with the closest point of the other edge. */
static inline vec3 closest_parallel_edges(vec3 a, vec3 b, vec3 r, double *s, double *u)
{
    vec3 n = vec3_cross(a, b);
    double nn = vec3_norm_squared(n);
    *s = *u = 0.0;
    if (nn > 0.0) { /* so neither edge has zero length */
        closest_from(products_of_edges(a, b, r), vec3_dot(vec3_cross(r, b), n) / nn, s, u);
    }
    vec3 best = edge_separation(a, b, r, *s, *u);
    double min_squared = vec3_norm_squared(best);
    for (int end = 0; end < 4; end++) {
        double at = (double)(end & 1), s_end = at, u_end = at;
        if (end < 2) {
            u_end = closest_on_edge(b, vec3_sub(vec3_scale(a, at), r));
        } else {
            s_end = closest_on_edge(a, vec3_add_scaled(r, at, b));
        }
        vec3 separation = edge_separation(a, b, r, s_end, u_end);
        double square = vec3_norm_squared(separation);
        if (square < min_squared) {
            min_squared = square;
            best = separation;
            *s = s_end;
            *u = u_end;
        }
    }
    return best;
}

/* Closest points of edge a, which starts at the origin, and edge b, which starts at r. s and u are
 * fractions along the edges. Returns the vector from a to b. */
VBSS_ALWAYS_INLINE vec3 closest_between_edges(vec3 a, vec3 b, vec3 r, double *s, double *u)
{
    edge_products p = products_of_edges(a, b, r);
    double determinant = p.aa * p.bb - p.ab * p.ab;
    if (!(determinant > CLOSEST_PARALLEL * p.aa * p.bb)) { /* also if an edge has zero length */
        double s_best, u_best; /* local copies, so that s and u stay in registers */
        vec3 separation = closest_parallel_edges(a, b, r, &s_best, &u_best);
        *s = s_best;
        *u = u_best;
        return separation;
    }
    closest_from(p, (p.ar * p.bb - p.ab * p.br) / determinant, s, u);
    return edge_separation(a, b, r, *s, *u);
}

/* Closest point of a triangle to a point. The corners f are relative to that point; the result is
 * the vector to the closest point, and the weights of the corners. Candidates are the foot on the
 * plane if it lies inside, and the closest point of each edge. A triangle without area has no
 * foot. */
static inline vec3 closest_on_triangle(const vec3 f[3], double weights[3])
{
    vec3 best = f[0];
    double min_squared = vec3_norm_squared(f[0]);
    weights[0] = 1.0;
    weights[1] = weights[2] = 0.0;
    for (int k = 0; k < 3; k++) {
        vec3 from = f[k], e = vec3_sub(f[(k + 1) % 3], from);
        double s = closest_on_edge(e, vec3_neg(from));
        vec3 to = vec3_add_scaled(from, s, e);
        double square = vec3_norm_squared(to);
        if (square < min_squared) {
            min_squared = square;
            best = to;
            weights[k] = 1.0 - s;
            weights[(k + 1) % 3] = s;
            weights[(k + 2) % 3] = 0.0;
        }
    }
    vec3 e1 = vec3_sub(f[1], f[0]), e2 = vec3_sub(f[2], f[0]), n = vec3_cross(e1, e2);
    double nn = vec3_norm_squared(n);
    double w2 = vec3_dot(vec3_cross(f[0], e1), n), w1 = vec3_dot(vec3_cross(e2, f[0]), n);
    if (nn > 0.0 && w1 > 0.0 && w2 > 0.0 && w1 + w2 < nn) {
        double v = w1 / nn, w = w2 / nn;
        vec3 to = vec3_add_scaled(vec3_add_scaled(f[0], v, e1), w, e2);
        if (vec3_norm_squared(to) < min_squared) {
            best = to;
            weights[0] = 1.0 - v - w;
            weights[1] = v;
            weights[2] = w;
        }
    }
    return best;
}

#endif
