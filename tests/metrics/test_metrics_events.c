/* A whole trial told in events, against figures worked out by hand. */
#include "base/rotation.h"
#include "fixture.h"

static void deviation_is_geodesic_on_cylinder(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    report(&f, VBSS_METRICS_EVENT_NEEDLE_APPEARS, 0, 1.0, 0.0);
    puncture(&f, 0, 2.0, 0.2, 0.0);     /* an arc of 6.5 mm x 0.2 */
    puncture(&f, 1, 3.0, -0.6, 5.2e-3); /* legs of 3.9 and 5.2 mm: 6.5 */
    const vbss_metrics_report r = report_of(&f);
    expect_near(1.3, r.deviation_mm[0], 1e-12);
    expect_near(6.5, r.deviation_mm[1], 1e-12);
    assert_int_equal(r.flags, VBSS_METRICS_FLAG_STARTED | VBSS_METRICS_FLAG_PUNCTURE_0 |
                                  VBSS_METRICS_FLAG_PUNCTURE_1);
    end(&f);
}

/* A cylinder that lies askew: what was put in by angle and height comes back. */
static void offsets_use_cylinder_in_any_pose(void **state)
{
    (void)state;
    const pose at = pose_make(vec3_make(0.1, -0.2, 0.05),
                              vbss_quat_from_rotation_vector(vec3_make(0.4, 1.1, -0.7)));
    for (int i = -3; i <= 3; i++) {
        double angle = 1.04 * i, axial = 2e-3 * i, r = 6.5e-3, got[2];
        double axis[3], centre[3], mark[3], place[3];
        vec3_store(axis, vec3_scale(quat_rotate(at.orientation, vec3_make(0.0, 0.0, 1.0)), 3.0));
        vec3_store(centre, pose_apply(at, vec3_make(0.0, 0.0, 0.4)));
        vec3_store(mark, pose_apply(at, vec3_make(r * cos(0.3), r * sin(0.3), 0.01)));
        vec3_store(place, pose_apply(at, vec3_make(2.0 * r * cos(0.3 + angle),
                                                   2.0 * r * sin(0.3 + angle), 0.01 + axial)));
        expect_ok(vbss_metrics_get_offset(axis, centre, mark, place, &got[0], &got[1]));
        expect_near(angle, got[0], 1e-12);
        expect_near(axial, got[1], 1e-14);
        expect_result(VBSS_ERROR_OUT_OF_RANGE,
                      vbss_metrics_get_offset(axis, centre, centre, place, &got[0], &got[1]));
        expect_result(VBSS_ERROR_NULL_ARGUMENT,
                      vbss_metrics_get_offset(axis, centre, mark, NULL, &got[0], &got[1]));
        expect_result(VBSS_ERROR_NULL_ARGUMENT,
                      vbss_metrics_get_offset(axis, centre, mark, place, NULL, &got[1]));
        axis[1] = (double)NAN;
        expect_result(VBSS_ERROR_NOT_FINITE,
                      vbss_metrics_get_offset(axis, centre, mark, place, &got[0], &got[1]));
    }
}

static void gap_and_maximum_gap(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    vbss_metrics_event e = event_of(VBSS_METRICS_EVENT_GAP, 0, 1.0);
    e.position[0] = 1e-3;
    e.other[0] = 1e-3;
    e.other[1] = 3e-4;
    e.other[2] = -4e-4;
    e.amount = 0.8e-3;
    expect_ok(vbss_metrics_add_event(f.metrics, &e));
    expect_near(0.5, report_of(&f).gap_mm, 1e-12);
    expect_near(0.8, report_of(&f).gap_largest_mm, 1e-12);
    e.amount = 0.0; /* the largest is no less than that of the points */
    expect_ok(vbss_metrics_add_event(f.metrics, &e));
    expect_near(0.5, report_of(&f).gap_largest_mm, 1e-12);
    end(&f);
}

static void time_runs_from_needle_to_second_cut(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    report(&f, VBSS_METRICS_EVENT_PHASE, 9, 2.0, 0.0);
    expect_same_bits(0.0, report_of(&f).time);
    report(&f, VBSS_METRICS_EVENT_NEEDLE_APPEARS, 0, 5.0, 0.0);
    report(&f, VBSS_METRICS_EVENT_TAIL, 1, 30.0, 17e-3);
    expect_same_bits(25.0, report_of(&f).time); /* still running */
    expect_near(17.0, report_of(&f).tail_mm[1], 1e-12);
    report(&f, VBSS_METRICS_EVENT_TAIL_CUT, 1, 90.0, 4e-3);
    expect_near(4.0, report_of(&f).tail_mm[1], 1e-12);
    assert_false(report_of(&f).flags & VBSS_METRICS_FLAG_STOPPED);
    report(&f, VBSS_METRICS_EVENT_TAIL_CUT, 0, 93.5, 5e-3);
    report(&f, VBSS_METRICS_EVENT_DROP, 0, 120.0, 0.0);
    expect_same_bits(88.5, report_of(&f).time);
    assert_true(report_of(&f).flags & VBSS_METRICS_FLAG_STOPPED);
    end(&f);
}

static void throw_type_and_order_are_reported(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    tie(&f, 0, 10.0, VBSS_METRICS_RELATION_FIRST);
    tie(&f, 1, 20.0, VBSS_METRICS_RELATION_UNKNOWN);
    tie(&f, 2, 30.0, VBSS_METRICS_RELATION_GRANNY);
    tie(&f, 1, 31.0, VBSS_METRICS_RELATION_SQUARE); /* known better, not tied again */
    const vbss_metrics_report r = report_of(&f);
    assert_int_equal(r.throw_count, 3);
    assert_int_equal(r.throw_records, 3);
    assert_int_equal(r.square_count, 1);
    assert_int_equal(r.granny_count, 1);
    assert_int_equal(r.unknown_count, 0);
    vbss_metrics_throw t;
    expect_ok(vbss_metrics_get_throw(f.metrics, 1, &t, sizeof t));
    assert_int_equal(t.number, 1);
    assert_int_equal(t.wraps, 1);
    assert_int_equal(t.handedness, -1);
    assert_int_equal(t.relation, VBSS_METRICS_RELATION_SQUARE);
    expect_same_bits(20.0, t.time);
    assert_int_equal(t.step, 20000);
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_metrics_get_throw(f.metrics, 3, &t, sizeof t));
    end(&f);
}

static void phases_partition_time(void **state)
{
    (void)state;
    static const double begins[] = {1.0, 4.0, 4.0, 9.5};
    fixture f;
    begin_and_make(&f);
    for (uint32_t i = 0; i < 4; i++) {
        report(&f, VBSS_METRICS_EVENT_PHASE, i % 2, begins[i], 0.0);
    }
    report(&f, VBSS_METRICS_EVENT_TRANSFER, 0, 12.0, 0.0);
    double sum = 0.0;
    for (uint32_t i = 0; i < 4; i++) {
        vbss_metrics_phase p;
        expect_ok(vbss_metrics_get_phase(f.metrics, i, &p, sizeof p));
        assert_int_equal(p.number, i % 2);
        assert_int_equal(p.ended, i < 3);
        expect_same_bits(begins[i], p.begin);
        expect_same_bits(i < 3 ? begins[i + 1] : 12.0, p.end);
        sum += p.end - p.begin;
    }
    expect_same_bits(11.0, sum);
    assert_int_equal(report_of(&f).phase_count, 4);
    end(&f);
}

static void incidents_are_counted(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    for (int i = 0; i < 3; i++) {
        report(&f, VBSS_METRICS_EVENT_TRANSFER, 0, 1.0, 0.0);
    }
    report(&f, VBSS_METRICS_EVENT_TRANSFER_MISSED, 0, 1.0, 0.0);
    report(&f, VBSS_METRICS_EVENT_DROP, 0, 1.0, 0.0);
    report(&f, VBSS_METRICS_EVENT_DROP, 5, 1.0, 0.0);
    report(&f, VBSS_METRICS_EVENT_HOST, 5, 1.0, 2.0);
    const vbss_metrics_report r = report_of(&f);
    assert_int_equal(r.transfers, 3);
    assert_int_equal(r.transfers_missed, 1);
    assert_int_equal(r.drops, 2);
    assert_int_equal(r.host_penalties, 1);
    end(&f);
}

int test_metrics_events(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(deviation_is_geodesic_on_cylinder),
        harness_test(offsets_use_cylinder_in_any_pose),
        harness_test(gap_and_maximum_gap),
        harness_test(time_runs_from_needle_to_second_cut),
        harness_test(throw_type_and_order_are_reported),
        harness_test(phases_partition_time),
        harness_test(incidents_are_counted),
    };
    return cmocka_run_group_tests_name("metrics.metrics_events", tests, NULL, NULL);
}
