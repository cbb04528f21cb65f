#include <string.h>

#include "harness/harness.h"
#include "fixtures/rod.h"

static vbss_result step_call(void *handle)
{
    return rod_step(handle, 1e-3);
}

static vbss_result tip_call(void *handle)
{
    double tip[3];
    return rod_get_tip(handle, tip);
}

static rod *make_rod(vbss_context *context)
{
    rod_config config;
    rod *body;
    expect_ok(rod_config_init(&config, sizeof config));
    expect_ok(rod_create(context, &config, &body));
    return body;
}

static void every_call_rejects_invalid_handles(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    rod *destroyed = make_rod(context);
    expect_ok(rod_destroy(destroyed));
    const harness_handle_call calls[] = {step_call, tip_call};
    harness_refuses_bad_handles(context, destroyed, calls, 2);
    expect_ok(rod_destroy(NULL));
    expect_result(VBSS_ERROR_INVALID_HANDLE, rod_destroy(destroyed));
    expect_result(VBSS_ERROR_INVALID_HANDLE, rod_destroy((rod *)context));
    harness_context_end(context, &memory);
}

/* The heart of the promise: whatever is created later, a destroyed handle stays destroyed. */
static void destroyed_handle_stays_invalid_after_reuse(void **state)
{
    (void)state;
    enum { COUNT = 500 };
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    rod *handles[COUNT];
    for (int i = 0; i < COUNT; i++) {
        handles[i] = make_rod(context);
        if (i % 3 != 0) {
            expect_ok(rod_destroy(handles[i]));
        }
    }
    for (int i = 0; i < COUNT; i++) {
        expect_result(i % 3 != 0 ? VBSS_ERROR_INVALID_HANDLE : VBSS_OK, step_call(handles[i]));
        for (int k = 0; k < i; k++) {
            assert_ptr_not_equal(handles[i], handles[k]);
        }
    }
    vbss_context_statistics statistics;
    expect_ok(vbss_context_get_statistics(context, &statistics, sizeof statistics));
    assert_int_equal(statistics.objects_alive, (COUNT + 2) / 3);
    assert_int_equal(statistics.objects_created, COUNT);
    harness_context_end(context, &memory);
}

static void ordinals_count_creations(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    for (uint64_t i = 1; i <= 100; i++) {
        rod *body = make_rod(context);
        vbss_slot *slot;
        expect_ok(vbss_slot_open(body, &rod_kind, &slot));
        assert_int_equal(slot->ordinal, i);
        expect_ok(rod_destroy(body));
    }
    harness_context_end(context, &memory);
}

/* ---- the end of a context */

enum { LEFT = 150 };
static int ended[LEFT], ended_count;

static void note_end(vbss_context *context, void *object)
{
    (void)context;
    ended[ended_count++] = *(int *)object;
}

static void visit_nothing(vbss_stream *stream, void *object)
{
    (void)stream;
    (void)object;
}

static void context_end_destroys_youngest_first(void **state)
{
    (void)state;
    static const vbss_kind kind = {
        "noted", VBSS_CODE('N', 'O', 'T', 'E'), 1, note_end, visit_nothing, NULL};
    int numbers[LEFT];
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    for (int i = 0; i < LEFT; i++) {
        vbss_slot *slot;
        numbers[i] = i;
        expect_ok(vbss_slot_create(context, &kind, &numbers[i], &slot));
    }
    ended_count = 0;
    harness_context_end(context, &memory);
    assert_int_equal(ended_count, LEFT);
    for (int i = 0; i < LEFT; i++) {
        assert_int_equal(ended[i], LEFT - 1 - i);
    }
}

/* The oldest object looks at the youngest handle while the context ends. */
static vbss_result seen_at_the_end;
static rod *youngest;

static void inspect_youngest(vbss_context *context, void *object)
{
    double tip[3];
    (void)context;
    (void)object;
    seen_at_the_end = rod_get_tip(youngest, tip);
}

static void handles_are_checked_until_context_end(void **state)
{
    (void)state;
    static const vbss_kind kind = {
        "looker", VBSS_CODE('L', 'O', 'O', 'K'), 1, inspect_youngest, visit_nothing, NULL};
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_slot *slot;
    expect_ok(vbss_slot_create(context, &kind, NULL, &slot));
    for (int i = 0; i < 200; i++) { /* into another block of handles */
        youngest = make_rod(context);
    }
    seen_at_the_end = VBSS_OK;
    harness_context_end(context, &memory);
    expect_result(VBSS_ERROR_INVALID_HANDLE, seen_at_the_end);
}

/* While an object ends, its own handle is told already. */
static vbss_slot *ending;
static void open_the_ending(vbss_context *context, void *object);
static const vbss_kind ending_kind = {
    "ending", VBSS_CODE('E', 'N', 'D', ' '), 1, open_the_ending, visit_nothing, NULL};
static void open_the_ending(vbss_context *context, void *object)
{
    vbss_slot *found;
    (void)context;
    (void)object;
    seen_at_the_end = vbss_slot_open(ending, &ending_kind, &found);
}

static void object_being_destroyed_cannot_be_opened(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    expect_ok(vbss_slot_create(context, &ending_kind, NULL, &ending));
    seen_at_the_end = VBSS_OK;
    expect_ok(vbss_slot_destroy(ending, &ending_kind));
    expect_result(VBSS_ERROR_INVALID_HANDLE, seen_at_the_end);
    /* A dead handle of another kind is told by its kind, and nothing is handed out. */
    vbss_slot *found = ending;
    const char *text;
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_slot_edit(ending, &rod_kind, &found));
    assert_null(found);
    expect_ok(vbss_context_get_last_error(context, NULL, &text));
    assert_non_null(strstr(text, "is a ending where a rod is needed"));
    harness_context_end(context, &memory);
}

static vbss_result fill_slots(vbss_context *context, void *user)
{
    (void)user;
    rod_config config;
    rod *bodies[70]; /* more than one block of slots */
    vbss_result result = rod_config_init(&config, sizeof config);
    int made = 0;
    while (made < 70 && result == VBSS_OK) {
        result = rod_create(context, &config, &bodies[made]);
        made += result == VBSS_OK;
    }
    while (made > 0) {
        expect_ok(rod_destroy(bodies[--made]));
    }
    return result;
}

static void each_failed_allocation_is_reported(void **state)
{
    (void)state;
    harness_fail_every_allocation(fill_slots, NULL);
}

int test_slot(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(every_call_rejects_invalid_handles),
        harness_test(destroyed_handle_stays_invalid_after_reuse),
        harness_test(ordinals_count_creations),
        harness_test(context_end_destroys_youngest_first),
        harness_test(handles_are_checked_until_context_end),
        harness_test(object_being_destroyed_cannot_be_opened),
        harness_test(each_failed_allocation_is_reported),
    };
    return cmocka_run_group_tests_name("base.slot", tests, NULL, NULL);
}
