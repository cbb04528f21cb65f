#include <stdlib.h>

#include "determinism/scenes.h"
#include "harness/harness.h"

/* The first `count` hashes of a scene; the caller frees them. */
static uint64_t *hashes_of(const golden_scene *scene, size_t count)
{
    uint64_t *hashes = calloc(count, sizeof *hashes);
    assert_non_null(hashes);
    scene->run(hashes, count);
    return hashes;
}

/* The same scenes and files as the determinism table, in this very build. Each is run once in full, and once in short. */
static void golden_hashes(void **state)
{
    (void)state;
    for (size_t i = 0; i < golden_scene_count; i++) {
        const golden_scene *scene = &golden_scenes[i];
        size_t count = scene->short_count;
        uint64_t *full = hashes_of(scene, scene->count);
        harness_golden(scene->name, full, scene->count);
        for (size_t k = 1; k < scene->count; k++) {
            assert_true(full[k] != full[k - 1]); /* it stands still, and would prove nothing */
        }
        /* The short form is the beginning of the full one. */
        assert_true(count > 0 && count < scene->count);
        uint64_t *brief = hashes_of(scene, count);
        assert_int_equal(harness_first_difference(full, brief, count), count);
        free(brief);
        free(full);
    }
}

int test_golden(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(golden_hashes),
    };
    return cmocka_run_group_tests_name("harness.golden", tests, NULL, NULL);
}
