#include <pthread.h>

#include "base/snapshot.h"
#include "harness/harness.h"
#include "fixtures/rod_body.h"

enum { WORKERS = 4, STEPS = 200 };

/* A context of its own, stepped and saved; the hash is the answer, 0 a failure. */
static void *live(void *answer)
{
    uint64_t *hash = answer;
    vbss_context *context;
    void *handle;
    vbss_slot *slot;
    *hash = 0;
    if (vbss_context_create(NULL, &context) != VBSS_OK) {
        return NULL;
    }
    vbss_result result = rod_body_create(context, NULL, &handle);
    for (int i = 0; i < STEPS && result == VBSS_OK; i++) {
        result = rod_body_step(handle);
    }
    if (result == VBSS_OK && vbss_slot_open(handle, &rod_kind, &slot) == VBSS_OK) {
        vbss_snapshot_hash(slot, hash);
    }
    vbss_context_destroy(context);
    return NULL;
}

static void contexts_on_parallel_threads_are_independent(void **state)
{
    (void)state;
    uint64_t alone, hashes[WORKERS];
    pthread_t threads[WORKERS];
    live(&alone);
    assert_true(alone != 0);
    for (int i = 0; i < WORKERS; i++) {
        assert_int_equal(pthread_create(&threads[i], NULL, live, &hashes[i]), 0);
    }
    for (int i = 0; i < WORKERS; i++) {
        pthread_join(threads[i], NULL);
        assert_true(hashes[i] == alone);
    }
}

int test_threads(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(contexts_on_parallel_threads_are_independent),
    };
    return cmocka_run_group_tests_name("base.threads", tests, NULL, NULL);
}
