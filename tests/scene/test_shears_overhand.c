/* Blades that close on an overhand drawn tight, with the default limit of work. What it waits is a known
 * limit: docs/known-limits.md. */
#include "scene/cut_throw.h"

static void an_overhand_is_cut_through_with_known_waiting(void **state)
{
    (void)state;
    const cut_case bars = {KNOT_OVERHAND, true, 0.06, 3, 0, 0.0};
    cut_expect_within_known(&bars, 0.004);
}

int test_shears_overhand(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_overhand_is_cut_through_with_known_waiting),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
