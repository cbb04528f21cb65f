/* What leaving out near pairs does to memory, state and snapshots, and what it refuses. */
#include <math.h>
#include <stdlib.h>

#include "collision/near_rig.h"

static void failed_allocation_changes_nothing(void **state)
{
    (void)state;
    near_rig f;
    near_begin(&f);
    const model_shape *s = near_add_slit_sheet(&f);
    near_make(&f);
    model_move(&f.m, f.collision);
    uint64_t before = f.memory.blocks;
    for (int round = 0; round < 3; round++) {
        uint64_t calls = 1;
        for (;; calls++) {
            uint32_t count, kept;
            shapes_find(f.collision, &count);
            uint64_t hash = near_hash(&f), blocks = f.memory.blocks;
            f.memory.fail_call = f.memory.calls + calls;
            vbss_result result = vbss_collision_exclude_near(f.object, 0, s->end, 2.5 + round);
            f.memory.fail_call = 0;
            if (result == VBSS_OK) {
                assert_true(near_hash(&f) != hash);
                break;
            }
            expect_result(VBSS_ERROR_OUT_OF_MEMORY, result);
            assert_int_equal(f.memory.blocks, blocks);
            assert_int_equal(shapes_statistics(f.collision).candidates, count); /* not forgotten */
            shapes_find(f.collision, &kept);
            assert_int_equal(kept, count);
        }
        assert_int_equal(calls, 16); /* of each of fifteen */
        assert_int_equal(f.memory.blocks, before + COLLISION_EXCLUSION_ARRAYS);
    }
    expect_ok(vbss_collision_remove(f.collision, 0));
    assert_true(f.memory.blocks < before);
    near_end(&f);
}

/* A snapshot fits what leaves out the same, and the list does not depend on what was before. */
static void exclusion_rules_are_checked_in_snapshot(void **state)
{
    (void)state;
    near_rig saved, other;
    uint8_t bytes[8192];
    uint64_t written;
    near_begin(&saved);
    near_begin(&other);
    const model_shape *s = near_add_slit_sheet(&saved);
    near_make(&saved);
    model_move(&saved.m, saved.collision);
    near_add_slit_sheet(&other);
    near_make(&other);
    near_leave_out(&saved, 0, s->end, 2.5);
    expect_ok(vbss_collision_save(saved.collision, bytes, sizeof bytes, &written));
    expect_result(VBSS_ERROR_CORRUPT, vbss_collision_restore(other.collision, bytes, written));
    near_leave_out(&other, 0, s->end, 4.5);
    expect_result(VBSS_ERROR_CORRUPT, vbss_collision_restore(other.collision, bytes, written));
    near_leave_out(&other, 0, s->end, 2.5);
    expect_ok(vbss_collision_restore(other.collision, bytes, written));
    assert_true(near_hash(&saved) == near_hash(&other));
    expect_ok(vbss_collision_find_candidates(saved.collision));
    expect_ok(vbss_collision_find_candidates(other.collision));
    shapes_expect_same_list(saved.collision, other.collision);
    near_end(&saved);
    near_end(&other);
}

static void invalid_rules_are_rejected(void **state)
{
    (void)state;
    enum { MAX_COUNT = 65536 };
    near_rig f;
    const uint32_t triangle[3] = {0, 1, 2};
    uint32_t name;
    near_begin(&f);
    model_shape *s = near_add_slit_sheet(&f);
    model_chain(&f.m, 5, NULL, 0.1);
    near_make(&f);
    model_move(&f.m, f.collision);
    expect_ok(vbss_collision_add_mesh(f.collision, MAX_COUNT, triangle, 1, 0.1, &name));
    uint64_t hash = near_hash(&f);
    vec3 *at = calloc(MAX_COUNT, sizeof *at);
    assert_non_null(at);
    collision_object *c = f.object;
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_collision_exclude_near(c, 3, at, 1.0));
    expect_result(VBSS_ERROR_INCOMPATIBLE, vbss_collision_exclude_near(c, 1, at, 1.0));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_collision_exclude_near(c, 0, at, -1.0));
    expect_result(VBSS_ERROR_NOT_FINITE, vbss_collision_exclude_near(c, 0, at, (double)NAN));
    expect_result(VBSS_ERROR_CAPACITY, vbss_collision_exclude_near(c, name, at, 1.0));
    s->start[47].z = (double)INFINITY;
    expect_result(VBSS_ERROR_NOT_FINITE, vbss_collision_exclude_near(c, 0, s->start, 1.0));
    assert_true(near_hash(&f) == hash);
    free(at);
    near_end(&f);
}

int test_near_pair_rules(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(failed_allocation_changes_nothing),
        cmocka_unit_test(exclusion_rules_are_checked_in_snapshot),
        cmocka_unit_test(invalid_rules_are_rejected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
