/* A needle with its thread in the drain: the needle in the second hole, the thread in the first; drawn on it leaves a stitch.
 * Needle and thread cross the wall in holes only. */
#include "scene/needle_stitch.h"

#define SPEED 0.05

static needle_stitch n;

static void needle_and_thread_rest_in_two_holes(void **state)
{
    (void)state;
    needle_stitch_begin(&n);
    needle_stitch_into_second(&n, SPEED);
    needle_stitch_wait(&n, 300);
    needle_stitch_expect_in(&n, 2, 1);
    assert_true(drain_case_fastest(&n.c.d) < 0.01);
    needle_stitch_finish(&n, "needle and thread");
}

static void drawn_through_needle_leaves_stitch(void **state)
{
    (void)state;
    needle_stitch_begin(&n);
    needle_stitch_into_second(&n, SPEED);
    needle_stitch_turn(&n, 60e-3, SPEED, VBSS_SCENE_EVENT_PASSED, 2);
    needle_stitch_turn(&n, 3e-3, SPEED, 0, 0);
    needle_stitch_expect_in(&n, 2, 2);
    assert_int_equal(n.watch.crossings, 2);
    assert_int_equal(
        n.c.counts[VBSS_SCENE_EVENT_WITHDRAWN] + n.c.counts[VBSS_SCENE_EVENT_UNTHREADED], 0);
    needle_stitch_finish(&n, "a stitch");
}

int test_stitch_needle(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(needle_and_thread_rest_in_two_holes),
        cmocka_unit_test(drawn_through_needle_leaves_stitch),
    };
    return cmocka_run_group_tests_name("scene.stitch_needle", tests, NULL, NULL);
}
