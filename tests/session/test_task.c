/* The task from the needle's appearing to both tails cut: each phase in its turn, each event once, and what the metrics make
 * of them. */
#include "rig.h"

static void cut(rig *r, uint32_t limb, double left)
{
    double lost;
    if (limb == SESSION_ENTRY) {
        lost = r->observation.thread_length - r->observation.holes[0].arc - left;
        r->observation.thread_length -= lost;
        return;
    }
    /* what goes through the drain is a new piece */
    lost = r->observation.holes[1].arc - left;
    r->observation.thread = 40;
    r->observation.thread_length -= lost;
    rig_thread_through(r, RIG_ENTRY, r->observation.holes[0].arc - lost);
    rig_thread_through(r, RIG_EXIT, left);
}

static void task_completes_phase_by_phase(void **state)
{
    (void)state;
    rig r;
    vbss_metrics_report report;
    rig_begin(&r);
    rig_to_cut(&r);
    vbss_session_status status = rig_status(&r);
    assert_int_equal(status.phase, VBSS_SESSION_PHASE_CUT);
    assert_int_equal(status.throws, 3);
    assert_int_equal(status.seated, 3);
    assert_int_equal(status.transfers, 2);
    assert_int_equal(status.faults, 0);
    cut(&r, SESSION_EXIT, 4e-3);
    rig_run(&r, 0.5);
    expect_near(4e-3, rig_expect(&r, VBSS_SESSION_EVENT_CUT, SESSION_EXIT, 0)->amount, 1e-12);
    rig_expect_quiet(&r);
    cut(&r, SESSION_ENTRY, 5e-3);
    rig_run(&r, 0.5);
    expect_near(5e-3, rig_expect(&r, VBSS_SESSION_EVENT_CUT, SESSION_ENTRY, 0)->amount, 1e-12);
    rig_expect(&r, VBSS_SESSION_EVENT_DONE, 0, 0);
    rig_expect_phase(&r, VBSS_SESSION_PHASE_DONE, 0);
    rig_expect_quiet(&r);
    expect_ok(vbss_metrics_get_report(r.metrics, &report, sizeof report));
    const uint32_t known = VBSS_METRICS_FLAG_STARTED | VBSS_METRICS_FLAG_STOPPED |
                           VBSS_METRICS_FLAG_PUNCTURE_0 | VBSS_METRICS_FLAG_PUNCTURE_1 |
                           VBSS_METRICS_FLAG_GAP | VBSS_METRICS_FLAG_TAIL_0 |
                           VBSS_METRICS_FLAG_TAIL_1 | VBSS_METRICS_FLAG_FINISHED;
    assert_int_equal(report.flags & known, known);
    assert_int_equal(report.throw_count, 3);
    assert_int_equal(report.square_count, 2);
    assert_int_equal(report.transfers, 2);
    assert_int_equal(report.transfers_missed, 0);
    assert_int_equal(report.drops, 0);
    assert_int_equal(report.phase_count, 11);
    expect_near(0.5, report.deviation_mm[0], 1e-9);
    expect_near(1.0, report.deviation_mm[1], 1e-9);
    expect_near(5.0, report.tail_mm[0], 1e-9);
    expect_near(4.0, report.tail_mm[1], 1e-9);
    status = rig_status(&r);
    expect_near(status.time, report.time, 1e-9);
    expect_near(0.5, status.deviation_mm[0], 1e-9);
    assert_int_equal(status.metrics_lost, 0);
    rig_end(&r);
}

static void cut_order_is_free(void **state)
{
    (void)state;
    rig r;
    rig_begin(&r);
    rig_to_cut(&r);
    cut(&r, SESSION_ENTRY, 5e-3);
    rig_run(&r, 0.1);
    rig_expect(&r, VBSS_SESSION_EVENT_CUT, SESSION_ENTRY, 0);
    cut(&r, SESSION_ENTRY, 3e-3); /* once more, shorter */
    rig_run(&r, 0.1);
    expect_near(3e-3, rig_expect(&r, VBSS_SESSION_EVENT_CUT, SESSION_ENTRY, 0)->amount, 1e-12);
    assert_int_equal(rig_status(&r).phase, VBSS_SESSION_PHASE_CUT);
    cut(&r, SESSION_EXIT, 3e-3);
    rig_run(&r, 0.1);
    rig_expect(&r, VBSS_SESSION_EVENT_CUT, SESSION_EXIT, 0);
    rig_expect(&r, VBSS_SESSION_EVENT_DONE, 0, 0);
    rig_expect_phase(&r, VBSS_SESSION_PHASE_DONE, 0);
    rig_end(&r);
}

static void completed_phases_stay_complete(void **state)
{
    (void)state;
    rig r;
    rig_begin(&r);
    rig_to_cut(&r);
    cut(&r, SESSION_ENTRY, 5e-3);
    rig_run(&r, RIG_STEP);
    cut(&r, SESSION_EXIT, 5e-3);
    rig_run(&r, RIG_STEP);
    r.read = r.s->event_count;
    const double time = rig_status(&r).time;
    r.observation.hole_count = 0;
    r.observation.torn_fraction = 1.0;
    r.observation.thread_length = 0.01;
    rig_set_throw(&r, 0, 0, 0, 0);
    rig_run(&r, 7.0);
    rig_expect_quiet(&r);
    expect_same_bits(time, rig_status(&r).time);
    rig_end(&r);
}

static void entry_hole_may_be_at_either_target(void **state)
{
    (void)state;
    rig r;
    rig_begin(&r);
    rig_to_approach(&r);
    rig_pierce(&r, 3, 0, 0.0);
    rig_run(&r, RIG_STEP);
    rig_expect(&r, VBSS_SESSION_EVENT_PUNCTURE, SESSION_ENTRY, 0);
    rig_expect_phase(&r, VBSS_SESSION_PHASE_IN_DRAIN, 0);
    rig_pierce(&r, 4, 0, 2e-3); /* the same side again */
    rig_run(&r, RIG_STEP);
    rig_expect(&r, VBSS_SESSION_EVENT_STRAY, 4, 0);
    rig_pierce(&r, 5, 1, 0.0);
    rig_run(&r, RIG_STEP);
    rig_expect(&r, VBSS_SESSION_EVENT_PUNCTURE, SESSION_EXIT, 0);
    rig_expect_phase(&r, VBSS_SESSION_PHASE_PULL_THROUGH, 0);
    rig_leave(&r, 4);
    rig_run(&r, RIG_STEP);
    rig_expect(&r, VBSS_SESSION_EVENT_STRAY, 4, 1);
    rig_expect_quiet(&r);
    rig_end(&r);
}

/* What a host laid out: the hole farther from the needle is the one in. */
static void instant_stitch_is_read_from_tail(void **state)
{
    (void)state;
    rig r;
    rig_begin(&r);
    rig_pierce(&r, 1, 0, 1e-3);
    rig_pierce(&r, 2, 1, 2e-3);
    rig_thread_through(&r, 1, 0.121);
    rig_thread_through(&r, 2, 0.133);
    r.observation.holes[0].distance_from_tip = 0.154;
    r.observation.holes[1].distance_from_tip = 0.166;
    rig_run(&r, 0.1);
    rig_expect(&r, VBSS_SESSION_EVENT_PUNCTURE, SESSION_ENTRY, 0);
    rig_expect(&r, VBSS_SESSION_EVENT_PUNCTURE, SESSION_EXIT, 0);
    rig_expect(&r, VBSS_SESSION_EVENT_THREADED, SESSION_ENTRY, 0);
    rig_expect(&r, VBSS_SESSION_EVENT_THREADED, SESSION_EXIT, 0);
    rig_expect_phase(&r, VBSS_SESSION_PHASE_PULL_THROUGH, 0);
    rig_expect(&r, VBSS_SESSION_EVENT_TAIL, 0, 0);
    rig_expect_phase(&r, VBSS_SESSION_PHASE_THROW_1, 0);
    expect_near(17e-3, rig_status(&r).tail, 1e-12);
    expect_near(2.0, rig_status(&r).deviation_mm[SESSION_ENTRY], 1e-9);
    rig_end(&r);
}

int test_task(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(task_completes_phase_by_phase),
        cmocka_unit_test(cut_order_is_free),
        cmocka_unit_test(completed_phases_stay_complete),
        cmocka_unit_test(entry_hole_may_be_at_either_target),
        cmocka_unit_test(instant_stitch_is_read_from_tail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
