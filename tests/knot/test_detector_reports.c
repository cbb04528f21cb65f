/* What a detector tells of knots: its state, and the throws. */
#include "knot/detector_rig.h"
#include "fixtures/knot_body.h"

static void state_reports_knot(void **state)
{
    (void)state;
    static const struct {
        const char *knot;
        vbss_knot_name name;
        uint32_t throws, faults, crossings;
        int32_t signature, tristram;
        int64_t determinant, v2, v3;
    } knots[] = {
        {"", VBSS_KNOT_NAME_NONE, 0, VBSS_KNOT_FAULT_FEW, 0, 0, 0, 1, 0, 0},
        {"1", VBSS_KNOT_NAME_SINGLE, 1, VBSS_KNOT_FAULT_FEW | VBSS_KNOT_FAULT_FIRST, 3, -2, 0, 3, 1,
         1},
        {"2", VBSS_KNOT_NAME_DOUBLE, 1, VBSS_KNOT_FAULT_FEW, 5, -4, -2, 5, 3, 5},
        {"1=1", VBSS_KNOT_NAME_SQUARE, 2, VBSS_KNOT_FAULT_FEW | VBSS_KNOT_FAULT_FIRST, 6, 0, 0, 9,
         2, 0},
        {"2x1", VBSS_KNOT_NAME_SURGEONS_GRANNY, 2, VBSS_KNOT_FAULT_FEW | VBSS_KNOT_FAULT_GRANNY, 8,
         -6, -2, 15, 4, 6},
        {"2=1=1", VBSS_KNOT_NAME_FLS, 3, 0, 11, -4, -2, 45, 5, 5},
    };
    for (size_t i = 0; i < sizeof knots / sizeof knots[0]; i++) {
        detector_rig r;
        detector_rig_begin(&r);
        detector_rig_create(&r);
        detector_rig_tie(&r, knots[i].knot, 200);
        detector_rig_judge(&r);
        vbss_knot_state s = detector_rig_state(&r);
        assert_int_equal(s.name, knots[i].name);
        assert_int_equal(s.verdict, i == 0 ? VBSS_KNOT_VERDICT_NONE : VBSS_KNOT_VERDICT_CERTIFIED);
        assert_int_equal(s.reason, VBSS_KNOT_REASON_NONE);
        assert_int_equal(s.throw_count, knots[i].throws);
        assert_int_equal(s.faults, knots[i].faults);
        assert_int_equal(s.crossings, knots[i].crossings);
        assert_int_equal(s.certified, 1);
        assert_int_equal(s.signature, knots[i].signature);
        assert_int_equal(s.signature_tristram, knots[i].tristram);
        assert_true(s.determinant == knots[i].determinant);
        assert_true(s.v2 == knots[i].v2 && s.v3 == knots[i].v3);
        assert_int_equal(s.ends_free, 1);
        assert_int_equal(s.closures, 0); /* nothing else to compare with */
        assert_int_equal(s.steps, 1);
        assert_int_equal(s.reading_step, 1);
        detector_rig_expect_notation(&r, knots[i].knot);
        detector_rig_end(&r);
    }
}

static void non_stack_knot_is_reported(void **state)
{
    (void)state;
    detector_rig r;
    detector_rig_begin(&r);
    detector_rig_create(&r);
    detector_rig_figure_eight(&r);
    detector_rig_judge(&r);
    vbss_knot_state s = detector_rig_state(&r);
    assert_int_equal(s.name, VBSS_KNOT_NAME_OTHER);
    assert_int_equal(s.verdict, VBSS_KNOT_VERDICT_FORMED);
    assert_int_equal(s.throw_count, 0);
    assert_true(s.faults & VBSS_KNOT_FAULT_TYPE);
    assert_int_equal(s.crossings, 4);
    assert_int_equal(s.certified, 0);
    assert_int_equal(s.signature, 0);
    assert_true(s.determinant == 5 && s.v2 == -1 && s.v3 == 0);
    detector_rig_expect_notation(&r, "?");
    detector_rig_end(&r);
}

static void throws_are_counted_from_tissue_outward(void **state)
{
    (void)state;
    detector_rig r;
    vbss_knot_throw t = {0};
    detector_rig_begin(&r);
    detector_rig_create(&r);
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_knot_detector_get_throw(r.detector, 0, &t, sizeof t));
    detector_rig_tie(&r, "2=1x1", 200);
    detector_rig_judge(&r);
    double inside[2] = {r.line.tissue_place, r.line.tissue_place};
    const uint32_t sure = VBSS_KNOT_THROW_LOCATED | VBSS_KNOT_THROW_ORDERED;
    for (uint32_t i = 0; i < 3; i++) {
        t = detector_rig_throw(&r, i);
        assert_int_equal(t.verdict, VBSS_KNOT_VERDICT_CERTIFIED);
        assert_int_equal(t.wraps, i == 0 ? 2 : 1);
        assert_int_equal(t.handedness, i == 0 ? 1 : -1);
        assert_int_equal(t.flags, i == 2 ? sure | VBSS_KNOT_THROW_GRANNY : sure);
        assert_int_equal(t.reserved, 0);
        assert_true(0.0 < t.tail_places[0] && t.tail_places[0] < t.tail_places[1]);
        assert_true(t.tail_places[1] <= inside[0] && inside[1] <= t.long_places[0]);
        assert_true(t.long_places[0] < t.long_places[1] && t.long_places[1] < r.line.count - 1.0);
        double length = 0.0; /* of the tail beyond it */
        vec3 last = r.line.x[0];
        for (uint32_t k = 1; k < t.tail_places[0]; k++) {
            length += vec3_distance(last, r.line.x[k]);
            last = r.line.x[k];
        }
        length += vec3_distance(last, thread_line_at(&r.line, t.tail_places[0]));
        expect_near(length, t.tail_length, 1e-9);
        assert_true(length > 5e-3 && fabs(t.slip) < 0.5);
        inside[0] = t.tail_places[0];
        inside[1] = t.long_places[1];
    }
    const uint32_t none[] = {3, KNOT_THROWS, UINT32_MAX};
    for (int i = 0; i < 3; i++) {
        expect_result(VBSS_ERROR_NOT_FOUND,
                      vbss_knot_detector_get_throw(r.detector, none[i], &t, sizeof t));
    }
    detector_rig_end(&r);
}

static void throws_report_formed_and_last_seen_time(void **state)
{
    (void)state;
    detector_rig r;
    detector_rig_begin(&r);
    detector_rig_create(&r);
    detector_rig_tie(&r, "2", 100);
    detector_rig_judge(&r);
    detector_rig_tie(&r, "2=1", 150);
    detector_rig_steps(&r, 6);
    detector_rig_judge(&r);
    assert_true(detector_rig_throw(&r, 0).formed_step == 1);
    assert_true(detector_rig_throw(&r, 1).formed_step == 8 ||
                detector_rig_throw(&r, 1).formed_step == 2); /* if that was read at once */
    assert_true(detector_rig_throw(&r, 0).reading_step == 8);
    assert_true(detector_rig_throw(&r, 1).reading_step == 8);
    detector_rig_end(&r);
}

/* Some steps after anything has happened, so that it was read. */
static void expect_stage(const detector_rig *r, uint64_t step)
{
    const uint64_t at = step % MOVING_KNOT_PERIOD;
    const int32_t wraps = moving_knot_wraps(step);
    vbss_knot_state s = detector_rig_state(r);
    if (at == 5 || at == 89 || (at == 65 && wraps == 0)) {
        assert_int_equal(s.verdict, VBSS_KNOT_VERDICT_NONE);
        assert_int_equal(s.next_verdict, VBSS_KNOT_VERDICT_NONE);
        assert_int_equal(s.next_wraps, 0);
        assert_int_equal(s.next_handedness, 0);
        assert_int_equal(s.throw_count, 0);
    } else if (at == 28 || (at == 46 && wraps > 0)) {
        assert_int_equal(s.next_verdict,
                         at == 28 ? VBSS_KNOT_VERDICT_WRAPPING : VBSS_KNOT_VERDICT_PASSED);
        assert_int_equal(s.next_tool, 0);
        assert_int_equal(s.next_wraps, wraps);
        assert_int_equal(s.next_handedness, moving_knot_handedness(step));
        assert_true(at == 46 || detector_rig_winding(r, 0).sense == (wraps > 0 ? 1 : -1));
    } else if (at == 65) {
        assert_int_equal(s.verdict, VBSS_KNOT_VERDICT_CERTIFIED);
        assert_int_equal(s.throw_count, 1);
        assert_int_equal(detector_rig_throw(r, 0).wraps, wraps);
        assert_int_equal(detector_rig_throw(r, 0).handedness, moving_knot_handedness(step));
    }
}

/* The script of the moving knot, as a detector follows it: wound, passed, tied, undone; to either side. */
static void knot_is_tracked_while_tying(void **state)
{
    (void)state;
    knot_body_options options[] = {{VBSS_KNOT_METHOD_TOPOLOGY, 15000},
                                   {VBSS_KNOT_METHOD_PROJECTION, 15000}};
    for (int i = 0; i < 2; i++) {
        harness_memory memory;
        vbss_context *context = harness_context(&memory);
        void *detector = NULL;
        expect_ok(knot_body_create(context, &options[i], &detector));
        detector_rig r = {.context = context, .detector = detector};
        for (uint64_t step = 0; step < (uint64_t)4 * MOVING_KNOT_PERIOD; step++) {
            expect_ok(knot_body_step(detector));
            if (i == 0) {
                expect_stage(&r, step);
            }
            assert_in_range(detector_rig_state(&r).next_verdict, VBSS_KNOT_VERDICT_NONE,
                            VBSS_KNOT_VERDICT_PASSED);
        }
        harness_context_end(context, &memory);
    }
}

/* ---- when they are read */

static uint64_t begun(detector_rig *r, uint32_t steps)
{
    uint64_t before = detector_rig_statistics(r).readings;
    detector_rig_steps(r, steps); /* a reading begins in one and ends in the next */
    return detector_rig_statistics(r).readings - before;
}

static void readings_start_at_intervals(void **state)
{
    (void)state;
    const uint32_t intervals[] = {0, 1, 2, 3, 20, UINT32_MAX};
    for (int i = 0; i < 6; i++) {
        detector_rig r;
        detector_rig_begin(&r);
        r.config.step_budget = 1000000000;
        r.config.interval = intervals[i];
        detector_rig_create(&r);
        detector_rig_tie(&r, "1", 60);
        detector_rig_add_tools(&r, 3);
        r.tools[0].held = VBSS_KNOT_HELD_NOTHING;
        assert_true(begun(&r, 1) == 0);
        uint64_t last = 0, smallest = intervals[i] < 2 ? 2 : intervals[i];
        for (int k = 2; k <= 100; k++) {
            uint64_t ended = begun(&r, 1);
            bool wanted = k == 2 || (intervals[i] > 0 && (uint64_t)(k - 2) % smallest == 0);
            assert_true(ended == wanted);
            last = ended ? detector_rig_state(&r).reading_step : last;
            assert_true(last == detector_rig_state(&r).reading_step);
            assert_true(!ended || last == (uint64_t)k - 1);
        }
        detector_rig_end(&r);
    }
}

static void readings_start_at_events(void **state)
{
    (void)state;
    detector_rig r;
    detector_rig_begin(&r);
    r.config.interval = 0;
    r.config.step_budget = 1000000000;
    detector_rig_create(&r);
    detector_rig_wind(&r, 0.2);
    assert_true(begun(&r, 200) == 1);
    r.input.may_have_passed = 1;
    assert_true(begun(&r, 2) == 1);
    r.input.may_have_passed = 0;
    assert_true(begun(&r, 200) == 1); /* of the second of those steps */
    assert_true(begun(&r, 200) == 0);
    r.input.point_count = 90;
    assert_true(begun(&r, 200) == 1);
    r.tools[0].held = VBSS_KNOT_HELD_NEEDLE;
    assert_true(begun(&r, 200) == 1);
    r.tools[0].held = VBSS_KNOT_HELD_THREAD; /* and then every 20 steps, as long as it does */
    assert_true(begun(&r, 202) == 11);
    r.tools[0].held = VBSS_KNOT_HELD_NOTHING;
    assert_true(begun(&r, 200) == 1);
    r.input.tool_count = 0;
    detector_rig_wind(&r, 0.9); /* and as long as it winds */
    assert_true(begun(&r, 202) == 11);
    r.input.tool_count = 0;
    detector_rig_wind(&r, 0.2);
    assert_true(begun(&r, 200) == 1);
    detector_rig_end(&r);
}

int test_detector_reports(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(state_reports_knot),
        cmocka_unit_test(non_stack_knot_is_reported),
        cmocka_unit_test(throws_are_counted_from_tissue_outward),
        cmocka_unit_test(throws_report_formed_and_last_seen_time),
        cmocka_unit_test(knot_is_tracked_while_tying),
        cmocka_unit_test(readings_start_at_intervals),
        cmocka_unit_test(readings_start_at_events),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
