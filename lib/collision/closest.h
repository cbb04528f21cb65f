/* Closest points, in coordinates relative to the first vertex: inline, as every test starts with them.
 *
 * Whatever the weights' accuracy, the vector returned joins two points of the features (up to
 * rounding), so its length is never below their distance. */
#ifndef VBSS_COLLISION_CLOSEST_H
#define VBSS_COLLISION_CLOSEST_H

#include "base/base.h"

/* Edges whose squared sine is below this are taken for parallel: the general formula loses digits. */
#define CLOSEST_PARALLEL 1e-6

/* NaN becomes 0. */
static inline double clamp_unit(double x)
{
    double least = x > 0.0 ? x : 0.0;
    return least < 1.0 ? least : 1.0;
}

/* Share of the way along e, from its begin, at which it is closest to a point `to` away from there;
 * 0 for an edge without length. */
static inline double closest_on_edge(vec3 e, vec3 to)
{
    double ee = vec3_norm_squared(e);
    return ee > 0.0 ? clamp_unit(vec3_dot(e, to) / ee) : 0.0;
}

/* From point s of edge a to point u of edge b; r leads from the begin of a to that of b. */
static inline vec3 edges_apart(vec3 a, vec3 b, vec3 r, double s, double u)
{
    return vec3_sub(vec3_add_scaled(r, u, b), vec3_scale(a, s));
}

/* The best of what is given and of the four ends, each with its closest point on the other edge. */
static inline vec3 closest_parallel_edges(vec3 a, vec3 b, vec3 r, double *s, double *u)
{
    vec3 best = edges_apart(a, b, r, *s, *u);
    double least = vec3_norm_squared(best);
    for (int end = 0; end < 4; end++) {
        double at = (double)(end & 1), s_end, u_end;
        if (end < 2) {
            s_end = at;
            u_end = closest_on_edge(b, vec3_sub(vec3_scale(a, at), r));
        } else {
            u_end = at;
            s_end = closest_on_edge(a, vec3_add_scaled(r, at, b));
        }
        vec3 apart = edges_apart(a, b, r, s_end, u_end);
        double square = vec3_norm_squared(apart);
        if (square < least) {
            least = square;
            best = apart;
            *s = s_end;
            *u = u_end;
        }
    }
    return best;
}

/* Closest points of edge a, which begins at the origin, and edge b, which begins at r: shares s and u of
 * the way along them. Returns the vector from a to b. */
static inline vec3 closest_edges(vec3 a, vec3 b, vec3 r, double *s, double *u)
{
    double aa = vec3_norm_squared(a), bb = vec3_norm_squared(b), ab = vec3_dot(a, b);
    double ar = vec3_dot(a, r), br = vec3_dot(b, r);
    double determinant = aa * bb - ab * ab;
    *s = *u = 0.0;
    if (determinant > 0.0) { /* so neither is a point */
        /* Without branches, and with divisions that do not wait for each other. */
        double inverse_aa = 1.0 / aa, inverse_bb = 1.0 / bb;
        double first = clamp_unit((ar * bb - ab * br) / determinant);
        *u = clamp_unit((first * ab - br) * inverse_bb);
        *s = clamp_unit((*u * ab + ar) * inverse_aa);
    }
    if (!(determinant > CLOSEST_PARALLEL * aa * bb)) {
        return closest_parallel_edges(a, b, r, s, u);
    }
    return edges_apart(a, b, r, *s, *u);
}

/* Closest point of a triangle, whose corners f are relative to a point, to that point: the corners'
 * weights. Returns the vector to it. Candidates are the foot on the plane, if it lies inside, and the
 * closest point of each edge; a triangle without area has no foot. */
static inline vec3 closest_corners(const vec3 f[3], double weights[3])
{
    vec3 best = f[0];
    double least = vec3_norm_squared(f[0]);
    weights[0] = 1.0;
    weights[1] = weights[2] = 0.0;
    for (int k = 0; k < 3; k++) {
        vec3 from = f[k], e = vec3_sub(f[(k + 1) % 3], from);
        double s = closest_on_edge(e, vec3_neg(from));
        vec3 to = vec3_add_scaled(from, s, e);
        double square = vec3_norm_squared(to);
        if (square < least) {
            least = square;
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
        if (vec3_norm_squared(to) < least) {
            best = to;
            weights[0] = 1.0 - v - w;
            weights[1] = v;
            weights[2] = w;
        }
    }
    return best;
}

#endif
