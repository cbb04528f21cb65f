/* Blades that close on a throw drawn tight, and go through all strands of it while hands go on pulling. Medians of runs
 * that differ a little in their limit of work or their pull. */
#include "scene/cut_throw.h"

enum { LIMITS = 9 };
static const double shares[LIMITS] = {0.88, 0.92, 0.96, 1.0, 1.04,
                                      1.08, 1.12, 1.2,  1.4}; /* of the default */

static void tight_throw_is_cut_through(void **state)
{
    (void)state;
    enum { PULLS = 5 };
    static const double pulls[PULLS] = {0.96, 0.98, 1.0, 1.02, 1.04};
    const cut_case cases[] = {
        {KNOT_OVERHAND, false, 0.06, 3, 0, 0.0},
        {KNOT_DOUBLE_OVERHAND, false, 0.06, 3, 0, 0.0},
        {KNOT_SQUARE, false, 0.09, 4, 4, 0.0}}; /* squeezed before it is cut */
    for (int k = 0; k < 3; k++) {
        cut_outcome found = cut_throw_medians(&cases[k], pulls, PULLS);
        cut_expect_within(&found, &cases[k]);
    }
}

static void cut_depends_little_on_budget(void **state)
{
    (void)state;
    const cut_case cases[] = {{KNOT_OVERHAND, true, 0.06, 3, 0, 0.002},
                              {KNOT_DOUBLE_OVERHAND, true, 0.06, 3, 0, 0.04},
                              {KNOT_SQUARE, true, 0.09, 4, 20, 0.1}};
    for (int k = 0; k < 3; k++) {
        cut_outcome found = cut_throw_medians(&cases[k], shares, LIMITS);
        cut_expect_within(&found, &cases[k]);
    }
}

int test_shears_throws(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tight_throw_is_cut_through),
        cmocka_unit_test(cut_depends_little_on_budget),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
