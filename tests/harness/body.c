/* What every stepped body must be able to do: go back, go on elsewhere, refuse nonsense. */
#include <stdlib.h>
#include <string.h>

#include "base/little_endian.h"
#include "base/snapshot.h"
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

/* The three ways to continue after a restore. */
enum { IN_A_NEW_BODY, IN_ANOTHER_LIFE, BACK_IN_ITS_OWN, CONTINUATIONS };
static const char *const continuation_names[CONTINUATIONS] = {
    "in a new body", "in a body that lived otherwise", "in its own body"};

/* One run, saved at several steps. */
typedef struct saved_run {
    const size_t *before; /* when it is saved, ascending */
    size_t count, after;  /* of them; states that are compared after each */
    uint8_t **states;
    size_t *sizes;
    uint64_t *hashes; /* of the state after step i, if it is compared */
} saved_run;

static bool is_compared(const saved_run *run, size_t step)
{
    for (size_t i = 0; i < run->count; i++) {
        if (step > run->before[i] && step <= run->before[i] + run->after) {
            return true;
        }
    }
    return false;
}

static void begin_saved_run(saved_run *run, const living *first, const harness_body *body)
{
    size_t last = run->before[run->count - 1] + run->after, next = 0;
    run->states = calloc(run->count, sizeof *run->states);
    run->sizes = calloc(run->count, sizeof *run->sizes);
    run->hashes = calloc(last + 1, sizeof *run->hashes);
    assert_non_null(run->states);
    assert_non_null(run->sizes);
    assert_non_null(run->hashes);
    for (size_t i = 0; i <= last; i++) {
        if (i > 0) {
            step(first, body, 1);
            run->hashes[i] = is_compared(run, i) ? hash_of(first) : 0;
        }
        while (next < run->count && run->before[next] == i) {
            run->states[next] = save(first, &run->sizes[next]);
            next++;
        }
    }
    assert_int_equal(next, run->count); /* else they do not ascend */
}

static void end_saved_run(saved_run *run)
{
    for (size_t i = 0; i < run->count; i++) {
        free(run->states[i]);
    }
    free(run->states);
    free(run->sizes);
    free(run->hashes);
}

static size_t divergence_from(const saved_run *run, size_t i, const living *life,
                              const harness_body *body)
{
    expect_ok(vbss_snapshot_restore(life->slot, run->states[i], run->sizes[i]));
    return divergence(life, body, run->hashes + run->before[i] + 1, run->after);
}

/* For each of `count` steps and each continuation, the first state that differs. */
static void divergences(const harness_body *body, const size_t *before, size_t count, size_t after,
                        size_t found[][CONTINUATIONS])
{
    living first, fresh, other;
    saved_run run = {.before = before, .count = count, .after = after};
    begin_life(&first, body);
    if (body->edit != NULL) {
        expect_ok(body->edit(first.handle));
    }
    begin_saved_run(&run, &first, body);
    begin_life(&other, body);
    step(&other, body, before[count - 1] / 2 + 3); /* leaves other caches behind */
    for (size_t i = 0; i < count; i++) {
        const uint64_t *hashes = run.hashes + before[i] + 1;
        assert_true(after < 2 || hashes[0] != hashes[1]); /* else it stands still: no test */
        begin_life(&fresh, body);
        found[i][IN_A_NEW_BODY] = divergence_from(&run, i, &fresh, body);
        end_life(&fresh, body);
        found[i][IN_ANOTHER_LIFE] = divergence_from(&run, i, &other, body);
        found[i][BACK_IN_ITS_OWN] = divergence_from(&run, i, &first, body);
    }
    end_life(&other, body);
    end_life(&first, body);
    end_saved_run(&run);
}

size_t harness_restored_divergence(const harness_body *body, size_t before, size_t after)
{
    size_t found[1][CONTINUATIONS], smallest = after;
    divergences(body, &before, 1, after, found);
    for (int continuation = 0; continuation < CONTINUATIONS; continuation++) {
        smallest = found[0][continuation] < smallest ? found[0][continuation] : smallest;
    }
    return smallest;
}

void harness_save_restore_continue_at(const harness_body *body, const size_t *before, size_t count,
                                      size_t after)
{
    enum { MAX_COUNT = 32 };
    size_t found[MAX_COUNT][CONTINUATIONS];
    assert_in_range(count, 1, MAX_COUNT);
    divergences(body, before, count, after, found);
    for (size_t i = 0; i < count; i++) {
        for (int continuation = 0; continuation < CONTINUATIONS; continuation++) {
            if (found[i][continuation] < after) {
                fail_msg("%s saved at step %zu and restored %s differs from step %zu on",
                         body->name, before[i], continuation_names[continuation],
                         before[i] + found[i][continuation] + 1);
            }
        }
    }
}

void harness_save_restore_continue(const harness_body *body, size_t before, size_t after)
{
    harness_save_restore_continue_at(body, &before, 1, after);
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

size_t harness_state_end(const uint8_t *bytes, size_t count)
{
    enum { STATE_FORMAT = 1, DESCRIBED_HEADER = 24, CHECKSUM = 8 };
    return bytes[4] == STATE_FORMAT ? count - CHECKSUM
                                    : DESCRIBED_HEADER + (size_t)load_little_endian(bytes + 8, 8);
}

/* Damage under a right checksum, one bit at a time over the whole state: the visitor refuses it,
 * or it is a state like another, which is then saved as it was read. */
static void try_sealed_damage(const living *life, const uint8_t *good, size_t count)
{
    enum { FRONT = 16 };
    const size_t end = harness_state_end(good, count);
    uint64_t hash = hash_of(life);
    uint8_t *bad = malloc(count), *again = malloc(count);
    assert_non_null(bad);
    assert_non_null(again);
    for (size_t at = FRONT; at < end; at += 1 + at / 256) {
        size_t written = 0;
        memcpy(bad, good, count);
        bad[at] ^= (uint8_t)(1u << (at % 8));
        harness_seal_snapshot(bad, count);
        if (vbss_snapshot_restore(life->slot, bad, count) != VBSS_OK) {
            assert_true(hash_of(life) == hash);
            continue;
        }
        expect_ok(vbss_snapshot_save(life->slot, again, count, &written));
        assert_int_equal(written, count);
        assert_memory_equal(again, bad, end); /* a description follows the state */
        hash = hash_of(life);
    }
    free(again);
    free(bad);
}

/* An object of another kind, whose state must not be taken for this one's. */
static void visit_foreign(vbss_stream *stream, void *object)
{
    vbss_stream_u64(stream, 1, object, 1);
}

static void keep_foreign(vbss_context *context, void *object)
{
    (void)context;
    (void)object;
}

static const vbss_kind foreign_kind = {
    "foreign", VBSS_CODE('F', 'R', 'G', 'N'), 1, keep_foreign, visit_foreign, NULL};

static void refuse_foreign(const living *life, uint64_t hash)
{
    uint64_t object = 7;
    uint8_t bytes[128];
    size_t count = 0;
    vbss_slot *foreign;
    expect_ok(vbss_slot_create(life->context, &foreign_kind, &object, &foreign));
    expect_ok(vbss_snapshot_save(foreign, bytes, sizeof bytes, &count));
    refuse(life, bytes, count, hash);
    expect_ok(vbss_slot_destroy(foreign, &foreign_kind));
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
    /* Magic and format under a right checksum. */
    for (size_t at = 0; at < 8; at++) {
        memcpy(bad, good, count);
        bad[at] ^= 0x40;
        harness_seal_snapshot(bad, count);
        refuse(&life, bad, count, hash);
    }
    refuse_foreign(&life, hash);
    /* And the good one still works. */
    expect_ok(vbss_snapshot_restore(life.slot, good, count));
    assert_true(hash_of(&life) != hash);
    try_sealed_damage(&life, good, count);

    free(bad);
    free(good);
    end_life(&life, body);
}
