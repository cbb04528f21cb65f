/* A needle with its thread in the drain, the needle in the second hole, the thread in the first, is turned back: its end goes back
 * into the first hole. */
#include "scene/needle_stitch.h"

static needle_stitch n;

static void drawn_back_the_needle_undoes_the_stitch(void **state)
{
    (void)state;
    static const double speeds[] = {0.05, 0.2};
    for (int i = 0; i < 2; i++) {
        needle_stitch_begin(&n);
        needle_stitch_into_second(&n, speeds[i]);
        needle_stitch_turn(&n, -80e-3, speeds[i], VBSS_EVENT_WITHDRAWN, 2);
        assert_int_equal(n.c.counts[VBSS_EVENT_RETURNED], 1);
        assert_int_equal(n.c.counts[VBSS_EVENT_WITHDRAWN], 2);
        assert_int_equal(n.c.counts[VBSS_EVENT_UNTHREADED], 0);
        assert_true(n.first[VBSS_EVENT_PASSED] < n.first[VBSS_EVENT_RETURNED]);
        assert_true(n.first[VBSS_EVENT_RETURNED] < n.last[VBSS_EVENT_WITHDRAWN]);
        needle_stitch_turn(&n, -2e-3, speeds[i], 0, 0);
        needle_stitch_expect_in(&n, 0, 0);
        assert_int_equal(n.watch.crossings, 0);
        needle_stitch_finish(&n, "undone");
    }
}

int test_stitch_undone(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(drawn_back_the_needle_undoes_the_stitch),
    };
    return cmocka_run_group_tests_name("scene.stitch_undone", tests, NULL, NULL);
}
