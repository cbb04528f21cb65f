/* Blades that close on a throw drawn tight, and go through all strands of it while hands go on pulling.
 *
 * With a limit of work each run is one of many, which a limit that is a little other would show: the median of nine is
 * looked at. What the default keeps of its bars for each: test_shears_overhand, test_shears_double, test_shears_square. */
#include <stdlib.h>

#include "scene/cut_throw.h"

enum { LIMITS = 9 };
static const double shares[LIMITS] = {0.88, 0.92, 0.96, 1.0, 1.04,
                                      1.08, 1.12, 1.2,  1.4}; /* of the default */

static void tight_throw_is_cut_through(void **state)
{
    (void)state;
    const cut_case cases[] = {
        {KNOT_OVERHAND, false, 0.06, 3, 0, 0.0},
        {KNOT_DOUBLE_OVERHAND, false, 0.06, 3, 0, 0.0},
        {KNOT_SQUARE, false, 0.09, 4, 4, 0.0}}; /* squeezed before it is cut */
    for (int k = 0; k < 3; k++) {
        cut_outcome found = cut_throw(&cases[k], 1.0);
        cut_expect_within(&found, &cases[k]);
    }
}

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double values[LIMITS])
{
    qsort(values, LIMITS, sizeof *values, ascending);
    return values[LIMITS / 2];
}

static void cut_depends_little_on_budget(void **state)
{
    (void)state;
    const cut_case cases[] = {{KNOT_OVERHAND, true, 0.06, 3, 0, 0.002},
                              {KNOT_DOUBLE_OVERHAND, true, 0.06, 3, 0, 0.04},
                              {KNOT_SQUARE, true, 0.09, 4, 20, 0.1}};
    for (int k = 0; k < 3; k++) {
        double cuts[LIMITS], clamped[LIMITS], paused[LIMITS], fastest[LIMITS];
        for (int i = 0; i < LIMITS; i++) {
            cut_outcome one = cut_throw(&cases[k], shares[i]);
            print_message("limit of work x %.2f: %.0f cuts, %.0f steps cut short, %.1f ms waited, "
                          "fastest %.1f m/s, shortened by %.3f\n",
                          shares[i], one.cuts, one.clamped, 1e3 * one.paused, one.fastest,
                          one.shortened);
            assert_true(one.cuts > 0.0);
            assert_true(one.shortened < 0.05);
            cuts[i] = one.cuts;
            clamped[i] = one.clamped;
            paused[i] = one.paused;
            fastest[i] = one.fastest;
        }
        cut_outcome found = {.cuts = median(cuts),
                             .clamped = median(clamped),
                             .paused = median(paused),
                             .fastest = median(fastest)};
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
