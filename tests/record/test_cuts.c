/* Cuts of a recorded scene: in the log, replayed to the bit; refused cuts are not in it. */
#include "fixture.h"
#include "record/record.h"

enum { STEPS = 60 };

typedef struct cutting {
    harness_memory memory;
    vbss_context *context;
    vbss_scene *scene;
    uint32_t body;
} cutting;

static void begin(cutting *c, vbss_method method)
{
    vbss_scene_config config;
    vbss_thread_config own;
    vbss_thread *thread;
    uint32_t pin;
    *c = (cutting){.context = NULL};
    c->context = harness_context(&c->memory);
    expect_ok(vbss_scene_config_init(&config, sizeof config));
    expect_ok(vbss_thread_config_init(&own, sizeof own));
    config.method = own.method = method;
    config.node_capacity = 60;
    own.segment_count = 30;
    own.length = 0.03;
    own.cut_capacity = 3;
    expect_ok(vbss_scene_create(c->context, &config, &c->scene));
    expect_ok(vbss_thread_create(c->context, &own, &thread));
    expect_ok(vbss_scene_add_thread(c->scene, thread, &c->body));
    expect_ok(vbss_scene_pin_thread(c->scene, c->body, 0, 0, NULL, &pin));
    expect_ok(vbss_scene_pin_thread(c->scene, c->body, 30, 0, NULL, &pin));
}

static void make_edits(const cutting *c, uint32_t step)
{
    uint32_t piece = 0;
    if (step == 10 || step == 30) {
        double arc = step == 10 ? 0.0152 : 0.004;
        expect_ok(vbss_scene_cut_thread(c->scene, c->body, arc, &piece));
        assert_int_equal(piece, step == 10 ? 2 : 3);
    } else if (step == 31) { /* a piece goes on to be told things */
        vbss_thread_attachment a;
        vbss_thread *thread;
        uint32_t id;
        expect_ok(vbss_thread_attachment_init(&a, sizeof a));
        a.kind = VBSS_THREAD_ATTACHMENT_FORCE;
        a.force[2] = 1e-3;
        expect_ok(vbss_scene_get_thread(c->scene, 2, &thread));
        expect_ok(vbss_thread_attach(thread, &a, &id));
    }
}

static log_bytes log_of_cuts(cutting *c)
{
    vbss_record *record;
    log_bytes log = {NULL, 0};
    expect_ok(vbss_record_create(c->scene, NULL, &record));
    expect_ok(vbss_scene_set_recorder(c->scene, record));
    for (uint32_t i = 0; i < STEPS; i++) {
        make_edits(c, i);
        expect_ok(vbss_scene_step(c->scene, 1e-3));
    }
    expect_ok(vbss_record_end(record));
    log_take(&log, record);
    return log;
}

static void replay(const cutting *c, const log_bytes *log)
{
    vbss_replay *replay;
    vbss_replay_report report;
    expect_ok(vbss_replay_create(c->context, log->bytes, log->count, &replay));
    expect_ok(vbss_replay_begin(replay, c->scene));
    expect_ok(replay_all(replay, &report));
    assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_ENDED);
    assert_int_equal(report.agreed_step, STEPS);
    expect_ok(vbss_replay_destroy(replay));
}

/* In a scene made alike, again in the same, and in the one that was recorded, with its cuts. */
static void cuts_replay_bit_equal(void **state)
{
    (void)state;
    for (int method = 0; method < 2; method++) {
        cutting c, other;
        begin(&c, method);
        log_bytes log = log_of_cuts(&c);
        begin(&other, method);
        replay(&other, &log);
        replay(&other, &log);
        replay(&c, &log);
        log_free(&log);
        harness_context_end(other.context, &other.memory);
        harness_context_end(c.context, &c.memory);
    }
}

static void rejected_cuts_are_not_recorded(void **state)
{
    (void)state;
    cutting c;
    vbss_record *record;
    uint32_t piece = 77;
    begin(&c, VBSS_METHOD_IMPLICIT);
    expect_ok(vbss_record_create(c.scene, NULL, &record));
    expect_ok(vbss_scene_set_recorder(c.scene, record));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_scene_cut_thread(c.scene, 1, 0.01, NULL));
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_scene_cut_thread(c.scene, 2, 0.01, &piece));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_scene_cut_thread(c.scene, 1, 0.0, &piece));
    expect_result(VBSS_ERROR_NOT_FINITE,
                  vbss_scene_cut_thread(c.scene, 1, harness_bad_numbers[0], &piece));
    assert_int_equal(piece, 77);
    expect_ok(vbss_scene_step(c.scene, 1e-3));
    expect_ok(vbss_scene_set_recorder(c.scene, NULL));
    expect_ok(vbss_scene_cut_thread(c.scene, 1, 0.01, &piece)); /* past the record */
    expect_result(VBSS_ERROR_WRONG_STATE, vbss_scene_set_recorder(c.scene, record));
    harness_context_end(c.context, &c.memory);
}

static void impossible_cuts_keep_recording(void **state)
{
    (void)state;
    cutting c;
    vbss_record *record;
    uint32_t piece;
    begin(&c, VBSS_METHOD_IMPLICIT);
    expect_ok(vbss_record_create(c.scene, NULL, &record));
    expect_ok(vbss_scene_set_recorder(c.scene, record));
    for (int k = 1; k <= 3; k++) {
        expect_ok(vbss_scene_cut_thread(c.scene, 1, 0.02 - 5e-3 * k, &piece));
    }
    expect_result(VBSS_ERROR_CAPACITY, vbss_scene_cut_thread(c.scene, 1, 2e-3, &piece));
    expect_ok(vbss_scene_step(c.scene, 1e-3));
    harness_context_end(c.context, &c.memory);
}

int test_cuts(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cuts_replay_bit_equal),
        cmocka_unit_test(rejected_cuts_are_not_recorded),
        cmocka_unit_test(impossible_cuts_keep_recording),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
