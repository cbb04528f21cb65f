/* Polynomials with integer coefficients of any length, and the signs they take at real algebraic
 * numbers. For the oracle only. */
#ifndef VBSS_TESTS_ORACLE_POLYNOMIAL_H
#define VBSS_TESTS_ORACLE_POLYNOMIAL_H

#include <stdbool.h>

#include <gmp.h>

/* A cubic's derivative times a cubic has degree 5. */
enum { POLYNOMIAL_TERMS = 6 };

/* c[0] + c[1] t + ...; the degree of the zero polynomial is -1. */
typedef struct polynomial {
    int degree;
    mpz_t c[POLYNOMIAL_TERMS];
} polynomial;

void polynomial_init(polynomial *p); /* to zero */
void polynomial_clear(polynomial *p);
void polynomial_set(polynomial *p, const polynomial *a);
/* The result may be one of the operands. */
void polynomial_subtract(polynomial *p, const polynomial *a, const polynomial *b);
void polynomial_multiply(polynomial *p, const polynomial *a, const polynomial *b);
/* c0 + c1 t */
void polynomial_set_linear(polynomial *p, const mpz_t c0, const mpz_t c1);

/* number / 2^power */
typedef struct dyadic {
    mpz_t number;
    mp_bitcnt_t power;
} dyadic;

/* The one root of `of` between low and high, which are no roots. */
typedef struct algebraic {
    const polynomial *of;
    dyadic low, high;
} algebraic;

int polynomial_sign_at(const polynomial *p, const algebraic *root);

/* Calls `visit` for every real root of p, which is not zero, between -1 - e and 2 + e for some e > 0 from 0
 * to 3, until it returns true; whether it did. */
typedef bool (*polynomial_visit)(const algebraic *root, void *user);
bool polynomial_any_root(const polynomial *p, polynomial_visit visit, void *user);

#endif
