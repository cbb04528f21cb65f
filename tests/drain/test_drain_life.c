/* How drains begin and end, and what they refuse while they live. */
#include <stdlib.h>
#include <string.h>

#include "base/error.h"
#include "drain/drain_rig.h"

/* ---- the size protocols */

static vbss_result config_init(void *config, uint32_t struct_size)
{
    return vbss_drain_config_init(config, struct_size);
}

static vbss_result create_and_destroy(vbss_context *context, const void *config)
{
    vbss_drain *drain;
    VBSS_TRY(vbss_drain_create(context, config, &drain));
    return vbss_drain_destroy(drain);
}

static vbss_result attachment_init(void *attachment, uint32_t struct_size)
{
    return vbss_drain_attachment_init(attachment, struct_size);
}

static vbss_result attach_and_destroy(vbss_context *context, const void *attachment)
{
    vbss_drain_config config;
    vbss_drain *drain;
    uint32_t id;
    VBSS_TRY(vbss_drain_config_init(&config, sizeof config));
    VBSS_TRY(vbss_drain_create(context, &config, &drain));
    vbss_result result = vbss_drain_attach(drain, attachment, &id);
    VBSS_TRY(vbss_drain_destroy(drain));
    return result;
}

static void config_size_protocol(void **state)
{
    (void)state;
    static const uint32_t config_sizes[] = {240, 248, 296, 304, 0}, attachment_sizes[] = {72, 0};
    const harness_config config = {config_sizes, config_init, create_and_destroy};
    const harness_config attachment = {attachment_sizes, attachment_init, attach_and_destroy};
    harness_config_protocol(&config);
    harness_config_protocol(&attachment);
}

enum { OUTS = 5 };

static vbss_result write_out(vbss_drain *drain, int which, void *out, uint32_t size)
{
    switch (which) {
    case 0:
        return vbss_drain_get_places(drain, out, size);
    case 1:
        return vbss_drain_get_gap(drain, out, size);
    case 2:
        return vbss_drain_get_energies(drain, out, size);
    case 3:
        return vbss_drain_get_statistics(drain, out, size);
    default:
        return vbss_drain_get_view(drain, VBSS_DRAIN_STRAINS, out, size);
    }
}

static void output_struct_size_protocol(void **state)
{
    (void)state;
    const uint32_t sizes[OUTS] = {32, 96, 56, 80, sizeof(vbss_view)};
    const uint32_t gap_before_lips = 32; /* it is still filled for hosts of that time */
    drain_rig r;
    drain_rig_begin(&r);
    drain_rig_make(&r);
    drain_rig_run(&r, 1e-3, 1);
    for (int which = 0; which < OUTS; which++) {
        unsigned char out[256];
        uint32_t filled;
        expect_result(VBSS_ERROR_NULL_ARGUMENT, write_out(r.drain, which, NULL, sizes[which]));
        for (uint32_t size = 0; size < sizes[which]; size++) {
            bool published = which == 1 && size == gap_before_lips;
            expect_result(published ? VBSS_OK : VBSS_ERROR_STRUCT_SIZE,
                          write_out(r.drain, which, out, size));
        }
        memset(out, 0xff, sizeof out);
        expect_ok(write_out(r.drain, which, out, 192));
        memcpy(&filled, out, sizeof filled);
        assert_int_equal(filled, sizes[which]);
        for (uint32_t i = 0; i < sizeof out; i++) {
            assert_true(i < sizes[which] || out[i] == (i < 192 ? 0 : 0xff));
        }
    }
    drain_rig_end(&r);
}

/* ---- handles */

static vbss_result call_step(void *d)
{
    return vbss_drain_step(d, 1e-3);
}
/* Nothing given: nothing placed. */
static vbss_result call_set_state(void *d)
{
    return vbss_drain_set_state(d, NULL, NULL, 137);
}
static vbss_result call_attach(void *d)
{
    vbss_drain_attachment a;
    uint32_t id;
    VBSS_TRY(vbss_drain_attachment_init(&a, sizeof a));
    a.kind = VBSS_DRAIN_ATTACHMENT_FORCE;
    return vbss_drain_attach(d, &a, &id);
}
static vbss_result call_move(void *d)
{
    const double zero[3] = {0.0, 0.0, 0.0};
    return vbss_drain_move(d, 1, zero);
}
static vbss_result call_restore(void *d)
{
    uint8_t bytes[64] = {0};
    return vbss_drain_restore(d, bytes, sizeof bytes);
}
static vbss_result call_detach(void *d)
{
    return vbss_drain_detach(d, 1);
}
static vbss_result call_reaction(void *d)
{
    double force[3];
    return vbss_drain_get_reaction(d, 2, force);
}
static vbss_result call_save(void *d)
{
    uint64_t written;
    vbss_result result = vbss_drain_save(d, NULL, 0, &written);
    return result == VBSS_ERROR_CAPACITY ? VBSS_OK : result;
}
static vbss_result call_hash(void *d)
{
    uint64_t hash;
    return vbss_drain_get_hash(d, &hash);
}
static vbss_result call_out(void *d, int which)
{
    unsigned char out[192];
    return write_out(d, which, out, sizeof out);
}
static vbss_result call_places(void *d)
{
    return call_out(d, 0);
}
static vbss_result call_gap(void *d)
{
    return call_out(d, 1);
}
static vbss_result call_energies(void *d)
{
    return call_out(d, 2);
}
static vbss_result call_statistics(void *d)
{
    return call_out(d, 3);
}
static vbss_result call_view(void *d)
{
    return call_out(d, 4);
}

/* Those that change something come first. */
enum { EDITS = 6, CALLS = 14 };
static const harness_handle_call calls[CALLS] = {
    call_step, call_set_state, call_attach, call_move, call_restore,  call_detach, call_reaction,
    call_save, call_hash,      call_places, call_gap,  call_energies, call_view,   call_statistics};

static void every_call_rejects_invalid_handles(void **state)
{
    (void)state;
    drain_rig r;
    drain_rig_begin(&r);
    drain_rig_make(&r);
    vbss_drain *destroyed = r.drain, *none = destroyed;
    expect_ok(vbss_drain_destroy(destroyed));
    harness_refuses_bad_handles(r.context, destroyed, calls, CALLS);
    expect_ok(vbss_drain_destroy(NULL));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_drain_destroy(destroyed));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_drain_destroy((vbss_drain *)r.context));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_drain_create(NULL, &r.config, &none));
    assert_null(none);
    none = destroyed;
    expect_result(VBSS_ERROR_INVALID_HANDLE,
                  vbss_drain_create((vbss_context *)destroyed, &r.config, &none));
    assert_null(none);
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_drain_create(r.context, NULL, &none));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_drain_create(r.context, &r.config, NULL));
    r.drain = NULL;
    drain_rig_end(&r);
}

/* ---- inside callbacks */

typedef struct listener {
    vbss_context *context;
    vbss_drain *drain;
    vbss_result results[CALLS], created, destroyed;
    int heard;
} listener;

static void listen(void *user, vbss_log_level level, const char *message)
{
    listener *l = user;
    vbss_drain_config config;
    vbss_drain *made = NULL;
    (void)level;
    (void)message;
    l->heard++;
    for (int i = 0; i < CALLS; i++) {
        l->results[i] = calls[i](l->drain);
    }
    l->created = vbss_drain_config_init(&config, sizeof config);
    l->created = vbss_drain_create(l->context, &config, &made);
    l->destroyed = vbss_drain_destroy(l->drain);
}

static void calls_inside_callback_are_rejected(void **state)
{
    (void)state;
    listener l = {0};
    drain_rig r = {0};
    vbss_context_config context_config = harness_watched_config(&r.memory);
    context_config.log = listen;
    context_config.log_user = &l;
    expect_ok(vbss_context_create(&context_config, &r.context));
    l.context = r.context;
    expect_ok(vbss_drain_config_init(&r.config, sizeof r.config));
    drain_rig_make(&r);
    l.drain = r.drain;
    drain_rig_pin_here(&r, r.places.marks[0]);
    drain_rig_pin_here(&r, r.places.marks[1]);
    uint64_t hash = drain_rig_hash(&r);
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_drain_step(r.drain, 1.0));
    assert_int_equal(l.heard, 1);
    for (int i = 0; i < CALLS; i++) {
        expect_result(i < EDITS ? VBSS_ERROR_BUSY : VBSS_OK, l.results[i]);
    }
    expect_result(VBSS_ERROR_BUSY, l.created);
    expect_result(VBSS_ERROR_BUSY, l.destroyed);
    assert_true(drain_rig_hash(&r) == hash);
    /* All of these work outside; the restore has nothing to read. */
    for (int i = 0; i < CALLS; i++) {
        expect_result(calls[i] == call_restore ? VBSS_ERROR_CORRUPT : VBSS_OK, calls[i](r.drain));
    }
    drain_rig_end(&r);
}

/* ---- memory */

static vbss_result use(vbss_drain *drain)
{
    VBSS_TRY(call_attach(drain));
    uint64_t need = 0, count = 0;
    (void)vbss_drain_save(drain, NULL, 0, &need);
    uint8_t *bytes = malloc(need);
    assert_non_null(bytes);
    vbss_result result = vbss_drain_save(drain, bytes, need, &count);
    if (result == VBSS_OK) {
        result = vbss_drain_restore(drain, bytes, count);
    }
    free(bytes);
    return result == VBSS_OK ? vbss_drain_step(drain, 1e-3) : result;
}

static vbss_result live(vbss_context *context, void *user)
{
    vbss_drain *drain;
    VBSS_TRY(vbss_drain_create(context, user, &drain));
    vbss_result result = use(drain);
    VBSS_TRY(vbss_drain_destroy(drain));
    return result;
}

static void each_failed_allocation_is_reported_without_leak(void **state)
{
    (void)state;
    vbss_drain_config config;
    expect_ok(vbss_drain_config_init(&config, sizeof config));
    harness_fail_every_allocation(live, &config);
    config.attachment_capacity = 1;
    config.mesh = VBSS_DRAIN_MESH_225;
    harness_fail_every_allocation(live, &config);
}

static void drain_churn_does_not_grow_memory(void **state)
{
    (void)state;
    drain_rig r;
    uint64_t blocks = 0;
    drain_rig_begin(&r);
    for (uint32_t i = 0; i < 8; i++) {
        r.config.mesh = (vbss_drain_mesh)(i % 4);
        drain_rig_make(&r);
        drain_rig_run(&r, 1e-3, 2);
        expect_ok(vbss_drain_destroy(r.drain));
        blocks = i == 0 ? r.memory.blocks : blocks;
        assert_int_equal(r.memory.blocks, blocks);
    }
    drain_rig_make(&r); /* a context ends with a living one */
    harness_context_end(r.context, &r.memory);
}

int test_drain_life(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(config_size_protocol),
        cmocka_unit_test(output_struct_size_protocol),
        cmocka_unit_test(every_call_rejects_invalid_handles),
        cmocka_unit_test(calls_inside_callback_are_rejected),
        cmocka_unit_test(each_failed_allocation_is_reported_without_leak),
        cmocka_unit_test(drain_churn_does_not_grow_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
