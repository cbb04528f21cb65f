/* What is undone leaves the figures as if it had not been, but for attempts and records. */
#include "fixture.h"

static void withdrawn_puncture_is_an_attempt(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    puncture(&f, 1, 1.0, 0.3, 0.0);
    take_back(&f, VBSS_METRICS_EVENT_PUNCTURE, 1, 2.0);
    assert_false(report_of(&f).flags & VBSS_METRICS_FLAG_PUNCTURE_1);
    expect_same_bits(0.0, report_of(&f).deviation_mm[1]);
    assert_int_equal(report_of(&f).attempts[0], 0);
    assert_int_equal(report_of(&f).attempts[1], 1);
    puncture(&f, 1, 3.0, 0.1, 0.0);
    expect_near(0.65, report_of(&f).deviation_mm[1], 1e-12);
    assert_int_equal(report_of(&f).attempts[1], 1);
    end(&f);
}

static void untied_throw_is_removed_and_counted(void **state)
{
    (void)state;
    fixture f;
    vbss_metrics_throw t;
    begin_and_make(&f);
    tie(&f, 0, 1.0, VBSS_METRICS_RELATION_FIRST);
    tie(&f, 1, 2.0, VBSS_METRICS_RELATION_GRANNY);
    take_back(&f, VBSS_METRICS_EVENT_THROW, 1, 3.0);
    assert_int_equal(report_of(&f).throw_count, 1);
    assert_int_equal(report_of(&f).granny_count, 0);
    tie(&f, 1, 4.0, VBSS_METRICS_RELATION_SQUARE);
    assert_int_equal(report_of(&f).throw_count, 2);
    assert_int_equal(report_of(&f).throw_records, 3);
    assert_int_equal(report_of(&f).square_count, 1);
    expect_ok(vbss_metrics_get_throw(f.metrics, 1, &t, sizeof t));
    assert_int_equal(t.standing, 0);
    expect_same_bits(2.0, t.time);
    expect_same_bits(3.0, t.undone_time);
    end(&f);
}

static void rejected_cut_keeps_clock_running(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    report(&f, VBSS_METRICS_EVENT_NEEDLE_APPEARS, 0, 0.0, 0.0);
    report(&f, VBSS_METRICS_EVENT_TAIL_CUT, 0, 10.0, 4e-3);
    report(&f, VBSS_METRICS_EVENT_TAIL_CUT, 1, 12.0, 4e-3);
    take_back(&f, VBSS_METRICS_EVENT_TAIL_CUT, 0, 20.0);
    assert_false(report_of(&f).flags & VBSS_METRICS_FLAG_STOPPED);
    expect_same_bits(20.0, report_of(&f).time);
    end(&f);
}

static void undoing_everything_leaves_nothing(void **state)
{
    (void)state;
    static const vbss_metrics_event_kind kinds[] = {VBSS_METRICS_EVENT_NEEDLE_APPEARS,
                                                    VBSS_METRICS_EVENT_TAIL,
                                                    VBSS_METRICS_EVENT_TAIL_CUT,
                                                    VBSS_METRICS_EVENT_GAP,
                                                    VBSS_METRICS_EVENT_THROW,
                                                    VBSS_METRICS_EVENT_TRANSFER,
                                                    VBSS_METRICS_EVENT_TRANSFER_MISSED,
                                                    VBSS_METRICS_EVENT_DROP,
                                                    VBSS_METRICS_EVENT_HOST,
                                                    VBSS_METRICS_EVENT_AVULSED,
                                                    VBSS_METRICS_EVENT_BROKEN};
    fixture f;
    begin_and_make(&f);
    vbss_metrics_report none = report_of(&f);
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++) {
        report(&f, kinds[i], 1, 1.0, 1.0);
        vbss_metrics_report r = report_of(&f);
        assert_memory_not_equal(&r, &none, sizeof r);
        take_back(&f, kinds[i], 1, 1.0);
        r = report_of(&f);
        r.throw_records = 0;
        assert_memory_equal(&r, &none, sizeof r);
    }
    end(&f);
}

static void missing_fact_cannot_be_undone(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    puncture(&f, 0, 1.0, 0.1, 0.0);
    tie(&f, 0, 1.0, VBSS_METRICS_RELATION_FIRST);
    report(&f, VBSS_METRICS_EVENT_DROP, 4, 1.0, 0.0);
    uint64_t hash = hash_of(f.metrics);
    for (int kind = VBSS_METRICS_EVENT_NEEDLE_APPEARS; kind <= VBSS_METRICS_EVENT_BROKEN; kind++) {
        vbss_metrics_event e = event_of(kind, 1, 2.0);
        e.undone = 1;
        expect_result(kind == VBSS_METRICS_EVENT_PHASE ? VBSS_ERROR_OUT_OF_RANGE /* never can */
                                                       : VBSS_ERROR_NOT_FOUND,
                      vbss_metrics_add_event(f.metrics, &e));
        assert_true(hash_of(f.metrics) == hash);
    }
    end(&f);
}

int test_metrics_undone(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(withdrawn_puncture_is_an_attempt),
        harness_test(untied_throw_is_removed_and_counted),
        harness_test(rejected_cut_keeps_clock_running),
        harness_test(undoing_everything_leaves_nothing),
        harness_test(missing_fact_cannot_be_undone),
    };
    return cmocka_run_group_tests_name("metrics.metrics_undone", tests, NULL, NULL);
}
