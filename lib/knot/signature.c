/* The Levine-Tristram signature from the matrix of R. Kashaev, "On symmetric matrices associated
 * with oriented link diagrams", arXiv 1801.04632. D. Cimasoni and L. Ferretti, Fundamenta
 * Mathematicae 266 (2024), and J. Liu, arXiv 2311.01923, prove that it gives this signature. The
 * matrix has one row for each face; a crossing of sign s adds the form
 *     s ((left + right + x (front + back))^2 - (1 - x^2) (front - back)^2).
 *
 * Two faces that share an arc are omitted. All these forms vanish where the values of successive
 * faces across the curve obey next = -2 x this - previous, and the values on these two faces
 * determine all others. The rest is singular only where Delta(t) = 0, 4 - 4 x^2 = 2 - t - 1/t.
 * Conway's polynomial is integral with constant term 1, so its rational roots are 1/k and -1/k, and
 * -(4 - 4 x^2) is not such a number for any x below 1 in ten-thousandths.
 *
 * The numbers of positive and negative eigenvalues are proved. The matrix is factorised twice,
 * shifted down and up by more than rounding can move an eigenvalue. The first gives a lower bound
 * of the positive ones, the second of the negative ones. If the bounds add up to all eigenvalues,
 * both are exact. */
#include "knot/faces.h"

#include <string.h>

/* J. R. Bunch and L. Kaufman, "Some stable methods for calculating inertia and solving symmetric linear
 * systems", Mathematics of Computation 31 (1977): (1 + sqrt 17) / 8. */
#define BUNCH_KAUFMAN_ALPHA 0.6403882032022076
/* Rows times the rounding of as many updates, a hundred roundings each, of numbers up to LARGEST_ENTRY. Derived. */
#define SHIFT_BY_SQUARE_OF_ROWS 1e-11
#define LARGEST_ENTRY 1e3

typedef struct form {
    uint32_t size;
    double *a;                            /* size x size, both triangles */
    double *first, *second;               /* columns of the pivots, at the listed rows */
    double *first_factor, *second_factor; /* multiples to subtract, at the listed rows */
    uint32_t *row;                        /* face -> row; `size` if omitted */
    uint32_t *degree;                     /* row -> number of its other nonzero entries */
    uint32_t *active, active_count;       /* rows not yet eliminated */
    uint32_t *list, list_count;           /* active rows where a pivot's column is not zero */
    double largest;
    uint64_t steps;
} form;

static form form_in(const knot_algebra *algebra, uint32_t n)
{
    double *behind = algebra->real + (size_t)n * n;
    uint32_t *index = algebra->index + (size_t)KNOT_CORNERS * n;
    return (form){.size = n,
                  .a = algebra->real,
                  .first = behind,
                  .second = behind + n,
                  .first_factor = behind + 2 * (size_t)n,
                  .second_factor = behind + 3 * (size_t)n,
                  .row = index,
                  .degree = index + (n + 2),
                  .active = index + 2 * ((size_t)n + 2),
                  .list = index + 3 * ((size_t)n + 2)};
}

/* ---- the matrix */

/* Omits the face with the most corners, and of its neighbours the one with the most corners. */
static void number_rows(form *f, const uint32_t *corners)
{
    uint32_t faces = f->size + 2, corner_count = KNOT_CORNERS * f->size, largest_face = 0,
             beside = faces;
    uint32_t *degree = f->degree;
    memset(degree, 0, faces * sizeof *degree);
    for (uint32_t i = 0; i < corner_count; i++) {
        degree[corners[i]]++;
    }
    for (uint32_t i = 1; i < faces; i++) {
        largest_face = degree[i] > degree[largest_face] ? i : largest_face;
    }
    for (uint32_t i = 0; i < corner_count; i++) {
        uint32_t next =
            corners[i % KNOT_CORNERS == KNOT_CORNERS - 1 ? i + 1 - KNOT_CORNERS : i + 1];
        uint32_t other = corners[i] == largest_face ? next : corners[i];
        if ((corners[i] == largest_face || next == largest_face) &&
            (beside == faces || degree[other] > degree[beside])) {
            beside = other;
        }
    }
    for (uint32_t i = 0, row = 0; i < faces; i++) {
        bool is_included = i != largest_face && i != beside;
        f->row[i] = is_included ? row : f->size;
        row += is_included ? 1 : 0;
    }
}

static void add_to(form *f, uint32_t i, uint32_t j, double value)
{
    double *entry = &f->a[(size_t)i * f->size + j], old = *entry;
    *entry = old + value;
    if (i != j) {
        f->degree[i] += (*entry != 0.0 ? 1u : 0u) - (old != 0.0 ? 1u : 0u);
    }
}

static void fill(form *f, const knot_gauss_code *code, const uint32_t *corners, double x,
                 double shift)
{
    const double own = 2.0 * x * x - 1.0;
    const double block[KNOT_CORNERS][KNOT_CORNERS] = {
        {own, x, 1.0, x}, {x, 1.0, x, 1.0}, {1.0, x, own, x}, {x, 1.0, x, 1.0}};
    memset(f->a, 0, (size_t)f->size * f->size * sizeof *f->a);
    memset(f->degree, 0, f->size * sizeof *f->degree);
    for (uint32_t i = 0; i < f->size; i++) {
        f->a[(size_t)i * f->size + i] = shift;
        f->active[i] = i;
    }
    f->active_count = f->size;
    for (uint32_t c = 0; c < code->n; c++) {
        for (uint32_t p = 0; p < KNOT_CORNERS; p++) {
            uint32_t i = f->row[corners[KNOT_CORNERS * c + p]];
            for (uint32_t q = 0; q < KNOT_CORNERS && i < f->size; q++) {
                uint32_t j = f->row[corners[KNOT_CORNERS * c + q]];
                if (j < f->size) {
                    add_to(f, i, j, code->sign[c] > 0 ? block[p][q] : -block[p][q]);
                }
            }
        }
    }
}

/* ---- pivots: L D L^T in an order with little fill */

static void deactivate(form *f, uint32_t row)
{
    uint32_t i = 0;
    while (f->active[i] != row) {
        i++;
    }
    f->active[i] = f->active[--f->active_count];
}

static uint32_t sparsest(const form *f)
{
    uint32_t best = f->active[0];
    for (uint32_t i = 1; i < f->active_count; i++) {
        uint32_t row = f->active[i];
        best = f->degree[row] < f->degree[best] ? row : best;
    }
    return best;
}

/* The largest other entry in a row, and its column. */
static double largest_beside(const form *f, uint32_t row, uint32_t *where)
{
    const double *entries = f->a + (size_t)row * f->size;
    double largest = 0.0;
    for (uint32_t i = 0; i < f->active_count; i++) {
        uint32_t j = f->active[i];
        if (j != row && fabs(entries[j]) > largest) {
            largest = fabs(entries[j]);
            *where = j;
        }
    }
    return largest;
}

static double at(const form *f, uint32_t i, uint32_t j)
{
    return f->a[(size_t)i * f->size + j];
}

/* Subtracts the contribution of the pivots from all listed rows. */
static void subtract_pivots(form *f, bool both)
{
    size_t size = f->size;
    double largest = f->largest;
    for (uint32_t p = 0; p < f->list_count; p++) {
        uint32_t i = f->list[p], filled = 0;
        double *row = f->a + i * size, factor = f->first_factor[p];
        double second_factor = both ? f->second_factor[p] : 0.0;
        for (uint32_t q = 0; q <= p; q++) {
            uint32_t j = f->list[q];
            double old = row[j], update = factor * f->first[q];
            update += both ? second_factor * f->second[q] : 0.0;
            double value = old - update;
            row[j] = value;
            f->a[j * size + i] = value;
            largest = vbss_max(largest, fabs(value));
            if (old == 0.0 && q < p) {
                f->degree[j]++;
                filled++;
            }
        }
        f->degree[i] += filled;
    }
    f->largest = largest;
    f->steps += 40 + 2 * (uint64_t)f->active_count +
                (uint64_t)f->list_count * f->list_count * (both ? 3 : 2) / 2;
}

/* Eliminates one row. Returns the sign of the pivot. */
static int eliminate_one(form *f, uint32_t k)
{
    const double *row = f->a + (size_t)k * f->size;
    double pivot = row[k];
    deactivate(f, k);
    f->list_count = 0;
    for (uint32_t i = 0; i < f->active_count; i++) {
        uint32_t j = f->active[i];
        if (row[j] != 0.0) {
            f->degree[j]--;
            f->first[f->list_count] = row[j];
            f->first_factor[f->list_count] = row[j] / pivot;
            f->list[f->list_count++] = j;
        }
    }
    subtract_pivots(f, false);
    return (pivot > 0.0) - (pivot < 0.0);
}

/* Eliminates two rows with a 2x2 pivot, which has one positive and one negative eigenvalue. */
static void eliminate_two(form *f, uint32_t k, uint32_t r)
{
    const double *row_k = f->a + (size_t)k * f->size, *row_r = f->a + (size_t)r * f->size;
    double beside = row_k[r], d_k = row_k[k] / beside, d_r = row_r[r] / beside;
    double scale = 1.0 / (beside * (d_k * d_r - 1.0));
    deactivate(f, k);
    deactivate(f, r);
    f->list_count = 0;
    for (uint32_t i = 0; i < f->active_count; i++) {
        uint32_t j = f->active[i];
        double a = row_k[j], b = row_r[j];
        if (a != 0.0 || b != 0.0) {
            f->degree[j] -= (a != 0.0 ? 1u : 0u) + (b != 0.0 ? 1u : 0u);
            f->first[f->list_count] = a;
            f->second[f->list_count] = b;
            f->first_factor[f->list_count] = (d_r * a - b) * scale;
            f->second_factor[f->list_count] = (d_k * b - a) * scale;
            f->list[f->list_count++] = j;
        }
    }
    subtract_pivots(f, true);
}

/* Counts positive and negative eigenvalues; overwrites the matrix. Returns false if it is singular
 * or its entries have grown too much. */
static bool count_signs(form *f, uint32_t *positive, uint32_t *negative)
{
    *positive = *negative = 0;
    f->largest = 0.0;
    while (f->active_count > 0) {
        uint32_t k = sparsest(f), r = k;
        double beside = largest_beside(f, k, &r), own = fabs(at(f, k, k));
        if (own < BUNCH_KAUFMAN_ALPHA * beside) {
            uint32_t s = r;
            double beside_r = largest_beside(f, r, &s), own_r = fabs(at(f, r, r));
            if (own * beside_r < BUNCH_KAUFMAN_ALPHA * beside * beside) {
                if (own_r < BUNCH_KAUFMAN_ALPHA * beside_r) {
                    eliminate_two(f, k, r);
                    ++*positive;
                    ++*negative;
                    continue;
                }
                k = r;
            }
        }
        int sign = at(f, k, k) != 0.0 ? eliminate_one(f, k) : 0;
        if (sign == 0) {
            return false;
        }
        ++*(sign > 0 ? positive : negative);
    }
    return f->largest <= LARGEST_ENTRY;
}

bool vbss_knot_signature(knot_algebra *algebra, const knot_gauss_code *code, uint32_t x_10000,
                         int32_t *signature, knot_ops *budget)
{
    uint32_t n = code->n, positive = 0, negative = 0, rest = 0;
    knot_faces faces;
    *signature = 0;
    *budget -= 200;
    if (n == 0) {
        return true;
    }
    if (!vbss_knot_find_faces(algebra, code, &faces)) {
        return false;
    }
    double x = (double)x_10000 / 10000.0, shift = SHIFT_BY_SQUARE_OF_ROWS * n * n;
    form f = form_in(algebra, n);
    number_rows(&f, algebra->index);
    fill(&f, code, algebra->index, x, -shift);
    bool is_certain = count_signs(&f, &positive, &rest);
    fill(&f, code, algebra->index, x, shift);
    is_certain = count_signs(&f, &rest, &negative) && is_certain && positive + negative == n;
    *budget -= (knot_ops)(f.steps + 40 * (uint64_t)n + (uint64_t)n * n / 2);
    int32_t twice = (int32_t)positive - (int32_t)negative;
    for (uint32_t c = 0; c < n; c++) {
        twice -= code->sign[c];
    }
    *signature = twice / 2;
    return is_certain && twice % 4 == 0; /* the signature of a knot is even */
}
