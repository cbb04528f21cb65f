/* What is saved with its scene goes on to the same bits; what is no such state is refused. */
#include "base/error.h"
#include "base/memory.h"
#include "rig.h"
#include "scene/api/api.h"

typedef struct tied_body {
    session_scene scene;
    vbss_session *session;
} tied_body;

static void free_body(vbss_context *context, void *object)
{
    vbss_release(context, object, 1, sizeof(tied_body));
}

static void visit(vbss_stream *stream, const vbss_kind *kind, void *object)
{
    vbss_section outer = vbss_stream_open(stream, kind->code, kind->version);
    kind->serialise(stream, object);
    vbss_stream_close(stream, outer);
}

/* The scene first, as hosts restore it. */
static void visit_body(vbss_stream *stream, void *object)
{
    tied_body *b = object;
    visit(stream, &vbss_scene_kind, ((vbss_slot *)b->scene.scene)->object);
    visit(stream, &vbss_session_kind, ((vbss_slot *)b->session)->object);
}

static const vbss_kind tied_kind = {
    "tied body", VBSS_CODE('T', 'I', 'E', 'D'), 1, free_body, visit_body, NULL};

static vbss_result create(vbss_context *context, void *user, void **handle)
{
    const uint32_t *crossings = user;
    vbss_slot *slot;
    tied_body *b = vbss_allocate(context, 1, sizeof *b, "tied body");
    assert_non_null(b);
    VBSS_TRY(session_scene_tying(context, *crossings, &b->scene));
    VBSS_TRY(vbss_session_create(b->scene.scene, &b->scene.config, &b->session));
    VBSS_TRY(vbss_slot_create(context, &tied_kind, b, &slot));
    *handle = slot;
    return VBSS_OK;
}

static vbss_result step(void *handle)
{
    tied_body *b = ((vbss_slot *)handle)->object;
    return session_scene_tie(&b->scene, b->session, NULL);
}

static vbss_result destroy(void *handle)
{
    return vbss_slot_destroy(handle, &tied_kind);
}

static harness_body body(void *crossings)
{
    const harness_body b = {.name = "a session that ties",
                            .kind = &tied_kind,
                            .create = create,
                            .step = step,
                            .destroy = destroy,
                            .user = crossings};
    return b;
}

static void restored_session_continues_bit_equal(void **state)
{
    (void)state;
    static const size_t at[] = {0, 1, 60, 128};
    uint32_t crossings = 5;
    const harness_body b = body(&crossings);
    harness_save_restore_continue_at(&b, at, sizeof at / sizeof at[0], 30);
}

static void step_does_not_allocate(void **state)
{
    (void)state;
    uint32_t crossings = 3;
    const harness_body b = body(&crossings);
    assert_int_equal(harness_step_allocations(&b, 200), 0);
}

/* ---- of the session alone: its scene stands still, and the task sees a stitch with a throw */

static vbss_result create_alone(vbss_context *context, void *user, void **handle)
{
    session_scene scene;
    vbss_metrics_config c;
    (void)user;
    VBSS_TRY(session_scene_still(context, &scene));
    VBSS_TRY(vbss_metrics_config_init(&c, sizeof c));
    c.duration = 1.0;
    c.throw_capacity = c.phase_capacity = c.incident_capacity = 4;
    VBSS_TRY(vbss_metrics_create(context, &c, &scene.config.metrics));
    VBSS_TRY(vbss_knot_detector_create(context, NULL, &scene.config.knots));
    scene.config.dwell = scene.config.throw_dwell = 0.0;
    scene.config.event_capacity = 16;
    return vbss_session_create(scene.scene, &scene.config, (vbss_session **)handle);
}

static void see(session_object *s)
{
    session_observation *observation = &s->observation;
    *observation = (session_observation){
        .thread = s->config.thread, .thread_length = 0.15, .drain_radius = 6.5e-3};
    observation->tools[RIG_LEFT].has_needle = s->steps % 2 == 0;
    observation->hole_count = 2;
    for (uint32_t k = 0; k < 2; k++) {
        observation->holes[k] = (session_hole_observation){.id = k + 1,
                                                           .mark = k,
                                                           .thread = observation->thread,
                                                           .distance_from_tip = 0.2 - 0.02 * k,
                                                           .arc = 0.133 - 0.02 * k,
                                                           .axial = {1e-3, 2e-3}};
    }
    observation->knot.throw_count = 1;
    observation->knot.throws[0] = (session_throw_observation){2, 1, VBSS_METRICS_RELATION_FIRST};
    observation->tension[0] = observation->tension[1] = 1.0;
    s->knot = observation->knot;
}

static vbss_result step_alone(void *handle)
{
    session_object *s;
    VBSS_TRY(vbss_session_open(handle, &s));
    s->time += RIG_STEP;
    s->steps++;
    s->events_before_step = s->event_count;
    see(s);
    vbss_session_update_progress(s, &s->observation);
    return vbss_session_feed_metrics(s, &s->observation);
}

static vbss_result destroy_alone(void *handle)
{
    return vbss_session_destroy(handle);
}

static void bad_snapshots_are_rejected(void **state)
{
    (void)state;
    const harness_body b = {.name = "a session",
                            .kind = &vbss_session_kind,
                            .create = create_alone,
                            .step = step_alone,
                            .destroy = destroy_alone};
    harness_refuses_bad_snapshots(&b, 0);
    harness_refuses_bad_snapshots(&b, 4);
}

static void snapshot_needs_scene_at_same_step(void **state)
{
    (void)state;
    static uint8_t bytes[1u << 20];
    rig r;
    uint64_t written, before, after;
    rig_begin(&r);
    expect_ok(vbss_session_step(r.session, 0.0, 1e-3));
    expect_ok(vbss_session_save(r.session, bytes, sizeof bytes, &written));
    expect_ok(vbss_session_step(r.session, 0.0, 1e-3));
    expect_ok(vbss_session_get_hash(r.session, &before));
    expect_result(VBSS_ERROR_CORRUPT, vbss_session_restore(r.session, bytes, written));
    expect_ok(vbss_session_get_hash(r.session, &after));
    assert_true(before == after);
    rig_end(&r);
}

int test_state(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(restored_session_continues_bit_equal),
        cmocka_unit_test(step_does_not_allocate),
        cmocka_unit_test(bad_snapshots_are_rejected),
        cmocka_unit_test(snapshot_needs_scene_at_same_step),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
