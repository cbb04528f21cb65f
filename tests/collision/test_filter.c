/* Which shapes are searched together: the list without a filter, less what the filter leaves out. */
#include <string.h>

#include "collision/shapes_model.h"
#include "fixtures/moving_shapes.h"

enum { SHAPES = 3 };

typedef struct fixture {
    harness_memory memory;
    vbss_context *context;
    moving_shapes scene;
} fixture;

static void begin(fixture *f)
{
    moving_shapes_options options = {.segment_count = 60, .capsules = true, .sheet = true};
    vbss_collision_config config;
    f->context = harness_context(&f->memory);
    expect_ok(moving_shapes_config(&options, &config));
    expect_ok(moving_shapes_create(f->context, &options, &config, &f->scene));
}

static void end(fixture *f)
{
    expect_ok(moving_shapes_destroy(&f->scene));
    harness_context_end(f->context, &f->memory);
}

static void set(fixture *f, const uint32_t category[SHAPES], const uint32_t mask[SHAPES])
{
    for (uint32_t i = 0; i < SHAPES; i++) {
        expect_ok(vbss_collision_set_filter(f->scene.collision, i, category[i], mask[i]));
    }
}

static bool meet(const uint32_t category[SHAPES], const uint32_t mask[SHAPES], uint32_t a,
                 uint32_t b)
{
    return (category[a] & mask[b]) != 0 && (category[b] & mask[a]) != 0;
}

/* Of each pair of shapes that were searched, how many candidates the list has. */
static uint32_t expect_filtered(fixture *f, const candidate *all, uint32_t all_count,
                                const uint32_t category[SHAPES], const uint32_t mask[SHAPES])
{
    uint32_t count, next = 0;
    const candidate *listed = shapes_find(f->scene.collision, &count);
    for (uint32_t i = 0; i < all_count; i++) {
        if (meet(category, mask, all[i].shape_a, all[i].shape_b)) {
            assert_true(next < count);
            assert_memory_equal(&listed[next++], &all[i], sizeof all[i]);
        }
    }
    assert_int_equal(next, count);
    return count;
}

static void filter_removes_exactly_its_pairs(void **state)
{
    (void)state;
    static const uint32_t every = UINT32_MAX;
    static const struct {
        uint32_t category[SHAPES], mask[SHAPES];
    } filters[] = {
        {{1, 1, 1}, {every, every, every}},      /* as added */
        {{1, 1, 2}, {every, every, every ^ 2u}}, /* the sheet is not searched with itself */
        {{1, 2, 4},
         {every ^ 2u, every, every}}, /* not the thread with the capsules: its mask says so */
        {{1, 2, 4}, {every, every ^ 1u, every}},           /* their mask says so */
        {{1, 2, 4}, {every ^ 1u, every ^ 2u, every ^ 4u}}, /* nobody with itself */
        {{0, 1, 1}, {every, every, every}},                /* the thread with nobody */
        {{1, 1, 1}, {0, 0, 0}},                            /* nobody with anybody */
        {{0x80000000u, 1, 1}, {0x80000000u, 1, 1}},        /* the thread with itself alone */
    };
    fixture f;
    begin(&f);
    expect_ok(moving_shapes_move(&f.scene, 1));
    uint32_t all_count, kept[sizeof filters / sizeof filters[0]];
    const candidate *listed = shapes_find(f.scene.collision, &all_count);
    assert_true(all_count > 0);
    static candidate all[4096];
    assert_true(all_count <= sizeof all / sizeof all[0]);
    memcpy(all, listed, all_count * sizeof *all);
    for (size_t i = 0; i < sizeof filters / sizeof filters[0]; i++) {
        set(&f, filters[i].category, filters[i].mask);
        kept[i] = expect_filtered(&f, all, all_count, filters[i].category, filters[i].mask);
    }
    assert_int_equal(kept[0], all_count);
    assert_true(kept[1] < all_count && kept[2] < all_count && kept[4] < kept[2]);
    assert_int_equal(kept[2], kept[3]);
    assert_true(kept[5] < all_count && kept[7] > 0);
    assert_int_equal(kept[6], 0);
    end(&f);
}

static void filter_is_in_snapshot(void **state)
{
    (void)state;
    fixture f;
    uint64_t before, after, restored;
    uint8_t bytes[65536];
    uint64_t count;
    begin(&f);
    vbss_collision *c = f.scene.collision;
    expect_ok(vbss_collision_get_hash(c, &before));
    expect_ok(vbss_collision_set_filter(c, MOVING_SHEET, 4, 3));
    expect_ok(vbss_collision_get_hash(c, &after));
    assert_true(before != after);
    expect_ok(vbss_collision_save(c, bytes, sizeof bytes, &count));
    expect_ok(vbss_collision_set_filter(c, MOVING_SHEET, 1, UINT32_MAX));
    expect_ok(vbss_collision_restore(c, bytes, count));
    expect_ok(vbss_collision_get_hash(c, &restored));
    assert_true(restored == after);
    end(&f);
}

static uint64_t listed(vbss_collision *collision)
{
    return shapes_view(collision, VBSS_COLLISION_VIEW_CANDIDATES).count;
}

/* Testing candidates of other places, or of shapes that no longer meet, would be wrong. */
static void moves_and_filters_invalidate_candidates(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    vbss_collision *c = f.scene.collision;
    expect_ok(vbss_collision_find_candidates(c));
    assert_true(listed(c) > 0);
    expect_ok(moving_shapes_move(&f.scene, 1));
    assert_true(listed(c) == 0);
    expect_ok(vbss_collision_find_impacts(c));
    assert_true(shapes_view(c, VBSS_COLLISION_VIEW_IMPACTS).count == 0);
    expect_ok(vbss_collision_find_candidates(c));
    assert_true(listed(c) > 0);
    expect_ok(vbss_collision_set_filter(c, MOVING_THREAD, 1, 1));
    assert_true(listed(c) == 0);
    end(&f);
}

static void filter_needs_a_shape(void **state)
{
    (void)state;
    fixture f;
    uint64_t before, after;
    begin(&f);
    vbss_collision *c = f.scene.collision;
    expect_ok(vbss_collision_get_hash(c, &before));
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_collision_set_filter(c, SHAPES, 1, 1));
    expect_ok(vbss_collision_remove(c, MOVING_CAPSULES));
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_collision_set_filter(c, MOVING_CAPSULES, 1, 1));
    expect_ok(vbss_collision_get_hash(c, &after));
    assert_true(before != after); /* the removal */
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_collision_set_filter(NULL, 0, 1, 1));
    end(&f);
}

int test_filter(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(filter_removes_exactly_its_pairs),
        cmocka_unit_test(filter_is_in_snapshot),
        cmocka_unit_test(moves_and_filters_invalidate_candidates),
        cmocka_unit_test(filter_needs_a_shape),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
