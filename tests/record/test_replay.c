/* A recorded scene is replayed to the bit, and what differs is named where it does. */
#include <stddef.h>

#include "base/little_endian.h"
#include "fixture.h"

enum { STEPS = 240 };
#define STEP VBSS_CODE('S', 'T', 'E', 'P')

static void scene_replays_bit_equal_in_fresh_context(void **state)
{
    (void)state;
    stage recorded, plain, replayed;
    vbss_replay_report report;
    stage_begin(&recorded, NULL);
    stage_begin(&plain, NULL);
    log_bytes log = log_of(&recorded, NULL, STEPS);
    for (uint32_t i = 0; i < STEPS; i++) {
        stage_step(&plain, NULL);
    }
    assert_true(stage_hash(&plain) == stage_hash(&recorded)); /* recording changes nothing */
    vbss_scene_statistics statistics; /* a scene in which little happens would test little */
    expect_ok(vbss_scene_get_statistics(plain.scene, &statistics, sizeof statistics));
    assert_true(statistics.contacts > 0 && statistics.parts > STEPS && statistics.clamped < 10);
    stage_end(&plain);

    stage_begin(&replayed, NULL);
    vbss_replay *replay = replay_of(&replayed, &log);
    for (int life = 0; life < 2; life++) { /* and once more */
        expect_ok(vbss_replay_begin(replay, replayed.scene));
        for (uint32_t i = 1; i <= STEPS; i++) {
            expect_ok(vbss_replay_step(replay, &report, sizeof report));
            assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_STEPPED);
            assert_int_equal(report.step, i);
            assert_int_equal(report.agreed_step, i);
            assert_true(report.recorded_hash == stage_hash(&replayed));
        }
        for (int again = 0; again < 2; again++) {
            expect_ok(vbss_replay_step(replay, &report, sizeof report));
            assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_ENDED);
            assert_int_equal(report.step, STEPS);
            assert_int_equal(report.position, log.count);
        }
        assert_true(stage_hash(&replayed) == stage_hash(&recorded));
    }
    stage_end(&replayed);
    stage_end(&recorded);
    log_free(&log);
}

static void paper_scene_replays_bit_equal(void **state)
{
    (void)state;
    stage recorded, replayed;
    vbss_replay_report report;
    stage_options options = stage_defaults();
    options.method = VBSS_METHOD_VBLAST;
    stage_begin(&recorded, &options);
    stage_begin(&replayed, &options);
    for (uint32_t i = 0; i < 13; i++) {
        stage_step(&recorded, NULL);
    }
    log_bytes log = log_of(&recorded, NULL, 100);
    vbss_replay *replay = replay_of(&replayed, &log);
    expect_ok(vbss_replay_begin(replay, replayed.scene));
    expect_ok(replay_all(replay, &report));
    assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_ENDED);
    assert_int_equal(report.agreed_step, 100);
    assert_true(stage_hash(&replayed) == stage_hash(&recorded));
    stage_end(&replayed);
    stage_end(&recorded);
    log_free(&log);
}

/* A log may begin anywhere in a scene's life, and be replayed in a scene that has lived otherwise. */
static void log_may_start_mid_life(void **state)
{
    (void)state;
    stage recorded, replayed;
    vbss_replay_report report;
    stage_begin(&recorded, NULL);
    stage_begin(&replayed, NULL);
    for (uint32_t i = 0; i < 57; i++) {
        stage_step(&recorded, NULL);
    }
    for (uint32_t i = 0; i < 23; i++) {
        stage_step(&replayed, NULL);
    }
    log_bytes log = log_of(&recorded, NULL, 120);
    vbss_replay *replay = replay_of(&replayed, &log);
    expect_ok(vbss_replay_begin(replay, replayed.scene));
    expect_ok(replay_all(replay, &report));
    assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_ENDED);
    assert_int_equal(report.agreed_step, 120);
    assert_true(stage_hash(&replayed) == stage_hash(&recorded));
    stage_end(&replayed);
    stage_end(&recorded);
    log_free(&log);
}

/* Replays `log`, which differs first after step `after`. */
static void expect_difference(const log_bytes *log, uint64_t after, uint64_t agreed)
{
    stage s;
    vbss_replay_report report, again;
    stage_begin(&s, NULL);
    vbss_replay *replay = replay_of(&s, log);
    expect_ok(vbss_replay_begin(replay, s.scene));
    expect_ok(replay_all(replay, &report));
    assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_DIFFERS);
    assert_int_equal(report.step, after);
    assert_int_equal(report.agreed_step, agreed);
    assert_true(report.found_hash == stage_hash(&s));
    assert_true(report.recorded_hash != report.found_hash && report.recorded_hash != 0);
    expect_ok(vbss_replay_step(replay, &again, sizeof again)); /* it stays there */
    assert_memory_equal(&again, &report, sizeof report);
    stage_end(&s);
}

/* The first number of the first input of a step of a log in format 2: where the first tool shall be. */
static uint8_t *first_number(const log_bytes *log, uint32_t step)
{
    /* the record's length, its section; number and hash, h, count of inputs */
    uint8_t *count = log->bytes + log_find(log, STEP, step).at + 8 + 8 + (8 + 24) + (8 + 8) + 8;
    size_t inputs = (size_t)load_little_endian(count, 4);
    return count + 4 + (8 + inputs) + (8 + 8) + 8; /* kinds, words */
}

static void changed_input_is_located_by_step(void **state)
{
    (void)state;
    stage recorded;
    stage_begin(&recorded, NULL);
    log_bytes log = log_of(&recorded, NULL, 60);
    log_to_format_2(&log);
    for (uint32_t step = 1; step <= 60; step += 29) {
        log_bytes changed = log_copy(&log);
        log_place place = log_find(&log, STEP, step);
        *first_number(&changed, step) ^= 1; /* the last place of a coordinate */
        stage s;
        vbss_replay_report report;
        stage_begin(&s, NULL);
        vbss_replay *replay = replay_of(&s, &changed);
        expect_ok(vbss_replay_begin(replay, s.scene));
        expect_result(VBSS_ERROR_CORRUPT, replay_all(replay, &report));
        assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_STOPPED);
        assert_int_equal(report.step, step - 1);
        assert_int_equal(report.position, place.at);
        stage_end(&s);
        log_seal(&changed); /* now only the scene can tell */
        expect_difference(&changed, step, step - 1);
        log_free(&changed);
    }
    stage_end(&recorded);
    log_free(&log);
}

static void hash_interval_locates_difference(void **state)
{
    (void)state;
    vbss_record_config config;
    stage recorded;
    expect_ok(vbss_record_config_init(&config, sizeof config));
    config.hash_interval =
        10; /* and changes of 0.3 nm: those of a last place may be gone by then */
    stage_begin(&recorded, NULL);
    log_bytes log = log_of(&recorded, &config, 57);
    log_to_format_2(&log);
    log_bytes changed = log_copy(&log);
    first_number(&changed, 30)[3] ^= 1;
    log_seal(&changed);
    expect_difference(&changed, 30, 20);
    memcpy(changed.bytes, log.bytes, log.count);
    first_number(&changed, 46)[3] ^= 1;
    log_seal(&changed);
    expect_difference(&changed, 50, 40);
    memcpy(changed.bytes, log.bytes, log.count);
    first_number(&changed, 53)[3] ^= 1;
    log_seal(&changed);
    expect_difference(&changed, 57, 50); /* the end has a hash of its own */
    log_free(&changed);
    log_free(&log);
    stage_end(&recorded);
}

/* ---- another scene */

static vbss_result begin_in(const log_bytes *log, const stage_options *options, const char *named)
{
    stage s;
    stage_begin(&s, options);
    vbss_replay *replay = replay_of(&s, log);
    uint64_t hash = stage_hash(&s);
    vbss_result result = vbss_replay_begin(replay, s.scene);
    if (result != VBSS_OK) {
        vbss_replay_report report;
        assert_non_null(strstr(last_text(s.context), named));
        assert_true(stage_hash(&s) == hash);
        expect_result(VBSS_ERROR_WRONG_STATE, vbss_replay_step(replay, &report, sizeof report));
    }
    stage_end(&s);
    return result;
}

static void other_scene_is_rejected_with_difference(void **state)
{
    (void)state;
    stage recorded;
    stage_begin(&recorded, NULL);
    log_bytes log = log_of(&recorded, NULL, 3);
    stage_options options = stage_defaults();
    options.contact_capacity = 300; /* only room */
    expect_ok(begin_in(&log, &options, ""));
    options.thread_friction = 0.3000000001;
    expect_result(VBSS_ERROR_CORRUPT, begin_in(&log, &options, "thread_friction"));
    options = stage_defaults();
    options.tool_friction = 0.1501;
    expect_result(VBSS_ERROR_CORRUPT, begin_in(&log, &options, "another configuration"));
    options = stage_defaults();
    options.bending_stiffness = 1.0001e-8;
    expect_result(VBSS_ERROR_CORRUPT, begin_in(&log, &options, "another configuration"));
    stage_end(&recorded);
    log_free(&log);
}

/* A scene with less room than the recorded one fails where that matters, and is told. */
static void failing_step_stops_replay(void **state)
{
    (void)state;
    stage recorded, s;
    vbss_replay_report report;
    stage_options options = stage_defaults();
    stage_begin(&recorded, NULL);
    log_bytes log = log_of(&recorded, NULL, 150);
    options.contact_capacity = 1;
    stage_begin(&s, &options);
    vbss_replay *replay = replay_of(&s, &log);
    expect_ok(vbss_replay_begin(replay, s.scene));
    expect_result(VBSS_ERROR_CAPACITY, replay_all(replay, &report));
    assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_STOPPED);
    assert_true(report.step < 150 && report.step == report.agreed_step);
    expect_result(VBSS_ERROR_CAPACITY, vbss_replay_step(replay, &report, sizeof report));
    stage_end(&s);
    stage_end(&recorded);
    log_free(&log);
}

/* ---- what a log says about itself */

static void log_reports_its_origin(void **state)
{
    (void)state;
    const char note[] = "scene=rubbing seed=7";
    vbss_record_config config;
    vbss_scene_config scene;
    vbss_replay_info info;
    stage recorded;
    uint64_t steps;
    stage_options options = stage_defaults();
    options.thread_friction = 0.27;
    expect_ok(vbss_record_config_init(&config, sizeof config));
    config.note = note;
    config.note_bytes = sizeof note;
    config.hash_interval = 3;
    stage_begin(&recorded, &options);
    uint64_t begin_bytes;
    expect_result(VBSS_ERROR_CAPACITY, vbss_scene_save(recorded.scene, NULL, 0, &begin_bytes));
    log_bytes log = log_of(&recorded, &config, 12);
    vbss_replay *replay = replay_of(&recorded, &log);
    expect_ok(vbss_replay_get_info(replay, &info, sizeof info));
    assert_int_equal(info.library_version, vbss_version());
    assert_string_equal(info.build_info, vbss_build_info());
    assert_int_equal(info.note_bytes, sizeof note);
    assert_string_equal(info.note, note);
    assert_int_equal(info.hash_interval, 3);
    assert_int_equal(info.log_bytes, log.count);
    assert_int_equal(info.snapshot_bytes, begin_bytes);
    expect_ok(vbss_scene_config_init(&scene, sizeof scene));
    expect_ok(vbss_replay_get_scene_config(replay, &scene));
    expect_same_bits(0.27, scene.thread_friction);
    assert_int_equal(scene.floor, 1);
    assert_int_equal(scene.candidate_capacity, 1024);
    vbss_scene *made;
    expect_ok(vbss_scene_create(recorded.context, &scene, &made));
    vbss_replay_report report; /* wherever the replay is, all of the log is read */
    expect_ok(vbss_replay_begin(replay, recorded.scene));
    expect_ok(vbss_replay_step(replay, &report, sizeof report));
    expect_ok(vbss_replay_check(replay, &steps));
    assert_int_equal(steps, 12);
    expect_ok(replay_all(replay, &report));
    assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_ENDED);
    stage_end(&recorded);
    log_free(&log);
}

int test_replay(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(scene_replays_bit_equal_in_fresh_context),
        cmocka_unit_test(paper_scene_replays_bit_equal),
        cmocka_unit_test(log_may_start_mid_life),
        cmocka_unit_test(changed_input_is_located_by_step),
        cmocka_unit_test(hash_interval_locates_difference),
        cmocka_unit_test(other_scene_is_rejected_with_difference),
        cmocka_unit_test(failing_step_stops_replay),
        cmocka_unit_test(log_reports_its_origin),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
