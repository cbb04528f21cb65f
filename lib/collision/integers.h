/* Integers of any size and polynomials of them, in memory that the caller gives.
 *
 * For the exact decision (ccd_exact.c). When the memory is used up, `full` is set and results are zero from
 * then on: look at it before believing anything. */
#ifndef VBSS_COLLISION_INTEGERS_H
#define VBSS_COLLISION_INTEGERS_H

#include <stdbool.h>
#include <stdint.h>

typedef struct workspace {
    uint32_t *limbs;
    uint32_t capacity, used;
    bool full;
} workspace;

/* sign is -1, 0 or 1; the magnitude stands in `count` limbs of 32 bits from `first` on, least first, the
 * last not zero. Limbs are never changed once they are made: copies share them. Small, as many stand on
 * the stack. */
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
integer vbss_integer_shift(workspace *w, integer a, uint32_t bits); /* to the left */
/* Gives back what was taken since `mark`, a value of w->used, but for these integers, which move down to
 * it. They may share limbs. */
void vbss_integers_compact(workspace *w, uint32_t mark, integer *const *live, int count);
static inline integer vbss_integer_compact(workspace *w, uint32_t mark, integer a)
{
    integer *one = &a;
    vbss_integers_compact(w, mark, &one, 1);
    return a;
}

/* sum of c[k] t^k; degree -1 is zero, else c[degree] is not zero. */
enum { COLLISION_POLYNOMIAL_DEGREE = 3 };
typedef struct polynomial {
    int32_t degree;
    integer c[COLLISION_POLYNOMIAL_DEGREE + 1];
} polynomial;

/* A place on the axis of t: numerator / 2^bits, numerator >= 0. */
typedef struct dyadic {
    integer numerator;
    uint32_t bits;
} dyadic;

polynomial vbss_polynomial_multiply(workspace *w, const polynomial *a, const polynomial *b);
polynomial vbss_polynomial_subtract(workspace *w, const polynomial *a, const polynomial *b);
polynomial vbss_polynomial_add(workspace *w, const polynomial *a, const polynomial *b);
/* As vbss_integers_compact. */
polynomial vbss_polynomial_compact(workspace *w, uint32_t mark, polynomial p);
int32_t vbss_polynomial_sign_at(workspace *w, const polynomial *p, dyadic t);
/* Sets the degree after coefficients up to `degree` were written. */
void vbss_polynomial_trim(polynomial *p, int32_t degree);

/* p, p', and the signed remainders down to the greatest common divisor of the two. */
typedef struct sturm {
    int32_t count;
    polynomial p[4]; /* of a polynomial of degree 3 */
} sturm;
sturm vbss_sturm_make(workspace *w, const polynomial *p);
/* Changes of sign along the sequence; between two places, of which neither is a root, it falls by the
 * number of distinct roots between them. */
int32_t vbss_sturm_changes(workspace *w, const sturm *s, dyadic t);

/* One distinct root of a polynomial, alone between two places which are no roots of it. */
typedef struct root {
    dyadic low, high;
    int32_t changes_low, changes_high; /* of its sequence */
} root;
/* The distinct roots between 0 and 1, both excluded, of a polynomial that is not zero, ascending; at
 * most 3. `s` receives the sequence of the polynomial without its roots at 0 and 1. */
int32_t vbss_roots_between(workspace *w, const polynomial *p, sturm *s, root roots[3]);
/* The sign of q, of degree 2 at most, at a root of s. Narrows the root. */
int32_t vbss_sign_at_root(workspace *w, const polynomial *q, const sturm *s, root *r);

#endif
