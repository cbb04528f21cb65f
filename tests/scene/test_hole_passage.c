/* A thread goes through a host surface in its hole only, also when it slides fast: a sample of soak_holes.c. */
#include "scene/hole_life.h"

/* Tools reach 0.5 m/s, as fast as hands draw. Before threads could return from the wrong side, 84 of these steps had a crossing
 * beside the hole where contact is complete. */
static void thread_crosses_the_surface_in_its_hole_only(void **state)
{
    (void)state;
    static const hole_life_hands hands = {.speed = 0.5};
    vbss_random random;
    hole_life_result result = {0};
    vbss_random_seed(&random, 1, 17);
    for (int i = 0; i < 24; i++) {
        expect_ok(hole_life_run(&random, 500, &hands, &result));
    }
    assert_int_equal(result.steps, 12000);
    assert_int_equal(result.several, 0);
    assert_int_equal(result.far, 0);
    assert_int_equal(result.clamped, 0);
    assert_true(result.slid > 0.5);
}

/* At 1 m/s the search for the state of a hole went to and fro between two directions of its transverse force until its limit, and 344
 * parts of these steps were truncated. */
static void fast_pull_does_not_stop_the_thread(void **state)
{
    (void)state;
    static const hole_life_hands hands = {.speed = 1.0};
    vbss_random random;
    hole_life_result result = {0};
    vbss_random_seed(&random, 3, 17);
    for (int i = 0; i < 14; i++) {
        expect_ok(hole_life_run(&random, 500, &hands, &result));
    }
    assert_true(result.clamped < 20);
    assert_true(result.slid > 0.5);
}

int test_hole_passage(void)
{
    const struct CMUnitTest tests[] = {harness_test(thread_crosses_the_surface_in_its_hole_only),
                                       harness_test(fast_pull_does_not_stop_the_thread)};
    return cmocka_run_group_tests_name("scene.hole_passage", tests, NULL, NULL);
}
