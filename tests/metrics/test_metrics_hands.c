/* Rest, and two hands together. */
#include "fixture.h"

/* Both at 500 Hz for 12 s: left swings along x, right as `right` says. */
static void swing(const fixture *f, curve left, curve right)
{
    for (int i = 0; i <= 6000; i++) {
        double t = i / 500.0;
        show(f, 3, t, left(t), right(t));
        if (i == 1000) { /* the phase that is looked at: 2 to 10 s */
            report(f, VBSS_METRICS_EVENT_PHASE, 1, t, 0.0);
        } else if (i == 5000) {
            report(f, VBSS_METRICS_EVENT_PHASE, 2, t, 0.0);
        }
    }
    expect_ok(vbss_metrics_finish(f->metrics));
}

static vec3 swinging(double t)
{
    return vec3_make(0.02 * sin(PI * t), 0.0, 0.0);
}
static vec3 along(double t)
{
    return vec3_make(0.0, 0.05 * sin(PI * t), 0.0); /* another way and amplitude, the same rhythm */
}
static vec3 in_turn(double t)
{
    return vec3_make(0.0, 0.0, 0.02 * cos(PI * t)); /* fast when the other is slow */
}
static vec3 still(double t)
{
    (void)t;
    return vec3_zero();
}

static double correlation(curve left, curve right)
{
    fixture f;
    begin_and_make(&f);
    swing(&f, left, right);
    const vbss_metrics_bimanual b = hands_of(&f, 0);
    assert_true((b.valid & VBSS_METRICS_HAS_CORRELATION) != 0 || right == still);
    expect_near(8.0, b.time, 1e-9);
    end(&f);
    return b.correlation;
}

/* |cos| and |sin|: means 2/pi, squares 1/2, product 1/pi; so (1/pi - 4/pi^2)/(1/2 - 4/pi^2). */
static void speed_correlation_matches_rhythm(void **state)
{
    (void)state;
    double in_turns = (1.0 / PI - 4.0 / (PI * PI)) / (0.5 - 4.0 / (PI * PI));
    expect_near(1.0, correlation(swinging, along), 1e-6);
    expect_near(in_turns, correlation(swinging, in_turn), 5e-3);
    expect_near(0.0, correlation(swinging, still), 0.0);
}

static vec3 moving_left(double t)
{
    return vec3_make(0.1 * reach((t - 3.0) / 2.0), 0.0, 0.0); /* 3 to 5 s */
}
static vec3 moving_right(double t)
{
    return vec3_make(0.1 * reach((t - 4.0) / 3.0), 0.0, 0.0); /* 4 to 7 s */
}

/* When a reach of 0.1 m in T becomes and stops being fast, by bisection in its bell of speed. */
static double fast_time(double t, double threshold)
{
    double low = 0.0, high = 0.5;
    for (int i = 0; i < 60; i++) {
        double s = 0.5 * (low + high), v = 30.0 * s * s * (1.0 - s) * (1.0 - s) * 0.1 / t;
        if (v < threshold) {
            low = s;
        } else {
            high = s;
        }
    }
    return low * t;
}

/* It begins to move above 6 mm/s and rests below 5 mm/s; times to a tick at each of the ends. */
static void rest_and_motion_partition_time(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    swing(&f, moving_left, moving_right);
    double left_from = 3.0 + fast_time(2.0, 6e-3), left_to = 5.0 - fast_time(2.0, 5e-3);
    double right_from = 4.0 + fast_time(3.0, 6e-3), right_to = 7.0 - fast_time(3.0, 5e-3);
    const vbss_metrics_motion m = motion_of(&f, VBSS_METRICS_TOOL_LEFT, 0);
    const vbss_metrics_bimanual b = hands_of(&f, 0);
    expect_near(8.0 - (left_to - left_from), m.idle_time, 0.021);
    expect_near(m.idle_time / 8.0, m.idle_share, 1e-12);
    expect_near(left_to - right_from, b.both_moving_time, 0.021);
    expect_near(right_to - left_from - (left_to - right_from), b.one_moving_time, 0.041);
    expect_near(8.0, b.both_moving_time + b.one_moving_time + b.still_time, 1e-9);
    expect_near(b.both_moving_time / 8.0, b.both_moving_share, 1e-12);
    end(&f);
}

static vec3 creeping(double t)
{
    return vec3_make(5.5e-3 * t, 0.0, 0.0);
}
static vec3 slowing(double t)
{
    return vec3_make(t < 1.0 ? 0.0 : 5.5e-3 * (t - 1.0), 0.0, 0.0);
}

/* Between both speeds what was goes on: one that always crept moves, one that stood rests. */
static void hysteresis_keeps_status(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    swing(&f, creeping, slowing);
    expect_near(0.0, motion_of(&f, VBSS_METRICS_TOOL_LEFT, 0).idle_time, 1e-12);
    assert_true(motion_of(&f, VBSS_METRICS_TOOL_RIGHT, VBSS_METRICS_PHASE_ALL).idle_share > 0.9);
    end(&f);
}

int test_metrics_hands(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(speed_correlation_matches_rhythm),
        harness_test(rest_and_motion_partition_time),
        harness_test(hysteresis_keeps_status),
    };
    return cmocka_run_group_tests_name("metrics.metrics_hands", tests, NULL, NULL);
}
