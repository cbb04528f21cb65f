/* A needle with its thread in the drain, the needle in the second hole, the thread in the first, is turned back. With a hand at
 * the tail, which draws the thread after it, its end goes back into the first hole; with a slack thread it meets the wall beside
 * it, as a blunt end does, and stays inside. */
#include "scene/needle_stitch.h"

static needle_stitch n;

static void undo(double speed, double force)
{
    needle_stitch_begin(&n);
    needle_stitch_into_second(&n, speed);
    needle_stitch_draw(&n, force);
    needle_stitch_turn(&n, -80e-3, speed, VBSS_EVENT_WITHDRAWN, 2);
    assert_int_equal(n.c.counts[VBSS_EVENT_RETURNED], 1);
    assert_int_equal(n.c.counts[VBSS_EVENT_WITHDRAWN], 2);
    assert_int_equal(n.c.counts[VBSS_EVENT_UNTHREADED], 0);
    assert_true(n.first[VBSS_EVENT_PASSED] < n.first[VBSS_EVENT_RETURNED]);
    assert_true(n.first[VBSS_EVENT_RETURNED] < n.last[VBSS_EVENT_WITHDRAWN]);
    needle_stitch_turn(&n, -2e-3, speed, 0, 0);
    needle_stitch_expect_in(&n, 0, 0);
    assert_int_equal(n.watch.crossings, 0);
    needle_stitch_finish(&n, "undone");
}

static void turned_back_with_its_thread_drawn_the_needle_undoes_the_stitch(void **state)
{
    (void)state;
    static const double speeds[] = {0.05, 0.2}, forces[] = {0.1, 0.3};
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < 2; k++) {
            undo(speeds[i], forces[k]);
        }
    }
}

static void with_its_thread_slack_the_end_stays_inside_beside_its_hole(void **state)
{
    (void)state;
    needle_stitch_begin(&n);
    needle_stitch_into_second(&n, 0.05);
    needle_stitch_turn(&n, -20e-3, 0.05, 0, 0);
    assert_int_equal(n.c.counts[VBSS_EVENT_RETURNED] + n.c.counts[VBSS_EVENT_WITHDRAWN], 0);
    needle_stitch_expect_in(&n, 2, 1);
    assert_int_equal(n.watch.crossings, 1);
    needle_stitch_finish(&n, "slack");
}

int test_stitch_undone(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(turned_back_with_its_thread_drawn_the_needle_undoes_the_stitch),
        cmocka_unit_test(with_its_thread_slack_the_end_stays_inside_beside_its_hole),
    };
    return cmocka_run_group_tests_name("scene.stitch_undone", tests, NULL, NULL);
}
