/* How threads begin and end, and what they refuse. */
#include "base/error.h"
#include "fixture.h"

/* ---- the size protocols */

static vbss_result config_init(void *config, uint32_t struct_size)
{
    return vbss_thread_config_init(config, struct_size);
}

static vbss_result create_and_destroy(vbss_context *context, const void *config)
{
    vbss_thread *thread;
    VBSS_TRY(vbss_thread_create(context, config, &thread));
    return vbss_thread_destroy(thread);
}

static vbss_result attachment_init(void *attachment, uint32_t struct_size)
{
    return vbss_thread_attachment_init(attachment, struct_size);
}

static vbss_result attach_and_destroy(vbss_context *context, const void *attachment)
{
    vbss_thread_config config;
    vbss_thread *thread;
    uint32_t id;
    VBSS_TRY(vbss_thread_config_init(&config, sizeof config));
    config.segment_count = 1;
    VBSS_TRY(vbss_thread_create(context, &config, &thread));
    vbss_result result = vbss_thread_attach(thread, attachment, &id);
    VBSS_TRY(vbss_thread_destroy(thread));
    return result;
}

static void config_size_protocol(void **state)
{
    (void)state;
    static const uint32_t config_sizes[] = {240, 304, 0}, attachment_sizes[] = {112, 0};
    const harness_config config = {config_sizes, config_init, create_and_destroy};
    const harness_config attachment = {attachment_sizes, attachment_init, attach_and_destroy};
    harness_config_protocol(&config);
    harness_config_protocol(&attachment);
}

static vbss_result write_out(vbss_thread *thread, int which, void *out, uint32_t size)
{
    switch (which) {
    case 0:
        return vbss_thread_get_reaction(thread, 1, out, size);
    case 1:
        return vbss_thread_get_view(thread, VBSS_THREAD_POSITIONS, out, size);
    case 2:
        return vbss_thread_get_energies(thread, out, size);
    case 3:
        return vbss_thread_get_momentum(thread, out, size);
    default:
        return vbss_thread_get_statistics(thread, out, size);
    }
}

static void output_struct_size_protocol(void **state)
{
    (void)state;
    const uint32_t sizes[5] = {56, sizeof(vbss_view), 48, 88, 168};
    fixture f;
    begin(&f);
    vbss_thread *thread = make(&f);
    assert_int_equal(hold(thread, VBSS_ATTACHMENT_PIN, 0, vec3_zero()), 1);
    steps(thread, 1, 1e-3);
    for (int which = 0; which < 5; which++) {
        unsigned char out[256];
        uint32_t filled;
        expect_result(VBSS_ERROR_NULL_ARGUMENT, write_out(thread, which, NULL, sizes[which]));
        for (uint32_t size = 0; size < sizes[which]; size++) {
            bool older = which == 4 && size == 104;
            expect_result(older ? VBSS_OK : VBSS_ERROR_STRUCT_SIZE,
                          write_out(thread, which, out, size));
        }
        memset(out, 0xff, sizeof out);
        expect_ok(write_out(thread, which, out, 192));
        memcpy(&filled, out, sizeof filled);
        assert_int_equal(filled, sizes[which]);
        for (uint32_t i = 0; i < sizeof out; i++) {
            assert_true(i < sizes[which] || out[i] == (i < 192 ? 0 : 0xff));
        }
    }
    end(&f);
}

/* ---- materials */

static void presets_match_documentation(void **state)
{
    (void)state;
    const struct {
        vbss_thread_preset preset;
        double radius, linear_density, axial_stiffness, bending_stiffness;
    } wanted[] = {
        {VBSS_PRESET_SILK_2_0, 0.16e-3, 1.05e-4, 700.0, 2.7e-8},
        {VBSS_PRESET_PAPER_THREAD, 0.125e-3, 6.4e-5, 427.0, 1e-8},
    };
    vbss_thread_config config, kept;
    expect_ok(vbss_thread_config_init(&config, sizeof config));
    kept = config;
    for (int k = 0; k < 2; k++) {
        expect_ok(vbss_thread_config_preset(&config, wanted[k].preset));
        expect_same_bits(wanted[k].radius, config.radius);
        expect_same_bits(wanted[k].linear_density, config.linear_density);
        expect_same_bits(wanted[k].axial_stiffness, config.axial_stiffness);
        expect_same_bits(wanted[k].bending_stiffness, config.bending_stiffness);
    }
    /* The last of them is the default, and nothing else was touched. */
    assert_memory_equal(&config, &kept, sizeof config);
    const vbss_thread_preset none[] = {-1, 2, INT32_MAX, INT32_MIN};
    for (int k = 0; k < 4; k++) {
        expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_thread_config_preset(&config, none[k]));
        assert_memory_equal(&config, &kept, sizeof config);
    }
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_thread_config_preset(NULL, VBSS_PRESET_SILK_2_0));
}

/* ---- handles */

static const double three[3], state_of_two[6];

static vbss_result call_step(void *t)
{
    return vbss_thread_step(t, 1e-3);
}
static vbss_result call_set_state(void *t)
{
    return vbss_thread_set_state(t, state_of_two, NULL, 2);
}
static vbss_result call_attach(void *t)
{
    vbss_thread_attachment a = plain(VBSS_ATTACHMENT_PIN, 1);
    uint32_t id;
    return vbss_thread_attach(t, &a, &id);
}
static vbss_result call_move(void *t)
{
    return vbss_thread_move(t, 1, three, NULL);
}
static vbss_result call_detach(void *t)
{
    return vbss_thread_detach(t, 1);
}
static vbss_result call_cut(void *t)
{
    vbss_thread *piece;
    return vbss_thread_cut(t, 0.04, &piece);
}
static vbss_result call_restore(void *t)
{
    uint8_t bytes[64] = {0};
    return vbss_thread_restore(t, bytes, sizeof bytes);
}
static vbss_result call_save(void *t)
{
    uint64_t written;
    vbss_result result = vbss_thread_save(t, NULL, 0, &written);
    return result == VBSS_ERROR_CAPACITY ? VBSS_OK : result;
}
static vbss_result call_hash(void *t)
{
    uint64_t hash;
    return vbss_thread_get_hash(t, &hash);
}
static vbss_result call_out(void *t, int which)
{
    unsigned char out[192];
    return write_out(t, which, out, sizeof out);
}
static vbss_result call_reaction(void *t)
{
    return call_out(t, 0);
}
static vbss_result call_view(void *t)
{
    return call_out(t, 1);
}
static vbss_result call_energies(void *t)
{
    return call_out(t, 2);
}
static vbss_result call_momentum(void *t)
{
    return call_out(t, 3);
}
static vbss_result call_statistics(void *t)
{
    return call_out(t, 4);
}

/* Those that change something come first. */
enum { EDITS = 7, CALLS = 14 };
static const harness_handle_call calls[CALLS] = {
    call_step, call_set_state, call_attach,   call_move,      call_detach,
    call_cut,  call_restore,   call_save,     call_hash,      call_reaction,
    call_view, call_energies,  call_momentum, call_statistics};

static void every_call_rejects_invalid_handles(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    vbss_thread *destroyed = make(&f);
    expect_ok(vbss_thread_destroy(destroyed));
    harness_refuses_bad_handles(f.context, destroyed, calls, CALLS);
    expect_ok(vbss_thread_destroy(NULL));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_thread_destroy(destroyed));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_thread_destroy((vbss_thread *)f.context));
    vbss_thread *none = destroyed;
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_thread_create(NULL, &f.config, &none));
    expect_result(VBSS_ERROR_INVALID_HANDLE,
                  vbss_thread_create((vbss_context *)destroyed, &f.config, &none));
    end(&f);
}

/* ---- inside callbacks */

typedef struct listener {
    vbss_context *context;
    vbss_thread *thread;
    vbss_result results[CALLS], created, destroyed;
    int heard;
} listener;

static void listen(void *user, vbss_log_level level, const char *message)
{
    listener *l = user;
    vbss_thread_config config;
    vbss_thread *made = NULL;
    (void)level;
    (void)message;
    l->heard++;
    for (int i = 0; i < CALLS; i++) {
        l->results[i] = calls[i](l->thread);
    }
    l->created = vbss_thread_config_init(&config, sizeof config);
    l->created = vbss_thread_create(l->context, &config, &made);
    l->destroyed = vbss_thread_destroy(l->thread);
}

static void calls_inside_callback_are_rejected(void **state)
{
    (void)state;
    listener l = {0};
    harness_memory memory;
    vbss_context_config context_config = harness_watched_config(&memory);
    vbss_thread_config config;
    context_config.log = listen;
    context_config.log_user = &l;
    expect_ok(vbss_context_create(&context_config, &l.context));
    expect_ok(vbss_thread_config_init(&config, sizeof config));
    config.segment_count = 1;
    config.cut_capacity = 1;
    expect_ok(vbss_thread_create(l.context, &config, &l.thread));
    hold(l.thread, VBSS_ATTACHMENT_PIN, 0, vec3_zero());
    uint64_t hash = hash_of(l.thread);
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_thread_step(l.thread, 1.0));
    assert_int_equal(l.heard, 1);
    for (int i = 0; i < CALLS; i++) {
        expect_result(i < EDITS ? VBSS_ERROR_BUSY : VBSS_OK, l.results[i]);
    }
    expect_result(VBSS_ERROR_BUSY, l.created);
    expect_result(VBSS_ERROR_BUSY, l.destroyed);
    assert_true(hash_of(l.thread) == hash);
    /* All of these work outside; the restore has nothing to read. */
    for (int i = 0; i < CALLS; i++) {
        expect_result(calls[i] == call_restore ? VBSS_ERROR_CORRUPT : VBSS_OK,
                      calls[i] == call_reaction ? VBSS_OK : calls[i](l.thread));
    }
    l.thread = NULL;
    harness_context_end(l.context, &memory);
}

int test_thread_life(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(config_size_protocol),
        cmocka_unit_test(output_struct_size_protocol),
        cmocka_unit_test(presets_match_documentation),
        cmocka_unit_test(every_call_rejects_invalid_handles),
        cmocka_unit_test(calls_inside_callback_are_rejected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
