/* How collision objects begin and end, what they show, and where their memory goes. */
#include <string.h>

#include "collision/shapes_model.h"
#include "collision/shapes_object.h"
#include "fixtures/shapes_body.h"

/* ---- the size protocols */

static vbss_result config_init(void *config, uint32_t struct_size)
{
    return vbss_collision_config_init(config, struct_size);
}

static vbss_result create_and_destroy(vbss_context *context, const void *config)
{
    vbss_collision *collision;
    VBSS_TRY(vbss_collision_create(context, config, &collision));
    return vbss_collision_destroy(collision);
}

static void config_size_protocol(void **state)
{
    (void)state;
    static const uint32_t sizes[] = {64, 0};
    const harness_config config = {sizes, config_init, create_and_destroy};
    harness_config_protocol(&config);
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    expect_ok(create_and_destroy(context, NULL)); /* the defaults */
    harness_context_end(context, &memory);
}

static void output_struct_size_protocol(void **state)
{
    (void)state;
    const uint32_t sizes[2] = {sizeof(vbss_view), 72};
    object_fixture f;
    object_begin(&f);
    for (int which = 0; which < 2; which++) {
        unsigned char out[256];
        uint32_t filled;
        expect_result(VBSS_ERROR_NULL_ARGUMENT,
                      object_write_out(f.collision, which, NULL, sizes[which]));
        for (uint32_t size = 0; size < sizes[which]; size++) {
            expect_result(VBSS_ERROR_STRUCT_SIZE, object_write_out(f.collision, which, out, size));
        }
        memset(out, 0xff, sizeof out);
        expect_ok(object_write_out(f.collision, which, out, 128));
        memcpy(&filled, out, sizeof filled);
        assert_int_equal(filled, sizes[which]);
        for (uint32_t i = 0; i < sizeof out; i++) {
            assert_true(i < sizes[which] || out[i] == (i < 128 ? 0 : 0xff));
        }
    }
    object_end(&f);
}

/* ---- handles */

static void every_call_rejects_invalid_handles(void **state)
{
    (void)state;
    object_fixture f;
    object_begin(&f);
    vbss_collision *destroyed = f.collision, *none = destroyed;
    expect_ok(vbss_collision_destroy(destroyed));
    harness_refuses_bad_handles(f.context, destroyed, object_calls, OBJECT_CALLS);
    expect_ok(vbss_collision_destroy(NULL));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_collision_destroy(destroyed));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_collision_create(NULL, NULL, &none));
    assert_null(none);
    expect_result(VBSS_ERROR_INVALID_HANDLE,
                  vbss_collision_create((vbss_context *)destroyed, NULL, &none));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_collision_create(f.context, NULL, NULL));
    object_end(&f);
}

/* ---- inside callbacks */

typedef struct listener {
    vbss_context *context;
    vbss_collision *collision;
    vbss_result results[OBJECT_CALLS], created, destroyed;
    int heard;
} listener;

static void listen(void *user, vbss_log_level level, const char *message)
{
    listener *l = user;
    vbss_collision *made = NULL;
    (void)level;
    (void)message;
    if (l->heard++ > 0) {
        return;
    }
    for (int i = 0; i < OBJECT_CALLS; i++) {
        l->results[i] = object_calls[i](l->collision);
    }
    l->created = vbss_collision_create(l->context, NULL, &made);
    l->destroyed = vbss_collision_destroy(l->collision);
}

static void calls_inside_callback_are_rejected(void **state)
{
    (void)state;
    listener l = {0};
    harness_memory memory;
    vbss_context_config config = harness_watched_config(&memory);
    config.log = listen;
    config.log_user = &l;
    expect_ok(vbss_context_create(&config, &l.context));
    l.collision = object_make(l.context, NULL);
    uint64_t before = object_hash(l.collision);
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_collision_remove(l.collision, 77));
    for (int i = 0; i < OBJECT_CALLS; i++) {
        expect_result(i < OBJECT_EDITS ? VBSS_ERROR_BUSY : VBSS_OK, l.results[i]);
    }
    expect_result(VBSS_ERROR_BUSY, l.created);
    expect_result(VBSS_ERROR_BUSY, l.destroyed);
    assert_true(object_hash(l.collision) == before);
    /* All of these work outside; the restore has nothing to read. */
    for (int i = 0; i < OBJECT_CALLS; i++) {
        expect_result(object_calls[i] == object_call_restore ? VBSS_ERROR_CORRUPT : VBSS_OK,
                      object_calls[i](l.collision));
    }
    harness_context_end(l.context, &memory);
}

/* Looks at the object whenever memory is given back. */
typedef struct watcher {
    harness_memory memory;
    vbss_context_config inner;
    vbss_collision *collision; /* NULL: nothing to look at */
    uint64_t hash;
} watcher;

static void *pass_allocate(void *user, uint64_t size, uint64_t alignment)
{
    watcher *w = user;
    return w->inner.allocate(w->inner.allocator_user, size, alignment);
}

static void release_and_hash(void *user, void *block, uint64_t size, uint64_t alignment)
{
    watcher *w = user;
    w->inner.deallocate(w->inner.allocator_user, block, size, alignment);
    if (w->collision != NULL) {
        w->hash = object_hash(w->collision);
    }
}

static void shape_is_removed_before_its_memory(void **state)
{
    (void)state;
    watcher w = {.collision = NULL};
    vbss_context *context;
    vbss_context_config config;
    expect_ok(vbss_context_config_init(&config, sizeof config));
    w.inner = harness_watched_config(&w.memory);
    config.allocate = pass_allocate;
    config.deallocate = release_and_hash;
    config.allocator_user = &w;
    expect_ok(vbss_context_create(&config, &context));
    vbss_collision *collision = w.collision = object_make(context, NULL);
    expect_ok(vbss_collision_remove(collision, OBJECT_MESH));
    assert_true(w.hash == object_hash(collision));
    w.collision = NULL;
    harness_context_end(context, &w.memory);
}

/* ---- memory */

static vbss_result live(vbss_context *context, void *user)
{
    const moving_shapes_options options = {20, true, true};
    moving_shapes scene;
    (void)user;
    VBSS_TRY(moving_shapes_create(context, &options, NULL, &scene));
    vbss_result result = moving_shapes_step(&scene);
    if (result == VBSS_OK) {
        result = vbss_collision_remove(scene.collision, 1);
    }
    VBSS_TRY(moving_shapes_destroy(&scene));
    return result;
}

static void each_failed_allocation_is_reported_without_leak(void **state)
{
    (void)state;
    harness_fail_every_allocation(live, NULL);
}

/* A shape for which there is no memory leaves the object as it was. */
static void shape_without_memory_changes_nothing(void **state)
{
    (void)state;
    object_fixture f;
    object_begin(&f);
    for (int which = 0; which < 3; which++) {
        for (uint64_t call = 1; call < 100; call++) {
            uint64_t hash = object_hash(f.collision), blocks = f.memory.blocks;
            f.memory.fail_call = f.memory.calls + call;
            vbss_result result = object_calls[which](f.collision);
            f.memory.fail_call = 0;
            if (result == VBSS_OK) {
                assert_true(call > 5);
                break;
            }
            expect_result(VBSS_ERROR_OUT_OF_MEMORY, result);
            assert_true(object_hash(f.collision) == hash);
            assert_int_equal(f.memory.blocks, blocks);
        }
    }
    object_end(&f);
}

static void searches_and_tests_do_not_allocate(void **state)
{
    (void)state;
    moving_shapes_options options = {60, true, true};
    const harness_body body = shapes_body(&options);
    assert_int_equal(harness_step_allocations(&body, 50), 0);
}

static void shape_churn_does_not_grow_memory(void **state)
{
    (void)state;
    object_fixture f;
    object_begin(&f);
    uint64_t blocks = f.memory.blocks;
    for (uint32_t i = 0; i < 4; i++) {
        expect_ok(object_calls[i % 3](f.collision));
        expect_ok(vbss_collision_remove(f.collision, OBJECT_SHAPES + i));
        assert_int_equal(f.memory.blocks, blocks);
    }
    object_end(&f);
}

/* ---- names and edges */

static void shape_names_are_never_reused(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_collision_config config;
    vbss_collision *collision;
    uint32_t name = 99;
    expect_ok(vbss_collision_config_init(&config, sizeof config));
    config.shape_capacity = 3;
    expect_ok(vbss_collision_create(context, &config, &collision));
    for (uint32_t i = 0; i < 3; i++) {
        expect_ok(vbss_collision_add_capsules(collision, 1 + i, 0.1, &name));
        assert_int_equal(name, i);
        expect_ok(vbss_collision_remove(collision, name));
        expect_result(VBSS_ERROR_NOT_FOUND, vbss_collision_remove(collision, name));
    }
    expect_result(VBSS_ERROR_CAPACITY, vbss_collision_add_capsules(collision, 1, 0.1, &name));
    assert_int_equal(name, 2);
    harness_context_end(context, &memory);
}

static void expect_edges(vbss_collision *collision, uint32_t shape, const uint32_t (*wanted)[2],
                         uint32_t count)
{
    uint32_t nodes[2];
    for (uint32_t i = 0; i < count; i++) {
        expect_ok(vbss_collision_get_edge(collision, shape, i, nodes));
        assert_memory_equal(nodes, wanted[i], sizeof nodes);
    }
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_collision_get_edge(collision, shape, count, nodes));
    expect_result(VBSS_ERROR_OUT_OF_RANGE,
                  vbss_collision_get_edge(collision, shape, UINT32_MAX, nodes));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_collision_get_edge(collision, shape, 0, NULL));
}

static void edge_numbers_match_documentation(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_collision *collision;
    uint32_t shape;
    /* Three triangles at the edge 1 2, one of them twice; node 0 is of none. */
    const uint32_t triangles[] = {5, 2, 1, 1, 2, 3, 4, 2, 1, 2, 1, 5};
    const uint32_t chain[][2] = {{0, 1}, {1, 2}, {2, 3}}, capsules[][2] = {{0, 1}, {2, 3}};
    const uint32_t mesh[][2] = {{1, 2}, {1, 3}, {1, 4}, {1, 5}, {2, 3}, {2, 4}, {2, 5}};
    expect_ok(vbss_collision_create(context, NULL, &collision));
    expect_ok(vbss_collision_add_chain(collision, 4, NULL, 0.1, &shape));
    expect_edges(collision, shape, chain, 3);
    expect_ok(vbss_collision_add_capsules(collision, 2, 0.1, &shape));
    expect_edges(collision, shape, capsules, 2);
    expect_ok(vbss_collision_add_mesh(collision, 6, triangles, 4, 0.1, &shape));
    expect_edges(collision, shape, mesh, 7);
    harness_context_end(context, &memory);
}

int test_object(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(config_size_protocol),
        cmocka_unit_test(output_struct_size_protocol),
        cmocka_unit_test(every_call_rejects_invalid_handles),
        cmocka_unit_test(calls_inside_callback_are_rejected),
        cmocka_unit_test(shape_is_removed_before_its_memory),
        cmocka_unit_test(each_failed_allocation_is_reported_without_leak),
        cmocka_unit_test(shape_without_memory_changes_nothing),
        cmocka_unit_test(searches_and_tests_do_not_allocate),
        cmocka_unit_test(shape_churn_does_not_grow_memory),
        cmocka_unit_test(shape_names_are_never_reused),
        cmocka_unit_test(edge_numbers_match_documentation),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
