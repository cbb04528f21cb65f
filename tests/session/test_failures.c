/* Each way to fail, which is for good; and what is near to it and does not fail. */
#include "rig.h"

static void expect_failed(rig *r, vbss_session_failure failure)
{
    rig_expect(r, VBSS_SESSION_EVENT_FAILED, (uint32_t)failure, 0);
    rig_expect_phase(r, VBSS_SESSION_PHASE_FAILED, 0);
    assert_int_equal(rig_status(r).failure, failure);
    rig_take(r, RIG_LEFT);
    rig_run(r, 0.3);
    rig_expect_quiet(r);
}

static uint32_t flags_of(const rig *r)
{
    vbss_metrics_report report;
    expect_ok(vbss_metrics_get_report(r->metrics, &report, sizeof report));
    assert_true((report.flags & (uint32_t)VBSS_METRICS_FLAG_FINISHED) != 0);
    expect_same_bits(0.0, report.score);
    return report.flags;
}

static void timeout(void **state)
{
    (void)state;
    rig r;
    rig_make(&r);
    r.scene.config.time_limit = 0.5;
    rig_start(&r);
    rig_run(&r, 0.499);
    rig_expect_quiet(&r);
    rig_run(&r, 0.1);
    expect_failed(&r, VBSS_SESSION_FAILURE_TIMEOUT);
    expect_near(0.5, rig_status(&r).time, 1e-9);
    rig_end(&r);
}

static void drain_torn_off(void **state)
{
    (void)state;
    rig r;
    rig_begin(&r);
    rig_to_approach(&r);
    r.observation.torn_fraction = 0.49;
    rig_run(&r, 0.3);
    rig_expect_quiet(&r);
    r.observation.torn_fraction = 0.5;
    rig_run(&r, RIG_STEP);
    expect_failed(&r, VBSS_SESSION_FAILURE_AVULSED);
    assert_true((flags_of(&r) & (uint32_t)VBSS_METRICS_FLAG_AVULSED) != 0);
    rig_end(&r);
}

static void thread_cut_early(void **state)
{
    (void)state;
    rig r;
    rig_begin(&r);
    rig_to_tail(&r);
    r.observation.thread_length -= 0.005;
    rig_run(&r, RIG_STEP);
    expect_failed(&r, VBSS_SESSION_FAILURE_CUT_EARLY);
    assert_true((flags_of(&r) & (uint32_t)VBSS_METRICS_FLAG_BROKEN) != 0);
    rig_end(&r);
}

static void thread_cut_before_stitch(void **state)
{
    (void)state;
    rig r;
    rig_begin(&r);
    r.observation.thread_length = 0.1;
    rig_run(&r, RIG_STEP);
    expect_failed(&r, VBSS_SESSION_FAILURE_CUT_EARLY);
    rig_end(&r);
}

/* The knot takes 4 mm of both limbs. */
static void to_located_knot(rig *r)
{
    rig_begin(r);
    rig_to_cut(r);
    r->s->knot.is_located = true;
    r->s->knot.end_arcs[SESSION_ENTRY] = r->observation.holes[0].arc + 4e-3;
    r->s->knot.end_arcs[SESSION_EXIT] = r->observation.holes[1].arc - 4e-3;
}

static void knot_cut_from_tail_side(void **state)
{
    (void)state;
    rig r;
    to_located_knot(&r);
    r.observation.thread_length = r.observation.holes[0].arc + 3.9e-3;
    rig_run(&r, RIG_STEP);
    expect_failed(&r, VBSS_SESSION_FAILURE_CUT_KNOT);
    rig_end(&r);
}

static void cut_limb(rig *r, double left)
{
    double lost = r->observation.holes[1].arc - left;
    r->observation.thread = 33;
    r->observation.thread_length -= lost;
    rig_thread_through(r, RIG_ENTRY, r->observation.holes[0].arc - lost);
    rig_thread_through(r, RIG_EXIT, left);
}

static void knot_cut_from_needle_side(void **state)
{
    (void)state;
    rig r;
    to_located_knot(&r);
    cut_limb(&r, 3.9e-3);
    rig_run(&r, RIG_STEP);
    expect_failed(&r, VBSS_SESSION_FAILURE_CUT_KNOT);
    rig_end(&r);
}

/* The detector may find a crossing of the hanging limbs far out, beyond a cut. */
static void cut_of_free_limb_inside_located_knot_does_not_fail(void **state)
{
    (void)state;
    rig r;
    to_located_knot(&r);
    cut_limb(&r, 3.9e-3);
    r.observation.free_length = 2.5e-3;
    rig_run(&r, RIG_STEP);
    expect_near(2.5e-3, rig_expect(&r, VBSS_SESSION_EVENT_CUT, SESSION_EXIT, 0)->amount, 1e-12);
    rig_expect_quiet(&r);
    rig_end(&r);
}

static void cut_distance_is_measured_from_knot(void **state)
{
    (void)state;
    rig r;
    to_located_knot(&r);
    cut_limb(&r, 4.1e-3);
    rig_run(&r, RIG_STEP);
    expect_near(0.1e-3, rig_expect(&r, VBSS_SESSION_EVENT_CUT, SESSION_EXIT, 0)->amount, 1e-12);
    r.observation.thread_length = r.observation.holes[0].arc + 4.2e-3;
    rig_run(&r, RIG_STEP);
    expect_near(0.2e-3, rig_expect(&r, VBSS_SESSION_EVENT_CUT, SESSION_ENTRY, 0)->amount, 1e-12);
    rig_end(&r);
}

static void stitch_cut_in_tissue(void **state)
{
    (void)state;
    rig r;
    rig_begin(&r);
    rig_to_cut(&r);
    cut_limb(&r, 2e-3);
    r.observation.holes[1].thread = r.scene.config.thread;
    rig_run(&r, RIG_STEP);
    rig_expect(&r, VBSS_SESSION_EVENT_FAILED, VBSS_SESSION_FAILURE_CUT_KNOT, 0);
    rig_end(&r);
}

static void thread_breaks_if_breakable(void **state)
{
    (void)state;
    rig r;
    rig_begin(&r);
    r.observation.max_tension = 100.0;
    rig_run(&r, 0.3);
    rig_expect_quiet(&r);
    rig_end(&r);
    rig_make(&r);
    r.scene.config.break_force = 20.0;
    rig_start(&r);
    r.observation.max_tension = 21.0;
    rig_run(&r, 0.04);
    r.observation.max_tension = 19.0; /* too short to break it */
    rig_run(&r, 0.1);
    rig_expect_quiet(&r);
    r.observation.max_tension = 21.0;
    rig_run(&r, 0.1);
    expect_failed(&r, VBSS_SESSION_FAILURE_BROKEN);
    assert_true((flags_of(&r) & (uint32_t)VBSS_METRICS_FLAG_BROKEN) != 0);
    rig_end(&r);
}

static void removed_body_ends_session(void **state)
{
    (void)state;
    rig r;
    rig_begin(&r);
    expect_ok(vbss_session_step(r.session, 0.0, 1e-3));
    expect_ok(vbss_scene_remove(r.scene.scene, r.scene.config.needle));
    r.read = r.s->event_count;
    expect_ok(vbss_session_step(r.session, 0.0, 1e-3));
    rig_expect(&r, VBSS_SESSION_EVENT_FAILED, VBSS_SESSION_FAILURE_LOST, 0);
    rig_expect_phase(&r, VBSS_SESSION_PHASE_FAILED, 0);
    expect_ok(vbss_session_step(r.session, 0.0, 1e-3));
    rig_expect_quiet(&r);
    rig_end(&r);
}

int test_failures(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(timeout),
        cmocka_unit_test(drain_torn_off),
        cmocka_unit_test(thread_cut_early),
        cmocka_unit_test(thread_cut_before_stitch),
        cmocka_unit_test(knot_cut_from_tail_side),
        cmocka_unit_test(knot_cut_from_needle_side),
        cmocka_unit_test(cut_of_free_limb_inside_located_knot_does_not_fail),
        cmocka_unit_test(cut_distance_is_measured_from_knot),
        cmocka_unit_test(stitch_cut_in_tissue),
        cmocka_unit_test(thread_breaks_if_breakable),
        cmocka_unit_test(removed_body_ends_session),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
