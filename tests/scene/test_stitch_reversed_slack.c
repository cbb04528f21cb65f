/* A needle with its thread in the drain, the needle in the second hole, the thread in the first, is pushed back while nobody draws
 * the thread after it: its end comes beside the first hole, where the wall stops it, as it would a surgeon. */
#include "scene/needle_stitch.h"

/* Drawn, the end is back in its hole after 10 mm. */
#define PUSHED 15e-3
#define PUSHED_HARD 25e-3

static const double speeds[] = {0.05, 0.2};
static needle_stitch n;

/* Of the needle, in the second hole, m. */
static double arc_in_hole(void)
{
    vbss_scene_hole in[NEEDLE_CASE_HOLES];
    uint32_t count = needle_case_holes(&n.c, in), i = 0;
    while (i < count && in[i].needle == 0) {
        i++;
    }
    assert_true(i < count);
    return in[i].arc_length;
}

static void push_back(double distance, double speed)
{
    needle_stitch_begin(&n);
    needle_stitch_into_second(&n, speed);
    const double before = arc_in_hole();
    needle_stitch_turn(&n, -distance, speed, 0, 0);
    assert_true(before - arc_in_hole() < 0.25 * distance); /* the rest it is held back */
    assert_int_equal(n.c.counts[VBSS_SCENE_EVENT_RETURNED], 0);
    assert_int_equal(n.c.counts[VBSS_SCENE_EVENT_WITHDRAWN], 0);
    assert_int_equal(n.c.counts[VBSS_SCENE_EVENT_UNTHREADED], 0);
    needle_stitch_expect_in(&n, 2, 1);
}

static void slack_thread_needle_is_stopped_by_wall(void **state)
{
    (void)state;
    for (int i = 0; i < 2; i++) {
        push_back(PUSHED_HARD, speeds[i]);
        needle_stitch_finish(&n, "pushed back");
    }
}

static void regrasped_and_drawn_needle_undoes_stitch(void **state)
{
    (void)state;
    for (int i = 0; i < 2; i++) {
        push_back(PUSHED, speeds[i]);
        needle_stitch_turn(&n, PUSHED, speeds[i], 0, 0);
        needle_stitch_expect_undone(&n, 0.3, speeds[i]);
        needle_stitch_finish(&n, "taken on and drawn");
    }
}

int test_stitch_reversed_slack(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(slack_thread_needle_is_stopped_by_wall),
        cmocka_unit_test(regrasped_and_drawn_needle_undoes_stitch),
    };
    return cmocka_run_group_tests_name("scene.stitch_reversed_slack", tests, NULL, NULL);
}
