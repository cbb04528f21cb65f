/* Knots that all five invariants take for stacks of throws are never certified as such. They were found by a
 * search of random braids; Jones' polynomial tells them from the stacks. */
#include "knot/algebra_room.h"

typedef struct lookalike {
    const char *name;
    int word[16], letters;
    uint32_t throws; /* of the stack that it looks like */
    int64_t determinant;
} lookalike;

static const lookalike lookalikes[] = {
    {"10_99", {1, -2, -2, 1, -2, -2, 1, 1, -2, 1}, 10, 4, 81},
    {"like 1=1=1", {2, -3, -3, 1, -2, 1, 3, 1, -2, -3, 2}, 11, 3, 27},
    {"like 1=1", {2, -3, 1, -2, -3, 1, -2, -3, -3, 1, 2}, 11, 2, 9},
    {"like 2=1=1", {-3, -3, 1, 1, -2, -2, -1, 1, 1, 2, -3, -1, -3, 2, -3}, 15, 3, 45},
};
enum { LOOKALIKES = sizeof lookalikes / sizeof lookalikes[0] };

static knot_invariants invariants_of(const knot_gauss_code *code)
{
    algebra_room *room = algebra_room_make(64);
    knot_invariants v = {.known = true};
    knot_ops work = 0;
    v.determinant = vbss_knot_determinant(&room->algebra, code, &work);
    vbss_knot_vassiliev(code, &v.v2, &v.v3, &work);
    assert_true(
        vbss_knot_signature(&room->algebra, code, KNOT_X_ORDINARY_10000, &v.signature, &work));
    assert_true(vbss_knot_signature(&room->algebra, code, KNOT_X_TRISTRAM_10000,
                                    &v.signature_tristram, &work));
    algebra_room_end(room);
    return v;
}

static void invariants_cannot_separate_lookalikes(void **state)
{
    (void)state;
    for (int i = 0; i < LOOKALIKES; i++) {
        const lookalike *l = &lookalikes[i];
        knot_gauss_code *code = codes_make();
        knot_factors factors;
        assert_true(codes_braid(code, l->word, (size_t)l->letters));
        knot_invariants v = invariants_of(code);
        assert_int_equal(l->determinant, v.determinant);
        assert_true(vbss_knot_match(v, &factors));
        assert_int_equal(l->throws, factors.count);
        codes_free(code);
    }
}

/* Of the braid, and of thousands of other diagrams of it. */
static void no_lookalike_unties(void **state)
{
    (void)state;
    knot_gauss_code *code = codes_make(), *spare = codes_make();
    vbss_random random;
    vbss_random_seed(&random, 7, 1);
    for (int i = 0; i < LOOKALIKES * 400; i++) {
        const lookalike *l = &lookalikes[i % LOOKALIKES];
        uint32_t tries = KNOT_TRIES;
        knot_ops work = 0;
        knot_factors factors;
        assert_true(codes_braid(code, l->word, (size_t)l->letters));
        assert_false(vbss_knot_decompose(code, &factors));
        codes_grow(code, &random, 20 + vbss_random_below(&random, 40));
        if (vbss_random_below(&random, 2) == 0) {
            codes_mirror(code);
        }
        vbss_knot_gauss_code_simplify(code, &work);
        assert_false(vbss_knot_decompose(code, &factors));
        while (vbss_knot_gauss_code_untangle(code, spare, &tries, &work)) {
        }
        assert_false(vbss_knot_decompose(code, &factors));
    }
    codes_free(code);
    codes_free(spare);
}

int test_lookalikes(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(invariants_cannot_separate_lookalikes),
        cmocka_unit_test(no_lookalike_unties),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
