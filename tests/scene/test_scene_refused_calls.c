/* Every bad name, number and NULL that calls on a scene are given: its status, and that the scene is as it was to
 * the bit. */

#include "scene/small_subject.h"

static void bad_threads_are_rejected(void **state)
{
    (void)state;
    subject t;
    uint32_t body = 77;
    vbss_thread *paper, *large, *good;
    begin_subject(&t);
    t.s.thread.segment_count = 2;
    expect_ok(vbss_thread_create(t.s.context, &t.s.thread, &good));
    t.s.thread.method = VBSS_METHOD_VBLAST;
    expect_ok(vbss_thread_create(t.s.context, &t.s.thread, &paper));
    t.s.thread.method = VBSS_METHOD_IMPLICIT;
    t.s.thread.segment_count = 7; /* of 20 nodes 13 are taken */
    expect_ok(vbss_thread_create(t.s.context, &t.s.thread, &large));
    unchanged(&t, VBSS_ERROR_INCOMPATIBLE, vbss_scene_add_thread(t.s.scene, paper, &body));
    unchanged(&t, VBSS_ERROR_CAPACITY, vbss_scene_add_thread(t.s.scene, large, &body));
    unchanged(&t, VBSS_ERROR_NULL_ARGUMENT, vbss_scene_add_thread(t.s.scene, good, NULL));
    unchanged(&t, VBSS_ERROR_IN_SCENE, vbss_scene_add_thread(t.s.scene, t.thread, &body));
    assert_int_equal(body, 77);
    expect_ok(vbss_thread_step(large, 1e-3)); /* and is not the scene's */
    expect_ok(vbss_scene_add_thread(t.s.scene, good, &body));
    small_end(&t.s);
    tiny_scene(&t.s);
    t.s.config.thread_capacity = 1;
    small_create(&t.s);
    t.s.thread.segment_count = 2;
    for (int k = 0; k < 2; k++) {
        expect_ok(vbss_thread_create(t.s.context, &t.s.thread, &good));
        expect_result(k == 0 ? VBSS_OK : VBSS_ERROR_CAPACITY,
                      vbss_scene_add_thread(t.s.scene, good, &body));
    }
    small_end(&t.s);
}

static void bad_names_and_moves_are_rejected(void **state)
{
    (void)state;
    subject t;
    const double zero[3] = {0.0, 0.0, 0.0};
    begin_subject(&t);
    const uint32_t no_body[] = {0, t.free + 1, UINT32_MAX};
    for (int k = 0; k < 3; k++) {
        vbss_scene_rigid_state state_of;
        unchanged(&t, VBSS_ERROR_NOT_FOUND, vbss_scene_remove(t.s.scene, no_body[k]));
        unchanged(&t, VBSS_ERROR_NOT_FOUND,
                  vbss_scene_set_rigid_target(t.s.scene, no_body[k], zero, NULL));
        unchanged(&t, VBSS_ERROR_NOT_FOUND,
                  vbss_scene_get_rigid(t.s.scene, no_body[k], &state_of, sizeof state_of));
        unchanged(&t, VBSS_ERROR_NOT_FOUND,
                  vbss_scene_unpin_thread(t.s.scene, k == 1 ? t.weld + 1 : no_body[k]));
    }
    vbss_scene_rigid_state state_of;
    unchanged(&t, VBSS_ERROR_INCOMPATIBLE,
              vbss_scene_get_rigid(t.s.scene, t.line, &state_of, sizeof state_of));
    unchanged(&t, VBSS_ERROR_INCOMPATIBLE,
              vbss_scene_set_rigid_target(t.s.scene, t.line, zero, NULL));
    unchanged(&t, VBSS_ERROR_INCOMPATIBLE,
              vbss_scene_set_rigid_target(t.s.scene, t.free, zero, NULL));
    unchanged(&t, VBSS_ERROR_NULL_ARGUMENT,
              vbss_scene_set_rigid_target(t.s.scene, t.driven, NULL, NULL));
    for (int c = 0; c < 4; c++) {
        for (int k = 0; k < 4; k++) {
            double p[3] = {0.0, 0.0, 0.0}, q[4] = {1.0, 0.0, 0.0, 0.0};
            vbss_result wanted = k < 3 ? VBSS_ERROR_NOT_FINITE : VBSS_ERROR_OUT_OF_RANGE;
            q[c] = k < 3 ? harness_bad_numbers[k] : 1e101;
            unchanged(&t, wanted, vbss_scene_set_rigid_target(t.s.scene, t.driven, p, q));
            p[c % 3] = k < 3 ? harness_bad_numbers[k] : 1.001e3;
            unchanged(&t, wanted, vbss_scene_set_rigid_target(t.s.scene, t.driven, p, NULL));
        }
    }
    const double none[4] = {0.0, 0.0, 0.0, 0.0};
    unchanged(&t, VBSS_ERROR_OUT_OF_RANGE,
              vbss_scene_set_rigid_target(t.s.scene, t.driven, zero, none));
    small_end(&t.s);
}

static void bad_pins_are_rejected(void **state)
{
    (void)state;
    subject t;
    uint32_t pin = 77;
    vbss_scene *scene;
    begin_subject(&t);
    scene = t.s.scene;
    const uint32_t no_body[] = {0, t.driven, 99};
    for (int k = 0; k < 3; k++) {
        unchanged(&t, k == 1 ? VBSS_ERROR_INCOMPATIBLE : VBSS_ERROR_NOT_FOUND,
                  vbss_scene_pin_thread(scene, no_body[k], 3, 0, NULL, &pin));
    }
    unchanged(&t, VBSS_ERROR_NOT_FOUND, vbss_scene_pin_thread(scene, t.line, 3, 99, NULL, &pin));
    unchanged(&t, VBSS_ERROR_INCOMPATIBLE,
              vbss_scene_pin_thread(scene, t.line, 3, t.line, NULL, &pin));
    unchanged(&t, VBSS_ERROR_OUT_OF_RANGE, vbss_scene_pin_thread(scene, t.line, 13, 0, NULL, &pin));
    unchanged(&t, VBSS_ERROR_OUT_OF_RANGE,
              vbss_scene_pin_thread(scene, t.line, UINT32_MAX, 0, NULL, &pin));
    const uint32_t bodies[] = {0, t.driven, t.free};
    for (int k = 0; k < 3; k++) { /* held by a pin, and by a weld */
        unchanged(&t, VBSS_ERROR_IN_USE,
                  vbss_scene_pin_thread(scene, t.line, 0, bodies[k], NULL, &pin));
        unchanged(&t, VBSS_ERROR_IN_USE,
                  vbss_scene_pin_thread(scene, t.line, 12, bodies[k], NULL, &pin));
    }
    for (int c = 0; c < 3; c++) {
        for (int k = 0; k < 4; k++) {
            double p[3] = {0.0, 0.0, 0.0};
            vbss_result wanted = k < 3 ? VBSS_ERROR_NOT_FINITE : VBSS_ERROR_OUT_OF_RANGE;
            p[c] = k < 3 ? harness_bad_numbers[k] : -1.001e3;
            unchanged(&t, wanted, vbss_scene_pin_thread(scene, t.line, 3, t.free, p, &pin));
        }
    }
    unchanged(&t, VBSS_ERROR_NULL_ARGUMENT, vbss_scene_pin_thread(scene, t.line, 3, 0, NULL, NULL));
    assert_int_equal(pin, 77);
    expect_ok(vbss_scene_pin_thread(scene, t.line, 5, 0, NULL, &pin));
    t.hash = small_hash(&t.s);
    t.generation = small_view(&t.s, VBSS_SCENE_VIEW_CONTACTS).generation;
    unchanged(&t, VBSS_ERROR_CAPACITY, vbss_scene_pin_thread(scene, t.line, 7, 0, NULL, &pin));
    small_end(&t.s);
}

static void pin_needs_attachment_capacity(void **state)
{
    (void)state;
    small s;
    uint32_t pin = 77;
    tiny_scene(&s);
    small_create(&s);
    s.thread.attachment_capacity = 0;
    uint32_t line = small_thread(&s, vec3_zero(), vec3_make(0.01, 0.0, 0.0), 5, NULL);
    uint64_t hash = small_hash(&s);
    expect_result(VBSS_ERROR_CAPACITY, vbss_scene_pin_thread(s.scene, line, 0, 0, NULL, &pin));
    assert_int_equal(pin, 77);
    assert_true(small_hash(&s) == hash);
    small_end(&s);
}

static void bad_steps_views_and_buffers_are_rejected(void **state)
{
    (void)state;
    subject t;
    vbss_view view;
    uint64_t written;
    begin_subject(&t);
    const double wrong[] = {0.0, -1e-3, 0.99e-7, 0.1001, DBL_MAX, -DBL_MAX, 5e-324};
    for (int k = 0; k < 7; k++) {
        unchanged(&t, VBSS_ERROR_OUT_OF_RANGE, vbss_scene_step(t.s.scene, wrong[k]));
    }
    for (int k = 0; k < 3; k++) {
        unchanged(&t, VBSS_ERROR_NOT_FINITE, vbss_scene_step(t.s.scene, harness_bad_numbers[k]));
    }
    const vbss_scene_field none[] = {-1, 6, INT32_MAX, INT32_MIN};
    for (int k = 0; k < 4; k++) {
        unchanged(&t, VBSS_ERROR_OUT_OF_RANGE,
                  vbss_scene_get_view(t.s.scene, none[k], &view, sizeof view));
    }
    unchanged(&t, VBSS_ERROR_NULL_ARGUMENT, vbss_scene_get_hash(t.s.scene, NULL));
    unchanged(&t, VBSS_ERROR_NULL_ARGUMENT, vbss_scene_save(t.s.scene, NULL, 0, NULL));
    unchanged(&t, VBSS_ERROR_CAPACITY, vbss_scene_save(t.s.scene, NULL, 0, &written));
    unchanged(&t, VBSS_ERROR_NULL_ARGUMENT, vbss_scene_save(t.s.scene, NULL, written, &written));
    unchanged(&t, VBSS_ERROR_NULL_ARGUMENT, vbss_scene_restore(t.s.scene, NULL, written));
    small_end(&t.s);
}

/* A drain is neither a thread nor a tool. */
static void calls_about_other_bodies_are_rejected(void **state)
{
    (void)state;
    small s;
    vbss_scene_rigid_state rigid;
    vbss_thread *thread = NULL;
    vbss_scene_grasp grasp;
    uint32_t pin = 77;
    const double zero[3] = {0.0, 0.0, 0.0};
    small_begin_scene(&s);
    uint32_t drain = small_drain(&s, NULL);
    uint32_t line = small_thread(&s, vec3_make(0.0, 0.1, 0.0), vec3_make(0.01, 0.1, 0.0), 5, NULL);
    uint64_t hash = small_hash(&s);
    expect_result(VBSS_ERROR_INCOMPATIBLE,
                  vbss_scene_get_rigid(s.scene, drain, &rigid, sizeof rigid));
    expect_result(VBSS_ERROR_INCOMPATIBLE, vbss_scene_set_rigid_target(s.scene, drain, zero, NULL));
    expect_result(VBSS_ERROR_INCOMPATIBLE, vbss_scene_get_thread(s.scene, drain, &thread));
    expect_result(VBSS_ERROR_INCOMPATIBLE, vbss_scene_cut_thread(s.scene, drain, 5e-3, &pin));
    expect_result(VBSS_ERROR_INCOMPATIBLE, vbss_scene_pin_thread(s.scene, drain, 0, 0, NULL, &pin));
    expect_result(VBSS_ERROR_INCOMPATIBLE,
                  vbss_scene_pin_thread(s.scene, line, 0, drain, NULL, &pin));
    expect_result(VBSS_ERROR_NOT_FOUND,
                  vbss_scene_get_grasp(s.scene, drain, 0, &grasp, sizeof grasp));
    assert_int_equal(pin, 77);
    assert_true(small_hash(&s) == hash);
    small_end(&s);
}

int test_scene_refused_calls(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bad_threads_are_rejected),
        cmocka_unit_test(bad_names_and_moves_are_rejected),
        cmocka_unit_test(bad_pins_are_rejected),
        cmocka_unit_test(pin_needs_attachment_capacity),
        cmocka_unit_test(bad_steps_views_and_buffers_are_rejected),
        cmocka_unit_test(calls_about_other_bodies_are_rejected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
