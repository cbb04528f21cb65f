/* In real time: a thread that slides in its holes gives back no more than a hand has put in. */
#include "scene/stitch_case.h"

static stitch_case c;

/* More energy than was put in, as a share of that. */
#define SHARE 0.05

static void fast_withdrawal_gains_no_energy(void **state)
{
    (void)state;
    stitch_case_open(&c, 0);
    stitch_case_wait(&c, 20);
    stitch_case_drop(&c, 0);
    stitch_case_pull(&c, 1, vec3_make(0.0, 0.0, 80e-3), 0.5);
    stitch_case_wait(&c, 50);
    assert_int_equal(c.counts[VBSS_SCENE_EVENT_UNTHREADED], 2);
    stitch_case_finish(&c, "drawn out, 0.5 m/s", SHARE);
}

static void cut_between_holes_gains_no_energy(void **state)
{
    (void)state;
    vbss_scene_hole holes[2];
    stitch_case_open(&c, 0);
    assert_true(stitch_case_hole(&c, 0, &holes[0]) && stitch_case_hole(&c, 1, &holes[1]));
    double middle = 0.5 * (holes[0].arc_length + holes[1].arc_length);
    assert_int_not_equal(stitch_case_cut(&c, c.stitch.thread_body, middle), 0);
    stitch_case_wait(&c, 50);
    for (int i = 0; i < 250; i++) {
        stitch_case_shift(&c, 0, vec3_make(0.0, 0.0, -0.1e-3));
        stitch_case_shift(&c, 1, vec3_make(0.0, 0.0, 0.1e-3));
        stitch_case_step(&c);
    }
    stitch_case_finish(&c, "cut between", SHARE);
}

int test_stitch_energy(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fast_withdrawal_gains_no_energy),
        cmocka_unit_test(cut_between_holes_gains_no_energy),
    };
    return cmocka_run_group_tests_name("scene.stitch_energy", tests, NULL, NULL);
}
