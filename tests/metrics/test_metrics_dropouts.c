/* Tools that come late, go and come back: what is not seen is not motion. */
#include "fixture.h"

static vec3 reaching(double t)
{
    return vec3_make(0.1 * reach(t / 2.0), 0.0, 0.0);
}

/* Reaches from 1 to 3 s, is exchanged, and comes back 0.3 m away at 5 s to reach again. */
static void reappearance_adds_no_path(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    for (int i = 0; i <= 8000; i++) {
        double t = i / 1000.0;
        bool gone = i > 3500 && i < 5000;
        vec3 away = vec3_make(0.1, i < 4000 ? 0.0 : 0.3, 0.0);
        vec3 p = i < 4000 ? reaching(t - 1.0) : vec3_add(away, reaching(t - 5.5));
        show(&f, gone ? 0 : VBSS_METRICS_HAS_LEFT, t, p, vec3_zero());
    }
    expect_ok(vbss_metrics_finish(f.metrics));
    const vbss_metrics_motion m = motion_of(&f, 0, VBSS_METRICS_PHASE_ALL);
    expect_near(0.2, m.path_length, 1e-4);
    expect_near(0.09375, m.peak_speed, 1e-4);
    expect_near(1.5, m.unseen_time, 0.011);
    expect_near(8.0, m.time + m.unseen_time, 1e-9);
    assert_int_equal(m.movement_count, 2);
    end(&f);
}

static void late_instrument_was_absent(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    for (int i = 0; i <= 4000; i++) {
        double t = i / 1000.0;
        show(&f, i < 2000 ? 1 : 3, t, vec3_zero(), reaching(t - 2.0));
    }
    expect_ok(vbss_metrics_finish(f.metrics));
    const vbss_metrics_motion m = motion_of(&f, VBSS_METRICS_TOOL_RIGHT, VBSS_METRICS_PHASE_ALL);
    expect_near(2.0, m.unseen_time, 0.011);
    expect_near(0.1, m.path_length, 1e-4);
    expect_near(2.01, hands_of(&f, VBSS_METRICS_PHASE_ALL).time, 0.011);
    end(&f);
}

/* A sample lost here and there is none of that: up to a tenth of a second the curve goes on. */
static void lost_samples_are_bridged(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    for (int i = 0; i <= 120; i++) {
        double t = i / 30.0;
        show(&f, i % 3 == 1 && i > 30 ? 0 : 1, t, reaching(t - 1.0), vec3_zero());
    }
    expect_ok(vbss_metrics_finish(f.metrics));
    const vbss_metrics_motion m = motion_of(&f, 0, VBSS_METRICS_PHASE_ALL);
    expect_near(0.0, m.unseen_time, 0.0);
    expect_near(0.1, m.path_length, 1e-4);
    end(&f);
}

/* Of what was told a quarter of a second ago all is known; the rest when it is finished. */
static void motion_is_known_after_filter_delay(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    for (int i = 0; i <= 2000; i++) {
        show(&f, 1, i / 1000.0, reaching(i / 1000.0), vec3_zero());
    }
    uint64_t ticks = report_of(&f).ticks;
    assert_true(ticks >= 174 && ticks <= 175);
    expect_ok(vbss_metrics_finish(f.metrics));
    assert_int_equal(report_of(&f).ticks, 201);
    uint64_t hash = hash_of(f.metrics);
    expect_ok(vbss_metrics_finish(f.metrics));
    assert_true(hash_of(f.metrics) == hash);
    expect_near(0.1, motion_of(&f, 0, VBSS_METRICS_PHASE_ALL).path_length, 1e-4);
    end(&f);
}

int test_metrics_dropouts(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(reappearance_adds_no_path),
        harness_test(late_instrument_was_absent),
        harness_test(lost_samples_are_bridged),
        harness_test(motion_is_known_after_filter_delay),
    };
    return cmocka_run_group_tests_name("metrics.metrics_dropouts", tests, NULL, NULL);
}
