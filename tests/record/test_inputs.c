/* Inputs of a recorded scene: which are logged, which are refused, and the room they have. */
#include "recorder.h"

static const double somewhere[3] = {0.05, 0.02, 0.01};

static vbss_record_config config_of(uint32_t inputs, uint64_t buffer)
{
    vbss_record_config config;
    expect_ok(vbss_record_config_init(&config, sizeof config));
    config.input_capacity = inputs;
    config.buffer_bytes = buffer;
    config.snapshot_interval = 0;
    return config;
}

/* ---- refused */

static void inputs_rejected_by_scene_are_not_recorded(void **state)
{
    (void)state;
    recorder r;
    vbss_thread_attachment bad;
    uint32_t id = 77;
    recorder_begin(&r, NULL);
    stage_step(&r.s, r.record);
    uint64_t hash = stage_hash(&r.s);
    double far[3] = {0.0, 1001.0, 0.0};
    expect_ok(vbss_thread_attachment_init(&bad, sizeof bad));
    bad.node = 31;
    vbss_record *record = r.record;
    const uint32_t tool = r.s.tools[0], body = r.s.body, force = r.s.force;
    vbss_scene *scene = r.s.scene;
    vbss_thread *thread = r.s.thread;
    expect_ok(vbss_scene_set_recorder(scene, record));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_scene_set_rigid_target(scene, tool, NULL, NULL));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_scene_set_rigid_target(scene, tool, far, NULL));
    expect_result(VBSS_ERROR_INCOMPATIBLE,
                  vbss_scene_set_rigid_target(scene, body, somewhere, NULL));
    far[1] = harness_bad_numbers[0];
    expect_result(VBSS_ERROR_NOT_FINITE, vbss_scene_set_rigid_target(scene, tool, far, NULL));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_scene_pin_thread(scene, body, 9, 0, NULL, NULL));
    expect_result(VBSS_ERROR_IN_USE,
                  vbss_scene_pin_thread(scene, body, 0, tool, NULL, &id)); /* held */
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_scene_unpin_thread(scene, 9));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_thread_attach(thread, NULL, &id));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_thread_attach(thread, &bad, NULL));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_thread_attach(thread, &bad, &id));
    bad.struct_size = 111;
    expect_result(VBSS_ERROR_STRUCT_SIZE, vbss_thread_attach(thread, &bad, &id));
    expect_result(VBSS_ERROR_NULL_ARGUMENT,
                  vbss_thread_set_attachment_target(thread, force, NULL, NULL));
    expect_result(VBSS_ERROR_NOT_FOUND,
                  vbss_thread_set_attachment_target(thread, 999, somewhere, NULL));
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_thread_detach(thread, 999));
    vbss_record_input input = {.kind = VBSS_RECORD_INPUT_ATTACHMENT_TARGET, .words = {tool, force}};
    expect_result(VBSS_ERROR_INCOMPATIBLE, vbss_record_apply_input(record, &input, NULL));
    input = (vbss_record_input){.kind = VBSS_RECORD_INPUT_ATTACH, .words = {tool}};
    expect_result(VBSS_ERROR_INCOMPATIBLE, vbss_record_apply_input(record, &input, NULL));
    expect_result(VBSS_ERROR_NOT_FINITE, vbss_scene_step(scene, harness_bad_numbers[1]));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_scene_step(scene, 0.2));
    assert_int_equal(id, 77);
    assert_true(stage_hash(&r.s) == hash);
    stage_step(&r.s, record);
    expect_ok(vbss_record_end(record));
    recorder_end(&r, 2);
}

/* Inputs wait for the step that succeeds. */
static void inputs_of_failed_step_belong_to_next(void **state)
{
    (void)state;
    recorder r;
    recorder_begin(&r, NULL);
    stage_report(&r.s, r.record);
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_scene_step(r.s.scene, -1.0));
    expect_ok(vbss_scene_step(r.s.scene, 1e-3));
    expect_ok(vbss_scene_step(r.s.scene, 0.5e-3)); /* and steps may differ in length */
    expect_ok(vbss_record_end(r.record));
    recorder_end(&r, 2);
}

/* The scene was in the middle of it, and went back. */
static void undone_step_leaves_no_trace(void **state)
{
    (void)state;
    stage_options options = stage_defaults();
    options.contact_capacity = 3;
    options.speed_limit = 0.0;              /* the tool is there in one step */
    options.mode = VBSS_SCENE_MODE_OFFLINE; /* or some of the steps would wait instead */
    stage s, other;
    vbss_record *record;
    vbss_replay_report report;
    uint64_t steps = 0;
    stage_begin(&s, &options);
    expect_ok(vbss_record_create(s.scene, NULL, &record));
    expect_ok(vbss_scene_set_recorder(s.scene, record));
    const double here[3] = {0.04, 0.02, 0.0}, along[3] = {0.04, 0.0301, 0.0};
    const double turned[4] = {1.0, 0.0, 1.0, 0.0};
    for (uint64_t i = 0; i < 10; i++) {
        /* through the thread and along it: too much for three contacts */
        expect_ok(vbss_scene_set_rigid_target(s.scene, s.tools[1], along, turned));
        expect_result(VBSS_ERROR_CAPACITY, vbss_scene_step(s.scene, 1e-3));
        expect_ok(vbss_scene_set_rigid_target(s.scene, s.tools[1], here, NULL));
        expect_ok(vbss_scene_step(s.scene, 1e-3));
        steps++;
    }
    expect_ok(vbss_record_end(record));
    log_bytes log = {NULL, 0};
    log_take(&log, record);
    stage_begin(&other, &options);
    vbss_replay *replay = replay_of(&other, &log);
    expect_ok(vbss_replay_begin(replay, other.scene));
    expect_ok(replay_all(replay, &report));
    assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_ENDED);
    assert_int_equal(report.agreed_step, steps);
    assert_true(stage_hash(&other) == stage_hash(&s));
    stage_end(&other);
    stage_end(&s);
    log_free(&log);
}

/* ---- room */

static void missing_input_space_is_reported(void **state)
{
    (void)state;
    recorder r;
    uint32_t id = 77;
    vbss_thread_attachment a;
    vbss_record_config config = config_of(2, 4096);
    recorder_begin(&r, &config);
    expect_ok(vbss_thread_attachment_init(&a, sizeof a));
    a.kind = VBSS_THREAD_ATTACHMENT_MASS;
    expect_ok(vbss_scene_set_recorder(r.s.scene, r.record));
    for (int round = 0; round < 2; round++) {
        expect_ok(vbss_scene_set_rigid_target(r.s.scene, r.s.ball, somewhere, NULL));
        expect_ok(vbss_thread_set_attachment_target(r.s.thread, r.s.force, somewhere, NULL));
        uint64_t hash = stage_hash(&r.s);
        expect_result(VBSS_ERROR_CAPACITY, vbss_thread_detach(r.s.thread, r.s.force));
        expect_result(VBSS_ERROR_CAPACITY, vbss_thread_attach(r.s.thread, &a, &id));
        assert_true(stage_hash(&r.s) == hash && id == 77);
        expect_ok(vbss_scene_step(r.s.scene, 1e-3));
    }
    expect_ok(vbss_record_end(r.record));
    recorder_end(&r, 2);
}

static void full_log_is_reported_before_step(void **state)
{
    (void)state;
    recorder r;
    vbss_record_config config = config_of(64, 4096);
    uint32_t full = 0;
    recorder_begin(&r, &config);
    for (uint32_t i = 0; i < 800; i++) {
        stage_report(&r.s, r.record);
        uint64_t hash = stage_hash(&r.s);
        vbss_result result = vbss_scene_step(r.s.scene, 1e-3);
        if (result != VBSS_OK) {
            expect_result(VBSS_ERROR_CAPACITY, result);
            assert_true(stage_hash(&r.s) == hash);
            full++;
            log_take(&r.log, r.record);
            expect_ok(vbss_scene_step(r.s.scene, 1e-3));
        }
        r.s.step++;
    }
    assert_true(full >= 2 && full <= 8);
    expect_ok(vbss_record_end(r.record)); /* for which there is always room */
    recorder_end(&r, 800);
}

/* However full it is. */
static void space_for_end_record_is_reserved(void **state)
{
    (void)state;
    for (uint64_t more = 0; more < 160; more++) {
        harness_memory memory;
        vbss_context *context = harness_context(&memory);
        vbss_scene *scene;
        vbss_record *record;
        vbss_record_config config = config_of(0, 4096 + more);
        vbss_replay *replay;
        uint64_t made = 0, steps;
        log_bytes log = {NULL, 0};
        expect_ok(empty_scene(context, &scene));
        expect_ok(vbss_record_create(scene, &config, &record));
        expect_ok(vbss_scene_set_recorder(scene, record));
        while (vbss_scene_step(scene, 1e-3) == VBSS_OK) {
            made++;
        }
        assert_true(made >= 4096 / 160);
        expect_ok(vbss_record_end(record));
        log_take(&log, record);
        expect_ok(vbss_replay_create(context, log.bytes, log.count, &replay));
        expect_ok(vbss_replay_check(replay, &steps));
        assert_int_equal(steps, made);
        log_free(&log);
        harness_context_end(context, &memory);
    }
}

static void bytes_are_taken_once(void **state)
{
    (void)state;
    recorder r;
    const uint8_t *bytes;
    uint64_t count;
    recorder_begin(&r, NULL);
    expect_ok(vbss_record_take(r.record, &bytes, &count)); /* the begin */
    assert_true(count > 1000 && memcmp(bytes, "VBSL", 4) == 0);
    log_bytes first = {(uint8_t *)bytes, (size_t)count};
    r.log = log_copy(&first);
    expect_ok(vbss_record_take(r.record, &bytes, &count));
    assert_true(count == 0 && bytes != NULL);
    stage_report(&r.s, r.record);
    expect_ok(vbss_record_take(r.record, &bytes, &count));
    assert_int_equal(count, 0); /* inputs come with their step */
    expect_ok(vbss_scene_step(r.s.scene, 1e-3));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_record_take(r.record, NULL, &count));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_record_take(r.record, &bytes, NULL));
    expect_ok(vbss_record_end(r.record));
    recorder_end(&r, 1);
}

/* ---- the end */

static void after_end_only_taking_is_allowed(void **state)
{
    (void)state;
    recorder r;
    const vbss_record_input input = {.kind = VBSS_RECORD_INPUT_UNPIN, .words = {1}};
    recorder_begin(&r, NULL);
    stage_step(&r.s, r.record);
    expect_ok(vbss_record_end(r.record));
    expect_result(VBSS_ERROR_WRONG_STATE, vbss_record_end(r.record));
    expect_result(VBSS_ERROR_WRONG_STATE, vbss_scene_set_recorder(r.s.scene, r.record));
    expect_result(VBSS_ERROR_WRONG_STATE, vbss_record_apply_input(r.record, &input, NULL));
    recorder_end(&r, 1);
}

static void record_outlives_scene(void **state)
{
    (void)state;
    recorder r;
    const vbss_record_input input = {.kind = VBSS_RECORD_INPUT_UNPIN, .words = {1}};
    recorder_begin(&r, NULL);
    stage_step(&r.s, r.record);
    expect_ok(stage_leave(&r.s));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_record_apply_input(r.record, &input, NULL));
    expect_ok(vbss_record_end(r.record));
    recorder_end(&r, 1);
}

static void inputs_after_last_step_are_dropped(void **state)
{
    (void)state;
    recorder r;
    recorder_begin(&r, NULL);
    stage_step(&r.s, r.record);
    expect_ok(vbss_scene_set_rigid_target(r.s.scene, r.s.ball, somewhere, NULL));
    expect_ok(vbss_record_end(r.record));
    recorder_end(&r, 1);
}

int test_inputs(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(inputs_rejected_by_scene_are_not_recorded),
        cmocka_unit_test(inputs_of_failed_step_belong_to_next),
        cmocka_unit_test(undone_step_leaves_no_trace),
        cmocka_unit_test(missing_input_space_is_reported),
        cmocka_unit_test(full_log_is_reported_before_step),
        cmocka_unit_test(space_for_end_record_is_reserved),
        cmocka_unit_test(bytes_are_taken_once),
        cmocka_unit_test(after_end_only_taking_is_allowed),
        cmocka_unit_test(record_outlives_scene),
        cmocka_unit_test(inputs_after_last_step_are_dropped),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
