#include <stdlib.h>

#include "determinism/scenes.h"
#include "harness/harness.h"

/* The same scenes and files as the determinism table, in this very build. */
static void the_golden_scenes_give_the_golden_hashes(void **state)
{
    (void)state;
    for (size_t i = 0; i < golden_scene_count; i++) {
        const golden_scene *scene = &golden_scenes[i];
        uint64_t *hashes = calloc(scene->count, sizeof *hashes);
        assert_non_null(hashes);
        scene->run(hashes, scene->count);
        harness_golden(scene->name, hashes, scene->count);
        free(hashes);
    }
}

static void the_short_form_is_the_beginning_of_the_full_one(void **state)
{
    (void)state;
    for (size_t i = 0; i < golden_scene_count; i++) {
        const golden_scene *scene = &golden_scenes[i];
        assert_true(scene->short_count > 0 && scene->short_count < scene->count);
        uint64_t *full = calloc(scene->count, sizeof *full);
        uint64_t *brief = calloc(scene->short_count, sizeof *brief);
        assert_non_null(full);
        assert_non_null(brief);
        scene->run(full, scene->count);
        scene->run(brief, scene->short_count);
        assert_int_equal(harness_first_difference(full, brief, scene->short_count),
                         scene->short_count);
        free(brief);
        free(full);
    }
}

static void a_scene_s_hashes_all_differ(void **state)
{
    (void)state;
    for (size_t i = 0; i < golden_scene_count; i++) {
        const golden_scene *scene = &golden_scenes[i];
        uint64_t *hashes = calloc(scene->count, sizeof *hashes);
        assert_non_null(hashes);
        scene->run(hashes, scene->count);
        for (size_t k = 1; k < scene->count; k++) {
            assert_true(hashes[k] != hashes[k - 1]); /* a scene that stands still proves nothing */
        }
        free(hashes);
    }
}

int test_golden(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(the_golden_scenes_give_the_golden_hashes),
        harness_test(the_short_form_is_the_beginning_of_the_full_one),
        harness_test(a_scene_s_hashes_all_differ),
    };
    return cmocka_run_group_tests_name("harness.golden", tests, NULL, NULL);
}
