/* Nothing passes through a static mesh: a sample of soak_meshes.c. */
#include "scene/mesh_life.h"

static void nothing_passes_through_static_meshes(void **state)
{
    (void)state;
    vbss_random random;
    mesh_life_result result = {0};
    vbss_random_seed(&random, 1, 12);
    for (int i = 0; i < 20; i++) {
        expect_ok(mesh_life_run(&random, 100, MESH_LIFE_STATIC, &result));
    }
    assert_int_equal(result.passed, 0);
    assert_int_equal(result.steps, 2000);
    assert_true(result.touched > 200 && result.fastest > 17.0);
}

int test_static_mesh_passage(void)
{
    const struct CMUnitTest tests[] = {harness_test(nothing_passes_through_static_meshes)};
    return cmocka_run_group_tests_name("scene.static_mesh_passage", tests, NULL, NULL);
}
