/* A hundred thousand configurations of knots that are known, from all families: nothing that is said is wrong, less
 * than one in a thousand is uncertain. */
#include "harness/harness.h"
#include "knot/derive.h"

enum { SEEDS = 42, FIRST_SEED = 10000, CONFIGURATIONS = 32, SIZES = 4 };

static void no_error_in_a_hundred_thousand(void **state)
{
    (void)state;
    static const uint32_t segments[SIZES] = {60, 120, 240, 300};
    judge j;
    judge_counts all = {0};
    uint64_t made = 0, asked = 0;
    judge_begin(&j);
    assert_true(judge_make(&j));
    for (int f = 0; f < FAMILIES; f++) {
        for (uint64_t seed = 0; seed < (uint64_t)SIZES * SEEDS; seed++, asked++) {
            made += derive_and_judge(&j, &families[f], FIRST_SEED + seed, segments[seed % SIZES],
                                     CONFIGURATIONS, &all);
        }
    }
    judge_end(&j);
    print_message("%llu of %llu cases made; %llu configurations heard: %llu wrong, %llu uncertain, "
                  "%llu certified, %llu ordered, %llu located; %llu without truth\n",
                  (unsigned long long)made, (unsigned long long)asked,
                  (unsigned long long)all.heard, (unsigned long long)all.wrong,
                  (unsigned long long)all.uncertain, (unsigned long long)all.certified,
                  (unsigned long long)all.ordered, (unsigned long long)all.located,
                  (unsigned long long)all.untrue);
    print_message("of %llu stacks of throws %llu recognised, %llu certified\n",
                  (unsigned long long)all.stacks, (unsigned long long)all.recognised,
                  (unsigned long long)all.proved);
    if (all.wrong > 0 || 1000 * all.uncertain > all.heard) {
        fail_msg("the first: %s", all.first);
    }
    assert_true(all.heard >= 100000);
    assert_int_equal(all.stacks, 97944);
    assert_int_equal(all.recognised, all.stacks);
    assert_true(all.proved >= 96241); /* as many as without the Jones polynomial */
    assert_true(1000 * all.certified >= 915 * all.heard);
    assert_true(1000 * all.ordered >= 915 * all.heard);
}

int test_detector_many(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(no_error_in_a_hundred_thousand),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
