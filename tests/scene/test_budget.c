/* Work that is counted and limited: a step never takes much more than it may, what it cannot do in time waits, and
 * nothing passes through anything for that. */
#include <string.h>

#include "fixtures/solver_of.h"
#include "harness/harness.h"
#include "oracle/knot_type.h"
#include "scene/pulled_surgeons.h"
#include "scene/small.h"
#include "scene/watch.h"

enum { STEPS = 500, LIMIT = 100000, ATTEMPTS = 3 };
#define STEP 1e-3

typedef struct limited {
    vbss_context *context;
    contact_scene scene;
    watch watch;
    vbss_scene_statistics before;
} limited;

static limited lives[2];

static limited *begin(int which, vbss_scene_mode mode, uint32_t limit)
{
    limited *l = &lives[which];
    contact_scene_options o;
    *l = (limited){0};
    pulled_surgeons_init(&o);
    o.scene.mode = mode;
    set_step_operations(&o.scene, limit);
    set_call_operations(&o.scene, 0); /* a call is a step */
    solver_of(&o.scene)->attempt_limit = ATTEMPTS;
    expect_ok(vbss_context_create(NULL, &l->context));
    expect_ok(contact_scene_create(l->context, &o, &l->scene));
    return l;
}

static void end(limited *l)
{
    expect_ok(contact_scene_destroy(&l->scene));
    expect_ok(vbss_context_destroy(l->context));
}

static vbss_scene_statistics statistics(limited *l)
{
    vbss_scene_statistics s;
    expect_ok(vbss_scene_get_statistics(l->scene.scene, &s, sizeof s));
    return s;
}

static vbss_scene_statistics step(limited *l)
{
    l->before = statistics(l);
    expect_ok(contact_scene_step(&l->scene, STEP));
    return statistics(l);
}

static uint64_t hash_of(limited *l)
{
    uint64_t hash;
    expect_ok(contact_scene_hash(&l->scene, &hash));
    return hash;
}

static knot_type type_of(limited *l)
{
    vbss_view v;
    knot_type type;
    expect_ok(vbss_thread_get_view(l->scene.threads[0], VBSS_THREAD_VIEW_POSITIONS, &v, sizeof v));
    assert_true(knot_type_of(v.data, l->scene.nodes[0], &type));
    return type;
}

/* ---- */

/* Last linearisations go beyond the limit; parts of the smallest size, a hundredth of the steps here, wherever they
 * must. */
static void step_stays_near_budget(void **state)
{
    (void)state;
    limited *l = begin(0, VBSS_SCENE_MODE_REAL_TIME, LIMIT);
    uint32_t beyond = 0, tried = 0;
    uint64_t largest = 0;
    step(l); /* the first is finished */
    for (int i = 1; i < STEPS; i++) {
        vbss_scene_statistics now = step(l);
        uint64_t work = now.operations - l->before.operations;
        beyond += work > 3 * (uint64_t)LIMIT;
        tried += now.attempts - l->before.attempts > ATTEMPTS;
        largest = work > largest ? work : largest;
    }
    vbss_scene_statistics s = statistics(l);
    assert_true(s.paused > 0 && s.paused < STEPS);
    assert_true(s.time_paused > 0.0 && s.time_paused <= STEP * (double)s.paused);
    assert_true(largest <= s.most_operations);
    assert_in_range(beyond, 0, STEPS / 50);
    assert_in_range(tried, 0, STEPS / 50);
    end(l);
}

/* Two driven sticks close on a taut thread. Without a limit the step took 30 million operations. */
static void first_step_is_limited(void **state)
{
    (void)state;
    enum { FIRST_STEP_LIMITS = 32, SMALL_LIMIT = 20000 };
    const vec3 half = vec3_make(0.0, 0.0, 0.01);
    small s;
    small_begin(&s);
    solver_of(&s.config)->halving_limit = 10;
    set_step_operations(&s.config, SMALL_LIMIT);
    small_create(&s);
    uint32_t line =
        small_thread(&s, vec3_make(-0.02, 0.0, 0.0), vec3_make(0.02, 0.0, 0.0), 40, NULL);
    uint32_t upper =
        small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.0, 3e-3, 0.0), half, 2.5e-3);
    (void)small_stick(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.0, -3e-3, 0.0), half, 2.5e-3);
    small_pin_ends(&s, line, 41);
    small_move(&s, upper, vec3_make(0.0, -2e-3, 0.0));
    small_steps(&s, 1, STEP);
    const vbss_scene_statistics now = small_statistics(&s);
    assert_in_range(now.operations, 1, (FIRST_STEP_LIMITS + 1) * SMALL_LIMIT);
    assert_in_range(now.attempts, 1, FIRST_STEP_LIMITS * solver_values(&s.config).attempt_limit);
    assert_int_equal(now.paused, 1);
    small_end(&s);
}

static void no_passage_at_low_budget(void **state)
{
    (void)state;
    limited *l = begin(0, VBSS_SCENE_MODE_REAL_TIME, LIMIT);
    knot_type first = type_of(l);
    watch_begin(&l->watch, l->scene.scene);
    for (int i = 0; i < STEPS; i++) {
        step(l);
        assert_int_equal(watch_faults(&l->watch), 0);
    }
    vbss_scene_statistics s = statistics(l);
    assert_true(s.paused > 0);
    assert_in_range(s.clamped, 0, 5); /* of the smallest parts */
    assert_int_equal(s.loose_stretch, 0);
    assert_true(knot_type_same(first, type_of(l)));
    end(l);
}

/* Whoever waits is where it was, and tools with it: the hands' way is done later. */
static void paused_bodies_are_static(void **state)
{
    (void)state;
    limited *l = begin(0, VBSS_SCENE_MODE_REAL_TIME, LIMIT / 4);
    bool waited = false;
    step(l);
    for (int i = 0; i < STEPS && !waited; i++) {
        static vec3 was[KNOT_NODES];
        vbss_view v;
        expect_ok(
            vbss_thread_get_view(l->scene.threads[0], VBSS_THREAD_VIEW_POSITIONS, &v, sizeof v));
        memcpy(was, v.data, v.count * sizeof was[0]);
        vbss_scene_statistics now = step(l);
        waited = now.paused > l->before.paused && now.parts == l->before.parts;
        expect_ok(
            vbss_thread_get_view(l->scene.threads[0], VBSS_THREAD_VIEW_POSITIONS, &v, sizeof v));
        if (waited) {
            assert_memory_equal(was, v.data, v.count * sizeof was[0]);
            assert_true(now.time_paused - l->before.time_paused == STEP);
            assert_true(now.time > l->before.time);
        }
    }
    assert_true(waited);
    end(l);
}

static void offline_mode_has_no_budget(void **state)
{
    (void)state;
    limited *l = begin(0, VBSS_SCENE_MODE_OFFLINE, LIMIT),
            *free = begin(1, VBSS_SCENE_MODE_OFFLINE, 0);
    for (int i = 0; i < STEPS / 5; i++) {
        vbss_scene_statistics a = step(l), b = step(free);
        assert_int_equal(a.paused, 0);
        assert_int_equal(a.operations, b.operations);
        assert_true(a.operations > l->before.operations);
        assert_true(a.last_penetration == b.last_penetration);
    }
    end(l);
    end(free);
}

/* Half done is part of the state: the next step begins with small parts. */
static void suspended_scene_is_restored(void **state)
{
    enum { AFTER = 40 };
    static uint8_t bytes[1u << 20];
    static uint64_t hashes[AFTER];
    uint64_t count;
    (void)state;
    limited *l = begin(0, VBSS_SCENE_MODE_REAL_TIME, LIMIT);
    vbss_scene_statistics now = step(l);
    for (int i = 0; i < STEPS && now.paused == l->before.paused; i++) {
        now = step(l);
    }
    assert_true(now.paused > l->before.paused);
    contact_scene there = l->scene;
    expect_ok(vbss_scene_save(l->scene.scene, bytes, sizeof bytes, &count));
    for (int i = 0; i < AFTER; i++) {
        step(l);
        hashes[i] = hash_of(l);
    }
    l->scene = there;
    expect_ok(vbss_scene_restore(l->scene.scene, bytes, count));
    for (int i = 0; i < AFTER; i++) {
        step(l);
        assert_int_equal(hashes[i], hash_of(l));
    }
    end(l);
}

int test_budget(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(first_step_is_limited),      cmocka_unit_test(step_stays_near_budget),
        cmocka_unit_test(no_passage_at_low_budget),   cmocka_unit_test(paused_bodies_are_static),
        cmocka_unit_test(offline_mode_has_no_budget), cmocka_unit_test(suspended_scene_is_restored),
    };
    return cmocka_run_group_tests_name("scene.budget", tests, NULL, NULL);
}
