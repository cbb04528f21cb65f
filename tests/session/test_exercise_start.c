/* Starts within the task: a session that begins where another one was; its states, its log. */
#include <string.h>

#include "fixtures/needle_scenes.h"
#include "log_bytes.h"
#include "rig.h"

#define STEP RIG_STEP

enum { ROOM = 1 << 21, LIFTED = 800, HELD = 2200, MORE = 400 };

static uint8_t scene_bytes[ROOM], session_bytes[ROOM];
static uint64_t scene_count, session_count;

static vbss_session_exercise_state exercise_of(const rig *r)
{
    vbss_session_exercise_state state;
    expect_ok(vbss_session_get_exercise(r->session, &state, sizeof state));
    return state;
}

static uint64_t hash_of(const rig *r)
{
    uint64_t hash;
    expect_ok(vbss_session_get_hash(r->session, &hash));
    return hash;
}

/* ---- of a scripted observation */

/* A session whose stitch is made, saved; then another one over the same scene. */
static void make_second(rig *r, vbss_session_exercise exercise)
{
    rig_begin_coached(r);
    rig_to_tail(r);
    rig_run(r, 7.0);
    expect_ok(vbss_session_save(r->session, session_bytes, ROOM, &session_count));
    expect_ok(vbss_session_destroy(r->session));
    vbss_metrics_config c;
    expect_ok(vbss_metrics_config_init(&c, sizeof c));
    c.duration = 60.0;
    expect_ok(vbss_metrics_create(r->context, &c, &r->scene.config.metrics));
    r->scene.config.exercise = exercise;
    expect_ok(vbss_session_create(r->scene.scene, &r->scene.config, &r->session));
    expect_ok(vbss_session_open(r->session, &r->s));
    r->read = 0;
}

static void facts_stay_and_all_else_begins(void **state)
{
    (void)state;
    static rig r;
    vbss_metrics_report report;
    make_second(&r, VBSS_SESSION_EXERCISE_DOUBLE_THROW);
    expect_ok(vbss_session_begin_at(r.session, session_bytes, session_count));
    const vbss_session_status now = rig_status(&r);
    assert_int_equal(now.phase, VBSS_SESSION_PHASE_THROW_1);
    assert_int_equal(now.threaded, 3);
    assert_int_equal(now.tail_set, 1);
    assert_int_equal(now.holder, VBSS_METRICS_TOOL_RIGHT);
    assert_int_equal(now.event_count, 0);
    assert_int_equal(now.steps, 0);
    expect_near(0.0, now.time, 0.0);
    rig_run(&r, STEP);
    rig_expect(&r, VBSS_SESSION_EVENT_APPEARED, 0, 0);
    rig_run(&r, 0.1);
    rig_expect_quiet(&r);
    assert_int_equal(rig_coaching(&r).goal, VBSS_SESSION_GOAL_WIND);
    rig_tie(&r, 0); /* whose dwell times have the new clock */
    rig_pull(&r, 1.0, 3e-4);
    rig_run(&r, 0.2);
    assert_int_equal(exercise_of(&r).outcome, VBSS_SESSION_OUTCOME_PASSED);
    expect_ok(vbss_metrics_get_report(r.scene.config.metrics, &report, sizeof report));
    assert_true(report.time < 2.0);
    rig_end(&r);
}

/* Saved while a needle that was just dropped, and a throw, had not been debounced: both are on the new clock. */
static void a_dwell_that_had_begun_goes_on(void **state)
{
    (void)state;
    static rig r;
    make_second(&r, VBSS_SESSION_EXERCISE_NONE);
    expect_ok(vbss_session_begin_at(r.session, session_bytes, session_count));
    rig_run(&r, 5.0);
    rig_drop(&r, RIG_RIGHT);
    rig_set_throw(&r, 0, 2, 1, VBSS_METRICS_RELATION_FIRST);
    rig_run(&r, 0.03);
    expect_ok(vbss_session_save(r.session, session_bytes, ROOM, &session_count));
    expect_ok(vbss_session_destroy(r.session));
    expect_ok(vbss_session_create(r.scene.scene, &r.scene.config, &r.session));
    expect_ok(vbss_session_open(r.session, &r.s));
    r.read = 0;
    expect_ok(vbss_session_begin_at(r.session, session_bytes, session_count));
    r.s->config.metrics = NULL; /* they have the old clock */
    rig_run(&r, 0.15);
    rig_expect(&r, VBSS_SESSION_EVENT_APPEARED, 0, 0);
    rig_expect(&r, VBSS_SESSION_EVENT_TAKEN, 0, 1);
    rig_expect(&r, VBSS_SESSION_EVENT_THROW, 0, 0);
    rig_end(&r);
}

static void the_whole_task_can_begin_there_too(void **state)
{
    (void)state;
    static rig r;
    make_second(&r, VBSS_SESSION_EXERCISE_NONE);
    expect_ok(vbss_session_begin_at(r.session, session_bytes, session_count));
    rig_run(&r, STEP);
    rig_expect(&r, VBSS_SESSION_EVENT_APPEARED, 0, 0);
    rig_to_throw(&r, 0, RIG_RIGHT);
    rig_to_throw(&r, 1, RIG_LEFT);
    rig_end(&r);
}

static void a_wrong_start_changes_nothing(void **state)
{
    (void)state;
    static rig r;
    make_second(&r, VBSS_SESSION_EXERCISE_DOUBLE_THROW);
    const uint64_t before = hash_of(&r);
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_session_begin_at(r.session, NULL, session_count));
    session_bytes[session_count / 2] ^= 1;
    assert_int_not_equal(vbss_session_begin_at(r.session, session_bytes, session_count), VBSS_OK);
    session_bytes[session_count / 2] ^= 1;
    assert_int_not_equal(vbss_session_begin_at(r.session, session_bytes, session_count - 9),
                         VBSS_OK);
    assert_true(hash_of(&r) == before);
    /* restore() wants the same exercise, and begins nothing */
    assert_int_not_equal(vbss_session_restore(r.session, session_bytes, session_count), VBSS_OK);
    assert_true(hash_of(&r) == before);
    r.s->config.dwell *= 2.0;
    assert_int_not_equal(vbss_session_begin_at(r.session, session_bytes, session_count), VBSS_OK);
    r.s->config.dwell *= 0.5;
    expect_ok(vbss_session_begin_at(r.session, session_bytes, session_count));
    rig_run(&r, STEP);
    expect_result(VBSS_ERROR_WRONG_STATE,
                  vbss_session_begin_at(r.session, session_bytes, session_count));
    rig_end(&r);
}

static void saved_exercises_go_on_where_they_were(void **state)
{
    (void)state;
    static rig r;
    make_second(&r, VBSS_SESSION_EXERCISE_DOUBLE_THROW);
    expect_ok(vbss_session_begin_at(r.session, session_bytes, session_count));
    r.observation.max_tension = 2.5;
    rig_run(&r, 0.5);
    const uint64_t before = hash_of(&r);
    expect_ok(vbss_session_save(r.session, session_bytes, ROOM, &session_count));
    r.observation.max_tension = 7.0;
    rig_run(&r, 0.5);
    assert_true(hash_of(&r) != before);
    expect_ok(vbss_session_restore(r.session, session_bytes, session_count));
    assert_true(hash_of(&r) == before);
    for (uint32_t i = 0; i < exercise_of(&r).measure_count; i++) {
        vbss_session_measure m;
        expect_ok(vbss_session_get_measure(r.session, i, &m, sizeof m));
        if (m.kind == VBSS_SESSION_MEASURE_TENSION) {
            expect_near(2.5, m.value, 0.0);
        }
    }
    rig_end(&r);
}

/* ---- of a needle in hands, with a log */

static void make_floor(rig *r, vbss_session_exercise exercise)
{
    vbss_metrics_config c;
    memset(r, 0, sizeof *r);
    r->context = harness_context(&r->memory);
    expect_ok(session_scene_floor(r->context, &r->scene));
    expect_ok(vbss_metrics_config_init(&c, sizeof c));
    c.duration = 10.0;
    expect_ok(vbss_metrics_create(r->context, &c, &r->metrics));
    r->scene.config.metrics = r->metrics;
    r->scene.config.coaching = 1;
    r->scene.config.exercise = exercise;
}

static void start(rig *r)
{
    expect_ok(vbss_session_create(r->scene.scene, &r->scene.config, &r->session));
    expect_ok(vbss_session_open(r->session, &r->s));
}

/* The first tool takes the needle, lifts it and stays there. */
static void make_step(const rig *r, int step)
{
    vbss_session_hand hand = vbss_session_hand_default();
    needle_scene_hand(0, step < LIFTED ? step : LIFTED, hand.position, hand.orientation,
                      &hand.opening);
    expect_ok(vbss_session_move_hand(r->session, VBSS_METRICS_TOOL_LEFT, &hand));
    expect_ok(vbss_session_step(r->session, 0.0, STEP));
}

static uint64_t hashes[HELD];

static void an_outcome_is_replayed(void **state)
{
    (void)state;
    static rig r;
    log_bytes log = {NULL, 0};
    make_floor(&r, VBSS_SESSION_EXERCISE_TAKE_NEEDLE);
    expect_ok(vbss_record_create(r.scene.scene, NULL, &r.scene.config.record));
    start(&r);
    for (int i = 0; i < HELD; i++) {
        make_step(&r, i);
        log_take(&log, r.scene.config.record);
        hashes[i] = hash_of(&r);
    }
    const vbss_session_exercise_state recorded = exercise_of(&r);
    vbss_session_measure share;
    expect_ok(vbss_session_get_measure(r.session, 0, &share, sizeof share));
    assert_int_equal(recorded.outcome, VBSS_SESSION_OUTCOME_PASSED);
    print_message("held at %.3f of the needle after %.3f s\n", share.value, recorded.time);
    assert_true(recorded.time < 1e-3 * HELD);
    expect_ok(vbss_record_end(r.scene.config.record));
    log_take(&log, r.scene.config.record);
    rig_end(&r);

    make_floor(&r, VBSS_SESSION_EXERCISE_TAKE_NEEDLE);
    expect_ok(vbss_replay_create(r.context, log.bytes, log.count, &r.scene.config.replay));
    expect_ok(vbss_replay_begin(r.scene.config.replay, r.scene.scene));
    start(&r);
    for (int i = 0; i < HELD; i++) {
        expect_ok(vbss_session_step(r.session, 0.0, 0.0));
        assert_true(hash_of(&r) == hashes[i]);
    }
    const vbss_session_exercise_state replayed = exercise_of(&r);
    assert_int_equal(replayed.outcome, recorded.outcome);
    expect_near(recorded.time, replayed.time, 0.0);
    rig_end(&r);
    free(log.bytes);
}

static void save_held_needle(void)
{
    static rig r;
    make_floor(&r, VBSS_SESSION_EXERCISE_NONE);
    start(&r);
    for (int i = 0; i < HELD; i++) {
        make_step(&r, i);
    }
    assert_int_equal(rig_status(&r).phase, VBSS_SESSION_PHASE_APPROACH);
    expect_ok(vbss_scene_save(r.scene.scene, scene_bytes, ROOM, &scene_count));
    expect_ok(vbss_session_save(r.session, session_bytes, ROOM, &session_count));
    rig_end(&r);
}

/* The log has the start, so a replay needs neither of the two states. */
static void a_log_has_the_start_of_its_exercise(void **state)
{
    (void)state;
    static rig r;
    log_bytes log = {NULL, 0};
    save_held_needle();
    make_floor(&r, VBSS_SESSION_EXERCISE_PASS_MARK);
    expect_ok(vbss_scene_restore(r.scene.scene, scene_bytes, scene_count));
    start(&r);
    expect_ok(vbss_session_begin_at(r.session, session_bytes, session_count));
    expect_ok(vbss_record_create(r.scene.scene, NULL, &r.scene.config.record));
    expect_ok(vbss_session_set_record(r.session, r.scene.config.record));
    for (int i = 0; i < MORE; i++) {
        make_step(&r, LIFTED);
        log_take(&log, r.scene.config.record);
        hashes[i] = hash_of(&r);
    }
    assert_int_equal(rig_status(&r).phase, VBSS_SESSION_PHASE_APPROACH);
    expect_near((MORE - 1) * STEP, exercise_of(&r).time, 1e-9);
    expect_ok(vbss_record_end(r.scene.config.record));
    log_take(&log, r.scene.config.record);
    rig_end(&r);

    make_floor(&r, VBSS_SESSION_EXERCISE_PASS_MARK);
    expect_ok(vbss_replay_create(r.context, log.bytes, log.count, &r.scene.config.replay));
    expect_ok(vbss_replay_begin(r.scene.config.replay, r.scene.scene));
    start(&r);
    for (int i = 0; i < MORE; i++) {
        expect_ok(vbss_session_step(r.session, 0.0, 0.0));
        assert_true(hash_of(&r) == hashes[i]);
    }
    expect_result(VBSS_ERROR_WRONG_STATE,
                  vbss_session_begin_at(r.session, session_bytes, session_count));
    rig_end(&r);
    free(log.bytes);
}

int test_exercise_start(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(facts_stay_and_all_else_begins),
        cmocka_unit_test(a_dwell_that_had_begun_goes_on),
        cmocka_unit_test(the_whole_task_can_begin_there_too),
        cmocka_unit_test(a_wrong_start_changes_nothing),
        cmocka_unit_test(saved_exercises_go_on_where_they_were),
        cmocka_unit_test(an_outcome_is_replayed),
        cmocka_unit_test(a_log_has_the_start_of_its_exercise),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
