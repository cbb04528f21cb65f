/* Decomposition of a diagram into twist regions, which proves that a knot is a connected sum of
 * torus knots.
 *
 * Consider an interval of the code that contains both entries of each of its crossings. Its ends
 * are the only edges between the two sets of crossings, and a cut of a connected planar graph is a
 * circle of its dual. So a circle in the plane separates the interval from the rest: it is a
 * summand, and the code without it is that of the rest.
 * An interval 1 ... m 1 ... m, alternating and with equal signs, is exactly the code of the closed
 * braid of two strands and m crossings, T(2, m), and codes with signs determine diagrams on the
 * sphere. Each cyclic shift reads the same with other letters. Even m cannot alternate; 1 ... m m
 * ... 1 is not such a block.
 * Entries are pushed on a stack; a complete block on top is popped. A block contains no smaller
 * interval of this kind. Only such intervals lie between its entries, and they end before it does.
 * So all blocks are found, inner ones first. */
#include "knot/knot.h"

/* Smallest number of crossings of a torus knot T(2, m), derived. */
enum { MIN_CROSSINGS = 3 };

/* Whether 2 m entries are a block. The caller knows that some crossing is the last entry of each
 * half. */
static bool is_block(const knot_gauss_code *code, const uint16_t *entries, uint32_t m)
{
    int8_t sign = code->sign[code->crossing[entries[0]]];
    bool over = code->over[entries[0]] != 0;
    for (uint32_t i = m; i-- > 0;) {
        uint32_t first = entries[i], second = entries[m + i];
        uint32_t crossing = code->crossing[first];
        /* m is odd, so the second passage is the opposite one */
        bool over_first = over != (i % 2 == 1);
        if (code->crossing[second] != crossing || code->sign[crossing] != sign ||
            (code->over[first] != 0) != over_first || (code->over[second] != 0) == over_first) {
            return false;
        }
    }
    return true;
}

static knot_factor factor_of(const knot_gauss_code *code, const uint16_t *entries, uint32_t m)
{
    knot_factor factor = {.wraps = (int32_t)(m / 2),
                          .handedness = code->sign[code->crossing[entries[0]]] > 0 ? 1 : -1,
                          .first = entries[0],
                          .strand_end = entries[m - 1],
                          .strand_begin = entries[m],
                          .last = entries[2 * m - 1]};
    return factor;
}

static bool are_nested(const knot_factors *factors)
{
    for (uint32_t i = 1; i < factors->count; i++) {
        const knot_factor *inner = &factors->factors[i - 1], *outer = &factors->factors[i];
        if (inner->first < outer->strand_end || inner->last > outer->strand_begin) {
            return false;
        }
    }
    return true;
}

/* Number of crossings of the block that ends on top, if the stack can contain it; otherwise 0. */
static uint32_t crossings_on_top(uint32_t first, uint32_t top)
{
    uint32_t m = top - first;
    return m >= MIN_CROSSINGS && m % 2 == 1 && top + 1 >= 2 * m ? m : 0;
}

static bool pop_blocks(const knot_gauss_code *code, knot_factors *factors)
{
    uint16_t *stack = code->scratch, *first = stack + 2 * (size_t)code->n, *seen = first + code->n;
    uint32_t height = 0;
    for (uint32_t i = 0; i < code->n; i++) {
        seen[i] = 0;
    }
    for (uint32_t entry = 0; entry < 2 * code->n; entry++) {
        uint32_t crossing = code->crossing[entry];
        if (crossing >= code->n || seen[crossing] == 2) {
            return false;
        }
        stack[height++] = (uint16_t)entry;
        if (++seen[crossing] == 1) {
            first[crossing] = (uint16_t)(height - 1);
            continue;
        }
        uint32_t m = crossings_on_top(first[crossing], height - 1);
        if (m == 0 || !is_block(code, stack + (height - 2 * m), m)) {
            continue;
        }
        if (factors->count == KNOT_THROWS) {
            return false;
        }
        height -= 2 * m;
        factors->factors[factors->count++] = factor_of(code, stack + height, m);
    }
    return height == 0;
}

bool vbss_knot_decompose(const knot_gauss_code *code, knot_factors *factors)
{
    *factors = (knot_factors){.count = 0};
    if (code->n > UINT16_MAX / 2 || !pop_blocks(code, factors)) {
        *factors = (knot_factors){.count = 0};
        return false;
    }
    factors->nested = are_nested(factors);
    return true;
}
