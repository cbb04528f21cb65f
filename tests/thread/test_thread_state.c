/* The hash of a thread, and states that are finite but absurd; snapshots: contract.thread. */
#include <stdlib.h>

#include "fixture.h"

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
        hold(thread, VBSS_THREAD_ATTACHMENT_PIN, 6, vec3_make(0.075, 0.0, 0.0));
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

/* The parameters of memory of bends do nothing while it is off; and the golden scenes thread-release, thread-tugged and
 * thread-cut have the hashes that they had before memory and twist existed. */
static void options_that_are_off_change_no_bit(void **state)
{
    (void)state;
    uint64_t hashes[2];
    for (int k = 0; k < 2; k++) {
        fixture f;
        begin(&f);
        if (k == 1) {
            f.config.yield_hardening = 0.3;
            f.config.relaxation_time = 7.0;
        }
        vbss_thread *thread = make(&f);
        (void)hold(thread, VBSS_THREAD_ATTACHMENT_CLAMP, 0, place_of(thread, 0));
        steps(thread, 200, 1e-3);
        assert_true(place_of(thread, 12).y < -1e-2);
        hashes[k] = hash_of(thread);
        end(&f);
    }
    assert_true(hashes[0] == hashes[1]);
}

int test_thread_state(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hash_covers_all_state),
        cmocka_unit_test(options_that_are_off_change_no_bit),
        cmocka_unit_test(finite_absurd_state_is_reported_by_step),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
