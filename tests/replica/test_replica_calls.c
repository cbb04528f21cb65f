/* Calls on a replica: handles, structs, fields, a second reader, memory. */
#include "rig.h"

#include <string.h>

#include "base/error.h"
#include "fixtures/tool_run.h"
#include "replica/replica.h"

typedef struct fixture {
    harness_memory memory;
    vbss_context *context;
    tool_run run;
    vbss_replica *replica;
} fixture;

static void begin(fixture *f)
{
    f->context = harness_context(&f->memory);
    expect_ok(tool_run_create(f->context, VBSS_METHOD_IMPLICIT, &f->run));
    expect_ok(vbss_replica_create(f->run.scene, NULL, &f->replica));
}

static void end(fixture *f)
{
    harness_context_end(f->context, &f->memory);
}

/* ---- handles */

static vbss_scene *scene; /* alive in the context under test */

static vbss_result call_publish(void *r)
{
    return vbss_replica_publish(r, scene);
}
static vbss_result call_destroy(void *r)
{
    return r == NULL ? VBSS_ERROR_INVALID_HANDLE : vbss_replica_destroy(r);
}
static vbss_result call_take(void *r)
{
    return vbss_replica_take(r, NULL, 0);
}
static vbss_result call_view(void *r)
{
    vbss_view view;
    return vbss_replica_get_view(r, VBSS_REPLICA_VIEW_NODES, &view, sizeof view);
}

static void every_call_rejects_invalid_handles(void **state)
{
    (void)state;
    const harness_handle_call writes[] = {call_publish, call_destroy},
                              reads[] = {call_take, call_view};
    fixture f;
    begin(&f);
    scene = f.run.scene;
    vbss_replica *none = f.replica;
    expect_ok(vbss_replica_destroy(f.replica));
    expect_ok(vbss_replica_destroy(NULL));
    harness_refuses_bad_handles(f.context, f.replica, writes, 2);
    for (int i = 0; i < 2; i++) {
        expect_result(VBSS_ERROR_INVALID_HANDLE, reads[i](NULL));
        expect_result(VBSS_ERROR_INVALID_HANDLE, reads[i](f.context));
        expect_result(VBSS_ERROR_INVALID_HANDLE, reads[i](scene));
        expect_result(VBSS_ERROR_INVALID_HANDLE, reads[i](f.replica));
    }
    expect_result(VBSS_ERROR_INVALID_HANDLE,
                  vbss_replica_create((vbss_scene *)f.context, NULL, &none));
    assert_null(none);
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_replica_create(scene, NULL, NULL));
    end(&f);
}

static void scenes_of_other_contexts_are_rejected(void **state)
{
    (void)state;
    fixture f, other;
    begin(&f);
    begin(&other);
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_replica_publish(f.replica, other.run.scene));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_replica_publish(f.replica, NULL));
    expect_ok(vbss_scene_destroy(f.run.scene));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_replica_publish(f.replica, f.run.scene));
    end(&other);
    end(&f);
}

/* ---- two readers */

/* As if the other thread were in the middle of a call. */
static void second_reader_is_rejected(void **state)
{
    (void)state;
    const replica_state *held;
    vbss_visual *visual;
    fixture f;
    begin(&f);
    expect_ok(vbss_visual_create(f.context, NULL, &visual));
    expect_ok(vbss_visual_add_replica(visual, f.replica, NULL));
    expect_ok(vbss_replica_begin_reading(f.replica, &held));
    expect_result(VBSS_ERROR_BUSY, call_take(f.replica));
    expect_result(VBSS_ERROR_BUSY, call_view(f.replica));
    expect_result(VBSS_ERROR_BUSY, vbss_visual_update(visual));
    expect_result(VBSS_ERROR_BUSY, vbss_replica_destroy(f.replica));
    expect_ok(vbss_replica_publish(f.replica, f.run.scene)); /* which never waits for a reader */
    vbss_replica_end_reading(f.replica);
    expect_ok(call_take(f.replica));
    expect_ok(vbss_visual_update(visual));
    expect_ok(vbss_replica_destroy(f.replica));
    end(&f);
}

/* While a call is in a context, another thread may read; here a callback stands for it. */
typedef struct listener {
    vbss_replica *replica;
    vbss_result results[3];
} listener;

static void listen(void *user, vbss_log_level level, const char *message)
{
    listener *l = user;
    (void)level;
    (void)message;
    l->results[0] = call_take(l->replica);
    l->results[1] = call_view(l->replica);
    l->results[2] = call_publish(l->replica);
}

static void readers_enter_no_context(void **state)
{
    (void)state;
    listener l = {.results = {VBSS_ERROR_DEVICE, VBSS_ERROR_DEVICE, VBSS_ERROR_DEVICE}};
    harness_memory memory;
    vbss_context *context;
    vbss_context_config config = harness_watched_config(&memory);
    config.log = listen;
    config.log_user = &l;
    expect_ok(vbss_context_create(&config, &context));
    expect_ok(vbss_scene_create(context, NULL, &scene));
    expect_ok(vbss_replica_create(scene, NULL, &l.replica));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_replica_create(scene, NULL, NULL));
    expect_ok(l.results[0]);
    expect_ok(l.results[1]);
    expect_result(VBSS_ERROR_BUSY, l.results[2]); /* it changes the replica */
    harness_context_end(context, &memory);
}

/* ---- structs and fields */

static vbss_result init_config(void *config, uint32_t struct_size)
{
    return vbss_replica_config_init(config, struct_size);
}

static vbss_result create_and_destroy(vbss_context *context, const void *config)
{
    vbss_replica *replica;
    vbss_scene *own;
    vbss_scene_config small;
    VBSS_TRY(vbss_scene_config_init(&small, sizeof small));
    small.node_capacity = small.contact_capacity = small.candidate_capacity = 16;
    vbss_result result = vbss_scene_create(context, &small, &own);
    if (result == VBSS_OK) {
        result = vbss_replica_create(own, config, &replica);
        vbss_replica_destroy(replica);
        vbss_scene_destroy(own);
    }
    return result;
}

static void config_size_protocol(void **state)
{
    (void)state;
    const uint32_t sizes[] = {8, 0};
    const harness_config config = {sizes, init_config, create_and_destroy};
    harness_config_protocol(&config);
}

static void output_struct_size_protocol(void **state)
{
    (void)state;
    fixture f;
    unsigned char out[128];
    uint32_t filled;
    begin(&f);
    expect_ok(vbss_replica_publish(f.replica, f.run.scene));
    for (uint32_t size = 0; size < sizeof(vbss_replica_state); size++) {
        expect_result(VBSS_ERROR_STRUCT_SIZE,
                      vbss_replica_take(f.replica, (vbss_replica_state *)(void *)out, size));
    }
    memset(out, 0xff, sizeof out);
    expect_ok(vbss_replica_take(f.replica, (vbss_replica_state *)(void *)out, 96));
    memcpy(&filled, out, sizeof filled);
    assert_int_equal(filled, sizeof(vbss_replica_state));
    assert_true(out[95] == 0 && out[96] == 0xff);
    memcpy(&filled, out + 4, sizeof filled);
    assert_int_equal(filled, 1); /* calls with a wrong size took nothing */
    expect_result(VBSS_ERROR_NULL_ARGUMENT,
                  vbss_replica_get_view(f.replica, VBSS_REPLICA_VIEW_NODES, NULL, 48));
    end(&f);
}

static void view_dimensions_match_documentation(void **state)
{
    (void)state;
    const struct {
        vbss_view_type type;
        uint32_t components;
    } wanted[] = {{VBSS_VIEW_TYPE_U32, 8}, {VBSS_VIEW_TYPE_F64, 7}, {VBSS_VIEW_TYPE_F64, 2},
                  {VBSS_VIEW_TYPE_F64, 3}, {VBSS_VIEW_TYPE_F64, 1}, {VBSS_VIEW_TYPE_U32, 3},
                  {VBSS_VIEW_TYPE_F64, 7}, {VBSS_VIEW_TYPE_U32, 4}, {VBSS_VIEW_TYPE_F64, 8},
                  {VBSS_VIEW_TYPE_U32, 5}, {VBSS_VIEW_TYPE_F64, 3}, {VBSS_VIEW_TYPE_F64, 3},
                  {VBSS_VIEW_TYPE_F64, 3}, {VBSS_VIEW_TYPE_F64, 1}};
    fixture f;
    vbss_view view;
    begin(&f);
    for (vbss_replica_field field = 0; field < 14; field++) {
        view = rig_view(f.replica, field); /* before the first state */
        assert_int_equal(view.count, 0);
        assert_non_null(view.data);
        assert_int_equal(view.type, wanted[field].type);
        assert_int_equal(view.components, wanted[field].components);
        assert_int_equal(view.stride_bytes,
                         view.components * (view.type == VBSS_VIEW_TYPE_U32 ? 4 : 8));
    }
    expect_result(VBSS_ERROR_OUT_OF_RANGE,
                  vbss_replica_get_view(f.replica, 14, &view, sizeof view));
    expect_result(VBSS_ERROR_OUT_OF_RANGE,
                  vbss_replica_get_view(f.replica, -1, &view, sizeof view));
    end(&f);
}

/* ---- the life of a state */

static void views_stay_until_the_next_take(void **state)
{
    (void)state;
    fixture f;
    vbss_replica_state taken;
    begin(&f);
    expect_ok(vbss_replica_publish(f.replica, f.run.scene));
    taken = rig_take(f.replica);
    const uint64_t hash = rig_hash_replica(f.replica, &taken);
    for (int i = 0; i < 5; i++) {
        expect_ok(tool_run_step(&f.run));
        expect_ok(vbss_replica_publish(f.replica, f.run.scene));
        assert_true(rig_hash_replica(f.replica, &taken) == hash);
        assert_int_equal(rig_view(f.replica, VBSS_REPLICA_VIEW_NODES).generation, 1);
    }
    taken = rig_take(f.replica);
    assert_true(taken.number == 6 && taken.missed == 4 && taken.steps == 5);
    expect_ok(vbss_replica_take(f.replica, &taken, sizeof taken));
    assert_true(taken.is_new == 0 && taken.number == 6 && taken.missed == 4);
    end(&f);
}

static void floor_and_time_are_reported(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    expect_ok(tool_run_step(&f.run));
    expect_ok(vbss_replica_publish(f.replica, f.run.scene));
    const vbss_replica_state taken = rig_take(f.replica);
    assert_true(taken.floor == 1 && taken.steps == 1);
    expect_near(1e-3, taken.time, 1e-15);
    expect_near(-0.02, taken.floor_height, 1e-15);
    expect_near(1.0, taken.floor_normal[2], 1e-15);
    end(&f);
}

static vbss_result attempt(vbss_context *context, void *user)
{
    (void)user;
    return create_and_destroy(context, NULL);
}

static void failed_allocations_lose_nothing(void **state)
{
    (void)state;
    harness_fail_every_allocation(attempt, NULL);
}

int test_replica_calls(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(every_call_rejects_invalid_handles),
        harness_test(scenes_of_other_contexts_are_rejected),
        harness_test(second_reader_is_rejected),
        harness_test(readers_enter_no_context),
        harness_test(config_size_protocol),
        harness_test(output_struct_size_protocol),
        harness_test(view_dimensions_match_documentation),
        harness_test(views_stay_until_the_next_take),
        harness_test(floor_and_time_are_reported),
        harness_test(failed_allocations_lose_nothing),
    };
    return cmocka_run_group_tests_name("replica.replica_calls", tests, NULL, NULL);
}
