/* The coach is part of the session's state: it replays, is saved and restored, and costs nothing when it is off. */
#include <string.h>

#include "followed.h"

enum { SAVED = 60, STEPS = 120 };

static vbss_session_coaching coaching_of(vbss_session *session)
{
    vbss_session_coaching c;
    expect_ok(vbss_session_get_coaching(session, &c, sizeof c));
    return c;
}

static void expect_same(const vbss_session_coaching *a, const vbss_session_coaching *b)
{
    assert_memory_equal(a, b, sizeof *a);
}

static void begin_coached(session_trial *t)
{
    trial_begin(t);
    t->scene.config.coaching = 1;
}

/* With what the coach says after each step. */
static void record_coached(log_bytes *log, vbss_session_coaching was[TRIAL_STEPS])
{
    static session_trial t;
    begin_coached(&t);
    trial_begin_record(&t);
    trial_start(&t);
    for (uint32_t i = 0; i < TRIAL_STEPS; i++) {
        expect_ok(session_scene_tie(&t.scene, t.session, t.scene.config.record));
        log_take(log, t.scene.config.record);
        was[i] = coaching_of(t.session);
    }
    expect_ok(vbss_record_end(t.scene.config.record));
    log_take(log, t.scene.config.record);
    trial_end(&t);
}

static void follow(session_trial *t, const log_bytes *log, uint32_t coaching)
{
    trial_begin(t);
    t->scene.config.coaching = coaching;
    expect_ok(vbss_replay_create(t->context, log->bytes, log->count, &t->scene.config.replay));
    expect_ok(vbss_replay_begin(t->scene.config.replay, t->scene.scene));
    trial_start(t);
}

static vbss_session_coaching said[TRIAL_STEPS];

static void replay_says_the_same(void **state)
{
    (void)state;
    static session_trial t;
    log_bytes log = {NULL, 0};
    record_coached(&log, said);
    assert_int_not_equal(said[TRIAL_STEPS - 1].goal, VBSS_SESSION_GOAL_NONE);
    follow(&t, &log, 1);
    for (uint32_t i = 0; i < TRIAL_STEPS; i++) {
        expect_ok(vbss_session_step(t.session, 0.0, 0.0));
        const vbss_session_coaching is = coaching_of(t.session);
        expect_same(&said[i], &is);
    }
    expect_ok(vbss_session_seek(t.session, 130));
    const vbss_session_coaching is = coaching_of(t.session);
    expect_same(&said[129], &is);
    trial_end(&t);
    follow(&t, &log, 0); /* hashes of the log do not depend on the coach */
    for (uint32_t i = 0; i < TRIAL_STEPS; i++) {
        expect_ok(vbss_session_step(t.session, 0.0, 0.0));
    }
    trial_end(&t);
    free(log.bytes);
}

typedef struct saved {
    uint8_t *scene, *session;
    uint64_t scene_size, session_size;
} saved;

static saved save(const session_trial *t)
{
    saved s = {0};
    expect_ok(vbss_scene_save(t->scene.scene, NULL, 0, &s.scene_size) == VBSS_ERROR_CAPACITY
                  ? VBSS_OK
                  : VBSS_ERROR_WRONG_STATE);
    (void)vbss_session_save(t->session, NULL, 0, &s.session_size);
    s.scene = malloc(s.scene_size);
    s.session = malloc(s.session_size);
    expect_ok(vbss_scene_save(t->scene.scene, s.scene, s.scene_size, &s.scene_size));
    expect_ok(vbss_session_save(t->session, s.session, s.session_size, &s.session_size));
    return s;
}

static void restored_coach_goes_on(void **state)
{
    (void)state;
    static session_trial t;
    begin_coached(&t);
    trial_start(&t);
    saved s = {0};
    for (uint32_t i = 0; i < STEPS; i++) {
        expect_ok(session_scene_tie(&t.scene, t.session, NULL));
        said[i] = coaching_of(t.session);
        s = i + 1 == SAVED ? save(&t) : s;
    }
    expect_ok(vbss_scene_restore(t.scene.scene, s.scene, s.scene_size));
    expect_ok(vbss_session_restore(t.session, s.session, s.session_size));
    vbss_session_coaching is = coaching_of(t.session);
    expect_same(&said[SAVED - 1], &is);
    for (uint32_t i = SAVED; i < STEPS; i++) {
        expect_ok(session_scene_tie(&t.scene, t.session, NULL));
        is = coaching_of(t.session);
        expect_same(&said[i], &is);
    }
    trial_end(&t);
    free(s.scene);
    free(s.session);
}

static void state_without_coach_is_refused(void **state)
{
    (void)state;
    static session_trial t;
    uint64_t before, after;
    trial_begin(&t);
    trial_start(&t);
    saved s = save(&t);
    t.scene.config.coaching = 1;
    vbss_session *coached;
    expect_ok(vbss_session_create(t.scene.scene, &t.scene.config, &coached));
    expect_ok(vbss_session_get_hash(coached, &before));
    assert_int_not_equal(vbss_session_restore(coached, s.session, s.session_size), VBSS_OK);
    expect_ok(vbss_session_get_hash(coached, &after));
    assert_true(before == after);
    trial_end(&t);
    free(s.scene);
    free(s.session);
}

static void coaching_is_refused_without_a_coach(void **state)
{
    (void)state;
    static session_trial t;
    vbss_session_coaching c;
    trial_begin(&t);
    trial_start(&t);
    expect_result(VBSS_ERROR_WRONG_STATE, vbss_session_get_coaching(t.session, &c, sizeof c));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_session_get_coaching(NULL, &c, sizeof c));
    expect_ok(session_scene_tie(&t.scene, t.session, NULL));
    trial_end(&t);
    begin_coached(&t);
    trial_start(&t);
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_session_get_coaching(t.session, NULL, sizeof c));
    expect_result(VBSS_ERROR_STRUCT_SIZE, vbss_session_get_coaching(t.session, &c, 8));
    expect_ok(vbss_session_get_coaching(t.session, &c, sizeof c)); /* before the first step */
    assert_int_equal(c.goal, VBSS_SESSION_GOAL_NONE);
    assert_int_equal(c.tool, VBSS_METRICS_TOOL_NONE);
    trial_end(&t);
}

static void queries_change_nothing(void **state)
{
    (void)state;
    static session_trial t;
    uint64_t before, after;
    begin_coached(&t);
    trial_start(&t);
    for (uint32_t i = 0; i < SAVED; i++) {
        expect_ok(session_scene_tie(&t.scene, t.session, NULL));
    }
    expect_ok(vbss_session_get_hash(t.session, &before));
    const uint64_t allocations = t.memory.calls;
    (void)coaching_of(t.session);
    assert_true(allocations == t.memory.calls);
    expect_ok(vbss_session_get_hash(t.session, &after));
    assert_true(before == after);
    trial_end(&t);
}

int test_coach_state(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(replay_says_the_same),
        cmocka_unit_test(restored_coach_goes_on),
        cmocka_unit_test(state_without_coach_is_refused),
        cmocka_unit_test(coaching_is_refused_without_a_coach),
        cmocka_unit_test(queries_change_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
