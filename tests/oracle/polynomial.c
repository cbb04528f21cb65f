#include "oracle/polynomial.h"

#include <stddef.h>

void polynomial_init(polynomial *p)
{
    p->degree = -1;
    for (int i = 0; i < POLYNOMIAL_TERMS; i++) {
        mpz_init(p->c[i]);
    }
}

void polynomial_clear(polynomial *p)
{
    for (int i = 0; i < POLYNOMIAL_TERMS; i++) {
        mpz_clear(p->c[i]);
    }
}

static void find_degree(polynomial *p)
{
    p->degree = POLYNOMIAL_TERMS - 1;
    while (p->degree >= 0 && mpz_sgn(p->c[p->degree]) == 0) {
        p->degree--;
    }
}

void polynomial_set(polynomial *p, const polynomial *a)
{
    p->degree = a->degree;
    for (int i = 0; i < POLYNOMIAL_TERMS; i++) {
        mpz_set(p->c[i], a->c[i]);
    }
}

void polynomial_set_linear(polynomial *p, const mpz_t c0, const mpz_t c1)
{
    for (int i = 2; i < POLYNOMIAL_TERMS; i++) {
        mpz_set_ui(p->c[i], 0);
    }
    mpz_set(p->c[0], c0);
    mpz_set(p->c[1], c1);
    find_degree(p);
}

void polynomial_subtract(polynomial *p, const polynomial *a, const polynomial *b)
{
    for (int i = 0; i < POLYNOMIAL_TERMS; i++) {
        mpz_sub(p->c[i], a->c[i], b->c[i]);
    }
    find_degree(p);
}

void polynomial_multiply(polynomial *p, const polynomial *a, const polynomial *b)
{
    polynomial product;
    polynomial_init(&product);
    for (int i = 0; i <= a->degree; i++) {
        for (int j = 0; j <= b->degree; j++) {
            mpz_addmul(product.c[i + j], a->c[i], b->c[j]);
        }
    }
    find_degree(&product);
    polynomial_set(p, &product);
    polynomial_clear(&product);
}

static void differentiate(polynomial *p, const polynomial *a)
{
    for (int i = 1; i < POLYNOMIAL_TERMS; i++) {
        mpz_mul_si(p->c[i - 1], a->c[i], i);
    }
    mpz_set_ui(p->c[POLYNOMIAL_TERMS - 1], 0);
    find_degree(p);
}

/* r becomes a positive multiple of -(r mod d). */
static void negated_remainder(polynomial *r, const polynomial *d)
{
    mpz_t scale, lead;
    mpz_inits(scale, lead, NULL);
    mpz_abs(scale, d->c[d->degree]);
    while (r->degree >= d->degree) {
        int shift = r->degree - d->degree;
        mpz_set(lead, r->c[r->degree]);
        if (mpz_sgn(d->c[d->degree]) < 0) {
            mpz_neg(lead, lead);
        }
        for (int i = 0; i <= r->degree; i++) {
            mpz_mul(r->c[i], r->c[i], scale);
        }
        for (int i = 0; i <= d->degree; i++) {
            mpz_submul(r->c[i + shift], lead, d->c[i]);
        }
        find_degree(r);
    }
    for (int i = 0; i <= r->degree; i++) {
        mpz_neg(r->c[i], r->c[i]);
    }
    mpz_clears(scale, lead, NULL);
}

static int sign_at_dyadic(const polynomial *p, const dyadic *x)
{
    mpz_t sum, term;
    mpz_inits(sum, term, NULL);
    for (int i = p->degree; i >= 0; i--) { /* Horner, times 2^(power degree) */
        mpz_mul(sum, sum, x->number);
        mpz_mul_2exp(term, p->c[i], x->power * (mp_bitcnt_t)(p->degree - i));
        mpz_add(sum, sum, term);
    }
    int sign = mpz_sgn(sum);
    mpz_clears(sum, term, NULL);
    return sign;
}

/* ---- Sturm and Tarski: for q with q(low) and q(high) not zero, and the sequence q, q' f, and then
 * always minus the remainder of the two before, the changes of sign at low less those at high are the
 * number of distinct roots of q between them where f > 0 less the number where f < 0. */

enum { SEQUENCE = POLYNOMIAL_TERMS + 3 };

static int sum_of_signs(const polynomial *q, const polynomial *f, const dyadic *low,
                        const dyadic *high)
{
    polynomial sequence[SEQUENCE];
    for (int i = 0; i < SEQUENCE; i++) {
        polynomial_init(&sequence[i]);
    }
    polynomial_set(&sequence[0], q);
    differentiate(&sequence[1], q);
    polynomial_multiply(&sequence[1], &sequence[1], f);
    int count = 1;
    while (sequence[count].degree >= 0) {
        polynomial_set(&sequence[count + 1], &sequence[count - 1]);
        negated_remainder(&sequence[count + 1], &sequence[count]);
        count++;
    }
    int changes = 0, last_low = 0, last_high = 0;
    for (int i = 0; i < count; i++) {
        int at_low = sign_at_dyadic(&sequence[i], low);
        int at_high = sign_at_dyadic(&sequence[i], high);
        changes += at_low * last_low < 0 ? 1 : 0;
        changes -= at_high * last_high < 0 ? 1 : 0;
        last_low = at_low != 0 ? at_low : last_low;
        last_high = at_high != 0 ? at_high : last_high;
    }
    for (int i = 0; i < SEQUENCE; i++) {
        polynomial_clear(&sequence[i]);
    }
    return changes;
}

int polynomial_sign_at(const polynomial *p, const algebraic *root)
{
    return sum_of_signs(root->of, p, &root->low, &root->high);
}

/* ---- isolating roots */

static int count_roots(const polynomial *q, const dyadic *low, const dyadic *high)
{
    polynomial one;
    polynomial_init(&one);
    mpz_set_ui(one.c[0], 1);
    find_degree(&one);
    int count = sum_of_signs(q, &one, low, high);
    polynomial_clear(&one);
    return count;
}

/* A point between low and high that is no root: of eight, seven at most are. */
static void split(const polynomial *q, const dyadic *low, const dyadic *high, dyadic *middle)
{
    mpz_t a, b;
    mpz_inits(a, b, NULL);
    middle->power = (low->power > high->power ? low->power : high->power) + 4;
    mpz_mul_2exp(a, low->number, middle->power - low->power);
    mpz_mul_2exp(b, high->number, middle->power - high->power);
    mpz_sub(b, b, a); /* a multiple of 16 */
    mpz_fdiv_q_2exp(b, b, 4);
    mpz_addmul_ui(a, b, 8);
    do {
        mpz_set(middle->number, a);
        mpz_add(a, a, b);
    } while (sign_at_dyadic(q, middle) == 0);
    mpz_clears(a, b, NULL);
}

static bool visit_between(const polynomial *q, const dyadic *low, const dyadic *high,
                          polynomial_visit visit, void *user)
{
    int count = count_roots(q, low, high);
    if (count == 0) {
        return false;
    }
    if (count == 1) {
        algebraic root = {.of = q, .low = *low, .high = *high};
        return visit(&root, user);
    }
    dyadic middle;
    mpz_init(middle.number);
    split(q, low, high, &middle);
    bool found =
        visit_between(q, low, &middle, visit, user) || visit_between(q, &middle, high, visit, user);
    mpz_clear(middle.number);
    return found;
}

bool polynomial_any_root(const polynomial *p, polynomial_visit visit, void *user)
{
    dyadic low = {.power = 0}, high = {.power = 0};
    mpz_init_set_si(low.number, -1);
    mpz_init_set_si(high.number, 2);
    while (sign_at_dyadic(p, &low) == 0) {
        mpz_sub_ui(low.number, low.number, 1);
    }
    while (sign_at_dyadic(p, &high) == 0) {
        mpz_add_ui(high.number, high.number, 1);
    }
    bool found = visit_between(p, &low, &high, visit, user);
    mpz_clears(low.number, high.number, NULL);
    return found;
}
