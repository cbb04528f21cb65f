/* A recorded session replays to the same task, step by step; where it does not, that is told; and it goes on live. */
#include "log_bytes.h"
#include "rig.h"

enum { STEPS = 260, CUT = 170 };

typedef struct trial {
    harness_memory memory;
    vbss_context *context;
    session_scene scene;
    vbss_session *session;
} trial;

static void begin(trial *t)
{
    memset(t, 0, sizeof *t);
    t->context = harness_context(&t->memory);
    expect_ok(session_scene_tying(t->context, 5, &t->scene));
    t->scene.config.hash_interval = 10;
}

static void start(trial *t)
{
    expect_ok(vbss_session_create(t->scene.scene, &t->scene.config, &t->session));
}

static uint64_t end(trial *t)
{
    uint64_t hash;
    expect_ok(vbss_session_get_hash(t->session, &hash));
    harness_context_end(t->context, &t->memory);
    return hash;
}

/* As it is recorded; *position: where the log is after step CUT. */
static uint64_t record(log_bytes *log, size_t *position)
{
    static trial t;
    vbss_record_config c;
    begin(&t);
    expect_ok(vbss_record_config_init(&c, sizeof c));
    c.snapshot_interval = 60;
    expect_ok(vbss_record_create(t.scene.scene, &c, &t.scene.config.record));
    start(&t);
    for (uint32_t i = 0; i < STEPS; i++) {
        expect_ok(session_scene_tie(&t.scene, t.session, t.scene.config.record));
        log_take(log, t.scene.config.record);
        *position = i + 1 == CUT ? log->count : *position;
    }
    expect_ok(vbss_record_end(t.scene.config.record));
    log_take(log, t.scene.config.record);
    return end(&t);
}

static void begin_replay(trial *t, const log_bytes *log, size_t count)
{
    begin(t);
    expect_ok(vbss_replay_create(t->context, log->bytes, count, &t->scene.config.replay));
    expect_ok(vbss_replay_begin(t->scene.config.replay, t->scene.scene));
}

/* Until something is told; returns the steps. */
static uint32_t replay(trial *t, vbss_result wanted)
{
    vbss_result result;
    uint32_t steps = 0;
    while ((result = vbss_session_step(t->session, 0.0, 0.0)) == VBSS_OK) {
        steps++;
    }
    expect_result(wanted, result);
    return steps;
}

static void log_replays_to_same_task(void **state)
{
    (void)state;
    static trial t;
    log_bytes log = {NULL, 0};
    size_t position = 0;
    uint64_t hash = record(&log, &position);
    begin_replay(&t, &log, log.count);
    start(&t);
    assert_int_equal(replay(&t, VBSS_ERROR_WRONG_STATE), STEPS);
    assert_true(end(&t) == hash);
    free(log.bytes);
}

/* The scene is the same to the bit, the task is not: with another limit, or without a detector. */
static void other_task_is_rejected(void **state)
{
    (void)state;
    static trial t;
    log_bytes log = {NULL, 0};
    size_t position = 0;
    (void)record(&log, &position);
    begin_replay(&t, &log, log.count);
    t.scene.config.dwell = 0.06;
    start(&t);
    assert_true(replay(&t, VBSS_ERROR_CORRUPT) < 2); /* at the first event */
    (void)end(&t);
    begin_replay(&t, &log, log.count);
    t.scene.config.knot_interval = 5;
    start(&t);
    assert_true(replay(&t, VBSS_ERROR_CORRUPT) < 2);
    (void)end(&t);
    begin_replay(&t, &log, log.count);
    start(&t);
    for (uint32_t i = 0; i < 55; i++) {
        expect_ok(vbss_session_step(t.session, 0.0, 0.0));
    }
    session_object *s;
    expect_ok(vbss_session_open(t.session, &s));
    s->tail_set.since += 1e-3;                           /* as a fault in the task would */
    assert_int_equal(replay(&t, VBSS_ERROR_CORRUPT), 4); /* at the next mark, of step 60 */
    (void)end(&t);
    free(log.bytes);
}

static void session_resumes_truncated_log(void **state)
{
    (void)state;
    static trial t;
    log_bytes log = {NULL, 0};
    size_t position = 0;
    uint64_t at;
    vbss_record *record_on;
    uint64_t hash = record(&log, &position);
    log.count = position + 21; /* within the record of a step */
    begin_replay(&t, &log, log.count);
    start(&t);
    assert_int_equal(replay(&t, VBSS_ERROR_TRUNCATED), CUT);
    expect_ok(vbss_record_resume(t.scene.config.replay, NULL, &record_on, &at));
    assert_true(at <= position);
    log.count = (size_t)at;
    expect_ok(vbss_session_set_record(t.session, record_on));
    for (uint32_t i = CUT; i < STEPS; i++) {
        expect_ok(session_scene_tie(&t.scene, t.session, record_on));
        log_take(&log, record_on);
    }
    expect_ok(vbss_record_end(record_on));
    log_take(&log, record_on);
    assert_true(end(&t) == hash);
    begin_replay(&t, &log, log.count); /* and all of it replays */
    start(&t);
    assert_int_equal(replay(&t, VBSS_ERROR_WRONG_STATE), STEPS);
    assert_true(end(&t) == hash);
    free(log.bytes);
}

/* Who knows no sessions passes over their marks. */
static void log_with_hashes_is_a_valid_log(void **state)
{
    (void)state;
    static trial t;
    log_bytes log = {NULL, 0};
    size_t position = 0;
    vbss_record_log_report report;
    vbss_replay_report found;
    (void)record(&log, &position);
    begin_replay(&t, &log, log.count);
    expect_ok(vbss_record_check_log(t.context, log.bytes, log.count, &report, sizeof report));
    expect_ok(report.result);
    assert_int_equal(report.steps, STEPS);
    expect_ok(vbss_replay_seek(t.scene.config.replay, 130, &found, sizeof found));
    assert_int_equal(found.agreed_step, 130);
    harness_context_end(t.context, &t.memory);
    free(log.bytes);
}

int test_log(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(log_replays_to_same_task),
        cmocka_unit_test(other_task_is_rejected),
        cmocka_unit_test(session_resumes_truncated_log),
        cmocka_unit_test(log_with_hashes_is_a_valid_log),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
