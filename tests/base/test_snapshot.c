#include <stdlib.h>
#include <string.h>

#include "base/snapshot.h"
#include "harness/harness.h"
#include "fixtures/rod_body.h"

static void restored_body_continues_bit_equal(void **state)
{
    (void)state;
    harness_body body = rod_body(NULL);
    harness_save_restore_continue(&body, 100, 1000);
    harness_save_restore_continue(&body, 0, 10);
}

static void damaged_snapshot_changes_nothing(void **state)
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

static void snapshot_of_other_size_is_rejected_by_name(void **state)
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
    /* Same size, another length: the same arrays mean something else. */
    rod_config config;
    rod *longer;
    vbss_slot *slot;
    expect_ok(rod_config_init(&config, sizeof config));
    config.node_count = 10;
    config.length = 0.3;
    expect_ok(rod_create(context, &config, &longer));
    expect_ok(vbss_slot_open(longer, &rod_kind, &slot));
    expect_result(VBSS_ERROR_CORRUPT, vbss_snapshot_restore(slot, bytes, count));
    free(bytes);
    harness_context_end(context, &memory);
}

/* ---- small objects of the test's own, with a snapshot of how they began */

typedef struct small_life {
    harness_memory memory;
    vbss_context *context;
    vbss_slot *slot;
    uint8_t bytes[256];
    size_t written;
} small_life;

static void begin_small(small_life *life, const vbss_kind *kind, void *object)
{
    memset(life, 0, sizeof *life);
    life->context = harness_context(&life->memory);
    expect_ok(vbss_slot_create(life->context, kind, object, &life->slot));
    expect_ok(vbss_snapshot_save(life->slot, life->bytes, sizeof life->bytes, &life->written));
}

static vbss_result restore_small(const small_life *life)
{
    return vbss_snapshot_restore(life->slot, life->bytes, life->written);
}

static void end_small(small_life *life)
{
    harness_context_end(life->context, &life->memory);
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
    vbss_stream_expect(stream, 2, b->configuration);
}

static const vbss_kind broken_kind = {
    "broken", VBSS_CODE('B', 'R', 'K', 'N'), 1, keep_broken, serialise_broken, NULL};

static void rollback_keeps_invalid_state(void **state)
{
    (void)state;
    small_life life;
    broken object = {{1.0, 2.0}, 7};
    begin_small(&life, &broken_kind, &object);
    object.values[0] = harness_bad_numbers[0];
    object.values[1] = harness_bad_numbers[1];
    object.configuration = 8; /* found only after the values were read */
    uint64_t before, after;
    expect_ok(vbss_snapshot_hash(life.slot, &before));
    expect_result(VBSS_ERROR_CORRUPT, restore_small(&life));
    expect_ok(vbss_snapshot_hash(life.slot, &after));
    assert_true(before == after);
    expect_same_bits(harness_bad_numbers[1], object.values[1]);

    /* Out of a broken state a good one is restored; a broken one is saved but never restored. */
    object.configuration = 7;
    expect_ok(restore_small(&life));
    expect_same_bits(1.0, object.values[0]);
    object.values[0] = harness_bad_numbers[0];
    expect_ok(vbss_snapshot_save(life.slot, life.bytes, sizeof life.bytes, &life.written));
    expect_result(VBSS_ERROR_CORRUPT, restore_small(&life));
    end_small(&life);
}

/* A visitor that refuses what is there now must not stand in the way of what was there before. */
static void serialise_picky(vbss_stream *stream, void *object)
{
    double *values = object;
    vbss_stream_f64(stream, 1, values, 2);
    if (values[0] < 0.0) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "negative");
    }
    vbss_stream_f64(stream, 2, values + 2, 1);
}

static const vbss_kind picky_kind = {
    "picky", VBSS_CODE('P', 'I', 'C', 'K'), 1, keep_broken, serialise_picky, NULL};

static void state_rejected_by_its_visitor_cannot_be_saved(void **state)
{
    (void)state;
    small_life life;
    double values[3] = {1.0, 2.0, 3.0};
    uint8_t bad[256];
    size_t written, size;
    uint64_t hash;
    begin_small(&life, &picky_kind, values);
    values[0] = -1.0;
    values[1] = 7.0;
    values[2] = 8.0;
    expect_result(VBSS_ERROR_CORRUPT, vbss_snapshot_save(life.slot, bad, sizeof bad, &written));
    expect_result(VBSS_ERROR_CORRUPT, vbss_snapshot_hash(life.slot, &hash));
    expect_result(VBSS_ERROR_CORRUPT, vbss_snapshot_size(life.slot, &size));
    /* A refused restore: the good bytes with a first value the visitor does not take. */
    memcpy(bad, life.bytes, life.written);
    bad[16 + 8 + 8 + 7] ^= 0x80; /* the sign of 1.0 */
    harness_seal_snapshot(bad, life.written);
    expect_result(VBSS_ERROR_CORRUPT, vbss_snapshot_restore(life.slot, bad, life.written));
    expect_same_bits(-1.0, values[0]);
    expect_same_bits(7.0, values[1]);
    expect_same_bits(8.0, values[2]);
    expect_ok(restore_small(&life));
    expect_same_bits(3.0, values[2]);
    end_small(&life);
}

/* What a log callback finds when it looks at the object it is told about. */
typedef struct witness {
    const double *observed;
    double saw;
    int calls;
} witness;

static void observe(void *user, vbss_log_level level, const char *message)
{
    witness *w = user;
    (void)level;
    (void)message;
    w->saw = *w->observed;
    w->calls++;
}

static void rejected_restore_is_undone_before_report(void **state)
{
    (void)state;
    small_life life;
    double values[3] = {1.0, 2.0, 3.0};
    witness w = {values, 0.0, 0};
    memset(&life, 0, sizeof life);
    vbss_context_config config = harness_watched_config(&life.memory);
    config.log = observe;
    config.log_user = &w;
    config.log_level = VBSS_LOG_ERROR;
    expect_ok(vbss_context_create(&config, &life.context));
    expect_ok(vbss_slot_create(life.context, &picky_kind, values, &life.slot));
    expect_ok(vbss_snapshot_save(life.slot, life.bytes, sizeof life.bytes, &life.written));
    life.bytes[16 + 8 + 8 + 7] ^= 0x80; /* the sign of 1.0 */
    harness_seal_snapshot(life.bytes, life.written);
    expect_result(VBSS_ERROR_CORRUPT, restore_small(&life));
    assert_int_equal(w.calls, 1);
    expect_same_bits(1.0, w.saw);
    end_small(&life);
}

static void too_small_buffer_is_untouched(void **state)
{
    (void)state;
    small_life life;
    double values[3] = {1.0, 2.0, 3.0};
    uint8_t bytes[256];
    size_t size, written = 99;
    begin_small(&life, &picky_kind, values);
    expect_ok(vbss_snapshot_size(life.slot, &size));
    for (size_t capacity = 0; capacity < size; capacity++) {
        memset(bytes, 0xee, sizeof bytes);
        expect_result(VBSS_ERROR_CAPACITY,
                      vbss_snapshot_save(life.slot, bytes, capacity, &written));
        for (size_t i = capacity; i < sizeof bytes; i++) {
            assert_int_equal(bytes[i], 0xee);
        }
    }
    assert_int_equal(written, 99);
    expect_ok(vbss_snapshot_save(life.slot, bytes, size, &written));
    assert_int_equal(written, size);
    end_small(&life);
}

static void restore_inside_callback_is_rejected(void **state)
{
    (void)state;
    small_life life;
    double values[3] = {1.0, 2.0, 3.0};
    begin_small(&life, &picky_kind, values);
    values[2] = 4.0;
    bool outer = vbss_callback_begin(life.context);
    expect_result(VBSS_ERROR_BUSY, restore_small(&life));
    vbss_callback_end(life.context, outer);
    expect_same_bits(4.0, values[2]);
    expect_ok(restore_small(&life));
    expect_same_bits(3.0, values[2]);
    end_small(&life);
}

static void other_format_is_rejected(void **state)
{
    (void)state;
    small_life life;
    double values[3] = {1.0, 2.0, 3.0};
    begin_small(&life, &picky_kind, values);
    const uint8_t formats[] = {0, 3}; /* older and newer */
    for (int i = 0; i < 2; i++) {
        life.bytes[4] = formats[i];
        harness_seal_snapshot(life.bytes, life.written);
        expect_result(VBSS_ERROR_DATA_VERSION, restore_small(&life));
    }
    end_small(&life);
}

/* A body whose visitor writes what its room does not hold is told, and nothing is read or written
 * beyond it. */
typedef struct crowded {
    uint32_t count;
    double values[4];
} crowded;

static void serialise_crowded(vbss_stream *stream, void *object)
{
    crowded *c = object;
    vbss_stream_count(stream, 1, &c->count, 4);
    vbss_stream_f64(stream, 2, c->values, c->count);
}

static const vbss_kind crowded_kind = {
    "crowded", VBSS_CODE('C', 'R', 'W', 'D'), 1, keep_broken, serialise_crowded, NULL};

static void count_above_capacity_stops_restore(void **state)
{
    (void)state;
    small_life life;
    crowded object = {2, {1.0, 2.0, 3.0, 4.0}};
    begin_small(&life, &crowded_kind, &object);
    object.count = 1000000;
    expect_result(VBSS_ERROR_CAPACITY, restore_small(&life));
    assert_int_equal(object.count, 1000000);
    end_small(&life);
}

/* Data behind the state, under a right length and checksum. */
static void snapshot_has_no_trailing_bytes(void **state)
{
    (void)state;
    small_life life;
    double values[3] = {1.0, 2.0, 3.0};
    begin_small(&life, &picky_kind, values);
    life.bytes[8] = (uint8_t)(life.bytes[8] + 8); /* the payload's length */
    life.written += 8;
    harness_seal_snapshot(life.bytes, life.written);
    expect_result(VBSS_ERROR_CORRUPT, restore_small(&life));
    end_small(&life);
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

static void each_failed_allocation_is_reported(void **state)
{
    (void)state;
    harness_fail_every_allocation(save_and_restore, NULL);
}

int test_snapshot(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(restored_body_continues_bit_equal),
        harness_test(damaged_snapshot_changes_nothing),
        harness_test(snapshot_of_other_size_is_rejected_by_name),
        harness_test(rollback_keeps_invalid_state),
        harness_test(state_rejected_by_its_visitor_cannot_be_saved),
        harness_test(rejected_restore_is_undone_before_report),
        harness_test(too_small_buffer_is_untouched),
        harness_test(restore_inside_callback_is_rejected),
        harness_test(other_format_is_rejected),
        harness_test(count_above_capacity_stops_restore),
        harness_test(snapshot_has_no_trailing_bytes),
        harness_test(each_failed_allocation_is_reported),
    };
    return cmocka_run_group_tests_name("base.snapshot", tests, NULL, NULL);
}
