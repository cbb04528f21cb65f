#include <string.h>

#include "base/error.h"
#include "base/memory.h"
#include "harness/harness.h"
#include "fixtures/rod.h"

static void context_without_config(void **state)
{
    (void)state;
    vbss_context *context = NULL;
    expect_ok(vbss_context_create(NULL, &context));
    assert_non_null(context);
    expect_ok(vbss_context_destroy(context));
    expect_ok(vbss_context_destroy(NULL));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_context_create(NULL, NULL));
}

static void incomplete_allocator_or_unknown_log_level_is_rejected(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context_config config = harness_watched_config(&memory);
    vbss_context *context = (vbss_context *)&memory;
    config.deallocate = NULL;
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_context_create(&config, &context));
    assert_null(context);
    config = harness_watched_config(&memory);
    config.allocate = NULL;
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_context_create(&config, &context));
    for (int32_t level = -1; level <= 4; level += 5) {
        config = harness_watched_config(&memory);
        config.log_level = level;
        expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_context_create(&config, &context));
    }
    assert_int_equal(memory.calls, 0);
}

static void null_context_is_rejected(void **state)
{
    (void)state;
    vbss_context_statistics statistics;
    struct {
        uint64_t words[64];
    } something_else = {{0}};
    vbss_context *wrong[] = {NULL, (vbss_context *)&something_else};
    for (int i = 0; i < 2; i++) {
        expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_context_get_last_error(wrong[i], NULL, NULL));
        expect_result(VBSS_ERROR_INVALID_HANDLE,
                      vbss_context_get_statistics(wrong[i], &statistics, sizeof statistics));
    }
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_context_destroy(wrong[1]));
}

static void body_handle_is_rejected_as_context(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    rod_config config;
    rod *body;
    expect_ok(rod_config_init(&config, sizeof config));
    expect_ok(rod_create(context, &config, &body));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_context_destroy((vbss_context *)body));
    expect_ok(rod_destroy(body));
    harness_context_end(context, &memory);
}

static void statistics_count_memory_and_objects(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_context_statistics empty, now;
    expect_ok(vbss_context_get_statistics(context, &empty, sizeof empty));
    assert_int_equal(empty.struct_size, sizeof empty);
    assert_int_equal(empty.allocation_count, 1);
    assert_int_equal(empty.bytes_peak, empty.bytes_allocated);
    assert_true(empty.bytes_allocated > 0);
    double *numbers = vbss_allocate(context, 100, sizeof *numbers, "numbers");
    for (int i = 0; i < 100; i++) {
        expect_same_bits(0.0, numbers[i]);
    }
    assert_int_equal((uintptr_t)numbers % VBSS_ALIGNMENT, 0);
    expect_ok(vbss_context_get_statistics(context, &now, sizeof now));
    assert_int_equal(now.bytes_allocated, empty.bytes_allocated + 800);
    assert_int_equal(now.allocation_count, 2);
    vbss_release(context, numbers, 100, sizeof *numbers);
    expect_ok(vbss_context_get_statistics(context, &now, sizeof now));
    assert_int_equal(now.bytes_allocated, empty.bytes_allocated);
    assert_int_equal(now.bytes_peak, empty.bytes_allocated + 800);
    assert_int_equal(now.objects_created, 0);
    vbss_release(context, vbss_allocate(context, 1, 100, "less"), 1, 100);
    expect_ok(vbss_context_get_statistics(context, &now, sizeof now));
    assert_int_equal(now.bytes_peak, empty.bytes_allocated + 800);
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_context_get_statistics(context, NULL, sizeof now));
    expect_result(VBSS_ERROR_STRUCT_SIZE, vbss_context_get_statistics(context, &now, 8));
    expect_result(VBSS_ERROR_STRUCT_SIZE, vbss_context_get_statistics(context, &now, 16));
    harness_context_end(context, &memory);
}

static void size_overflow_is_rejected_without_allocating(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    uint64_t calls = memory.calls;
    const char *text;
    vbss_result result;
    assert_null(vbss_allocate(context, SIZE_MAX / 2, 3, "everything"));
    assert_null(vbss_allocate(context, 3, SIZE_MAX / 2, "everything"));
    assert_null(vbss_allocate(context, SIZE_MAX - 32, 1, "everything"));
    assert_int_equal(memory.calls, calls);
    expect_ok(vbss_context_get_last_error(context, &result, &text));
    expect_result(VBSS_ERROR_OUT_OF_MEMORY, result);
    assert_non_null(strstr(text, "everything"));
    void *nothing = vbss_allocate(context, 0, 8, "nothing"); /* NULL is for failures */
    assert_non_null(nothing);
    vbss_release(context, nothing, 0, 8);
    harness_context_end(context, &memory);
}

static void last_error_persists_until_next_error(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_result result;
    const char *text;
    expect_ok(vbss_context_get_last_error(context, &result, &text));
    expect_ok(result);
    assert_string_equal(text, "");
    char long_name[1000];
    memset(long_name, 'x', sizeof long_name - 1);
    long_name[sizeof long_name - 1] = '\0';
    vbss_fail(context, VBSS_ERROR_CAPACITY, "%s", long_name);
    expect_ok(vbss_context_get_last_error(context, &result, &text));
    expect_result(VBSS_ERROR_CAPACITY, result);
    assert_int_equal(strlen(text), 255);
    vbss_fail(context, VBSS_ERROR_NOT_FINITE, "node %d", 3);
    expect_ok(vbss_context_get_last_error(context, &result, NULL));
    expect_result(VBSS_ERROR_NOT_FINITE, result);
    assert_string_equal(text, "node 3");
    harness_context_end(context, &memory);
}

/* ---- log */

typedef struct heard {
    int count;
    vbss_log_level level;
    char text[300];
    vbss_context *context;
    rod *body;
    vbss_result destroyed, stepped, context_destroyed;
    bool saw_its_error; /* the last error is the one that is being told */
} heard;

static void listen(void *user, vbss_log_level level, const char *message)
{
    heard *h = user;
    h->count++;
    h->level = level;
    snprintf(h->text, sizeof h->text, "%s", message);
    const char *kept = "";
    vbss_context_get_last_error(h->context, NULL, &kept);
    h->saw_its_error = strcmp(kept, message) == 0;
    if (h->body != NULL) {
        h->destroyed = rod_destroy(h->body);
        h->stepped = rod_step(h->body, 1e-3);
        h->context_destroyed = vbss_context_destroy(h->context);
    }
}

static void log_messages_are_filtered_by_level(void **state)
{
    (void)state;
    for (vbss_log_level level = VBSS_LOG_NONE; level <= VBSS_LOG_INFO; level++) {
        heard h = {0};
        vbss_context_config config;
        vbss_context *context;
        expect_ok(vbss_context_config_init(&config, sizeof config));
        config.log_level = level;
        config.log = listen;
        config.log_user = &h;
        expect_ok(vbss_context_create(&config, &context));
        assert_int_equal(h.count, level >= VBSS_LOG_INFO);
        vbss_message(context, VBSS_LOG_WARNING, "knot %d slips", 2);
        assert_int_equal(h.count, (level >= VBSS_LOG_INFO) + (level >= VBSS_LOG_WARNING));
        if (level >= VBSS_LOG_WARNING) {
            assert_string_equal(h.text, "knot 2 slips");
        }
        int before = h.count;
        vbss_fail(context, VBSS_ERROR_CAPACITY, "full");
        assert_int_equal(h.count - before, level >= VBSS_LOG_ERROR);
        expect_ok(vbss_context_destroy(context));
    }
}

static void log_callback_cannot_reenter(void **state)
{
    (void)state;
    heard h = {0};
    harness_memory memory;
    vbss_context_config config = harness_watched_config(&memory);
    vbss_context *context;
    config.log = listen;
    config.log_user = &h;
    expect_ok(vbss_context_create(&config, &context));
    rod_config body;
    expect_ok(rod_config_init(&body, sizeof body));
    expect_ok(rod_create(context, &body, &h.body));
    h.context = context;
    vbss_message(context, VBSS_LOG_WARNING, "now");
    expect_result(VBSS_ERROR_BUSY, h.destroyed);
    expect_result(VBSS_ERROR_BUSY, h.stepped);
    expect_result(VBSS_ERROR_BUSY, h.context_destroyed);
    assert_int_equal(h.count, 1); /* the failures inside did not call back again */
    rod *alive = h.body;
    h.body = NULL;
    expect_ok(rod_step(alive, 1e-3));
    expect_ok(rod_destroy(alive));
    harness_context_end(context, &memory);
}

/* ---- callbacks that call back */

static void error_survives_failing_callback(void **state)
{
    (void)state;
    heard h = {0};
    harness_memory memory;
    vbss_context_config config = harness_watched_config(&memory);
    config.log = listen;
    config.log_user = &h;
    expect_ok(vbss_context_create(&config, &h.context));
    rod_config body;
    expect_ok(rod_config_init(&body, sizeof body));
    expect_ok(rod_create(h.context, &body, &h.body));
    rod *alive = h.body;
    expect_result(VBSS_ERROR_OUT_OF_RANGE, rod_step(alive, 5.0));
    expect_result(VBSS_ERROR_BUSY, h.stepped);
    assert_non_null(strstr(h.text, "h is 5"));
    assert_true(h.saw_its_error);
    vbss_result kept;
    const char *text;
    expect_ok(vbss_context_get_last_error(h.context, &kept, &text));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, kept);
    assert_string_equal(text, h.text);
    h.body = NULL;
    harness_context_end(h.context, &memory);
}

typedef struct meddler {
    harness_memory memory;
    vbss_context_config watched;
    vbss_context *context; /* once it is there, each call tries to change it */
    vbss_result results[3];
    int tried;
} meddler;

static void meddle(meddler *m)
{
    if (m->context != NULL) {
        rod_config config;
        rod *made;
        vbss_context *context = m->context;
        m->context = NULL; /* once, or a library that lets it happen would never end */
        m->tried++;
        m->results[0] = rod_config_init(&config, sizeof config);
        m->results[1] = rod_create(context, &config, &made);
        m->results[2] = vbss_context_destroy(context);
        m->context = context;
    }
}

static void *meddling_allocate(void *user, uint64_t size, uint64_t alignment)
{
    meddler *m = user;
    meddle(m);
    return m->watched.allocate(m->watched.allocator_user, size, alignment);
}

static void meddling_release(void *user, void *block, uint64_t size, uint64_t alignment)
{
    meddler *m = user;
    meddle(m);
    m->watched.deallocate(m->watched.allocator_user, block, size, alignment);
}

static vbss_context *meddled_context(meddler *m)
{
    memset(m, 0, sizeof *m);
    m->watched = harness_watched_config(&m->memory);
    vbss_context_config config = m->watched;
    config.allocate = meddling_allocate;
    config.deallocate = meddling_release;
    config.allocator_user = m;
    vbss_context *context;
    expect_ok(vbss_context_create(&config, &context));
    return context;
}

static void allocator_callback_cannot_reenter(void **state)
{
    (void)state;
    meddler m;
    vbss_context *context = meddled_context(&m);
    m.context = context;
    rod_config body;
    rod *handle;
    expect_ok(rod_config_init(&body, sizeof body));
    expect_ok(rod_create(context, &body, &handle));
    expect_result(VBSS_ERROR_BUSY, m.results[1]);
    expect_result(VBSS_ERROR_BUSY, m.results[2]);
    int tried = m.tried;
    assert_true(tried > 0);
    expect_ok(rod_destroy(handle));
    assert_true(m.tried > tried);
    expect_result(VBSS_ERROR_BUSY, m.results[1]);
    m.context = NULL;
    harness_context_end(context, &m.memory);
}

static void callbacks_nest(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    bool outer = vbss_callback_begin(context), inner = vbss_callback_begin(context);
    vbss_callback_end(context, inner);
    expect_result(VBSS_ERROR_BUSY, vbss_context_edit(context));
    vbss_callback_end(context, outer);
    expect_ok(vbss_context_edit(context));
    harness_context_end(context, &memory);
}

/* The release callback of a failing creation calls back, and is refused: the reason stays. */
static void error_survives_failing_release(void **state)
{
    (void)state;
    meddler m;
    vbss_context *context = meddled_context(&m);
    rod_config body;
    rod *handle;
    expect_ok(rod_config_init(&body, sizeof body));
    m.context = context;
    m.memory.fail_call = m.memory.calls + 3; /* the third block of a rod */
    expect_result(VBSS_ERROR_OUT_OF_MEMORY, rod_create(context, &body, &handle));
    expect_result(VBSS_ERROR_BUSY, m.results[1]);
    vbss_result kept;
    const char *text;
    expect_ok(vbss_context_get_last_error(context, &kept, &text));
    expect_result(VBSS_ERROR_OUT_OF_MEMORY, kept);
    assert_non_null(strstr(text, "rod velocities"));
    m.context = NULL;
    harness_context_end(context, &m.memory);
}

/* ---- an allocator that does not keep its word */

typedef struct skewed {
    vbss_context_config good;
    size_t by; /* bytes off the alignment */
} skewed;

static void *skewed_allocate(void *user, uint64_t size, uint64_t alignment)
{
    skewed *s = user;
    assert_true(size > 0); /* the library never asks for nothing */
    unsigned char *block = s->good.allocate(s->good.allocator_user, size + s->by, alignment);
    return block == NULL ? NULL : block + s->by;
}

static void skewed_release(void *user, void *block, uint64_t size, uint64_t alignment)
{
    skewed *s = user;
    uintptr_t off = (uintptr_t)block % alignment;
    s->good.deallocate(s->good.allocator_user, (unsigned char *)block - off, size + off, alignment);
}

static void misaligned_allocation_is_released(void **state)
{
    (void)state;
    harness_memory memory;
    skewed s = {harness_watched_config(&memory), 8};
    vbss_context_config config = s.good;
    vbss_context *context;
    config.allocate = skewed_allocate;
    config.deallocate = skewed_release;
    config.allocator_user = &s;
    expect_result(VBSS_ERROR_OUT_OF_MEMORY, vbss_context_create(&config, &context));
    assert_null(context);
    assert_int_equal(memory.calls, 1);
    assert_int_equal(memory.blocks, 0);
    s.by = 0;
    expect_ok(vbss_context_create(&config, &context));
    s.by = 8;
    assert_null(vbss_allocate(context, 1, 8, "skewed"));
    assert_int_equal(memory.blocks, 1);
    s.by = 0;
    vbss_release(context, vbss_allocate(context, 0, 8, "empty"), 0, 8);
    expect_ok(vbss_context_destroy(context));
    assert_int_equal(memory.blocks, 0);
    assert_int_equal(memory.wrong_releases, 0);
}

/* ---- the end */

static void destroy_with_live_objects_is_no_trouble(void **state)
{
    (void)state;
    for (int left = 0; left < 3; left++) {
        heard h = {0};
        harness_memory memory;
        vbss_context_config config = harness_watched_config(&memory);
        vbss_context *context;
        config.log = listen;
        config.log_user = &h;
        expect_ok(vbss_context_create(&config, &context));
        rod_config body;
        rod *bodies[3];
        expect_ok(rod_config_init(&body, sizeof body));
        for (int i = 0; i < 3; i++) {
            expect_ok(rod_create(context, &body, &bodies[i]));
        }
        for (int i = left; i < 3; i++) {
            expect_ok(rod_destroy(bodies[i]));
        }
        harness_context_end(context, &memory);
        assert_int_equal(h.count, 0);
    }
}

static vbss_result use_a_context(vbss_context *context, void *user)
{
    (void)user;
    void *block = vbss_allocate(context, 10, 10, "block");
    vbss_release(context, block, 10, 10);
    return block != NULL ? VBSS_OK : VBSS_ERROR_OUT_OF_MEMORY;
}

static void each_failed_allocation_is_reported(void **state)
{
    (void)state;
    harness_fail_every_allocation(use_a_context, NULL);
}

int test_context(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(context_without_config),
        harness_test(incomplete_allocator_or_unknown_log_level_is_rejected),
        harness_test(null_context_is_rejected),
        harness_test(body_handle_is_rejected_as_context),
        harness_test(statistics_count_memory_and_objects),
        harness_test(size_overflow_is_rejected_without_allocating),
        harness_test(last_error_persists_until_next_error),
        harness_test(log_messages_are_filtered_by_level),
        harness_test(log_callback_cannot_reenter),
        harness_test(error_survives_failing_callback),
        harness_test(allocator_callback_cannot_reenter),
        harness_test(callbacks_nest),
        harness_test(error_survives_failing_release),
        harness_test(misaligned_allocation_is_released),
        harness_test(destroy_with_live_objects_is_no_trouble),
        harness_test(each_failed_allocation_is_reported),
    };
    return cmocka_run_group_tests_name("base.context", tests, NULL, NULL);
}
