/* Blades that close on a double overhand drawn tight, with the default limit of work. Known to fail: docs/contact.md. */
#include "scene/cut_throw.h"

static void a_double_overhand_is_cut_through_with_little_waiting(void **state)
{
    (void)state;
    const cut_case bars = {KNOT_DOUBLE_OVERHAND, true, 0.06, 3, 0, 0.04};
    cut_outcome found = cut_throw(&bars, 1.0);
    print_message("%.0f steps cut short, %.1f ms waited, fastest %.1f m/s\n", found.clamped,
                  1e3 * found.paused, found.fastest);
    cut_expect_within(&found, &bars);
}

int test_shears_double(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_double_overhand_is_cut_through_with_little_waiting),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
