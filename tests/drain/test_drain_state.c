/* Saving, restoring, hashing. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/error.h"
#include "drain/drain.h"
#include "drain/drain_rig.h"

/* ---- a life: hands that pull until parts of the strip have torn off, then let go */

typedef struct life {
    double tear_stress;
    uint32_t linearisations;
    vbss_drain_mesh mesh;
} life;

static const life lives[] = {{5e4, 1, VBSS_DRAIN_MESH_137},
                             {1.5e4, 1, VBSS_DRAIN_MESH_137}, /* tears */
                             {1.5e4, 10, VBSS_DRAIN_MESH_159}};
enum { LIVES = sizeof lives / sizeof lives[0] };

static vbss_result life_create(vbss_context *context, void *user, void **handle)
{
    const life *l = user;
    vbss_drain_config config;
    vbss_drain *drain = NULL;
    VBSS_TRY(vbss_drain_config_init(&config, sizeof config));
    config.tear_stress = l->tear_stress;
    config.linearisation_limit = l->linearisations;
    config.mesh = l->mesh;
    config.gravity[1] = -9.81;
    config.move_limit = 3e-4; /* with steps in parts */
    vbss_result result = vbss_drain_create(context, &config, &drain);
    *handle = drain;
    return result;
}

static vbss_result attach(vbss_drain *drain, vbss_drain_attachment_kind kind, uint32_t node)
{
    vbss_drain_attachment a;
    uint32_t id;
    VBSS_TRY(vbss_drain_attachment_init(&a, sizeof a));
    a.kind = kind;
    a.node = node;
    a.position[1] = 7e-3;
    a.force[2] = 5e-3;
    a.stiffness = 5.0;
    return vbss_drain_attach(drain, &a, &id);
}

/* What the hand does hangs on the steps so far only: a restored drain gets the same. */
static vbss_result life_step(void *handle)
{
    vbss_drain_statistics s;
    vbss_drain_places p;
    VBSS_TRY(vbss_drain_get_statistics(handle, &s, sizeof s));
    VBSS_TRY(vbss_drain_get_places(handle, &p, sizeof p));
    double t = 1e-3 * (double)s.steps;
    if (s.steps == 0) {
        VBSS_TRY(attach(handle, VBSS_DRAIN_ATTACHMENT_PIN, p.marks[0]));
        VBSS_TRY(attach(handle, VBSS_DRAIN_ATTACHMENT_FORCE, p.gap_points[1]));
        VBSS_TRY(attach(handle, VBSS_DRAIN_ATTACHMENT_SPRING, p.gap_points[0]));
    }
    if (s.steps < 60) {
        const double to[3] = {0.1 * t, 5e-3 + 0.08 * t, -4e-3 - 0.02 * t};
        VBSS_TRY(vbss_drain_move(handle, 1, to));
    }
    if (s.steps == 60) {
        VBSS_TRY(vbss_drain_detach(handle, 1));
        VBSS_TRY(attach(handle, VBSS_DRAIN_ATTACHMENT_FORCE, p.marks[1]));
    }
    return vbss_drain_step(handle, s.steps % 3 == 0 ? 5e-4 : 1e-3);
}

static vbss_result life_destroy(void *handle)
{
    return vbss_drain_destroy(handle);
}

static harness_body body_of(life *l)
{
    return (harness_body){"drain", &vbss_drain_kind, life_create, NULL, life_step, life_destroy, l};
}

static void state_cases_cover_all_events(void **state)
{
    (void)state;
    drain_rig r;
    life l = lives[1];
    drain_rig_begin(&r);
    void *handle = NULL;
    expect_ok(life_create(r.context, &l, &handle));
    r.drain = handle;
    for (int i = 0; i < 55; i++) {
        expect_ok(life_step(r.drain));
    }
    vbss_drain_statistics s = drain_rig_statistics(&r);
    assert_in_range(s.torn, 2, 32);
    assert_true(s.parts > s.steps);
    drain_rig_end(&r);
}

static void restored_drain_continues_bit_equal(void **state)
{
    (void)state;
    for (int i = 0; i < LIVES; i++) {
        life l = lives[i];
        harness_body body = body_of(&l);
        const size_t moments[] = {1, 30, 55, 70};
        harness_save_restore_continue_at(&body, moments, 4, 10);
    }
}

static void bad_snapshots_are_rejected(void **state)
{
    (void)state;
    for (int i = 0; i < LIVES; i++) {
        life l = lives[i];
        harness_body body = body_of(&l);
        harness_refuses_bad_snapshots(&body, 10);
        harness_refuses_bad_snapshots(&body, 62);
    }
}

static void steps_do_not_allocate(void **state)
{
    (void)state;
    for (int i = 0; i < LIVES; i++) {
        life l = lives[i];
        harness_body body = body_of(&l);
        assert_int_equal(harness_step_allocations(&body, 80), 0);
    }
}

/* ---- the public functions */

enum { ROOM = 32768 };

static void small_buffer_reports_required_size(void **state)
{
    (void)state;
    static uint8_t bytes[ROOM];
    drain_rig r;
    uint64_t need = 0, written = 0;
    drain_rig_begin(&r);
    drain_rig_make(&r);
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_drain_save(r.drain, bytes, ROOM, NULL));
    expect_result(VBSS_ERROR_CAPACITY, vbss_drain_save(r.drain, NULL, 0, &need));
    assert_in_range(need, 1, ROOM);
    for (uint64_t capacity = 0; capacity < need; capacity += 1 + capacity / 8) {
        bytes[capacity] = 0x5a;
        expect_result(VBSS_ERROR_CAPACITY, vbss_drain_save(r.drain, bytes, capacity, &written));
        assert_int_equal(written, need);
        assert_int_equal(bytes[capacity], 0x5a);
    }
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_drain_save(r.drain, NULL, need, &written));
    expect_ok(vbss_drain_save(r.drain, bytes, need, &written));
    assert_int_equal(written, need);
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_drain_restore(r.drain, NULL, need));
    expect_result(VBSS_ERROR_TRUNCATED, vbss_drain_restore(r.drain, bytes, need - 1));
    expect_result(VBSS_ERROR_TRUNCATED, vbss_drain_restore(r.drain, bytes, 0));
    drain_rig_end(&r);
}

static void expect_foreign(drain_rig *r, const uint8_t *bytes, uint64_t count)
{
    drain_rig_make(r);
    uint64_t hash = drain_rig_hash(r);
    assert_true(vbss_drain_restore(r->drain, bytes, count) < 0);
    assert_true(drain_rig_hash(r) == hash);
    expect_ok(vbss_drain_destroy(r->drain));
}

/* Every field of the configuration that the motion depends on. */
static void snapshot_of_other_config_is_rejected(void **state)
{
    (void)state;
    static const size_t numbers[] = {offsetof(vbss_drain_config, length),
                                     offsetof(vbss_drain_config, radius),
                                     offsetof(vbss_drain_config, thickness),
                                     offsetof(vbss_drain_config, slit_length),
                                     offsetof(vbss_drain_config, slit_opening),
                                     offsetof(vbss_drain_config, mark_arc),
                                     offsetof(vbss_drain_config, young_modulus),
                                     offsetof(vbss_drain_config, poisson_ratio),
                                     offsetof(vbss_drain_config, density),
                                     offsetof(vbss_drain_config, drag),
                                     offsetof(vbss_drain_config, gravity[1]),
                                     offsetof(vbss_drain_config, position[2]),
                                     offsetof(vbss_drain_config, orientation[3]),
                                     offsetof(vbss_drain_config, tear_stress),
                                     offsetof(vbss_drain_config, move_limit),
                                     offsetof(vbss_drain_config, position_tolerance)};
    static const size_t choices[] = {offsetof(vbss_drain_config, mesh),
                                     offsetof(vbss_drain_config, mesh_divisions),
                                     offsetof(vbss_drain_config, attachment_capacity),
                                     offsetof(vbss_drain_config, linearisation_limit),
                                     offsetof(vbss_drain_config, halving_limit)};
    static uint8_t bytes[ROOM];
    drain_rig r;
    uint64_t written;
    drain_rig_begin(&r);
    drain_rig_make(&r);
    vbss_drain *first = r.drain;
    expect_ok(vbss_drain_save(first, bytes, ROOM, &written));
    const vbss_drain_config kept = r.config;
    for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; k++) {
        double value;
        memcpy(&value, (char *)&r.config + numbers[k], sizeof value);
        value = value > 0.0 ? 0.999 * value : 0.001;
        memcpy((char *)&r.config + numbers[k], &value, sizeof value);
        expect_foreign(&r, bytes, written);
        r.config = kept;
    }
    for (size_t k = 0; k < sizeof choices / sizeof choices[0]; k++) {
        uint32_t value;
        memcpy(&value, (char *)&r.config + choices[k], sizeof value);
        value++;
        memcpy((char *)&r.config + choices[k], &value, sizeof value);
        expect_foreign(&r, bytes, written);
        r.config = kept;
    }
    r.config.orientation[0] = 7.0; /* the same turn */
    drain_rig_make(&r);
    expect_ok(vbss_drain_restore(r.drain, bytes, written));
    expect_ok(vbss_drain_destroy(first));
    drain_rig_end(&r);
}

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

/* ---- damage by hand under a right checksum */

/* Edits the state of a drain, saves it, and restores that into another. */
static vbss_result restored(void (*edit)(drain_object *d))
{
    static uint8_t bytes[ROOM];
    drain_rig r;
    uint64_t written;
    drain_object *d;
    drain_rig_begin(&r);
    drain_rig_make(&r);
    drain_rig_pin_here(&r, 0);
    drain_rig_force(&r, 1, vec3_zero());
    drain_rig_run(&r, 1e-3, 2);
    vbss_drain *damaged = r.drain;
    expect_ok(vbss_drain_open(damaged, &d));
    edit(d);
    expect_ok(vbss_drain_save(damaged, bytes, ROOM, &written));
    drain_rig_make(&r);
    uint64_t hash = drain_rig_hash(&r);
    vbss_result result = vbss_drain_restore(r.drain, bytes, written);
    assert_true(result == VBSS_OK || drain_rig_hash(&r) == hash);
    expect_ok(vbss_drain_destroy(damaged));
    drain_rig_end(&r);
    return result;
}

static void leave(drain_object *d)
{
    d->v[0].x = 1.0;
}
static void move_anchored(drain_object *d)
{
    d->x[d->mesh.anchors[3]].y += 1e-6;
}
static void speed_anchored(drain_object *d)
{
    d->v[d->mesh.anchors[3]].y = 1e-6;
}
static void tear_uncounted(drain_object *d)
{
    d->torn[1] = 1;
}
static void tear_twice(drain_object *d)
{
    d->torn[1] = 2;
    d->statistics.torn = 1;
}
static void pin_twice(drain_object *d)
{
    d->attachments[1].kind = VBSS_DRAIN_ATTACHMENT_PIN;
    d->attachments[1].node = 0;
}
static void hold_anchored(drain_object *d)
{
    d->attachments[1].node = d->mesh.anchors[0];
}
static void name_twice(drain_object *d)
{
    d->attachments[1].id = 1;
}
static void name_ahead(drain_object *d)
{
    d->attachments[1].id = 3;
}
static void soften(drain_object *d)
{
    d->attachments[1].stiffness = -1.0;
}

static void impossible_states_are_rejected(void **state)
{
    (void)state;
    void (*const edits[])(drain_object *) = {move_anchored, speed_anchored, tear_uncounted,
                                             tear_twice,    pin_twice,      hold_anchored,
                                             name_twice,    name_ahead,     soften};
    expect_ok(restored(leave));
    for (size_t k = 0; k < sizeof edits / sizeof edits[0]; k++) {
        expect_result(VBSS_ERROR_CORRUPT, restored(edits[k]));
    }
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
        cmocka_unit_test(state_cases_cover_all_events),
        cmocka_unit_test(restored_drain_continues_bit_equal),
        cmocka_unit_test(bad_snapshots_are_rejected),
        cmocka_unit_test(steps_do_not_allocate),
        cmocka_unit_test(small_buffer_reports_required_size),
        cmocka_unit_test(snapshot_of_other_config_is_rejected),
        cmocka_unit_test(hash_covers_all_state),
        cmocka_unit_test(impossible_states_are_rejected),
        cmocka_unit_test(finite_absurd_state_is_reported_by_step),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
