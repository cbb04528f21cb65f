/* Throws of a real thread above a real drain: what the detector makes of them becomes events of the task. */
#include <math.h>

#include "rig.h"
#include "scene/api/api.h"
#include "scene/world/world.h"

typedef struct tied {
    harness_memory memory;
    vbss_context *context;
    session_scene scene;
    vbss_session *session;
    uint32_t faults; /* when a throw was seated */
} tied;

/* Where edges pass each other steps wait, in one run a hundred more than in the next: both hands pull later then. */
#define ENOUGH 1.9 /* N */
enum { MAX_STEPS = 3 * STITCH_TIE_STEPS };

static bool pulls_enough(const tied *t)
{
    return stitch_scene_pull(&t->scene.stitch, 0) > ENOUGH &&
           stitch_scene_pull(&t->scene.stitch, 1) > ENOUGH;
}

static vbss_session_status run(tied *t, uint32_t crossings)
{
    vbss_session_status status;
    t->context = harness_context(&t->memory);
    expect_ok(session_scene_tying(t->context, crossings, &t->scene));
    t->scene.config.seat_release =
        1.5e-3;                   /* at 2 N edges have passed each other by a millimetre, */
    t->scene.config.dwell = 0.02; /* soon after they met */
    expect_ok(vbss_session_create(t->scene.scene, &t->scene.config, &t->session));
    bool seated = false;
    for (uint32_t i = 0;
         i < STITCH_TIE_STEPS || (crossings == 1 && i < MAX_STEPS && !pulls_enough(t)); i++) {
        expect_ok(session_scene_tie(&t->scene, t->session, NULL));
        expect_ok(vbss_session_get_status(t->session, &status, sizeof status));
        if (!seated && status.seated > 0) {
            t->faults = status.faults;
            seated = true;
        }
    }
    return status;
}

/* The events of that kind; the last of them. */
static uint32_t count(const tied *t, vbss_session_event_kind kind, vbss_session_event *last)
{
    vbss_session_status status;
    vbss_session_event e;
    uint32_t found = 0;
    expect_ok(vbss_session_get_status(t->session, &status, sizeof status));
    for (uint64_t i = status.first_event; i < status.event_count; i++) {
        expect_ok(vbss_session_get_event(t->session, i, &e, sizeof e));
        if (e.kind == kind) {
            *last = e;
            found++;
        }
    }
    return found;
}

/* What rubs beside a hole may hold more than the hand pulls with: farther out the limb is as tense as the hand says. */
#define BESIDE 5e-3

/* Hand 1 has the limb before the first hole, hand 0 the one beyond the second. */
static void expect_tension(const tied *t, int hand, double reported)
{
    const stitch_scene *stitch = &t->scene.stitch;
    scene_object *scene;
    vbss_scene_hole first = {0}, second = {0};
    expect_ok(vbss_scene_open(t->scene.scene, &scene));
    const thread_object *thread = vbss_scene_body(scene, stitch->thread_body)->thread.thread;
    assert_true(stitch_scene_hole(stitch, 0, &first) && stitch_scene_hole(stitch, 1, &second));
    assert_true(first.arc_length < second.arc_length);
    const double pull = stitch_scene_pull(stitch, hand);
    assert_true(pull > ENOUGH && pull < 2.3);
    double largest = 0.0, arc = 0.0;
    for (uint32_t i = 0; i + 1 < thread->node_count; i++) {
        double end = arc + thread->rest[i], tension = thread->now.tension[i];
        double out = hand == 1 ? first.arc_length - end : arc - second.arc_length;
        largest = out > 0.0 ? fmax(largest, tension) : largest;
        if (out > BESIDE) {
            expect_near(pull, tension, 0.01);
        }
        arc = end;
    }
    expect_near(largest, reported, 0.0);
}

static void stitch_without_throw_is_incomplete(void **state)
{
    (void)state;
    static tied t;
    vbss_session_event e;
    const vbss_session_status status = run(&t, 1);
    assert_int_equal(status.phase, VBSS_SESSION_PHASE_PULL_THROUGH);
    assert_int_equal(status.punctured, 3);
    assert_int_equal(status.threaded, 3);
    assert_int_equal(status.throws, 0);
    assert_int_equal(count(&t, VBSS_SESSION_EVENT_THROW, &e), 0);
    assert_true(status.tail > 0.04 && status.tail < 0.05); /* limb, rise and wall */
    expect_tension(&t, 0, status.tension[0]);
    expect_tension(&t, 1, status.tension[1]);
    assert_true(status.deviation_mm[0] < 0.5 && status.deviation_mm[1] < 0.5);
    harness_context_end(t.context, &t.memory);
}

static void expect_tied(uint32_t crossings, int32_t wraps, uint32_t faults)
{
    static tied t;
    vbss_session_event e = {0};
    vbss_metrics_report report;
    const vbss_session_status status = run(&t, crossings);
    assert_int_equal(status.throws, 1);
    assert_int_equal(status.seated, 1);
    /* A single that is pulled on may turn into a half hitch later. */
    assert_int_equal(t.faults, faults);
    assert_int_equal(status.phase, VBSS_SESSION_PHASE_TRANSFER_1);
    assert_int_equal(status.stage, VBSS_SESSION_STAGE_SEATED);
    assert_int_equal(count(&t, VBSS_SESSION_EVENT_THROW, &e), 1);
    assert_int_equal(e.wraps, wraps);
    assert_int_equal(e.handedness, 1);
    assert_int_equal(e.relation, VBSS_METRICS_RELATION_FIRST);
    assert_int_equal(count(&t, VBSS_SESSION_EVENT_SEATED, &e), 1);
    assert_true(e.amount < 1.1e-3); /* edges may have crossed by then */
    expect_ok(vbss_metrics_get_report(t.scene.config.metrics, &report, sizeof report));
    assert_int_equal(report.throw_count, 1);
    expect_near(1e3 * e.amount, report.gap_mm, 1e-9);
    assert_int_equal(report.samples, STITCH_TIE_STEPS);
    harness_context_end(t.context, &t.memory);
}

static void double_throw_is_tied_and_seated(void **state)
{
    (void)state;
    expect_tied(5, 2, 0);
}

static void single_throw_has_too_few_wraps(void **state)
{
    (void)state;
    expect_tied(3, 1, VBSS_KNOT_FAULT_FIRST);
}

/* Blades are not wanted for it: the host cuts. */
static void early_cut_fails(void **state)
{
    (void)state;
    rig r;
    uint32_t piece;
    rig_begin(&r);
    expect_ok(vbss_session_step(r.session, 0.0, 1e-3));
    expect_ok(vbss_scene_cut_thread(r.scene.scene, r.scene.config.thread, 0.1, &piece));
    r.s->thread_length = 0.15;
    expect_ok(vbss_session_step(r.session, 0.0, 1e-3));
    assert_int_equal(rig_status(&r).failure, VBSS_SESSION_FAILURE_CUT_EARLY);
    rig_end(&r);
}

int test_tied(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stitch_without_throw_is_incomplete),
        cmocka_unit_test(double_throw_is_tied_and_seated),
        cmocka_unit_test(single_throw_has_too_few_wraps),
        cmocka_unit_test(early_cut_fails),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
