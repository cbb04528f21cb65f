/* Scenes whose threads adapt, told through a record: what is told in node numbers is replayed to the bit. */
#include "fixture.h"
#include "record/record.h"
#include "fixtures/knots.h"

enum { STEPS = 160, FORCE_AT = 60, CUT_AT = 90, PIN_AT = 100 };

typedef struct adapting {
    harness_memory memory;
    vbss_context *context;
    vbss_scene *scene;
    vbss_thread *thread;
    uint32_t body, pins[2];
} adapting;

static void begin(adapting *a)
{
    vbss_scene_config config;
    vbss_thread_config own;
    knot_shape shape;
    knot_line line;
    static vec3 x[KNOT_NODES];
    static double rest[KNOT_NODES];
    *a = (adapting){.context = NULL};
    a->context = harness_context(&a->memory);
    knot_shape_init(&shape, KNOT_OVERHAND);
    shape.size = 2e-3;
    shape.length = 0.08;
    shape.finest = shape.coarsest = 1.2e-3;
    expect_ok(knot_make(&shape, KNOT_NODES, x, rest, &line));
    expect_ok(vbss_scene_config_init(&config, sizeof config));
    expect_ok(vbss_thread_config_init(&own, sizeof own));
    own.segment_count = line.node_count - 1;
    own.positions = &x[0].x;
    own.rest_lengths = rest;
    own.mesh = VBSS_THREAD_MESH_ADAPTIVE;
    own.node_capacity = 400;
    own.cut_capacity = 1;
    expect_ok(vbss_scene_create(a->context, &config, &a->scene));
    expect_ok(vbss_thread_create(a->context, &own, &a->thread));
    expect_ok(vbss_scene_add_thread(a->scene, a->thread, &a->body));
    expect_ok(vbss_scene_pin_thread(a->scene, a->body, 0, 0, NULL, &a->pins[0]));
}

/* Nodes are named as they are numbered at that moment. */
static void make_edits(const adapting *a, uint32_t step)
{
    vbss_thread_statistics s;
    vbss_thread_attachment force;
    uint32_t id, piece, pin;
    expect_ok(vbss_thread_get_statistics(a->thread, &s, sizeof s));
    if (step == FORCE_AT) {
        expect_ok(vbss_thread_attachment_init(&force, sizeof force));
        force.kind = VBSS_THREAD_ATTACHMENT_FORCE;
        force.node = s.nodes - 1;
        force.force[0] = 0.02;
        expect_ok(vbss_thread_attach(a->thread, &force, &id));
    } else if (step == CUT_AT) {
        expect_ok(vbss_scene_cut_thread(a->scene, a->body, 0.07, &piece));
    } else if (step == PIN_AT) {
        expect_ok(vbss_scene_pin_thread(a->scene, a->body, s.nodes - 4, 0, NULL, &pin));
    }
}

static void adapted_scene_replays_bit_equal(void **state)
{
    (void)state;
    adapting a, other;
    vbss_record *record;
    log_bytes log = {NULL, 0};
    begin(&a);
    expect_ok(vbss_record_create(a.scene, NULL, &record));
    expect_ok(vbss_scene_set_recorder(a.scene, record));
    uint32_t changed = 0, nodes = 0;
    for (uint32_t i = 0; i < STEPS; i++) {
        vbss_thread_statistics s;
        make_edits(&a, i);
        expect_ok(vbss_scene_step(a.scene, 1e-3));
        expect_ok(vbss_thread_get_statistics(a.thread, &s, sizeof s));
        changed += s.nodes != nodes;
        nodes = s.nodes;
    }
    assert_true(changed > 10);
    expect_ok(vbss_record_end(record));
    log_take(&log, record);
    begin(&other);
    const adapting *scenes[3] = {&other, &other, &a};
    for (int k = 0; k < 3; k++) {
        vbss_replay *replay;
        vbss_replay_report report;
        expect_ok(vbss_replay_create(scenes[k]->context, log.bytes, log.count, &replay));
        expect_ok(vbss_replay_begin(replay, scenes[k]->scene));
        expect_ok(replay_all(replay, &report));
        assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_ENDED);
        assert_int_equal(report.agreed_step, STEPS);
        expect_ok(vbss_replay_destroy(replay));
    }
    log_free(&log);
    harness_context_end(other.context, &other.memory);
    harness_context_end(a.context, &a.memory);
}

int test_adaptive_mesh(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(adapted_scene_replays_bit_equal),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
