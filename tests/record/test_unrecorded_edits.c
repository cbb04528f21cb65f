/* A record knows all that was done to the scene, or says so. */
#include "recorder.h"
#include "scene/world/scene_data.h"

typedef void (*deed)(stage *s);

static const double somewhere[3] = {0.05, 0.02, 0.01};

static void move_a_tool(stage *s)
{
    expect_ok(vbss_scene_set_rigid_target(s->scene, s->tools[1], somewhere, NULL));
}

static void move_a_force(stage *s)
{
    expect_ok(vbss_thread_set_attachment_target(s->thread, s->force, somewhere, NULL));
}

static void detach_a_force(stage *s)
{
    expect_ok(vbss_thread_detach(s->thread, s->force));
}

static void attach_a_mass(stage *s)
{
    uint32_t id;
    vbss_thread_attachment a;
    expect_ok(vbss_thread_attachment_init(&a, sizeof a));
    a.kind = VBSS_THREAD_ATTACHMENT_MASS;
    expect_ok(vbss_thread_attach(s->thread, &a, &id));
}

static void stop_the_thread(stage *s)
{
    const double rest[3 * 31] = {0.0};
    expect_ok(vbss_thread_set_state(s->thread, NULL, rest, 31));
}

static void pin_a_node(stage *s)
{
    expect_ok(vbss_scene_pin_thread(s->scene, s->body, 15, 0, NULL, &s->pin));
}

static void step_alone(stage *s)
{
    expect_ok(vbss_scene_step(s->scene, 1e-3));
}

static void remove_a_body(stage *s)
{
    expect_ok(vbss_scene_remove(s->scene, s->ball));
}

static void remove_the_thread(stage *s)
{
    expect_ok(vbss_scene_remove(s->scene, s->body));
}

static const deed deeds[] = {move_a_tool,   move_a_force,    detach_a_force,
                             attach_a_mass, stop_the_thread, pin_a_node,
                             step_alone,    remove_a_body,   remove_the_thread};

static void unrecorded_edit_is_detected(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof deeds / sizeof deeds[0]; i++) {
        recorder r;
        const vbss_record_input input = {.kind = VBSS_RECORD_INPUT_UNPIN, .words = {1}};
        recorder_begin(&r, NULL);
        stage_step(&r.s, r.record);
        stage_step(&r.s, r.record);
        expect_ok(vbss_scene_set_recorder(r.s.scene, NULL));
        deeds[i](&r.s);
        uint64_t hash = stage_hash(&r.s);
        expect_result(VBSS_ERROR_WRONG_STATE, vbss_record_apply_input(r.record, &input, NULL));
        expect_result(VBSS_ERROR_WRONG_STATE, vbss_scene_set_recorder(r.s.scene, r.record));
        assert_non_null(strstr(last_text(r.s.context), "past the record after step 2"));
        assert_true(stage_hash(&r.s) == hash);
        expect_ok(vbss_record_end(r.record)); /* the log is good up to there */
        recorder_end(&r, 2);
    }
}

/* Of drains too. */
static void unrecorded_drain_edit_is_detected(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_scene_config config;
    vbss_drain_config own;
    vbss_drain_attachment a;
    vbss_scene *scene;
    vbss_drain *drain;
    vbss_record *record;
    uint32_t body, id;
    expect_ok(vbss_scene_config_init(&config, sizeof config));
    expect_ok(vbss_drain_config_init(&own, sizeof own));
    expect_ok(vbss_scene_create(context, &config, &scene));
    expect_ok(vbss_drain_create(context, &own, &drain));
    expect_ok(vbss_scene_add_drain(scene, drain, &body));
    expect_ok(vbss_record_create(scene, NULL, &record));
    expect_ok(vbss_scene_set_recorder(scene, record));
    expect_ok(vbss_scene_step(scene, 1e-3));
    expect_ok(vbss_scene_step(scene, 1e-3)); /* its own steps are no edits */
    expect_ok(vbss_scene_set_recorder(scene, NULL));
    expect_ok(vbss_drain_attachment_init(&a, sizeof a));
    expect_ok(vbss_drain_attach(drain, &a, &id));
    expect_result(VBSS_ERROR_WRONG_STATE, vbss_scene_set_recorder(scene, record));
    assert_non_null(strstr(last_text(context), "past the record after step 2"));
    harness_context_end(context, &memory);
}

/* A call that is refused while a step is suspended is no edit, whether it is refused at once or at its end. */
static void refused_call_leaves_record_alive(void **state)
{
    (void)state;
    recorder r;
    uint32_t id;
    recorder_begin(&r, NULL);
    scene_object *scene = ((vbss_slot *)r.s.scene)->object;
    scene->settings.call_budget = 1;
    for (int i = 0; i < 200 || !scene->cursor.is_suspended; i++) {
        stage_step(&r.s, r.record);
    }
    const uint64_t hash = stage_hash(&r.s);
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_scene_cut_thread(r.s.scene, r.s.body, 5.0, &id));
    expect_result(VBSS_ERROR_OUT_OF_RANGE,
                  vbss_scene_pin_thread(r.s.scene, r.s.body, 999, 0, NULL, &id));
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_scene_unpin_thread(r.s.scene, 77));
    thread_object *t = ((vbss_slot *)r.s.thread)->object;
    const uint32_t last_id = t->last_id;
    t->last_id = UINT32_MAX; /* no room for the attachment, which the pin finds last */
    const uint64_t full = stage_hash(&r.s);
    expect_result(VBSS_ERROR_CAPACITY,
                  vbss_scene_pin_thread(r.s.scene, r.s.body, 15, 0, NULL, &id));
    assert_true(stage_hash(&r.s) == full);
    t->last_id = last_id;
    assert_true(scene->cursor.is_suspended && stage_hash(&r.s) == hash);
    expect_ok(vbss_scene_step(r.s.scene, 1e-3));
    expect_ok(vbss_record_end(r.record));
    log_free(&r.log);
    stage_end(&r.s);
}

static void queries_are_no_edits(void **state)
{
    (void)state;
    recorder r;
    uint8_t bytes[8];
    uint64_t written;
    vbss_scene_rigid_state rigid;
    vbss_view view;
    recorder_begin(&r, NULL);
    stage_step(&r.s, r.record);
    (void)stage_hash(&r.s);
    expect_result(VBSS_ERROR_CAPACITY, vbss_scene_save(r.s.scene, bytes, 8, &written));
    expect_ok(vbss_scene_get_rigid(r.s.scene, r.s.ball, &rigid, sizeof rigid));
    expect_ok(vbss_thread_get_view(r.s.thread, VBSS_THREAD_VIEW_CURVATURES, &view, sizeof view));
    expect_result(VBSS_ERROR_IN_SCENE, vbss_thread_step(r.s.thread, 1e-3));
    stage_step(&r.s, r.record);
    expect_ok(vbss_record_end(r.record));
    recorder_end(&r, 2);
}

int test_unrecorded_edits(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(unrecorded_edit_is_detected),
        cmocka_unit_test(unrecorded_drain_edit_is_detected),
        cmocka_unit_test(refused_call_leaves_record_alive),
        cmocka_unit_test(queries_are_no_edits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
