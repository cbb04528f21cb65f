/* Needles and tools that are removed or destroyed while the needle is held. */
#include "scene/needles_rig.h"
#include "fixtures/needle_scenes.h"

/* Without an event: what is no longer there was not let go. The jaws close on. */
static void held_needle_can_be_removed(void **state)
{
    (void)state;
    needles_rig r;
    vbss_scene_grasp grasp;
    vbss_scene_event event;
    uint32_t body;
    needles_begin_scene(&r);
    needles_hold(&r);
    small *s = &r.tools.s;
    double angle = tools_state(&r.tools, 0).jaw_angle;
    assert_true(angle > 0.02);
    expect_ok(vbss_scene_remove(s->scene, r.body));
    expect_result(VBSS_ERROR_NOT_FOUND,
                  vbss_scene_get_grasp(s->scene, r.tools.bodies[0], 0, &grasp, sizeof grasp));
    for (int i = 0; i < 20; i++) {
        tools_steps(&r.tools, 1);
        assert_int_equal(tools_happened(&r.tools, VBSS_SCENE_EVENT_RELEASE, &event), 0);
        assert_int_equal(tools_happened(&r.tools, VBSS_SCENE_EVENT_TORN, &event), 0);
    }
    vbss_grasper_state tool = tools_state(&r.tools, 0);
    assert_int_equal(tool.grasp_count, 0);
    expect_near(0.0, tool.jaw_angle, 0.0);
    expect_near(0.0, tool.pressure, 0.0);
    expect_ok(vbss_needle_step(r.needle, 1e-3));
    /* A needle that comes back, elsewhere, is not held. */
    const double far[3] = {0.1, 0.0, 0.0};
    expect_ok(vbss_needle_set_state(r.needle, far, NULL, NULL, NULL));
    expect_ok(vbss_scene_add_needle(s->scene, r.needle, &body));
    tools_steps(&r.tools, 20);
    assert_int_equal(tools_state(&r.tools, 0).grasp_count, 0);
    needles_end(&r);
}

static void holding_tool_can_be_removed(void **state)
{
    (void)state;
    needles_rig r;
    needles_begin_scene(&r);
    needles_hold(&r);
    expect_ok(vbss_scene_remove(r.tools.s.scene, r.tools.bodies[0]));
    expect_ok(vbss_grasper_destroy(r.tools.tools[0]));
    scene_body *b = vbss_scene_body(small_object(&r.tools.s), r.body);
    b->rigid.body.gravity = vec3_make(0.0, 0.0, -9.81);
    double before = needles_state(&r).position[2];
    tools_steps(&r.tools, 100);
    expect_near(-0.5 * 9.81 * 0.1 * 0.101, needles_state(&r).position[2] - before, 1e-5);
    needles_end(&r);
}

/* Its thread stays, and is pinned to nothing. */
static void swaged_needle_can_be_removed(void **state)
{
    (void)state;
    small s;
    small_begin(&s);
    expect_ok(needle_scene_create(s.context, &s.scene));
    for (int i = 0; i < NEEDLE_SCENE_LIFTED; i++) {
        expect_ok(needle_scene_step(s.scene));
    }
    expect_ok(vbss_scene_remove(s.scene, NEEDLE_SCENE_NEEDLE));
    for (int i = 0; i < 200; i++) {
        expect_ok(needle_scene_step(s.scene));
    }
    const thread_object *t = vbss_scene_body(small_object(&s), NEEDLE_SCENE_THREAD)->thread.thread;
    assert_true(t->now.x[0].z < 1e-3); /* it has fallen on the floor */
    small_end(&s);
}

/* ---- ends */

/* A needle in jaws, and one that is older than the scene. */
static void context_end_destroys_held_needle_in_any_order(void **state)
{
    (void)state;
    for (int order = 0; order < 16; order++) {
        needles_rig r;
        vbss_needle *before;
        uint32_t body;
        needles_begin(&r);
        r.config.position[2] = 0.1;
        expect_ok(vbss_needle_create(r.tools.s.context, &r.config, &before));
        small_create(&r.tools.s);
        r.config.position[2] = 0.0;
        needles_hold(&r);
        if ((order & 1) != 0) {
            expect_ok(vbss_scene_add_needle(r.tools.s.scene, before, &body));
        }
        if ((order & 2) != 0) {
            tools_open(&r.tools, 0, 1.0);
        }
        tools_steps(&r.tools, 1);
        if ((order & 4) != 0) {
            expect_ok(vbss_scene_destroy(r.tools.s.scene));
            expect_ok(vbss_needle_step(r.needle, 1e-3));
        }
        if ((order & 4) != 0 && (order & 8) != 0) {
            expect_ok(vbss_needle_destroy(r.needle));
            expect_ok(vbss_grasper_destroy(r.tools.tools[0]));
        }
        needles_end(&r);
    }
}

int test_needle_removal(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(held_needle_can_be_removed),
        harness_test(holding_tool_can_be_removed),
        harness_test(swaged_needle_can_be_removed),
        harness_test(context_end_destroys_held_needle_in_any_order),
    };
    return cmocka_run_group_tests_name("scene.needle_removal", tests, NULL, NULL);
}
