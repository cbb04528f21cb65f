/* Polynomials whose factors are known, so that every root is rational or of a quadratic, and what is true
 * of it is a matter of GMP's integers. */
#ifndef VBSS_TESTS_COLLISION_KNOWN_ROOTS_H
#define VBSS_TESTS_COLLISION_KNOWN_ROOTS_H

#include "gmp_integers.h"

/* ---- the truth */

/* (p + root_sign sqrt(d)) / q, q > 0, d >= 0; root_sign 0: p / q, d is 0. */
typedef struct surd {
    mpz_t p, q, d;
    int root_sign;
} surd;

/* c[0] + c[1] t + ... and its distinct real roots */
typedef struct known {
    int degree, count;
    mpz_t c[4];
    surd roots[3];
    mpz_t n, d, factor[3]; /* the last rational root n / d; the quadratic factor */
} known;

static inline void for_all(known *k, void (*each)(mpz_t x))
{
    for (int i = 0; i < 4; i++) {
        each(k->c[i]);
    }
    for (int i = 0; i < 3; i++) {
        each(k->roots[i].p);
        each(k->roots[i].q);
        each(k->roots[i].d);
        each(k->factor[i]);
    }
    each(k->n);
    each(k->d);
}

static inline void begin(mpz_t x)
{
    mpz_init(x);
}

static inline void end(mpz_t x)
{
    mpz_clear(x);
}

/* x + y sqrt(d) */
static inline int surd_sign(const mpz_t x, const mpz_t y, const mpz_t d)
{
    int of_x = mpz_sgn(x), of_y = mpz_sgn(d) == 0 ? 0 : mpz_sgn(y);
    if (of_x * of_y >= 0) {
        return of_x != 0 ? of_x : of_y;
    }
    mpz_t xx, yyd;
    mpz_inits(xx, yyd, NULL);
    mpz_mul(xx, x, x);
    mpz_mul(yyd, y, y);
    mpz_mul(yyd, yyd, d);
    int order = mpz_cmp(xx, yyd);
    mpz_clears(xx, yyd, NULL);
    return order == 0 ? 0 : order > 0 ? of_x : of_y;
}

/* The sign of c[0] + c[1] t + c[2] t^2 at t, from q^2 times that: x + y sqrt(d). */
static inline int sign_at(mpz_t c[3], const surd *t)
{
    mpz_t x, y, part;
    mpz_inits(x, y, part, NULL);
    mpz_mul(x, t->p, t->p);
    mpz_add(x, x, t->d);
    mpz_mul(x, x, c[2]);
    mpz_mul(part, c[1], t->q);
    mpz_addmul(x, part, t->p);
    mpz_mul(y, c[2], t->p);
    mpz_addmul_ui(part, y, 2);
    mpz_mul_si(y, part, t->root_sign);
    mpz_mul(part, c[0], t->q);
    mpz_addmul(x, part, t->q);
    int sign = surd_sign(x, y, t->d);
    mpz_clears(x, y, part, NULL);
    return sign;
}

/* 1: t is above the place. */
static inline int side_of(const workspace *w, const surd *t, dyadic place)
{
    mpz_t c[3];
    mpz_inits(c[0], c[1], c[2], NULL);
    to_mpz(w, place.numerator, c[0]);
    mpz_neg(c[0], c[0]);
    mpz_setbit(c[1], place.bits);
    int sign = sign_at(c, t);
    mpz_clears(c[0], c[1], c[2], NULL);
    return sign;
}

static inline bool is_between_0_and_1(const surd *t)
{
    uint32_t one = 1;
    const workspace w = {&one, 1, 1, false};
    const dyadic low = {{0, 0, 0}, 0}, high = {{0, 1, 1}, 0};
    return side_of(&w, t, low) > 0 && side_of(&w, t, high) < 0;
}

/* ---- polynomials with known roots */

/* Times f[0] + f[1] t + f[2] t^2. */
static inline void multiply(known *k, mpz_t *f, int degree)
{
    mpz_t sum;
    mpz_init(sum);
    for (int i = k->degree + degree; i >= 0; i--) {
        mpz_set_ui(sum, 0);
        for (int j = 0; j <= degree && j <= i; j++) {
            mpz_addmul(sum, f[j], k->c[i - j]);
        }
        mpz_set(k->c[i], sum);
    }
    mpz_clear(sum);
    k->degree += degree;
}

/* a t^2 + b t + c: of small numbers; or with two roots 2^-200 beside m / 7; or with that twice. */
static inline void add_quadratic(harness_source *source, known *k)
{
    uint32_t how = harness_draw_below(source, 3);
    long m = (long)harness_draw_below(source, 8);
    long a = 1 + (long)harness_draw_below(source, 20),
         b = 20 - (long)harness_draw_below(source, 41);
    long c = 20 - (long)harness_draw_below(source, 41);
    mpz_set_si(k->factor[2], how == 0 ? a : 49);
    mpz_set_si(k->factor[1], how == 0 ? b : -14 * m);
    mpz_set_si(k->factor[0], how == 0 ? c : m * m);
    for (int i = 0; i < 3 && how != 0; i++) {
        mpz_mul_2exp(k->factor[i], k->factor[i], 400);
    }
    if (how == 1) {
        mpz_sub_ui(k->factor[0], k->factor[0], 2);
    }
    multiply(k, k->factor, 2);
    surd *r = &k->roots[0];
    mpz_mul(r->d, k->factor[2], k->factor[0]);
    mpz_mul_si(r->d, r->d, -4);
    mpz_addmul(r->d, k->factor[1], k->factor[1]);
    mpz_neg(r->p, k->factor[1]);
    mpz_mul_ui(r->q, k->factor[2], 2);
    r->root_sign = mpz_sgn(r->d);
    k->count = r->root_sign + 1;
    if (k->count == 2) {
        mpz_set(r[1].p, r->p);
        mpz_set(r[1].q, r->q);
        mpz_set(r[1].d, r->d);
        r[1].root_sign = -1;
    } else if (k->count == 0) {
        mpz_set_ui(r->d, 0);
    }
}

/* d t - n: of small numbers, often 0 or 1; of long ones; the last one again, or 2^-200 beside it. */
static inline void add_linear(harness_source *source, known *k)
{
    uint32_t how = harness_draw_below(source, 4), limbs = 1 + harness_draw_below(source, 30);
    if (how == 0 || mpz_sgn(k->d) == 0) {
        uint32_t d = 1 + harness_draw_below(source, 6);
        mpz_set_ui(k->d, d);
        mpz_set_si(k->n, (long)harness_draw_below(source, d + 3) - 1);
    } else if (how == 1) {
        draw_mpz(source, limbs, k->n);
        draw_mpz(source, limbs, k->d);
        mpz_abs(k->d, k->d);
        mpz_add_ui(k->d, k->d, 1);
    } else if (how == 2) {
        mpz_mul_2exp(k->n, k->n, 200);
        mpz_mul_2exp(k->d, k->d, 200);
        mpz_add_ui(k->n, k->n, 1);
    }
    mpz_t f[3];
    mpz_inits(f[0], f[1], f[2], NULL);
    mpz_neg(f[0], k->n);
    mpz_set(f[1], k->d);
    bool old = false;
    for (int i = 0; i < k->count; i++) {
        old = old || sign_at(f, &k->roots[i]) == 0;
    }
    multiply(k, f, 1);
    if (!old) {
        surd *r = &k->roots[k->count++];
        mpz_set(r->p, k->n);
        mpz_set(r->q, k->d);
        r->root_sign = 0;
    }
    mpz_clears(f[0], f[1], f[2], NULL);
}

static inline void draw_known(harness_source *source, known *k)
{
    *k = (known){.degree = 0};
    for_all(k, begin);
    do {
        draw_mpz(source, 4, k->c[0]);
    } while (mpz_sgn(k->c[0]) == 0);
    if (harness_draw_below(source, 2) != 0) {
        add_quadratic(source, k);
    }
    uint32_t linear = harness_draw_below(source, 4 - (uint32_t)k->degree);
    for (uint32_t i = 0; i < linear; i++) {
        add_linear(source, k);
    }
}

/* What may vanish at a root, nearly or not at all. */
static inline void draw_second(harness_source *source, const known *k, mpz_t q[3])
{
    uint32_t how = harness_draw_below(source, 6), limbs = 1 + harness_draw_below(source, 20);
    for (int i = 0; i < 3; i++) {
        if (how == 0) { /* any */
            draw_mpz(source, limbs, q[i]);
        } else if (how == 1) { /* the derivative */
            mpz_mul_ui(q[i], k->c[i + 1], (unsigned long)i + 1);
        } else if (how == 2) {
            mpz_set(q[i], k->factor[i]);
        } else {
            mpz_set_si(q[i], 3 - (long)harness_draw_below(source, 7));
        }
    }
    if (how >= 3 && how <= 4) { /* the last rational root, or 2^-300 beside it, and another one */
        known product = {.degree = 0};
        for_all(&product, begin);
        mpz_set_ui(product.c[0], 1);
        mpz_neg(product.factor[0], k->n);
        mpz_set(product.factor[1], k->d);
        for (int i = 0; i < 2 && how == 4; i++) {
            mpz_mul_2exp(product.factor[i], product.factor[i], 300);
        }
        mpz_add_ui(product.factor[0], product.factor[0], how == 4);
        multiply(&product, product.factor, 1);
        multiply(&product, q, 1);
        for (int i = 0; i < 3; i++) {
            mpz_set(q[i], product.c[i]);
        }
        for_all(&product, end);
    }
}

#endif
