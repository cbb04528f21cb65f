/* Needles in jaws: a step that fails changes nothing; jaws of the greatest length are restored. */
#include <stdlib.h>

#include "fixtures/solver_of.h"
#include "scene/needles_rig.h"
#include "scene/api/api.h"
#include "scene/tools/tools.h"
#include "scene/world/world.h"

/* Jaws of the greatest length hold it by their ends, more than a metre from the pivot. */
static void long_jaws_are_restored(void **state)
{
    (void)state;
    needles_rig r;
    needles_begin_scene(&r);
    r.tools.config.driver_length = 1.0;
    r.tools.config.driver_radius = 2e-3;
    r.tools.config.driver_opening = 0.02;
    needles_add_across(&r, 0.5 * r.config.arc * r.config.radius, vec3_make(1e-3, 0.0, 0.0));
    tools_add(&r.tools, vec3_make(0.0, 0.0, -1e-7));
    tools_open(&r.tools, 0, 0.0);
    for (int i = 0; i < 50 && tools_state(&r.tools, 0).grasp_count == 0; i++) {
        tools_steps(&r.tools, 1);
    }
    assert_int_equal(tools_state(&r.tools, 0).grasp_count, 1);
    uint64_t hash = small_hash(&r.tools.s);
    small_state saved = small_save(&r.tools.s);
    tools_steps(&r.tools, 5);
    expect_ok(vbss_scene_restore(r.tools.s.scene, saved.bytes, saved.count));
    assert_true(small_hash(&r.tools.s) == hash);
    free(saved.bytes);
    needles_end(&r);
}

/* ---- steps that fail */

typedef struct shown {
    uint64_t hash;
    vbss_needle_state needle;
    vbss_grasper_state tool;
    vbss_scene_grasp grasp;
    vec3 points[9];
    scene_needle_grasp hold;
    bool has_grasp;
} shown;

static void show(const needles_rig *r, shown *l)
{
    vbss_view view;
    memset(l, 0, sizeof *l);
    l->hash = small_hash(&r->tools.s);
    l->needle = needles_state(r);
    l->tool = tools_state(&r->tools, 0);
    expect_ok(vbss_needle_get_view(r->needle, VBSS_NEEDLE_VIEW_POINTS, &view, sizeof view));
    assert_int_equal(view.count, 9);
    memcpy(l->points, view.data, sizeof l->points);
    memcpy(&l->hold,
           &vbss_scene_body(small_object(&r->tools.s), r->tools.bodies[0])->rigid.needle_grasp,
           sizeof l->hold);
    l->has_grasp = vbss_scene_get_grasp(r->tools.s.scene, r->tools.bodies[0], 0, &l->grasp,
                                        sizeof l->grasp) == VBSS_OK;
}

enum { BALLS = 24 };

/* Balls along the arc, below the needle. */
static uint32_t add_brush(needles_rig *r)
{
    vbss_scene_capsule balls[BALLS];
    uint32_t body_of_balls = 0;
    double length = r->config.arc * r->config.radius;
    for (int i = 0; i < BALLS; i++) {
        vec3 at = needles_place(r, length * (i + 0.5) / BALLS, NULL);
        balls[i].radius = 0.3e-3;
        vec3_store(balls[i].begin, at);
        vec3_store(balls[i].end, at);
    }
    r->tools.s.rigid.kind = VBSS_SCENE_RIGID_DRIVEN;
    r->tools.s.rigid.capsules = balls;
    r->tools.s.rigid.capsule_count = BALLS;
    vec3_store(r->tools.s.rigid.position, vec3_make(0.0, 0.0, -5e-3));
    expect_ok(vbss_scene_add_rigid(r->tools.s.scene, &r->tools.s.rigid, &body_of_balls));
    return body_of_balls;
}

/* In every step the balls are told first to go where all of them all but touch the needle: there is no room for that. What
 * is told of the tool is done when they stay. */
static void expect_nothing_changed(uint32_t contacts, uint32_t candidates)
{
    needles_rig r;
    vbss_scene_event event;
    uint32_t holding = 0, taken = 0, let_go = 0;
    needles_begin(&r);
    r.tools.s.config.contact_capacity = contacts;
    r.tools.s.config.candidate_capacity = candidates;
    r.tools.s.config.capsule_capacity = 64;
    set_step_operations(&r.tools.s.config, 0);
    small_create(&r.tools.s);
    needles_add_across(&r, 0.5 * r.config.arc * r.config.radius, vec3_zero());
    tools_add(&r.tools, vec3_make(0.0, 0.0, -2e-3));
    uint32_t brush = add_brush(&r);
    for (uint32_t i = 0; i < 200; i++) {
        shown before, after;
        tools_open(&r.tools, 0, i < 120 ? 0.0 : 1.0);
        tools_move(&r.tools, 0, vec3_make(1e-6 * i, 0.0, -2e-3));
        small_move(&r.tools.s, brush, vec3_make(0.0, 0.0, -0.66e-3));
        show(&r, &before);
        expect_result(VBSS_ERROR_CAPACITY, vbss_scene_step(r.tools.s.scene, 1e-3));
        show(&r, &after);
        assert_memory_equal(&before, &after, sizeof before);
        small_move(&r.tools.s, brush, vec3_make(0.0, 0.0, -5e-3));
        tools_steps(&r.tools, 1);
        taken += tools_happened(&r.tools, VBSS_SCENE_EVENT_GRASP, &event);
        let_go += tools_happened(&r.tools, VBSS_SCENE_EVENT_RELEASE, &event);
        holding += before.has_grasp;
    }
    assert_int_equal(taken, 1);
    assert_int_equal(let_go, 1);
    assert_true(holding > 50);
    needles_end(&r);
}

static void failed_step_changes_nothing(void **state)
{
    (void)state;
    expect_nothing_changed(16, 4096);
    expect_nothing_changed(256, 16);
}

int test_needle_rollback(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(long_jaws_are_restored),
        harness_test(failed_step_changes_nothing),
    };
    return cmocka_run_group_tests_name("scene.needle_rollback", tests, NULL, NULL);
}
