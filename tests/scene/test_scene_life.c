/* How scenes begin and end, and what handles and structs they refuse. */
#include "base/error.h"
#include "scene/small.h"

/* ---- the size protocols */

/* Small ones, as hundreds are made. */
static vbss_result config_init(void *config, uint32_t struct_size)
{
    vbss_scene_config *c = config;
    VBSS_TRY(vbss_scene_config_init(config, struct_size));
    c->node_capacity = 8;
    c->contact_capacity = c->candidate_capacity = 8;
    return VBSS_OK;
}

static vbss_result create_and_destroy(vbss_context *context, const void *config)
{
    vbss_scene *scene;
    VBSS_TRY(vbss_scene_create(context, config, &scene));
    return vbss_scene_destroy(scene);
}

static const vbss_capsule ball = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 1e-3};

static vbss_result rigid_init(void *config, uint32_t struct_size)
{
    vbss_rigid_config *c = config;
    VBSS_TRY(vbss_rigid_config_init(config, struct_size));
    c->capsule_count = 1;
    c->capsules = &ball;
    return VBSS_OK;
}

static vbss_result add_rigid_and_destroy(vbss_context *context, const void *config)
{
    vbss_scene_config scene_config;
    vbss_scene *scene;
    uint32_t body;
    VBSS_TRY(config_init(&scene_config, sizeof scene_config));
    VBSS_TRY(vbss_scene_create(context, &scene_config, &scene));
    vbss_result result = vbss_scene_add_rigid(scene, config, &body);
    VBSS_TRY(vbss_scene_destroy(scene));
    return result;
}

static void config_size_protocol(void **state)
{
    (void)state;
    static const uint32_t scene_sizes[] = {160, 168, 176, 192, 0}, rigid_sizes[] = {200, 0};
    const harness_config scene = {scene_sizes, config_init, create_and_destroy};
    const harness_config rigid = {rigid_sizes, rigid_init, add_rigid_and_destroy};
    harness_config_protocol(&scene);
    harness_config_protocol(&rigid);
}

static vbss_result write_out(vbss_scene *scene, int which, void *out, uint32_t size)
{
    switch (which) {
    case 0:
        return vbss_scene_get_rigid(scene, 1, out, size);
    case 1:
        return vbss_scene_get_view(scene, VBSS_SCENE_VIEW_EVENTS, out, size);
    default:
        return vbss_scene_get_statistics(scene, out, size);
    }
}

static void output_struct_size_protocol(void **state)
{
    (void)state;
    const uint32_t sizes[3] = {264, sizeof(vbss_view), sizeof(vbss_scene_statistics)};
    small s;
    small_begin_scene(&s);
    small_capsule(&s, VBSS_RIGID_FREE, vec3_zero(), vec3_zero(), 1e-3);
    small_steps(&s, 1, 1e-3);
    for (int which = 0; which < 3; which++) {
        unsigned char out[512];
        uint32_t filled;
        expect_result(VBSS_ERROR_NULL_ARGUMENT, write_out(s.scene, which, NULL, sizes[which]));
        for (uint32_t size = 0; size < sizes[which]; size++) {
            bool published = which == 2 && (size == 200 || size == 232); /* of earlier versions */
            vbss_result wanted = published ? VBSS_OK : VBSS_ERROR_STRUCT_SIZE;
            expect_result(wanted, write_out(s.scene, which, out, size));
        }
        memset(out, 0xff, sizeof out);
        expect_ok(write_out(s.scene, which, out, 400));
        memcpy(&filled, out, sizeof filled);
        assert_int_equal(filled, sizes[which]);
        for (uint32_t i = sizes[which]; i < sizeof out; i++) {
            assert_int_equal(out[i], i < 400 ? 0 : 0xff);
        }
    }
    small_end(&s);
}

static void default_scene(void **state)
{
    (void)state;
    small s;
    uint32_t body = 77;
    small_begin(&s);
    expect_ok(vbss_scene_create(s.context, NULL, &s.scene));
    small_steps(&s, 3, 1e-3); /* of nothing */
    assert_int_equal(small_statistics(&s).steps, 3);
    expect_near(3e-3, small_statistics(&s).time, 1e-18);
    s.rigid.capsules = &ball;
    s.rigid.capsule_count = 1;
    for (uint32_t i = 1; i <= 4; i++) {
        expect_ok(vbss_scene_add_rigid(s.scene, &s.rigid, &body));
        assert_int_equal(body, i);
    }
    expect_result(VBSS_ERROR_CAPACITY, vbss_scene_add_rigid(s.scene, &s.rigid, &body));
    assert_int_equal(body, 4);
    small_end(&s);
}

/* ---- handles */

static small at_hand; /* what the calls below need beside the handle */
static vbss_thread *own_thread;

static vbss_result call_step(void *scene)
{
    return vbss_scene_step(scene, 1e-3);
}
static vbss_result call_add_thread(void *scene)
{
    uint32_t body;
    return vbss_scene_add_thread(scene, own_thread, &body);
}
static vbss_result call_add_rigid(void *scene)
{
    uint32_t body;
    at_hand.rigid.capsules = &ball;
    at_hand.rigid.capsule_count = 1;
    return vbss_scene_add_rigid(scene, &at_hand.rigid, &body);
}
static vbss_result call_pin(void *scene)
{
    uint32_t pin;
    return vbss_scene_pin_thread(scene, 1, 0, 2, NULL, &pin);
}
static vbss_result call_move(void *scene)
{
    const double zero[3] = {0.0, 0.0, 0.0};
    return vbss_scene_move_rigid(scene, 2, zero, NULL);
}
static vbss_result call_unpin(void *scene)
{
    return vbss_scene_unpin_thread(scene, 1);
}
static vbss_result call_remove(void *scene)
{
    return vbss_scene_remove(scene, 1);
}
static vbss_result call_restore(void *scene)
{
    uint8_t bytes[64] = {0};
    return vbss_scene_restore(scene, bytes, sizeof bytes);
}
static vbss_result call_save(void *scene)
{
    uint64_t written;
    vbss_result result = vbss_scene_save(scene, NULL, 0, &written);
    return result == VBSS_ERROR_CAPACITY ? VBSS_OK : result;
}
static vbss_result call_hash(void *scene)
{
    uint64_t hash;
    return vbss_scene_get_hash(scene, &hash);
}
static vbss_result call_rigid(void *scene)
{
    vbss_rigid_state state;
    return vbss_scene_get_rigid(scene, 2, &state, sizeof state);
}
static vbss_result call_view(void *scene)
{
    vbss_view view;
    return vbss_scene_get_view(scene, VBSS_SCENE_VIEW_CONTACTS, &view, sizeof view);
}
static vbss_result call_statistics(void *scene)
{
    vbss_scene_statistics statistics;
    return vbss_scene_get_statistics(scene, &statistics, sizeof statistics);
}

/* Those that change something come first; each of them works once in this order. */
enum { EDITS = 8, CALLS = 13 };
static const harness_handle_call calls[CALLS] = {
    call_add_thread, call_add_rigid, call_pin,  call_move,  call_step, call_unpin,     call_remove,
    call_restore,    call_save,      call_hash, call_rigid, call_view, call_statistics};

static void every_call_rejects_invalid_handles(void **state)
{
    (void)state;
    small *s = &at_hand;
    small_begin_scene(s);
    expect_ok(vbss_thread_create(s->context, &s->thread, &own_thread));
    expect_ok(vbss_scene_destroy(s->scene));
    harness_refuses_bad_handles(s->context, s->scene, calls, CALLS);
    expect_ok(vbss_scene_destroy(NULL));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_scene_destroy(s->scene));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_scene_destroy((vbss_scene *)s->context));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_scene_destroy((vbss_scene *)own_thread));
    vbss_scene *none = s->scene;
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_scene_create(NULL, &s->config, &none));
    assert_null(none);
    none = s->scene;
    expect_result(VBSS_ERROR_INVALID_HANDLE,
                  vbss_scene_create((vbss_context *)s->scene, &s->config, &none));
    assert_null(none);
    small_end(s);
}

/* ---- inside callbacks */

typedef struct listener {
    vbss_scene *scene;
    vbss_context *context;
    vbss_result results[CALLS], created, destroyed;
    int heard;
} listener;

static void listen(void *user, vbss_log_level level, const char *message)
{
    listener *l = user;
    vbss_scene *made = NULL;
    (void)level;
    (void)message;
    l->heard++;
    for (int i = 0; i < CALLS; i++) {
        l->results[i] = calls[i](l->scene);
    }
    l->created = vbss_scene_create(l->context, &at_hand.config, &made);
    l->destroyed = vbss_scene_destroy(l->scene);
}

static void calls_inside_callback_are_rejected(void **state)
{
    (void)state;
    listener l = {0};
    small *s = &at_hand;
    small_begin(s);
    expect_ok(vbss_context_destroy(s->context));
    vbss_context_config config = harness_watched_config(&s->memory);
    config.log = listen;
    config.log_user = &l;
    expect_ok(vbss_context_create(&config, &s->context));
    small_create(s);
    l.scene = s->scene;
    l.context = s->context;
    expect_ok(vbss_thread_create(s->context, &s->thread, &own_thread));
    small_thread(s, vec3_zero(), vec3_make(0.01, 0.0, 0.0), 5, NULL);
    small_capsule(s, VBSS_RIGID_DRIVEN, vec3_make(0.0, 1.0, 0.0), vec3_make(0.1, 1.0, 0.0), 1e-3);
    uint64_t hash = small_hash(s);
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_scene_step(s->scene, 1.0));
    assert_int_equal(l.heard, 1);
    for (int i = 0; i < CALLS; i++) {
        expect_result(i < EDITS ? VBSS_ERROR_BUSY : VBSS_OK, l.results[i]);
    }
    expect_result(VBSS_ERROR_BUSY, l.created);
    expect_result(VBSS_ERROR_BUSY, l.destroyed);
    assert_true(small_hash(s) == hash);
    /* All of these work outside; the restore has nothing to read. */
    for (int i = 0; i < CALLS; i++) {
        expect_result(calls[i] == call_restore ? VBSS_ERROR_CORRUPT : VBSS_OK, calls[i](s->scene));
    }
    small_end(s);
}

int test_scene_life(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(config_size_protocol),
        cmocka_unit_test(output_struct_size_protocol),
        cmocka_unit_test(default_scene),
        cmocka_unit_test(every_call_rejects_invalid_handles),
        cmocka_unit_test(calls_inside_callback_are_rejected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
