/* Options of the solver: defaults, ranges, budgets in microseconds, and the options in snapshots. */
#include <stdlib.h>

#include "base/error.h"
#include "fixtures/solver_of.h"
#include "scene/small_subject.h"

typedef struct field {
    const char *name;
    size_t offset;
    double low, high, other; /* and another good value */
} field;

#define FIELD(name, low, high, other)                                      \
    {                                                                      \
#name, offsetof(vbss_solver_options, name), (low), (high), (other) \
    }

static const field numbers[] = {
    FIELD(stretch_tolerance, 1e-9, 0.1, 2e-3), FIELD(penetration_tolerance, 1e-3, 0.5, 0.2),
    FIELD(contact_margin, 0.0, 0.1, 4e-5),     FIELD(step_budget_us, 0.0, 8e6, 400.0),
    FIELD(call_budget_us, 0.0, 8e6, 400.0),    FIELD(operations_per_us, 1e-2, 1e6, 400.0),
};
static const field words[] = {
    FIELD(iteration_limit, 1, 100, 11),
    FIELD(active_set_limit, 1, 1000, 35),
    FIELD(halving_limit, 0, 10, 4),
    FIELD(attempt_limit, 1, 1000, 2),
};
enum { NUMBERS = sizeof numbers / sizeof numbers[0], WORDS = sizeof words / sizeof words[0] };

static void set_number(vbss_solver_options *options, const field *f, double value)
{
    memcpy((char *)options + f->offset, &value, sizeof value);
}

static void set_word(vbss_solver_options *options, const field *f, uint32_t value)
{
    memcpy((char *)options + f->offset, &value, sizeof value);
}

static vbss_result make(small *s, const vbss_solver_options *options)
{
    vbss_scene *scene;
    s->config.solver = options;
    const vbss_result result = vbss_scene_create(s->context, &s->config, &scene);
    return result == VBSS_OK ? vbss_scene_destroy(scene) : result;
}

static void expect_refused(small *s, const vbss_solver_options *options, vbss_result wanted,
                           const char *name)
{
    vbss_result result;
    const char *text = NULL;
    expect_result(wanted, make(s, options));
    expect_ok(vbss_context_get_last_error(s->context, &result, &text));
    assert_non_null(strstr(text, name));
}

/* ---- values */

static void numbers_out_of_range_are_refused_by_name(void **state)
{
    (void)state;
    small s;
    tiny_scene(&s);
    for (size_t i = 0; i < NUMBERS; i++) {
        const field *f = &numbers[i];
        vbss_solver_options options = vbss_solver_options_default();
        options.step_budget_us = options.call_budget_us = 1000.0;
        set_number(&options, f, f->low);
        expect_ok(make(&s, &options));
        set_number(&options, f, f->high);
        expect_ok(make(&s, &options));
        set_number(&options, f, -1e-15);
        expect_refused(&s, &options, VBSS_ERROR_OUT_OF_RANGE, f->name);
        set_number(&options, f, 2e7);
        expect_refused(&s, &options, VBSS_ERROR_OUT_OF_RANGE, f->name);
        for (int k = 0; k < 3; k++) {
            set_number(&options, f, harness_bad_numbers[k]);
            expect_refused(&s, &options, VBSS_ERROR_NOT_FINITE, f->name);
        }
    }
    small_end(&s);
}

static void counts_out_of_range_are_refused_by_name(void **state)
{
    (void)state;
    small s;
    tiny_scene(&s);
    for (size_t i = 0; i < WORDS; i++) {
        const field *f = &words[i];
        vbss_solver_options options = vbss_solver_options_default();
        set_word(&options, f, (uint32_t)f->low);
        expect_ok(make(&s, &options));
        set_word(&options, f, (uint32_t)f->high);
        expect_ok(make(&s, &options));
        set_word(&options, f, (uint32_t)f->high + 1);
        expect_refused(&s, &options, VBSS_ERROR_OUT_OF_RANGE, f->name);
        if (f->low > 0.0) {
            set_word(&options, f, 0);
            expect_refused(&s, &options, VBSS_ERROR_OUT_OF_RANGE, f->name);
        }
    }
    vbss_solver_options options = vbss_solver_options_default();
    options.reserved = 1;
    expect_refused(&s, &options, VBSS_ERROR_OUT_OF_RANGE, "reserved");
    small_end(&s);
}

/* A budget above zero must be a number of operations of 32 bits, or rounding would make it no limit. */
static void budgets_that_are_no_operations_are_refused(void **state)
{
    (void)state;
    small s;
    tiny_scene(&s);
    const struct {
        double budget, speed;
        bool is_good;
    } cases[] = {
        {1e-3, 500.0, true},       {0.9e-3, 500.0, false},   {4294967295.0 / 500.0, 500.0, true},
        {8589935.0, 500.0, false}, {0.0, 500.0, true},       {1.0, 0.5, true},
        {1.0, 0.49, false},        {4294.967295, 1e6, true}, {4294.968, 1e6, false}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        vbss_solver_options of_step = vbss_solver_options_default(), of_call = of_step;
        of_step.operations_per_us = of_call.operations_per_us = cases[i].speed;
        of_step.step_budget_us = of_call.call_budget_us = cases[i].budget;
        of_step.call_budget_us = of_call.step_budget_us = 0.0;
        if (cases[i].is_good) {
            expect_ok(make(&s, &of_step));
            expect_ok(make(&s, &of_call));
        } else {
            expect_refused(&s, &of_step, VBSS_ERROR_OUT_OF_RANGE, "step_budget_us");
            expect_refused(&s, &of_call, VBSS_ERROR_OUT_OF_RANGE, "call_budget_us");
        }
    }
    small_end(&s);
}

static vbss_result init(void *config, uint32_t struct_size)
{
    return vbss_solver_options_init(config, struct_size);
}

static vbss_result create(vbss_context *context, const void *options)
{
    vbss_scene *scene;
    vbss_scene_config config = vbss_scene_config_default();
    config.node_capacity = config.contact_capacity = config.candidate_capacity = 8;
    config.solver = options;
    VBSS_TRY(vbss_scene_create(context, &config, &scene));
    return vbss_scene_destroy(scene);
}

static void options_follow_the_size_protocol(void **state)
{
    (void)state;
    const uint32_t sizes[] = {72, 0};
    const harness_config config = {sizes, init, create};
    harness_config_protocol(&config);
}

/* ---- operations */

static void default_budgets_are_250000_and_210000_operations(void **state)
{
    (void)state;
    small s;
    small_begin_scene(&s);
    const scene_settings *settings = &small_object(&s)->settings;
    assert_int_equal(settings->step_budget, 250000);
    assert_int_equal(settings->call_budget, 210000);
    expect_ok(vbss_scene_set_budgets(s.scene, 500.0, 420.0, 250.0));
    assert_int_equal(settings->step_budget, 125000);
    assert_int_equal(settings->call_budget, 105000);
    expect_ok(vbss_scene_set_budgets(s.scene, 0.0, 0.0, 250.0));
    assert_int_equal(settings->step_budget, 0);
    assert_int_equal(settings->call_budget, 0);
    small_end(&s);
}

/* Tests that need N operations get N, for every N. */
static void operations_survive_microseconds_exactly(void **state)
{
    (void)state;
    const double speeds[] = {500.0, 262.3, 1.0 / 3.0, 777.77};
    for (int k = 0; k < 4; k++) {
        for (uint64_t n = 1; n < UINT32_MAX; n = n * 5 / 4 + 1) {
            const double us = (double)n / speeds[k];
            assert_true(vbss_scene_count_operations(us, speeds[k]) == (double)n);
        }
    }
}

/* ---- in snapshots */

static void begin_with(small *s, const vbss_solver_options *options)
{
    small_begin(s);
    s->config.floor = 1;
    s->config.solver = options;
    small_create(s);
    s->thread.gravity[1] = -9.81;
    (void)small_thread(s, vec3_make(-0.02, 3e-4, 0.0), vec3_make(0.02, 3e-4, 0.0), 20, NULL);
    small_steps(s, 5, 1e-3);
}

static void expect_restore(const vbss_solver_options *other, vbss_result wanted)
{
    small s, t;
    begin_with(&s, NULL);
    begin_with(&t, other);
    const small_state saved = small_save(&s);
    expect_result(wanted, vbss_scene_restore(t.scene, saved.bytes, saved.count));
    assert_true(wanted != VBSS_OK || small_hash(&s) == small_hash(&t));
    free(saved.bytes);
    small_end(&t);
    small_end(&s);
}

static void snapshot_of_other_options_is_rejected(void **state)
{
    (void)state;
    for (size_t i = 0; i < NUMBERS; i++) {
        vbss_solver_options options = vbss_solver_options_default();
        set_number(&options, &numbers[i], numbers[i].other);
        expect_restore(&options, VBSS_ERROR_CORRUPT);
    }
    for (size_t i = 0; i < WORDS; i++) {
        vbss_solver_options options = vbss_solver_options_default();
        set_word(&options, &words[i], (uint32_t)words[i].other);
        expect_restore(&options, VBSS_ERROR_CORRUPT);
    }
}

/* Bits depend on the products alone. */
static void snapshot_of_same_operations_is_accepted(void **state)
{
    (void)state;
    vbss_solver_options options = vbss_solver_options_default();
    options.step_budget_us *= 2.0;
    options.call_budget_us *= 2.0;
    options.operations_per_us *= 0.5;
    expect_restore(&options, VBSS_OK);
}

static void loaded_scene_has_the_options_of_the_saved_one(void **state)
{
    (void)state;
    small s;
    vbss_scene *loaded = NULL;
    scene_object *object = NULL;
    vbss_solver_options options = vbss_solver_options_default();
    for (size_t i = 0; i < NUMBERS; i++) {
        set_number(&options, &numbers[i], numbers[i].other);
    }
    for (size_t i = 0; i < WORDS; i++) {
        set_word(&options, &words[i], (uint32_t)words[i].other);
    }
    begin_with(&s, &options);
    expect_ok(vbss_scene_set_budgets(s.scene, 321.0, 123.0, 77.0));
    const small_state saved = small_save(&s);
    expect_ok(vbss_scene_load(s.context, saved.bytes, saved.count, &loaded));
    expect_ok(vbss_scene_open(loaded, &object));
    assert_memory_equal(&object->solver, &options, sizeof options);
    assert_int_equal(object->settings.step_budget, 321 * 77);
    assert_int_equal(object->settings.call_budget, 123 * 77);
    expect_ok(vbss_scene_destroy(loaded));
    free(saved.bytes);
    small_end(&s);
}

int test_solver_options(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_out_of_range_are_refused_by_name),
        cmocka_unit_test(counts_out_of_range_are_refused_by_name),
        cmocka_unit_test(budgets_that_are_no_operations_are_refused),
        cmocka_unit_test(options_follow_the_size_protocol),
        cmocka_unit_test(default_budgets_are_250000_and_210000_operations),
        cmocka_unit_test(operations_survive_microseconds_exactly),
        cmocka_unit_test(snapshot_of_other_options_is_rejected),
        cmocka_unit_test(snapshot_of_same_operations_is_accepted),
        cmocka_unit_test(loaded_scene_has_the_options_of_the_saved_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
