/* Changes of a running scene in a log: a replay repeats them to the bit. */
#include "record/recorder.h"

#include <vblast_ss/scene_query.h>
#include <vblast_ss/scene_settings.h>

static void change(stage *s, vbss_record *record, uint32_t which)
{
    const vbss_record_input inputs[] = {
        {.words = {VBSS_SCENE_SETTING_GRAVITY}, .numbers = {0.5, -3.0, 0.25}},
        {.words = {VBSS_SCENE_SETTING_FRICTION, s->ball}, .numbers = {0.7}},
        {.words = {VBSS_SCENE_SETTING_THREAD_FRICTION}, .numbers = {0.05}},
        {.words = {VBSS_SCENE_SETTING_COUPLING, s->ball}, .numbers = {900.0, 3.0, 1.0, 0.01}},
        {.words = {VBSS_SCENE_SETTING_SPEED_LIMIT}, .numbers = {7.0}},
        {.words = {VBSS_SCENE_SETTING_BUDGETS}, .numbers = {450.0, 380.0, 262.0}},
        {.words = {VBSS_SCENE_SETTING_FILTER, s->tools[1], 2u, 0xfffffff0u}},
        {.words = {VBSS_SCENE_SETTING_FORCE, s->ball, 1, 1},
         .numbers = {0.1, 0.2, 0.3, 0.01, 0.02, 0.0, 1e-4, 0.0, 0.0}},
    };
    vbss_record_input input = inputs[which % (sizeof inputs / sizeof inputs[0])];
    input.kind = VBSS_RECORD_INPUT_SETTING;
    expect_ok(vbss_record_apply_input(record, &input, NULL));
}

static void replay_repeats_changes_to_the_bit(void **state)
{
    (void)state;
    recorder r;
    vbss_record_config config;
    expect_ok(vbss_record_config_init(&config, sizeof config));
    config.hash_interval = 1;
    config.snapshot_interval = 5;
    recorder_begin(&r, &config);
    for (uint32_t i = 0; i < 16; i++) {
        change(&r.s, r.record, i);
        stage_step(&r.s, r.record);
    }
    expect_ok(vbss_record_end(r.record));
    recorder_end(&r, 16); /* which replays the log and compares every hash */
}

static void input_that_does_not_exist_is_refused(void **state)
{
    (void)state;
    recorder r;
    vbss_record_input input = {.kind = VBSS_RECORD_INPUT_SETTING, .words = {99}};
    recorder_begin(&r, NULL);
    const uint64_t before = stage_hash(&r.s);
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_record_apply_input(r.record, &input, NULL));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_record_apply_input(r.record, NULL, NULL));
    input.kind = 17;
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_record_apply_input(r.record, &input, NULL));
    input = (vbss_record_input){.kind = VBSS_RECORD_INPUT_SETTING,
                                .words = {VBSS_SCENE_SETTING_SPEED_LIMIT},
                                .numbers = {1.0, harness_bad_numbers[0]}};
    expect_result(VBSS_ERROR_NOT_FINITE, vbss_record_apply_input(r.record, &input, NULL));
    assert_true(stage_hash(&r.s) == before);
    stage_step(&r.s, r.record);
    expect_ok(vbss_record_end(r.record));
    recorder_end(&r, 1);
}

int test_settings_log(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(replay_repeats_changes_to_the_bit),
        cmocka_unit_test(input_that_does_not_exist_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
