/* The hash of a drain, and states that are finite but absurd; snapshots: contract.drain. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/error.h"
#include "drain/drain.h"
#include "drain/drain_rig.h"

/* Everything a host can set shows in the hash. */
static void hash_covers_all_state(void **state)
{
    (void)state;
    static uint64_t seen[600];
    static vec3 x[DRAIN_RIG_NODES], v[DRAIN_RIG_NODES];
    uint32_t count = 0;
    drain_rig r;
    drain_rig_begin(&r);
    drain_rig_make(&r);
    drain_rig_copy(&r, x);
    seen[count++] = drain_rig_hash(&r);
    for (uint32_t i = 0; i < r.places.node_count; i++) {
        if (!drain_rig_is_anchor(&r, i)) {
            *(i % 3 == 0 ? &x[i].x : i % 3 == 1 ? &x[i].y : &x[i].z) += 1e-9;
            expect_ok(vbss_drain_set_state(r.drain, &x[0].x, NULL, r.places.node_count));
            seen[count++] = drain_rig_hash(&r);
            *(i % 3 == 0 ? &v[i].x : i % 3 == 1 ? &v[i].y : &v[i].z) -= 1e-9;
            expect_ok(vbss_drain_set_state(r.drain, NULL, &v[0].x, r.places.node_count));
            seen[count++] = drain_rig_hash(&r);
        }
    }
    uint32_t pin = drain_rig_pin_here(&r, 0);
    seen[count++] = drain_rig_hash(&r);
    uint32_t force = drain_rig_force(&r, 1, vec3_zero());
    seen[count++] = drain_rig_hash(&r);
    drain_rig_spring(&r, 2, vec3_zero(), 1.0);
    seen[count++] = drain_rig_hash(&r);
    drain_rig_move(&r, pin, vec3_make(1e-9, 0.0, 0.0));
    seen[count++] = drain_rig_hash(&r);
    drain_rig_move(&r, force, vec3_make(1e-9, 0.0, 0.0));
    seen[count++] = drain_rig_hash(&r);
    drain_rig_detach(&r, pin);
    seen[count++] = drain_rig_hash(&r);
    drain_rig_run(&r, 1e-3, 1);
    seen[count++] = drain_rig_hash(&r);
    for (uint32_t i = 0; i < count; i++) {
        for (uint32_t k = 0; k < i; k++) {
            assert_true(seen[i] != seen[k]);
        }
    }
    drain_rig_end(&r);
}

static void finite_absurd_state_is_reported_by_step(void **state)
{
    (void)state;
    const double absurd[] = {1e30, 1e100, 1e160, 1e300, DBL_MAX};
    for (int k = 0; k < 10; k++) {
        drain_rig r;
        drain_object *d;
        drain_rig_begin(&r);
        drain_rig_make(&r);
        drain_rig_pin_here(&r, 4);
        drain_rig_run(&r, 1e-3, 3);
        expect_ok(vbss_drain_edit(r.drain, &d));
        (k < 5 ? d->v : d->x)[2].x = absurd[k % 5];
        uint64_t hash = drain_rig_hash(&r);
        vbss_result result = vbss_drain_step(r.drain, 1e-3);
        if (result == VBSS_OK) {
            assert_true(isfinite(drain_rig_fastest(&r)));
        } else {
            expect_result(VBSS_ERROR_NOT_FINITE, result);
            assert_true(drain_rig_hash(&r) == hash);
        }
        drain_rig_end(&r);
    }
}

int test_drain_state(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hash_covers_all_state),
        cmocka_unit_test(finite_absurd_state_is_reported_by_step),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
