/* Properties of creation, handles, structs that go out, and memory. */
#include <string.h>

#include "contract/contract.h"

static void config_size_protocol(void **state)
{
    const contract_object *o = *state;
    for (size_t i = 0; i < CONTRACT_CONFIGS && o->configs[i].sizes != NULL; i++) {
        harness_config_protocol(&o->configs[i]);
    }
}

static bool is_published(const contract_output *out, uint32_t size)
{
    return size > 0 && (size == out->older[0] || size == out->older[1] || size == out->older[2]);
}

static void check_output(const contract_output *output, void *handle)
{
    enum { FUTURE = 120 }; /* bytes that only a later version fills */
    unsigned char out[1024];
    uint32_t filled;
    expect_result(VBSS_ERROR_NULL_ARGUMENT, output->write(handle, NULL, output->size));
    for (uint32_t size = 0; size < output->size; size++) {
        expect_result(is_published(output, size) ? VBSS_OK : VBSS_ERROR_STRUCT_SIZE,
                      output->write(handle, out, size));
    }
    const uint32_t given = output->size + FUTURE;
    assert_true(given < sizeof out);
    memset(out, 0xff, sizeof out);
    expect_ok(output->write(handle, out, given));
    memcpy(&filled, out, sizeof filled);
    assert_int_equal(filled, output->size);
    for (uint32_t i = output->size; i < sizeof out; i++) {
        assert_int_equal(out[i], i < given ? 0 : 0xff);
    }
}

static void output_struct_size_protocol(void **state)
{
    const contract_object *o = *state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    void *handle = NULL;
    expect_ok(o->create(context, &handle));
    for (size_t i = 0; i < CONTRACT_OUTPUTS && o->outputs[i].write != NULL; i++) {
        check_output(&o->outputs[i], handle);
    }
    harness_context_end(context, &memory);
}

/* ---- handles */

static const contract_object *at_hand; /* whose destroy is called */

/* NULL is nothing to destroy. */
static vbss_result call_destroy(void *handle)
{
    return handle == NULL ? VBSS_ERROR_INVALID_HANDLE : at_hand->destroy(handle);
}

static size_t count_calls(const contract_object *o)
{
    size_t count = 0;
    while (count < CONTRACT_CALLS && o->calls[count].call != NULL) {
        count++;
    }
    return count;
}

static void every_call_rejects_invalid_handles(void **state)
{
    const contract_object *o = *state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    void *destroyed = NULL;
    harness_handle_call calls[CONTRACT_CALLS + 1];
    const size_t count = count_calls(o);
    for (size_t i = 0; i < count; i++) {
        calls[i] = o->calls[i].call;
    }
    at_hand = o;
    calls[count] = call_destroy;
    expect_ok(o->create(context, &destroyed));
    expect_ok(o->destroy(destroyed));
    harness_refuses_bad_handles(context, destroyed, calls, count + 1);
    expect_ok(o->destroy(NULL));
    void *contexts[] = {NULL, destroyed};
    for (int k = 0; k < 2; k++) {
        void *none = destroyed;
        expect_result(VBSS_ERROR_INVALID_HANDLE, o->create_from(contexts[k], o->config(), &none));
        assert_null(none);
    }
    expect_result(VBSS_ERROR_NULL_ARGUMENT, o->create_from(context, o->config(), NULL));
    void *made = NULL;
    expect_result(o->null_config, o->create_from(context, NULL, &made));
    harness_context_end(context, &memory);
}

/* ---- inside callbacks */

typedef struct listener {
    const contract_object *object;
    vbss_context *context;
    void *handle;
    vbss_result results[CONTRACT_CALLS], created, destroyed;
    int heard;
} listener;

static void listen(void *user, vbss_log_level level, const char *message)
{
    listener *l = user;
    void *made = NULL;
    (void)level;
    (void)message;
    l->heard++;
    for (size_t i = 0; i < count_calls(l->object); i++) {
        l->results[i] = l->object->calls[i].call(l->handle);
    }
    l->created = l->object->create_from(l->context, l->object->config(), &made);
    l->destroyed = l->object->destroy(l->handle);
}

static void calls_inside_callback_are_rejected(void **state)
{
    const contract_object *o = *state;
    listener l = {.object = o};
    harness_memory memory;
    uint64_t hash, after;
    vbss_context_config config = harness_watched_config(&memory);
    config.log = listen;
    config.log_user = &l;
    expect_ok(vbss_context_create(&config, &l.context));
    expect_ok(o->create(l.context, &l.handle));
    expect_ok(o->hash(l.handle, &hash));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, o->reject(l.handle));
    assert_int_equal(l.heard, 1);
    for (size_t i = 0; i < count_calls(o); i++) {
        expect_result(o->calls[i].edits ? VBSS_ERROR_BUSY : VBSS_OK, l.results[i]);
    }
    expect_result(VBSS_ERROR_BUSY, l.created);
    expect_result(VBSS_ERROR_BUSY, l.destroyed);
    expect_ok(o->hash(l.handle, &after));
    assert_true(hash == after);
    for (size_t i = 0; i < count_calls(o); i++) {
        if (!o->calls[i].is_one_time) {
            expect_result(o->calls[i].result, o->calls[i].call(l.handle));
        }
    }
    harness_context_end(l.context, &memory);
}

/* ---- owned by a scene */

static void owned_object_rejects_edits(void **state)
{
    const contract_object *o = *state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    void *handle = NULL;
    vbss_slot *slot;
    uint64_t hash, after;
    expect_ok(o->create(context, &handle));
    expect_ok(o->hash(handle, &hash));
    expect_ok(vbss_slot_open(handle, o->owned_kind, &slot));
    slot->owner = &memory; /* anything: only whether there is one counts */
    for (size_t i = 0; i < count_calls(o); i++) {
        expect_result(o->calls[i].edits ? VBSS_ERROR_IN_SCENE : VBSS_OK, o->calls[i].call(handle));
    }
    expect_result(VBSS_ERROR_IN_SCENE, o->destroy(handle));
    slot->owner = NULL;
    expect_ok(o->hash(handle, &after));
    assert_true(hash == after);
    harness_context_end(context, &memory);
}

/* ---- memory */

static void each_failed_allocation_is_reported_without_leak(void **state)
{
    const contract_object *o = *state;
    for (size_t i = 0; i < CONTRACT_ATTEMPTS && o->attempts[i].run != NULL; i++) {
        const contract_attempt *a = &o->attempts[i];
        harness_fail_every_allocation(a->run, a->argument != NULL ? a->argument() : NULL);
    }
}

static void churn_does_not_grow_memory(void **state)
{
    const contract_object *o = *state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    uint64_t blocks = 0;
    for (uint32_t i = 0; i < o->cycles; i++) {
        expect_ok(o->cycle(context, i));
        blocks = i == 0 ? memory.blocks : blocks;
        assert_int_equal(memory.blocks, blocks);
    }
    void *living = NULL; /* a context ends with a living object, too */
    expect_ok(o->create(context, &living));
    harness_context_end(context, &memory);
}

#define PROPERTY(name) \
    {                  \
#name, name    \
    }

int contract_check_object(const char *group, const contract_object *object)
{
    static const contract_property properties[] = {
        PROPERTY(config_size_protocol),
        PROPERTY(output_struct_size_protocol),
        PROPERTY(every_call_rejects_invalid_handles),
        PROPERTY(calls_inside_callback_are_rejected),
        PROPERTY(each_failed_allocation_is_reported_without_leak),
    };
    static const contract_property churn = PROPERTY(churn_does_not_grow_memory),
                                   owned = PROPERTY(owned_object_rejects_edits);
    static contract_cases cases;
    cases.count = 0;
    for (size_t i = 0; i < sizeof properties / sizeof properties[0]; i++) {
        contract_add(&cases, object->name, &properties[i], object);
    }
    if (object->cycle != NULL) {
        contract_add(&cases, object->name, &churn, object);
    }
    if (object->owned_kind != NULL) {
        contract_add(&cases, object->name, &owned, object);
    }
    return contract_run_cases(group, &cases);
}
