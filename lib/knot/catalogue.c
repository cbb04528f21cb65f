/* Invariants of connected sums of torus knots T(2, 2 k + 1), and the inverse: the sum with given
 * invariants.
 *
 * Determinants multiply; the other invariants add. A sum of a, b and c knots with k = 1, 2, 3 has
 * v2 = a + 3 b + 6 c and the determinant 3^a 5^b 7^c. Let x, y and z be the number of right-handed
 * minus left-handed knots of each kind. Then v3 = x + 5 y + 14 z, -sigma / 2 = x + 2 y + 3 z, and
 * at X_TRISTRAM y + z. These three equations have one solution, so the invariants distinguish all
 * sums. */
#include "knot/knot.h"
#include "knot/prime_field.h"

#include <string.h>

/* 1e9 theta / pi of X_TRISTRAM: 2 acos(0.9114) / pi = 0.27000506897. No odd / (2 k + 1) with k below
 * 2048 is nearer than 9e-8. */
#define TRISTRAM_1E9 270005069

enum { MAX_WRAPS = 3 };

/* The roots exp(i theta) of the Alexander polynomial of T(2, 2 k + 1) are at odd multiples of pi /
 * (2 k + 1) below pi. The signature at theta is 0 near 0 and decreases by 2 at each root. */
static int32_t roots_before_tristram(int32_t wraps)
{
    /* there are (floor(x) + 1) / 2 odd numbers up to x */
    int64_t below = ((2 * (int64_t)wraps + 1) * TRISTRAM_1E9) / 1000000000;
    return (int32_t)((below + 1) / 2);
}

static int64_t capped_product(int64_t a, int64_t b)
{
    return a > INT64_MAX / b ? INT64_MAX : a * b;
}

knot_invariants vbss_knot_invariants_of(const knot_factors *factors)
{
    knot_invariants sum = {.determinant = 1, .known = true};
    for (uint32_t i = 0; i < factors->count; i++) {
        int64_t k = factors->factors[i].wraps;
        int32_t s = factors->factors[i].handedness;
        sum.determinant = capped_product(sum.determinant, 2 * k + 1);
        sum.v2 += k * (k + 1) / 2;
        sum.v3 += s * (k * (k + 1) * (2 * k + 1) / 6);
        sum.signature -= 2 * s * factors->factors[i].wraps;
        sum.signature_tristram -= 2 * s * roots_before_tristram(factors->factors[i].wraps);
    }
    return sum;
}

/* The determinant as determinant.c computes it: from 2^30 on only its remainder is known. */
static int64_t reduce_determinant(int64_t determinant)
{
    const int64_t prime = FIELD_PRIME, rest = determinant % prime;
    return rest > prime / 2 ? prime - rest : rest;
}

bool vbss_knot_invariants_same(knot_invariants a, knot_invariants b)
{
    return a.known && b.known &&
           reduce_determinant(a.determinant) == reduce_determinant(b.determinant) && a.v2 == b.v2 &&
           a.v3 == b.v3 && a.signature == b.signature &&
           a.signature_tristram == b.signature_tristram &&
           (!a.jones_known || !b.jones_known || memcmp(a.jones, b.jones, sizeof a.jones) == 0);
}

/* ---- inverse */

/* Numbers of knots of each number of wraps in the determinant. Returns false if there is no such
 * sum. */
static bool count_wraps(int64_t determinant, uint32_t counts[MAX_WRAPS])
{
    uint32_t count = 0;
    for (uint32_t k = 1; k <= MAX_WRAPS; k++) {
        int64_t factor = 2 * k + 1;
        counts[k - 1] = 0;
        while (determinant > 1 && determinant % factor == 0 && count <= KNOT_THROWS) {
            determinant /= factor;
            counts[k - 1]++;
            count++;
        }
    }
    return determinant == 1 && count <= KNOT_THROWS;
}

static void add_factors(knot_factors *factors, uint32_t count, int32_t wraps, int32_t handedness)
{
    for (uint32_t i = 0; i < count; i++) {
        factors->factors[factors->count++] =
            (knot_factor){.wraps = wraps, .handedness = handedness};
    }
}

bool vbss_knot_match(knot_invariants invariants, knot_factors *factors)
{
    uint32_t counts[MAX_WRAPS];
    *factors = (knot_factors){.count = 0};
    if (!count_wraps(invariants.determinant, counts)) {
        return false;
    }
    uint32_t choices = (counts[0] + 1) * (counts[1] + 1) * (counts[2] + 1);
    for (uint32_t choice = 0; choice < choices; choice++) {
        *factors = (knot_factors){.count = 0};
        for (uint32_t k = MAX_WRAPS, rest = choice; k > 0; k--) {
            uint32_t count = counts[k - 1], left = rest % (count + 1);
            rest /= count + 1;
            add_factors(factors, count - left, (int32_t)k, 1);
            add_factors(factors, left, (int32_t)k, -1);
        }
        if (vbss_knot_invariants_same(vbss_knot_invariants_of(factors), invariants)) {
            return true;
        }
    }
    *factors = (knot_factors){.count = 0};
    return false;
}
