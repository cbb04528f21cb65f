/* What a measurement refuses, with a text and without any change. */

#include "fixture.h"
#include "harness/float_modes.h"

static vbss_metrics_sample good_sample(void)
{
    vbss_metrics_sample s;
    expect_ok(vbss_metrics_sample_init(&s, sizeof s));
    s.valid = 15;
    s.time = 2.0;
    return s;
}

static void expect_sample(const fixture *f, const vbss_metrics_sample *s, vbss_result wanted)
{
    uint64_t hash = hash_of(f->metrics);
    expect_result(wanted, vbss_metrics_add_sample(f->metrics, s));
    assert_true(hash_of(f->metrics) == hash);
}

static void bad_samples_change_nothing(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    show(&f, 3, 1.0, vec3_zero(), vec3_zero());
    for (int c = 0; c < 13; c++) {
        vbss_metrics_sample s = good_sample();
        double *number = c < 6    ? &s.position[c / 3][c % 3]
                         : c < 12 ? &s.force[(c - 6) / 3][c % 3]
                                  : &s.time;
        for (int k = 0; k < 3; k++) {
            *number = harness_bad_numbers[k];
            expect_sample(&f, &s, VBSS_ERROR_NOT_FINITE);
        }
        *number = c < 6 ? 1e3 + 1.0 : c < 12 ? 1e6 + 1.0 : 1e9 + 1.0;
        expect_sample(&f, &s, VBSS_ERROR_OUT_OF_RANGE);
        s.valid = 0; /* what is not said to be there is not looked at */
        if (c < 12) {
            s.time = 1.0 + 0.01 * (c + 1);
            expect_ok(vbss_metrics_add_sample(f.metrics, &s));
        }
    }
    vbss_metrics_sample s = good_sample();
    s.valid = 16;
    expect_sample(&f, &s, VBSS_ERROR_OUT_OF_RANGE);
    expect_sample(&f, NULL, VBSS_ERROR_NULL_ARGUMENT);
    s = good_sample();
    s.struct_size = 12;
    expect_sample(&f, &s, VBSS_ERROR_STRUCT_SIZE);
    end(&f);
}

static void time_is_monotonic(void **state)
{
    (void)state;
    fixture f;
    const char *text;
    begin_and_make(&f);
    show(&f, 3, 1.0, vec3_zero(), vec3_zero());
    report(&f, VBSS_METRICS_EVENT_DROP, 0, 1.0, 0.0); /* at the same time it may */
    report(&f, VBSS_METRICS_EVENT_DROP, 0, 1.5, 0.0);
    vbss_metrics_sample s = good_sample();
    s.time = 1.25; /* after the last sample, before the last event */
    expect_sample(&f, &s, VBSS_ERROR_OUT_OF_RANGE);
    show(&f, 3, 1.5, vec3_zero(), vec3_zero());
    s.time = 1.5; /* one sample a time */
    expect_sample(&f, &s, VBSS_ERROR_OUT_OF_RANGE);
    expect_ok(vbss_context_get_last_error(f.context, NULL, &text));
    assert_non_null(strstr(text, "1.5"));
    vbss_metrics_event e = event_of(VBSS_METRICS_EVENT_DROP, 0, 1.4);
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_metrics_add_event(f.metrics, &e));
    vbss_metrics_pull p;
    expect_ok(vbss_metrics_pull_init(&p, sizeof p));
    p.time = 1.4;
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_metrics_add_pull(f.metrics, &p));
    expect_ok(vbss_metrics_finish(f.metrics));
    s.time = 2.0;
    expect_sample(&f, &s, VBSS_ERROR_WRONG_STATE);
    report(&f, VBSS_METRICS_EVENT_DROP, 0, 2.0, 0.0);
    end(&f);
}

static void expect_event(const fixture *f, const vbss_metrics_event *e, vbss_result wanted)
{
    uint64_t hash = hash_of(f->metrics);
    expect_result(wanted, vbss_metrics_add_event(f->metrics, e));
    assert_true(hash_of(f->metrics) == hash);
}

static void bad_events_change_nothing(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    const vbss_metrics_event good = event_of(VBSS_METRICS_EVENT_PUNCTURE, 0, 1.0);
    const size_t first = offsetof(vbss_metrics_event, time);
    static const double largest[13] = {1e9, 1e3, 1e3, 1e3, 1e6, 1e6, 1e6,
                                       1e3, 1e3, 1e3, 3.2, 1e3, 1e6};
    for (size_t i = 0; i < 13; i++) {
        for (int k = 0; k < 4; k++) {
            vbss_metrics_event e = good;
            double value = k < 3 ? harness_bad_numbers[k] : 1.01 * largest[i];
            memcpy((char *)&e + first + i * sizeof value, &value, sizeof value);
            expect_event(&f, &e, k < 3 ? VBSS_ERROR_NOT_FINITE : VBSS_ERROR_OUT_OF_RANGE);
        }
    }
    for (int i = 0; i < 8; i++) {
        vbss_metrics_event e = good;
        int32_t *const words[] = {&e.kind, &e.kind,       &e.kind,     &e.tool,
                                  &e.tool, &e.handedness, &e.relation, &e.wraps};
        static const int32_t bad[] = {0, -1, VBSS_METRICS_EVENT_ASSISTED + 1, 3, -1, 2, 4, 65};
        *words[i] = bad[i];
        expect_event(&f, &e, VBSS_ERROR_OUT_OF_RANGE);
    }
    vbss_metrics_event e = good;
    e.number = 2;
    expect_event(&f, &e, VBSS_ERROR_OUT_OF_RANGE);
    e = good;
    e.undone = 2;
    expect_event(&f, &e, VBSS_ERROR_OUT_OF_RANGE);
    e.struct_size = 4;
    expect_event(&f, &e, VBSS_ERROR_STRUCT_SIZE);
    expect_event(&f, NULL, VBSS_ERROR_NULL_ARGUMENT);
    end(&f);
}

static void bad_pulls_change_nothing(void **state)
{
    (void)state;
    fixture f;
    vbss_metrics_pull good;
    begin_and_make(&f);
    expect_ok(vbss_metrics_pull_init(&good, sizeof good));
    static const double largest[] = {1e9, 1.0, 1.0, 1e6, 1e6, 1e3};
    uint64_t hash = hash_of(f.metrics);
    for (size_t i = 0; i < 6; i++) {
        for (int k = 0; k < 4; k++) {
            vbss_metrics_pull p = good;
            double value = k < 3 ? harness_bad_numbers[k] : 1.01 * largest[i];
            memcpy((char *)&p + offsetof(vbss_metrics_pull, time) + i * sizeof value, &value,
                   sizeof value);
            expect_result(k < 3 ? VBSS_ERROR_NOT_FINITE : VBSS_ERROR_OUT_OF_RANGE,
                          vbss_metrics_add_pull(f.metrics, &p));
        }
    }
    for (int i = 0; i < 3; i++) {
        vbss_metrics_pull p = good;
        uint32_t *const words[] = {&p.begins, &p.tied, &p.reserved};
        *words[i] = 2;
        expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_metrics_add_pull(f.metrics, &p));
    }
    assert_true(hash_of(f.metrics) == hash);
    end(&f);
}

static void unknown_tools_phases_and_fields_are_rejected(void **state)
{
    (void)state;
    fixture f;
    vbss_metrics_motion m;
    vbss_metrics_bimanual b;
    vbss_metrics_phase p;
    vbss_view v;
    begin_and_make(&f);
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_metrics_get_motion(f.metrics, 2, -1, &m, sizeof m));
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_metrics_get_motion(f.metrics, 0, 0, &m, sizeof m));
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_metrics_get_bimanual(f.metrics, -2, &b, sizeof b));
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_metrics_get_phase(f.metrics, 0, &p, sizeof p));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_metrics_get_view(f.metrics, 6, &v, sizeof v));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_metrics_get_view(f.metrics, -1, &v, sizeof v));
    expect_ok(vbss_metrics_get_view(f.metrics, 5, &v, sizeof v));
    assert_int_equal(v.count, 0);
    assert_non_null(v.data);
    expect_result(VBSS_ERROR_STRUCT_SIZE, vbss_metrics_get_motion(f.metrics, 0, -1, &m, 119));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_metrics_get_report(f.metrics, NULL, 232));
    end(&f);
}

/* Samples of a motion, and the motion that they add up to. */
static vbss_metrics_motion motion_in_mode(const fixture *f, bool in_mode, size_t k)
{
    vbss_metrics_motion motion;
    for (int i = 0; i < 100; i++) {
        vbss_metrics_sample s = good_sample();
        s.time = 2.0 + 1e-3 * i;
        s.position[0][0] = 1e-5 * i * i;
        s.position[0][1] = i % 7 == 0 ? 1e-310 : 0.0;
        if (in_mode) {
            harness_mode_set(k);
        }
        vbss_result result = vbss_metrics_add_sample(f->metrics, &s);
        if (in_mode) {
            harness_mode_end(k);
        }
        expect_ok(result);
    }
    expect_ok(vbss_metrics_get_motion(f->metrics, 0, -1, &motion, sizeof motion));
    return motion;
}

static void host_mode_does_not_change_motion(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    const vbss_metrics_motion wanted = motion_in_mode(&f, false, 0);
    const uint64_t hash = hash_of(f.metrics);
    end(&f);
    for (size_t k = 0; k < harness_mode_count; k++) {
        begin_and_make(&f);
        const vbss_metrics_motion found = motion_in_mode(&f, true, k);
        assert_true(hash_of(f.metrics) == hash);
        assert_memory_equal(&found, &wanted, sizeof wanted);
        end(&f);
    }
}

int test_metrics_refusals(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(bad_samples_change_nothing),
        harness_test(time_is_monotonic),
        harness_test(bad_events_change_nothing),
        harness_test(bad_pulls_change_nothing),
        harness_test(unknown_tools_phases_and_fields_are_rejected),
        harness_test(host_mode_does_not_change_motion),
    };
    return cmocka_run_group_tests_name("metrics.metrics_refusals", tests, NULL, NULL);
}
