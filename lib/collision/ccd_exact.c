/* Exact predicate: whether two features of zero thickness meet, by integer arithmetic without
 * error.
 *
 * Two kinds of events suffice (proof in docs/explanation/collision-proof.md). A crossing: the volume of the four
 * vertices vanishes while the interiors cross. A touching: a vertex meets an edge. A contact on the
 * border of an interior, within one plane, or with vanishing length or area is a touching, or
 * exists at time 0. */
#include "collision/ccd_exact.h"

#include "base/double_double.h"
#include "collision/conservative_advancement.h"

_Static_assert((int)COLLISION_LIMBS <= (int)COLLISION_WORKSPACE_LIMBS,
               "integers find all their limbs");

typedef struct ivec {
    polynomial x, y, z;
} ivec;

/* ---- conversion of doubles to integers, all multiplied by the same power of two */

static int exponent_of(double x)
{
    int exponent = (int)((bits_of(x) >> 52) & 0x7ff);
    return exponent == 0 ? 1 : exponent;
}

static uint64_t mantissa_of(double x)
{
    uint64_t bits = bits_of(x), fraction = bits & UINT64_C(0xfffffffffffff);
    return ((bits >> 52) & 0x7ff) == 0 ? fraction : fraction | UINT64_C(0x10000000000000);
}

static int trailing_zeros(uint64_t x)
{
    int count = 0;
    while ((x & 1u) == 0) {
        x >>= 1;
        count++;
    }
    return count;
}

/* Exponent of the lowest bit that is set in any coordinate. */
static int last_exponent(const collision_ccd_query *q)
{
    int last = 3000;
    for (int k = 0; k < 8; k++) {
        vec3 v = k < 4 ? q->start[k] : q->end[k - 4];
        double at[3] = {v.x, v.y, v.z};
        for (int i = 0; i < 3; i++) {
            uint64_t mantissa = mantissa_of(at[i]);
            if (mantissa != 0) {
                int exponent = exponent_of(at[i]) + trailing_zeros(mantissa);
                last = exponent < last ? exponent : last;
            }
        }
    }
    return last;
}

static integer to_integer(workspace *w, double x, int last)
{
    uint64_t mantissa = mantissa_of(x);
    if (mantissa == 0) {
        return integer_zero();
    }
    int zeros = trailing_zeros(mantissa);
    uint32_t shift = (uint32_t)(exponent_of(x) + zeros - last);
    return vbss_integer_make(w, mantissa >> zeros, shift, x < 0.0 ? -1 : 1);
}

/* Vector component from one vertex to another, linear in time. */
static polynomial difference(workspace *w, double from0, double from1, double to0, double to1,
                             int last)
{
    polynomial p = {.degree = -1};
    uint32_t mark = w->used;
    integer a = to_integer(w, from0, last), b = to_integer(w, to0, last);
    p.c[0] = vbss_integer_compact(w, mark, vbss_integer_subtract(w, b, a));
    mark = w->used;
    a = to_integer(w, from1, last);
    b = to_integer(w, to1, last);
    integer end = vbss_integer_subtract(w, b, a);
    p.c[1] = vbss_integer_compact(w, mark, vbss_integer_subtract(w, end, p.c[0]));
    vbss_polynomial_trim(&p, 1);
    return p;
}

static ivec between(workspace *w, const collision_ccd_query *q, int from, int to, int last)
{
    vec3 a0 = q->start[from], a1 = q->end[from], b0 = q->start[to], b1 = q->end[to];
    ivec v = {difference(w, a0.x, a1.x, b0.x, b1.x, last),
              difference(w, a0.y, a1.y, b0.y, b1.y, last),
              difference(w, a0.z, a1.z, b0.z, b1.z, last)};
    return v;
}

/* ---- vectors of polynomials */

static polynomial product_difference(workspace *w, const polynomial *a, const polynomial *b,
                                     const polynomial *c, const polynomial *d)
{
    uint32_t mark = w->used;
    polynomial ab = vbss_polynomial_multiply(w, a, b), cd = vbss_polynomial_multiply(w, c, d);
    return vbss_polynomial_compact(w, mark, vbss_polynomial_subtract(w, &ab, &cd));
}

static ivec cross(workspace *w, const ivec *a, const ivec *b)
{
    ivec c = {product_difference(w, &a->y, &b->z, &a->z, &b->y),
              product_difference(w, &a->z, &b->x, &a->x, &b->z),
              product_difference(w, &a->x, &b->y, &a->y, &b->x)};
    return c;
}

static polynomial dot(workspace *w, const ivec *a, const ivec *b)
{
    uint32_t mark = w->used;
    polynomial x = vbss_polynomial_multiply(w, &a->x, &b->x);
    polynomial y = vbss_polynomial_multiply(w, &a->y, &b->y);
    polynomial z = vbss_polynomial_multiply(w, &a->z, &b->z);
    x = vbss_polynomial_add(w, &x, &y);
    return vbss_polynomial_compact(w, mark, vbss_polynomial_add(w, &x, &z));
}

static ivec minus(workspace *w, const ivec *a, const ivec *b)
{
    ivec c = {vbss_polynomial_subtract(w, &a->x, &b->x), vbss_polynomial_subtract(w, &a->y, &b->y),
              vbss_polynomial_subtract(w, &a->z, &b->z)};
    return c;
}

static const polynomial *component(const ivec *v, int k)
{
    return k == 0 ? &v->x : k == 1 ? &v->y : &v->z;
}

/* ---- instants: 0, 1, or a root between them */

typedef struct instant {
    const sturm *s; /* NULL for the dyadic time t */
    root *r;
    dyadic t;
} instant;

static int32_t sign_at(workspace *w, const polynomial *p, const instant *when)
{
    return when->s != NULL ? vbss_sign_at_root(w, p, when->s, when->r)
                           : vbss_polynomial_sign_at(w, p, when->t);
}

/* ---- touching: a point at c relative to the start of an edge b */

typedef struct touching {
    ivec b, c, across;                /* across = c x b */
    polynomial along, beyond, bb, cc; /* c.b, b.b - c.b, b.b, c.c */
} touching;

static touching make_touching(workspace *w, const ivec *b, const ivec *c)
{
    touching p = {.b = *b, .c = *c, .across = cross(w, c, b)};
    p.along = dot(w, c, b);
    p.bb = dot(w, b, b);
    p.cc = dot(w, c, c);
    p.beyond = vbss_polynomial_subtract(w, &p.bb, &p.along);
    return p;
}

static bool touches_at(workspace *w, const touching *p, const instant *when)
{
    for (int k = 0; k < 3; k++) {
        if (sign_at(w, component(&p->across, k), when) != 0) {
            return false;
        }
    }
    if (sign_at(w, &p->bb, when) == 0) { /* the edge has zero length at this instant */
        return sign_at(w, &p->cc, when) == 0;
    }
    return sign_at(w, &p->along, when) >= 0 && sign_at(w, &p->beyond, when) >= 0;
}

/* Whether a vector that is linear in time vanishes between 0 and 1. */
static bool vanishes_between(workspace *w, const ivec *v)
{
    for (int k = 0; k < 3; k++) {
        const polynomial *p = component(v, k);
        if (p->degree == 1) {
            sturm s;
            root r[3];
            if (vbss_roots_between(w, p, &s, r) == 0) {
                return false;
            }
            instant when = {.s = &s, .r = &r[0]};
            for (int i = 0; i < 3; i++) {
                if (sign_at(w, component(v, i), &when) != 0) {
                    return false;
                }
            }
            return true;
        }
        if (p->degree == 0) {
            return false;
        }
    }
    return false; /* it is zero at all times, so also at time 0 */
}

/* Whether point and edge meet at time 0, at time 1, or in between. */
static bool touches(workspace *w, const touching *p)
{
    const dyadic ends[2] = {{integer_zero(), 0}, {vbss_integer_make(w, 1, 0, 1), 0}};
    for (int k = 0; k < 2; k++) {
        instant when = {.t = ends[k]};
        if (touches_at(w, p, &when)) {
            return true;
        }
    }
    for (int k = 0; k < 3; k++) {
        const polynomial *q = component(&p->across, k);
        if (q->degree < 0) {
            continue;
        }
        sturm s;
        root r[3];
        int32_t count = vbss_roots_between(w, q, &s, r);
        for (int32_t i = 0; i < count; i++) {
            instant when = {.s = &s, .r = &r[i]};
            if (touches_at(w, p, &when)) {
                return true;
            }
        }
        return false;
    }
    /* Point and edge stay on one line. Their first contact is at an end of the edge. */
    ivec from_end = minus(w, &p->c, &p->b);
    return vanishes_between(w, &p->c) || vanishes_between(w, &from_end);
}

/* ---- crossing: a point is strictly inside if its weights and their complements have the sign of
 * the normal, component by component */

typedef struct crossing {
    bool edges;
    polynomial volume;
    ivec normal, first, second;
} crossing;

static bool inside(workspace *w, const polynomial *weight, const polynomial *whole, int32_t sign,
                   const instant *when)
{
    if (sign_at(w, weight, when) != sign) {
        return false;
    }
    polynomial left = vbss_polynomial_subtract(w, whole, weight);
    return sign_at(w, &left, when) == sign;
}

/* Whether the features cross strictly inside; `when` must be a root of the volume. */
static bool crosses_at(workspace *w, const crossing *p, const instant *when)
{
    for (int k = 0; k < 3; k++) {
        const polynomial *n = component(&p->normal, k);
        const polynomial *first = component(&p->first, k), *second = component(&p->second, k);
        int32_t sign = sign_at(w, n, when);
        if (sign == 0) {
            continue;
        }
        if (p->edges) {
            return inside(w, first, n, sign, when) && inside(w, second, n, sign, when);
        }
        polynomial sum = vbss_polynomial_add(w, first, second);
        return sign_at(w, second, when) == sign && sign_at(w, first, when) == sign &&
               inside(w, &sum, n, sign, when);
    }
    return false; /* no normal: at most a touching */
}

static bool crosses(workspace *w, const crossing *p)
{
    const dyadic ends[2] = {{integer_zero(), 0}, {vbss_integer_make(w, 1, 0, 1), 0}};
    for (int k = 0; k < 2; k++) {
        instant when = {.t = ends[k]};
        if (sign_at(w, &p->volume, &when) == 0 && crosses_at(w, p, &when)) {
            return true;
        }
    }
    sturm s;
    root r[3];
    /* Degree -1: coplanar at all times, where contact starts with a touching. */
    int32_t count = p->volume.degree < 1 ? 0 : vbss_roots_between(w, &p->volume, &s, r);
    for (int32_t i = 0; i < count; i++) {
        instant when = {.s = &s, .r = &r[i]};
        if (crosses_at(w, p, &when)) {
            return true;
        }
    }
    return false;
}

/* ---- decision */

static crossing make_crossing(workspace *w, const collision_ccd_query *q, int last)
{
    crossing p = {.edges = q->kind == VBSS_COLLISION_PAIR_EDGE_EDGE};
    if (p.edges) { /* s a = c + u b */
        ivec a = between(w, q, 0, 1, last), b = between(w, q, 2, 3, last);
        ivec c = between(w, q, 0, 2, last);
        p.normal = cross(w, &a, &b);
        p.first = cross(w, &c, &b);
        p.second = cross(w, &c, &a);
        p.volume = dot(w, &c, &p.normal);
    } else { /* c = v e + w f */
        ivec e = between(w, q, 1, 2, last), f = between(w, q, 1, 3, last);
        ivec c = between(w, q, 1, 0, last);
        p.normal = cross(w, &e, &f);
        p.first = cross(w, &c, &f);
        p.second = cross(w, &e, &c);
        p.volume = dot(w, &c, &p.normal);
    }
    return p;
}

/* Point, and start and end of the edge, of each possible touching. */
static const int touchings_of_edges[4][3] = {{0, 2, 3}, {1, 2, 3}, {2, 0, 1}, {3, 0, 1}};
static const int touchings_of_triangle[3][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}};

/* Most touchings are ruled out by a proof that point and edge stay apart. */
static bool may_touch(const collision_ccd_query *q, const int vertices[3])
{
    collision_ccd_query pair = {.kind = VBSS_COLLISION_PAIR_EDGE_EDGE};
    const int both[4] = {vertices[0], vertices[0], vertices[1], vertices[2]};
    for (int k = 0; k < 4; k++) {
        pair.start[k] = q->start[both[k]];
        pair.end[k] = q->end[both[k]];
    }
    return !vbss_collision_proves_separation(&pair);
}

exact_result vbss_collision_decide_exactly(const collision_ccd_query *q, workspace *w)
{
    int last = last_exponent(q);
    bool edges = q->kind == VBSS_COLLISION_PAIR_EDGE_EDGE, hit = false;
    for (int k = 0; k < (edges ? 4 : 3) && !hit && !w->full; k++) {
        const int *v = edges ? touchings_of_edges[k] : touchings_of_triangle[k];
        if (may_touch(q, v)) {
            w->used = 0;
            ivec b = between(w, q, v[1], v[2], last), c = between(w, q, v[1], v[0], last);
            touching touch = make_touching(w, &b, &c);
            hit = touches(w, &touch);
        }
    }
    if (!hit && !w->full) {
        w->used = 0;
        crossing across = make_crossing(w, q, last);
        hit = crosses(w, &across);
    }
    if (w->full) {
        return COLLISION_EXACT_UNKNOWN;
    }
    return hit ? COLLISION_EXACT_HIT : COLLISION_EXACT_MISS;
}
