#include "solver/plain_solve.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The machine is out of memory, not the test. */
static void *take(size_t count, size_t size)
{
    void *memory = calloc(count + 1, size);
    if (memory == NULL) {
        abort();
    }
    return memory;
}

void plain_begin(plain_system *p, uint32_t blocks)
{
    p->n = 3 * blocks;
    p->a = take((size_t)p->n * p->n, sizeof *p->a);
    p->b = take(p->n, sizeof *p->b);
}

void plain_end(plain_system *p)
{
    free(p->a);
    free(p->b);
}

static double *at(const plain_system *p, uint32_t i, uint32_t j)
{
    return &p->a[(size_t)i * p->n + j];
}

void plain_add(plain_system *p, uint32_t row, uint32_t column, mat3 m)
{
    for (uint32_t i = 0; i < 3; i++) {
        for (uint32_t j = 0; j < 3; j++) {
            *at(p, 3 * row + i, 3 * column + j) += m.m[i][j];
        }
    }
}

void plain_add_rhs(plain_system *p, uint32_t row, vec3 v)
{
    double *b = &p->b[(size_t)3 * row];
    b[0] += v.x;
    b[1] += v.y;
    b[2] += v.z;
}

void plain_remove(plain_system *p, uint32_t block)
{
    for (uint32_t i = 3 * block; i < 3 * block + 3; i++) {
        for (uint32_t j = 0; j < p->n; j++) {
            *at(p, i, j) = *at(p, j, i) = 0.0;
        }
        *at(p, i, i) = 1.0;
        p->b[i] = 0.0;
    }
}

/* ---- the band */

/* l: row i holds columns i - width .. i, of L and on the diagonal D. */
typedef struct band {
    uint32_t n, width;
    long double *l;
} band;

static long double *in_band(const band *b, uint32_t i, uint32_t j)
{
    return &b->l[(size_t)i * (b->width + 1) + (j + b->width - i)];
}

static bool band_factor(const plain_system *p, band *b)
{
    b->n = p->n;
    b->width = 0;
    for (uint32_t i = 0; i < p->n; i++) {
        for (uint32_t j = 0; j + b->width < i; j++) {
            if (*at(p, i, j) != 0.0) {
                b->width = i - j;
            }
        }
    }
    b->l = take((size_t)b->n * (b->width + 1), sizeof *b->l);
    for (uint32_t i = 0; i < b->n; i++) {
        uint32_t first = i > b->width ? i - b->width : 0;
        for (uint32_t j = first; j <= i; j++) {
            long double sum = (long double)*at(p, i, j);
            uint32_t start = j > b->width && j - b->width > first ? j - b->width : first;
            for (uint32_t k = start; k < j; k++) {
                sum -= *in_band(b, i, k) * *in_band(b, k, k) * *in_band(b, j, k);
            }
            *in_band(b, i, j) = i == j ? sum : sum / *in_band(b, j, j);
        }
        if (!(*in_band(b, i, i) > 0.0L)) {
            free(b->l);
            return false;
        }
    }
    return true;
}

static void band_solve(const band *b, const double *rhs, double *x)
{
    long double *y = take(b->n, sizeof *y);
    for (uint32_t i = 0; i < b->n; i++) {
        y[i] = (long double)rhs[i];
        for (uint32_t j = i > b->width ? i - b->width : 0; j < i; j++) {
            y[i] -= *in_band(b, i, j) * y[j];
        }
    }
    for (uint32_t i = b->n; i > 0; i--) {
        y[i - 1] /= *in_band(b, i - 1, i - 1);
        for (uint32_t j = i; j < b->n && j <= i - 1 + b->width; j++) {
            y[i - 1] -= *in_band(b, j, i - 1) * y[j];
        }
        x[i - 1] = (double)y[i - 1];
    }
    free(y);
}

bool plain_band_solve(const plain_system *p, double *x)
{
    band b;
    if (!band_factor(p, &b)) {
        return false;
    }
    band_solve(&b, p->b, x);
    free(b.l);
    return true;
}

/* ---- dense */

bool plain_lu_solve(const plain_system *p, double *x)
{
    uint32_t n = p->n, columns = n + 1; /* the right-hand side is the last */
    long double *m = take((size_t)n * columns, sizeof *m);
    bool regular = true;
    for (uint32_t i = 0; i < n; i++) {
        for (uint32_t j = 0; j < n; j++) {
            m[(size_t)i * columns + j] = (long double)*at(p, i, j);
        }
        m[(size_t)i * columns + n] = (long double)p->b[i];
    }
    for (uint32_t k = 0; k < n && regular; k++) {
        long double *top = &m[(size_t)k * columns];
        long double *best = top;
        for (uint32_t i = k + 1; i < n; i++) {
            long double *row = &m[(size_t)i * columns];
            best = fabsl(row[k]) > fabsl(best[k]) ? row : best;
        }
        for (uint32_t j = k; j < columns && best != top; j++) {
            long double kept = top[j];
            top[j] = best[j];
            best[j] = kept;
        }
        regular = top[k] != 0.0L;
        for (uint32_t i = k + 1; i < n && regular; i++) {
            long double *row = &m[(size_t)i * columns], factor = row[k] / top[k];
            for (uint32_t j = k; j < columns; j++) {
                row[j] -= factor * top[j];
            }
        }
    }
    for (uint32_t i = n; i > 0 && regular; i--) {
        long double *row = &m[(size_t)(i - 1) * columns];
        for (uint32_t j = i; j < n; j++) {
            row[n] -= row[j] * m[(size_t)j * columns + n];
        }
        row[n] /= row[i - 1];
        x[i - 1] = (double)row[n];
    }
    free(m);
    return regular;
}

/* ---- how good a solution is */

/* NaN is larger than anything. */
static double larger(double a, double b)
{
    return a > b || isnan(a) ? a : b;
}

void plain_defect(const plain_system *p, const double *x, double *r)
{
    for (uint32_t i = 0; i < p->n; i++) {
        long double sum = (long double)p->b[i];
        for (uint32_t j = 0; j < p->n; j++) {
            sum -= (long double)*at(p, i, j) * (long double)x[j];
        }
        r[i] = (double)sum;
    }
}

double plain_residual(const plain_system *p, const double *x)
{
    double *r = take(p->n, sizeof *r), worst = 0.0, scale = 0.0;
    plain_defect(p, x, r);
    for (uint32_t i = 0; i < p->n; i++) {
        double size = fabs(p->b[i]);
        for (uint32_t j = 0; j < p->n; j++) {
            size += fabs(*at(p, i, j)) * fabs(x[j]);
        }
        scale = fmax(scale, size);
        worst = larger(worst, fabs(r[i]));
    }
    free(r);
    return worst == 0.0 ? 0.0 : worst / scale;
}

static double largest(uint32_t n, const double *x)
{
    double largest = 0.0;
    for (uint32_t i = 0; i < n; i++) {
        largest = larger(largest, fabs(x[i]));
    }
    return largest;
}

double plain_condition(const plain_system *p)
{
    band b;
    if (!band_factor(p, &b)) {
        return HUGE_VAL;
    }
    double norm = 0.0, inverse = 0.0;
    double *x = take(p->n, sizeof *x);
    for (uint32_t i = 0; i < p->n; i++) {
        double sum = 0.0;
        for (uint32_t j = 0; j < p->n; j++) {
            sum += fabs(*at(p, i, j));
        }
        norm = fmax(norm, sum);
        x[i] = 1.0 + 0.3 * (i % 7); /* no eigenvector of anything */
    }
    for (int round = 0; round < 8; round++) {
        double size = largest(p->n, x);
        for (uint32_t i = 0; i < p->n; i++) {
            x[i] /= size;
        }
        band_solve(&b, x, x);
        inverse = largest(p->n, x);
    }
    free(x);
    free(b.l);
    return norm * inverse;
}

double plain_difference(uint32_t n, const double *x, const double *wanted)
{
    double worst = 0.0, scale = largest(n, wanted);
    for (uint32_t i = 0; i < n; i++) {
        worst = larger(worst, fabs(x[i] - wanted[i]));
    }
    return worst == 0.0 ? 0.0 : worst / scale;
}
