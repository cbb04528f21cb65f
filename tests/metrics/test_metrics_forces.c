/* Forces on the tools: peak and integral, per tool and phase, at any rate of the samples. */
#include "fixture.h"

static void load(const fixture *f, double time, vec3 left, vec3 right)
{
    vbss_metrics_sample s;
    expect_ok(vbss_metrics_sample_init(&s, sizeof s));
    s.valid = VBSS_METRICS_HAS_LEFT_FORCE | VBSS_METRICS_HAS_RIGHT_FORCE;
    s.time = time;
    vec3_store(s.force[0], left);
    vec3_store(s.force[1], right);
    expect_ok(vbss_metrics_add_sample(f->metrics, &s));
}

/* The left one bears t newton (3-4-5), the right one always 2 N the other way, for 4 s; a phase from 1 to 3 s. */
static void bear(const fixture *f, double rate)
{
    int count = (int)(4.0 * rate + 0.5);
    for (int i = 0; i <= count; i++) {
        double t = i / rate;
        load(f, t, vec3_make(0.6 * t, -0.8 * t, 0.0), vec3_make(0.0, 0.0, -2.0));
        if (i == count / 4 || i == 3 * count / 4) {
            report(f, VBSS_METRICS_EVENT_PHASE, 1, t, 0.0);
        }
    }
}

static void peak_and_integral_are_of_magnitude(void **state)
{
    (void)state;
    static const double rates[] = {30.0, 100.0, 1000.0, 2000.0};
    for (int i = 0; i < 4; i++) {
        fixture f;
        begin_and_make(&f);
        bear(&f, rates[i]);
        const vbss_metrics_motion whole = motion_of(&f, 0, VBSS_METRICS_PHASE_ALL),
                                  part = motion_of(&f, 0, 0), other = motion_of(&f, 1, 0);
        expect_near(8.0, whole.force_integral, 1e-9); /* 4^2/2 */
        expect_near(4.0, whole.force_peak, 1e-12);
        expect_near(4.0, part.force_integral, 0.03); /* (3^2 - 1)/2; phases end on ticks */
        expect_near(3.0, part.force_peak, 0.01 + 1.0 / rates[i]); /* and before its last sample */
        expect_near(2.0 * 2.0, other.force_integral, 0.021);
        expect_near(2.0, other.force_peak, 1e-12);
        end(&f);
    }
}

static void phases_partition_integral(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    report(&f, VBSS_METRICS_EVENT_PHASE, 7, 0.0, 0.0);
    bear(&f, 73.0);
    double sum = 0.0;
    for (int i = 0; i < 3; i++) {
        sum += motion_of(&f, 0, i).force_integral;
    }
    expect_near(motion_of(&f, 0, VBSS_METRICS_PHASE_ALL).force_integral, sum, 1e-12);
    end(&f);
}

static void long_sample_gap_is_unknown(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    load(&f, 0.0, vec3_make(1.0, 0.0, 0.0), vec3_zero());
    load(&f, 0.05, vec3_make(1.0, 0.0, 0.0), vec3_zero());
    load(&f, 1.0, vec3_make(9.0, 0.0, 0.0), vec3_zero());
    load(&f, 1.05, vec3_make(1.0, 0.0, 0.0), vec3_zero());
    const vbss_metrics_motion m = motion_of(&f, 0, VBSS_METRICS_PHASE_ALL);
    expect_near(0.05 + 0.25, m.force_integral, 1e-12);
    expect_near(9.0, m.force_peak, 1e-15);
    end(&f);
}

static void only_task_phase_counts(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    for (int i = 0; i <= 400; i++) {
        double t = i / 100.0;
        if (i == 100) {
            report(&f, VBSS_METRICS_EVENT_NEEDLE_APPEARS, 0, t, 0.0);
        } else if (i == 300) {
            report(&f, VBSS_METRICS_EVENT_TAIL_CUT, 0, t, 4e-3);
            report(&f, VBSS_METRICS_EVENT_TAIL_CUT, 1, t, 4e-3);
        }
        load(&f, t, vec3_make(i < 100 || i > 310 ? 50.0 : 1.0, 0.0, 0.0), vec3_zero());
    }
    const vbss_metrics_motion m = motion_of(&f, 0, VBSS_METRICS_PHASE_ALL);
    expect_near(2.0, m.force_integral, 1e-9);
    expect_near(1.0, m.force_peak, 1e-12);
    end(&f);
}

int test_metrics_forces(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(peak_and_integral_are_of_magnitude),
        harness_test(phases_partition_integral),
        harness_test(long_sample_gap_is_unknown),
        harness_test(only_task_phase_counts),
    };
    return cmocka_run_group_tests_name("metrics.metrics_forces", tests, NULL, NULL);
}
