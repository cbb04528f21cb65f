/* Polynomials with integer coefficients: roots, and signs at roots. */
#include "collision/integers.h"

void vbss_polynomial_trim(polynomial *p, int32_t degree)
{
    while (degree >= 0 && p->c[degree].sign == 0) {
        degree--;
    }
    p->degree = degree;
}

polynomial vbss_polynomial_compact(workspace *w, uint32_t mark, polynomial p)
{
    integer *all[COLLISION_POLYNOMIAL_DEGREE + 1];
    for (int32_t k = 0; k <= p.degree; k++) {
        all[k] = &p.c[k];
    }
    vbss_integers_compact(w, mark, all, p.degree + 1);
    return p;
}

polynomial vbss_polynomial_multiply(workspace *w, const polynomial *a, const polynomial *b)
{
    polynomial p = {.degree = -1};
    if (a->degree < 0 || b->degree < 0) {
        return p;
    }
    for (int32_t k = 0; k <= a->degree + b->degree; k++) {
        uint32_t mark = w->used;
        integer sum = integer_zero();
        int32_t first = k > b->degree ? k - b->degree : 0;
        for (int32_t i = first; i <= a->degree && i <= k; i++) {
            integer product = vbss_integer_multiply(w, a->c[i], b->c[k - i]);
            sum = vbss_integer_add(w, sum, product);
        }
        p.c[k] = vbss_integer_compact(w, mark, sum);
    }
    vbss_polynomial_trim(&p, a->degree + b->degree);
    return p;
}

polynomial vbss_polynomial_add(workspace *w, const polynomial *a, const polynomial *b)
{
    polynomial p = {.degree = -1};
    int32_t degree = a->degree > b->degree ? a->degree : b->degree;
    for (int32_t k = 0; k <= degree; k++) {
        integer from_a = k <= a->degree ? a->c[k] : integer_zero();
        integer from_b = k <= b->degree ? b->c[k] : integer_zero();
        p.c[k] = vbss_integer_add(w, from_a, from_b);
    }
    vbss_polynomial_trim(&p, degree);
    return p;
}

static polynomial negated(polynomial p)
{
    for (int32_t k = 0; k <= p.degree; k++) {
        p.c[k] = integer_negated(p.c[k]);
    }
    return p;
}

polynomial vbss_polynomial_subtract(workspace *w, const polynomial *a, const polynomial *b)
{
    polynomial minus = negated(*b);
    return vbss_polynomial_add(w, a, &minus);
}

/* Horner's method with separate powers of two: sum of c[k] n^k 2^(bits (degree - k)). */
int32_t vbss_polynomial_sign_at(workspace *w, const polynomial *p, dyadic t)
{
    if (p->degree < 0) {
        return 0;
    }
    uint32_t mark = w->used, shift = 0;
    integer sum = p->c[p->degree];
    for (int32_t k = p->degree - 1; k >= 0; k--) {
        shift += t.bits;
        integer product = vbss_integer_multiply(w, sum, t.numerator);
        sum = vbss_integer_add(w, product, vbss_integer_shift(w, p->c[k], shift));
        sum = vbss_integer_compact(w, mark, sum);
    }
    w->used = mark;
    return sum.sign;
}

/* A positive multiple of the remainder of a divided by b; b must not be zero. */
static polynomial remainder_of(workspace *w, const polynomial *a, const polynomial *b)
{
    polynomial r = *a;
    integer factor_of_r = b->c[b->degree];
    int32_t lead_sign = factor_of_r.sign;
    factor_of_r.sign = 1;
    while (r.degree >= b->degree) {
        int32_t shift = r.degree - b->degree;
        integer factor_of_b = r.c[r.degree];
        factor_of_b.sign *= lead_sign;
        /* |lead of b| r - (+-) (lead of r) t^shift b cancels the leading terms. */
        for (int32_t k = 0; k < r.degree; k++) {
            uint32_t mark = w->used;
            integer c = vbss_integer_multiply(w, factor_of_r, r.c[k]);
            if (k >= shift) {
                integer product = vbss_integer_multiply(w, factor_of_b, b->c[k - shift]);
                c = vbss_integer_subtract(w, c, product);
            }
            r.c[k] = vbss_integer_compact(w, mark, c);
        }
        vbss_polynomial_trim(&r, r.degree - 1);
    }
    return r;
}

static polynomial derivative(workspace *w, const polynomial *p)
{
    polynomial d = {.degree = p->degree - 1};
    for (int32_t k = 1; k <= p->degree; k++) {
        integer factor = vbss_integer_make(w, (uint64_t)k, 0, 1);
        d.c[k - 1] = vbss_integer_multiply(w, factor, p->c[k]);
    }
    return d;
}

sturm vbss_sturm_make(workspace *w, const polynomial *p)
{
    sturm s = {.count = 1};
    s.p[0] = *p;
    polynomial next = p->degree > 0 ? derivative(w, p) : (polynomial){.degree = -1};
    while (next.degree >= 0 && s.count < 4) {
        s.p[s.count++] = next;
        next = negated(remainder_of(w, &s.p[s.count - 2], &next));
    }
    return s;
}

int32_t vbss_sturm_changes(workspace *w, const sturm *s, dyadic t)
{
    int32_t changes = 0, last = 0;
    for (int32_t k = 0; k < s->count; k++) {
        int32_t sign = vbss_polynomial_sign_at(w, &s->p[k], t);
        changes += sign * last < 0;
        last = sign != 0 ? sign : last;
    }
    return changes;
}

/* ---- roots */

/* (8 - eighths) / 8 low + eighths / 8 high. */
static dyadic interpolate(workspace *w, dyadic low, dyadic high, uint32_t eighths)
{
    uint32_t mark = w->used, bits = low.bits > high.bits ? low.bits : high.bits;
    uint32_t finer = eighths == 4 ? 1 : 3;
    uint32_t weight_high = eighths == 4 ? 1 : eighths, whole = 1u << finer;
    integer a = vbss_integer_shift(w, low.numerator, bits - low.bits);
    integer b = vbss_integer_shift(w, high.numerator, bits - high.bits);
    integer from_a = vbss_integer_make(w, whole - weight_high, 0, 1);
    integer from_b = vbss_integer_make(w, weight_high, 0, 1);
    from_a = vbss_integer_multiply(w, a, from_a);
    from_b = vbss_integer_multiply(w, b, from_b);
    dyadic t = {vbss_integer_compact(w, mark, vbss_integer_add(w, from_a, from_b)), bits + finer};
    return t;
}

/* A point between two others that is not a root of p. There are more candidates than p has
 * roots. */
static dyadic split(workspace *w, const polynomial *p, dyadic low, dyadic high)
{
    static const uint32_t eighths[] = {4, 3, 5, 2};
    dyadic t = low;
    for (int k = 0; k < 4; k++) {
        uint32_t mark = w->used;
        t = interpolate(w, low, high, eighths[k]);
        if (vbss_polynomial_sign_at(w, p, t) != 0 || w->full) {
            break;
        }
        w->used = mark;
    }
    return t;
}

/* Removes all factors t. */
static void divide_by_t(polynomial *p)
{
    while (p->degree > 0 && p->c[0].sign == 0) {
        for (int32_t k = 0; k < p->degree; k++) {
            p->c[k] = p->c[k + 1];
        }
        p->degree--;
    }
}

/* Removes all factors t - 1. */
static void divide_by_t_minus_one(workspace *w, polynomial *p)
{
    while (p->degree > 0) {
        polynomial quotient = {.degree = p->degree - 1};
        integer carry = integer_zero();
        for (int32_t k = p->degree; k > 0; k--) {
            carry = vbss_integer_add(w, carry, p->c[k]);
            quotient.c[k - 1] = carry;
        }
        if (vbss_integer_add(w, carry, p->c[0]).sign != 0 || w->full) {
            return;
        }
        *p = quotient;
    }
}

/* Whether all Bernstein coefficients have one sign, which proves that there is no root between 0
 * and 1. */
static bool has_one_sign(workspace *w, const polynomial *p)
{
    static const uint64_t binomial[4][4] = {{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}};
    int32_t d = p->degree, sign = p->c[0].sign;
    uint32_t mark = w->used;
    bool same = true;
    /* coefficient j times binomial(d, j): sum over k of c[k] binomial(d - k, j - k) */
    for (int32_t j = 1; j <= d && same; j++) {
        integer sum = integer_zero();
        for (int32_t k = 0; k <= j; k++) {
            integer times = vbss_integer_make(w, binomial[d - k][j - k], 0, 1);
            sum = vbss_integer_add(w, sum, vbss_integer_multiply(w, times, p->c[k]));
        }
        same = sum.sign == sign;
    }
    w->used = mark;
    return same;
}

/* Frees the limbs of all points except these. */
static void compact_bounds(workspace *w, uint32_t mark, root *a, int32_t count_a, root *b,
                           int32_t count_b)
{
    integer *bounds[2 * (3 + 4)];
    int count = 0;
    for (int32_t k = 0; k < count_a + count_b; k++) {
        root *r = k < count_a ? &a[k] : &b[k - count_a];
        bounds[count++] = &r->low.numerator;
        bounds[count++] = &r->high.numerator;
    }
    vbss_integers_compact(w, mark, bounds, count);
}

int32_t vbss_roots_between(workspace *w, const polynomial *p, sturm *s, root roots[3])
{
    polynomial inner = *p;
    divide_by_t(&inner);
    divide_by_t_minus_one(w, &inner);
    if (inner.degree < 1 || has_one_sign(w, &inner)) {
        return 0;
    }
    *s = vbss_sturm_make(w, &inner);
    uint32_t mark = w->used;
    root intervals[4]; /* intervals still to be examined, the leftmost on top */
    int32_t count = 0, pending = 1;
    intervals[0].low = (dyadic){integer_zero(), 0};
    intervals[0].high = (dyadic){vbss_integer_make(w, 1, 0, 1), 0};
    intervals[0].changes_low = vbss_sturm_changes(w, s, intervals[0].low);
    intervals[0].changes_high = vbss_sturm_changes(w, s, intervals[0].high);
    while (pending > 0 && !w->full) {
        root whole = intervals[--pending];
        int32_t root_count = whole.changes_low - whole.changes_high;
        if (root_count == 1) {
            roots[count++] = whole;
        } else if (root_count > 1) {
            root left = whole, right = whole;
            left.high = right.low = split(w, &inner, whole.low, whole.high);
            left.changes_high = right.changes_low = vbss_sturm_changes(w, s, left.high);
            /* Each pending interval contains a root, so there are never more than three. */
            if (right.changes_low - right.changes_high > 0) {
                intervals[pending++] = right;
            }
            if (left.changes_low - left.changes_high > 0) {
                intervals[pending++] = left;
            }
            compact_bounds(w, mark, intervals, pending, roots, count);
        }
    }
    return count;
}

/* Number of roots between two points; neither may be a root itself. */
static int32_t roots_in(workspace *w, const sturm *s, dyadic low, dyadic high)
{
    return vbss_sturm_changes(w, s, low) - vbss_sturm_changes(w, s, high);
}

/* Whether q vanishes at the root r of p, that is whether their greatest common divisor has a root
 * there. */
static bool vanishes(workspace *w, const polynomial *q, const polynomial *p, const root *r)
{
    uint32_t mark = w->used;
    bool common = false;
    polynomial a = *p, b = *q;
    while (b.degree > 0) {
        polynomial c = remainder_of(w, &a, &b);
        a = b;
        b = c;
    }
    if (b.degree < 0) { /* a divides p, so neither end is a root of it */
        sturm s = vbss_sturm_make(w, &a);
        common = roots_in(w, &s, r->low, r->high) > 0;
    }
    w->used = mark;
    return common;
}

/* Replaces the interval of the root by the half that contains it. */
static void narrow(workspace *w, const sturm *s, root *r)
{
    dyadic middle = split(w, &s->p[0], r->low, r->high);
    int32_t changes = vbss_sturm_changes(w, s, middle);
    if (r->changes_low - changes > 0) {
        r->high = middle;
        r->changes_high = changes;
    } else {
        r->low = middle;
        r->changes_low = changes;
    }
}

int32_t vbss_sign_at_root(workspace *w, const polynomial *q, const sturm *s, root *r)
{
    if (q->degree < 1) {
        return q->degree < 0 ? 0 : q->c[0].sign;
    }
    uint32_t mark = w->used;
    sturm of_q = vbss_sturm_make(w, q);
    uint32_t after = w->used;
    integer *ends[] = {&r->low.numerator, &r->high.numerator};
    int32_t sign = 0;
    bool found = false, is_checked = false;
    while (!found && !w->full) {
        int32_t low = vbss_polynomial_sign_at(w, q, r->low);
        int32_t high = vbss_polynomial_sign_at(w, q, r->high);
        if (low != 0 && low == high && roots_in(w, &of_q, r->low, r->high) == 0) {
            sign = low;
            found = true;
        } else if (!is_checked) {
            is_checked = true;
            found = vanishes(w, q, &s->p[0], r);
        } else { /* q has a different root close by: narrow the interval until it is excluded */
            narrow(w, s, r);
            vbss_integers_compact(w, after, ends, 2);
        }
    }
    vbss_integers_compact(w, mark, ends, 2);
    return sign;
}
