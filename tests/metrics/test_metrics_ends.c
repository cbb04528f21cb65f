/* Recordings that begin and end in the middle of a movement: their ends add neither jerk nor path. */
#include "fixture.h"

static double duration, frequency, phase;

static vbss_view view_of(const fixture *f, vbss_metrics_field field)
{
    vbss_view view;
    expect_ok(vbss_metrics_get_view(f->metrics, field, &view, sizeof view));
    return view;
}

/* Integral of |jerk|^2 over the recording. */
static double roughness_of(const fixture *f)
{
    const vbss_view view = view_of(f, VBSS_METRICS_VIEW_LEFT_JERK);
    const double *jerk = view.data;
    double sum = 0.0;
    for (uint64_t i = 0; i + 1 < view.count; i++) {
        sum += 0.005 * (jerk[i] + jerk[i + 1]);
    }
    return sum;
}

static vbss_metrics_motion measured(fixture *f, curve at, double seconds, double rate,
                                    double jitter)
{
    begin_and_make(f);
    record(f, at, 0.0, seconds, rate, jitter);
    expect_ok(vbss_metrics_finish(f->metrics));
    return motion_of(f, VBSS_METRICS_TOOL_LEFT, VBSS_METRICS_PHASE_ALL);
}

/* ---- a straight line at constant speed */

#define SPEED 0.25

static vec3 straight(double t)
{
    return vec3_make(0.3 + 0.6 * SPEED * t, -0.1 + 0.8 * SPEED * t, 0.2);
}

/* Below 1e-5 m/s^3, the rounding of the filter's taps; with a rest beyond the ends it was 137 m/s^3. */
static void expect_no_jerk(const fixture *f)
{
    const vbss_view view = view_of(f, VBSS_METRICS_VIEW_LEFT_JERK);
    const double *jerk = view.data;
    const double *speed = view_of(f, VBSS_METRICS_VIEW_LEFT_SPEED).data;
    for (uint64_t i = 0; i < view.count; i++) {
        expect_near(0.0, sqrt(jerk[i]), 1e-5);
        assert_true(speed[i] == 0.0 || fabs(speed[i] - SPEED) < 1e-9);
    }
}

static void constant_speed_has_no_jerk(void **state)
{
    (void)state;
    static const double rates[] = {30.0, 100.0, 1000.0, 2000.0}, jitters[] = {0.0, 0.3};
    static const double lengths[] = {0.02, 0.1, 0.26, 0.4, 0.6, 4.0};
    for (int i = 0; i < 4 * 2 * 6; i++) {
        fixture f;
        double rate = rates[i % 4], jitter = jitters[i / 4 % 2], seconds = lengths[i / 8];
        const vbss_metrics_motion m = measured(&f, straight, seconds, rate, jitter);
        expect_no_jerk(&f);
        expect_near(SPEED * m.time, m.path_length, 1e-9);
        expect_near(seconds, m.time, 0.02 + (1.0 + jitter) / rate);
        if (rate == 1000.0 && jitter == 0.0) {
            expect_near(seconds, m.time, 1e-9);
        }
        end(&f);
    }
}

/* Gone from 2 to 3 s, and an outlier at 1 and 4 s. */
static void gap_in_constant_speed_has_no_jerk(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    for (int i = 0; i <= 5000; i++) {
        double t = i / 1000.0;
        vec3 p = straight(t);
        p.x += i == 1000 || i == 4000 ? 0.2 : 0.0;
        show(&f, i > 2000 && i < 3000 ? 0 : VBSS_METRICS_HAS_LEFT, t, p, vec3_zero());
    }
    expect_ok(vbss_metrics_finish(f.metrics));
    const vbss_metrics_motion m = motion_of(&f, VBSS_METRICS_TOOL_LEFT, VBSS_METRICS_PHASE_ALL);
    expect_no_jerk(&f);
    expect_near(1.0, m.unseen_time, 1e-9);
    expect_near(4.0 * SPEED, m.path_length, 1e-9);
    assert_int_equal(report_of(&f).outliers[VBSS_METRICS_TOOL_LEFT], 2);
    end(&f);
}

/* ---- a minimum-jerk reach, recorded from its begin to its end */

static vec3 reaching(double t)
{
    double s = 0.1 * reach(t / duration);
    return vec3_make(0.6 * s, 0.0, 0.8 * s);
}

/* 720 L^2/T^5, whose largest values are at the ends. The trapezoidal rule over ticks of 10 ms adds 10 (0.01/T)^2 of it. */
static void minimum_jerk_reach_is_exact(void **state)
{
    (void)state;
    static const double durations[] = {0.5, 1.0, 2.0, 4.0};
    for (int i = 0; i < 4; i++) {
        double t = duration = durations[i], rule = 1.0 + 1e-3 / (t * t);
        double wanted = 720.0 * 0.01 / pow(t, 5.0) * rule;
        fixture f;
        const vbss_metrics_motion m = measured(&f, reaching, t, 1000.0, 0.0);
        expect_near(wanted, roughness_of(&f), 5e-4 * wanted);
        expect_near(t, m.time, 1e-9);
        expect_near(0.1, m.path_length, (t < 1.0 ? 1.5e-3 : 1e-4) * 0.1);
        expect_near(1.875 * 0.1 / t, m.peak_speed, 1e-3 * 0.1 / t);
        expect_near(-log(720.0 * rule), m.ldj_length, t < 1.0 ? 3e-3 : 1e-3);
        expect_near(-log(720.0 / (1.875 * 1.875) * rule), m.ldj_speed, t < 1.0 ? 3e-3 : 1e-3);
        end(&f);
    }
}

/* ---- a sine that begins and ends at any phase */

static vec3 swinging(double t)
{
    double s = 0.02 * sin(2.0 * PI * frequency * t + phase);
    return vec3_make(0.6 * s, 0.8 * s, 0.0);
}

/* Integral of (a w^3 cos(w t + p))^2 over 4 s. */
static double sine_roughness(void)
{
    double w = 2.0 * PI * frequency, t = 4.0, jerk = 0.02 * w * w * w;
    return jerk * jerk * (0.5 * t + (sin(2.0 * (w * t + phase)) - sin(2.0 * phase)) / (4.0 * w));
}

/* Within 0.2 % at 0.5 Hz, 1 % at 1 Hz and 8 % at 2 Hz, whose half period is the window of the fit. */
static void sine_of_any_phase_is_exact(void **state)
{
    (void)state;
    static const double frequencies[] = {0.3, 0.5, 1.0, 2.0};
    static const double jerk[] = {2e-3, 2e-3, 0.01, 0.08}, speed[] = {1e-3, 1e-3, 5e-3, 0.04};
    for (int i = 0; i < 4 * 6; i++) {
        fixture f;
        frequency = frequencies[i % 4];
        phase = PI * floor(i / 4.0) / 6.0;
        const vbss_metrics_motion m = measured(&f, swinging, 4.0, 1000.0, 0.0);
        double wanted = sine_roughness(), peak = 0.02 * 2.0 * PI * frequency;
        expect_near(wanted, roughness_of(&f), jerk[i % 4] * wanted);
        expect_near(peak, m.peak_speed, speed[i % 4] * peak);
        end(&f);
    }
}

/* ---- short recordings */

static void short_run_has_no_jerk(void **state)
{
    (void)state;
    frequency = 2.0;
    phase = 0.3;
    static const double lengths[] = {0.0, 0.001, 0.002, 0.05, 0.24};
    for (int i = 0; i < 5; i++) {
        fixture f;
        const vbss_metrics_motion m = measured(&f, swinging, lengths[i], 1000.0, 0.0);
        expect_near(0.0, roughness_of(&f), 0.0);
        assert_true(m.peak_speed < 0.5);
        assert_int_equal(m.valid & VBSS_METRICS_HAS_LDJ, 0);
        end(&f);
    }
}

int test_metrics_ends(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(constant_speed_has_no_jerk),  harness_test(gap_in_constant_speed_has_no_jerk),
        harness_test(minimum_jerk_reach_is_exact), harness_test(sine_of_any_phase_is_exact),
        harness_test(short_run_has_no_jerk),
    };
    return cmocka_run_group_tests_name("metrics.metrics_ends", tests, NULL, NULL);
}
