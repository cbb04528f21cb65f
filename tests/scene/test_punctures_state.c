/* Scenes with a needle in a drain: saved, restored and gone on with; damaged; without memory; without room for holes. */
#include "base/error.h"
#include "harness/harness.h"
#include "scene/api/api.h"
#include "fixtures/puncture_scenes.h"

#define STEP_S 1e-3
#define SPEED 0.1

/* ---- a needle that turns into both walls and back, as a body that is stepped */

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

static vbss_result destroy(void *handle)
{
    return vbss_scene_destroy(handle);
}

static harness_body as_body(pricked *p)
{
    const harness_body body = {"pricked drain", &vbss_scene_kind, create, NULL, step, destroy, p};
    return body;
}

/* ---- tests */

static uint32_t count_of(vbss_scene *scene, vbss_event_kind kind)
{
    vbss_view view;
    uint32_t count = 0;
    expect_ok(vbss_scene_get_view(scene, VBSS_SCENE_VIEW_EVENTS, &view, sizeof view));
    for (uint64_t i = 0; i < view.count; i++) {
        count += ((const uint32_t *)view.data)[4 * i] == (uint32_t)kind;
    }
    return count;
}

/* What the other tests stand on: moments 63 to 73 are about the first entry, 170 to 185 about the second. */
static void state_cases_cover_events(void **state)
{
    (void)state;
    harness_memory memory;
    pricked p = {16};
    void *scene = NULL;
    uint32_t in = 0, out = 0;
    vbss_context *context = harness_context(&memory);
    expect_ok(create(context, &p, &scene));
    for (int i = 0; i < 420; i++) {
        expect_ok(step(scene));
        in += count_of(scene, VBSS_EVENT_PUNCTURE);
        out += count_of(scene, VBSS_EVENT_WITHDRAWN);
        if (count_of(scene, VBSS_EVENT_PUNCTURE) + count_of(scene, VBSS_EVENT_WITHDRAWN) > 0) {
            print_message("step %d: %u in, %u out\n", i + 1, in, out);
        }
    }
    assert_int_equal(in, 2);
    assert_int_equal(out, 2);
    harness_context_end(context, &memory);
}

static void restored_scene_continues_bit_equal(void **state)
{
    (void)state;
    const size_t moments[] = {20, 55, 66, 70, 90, 120, 160, 176, 190, 220, 300};
    pricked p = {16};
    harness_body body = as_body(&p);
    harness_save_restore_continue_at(&body, moments, sizeof moments / sizeof moments[0], 25);
}

static void bad_snapshots_are_rejected(void **state)
{
    (void)state;
    pricked p = {2};
    harness_body body = as_body(&p);
    harness_refuses_bad_snapshots(&body, 190);
}

static void steps_do_not_allocate(void **state)
{
    (void)state;
    pricked p = {16};
    harness_body body = as_body(&p);
    assert_int_equal(harness_step_allocations(&body, 400), 0);
}

static void wall_holds_without_hole_capacity(void **state)
{
    (void)state;
    harness_memory memory;
    pricked p = {0};
    void *scene = NULL;
    vbss_hole hole;
    uint32_t lost = 0;
    vbss_context *context = harness_context(&memory);
    expect_ok(create(context, &p, &scene));
    for (int i = 0; i < 100; i++) {
        expect_ok(step(scene));
        lost += count_of(scene, VBSS_EVENT_HOLE_LOST);
        assert_int_equal(count_of(scene, VBSS_EVENT_PUNCTURE), 0);
    }
    assert_true(lost > 0);
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_scene_get_hole(scene, 0, &hole, sizeof hole));
    harness_context_end(context, &memory);
}

static void removed_bodies_remove_holes(void **state)
{
    (void)state;
    for (uint32_t which = 1; which <= 2; which++) {
        harness_memory memory;
        pricked p = {16};
        void *scene = NULL;
        vbss_hole hole;
        vbss_context *context = harness_context(&memory);
        expect_ok(create(context, &p, &scene));
        for (int i = 0; i < 120; i++) {
            expect_ok(step(scene));
        }
        expect_ok(vbss_scene_get_hole(scene, 0, &hole, sizeof hole));
        expect_ok(vbss_scene_remove(scene, which));
        expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_scene_get_hole(scene, 0, &hole, sizeof hole));
        for (int i = 0; i < 20; i++) {
            expect_ok(vbss_scene_step(scene, STEP_S));
        }
        harness_context_end(context, &memory);
    }
}

int test_punctures_state(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(state_cases_cover_events),
        cmocka_unit_test(restored_scene_continues_bit_equal),
        cmocka_unit_test(bad_snapshots_are_rejected),
        cmocka_unit_test(steps_do_not_allocate),
        cmocka_unit_test(wall_holds_without_hole_capacity),
        cmocka_unit_test(removed_bodies_remove_holes),
    };
    return cmocka_run_group_tests_name("scene.punctures_state", tests, NULL, NULL);
}
