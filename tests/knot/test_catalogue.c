/* Invariants of sums of throws are those of the table in the reference, and tell every sum of at most eight of them. */
#include <stdlib.h>

#include "base/elementary.h"
#include "knot/knot.h"

#include "harness/harness.h"

/* Throws as wraps times handedness. */
static knot_factors sum_of(const int *throws, uint32_t count)
{
    knot_factors factors = {.count = count};
    for (uint32_t i = 0; i < count; i++) {
        int k = throws[i] < 0 ? -throws[i] : throws[i];
        factors.factors[i] = (knot_factor){.wraps = k, .handedness = throws[i] < 0 ? -1 : 1};
    }
    return factors;
}

typedef struct row {
    int throws[3];
    uint32_t count;
    int determinant, signature, tristram, v2, v3;
} row;

static const row table[] = {
    {{0}, 0, 1, 0, 0, 0, 0},           {{1}, 1, 3, -2, 0, 1, 1},
    {{2}, 1, 5, -4, -2, 3, 5},         {{3}, 1, 7, -6, -2, 6, 14},
    {{1, -1}, 2, 9, 0, 0, 2, 0},       {{1, 1}, 2, 9, -4, 0, 2, 2},
    {{2, -1}, 2, 15, -2, -2, 4, 4},    {{2, 1}, 2, 15, -6, -2, 4, 6},
    {{2, -2}, 2, 25, 0, 0, 6, 0},      {{2, 2}, 2, 25, -8, -4, 6, 10},
    {{1, -1, 1}, 3, 27, -2, 0, 3, 1},  {{1, 1, 1}, 3, 27, -6, 0, 3, 3},
    {{2, -1, 1}, 3, 45, -4, -2, 5, 5}, {{2, -1, -1}, 3, 45, 0, -2, 5, 3},
    {{2, 1, 1}, 3, 45, -8, -2, 5, 7},
};

static void invariants_match_table(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        const row *r = &table[i];
        for (int mirror = 1; mirror >= -1; mirror -= 2) {
            knot_factors factors = sum_of(r->throws, r->count);
            for (uint32_t k = 0; k < r->count; k++) {
                factors.factors[k].handedness *= mirror;
            }
            knot_invariants got = vbss_knot_invariants_of(&factors);
            assert_true(got.known);
            assert_int_equal(got.determinant, r->determinant);
            assert_int_equal(got.v2, r->v2);
            assert_int_equal(got.v3, mirror * r->v3);
            assert_int_equal(got.signature, mirror * r->signature);
            assert_int_equal(got.signature_tristram, mirror * r->tristram);
        }
    }
}

/* Counting roots up to the angle that the signature is taken at. */
static void signatures_of_many_wraps(void **state)
{
    (void)state;
    const double theta = 2.0 * vbss_acos(KNOT_X_TRISTRAM_10000 / 10000.0);
    const double pi = 2.0 * vbss_acos(0.0);
    expect_near(0.27, theta / pi, 1e-5); /* as the header of knots documents */
    for (int k = 1; k <= 511; k++) {
        knot_factors factors = sum_of(&k, 1);
        int roots = 0;
        for (int odd = 1; odd < 2 * k + 1; odd += 2) {
            roots += pi * odd / (2 * k + 1) < theta;
        }
        knot_invariants got = vbss_knot_invariants_of(&factors);
        assert_int_equal(got.signature_tristram, -2 * roots);
        assert_int_equal(got.signature, -2 * k);
        assert_int_equal(got.determinant, 2 * k + 1);
    }
}

static void large_determinant_is_capped(void **state)
{
    (void)state;
    knot_factors factors = {.count = KNOT_THROWS};
    for (uint32_t i = 0; i < KNOT_THROWS; i++) {
        factors.factors[i] = (knot_factor){.wraps = 99, .handedness = 1};
    }
    assert_int_equal(vbss_knot_invariants_of(&factors).determinant, 2459374191553118401);
    factors.factors[0].wraps = 999;
    assert_int_equal(vbss_knot_invariants_of(&factors).determinant, INT64_MAX);
}

static void each_invariant_distinguishes(void **state)
{
    (void)state;
    const knot_factors factors = sum_of((const int[]){2, -1, 1}, 3);
    const knot_invariants same = vbss_knot_invariants_of(&factors);
    knot_invariants others[6];
    for (int i = 0; i < 6; i++) {
        others[i] = same;
    }
    others[0].determinant += 2;
    others[1].v2++;
    others[2].v3++;
    others[3].signature += 2;
    others[4].signature_tristram += 2;
    others[5].known = false;
    assert_true(vbss_knot_invariants_same(same, same));
    for (int i = 0; i < 6; i++) {
        knot_factors got;
        assert_false(vbss_knot_invariants_same(same, others[i]));
        assert_false(vbss_knot_invariants_same(others[i], same));
        assert_false(vbss_knot_match(others[i], &got));
        assert_int_equal(got.count, 0);
    }
    assert_false(vbss_knot_invariants_same(others[5], others[5]));
}

/* Modulo 2^31 - 1, of either sign. */
static void large_determinants_compare_as_computed(void **state)
{
    (void)state;
    const int64_t prime = 2147483647;
    knot_invariants a = {.determinant = 3, .known = true}, b = a;
    b.determinant = prime + 3;
    assert_true(vbss_knot_invariants_same(a, b));
    b.determinant = 5 * prime - 3;
    assert_true(vbss_knot_invariants_same(a, b));
    b.determinant = prime + 5;
    assert_false(vbss_knot_invariants_same(a, b));
}

/* ---- the way back */

enum { SUMS = 3003 };

/* All multisets of at most eight; throws in the order in which they are to be told. */
static uint32_t all_sums(knot_factors *sums)
{
    static const int throws[6] = {3, -3, 2, -2, 1, -1};
    uint32_t count = 0;
    for (uint32_t length = 0; length <= KNOT_THROWS; length++) {
        uint32_t kinds[KNOT_THROWS] = {0};
        for (;;) {
            int one[KNOT_THROWS];
            for (uint32_t i = 0; i < length; i++) {
                one[i] = throws[kinds[i]];
            }
            assert_true(count < SUMS);
            sums[count++] = sum_of(one, length);
            uint32_t at = length; /* the next sequence that does not descend */
            while (at > 0 && kinds[at - 1] == 5) {
                at--;
            }
            if (at == 0) {
                break;
            }
            uint32_t next = kinds[at - 1] + 1;
            for (uint32_t i = at - 1; i < length; i++) {
                kinds[i] = next;
            }
        }
    }
    return count;
}

static void sums_of_eight_are_identified(void **state)
{
    (void)state;
    knot_factors *sums = calloc(SUMS, sizeof *sums);
    assert_non_null(sums);
    assert_int_equal(all_sums(sums), SUMS);
    for (uint32_t i = 0; i < SUMS; i++) {
        knot_factors got;
        knot_invariants invariants = vbss_knot_invariants_of(&sums[i]);
        assert_true(vbss_knot_match(invariants, &got));
        assert_false(got.nested);
        assert_memory_equal(&sums[i], &got, sizeof got);
        for (uint32_t j = 0; j < i; j++) {
            assert_false(vbss_knot_invariants_same(invariants, vbss_knot_invariants_of(&sums[j])));
        }
    }
    free(sums);
}

static void other_knots_are_rejected(void **state)
{
    (void)state;
    static const knot_invariants others[] = {
        {.determinant = 5, .v2 = -1, .known = true},                          /* figure eight */
        {.determinant = 7, .v2 = 2, .v3 = 3, .signature = -2, .known = true}, /* 5_2 */
        {.determinant = 9,
         .v2 = 10,
         .v3 = 30,
         .signature = -8,
         .signature_tristram = -2,
         .known = true}, /* T(2, 9) */
        {.determinant = 11,
         .v2 = 15,
         .v3 = 55,
         .signature = -10,
         .signature_tristram = -2,
         .known = true},                             /* T(2, 11) */
        {.determinant = 1, .v2 = -1, .known = true}, /* the unknot's determinant */
        {.determinant = 1},
        {.known = true},
        {.determinant = 2, .known = true},
        {.determinant = INT64_MAX, .known = true},
        {.determinant = -3, .v2 = 1, .v3 = 1, .signature = -2, .known = true},
    };
    knot_factors got;
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        assert_false(vbss_knot_match(others[i], &got));
        assert_int_equal(got.count, 0);
    }
    knot_invariants nine = {.determinant = 1, .v2 = 9, .v3 = 9, .signature = -18, .known = true};
    for (int i = 0; i < 9; i++) {
        nine.determinant *= 3;
    }
    assert_false(vbss_knot_match(nine, &got));
}

int test_catalogue(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(invariants_match_table),
        cmocka_unit_test(signatures_of_many_wraps),
        cmocka_unit_test(large_determinant_is_capped),
        cmocka_unit_test(each_invariant_distinguishes),
        cmocka_unit_test(large_determinants_compare_as_computed),
        cmocka_unit_test(sums_of_eight_are_identified),
        cmocka_unit_test(other_knots_are_rejected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
