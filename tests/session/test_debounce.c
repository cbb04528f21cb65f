/* Nothing chatters: what flickers around a limit is told once or not at all. */
#include "rig.h"

static void condition_must_hold_for_dwell_time(void **state)
{
    (void)state;
    rig r;
    rig_begin(&r);
    for (int i = 0; i < 50; i++) {
        r.observation.tools[RIG_RIGHT].has_needle = i % 2 == 0;
        rig_run(&r, 0.049);
    }
    rig_expect_quiet(&r);
    rig_take(&r, RIG_RIGHT);
    rig_run(&r, 0.05);
    rig_expect_quiet(&r);
    rig_run(&r, 2e-3);
    rig_expect(&r, VBSS_SESSION_EVENT_TAKEN, 0, 0);
    rig_expect_phase(&r, VBSS_SESSION_PHASE_APPROACH, 0);
    rig_end(&r);
}

static void tail_at_limit_is_reported_once(void **state)
{
    (void)state;
    rig r;
    rig_begin(&r);
    rig_to_tail(&r);
    for (int i = 0; i < 20; i++) { /* from 19.2 to 20.8 mm and back */
        rig_thread_through(&r, RIG_ENTRY, 0.15 - 20e-3 + (i % 2 == 0 ? 0.8e-3 : -0.8e-3));
        rig_run(&r, 0.2);
    }
    rig_expect_quiet(&r);
    rig_thread_through(&r, RIG_ENTRY, 0.15 - 21.1e-3);
    rig_run(&r, 0.2);
    rig_expect(&r, VBSS_SESSION_EVENT_TAIL, 0, 1);
    rig_expect_phase(&r, VBSS_SESSION_PHASE_PULL_THROUGH, 1);
    rig_thread_through(&r, RIG_ENTRY, 0.15 - 20.5e-3); /* not good enough to come back */
    rig_run(&r, 0.2);
    rig_expect_quiet(&r);
    rig_end(&r);
}

static void tail_drawn_into_knot_was_long_enough(void **state)
{
    (void)state;
    rig r;
    rig_begin(&r);
    rig_to_tail(&r);
    rig_to_throw(&r, 0, RIG_RIGHT);
    rig_thread_through(&r, RIG_ENTRY, 0.15 - 5e-3);
    rig_run(&r, 1.0);
    rig_expect_quiet(&r);
    expect_near(5e-3, rig_status(&r).tail, 1e-12);
    rig_end(&r);
}

static void slit_at_limit_is_reported_once(void **state)
{
    (void)state;
    rig r;
    rig_begin(&r);
    rig_to_tail(&r);
    rig_to_throw(&r, 0, RIG_RIGHT);
    for (int i = 0; i < 20; i++) {
        rig_pull(&r, i % 2 == 0 ? 0.4 : 0.6, i % 2 == 0 ? 0.45e-3 : 0.95e-3);
        rig_run(&r, 0.2);
    }
    rig_expect_quiet(&r);
    rig_end(&r);
}

static void flickering_reading_is_no_throw(void **state)
{
    (void)state;
    rig r;
    rig_begin(&r);
    rig_to_tail(&r);
    for (int i = 0; i < 20; i++) {
        rig_set_throw(&r, 0, i % 2 == 0 ? 2 : 0, 1, VBSS_METRICS_RELATION_FIRST);
        rig_run(&r, 0.09);
    }
    rig_expect_quiet(&r);
    rig_end(&r);
}

static void flickering_knot_reports_paired_events(void **state)
{
    (void)state;
    rig r;
    vbss_random random;
    uint32_t tied = 0;
    rig_begin(&r);
    rig_to_tail(&r);
    vbss_random_seed(&random, 12, 2);
    for (int i = 0; i < 3000; i++) {
        uint32_t count = vbss_random_below(&random, 3);
        for (uint32_t k = 0; k < 3; k++) {
            rig_set_throw(&r, k, k < count ? 1 : 0, 1, VBSS_METRICS_RELATION_UNKNOWN);
        }
        r.observation.knot.throw_count = count;
        rig_pull(&r, vbss_random_uniform(&random), 2e-3 * vbss_random_uniform(&random));
        rig_run(&r, 0.3 * vbss_random_uniform(&random));
        for (; r.read < r.s->event_count; r.read++) { /* each undone what was, and no other */
            const vbss_session_event *e = vbss_session_event_at(r.s, r.read);
            if (e->kind == VBSS_SESSION_EVENT_THROW) {
                assert_int_equal(e->number, e->undone != 0 ? tied - 1 : tied);
                tied += e->undone != 0 ? UINT32_MAX : 1u;
            }
        }
        assert_int_equal(tied, rig_status(&r).throws);
        assert_true(rig_status(&r).seated <= tied);
    }
    assert_true(r.read > 1000);
    rig_end(&r);
}

int test_debounce(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(condition_must_hold_for_dwell_time),
        cmocka_unit_test(tail_at_limit_is_reported_once),
        cmocka_unit_test(tail_drawn_into_knot_was_long_enough),
        cmocka_unit_test(slit_at_limit_is_reported_once),
        cmocka_unit_test(flickering_reading_is_no_throw),
        cmocka_unit_test(flickering_knot_reports_paired_events),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
