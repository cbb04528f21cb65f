/* Blades that close on a square drawn tight, with about the default limit of work. */
#include "scene/cut_throw.h"

static void square_knot_cut_pauses_little(void **state)
{
    (void)state;
    static const double shares[5] = {0.92, 0.96, 1.0, 1.04, 1.08};
    const cut_case bars = {KNOT_SQUARE, true, 0.09, 4, 20, 0.1};
    cut_outcome found = cut_throw_medians(&bars, shares, 5);
    cut_expect_within(&found, &bars);
}

int test_shears_square(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(square_knot_cut_pauses_little),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
