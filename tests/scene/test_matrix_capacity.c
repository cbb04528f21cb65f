/* Memory of a scene: what a configuration takes, what preparing does, and what happens beyond the capacity
 * of the matrix. */
#include "scene/small.h"

#include <vblast_ss/drain.h>

static uint64_t allocated(vbss_context *context)
{
    vbss_context_statistics statistics;
    expect_ok(vbss_context_get_statistics(context, &statistics, sizeof statistics));
    return statistics.bytes_allocated;
}

/* ---- memory of a configuration */

/* Asserts that the function tells what creation takes; returns it. */
static uint64_t expect_exact_memory(vbss_context *context, const vbss_scene_config *config)
{
    const uint64_t before = allocated(context);
    uint64_t bytes = 0;
    vbss_scene *scene;
    expect_ok(vbss_scene_config_get_memory(context, config, &bytes));
    assert_true(allocated(context) == before);
    expect_ok(vbss_scene_create(context, config, &scene));
    assert_true(allocated(context) - before == bytes);
    expect_ok(vbss_scene_destroy(scene));
    return bytes;
}

static void memory_of_configuration_is_exact(void **state)
{
    (void)state;
    small s;
    small_begin(&s);
    vbss_thread *thread; /* its handle takes the slots that handles of scenes use */
    expect_ok(vbss_thread_create(s.context, NULL, &thread));
    const uint64_t standard = expect_exact_memory(s.context, NULL);
    const uint64_t less = expect_exact_memory(s.context, &s.config);
    assert_true(less < standard);
    s.config.matrix_capacity = 1000;
    assert_true(expect_exact_memory(s.context, &s.config) < less);
    s.config.thread_capacity = s.config.node_capacity = s.config.rigid_capacity = 0;
    s.config.matrix_capacity = 0;
    (void)expect_exact_memory(s.context, &s.config);
    vbss_scene_config baseline = vbss_scene_config_default();
    baseline.method = VBSS_METHOD_VBLAST;
    (void)expect_exact_memory(s.context, &baseline);
    small_end(&s);
}

static void default_scene_takes_no_more_than_8_MB(void **state)
{
    (void)state;
    small s;
    uint64_t bytes;
    small_begin(&s);
    expect_ok(vbss_scene_config_get_memory(s.context, NULL, &bytes));
    assert_true(bytes <= 8000000);
    small_end(&s);
}

static void refused_configuration_leaves_the_number(void **state)
{
    (void)state;
    small s;
    uint64_t bytes = 77;
    small_begin(&s);
    s.config.matrix_capacity = 10000001;
    expect_result(VBSS_ERROR_OUT_OF_RANGE,
                  vbss_scene_config_get_memory(s.context, &s.config, &bytes));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_scene_config_get_memory(s.context, NULL, NULL));
    s.memory.fail_call = s.memory.calls + 40;
    expect_result(VBSS_ERROR_OUT_OF_MEMORY, vbss_scene_config_get_memory(s.context, NULL, &bytes));
    assert_true(bytes == 77);
    small_end(&s);
}

/* ---- the matrix */

static void scene_beyond_matrix_capacity_reports_capacity(void **state)
{
    (void)state;
    small s;
    vbss_result result;
    const char *text;
    small_begin(&s);
    s.config.floor = 1;
    s.config.matrix_capacity = 400; /* 60 free nodes take 361 */
    small_create(&s);
    s.thread.gravity[1] = -9.81;
    const double radius = s.thread.radius;
    (void)small_thread(&s, vec3_make(0.0, radius + 4e-4, 0.0), vec3_make(0.06, radius + 4e-4, 0.0),
                       60, NULL);
    small_steps(&s, 2, 1e-3);
    expect_ok(vbss_scene_prepare(s.scene));
    uint64_t hash = 0;
    for (int i = 0; i < 40; i++) { /* it falls on the floor */
        hash = small_hash(&s);
        result = vbss_scene_step(s.scene, 1e-3);
        if (result != VBSS_OK) {
            break;
        }
    }
    expect_ok(vbss_context_get_last_error(s.context, &result, &text));
    expect_result(VBSS_ERROR_CAPACITY, result);
    assert_non_null(strstr(text, "matrix_capacity"));
    assert_true(small_hash(&s) == hash);
    assert_true(small_statistics(&s).rejected_full > 0);
    small_end(&s);
}

static void thread_that_touches_with_all_nodes_fits_default(void **state)
{
    (void)state;
    small s;
    enum { SEGMENTS = 1023 };
    small_begin(&s);
    s.config = vbss_scene_config_default();
    s.config.floor = 1;
    small_create(&s);
    s.thread.gravity[1] = -9.81;
    const double height = 0.99 * s.thread.radius;
    (void)small_thread(&s, vec3_make(0.0, height, 0.0), vec3_make(1.0, height, 0.0), SEGMENTS,
                       NULL);
    small_steps(&s, 3, 1e-3);
    assert_true(small_statistics(&s).separators == SEGMENTS + 1);
    assert_true(small_statistics(&s).rejected_full == 0);
    small_end(&s);
}

/* ---- preparing */

enum { STEPS = 30 };

/* A thread falls on a floor and a tool, beside a drain. */
static uint64_t run(bool prepares)
{
    small s;
    small_begin(&s);
    s.config.floor = 1;
    small_create(&s);
    s.thread.gravity[1] = -9.81;
    s.drain.position[1] = 0.05;
    (void)small_thread(&s, vec3_make(0.0, 1e-3, 0.0), vec3_make(0.05, 1e-3, 0.0), 50, NULL);
    (void)small_drain(&s, NULL);
    const uint32_t tool = small_stick(&s, VBSS_SCENE_RIGID_COUPLED, vec3_make(0.025, 4e-4, 0.0),
                                      vec3_make(0.0, 0.0, 0.01), 3e-4);
    const uint64_t patterns = small_statistics(&s).patterns, calls = s.memory.calls;
    const uint64_t hash = small_hash(&s);
    for (int i = 0; prepares && i < 2; i++) {
        expect_ok(vbss_scene_prepare(s.scene));
        assert_true(small_statistics(&s).patterns == patterns + 1);
    }
    assert_true(small_hash(&s) == hash);
    for (int i = 0; i < STEPS; i++) {
        if (prepares) {
            expect_ok(vbss_scene_prepare(s.scene));
        }
        small_move(&s, tool, vec3_make(0.025, 4e-4 + 1e-5 * i, 0.0));
        small_steps(&s, 1, 1e-3);
        if (i == STEPS / 2) {
            small_pin(&s, 1, 0, 0);
        }
    }
    assert_true(s.memory.calls == calls || !prepares);
    const uint64_t end = small_hash(&s);
    small_end(&s);
    return end;
}

static void prepared_scene_steps_with_the_same_bits(void **state)
{
    (void)state;
    assert_true(run(false) == run(true));
}

static void prepared_pattern_serves_the_first_step(void **state)
{
    (void)state;
    small s;
    small_begin_scene(&s);
    (void)small_thread(&s, vec3_zero(), vec3_make(0.05, 0.0, 0.0), 50, NULL);
    (void)small_drain(&s, NULL);
    expect_ok(vbss_scene_prepare(s.scene));
    const uint64_t patterns = small_statistics(&s).patterns;
    small_steps(&s, 1, 1e-3);
    assert_true(small_statistics(&s).patterns == patterns);
    small_end(&s);
}

int test_matrix_capacity(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(memory_of_configuration_is_exact),
        harness_test(default_scene_takes_no_more_than_8_MB),
        harness_test(refused_configuration_leaves_the_number),
        harness_test(scene_beyond_matrix_capacity_reports_capacity),
        harness_test(thread_that_touches_with_all_nodes_fits_default),
        harness_test(prepared_scene_steps_with_the_same_bits),
        harness_test(prepared_pattern_serves_the_first_step),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
