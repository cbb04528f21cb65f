/* Whether a bend holds, and the force at which it slips, do not depend on the step. The whole table of kinds, friction, steps
 * and meshes is scene.bends_table; this is one step and mesh of it. */
#include "scene/bend_case.h"

/* Offline nothing is truncated. */
static bend_outcome run(bend_kind kind, double friction, double step, double segment,
                        vbss_scene_mode mode)
{
    const bend_outcome outcome = bend_case_run(kind, friction, step, segment, mode);
    assert_true(mode == VBSS_SCENE_MODE_REAL_TIME || outcome.clamped == 0);
    return outcome;
}

/* Reference: the middle of steps from 0.2 to 1 ms and segments of 0.2 and 0.3 mm. */
static void bends_slip_below_critical_friction(void **state)
{
    (void)state;
    const bend_outcome grief = run(BEND_GRIEF, 0.2, 1e-3, 0.3e-3, VBSS_SCENE_MODE_OFFLINE);
    const bend_outcome granny = run(BEND_GRANNY, 0.2, 1e-3, 0.3e-3, VBSS_SCENE_MODE_OFFLINE);
    assert_int_equal(BEND_SLIPS, grief.result);
    assert_int_equal(BEND_SLIPS, granny.result);
    expect_near(1.0, grief.force / 0.17, 0.2);
    expect_near(1.0, granny.force / 0.73, 0.2);
}

static void bends_hold_above_critical_friction(void **state)
{
    (void)state;
    for (bend_kind kind = BEND_REEF; kind <= BEND_GRIEF; kind++) {
        if (kind != BEND_THIEF) {
            const bend_outcome at = run(kind, 0.4, 1e-3, 0.3e-3, VBSS_SCENE_MODE_OFFLINE);
            assert_int_equal(BEND_HOLDS, at.result);
        }
    }
}

/* No friction up to 0.5 locks it. */
static void thief_slips(void **state)
{
    (void)state;
    assert_int_equal(BEND_SLIPS,
                     run(BEND_THIEF, 0.5, 1e-3, 0.3e-3, VBSS_SCENE_MODE_OFFLINE).result);
}

static void real_time_bends_have_same_results(void **state)
{
    (void)state;
    assert_int_equal(BEND_SLIPS,
                     run(BEND_GRIEF, 0.2, 1e-3, 0.3e-3, VBSS_SCENE_MODE_REAL_TIME).result);
    assert_int_equal(BEND_HOLDS,
                     run(BEND_GRIEF, 0.4, 1e-3, 0.3e-3, VBSS_SCENE_MODE_REAL_TIME).result);
}

int test_bends(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bends_slip_below_critical_friction),
        cmocka_unit_test(bends_hold_above_critical_friction),
        cmocka_unit_test(thief_slips),
        cmocka_unit_test(real_time_bends_have_same_results),
    };
    return cmocka_run_group_tests_name("scene.bends", tests, NULL, NULL);
}
