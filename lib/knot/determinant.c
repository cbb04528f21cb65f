/* The determinant of a knot, |Delta(-1)|, from the Goeritz matrix of the checkerboard colour with
 * fewer faces, without one row and column.
 *
 * The matrix has one row for each face. Each crossing joins two faces, with +1 if its over strand
 * sweeps them when it turns left, otherwise -1. (The colouring matrix, with one row for each
 * crossing, has the same determinant and twice as many rows.)
 * The computation is modulo a prime, so nothing is rounded. The determinant is a signed count of
 * spanning trees of that graph. Each of them selects as many of the n edges as there are rows, so
 * there are at most binomial(n, n/2). One prime suffices for 32 crossings, two for 64. */
#include "knot/faces.h"

#include <string.h>

/* 2^31 - 1 and the prime before it are 2^31 - below. Derived, as said above. */
enum { BELOW_FIRST = 1, BELOW_SECOND = 19, ONE_PRIME_CROSSINGS = 32 };

void vbss_knot_algebra_arrays(knot_algebra *a, uint32_t capacity,
                              vbss_array arrays[KNOT_ALGEBRA_ARRAYS])
{
    size_t rows = (size_t)capacity + 2;
    a->capacity = capacity;
    arrays[0] = (vbss_array){&a->real, rows * rows, sizeof *a->real};
    arrays[1] = (vbss_array){&a->modular, rows * rows, sizeof *a->modular};
    arrays[2] = (vbss_array){&a->index, 16 * rows, sizeof *a->index};
}

/* ---- arithmetic modulo 2^31 - below */

static uint64_t prime_of(uint32_t below)
{
    return ((uint64_t)1 << 31) - below;
}

/* Requires x < 2^63; uses that 2^31 is congruent to `below`. */
static inline uint64_t reduced(uint64_t x, uint32_t below)
{
    const uint64_t low = ((uint64_t)1 << 31) - 1, prime = prime_of(below);
    x = (x & low) + (x >> 31) * below;
    x = (x & low) + (x >> 31) * below;
    return x >= prime ? x - prime : x;
}

static uint64_t inverse(uint64_t x, uint32_t below)
{
    uint64_t result = 1;
    for (uint64_t power = prime_of(below) - 2; power > 0; power >>= 1) {
        result = (power & 1) != 0 ? reduced(result * x, below) : result;
        x = reduced(x * x, below);
    }
    return result;
}

/* ---- the matrix */

typedef struct graph {
    const knot_algebra *algebra;
    const knot_gauss_code *code;
    uint32_t first, count, size; /* faces of the chosen colour; there is one row fewer */
    uint32_t *row;               /* face of this colour -> row */
} graph;

/* Faces with few crossings come first, which limits the fill; the one with the most is omitted. */
static void order_rows(graph *g)
{
    uint32_t n = g->code->n, *degree = g->row + g->count;
    const uint32_t *corners = g->algebra->index;
    memset(degree, 0, g->count * sizeof *degree);
    for (uint32_t i = 0; i < KNOT_CORNERS * n; i++) {
        if (corners[i] - g->first < g->count) {
            degree[corners[i] - g->first]++;
        }
    }
    for (uint32_t i = 0; i < g->count; i++) {
        uint32_t rank = 0;
        for (uint32_t j = 0; j < g->count; j++) {
            rank += degree[j] < degree[i] || (degree[j] == degree[i] && j < i) ? 1 : 0;
        }
        g->row[i] = rank;
    }
}

static void add_to(uint64_t *entry, uint64_t value, uint64_t prime)
{
    *entry += value;
    *entry -= *entry >= prime ? prime : 0;
}

static void fill(const graph *g, uint64_t prime)
{
    uint64_t *a = g->algebra->modular;
    memset(a, 0, (size_t)g->size * g->size * sizeof *a);
    for (uint32_t c = 0; c < g->code->n; c++) {
        const uint32_t *corner = g->algebra->index + (size_t)KNOT_CORNERS * c;
        bool ahead = corner[KNOT_FRONT] - g->first < g->count;
        uint32_t p = g->row[corner[ahead ? KNOT_FRONT : KNOT_LEFT] - g->first];
        uint32_t q = g->row[corner[ahead ? KNOT_BACK : KNOT_RIGHT] - g->first];
        uint64_t plus = (g->code->sign[c] > 0) == ahead ? 1 : prime - 1, minus = prime - plus;
        if (p != q && p < g->size) {
            add_to(&a[p * g->size + p], plus, prime);
        }
        if (p != q && q < g->size) {
            add_to(&a[q * g->size + q], plus, prime);
        }
        if (p != q && p < g->size && q < g->size) {
            add_to(&a[p * g->size + q], minus, prime);
            add_to(&a[q * g->size + p], minus, prime);
        }
    }
}

/* Fraction-free elimination: rows are multiplied by the pivot, and the product of these factors is
 * divided out at the end. Overwrites the matrix. */
static uint64_t eliminate(uint64_t *a, uint32_t size, uint32_t below, knot_ops *budget)
{
    const uint64_t prime = prime_of(below);
    uint64_t product = 1, factors = 1, steps = 0;
    for (uint32_t k = 0; k < size; k++) {
        uint64_t *pivot_row = a + (size_t)k * size;
        uint32_t chosen = k;
        while (chosen < size && a[(size_t)chosen * size + k] == 0) {
            chosen++;
        }
        if (chosen == size) {
            return 0;
        }
        if (chosen != k) { /* exchange rows, with a minus sign */
            uint64_t *row = a + (size_t)chosen * size;
            for (uint32_t j = k; j < size; j++) {
                uint64_t value = pivot_row[j];
                pivot_row[j] = row[j];
                row[j] = value == 0 ? 0 : prime - value;
            }
        }
        uint64_t pivot = pivot_row[k];
        product = reduced(product * pivot, below);
        for (uint32_t i = k + 1; i < size; i++) {
            uint64_t *row = a + (size_t)i * size;
            if (row[k] != 0) {
                uint64_t minus = prime - row[k];
                for (uint32_t j = k + 1; j < size; j++) {
                    row[j] = reduced(pivot * row[j] + minus * pivot_row[j], below);
                }
                factors = reduced(factors * pivot, below);
                steps += size - k;
            }
        }
    }
    *budget -= (knot_ops)(3 * steps);
    return reduced(product * inverse(factors, below), below);
}

/* The number of smallest magnitude with these remainders. */
static int64_t chinese_remainder(uint64_t first, uint64_t second)
{
    const uint64_t p = prime_of(BELOW_FIRST), q = prime_of(BELOW_SECOND);
    uint64_t difference = second + q - first % q;
    uint64_t times =
        reduced(reduced(difference, BELOW_SECOND) * inverse(p % q, BELOW_SECOND), BELOW_SECOND);
    uint64_t x = first + p * times, whole = p * q;
    return (int64_t)(x > whole / 2 ? whole - x : x);
}

int64_t vbss_knot_determinant(knot_algebra *algebra, const knot_gauss_code *code, knot_ops *budget)
{
    knot_faces faces;
    *budget -= 50 + 45 * (knot_ops)code->n;
    if (code->n == 0) {
        return 1;
    }
    if (!vbss_knot_find_faces(algebra, code, &faces)) {
        return 0;
    }
    bool even = 2 * faces.even <= faces.count;
    graph g = {algebra,
               code,
               even ? 0 : faces.even,
               even ? faces.even : faces.count - faces.even,
               0,
               algebra->index + (size_t)KNOT_CORNERS * code->n};
    g.size = g.count - 1;
    order_rows(&g);
    const uint64_t p = prime_of(BELOW_FIRST);
    fill(&g, p);
    uint64_t first = eliminate(algebra->modular, g.size, BELOW_FIRST, budget);
    if (code->n <= ONE_PRIME_CROSSINGS) {
        return (int64_t)(first > p / 2 ? p - first : first);
    }
    fill(&g, prime_of(BELOW_SECOND));
    return chinese_remainder(first, eliminate(algebra->modular, g.size, BELOW_SECOND, budget));
}
