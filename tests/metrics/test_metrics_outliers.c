/* Samples that no hand can have reached are counted and bridged, and lasting jumps are no motion. */
#include "fixture.h"

enum { SAMPLES = 1735 };
#define RATE 30.0

/* A hand at work: 0.05 m/s in the mean, 0.16 m/s at most. */
static vec3 working(double t)
{
    return vec3_make(0.04 * sin(0.9 * t), 0.03 * sin(1.7 * t + 0.4), 0.02 * sin(3.1 * t));
}

/* So many samples from the first one on are this far off; `rate` Hz. */
typedef struct fault {
    int first, count;
    double distance, rate;
} fault;

static vbss_metrics_motion measured(fixture *f, const fault *wrong)
{
    make(f);
    for (int i = 0; i < SAMPLES; i++) {
        vec3 p = working(i / wrong->rate);
        p.z += i >= wrong->first && i < wrong->first + wrong->count ? wrong->distance : 0.0;
        show(f, VBSS_METRICS_HAS_LEFT, i / wrong->rate, p, vec3_zero());
    }
    expect_ok(vbss_metrics_finish(f->metrics));
    return motion_of(f, VBSS_METRICS_TOOL_LEFT, VBSS_METRICS_PHASE_ALL);
}

static vbss_metrics_motion measured_without_fault(double rate)
{
    fixture f;
    begin(&f);
    const vbss_metrics_motion m = measured(&f, &(fault){0, 0, 0.0, rate});
    const vbss_metrics_report r = report_of(&f);
    assert_int_equal(r.outliers[0] + r.outliers[1] + r.jumps[0] + r.jumps[1], 0);
    end(&f);
    return m;
}

static void expect_bridged(const fault *wrong, uint64_t outliers)
{
    const vbss_metrics_motion plain = measured_without_fault(wrong->rate);
    fixture f;
    begin(&f);
    const vbss_metrics_motion m = measured(&f, wrong);
    assert_int_equal(report_of(&f).outliers[VBSS_METRICS_TOOL_LEFT], outliers);
    assert_int_equal(report_of(&f).outliers[VBSS_METRICS_TOOL_RIGHT], 0);
    assert_int_equal(report_of(&f).jumps[VBSS_METRICS_TOOL_LEFT], 0);
    assert_int_equal(report_of(&f).samples, SAMPLES);
    expect_near(plain.path_length, m.path_length, 1e-4 * plain.path_length);
    expect_near(plain.peak_speed, m.peak_speed, 1e-3 * plain.peak_speed);
    if (wrong->count <= 2) { /* a bridge of many samples begins with the slope of its chord */
        expect_near(plain.ldj_length, m.ldj_length, 1e-3);
    }
    expect_near(plain.time, m.time, 1e-9);
    end(&f);
}

static void outlier_is_counted_and_bridged(void **state)
{
    (void)state;
    expect_bridged(&(fault){900, 1, 0.2, RATE}, 1);
    expect_bridged(&(fault){900, 2, 0.2, 60.0}, 2);
    expect_bridged(&(fault){900, 1, -30.0, RATE}, 1);
    expect_bridged(&(fault){900, 1, 0.2, 1000.0}, 1);
    expect_bridged(&(fault){900, 80, 0.2, 1000.0}, 80);
    expect_bridged(&(fault){SAMPLES - 1, 1, 0.2, 1000.0}, 1);
}

/* To show what the bound prevents: this outlier alone makes 0.3 m of path and 3 m/s. */
static void outlier_without_bound_becomes_motion(void **state)
{
    (void)state;
    const vbss_metrics_motion plain = measured_without_fault(RATE);
    fixture f;
    begin(&f);
    f.config.max_speed = 0.0;
    const vbss_metrics_motion m = measured(&f, &(fault){900, 1, 0.2, RATE});
    assert_int_equal(report_of(&f).outliers[VBSS_METRICS_TOOL_LEFT], 0);
    assert_true(m.path_length > plain.path_length + 0.2);
    assert_true(m.peak_speed > 3.0);
    end(&f);
}

/* The tool is put down and taken up elsewhere, or registered anew. */
static void lasting_jump_is_no_motion(void **state)
{
    (void)state;
    static const double rates[] = {30.0, 200.0, 1000.0}, distances[] = {0.1, 0.2, 5.0};
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            const vbss_metrics_motion plain = measured_without_fault(rates[i]);
            fixture f;
            begin(&f);
            f.config.max_speed = 1.0;
            const vbss_metrics_motion m =
                measured(&f, &(fault){900, SAMPLES, distances[k], rates[i]});
            const vbss_metrics_report r = report_of(&f);
            assert_int_equal(r.jumps[VBSS_METRICS_TOOL_LEFT], 1);
            expect_near(0.1 * rates[i], (double)r.outliers[VBSS_METRICS_TOOL_LEFT], 1.0);
            expect_near(0.1, m.unseen_time, 0.05);
            expect_near(plain.path_length, m.path_length, 0.16 * (m.unseen_time + 0.01));
            expect_near(plain.peak_speed, m.peak_speed, 0.01 * plain.peak_speed);
            end(&f);
        }
    }
}

static double reach_length;

static vec3 reaching(double t)
{
    return vec3_make(reach_length * reach((t - 1.0) / 0.5), 0.0, 0.0);
}

/* 1.875 L/T at most. */
static uint64_t outliers_at_speed(double speed, double max_speed)
{
    fixture f;
    begin(&f);
    f.config.max_speed = max_speed;
    make(&f);
    reach_length = speed * 0.5 / 1.875;
    record(&f, reaching, 0.0, 3.0, 1000.0, 0.0);
    expect_ok(vbss_metrics_finish(f.metrics));
    uint64_t count = report_of(&f).outliers[VBSS_METRICS_TOOL_LEFT];
    end(&f);
    return count;
}

/* The bound has 1 mm for noise beside it, here 1 m/s. */
static void hand_below_bound_has_no_outlier(void **state)
{
    (void)state;
    assert_int_equal(outliers_at_speed(1.99, 2.0), 0);
    assert_int_equal(outliers_at_speed(1.2, 0.25), 0);
    assert_true(outliers_at_speed(3.3, 2.0) > 0);
    assert_true(outliers_at_speed(1.4, 0.25) > 0);
    assert_int_equal(outliers_at_speed(50.0, 0.0), 0);
}

/* ---- lost time */

static void show_lost(const fixture *f, double time, double lost)
{
    vbss_metrics_sample s;
    expect_ok(vbss_metrics_sample_init(&s, sizeof s));
    s.time = time;
    s.time_lost = lost;
    expect_ok(vbss_metrics_add_sample(f->metrics, &s));
}

static void lost_time_of_trial_is_reported(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    show_lost(&f, 10.0, 3.0); /* before the needle appears */
    report(&f, VBSS_METRICS_EVENT_NEEDLE_APPEARS, 0, 10.0, 0.0);
    show_lost(&f, 20.0, 3.15);
    expect_near(10.0, report_of(&f).time, 1e-12);
    expect_near(0.15, report_of(&f).time_lost, 1e-12);
    expect_near(9.85, report_of(&f).time_simulated, 1e-12);
    assert_int_equal(report_of(&f).flags & VBSS_METRICS_FLAG_TIME_LOST, 0);
    const double score = report_of(&f).score;
    show_lost(&f, 20.0 + 1e-9, 3.25);
    assert_int_not_equal(report_of(&f).flags & VBSS_METRICS_FLAG_TIME_LOST, 0);
    expect_near(score, report_of(&f).score, 1e-6);
    assert_int_equal(report_of(&f).penalty_count, 1);
    const vbss_metrics_penalty p = penalty_of(&f, 0);
    assert_int_equal(p.kind, VBSS_METRICS_PENALTY_TIME_LOST);
    expect_near(0.25, p.measure, 1e-12);
    expect_near(0.0, p.amount, 0.0);
    report(&f, VBSS_METRICS_EVENT_TAIL_CUT, 0, 21.0, 0.0);
    report(&f, VBSS_METRICS_EVENT_TAIL_CUT, 1, 22.0, 0.0);
    show_lost(&f, 30.0, 9.0); /* after both cuts */
    expect_near(12.0, report_of(&f).time, 1e-12);
    expect_near(0.25, report_of(&f).time_lost, 1e-12);
    end(&f);
}

static void lost_time_never_decreases(void **state)
{
    (void)state;
    fixture f;
    vbss_metrics_sample s;
    begin_and_make(&f);
    show_lost(&f, 1.0, 0.5);
    static const double bad[] = {0.4, -0.1, 1.1e9, (double)NAN, (double)INFINITY};
    for (int i = 0; i < 5; i++) {
        uint64_t hash = hash_of(f.metrics);
        expect_ok(vbss_metrics_sample_init(&s, sizeof s));
        s.time = 2.0;
        s.time_lost = bad[i];
        expect_result(i < 3 ? VBSS_ERROR_OUT_OF_RANGE : VBSS_ERROR_NOT_FINITE,
                      vbss_metrics_add_sample(f.metrics, &s));
        assert_true(hash_of(f.metrics) == hash);
    }
    end(&f);
}

int test_metrics_outliers(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(outlier_is_counted_and_bridged),
        harness_test(outlier_without_bound_becomes_motion),
        harness_test(lasting_jump_is_no_motion),
        harness_test(hand_below_bound_has_no_outlier),
        harness_test(lost_time_of_trial_is_reported),
        harness_test(lost_time_never_decreases),
    };
    return cmocka_run_group_tests_name("metrics.metrics_outliers", tests, NULL, NULL);
}
