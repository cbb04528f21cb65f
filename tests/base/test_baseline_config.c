/* The parameters of the baseline: every kind of object that takes them checks them, copies them, and compares them with
 * those of a snapshot. */
#include <stddef.h>
#include <string.h>

#include <vblast_ss/vblast_ss.h>

#include "base/error.h"
#include "harness/harness.h"

/* A snapshot, saved first and restored later. */
typedef struct saved {
    uint8_t bytes[1 << 20];
    uint64_t count;
} saved;
static saved snapshot;

/* Creates an object of the baseline with these parameters, which it forgets before the snapshot: the object has a copy. Saves
 * the snapshot, or restores it if `restores`. */
#define MAKER(module)                                                                              \
    static vbss_result make_##module(vbss_context *context, const vbss_baseline_config *given,     \
                                     bool restores)                                                \
    {                                                                                              \
        vbss_##module *object = NULL;                                                              \
        vbss_##module##_config config = vbss_##module##_config_default();                          \
        vbss_baseline_config mine;                                                                 \
        memcpy(&mine, given, sizeof mine);                                                         \
        config.method = VBSS_METHOD_VBLAST;                                                        \
        config.baseline = &mine;                                                                   \
        VBSS_TRY(vbss_##module##_create(context, &config, &object));                               \
        memset(&mine, 0xa5, sizeof mine);                                                          \
        vbss_result result = restores                                                              \
                                 ? vbss_##module##_restore(object, snapshot.bytes, snapshot.count) \
                                 : vbss_##module##_save(object, snapshot.bytes,                    \
                                                        sizeof snapshot.bytes, &snapshot.count);   \
        expect_ok(vbss_##module##_destroy(object));                                                \
        return result;                                                                             \
    }

MAKER(collision)
MAKER(thread)
MAKER(drain)
MAKER(scene)

/* A grasper alone has no snapshot. */
static vbss_result make_grasper(vbss_context *context, const vbss_baseline_config *given,
                                bool restores)
{
    (void)restores;
    vbss_grasper *grasper;
    vbss_grasper_config config = vbss_grasper_config_default();
    config.method = VBSS_METHOD_VBLAST;
    config.baseline = given;
    VBSS_TRY(vbss_grasper_create(context, &config, &grasper));
    return vbss_grasper_destroy(grasper);
}

typedef struct kind {
    const char *name;
    vbss_result (*make)(vbss_context *context, const vbss_baseline_config *given, bool restores);
} kind;
static const kind kinds[] = {{"collision", make_collision},
                             {"thread", make_thread},
                             {"drain", make_drain},
                             {"grasper", make_grasper},
                             {"scene", make_scene}};
enum { KINDS = sizeof kinds / sizeof kinds[0] };

static const struct number {
    const char *name;
    size_t offset;
    double low, high;
} numbers[] = {
#define NUMBER(field, low, high)                                 \
    {                                                            \
#field, offsetof(vbss_baseline_config, field), low, high \
    }
    NUMBER(collision_parallel, 0.0, 1.0), NUMBER(collision_unit, 1e-9, 1e3),
    NUMBER(thread_stiffness, 0.0, 1e9),   NUMBER(thread_damping, 0.0, 1.0),
    NUMBER(thread_tolerance, 1e-14, 1.0), NUMBER(drain_stiffness, 0.0, 1e9),
    NUMBER(drain_damping, 0.0, 1.0),      NUMBER(grasper_stiffness, 0.0, 1e6),
    NUMBER(grasper_distance, 0.0, 0.1),   NUMBER(scene_thickness, 0.0, 1e-2),
};

static const struct word {
    const char *name;
    size_t offset;
    uint32_t low, high;
} words[] = {
#define WORD(field, low, high)                                   \
    {                                                            \
#field, offsetof(vbss_baseline_config, field), low, high \
    }
    WORD(thread_substeps, 0, 100000),
    WORD(thread_iteration_limit, 1, 1000),
    WORD(drain_substeps, 0, 100000),
    WORD(scene_pass_limit, 1, 1000),
    WORD(reserved, 0, 0),
};

/* Whether the error text names the field. */
static bool is_named(const vbss_context *context, const char *name)
{
    vbss_result result;
    const char *text;
    expect_ok(vbss_context_get_last_error(context, &result, &text));
    return strstr(text, name) != NULL;
}

static void make_with_number(vbss_context *context, const struct number *n, double value,
                             vbss_result wanted)
{
    vbss_baseline_config config = vbss_baseline_config_default();
    memcpy((char *)&config + n->offset, &value, sizeof value);
    for (size_t k = 0; k < KINDS; k++) {
        expect_result(wanted, kinds[k].make(context, &config, false));
        assert_true(wanted == VBSS_OK || is_named(context, n->name));
    }
}

static void every_object_refuses_numbers_out_of_range(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        const struct number *n = &numbers[i];
        make_with_number(context, n, n->low, VBSS_OK);
        make_with_number(context, n, n->high, VBSS_OK);
        make_with_number(context, n, n->low - 1e-15, VBSS_ERROR_OUT_OF_RANGE);
        make_with_number(context, n, n->high * (1.0 + 1e-12), VBSS_ERROR_OUT_OF_RANGE);
        for (int k = 0; k < 3; k++) {
            make_with_number(context, n, harness_bad_numbers[k], VBSS_ERROR_NOT_FINITE);
        }
    }
    harness_context_end(context, &memory);
}

static void make_with_word(vbss_context *context, const struct word *w, uint32_t value,
                           vbss_result wanted)
{
    vbss_baseline_config config = vbss_baseline_config_default();
    memcpy((char *)&config + w->offset, &value, sizeof value);
    for (size_t k = 0; k < KINDS; k++) {
        expect_result(wanted, kinds[k].make(context, &config, false));
        assert_true(wanted == VBSS_OK || is_named(context, w->name));
    }
}

static void every_object_refuses_counts_out_of_range(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        make_with_word(context, &words[i], words[i].low, VBSS_OK);
        make_with_word(context, &words[i], words[i].high, VBSS_OK);
        make_with_word(context, &words[i], words[i].high + 1, VBSS_ERROR_OUT_OF_RANGE);
        if (words[i].low > 0) {
            make_with_word(context, &words[i], 0, VBSS_ERROR_OUT_OF_RANGE);
        }
    }
    harness_context_end(context, &memory);
}

/* Changes a parameter of one module; returns false if the module has none of that number. */
static bool change(vbss_baseline_config *config, size_t k, int which)
{
    double *const values[][3] = {
        {&config->collision_parallel, &config->collision_unit, NULL},
        {&config->thread_stiffness, &config->thread_damping, &config->thread_tolerance},
        {&config->drain_stiffness, &config->drain_damping, NULL},
        {NULL},
        {&config->scene_thickness, NULL},
    };
    uint32_t *const counts[][2] = {
        {NULL},
        {&config->thread_substeps, &config->thread_iteration_limit},
        {&config->drain_substeps},
        {NULL},
        {&config->scene_pass_limit},
    };
    if (which < 3 && values[k][which] != NULL) {
        *values[k][which] = 5e-3;
        return true;
    }
    if (which >= 3 && counts[k][which - 3] != NULL) {
        *counts[k][which - 3] = 7;
        return true;
    }
    return false;
}

static void snapshot_of_other_parameters_is_rejected(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    const vbss_baseline_config kept = vbss_baseline_config_default();
    int rejected = 0;
    for (size_t k = 0; k < KINDS; k++) {
        if (kinds[k].make == make_grasper) {
            continue;
        }
        expect_ok(kinds[k].make(context, &kept, false));
        expect_ok(kinds[k].make(context, &kept, true));
        for (int which = 0; which < 5; which++) {
            vbss_baseline_config config = kept;
            bool same = !change(&config, k, which);
            expect_result(same ? VBSS_OK : VBSS_ERROR_CORRUPT,
                          kinds[k].make(context, &config, true));
            rejected += !same;
        }
    }
    assert_int_equal(rejected, 12);
    harness_context_end(context, &memory);
}

static vbss_result init(void *config, uint32_t struct_size)
{
    return vbss_baseline_config_init(config, struct_size);
}

static vbss_result create(vbss_context *context, const void *config)
{
    return make_grasper(context, config, false);
}

static void config_size_protocol(void **state)
{
    (void)state;
    const uint32_t sizes[] = {104, 0};
    const harness_config config = {sizes, init, create};
    harness_config_protocol(&config);
}

int test_baseline_config(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(every_object_refuses_numbers_out_of_range),
        harness_test(every_object_refuses_counts_out_of_range),
        harness_test(snapshot_of_other_parameters_is_rejected),
        harness_test(config_size_protocol),
    };
    return cmocka_run_group_tests_name("base.baseline_config", tests, NULL, NULL);
}
