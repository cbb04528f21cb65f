/* Blades that close on a double overhand drawn tight, with the default limit of work. What it waits is a known
 * limit: docs/explanation/known-limits.md. */
#include "scene/cut_throw.h"

static void double_overhand_cut_pauses_as_documented(void **state)
{
    (void)state;
    const cut_case bars = {KNOT_DOUBLE_OVERHAND, true, 0.06, 3, 0, 0.04};
    cut_expect_within_known(&bars, 0.06);
}

int test_shears_double(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(double_overhand_cut_pauses_as_documented),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
