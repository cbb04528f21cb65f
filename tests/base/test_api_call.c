/* Entry and exit of public calls: the thread that owns the context, and the floating-point mode. */
#include <pthread.h>
#include <stdlib.h>

#include "base/api_call.h"
#include "base/error.h"
#include "fixtures/rod.h"
#include "harness/float_modes.h"
#include "harness/harness.h"

/* A host whose callbacks run `act` once, with the context and a rod in it. */
typedef struct host {
    vbss_context *context;
    rod *rod;
    void (*act)(struct host *h);
    vbss_result results[8];
    size_t mode;
    unsigned calls, calls_in_mode;
} host;

static void act_once(host *h)
{
    void (*act)(host *) = h->act;
    h->act = NULL;
    if (act != NULL) {
        act(h);
    }
    h->calls++;
    h->calls_in_mode += harness_mode_is(h->mode);
}

static void on_log(void *user, vbss_log_level level, const char *message)
{
    (void)level;
    (void)message;
    act_once(user);
}

static void *on_allocate(void *user, uint64_t size, uint64_t alignment)
{
    act_once(user);
    return aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}

static void on_release(void *user, void *block, uint64_t size, uint64_t alignment)
{
    (void)size;
    (void)alignment;
    act_once(user);
    free(block);
}

static void begin(host *h)
{
    vbss_context_config config;
    rod_config body;
    expect_ok(vbss_context_config_init(&config, sizeof config));
    config.allocate = on_allocate;
    config.deallocate = on_release;
    config.log = on_log;
    config.allocator_user = config.log_user = h;
    *h = (host){.context = NULL};
    expect_ok(vbss_context_create(&config, &h->context));
    expect_ok(rod_config_init(&body, sizeof body));
    expect_ok(rod_create(h->context, &body, &h->rod));
    h->calls = h->calls_in_mode = 0;
}

/* ---- two threads */

static void *call_from_second_thread(void *user)
{
    host *h = user;
    vbss_context_statistics statistics;
    vbss_result stored = VBSS_OK;
    double tip[3];
    h->results[0] = vbss_context_get_statistics(h->context, &statistics, sizeof statistics);
    h->results[1] = vbss_context_get_last_error(h->context, &stored, NULL);
    h->results[2] = rod_step(h->rod, 1e-3);
    h->results[3] = rod_get_tip(h->rod, tip);
    h->results[4] = rod_destroy(h->rod);
    h->results[5] = vbss_context_destroy(h->context);
    return NULL;
}

static void start_second_thread(host *h)
{
    pthread_t thread;
    assert_int_equal(pthread_create(&thread, NULL, call_from_second_thread, h), 0);
    pthread_join(thread, NULL);
}

static void second_thread_is_busy_while_one_is_inside(void **state)
{
    (void)state;
    host h;
    begin(&h);
    h.act = start_second_thread; /* from the log callback of a call that fails */
    expect_result(VBSS_ERROR_OUT_OF_RANGE, rod_step(h.rod, 7.0));
    for (int k = 0; k < 6; k++) {
        expect_result(VBSS_ERROR_BUSY, h.results[k]);
    }
    vbss_result stored;
    expect_ok(vbss_context_get_last_error(h.context, &stored, NULL));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, stored);
    expect_ok(rod_step(h.rod, 1e-3));
    expect_ok(vbss_context_destroy(h.context));
}

static void another_thread_may_use_the_context_afterwards(void **state)
{
    (void)state;
    host h;
    begin(&h);
    expect_ok(rod_step(h.rod, 1e-3));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, rod_step(h.rod, 7.0)); /* leaves, too */
    start_second_thread(&h);
    for (int k = 0; k < 6; k++) {
        expect_ok(h.results[k]);
    }
}

/* ---- calls from callbacks */

static void read_and_edit(host *h)
{
    vbss_context_statistics statistics;
    h->results[0] = vbss_context_get_statistics(h->context, &statistics, sizeof statistics);
    h->results[1] = rod_step(h->rod, 1e-3);
    h->results[2] = vbss_context_get_statistics(h->context, &statistics, sizeof statistics);
}

static void callback_may_read_and_not_edit(void **state)
{
    (void)state;
    host h;
    begin(&h);
    h.act = read_and_edit;
    expect_result(VBSS_ERROR_OUT_OF_RANGE, rod_step(h.rod, 7.0));
    expect_ok(h.results[0]);
    expect_result(VBSS_ERROR_BUSY, h.results[1]);
    expect_ok(h.results[2]);
    expect_ok(rod_step(h.rod, 1e-3));
    expect_ok(vbss_context_destroy(h.context));
}

static void use_another_context(host *h)
{
    vbss_context *other;
    rod_config config;
    rod *body;
    expect_ok(vbss_context_create(NULL, &other));
    expect_ok(rod_config_init(&config, sizeof config));
    expect_ok(rod_create(other, &config, &body));
    h->results[0] = rod_step(body, 1e-3);
    expect_ok(vbss_context_destroy(other));
}

static void callback_may_use_another_context(void **state)
{
    (void)state;
    host h;
    begin(&h);
    for (h.mode = 0; h.mode < harness_mode_count; h.mode++) {
        h.act = use_another_context;
        h.calls = h.calls_in_mode = 0;
        harness_mode_set(h.mode);
        vbss_result result = rod_step(h.rod, 7.0);
        harness_mode_end(h.mode);
        expect_result(VBSS_ERROR_OUT_OF_RANGE, result);
        expect_ok(h.results[0]);
        assert_int_equal(h.calls_in_mode, h.calls);
    }
    h.mode = 0;
    expect_ok(vbss_context_destroy(h.context));
}

/* ---- the floating-point mode */

static void host_mode_is_in_force_in_callbacks_and_after(void **state)
{
    (void)state;
    for (size_t k = 0; k < harness_mode_count; k++) {
        host h;
        begin(&h);
        h.mode = k;
        harness_mode_set(k);
        vbss_result failed = rod_step(h.rod, 7.0); /* logs */
        unsigned logged = h.calls;
        vbss_result stepped = rod_step(h.rod, 1e-3);
        vbss_result destroyed = vbss_context_destroy(h.context); /* releases */
        harness_mode_end(k);
        expect_result(VBSS_ERROR_OUT_OF_RANGE, failed);
        expect_ok(stepped);
        expect_ok(destroyed);
        assert_int_equal(logged, 1);
        assert_true(h.calls > logged);
        assert_int_equal(h.calls_in_mode, h.calls);
    }
}

static void set_next_mode(host *h)
{
    harness_mode_set(++h->mode);
}

static void mode_that_a_callback_sets_stays(void **state)
{
    (void)state;
    host h;
    begin(&h);
    for (size_t k = 0; k + 1 < harness_mode_count; k++) {
        h.mode = k;
        h.act = set_next_mode;
        harness_mode_set(k);
        vbss_result failed = rod_step(h.rod, 7.0);
        harness_mode_end(k + 1);
        expect_result(VBSS_ERROR_OUT_OF_RANGE, failed);
    }
    expect_ok(vbss_context_destroy(h.context));
}

static void results_have_the_same_bits_in_every_mode(void **state)
{
    (void)state;
    vbss_context *contexts[2];
    rod *rods[2];
    rod_config config;
    double tips[2][3];
    expect_ok(rod_config_init(&config, sizeof config));
    for (int i = 0; i < 2; i++) {
        expect_ok(vbss_context_create(NULL, &contexts[i]));
        expect_ok(rod_create(contexts[i], &config, &rods[i]));
    }
    for (size_t k = 0; k < harness_mode_count; k++) {
        for (int step = 0; step < 20; step++) {
            expect_ok(rod_step(rods[0], 1e-3));
            harness_mode_set(k);
            vbss_result result = rod_step(rods[1], 1e-3);
            harness_mode_end(k);
            expect_ok(result);
        }
    }
    for (int i = 0; i < 2; i++) {
        expect_ok(rod_get_tip(rods[i], tips[i]));
        expect_ok(vbss_context_destroy(contexts[i]));
    }
    assert_memory_equal(tips[0], tips[1], sizeof tips[0]);
}

static void call_elementary_functions(double x, double tiny, double results[5])
{
    results[0] = vbss_sin(x);
    results[1] = vbss_cos(x);
    results[2] = vbss_acos(x);
    results[3] = vbss_atan2(x, 0.3);
    results[4] = vbss_sin(tiny);
}

static void elementary_functions_have_the_same_bits_in_every_mode(void **state)
{
    (void)state;
    for (size_t k = 0; k < harness_mode_count; k++) {
        for (int i = 0; i < 200; i++) {
            double wanted[5], got[5];
            const double x = 0.01 * i - 1.0, tiny = 0x1p-1060 * i;
            call_elementary_functions(x, tiny, wanted);
            harness_mode_set(k);
            call_elementary_functions(x, tiny, got);
            harness_mode_end(k);
            for (int j = 0; j < 5; j++) {
                expect_same_bits(wanted[j], got[j]);
            }
        }
    }
}

int test_api_call(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(second_thread_is_busy_while_one_is_inside),
        harness_test(another_thread_may_use_the_context_afterwards),
        harness_test(callback_may_read_and_not_edit),
        harness_test(callback_may_use_another_context),
        harness_test(host_mode_is_in_force_in_callbacks_and_after),
        harness_test(mode_that_a_callback_sets_stays),
        harness_test(results_have_the_same_bits_in_every_mode),
        harness_test(elementary_functions_have_the_same_bits_in_every_mode),
    };
    return cmocka_run_group_tests_name("base.api_call", tests, NULL, NULL);
}
