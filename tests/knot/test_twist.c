/* Codes are taken apart into twist regions exactly when they are sums of them, however they are nested,
 * side by side or shifted; and nothing else is. */
#include "knot/sum_diagram.h"

#include <string.h>

#include "harness/harness.h"

/* ---- what must be found */

static uint32_t how_many(const knot_factors *factors, knot_factor like)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < factors->count; i++) {
        count += factors->factors[i].wraps == like.wraps &&
                 factors->factors[i].handedness == like.handedness;
    }
    return count;
}

static void check(const sum_diagram *d)
{
    knot_factors got;
    assert_true(vbss_knot_decompose(&d->code, &got));
    assert_true(sum_comes_apart(d));
    assert_int_equal(got.count, d->wanted.count);
    for (uint32_t i = 0; i < got.count; i++) {
        knot_factor f = got.factors[i];
        assert_int_equal(how_many(&got, f), how_many(&d->wanted, f));
        uint32_t owner = d->owner[f.first], of_it = 0, m = 2 * (uint32_t)f.wraps + 1;
        for (uint32_t k = f.first; k <= f.last; k++) {
            bool is_its = d->owner[k] == owner;
            assert_true(!is_its || k <= f.strand_end || k >= f.strand_begin);
            of_it += is_its;
            assert_true(k != f.strand_end || (is_its && of_it == m));
            assert_true(k != f.strand_begin || (is_its && of_it == m + 1));
        }
        assert_int_equal(of_it, 2 * m);
        assert_int_equal(d->owner[f.last], owner);
    }
    assert_int_equal(got.nested, sum_is_nest(d));
}

static void refuse(const sum_diagram *d)
{
    knot_factors got;
    assert_false(vbss_knot_decompose(&d->code, &got));
    assert_int_equal(got.count, 0);
    assert_false(got.nested);
}

static void no_crossing_is_unknot(void **state)
{
    (void)state;
    sum_diagram d;
    sum_begin(&d);
    check(&d);
}

static void twist_blocks_of_any_length_and_start(void **state)
{
    (void)state;
    sum_diagram d;
    for (uint32_t k = 1; k <= 100; k++) {
        for (int i = 0; i < 4; i++) {
            sum_begin(&d);
            sum_insert(&d, 0, k, i % 2 == 0 ? 1 : -1, i < 2);
            for (uint32_t j = 0; j < 4 * k + 2; j += k < 8 ? 1 : 2 * k) {
                check(&d);
                memset(d.owner, 0, sizeof d.owner);
                sum_shift(&d, 1);
            }
        }
    }
}

static void stack_is_read_from_inside_out(void **state)
{
    (void)state;
    sum_diagram d;
    knot_factors got;
    sum_stack(&d, 3, (const uint32_t[]){1, 1, 2}, (const int[]){1, -1, 1});
    check(&d);
    assert_true(vbss_knot_decompose(&d.code, &got));
    static const knot_factor wanted[] = {
        {2, 1, 6, 10, 11, 15}, {1, -1, 3, 5, 16, 18}, {1, 1, 0, 2, 19, 21}};
    assert_true(got.nested);
    assert_memory_equal(wanted, got.factors, sizeof wanted);
}

static void inner_knot_between_any_entries(void **state)
{
    (void)state;
    sum_diagram d;
    knot_factors got;
    for (uint32_t at = 0; at <= 10; at++) {
        sum_begin(&d);
        sum_insert(&d, 0, 2, 1, true);
        sum_insert(&d, at, 1, -1, false);
        check(&d);
        assert_true(vbss_knot_decompose(&d.code, &got));
        assert_int_equal(got.nested, at == 5);
        assert_int_equal(got.factors[at == 10].handedness, -1);
    }
}

static void sums_in_all_nestings(harness_source *source, void *user)
{
    (void)user;
    sum_diagram d;
    sum_begin(&d);
    uint32_t count = 1 + harness_draw_below(source, KNOT_THROWS);
    bool middle = harness_draw_below(source, 3) == 0;
    for (uint32_t i = 0; i < count; i++) {
        uint32_t at = middle ? d.code.n : harness_draw_below(source, 2 * d.code.n + 1);
        uint32_t wraps = 1 + harness_draw_below(source, 4);
        int handedness = harness_draw_below(source, 2) == 0 ? 1 : -1;
        sum_insert(&d, at, wraps, handedness, harness_draw_below(source, 2) == 0);
    }
    check(&d);
    for (uint32_t i = 0; i < 3; i++) {
        sum_shift(&d, harness_draw_below(source, 2 * d.code.n));
        check(&d);
    }
}

static void sums_are_decomposed(void **state)
{
    (void)state;
    harness_property("sums", 3000, sums_in_all_nestings, NULL);
}

static void more_than_eight_are_rejected(void **state)
{
    (void)state;
    sum_diagram d;
    sum_begin(&d);
    for (uint32_t i = 0; i <= KNOT_THROWS; i++) {
        sum_insert(&d, i % 2 == 0 ? 0 : d.code.n, 1, 1, true);
        if (i < KNOT_THROWS) {
            check(&d);
        } else {
            refuse(&d);
        }
    }
}

/* ---- what must be refused */

typedef struct word {
    uint32_t n;
    int letters[12];
    int8_t signs[6];
} word;

static const word others[] = {
    {4, {-1, 2, -3, 1, -4, 3, -2, 4}, {1, 1, -1, -1}},              /* figure eight */
    {5, {-1, 2, -3, 1, -4, 5, -2, 3, -5, 4}, {1, 1, 1, 1, 1}},      /* 5_2 */
    {5, {-1, 2, -3, 1, -4, 5, -2, 3, -5, 4}, {-1, -1, -1, -1, -1}}, /* its mirror image */
    {1, {1, -1}, {1}},                                              /* a kink */
    {2, {1, 2, -1, -2}, {1, 1}},                                    /* even, virtual */
    {2, {1, -2, 2, -1}, {1, -1}},                                   /* two kinks */
    {2, {1, -2, -1, 2}, {1, 1}},                     /* alternating if run through twice */
    {3, {1, -2, 3, -3, 2, -1}, {1, 1, 1}},           /* antiparallel */
    {3, {1, 2, 3, -1, -2, -3}, {1, 1, 1}},           /* two strands that lie side by side */
    {3, {1, -2, -3, -1, 2, 3}, {1, 1, 1}},           /* one crossing changed */
    {3, {1, -2, 3, -1, 2, -3}, {1, 1, -1}},          /* signs of no plane diagram */
    {3, {1, -2, 3, -2, 1, -3}, {1, 1, 1}},           /* crossed */
    {4, {1, -2, 3, -4, -1, 2, -3, 4}, {1, 1, 1, 1}}, /* four crossings */
    {6, {1, 2, 3, 4, 5, 6, -1, -2, -3, -4, -5, -6}, {1, 1, 1, 1, 1, 1}},
};

static void other_codes_are_rejected_alone_and_in_sums(void **state)
{
    (void)state;
    sum_diagram d;
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        const word *w = &others[i];
        sum_from_word(&d, w->n, w->letters, w->signs);
        for (uint32_t k = 0; k < 2 * w->n; k++) {
            refuse(&d);
            assert_false(sum_comes_apart(&d));
            sum_shift(&d, 1);
        }
        for (uint32_t at = 0; at <= 2 * w->n; at++) {
            sum_from_word(&d, w->n, w->letters, w->signs);
            sum_insert(&d, at, 1 + at % 2, 1, at % 3 == 0);
            refuse(&d);
            sum_insert(&d, at + 3, 1, -1, true);
            refuse(&d);
        }
    }
}

static void invalid_codes_are_rejected(void **state)
{
    (void)state;
    sum_diagram d;
    sum_from_word(&d, 3, (const int[]){1, -2, 3, -1, 2, 1}, (const int8_t[]){1, 1, 1});
    refuse(&d); /* three times */
    d.crossing[5] = UINT16_MAX;
    refuse(&d); /* no such crossing */
    sum_from_word(&d, 6, (const int[]){1, -2, 3, -1, 2, -3, 1, -2, 3, -1, 2, -3},
                  (const int8_t[]){1, 1, 1, 1, 1, 1});
    refuse(&d); /* the same block twice */
}

static void every_single_damage_is_handled(void **state)
{
    (void)state;
    sum_diagram d;
    sum_stack(&d, 4, (const uint32_t[]){1, 2, 1, 3}, (const int[]){1, -1, 1, 1});
    sum_insert(&d, 5, 1, -1, true);
    check(&d);
    uint32_t entries = 2 * d.code.n, slid = 0;
    for (uint32_t i = 0; i < d.code.n; i++) {
        d.sign[i] = (int8_t)-d.sign[i];
        refuse(&d);
        d.sign[i] = (int8_t)-d.sign[i];
    }
    for (uint32_t i = 0; i < entries; i++) {
        for (uint32_t j = 0; j < i; j++) { /* where i and j are one crossing it is changed */
            sum_swap(&d, i, j);
            knot_factors got; /* a few times a whole block was only moved past an entry */
            bool is_sum = sum_comes_apart(&d);
            assert_int_equal(vbss_knot_decompose(&d.code, &got), is_sum);
            slid += is_sum;
            sum_swap(&d, i, j);
        }
        d.over[i] = !d.over[i];
        refuse(&d);
        d.over[i] = !d.over[i];
    }
    assert_in_range(slid, 1, 10);
    check(&d);
}

/* Few crossings and few letters apart: some of them are blocks. */
static void random_codes(harness_source *source, void *user)
{
    uint32_t *taken = user, n = 3 + harness_draw_below(source, 6);
    sum_diagram d;
    knot_factors got;
    sum_begin(&d);
    d.code.n = n;
    bool over = harness_draw_below(source, 2) == 0, alternates = harness_draw_below(source, 4) != 0;
    bool halves = harness_draw_below(source, 2) == 0;
    for (uint32_t i = 0; i < 2 * n; i++) {
        d.crossing[i] = (uint16_t)(i % n);
        d.over[i] = alternates ? over != (i % 2 == 1) : harness_draw_below(source, 2) == 0;
    }
    for (uint32_t i = 0; i < n; i++) {
        d.sign[i] = harness_draw_below(source, 8) == 0 ? -1 : 1;
    }
    for (uint32_t swaps = harness_draw_below(source, halves ? 3 : 30); swaps > 0; swaps--) {
        uint32_t i = harness_draw_below(source, 2 * n), j = harness_draw_below(source, 2 * n);
        sum_swap(&d, i, j);
    }
    bool wanted = sum_comes_apart(&d);
    assert_int_equal(vbss_knot_decompose(&d.code, &got), wanted);
    *taken += wanted;
}

static void random_codes_match_definition(void **state)
{
    (void)state;
    uint32_t taken = 0;
    harness_property("random codes", 20000, random_codes, &taken);
    assert_in_range(taken, 100, 15000);
}

int test_twist(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_crossing_is_unknot),
        cmocka_unit_test(twist_blocks_of_any_length_and_start),
        cmocka_unit_test(stack_is_read_from_inside_out),
        cmocka_unit_test(inner_knot_between_any_entries),
        harness_test(sums_are_decomposed),
        cmocka_unit_test(more_than_eight_are_rejected),
        cmocka_unit_test(other_codes_are_rejected_alone_and_in_sums),
        cmocka_unit_test(invalid_codes_are_rejected),
        cmocka_unit_test(every_single_damage_is_handled),
        harness_test(random_codes_match_definition),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
