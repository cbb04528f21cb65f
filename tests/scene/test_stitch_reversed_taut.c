/* A needle with its thread in the drain, the needle in the second hole, the thread in the first, is turned back while a hand at
 * the tail draws the thread after it: its end goes back into the first hole. */
#include "scene/needle_stitch.h"

static needle_stitch n;

static void undo(double speed, double force)
{
    needle_stitch_begin(&n);
    needle_stitch_into_second(&n, speed);
    needle_stitch_expect_undone(&n, force, speed);
    needle_stitch_finish(&n, "undone");
}

static void reversed_needle_with_taut_thread_undoes_stitch(void **state)
{
    (void)state;
    static const double speeds[] = {0.05, 0.2}, forces[] = {0.1, 0.3};
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < 2; k++) {
            undo(speeds[i], forces[k]);
        }
    }
}

int test_stitch_reversed_taut(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reversed_needle_with_taut_thread_undoes_stitch),
    };
    return cmocka_run_group_tests_name("scene.stitch_reversed_taut", tests, NULL, NULL);
}
