/* The same movement told at 30 Hz to 2 kHz, evenly or not, has the same figures. */
#include "fixture.h"

/* Hand-like: reaches of half a second to two, and a slow drift, up to about 4 Hz. */
static vec3 working(double time)
{
    vec3 p = vec3_make(0.01 * sin(0.9 * time), 0.0, 0.004 * sin(2.0 * PI * 0.7 * time));
    p.x += 0.08 * reach((time - 1.0) / 0.8);
    p.y += 0.05 * reach((time - 2.5) / 1.5);
    p.z -= 0.04 * reach((time - 4.5) / 0.6);
    p.x -= 0.06 * reach((time - 6.0) / 2.0);
    return p;
}

static vbss_metrics_motion reported_at(fixture *f, double rate, double jitter)
{
    begin_and_make(f);
    record(f, working, 0.0, 9.0, rate, jitter);
    expect_ok(vbss_metrics_finish(f->metrics));
    return motion_of(f, VBSS_METRICS_TOOL_LEFT, VBSS_METRICS_PHASE_ALL);
}

static void compare(double rate, double jitter, double part, double logarithms)
{
    fixture fine, other;
    const vbss_metrics_motion a = reported_at(&fine, 1000.0, 0.0),
                              b = reported_at(&other, rate, jitter);
    expect_near(a.time, b.time, 0.05); /* the last sample */
    expect_near(a.path_length, b.path_length, part * a.path_length);
    expect_near(a.peak_speed, b.peak_speed, part * a.peak_speed);
    expect_near(a.idle_share, b.idle_share, 0.005);
    expect_near(a.ldj_length, b.ldj_length, logarithms);
    expect_near(a.ldj_speed, b.ldj_speed, logarithms);
    expect_near(a.sparc, b.sparc, logarithms);
    end(&other);
    end(&fine);
}

/* What is lost at 30 Hz is what a cubic through its samples loses of the fastest reach: 0.4 % of the squared jerk, 1e-5 of
 * the path. Tolerances are twice what was measured. */
static void sample_rate_invariance(void **state)
{
    (void)state;
    compare(30.0, 0.0, 3e-5, 0.01);
    compare(60.0, 0.0, 3e-6, 1e-3);
    compare(100.0, 0.0, 1e-6, 1e-4);
    compare(2000.0, 0.0, 1e-6, 1e-6);
}

/* Where times are very uneven, slopes are those of chords: that is what is lost at 100 Hz. */
static void uneven_sampling_invariance(void **state)
{
    (void)state;
    compare(30.0, 0.2, 2e-4, 0.01);
    compare(100.0, 0.45, 3e-4, 0.012);
    compare(1000.0, 0.45, 2e-6, 1e-4);
}

/* To show what would be without: differences of the samples themselves hang on the rate by far. */
static double plain_jerk(double rate)
{
    double sum = 0.0, h = 1.0 / rate;
    for (int i = 2; i + 2 < (int)(9.0 * rate); i++) {
        vec3 a = vec3_sub(working((i + 2) * h), working((i - 2) * h));
        vec3 b = vec3_sub(working((i + 1) * h), working((i - 1) * h));
        sum += h * vec3_norm_squared(vec3_scale(vec3_add_scaled(a, -2.0, b), 0.5 / (h * h * h)));
    }
    return sum;
}

static void plain_differences_depend_on_rate(void **state)
{
    (void)state;
    assert_true(log(plain_jerk(1000.0) / plain_jerk(30.0)) > 0.15);
}

/* Where the samples begin and end within a tick does not matter either. */
static void clock_shift_invariance(void **state)
{
    (void)state;
    fixture f, g;
    begin_and_make(&f);
    begin_and_make(&g);
    for (int i = 0; i <= 9000; i++) {
        vec3 p = working(i / 1000.0);
        show(&f, VBSS_METRICS_HAS_LEFT, i / 1000.0, p, vec3_zero());
        show(&g, VBSS_METRICS_HAS_LEFT, 3600.0 + i / 1000.0, p, vec3_zero());
    }
    expect_ok(vbss_metrics_finish(f.metrics));
    expect_ok(vbss_metrics_finish(g.metrics));
    const vbss_metrics_motion a = motion_of(&f, 0, VBSS_METRICS_PHASE_ALL),
                              b = motion_of(&g, 0, VBSS_METRICS_PHASE_ALL);
    expect_near(a.path_length, b.path_length, 1e-9);
    expect_near(a.ldj_length, b.ldj_length, 1e-6);
    expect_near(a.sparc, b.sparc, 1e-6);
    end(&f);
    end(&g);
}

int test_metrics_rates(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(sample_rate_invariance),
        harness_test(uneven_sampling_invariance),
        harness_test(plain_differences_depend_on_rate),
        harness_test(clock_shift_invariance),
    };
    return cmocka_run_group_tests_name("metrics.metrics_rates", tests, NULL, NULL);
}
