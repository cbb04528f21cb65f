/* Random hands at one, two and five times their speed, with jumps: nothing passes through anything, no node is thrown. */
#include "scene/hand_run.h"

static const double speeds[3] = {1.0, 2.0, 5.0};
enum { SEEDS = 10, STEPS = 4000 };

static void random_hands_pass_nothing(void **state)
{
    (void)state;
    static hand_run r;
    uint64_t grasps = 0;
    for (uint64_t seed = 1; seed <= SEEDS; seed++) {
        for (int i = 0; i < 3; i++) {
            char name[32];
            snprintf(name, sizeof name, "hands %llu", (unsigned long long)seed);
            hand_run_begin(&r, seed);
            hand_run_start(&r, speeds[i]);
            hand_run_steps(&r, STEPS);
            hand_run_print(&r, name, speeds[i]);
            hand_run_expect_kept(&r);
            grasps += r.grasps;
            hand_run_end(&r);
        }
    }
    assert_true(grasps > SEEDS);
}

int test_hand_speeds(void)
{
    const struct CMUnitTest tests[] = {harness_test(random_hands_pass_nothing)};
    return cmocka_run_group_tests_name("scene.hand_speeds", tests, NULL, NULL);
}
