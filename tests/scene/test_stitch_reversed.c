/* A needle with its thread in the drain, the needle in the second hole, the thread in the first, is turned back by 80 mm while
 * nobody draws its thread. Its end should go back into the first hole; today the wall stops it: docs/explanation/known-limits.md. */
#include "scene/needle_stitch.h"

static needle_stitch n;

static void drawn_back_needle_stays_in_stitch(void **state)
{
    (void)state;
    static const double speeds[] = {0.05, 0.2};
    for (int i = 0; i < 2; i++) {
        needle_stitch_begin(&n);
        needle_stitch_into_second(&n, speeds[i]);
        needle_stitch_turn(&n, -80e-3, speeds[i], VBSS_SCENE_EVENT_WITHDRAWN, 2);
        /* Of two holes that the needle should leave, so many still stand. */
        expect_known_limit(0.0, 2.0, 2.0 - n.c.counts[VBSS_SCENE_EVENT_WITHDRAWN]);
        /* It is all or nothing: half an undone stitch would be a fault. */
        assert_int_equal(n.c.counts[VBSS_SCENE_EVENT_WITHDRAWN], 0);
        assert_int_equal(n.c.counts[VBSS_SCENE_EVENT_RETURNED], 0);
        assert_int_equal(n.c.counts[VBSS_SCENE_EVENT_UNTHREADED], 0);
        needle_stitch_expect_in(&n, 2, 1);
        assert_int_equal(n.watch.crossings, 1);
        needle_stitch_finish_clamped(&n, "not undone", 30); /* the turning hand pulls on */
    }
}

int test_stitch_reversed(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(drawn_back_needle_stays_in_stitch),
    };
    return cmocka_run_group_tests_name("scene.stitch_reversed", tests, NULL, NULL);
}
