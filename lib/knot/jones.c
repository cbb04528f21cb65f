/* The Jones polynomial V(t), t = A^-4, as its values at fixed elements of a prime field.
 *
 * V = (-A^3)^-w <D> / <O>, with the bracket <D> and the writhe w of a diagram D, and the bracket
 * <O> of a loop. Different values prove different polynomials, and so different knots. The values of a
 * connected sum are the products of those of its summands. T(2, 2 k + 1) has
 * V = t^k (1 + t^2 - t^3 + t^4 - ... - t^(2 k + 1)): V. F. R. Jones, "A polynomial invariant for
 * knots via von Neumann algebras", Bulletin of the American Mathematical Society 12 (1985). */
#include "knot/knot.h"
#include "knot/prime_field.h"

/* Values of A: primitive roots modulo the prime, so that no power of t in use here is 1. */
static const uint32_t points[KNOT_JONES_POINTS] = {7, 16807, 48271, 69621};

void vbss_knot_jones_begin(knot_bracket *b, const knot_gauss_code *code, knot_ops *budget)
{
    *budget -= 1000 + 4 * (knot_ops)code->n; /* with vbss_knot_jones_end */
    vbss_knot_bracket_begin(b, code, points);
}

bool vbss_knot_jones_end(const knot_bracket *b, knot_invariants *invariants)
{
    uint32_t right = 0;
    for (uint32_t i = 0; i < b->crossing_count; i++) {
        right += b->crossings[i].sign > 0 ? 1 : 0;
    }
    uint32_t left = b->crossing_count - right;
    for (uint32_t i = 0; i < KNOT_JONES_POINTS && !b->is_full; i++) {
        uint32_t minus_cube = field_negative(field_power(b->a[i], 3));
        uint32_t divisor = field_multiply(field_power(minus_cube, right), b->loop[i]);
        uint32_t bracket = field_multiply(b->pairings[0].value[i], field_power(minus_cube, left));
        invariants->jones[i] = field_multiply(bracket, field_inverse(divisor));
    }
    invariants->jones_known = !b->is_full;
    return invariants->jones_known;
}

static uint32_t jones_of_factor(uint32_t t, uint32_t wraps)
{
    uint32_t minus_t = field_negative(t), sum = 0;
    for (uint32_t i = 0; i < 2 * wraps; i++) {
        sum = field_multiply(field_add(sum, 1), minus_t);
    }
    sum = field_add(field_multiply(sum, minus_t), 1);
    return field_multiply(field_power(t, wraps), sum);
}

void vbss_knot_jones_of(const knot_factors *factors, knot_invariants *invariants)
{
    for (uint32_t i = 0; i < KNOT_JONES_POINTS; i++) {
        uint32_t inverse_t = field_power(points[i], 4), t = field_inverse(inverse_t);
        uint32_t product = 1;
        for (uint32_t k = 0; k < factors->count; k++) {
            const knot_factor *f = &factors->factors[k];
            uint32_t value = jones_of_factor(f->handedness > 0 ? t : inverse_t, (uint32_t)f->wraps);
            product = field_multiply(product, value);
        }
        invariants->jones[i] = product;
    }
    invariants->jones_known = true;
}
