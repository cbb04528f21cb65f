/* What method VBLAST counts is in a struct of its own, and the fields of the implicit method stay 0. */
#include "scene/paper_fixture.h"

#include <stdlib.h>

static void run(stage *s, int steps)
{
    for (int i = 0; i < steps; i++) {
        expect_ok(vbss_scene_step(s->scene, 1e-3));
    }
}

/* A thread on the floor, for a quarter of a second. */
static void begin_with_landed_thread(stage *s, vbss_method method)
{
    begin(s);
    s->config.method = method;
    s->config.floor = 1;
    make(s);
    vbss_thread_config c = paper_thread(SEGMENTS);
    c.method = method;
    c.start[0] = -0.075;
    c.start[1] = 0.002;
    add(s, 0, &c);
    run(s, 250);
}

static void scene_of_vblast_leaves_counters_of_implicit_at_zero(void **state)
{
    (void)state;
    stage s;
    begin_with_landed_thread(&s, VBSS_METHOD_VBLAST);
    const vbss_scene_statistics q = statistics_of(&s);
    assert_int_equal(250, q.steps);
    assert_true(q.contacts > 0);
    assert_int_equal(0, q.rows + q.separators);
    assert_int_equal(0, q.attempts + q.linearisations + q.guard_pairs + q.loose_states);
    assert_int_equal(0, q.operations);
    vbss_thread_statistics t;
    expect_ok(vbss_thread_get_statistics(s.threads[0], &t, sizeof t));
    assert_true(t.substeps > t.steps);
    assert_int_equal(0, t.iterations + t.last_iterations);
    end(&s);
}

static void each_object_fills_counters_of_its_kind(void **state)
{
    (void)state;
    stage s;
    begin_with_landed_thread(&s, VBSS_METHOD_VBLAST);
    const vbss_baseline_statistics scene = baseline_statistics_of(&s);
    vbss_baseline_statistics thread;
    expect_ok(vbss_thread_get_baseline_statistics(s.threads[0], &thread, sizeof thread));
    assert_int_equal(sizeof scene, scene.struct_size);
    assert_true(scene.passes > 250 && scene.passes <= 1000);
    assert_int_equal(0, scene.projection_iterations + scene.failed_projections);
    assert_int_equal(0, thread.passes + thread.tested_pairs + thread.sign_tests_ended);
    assert_true(thread.projection_iterations >= thread.last_projection_iterations);
    assert_true(thread.last_projection_iterations > 0);
    end(&s);
}

static void restored_scene_has_its_baseline_statistics(void **state)
{
    (void)state;
    stage s;
    uint64_t size;
    begin_with_landed_thread(&s, VBSS_METHOD_VBLAST);
    vbss_baseline_statistics scene[2] = {baseline_statistics_of(&s)}, thread[2];
    expect_ok(vbss_thread_get_baseline_statistics(s.threads[0], &thread[0], sizeof thread[0]));
    const uint64_t hash = hash_of(s.scene);
    expect_result(VBSS_ERROR_CAPACITY, vbss_scene_save(s.scene, NULL, 0, &size));
    uint8_t *bytes = malloc(size);
    assert_non_null(bytes);
    expect_ok(vbss_scene_save(s.scene, bytes, size, &size));
    run(&s, 20);
    assert_true(baseline_statistics_of(&s).passes > scene[0].passes);
    expect_ok(vbss_scene_restore(s.scene, bytes, size));
    free(bytes);
    scene[1] = baseline_statistics_of(&s);
    expect_ok(vbss_thread_get_baseline_statistics(s.threads[0], &thread[1], sizeof thread[1]));
    assert_memory_equal(&scene[0], &scene[1], sizeof scene[0]);
    assert_memory_equal(&thread[0], &thread[1], sizeof thread[0]);
    assert_int_equal(0, statistics_of(&s).attempts + statistics_of(&s).rows);
    assert_int_equal(hash, hash_of(s.scene));
    end(&s);
}

static void objects_of_other_methods_are_refused(void **state)
{
    (void)state;
    stage s;
    vbss_collision *collision;
    vbss_baseline_statistics t = {.passes = 7};
    begin_with_landed_thread(&s, VBSS_METHOD_IMPLICIT);
    expect_ok(vbss_collision_create(s.context, NULL, &collision));
    expect_result(VBSS_ERROR_INCOMPATIBLE,
                  vbss_scene_get_baseline_statistics(s.scene, &t, sizeof t));
    expect_result(VBSS_ERROR_INCOMPATIBLE,
                  vbss_thread_get_baseline_statistics(s.threads[0], &t, sizeof t));
    expect_result(VBSS_ERROR_INCOMPATIBLE,
                  vbss_collision_get_baseline_statistics(collision, &t, sizeof t));
    assert_int_equal(7, t.passes);
    expect_ok(vbss_collision_destroy(collision));
    end(&s);
}

int test_paper_statistics(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(scene_of_vblast_leaves_counters_of_implicit_at_zero),
        harness_test(each_object_fills_counters_of_its_kind),
        harness_test(restored_scene_has_its_baseline_statistics),
        harness_test(objects_of_other_methods_are_refused),
    };
    return cmocka_run_group_tests_name("scene.paper_statistics", tests, NULL, NULL);
}
