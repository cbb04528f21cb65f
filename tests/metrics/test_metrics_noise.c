/* What noise of the sensor does to smoothness is what the filter's band lets through, and can be foretold. */
#include "fixture.h"

static void rest_with_noise(const fixture *f, double rate, double deviation, double seconds)
{
    vbss_random random;
    vbss_random_seed(&random, 11, 4);
    for (int i = 0; i < (int)(seconds * rate); i++) {
        double x = deviation * vbss_random_normal(&random);
        double y = deviation * vbss_random_normal(&random);
        double z = deviation * vbss_random_normal(&random);
        show(f, VBSS_METRICS_HAS_LEFT, i / rate, vec3_make(x, y, z), vec3_zero());
    }
    expect_ok(vbss_metrics_finish(f->metrics));
}

/* White noise of deviation s at a rate r has the density 2 s^2/r up to r/2; its jerk (2 pi f)^6 times that. With the
 * gain of the filter measured as in its test. */
static double foretold(double rate, double deviation)
{
    double sum = 0.0, step = 0.05, bends = 0.0;
    metrics_kernel kernel;
    vbss_metrics_make_kernel(&kernel);
    for (int i = 1; i < 600; i++) {
        double w = 2.0 * PI * step * i;
        bends = 0.0;
        for (int k = 1; k <= METRICS_KERNEL_HALF_WIDTH; k++) {
            bends += 2.0 * kernel.third[k] * sin(w * k / 1000.0);
        }
        sum += bends * bends * step;
    }
    return 3.0 * 2.0 * deviation * deviation / rate * sum;
}

static void jerk_of_noise_matches_filter_band(void **state)
{
    (void)state;
    static const double rates[] = {200.0, 1000.0};
    for (int i = 0; i < 2; i++) {
        fixture f;
        vbss_view view;
        begin_and_make(&f);
        rest_with_noise(&f, rates[i], 1e-4, 60.0);
        expect_ok(
            vbss_metrics_get_view(f.metrics, VBSS_METRICS_VIEW_LEFT_JERK, &view, sizeof view));
        const double *jerk = view.data;
        double mean = 0.0;
        for (uint64_t k = 0; k < view.count; k++) {
            mean += jerk[k] / (double)view.count;
        }
        double wanted = foretold(rates[i], 1e-4);
        expect_near(1.0, mean / wanted, 0.1);
        end(&f);
    }
}

/* A tenth of a millimetre does not move a resting hand. */
static void sensor_noise_is_rest(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    rest_with_noise(&f, 1000.0, 1e-4, 20.0);
    const vbss_metrics_motion m = motion_of(&f, 0, VBSS_METRICS_PHASE_ALL);
    assert_true(m.idle_share > 0.99);
    assert_true(m.peak_speed < 5e-3);
    end(&f);
}

int test_metrics_noise(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(jerk_of_noise_matches_filter_band),
        harness_test(sensor_noise_is_rest),
    };
    return cmocka_run_group_tests_name("metrics.metrics_noise", tests, NULL, NULL);
}
