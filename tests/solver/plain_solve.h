/* Linear systems solved the plain way, in long double: what the solver's tests compare with. Shares
 * nothing with lib/solver. */
#ifndef VBSS_TESTS_PLAIN_SOLVE_H
#define VBSS_TESTS_PLAIN_SOLVE_H

#include <stdbool.h>
#include <stdint.h>

#include "base/linear.h"

/* a x = b in scalars, three a block; a by rows. */
typedef struct plain_system {
    uint32_t n;
    double *a, *b;
} plain_system;
void plain_begin(plain_system *p, uint32_t blocks);
void plain_end(plain_system *p);
/* Into the rows of one block and the columns of another: only there. */
void plain_add(plain_system *p, uint32_t row, uint32_t column, mat3 m);
void plain_add_rhs(plain_system *p, uint32_t row, vec3 v);
/* The block has no equation and its unknown is zero. */
void plain_remove(plain_system *p, uint32_t block);

/* By a scalar L D L^T inside the band, of a symmetric positive definite system. False: it is none. */
bool plain_band_solve(const plain_system *p, double *x);
/* By LU with row exchanges, of any system that is not singular. */
bool plain_lu_solve(const plain_system *p, double *x);
/* Largest |b - a x| against the largest |a| |x| + |b|. */
double plain_residual(const plain_system *p, const double *x);
/* Of b - a x, into r. */
void plain_defect(const plain_system *p, const double *x, double *r);
/* The condition number in the largest norm, of a symmetric positive definite system; from below, by
 * inverse iteration. */
double plain_condition(const plain_system *p);
/* Largest |x - wanted| against the largest |wanted|; 0 for two zeros. */
double plain_difference(uint32_t n, const double *x, const double *wanted);

#endif
