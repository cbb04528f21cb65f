/* Saving, restoring, hashing. */
#include <stdlib.h>
#include <string.h>

#include "collision/shapes_model.h"
#include "collision/shapes_object.h"
#include "fixtures/shapes_body.h"

static const moving_shapes_options lives[] = {
    {24, true, true}, {40, false, false}, {33, true, false}, {9, false, true}, {1, true, true}};
enum { LIVES = sizeof lives / sizeof lives[0] };

static void restored_object_continues_bit_equal(void **state)
{
    (void)state;
    for (int i = 0; i < LIVES; i++) {
        moving_shapes_options options = lives[i];
        const harness_body body = shapes_body(&options);
        harness_save_restore_continue(&body, 1, 20);
        harness_save_restore_continue(&body, 14, 20);
    }
}

/* What is found, too, is the same, to the bit. */
static void restored_object_finds_same_candidates(void **state)
{
    (void)state;
    uint8_t *bytes = malloc(100000);
    assert_non_null(bytes);
    for (int i = 0; i < LIVES; i++) {
        harness_memory memory;
        vbss_context *context = harness_context(&memory);
        moving_shapes first, other;
        uint64_t written, hashes[2];
        expect_ok(moving_shapes_create(context, &lives[i], NULL, &first));
        expect_ok(moving_shapes_create(context, &lives[i], NULL, &other));
        for (int step = 0; step < 30; step++) {
            expect_ok(moving_shapes_step(&first));
            if (step % 10 == 0) {
                expect_ok(vbss_collision_save(first.collision, bytes, 100000, &written));
                expect_ok(vbss_collision_restore(other.collision, bytes, written));
                expect_ok(vbss_collision_find_candidates(first.collision));
                expect_ok(vbss_collision_find_candidates(other.collision));
                expect_ok(vbss_collision_find_impacts(first.collision));
                expect_ok(vbss_collision_find_impacts(other.collision));
            } else {
                expect_ok(moving_shapes_step(&other));
            }
            expect_ok(moving_shapes_hash(&first, &hashes[0]));
            expect_ok(moving_shapes_hash(&other, &hashes[1]));
            assert_true(hashes[0] == hashes[1]);
        }
        expect_ok(moving_shapes_destroy(&first));
        expect_ok(moving_shapes_destroy(&other));
        harness_context_end(context, &memory);
    }
    free(bytes);
}

static void bad_snapshots_are_rejected(void **state)
{
    (void)state;
    for (int i = 0; i < LIVES; i++) {
        moving_shapes_options options = lives[i];
        const harness_body body = shapes_body(&options);
        harness_refuses_bad_snapshots(&body, 9);
    }
}

/* ---- the public functions */

static uint64_t save(vbss_collision *collision, uint8_t *bytes, uint64_t capacity)
{
    uint64_t written;
    expect_ok(vbss_collision_save(collision, bytes, capacity, &written));
    return written;
}

static void small_buffer_reports_required_size(void **state)
{
    (void)state;
    object_fixture f;
    uint8_t bytes[4096];
    uint64_t need = 0, written = 0;
    object_begin(&f);
    vbss_collision *c = f.collision;
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_collision_save(c, bytes, sizeof bytes, NULL));
    expect_result(VBSS_ERROR_CAPACITY, vbss_collision_save(c, NULL, 0, &need));
    assert_in_range(need, 1, sizeof bytes);
    for (uint64_t capacity = 0; capacity < need; capacity += 1 + capacity / 8) {
        bytes[capacity] = 0x5a;
        expect_result(VBSS_ERROR_CAPACITY, vbss_collision_save(c, bytes, capacity, &written));
        assert_int_equal(written, need);
        assert_int_equal(bytes[capacity], 0x5a);
    }
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_collision_save(c, NULL, need, &written));
    assert_int_equal(save(c, bytes, need), need);
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_collision_restore(c, NULL, need));
    expect_result(VBSS_ERROR_TRUNCATED, vbss_collision_restore(c, bytes, need - 1));
    expect_result(VBSS_ERROR_TRUNCATED, vbss_collision_restore(c, bytes, 0));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_collision_get_hash(c, NULL));
    object_end(&f);
}

/* On failure the list stays, on success it is forgotten. */
static void restore_clears_results(void **state)
{
    (void)state;
    object_fixture f;
    uint8_t bytes[4096];
    object_begin(&f);
    uint64_t written = save(f.collision, bytes, sizeof bytes);
    uint32_t count = shapes_statistics(f.collision).candidates;
    assert_true(count > 0);
    bytes[40] ^= 1u;
    assert_true(vbss_collision_restore(f.collision, bytes, written) < 0);
    assert_int_equal(shapes_statistics(f.collision).candidates, count);
    bytes[40] ^= 1u;
    expect_ok(vbss_collision_restore(f.collision, bytes, written));
    assert_int_equal(shapes_statistics(f.collision).candidates, 0);
    assert_int_equal(shapes_statistics(f.collision).impacts, 0);
    assert_int_equal(shapes_view(f.collision, VBSS_COLLISION_VIEW_IMPACTS).count, 0);
    object_end(&f);
}

static void expect_refused(object_fixture *f, vbss_collision *other, const uint8_t *bytes,
                           uint64_t count)
{
    uint64_t hash = object_hash(other);
    assert_true(hash != object_hash(f->collision));
    expect_result(VBSS_ERROR_CORRUPT, vbss_collision_restore(other, bytes, count));
    assert_true(object_hash(other) == hash);
    expect_ok(vbss_collision_destroy(other));
}

static void snapshot_of_other_config_is_rejected(void **state)
{
    (void)state;
    static const size_t numbers[] = {
        offsetof(vbss_collision_config, thickness), offsetof(vbss_collision_config, tolerance),
        offsetof(vbss_collision_config, exclusion), offsetof(vbss_collision_config, margin)};
    object_fixture f;
    uint8_t bytes[4096];
    vbss_collision_config config, kept;
    object_begin(&f);
    uint64_t count = save(f.collision, bytes, sizeof bytes);
    expect_ok(vbss_collision_config_init(&kept, sizeof kept));
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        double value = 0.25;
        config = kept;
        memcpy((char *)&config + numbers[i], &value, sizeof value);
        expect_refused(&f, object_make(f.context, &config), bytes, count);
    }
    config = kept;
    config.method = VBSS_COLLISION_METHOD_VBLAST;
    expect_refused(&f, object_make(f.context, &config), bytes, count);
    config = kept;
    config.pass_limit--;
    expect_refused(&f, object_make(f.context, &config), bytes, count);
    /* What only reserves memory may differ. */
    config = kept;
    config.shape_capacity = 3;
    config.pair_capacity = config.impact_capacity = 500;
    vbss_collision *alike = object_make(f.context, &config);
    expect_ok(vbss_collision_restore(alike, bytes, count));
    assert_true(object_hash(alike) == object_hash(f.collision));
    object_end(&f);
}

static vbss_collision *begin_one(const object_fixture *f)
{
    vbss_collision *collision;
    expect_ok(vbss_collision_create(f->context, NULL, &collision));
    return collision;
}

/* Each differs from the first in one thing. */
static void snapshot_of_other_shapes_is_rejected(void **state)
{
    (void)state;
    object_fixture f;
    uint8_t bytes[4096];
    uint32_t name;
    const double rest[2][4] = {{1.0, 1.0, 1.0, 1.0}, {1.0, 1e-9, 1e-9, 1.0}};
    const uint32_t triangles[2][6] = {{0, 1, 2, 2, 1, 3}, {0, 1, 2, 2, 0, 3}};
    object_begin(&f);
    expect_ok(vbss_collision_destroy(f.collision));
    for (int variant = 0; variant < 7; variant++) {
        f.collision = begin_one(&f);
        expect_ok(vbss_collision_add_chain(f.collision, 5, rest[0], 0.1, &name));
        expect_ok(vbss_collision_add_mesh(f.collision, 4, triangles[0], 2, 0.1, &name));
        uint64_t count = save(f.collision, bytes, sizeof bytes);
        vbss_collision *other = begin_one(&f);
        expect_ok(vbss_collision_add_chain(other, variant == 0 ? 6 : 5,
                                           variant == 1 ? NULL : rest[variant == 2],
                                           variant == 3 ? 0.11 : 0.1, &name));
        expect_ok(vbss_collision_add_mesh(other, 4, triangles[variant == 4], 2, 0.1, &name));
        if (variant == 5) {
            expect_ok(vbss_collision_remove(other, name));
        } else if (variant == 6) {
            expect_ok(vbss_collision_add_capsules(other, 1, 0.1, &name));
        }
        if (variant == 1) { /* neighbours alone are excluded, as with these rest lengths */
            expect_ok(vbss_collision_restore(other, bytes, count));
            expect_ok(vbss_collision_destroy(other));
        } else {
            expect_refused(&f, other, bytes, count);
        }
        expect_ok(vbss_collision_destroy(f.collision));
    }
    object_end(&f);
}

/* ---- hashes */

static void hash_covers_all_state(void **state)
{
    (void)state;
    object_fixture f;
    uint64_t seen[100];
    uint32_t count = 0;
    double x[2][18] = {{0.0}};
    object_begin(&f);
    seen[count++] = object_hash(f.collision);
    for (int i = 0; i < 36; i++) {
        x[i / 18][i % 18] = 1e-9;
        expect_ok(vbss_collision_set_motion(f.collision, OBJECT_CAPSULES, x[0], x[1], 6));
        seen[count++] = object_hash(f.collision);
    }
    expect_ok(vbss_collision_find_candidates(f.collision));
    seen[count++] = object_hash(f.collision);
    expect_ok(vbss_collision_find_impacts(f.collision));
    seen[count++] = object_hash(f.collision);
    expect_ok(vbss_collision_remove(f.collision, OBJECT_MESH));
    seen[count++] = object_hash(f.collision);
    for (uint32_t i = 0; i < count; i++) {
        for (uint32_t k = 0; k < i; k++) {
            assert_true(seen[i] != seen[k]);
        }
    }
    object_end(&f);
}

int test_object_state(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(restored_object_continues_bit_equal),
        cmocka_unit_test(restored_object_finds_same_candidates),
        cmocka_unit_test(bad_snapshots_are_rejected),
        cmocka_unit_test(small_buffer_reports_required_size),
        cmocka_unit_test(restore_clears_results),
        cmocka_unit_test(snapshot_of_other_config_is_rejected),
        cmocka_unit_test(snapshot_of_other_shapes_is_rejected),
        cmocka_unit_test(hash_covers_all_state),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
