/* Properties of scripted runs. */
#include <stdlib.h>

#include "base/snapshot.h"
#include "contract/contract.h"

static void restored_run_continues_bit_equal(void **state)
{
    const contract_run *run = *state;
    harness_save_restore_continue_at(&run->body, run->saves, run->save_count, run->continued);
}

static void bad_snapshots_are_rejected(void **state)
{
    const contract_run *run = *state;
    for (size_t i = 0; i < run->damage_count; i++) {
        harness_refuses_bad_snapshots(&run->body, run->damages[i]);
    }
}

static void steps_do_not_allocate(void **state)
{
    const contract_run *run = *state;
    assert_int_equal(harness_step_allocations(&run->body, run->quiet), 0);
}

static void script_covers_its_events(void **state)
{
    const contract_run *run = *state;
    run->covers(run);
}

static uint64_t hash_of(const harness_body *body, void *handle)
{
    vbss_slot *slot;
    uint64_t hash = 0;
    expect_ok(vbss_slot_open(handle, body->kind, &slot));
    expect_ok(vbss_snapshot_hash(slot, &hash));
    return hash;
}

/* Hashes after each step. Another body may live in the context and step in turn, one step ahead, so that nothing depends on
 * addresses, on history or on data that bodies share. */
static void record_hashes(const harness_body *body, bool beside_another, uint64_t *hashes,
                          size_t steps)
{
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    void *handle = NULL, *other = NULL;
    if (beside_another) {
        expect_ok(body->create(context, body->user, &other));
        expect_ok(body->step(other));
    }
    expect_ok(body->create(context, body->user, &handle));
    for (size_t i = 0; i < steps; i++) {
        if (beside_another) {
            expect_ok(body->step(other));
        }
        expect_ok(body->step(handle));
        hashes[i] = hash_of(body, handle);
    }
    harness_context_end(context, &memory);
}

static void runs_are_bit_equal(void **state)
{
    const contract_run *run = *state;
    uint64_t *first = calloc(2 * run->repeated, sizeof *first), *second = first + run->repeated;
    assert_non_null(first);
    record_hashes(&run->body, false, first, run->repeated);
    record_hashes(&run->body, true, second, run->repeated);
    assert_int_equal(harness_first_difference(first, second, run->repeated), run->repeated);
    for (size_t i = 1; i < run->repeated; i++) {
        assert_true(first[i] != first[i - 1]); /* the hash sees the step */
    }
    free(first);
}

typedef struct saved_state {
    uint8_t *bytes;
    size_t count;
} saved_state;

static saved_state save(const vbss_slot *slot)
{
    saved_state s = {NULL, 0};
    size_t written = 0;
    expect_ok(vbss_snapshot_size(slot, &s.count));
    s.bytes = malloc(s.count);
    assert_non_null(s.bytes);
    expect_ok(vbss_snapshot_save(slot, s.bytes, s.count, &written));
    return s;
}

/* Saves one body and restores the other from it. */
static void expect_restored(vbss_slot *to, const vbss_slot *from, vbss_result wanted)
{
    saved_state s = save(from);
    expect_result(wanted, vbss_snapshot_restore(to, s.bytes, s.count));
    free(s.bytes);
}

/* The snapshots have a valid checksum, so that only the visitor can reject them. */
static void impossible_states_are_rejected(void **state)
{
    const contract_run *run = *state;
    const harness_body *body = &run->body;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    void *handle = NULL;
    vbss_slot *slot;
    expect_ok(body->create(context, body->user, &handle));
    expect_ok(vbss_slot_open(handle, body->kind, &slot));
    for (size_t i = 0; i < run->spoil_at; i++) {
        expect_ok(body->step(handle));
    }
    const saved_state good = save(slot);
    const uint64_t hash = hash_of(body, handle);
    for (uint32_t which = 0; which < run->spoil_count; which++) {
        void *spoilt = NULL;
        vbss_slot *its_slot;
        expect_ok(body->create(context, body->user, &spoilt));
        expect_ok(vbss_slot_open(spoilt, body->kind, &its_slot));
        expect_ok(vbss_snapshot_restore(its_slot, good.bytes, good.count));
        expect_restored(slot, its_slot, VBSS_OK);
        run->spoil(spoilt, which);
        expect_restored(slot, its_slot, VBSS_ERROR_CORRUPT);
        assert_true(hash_of(body, handle) == hash);
        expect_ok(body->destroy(spoilt));
    }
    free(good.bytes);
    harness_context_end(context, &memory);
}

int contract_check_runs(const char *group, const contract_run *runs, size_t count)
{
    static const contract_property covers = {"script_covers_its_events", script_covers_its_events},
                                   restored = {"restored_run_continues_bit_equal",
                                               restored_run_continues_bit_equal},
                                   damaged = {"bad_snapshots_are_rejected",
                                              bad_snapshots_are_rejected},
                                   quiet = {"steps_do_not_allocate", steps_do_not_allocate},
                                   repeated = {"runs_are_bit_equal", runs_are_bit_equal},
                                   impossible = {"impossible_states_are_rejected",
                                                 impossible_states_are_rejected};
    static contract_cases cases;
    cases.count = 0;
    for (size_t i = 0; i < count; i++) {
        const contract_run *run = &runs[i];
        const struct {
            bool is_wanted;
            const contract_property *property;
        } properties[] = {
            {run->covers != NULL, &covers},    {run->save_count > 0, &restored},
            {run->damage_count > 0, &damaged}, {run->quiet > 0, &quiet},
            {run->repeated > 0, &repeated},    {run->spoil != NULL, &impossible},
        };
        for (size_t k = 0; k < sizeof properties / sizeof properties[0]; k++) {
            if (properties[k].is_wanted) {
                contract_add(&cases, run->name, properties[k].property, run);
            }
        }
    }
    return contract_run_cases(group, &cases);
}
