/* A record that is attached to its scene logs what the host does with the scene by its own functions. */
#include "fixture.h"
#include "fixtures/adaptive_scene.h"
#include "fixtures/cutting_scene.h"
#include "fixtures/needle_scenes.h"
#include "fixtures/scene_scenes.h"
#include "fixtures/tool_scenes.h"

/* Attaches a new record. */
static vbss_record *attach(vbss_scene *scene)
{
    vbss_record *record;
    vbss_record_config config;
    expect_ok(vbss_record_config_init(&config, sizeof config));
    config.buffer_bytes = 1u << 22;
    config.snapshot_interval = 50;
    expect_ok(vbss_record_create(scene, &config, &record));
    expect_ok(vbss_scene_set_recorder(scene, record));
    return record;
}

/* Ends the record. Its log must lead a scene that is loaded from the log to the same hash. */
static void expect_replays(vbss_scene *scene, vbss_record *record, uint64_t steps)
{
    log_bytes log = {NULL, 0};
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_replay *replay;
    vbss_replay_report report;
    vbss_scene *loaded;
    uint64_t wanted = 0, found = 0;
    expect_ok(vbss_record_end(record));
    log_take(&log, record);
    expect_ok(vbss_replay_create(context, log.bytes, log.count, &replay));
    expect_ok(vbss_replay_load_scene(replay, &loaded));
    expect_ok(replay_all(replay, &report));
    assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_ENDED);
    assert_int_equal(report.agreed_step, steps);
    expect_ok(vbss_scene_get_hash(scene, &wanted));
    expect_ok(vbss_scene_get_hash(loaded, &found));
    assert_int_equal(wanted, found);
    log_free(&log);
    harness_context_end(context, &memory);
}

/* ---- scenes in motion */

typedef struct run {
    vbss_result (*create)(vbss_context *context, vbss_scene **scene);
    vbss_result (*step)(vbss_scene *scene);
    uint32_t first, steps; /* steps before the record, and with it */
} run;

static vbss_result create_tools(vbss_context *context, vbss_scene **scene)
{
    return tool_scene_create(context, VBSS_METHOD_IMPLICIT, scene);
}
static vbss_result create_paper_tools(vbss_context *context, vbss_scene **scene)
{
    return tool_scene_create(context, VBSS_METHOD_VBLAST, scene);
}
static vbss_result create_cuts(vbss_context *context, vbss_scene **scene)
{
    return cutting_scene_create(context, VBSS_METHOD_IMPLICIT, scene);
}
static vbss_result create_adaptive(vbss_context *context, vbss_scene **scene)
{
    return adaptive_scene_create(context, VBSS_THREAD_BENDING_SPLINE, scene);
}
static vbss_result create_mesh(vbss_context *context, vbss_scene **scene)
{
    return scene_scene_create(context, SCENE_SCENE_MESH, scene);
}
static vbss_result step_mesh(vbss_scene *scene)
{
    return scene_scene_step(scene, SCENE_SCENE_MESH);
}

static const run runs[] = {
    {create_tools, tool_scene_step, 90, 220},
    {create_paper_tools, tool_scene_step, 0, 120},
    {needle_scene_create, needle_scene_step, 390, 120},
    {create_cuts, cutting_scene_step, 0, 90},
    {create_adaptive, adaptive_scene_step, 0, 90},
    {create_mesh, step_mesh, 5, 25},
};

static void log_of_attached_record_replays_in_loaded_scene(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof runs / sizeof runs[0]; i++) {
        harness_memory memory;
        vbss_context *context = harness_context(&memory);
        vbss_scene *scene;
        expect_ok(runs[i].create(context, &scene));
        for (uint32_t k = 0; k < runs[i].first; k++) {
            expect_ok(runs[i].step(scene));
        }
        vbss_record *record = attach(scene);
        for (uint32_t k = 0; k < runs[i].steps; k++) {
            expect_ok(runs[i].step(scene));
        }
        expect_replays(scene, record, runs[i].steps);
        harness_context_end(context, &memory);
    }
}

static void pins_attachments_and_targets_are_logged(void **state)
{
    (void)state;
    stage s;
    stage_begin(&s, NULL);
    vbss_record *record = attach(s.scene);
    for (uint32_t i = 0; i < 60; i++) {
        stage_step(&s, NULL);
    }
    expect_replays(s.scene, record, 60);
    stage_end(&s);
}

/* ---- edits one by one */

typedef struct mixed {
    stage s;
    vbss_drain *drain;
    uint32_t drain_body, needle;
} mixed;

/* A stage with a drain and a needle beside it. */
static void begin_mixed(mixed *m)
{
    vbss_scene_config c;
    vbss_drain_config d;
    vbss_needle_config n;
    vbss_needle *needle;
    memset(m, 0, sizeof *m);
    m->s.context = harness_context(&m->s.memory);
    expect_ok(vbss_scene_config_init(&c, sizeof c));
    expect_ok(vbss_scene_create(m->s.context, &c, &m->s.scene));
    expect_ok(vbss_drain_config_init(&d, sizeof d));
    expect_ok(vbss_drain_create(m->s.context, &d, &m->drain));
    expect_ok(vbss_scene_add_drain(m->s.scene, m->drain, &m->drain_body));
    expect_ok(vbss_needle_config_init(&n, sizeof n));
    n.position[1] = 0.1;
    expect_ok(vbss_needle_create(m->s.context, &n, &needle));
    expect_ok(vbss_scene_add_needle(m->s.scene, needle, &m->needle));
}

static void step(mixed *m, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        expect_ok(vbss_scene_step(m->s.scene, 1e-3));
    }
}

static void edits_of_drains_and_removal_are_logged(void **state)
{
    (void)state;
    mixed m;
    uint32_t pull;
    const double at[3] = {0.0, 0.2, 0.0}, force[3] = {0.0, 0.02, 0.0};
    vbss_drain_attachment a;
    begin_mixed(&m);
    vbss_record *record = attach(m.s.scene);
    expect_ok(vbss_drain_attachment_init(&a, sizeof a));
    a.kind = VBSS_DRAIN_ATTACHMENT_FORCE;
    a.node = 5;
    a.force[1] = 0.01;
    step(&m, 1);
    vbss_result result = vbss_drain_attach(m.drain, &a, &pull);
    for (a.node = 6; result != VBSS_OK; a.node++) { /* node 5 may be anchored */
        result = vbss_drain_attach(m.drain, &a, &pull);
    }
    step(&m, 2);
    expect_ok(vbss_drain_set_attachment_target(m.drain, pull, force));
    step(&m, 2);
    expect_ok(vbss_drain_detach(m.drain, pull));
    step(&m, 1);
    expect_ok(vbss_scene_set_rigid_pose(m.s.scene, m.needle, at, NULL));
    step(&m, 1);
    expect_ok(vbss_scene_remove(m.s.scene, m.needle));
    step(&m, 2);
    expect_replays(m.s.scene, record, 9);
    stage_end(&m.s);
}

/* Where the needle must be so that it passes through the middle of a triangle. */
static void find_pose(const mixed *m, uint32_t triangle, double arc, double position[3])
{
    vbss_view triangles, nodes;
    vbss_needle *needle;
    vbss_scene_rigid_state now;
    double place[3];
    expect_ok(
        vbss_drain_get_view(m->drain, VBSS_DRAIN_VIEW_TRIANGLES, &triangles, sizeof triangles));
    expect_ok(vbss_drain_get_view(m->drain, VBSS_DRAIN_VIEW_POSITIONS, &nodes, sizeof nodes));
    expect_ok(vbss_scene_get_needle(m->s.scene, m->needle, &needle));
    expect_ok(vbss_needle_get_place(needle, arc, place, NULL));
    expect_ok(vbss_scene_get_rigid(m->s.scene, m->needle, &now, sizeof now));
    const uint32_t *corner = (const uint32_t *)triangles.data + 3 * (size_t)triangle;
    for (int i = 0; i < 3; i++) {
        const double *x = (const double *)nodes.data + i;
        const double middle =
            (x[3 * (size_t)corner[0]] + x[3 * (size_t)corner[1]] + x[3 * (size_t)corner[2]]) / 3.0;
        position[i] = now.position[i] + middle - place[i];
    }
}

static void made_holes_are_logged(void **state)
{
    (void)state;
    mixed m;
    uint32_t id = 0;
    const uint32_t triangle = 20;
    const double weights[3] = {1.0 / 3, 1.0 / 3, 1.0 / 3}, arc = 0.01;
    double position[3];
    begin_mixed(&m);
    vbss_record *record = attach(m.s.scene);
    step(&m, 1);
    find_pose(&m, triangle, arc, position);
    expect_ok(vbss_scene_set_rigid_pose(m.s.scene, m.needle, position, NULL));
    expect_ok(vbss_scene_make_hole(m.s.scene, m.needle, arc, m.drain_body, triangle, weights, &id));
    step(&m, 3);
    expect_replays(m.s.scene, record, 4);
    stage_end(&m.s);
}

static void edit_inside_an_edit_is_logged_once(void **state)
{
    (void)state;
    stage s;
    uint32_t pin;
    log_bytes log = {NULL, 0};
    vbss_replay_logged_step read;
    stage_begin(&s, NULL);
    vbss_record *record = attach(s.scene);
    expect_ok(vbss_scene_pin_thread(s.scene, s.body, 15, 0, NULL, &pin)); /* attaches the node */
    expect_ok(vbss_scene_step(s.scene, 1e-3));
    expect_ok(vbss_scene_unpin_thread(s.scene, pin)); /* detaches it */
    expect_ok(vbss_scene_step(s.scene, 1e-3));
    log_take(&log, record);
    vbss_replay *replay = replay_of(&s, &log);
    for (uint64_t i = 1; i <= 2; i++) {
        expect_ok(vbss_replay_read(replay, i, &read, sizeof read));
        assert_int_equal(read.input_count, 1);
        assert_int_equal(read.inputs[0].kind,
                         i == 1 ? VBSS_RECORD_INPUT_PIN : VBSS_RECORD_INPUT_UNPIN);
    }
    log_free(&log);
    stage_end(&s);
}

static void failed_edit_is_not_logged(void **state)
{
    (void)state;
    stage s;
    uint32_t id;
    const double far[3] = {1e9, 0.0, 0.0};
    stage_begin(&s, NULL);
    vbss_record *record = attach(s.scene);
    expect_result(VBSS_ERROR_OUT_OF_RANGE,
                  vbss_scene_set_rigid_target(s.scene, s.tools[0], far, NULL));
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_scene_unpin_thread(s.scene, 1000));
    expect_result(VBSS_ERROR_OUT_OF_RANGE,
                  vbss_scene_pin_thread(s.scene, s.body, 1000, 0, NULL, &id));
    stage_step(&s, NULL);
    expect_replays(s.scene, record, 1);
    stage_end(&s);
}

/* ---- edits without an input of their own */

typedef vbss_result (*deed)(stage *s);

static vbss_result add_a_drain(stage *s)
{
    vbss_drain *drain;
    uint32_t body;
    vbss_drain_config c;
    expect_ok(vbss_drain_config_init(&c, sizeof c));
    c.position[1] = 0.5;
    expect_ok(vbss_drain_create(s->context, &c, &drain));
    return vbss_scene_add_drain(s->scene, drain, &body);
}

static vbss_result add_a_rod(stage *s)
{
    const vbss_scene_capsule capsule = {{0.3, 0.3, 0.3}, {0.31, 0.3, 0.3}, 1e-3};
    vbss_scene_rigid_config c;
    uint32_t body;
    expect_ok(vbss_scene_rigid_config_init(&c, sizeof c));
    c.capsule_count = 1;
    c.capsules = &capsule;
    return vbss_scene_add_rigid(s->scene, &c, &body);
}

static vbss_result stop_the_thread(stage *s)
{
    const double rest[3 * 31] = {0.0};
    return vbss_thread_set_state(s->thread, NULL, rest, 31);
}

static vbss_result restore_itself(stage *s)
{
    static uint8_t bytes[1u << 20];
    uint64_t count;
    expect_ok(vbss_scene_save(s->scene, bytes, sizeof bytes, &count));
    return vbss_scene_restore(s->scene, bytes, count);
}

/* The log then has the state after the edit. */
static void edits_without_an_input_are_logged(void **state)
{
    (void)state;
    static const deed deeds[] = {add_a_drain, stop_the_thread, add_a_rod, restore_itself};
    enum { DEEDS = sizeof deeds / sizeof deeds[0] };
    const double at[3] = {0.05, 0.02, 0.01};
    stage s;
    stage_begin(&s, NULL);
    vbss_record *record = attach(s.scene);
    for (size_t i = 0; i < DEEDS; i++) {
        expect_ok(vbss_scene_set_rigid_target(s.scene, s.tools[1], at, NULL));
        expect_ok(deeds[i](&s));
        stage_step(&s, NULL);
        stage_step(&s, NULL);
    }
    expect_replays(s.scene, record, 2 * (uint64_t)DEEDS);
    stage_end(&s);
}

/* Bodies come and go; a loaded scene follows to any step, forwards and back. */
static void replay_seeks_across_added_and_removed_bodies(void **state)
{
    (void)state;
    enum { STEPS = 30 };
    stage s;
    uint64_t hashes[STEPS + 1];
    log_bytes log = {NULL, 0};
    vbss_replay *replay;
    vbss_replay_report report;
    vbss_scene *loaded;
    vbss_record_config config;
    vbss_record *record;
    stage_begin(&s, NULL);
    expect_ok(vbss_record_config_init(&config, sizeof config));
    config.snapshot_interval = 4;
    expect_ok(vbss_record_create(s.scene, &config, &record));
    expect_ok(vbss_scene_set_recorder(s.scene, record));
    hashes[0] = stage_hash(&s);
    for (uint32_t i = 1; i <= STEPS; i++) {
        if (i == 7) {
            expect_ok(add_a_drain(&s));
        } else if (i == 14) {
            expect_ok(vbss_scene_remove(s.scene, s.ball));
        } else if (i == 22) {
            expect_ok(add_a_rod(&s));
        }
        expect_ok(vbss_scene_step(s.scene, 1e-3));
        hashes[i] = stage_hash(&s);
    }
    expect_ok(vbss_record_end(record));
    log_take(&log, record);
    replay = replay_of(&s, &log);
    expect_ok(vbss_replay_load_scene(replay, &loaded));
    const uint32_t targets[] = {30, 6, 7, 14, 13, 0, 22, 21, 5, 29};
    for (size_t i = 0; i < sizeof targets / sizeof targets[0]; i++) {
        uint64_t hash = 0;
        expect_ok(vbss_replay_seek(replay, targets[i], &report, sizeof report));
        expect_ok(vbss_scene_get_hash(loaded, &hash));
        assert_int_equal(hash, hashes[targets[i]]);
    }
    expect_ok(vbss_replay_begin(replay, loaded));
    expect_ok(replay_all(replay, &report));
    assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_ENDED);
    assert_int_equal(report.agreed_step, STEPS);
    log_free(&log);
    stage_end(&s);
}

/* A replay in a scene that the host has made lacks such bodies, and says so. */
static void scene_of_the_host_cannot_follow_added_bodies(void **state)
{
    (void)state;
    stage s, other;
    log_bytes log = {NULL, 0};
    vbss_replay_report report;
    stage_begin(&s, NULL);
    stage_begin(&other, NULL);
    vbss_record *record = attach(s.scene);
    stage_step(&s, NULL);
    expect_ok(add_a_rod(&s));
    stage_step(&s, NULL);
    log_take(&log, record);
    vbss_replay *replay = replay_of(&other, &log);
    expect_ok(vbss_replay_begin(replay, other.scene));
    expect_ok(vbss_replay_step(replay, &report, sizeof report));
    expect_result(VBSS_ERROR_CORRUPT, vbss_replay_step(replay, &report, sizeof report));
    assert_non_null(strstr(last_text(other.context), "vbss_replay_load_scene"));
    log_free(&log);
    stage_end(&other);
    stage_end(&s);
}

/* After a loss of power between an addition and its step, the log goes on without the addition. */
static void addition_without_its_step_is_cut_off(void **state)
{
    (void)state;
    stage s;
    log_bytes log = {NULL, 0};
    vbss_scene *loaded;
    vbss_record *record;
    uint64_t position = 0;
    stage_begin(&s, NULL);
    record = attach(s.scene);
    stage_step(&s, NULL);
    log_take(&log, record);
    const size_t complete = log.count;
    expect_ok(add_a_rod(&s));
    log_take(&log, record);
    assert_true(log.count > complete);
    vbss_replay *replay = replay_of(&s, &log);
    expect_ok(vbss_replay_load_scene(replay, &loaded));
    expect_ok(vbss_record_resume(replay, NULL, &record, &position));
    assert_int_equal(position, complete);
    log_free(&log);
    stage_end(&s);
}

/* ---- attaching and detaching */

static void record_that_does_not_know_the_state_is_not_attached(void **state)
{
    (void)state;
    stage s, other;
    stage_begin(&s, NULL);
    stage_begin(&other, NULL);
    vbss_record *record = attach(s.scene);
    stage_step(&s, NULL);
    expect_ok(vbss_scene_set_recorder(s.scene, NULL));
    expect_ok(vbss_scene_set_recorder(s.scene, record));
    stage_step(&s, NULL);
    expect_ok(vbss_scene_set_recorder(s.scene, NULL));
    stage_step(&s, NULL);
    expect_result(VBSS_ERROR_WRONG_STATE, vbss_scene_set_recorder(s.scene, record));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_scene_set_recorder(other.scene, record));
    expect_result(VBSS_ERROR_INVALID_HANDLE,
                  vbss_scene_set_recorder(s.scene, (vbss_record *)s.thread));
    expect_result(VBSS_ERROR_INVALID_HANDLE, vbss_scene_set_recorder(NULL, record));
    stage_end(&other);
    stage_end(&s);
}

static void destroyed_record_is_detached(void **state)
{
    (void)state;
    stage s;
    stage_begin(&s, NULL);
    vbss_record *record = attach(s.scene);
    stage_step(&s, NULL);
    expect_ok(vbss_record_destroy(record));
    stage_step(&s, NULL);
    record = attach(s.scene);
    expect_ok(vbss_scene_destroy(s.scene));
    expect_ok(vbss_record_end(record));
    stage_end(&s);
}

static void too_many_inputs_refuse_the_edit(void **state)
{
    (void)state;
    stage s;
    vbss_record *record;
    vbss_record_config config;
    const double at[3] = {0.05, 0.02, 0.01};
    stage_begin(&s, NULL);
    expect_ok(vbss_record_config_init(&config, sizeof config));
    config.input_capacity = 2;
    expect_ok(vbss_record_create(s.scene, &config, &record));
    expect_ok(vbss_scene_set_recorder(s.scene, record));
    expect_ok(vbss_scene_set_rigid_target(s.scene, s.tools[1], at, NULL));
    expect_ok(vbss_scene_set_rigid_target(s.scene, s.tools[1], at, NULL));
    const uint64_t hash = stage_hash(&s);
    expect_result(VBSS_ERROR_CAPACITY, vbss_scene_set_rigid_target(s.scene, s.tools[0], at, NULL));
    assert_int_equal(hash, stage_hash(&s));
    expect_ok(vbss_scene_step(s.scene, 1e-3));
    expect_ok(vbss_scene_set_rigid_target(s.scene, s.tools[1], at, NULL));
    expect_ok(vbss_scene_step(s.scene, 1e-3));
    expect_replays(s.scene, record, 2);
    stage_end(&s);
}

int test_attached(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(log_of_attached_record_replays_in_loaded_scene),
        harness_test(pins_attachments_and_targets_are_logged),
        harness_test(edits_of_drains_and_removal_are_logged),
        harness_test(made_holes_are_logged),
        harness_test(edit_inside_an_edit_is_logged_once),
        harness_test(failed_edit_is_not_logged),
        harness_test(edits_without_an_input_are_logged),
        harness_test(replay_seeks_across_added_and_removed_bodies),
        harness_test(scene_of_the_host_cannot_follow_added_bodies),
        harness_test(addition_without_its_step_is_cut_off),
        harness_test(record_that_does_not_know_the_state_is_not_attached),
        harness_test(destroyed_record_is_detached),
        harness_test(too_many_inputs_refuse_the_edit),
    };
    return cmocka_run_group_tests_name("record.attached", tests, NULL, NULL);
}
