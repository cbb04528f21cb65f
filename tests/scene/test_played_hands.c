/* Random hands through mock devices: a sample of hand_speeds. */
#include "scene/hand_run.h"

static hand_run r;

static void run(uint64_t seed, double speed, uint32_t steps)
{
    hand_run_begin(&r, seed);
    hand_run_start(&r, speed);
    hand_run_steps(&r, steps);
}

/* They jump in the first second. */
static void fast_hands_pass_nothing(void **state)
{
    (void)state;
    run(4, 5.0, 500);
    hand_run_expect_kept(&r);
    hand_run_end(&r);
}

/* The jaws grasp the wall near their pivot and draw it. */
static void jaws_do_not_pass_through_wall_they_grasp(void **state)
{
    (void)state;
    uint64_t grasps = 0;
    const uint64_t seeds[] = {25, 29}; /* of seeds 10 to 29, those that grasp something */
    for (int k = 0; k < 2; k++) {
        run(seeds[k], 2.0, 800);
        grasps += r.grasps;
        hand_run_expect_kept(&r);
        hand_run_end(&r);
    }
    assert_true(grasps > 0);
}

/* Two tools press the drain flat, and one of its folds begins 0.4 mm deep. */
static void deep_fold_opens_slowly(void **state)
{
    (void)state;
    run(1, 2.0, 1100);
    hand_run_expect_kept(&r);
    assert_true(r.watch.fastest < 20.0);
    hand_run_end(&r);
}

int test_played_hands(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(fast_hands_pass_nothing),
        harness_test(jaws_do_not_pass_through_wall_they_grasp),
        harness_test(deep_fold_opens_slowly),
    };
    return cmocka_run_group_tests_name("scene.played_hands", tests, NULL, NULL);
}
