/* The fixtures on a body by the rules, and what they are made of. */
#include <stdlib.h>
#include <string.h>

#include "base/snapshot.h"
#include "harness/blocks.h"
#include "harness/harness.h"
#include "fixtures/rod_body.h"

static vbss_result init_rod_config(void *config, uint32_t struct_size)
{
    return rod_config_init(config, struct_size);
}

static vbss_result create_and_destroy_rod(vbss_context *context, const void *config)
{
    rod *handle;
    VBSS_TRY(rod_create(context, config, &handle));
    return rod_destroy(handle);
}

static void correct_body_passes(void **state)
{
    (void)state;
    const harness_config config = {rod_config_sizes, init_rod_config, create_and_destroy_rod};
    harness_config_protocol(&config);
    harness_body body = rod_body(NULL);
    assert_int_equal(harness_step_allocations(&body, 50), 0);
    harness_save_restore_continue(&body, 5, 20);
    harness_refuses_bad_snapshots(&body, 5);
}

static void bad_numbers_are_rejected_and_change_nothing(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    rod_config config;
    rod *handle;
    vbss_slot *slot;
    uint64_t before, after;
    expect_ok(rod_config_init(&config, sizeof config));
    expect_ok(rod_create(context, &config, &handle));
    expect_ok(vbss_slot_open(handle, &rod_kind, &slot));
    expect_ok(vbss_snapshot_hash(slot, &before));
    for (int i = 0; i < 3; i++) {
        expect_result(VBSS_ERROR_NOT_FINITE, rod_step(handle, harness_bad_numbers[i]));
        rod_config bad = config;
        rod *none = handle;
        bad.length = harness_bad_numbers[i];
        expect_result(VBSS_ERROR_NOT_FINITE, rod_create(context, &bad, &none));
        assert_null(none);
    }
    const double out_of_range[] = {0.0, -1e-3, 0.2};
    for (int i = 0; i < 3; i++) {
        expect_result(VBSS_ERROR_OUT_OF_RANGE, rod_step(handle, out_of_range[i]));
    }
    rod_config bad[] = {config, config, config, config};
    bad[0].node_count = 1;
    bad[1].node_count = 4097;
    bad[2].gust = -0.1;
    bad[3].gust = harness_bad_numbers[1];
    for (int i = 0; i < 4; i++) {
        rod *none = handle;
        expect_result(i < 3 ? VBSS_ERROR_OUT_OF_RANGE : VBSS_ERROR_NOT_FINITE,
                      rod_create(context, &bad[i], &none));
        assert_null(none);
    }
    expect_result(VBSS_ERROR_NULL_ARGUMENT, rod_create(context, &config, NULL));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, rod_get_tip(handle, NULL));
    rod *none = handle;
    expect_result(VBSS_ERROR_INVALID_HANDLE, rod_create(NULL, &config, &none));
    expect_ok(vbss_snapshot_hash(slot, &after));
    assert_true(before == after);
    harness_context_end(context, &memory);
}

/* ---- memory */

static void wrong_releases_and_leaks_are_detected(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context_config config = harness_watched_config(&memory);
    void *a = config.allocate(config.allocator_user, 100, 64);
    assert_non_null(a);
    assert_int_equal((uintptr_t)a % 64, 0);
    config.deallocate(config.allocator_user, a, 99, 64);
    assert_int_equal(memory.wrong_releases, 1);
    config.deallocate(config.allocator_user, a, 100, 32);
    assert_int_equal(memory.wrong_releases, 2);
    assert_int_equal(memory.blocks, 1);
    config.deallocate(config.allocator_user, a, 100, 64);
    assert_int_equal(memory.blocks, 0);
    assert_int_equal(memory.wrong_releases, 2);
    config.deallocate(config.allocator_user, a, 100, 64); /* twice */
    assert_int_equal(memory.wrong_releases, 3);
}

static void chosen_allocation_fails(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context_config config = harness_watched_config(&memory);
    for (int ever_after = 0; ever_after < 2; ever_after++) {
        memory.calls = 0;
        memory.fail_call = 2;
        memory.fail_ever_after = ever_after == 1;
        void *blocks[3];
        for (int i = 0; i < 3; i++) {
            blocks[i] = config.allocate(config.allocator_user, 8, 64);
        }
        assert_non_null(blocks[0]);
        assert_null(blocks[1]);
        assert_int_equal(blocks[2] == NULL, ever_after);
        config.deallocate(config.allocator_user, blocks[0], 8, 64);
        if (blocks[2] != NULL) {
            config.deallocate(config.allocator_user, blocks[2], 8, 64);
        }
    }
    assert_int_equal(memory.blocks, 0);
}

/* ---- properties */

static void count_cases(harness_source *source, void *user)
{
    uint64_t *sum = user;
    sum[0]++;
    sum[1] ^= harness_draw_u64(source);
}

/* Sizes that no other test asks for. */
enum { BLOCK = 64 * 1237, OTHER_BLOCK = 64 * 1239, LARGE_BLOCK = 64 * 65537 };

/* So many bytes are given back; of a size of their own. */
static void give_back(size_t bytes)
{
    for (size_t done = 0; done < bytes; done += LARGE_BLOCK) {
        harness_block_give_back(harness_block_take(LARGE_BLOCK), LARGE_BLOCK);
    }
}

static void blocks_are_reused_oldest_first(void **state)
{
    (void)state;
    unsigned char *a = harness_block_take(BLOCK), *b = harness_block_take(BLOCK);
    harness_block_give_back(a, BLOCK);
    harness_block_give_back(b, BLOCK);
    give_back(harness_block_delay());
    unsigned char *other = harness_block_take(BLOCK + 64);
    assert_true(other != a && other != b);
    assert_ptr_equal(harness_block_take(BLOCK), a);
    assert_ptr_equal(harness_block_take(BLOCK), b);
    unsigned char *third = harness_block_take(BLOCK);
    assert_true(third != a && third != b);
    unsigned char *const all[] = {other, third, b, a};
    for (size_t i = 0; i < 4; i++) {
        harness_block_give_back(all[i], BLOCK + (i == 0 ? 64u : 0u));
    }
    give_back(harness_block_delay());
    assert_ptr_equal(harness_block_take(BLOCK), third);
    harness_block_give_back(third, BLOCK);
}

static void released_memory_is_poisoned(void **state)
{
    (void)state;
    bool watched = harness_block_delay() > 0;
    unsigned char *a = harness_block_take(OTHER_BLOCK);
    assert_false(harness_block_is_forbidden(a));
    harness_block_give_back(a, OTHER_BLOCK);
    assert_int_equal(harness_block_is_forbidden(a), watched);
    assert_int_equal(harness_block_is_forbidden(a + OTHER_BLOCK - 1), watched);
    if (watched) {
        give_back(harness_block_delay() - 2 * (size_t)LARGE_BLOCK);
        unsigned char *early = harness_block_take(OTHER_BLOCK);
        assert_true(early != a);
        assert_true(harness_block_is_forbidden(a));
        harness_block_give_back(early, OTHER_BLOCK);
        give_back(2 * (size_t)LARGE_BLOCK);
    }
    assert_ptr_equal(harness_block_take(OTHER_BLOCK), a);
    assert_false(harness_block_is_forbidden(a));
    assert_int_equal(harness_block_is_forbidden(a + OTHER_BLOCK), watched);
    harness_block_give_back(a, OTHER_BLOCK);
}

static void property_cases_are_deterministic(void **state)
{
    (void)state;
    uint64_t first[2] = {0}, again[2] = {0};
    harness_property("count", 100, count_cases, first);
    harness_property("count", 100, count_cases, again);
    assert_int_equal(first[0], 100);
    assert_true(first[1] == again[1] && first[1] != 0);
}

static void single_case_can_be_replayed(void **state)
{
    (void)state;
    uint64_t all[2] = {0}, rest[2] = {0};
    harness_property("count", 10, count_cases, all);
    for (int i = 0; i < 10; i++) {
        char number[8];
        snprintf(number, sizeof number, "%d", i);
        setenv("VBSS_PROPERTY_CASE", number, 1);
        harness_property("count", 10, count_cases, rest);
        unsetenv("VBSS_PROPERTY_CASE");
    }
    assert_int_equal(rest[0], 10);
    assert_true(all[1] == rest[1]);
}

static void failing_soak_reports_figures(void **state)
{
    (void)state;
    harness_soak soak = {.seed = 3};
    harness_soak_figure(&soak, "worst", 0.5);
    harness_soak_figure(&soak, "none", harness_bad_numbers[0]);
    assert_string_equal(soak.figures, ", \"worst\": 0.5, \"none\": null");
    assert_int_equal(soak.failures, 0);
    harness_soak_fail(&soak, "on purpose, to be counted");
    assert_int_equal(soak.failures, 1);
}

static void bytes_can_drive_property(void **state)
{
    (void)state;
    const uint8_t bytes[10] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
    harness_source source;
    harness_source_from_bytes(&source, bytes, sizeof bytes);
    assert_true(harness_draw_u64(&source) == 0x0807060504030201u);
    assert_true(harness_draw_u64(&source) == 0x0a09u);
    assert_true(harness_draw_u64(&source) == 0);
    expect_same_bits(2.0, harness_draw_real(&source, 2.0, 3.0));
}

static void first_difference_is_named(void **state)
{
    (void)state;
    const uint64_t a[4] = {1, 2, 3, 4}, b[4] = {1, 2, 9, 4};
    assert_int_equal(harness_first_difference(a, b, 4), 2);
    assert_int_equal(harness_first_difference(a, b, 2), 2);
    assert_int_equal(harness_first_difference(a, a, 4), 4);
}

int test_fixtures(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(correct_body_passes),
        harness_test(bad_numbers_are_rejected_and_change_nothing),
        harness_test(wrong_releases_and_leaks_are_detected),
        harness_test(chosen_allocation_fails),
        harness_test(blocks_are_reused_oldest_first),
        harness_test(released_memory_is_poisoned),
        harness_test(property_cases_are_deterministic),
        harness_test(single_case_can_be_replayed),
        harness_test(failing_soak_reports_figures),
        harness_test(bytes_can_drive_property),
        harness_test(first_difference_is_named),
    };
    return cmocka_run_group_tests_name("harness.fixtures", tests, NULL, NULL);
}
