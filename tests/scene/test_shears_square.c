/* Blades that close on a square drawn tight, with the default limit of work. */
#include "scene/cut_throw.h"

static void square_knot_cut_pauses_little(void **state)
{
    (void)state;
    const cut_case bars = {KNOT_SQUARE, true, 0.09, 4, 20, 0.1};
    cut_outcome found = cut_throw(&bars, 1.0);
    print_message("%.0f steps cut short, %.1f ms waited, fastest %.1f m/s\n", found.clamped,
                  1e3 * found.paused, found.fastest);
    cut_expect_within(&found, &bars);
}

int test_shears_square(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(square_knot_cut_pauses_little),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
