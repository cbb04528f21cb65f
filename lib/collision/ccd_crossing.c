/* Certifies in double precision that two interiors cross near a time, with bounds on rounding.
 *
 * This avoids the exact predicate for most true crossings at zero thickness. The volume of the four
 * vertices has opposite signs before and after, and in between the crossing point stays inside both
 * features. */
#include "collision/ccd_crossing.h"
#include "collision/tuning.h"

/* Rounding of cross products and volumes, for vectors that are differences of relative vertices with
 * coordinates up to `size`: 460 u size^2, of differences too, and 600 u size^3; see
 * docs/explanation/collision-proof.md. */
#define AREA_ROUNDING (128.0 * DBL_EPSILON)
#define VOLUME_SPAN_ROUNDING (1024.0 * DBL_EPSILON)

/* Edges: s a = c + u b. Triangle: c = s a + u b, where a and b are edges from corner 0. */
typedef struct vectors {
    vec3 a, b, c;
} vectors;

static vectors vectors_at(const collision_relative_motion *m, bool edges, double t)
{
    vec3 p = relative_at(m, 0, t), q = relative_at(m, 1, t), r = relative_at(m, 2, t);
    vectors v;
    if (edges) {
        v.a = p;
        v.b = vec3_sub(r, q);
        v.c = q;
    } else {
        v.a = vec3_sub(q, p);
        v.b = vec3_sub(r, p);
        v.c = vec3_neg(p);
    }
    return v;
}

static double component(vec3 v, int k)
{
    return k == 0 ? v.x : k == 1 ? v.y : v.z;
}

/* Component k of the cross product of x at one time and y at another. */
static double across(vec3 x, vec3 y, int k)
{
    int i = (k + 1) % 3, j = (k + 2) % 3;
    return component(x, i) * component(y, j) - component(x, j) * component(y, i);
}

/* The three Bernstein coefficients, between two times, of component k of the cross product of two
 * vectors linear in time. */
typedef struct bernstein {
    double c[3];
} bernstein;

static bernstein product(vec3 x_low, vec3 x_high, vec3 y_low, vec3 y_high, int k)
{
    bernstein p = {{across(x_low, y_low, k),
                    0.5 * (across(x_low, y_high, k) + across(x_high, y_low, k)),
                    across(x_high, y_high, k)}};
    return p;
}

static bernstein difference(bernstein a, bernstein b)
{
    bernstein p = {{a.c[0] - b.c[0], a.c[1] - b.c[1], a.c[2] - b.c[2]}};
    return p;
}

static bool above(bernstein p, double sign, double bound)
{
    return sign * p.c[0] > bound && sign * p.c[1] > bound && sign * p.c[2] > bound;
}

static int largest_component(vec3 v)
{
    double x = fabs(v.x), y = fabs(v.y), z = fabs(v.z);
    return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

bool vbss_collision_certifies_crossing(const collision_relative_motion *m, bool edges, double t)
{
    double low = t - COLLISION_CROSSING_SPAN < 0.0 ? 0.0 : t - COLLISION_CROSSING_SPAN,
           high = t + COLLISION_CROSSING_SPAN > 1.0 ? 1.0 : t + COLLISION_CROSSING_SPAN;
    vectors l = vectors_at(m, edges, low), h = vectors_at(m, edges, high);
    vec3 n_low = vec3_cross(l.a, l.b), n_high = vec3_cross(h.a, h.b);
    double before = vec3_dot(l.c, n_low), after = vec3_dot(h.c, n_high), size = m->size;
    double bound = VOLUME_SPAN_ROUNDING * size * size * size;
    if (!(bound > 1e-290 && fabs(before) > bound && fabs(after) > bound) ||
        (before > 0.0) == (after > 0.0)) {
        return false;
    }
    int k = largest_component(n_low);
    double sign = component(n_low, k) < 0.0 ? -1.0 : 1.0;
    /* Differences of two or three products: at most 4 times the rounding error of one. */
    double area = 4.0 * AREA_ROUNDING * size * size;
    bernstein n = product(l.a, h.a, l.b, h.b, k), first = product(l.c, h.c, l.b, h.b, k), second;
    if (edges) {
        second = product(l.c, h.c, l.a, h.a, k);
        return above(first, sign, area) && above(difference(n, first), sign, area) &&
               above(second, sign, area) && above(difference(n, second), sign, area);
    }
    second = product(l.a, h.a, l.c, h.c, k);
    return above(first, sign, area) && above(second, sign, area) &&
           above(difference(difference(n, first), second), sign, area);
}
