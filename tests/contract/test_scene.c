/* The contract of scenes as objects. */
#include <stdlib.h>

#include "base/error.h"
#include "contract/contract.h"
#include "scene/api/api.h"
#include "fixtures/scene_build.h"

static const vbss_scene_capsule ball = {{0.0, 0.02, 0.0}, {0.0, 0.02, 0.0}, 1e-3};

/* ---- configurations: small ones, as hundreds are made */

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

static vbss_result rigid_init(void *config, uint32_t struct_size)
{
    vbss_scene_rigid_config *c = config;
    VBSS_TRY(vbss_scene_rigid_config_init(config, struct_size));
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

static const void *good_config(void)
{
    static vbss_scene_config config;
    expect_ok(vbss_scene_config_init(&config, sizeof config));
    return &config;
}

/* ---- the object: a thread, body 1, and a driven capsule, body 2; a third thread is not in it yet */

static vbss_thread *spare_thread; /* of the newest scene */

static vbss_result add_rigid(vbss_scene *scene, double height)
{
    vbss_scene_rigid_config config;
    uint32_t body;
    VBSS_TRY(rigid_init(&config, sizeof config));
    config.kind = VBSS_SCENE_RIGID_DRIVEN;
    config.position[1] = height;
    return vbss_scene_add_rigid(scene, &config, &body);
}

static vbss_result create(vbss_context *context, void **handle)
{
    vbss_scene_config config;
    vbss_thread_config own;
    VBSS_TRY(vbss_scene_config_init(&config, sizeof config));
    VBSS_TRY(vbss_thread_config_init(&own, sizeof own));
    config.node_capacity = 200;
    VBSS_TRY(vbss_scene_create(context, &config, (vbss_scene **)handle));
    VBSS_TRY(vbss_thread_create(context, &own, &spare_thread));
    own.segment_count = 5;
    own.length = 0.01;
    own.start[1] = -0.1;
    VBSS_TRY(scene_build_thread(context, *handle, &own, NULL, NULL));
    return add_rigid(*handle, 1.0);
}

static vbss_result create_from(vbss_context *context, const void *config, void **handle)
{
    return vbss_scene_create(context, config, (vbss_scene **)handle);
}

static vbss_result destroy(void *handle)
{
    return vbss_scene_destroy(handle);
}

static vbss_result reject(void *handle)
{
    return vbss_scene_step(handle, 1.0);
}

static vbss_result get_hash(void *handle, uint64_t *hash)
{
    return vbss_scene_get_hash(handle, hash);
}

static vbss_result write_rigid(void *handle, void *out, uint32_t size)
{
    return vbss_scene_get_rigid(handle, 2, out, size);
}
static vbss_result write_view(void *handle, void *out, uint32_t size)
{
    return vbss_scene_get_view(handle, VBSS_SCENE_VIEW_CONTACTS, out, size);
}
static vbss_result write_statistics(void *handle, void *out, uint32_t size)
{
    return vbss_scene_get_statistics(handle, out, size);
}

static vbss_result call_step(void *scene)
{
    return vbss_scene_step(scene, 1e-3);
}
static vbss_result call_add_thread(void *scene)
{
    uint32_t body;
    return vbss_scene_add_thread(scene, spare_thread, &body);
}
static vbss_result call_add_rigid(void *scene)
{
    return add_rigid(scene, 2.0);
}
static vbss_result call_pin(void *scene)
{
    uint32_t pin;
    return vbss_scene_pin_thread(scene, 1, 0, 2, NULL, &pin);
}
static vbss_result call_move(void *scene)
{
    const double there[3] = {0.0, 1.0, 0.0};
    return vbss_scene_set_rigid_target(scene, 2, there, NULL);
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
    vbss_scene_rigid_state out;
    return write_rigid(scene, &out, sizeof out);
}
static vbss_result call_view(void *scene)
{
    vbss_view view;
    return vbss_scene_get_view(scene, VBSS_SCENE_VIEW_CONTACTS, &view, sizeof view);
}
static vbss_result call_statistics(void *scene)
{
    vbss_scene_statistics out;
    return write_statistics(scene, &out, sizeof out);
}

/* ---- memory */

typedef struct plan {
    vbss_scene_config scene;
    vbss_thread_config thread;
    vbss_scene_rigid_config rigid;
} plan;

static vbss_result save_and_restore(vbss_scene *scene)
{
    uint64_t need = 0, count = 0;
    (void)vbss_scene_save(scene, NULL, 0, &need);
    uint8_t *bytes = malloc(need);
    assert_non_null(bytes);
    vbss_result result = vbss_scene_save(scene, bytes, need, &count);
    result = result == VBSS_OK ? vbss_scene_restore(scene, bytes, count) : result;
    free(bytes);
    return result;
}

static vbss_result fill(vbss_scene *scene, vbss_thread *thread, const plan *p)
{
    uint32_t line, body, pin;
    VBSS_TRY(vbss_scene_add_thread(scene, thread, &line));
    VBSS_TRY(vbss_scene_add_rigid(scene, &p->rigid, &body));
    VBSS_TRY(vbss_scene_pin_thread(scene, line, 0, body, NULL, &pin));
    VBSS_TRY(vbss_scene_step(scene, 1e-3));
    VBSS_TRY(save_and_restore(scene));
    VBSS_TRY(vbss_scene_remove(scene, body));
    return vbss_scene_remove(scene, line);
}

static vbss_result attempt(vbss_context *context, void *user)
{
    const plan *p = user;
    vbss_scene *scene;
    vbss_thread *thread = NULL;
    uint64_t hash;
    VBSS_TRY(vbss_scene_create(context, &p->scene, &scene));
    vbss_result result = vbss_thread_create(context, &p->thread, &thread);
    result = result == VBSS_OK ? fill(scene, thread, p) : result;
    expect_ok(vbss_scene_get_hash(scene, &hash)); /* whatever failed, the scene is intact */
    VBSS_TRY(vbss_scene_destroy(scene));
    VBSS_TRY(vbss_thread_destroy(thread));
    return result;
}

static plan attempted;

static void *loose(void)
{
    plan *p = &attempted;
    expect_ok(vbss_scene_config_init(&p->scene, sizeof p->scene));
    expect_ok(vbss_thread_config_init(&p->thread, sizeof p->thread));
    expect_ok(rigid_init(&p->rigid, sizeof p->rigid));
    p->scene.node_capacity = 20;
    p->scene.contact_capacity = p->scene.candidate_capacity = 16;
    p->scene.event_capacity = 4;
    p->thread.segment_count = 6;
    p->rigid.kind = VBSS_SCENE_RIGID_FREE;
    return p;
}

static void *driven_above_floor(void)
{
    (void)loose();
    attempted.scene.floor = 1;
    attempted.rigid.kind = VBSS_SCENE_RIGID_DRIVEN;
    return &attempted;
}

static void *paper(void)
{
    (void)driven_above_floor();
    attempted.scene.floor = 0;
    attempted.scene.method = attempted.thread.method = VBSS_METHOD_VBLAST;
    return &attempted;
}

/* A scene with two bodies goes, its thread is used again. */
static vbss_result cycle(vbss_context *context, uint32_t i)
{
    void *scene = NULL;
    (void)i;
    VBSS_TRY(create(context, &scene));
    vbss_thread *thread = NULL;
    VBSS_TRY(vbss_scene_get_thread(scene, 1, &thread));
    VBSS_TRY(destroy(scene));
    VBSS_TRY(vbss_thread_destroy(thread));
    return vbss_thread_destroy(spare_thread);
}

static const uint32_t scene_sizes[] = {152, 0}, rigid_sizes[] = {200, 0};

static const contract_object object = {
    .name = "scene",
    .configs = {{scene_sizes, config_init, create_and_destroy},
                {rigid_sizes, rigid_init, add_rigid_and_destroy}},
    .create = create,
    .create_from = create_from,
    .config = good_config,
    .null_config = VBSS_OK,
    .destroy = destroy,
    .reject = reject,
    .hash = get_hash,
    .outputs = {{264, {0}, write_rigid},
                {sizeof(vbss_view), {0}, write_view},
                {sizeof(vbss_scene_statistics), {200, 232, 248}, write_statistics}},
    .calls = {{.call = call_add_thread, .edits = true},
              {.call = call_add_rigid, .edits = true},
              {.call = call_pin, .edits = true},
              {.call = call_move, .edits = true},
              {.call = call_step, .edits = true},
              {.call = call_unpin, .edits = true},
              {.call = call_remove, .edits = true},
              {.call = call_restore, .edits = true, .result = VBSS_ERROR_CORRUPT},
              {.call = call_save},
              {.call = call_hash},
              {.call = call_rigid},
              {.call = call_view},
              {.call = call_statistics}},
    .attempts = {{attempt, loose}, {attempt, driven_above_floor}, {attempt, paper}},
    .cycle = cycle,
    .cycles = 12,
};

/* ---- snapshots of scenes with a thread and a free capsule; those of scenes with other bodies: scene.scene_state */

static vbss_result create_pair(vbss_context *context, const void *config, void **handle)
{
    vbss_thread_config own;
    vbss_scene_rigid_config rigid;
    uint32_t body;
    VBSS_TRY(vbss_scene_create(context, config, (vbss_scene **)handle));
    VBSS_TRY(vbss_thread_config_init(&own, sizeof own));
    own.segment_count = 5;
    own.length = 0.01;
    VBSS_TRY(scene_build_thread(context, *handle, &own, NULL, NULL));
    VBSS_TRY(rigid_init(&rigid, sizeof rigid));
    rigid.kind = VBSS_SCENE_RIGID_FREE;
    return vbss_scene_add_rigid(*handle, &rigid, &body);
}

static void usual_config(void *config)
{
    expect_ok(vbss_scene_config_init(config, sizeof(vbss_scene_config)));
}

static void reserve_more(void *config)
{
    vbss_scene_config *c = config;
    c->node_capacity = 300;
    c->contact_capacity = 100;
    c->candidate_capacity = 1000;
    c->thread_capacity = 2;
    c->event_capacity = 3;
}

static vbss_result save(void *handle, void *bytes, uint64_t capacity, uint64_t *written)
{
    return vbss_scene_save(handle, bytes, capacity, written);
}

static vbss_result restore(void *handle, const void *bytes, uint64_t count)
{
    return vbss_scene_restore(handle, bytes, count);
}

#define NUMBER(field)                                \
    {                                                \
        offsetof(vbss_scene_config, field), 1, 0.999 \
    }
#define CHOICE(field, change)                         \
    {                                                 \
        offsetof(vbss_scene_config, field), 0, change \
    }

static const contract_snapshot snapshot = {
    .name = "scene",
    .kind = &vbss_scene_kind,
    .config = usual_config,
    .config_size = sizeof(vbss_scene_config),
    .create = create_pair,
    .destroy = destroy,
    .save = save,
    .restore = restore,
    .fields = {NUMBER(floor_height), NUMBER(floor_friction), NUMBER(thread_friction),
               NUMBER(contact_stiffness), NUMBER(floor_normal[0]), NUMBER(speed_limit),
               CHOICE(mode, 1), CHOICE(floor, 1), CHOICE(pin_capacity, -1)},
    .reserve_more = reserve_more,
    .step = call_step,
};

int test_scene(void)
{
    return contract_check_object("contract.scene", &object) +
           contract_check_snapshot("contract.scene", &snapshot);
}
