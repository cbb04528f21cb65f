/* How to measure: the size protocol, defaults, every bad number, memory that fails, handles. */
#include "fixture.h"

static vbss_result init(void *config, uint32_t struct_size)
{
    return vbss_metrics_config_init(config, struct_size);
}

static vbss_result create_and_destroy(vbss_context *context, const void *config)
{
    vbss_metrics *metrics = NULL;
    vbss_result result = vbss_metrics_create(context, config, &metrics);
    return result == VBSS_OK ? vbss_metrics_destroy(metrics) : result;
}

static void config_size_protocol(void **state)
{
    (void)state;
    const uint32_t sizes[] = {176, 192, 0};
    const harness_config config = {sizes, init, create_and_destroy};
    harness_config_protocol(&config);
}

static void null_config_is_default(void **state)
{
    (void)state;
    fixture f;
    begin_and_make(&f);
    vbss_metrics *plain;
    metrics_object *m;
    expect_ok(vbss_metrics_create(f.context, NULL, &plain));
    expect_ok(vbss_metrics_open(plain, &m));
    assert_memory_equal(&f.config, &m->config, sizeof f.config);
    assert_true(hash_of(plain) == hash_of(f.metrics));
    expect_same_bits(600.0, f.config.max_time);
    expect_same_bits(10.0, f.config.weight_deviation);
    expect_same_bits(10.0, f.config.weight_gap);
    expect_same_bits(1.0, f.config.weight_tightness);
    expect_same_bits(2.0, f.config.pull_force);
    expect_same_bits(5e-3, f.config.idle_speed);
    expect_same_bits(2.0, f.config.max_speed);
    expect_same_bits(0.02, f.config.lost_share);
    assert_int_equal(f.config.throws_wanted, 3);
    end(&f);
}

/* ---- bad numbers */

static void expect_config(const fixture *f, vbss_result wanted)
{
    vbss_metrics *metrics = (vbss_metrics *)f->context;
    vbss_context_statistics before, after;
    expect_ok(vbss_context_get_statistics(f->context, &before, sizeof before));
    vbss_result result = vbss_metrics_create(f->context, &f->config, &metrics);
    expect_result(wanted, result);
    if (result == VBSS_OK) {
        expect_ok(vbss_metrics_destroy(metrics));
        return;
    }
    assert_null(metrics);
    expect_ok(vbss_context_get_statistics(f->context, &after, sizeof after));
    assert_true(before.bytes_allocated == after.bytes_allocated);
}

static void out_of_range_numbers_are_rejected(void **state)
{
    (void)state;
    static const double largest[] = {7200.0, 1.0, 1e9, 1e3, 1e3, 1.0, 1.0, 1.0, 1.0, 1e6, 1e6,
                                     1e6,    1e6, 1e6, 1e6, 1e6, 1e6, 1e6, 1e6, 1e6, 1.0};
    fixture f;
    begin(&f);
    const vbss_metrics_config plain = f.config;
    size_t first = offsetof(vbss_metrics_config, duration);
    for (size_t i = 0; i < sizeof largest / sizeof largest[0]; i++) {
        const double bad[] = {-1e-9, largest[i] * 1.001};
        for (int k = 0; k < 5; k++) {
            double value = k < 2 ? bad[k] : harness_bad_numbers[k - 2];
            memcpy((char *)&f.config + first + i * sizeof value, &value, sizeof value);
            expect_config(&f, k < 2 ? VBSS_ERROR_OUT_OF_RANGE : VBSS_ERROR_NOT_FINITE);
            f.config = plain;
        }
    }
    assert_true(first + sizeof largest == sizeof f.config);
    end(&f);
}

static void out_of_range_choices_are_rejected(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    const vbss_metrics_config plain = f.config;
    uint32_t *const words[] = {&f.config.throw_capacity, &f.config.phase_capacity,
                               &f.config.incident_capacity, &f.config.throws_wanted};
    static const uint32_t largest[] = {4096, 65536, 65536, 64};
    for (int i = 0; i < 4; i++) {
        *words[i] = largest[i];
        expect_config(&f, VBSS_OK);
        *words[i] = largest[i] + 1;
        expect_config(&f, VBSS_ERROR_OUT_OF_RANGE);
        *words[i] = 0;
        expect_config(&f, i < 3 ? VBSS_ERROR_OUT_OF_RANGE : VBSS_OK);
        f.config = plain;
    }
    f.config.tightness_test = 2;
    expect_config(&f, VBSS_ERROR_OUT_OF_RANGE);
    f.config = plain;
    f.config.idle_release = 0.5 * f.config.idle_speed; /* hysteresis the wrong way round */
    expect_config(&f, VBSS_ERROR_OUT_OF_RANGE);
    end(&f);
}

static vbss_result attempt(vbss_context *context, void *user)
{
    (void)user;
    return create_and_destroy(context, NULL);
}

static void each_failed_allocation_is_reported(void **state)
{
    (void)state;
    harness_fail_every_allocation(attempt, NULL);
}

/* ---- handles */

static vbss_result call_sample(void *m)
{
    vbss_metrics_sample s;
    expect_ok(vbss_metrics_sample_init(&s, sizeof s));
    return vbss_metrics_add_sample(m, &s);
}
static vbss_result call_event(void *m)
{
    vbss_metrics_event e = event_of(VBSS_METRICS_EVENT_PHASE, 1, 0.0);
    return vbss_metrics_add_event(m, &e);
}
static vbss_result call_pull(void *m)
{
    vbss_metrics_pull p;
    expect_ok(vbss_metrics_pull_init(&p, sizeof p));
    return vbss_metrics_add_pull(m, &p);
}
static vbss_result call_finish(void *m)
{
    return vbss_metrics_finish(m);
}
static vbss_result call_report(void *m)
{
    vbss_metrics_report r;
    return vbss_metrics_get_report(m, &r, sizeof r);
}
static vbss_result call_throw(void *m)
{
    vbss_metrics_throw r;
    return vbss_metrics_get_throw(m, 0, &r, sizeof r);
}
static vbss_result call_phase(void *m)
{
    vbss_metrics_phase r;
    return vbss_metrics_get_phase(m, 0, &r, sizeof r);
}
static vbss_result call_penalty(void *m)
{
    vbss_metrics_penalty r;
    return vbss_metrics_get_penalty(m, 0, &r, sizeof r);
}
static vbss_result call_motion(void *m)
{
    vbss_metrics_motion r;
    return vbss_metrics_get_motion(m, 0, VBSS_METRICS_PHASE_ALL, &r, sizeof r);
}
static vbss_result call_bimanual(void *m)
{
    vbss_metrics_bimanual r;
    return vbss_metrics_get_bimanual(m, VBSS_METRICS_PHASE_ALL, &r, sizeof r);
}
static vbss_result call_view(void *m)
{
    vbss_view r;
    return vbss_metrics_get_view(m, 0, &r, sizeof r);
}
static vbss_result call_save(void *m)
{
    uint64_t written;
    return vbss_metrics_save(m, NULL, 0, &written);
}
static vbss_result call_restore(void *m)
{
    const uint8_t bytes[64] = {0};
    return vbss_metrics_restore(m, bytes, sizeof bytes);
}
static vbss_result call_hash(void *m)
{
    uint64_t hash;
    return vbss_metrics_get_hash(m, &hash);
}
static vbss_result call_destroy(void *m)
{
    return m == NULL ? VBSS_ERROR_INVALID_HANDLE : vbss_metrics_destroy(m);
}

static void every_call_rejects_invalid_handles(void **state)
{
    (void)state;
    static const harness_handle_call calls[] = {
        call_sample, call_event, call_pull,    call_finish, call_report,
        call_throw,  call_phase, call_penalty, call_motion, call_bimanual,
        call_view,   call_save,  call_restore, call_hash,   call_destroy};
    fixture f;
    begin_and_make(&f);
    expect_ok(vbss_metrics_destroy(f.metrics));
    expect_ok(vbss_metrics_destroy(NULL));
    harness_refuses_bad_handles(f.context, f.metrics, calls, sizeof calls / sizeof calls[0]);
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_metrics_create(f.context, NULL, NULL));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_metrics_create(NULL, NULL, &f.metrics));
    end(&f);
}

int test_metrics_config(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(config_size_protocol),
        harness_test(null_config_is_default),
        harness_test(out_of_range_numbers_are_rejected),
        harness_test(out_of_range_choices_are_rejected),
        harness_test(each_failed_allocation_is_reported),
        harness_test(every_call_rejects_invalid_handles),
    };
    return cmocka_run_group_tests_name("metrics.metrics_config", tests, NULL, NULL);
}
