/* Smoothness and speed against movements whose figures are known in closed form. */
#include "fixture.h"

static double duration;
static double frequency;

/* 0.1 m in `duration`, from t = 1 on. */
static vec3 reaching(double time)
{
    double s = 0.1 * reach((time - 1.0) / duration);
    return vec3_make(0.6 * s, 0.0, 0.8 * s);
}

static vec3 swinging(double time)
{
    double s = 0.02 * sin(2.0 * PI * frequency * time);
    return vec3_make(0.6 * s, 0.8 * s, 0.0);
}

/* The bell of a Gaussian speed profile of deviation `duration`, about t = 3. */
static vec3 bell(double time)
{
    return vec3_make(0.05 * erf((time - 3.0) / (duration * sqrt(2.0))), 0.0, 0.0);
}

/* A phase of just that time. */
static vbss_metrics_motion measured(fixture *f, curve at, double from, double to, double last)
{
    make(f);
    record(f, at, 0.0, from, 1000.0, 0.0);
    report(f, VBSS_METRICS_EVENT_PHASE, 1, from, 0.0);
    record(f, at, from + 1e-3, to - 1e-3, 1000.0, 0.0);
    report(f, VBSS_METRICS_EVENT_PHASE, 2, to, 0.0);
    record(f, at, to, last, 1000.0, 0.0);
    expect_ok(vbss_metrics_finish(f->metrics));
    return motion_of(f, VBSS_METRICS_TOOL_LEFT, 0);
}

/* Of a minimum-jerk reach: L in all, 15/8 L/T at most, and 720 L^2/T^5 of squared jerk. The jerk jumps by 60 L/T^3 at
 * both ends; beyond the cut f of the filter lie 2 (60/(2 pi))^2 2/f = 0.507/(f T) of the 720, and some
 * of the rest is moved out of the reach: 8.5 % in all for 1 s. */
static void minimum_jerk_reach_matches_formula(void **state)
{
    (void)state;
    static const double durations[] = {1.0, 2.0, 4.0};
    for (int i = 0; i < 3; i++) {
        double t = duration = durations[i];
        fixture f;
        begin(&f);
        const vbss_metrics_motion m = measured(&f, reaching, 1.0, 1.0 + t, 2.0 + t);
        expect_near(t, m.time, 1e-9);
        expect_near(0.1, m.path_length, 1e-5);
        expect_near(1.875 * 0.1 / t, m.peak_speed, 2e-4);
        expect_near(0.1 / t, m.mean_speed, 1e-5);
        assert_true(m.valid & VBSS_METRICS_HAS_LDJ);
        expect_near(-log(720.0), m.ldj_length, 0.09 / t);
        expect_near(-log(720.0 / (1.875 * 1.875)), m.ldj_speed, 0.09 / t);
        end(&f);
    }
}

/* x = a sin(w t) over whole periods: path 4 a f T, squared jerk a^2 w^6 T/2. */
static void oscillation_matches_formula(void **state)
{
    (void)state;
    static const double frequencies[] = {0.5, 1.0, 2.0, 4.0};
    for (int i = 0; i < 4; i++) {
        double w = 2.0 * PI * (frequency = frequencies[i]), t = 4.0, a = 0.02;
        fixture f;
        begin(&f);
        const vbss_metrics_motion m = measured(&f, swinging, 1.0, 1.0 + t, 6.0);
        double path = 4.0 * a * frequency * t, roughness = 0.5 * a * a * pow(w, 6.0) * t;
        expect_near(path, m.path_length, 2e-3 * path);
        expect_near(a * w, m.peak_speed, 2e-3 * a * w);
        expect_near(-log(pow(t, 5.0) / (path * path) * roughness), m.ldj_length, 5e-3);
        expect_near(-log(pow(t, 3.0) / (a * w * a * w) * roughness), m.ldj_speed, 5e-3);
        end(&f);
    }
}

/* ---- SPARC */

/* The length of exp(-(w s)^2/2) up to where it is 0.05, by many straight pieces. */
static double arc_of_bell(double deviation)
{
    enum { PIECES = 100000 };
    double end = sqrt(-2.0 * log(0.05)) / deviation, length = 0.0;
    for (int i = 0; i < PIECES; i++) {
        double a = end * i / PIECES * deviation, b = end * (i + 1.0) / PIECES * deviation;
        double fall = exp(-0.5 * a * a) - exp(-0.5 * b * b);
        length += sqrt(1.0 / ((double)PIECES * PIECES) + fall * fall);
    }
    return length;
}

/* Whatever its deviation, as SPARC must: 1.4165. The last frequency is one of a grid 16 times finer than 1/T. */
static void bell_profile_matches_spectral_arc_length(void **state)
{
    (void)state;
    static const double deviations[] = {0.1, 0.2, 0.4};
    for (int i = 0; i < 3; i++) {
        duration = deviations[i];
        fixture f;
        begin(&f);
        const vbss_metrics_motion m =
            measured(&f, bell, 3.0 - 5.0 * duration, 3.0 + 5.0 * duration, 6.0);
        assert_true(m.valid & VBSS_METRICS_HAS_SPARC);
        expect_near(-arc_of_bell(duration), m.sparc, 5e-3);
        end(&f);
    }
}

static vec3 halting(double time)
{
    double s = 0.03 * (reach((time - 1.0) / 0.6) + reach((time - 1.7) / 0.6) + reach(time - 2.5));
    return vec3_make(s, 0.0, 0.0);
}

static void halting_reach_is_less_smooth(void **state)
{
    (void)state;
    fixture smooth, rough;
    duration = 2.5;
    begin(&smooth);
    const vbss_metrics_motion one = measured(&smooth, reaching, 1.0, 3.5, 5.0);
    end(&smooth);
    begin(&rough);
    const vbss_metrics_motion three = measured(&rough, halting, 1.0, 3.5, 5.0);
    assert_true(three.ldj_length < one.ldj_length - 2.0);
    assert_true(three.ldj_speed < one.ldj_speed - 2.0);
    assert_true(three.sparc < one.sparc - 0.2);
    assert_int_equal(one.movement_count, 1);
    assert_int_equal(three.movement_count, 3);
    assert_true(three.movement_sparc > three.sparc + 0.2); /* each is smooth by itself */
    end(&rough);
}

int test_metrics_smoothness(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(minimum_jerk_reach_matches_formula),
        harness_test(oscillation_matches_formula),
        harness_test(bell_profile_matches_spectral_arc_length),
        harness_test(halting_reach_is_less_smooth),
    };
    return cmocka_run_group_tests_name("metrics.metrics_smoothness", tests, NULL, NULL);
}
