/* The filter: exact on what it should leave, flat where hands move, closed above. */
#include "fixture.h"

static metrics_kernel kernel;
static vec3 ring[METRICS_RING_SIZE];

/* What becomes of x(t) at t = 0, along x. */
static void filtered(double (*x)(double), double *speed, double *jerk)
{
    vbss_metrics_make_kernel(&kernel);
    for (int i = -METRICS_KERNEL_HALF_WIDTH; i <= METRICS_KERNEL_HALF_WIDTH; i++) {
        ring[(uint64_t)(METRICS_RING_SIZE + i) % METRICS_RING_SIZE] =
            vec3_make(x(i / 1000.0), 0.0, 0.0);
    }
    vbss_metrics_differentiate(&kernel, ring, METRICS_RING_SIZE, speed, jerk);
}

static double cubic(double t)
{
    return 0.3 - 2.0 * t + 5.0 * t * t + 4.0 * t * t * t;
}

/* Odd parts of a cubic: its slope is smoothed by what t^2 has in the window, its third derivative is exact. */
static void cubic_third_derivative_is_exact(void **state)
{
    (void)state;
    double speed, jerk;
    filtered(cubic, &speed, &jerk);
    expect_near(24.0 * 24.0, jerk, 1e-4);
    expect_near(2.0, speed, 0.01);
}

static double frequency;

static double wave(double t)
{
    return sin(2.0 * PI * frequency * t);
}

static double gain(double hertz)
{
    double speed, jerk;
    frequency = hertz;
    filtered(wave, &speed, &jerk);
    return speed / (2.0 * PI * hertz);
}

static double jerk_gain(double hertz)
{
    double speed, jerk;
    frequency = hertz;
    filtered(wave, &speed, &jerk);
    return sqrt(jerk) / pow(2.0 * PI * hertz, 3.0);
}

static void passband_is_flat_and_stopband_closed(void **state)
{
    (void)state;
    for (int i = 1; i <= 9; i++) {
        expect_near(1.0, gain(0.5 * i), 2e-3);
        expect_near(1.0, jerk_gain(0.5 * i), 2e-3);
    }
    expect_near(0.5, gain(10.0), 5e-3);
    for (int i = 16; i <= 200; i++) {
        assert_true(fabs(gain(i)) < 5e-4);
        assert_true(fabs(jerk_gain(i)) < 5e-4);
    }
}

/* ---- the curve between samples */

static vec3 parabola(double t)
{
    return vec3_make(1.0 + t, 2.0 * t * t, -3.0 * t * t + t);
}

static void parabola_is_exact_at_uneven_times(void **state)
{
    (void)state;
    const double times[4] = {0.1, 0.13, 0.15, 0.2};
    vec3 at[4];
    for (int i = 0; i < 4; i++) {
        at[i] = parabola(times[i]);
    }
    const metrics_segment cell = {times[1],
                                  times[2],
                                  at[1],
                                  at[2],
                                  vbss_metrics_middle_velocity(times, at),
                                  vbss_metrics_middle_velocity(times + 1, at + 1)};
    for (int i = 0; i <= 10; i++) {
        double t = times[1] + 0.002 * i;
        expect_near(0.0, vec3_distance(parabola(t), vbss_metrics_segment_at(&cell, t)), 1e-15);
    }
}

/* Two samples all but at once, with an error between them: no spike in what is measured. */
static void dense_samples_do_no_harm(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    for (int i = 0; i <= 300; i++) {
        double t = i / 100.0;
        show(&f, VBSS_METRICS_HAS_LEFT, t, vec3_zero(), vec3_zero());
        show(&f, VBSS_METRICS_HAS_LEFT, t + 1e-7, vec3_make(i == 150 ? 1e-4 : 0.0, 0.0, 0.0),
             vec3_zero());
    }
    expect_ok(vbss_metrics_finish(f.metrics));
    assert_true(motion_of(&f, 0, VBSS_METRICS_PHASE_ALL).peak_speed < 1e-3);
    end(&f);
}

int test_metrics_filter(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(cubic_third_derivative_is_exact),
        harness_test(passband_is_flat_and_stopband_closed),
        harness_test(parabola_is_exact_at_uneven_times),
        harness_test(dense_samples_do_no_harm),
    };
    return cmocka_run_group_tests_name("metrics.metrics_filter", tests, NULL, NULL);
}
