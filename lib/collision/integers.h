/* Integers of any size, and polynomials with such coefficients, in memory of the caller.
 *
 * For the exact predicate (ccd_exact.c). When the memory is exhausted, `full` is set and all
 * further results are zero. The caller must check it before using any result. */
#ifndef VBSS_COLLISION_INTEGERS_H
#define VBSS_COLLISION_INTEGERS_H

#include <stdbool.h>
#include <stdint.h>

typedef struct workspace {
    uint32_t *limbs;
    uint32_t capacity, used;
    bool full;
} workspace;

/* sign is -1, 0 or 1. The magnitude consists of `count` limbs of 32 bits from `first` on, least
 * significant first; the last one is not zero. Limbs never change once they are written, so copies
 * share them. The struct is small because many of them are on the stack. */
typedef struct integer {
    uint16_t first, count;
    int32_t sign;
} integer;
enum { COLLISION_WORKSPACE_LIMBS = 65535 }; /* the most that `first` tells apart */

static inline integer integer_zero(void)
{
    integer zero = {0, 0, 0};
    return zero;
}
static inline integer integer_negated(integer a)
{
    a.sign = -a.sign;
    return a;
}
/* magnitude * 2^shift with the given sign */
integer vbss_integer_make(workspace *w, uint64_t magnitude, uint32_t shift, int32_t sign);
integer vbss_integer_add(workspace *w, integer a, integer b);
integer vbss_integer_subtract(workspace *w, integer a, integer b);
integer vbss_integer_multiply(workspace *w, integer a, integer b);
integer vbss_integer_shift(workspace *w, integer a, uint32_t bits); /* shifted left */
/* Frees everything allocated since `mark`, a value of w->used, except the given integers, which
 * move down to it. They may share limbs. */
void vbss_integers_compact(workspace *w, uint32_t mark, integer *const *live, int count);
static inline integer vbss_integer_compact(workspace *w, uint32_t mark, integer a)
{
    integer *one = &a;
    vbss_integers_compact(w, mark, &one, 1);
    return a;
}

/* sum of c[k] t^k. Degree -1 is the zero polynomial; otherwise c[degree] is not zero. */
enum { COLLISION_POLYNOMIAL_DEGREE = 3 };
typedef struct polynomial {
    int32_t degree;
    integer c[COLLISION_POLYNOMIAL_DEGREE + 1];
} polynomial;

/* A point of the t axis: numerator / 2^bits, numerator >= 0. */
typedef struct dyadic {
    integer numerator;
    uint32_t bits;
} dyadic;

polynomial vbss_polynomial_multiply(workspace *w, const polynomial *a, const polynomial *b);
polynomial vbss_polynomial_subtract(workspace *w, const polynomial *a, const polynomial *b);
polynomial vbss_polynomial_add(workspace *w, const polynomial *a, const polynomial *b);
/* Frees everything allocated since `mark` except the coefficients of p. */
polynomial vbss_polynomial_compact(workspace *w, uint32_t mark, polynomial p);
/* Sign of p(t): -1, 0 or 1. */
int32_t vbss_polynomial_sign_at(workspace *w, const polynomial *p, dyadic t);
/* Sets the degree once the coefficients up to `degree` are written. */
void vbss_polynomial_trim(polynomial *p, int32_t degree);

/* Sturm sequence: p, p', and the signed remainders down to the greatest common divisor of both. */
typedef struct sturm {
    int32_t count;
    polynomial p[4]; /* enough for a polynomial of degree 3 */
} sturm;
sturm vbss_sturm_make(workspace *w, const polynomial *p);
/* Sign changes along the sequence at t. Between two points that are not roots they decrease by the
 * number of distinct roots between them. */
int32_t vbss_sturm_changes(workspace *w, const sturm *s, dyadic t);

/* A distinct root of a polynomial, isolated between two points that are not roots. */
typedef struct root {
    dyadic low, high;
    int32_t changes_low, changes_high; /* sign changes of the Sturm sequence at both points */
} root;
/* Distinct roots strictly between 0 and 1 of a polynomial that is not zero, ascending; at most 3.
 * `s` receives the Sturm sequence of the polynomial divided by its roots at 0 and 1. */
int32_t vbss_roots_between(workspace *w, const polynomial *p, sturm *s, root roots[3]);
/* Sign of q, of degree 2 at most, at a root of s. Narrows the interval of the root. */
int32_t vbss_sign_at_root(workspace *w, const polynomial *q, const sturm *s, root *r);

#endif
