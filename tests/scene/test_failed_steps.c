/* Steps that fail for want of room, at the places of a step where that is rare: the failure leaves no trace, or comes
 * with the next call. */
#include <stdlib.h>

#include "fixtures/solver_of.h"
#include "scene/small.h"

#define STEP 1e-3

/* A thread rests on two driven sticks, and is pinned to the first. */
typedef struct resting {
    small s;
    vbss_thread *thread;
    uint32_t sticks[2], capacity;
} resting;

static void begin(resting *r, uint32_t call_budget)
{
    const vec3 half = vec3_make(0.0, 0.0, 5e-3);
    small_begin(&r->s);
    set_call_operations(&r->s.config, call_budget);
    small_create(&r->s);
    r->s.thread.gravity[1] = -9.81;
    uint32_t line = small_thread(&r->s, vec3_make(-0.01, 1.1e-3, 0.0), vec3_make(0.01, 1.1e-3, 0.0),
                                 20, &r->thread);
    for (int k = 0; k < 2; k++) {
        r->sticks[k] = small_stick(&r->s, VBSS_SCENE_RIGID_DRIVEN,
                                   vec3_make(k == 0 ? -5e-3 : 5e-3, 0.0, 0.0), half, 1e-3);
    }
    (void)small_pin(&r->s, line, 0, r->sticks[0]);
    small_steps(&r->s, 30, STEP);
    r->capacity = small_object(&r->s)->contacts->capacity;
}

static bool is_suspended(const resting *r)
{
    return small_object(&r->s)->cursor.is_suspended;
}

/* From now on no step finds room for its contacts; or it does again. */
static void set_room(resting *r, bool has_room)
{
    small_object(&r->s)->contacts->capacity = has_room ? r->capacity : 0;
}

static void expect_failure_without_trace(resting *r)
{
    set_room(r, true);
    small_state before = small_save(&r->s);
    set_room(r, false);
    expect_result(VBSS_ERROR_CAPACITY, vbss_scene_step(r->s.scene, STEP));
    set_room(r, true);
    small_state now = small_save(&r->s);
    assert_int_equal(now.count, before.count);
    assert_memory_equal(now.bytes, before.bytes, now.count);
    free(before.bytes);
    free(now.bytes);
}

/* An edit by the thread's handle ends the suspended step in the next call. */
static void failure_after_end_of_suspended_step_comes_with_next_call(void **state)
{
    (void)state;
    resting r;
    uint32_t id;
    vbss_thread_attachment mass;
    begin(&r, 1);
    while (!is_suspended(&r)) {
        small_steps(&r.s, 1, STEP);
    }
    expect_ok(vbss_thread_attachment_init(&mass, sizeof mass));
    mass.kind = VBSS_THREAD_ATTACHMENT_MASS;
    mass.node = 9;
    mass.mass = 1e-6;
    expect_ok(vbss_thread_attach(r.thread, &mass, &id));
    const uint64_t paused = small_statistics(&r.s).paused;
    set_room(&r, false);
    expect_ok(vbss_scene_step(r.s.scene, STEP));
    assert_false(is_suspended(&r));
    assert_true(small_statistics(&r.s).paused > paused && small_statistics(&r.s).behind > 0);
    expect_failure_without_trace(&r);
    small_steps(&r.s, 5, STEP);
    small_end(&r.s);
}

/* The target of a driven body was set while a step was suspended, and no step has used it yet. */
static void failed_step_leaves_pending_targets(void **state)
{
    (void)state;
    resting r;
    int calls = 0;
    begin(&r, 1);
    do {
        assert_true(calls++ < 200);
        if (is_suspended(&r)) {
            small_move(&r.s, r.sticks[0], vec3_make(-5e-3, 1e-5 * calls, 0.0));
        }
        small_steps(&r.s, 1, STEP);
    } while (is_suspended(&r) || !small_object(&r.s)->bodies[1].rigid.has_pending_target);
    expect_failure_without_trace(&r);
    assert_true(small_object(&r.s)->bodies[1].rigid.has_pending_target);
    small_steps(&r.s, 5, STEP);
    small_end(&r.s);
}

/* Two sticks that overlap have come apart, which the next step notices first. */
static void failed_step_leaves_overlaps(void **state)
{
    (void)state;
    resting r;
    begin(&r, 0);
    const vec3 away = vec3_make(0.0, 0.05, 0.0), half = vec3_make(0.0, 0.0, 5e-3);
    (void)small_stick(&r.s, VBSS_SCENE_RIGID_DRIVEN, away, half, 1e-3);
    uint32_t other = small_stick(&r.s, VBSS_SCENE_RIGID_DRIVEN, away, half, 1e-3);
    assert_int_equal(small_object(&r.s)->overlap_count, 1);
    small_move(&r.s, other, vec3_make(0.0, 0.055, 0.0));
    small_steps(&r.s, 1, STEP);
    assert_int_equal(small_object(&r.s)->overlap_count, 1);
    expect_failure_without_trace(&r);
    small_steps(&r.s, 1, STEP);
    assert_int_equal(small_object(&r.s)->overlap_count, 0);
    small_end(&r.s);
}

/* A thread was edited while a step is suspended: also a restored scene ends that step in the next call. */
static void edited_suspended_step_is_restored(void **state)
{
    (void)state;
    const uint32_t slots[] = {1, 1000, 1500, 2000, 2500};
    for (int k = 0; k < 10; k++) {
        const int edited_first = k % 2;
        resting one, other;
        double raised[3 * 21];
        begin(&one, slots[k / 2]);
        begin(&other, slots[k / 2]);
        for (int i = 0; !small_object(&one.s)->cursor.is_attempt_suspended; i++) {
            assert_true(i < 200);
            small_steps(&one.s, 1, STEP);
        }
        for (uint32_t n = 0; n < 21; n++) {
            vec3_store(raised + (size_t)3 * n,
                       vec3_add(small_node(one.thread, n), vec3_make(0.0, 5e-3, 0.0)));
        }
        if (edited_first != 0) {
            expect_ok(vbss_thread_set_state(one.thread, raised, NULL, 21));
        }
        small_state saved = small_save(&one.s);
        expect_ok(vbss_scene_restore(other.s.scene, saved.bytes, saved.count));
        if (edited_first == 0) {
            expect_ok(vbss_thread_set_state(one.thread, raised, NULL, 21));
            expect_ok(vbss_thread_set_state(other.thread, raised, NULL, 21));
        }
        for (int i = 0; i < 20; i++) {
            small_steps(&one.s, 1, STEP);
            small_steps(&other.s, 1, STEP);
            assert_true(small_hash(&one.s) == small_hash(&other.s));
        }
        free(saved.bytes);
        small_end(&one.s);
        small_end(&other.s);
    }
}

/* A piece begins with the substep size of its thread, not with one that its entry had before. */
static void piece_begins_with_substeps_of_its_thread(void **state)
{
    (void)state;
    resting r;
    uint32_t piece;
    begin(&r, 0);
    r.s.thread.cut_capacity = 1;
    uint32_t line =
        small_thread(&r.s, vec3_make(-0.01, 0.1, 0.0), vec3_make(0.01, 0.1, 0.0), 20, NULL);
    scene_object *s = small_object(&r.s);
    for (uint32_t i = 0; i < s->body_count; i++) {
        s->bodies[i].next_halvings = s->bodies[i].is_reserved ? 3 : 1;
    }
    expect_ok(vbss_scene_cut_thread(r.s.scene, line, 5.5e-3, &piece));
    assert_int_equal(vbss_scene_body(s, piece)->next_halvings, 1);
    small_end(&r.s);
}

int test_failed_steps(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(failure_after_end_of_suspended_step_comes_with_next_call),
        cmocka_unit_test(failed_step_leaves_pending_targets),
        cmocka_unit_test(failed_step_leaves_overlaps),
        cmocka_unit_test(edited_suspended_step_is_restored),
        cmocka_unit_test(piece_begins_with_substeps_of_its_thread),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
