/* Properties of snapshots: whose they are, and buffers that are too small. */
#include <stdlib.h>
#include <string.h>

#include "base/snapshot.h"
#include "contract/contract.h"

enum { MAX_BYTES = 65536, MAX_CONFIG = 1024 };

typedef struct subject {
    harness_memory memory;
    vbss_context *context;
    double config[MAX_CONFIG / sizeof(double)]; /* aligned for any struct */
    void *handle;
    uint8_t bytes[MAX_BYTES];
    uint64_t count;
} subject;
static subject sub;

static uint64_t hash_of(const contract_snapshot *s, void *handle)
{
    vbss_slot *slot;
    uint64_t hash = 0;
    expect_ok(vbss_slot_open(handle, s->kind, &slot));
    expect_ok(vbss_snapshot_hash(slot, &hash));
    return hash;
}

static vbss_result restore(const contract_snapshot *s, void *handle, const uint8_t *bytes,
                           uint64_t count)
{
    return vbss_object_restore(handle, s->kind, bytes, count);
}

static void begin(const contract_snapshot *s)
{
    assert_true(s->config_size <= MAX_CONFIG);
    sub.context = harness_context(&sub.memory);
    s->config(sub.config);
    expect_ok(s->create(sub.context, sub.config, &sub.handle));
    expect_ok(vbss_object_save(sub.handle, s->kind, sub.bytes, sizeof sub.bytes, &sub.count));
}

static void end(void)
{
    harness_context_end(sub.context, &sub.memory);
}

/* ---- buffers */

static void small_buffer_reports_required_size(void **state)
{
    const contract_snapshot *s = *state;
    uint64_t need = 0, written = 0;
    begin(s);
    expect_result(VBSS_ERROR_NULL_ARGUMENT, s->save(sub.handle, sub.bytes, MAX_BYTES, NULL));
    expect_result(VBSS_ERROR_CAPACITY, s->save(sub.handle, NULL, 0, &need));
    assert_int_equal(need, sub.count);
    for (uint64_t capacity = 0; capacity < need; capacity += 1 + capacity / 8) {
        sub.bytes[capacity] = 0x5a;
        expect_result(VBSS_ERROR_CAPACITY, s->save(sub.handle, sub.bytes, capacity, &written));
        assert_int_equal(written, need);
        assert_int_equal(sub.bytes[capacity], 0x5a);
    }
    expect_result(VBSS_ERROR_NULL_ARGUMENT, s->save(sub.handle, NULL, need, &written));
    expect_ok(s->save(sub.handle, sub.bytes, need, &written));
    assert_int_equal(written, need);
    expect_result(VBSS_ERROR_NULL_ARGUMENT, s->restore(sub.handle, NULL, need));
    expect_result(VBSS_ERROR_TRUNCATED, s->restore(sub.handle, sub.bytes, need - 1));
    expect_result(VBSS_ERROR_TRUNCATED, s->restore(sub.handle, sub.bytes, 0));
    expect_ok(s->restore(sub.handle, sub.bytes, need));
    end();
}

/* ---- configurations */

static void change(void *config, const contract_field *field, size_t k)
{
    char *at = (char *)config + field->offset + k * sizeof(double);
    if (field->count > 0) {
        double value;
        memcpy(&value, at, sizeof value);
        value = value != 0.0 ? field->factor * value : 1e-3;
        memcpy(at, &value, sizeof value);
    } else {
        uint32_t value;
        memcpy(&value, at, sizeof value);
        value += (uint32_t)(int32_t)field->factor;
        memcpy(at, &value, sizeof value);
    }
}

/* Neither takes the other's snapshot. */
static void expect_foreign(const contract_snapshot *s, const void *config)
{
    static uint8_t bytes[MAX_BYTES];
    uint64_t count;
    void *other = NULL;
    expect_ok(s->create(sub.context, config, &other));
    const uint64_t own = hash_of(s, sub.handle), theirs = hash_of(s, other);
    assert_true(own != theirs);
    expect_ok(vbss_object_save(other, s->kind, bytes, sizeof bytes, &count));
    expect_result(VBSS_ERROR_CORRUPT, restore(s, other, sub.bytes, sub.count));
    expect_result(VBSS_ERROR_CORRUPT, restore(s, sub.handle, bytes, count));
    assert_true(hash_of(s, other) == theirs);
    assert_true(hash_of(s, sub.handle) == own);
    expect_ok(s->destroy(other));
}

static void snapshot_of_other_config_is_rejected(void **state)
{
    const contract_snapshot *s = *state;
    double config[MAX_CONFIG / sizeof(double)];
    begin(s);
    for (size_t i = 0; i < CONTRACT_FIELDS && s->fields[i].factor != 0.0; i++) {
        const contract_field *field = &s->fields[i];
        for (size_t k = 0; k < (field->count > 0 ? field->count : 1); k++) {
            memcpy(config, sub.config, s->config_size);
            change(config, field, k);
            expect_foreign(s, config);
        }
    }
    end();
}

static void reserved_memory_may_differ(void **state)
{
    const contract_snapshot *s = *state;
    void *other = NULL;
    begin(s);
    const uint64_t hash = hash_of(s, sub.handle);
    s->reserve_more(sub.config);
    expect_ok(s->create(sub.context, sub.config, &other));
    if (s->step != NULL) {
        expect_ok(s->step(other));
        assert_true(hash_of(s, other) != hash);
    }
    expect_ok(restore(s, other, sub.bytes, sub.count));
    assert_true(hash_of(s, other) == hash);
    end();
}

int contract_check_snapshot(const char *group, const contract_snapshot *snapshot)
{
    static const contract_property buffer = {"small_buffer_reports_required_size",
                                             small_buffer_reports_required_size},
                                   foreign = {"snapshot_of_other_config_is_rejected",
                                              snapshot_of_other_config_is_rejected},
                                   reserve = {"reserved_memory_may_differ",
                                              reserved_memory_may_differ};
    static contract_cases cases;
    cases.count = 0;
    if (snapshot->save != NULL) {
        contract_add(&cases, snapshot->name, &buffer, snapshot);
    }
    if (snapshot->fields[0].factor != 0.0) {
        contract_add(&cases, snapshot->name, &foreign, snapshot);
    }
    if (snapshot->reserve_more != NULL) {
        contract_add(&cases, snapshot->name, &reserve, snapshot);
    }
    return contract_run_cases(group, &cases);
}
