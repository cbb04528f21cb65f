/* Degenerate queries without thickness, 100 000 a kind. */
#include "degenerate_check.h"

static void degenerate_sets_match_oracle(void **state)
{
    (void)state;
    expect_degenerate_sets_right(6700, 100);
}

int test_degenerate_many(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(degenerate_sets_match_oracle)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
