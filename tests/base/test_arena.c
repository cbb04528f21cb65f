#include "harness/harness.h"

static void blocks_are_aligned_disjoint_and_counted(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_arena arena;
    expect_ok(vbss_arena_create(context, &arena, 1024));
    unsigned char *a = vbss_arena_take(&arena, 3, 1);
    unsigned char *b = vbss_arena_take(&arena, 5, 16);
    assert_non_null(a);
    assert_non_null(b);
    assert_int_equal((uintptr_t)a % VBSS_ALIGNMENT, 0);
    assert_int_equal((uintptr_t)b % VBSS_ALIGNMENT, 0);
    assert_true(b >= a + 3);
    assert_int_equal(arena.used, 64 + 128);
    vbss_arena_rewind(&arena, 64);
    assert_ptr_equal(vbss_arena_take(&arena, 1, 1), b);
    assert_int_equal(arena.peak, 192);
    vbss_arena_destroy(context, &arena);
    harness_context_end(context, &memory);
}

static void a_full_arena_gives_null_and_tells_the_need(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_arena arena;
    expect_ok(vbss_arena_create(context, &arena, 128));
    assert_null(vbss_arena_take(&arena, 129, 1));
    assert_int_equal(arena.used, 0);
    assert_int_equal(arena.peak, 192);
    assert_non_null(vbss_arena_take(&arena, 128, 1));
    assert_null(vbss_arena_take(&arena, 1, 1));
    assert_null(vbss_arena_take(&arena, SIZE_MAX, 2));
    assert_null(vbss_arena_take(&arena, SIZE_MAX / 2, 1));
    assert_null(vbss_arena_take(&arena, SIZE_MAX - 32, 1)); /* would round up to a few bytes */
    vbss_arena_rewind(&arena, 256);                         /* forward: nothing */
    assert_int_equal(arena.used, 128);
    vbss_arena_destroy(context, &arena);
    harness_context_end(context, &memory);
}

static void an_empty_array_is_no_failure(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_arena arena;
    expect_ok(vbss_arena_create(context, &arena, 0));
    assert_non_null(vbss_arena_take(&arena, 0, 8));
    assert_null(vbss_arena_take(&arena, 1, 1));
    vbss_arena_destroy(context, &arena);
    harness_context_end(context, &memory);
}

static void needs_add_up_to_a_capacity_that_holds(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_arena arena;
    size_t capacity = vbss_arena_need(7, 24) + vbss_arena_need(1, 1) + vbss_arena_need(0, 8) +
                      vbss_arena_need(64, 1);
    assert_int_equal(capacity, 192 + 64 + 0 + 64);
    expect_ok(vbss_arena_create(context, &arena, capacity));
    assert_non_null(vbss_arena_take(&arena, 7, 24));
    assert_non_null(vbss_arena_take(&arena, 1, 1));
    assert_non_null(vbss_arena_take(&arena, 0, 8));
    assert_non_null(vbss_arena_take(&arena, 64, 1));
    assert_null(vbss_arena_take(&arena, 1, 1));
    size_t too_much = vbss_arena_need(SIZE_MAX, 3);
    assert_true(too_much == SIZE_MAX / 4 && too_much + vbss_arena_need(1, 1) > too_much);
    vbss_arena_destroy(context, &arena);
    assert_null(arena.block);
    assert_null(vbss_arena_take(&arena, 1, 1)); /* after the end there is nothing to take */
    harness_context_end(context, &memory);
}

int test_arena(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(blocks_are_aligned_disjoint_and_counted),
        harness_test(a_full_arena_gives_null_and_tells_the_need),
        harness_test(an_empty_array_is_no_failure),
        harness_test(needs_add_up_to_a_capacity_that_holds),
    };
    return cmocka_run_group_tests_name("base.arena", tests, NULL, NULL);
}
