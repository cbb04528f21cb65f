/* The score in the style of MISTELS, and its reasons. */
#include "fixture.h"

/* Done in 120 s from t = 10: 1.3 and 0.65 mm off, a gap of 0.5 mm, a knot that slips. */
static void do_task(const fixture *f)
{
    report(f, VBSS_METRICS_EVENT_NEEDLE_APPEARS, 0, 10.0, 0.0);
    puncture(f, 0, 20.0, 0.2, 0.0);
    puncture(f, 1, 30.0, 0.1, 0.0);
    tie(f, 0, 50.0, VBSS_METRICS_RELATION_FIRST);
    tie(f, 1, 70.0, VBSS_METRICS_RELATION_SQUARE);
    tie(f, 2, 90.0, VBSS_METRICS_RELATION_SQUARE);
    vbss_metrics_event e = event_of(VBSS_METRICS_EVENT_GAP, 0, 100.0);
    e.other[0] = 0.5e-3;
    e.amount = 0.9e-3; /* the largest, which does not count */
    e.tool = VBSS_METRICS_TOOL_RIGHT;
    e.force[1] = 2.5;
    expect_ok(vbss_metrics_add_event(f->metrics, &e));
    report(f, VBSS_METRICS_EVENT_TAIL_CUT, 0, 120.0, 4e-3);
    report(f, VBSS_METRICS_EVENT_TAIL_CUT, 1, 130.0, 4e-3);
    pull_at(f, 140.0, 2.0, 0.01, 3e-3, 1);
}

static void expect_sums(const fixture *f)
{
    const vbss_metrics_report r = report_of(f);
    double sum = 0.0;
    for (uint32_t i = 0; i < r.penalty_count; i++) {
        const vbss_metrics_penalty p = penalty_of(f, i);
        assert_true(p.text[0] != '\0');
        assert_true(p.kind >= VBSS_METRICS_PENALTY_DEVIATION);
        sum += p.amount;
    }
    expect_near(r.penalties, sum, 1e-9);
    expect_near(fmax(f->config.max_time - r.time - sum, 0.0), r.score, 1e-9);
}

static void score_is_time_minus_penalties(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    do_task(&f);
    const vbss_metrics_report r = report_of(&f);
    expect_same_bits(120.0, r.time);
    expect_near(10.0 * (1.3 + 0.65 + 0.5) + 10.0, r.penalties, 1e-9); /* 34.5 */
    expect_near(600.0 - 120.0 - 34.5, r.score, 1e-9);
    assert_true(r.flags & VBSS_METRICS_FLAG_FINAL);
    expect_sums(&f);
    assert_int_equal(r.penalty_count, 4);
    const vbss_metrics_penalty first = penalty_of(&f, 0), gap = penalty_of(&f, 2),
                               knot = penalty_of(&f, 3);
    assert_int_equal(first.kind, VBSS_METRICS_PENALTY_DEVIATION);
    assert_int_equal(first.number, 0);
    expect_near(1.3, first.measure, 1e-12);
    expect_near(13.0, first.amount, 1e-11);
    expect_same_bits(20.0, first.time);
    assert_int_equal(first.step, 20000);
    assert_int_equal(gap.kind, VBSS_METRICS_PENALTY_GAP);
    assert_int_equal(gap.tool, VBSS_METRICS_TOOL_RIGHT);
    expect_same_bits(2.5, gap.force[1]);
    assert_int_equal(knot.kind, VBSS_METRICS_PENALTY_TIGHTNESS);
    expect_same_bits(10.0, knot.amount);
    expect_same_bits(140.0, knot.time);
    end(&f);
}

/* Korndorffer et al. 2005: 512 is the proficiency of experts; 88 s without a fault. */
static void flawless_expert_scores_512(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    report(&f, VBSS_METRICS_EVENT_NEEDLE_APPEARS, 0, 0.0, 0.0);
    puncture(&f, 0, 10.0, 0.0, 0.0);
    puncture(&f, 1, 10.0, 0.0, 0.0);
    for (uint32_t i = 0; i < 3; i++) {
        tie(&f, i, 20.0, VBSS_METRICS_RELATION_SQUARE);
    }
    report(&f, VBSS_METRICS_EVENT_GAP, 0, 30.0, 0.0);
    report(&f, VBSS_METRICS_EVENT_TAIL_CUT, 0, 88.0, 4e-3);
    report(&f, VBSS_METRICS_EVENT_TAIL_CUT, 1, 88.0, 4e-3);
    assert_false(report_of(&f).flags & VBSS_METRICS_FLAG_FINAL); /* the knot was not pulled */
    pull_at(&f, 90.0, 2.0, 0.01, 0.0, 1);
    pull_at(&f, 91.0, 2.0, 0.01, 0.0, 1);
    expect_same_bits(512.0, report_of(&f).score);
    assert_int_equal(report_of(&f).penalty_count, 0);
    assert_true(report_of(&f).flags & VBSS_METRICS_FLAG_FINAL);
    end(&f);
}

static void tightness_method_is_applied(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    f.config.tightness_test = VBSS_METRICS_TEST_STRAIN;
    make(&f);
    do_task(&f);
    assert_int_equal(report_of(&f).tightness_pull, VBSS_METRICS_TIGHTNESS_SLIPS);
    expect_near(600.0 - 120.0 - 24.5, report_of(&f).score, 1e-9);
    end(&f);
}

static void every_fault_has_weight(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    f.config.throws_wanted = 5;
    f.config.weight_throw = 1.0;
    f.config.weight_granny = 20.0;
    f.config.weight_attempt = 3.0;
    f.config.weight_drop = 7.0;
    f.config.weight_transfer = 11.0;
    f.config.weight_host = 0.5;
    make(&f);
    do_task(&f);
    double before = report_of(&f).penalties - 2.0; /* two throws are missing */
    tie(&f, 3, 150.0, VBSS_METRICS_RELATION_GRANNY);
    take_back(&f, VBSS_METRICS_EVENT_PUNCTURE, 1, 151.0);
    puncture(&f, 1, 152.0, 0.1, 0.0);
    report(&f, VBSS_METRICS_EVENT_DROP, 1, 153.0, 0.0);
    report(&f, VBSS_METRICS_EVENT_TRANSFER_MISSED, 1, 154.0, 0.0);
    report(&f, VBSS_METRICS_EVENT_TRANSFER, 1, 155.0, 0.0);
    report(&f, VBSS_METRICS_EVENT_HOST, 1, 156.0, 8.0);
    expect_near(before + 1.0 + 20.0 + 3.0 + 7.0 + 11.0 + 4.0, report_of(&f).penalties, 1e-9);
    expect_sums(&f);
    end(&f);
}

static void zero_weight_faults_are_reported(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    report(&f, VBSS_METRICS_EVENT_NEEDLE_APPEARS, 0, 0.0, 0.0);
    tie(&f, 1, 1.0, VBSS_METRICS_RELATION_GRANNY);
    assert_int_equal(report_of(&f).penalty_count, 1);
    assert_int_equal(penalty_of(&f, 0).kind, VBSS_METRICS_PENALTY_GRANNY);
    expect_same_bits(0.0, penalty_of(&f, 0).amount);
    vbss_metrics_penalty p;
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_metrics_get_penalty(f.metrics, 1, &p, sizeof p));
    end(&f);
}

/* ---- what takes all */

static void expect_zero(const fixture *f, vbss_metrics_penalty_kind kind, uint32_t flag)
{
    const vbss_metrics_report r = report_of(f);
    expect_same_bits(0.0, r.score);
    assert_true(r.flags & VBSS_METRICS_FLAG_FINAL);
    assert_true((r.flags & flag) == flag);
    assert_int_equal(penalty_of(f, r.penalty_count - 1).kind, kind);
    expect_sums(f);
}

static void timeout_is_at_limit(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    report(&f, VBSS_METRICS_EVENT_NEEDLE_APPEARS, 0, 10.0, 0.0);
    report(&f, VBSS_METRICS_EVENT_PHASE, 0, 609.0, 0.0);
    expect_same_bits(1.0, report_of(&f).score);
    report(&f, VBSS_METRICS_EVENT_PHASE, 0, 610.0, 0.0);
    expect_zero(&f, VBSS_METRICS_PENALTY_TIMEOUT, VBSS_METRICS_FLAG_TIMEOUT);
    expect_same_bits(610.0, penalty_of(&f, 0).time);
    end(&f);
}

static void torn_drain_or_thread_scores_zero_until_undone(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    do_task(&f);
    double score = report_of(&f).score;
    report(&f, VBSS_METRICS_EVENT_AVULSED, 0, 200.0, 0.0);
    expect_zero(&f, VBSS_METRICS_PENALTY_AVULSED, VBSS_METRICS_FLAG_AVULSED);
    expect_near(score, penalty_of(&f, 4).amount, 1e-9);
    take_back(&f, VBSS_METRICS_EVENT_AVULSED, 0, 201.0);
    expect_same_bits(score, report_of(&f).score);
    report(&f, VBSS_METRICS_EVENT_BROKEN, 0, 202.0, 0.0);
    expect_zero(&f, VBSS_METRICS_PENALTY_BROKEN, VBSS_METRICS_FLAG_BROKEN);
    end(&f);
}

static void abandoned_trial_has_no_score(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    report(&f, VBSS_METRICS_EVENT_NEEDLE_APPEARS, 0, 0.0, 0.0);
    report(&f, VBSS_METRICS_EVENT_TAIL_CUT, 0, 20.0, 4e-3);
    expect_same_bits(580.0, report_of(&f).score);
    expect_ok(vbss_metrics_finish(f.metrics));
    expect_zero(&f, VBSS_METRICS_PENALTY_INCOMPLETE, VBSS_METRICS_FLAG_FINISHED);
    end(&f);
}

int test_metrics_score(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(score_is_time_minus_penalties),
        harness_test(flawless_expert_scores_512),
        harness_test(tightness_method_is_applied),
        harness_test(every_fault_has_weight),
        harness_test(zero_weight_faults_are_reported),
        harness_test(timeout_is_at_limit),
        harness_test(torn_drain_or_thread_scores_zero_until_undone),
        harness_test(abandoned_trial_has_no_score),
    };
    return cmocka_run_group_tests_name("metrics.metrics_score", tests, NULL, NULL);
}
