/* A solenoid that cannot burn. */
#include "device/stage_rig.h"

static const double h = 1e-3;

static bool stays_on(stage_rig *r, bool wanted)
{
    r->demand.solenoid = wanted;
    stage_rig_step(r, h, vec3_zero());
    return r->state.solenoid.is_on;
}

static stage_rig fresh(void)
{
    stage_rig r = stage_rig_wide();
    r.config.solenoid_time = 0.2;
    r.config.solenoid_duty = 0.2;
    stage_rig_begin(&r);
    return r;
}

static void on_while_requested(void **state)
{
    (void)state;
    stage_rig r = fresh();
    for (int i = 0; i < 20; i++) {
        assert_int_equal(stays_on(&r, i % 5 < 3), i % 5 < 3);
        assert_int_equal(r.flags, 0);
    }
    assert_int_equal(r.state.statistics.pulses, 4);
    expect_near(0.012, r.state.statistics.solenoid_on, 1e-15);
}

static void overlong_request_latches_off(void **state)
{
    (void)state;
    stage_rig r = fresh();
    int on = 0;
    for (int i = 0; i < 3000; i++) {
        on += stays_on(&r, true);
    }
    assert_true(on == 199 || on == 200);
    expect_near(0.2, r.state.statistics.solenoid_on, 1.5e-3);
    assert_true(r.state.statistics.solenoid_on <= 0.2 + 1e-12);
    assert_int_equal(r.flags, VBSS_OUTPUT_FLAG_SOLENOID_SPENT);
    assert_int_equal(r.state.statistics.solenoid_spent, 3000 - on);
    /* Let go for a moment it comes again. */
    assert_false(stays_on(&r, false));
    assert_true(stays_on(&r, true));
}

/* However it is asked for: in no stretch of time is it on for longer than its store and its part of that time. */
static void never_too_much(harness_source *source, void *user)
{
    enum { STEPS = 3000 };
    (void)user;
    stage_rig r = fresh();
    double on[STEPS + 1] = {0.0};
    bool wanted = true;
    for (int i = 0; i < STEPS; i++) {
        if (harness_draw_below(source, 8) == 0) {
            wanted = harness_draw_below(source, 10) > 0;
        }
        r.demand.has_fault = harness_draw_below(source, 50) == 0;
        on[i + 1] = on[i] + (stays_on(&r, wanted) ? h : 0.0);
    }
    /* The store fills by 0.25 s a second of rest: all of it counts in any stretch. */
    for (int from = 0; from < STEPS; from += 37) {
        for (int to = from + 1; to <= STEPS; to += 41) {
            double used = on[to] - on[from], rest = h * (to - from) - used;
            assert_true(used <= 0.2 + 0.25 * rest + 1e-9);
        }
    }
}

static void duty_cycle_is_limited(void **state)
{
    (void)state;
    harness_property("never_too_much", 60, never_too_much, NULL);
    stage_rig r = fresh();
    for (int i = 0; i < 60000; i++) { /* asked for as cleverly as can be */
        stays_on(&r, !r.state.solenoid.is_exhausted);
    }
    expect_near(0.2 * 60.0, r.state.statistics.solenoid_on, 0.02 * 60.0);
}

static void every_fault_turns_solenoid_off(void **state)
{
    (void)state;
    for (int reason = 0; reason < 5; reason++) {
        stage_rig r = fresh();
        assert_true(stays_on(&r, true));
        r.demand.has_fault = reason == 0;
        r.demand.block_solenoid = reason == 1;
        r.demand.age = reason == 2 ? 0.006 : 0.0;
        r.demand.input_age = reason == 3 ? 0.006 : 0.0;
        if (reason == 4) {
            vbss_output_latch_stop(&r.state);
        }
        assert_false(stays_on(&r, true));
        assert_true((r.flags & VBSS_OUTPUT_FLAG_SOLENOID_OFF) != 0);
        assert_int_equal(r.state.statistics.solenoid_off, 1);
        r.demand.has_fault = r.demand.block_solenoid = r.state.is_stopped = false;
        r.demand.age = r.demand.input_age = 0.0;
        assert_true(stays_on(&r, true));
    }
}

static void disabled_solenoid_stays_off(void **state)
{
    (void)state;
    stage_rig r = stage_rig_wide();
    r.config.solenoid_time = 0.0;
    stage_rig_begin(&r);
    for (int i = 0; i < 10; i++) {
        assert_false(stays_on(&r, i % 2 == 0));
    }
    r = stage_rig_wide();
    r.config.solenoid_duty = 0.0; /* once, and never again */
    stage_rig_begin(&r);
    for (int i = 0; i < 5000; i++) {
        stays_on(&r, i % 100 > 0);
    }
    assert_true(r.state.statistics.solenoid_on <= 1.0 + 1e-12);
    assert_false(r.state.solenoid.is_on);
}

int test_solenoid(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(on_while_requested),
        cmocka_unit_test(overlong_request_latches_off),
        harness_test(duty_cycle_is_limited),
        cmocka_unit_test(every_fault_turns_solenoid_off),
        cmocka_unit_test(disabled_solenoid_stays_off),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
