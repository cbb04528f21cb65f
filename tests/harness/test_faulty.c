/* The fixtures catch what they are there to catch: each is shown something with the fault. */
#include <signal.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "determinism/scenes.h"
#include "harness/harness.h"
#include "fixtures/rod_body.h"

/* ---- a body with the faults the fixtures look for */

typedef enum fault {
    NO_FAULT,
    FORGETS_GROWTH, /* when saved */
    DAMPS_UNSAVED,  /* its growth changes at step 5, and is not saved */
    EDIT_UNSAVED,   /* what a host set is not saved */
    AGES,      /* beyond 60 steps in all it behaves otherwise, and restoring makes no younger */
    ALLOCATES, /* in every step */
    CHANGED_BY_READING, /* even when the reading fails */
    CLAMPS_WHEN_READ    /* takes what it was not given */
} fault;

typedef struct faulty {
    uint64_t value, growth, age;
    fault fault;
} faulty;

static void faulty_free(vbss_context *context, void *object)
{
    vbss_release(context, object, 1, sizeof(faulty));
}

static void faulty_serialise(vbss_stream *stream, void *object)
{
    faulty *f = object;
    if (f->fault == CHANGED_BY_READING && stream->mode == VBSS_STREAM_READ) {
        f->age++;
    }
    vbss_stream_u64(stream, 1, &f->value, 1);
    if (f->fault != FORGETS_GROWTH && f->fault != DAMPS_UNSAVED && f->fault != EDIT_UNSAVED) {
        vbss_stream_u64(stream, 2, &f->growth, 1);
    }
    if (f->fault == CHANGED_BY_READING) {
        uint64_t age = f->age;
        vbss_stream_u64(stream, 3, &age, 1);
    }
    if (f->fault == CLAMPS_WHEN_READ && stream->mode == VBSS_STREAM_READ && f->growth > 1u << 30) {
        f->growth = 1u << 30;
    }
}

static const vbss_kind faulty_kind = {
    "faulty", VBSS_CODE('F', 'L', 'T', 'Y'), 1, faulty_free, faulty_serialise, NULL};

static vbss_result faulty_create(vbss_context *context, void *user, void **handle)
{
    faulty *f = vbss_allocate(context, 1, sizeof *f, "faulty");
    vbss_slot *slot;
    memcpy(f, user, sizeof *f);
    VBSS_TRY(vbss_slot_create(context, &faulty_kind, f, &slot));
    *handle = slot;
    return VBSS_OK;
}

static vbss_result faulty_edit(void *handle)
{
    faulty *f = ((vbss_slot *)handle)->object;
    f->growth = f->fault == EDIT_UNSAVED ? 9 : f->growth;
    return VBSS_OK;
}

static vbss_result faulty_step(void *handle)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_edit(handle, &faulty_kind, &slot));
    faulty *f = slot->object;
    f->age++;
    f->value += f->growth;
    if (f->fault == DAMPS_UNSAVED) {
        f->growth = f->age == 5 ? 7 : f->growth;
    } else if (f->fault == AGES && f->age > 60) {
        f->value++;
    } else if (f->fault == NO_FAULT || f->fault == FORGETS_GROWTH) {
        f->growth = 3 * f->growth + 1;
    } else if (f->fault == ALLOCATES) {
        vbss_release(slot->context, vbss_allocate(slot->context, 1, 8, "waste"), 1, 8);
    }
    return VBSS_OK;
}

static vbss_result faulty_destroy(void *handle)
{
    return vbss_slot_destroy(handle, &faulty_kind);
}

static harness_body faulty_body(faulty *user)
{
    harness_body body = {"faulty",    &faulty_kind,   faulty_create, faulty_edit,
                         faulty_step, faulty_destroy, user};
    return body;
}

static void unsaved_state_is_detected(void **state)
{
    (void)state;
    const fault unsaved[] = {FORGETS_GROWTH, DAMPS_UNSAVED, EDIT_UNSAVED, AGES};
    for (int i = 0; i < 4; i++) {
        faulty f = {1, 1, 0, unsaved[i]};
        harness_body body = faulty_body(&f);
        assert_true(harness_restored_divergence(&body, 10, 50) < 50);
    }
    faulty good = {1, 1, 0, NO_FAULT};
    harness_body body = faulty_body(&good);
    assert_int_equal(harness_restored_divergence(&body, 10, 50), 50);
}

static void continue_with_a_forgotten_field(void **state)
{
    (void)state;
    faulty f = {1, 1, 0, FORGETS_GROWTH};
    harness_body body = faulty_body(&f);
    harness_save_restore_continue(&body, 10, 50);
}

static void continue_a_body_that_is_still(void **state)
{
    (void)state;
    faulty f = {1, 0, 0, AGES};
    harness_body body = faulty_body(&f);
    harness_save_restore_continue(&body, 1, 5);
}

static void continue_at_steps_that_do_not_ascend(void **state)
{
    (void)state;
    const size_t before[] = {10, 5};
    faulty f = {1, 1, 0, NO_FAULT};
    harness_body body = faulty_body(&f);
    harness_save_restore_continue_at(&body, before, 2, 5);
}

/* Its growth changes at step 5: of a state that is saved before, no body makes another one within two steps. */
static void continue_with_a_field_that_only_the_last_step_needs(void **state)
{
    (void)state;
    const size_t before[] = {1, 20};
    faulty f = {1, 1, 0, DAMPS_UNSAVED};
    harness_body body = faulty_body(&f);
    harness_save_restore_continue_at(&body, before, 2, 2);
}

static void allocation_in_step_is_counted(void **state)
{
    (void)state;
    faulty allocates = {1, 1, 0, ALLOCATES};
    harness_body body = faulty_body(&allocates);
    assert_int_equal(harness_step_allocations(&body, 50), 50);
}

static void restore_into_a_body_changed_by_reading(void **state)
{
    (void)state;
    faulty f = {1, 1, 0, CHANGED_BY_READING};
    harness_body body = faulty_body(&f);
    harness_refuses_bad_snapshots(&body, 3);
}

static void restore_into_a_body_that_clamps(void **state)
{
    (void)state;
    faulty f = {1, 1, 0, CLAMPS_WHEN_READ};
    harness_body body = faulty_body(&f);
    harness_refuses_bad_snapshots(&body, 3);
}

/* ---- attempts that handle a lack of memory badly */

static vbss_result attempt_nothing(vbss_context *context, void *user)
{
    (void)context;
    (void)user;
    return VBSS_OK;
}

static vbss_result attempt_and_ignore(vbss_context *context, void *user)
{
    (void)user;
    vbss_release(context, vbss_allocate(context, 1, 8, "a"), 1, 8);
    return VBSS_OK;
}

static vbss_result attempt_and_lose(vbss_context *context, void *user)
{
    (void)user;
    void *a = vbss_allocate(context, 1, 8, "a"), *b = vbss_allocate(context, 1, 8, "b");
    if (a == NULL || b == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY; /* the other one is lost */
    }
    vbss_release(context, a, 1, 8);
    vbss_release(context, b, 1, 8);
    return VBSS_OK;
}

/* Right when one allocation fails, wrong when the next fails as well. */
static vbss_result attempt_with_wrong_second_failure(vbss_context *context, void *user)
{
    (void)user;
    void *a = vbss_allocate(context, 1, 8, "a");
    if (a == NULL) {
        void *second = vbss_allocate(context, 1, 8, "second way");
        vbss_release(context, second, 1, 8);
        return second != NULL ? VBSS_ERROR_OUT_OF_MEMORY : VBSS_ERROR_CAPACITY;
    }
    vbss_release(context, a, 1, 8);
    return VBSS_OK;
}

#define FAILING_ATTEMPT(attempt)                      \
    static void sweep_##attempt(void **state)         \
    {                                                 \
        (void)state;                                  \
        harness_fail_every_allocation(attempt, NULL); \
    }
FAILING_ATTEMPT(attempt_nothing)
FAILING_ATTEMPT(attempt_and_ignore)
FAILING_ATTEMPT(attempt_and_lose)
FAILING_ATTEMPT(attempt_with_wrong_second_failure)

/* ---- calls and configs that believe too much */

static vbss_result call_on_the_dead(void *handle)
{
    vbss_slot *slot;
    vbss_result result = vbss_slot_open(handle, &rod_kind, &slot);
    const char *text = "";
    if (result != VBSS_OK && handle != NULL && ((vbss_slot *)handle)->kind == &rod_kind) {
        vbss_context_get_last_error(((vbss_slot *)handle)->context, NULL, &text);
    }
    return strstr(text, "destroyed") != NULL ? VBSS_OK : result;
}

static void call_with_bad_handles(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    rod_config config;
    rod *handle;
    rod_config_init(&config, sizeof config);
    rod_create(context, &config, &handle);
    rod_destroy(handle);
    const harness_handle_call calls[] = {call_on_the_dead};
    harness_refuses_bad_handles(context, handle, calls, 1);
}

static vbss_result init_rod_config(void *config, uint32_t struct_size)
{
    return rod_config_init(config, struct_size);
}

/* Reads what it can and asks no more. */
static vbss_result create_from_anything(vbss_context *context, const void *config)
{
    uint32_t size;
    memcpy(&size, config, sizeof size);
    rod_config own;
    rod_config_init(&own, sizeof own);
    memcpy(&own, config, size < sizeof own ? size : sizeof own);
    own.struct_size = sizeof own;
    if (size < 8 || size > 4096) {
        return VBSS_ERROR_STRUCT_SIZE;
    }
    rod *handle;
    VBSS_TRY(rod_create(context, &own, &handle));
    return rod_destroy(handle);
}

static void config_that_takes_anything(void **state)
{
    (void)state;
    const harness_config config = {rod_config_sizes, init_rod_config, create_from_anything};
    harness_config_protocol(&config);
}

/* ---- golden hashes that are not the golden ones */

static uint64_t rod_hashes[200];

static void golden_with_one_other(void **state)
{
    (void)state;
    rod_hashes[17] ^= 1;
    harness_golden("harness-rod", rod_hashes, 200);
}

static void golden_too_short(void **state)
{
    (void)state;
    harness_golden("harness-rod", rod_hashes, 199);
}

static void golden_without_file(void **state)
{
    (void)state;
    harness_golden("no-such-scene", rod_hashes, 1);
}

/* ---- expectations */

static void near_but_not_enough(void **state)
{
    (void)state;
    expect_near(1.0, 2.0, 0.5);
}

static void near_a_nan(void **state)
{
    (void)state;
    expect_near(1.0, harness_bad_numbers[0], 0.5);
}

static void zeros_of_other_signs(void **state)
{
    (void)state;
    expect_same_bits(0.0, -0.0);
}

static void worse_than_a_known_limit(void **state)
{
    (void)state;
    expect_known_limit(0.0, 2.0, 2.1);
}

static void as_good_as_wanted(void **state)
{
    (void)state;
    expect_known_limit(1.0, 2.0, 1.0);
}

static void not_a_number_within_a_known_limit(void **state)
{
    (void)state;
    expect_known_limit(1.0, 2.0, harness_bad_numbers[0]);
}

static void another_result(void **state)
{
    (void)state;
    expect_result(VBSS_ERROR_BUSY, VBSS_ERROR_CAPACITY);
}

static void pass(void **state)
{
    (void)state;
}

static void crash(void **state)
{
    (void)state;
    raise(SIGSEGV);
}

static void expect_a_passing_test_to_fail(void **state)
{
    (void)state;
    expect_failure(pass);
}

static void expect_a_crash_to_be_a_failure(void **state)
{
    (void)state;
    expect_failure(crash);
}

static void lose_a_block(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_allocate(context, 1, 8, "lost");
    harness_context_end(context, &memory);
}

static void fail_at_once(void **state)
{
    (void)state;
    fail();
}

static void harness_fails_on_faulty_body(void **state)
{
    (void)state;
    unsetenv("VBSS_UPDATE_GOLDEN"); /* or the golden canaries would write files */
    expect_failure(fail_at_once);
    expect_failure(expect_a_passing_test_to_fail);
    expect_failure(expect_a_crash_to_be_a_failure);
    expect_failure(near_but_not_enough);
    expect_failure(near_a_nan);
    expect_failure(zeros_of_other_signs);
    expect_failure(worse_than_a_known_limit);
    expect_failure(as_good_as_wanted);
    expect_failure(not_a_number_within_a_known_limit);
    expect_known_limit(1.0, 2.0, 2.0); /* as it is today */
    expect_failure(another_result);
    expect_failure(lose_a_block);
    expect_failure(continue_with_a_forgotten_field);
    expect_failure(continue_a_body_that_is_still);
    expect_failure(continue_at_steps_that_do_not_ascend);
    expect_failure(continue_with_a_field_that_only_the_last_step_needs);
    expect_failure(restore_into_a_body_changed_by_reading);
    expect_failure(restore_into_a_body_that_clamps);
    expect_failure(sweep_attempt_nothing);
    expect_failure(sweep_attempt_and_ignore);
    expect_failure(sweep_attempt_and_lose);
    expect_failure(sweep_attempt_with_wrong_second_failure);
    expect_failure(call_with_bad_handles);
    expect_failure(config_that_takes_anything);
    golden_scenes[2].run(rod_hashes, 200);
    assert_string_equal(golden_scenes[2].name, "harness-rod");
    harness_golden("harness-rod", rod_hashes, 200); /* as it should be */
    expect_failure(golden_with_one_other);
    expect_failure(golden_too_short);
    expect_failure(golden_without_file);
}

int test_faulty(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(unsaved_state_is_detected),
        harness_test(allocation_in_step_is_counted),
        harness_test(harness_fails_on_faulty_body),
    };
    return cmocka_run_group_tests_name("harness.faulty", tests, NULL, NULL);
}
