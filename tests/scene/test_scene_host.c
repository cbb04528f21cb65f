/* What a host's threads and floating-point modes do to a scene: nothing. */
#include <pthread.h>
#include <sched.h>

#include "harness/float_modes.h"
#include "scene/small_subject.h"

/* ---- floating-point modes */

/* A thread with a stick at its end falls onto a drain. */
static void begin_busy_scene(small *s)
{
    small_begin_scene(s);
    s->thread.gravity[2] = s->rigid.gravity[2] = -9.81;
    (void)small_drain(s, NULL);
    uint32_t thread =
        small_thread(s, vec3_make(0.0, -0.01, 0.02), vec3_make(0.0, 0.01, 0.02), 10, NULL);
    uint32_t stick = small_stick(s, VBSS_SCENE_RIGID_FREE, vec3_make(0.0, 0.01, 0.02),
                                 vec3_make(0.0, 2e-3, 0.0), 1e-3);
    small_pin(s, thread, 10, stick);
}

static void host_mode_does_not_change_a_scene(void **state)
{
    (void)state;
    small plain, s;
    begin_busy_scene(&plain);
    begin_busy_scene(&s);
    for (size_t k = 0; k < harness_mode_count; k++) {
        for (int i = 0; i < 15; i++) {
            expect_ok(vbss_scene_step(plain.scene, 1e-3));
            harness_mode_set(k);
            vbss_result result = vbss_scene_step(s.scene, 1e-3);
            harness_mode_end(k);
            expect_ok(result);
        }
        assert_true(small_hash(&s) == small_hash(&plain));
    }
    assert_true(harness_mode_count == 0 || small_statistics(&plain).contacts > 0);
    small_end(&plain);
    small_end(&s);
}

/* ---- two threads in one scene */

enum { STEPS = 300 };

typedef struct stepper {
    vbss_scene *scene;
    uint32_t accepted;
    vbss_result last;
} stepper;

static void *step_many_times(void *user)
{
    stepper *s = user;
    while (s->accepted < STEPS && (s->last == VBSS_OK || s->last == VBSS_ERROR_BUSY)) {
        s->last = vbss_scene_step(s->scene, 1e-3);
        s->accepted += s->last == VBSS_OK;
        if (s->last == VBSS_ERROR_BUSY) {
            sched_yield();
        }
    }
    return NULL;
}

/* Each call makes a whole step or is refused. */
static void scene_stepped_by_two_threads_is_intact(void **state)
{
    (void)state;
    subject t, twin;
    pthread_t threads[2];
    begin_subject(&t);
    begin_subject(&twin);
    stepper steppers[2] = {{.scene = t.s.scene}, {.scene = t.s.scene}};
    for (int i = 0; i < 2; i++) {
        assert_int_equal(pthread_create(&threads[i], NULL, step_many_times, &steppers[i]), 0);
    }
    for (int i = 0; i < 2; i++) {
        pthread_join(threads[i], NULL);
        assert_int_equal(steppers[i].accepted, STEPS);
    }
    small_steps(&twin.s, 2 * STEPS, 1e-3);
    assert_true(small_hash(&t.s) == small_hash(&twin.s));
    small_end(&t.s);
    small_end(&twin.s);
}

/* ---- a second handle */

static void expect_named(vbss_context *context, vbss_result got, const char *wanted)
{
    const char *text;
    vbss_result stored;
    expect_result(VBSS_ERROR_INVALID_HANDLE, got);
    expect_ok(vbss_context_get_last_error(context, &stored, &text));
    expect_result(VBSS_ERROR_INVALID_HANDLE, stored);
    assert_string_equal(text, wanted);
}

static void bad_second_handle_is_named(void **state)
{
    (void)state;
    subject t, other;
    uint32_t body;
    const double no_handle[8] = {0.0};
    begin_subject(&t);
    begin_subject(&other);
    vbss_scene *scene = t.s.scene;
    vbss_context *context = t.s.context;
    expect_named(context, vbss_scene_add_thread(scene, NULL, &body), "thread is NULL");
    expect_named(context, vbss_scene_add_drain(scene, NULL, &body), "drain is NULL");
    expect_named(context, vbss_scene_add_needle(scene, NULL, &body), "needle is NULL");
    expect_named(context, vbss_scene_add_grasper(scene, NULL, &body), "grasper is NULL");
    expect_named(context, vbss_scene_add_thread(scene, (vbss_thread *)no_handle, &body),
                 "thread is no handle");
    expect_named(context, vbss_scene_add_thread(scene, other.thread, &body),
                 "thread belongs to another context");
    vbss_visual *visual;
    expect_ok(vbss_visual_create(context, NULL, &visual));
    expect_named(context, vbss_visual_add_scene(visual, NULL, NULL), "source is NULL");
    small_end(&t.s);
    small_end(&other.s);
}

/* ---- the log */

typedef struct listener {
    uint32_t messages;
} listener;

static void listen(void *user, vbss_log_level level, const char *message)
{
    (void)level;
    (void)message;
    ((listener *)user)->messages++;
}

static void size_query_and_destruction_log_nothing(void **state)
{
    (void)state;
    listener l = {0};
    vbss_context_config config;
    vbss_context *context;
    vbss_scene *scene;
    vbss_result stored;
    uint64_t bytes = 0;
    expect_ok(vbss_context_config_init(&config, sizeof config));
    config.log = listen;
    config.log_user = &l;
    expect_ok(vbss_context_create(&config, &context));
    expect_ok(vbss_scene_create(context, NULL, &scene));
    expect_result(VBSS_ERROR_CAPACITY, vbss_scene_save(scene, NULL, 0, &bytes));
    assert_true(bytes > 0);
    expect_ok(vbss_context_get_last_error(context, &stored, NULL));
    expect_ok(stored);
    expect_ok(vbss_context_destroy(context));
    assert_int_equal(l.messages, 0);
}

int test_scene_host(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(host_mode_does_not_change_a_scene),
        cmocka_unit_test(scene_stepped_by_two_threads_is_intact),
        cmocka_unit_test(bad_second_handle_is_named),
        cmocka_unit_test(size_query_and_destruction_log_nothing),
    };
    return cmocka_run_group_tests_name("scene.scene_host", tests, NULL, NULL);
}
