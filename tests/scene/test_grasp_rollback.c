/* Graspers: a step that fails changes nothing, nor do views. */
#include "fixtures/solver_of.h"
#include "scene/api/api.h"
#include "scene/tools/tools.h"
#include "scene/world/world.h"
#include "scene/tools_rig.h"

/* What graspers and grasps show, too, is as it was. */
typedef struct observation {
    uint64_t hash;
    vbss_grasper_state tool;
    double shown[28];
    vbss_scene_grasp grasp;
    bool has_grasp;
} observation;

static observation observe(const tools_rig *r)
{
    observation l;
    vbss_view view;
    memset(&l, 0, sizeof l);
    l.hash = small_hash(&r->s);
    l.tool = tools_state(r, 0);
    expect_ok(vbss_grasper_get_view(r->tools[0], VBSS_GRASPER_VIEW_CAPSULES, &view, sizeof view));
    memcpy(l.shown, view.data, sizeof l.shown);
    l.has_grasp =
        vbss_scene_get_grasp(r->s.scene, r->bodies[0], 0, &l.grasp, sizeof l.grasp) == VBSS_OK;
    return l;
}

/* Another thread lands on a floor far below and needs more contacts than there are, `fall` ms after the begin. */
static void begin_fall(tools_rig *r, double fall, uint32_t step_budget)
{
    tools_begin(r);
    set_step_operations(&r->s.config, step_budget);
    solver_of(&r->s.config)->attempt_limit =
        step_budget > 0 ? 3 : solver_values(&r->s.config).attempt_limit;
    r->s.config.floor = 1;
    r->s.config.floor_normal[1] = 0.0;
    r->s.config.floor_normal[2] = 1.0;
    r->s.config.floor_height = -0.2;
    r->s.config.contact_capacity = 24;
    r->config.exchange_distance = 1.0;
    small_create(&r->s);
    tools_thread(r, TOOLS_FIRST, 0.0);
    tools_add(r, vec3_make(0.0, -8e-3, -2e-3));
    double z = -0.2 + 0.5 * 9.81 * 1e-6 * fall * fall;
    r->s.thread.gravity[2] = -9.81;
    small_thread(&r->s, vec3_make(-0.02, 0.0, z), vec3_make(0.02, 0.0, z), 40, NULL);
}

static void expect_nothing_changed(uint32_t step_budget)
{
    uint32_t closing = 0, holding = 0, letting_go = 0;
    for (uint32_t fall = 20; fall <= 108; fall += fall == 20 ? 40 : fall < 95 ? 35 : 1) {
        tools_rig r;
        bool failed = false;
        begin_fall(&r, fall, step_budget);
        for (uint32_t i = 0; i < 200 && !failed; i++) {
            tools_open(&r, 0, i < 100 ? 0.0 : 1.0);
            tools_move(&r, 0, vec3_make(1e-6 * i, -8e-3, -2e-3));
            expect_ok(vbss_grasper_exchange(r.tools[0], VBSS_GRASPER_KIND_SHEARS));
            observation before = observe(&r);
            vbss_result result = vbss_scene_step(r.s.scene, 1e-3);
            failed = result != VBSS_OK;
            if (failed) {
                observation after = observe(&r);
                expect_result(VBSS_ERROR_CAPACITY, result);
                assert_memory_equal(&before, &after, sizeof before);
                expect_result(VBSS_ERROR_CAPACITY, vbss_scene_step(r.s.scene, 1e-3));
                closing += i > 5 && i < 40;
                holding += i < 100 && before.has_grasp;
                letting_go += i >= 100 && before.has_grasp;
                /* Without what was too much, what was told is done. */
                expect_ok(vbss_scene_remove(r.s.scene, 3));
                tools_steps(&r, 1);
                assert_true(small_hash(&r.s) != before.hash);
            }
        }
        assert_true(failed);
        tools_end(&r);
    }
    if (step_budget == 0) {
        assert_int_equal(closing, 1);
        assert_true(holding > 1);
        assert_int_equal(letting_go, 1);
    } else { /* it fails a little later, and so more often in one or the other */
        assert_true(closing > 0 && holding > 1 && letting_go > 0);
    }
}

static void failed_step_changes_nothing(void **state)
{
    (void)state;
    expect_nothing_changed(0);
    expect_nothing_changed(
        100000); /* it has waited before, with jaws that are not where they shall be */
}

int test_grasp_rollback(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(failed_step_changes_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
