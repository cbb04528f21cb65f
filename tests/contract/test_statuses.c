/* Each module distinguishes why it refuses a call: a missing object, a wrong state, an object that does
 * not fit, or one that is in use. Every status is here once for every module that has it. */
#include <string.h>

#include <vblast_ss/vblast_ss.h>

#include "fixtures/session_scenes.h"
#include "harness/harness.h"

enum { NONE = 77 }; /* a number that nothing has */

typedef struct world {
    harness_memory memory;
    vbss_context *context;
    session_scene s; /* whose scene has a thread, a drain, a needle and two tools */
} world;

static void begin(world *w)
{
    w->context = harness_context(&w->memory);
    expect_ok(session_scene_still(w->context, &w->s));
}

static void end(world *w)
{
    harness_context_end(w->context, &w->memory);
}

/* The context has the same status, with a text. */
static void refused(const world *w, vbss_result wanted, vbss_result result)
{
    vbss_result stored;
    const char *text;
    expect_result(wanted, result);
    expect_ok(vbss_context_get_last_error(w->context, &stored, &text));
    expect_result(wanted, stored);
    assert_true(strlen(text) > 0);
}

static void collision_distinguishes_refusals(void **state)
{
    (void)state;
    world w;
    vbss_collision *collision;
    begin(&w);
    expect_ok(vbss_collision_create(w.context, NULL, &collision));
    refused(&w, VBSS_ERROR_NOT_FOUND, vbss_collision_remove(collision, NONE));
    end(&w);
}

static void thread_distinguishes_refusals(void **state)
{
    (void)state;
    const double target[3] = {0.0, 0.0, 0.0};
    world w;
    uint32_t id;
    vbss_thread_attachment a;
    begin(&w);
    expect_ok(vbss_thread_attachment_init(&a, sizeof a));
    a.kind = VBSS_THREAD_ATTACHMENT_PIN;
    expect_ok(vbss_thread_attach(w.s.thread, &a, &id));
    refused(&w, VBSS_ERROR_IN_USE, vbss_thread_attach(w.s.thread, &a, &id));
    a.kind = VBSS_THREAD_ATTACHMENT_MASS;
    expect_ok(vbss_thread_attach(w.s.thread, &a, &id));
    refused(&w, VBSS_ERROR_INCOMPATIBLE,
            vbss_thread_set_attachment_target(w.s.thread, id, target, NULL));
    refused(&w, VBSS_ERROR_NOT_FOUND,
            vbss_thread_set_attachment_target(w.s.thread, NONE, target, NULL));
    a.node = 1000000;
    refused(&w, VBSS_ERROR_OUT_OF_RANGE, vbss_thread_attach(w.s.thread, &a, &id));
    end(&w);
}

static void drain_distinguishes_refusals(void **state)
{
    (void)state;
    world w;
    uint32_t id;
    vbss_drain_attachment a;
    vbss_view anchors;
    begin(&w);
    expect_ok(vbss_drain_get_view(w.s.drain, VBSS_DRAIN_VIEW_ANCHORS, &anchors, sizeof anchors));
    expect_ok(vbss_drain_attachment_init(&a, sizeof a));
    a.node = *(const uint32_t *)anchors.data;
    refused(&w, VBSS_ERROR_IN_USE, vbss_drain_attach(w.s.drain, &a, &id));
    refused(&w, VBSS_ERROR_NOT_FOUND, vbss_drain_detach(w.s.drain, NONE));
    a.node = 1000000;
    refused(&w, VBSS_ERROR_OUT_OF_RANGE, vbss_drain_attach(w.s.drain, &a, &id));
    end(&w);
}

static void scene_distinguishes_refusals(void **state)
{
    (void)state;
    const double origin[3] = {0.0, 0.0, 0.0};
    world w;
    uint32_t id;
    vbss_thread *other;
    vbss_thread_config config;
    begin(&w);
    vbss_scene *scene = w.s.scene;
    const uint32_t thread = w.s.config.thread;
    expect_ok(vbss_thread_config_init(&config, sizeof config));
    config.method = VBSS_METHOD_VBLAST;
    expect_ok(vbss_thread_create(w.context, &config, &other));
    refused(&w, VBSS_ERROR_INCOMPATIBLE, vbss_scene_add_thread(scene, other, &id));
    refused(&w, VBSS_ERROR_NOT_FOUND, vbss_scene_set_rigid_target(scene, NONE, origin, NULL));
    refused(&w, VBSS_ERROR_INCOMPATIBLE, vbss_scene_set_rigid_target(scene, thread, origin, NULL));
    expect_ok(vbss_scene_pin_thread(scene, thread, 0, 0, NULL, &id));
    refused(&w, VBSS_ERROR_IN_USE, vbss_scene_pin_thread(scene, thread, 0, 0, NULL, &id));
    refused(&w, VBSS_ERROR_OUT_OF_RANGE,
            vbss_scene_pin_thread(scene, thread, 1000000, 0, NULL, &id));
    end(&w);
}

static void baseline_scene_distinguishes_refusals(void **state)
{
    (void)state;
    const double gravity[3] = {0.0, -1.0, 0.0};
    world w;
    uint32_t thread, id;
    vbss_scene *scene;
    vbss_thread *own;
    vbss_scene_config config;
    vbss_thread_config of_thread;
    begin(&w);
    expect_ok(vbss_scene_config_init(&config, sizeof config));
    expect_ok(vbss_thread_config_init(&of_thread, sizeof of_thread));
    config.method = of_thread.method = VBSS_METHOD_VBLAST;
    expect_ok(vbss_scene_create(w.context, &config, &scene));
    expect_ok(vbss_thread_create(w.context, &of_thread, &own));
    expect_ok(vbss_scene_add_thread(scene, own, &thread));
    refused(&w, VBSS_ERROR_INCOMPATIBLE, vbss_scene_set_gravity(scene, thread, gravity));
    refused(&w, VBSS_ERROR_NOT_FOUND, vbss_scene_remove(scene, NONE));
    expect_ok(vbss_scene_pin_thread(scene, thread, 0, 0, NULL, &id));
    refused(&w, VBSS_ERROR_IN_USE, vbss_scene_pin_thread(scene, thread, 0, 0, NULL, &id));
    end(&w);
}

static void visual_distinguishes_refusals(void **state)
{
    (void)state;
    world w;
    vbss_visual *visual;
    begin(&w);
    expect_ok(vbss_visual_create(w.context, NULL, &visual));
    refused(&w, VBSS_ERROR_NOT_FOUND, vbss_visual_remove(visual, NONE));
    end(&w);
}

static void metrics_distinguish_refusals(void **state)
{
    (void)state;
    world w;
    vbss_metrics *metrics;
    vbss_metrics_throw found;
    vbss_metrics_sample sample;
    begin(&w);
    expect_ok(vbss_metrics_create(w.context, NULL, &metrics));
    refused(&w, VBSS_ERROR_NOT_FOUND, vbss_metrics_get_throw(metrics, 0, &found, sizeof found));
    expect_ok(vbss_metrics_sample_init(&sample, sizeof sample));
    sample.valid = 16;
    refused(&w, VBSS_ERROR_OUT_OF_RANGE, vbss_metrics_add_sample(metrics, &sample));
    sample.valid = 0;
    expect_ok(vbss_metrics_finish(metrics));
    refused(&w, VBSS_ERROR_WRONG_STATE, vbss_metrics_add_sample(metrics, &sample));
    end(&w);
}

static void knot_detector_distinguishes_refusals(void **state)
{
    (void)state;
    world w;
    vbss_knot_detector *detector;
    vbss_knot_throw found;
    begin(&w);
    expect_ok(vbss_knot_detector_create(w.context, NULL, &detector));
    refused(&w, VBSS_ERROR_NOT_FOUND,
            vbss_knot_detector_get_throw(detector, 0, &found, sizeof found));
    end(&w);
}

static void device_distinguishes_refusals(void **state)
{
    (void)state;
    world w;
    vbss_mock *mock;
    vbss_device *device;
    vbss_device_adapter adapter;
    vbss_device_config config;
    begin(&w);
    expect_ok(vbss_mock_create(w.context, NULL, &mock));
    expect_ok(vbss_device_adapter_init(&adapter, sizeof adapter));
    expect_ok(vbss_mock_get_adapter(mock, &adapter));
    expect_ok(vbss_device_config_init(&config, sizeof config));
    config.jaw_takeover = 0;
    expect_ok(vbss_device_create(w.context, &adapter, NULL, &config, &device));
    refused(&w, VBSS_ERROR_NOT_FOUND, vbss_device_get_error(device, 1, NULL, NULL));
    refused(&w, VBSS_ERROR_WRONG_STATE, vbss_device_recentre(device, NULL, NULL));
    refused(&w, VBSS_ERROR_INCOMPATIBLE, vbss_device_hold_jaw(device, 0.5));
    refused(&w, VBSS_ERROR_OUT_OF_RANGE, vbss_device_hold_jaw(device, 1.5));
    refused(&w, VBSS_ERROR_INCOMPATIBLE,
            vbss_mock_add_fault(mock, VBSS_MOCK_FAULT_LATE, 0.0, 1.0, 0.5));
    expect_ok(vbss_device_destroy(device));
    end(&w);
}

static void record_and_replay_distinguish_refusals(void **state)
{
    (void)state;
    world w;
    uint32_t id;
    uint64_t count;
    const uint8_t *bytes;
    vbss_record *record;
    vbss_replay *replay;
    vbss_replay_report report;
    vbss_replay_logged_step step;
    begin(&w);
    const uint32_t thread = w.s.config.thread;
    expect_ok(vbss_record_create(w.s.scene, NULL, &record));
    vbss_record_input input = {.kind = VBSS_RECORD_INPUT_GRASPER_TARGET, .words = {NONE}};
    refused(&w, VBSS_ERROR_NOT_FOUND, vbss_record_apply_input(record, &input, NULL));
    input.words[0] = thread;
    refused(&w, VBSS_ERROR_INCOMPATIBLE, vbss_record_apply_input(record, &input, NULL));
    input = (vbss_record_input){.kind = VBSS_RECORD_INPUT_PIN, .words = {thread}};
    expect_ok(vbss_record_apply_input(record, &input, &id));
    refused(&w, VBSS_ERROR_IN_USE, vbss_record_apply_input(record, &input, &id));
    expect_ok(vbss_scene_set_recorder(w.s.scene, record));
    refused(&w, VBSS_ERROR_OUT_OF_RANGE, vbss_scene_step(w.s.scene, -1.0));
    expect_ok(vbss_scene_step(w.s.scene, SESSION_SCENE_STEP));
    expect_ok(vbss_record_end(record));
    refused(&w, VBSS_ERROR_WRONG_STATE, vbss_scene_set_recorder(w.s.scene, record));
    refused(&w, VBSS_ERROR_WRONG_STATE, vbss_record_apply_input(record, &input, NULL));
    refused(&w, VBSS_ERROR_WRONG_STATE, vbss_record_end(record));
    expect_ok(vbss_record_take(record, &bytes, &count));
    expect_ok(vbss_replay_create(w.context, bytes, count, &replay));
    refused(&w, VBSS_ERROR_WRONG_STATE, vbss_replay_step(replay, &report, sizeof report));
    refused(&w, VBSS_ERROR_NOT_FOUND, vbss_replay_read(replay, 2, &step, sizeof step));
    end(&w);
}

static void session_distinguishes_refusals(void **state)
{
    (void)state;
    world w;
    session_scene second;
    vbss_session *session;
    vbss_record *foreign;
    vbss_session_event event;
    begin(&w);
    vbss_session_config *c = &w.s.config;
    const uint32_t thread = c->thread, left = c->tools[0];
    c->thread = NONE;
    refused(&w, VBSS_ERROR_NOT_FOUND, vbss_session_create(w.s.scene, c, &session));
    c->thread = c->needle;
    refused(&w, VBSS_ERROR_INCOMPATIBLE, vbss_session_create(w.s.scene, c, &session));
    c->thread = thread;
    c->tools[0] = c->tools[1];
    refused(&w, VBSS_ERROR_IN_USE, vbss_session_create(w.s.scene, c, &session));
    c->tools[0] = left;
    expect_ok(vbss_session_create(w.s.scene, c, &session));
    expect_ok(session_scene_still(w.context, &second));
    expect_ok(vbss_record_create(second.scene, NULL, &foreign));
    refused(&w, VBSS_ERROR_INCOMPATIBLE, vbss_session_set_record(session, foreign));
    refused(&w, VBSS_ERROR_NOT_FOUND, vbss_session_get_event(session, NONE, &event, sizeof event));
    refused(&w, VBSS_ERROR_WRONG_STATE, vbss_session_seek(session, 1)); /* it follows no replay */
    refused(&w, VBSS_ERROR_OUT_OF_RANGE, vbss_session_step(session, 0.0, -1.0));
    expect_ok(vbss_scene_step(w.s.scene, SESSION_SCENE_STEP)); /* past the session */
    refused(&w, VBSS_ERROR_WRONG_STATE, vbss_session_step(session, 0.0, SESSION_SCENE_STEP));
    end(&w);
}

int test_statuses(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(collision_distinguishes_refusals),
        harness_test(thread_distinguishes_refusals),
        harness_test(drain_distinguishes_refusals),
        harness_test(scene_distinguishes_refusals),
        harness_test(baseline_scene_distinguishes_refusals),
        harness_test(visual_distinguishes_refusals),
        harness_test(metrics_distinguish_refusals),
        harness_test(knot_detector_distinguishes_refusals),
        harness_test(device_distinguishes_refusals),
        harness_test(record_and_replay_distinguish_refusals),
        harness_test(session_distinguishes_refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
