/* Budgets in logs: those of older libraries, in operations, and those that a host changes while the scene runs. */
#include <stdio.h>

#include "fixture.h"
#include "fixtures/scene_scenes.h"

#include <vblast_ss/scene_settings.h>

enum { OLD_STEPS = 12 };

static log_bytes read_old_log(void)
{
    enum { ROOM = 1 << 14 };
    log_bytes log = {malloc(ROOM), 0};
    FILE *file = fopen(VBSS_OPERATIONS_LOG, "rb");
    assert_non_null(file);
    assert_non_null(log.bytes);
    log.count = fread(log.bytes, 1, ROOM, file);
    assert_int_equal(fclose(file), 0);
    assert_true(log.count > 0 && log.count < ROOM);
    return log;
}

/* A library before budgets in microseconds (revision f179943d) wrote the log of a rod that falls onto the floor, with a step
 * budget of 123457 operations, a call budget of 98765, and no default among the options. */
static void old_log_gives_its_operations_in_microseconds(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    log_bytes log = read_old_log();
    vbss_replay *replay;
    vbss_scene_config config = vbss_scene_config_default();
    expect_ok(vbss_replay_create(context, log.bytes, log.count, &replay));
    expect_ok(vbss_replay_get_scene_config(replay, &config));
    assert_non_null(config.solver);
    const vbss_solver_options o = *config.solver;
    assert_int_equal(o.struct_size, sizeof o);
    expect_same_bits(500.0, o.operations_per_us);
    expect_same_bits(123457.0 / 500.0, o.step_budget_us);
    expect_same_bits(98765.0 / 500.0, o.call_budget_us);
    assert_int_equal(o.iteration_limit, 11);
    assert_int_equal(o.active_set_limit, 35);
    assert_int_equal(o.halving_limit, 4);
    assert_int_equal(o.attempt_limit, 2);
    expect_same_bits(2e-3, o.stretch_tolerance);
    expect_same_bits(0.11, o.penetration_tolerance);
    expect_same_bits(4e-5, o.contact_margin);
    harness_context_end(context, &memory);
    log_free(&log);
}

static void expect_replay_to_the_end(vbss_replay *replay)
{
    vbss_replay_report report;
    vbss_replay_info info;
    expect_ok(vbss_replay_get_info(replay, &info, sizeof info));
    if (info.library_version == vbss_version()) { /* which promises the same bits */
        expect_ok(replay_all(replay, &report));
        assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_ENDED);
        assert_int_equal(report.agreed_step, OLD_STEPS);
    }
}

static void old_log_replays_in_scenes_of_its_options(void **state)
{
    (void)state;
    const vbss_scene_capsule capsule = {{0.0, 0.0, -0.01}, {0.0, 0.0, 0.01}, 2e-3};
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    log_bytes log = read_old_log();
    vbss_replay *replay;
    vbss_scene *loaded, *made;
    uint32_t body;
    expect_ok(vbss_replay_create(context, log.bytes, log.count, &replay));
    expect_ok(vbss_replay_load_scene(replay, &loaded));
    expect_replay_to_the_end(replay);
    vbss_scene_config config = vbss_scene_config_default();
    vbss_scene_rigid_config rigid = vbss_scene_rigid_config_default();
    expect_ok(vbss_replay_get_scene_config(replay, &config));
    expect_ok(vbss_scene_create(context, &config, &made));
    rigid.kind = VBSS_SCENE_RIGID_FREE;
    rigid.capsules = &capsule;
    rigid.capsule_count = 1;
    rigid.position[1] = 2.05e-3;
    rigid.gravity[1] = -9.81;
    expect_ok(vbss_scene_add_rigid(made, &rigid, &body));
    expect_ok(vbss_replay_begin(replay, made));
    expect_replay_to_the_end(replay);
    harness_context_end(context, &memory);
    log_free(&log);
}

/* A scene that was created with other budgets than those of the log refuses it by name, but not other microseconds with the
 * same products. */
static void scene_of_other_operations_refuses_log(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    log_bytes log = read_old_log();
    vbss_replay *replay;
    vbss_scene *scene;
    vbss_scene_config config = vbss_scene_config_default();
    vbss_result result;
    const char *text = NULL;
    expect_ok(vbss_replay_create(context, log.bytes, log.count, &replay));
    expect_ok(vbss_replay_get_scene_config(replay, &config));
    vbss_solver_options other = *config.solver;
    other.call_budget_us += 1.0;
    config.solver = &other;
    expect_ok(vbss_scene_create(context, &config, &scene));
    expect_result(VBSS_ERROR_CORRUPT, vbss_replay_begin(replay, scene));
    expect_ok(vbss_context_get_last_error(context, &result, &text));
    assert_non_null(strstr(text, "call_budget"));
    other.call_budget_us = 98765.0 / 250.0;
    other.step_budget_us = 123457.0 / 250.0;
    other.operations_per_us = 250.0;
    expect_ok(vbss_scene_create(context, &config, &scene));
    result = vbss_replay_begin(replay, scene);
    assert_int_not_equal(result, VBSS_ERROR_OUT_OF_MEMORY);
    expect_ok(vbss_context_get_last_error(context, &result, &text));
    assert_null(strstr(text, "is not that of the log"));
    harness_context_end(context, &memory);
    log_free(&log);
}

/* ---- at run time */

/* Budgets for which steps are suspended, for which they are not, and none. */
static void change_budgets(vbss_scene *scene, uint32_t i)
{
    static const double budgets[][3] = {
        {500.0, 4.0, 500.0}, {40.0, 0.0, 500.0}, {500.0, 8.0, 262.5}, {0.0, 420.0, 500.0}};
    if (i % 25 == 0) {
        const double *b = budgets[i / 25 % 4];
        expect_ok(vbss_scene_set_budgets(scene, b[0], b[1], b[2]));
    }
}

static void budgets_changed_at_run_time_replay_to_the_bit(void **state)
{
    (void)state;
    enum { STEPS = 200 };
    harness_memory memory, other_memory;
    vbss_context *context = harness_context(&memory), *other = harness_context(&other_memory);
    vbss_scene *scene, *loaded;
    vbss_record *record;
    vbss_replay *replay;
    vbss_replay_report report;
    vbss_scene_statistics c;
    log_bytes log = {NULL, 0};
    vbss_record_config config = vbss_record_config_default();
    config.buffer_bytes = 1u << 22;
    config.snapshot_interval = 30;
    expect_ok(scene_scene_create(context, SCENE_SCENE_KNOT, &scene));
    expect_ok(vbss_record_create(scene, &config, &record));
    expect_ok(vbss_scene_set_recorder(scene, record));
    uint64_t suspended = 0, deferred_before = 0;
    for (uint32_t i = 0; i < STEPS; i++) {
        change_budgets(scene, i);
        expect_ok(scene_scene_step(scene, SCENE_SCENE_KNOT));
        expect_ok(vbss_scene_get_statistics(scene, &c, sizeof c));
        suspended += c.deferred > deferred_before;
        deferred_before = c.deferred;
    }
    assert_true(suspended > 5 && suspended < STEPS);
    expect_ok(vbss_record_end(record));
    log_take(&log, record);
    expect_ok(vbss_replay_create(other, log.bytes, log.count, &replay));
    expect_ok(vbss_replay_load_scene(replay, &loaded));
    expect_ok(replay_all(replay, &report));
    assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_ENDED);
    assert_int_equal(report.agreed_step, STEPS);
    expect_ok(
        vbss_replay_seek(replay, 95, &report, sizeof report)); /* from a snapshot amid changes */
    expect_ok(replay_all(replay, &report));
    assert_int_equal(report.agreed_step, STEPS);
    log_free(&log);
    harness_context_end(other, &other_memory);
    harness_context_end(context, &memory);
}

int test_budgets(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(old_log_gives_its_operations_in_microseconds),
        cmocka_unit_test(old_log_replays_in_scenes_of_its_options),
        cmocka_unit_test(scene_of_other_operations_refuses_log),
        cmocka_unit_test(budgets_changed_at_run_time_replay_to_the_bit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
