/* Properties of objects that a scene owns while they are in it. */
#include <string.h>

#include "contract/contract.h"
#include "scene/small.h"

enum { NO_BODY = 77 }; /* what a rejected call leaves in its result */

static uint64_t hash_of(const contract_member *m, void *handle)
{
    uint64_t hash = 0;
    expect_ok(m->hash(handle, &hash));
    return hash;
}

static void *make(const contract_member *m, const small *s, uint32_t place)
{
    void *handle = NULL;
    expect_ok(m->create(s->context, place, VBSS_METHOD_IMPLICIT, &handle));
    return handle;
}

static uint32_t add(const contract_member *m, const small *s, void *handle)
{
    uint32_t body = 0;
    expect_ok(m->add(s->scene, handle, &body));
    return body;
}

static void begin(const contract_member *m, small *s, uint32_t count)
{
    small_begin(s);
    m->limit(&s->config, count, 0);
    small_create(s);
}

/* ---- ownership */

static void expect_owned(const contract_member *m, void *handle, bool owned)
{
    static uint8_t bytes[1u << 16];
    const vbss_result wanted = owned ? VBSS_ERROR_IN_SCENE : VBSS_OK;
    uint64_t count;
    expect_ok(m->save(handle, bytes, sizeof bytes, &count));
    const uint64_t hash = hash_of(m, handle);
    expect_result(wanted, m->step(handle));
    expect_result(wanted, m->restore(handle, bytes, count));
    if (owned) {
        expect_result(wanted, m->destroy(handle));
        if (m->edit != NULL) {
            expect_result(wanted, m->edit(handle));
        }
    }
    assert_true(hash_of(m, handle) == hash);
    if (m->use != NULL) {
        m->use(handle, owned);
    }
}

/* A scene gives an object back with its motion, whether the object or the scene goes. */
static void object_belongs_to_scene_until_removed(void **state)
{
    const contract_member *m = *state;
    for (int by_destroy = 0; by_destroy < 2; by_destroy++) {
        small s;
        vbss_scene *other;
        uint32_t body = NO_BODY;
        begin(m, &s, 2);
        expect_ok(vbss_scene_create(s.context, &s.config, &other));
        void *handle = make(m, &s, 0);
        const uint32_t number = add(m, &s, handle);
        expect_owned(m, handle, true);
        expect_result(VBSS_ERROR_IN_SCENE, m->add(other, handle, &body));
        expect_result(VBSS_ERROR_IN_SCENE, m->add(s.scene, handle, &body));
        assert_int_equal(body, NO_BODY);
        small_steps(&s, 20, 1e-3);
        expect_owned(m, handle, true);
        const uint64_t before = hash_of(m, handle);
        if (by_destroy == 0) {
            expect_ok(vbss_scene_remove(s.scene, number));
            expect_result(VBSS_ERROR_NOT_FOUND, vbss_scene_remove(s.scene, number));
        } else {
            expect_ok(vbss_scene_destroy(s.scene));
        }
        assert_true(hash_of(m, handle) == before); /* it goes on from where it was */
        expect_owned(m, handle, false);
        expect_ok(m->add(other, handle, &body));
        expect_owned(m, handle, true);
        expect_ok(vbss_scene_step(other, 1e-3));
        expect_ok(vbss_scene_remove(other, body));
        if (m->edit != NULL) {
            expect_ok(m->edit(handle));
        }
        expect_ok(m->destroy(handle));
        small_end(&s);
    }
}

/* A discarded object is in the scene as before, and is destroyed when it leaves it. */
static void discarded_object_is_destroyed_when_it_leaves_scene(void **state)
{
    const contract_member *m = *state;
    for (int by_destroy = 0; by_destroy < 2; by_destroy++) {
        small s;
        begin(m, &s, 2);
        expect_ok(m->discard(NULL));
        void *alone = make(m, &s, 1), *handle = make(m, &s, 0);
        expect_ok(m->discard(alone)); /* in no scene: at once */
        expect_result(VBSS_ERROR_INVALID_HANDLE, m->discard(alone));
        const uint32_t number = add(m, &s, handle);
        expect_ok(m->discard(handle));
        expect_ok(m->discard(handle));
        expect_owned(m, handle, true);
        small_steps(&s, 2, 1e-3);
        expect_ok(by_destroy ? vbss_scene_destroy(s.scene) : vbss_scene_remove(s.scene, number));
        expect_result(VBSS_ERROR_INVALID_HANDLE, m->destroy(handle));
        small_end(&s);
    }
}

/* ---- rejections */

static void expect_rejected(const contract_member *m, const small *s, vbss_result wanted,
                            void *handle)
{
    uint32_t body = NO_BODY;
    const char *text;
    const uint64_t hash = small_hash(s), blocks = s->memory.blocks;
    const uint64_t generation = small_view(s, VBSS_SCENE_VIEW_CONTACTS).generation;
    expect_result(wanted, m->add(s->scene, handle, &body));
    expect_ok(vbss_context_get_last_error(s->context, NULL, &text));
    assert_true(strlen(text) > 0);
    assert_int_equal(body, NO_BODY);
    assert_int_equal(s->memory.blocks, blocks);
    assert_true(small_hash(s) == hash);
    assert_true(small_view(s, VBSS_SCENE_VIEW_CONTACTS).generation == generation);
}

static void invalid_object_is_rejected(void **state)
{
    const contract_member *m = *state;
    small s, other;
    uint32_t body = NO_BODY;
    begin(m, &s, 2);
    small_begin(&other);
    void *foreign = make(m, &other, 0), *good = make(m, &s, 0), *gone = make(m, &s, 1);
    expect_ok(m->destroy(gone));
    expect_rejected(m, &s, VBSS_ERROR_INVALID_HANDLE, foreign);
    expect_rejected(m, &s, VBSS_ERROR_INVALID_HANDLE, gone);
    expect_rejected(m, &s, VBSS_ERROR_INVALID_HANDLE, s.scene);
    expect_result(VBSS_ERROR_INVALID_HANDLE, m->add(s.scene, NULL, &body));
    expect_result(VBSS_ERROR_INVALID_HANDLE, m->add(NULL, good, &body));
    expect_result(VBSS_ERROR_INVALID_HANDLE, m->add(good, good, &body));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, m->add(s.scene, good, NULL));
    assert_int_equal(body, NO_BODY);
    expect_ok(m->step(foreign));
    expect_ok(m->step(good));
    small_end(&other);
    small_end(&s);
}

static void object_of_other_method_is_rejected(void **state)
{
    const contract_member *m = *state;
    for (int method = VBSS_METHOD_IMPLICIT; method <= VBSS_METHOD_VBLAST; method++) {
        small s;
        void *other = NULL;
        small_begin(&s);
        m->limit(&s.config, 1, 0);
        s.config.method = method;
        small_create(&s);
        expect_ok(
            m->create(s.context, 0, VBSS_METHOD_IMPLICIT + VBSS_METHOD_VBLAST - method, &other));
        expect_rejected(m, &s, VBSS_ERROR_INCOMPATIBLE, other);
        expect_ok(m->step(other));
        small_end(&s);
    }
}

static void fill_to_capacity(const contract_member *m, uint32_t capacity, uint32_t kind)
{
    small s;
    uint32_t first = 0, body = 0;
    small_begin(&s);
    m->limit(&s.config, capacity, kind);
    small_create(&s);
    for (uint32_t i = 0; i < capacity; i++) {
        body = add(m, &s, make(m, &s, i));
        first = i == 0 ? body : first;
    }
    void *one_more = make(m, &s, capacity);
    expect_rejected(m, &s, VBSS_ERROR_CAPACITY, one_more);
    small_steps(&s, 2, 1e-3);
    expect_rejected(m, &s, VBSS_ERROR_CAPACITY, one_more);
    if (capacity > 0) {
        expect_ok(vbss_scene_remove(s.scene, first));
        assert_int_equal(add(m, &s, one_more), body + 1); /* numbers are never used again */
        small_steps(&s, 2, 1e-3);
    }
    small_end(&s);
}

static void object_needs_capacity(void **state)
{
    const contract_member *m = *state;
    for (uint32_t kind = 0; kind < m->limit_kinds; kind++) {
        for (uint32_t capacity = 0; capacity <= 3; capacity++) {
            fill_to_capacity(m, capacity, kind);
        }
    }
}

/* ---- ends */

static void context_end_destroys_in_any_order(void **state)
{
    const contract_member *m = *state;
    for (int order = 0; order < 16; order++) {
        small s;
        small_begin(&s);
        m->limit(&s.config, 2, 0);
        void *before = make(m, &s, 0); /* older than the scene */
        small_create(&s);
        void *after = make(m, &s, 1);
        if ((order & 1) != 0) {
            (void)add(m, &s, before);
        }
        if ((order & 2) != 0) {
            (void)add(m, &s, after);
        }
        small_steps(&s, 1, 1e-3);
        if ((order & 4) != 0) {
            expect_ok(vbss_scene_destroy(s.scene));
            expect_ok(m->step(before));
        }
        if ((order & 4) != 0 && (order & 8) != 0) {
            expect_ok(m->destroy(after));
        }
        small_end(&s);
    }
}

/* ---- callbacks */

typedef struct listener {
    const contract_member *member;
    vbss_scene *scene;
    void *handle;
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
    l->added = l->member->add(l->scene, l->handle, &body);
    l->removed = vbss_scene_remove(l->scene, 1);
}

static void membership_inside_callback_is_rejected(void **state)
{
    const contract_member *m = *state;
    small s;
    listener l = {.member = m};
    small_begin(&s);
    expect_ok(vbss_context_destroy(s.context));
    vbss_context_config config = harness_watched_config(&s.memory);
    config.log = listen;
    config.log_user = &l;
    expect_ok(vbss_context_create(&config, &s.context));
    m->limit(&s.config, 2, 0);
    small_create(&s);
    (void)add(m, &s, make(m, &s, 0));
    l.handle = make(m, &s, 1);
    l.scene = s.scene;
    const uint64_t hash = small_hash(&s);
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_scene_step(s.scene, 1.0));
    assert_int_equal(l.heard, 1);
    expect_result(VBSS_ERROR_BUSY, l.added);
    expect_result(VBSS_ERROR_BUSY, l.removed);
    assert_true(small_hash(&s) == hash);
    expect_ok(m->step(l.handle));
    small_end(&s);
}

/* ---- memory */

static const contract_member *attempted;

static vbss_result use_in(vbss_scene *scene, void *handle)
{
    uint32_t body;
    vbss_result result = attempted->add(scene, handle, &body);
    result = result == VBSS_OK ? vbss_scene_step(scene, 1e-3) : result;
    return result == VBSS_OK ? vbss_scene_remove(scene, body) : result;
}

static vbss_result attempt(vbss_context *context, void *user)
{
    vbss_scene *scene = NULL;
    void *handle = NULL;
    uint64_t hash;
    vbss_result result = vbss_scene_create(context, user, &scene);
    if (result != VBSS_OK) {
        return result;
    }
    result = attempted->create(context, 0, VBSS_METHOD_IMPLICIT, &handle);
    result = result == VBSS_OK ? use_in(scene, handle) : result;
    expect_ok(vbss_scene_get_hash(scene, &hash)); /* the scene is intact */
    expect_ok(vbss_scene_destroy(scene));
    expect_ok(attempted->destroy(handle)); /* and the object is the host's */
    return result;
}

static void each_failed_allocation_is_reported_without_leak(void **state)
{
    const contract_member *m = *state;
    vbss_scene_config config;
    expect_ok(vbss_scene_config_init(&config, sizeof config));
    config.node_capacity = 20;
    config.contact_capacity = 16;
    config.candidate_capacity = 512;
    m->limit(&config, 1, 0);
    attempted = m;
    harness_fail_every_allocation(attempt, &config);
}

/* Beside an object that is there already. Whether an allocation failed. */
static bool add_with_failure(const contract_member *m, uint64_t call)
{
    small s;
    uint32_t body = NO_BODY;
    begin(m, &s, 2);
    (void)add(m, &s, make(m, &s, 0));
    small_steps(&s, 2, 1e-3);
    void *handle = make(m, &s, 1);
    const uint64_t hash = small_hash(&s), own = hash_of(m, handle), blocks = s.memory.blocks;
    s.memory.fail_call = s.memory.calls + call;
    vbss_result result = m->add(s.scene, handle, &body);
    const bool failed = s.memory.failures > 0;
    s.memory.fail_call = 0;
    expect_result(failed ? VBSS_ERROR_OUT_OF_MEMORY : VBSS_OK, result);
    if (failed) {
        assert_int_equal(body, NO_BODY);
        assert_int_equal(s.memory.blocks, blocks);
        assert_true(small_hash(&s) == hash);
        assert_true(hash_of(m, handle) == own);
        small_steps(&s, 2, 1e-3);
        expect_ok(m->step(handle)); /* still the host's */
        assert_int_equal(add(m, &s, handle), 2);
    }
    small_steps(&s, 2, 1e-3);
    small_end(&s);
    return failed;
}

static void object_without_memory_is_not_added(void **state)
{
    const contract_member *m = *state;
    uint64_t failures = 0;
    while (add_with_failure(m, failures + 1)) {
        failures++;
    }
    assert_true(failures >= m->add_allocations);
}

static void churn_does_not_grow_memory(void **state)
{
    const contract_member *m = *state;
    small s;
    uint64_t blocks = 0;
    begin(m, &s, 1);
    void *handle = make(m, &s, 0);
    for (int i = 0; i < 12; i++) {
        const uint32_t body = add(m, &s, handle);
        small_steps(&s, 2, 1e-3);
        expect_ok(vbss_scene_remove(s.scene, body));
        blocks = i == 0 ? s.memory.blocks : blocks;
        assert_int_equal(s.memory.blocks, blocks);
        small_steps(&s, 1, 1e-3);
    }
    small_end(&s);
}

#define PROPERTY(name) \
    {                  \
#name, name    \
    }

int contract_check_member(const char *group, const contract_member *member)
{
    static const contract_property properties[] = {
        PROPERTY(object_belongs_to_scene_until_removed),
        PROPERTY(discarded_object_is_destroyed_when_it_leaves_scene),
        PROPERTY(invalid_object_is_rejected),
        PROPERTY(object_of_other_method_is_rejected),
        PROPERTY(object_needs_capacity),
        PROPERTY(context_end_destroys_in_any_order),
        PROPERTY(membership_inside_callback_is_rejected),
        PROPERTY(each_failed_allocation_is_reported_without_leak),
        PROPERTY(object_without_memory_is_not_added),
        PROPERTY(churn_does_not_grow_memory),
    };
    static contract_cases cases;
    cases.count = 0;
    for (size_t i = 0; i < sizeof properties / sizeof properties[0]; i++) {
        contract_add(&cases, member->name, &properties[i], member);
    }
    return contract_run_cases(group, &cases);
}
