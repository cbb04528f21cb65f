/* Room is fixed when a measurement is made: what does not fit is told or counted; a session of ten minutes fits. */
#include "fixture.h"

static void full_lists_are_reported_and_change_nothing(void **state)
{
    (void)state;
    static const vbss_metrics_event_kind kinds[] = {
        VBSS_METRICS_EVENT_THROW, VBSS_METRICS_EVENT_PHASE, VBSS_METRICS_EVENT_DROP};
    fixture f;
    begin(&f);
    f.config.throw_capacity = f.config.phase_capacity = f.config.incident_capacity = 2;
    make(&f);
    for (int i = 0; i < 3; i++) {
        const char *text;
        report(&f, kinds[i], 0, 1.0, 0.0);
        report(&f, kinds[i], 1, 1.0, 0.0);
        uint64_t hash = hash_of(f.metrics);
        vbss_metrics_event e = event_of(kinds[i], 2, 2.0);
        expect_result(VBSS_ERROR_CAPACITY, vbss_metrics_add_event(f.metrics, &e));
        expect_ok(vbss_context_get_last_error(f.context, NULL, &text));
        assert_non_null(strstr(text, "room for 2"));
        assert_true(hash_of(f.metrics) == hash);
    }
    puncture(&f, 0, 1.0, 0.1, 0.0); /* a withdrawal would be an incident */
    vbss_metrics_event e = event_of(VBSS_METRICS_EVENT_PUNCTURE, 0, 2.0);
    e.undone = 1;
    expect_result(VBSS_ERROR_CAPACITY, vbss_metrics_add_event(f.metrics, &e));
    assert_true(report_of(&f).flags & VBSS_METRICS_FLAG_PUNCTURE_0);
    end(&f);
}

static void motion_above_capacity_is_counted(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    f.config.duration = 2.0;
    make(&f);
    for (int i = 0; i <= 300; i++) {
        double t = i / 100.0;
        vbss_metrics_sample s;
        expect_ok(vbss_metrics_sample_init(&s, sizeof s));
        s.valid = 15;
        s.time = t;
        s.position[0][0] = 0.1 * reach(t);
        s.force[0][0] = 1.0;
        expect_ok(vbss_metrics_add_sample(f.metrics, &s));
    }
    expect_ok(vbss_metrics_finish(f.metrics));
    assert_int_equal(report_of(&f).ticks, 200);
    assert_int_equal(report_of(&f).ticks_lost, 101);
    expect_near(2.0, motion_of(&f, 0, VBSS_METRICS_PHASE_ALL).force_integral, 1e-9);
    report(&f, VBSS_METRICS_EVENT_DROP, 0, 3.0, 0.0); /* events go on */
    end(&f);
}

/* The clock may jump: nothing is walked through for ever. */
static void long_silence_costs_no_time(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    for (int i = 0; i < 10; i++) {
        show(&f, 3, 0.01 * i, vec3_zero(), vec3_zero());
    }
    show(&f, 3, 9e8, vec3_make(1.0, 0.0, 0.0), vec3_zero());
    show(&f, 3, 9e8 + 0.01, vec3_make(2.0, 0.0, 0.0), vec3_zero());
    expect_ok(vbss_metrics_finish(f.metrics));
    assert_int_equal(report_of(&f).ticks, 60000);
    expect_same_bits(0.0, motion_of(&f, 0, VBSS_METRICS_PHASE_ALL).path_length);
    end(&f);
}

static vec3 swinging(double t)
{
    return vec3_make(0.02 * sin(2.0 * t), 0.01 * cos(2.0 * t), 0.0);
}

/* 600 s at 100 Hz, both tools: the whole path, with nothing lost and no more memory. */
static void ten_minutes_are_measured(void **state)
{
    (void)state;
    fixture f;
    vbss_context_statistics before, after;
    begin_and_make(&f);
    expect_ok(vbss_context_get_statistics(f.context, &before, sizeof before));
    report(&f, VBSS_METRICS_EVENT_NEEDLE_APPEARS, 0, 0.0, 0.0);
    for (int i = 0; i < 60000; i++) {
        double t = i / 100.0;
        show(&f, 3, t, swinging(t), swinging(t));
    }
    expect_ok(vbss_metrics_finish(f.metrics));
    const vbss_metrics_motion m = motion_of(&f, 0, VBSS_METRICS_PHASE_ALL);
    expect_ok(vbss_context_get_statistics(f.context, &after, sizeof after));
    assert_true(before.bytes_allocated == after.bytes_allocated);
    assert_true(before.bytes_peak < 6000000);
    assert_int_equal(report_of(&f).ticks, 60000);
    assert_int_equal(report_of(&f).ticks_lost, 0);
    expect_near(599.99, m.time, 1e-6); /* from the first sample to the last */
    expect_near(0.0, m.idle_time, 1.0);
    /* the path of an ellipse with half axes a, b: 4 a E(1 - b^2/a^2), E(0.75) = 1.2110560 (Abramowitz and Stegun 17.6),
     * 600 s x 2 rad/s of it */
    expect_near(4.0 * 0.02 * 1.2110560 * 600.0 / PI, m.path_length, 0.02);
    assert_false(m.valid & VBSS_METRICS_HAS_SPARC); /* too long for one movement */
    end(&f);
}

int test_metrics_capacities(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(full_lists_are_reported_and_change_nothing),
        harness_test(motion_above_capacity_is_counted),
        harness_test(long_silence_costs_no_time),
        harness_test(ten_minutes_are_measured),
    };
    return cmocka_run_group_tests_name("metrics.metrics_capacities", tests, NULL, NULL);
}
