/* What detectors say of threads whose knot is known by construction: never anything wrong, hardly ever nothing, and nearly
 * always with a proof and the order. */
#include <string.h>

#include "harness/harness.h"
#include "knot/derive.h"

enum { SEEDS = 12, CONFIGURATIONS = 10 };

/* The least number of cases made, of 240, and least shares of what is heard, per mille: measured (938 to 944), less a
 * margin. One family of nineteen is of knots that cannot be certified. */
typedef struct smallest {
    uint32_t segments, made, certified, ordered;
} smallest;

static void judge_family(judge *j, const family *f, uint32_t segments, judge_counts *all,
                         uint32_t *made)
{
    judge_counts counts = {0};
    for (uint64_t seed = 0; seed < SEEDS; seed++) {
        *made += derive_and_judge(j, f, seed, segments, CONFIGURATIONS, &counts);
    }
    print_message("  %-20s %5llu heard, %llu certified, %llu ordered, %llu uncertain, %llu wrong; "
                  "%llu without truth\n",
                  f->name, (unsigned long long)counts.heard, (unsigned long long)counts.certified,
                  (unsigned long long)counts.ordered, (unsigned long long)counts.uncertain,
                  (unsigned long long)counts.wrong, (unsigned long long)counts.untrue);
    judge_add_up(all, &counts);
}

static void nothing_is_wrong_at(const smallest *l)
{
    judge j;
    judge_counts all = {0};
    uint32_t made = 0;
    judge_begin(&j);
    assert_true(judge_make(&j));
    print_message("%u segments\n", l->segments);
    for (int f = 0; f < FAMILIES; f++) {
        judge_family(&j, &families[f], l->segments, &all, &made);
    }
    judge_end(&j);
    if (all.wrong > 0 || 1000 * all.uncertain > all.heard) {
        fail_msg("%llu wrong, %llu uncertain; the first: %s", (unsigned long long)all.wrong,
                 (unsigned long long)all.uncertain, all.first);
    }
    assert_true(made >= l->made);
    assert_true(1000 * all.certified >= l->certified * all.heard);
    assert_true(1000 * all.ordered >= l->ordered * all.heard);
}

static void no_error_at_60_segments(void **state)
{
    (void)state;
    const smallest l = {60, 210, 925, 925};
    nothing_is_wrong_at(&l);
}

static void no_error_at_120_segments(void **state)
{
    (void)state;
    const smallest l = {120, 235, 930, 930};
    nothing_is_wrong_at(&l);
}

static void no_error_at_240_segments(void **state)
{
    (void)state;
    const smallest l = {240, 235, 930, 930};
    nothing_is_wrong_at(&l);
}

static void no_error_at_300_segments(void **state)
{
    (void)state;
    const smallest l = {300, 235, 930, 930};
    nothing_is_wrong_at(&l);
}

/* ---- the judge is not blind */

static void expect_fault(const judge_saying *saying, const family_case *truth)
{
    assert_non_null(judge_fault(saying, truth, false));
}

/* Each number that is said, wrong by one, is found out. */
static void judge_finds_every_fault(void **state)
{
    (void)state;
    static family_case made;
    judge j;
    judge_saying said;
    judge_begin(&j);
    assert_true(judge_make(&j));
    assert_true(family_named("stray")->make(36, 240, &made)); /* three throws and one in the tail */
    vbss_knot_input in = judge_input_of(&made.line);
    expect_ok(judge_hear(&j, &in, &said));
    judge_end(&j);
    assert_null(judge_fault(&said, &made, false));
    assert_int_equal(made.throws, 3);
    assert_true(judge_is_ordered(&said) && said.state.throw_count == 4);
    int64_t *wide[] = {&said.state.determinant, &said.state.v2, &said.state.v3};
    int32_t *narrow[] = {&said.state.signature, &said.state.signature_tristram, &said.state.name};
    for (int i = 0; i < 3; i++) {
        ++*wide[i];
        expect_fault(&said, &made);
        --*wide[i];
        ++*narrow[i];
        expect_fault(&said, &made);
        --*narrow[i];
    }
    for (uint32_t i = 0; i < 4; i++) {
        vbss_knot_throw *t = &said.throws[i], kept = *t;
        t->wraps++;
        expect_fault(&said, &made);
        *t = kept;
        t->handedness = -t->handedness;
        expect_fault(&said, &made);
        *t = kept;
        t->flags ^= VBSS_KNOT_THROW_STRAY;
        expect_fault(&said, &made);
        *t = kept;
        t->long_places[1] = 1e3;
        expect_fault(&said, &made);
        *t = kept;
    }
    said.state.faults ^= VBSS_KNOT_FAULT_GRANNY;
    expect_fault(&said, &made);
    said.state.faults ^= VBSS_KNOT_FAULT_GRANNY;
    said.notation[0]++;
    expect_fault(&said, &made);
    said.notation[0]--;
    assert_null(judge_fault(&said, &made, false));
}

int test_detector_families(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(judge_finds_every_fault),  harness_test(no_error_at_60_segments),
        harness_test(no_error_at_120_segments), harness_test(no_error_at_240_segments),
        harness_test(no_error_at_300_segments),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
