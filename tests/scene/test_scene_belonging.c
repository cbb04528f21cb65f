/* Whose a thread is, and in which order scenes, threads and contexts may end. */
#include "scene/small.h"

static const vbss_capsule ball = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 1e-3};

typedef struct saved {
    uint8_t bytes[16384];
    uint64_t count;
} saved;

static void expect_owned(vbss_thread *thread, const saved *state, bool owned)
{
    vbss_result wanted = owned ? VBSS_ERROR_IN_SCENE : VBSS_OK;
    vbss_thread *piece = thread;
    uint64_t hash, after;
    expect_ok(vbss_thread_get_hash(thread, &hash));
    expect_result(wanted, vbss_thread_step(thread, 1e-3));
    expect_result(wanted, vbss_thread_restore(thread, state->bytes, state->count));
    if (owned) {
        expect_result(wanted, vbss_thread_cut(thread, 5e-3, &piece));
        assert_null(piece);
        expect_result(wanted, vbss_thread_destroy(thread));
        expect_ok(vbss_thread_get_hash(thread, &after));
        assert_true(hash == after);
    }
}

static void look_and_attach(vbss_thread *thread)
{
    vbss_thread_attachment a;
    vbss_thread_statistics statistics;
    uint32_t id;
    const double there[3] = {0.0, 1e-4, 0.0}, velocities[18] = {0.0};
    expect_ok(vbss_thread_attachment_init(&a, sizeof a));
    expect_ok(vbss_thread_attach(thread, &a, &id));
    expect_ok(vbss_thread_move(thread, id, there, NULL));
    expect_ok(vbss_thread_detach(thread, id));
    expect_ok(vbss_thread_set_state(thread, NULL, velocities, 6));
    expect_ok(vbss_thread_get_statistics(thread, &statistics, sizeof statistics));
    assert_int_equal(statistics.struct_size, sizeof statistics);
}

static void thread_belongs_to_scene_until_removed(void **state)
{
    (void)state;
    for (int end = 0; end < 2; end++) {
        small s;
        saved kept;
        vbss_thread *thread, *piece;
        uint32_t body = 77;
        vbss_scene *other;
        small_begin_scene(&s);
        expect_ok(vbss_scene_create(s.context, &s.config, &other));
        s.thread.cut_capacity = 1;
        uint32_t number = small_thread(&s, vec3_zero(), vec3_make(0.01, 0.0, 0.0), 5, &thread);
        expect_ok(vbss_thread_save(thread, kept.bytes, sizeof kept.bytes, &kept.count));
        expect_owned(thread, &kept, true);
        look_and_attach(thread);
        expect_result(VBSS_ERROR_IN_SCENE, vbss_scene_add_thread(s.scene, thread, &body));
        expect_result(VBSS_ERROR_IN_SCENE, vbss_scene_add_thread(other, thread, &body));
        assert_int_equal(body, 77);
        small_steps(&s, 2, 1e-3);
        expect_owned(thread, &kept, true);
        if (end == 0) {
            expect_ok(vbss_scene_remove(s.scene, number));
        } else {
            expect_ok(vbss_scene_destroy(s.scene));
        }
        expect_owned(thread, &kept, false);
        look_and_attach(thread);
        expect_ok(vbss_scene_add_thread(other, thread, &body)); /* and somebody else's */
        expect_owned(thread, &kept, true);
        expect_ok(vbss_scene_step(other, 1e-3));
        expect_ok(vbss_scene_remove(other, body));
        expect_ok(vbss_thread_cut(thread, 5e-3, &piece));
        expect_ok(vbss_thread_destroy(thread));
        small_end(&s);
    }
}

static void thread_of_other_context_is_rejected(void **state)
{
    (void)state;
    small s, other;
    uint32_t body = 77;
    vbss_thread *thread;
    small_begin_scene(&s);
    small_begin(&other);
    expect_ok(vbss_thread_create(other.context, &other.thread, &thread));
    uint64_t hash = small_hash(&s);
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_scene_add_thread(s.scene, thread, &body));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_scene_add_thread(s.scene, NULL, &body));
    expect_result(VBSS_ERROR_INVALID_HANDLE,
                  vbss_scene_add_thread(s.scene, (vbss_thread *)s.scene, &body));
    assert_int_equal(body, 77);
    assert_true(small_hash(&s) == hash);
    expect_ok(vbss_thread_step(thread, 1e-3)); /* it is as free as before */
    small_end(&other);
    small_end(&s);
}

/* ---- ends, in any order */

static void context_end_destroys_in_any_order(void **state)
{
    (void)state;
    for (int order = 0; order < 16; order++) {
        small s;
        vbss_thread *before, *after;
        uint32_t body;
        small_begin(&s);
        s.thread.segment_count = 20;
        expect_ok(vbss_thread_create(s.context, &s.thread, &before));
        small_create(&s);
        expect_ok(vbss_thread_create(s.context, &s.thread, &after));
        small_capsule(&s, VBSS_RIGID_FREE, vec3_zero(), vec3_zero(), 1e-3);
        if ((order & 1) != 0) {
            expect_ok(vbss_scene_add_thread(s.scene, before, &body));
        }
        if ((order & 2) != 0) {
            expect_ok(vbss_scene_add_thread(s.scene, after, &body));
        }
        if (order != 0) {
            small_steps(&s, 1, 1e-3);
        }
        if ((order & 4) != 0) {
            expect_ok(vbss_scene_destroy(s.scene));
        }
        if ((order & 4) != 0 && (order & 8) != 0) {
            expect_ok(vbss_thread_destroy(after));
        }
        small_end(&s);
    }
}

static void scene_churn_does_not_grow_memory(void **state)
{
    (void)state;
    small s;
    uint64_t blocks = 0;
    vbss_thread *thread;
    small_begin(&s);
    expect_ok(vbss_thread_create(s.context, &s.thread, &thread));
    for (int i = 0; i < 12; i++) {
        uint32_t body;
        small_create(&s);
        expect_ok(vbss_scene_add_thread(s.scene, thread, &body));
        small_capsule(&s, VBSS_RIGID_DRIVEN, vec3_zero(), vec3_zero(), 1e-3);
        expect_ok(vbss_scene_destroy(s.scene));
        blocks = i == 0 ? s.memory.blocks : blocks;
        assert_int_equal(s.memory.blocks, blocks);
    }
    small_end(&s);
}

/* Numbers are never used again, places are. */
static void removed_bodies_free_capacity(void **state)
{
    (void)state;
    small s;
    small_begin(&s);
    s.config.rigid_capacity = 2;
    s.config.capsule_capacity = 2;
    s.config.thread_capacity = 1;
    s.config.node_capacity = 6;
    small_create(&s);
    uint32_t last = 0;
    for (int i = 0; i < 50; i++) {
        vbss_thread *thread;
        uint32_t refused;
        vec3 high = vec3_make(0.0, 0.01, 0.0);
        uint32_t a = small_capsule(&s, VBSS_RIGID_FREE, high, high, 1e-3);
        uint32_t t = small_thread(&s, vec3_zero(), vec3_make(0.01, 0.0, 0.0), 5, &thread);
        uint32_t b = small_capsule(&s, VBSS_RIGID_DRIVEN, vec3_scale(high, 2.0), high, 1e-3);
        assert_true(last < a && a < t && t < b);
        last = b;
        s.rigid.capsules = &ball;
        expect_result(VBSS_ERROR_CAPACITY, vbss_scene_add_rigid(s.scene, &s.rigid, &refused));
        small_steps(&s, 1, 1e-3);
        expect_ok(vbss_scene_remove(s.scene, i % 2 == 0 ? a : b));
        expect_ok(vbss_scene_remove(s.scene, t));
        small_steps(&s, 1, 1e-3);
        expect_ok(vbss_scene_remove(s.scene, i % 2 == 0 ? b : a));
        expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_scene_remove(s.scene, a));
        expect_ok(vbss_thread_destroy(thread));
    }
    small_end(&s);
}

int test_scene_belonging(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(thread_belongs_to_scene_until_removed),
        cmocka_unit_test(thread_of_other_context_is_rejected),
        cmocka_unit_test(context_end_destroys_in_any_order),
        cmocka_unit_test(scene_churn_does_not_grow_memory),
        cmocka_unit_test(removed_bodies_free_capacity),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
