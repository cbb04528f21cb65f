/* A measurement is a function of its log; it is saved with all it knows, and restored to the same bits. */
#include "fixture.h"
#include "fixtures/metrics_run.h"

static vbss_result create(vbss_context *context, void *user, void **handle)
{
    (void)user;
    return metrics_run_create(context, (vbss_metrics **)handle);
}

static vbss_result step(void *handle)
{
    return metrics_run_step(handle);
}

static vbss_result destroy(void *handle)
{
    return vbss_metrics_destroy(handle);
}

static harness_body body(void)
{
    harness_body b = {.name = "a measurement",
                      .kind = &vbss_metrics_kind,
                      .create = create,
                      .step = step,
                      .destroy = destroy};
    return b;
}

static void restored_metrics_continue_bit_equal(void **state)
{
    (void)state;
    static const size_t at[] = {0, 1, 2, 35, 92, 116, 245};
    const harness_body b = body();
    harness_save_restore_continue_at(&b, at, sizeof at / sizeof at[0], 50);
}

static void bad_snapshots_are_rejected(void **state)
{
    (void)state;
    const harness_body b = body();
    harness_refuses_bad_snapshots(&b, 0);
    harness_refuses_bad_snapshots(&b, 150);
}

static void samples_and_events_do_not_allocate(void **state)
{
    (void)state;
    const harness_body b = body();
    assert_int_equal(harness_step_allocations(&b, METRICS_RUN_STEPS), 0);
}

static void same_log_gives_same_bits(void **state)
{
    (void)state;
    fixture f;
    vbss_metrics *one, *two;
    begin(&f);
    expect_ok(metrics_run_create(f.context, &one));
    expect_ok(metrics_run_create(f.context, &two));
    uint64_t before = 0;
    for (int i = 0; i < METRICS_RUN_STEPS; i++) {
        vbss_metrics_motion motion;
        expect_ok(metrics_run_step(one));
        /* looking changes nothing */
        expect_ok(vbss_metrics_get_motion(one, 0, VBSS_METRICS_PHASE_ALL, &motion, sizeof motion));
        expect_ok(metrics_run_step(two));
        assert_true(hash_of(one) == hash_of(two));
        assert_true(hash_of(one) != before);
        before = hash_of(one);
    }
    expect_ok(vbss_metrics_finish(one));
    expect_ok(vbss_metrics_finish(two));
    assert_true(hash_of(one) == hash_of(two));
    vbss_metrics_report a, b;
    expect_ok(vbss_metrics_get_report(one, &a, sizeof a));
    expect_ok(vbss_metrics_get_report(two, &b, sizeof b));
    assert_memory_equal(&a, &b, sizeof a);
    assert_true(a.score > 0.0);
    end(&f);
}

static void snapshot_of_other_config_is_rejected(void **state)
{
    (void)state;
    static uint8_t bytes[1 << 17];
    fixture f;
    uint64_t written;
    begin_and_make(&f);
    show(&f, 3, 1.0, vec3_zero(), vec3_zero());
    expect_ok(vbss_metrics_save(f.metrics, bytes, sizeof bytes, &written));
    const vbss_metrics_config plain = f.config;
    size_t first = offsetof(vbss_metrics_config, tightness_test);
    for (size_t at = first; at < sizeof plain; at += 4) {
        f.config = plain;
        if (at < offsetof(vbss_metrics_config, duration)) {
            uint32_t word;
            memcpy(&word, (char *)&f.config + at, sizeof word);
            word++;
            memcpy((char *)&f.config + at, &word, sizeof word);
        } else if (at % 8 == 0) {
            double number;
            memcpy(&number, (char *)&f.config + at, sizeof number);
            number = number == 0.0 ? 1e-3 : number * (1.0 + 1e-12);
            memcpy((char *)&f.config + at, &number, sizeof number);
        } else {
            continue;
        }
        make(&f);
        uint64_t hash = hash_of(f.metrics);
        expect_result(VBSS_ERROR_CORRUPT, vbss_metrics_restore(f.metrics, bytes, written));
        assert_true(hash_of(f.metrics) == hash);
        expect_ok(vbss_metrics_destroy(f.metrics));
    }
    end(&f);
}

int test_metrics_state(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(restored_metrics_continue_bit_equal),
        harness_test(bad_snapshots_are_rejected),
        harness_test(samples_and_events_do_not_allocate),
        harness_test(same_log_gives_same_bits),
        harness_test(snapshot_of_other_config_is_rejected),
    };
    return cmocka_run_group_tests_name("metrics.metrics_state", tests, NULL, NULL);
}
