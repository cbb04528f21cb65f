/* Scenes with adaptive threads: the scalar and the SIMD copy of the search lead to the same meshes. */
#include "fixtures/adaptive_scene.h"
#include "scene/mesh_rig.h"

static uint64_t hash_after(bool wide, uint32_t steps)
{
    vbss_context *context;
    vbss_scene *scene = NULL;
    uint64_t hash;
    expect_ok(vbss_context_create(NULL, &context));
    expect_ok(adaptive_scene_create(context, VBSS_THREAD_BENDING_SPLINE, &scene));
    scene_object *s = mesh_scene(scene);
    s->collision->wide = s->collision->wide && wide;
    for (uint32_t i = 0; i < steps; i++) {
        expect_ok(adaptive_scene_step(scene));
    }
    expect_ok(vbss_scene_get_hash(scene, &hash));
    vbss_context_destroy(context);
    return hash;
}

static void scalar_and_simd_search_adapt_alike(void **state)
{
    (void)state;
    assert_true(hash_after(false, 120) == hash_after(true, 120));
}

int test_adaptive_simd(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(scalar_and_simd_search_adapt_alike),
    };
    return cmocka_run_group_tests_name("scene.adaptive_simd", tests, NULL, NULL);
}
