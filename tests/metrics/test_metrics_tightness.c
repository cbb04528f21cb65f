/* The pull test: by ours and by the paper's strain, where they agree and where not. */
#include "fixture.h"

#define STRAIN_AT_2N (2.0 / 427.0)

static void expect_results(const fixture *f, int32_t ours, int32_t paper)
{
    const vbss_metrics_report r = report_of(f);
    assert_int_equal(r.tightness_pull, ours);
    assert_int_equal(r.tightness_strain, paper);
}

/* Ramps up in half a second, then pulls for `held` seconds, with so much drawn in a second. */
static void pull_for(const fixture *f, double force, double held, double drawn_per_second)
{
    for (int i = 0; i <= (int)(1000.0 * (0.5 + held)); i++) {
        double t = i / 1000.0, part = t < 0.5 ? t / 0.5 : 1.0;
        double drawn = t < 0.5 ? 0.0 : drawn_per_second * (t - 0.5);
        pull_at(f, 100.0 + t, part * force, part * force / 427.0, drawn, 1);
    }
}

static void unpulled_knot_is_unknown(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    expect_results(&f, VBSS_METRICS_TIGHTNESS_UNKNOWN, VBSS_METRICS_TIGHTNESS_UNKNOWN);
    end(&f);
}

static void tight_knot_is_tight_by_both_methods(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    pull_for(&f, 2.01, 1.1, 2e-4);
    expect_results(&f, VBSS_METRICS_TIGHTNESS_TIGHT, VBSS_METRICS_TIGHTNESS_TIGHT);
    assert_true(report_of(&f).pull_held >= 1.0);
    expect_near(2.01 / 427.0, report_of(&f).pull_strain, 1e-15);
    end(&f);
}

/* Capsized into half hitches: it bears the force while its tail creeps in. The paper sees the strain alone. */
static void force_bearing_slip_is_found_by_ours_only(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    pull_for(&f, 2.01, 1.1, 2e-3);
    expect_results(&f, VBSS_METRICS_TIGHTNESS_SLIPS, VBSS_METRICS_TIGHTNESS_TIGHT);
    expect_near(2.2, report_of(&f).drawn_in_mm, 1e-9);
    end(&f);
}

/* Slips at half a newton: the force is never reached. */
static void early_slip_is_found_by_both_methods(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    pull_for(&f, 0.5, 1.0, 5e-3);
    expect_results(&f, VBSS_METRICS_TIGHTNESS_SLIPS, VBSS_METRICS_TIGHTNESS_SLIPS);
    end(&f);
}

static void untied_knot_is_found_by_both_methods(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    pull_for(&f, 0.5, 1.0, 5e-3);
    pull_at(&f, 102.0, 0.0, 0.0, 8e-3, 0);
    expect_results(&f, VBSS_METRICS_TIGHTNESS_UNTIED, VBSS_METRICS_TIGHTNESS_UNTIED);
    pull_at(&f, 103.0, 3.0, 0.1, 8e-3, 1); /* what is lost stays lost in this test */
    expect_results(&f, VBSS_METRICS_TIGHTNESS_UNTIED, VBSS_METRICS_TIGHTNESS_UNTIED);
    end(&f);
}

static void short_or_interrupted_pull_is_inconclusive(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    pull_for(&f, 2.01, 0.9, 0.0);
    expect_results(&f, VBSS_METRICS_TIGHTNESS_UNKNOWN, VBSS_METRICS_TIGHTNESS_TIGHT);
    pull_at(&f, 102.0, 1.7, 0.0, 0.0, 1);
    pull_at(&f, 102.1, 2.0, 0.0, 0.0, 1);
    pull_at(&f, 103.0, 1.9, 0.0, 0.0, 1); /* a little less is borne with */
    expect_results(&f, VBSS_METRICS_TIGHTNESS_UNKNOWN, VBSS_METRICS_TIGHTNESS_TIGHT);
    pull_at(&f, 103.2, 1.9, 0.0, 0.0, 1);
    expect_results(&f, VBSS_METRICS_TIGHTNESS_TIGHT, VBSS_METRICS_TIGHTNESS_TIGHT);
    end(&f);
}

static void both_sides_must_pull(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    for (int i = 0; i <= 20; i++) {
        vbss_metrics_pull p;
        expect_ok(vbss_metrics_pull_init(&p, sizeof p));
        p.time = 0.1 * i;
        p.force[1] = 5.0;
        p.strain[1] = 5.0 * STRAIN_AT_2N;
        expect_ok(vbss_metrics_add_pull(f.metrics, &p));
    }
    expect_results(&f, VBSS_METRICS_TIGHTNESS_UNKNOWN, VBSS_METRICS_TIGHTNESS_SLIPS);
    end(&f);
}

static void threshold_is_force_strain_or_given(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    f.config.stiffness = 1000.0;
    for (int given = 0; given < 2; given++) {
        f.config.strain_threshold = given ? 0.01 : 0.0;
        double threshold = given ? 0.01 : 0.002;
        make(&f);
        pull_at(&f, 0.0, 0.1, 0.999 * threshold, 0.0, 1);
        assert_int_equal(report_of(&f).tightness_strain, VBSS_METRICS_TIGHTNESS_SLIPS);
        pull_at(&f, 0.1, 0.1, threshold, 0.0, 1);
        assert_int_equal(report_of(&f).tightness_strain, VBSS_METRICS_TIGHTNESS_TIGHT);
    }
    end(&f);
}

static void new_test_clears_last(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    pull_at(&f, 1.0, 0.0, 0.0, 0.0, 0);
    expect_results(&f, VBSS_METRICS_TIGHTNESS_UNTIED, VBSS_METRICS_TIGHTNESS_UNTIED);
    vbss_metrics_pull p;
    expect_ok(vbss_metrics_pull_init(&p, sizeof p));
    p.time = 2.0;
    p.begins = 1;
    expect_ok(vbss_metrics_add_pull(f.metrics, &p));
    expect_results(&f, VBSS_METRICS_TIGHTNESS_UNKNOWN, VBSS_METRICS_TIGHTNESS_SLIPS);
    end(&f);
}

int test_metrics_tightness(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(unpulled_knot_is_unknown),
        harness_test(tight_knot_is_tight_by_both_methods),
        harness_test(force_bearing_slip_is_found_by_ours_only),
        harness_test(early_slip_is_found_by_both_methods),
        harness_test(untied_knot_is_found_by_both_methods),
        harness_test(short_or_interrupted_pull_is_inconclusive),
        harness_test(both_sides_must_pull),
        harness_test(threshold_is_force_strain_or_given),
        harness_test(new_test_clears_last),
    };
    return cmocka_run_group_tests_name("metrics.metrics_tightness", tests, NULL, NULL);
}
