/* Scenes with a needle in a drain: without capacity for holes, and when either body is removed. */
#include "base/error.h"
#include "harness/harness.h"
#include "scene/api/api.h"
#include "fixtures/puncture_scenes.h"
#include "fixtures/step_events.h"

#define STEP_S 1e-3
#define SPEED 0.1

typedef struct pricked {
    uint32_t hole_capacity;
} pricked;

/* Bodies 1, the drain, and 2, the needle. */
static vbss_result create(vbss_context *context, void *user, void **handle)
{
    const pricked *p = user;
    vbss_scene_config config;
    vbss_drain_config wall;
    puncture_scene made;
    VBSS_TRY(puncture_scene_configs(&config, &wall));
    config.hole_capacity = p->hole_capacity;
    vbss_result result = puncture_scene_create(context, &config, &wall, &made);
    *handle = made.scene;
    return result;
}

static vbss_result step(void *handle)
{
    return puncture_scene_step_of(handle, SPEED, STEP_S);
}

static uint32_t count_of(vbss_scene *scene, vbss_scene_event_kind kind)
{
    vbss_scene_event last;
    return step_events_find(scene, kind, &last);
}

static void wall_holds_without_hole_capacity(void **state)
{
    (void)state;
    harness_memory memory;
    pricked p = {0};
    void *scene = NULL;
    vbss_scene_hole hole;
    uint32_t lost = 0;
    vbss_context *context = harness_context(&memory);
    expect_ok(create(context, &p, &scene));
    for (int i = 0; i < 100; i++) {
        expect_ok(step(scene));
        lost += count_of(scene, VBSS_SCENE_EVENT_HOLE_LOST);
        assert_int_equal(count_of(scene, VBSS_SCENE_EVENT_PUNCTURE), 0);
    }
    assert_true(lost > 0);
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_scene_get_hole(scene, 0, &hole, sizeof hole));
    harness_context_end(context, &memory);
}

static void removed_bodies_remove_holes(void **state)
{
    (void)state;
    for (uint32_t which = 1; which <= 2; which++) {
        harness_memory memory;
        pricked p = {16};
        void *scene = NULL;
        vbss_scene_hole hole;
        vbss_context *context = harness_context(&memory);
        expect_ok(create(context, &p, &scene));
        for (int i = 0; i < 120; i++) {
            expect_ok(step(scene));
        }
        expect_ok(vbss_scene_get_hole(scene, 0, &hole, sizeof hole));
        expect_ok(vbss_scene_remove(scene, which));
        expect_result(VBSS_ERROR_NOT_FOUND, vbss_scene_get_hole(scene, 0, &hole, sizeof hole));
        for (int i = 0; i < 20; i++) {
            expect_ok(vbss_scene_step(scene, STEP_S));
        }
        harness_context_end(context, &memory);
    }
}

int test_hole_capacity(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(wall_holds_without_hole_capacity),
        cmocka_unit_test(removed_bodies_remove_holes),
    };
    return cmocka_run_group_tests_name("scene.hole_capacity", tests, NULL, NULL);
}
