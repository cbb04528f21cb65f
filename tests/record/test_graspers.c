/* Sessions with graspers: recorded, replayed to the bit; what is told past the record is found out. */
#include "fixture.h"

#include <vblast_ss/scene_query.h>

#include "fixtures/tool_scenes.h"

/* The context must not move: the memory it watches is in the stage. */
static void tools_make(stage *s, vbss_method method)
{
    memset(s, 0, sizeof *s);
    s->context = harness_context(&s->memory);
    expect_ok(tool_scene_create(s->context, method, &s->scene));
}

/* Steps of a round, from the first; what they are told is recorded. */
static log_bytes record_tools(stage *s, uint32_t steps)
{
    log_bytes log = {NULL, 0};
    vbss_record *record;
    expect_ok(vbss_record_create(s->scene, NULL, &record));
    expect_ok(vbss_scene_set_recorder(s->scene, record));
    for (uint32_t i = 0; i < steps; i++) {
        expect_ok(tool_scene_drive(s->scene));
        expect_ok(vbss_scene_step(s->scene, 1e-3));
        if (i % 50 == 7) {
            log_take(&log, record);
        }
    }
    expect_ok(vbss_record_end(record));
    log_take(&log, record);
    expect_ok(vbss_record_destroy(record));
    return log;
}

static void expect_replayed(stage *recorded, const log_bytes *log, vbss_method method,
                            uint32_t steps)
{
    stage replayed;
    vbss_replay_report report;
    tools_make(&replayed, method);
    vbss_replay *replay = replay_of(&replayed, log);
    for (int life = 0; life < 2; life++) {
        expect_ok(vbss_replay_begin(replay, replayed.scene));
        for (uint32_t i = 1; i <= steps; i++) {
            expect_ok(vbss_replay_step(replay, &report, sizeof report));
            assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_STEPPED);
            assert_int_equal(report.agreed_step, i);
            assert_true(report.recorded_hash == stage_hash(&replayed));
        }
        expect_ok(vbss_replay_step(replay, &report, sizeof report));
        assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_ENDED);
        assert_true(stage_hash(&replayed) == stage_hash(recorded));
    }
    stage_end(&replayed);
}

/* A whole round: taken, drawn, taken by the other, slid, let go, exchanged. */
static void grasper_session_replays_bit_equal(void **state)
{
    (void)state;
    stage recorded, plain;
    tools_make(&recorded, VBSS_METHOD_IMPLICIT);
    tools_make(&plain, VBSS_METHOD_IMPLICIT);
    log_bytes log = record_tools(&recorded, TOOL_SCENE_ROUND);
    for (uint32_t i = 0; i < TOOL_SCENE_ROUND; i++) {
        expect_ok(tool_scene_step(plain.scene));
    }
    assert_true(stage_hash(&plain) == stage_hash(&recorded)); /* recording changes nothing */
    stage_end(&plain);
    expect_replayed(&recorded, &log, VBSS_METHOD_IMPLICIT, TOOL_SCENE_ROUND);
    stage_end(&recorded);
    log_free(&log);
}

static void session_starting_with_held_thread_replays_bit_equal(void **state)
{
    (void)state;
    stage recorded;
    tools_make(&recorded, VBSS_METHOD_IMPLICIT);
    for (uint32_t i = 0; i < TOOL_SCENE_SLIDING; i++) {
        expect_ok(tool_scene_step(recorded.scene));
    }
    log_bytes log = record_tools(&recorded, 200);
    expect_replayed(&recorded, &log, VBSS_METHOD_IMPLICIT, 200);
    stage_end(&recorded);
    log_free(&log);
}

static void paper_session_replays_bit_equal(void **state)
{
    (void)state;
    stage recorded;
    tools_make(&recorded, VBSS_METHOD_VBLAST);
    log_bytes log = record_tools(&recorded, 200);
    expect_replayed(&recorded, &log, VBSS_METHOD_VBLAST, 200);
    stage_end(&recorded);
    log_free(&log);
}

/* The room that the header promises for a step of two graspers. */
static void step_takes_documented_space(void **state)
{
    (void)state;
    stage s;
    vbss_record *record;
    log_bytes log = {NULL, 0};
    const double tip[3] = {0.0, 0.0, 0.05}, turned[4] = {1.0, 0.0, 0.0, 0.0};
    tools_make(&s, VBSS_METHOD_IMPLICIT);
    expect_ok(vbss_record_create(s.scene, NULL, &record));
    log_take(&log, record);
    size_t before = log.count;
    expect_ok(vbss_scene_set_recorder(s.scene, record));
    for (uint32_t body = 2; body <= 3; body++) {
        vbss_grasper *tool;
        expect_ok(vbss_scene_get_grasper(s.scene, body, &tool));
        expect_ok(vbss_grasper_set_target(tool, tip, turned));
        expect_ok(vbss_grasper_set_opening(tool, 0.5));
    }
    expect_ok(vbss_scene_step(s.scene, 1e-3));
    log_take(&log, record);
    assert_true(log.count - before <= 332);
    expect_ok(vbss_record_destroy(record));
    stage_end(&s);
    log_free(&log);
}

/* ---- refused */

static void unrecorded_commands_are_detected(void **state)
{
    (void)state;
    for (int how = 0; how < 3; how++) {
        stage s;
        vbss_record *record;
        vbss_grasper *tool;
        const double tip[3] = {0.0, 0.0, 0.05};
        tools_make(&s, VBSS_METHOD_IMPLICIT);
        expect_ok(vbss_record_create(s.scene, NULL, &record));
        expect_ok(vbss_scene_set_recorder(s.scene, record));
        expect_ok(vbss_scene_step(s.scene, 1e-3));
        expect_ok(vbss_scene_set_recorder(s.scene, NULL));
        expect_ok(vbss_scene_get_grasper(s.scene, 2, &tool));
        expect_ok(how == 0   ? vbss_grasper_set_target(tool, tip, NULL)
                  : how == 1 ? vbss_grasper_set_opening(tool, 0.5)
                             : vbss_grasper_exchange(tool, VBSS_GRASPER_KIND_SHEARS));
        expect_result(VBSS_ERROR_WRONG_STATE, vbss_scene_set_recorder(s.scene, record));
        expect_ok(vbss_record_destroy(record));
        stage_end(&s);
    }
}

/* And leaves the record as it was. */
static void rejected_commands_are_not_recorded(void **state)
{
    (void)state;
    stage s;
    vbss_record *record;
    vbss_grasper *tool;
    vbss_replay_logged_step step;
    log_bytes log = {NULL, 0};
    const double tip[3] = {0.0, 0.0, 0.05}, far[3] = {1e4, 0.0, 0.0}, none[4] = {0.0};
    const double odd[3] = {harness_bad_numbers[0], 0.0, 0.0};
    tools_make(&s, VBSS_METHOD_IMPLICIT);
    expect_ok(vbss_record_create(s.scene, NULL, &record));
    uint64_t hash = stage_hash(&s);
    expect_ok(vbss_scene_set_recorder(s.scene, record));
    expect_ok(vbss_scene_get_grasper(s.scene, 2, &tool));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_grasper_set_target(tool, NULL, NULL));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_grasper_set_target(tool, far, NULL));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_grasper_set_target(tool, tip, none));
    expect_result(VBSS_ERROR_NOT_FINITE, vbss_grasper_set_target(tool, odd, NULL));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_grasper_set_opening(tool, 1.5));
    expect_result(VBSS_ERROR_NOT_FINITE, vbss_grasper_set_opening(tool, harness_bad_numbers[1]));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_grasper_exchange(tool, 3));
    vbss_record_input input = {.kind = VBSS_RECORD_INPUT_GRASPER_TARGET, .words = {9}};
    expect_result(VBSS_ERROR_NOT_FOUND, vbss_record_apply_input(record, &input, NULL));
    input.words[0] = 1;
    expect_result(VBSS_ERROR_INCOMPATIBLE, vbss_record_apply_input(record, &input, NULL));
    assert_true(stage_hash(&s) == hash);
    expect_ok(vbss_scene_step(s.scene, 1e-3));
    log_take(&log, record);
    vbss_replay *replay = replay_of(&s, &log);
    expect_ok(vbss_replay_read(replay, 1, &step, sizeof step));
    assert_int_equal(step.input_count, 0);
    stage_end(&s);
    log_free(&log);
}

int test_graspers(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(grasper_session_replays_bit_equal),
        cmocka_unit_test(session_starting_with_held_thread_replays_bit_equal),
        cmocka_unit_test(paper_session_replays_bit_equal),
        cmocka_unit_test(step_takes_documented_space),
        cmocka_unit_test(unrecorded_commands_are_detected),
        cmocka_unit_test(rejected_commands_are_not_recorded),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
