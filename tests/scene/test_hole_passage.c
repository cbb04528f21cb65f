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
    assert_true(result.slid > 0.5);
}

int test_hole_passage(void)
{
    const struct CMUnitTest tests[] = {harness_test(thread_crosses_the_surface_in_its_hole_only)};
    return cmocka_run_group_tests_name("scene.hole_passage", tests, NULL, NULL);
}
