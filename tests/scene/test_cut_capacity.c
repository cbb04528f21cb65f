/* What cuts need is taken when a thread is added, and comes back: room, handles, memory, whoever ends first. */
#include "base/error.h"
#include "scene/cut_rig.h"

static vbss_thread *thread_of(small *s, uint32_t segments, uint32_t cuts)
{
    vbss_thread *thread;
    s->thread.segment_count = segments;
    s->thread.length = 1e-3 * segments;
    s->thread.cut_capacity = cuts;
    expect_ok(vbss_thread_create(s->context, &s->thread, &thread));
    return thread;
}

static void thread_needs_capacity_for_its_pieces(void **state)
{
    (void)state;
    small s;
    uint32_t body = 77;
    small_begin(&s);
    s.config.thread_capacity = 4;
    s.config.node_capacity = 40;
    small_create(&s);
    vbss_thread *many = thread_of(&s, 5, 4), *three = thread_of(&s, 5, 3),
                *one = thread_of(&s, 5, 0);
    vbss_thread *long_one = thread_of(&s, 36, 2), *fits = thread_of(&s, 35, 2);
    uint64_t hash = small_hash(&s);
    expect_result(VBSS_ERROR_CAPACITY, vbss_scene_add_thread(s.scene, many, &body));
    expect_result(VBSS_ERROR_CAPACITY, vbss_scene_add_thread(s.scene, long_one, &body));
    assert_int_equal(body, 77);
    assert_true(small_hash(&s) == hash);
    for (int again = 0; again < 3; again++) {
        uint32_t other = 77;
        expect_ok(vbss_scene_add_thread(s.scene, three, &body));
        expect_result(VBSS_ERROR_CAPACITY, vbss_scene_add_thread(s.scene, one, &other));
        small_steps(&s, 1, 1e-3);
        expect_ok(vbss_scene_remove(s.scene, body));
        expect_ok(vbss_scene_add_thread(s.scene, one, &body)); /* the room is back */
        expect_result(VBSS_ERROR_CAPACITY, vbss_scene_add_thread(s.scene, three, &other));
        expect_ok(vbss_scene_remove(s.scene, body));
        expect_ok(vbss_scene_add_thread(s.scene, fits, &body));
        expect_result(VBSS_ERROR_CAPACITY, vbss_scene_add_thread(s.scene, one, &other));
        (void)cut_at(&s, body, 10.5e-3, NULL); /* all nodes are used then */
        (void)cut_at(&s, body, 5.5e-3, NULL);
        assert_int_equal(small_object(&s)->node_count, 40);
        small_steps(&s, 1, 1e-3);
        assert_int_equal(other, 77);
        for (uint32_t number = body; number < body + 3; number++) {
            expect_ok(vbss_scene_remove(s.scene, number));
        }
        fits = thread_of(&s, 35, 2);
        assert_int_equal(small_object(&s)->node_count, 0);
    }
    small_end(&s);
}

static void cut_above_capacity_only_emits_event(void **state)
{
    (void)state;
    small s;
    vbss_thread *thread;
    vbss_scene_event event;
    uint32_t piece = 77;
    small_begin_scene(&s);
    s.thread.cut_capacity = 1;
    uint32_t body = small_thread(&s, vec3_zero(), vec3_make(0.02, 0.0, 0.0), 20, &thread);
    uint32_t first = cut_at(&s, body, 0.0105, NULL);
    small_steps(&s, 2, 1e-3);
    uint64_t hash = small_hash(&s);
    const uint32_t bodies[] = {body, first};
    for (int k = 0; k < 2; k++) {
        expect_result(VBSS_ERROR_CAPACITY,
                      vbss_scene_cut_thread(s.scene, bodies[k], 4.5e-3, &piece));
        assert_int_equal(small_events(&s, VBSS_SCENE_EVENT_CUT, &event), k + 1);
        assert_int_equal(event.body_a, bodies[k]);
        assert_int_equal(event.body_b, 0);
        expect_near(4.5e-3, event.arc_length, 1e-9);
    }
    assert_int_equal(piece, 77);
    assert_true(small_hash(&s) == hash);
    small_steps(&s, 2, 1e-3);
    assert_int_equal(small_events(&s, VBSS_SCENE_EVENT_CUT, &event), 0);
    small_end(&s);
}

static void cut_events_above_capacity_are_counted(void **state)
{
    (void)state;
    small s;
    small_begin(&s);
    s.config.event_capacity = 2;
    small_create(&s);
    s.thread.cut_capacity = 5;
    vbss_scene_event event;
    uint32_t body = small_thread(&s, vec3_zero(), vec3_make(0.02, 0.0, 0.0), 20, NULL);
    for (uint32_t k = 1; k <= 5; k++) {
        (void)cut_at(&s, body, 0.0185 - 2e-3 * k, NULL);
        assert_int_equal(small_events(&s, VBSS_SCENE_EVENT_CUT, &event), k <= 2 ? k : 2);
        assert_int_equal(small_object(&s)->events.lost, k <= 2 ? 0 : k - 2);
    }
    small_end(&s);
}

/* A short part was there first, and has taken what cuts need. */
static void longer_family_parts_may_be_added_later(void **state)
{
    (void)state;
    small s;
    vbss_thread *shorter = NULL, *longer;
    uint32_t bodies[2];
    small_begin_scene(&s);
    longer = thread_of(&s, 40, 3);
    expect_ok(vbss_thread_cut(longer, 35.5e-3, &shorter));
    expect_ok(vbss_scene_add_thread(s.scene, shorter, &bodies[0]));
    expect_ok(vbss_scene_add_thread(s.scene, longer, &bodies[1]));
    for (int k = 0; k < 2; k++) { /* both pieces are nearly all of it */
        bodies[1] = cut_at(&s, bodies[1], 0.5e-3, NULL);
        cut_expect_sound(small_object(&s));
        small_steps(&s, 3, 1e-3);
    }
    small_end(&s);
}

/* ---- leaving */

static void pieces_are_removed_like_threads(void **state)
{
    (void)state;
    for (int order = 0; order < 6; order++) {
        static const int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                         {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
        small s;
        vbss_thread *threads[3], *alone;
        uint32_t bodies[3], again;
        small_begin_scene(&s);
        s.thread.cut_capacity = 4;
        bodies[0] = small_thread(&s, vec3_zero(), vec3_make(0.02, 0.0, 0.0), 20, &threads[0]);
        bodies[1] = cut_at(&s, bodies[0], 0.0105, &threads[1]);
        bodies[2] = cut_at(&s, bodies[1], 5e-3, &threads[2]);
        small_steps(&s, 2, 1e-3);
        for (int i = 0; i < 3; i++) {
            int k = orders[order][i];
            expect_ok(vbss_scene_remove(s.scene, bodies[k]));
            expect_ok(vbss_thread_step(threads[k], 1e-3)); /* the host's */
            cut_expect_sound(small_object(&s));
            small_steps(&s, 2, 1e-3);
            /* The cuts left stay with who is left in the scene, and come along in the end. */
            double half = 0.5 * cut_length(((vbss_slot *)threads[k])->object);
            expect_result(i < 2 ? VBSS_ERROR_CAPACITY : VBSS_OK,
                          vbss_thread_cut(threads[k], half, &alone));
        }
        expect_ok(vbss_scene_add_thread(s.scene, threads[1], &again));
        (void)cut_at(&s, again, 0.4 * cut_length(((vbss_slot *)threads[1])->object), NULL);
        small_steps(&s, 2, 1e-3);
        expect_ok(vbss_scene_destroy(s.scene));
        expect_ok(vbss_thread_step(threads[1], 1e-3));
        expect_result(VBSS_ERROR_CAPACITY, vbss_thread_cut(threads[1], 0.4e-3, &alone));
        for (int i = 0; i < 3; i++) {
            expect_ok(vbss_thread_destroy(threads[i]));
        }
        small_end(&s);
    }
}

static void scenes_with_pieces_end_in_any_order(void **state)
{
    (void)state;
    for (int order = 0; order < 8; order++) {
        small s;
        vbss_thread *thread, *piece;
        uint32_t body;
        small_begin(&s);
        if ((order & 1) != 0) { /* the context ends objects in the order opposite to their making */
            thread = thread_of(&s, 20, 3);
            small_create(&s);
        } else {
            small_create(&s);
            thread = thread_of(&s, 20, 3);
        }
        expect_ok(vbss_scene_add_thread(s.scene, thread, &body));
        (void)cut_at(&s, body, 0.0105, &piece);
        if ((order & 2) != 0) {
            expect_ok(vbss_scene_remove(s.scene, body));
            expect_ok(vbss_thread_destroy(thread));
            small_steps(&s, 1, 1e-3);
            (void)cut_at(&s, body + 1, 3e-3, NULL); /* of a family whose first is gone */
        }
        if ((order & 4) != 0) {
            expect_ok(vbss_scene_destroy(s.scene));
            expect_ok(vbss_thread_destroy(piece));
        }
        small_end(&s);
    }
}

/* ---- memory */

static vbss_result attempt(vbss_context *context, void *user)
{
    const vbss_scene_config *config = user;
    vbss_scene *scene;
    vbss_thread_config own;
    vbss_thread *thread = NULL, *handle = NULL;
    uint32_t body, piece;
    VBSS_TRY(vbss_thread_config_init(&own, sizeof own));
    own.segment_count = 6;
    own.cut_capacity = 2;
    VBSS_TRY(vbss_scene_create(context, config, &scene));
    vbss_result result = vbss_thread_create(context, &own, &thread);
    if (result == VBSS_OK) {
        result = vbss_scene_add_thread(scene, thread, &body);
        if (result != VBSS_OK) { /* it is as free as before */
            vbss_thread *alone;
            expect_ok(vbss_thread_step(thread, 1e-3));
            expect_ok(vbss_thread_cut(thread, 0.07, &alone));
            expect_ok(vbss_scene_step(scene, 1e-3));
            expect_ok(vbss_thread_destroy(alone));
        }
    }
    if (result == VBSS_OK) {
        result = vbss_scene_cut_thread(scene, body, 0.07, &piece);
        expect_ok(vbss_scene_get_thread(scene, piece, &handle));
    }
    if (result == VBSS_OK) {
        result = vbss_scene_step(scene, 1e-3);
    }
    VBSS_TRY(vbss_scene_destroy(scene));
    VBSS_TRY(vbss_thread_destroy(handle));
    VBSS_TRY(vbss_thread_destroy(thread));
    return result;
}

static void each_failed_allocation_is_reported_without_leak(void **state)
{
    (void)state;
    vbss_scene_config config;
    expect_ok(vbss_scene_config_init(&config, sizeof config));
    config.node_capacity = 30;
    config.contact_capacity = config.candidate_capacity = 16;
    harness_fail_every_allocation(attempt, &config);
}

int test_cut_capacity(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(thread_needs_capacity_for_its_pieces),
        cmocka_unit_test(cut_above_capacity_only_emits_event),
        cmocka_unit_test(cut_events_above_capacity_are_counted),
        cmocka_unit_test(longer_family_parts_may_be_added_later),
        cmocka_unit_test(pieces_are_removed_like_threads),
        cmocka_unit_test(scenes_with_pieces_end_in_any_order),
        cmocka_unit_test(each_failed_allocation_is_reported_without_leak),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
