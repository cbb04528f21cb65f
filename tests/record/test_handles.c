/* Handles, pointers and callbacks that are no use. */
#include "fixture.h"

/* ---- handles */

static vbss_result call_take(void *handle)
{
    const uint8_t *bytes;
    uint64_t count;
    return vbss_record_take(handle, &bytes, &count);
}

static vbss_result call_apply_input(void *handle)
{
    const vbss_record_input input = {.kind = VBSS_RECORD_INPUT_UNPIN, .words = {1}};
    return vbss_record_apply_input(handle, &input, NULL);
}

static vbss_result call_end(void *handle)
{
    return vbss_record_end(handle);
}

static vbss_result call_create(void *handle) /* of a scene */
{
    vbss_record *record = (vbss_record *)&handle;
    vbss_result result = vbss_record_create(handle, NULL, &record);
    assert_null(record);
    return result;
}

static vbss_result call_info(void *handle)
{
    vbss_replay_info info;
    return vbss_replay_get_info(handle, &info, sizeof info);
}

static vbss_result call_config(void *handle)
{
    vbss_scene_config config;
    expect_ok(vbss_scene_config_init(&config, sizeof config));
    return vbss_replay_get_scene_config(handle, &config);
}

static vbss_result call_check(void *handle)
{
    uint64_t steps;
    return vbss_replay_check(handle, &steps);
}

static vbss_result call_begin(void *handle)
{
    return vbss_replay_begin(handle, NULL);
}

static vbss_result call_replay(void *handle)
{
    vbss_replay_report report;
    return vbss_replay_step(handle, &report, sizeof report);
}

static vbss_result call_seek(void *handle)
{
    vbss_replay_report report;
    return vbss_replay_seek(handle, 0, &report, sizeof report);
}

static vbss_result call_read(void *handle)
{
    vbss_replay_logged_step step;
    return vbss_replay_read(handle, 1, &step, sizeof step);
}

static vbss_result call_resume(void *handle)
{
    vbss_record *record;
    uint64_t begins;
    return vbss_record_resume(handle, NULL, &record, &begins);
}

static vbss_replay *the_replay; /* that begins in bad scenes */

static vbss_result call_begin_in(void *handle)
{
    return vbss_replay_begin(the_replay, handle);
}

static void bad_handles_are_rejected(void **state)
{
    (void)state;
    const harness_handle_call of_records[] = {call_take, call_apply_input, call_end};
    const harness_handle_call of_replays[] = {call_info,   call_config, call_check, call_begin,
                                              call_replay, call_seek,   call_read,  call_resume};
    const harness_handle_call of_scenes[] = {call_create, call_begin_in};
    stage s, other;
    vbss_record *record;
    stage_begin(&s, NULL);
    stage_begin(&other, NULL);
    log_bytes log = log_of(&s, NULL, 2);
    vbss_replay *replay = replay_of(&s, &log);
    the_replay = replay_of(&s, &log);
    expect_ok(vbss_record_create(s.scene, NULL, &record));
    expect_ok(vbss_record_destroy(record));
    expect_ok(vbss_replay_destroy(replay));
    harness_refuses_bad_handles(s.context, record, of_records, 3);
    harness_refuses_bad_handles(s.context, replay, of_replays, 8);
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_replay_begin(the_replay, other.scene));
    expect_ok(vbss_replay_begin(the_replay, s.scene));
    expect_ok(stage_leave(&s));
    vbss_replay_report report;
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_replay_step(the_replay, &report, sizeof report));
    assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_STOPPED);
    harness_refuses_bad_handles(s.context, s.scene, of_scenes, 2);
    expect_ok(vbss_record_destroy(NULL));
    expect_ok(vbss_replay_destroy(NULL));
    stage_end(&other);
    stage_end(&s);
    log_free(&log);
}

static void null_pointers_are_rejected(void **state)
{
    (void)state;
    stage s;
    vbss_replay *replay;
    vbss_replay_report report;
    stage_begin(&s, NULL);
    log_bytes log = log_of(&s, NULL, 2);
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_record_create(s.scene, NULL, NULL));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_replay_create(s.context, log.bytes, 9, NULL));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_replay_create(s.context, NULL, 9, &replay));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_replay_create(NULL, log.bytes, 9, &replay));
    assert_null(replay);
    replay = replay_of(&s, &log);
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_replay_check(replay, NULL));
    expect_result(VBSS_ERROR_WRONG_STATE, vbss_replay_step(replay, &report, sizeof report));
    assert_non_null(strstr(last_text(s.context), "not begun"));
    stage_end(&s);
    log_free(&log);
}

/* ---- callbacks */

typedef struct listener {
    vbss_record *record;
    vbss_replay *replay;
    uint32_t warnings, refused;
} listener;

static void listen(void *user, vbss_log_level level, const char *message)
{
    listener *l = user;
    vbss_replay_report report;
    const vbss_record_input input = {.kind = VBSS_RECORD_INPUT_UNPIN, .words = {1}};
    (void)message;
    l->warnings += level == VBSS_LOG_WARNING;
    if (l->record != NULL) {
        l->refused += vbss_record_apply_input(l->record, &input, NULL) == VBSS_ERROR_BUSY;
        l->refused += call_take(l->record) == VBSS_ERROR_BUSY;
        l->refused += vbss_replay_step(l->replay, &report, sizeof report) == VBSS_ERROR_BUSY;
    }
}

static void recording_inside_callback_is_rejected(void **state)
{
    (void)state;
    listener l = {NULL, NULL, 0, 0};
    stage s;
    memset(&s, 0, sizeof s);
    const stage_options options = stage_defaults();
    vbss_context_config config = harness_watched_config(&s.memory);
    config.log = listen;
    config.log_user = &l;
    expect_ok(vbss_context_create(&config, &s.context));
    expect_ok(stage_make(&s, &options));
    log_bytes log = log_of(&s, NULL, 3);
    vbss_replay *replay = replay_of(&s, &log);
    vbss_record *record;
    expect_ok(vbss_replay_begin(replay, s.scene));
    expect_ok(vbss_record_create(s.scene, NULL, &record));
    assert_int_equal(l.warnings, 0);
    l.record = record;
    l.replay = replay;
    uint64_t hash = stage_hash(&s);
    expect_ok(vbss_scene_set_recorder(s.scene, record));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_scene_step(s.scene, 2.0));
    assert_int_equal(l.refused, 3);
    assert_true(stage_hash(&s) == hash);
    l.record = NULL;

    /* And a log of another version of the library is replayed, with a warning. */
    expect_ok(vbss_replay_destroy(replay));
    log_place head = log_find(&log, VBSS_CODE('H', 'E', 'A', 'D'), 1);
    log.bytes[head.at + 8 + 8 + 8] ^= 1;
    log_seal(&log);
    replay = replay_of(&s, &log);
    expect_ok(vbss_replay_begin(replay, s.scene));
    assert_int_equal(l.warnings, 1);
    expect_ok(vbss_record_destroy(record));
    expect_ok(vbss_replay_destroy(replay));
    expect_ok(stage_leave(&s));
    stage_end(&s);
    log_free(&log);
}

int test_handles(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bad_handles_are_rejected),
        cmocka_unit_test(null_pointers_are_rejected),
        cmocka_unit_test(recording_inside_callback_is_rejected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
