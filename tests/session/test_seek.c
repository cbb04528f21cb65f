/* A session goes to a step of its log from the states that are in it, to the same bits, and goes on live from there. */
#include "followed.h"

static void session_snapshots_take_below_a_third_of_log(void **state)
{
    (void)state;
    static trial_log was;
    state_place last;
    trial_record(&was);
    uint32_t states = trial_find_states(&was.log, &last);
    print_message("%u states in %zu bytes, the last of %zu after step %u\n", states, was.log.count,
                  last.length, last.step);
    assert_true(states >= 2 && last.step > 0 && last.step % TRIAL_SNAPSHOTS == 0);
    assert_true((states - 1) * last.length * 2 < was.log.count);
    free(was.log.bytes);
}

/* Forwards, backwards, to the begin, to a state and beside one; and on from there to the end. */
static void seek_to_any_step_is_bit_equal(void **state)
{
    (void)state;
    static const uint32_t targets[] = {150, 30, 0, TRIAL_STEPS, 20, 60, 61, 1, 259};
    static trial_log was;
    static session_trial t;
    trial_record(&was);
    trial_follow(&t, &was.log);
    for (size_t i = 0; i < sizeof targets / sizeof targets[0]; i++) {
        expect_ok(vbss_session_seek(t.session, targets[i]));
        trial_expect_at(&t, &was, targets[i]);
    }
    expect_ok(vbss_session_seek(t.session, 200));
    for (uint32_t i = 201; i <= TRIAL_STEPS; i++) {
        expect_ok(vbss_session_step(t.session, 0.0, 0.0));
        trial_expect_at(&t, &was, i);
    }
    expect_result(VBSS_ERROR_WRONG_STATE, vbss_session_step(t.session, 0.0, 0.0));
    trial_end(&t);
    free(was.log.bytes);
}

/* The steps before the newest state are not made again: a log whose early steps cannot be made shows it. */
static void seek_replays_only_from_last_snapshot(void **state)
{
    (void)state;
    static trial_log was;
    static session_trial t;
    state_place last;
    vbss_scene_statistics before, after;
    trial_record(&was);
    (void)trial_find_states(&was.log, &last);
    trial_follow(&t, &was.log);
    expect_ok(vbss_session_seek(t.session, last.step));
    trial_expect_at(&t, &was, last.step);
    session_object *s;
    expect_ok(vbss_session_open(t.session, &s));
    double h = s->h; /* of a step that was made; restored sessions have made none */
    assert_true(h == 0.0);
    expect_ok(vbss_scene_get_statistics(t.scene.scene, &before, sizeof before));
    expect_ok(vbss_session_step(t.session, 0.0, 0.0));
    expect_ok(vbss_scene_get_statistics(t.scene.scene, &after, sizeof after));
    assert_true(after.steps == before.steps + 1);
    trial_end(&t);
    free(was.log.bytes);
}

static void on_event(void *user, const vbss_session_event *event)
{
    (void)event;
    ++*(uint32_t *)user;
}

static void seek_is_silent_but_events_are_readable(void **state)
{
    (void)state;
    static trial_log was;
    static session_trial t;
    uint32_t heard = 0;
    vbss_session_status status;
    vbss_session_event event;
    trial_record(&was);
    trial_begin(&t);
    t.scene.config.listen = on_event;
    t.scene.config.user = &heard;
    expect_ok(vbss_replay_create(t.context, was.log.bytes, was.log.count, &t.scene.config.replay));
    expect_ok(vbss_replay_begin(t.scene.config.replay, t.scene.scene));
    trial_start(&t);
    expect_ok(vbss_session_seek(t.session, TRIAL_STEPS));
    assert_int_equal(heard, 0);
    expect_ok(vbss_session_get_status(t.session, &status, sizeof status));
    assert_true(status.event_count > 3 && status.steps == TRIAL_STEPS);
    expect_ok(vbss_session_get_event(t.session, 0, &event, sizeof event));
    assert_int_equal(event.kind, VBSS_SESSION_EVENT_APPEARED);
    trial_end(&t);
    free(was.log.bytes);
}

/* As after a loss of power: the last complete step is sought, and the session_trial goes on with the same log. */
static void live_session_continues_from_logged_state(void **state)
{
    (void)state;
    static trial_log was;
    static session_trial t;
    enum { CUT = 170 };
    uint64_t steps, at;
    vbss_record *on;
    trial_record(&was);
    log_bytes log = was.log;
    log.count = was.ends[CUT] + 21; /* within the record of a step */
    trial_follow(&t, &log);
    expect_result(VBSS_ERROR_TRUNCATED, vbss_replay_check(t.scene.config.replay, &steps));
    assert_int_equal(steps, CUT);
    expect_ok(vbss_session_seek(t.session, steps));
    trial_expect_at(&t, &was, CUT);
    expect_ok(vbss_record_resume(t.scene.config.replay, NULL, &on, &at));
    expect_ok(vbss_session_set_record(t.session, on));
    log.count = (size_t)at;
    for (uint32_t i = CUT + 1; i <= TRIAL_STEPS; i++) {
        expect_ok(session_scene_tie(&t.scene, t.session, on));
        log_take(&log, on);
    }
    trial_expect_at(&t, &was, TRIAL_STEPS);
    expect_ok(vbss_record_end(on));
    log_take(&log, on);
    trial_end(&t);
    trial_follow(&t, &log);
    expect_ok(vbss_session_seek(t.session, 255));
    trial_expect_at(&t, &was, 255);
    trial_end(&t);
    free(log.bytes);
}

/* A record that begins in the middle of a session_trial has the session's state at its begin. */
static void mid_trial_log_is_followed(void **state)
{
    (void)state;
    static trial_log was;
    static session_trial t;
    enum { MIDDLE = 90 };
    log_bytes log = {NULL, 0};
    trial_record(&was);
    trial_begin(&t);
    trial_start(&t);
    for (uint32_t i = 0; i < MIDDLE; i++) {
        expect_ok(session_scene_tie(&t.scene, t.session, NULL));
    }
    trial_begin_record(&t);
    expect_ok(vbss_session_set_record(t.session, t.scene.config.record));
    for (uint32_t i = MIDDLE; i < TRIAL_STEPS; i++) {
        expect_ok(session_scene_tie(&t.scene, t.session, t.scene.config.record));
        log_take(&log, t.scene.config.record);
    }
    trial_end(&t);
    trial_follow(&t, &log);
    expect_ok(vbss_session_seek(t.session, 0));
    trial_expect_at(&t, &was, MIDDLE);
    expect_ok(vbss_session_seek(t.session, TRIAL_STEPS - MIDDLE));
    trial_expect_at(&t, &was, TRIAL_STEPS);
    trial_end(&t);
    free(log.bytes);
    free(was.log.bytes);
}

static void impossible_seek_changes_nothing(void **state)
{
    (void)state;
    static trial_log was;
    static session_trial t;
    trial_record(&was);
    trial_follow(&t, &was.log);
    expect_ok(vbss_session_seek(t.session, 33));
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_session_seek(t.session, TRIAL_STEPS + 1));
    trial_expect_at(&t, &was, 33);
    expect_ok(vbss_session_step(t.session, 0.0, 0.0));
    trial_expect_at(&t, &was, 34);
    expect_ok(vbss_session_set_record(t.session, NULL));
    expect_result(VBSS_ERROR_WRONG_STATE, vbss_session_seek(t.session, 1)); /* follows nothing */
    trial_end(&t);
    free(was.log.bytes);
}

/* A log of a scene without a session, as there were before. */
static void log_without_snapshots_is_reported(void **state)
{
    (void)state;
    static session_trial t;
    log_bytes log = {NULL, 0};
    trial_begin(&t);
    trial_begin_record(&t);
    expect_ok(vbss_scene_set_recorder(t.scene.scene, t.scene.config.record));
    for (uint32_t i = 0; i < 5; i++) {
        expect_ok(vbss_scene_step(t.scene.scene, 1e-3));
    }
    log_take(&log, t.scene.config.record);
    trial_end(&t);
    trial_follow(&t, &log);
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_session_seek(t.session, 3));
    expect_ok(vbss_session_step(t.session, 0.0, 0.0)); /* it still follows from the begin */
    trial_end(&t);
    free(log.bytes);
}

/* A step of the scene alone is in the log of the record that the session has, and of no other. */
static void session_attaches_its_record(void **state)
{
    (void)state;
    static session_trial t;
    const uint8_t *bytes;
    uint64_t count;
    trial_begin(&t);
    trial_start(&t);
    trial_begin_record(&t);
    vbss_record *record = t.scene.config.record;
    expect_ok(vbss_session_set_record(t.session, record));
    expect_ok(vbss_record_take(record, &bytes, &count));
    expect_ok(vbss_scene_step(t.scene.scene, 1e-3));
    expect_ok(vbss_record_take(record, &bytes, &count));
    assert_true(count > 0);
    expect_ok(vbss_session_set_record(t.session, NULL));
    expect_ok(vbss_scene_step(t.scene.scene, 1e-3));
    expect_ok(vbss_record_take(record, &bytes, &count));
    assert_int_equal(count, 0);
    expect_result(VBSS_ERROR_WRONG_STATE, vbss_session_set_record(t.session, record));
    trial_end(&t);
}

int test_seek(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(session_snapshots_take_below_a_third_of_log),
        cmocka_unit_test(seek_to_any_step_is_bit_equal),
        cmocka_unit_test(seek_replays_only_from_last_snapshot),
        cmocka_unit_test(seek_is_silent_but_events_are_readable),
        cmocka_unit_test(live_session_continues_from_logged_state),
        cmocka_unit_test(mid_trial_log_is_followed),
        cmocka_unit_test(impossible_seek_changes_nothing),
        cmocka_unit_test(log_without_snapshots_is_reported),
        cmocka_unit_test(session_attaches_its_record),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
