/* Simulated time that a scene leaves out is in the status, an event, the metrics and the score. */
#include "fixtures/solver_of.h"
#include "fixtures/step_events.h"
#include "rig.h"

typedef struct slow {
    harness_memory memory;
    vbss_context *context;
    session_scene scene;
    vbss_session *session;
    /* What the steps have reported, s: their statistics, and their events. */
    double paused, clamped;
} slow;

static vbss_session_status status_of(const slow *t)
{
    vbss_session_status status;
    expect_ok(vbss_session_get_status(t->session, &status, sizeof status));
    return status;
}

static vbss_metrics_report report_of(const slow *t)
{
    vbss_metrics_report report;
    expect_ok(vbss_metrics_get_report(t->scene.config.metrics, &report, sizeof report));
    return report;
}

static double lost_time_of_step(const slow *t)
{
    return step_events_lost_time(t->scene.scene);
}

static stitch_scene_options double_throw(void)
{
    stitch_scene_options options;
    expect_ok(stitch_scene_init(&options));
    options.crossings = 5;
    return options;
}

/* Ties a throw, and counts the clamped substeps. */
static uint64_t tie(slow *t, const stitch_scene_options *options)
{
    vbss_scene_statistics before, after;
    t->paused = t->clamped = 0.0;
    t->context = harness_context(&t->memory);
    expect_ok(session_scene_tying_with(t->context, options, &t->scene));
    expect_ok(vbss_session_create(t->scene.scene, &t->scene.config, &t->session));
    for (uint32_t i = 0; i < STITCH_TIE_STEPS; i++) {
        expect_ok(vbss_scene_get_statistics(t->scene.scene, &before, sizeof before));
        expect_ok(session_scene_tie(&t->scene, t->session, NULL));
        expect_ok(vbss_scene_get_statistics(t->scene.scene, &after, sizeof after));
        t->paused += i > 0 ? after.time_paused - before.time_paused : 0.0;
        t->clamped += i > 0 ? lost_time_of_step(t) : 0.0;
    }
    return after.clamped;
}

static uint64_t tie_with_limits(slow *t, uint32_t factor, uint32_t divisor)
{
    stitch_scene_options options = double_throw();
    set_step_operations(&options.scene, step_operations(&options.scene) * factor / divisor);
    set_call_operations(&options.scene, call_operations(&options.scene) * factor / divisor);
    return tie(t, &options);
}

static uint32_t count_events(const slow *t, vbss_session_event *last)
{
    vbss_session_event e;
    uint32_t count = 0;
    const vbss_session_status status = status_of(t);
    for (uint64_t i = status.first_event; i < status.event_count; i++) {
        expect_ok(vbss_session_get_event(t->session, i, &e, sizeof e));
        if (e.kind == VBSS_SESSION_EVENT_TIME_LOST) {
            *last = e;
            count++;
        }
    }
    return count;
}

/* An event is rounded down to 1/65536 of a step. */
#define ROUNDING (STITCH_TIE_STEPS * SESSION_SCENE_STEP / 65536.0)

static void quarter_of_limits_loses_reported_time(void **state)
{
    (void)state;
    static slow t;
    vbss_session_event e;
    assert_int_equal(tie_with_limits(&t, 1, 4), 0);
    const vbss_session_status status = status_of(&t);
    const vbss_metrics_report report = report_of(&t);
    expect_near((STITCH_TIE_STEPS - 1) * SESSION_SCENE_STEP, status.time, 1e-9);
    assert_true(status.time_lost > 0.1 * status.time && status.time_lost < status.time);
    expect_near(t.paused, status.time_lost, 1e-12);
    expect_near(t.clamped, status.time_lost, ROUNDING);
    expect_near(status.time, status.time_simulated + status.time_lost, 1e-12);
    assert_int_equal(status.is_lossy, 1);
    assert_int_equal(count_events(&t, &e), 1);
    assert_int_equal(e.undone, 0);
    assert_true(e.amount > 0.02 && e.amount <= 0.021 + 2.0 * SESSION_SCENE_STEP);
    /* metrics and score */
    expect_near(status.time, report.time, 1e-12);
    expect_near(status.time_lost, report.time_lost, 1e-12);
    expect_near(status.time_simulated, report.time_simulated, 1e-12);
    assert_int_not_equal(report.flags & VBSS_METRICS_FLAG_TIME_LOST, 0);
    vbss_metrics_penalty p;
    uint32_t found = 0;
    for (uint32_t i = 0; i < report.penalty_count; i++) {
        expect_ok(vbss_metrics_get_penalty(t.scene.config.metrics, i, &p, sizeof p));
        found += p.kind == VBSS_METRICS_PENALTY_TIME_LOST && p.amount == 0.0 &&
                 p.measure == report.time_lost;
    }
    assert_int_equal(found, 1);
    harness_context_end(t.context, &t.memory);
}

/* Offline no step is paused, but substeps are truncated. */
static void truncated_substeps_lose_time(void **state)
{
    (void)state;
    static slow t;
    stitch_scene_options options = double_throw();
    options.scene.mode = VBSS_SCENE_MODE_OFFLINE;
    solver_of(&options.scene)->halving_limit = 0;
    solver_of(&options.scene)->iteration_limit = 1;
    assert_true(tie(&t, &options) > 0);
    expect_same_bits(0.0, t.paused);
    assert_true(t.clamped > 0.02);
    expect_near(t.clamped, status_of(&t).time_lost, ROUNDING);
    assert_int_equal(status_of(&t).is_lossy, 1);
    harness_context_end(t.context, &t.memory);
}

static void twice_the_limits_lose_little_time(void **state)
{
    (void)state;
    static slow t;
    vbss_session_event e;
    (void)tie_with_limits(&t, 2, 1);
    const vbss_session_status status = status_of(&t);
    assert_true(status.time_lost < 0.02);
    assert_int_equal(status.is_lossy, 0);
    assert_int_equal(count_events(&t, &e), 0);
    assert_int_equal(report_of(&t).flags & VBSS_METRICS_FLAG_TIME_LOST, 0);
    harness_context_end(t.context, &t.memory);
}

static void lost_time_is_saved(void **state)
{
    (void)state;
    static slow t;
    static uint8_t scene[1 << 22], task[1 << 22];
    uint64_t scene_bytes, task_bytes, before, after;
    (void)tie_with_limits(&t, 1, 4);
    const double lost = status_of(&t).time_lost;
    expect_ok(vbss_scene_save(t.scene.scene, scene, sizeof scene, &scene_bytes));
    expect_ok(vbss_session_save(t.session, task, sizeof task, &task_bytes));
    expect_ok(vbss_session_get_hash(t.session, &before));
    for (int i = 0; i < 100; i++) {
        expect_ok(vbss_session_step(t.session, 0.0, SESSION_SCENE_STEP));
    }
    expect_ok(vbss_scene_restore(t.scene.scene, scene, scene_bytes));
    expect_ok(vbss_session_restore(t.session, task, task_bytes));
    expect_ok(vbss_session_get_hash(t.session, &after));
    assert_true(before == after);
    expect_same_bits(lost, status_of(&t).time_lost);
    harness_context_end(t.context, &t.memory);
}

/* ---- the limit, with what a scene might have lost */

static void lose(rig *r, double seconds, double lost)
{
    r->s->time_lost += lost;
    rig_run(r, seconds);
}

static void event_has_hysteresis(void **state)
{
    (void)state;
    rig r;
    rig_begin(&r);
    lose(&r, 0.3, 0.0199); /* a trial shorter than 1 s counts as 1 s */
    rig_expect_quiet(&r);
    assert_int_equal(rig_status(&r).is_lossy, 0);
    lose(&r, RIG_STEP, 0.0002);
    expect_near(0.0201, rig_expect(&r, VBSS_SESSION_EVENT_TIME_LOST, 0, 0)->amount, 1e-12);
    rig_expect_quiet(&r);
    assert_int_equal(rig_status(&r).is_lossy, 1);
    rig_run(&r, 1.7); /* at 2 s it is 1 % */
    rig_expect_quiet(&r);
    rig_run(&r, 0.1);
    rig_expect(&r, VBSS_SESSION_EVENT_TIME_LOST, 0, 1);
    rig_expect_quiet(&r);
    assert_int_equal(rig_status(&r).is_lossy, 0);
    rig_end(&r);
}

static void end_of_task_stops_both_clocks(void **state)
{
    (void)state;
    rig r;
    rig_begin(&r);
    lose(&r, 1.0, 0.5);
    rig_expect(&r, VBSS_SESSION_EVENT_TIME_LOST, 0, 0);
    r.observation.has_lost_body = true;
    rig_run(&r, RIG_STEP);
    const vbss_session_status end = rig_status(&r);
    assert_int_equal(end.phase, VBSS_SESSION_PHASE_FAILED);
    expect_near(0.5, end.time_lost, 1e-12);
    lose(&r, 1.0, 0.7);
    expect_same_bits(end.time_lost, rig_status(&r).time_lost);
    expect_same_bits(end.time_simulated, rig_status(&r).time_simulated);
    assert_int_equal(rig_status(&r).is_lossy, 1);
    rig_end(&r);
}

static void limit_is_configurable(void **state)
{
    (void)state;
    rig r;
    rig_make(&r);
    r.scene.config.lost_share = 0.6;
    rig_start(&r);
    lose(&r, 1.0, 0.5);
    rig_expect_quiet(&r);
    rig_end(&r);
}

int test_lost_time(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(quarter_of_limits_loses_reported_time),
        cmocka_unit_test(truncated_substeps_lose_time),
        cmocka_unit_test(twice_the_limits_lose_little_time),
        cmocka_unit_test(lost_time_is_saved),
        cmocka_unit_test(event_has_hysteresis),
        cmocka_unit_test(end_of_task_stops_both_clocks),
        cmocka_unit_test(limit_is_configurable),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
