/* Saving, restoring, hashing. */
#include <stdlib.h>

#include "fixture.h"
#include "fixtures/thread_body.h"

static const thread_body_options lives[] = {
    {THREAD_SCENE_RELEASE, VBSS_METHOD_OURS, VBSS_BENDING_SPLINE, 16},
    {THREAD_SCENE_TUGGED, VBSS_METHOD_OURS, VBSS_BENDING_SPLINE, 16},
    {THREAD_SCENE_TUGGED, VBSS_METHOD_OURS, VBSS_BENDING_LOCAL, 13},
    {THREAD_SCENE_CUT, VBSS_METHOD_OURS, VBSS_BENDING_SPLINE, 16},
    {THREAD_SCENE_CUT, VBSS_METHOD_OURS, VBSS_BENDING_LOCAL, 24},
    {THREAD_SCENE_TUGGED, VBSS_METHOD_PAPER, VBSS_BENDING_SPLINE, 16},
    {THREAD_SCENE_CUT, VBSS_METHOD_PAPER, VBSS_BENDING_SPLINE, 16},
};
enum { LIVES = sizeof lives / sizeof lives[0] };

static void restored_thread_continues_bit_equal(void **state)
{
    (void)state;
    for (int i = 0; i < LIVES; i++) {
        thread_body_options options = lives[i];
        harness_body body = thread_body(&options);
        const size_t moments[] = {1, 7, 9, THREAD_SCENE_CUT_STEP, 70};
        harness_save_restore_continue_at(&body, moments, 5, 40);
    }
}

static void bad_snapshots_are_rejected(void **state)
{
    (void)state;
    for (int i = 0; i < LIVES; i++) {
        thread_body_options options = lives[i];
        harness_body body = thread_body(&options);
        harness_refuses_bad_snapshots(&body, 30);
        harness_refuses_bad_snapshots(&body, THREAD_SCENE_CUT_STEP + 5);
    }
}

static void steps_do_not_allocate(void **state)
{
    (void)state;
    for (int i = 0; i < LIVES; i++) {
        thread_body_options options = lives[i];
        harness_body body = thread_body(&options);
        assert_int_equal(harness_step_allocations(&body, 100), 0);
    }
}

/* ---- the public functions */

static void small_buffer_reports_required_size(void **state)
{
    (void)state;
    fixture f;
    uint8_t bytes[8192];
    uint64_t need = 0, written = 0;
    begin(&f);
    vbss_thread *thread = make(&f);
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_thread_save(thread, bytes, sizeof bytes, NULL));
    expect_result(VBSS_ERROR_CAPACITY, vbss_thread_save(thread, NULL, 0, &need));
    assert_in_range(need, 1, sizeof bytes);
    for (uint64_t capacity = 0; capacity < need; capacity += 1 + capacity / 8) {
        bytes[capacity] = 0x5a;
        expect_result(VBSS_ERROR_CAPACITY, vbss_thread_save(thread, bytes, capacity, &written));
        assert_int_equal(written, need);
        assert_int_equal(bytes[capacity], 0x5a);
    }
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_thread_save(thread, NULL, need, &written));
    expect_ok(vbss_thread_save(thread, bytes, need, &written));
    assert_int_equal(written, need);
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_thread_restore(thread, NULL, need));
    expect_result(VBSS_ERROR_TRUNCATED, vbss_thread_restore(thread, bytes, need - 1));
    expect_result(VBSS_ERROR_TRUNCATED, vbss_thread_restore(thread, bytes, 0));
    end(&f);
}

/* Every number of the configuration that the motion depends on. */
static void snapshot_of_other_config_is_rejected(void **state)
{
    (void)state;
    static const size_t numbers[] = {offsetof(vbss_thread_config, radius),
                                     offsetof(vbss_thread_config, linear_density),
                                     offsetof(vbss_thread_config, axial_stiffness),
                                     offsetof(vbss_thread_config, bending_stiffness),
                                     offsetof(vbss_thread_config, rest_curvature),
                                     offsetof(vbss_thread_config, gravity[2]),
                                     offsetof(vbss_thread_config, drag),
                                     offsetof(vbss_thread_config, damping),
                                     offsetof(vbss_thread_config, spectral_radius),
                                     offsetof(vbss_thread_config, stretch_tolerance),
                                     offsetof(vbss_thread_config, position_tolerance)};
    static const size_t choices[] = {
        offsetof(vbss_thread_config, bending), offsetof(vbss_thread_config, segment_count),
        offsetof(vbss_thread_config, iteration_limit), offsetof(vbss_thread_config, halving_limit),
        offsetof(vbss_thread_config, attachment_capacity)};
    fixture f;
    uint8_t bytes[8192];
    uint64_t written;
    begin(&f);
    vbss_thread *first = make(&f);
    expect_ok(vbss_thread_save(first, bytes, sizeof bytes, &written));
    const vbss_thread_config kept = f.config;
    for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; k++) {
        double value;
        memcpy(&value, (char *)&f.config + numbers[k], sizeof value);
        value = value > 0.0 ? 0.999 * value : 0.001;
        memcpy((char *)&f.config + numbers[k], &value, sizeof value);
        vbss_thread *other = make(&f);
        uint64_t hash = hash_of(other);
        assert_true(hash != hash_of(first));
        expect_result(VBSS_ERROR_CORRUPT, vbss_thread_restore(other, bytes, written));
        assert_true(hash_of(other) == hash);
        f.config = kept;
    }
    for (size_t k = 0; k < sizeof choices / sizeof choices[0]; k++) {
        uint32_t value;
        memcpy(&value, (char *)&f.config + choices[k], sizeof value);
        value = value > 0 ? value - 1 : 1;
        memcpy((char *)&f.config + choices[k], &value, sizeof value);
        vbss_thread *other = make(&f);
        uint64_t hash = hash_of(other);
        assert_true(vbss_thread_restore(other, bytes, written) < 0);
        assert_true(hash_of(other) == hash);
        f.config = kept;
    }
    /* What only reserves memory may differ. */
    f.config.cut_capacity = 2;
    vbss_thread *alike = make(&f);
    expect_ok(vbss_thread_restore(alike, bytes, written));
    assert_true(hash_of(alike) == hash_of(first));
    end(&f);
}

/* Everything a host can set shows in the hash. */
static void hash_covers_all_state(void **state)
{
    (void)state;
    fixture f;
    uint64_t seen[160];
    uint32_t count = 0;
    begin(&f);
    vbss_thread *thread = make(&f);
    vec3 x[13], v[13];
    for (uint32_t i = 0; i < 13; i++) {
        x[i] = place_of(thread, i);
        v[i] = vec3_zero();
    }
    seen[count++] = hash_of(thread);
    for (uint32_t i = 0; i < 39; i++) {
        double *at = (i % 3 == 0 ? &x[i / 3].x : i % 3 == 1 ? &x[i / 3].y : &x[i / 3].z);
        *at += 1e-9;
        expect_ok(vbss_thread_set_state(thread, &x[0].x, NULL, 13));
        seen[count++] = hash_of(thread);
        at = (i % 3 == 0 ? &v[i / 3].x : i % 3 == 1 ? &v[i / 3].y : &v[i / 3].z);
        *at -= 1e-9;
        expect_ok(vbss_thread_set_state(thread, NULL, &v[0].x, 13));
        seen[count++] = hash_of(thread);
    }
    uint32_t ids[5];
    for (int kind = 0; kind < 5; kind++) {
        ids[kind] = hold(thread, kind, 3 + (uint32_t)kind, vec3_zero());
        seen[count++] = hash_of(thread);
    }
    for (int kind = 0; kind < 4; kind++) {
        move(thread, ids[kind], vec3_make(1e-9, 0.0, 0.0));
        seen[count++] = hash_of(thread);
    }
    expect_ok(vbss_thread_detach(thread, ids[4]));
    seen[count++] = hash_of(thread);
    steps(thread, 1, 1e-3);
    seen[count++] = hash_of(thread);
    for (uint32_t i = 0; i < count; i++) {
        for (uint32_t k = 0; k < i; k++) {
            assert_true(seen[i] != seen[k]);
        }
    }
    end(&f);
}

/* What was damaged by hand under a right checksum cannot make a step that is not finite a success. */
static void finite_absurd_state_is_reported_by_step(void **state)
{
    (void)state;
    const double absurd[] = {1e30, 1e100, 1e160, 1e300, DBL_MAX};
    for (int k = 0; k < 10; k++) {
        fixture f;
        begin(&f);
        vbss_thread *thread = make(&f);
        hold(thread, VBSS_ATTACHMENT_PIN, 6, vec3_make(0.075, 0.0, 0.0));
        steps(thread, 3, 1e-3);
        thread_object *t;
        expect_ok(vbss_thread_edit(thread, &t));
        (k < 5 ? t->now.v : t->now.q)[2].x = absurd[k % 5];
        uint64_t hash = hash_of(thread);
        vbss_result result = vbss_thread_step(thread, 1e-3);
        if (result == VBSS_OK) {
            assert_true(all_finite(thread));
        } else {
            expect_result(VBSS_ERROR_NOT_FINITE, result);
            assert_true(hash_of(thread) == hash);
        }
        end(&f);
    }
}

int test_thread_state(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(restored_thread_continues_bit_equal),
        cmocka_unit_test(bad_snapshots_are_rejected),
        cmocka_unit_test(steps_do_not_allocate),
        cmocka_unit_test(small_buffer_reports_required_size),
        cmocka_unit_test(snapshot_of_other_config_is_rejected),
        cmocka_unit_test(hash_covers_all_state),
        cmocka_unit_test(finite_absurd_state_is_reported_by_step),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
