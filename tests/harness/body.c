/* What every stepped body must be able to do: go back, go on elsewhere, refuse nonsense. */
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "base/little_endian.h"
#include "harness/harness.h"

typedef struct living {
    harness_memory memory;
    vbss_context *context;
    void *handle;
    vbss_slot *slot;
} living;

static void begin_life(living *life, const harness_body *body)
{
    life->context = harness_context(&life->memory);
    expect_ok(body->create(life->context, body->user, &life->handle));
    expect_ok(vbss_slot_open(life->handle, body->kind, &life->slot));
}

static void end_life(living *life, const harness_body *body)
{
    expect_ok(body->destroy(life->handle));
    harness_context_end(life->context, &life->memory);
}

static void step(const living *life, const harness_body *body, size_t steps)
{
    for (size_t i = 0; i < steps; i++) {
        expect_ok(body->step(life->handle));
    }
}

static uint64_t hash_of(const living *life)
{
    uint64_t hash;
    expect_ok(vbss_snapshot_hash(life->slot, &hash));
    return hash;
}

static uint8_t *save(const living *life, size_t *count)
{
    expect_ok(vbss_snapshot_size(life->slot, count));
    uint8_t *bytes = malloc(*count);
    assert_non_null(bytes);
    size_t written = 0;
    expect_result(VBSS_ERROR_CAPACITY, vbss_snapshot_save(life->slot, bytes, *count - 1, &written));
    expect_ok(vbss_snapshot_save(life->slot, bytes, *count, &written));
    assert_int_equal(written, *count);
    return bytes;
}

/* The index of the first step whose hash is not the wanted one. */
static size_t divergence(const living *life, const harness_body *body, const uint64_t *wanted,
                         size_t steps)
{
    for (size_t i = 0; i < steps; i++) {
        step(life, body, 1);
        if (hash_of(life) != wanted[i]) {
            return i;
        }
    }
    return steps;
}

/* Both ways to continue: [0] in a new context, [1] back in the old one. */
static void divergences(const harness_body *body, size_t before, size_t after, size_t found[2])
{
    living first, second;
    uint64_t *hashes = calloc(after, sizeof *hashes);
    assert_non_null(hashes);
    begin_life(&first, body);
    step(&first, body, before);
    size_t count;
    uint8_t *saved = save(&first, &count);
    for (size_t i = 0; i < after; i++) {
        step(&first, body, 1);
        hashes[i] = hash_of(&first);
    }
    assert_true(after < 2 || hashes[0] != hashes[1]); /* a body that stands still tests nothing */

    begin_life(&second, body);
    step(&second, body, before / 2 + 3); /* leave other caches behind than a new body has */
    expect_ok(vbss_snapshot_restore(second.slot, saved, count));
    found[0] = divergence(&second, body, hashes, after);
    expect_ok(vbss_snapshot_restore(first.slot, saved, count));
    found[1] = divergence(&first, body, hashes, after);

    end_life(&second, body);
    end_life(&first, body);
    free(saved);
    free(hashes);
}

size_t harness_restored_divergence(const harness_body *body, size_t before, size_t after)
{
    size_t found[2];
    divergences(body, before, after, found);
    return found[0] < found[1] ? found[0] : found[1];
}

void harness_save_restore_continue(const harness_body *body, size_t before, size_t after)
{
    size_t found[2];
    divergences(body, before, after, found);
    if (found[0] < after || found[1] < after) {
        bool elsewhere = found[0] < after;
        fail_msg("%s saved at step %zu and restored %s differs from step %zu on", body->name,
                 before, elsewhere ? "in a new context" : "in its own context",
                 before + found[elsewhere ? 0 : 1] + 1);
    }
}

uint64_t harness_step_allocations(const harness_body *body, size_t steps)
{
    living life;
    begin_life(&life, body);
    uint64_t calls = life.memory.calls;
    step(&life, body, steps);
    calls = life.memory.calls - calls;
    end_life(&life, body);
    return calls;
}

/* Restores damaged bytes; the body must be told off and stay as it is. */
static void refuse(const living *life, const uint8_t *bytes, size_t count, uint64_t hash)
{
    vbss_result result = vbss_snapshot_restore(life->slot, bytes, count);
    assert_true(result < 0);
    const char *text;
    vbss_result kept;
    expect_ok(vbss_context_get_last_error(life->context, &kept, &text));
    assert_int_equal(kept, result);
    assert_true(strlen(text) > 0);
    assert_true(hash_of(life) == hash);
}

void harness_seal_snapshot(uint8_t *bytes, size_t count)
{
    vbss_hash hash;
    vbss_hash_begin(&hash);
    vbss_hash_add(&hash, bytes, count - 8);
    store_little_endian(bytes + count - 8, vbss_hash_end(&hash), 8);
}

void harness_refuses_bad_snapshots(const harness_body *body, size_t steps)
{
    living life;
    begin_life(&life, body);
    step(&life, body, steps);
    size_t count;
    uint8_t *good = save(&life, &count);
    step(&life, body, 1);
    uint64_t hash = hash_of(&life);

    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_snapshot_restore(life.slot, NULL, count));
    uint8_t *bad = malloc(count + 1);
    assert_non_null(bad);
    for (size_t cut = 0; cut < count; cut += 1 + cut / 16) {
        refuse(&life, good, cut, hash);
    }
    for (size_t at = 0; at < count; at += 1 + at / 16) {
        memcpy(bad, good, count);
        bad[at] ^= 0x10;
        refuse(&life, bad, count, hash);
    }
    memcpy(bad, good, count);
    bad[count] = 0;
    refuse(&life, bad, count + 1, hash);
    /* Headers of section and first field, damaged under a right checksum. */
    for (size_t at = 16; at < 32; at++) {
        memcpy(bad, good, count);
        bad[at] ^= 0x40;
        harness_seal_snapshot(bad, count);
        refuse(&life, bad, count, hash);
    }
    /* And the good one still works. */
    expect_ok(vbss_snapshot_restore(life.slot, good, count));
    assert_true(hash_of(&life) != hash);

    free(bad);
    free(good);
    end_life(&life, body);
}
