/* Whose a drain is, in which order scenes, drains and contexts may end, and what is refused. */
#include "scene/small.h"

static void expect_owned(vbss_drain *drain, bool owned)
{
    static uint8_t bytes[1u << 16];
    vbss_result wanted = owned ? VBSS_ERROR_IN_SCENE : VBSS_OK;
    uint64_t count, hash, after;
    expect_ok(vbss_drain_save(drain, bytes, sizeof bytes, &count));
    expect_ok(vbss_drain_get_hash(drain, &hash));
    expect_result(wanted, vbss_drain_step(drain, 1e-3));
    expect_result(wanted, vbss_drain_restore(drain, bytes, count));
    if (owned) {
        expect_result(wanted, vbss_drain_destroy(drain));
    }
    expect_ok(vbss_drain_get_hash(drain, &after));
    assert_true(hash == after);
}

static void look_and_attach(vbss_drain *drain)
{
    vbss_drain_attachment a;
    vbss_drain_places places;
    vbss_drain_gap gap;
    vbss_drain_energies energies;
    vbss_drain_statistics statistics;
    vbss_view view;
    uint32_t id;
    double there[3], force[3];
    expect_ok(vbss_drain_get_places(drain, &places, sizeof places));
    for (int32_t field = VBSS_DRAIN_POSITIONS; field <= VBSS_DRAIN_CURVATURES; field++) {
        expect_ok(vbss_drain_get_view(drain, field, &view, sizeof view));
    }
    expect_ok(vbss_drain_get_view(drain, VBSS_DRAIN_POSITIONS, &view, sizeof view));
    expect_ok(vbss_drain_attachment_init(&a, sizeof a));
    a.node = places.marks[0];
    memcpy(there, (const char *)view.data + (size_t)a.node * view.stride_bytes, sizeof there);
    memcpy(a.position, there, sizeof there);
    expect_ok(vbss_drain_attach(drain, &a, &id));
    expect_ok(vbss_drain_move(drain, id, there));
    expect_ok(vbss_drain_get_reaction(drain, id, force));
    expect_ok(vbss_drain_detach(drain, id));
    expect_ok(vbss_drain_set_state(drain, (const double *)view.data, NULL, places.node_count));
    expect_ok(vbss_drain_get_gap(drain, &gap, sizeof gap));
    expect_ok(vbss_drain_get_energies(drain, &energies, sizeof energies));
    expect_ok(vbss_drain_get_statistics(drain, &statistics, sizeof statistics));
    assert_int_equal(statistics.struct_size, sizeof statistics);
}

static void drain_belongs_to_scene_until_removed(void **state)
{
    (void)state;
    for (int end = 0; end < 2; end++) {
        small s;
        vbss_drain *drain;
        vbss_scene *other;
        uint32_t body = 77;
        small_begin_scene(&s);
        s.config.drain_capacity = 2;
        expect_ok(vbss_scene_create(s.context, &s.config, &other));
        uint32_t number = small_drain(&s, &drain);
        assert_int_equal(number, 1);
        expect_owned(drain, true);
        look_and_attach(drain);
        expect_result(VBSS_ERROR_IN_SCENE, vbss_scene_add_drain(other, drain, &body));
        expect_result(VBSS_ERROR_IN_SCENE, vbss_scene_add_drain(s.scene, drain, &body));
        assert_int_equal(body, 77);
        small_steps(&s, 2, 1e-3);
        expect_owned(drain, true);
        if (end == 0) {
            expect_ok(vbss_scene_remove(s.scene, number));
            expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_scene_remove(s.scene, number));
        } else {
            expect_ok(vbss_scene_destroy(s.scene));
        }
        expect_ok(vbss_drain_step(drain, 1e-3));
        look_and_attach(drain);
        expect_ok(vbss_scene_add_drain(other, drain, &body)); /* and somebody else's */
        expect_owned(drain, true);
        expect_ok(vbss_scene_step(other, 1e-3));
        expect_ok(vbss_scene_remove(other, body));
        expect_ok(vbss_drain_destroy(drain));
        small_end(&s);
    }
}

/* ---- refused, and nothing has changed */

static void expect_refused(small *s, vbss_result wanted, vbss_drain *drain)
{
    uint32_t body = 77;
    const char *text;
    uint64_t hash = small_hash(s), generation = small_view(s, VBSS_SCENE_VIEW_EVENTS).generation;
    uint64_t blocks = s->memory.blocks;
    expect_result(wanted, vbss_scene_add_drain(s->scene, drain, &body));
    expect_ok(vbss_context_get_last_error(s->context, NULL, &text));
    assert_true(strlen(text) > 0);
    assert_int_equal(body, 77);
    assert_int_equal(s->memory.blocks, blocks);
    assert_true(small_hash(s) == hash);
    assert_true(small_view(s, VBSS_SCENE_VIEW_EVENTS).generation == generation);
}

static void invalid_drain_is_rejected(void **state)
{
    (void)state;
    small s, other;
    vbss_drain *foreign, *drain, *gone;
    uint32_t body = 77;
    small_begin_scene(&s);
    small_begin(&other);
    expect_ok(vbss_drain_create(other.context, &other.drain, &foreign));
    expect_ok(vbss_drain_create(s.context, &s.drain, &drain));
    expect_ok(vbss_drain_create(s.context, &s.drain, &gone));
    expect_ok(vbss_drain_destroy(gone));
    expect_refused(&s, VBSS_ERROR_INVALID_HANDLE, foreign);
    expect_refused(&s, VBSS_ERROR_INVALID_HANDLE, gone);
    expect_refused(&s, VBSS_ERROR_INVALID_HANDLE, (vbss_drain *)s.scene);
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_scene_add_drain(s.scene, NULL, &body));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_scene_add_drain(NULL, drain, &body));
    expect_result(VBSS_ERROR_INVALID_HANDLE,
                  vbss_scene_add_drain((vbss_scene *)drain, drain, &body));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_scene_add_drain(s.scene, drain, NULL));
    assert_int_equal(body, 77);
    vbss_drain *papers;
    s.drain.method = VBSS_METHOD_PAPER;
    expect_ok(vbss_drain_create(s.context, &s.drain, &papers));
    expect_refused(&s, VBSS_ERROR_OUT_OF_RANGE, papers);
    /* All of them are as free as before. */
    expect_ok(vbss_drain_step(foreign, 1e-3));
    expect_ok(vbss_drain_step(drain, 1e-3));
    expect_ok(vbss_drain_step(papers, 1e-3));
    small_end(&other);
    small_end(&s);
}

static void drain_needs_capacity(void **state)
{
    (void)state;
    for (uint32_t capacity = 0; capacity <= 3; capacity++) {
        small s;
        vbss_drain *one_more;
        uint32_t bodies[3];
        small_begin(&s);
        s.config.drain_capacity = capacity;
        small_create(&s);
        for (uint32_t i = 0; i < capacity; i++) {
            s.drain.position[0] = 0.05 * i;
            bodies[i] = small_drain(&s, NULL);
        }
        s.drain.position[0] = 0.05 * capacity;
        expect_ok(vbss_drain_create(s.context, &s.drain, &one_more));
        expect_refused(&s, VBSS_ERROR_CAPACITY, one_more);
        small_steps(&s, 2, 1e-3);
        expect_refused(&s, VBSS_ERROR_CAPACITY, one_more);
        if (capacity > 0) {
            expect_ok(vbss_scene_remove(s.scene, bodies[0]));
            expect_ok(vbss_scene_add_drain(s.scene, one_more, &bodies[0]));
            assert_int_equal(bodies[0], capacity + 1);
            small_steps(&s, 2, 1e-3);
        }
        small_end(&s);
    }
}

/* A drain is neither a thread nor a tool. */
static void calls_about_other_bodies_are_rejected(void **state)
{
    (void)state;
    small s;
    vbss_rigid_state rigid;
    vbss_thread *thread = NULL;
    vbss_grasp grasp;
    uint32_t pin = 77;
    const double zero[3] = {0.0, 0.0, 0.0};
    small_begin_scene(&s);
    uint32_t drain = small_drain(&s, NULL);
    uint32_t line = small_thread(&s, vec3_make(0.0, 0.1, 0.0), vec3_make(0.01, 0.1, 0.0), 5, NULL);
    uint64_t hash = small_hash(&s);
    expect_result(VBSS_ERROR_OUT_OF_RANGE,
                  vbss_scene_get_rigid(s.scene, drain, &rigid, sizeof rigid));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_scene_move_rigid(s.scene, drain, zero, NULL));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_scene_get_thread(s.scene, drain, &thread));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_scene_cut_thread(s.scene, drain, 5e-3, &pin));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_scene_pin_thread(s.scene, drain, 0, 0, NULL, &pin));
    expect_result(VBSS_ERROR_OUT_OF_RANGE,
                  vbss_scene_pin_thread(s.scene, line, 0, drain, NULL, &pin));
    expect_result(VBSS_ERROR_OUT_OF_RANGE,
                  vbss_scene_get_grasp(s.scene, drain, 0, &grasp, sizeof grasp));
    assert_int_equal(pin, 77);
    assert_true(small_hash(&s) == hash);
    small_end(&s);
}

/* ---- ends, in any order */

static void context_end_destroys_in_any_order(void **state)
{
    (void)state;
    for (int order = 0; order < 16; order++) {
        small s;
        vbss_drain *before, *after;
        uint32_t body;
        small_begin(&s);
        s.config.drain_capacity = 2;
        expect_ok(vbss_drain_create(s.context, &s.drain, &before));
        small_create(&s);
        s.drain.position[1] = 0.05;
        expect_ok(vbss_drain_create(s.context, &s.drain, &after));
        if ((order & 1) != 0) {
            expect_ok(vbss_scene_add_drain(s.scene, before, &body));
        }
        if ((order & 2) != 0) {
            expect_ok(vbss_scene_add_drain(s.scene, after, &body));
        }
        small_steps(&s, 1, 1e-3);
        if ((order & 4) != 0) {
            expect_ok(vbss_scene_destroy(s.scene));
            expect_ok(vbss_drain_step(before, 1e-3));
        }
        if ((order & 4) != 0 && (order & 8) != 0) {
            expect_ok(vbss_drain_destroy(after));
        }
        small_end(&s);
    }
}

/* ---- inside a callback */

typedef struct listener {
    vbss_scene *scene;
    vbss_drain *drain;
    vbss_result added, removed;
    int heard;
} listener;

static void listen(void *user, vbss_log_level level, const char *message)
{
    listener *l = user;
    uint32_t body = 0;
    (void)level;
    (void)message;
    l->heard++;
    l->added = vbss_scene_add_drain(l->scene, l->drain, &body);
    l->removed = vbss_scene_remove(l->scene, 1);
}

static void calls_inside_callback_are_rejected(void **state)
{
    (void)state;
    small s;
    listener l = {0};
    small_begin(&s);
    expect_ok(vbss_context_destroy(s.context));
    vbss_context_config config = harness_watched_config(&s.memory);
    config.log = listen;
    config.log_user = &l;
    expect_ok(vbss_context_create(&config, &s.context));
    s.config.drain_capacity = 2;
    small_create(&s);
    small_drain(&s, NULL);
    s.drain.position[1] = 0.05;
    expect_ok(vbss_drain_create(s.context, &s.drain, &l.drain));
    l.scene = s.scene;
    uint64_t hash = small_hash(&s);
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_scene_step(s.scene, 1.0));
    assert_int_equal(l.heard, 1);
    expect_result(VBSS_ERROR_BUSY, l.added);
    expect_result(VBSS_ERROR_BUSY, l.removed);
    assert_true(small_hash(&s) == hash);
    expect_ok(vbss_drain_step(l.drain, 1e-3));
    small_end(&s);
}

int test_drains_belonging(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(drain_belongs_to_scene_until_removed),
        cmocka_unit_test(invalid_drain_is_rejected),
        cmocka_unit_test(drain_needs_capacity),
        cmocka_unit_test(calls_about_other_bodies_are_rejected),
        cmocka_unit_test(context_end_destroys_in_any_order),
        cmocka_unit_test(calls_inside_callback_are_rejected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
