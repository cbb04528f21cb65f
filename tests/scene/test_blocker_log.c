/* Warnings about bodies that are held back: they name the bodies that are known, and none of the library's own scenes. */
#include <stdio.h>

#include <vblast_ss/core_speed.h>

#include "scene/small.h"

typedef struct listener {
    uint32_t count;
    char last[256];
} listener;

static void listen(void *user, vbss_log_level level, const char *message)
{
    listener *l = user;
    assert_int_equal(VBSS_LOG_WARNING, level);
    l->count++;
    (void)snprintf(l->last, sizeof l->last, "%s", message);
}

static vbss_context *create_context(listener *l)
{
    vbss_context *context;
    vbss_context_config config = vbss_context_config_default();
    config.log = listen;
    config.log_user = l;
    config.log_level = VBSS_LOG_WARNING;
    expect_ok(vbss_context_create(&config, &context));
    return context;
}

static void warning_names_the_bodies_that_are_known(void **state)
{
    (void)state;
    static const struct {
        scene_touching_pair bodies;
        const char *text;
    } cases[] = {
        {{0, 0}, "scene: bodies are held back: the penetration is too deep"},
        {{3, 0}, "scene: body 3 is held back: the penetration is too deep"},
        {{0, 4}, "scene: body 4 is held back: the penetration is too deep"},
        {{5, 5}, "scene: body 5 is held back: the penetration is too deep"},
        {{6, 7}, "scene: bodies 6 and 7 are held back: the penetration is too deep"},
    };
    listener l = {0};
    vbss_context *context = create_context(&l);
    vbss_scene *scene;
    scene_object *s;
    expect_ok(vbss_scene_create(context, NULL, &scene));
    expect_ok(vbss_scene_open(scene, &s));
    for (uint32_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        vbss_scene_record_blocker(s, VBSS_SCENE_BLOCKER_PENETRATION, cases[i].bodies, 1e-3);
        assert_string_equal(cases[i].text, l.last);
        assert_int_equal(i + 1, l.count);
    }
    expect_ok(vbss_context_destroy(context));
}

static double read_clock(void *user)
{
    double *now = user;
    return *now += 0x1p-11;
}

static void measurement_of_the_core_logs_nothing(void **state)
{
    (void)state;
    listener l = {0};
    double now = 0.0;
    vbss_core_speed speed;
    vbss_context *context = create_context(&l);
    expect_ok(vbss_core_speed_measure(context, read_clock, &now, &speed, sizeof speed));
    expect_ok(vbss_context_destroy(context));
    assert_int_equal(0, l.count);
}

int test_blocker_log(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(warning_names_the_bodies_that_are_known),
        cmocka_unit_test(measurement_of_the_core_logs_nothing),
    };
    return cmocka_run_group_tests_name("scene.blocker_log", tests, NULL, NULL);
}
