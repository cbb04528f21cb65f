/* A real needle goes through both marks and comes back: the stitch and its undoing, each told once. */
#include <string.h>

#include "rig.h"
#include "fixtures/puncture_scenes.h"

#define SPEED 0.05 /* m/s */

static void needle_passes_in_out_and_back(void **state)
{
    (void)state;
    rig r;
    memset(&r, 0, sizeof r);
    r.context = harness_context(&r.memory);
    expect_ok(session_scene_piercing(r.context, &r.scene));
    expect_ok(vbss_session_create(r.scene.scene, &r.scene.config, &r.session));
    expect_ok(vbss_session_open(r.session, &r.s));
    const uint32_t steps =
        (uint32_t)((PUNCTURE_SCENE_ON + PUNCTURE_SCENE_BACK) / (SPEED * RIG_STEP));
    for (uint32_t i = 0; i < steps; i++) {
        expect_ok(puncture_scene_target(r.scene.scene, SPEED, RIG_STEP));
        expect_ok(vbss_session_step(r.session, 0.0, RIG_STEP));
    }
    rig_expect(&r, VBSS_SESSION_EVENT_APPEARED, 0, 0);
    rig_expect_phase(&r, VBSS_SESSION_PHASE_LOADING, 0);
    const vbss_session_event *e = rig_expect(&r, VBSS_SESSION_EVENT_PUNCTURE, SESSION_ENTRY, 0);
    assert_true(e->amount < 0.5); /* it was aimed at the mark, mm */
    rig_expect_phase(&r, VBSS_SESSION_PHASE_IN_DRAIN, 0);
    e = rig_expect(&r, VBSS_SESSION_EVENT_PUNCTURE, SESSION_EXIT, 0);
    assert_true(e->amount >
                0.5); /* a circle through one mark square to the wall misses the other */
    assert_int_equal(e->phase, VBSS_SESSION_PHASE_PULL_THROUGH);
    rig_expect_phase(&r, VBSS_SESSION_PHASE_PULL_THROUGH, 0);
    rig_expect(&r, VBSS_SESSION_EVENT_PUNCTURE, SESSION_EXIT, 1);
    rig_expect_phase(&r, VBSS_SESSION_PHASE_IN_DRAIN, 1);
    rig_expect(&r, VBSS_SESSION_EVENT_PUNCTURE, SESSION_ENTRY, 1);
    rig_expect_phase(&r, VBSS_SESSION_PHASE_LOADING, 1);
    rig_expect_quiet(&r);
    rig_end(&r);
}

int test_puncture(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(needle_passes_in_out_and_back)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
