#include <stdlib.h>
#include <string.h>

#include "harness/harness.h"
#include "scenes/rod_body.h"

static void a_restored_body_goes_on_to_the_same_bits(void **state)
{
    (void)state;
    harness_body body = rod_body(NULL);
    harness_save_restore_continue(&body, 100, 1000);
    harness_save_restore_continue(&body, 0, 10);
}

static void damaged_snapshots_change_nothing(void **state)
{
    (void)state;
    harness_body body = rod_body(NULL);
    harness_refuses_bad_snapshots(&body, 20);
}

static vbss_slot *open_rod(vbss_context *context, uint32_t nodes, rod **handle)
{
    rod_config config;
    vbss_slot *slot;
    expect_ok(rod_config_init(&config, sizeof config));
    config.node_count = nodes;
    expect_ok(rod_create(context, &config, handle));
    expect_ok(vbss_slot_open(*handle, &rod_kind, &slot));
    return slot;
}

static void the_state_of_another_size_is_refused_by_name(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    rod *small, *large;
    vbss_slot *from = open_rod(context, 10, &small), *to = open_rod(context, 11, &large);
    size_t count, written;
    expect_ok(vbss_snapshot_size(from, &count));
    uint8_t *bytes = malloc(count);
    expect_ok(vbss_snapshot_save(from, bytes, count, &written));
    uint64_t before, after;
    expect_ok(vbss_snapshot_hash(to, &before));
    expect_result(VBSS_ERROR_CORRUPT, vbss_snapshot_restore(to, bytes, count));
    expect_ok(vbss_snapshot_hash(to, &after));
    assert_true(before == after);
    const char *text;
    expect_ok(vbss_context_get_last_error(context, NULL, &text));
    assert_non_null(strstr(text, "rod restore"));
    assert_non_null(strstr(text, "another configuration"));
    assert_non_null(strstr(text, "section ROD , field 1"));
    free(bytes);
    harness_context_end(context, &memory);
}

/* ---- a state that is not finite, with a constant behind it that can be made not to fit */

typedef struct broken {
    double values[2];
    uint64_t configuration;
} broken;

static void keep_broken(vbss_context *context, void *object)
{
    (void)context;
    (void)object;
}

static void serialise_broken(vbss_stream *stream, void *object)
{
    broken *b = object;
    vbss_stream_f64(stream, 1, b->values, 2);
    vbss_stream_same(stream, 2, b->configuration);
}

static const vbss_kind broken_kind = {"broken", VBSS_CODE('B', 'R', 'K', 'N'), 1, keep_broken,
                                      serialise_broken};

static void the_way_back_keeps_even_a_broken_state(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    broken object = {{1.0, 2.0}, 7};
    vbss_slot *slot;
    uint8_t bytes[256];
    size_t written;
    expect_ok(vbss_slot_create(context, &broken_kind, &object, &slot));
    expect_ok(vbss_snapshot_save(slot, bytes, sizeof bytes, &written));
    object.values[0] = harness_bad_numbers[0];
    object.values[1] = harness_bad_numbers[1];
    object.configuration = 8; /* found only after the values were read */
    uint64_t before, after;
    expect_ok(vbss_snapshot_hash(slot, &before));
    expect_result(VBSS_ERROR_CORRUPT, vbss_snapshot_restore(slot, bytes, written));
    expect_ok(vbss_snapshot_hash(slot, &after));
    assert_true(before == after);
    expect_same_bits(harness_bad_numbers[1], object.values[1]);

    /* Out of a broken state a good one is restored; a broken one is saved but never restored. */
    object.configuration = 7;
    expect_ok(vbss_snapshot_restore(slot, bytes, written));
    expect_same_bits(1.0, object.values[0]);
    object.values[0] = harness_bad_numbers[0];
    expect_ok(vbss_snapshot_save(slot, bytes, sizeof bytes, &written));
    expect_result(VBSS_ERROR_CORRUPT, vbss_snapshot_restore(slot, bytes, written));
    harness_context_end(context, &memory);
}

static vbss_result save_and_restore(vbss_context *context, void *user)
{
    (void)user;
    rod_config config;
    rod *handle = NULL;
    vbss_slot *slot = NULL;
    uint8_t bytes[8192];
    size_t written = 0;
    vbss_result result = rod_config_init(&config, sizeof config);
    result = result == VBSS_OK ? rod_create(context, &config, &handle) : result;
    result = result == VBSS_OK ? vbss_slot_open(handle, &rod_kind, &slot) : result;
    result = result == VBSS_OK ? vbss_snapshot_save(slot, bytes, sizeof bytes, &written) : result;
    result = result == VBSS_OK ? vbss_snapshot_restore(slot, bytes, written) : result;
    expect_ok(rod_destroy(handle));
    return result;
}

static void every_allocation_may_fail(void **state)
{
    (void)state;
    harness_fail_every_allocation(save_and_restore, NULL);
}

int test_snapshot(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(a_restored_body_goes_on_to_the_same_bits),
        harness_test(damaged_snapshots_change_nothing),
        harness_test(the_state_of_another_size_is_refused_by_name),
        harness_test(the_way_back_keeps_even_a_broken_state),
        harness_test(every_allocation_may_fail),
    };
    return cmocka_run_group_tests_name("base.snapshot", tests, NULL, NULL);
}
