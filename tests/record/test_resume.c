/* A scene goes on from a log, complete or cut off, and the whole log then replays. */
#include "base/little_endian.h"
#include "damage.h"

enum { FIRST = 25, SECOND = 20 };

static vbss_record_config config_of(uint32_t snapshot_interval)
{
    vbss_record_config config;
    expect_ok(vbss_record_config_init(&config, sizeof config));
    config.snapshot_interval = snapshot_interval;
    return config;
}

/* What the host's hands know of a scene after that many steps. */
static void know(stage *s, uint32_t steps)
{
    stage other;
    stage_begin(&other, NULL);
    while (other.step < steps) {
        stage_step(&other, NULL);
    }
    s->force = other.force;
    s->clamp = other.clamp;
    s->pin = other.pin;
    s->step = steps;
    stage_end(&other);
}

/* Goes on with a log to `until`, in a fresh context; the log then has all of it. */
static void resume(log_bytes *log, const vbss_record_config *config, uint32_t steps, uint32_t until)
{
    stage s;
    vbss_record *record;
    uint64_t position;
    stage_begin(&s, NULL);
    vbss_replay *replay = replay_of(&s, log);
    expect_ok(vbss_replay_begin(replay, s.scene));
    expect_ok(vbss_record_resume(replay, config, &record, &position));
    expect_ok(vbss_replay_destroy(replay)); /* it and the bytes are not needed any longer */
    assert_true(position <= log->count);
    log->count = (size_t)position;
    know(&s, steps);
    while (s.step < until) {
        stage_step(&s, record);
        log_take(log, record);
    }
    expect_ok(vbss_record_end(record));
    log_take(log, record);
    stage_end(&s);
}

/* The log leads to where a scene comes that was never interrupted. */
static void expect_whole(const log_bytes *log, uint32_t steps)
{
    stage plain, s;
    vbss_replay_report report;
    vbss_record_log_report found;
    stage_begin(&plain, NULL);
    stage_begin(&s, NULL);
    while (plain.step < steps) {
        stage_step(&plain, NULL);
    }
    vbss_replay *replay = replay_of(&s, log);
    expect_ok(vbss_replay_begin(replay, s.scene));
    expect_ok(replay_all(replay, &report));
    assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_ENDED);
    assert_int_equal(report.agreed_step, steps);
    assert_true(stage_hash(&s) == stage_hash(&plain));
    expect_ok(vbss_record_check_log(s.context, log->bytes, log->count, &found, sizeof found));
    expect_ok(found.result);
    assert_int_equal(found.steps, steps);
    stage_end(&s);
    stage_end(&plain);
}

static log_bytes first_part(uint32_t steps)
{
    stage s;
    const vbss_record_config config = config_of(8);
    stage_begin(&s, NULL);
    log_bytes log = log_of(&s, &config, steps);
    stage_end(&s);
    return log;
}

static void finished_log_can_be_resumed(void **state)
{
    (void)state;
    const vbss_record_config config = config_of(6);
    log_bytes log = first_part(FIRST);
    const size_t kept = log_find(&log, ENDS, 1).at;
    log_bytes before = log_copy(&log);
    resume(&log, NULL, FIRST, FIRST + SECOND);
    assert_memory_equal(log.bytes, before.bytes, kept); /* nothing was written over */
    expect_whole(&log, FIRST + SECOND);
    resume(&log, &config, FIRST + SECOND, FIRST + 2 * SECOND); /* and once more */
    expect_whole(&log, FIRST + 2 * SECOND);
    log_free(&before);
    log_free(&log);
}

static void truncated_log_can_be_resumed_at_any_cut(void **state)
{
    (void)state;
    log_bytes log = first_part(12);
    const log_place begin = log_find(&log, SNAP, 1), eight = log_find(&log, SNAP, 2);
    size_t cuts[24];
    uint32_t count = 0;
    for (uint32_t step = 1; step <= 12; step += 4) { /* in, before and behind a step */
        log_place place = log_find(&log, STEP, step);
        cuts[count++] = place.at;
        cuts[count++] = place.at + 3;
        cuts[count++] = place.next - 1;
        cuts[count++] = place.next;
    }
    cuts[count++] = begin.next;
    cuts[count++] = eight.at + 5;
    cuts[count++] = eight.next;
    cuts[count++] = log.count - 1;
    for (uint32_t i = 0; i < count; i++) {
        log_bytes cut = log_copy(&log);
        log_place place = {.next = 0};
        uint32_t complete = 0;
        while (log_next_place(&log, &place) && place.next <= cuts[i]) {
            complete += place.code == STEP;
        }
        cut.count = cuts[i];
        resume(&cut, NULL, complete, 16);
        expect_whole(&cut, 16);
        log_free(&cut);
    }
    log_free(&log);
}

/* ---- refused */

static void expect_refused(const log_bytes *log, const stage_options *options, vbss_result wanted,
                           const char *text)
{
    stage s;
    vbss_record *record = (vbss_record *)&s;
    uint64_t position;
    stage_begin(&s, options);
    vbss_replay *replay = replay_of(&s, log);
    expect_ok(vbss_replay_begin(replay, s.scene));
    expect_result(wanted, vbss_record_resume(replay, NULL, &record, &position));
    assert_null(record);
    assert_non_null(strstr(last_text(s.context), text));
    stage_end(&s);
}

static void damaged_log_is_rejected_and_good_part_accepted(void **state)
{
    (void)state;
    log_bytes log = first_part(FIRST);
    log_bytes bad = log_copy(&log);
    const log_place place = log_find(&log, STEP, 20);
    vbss_record_log_report found;
    stage s;
    bad.bytes[place.at + 50] ^= 4;
    expect_refused(&bad, NULL, VBSS_ERROR_CORRUPT, "checksum");
    stage_begin(&s, NULL);
    expect_ok(vbss_record_check_log(s.context, bad.bytes, bad.count, &found, sizeof found));
    assert_int_equal(found.good_bytes, place.at);
    stage_end(&s);
    bad.count = (size_t)found.good_bytes;
    resume(&bad, NULL, 19, 30);
    expect_whole(&bad, 30);
    log_free(&bad);
    log_free(&log);
}

static void log_of_other_build_is_rejected(void **state)
{
    (void)state;
    log_bytes log = first_part(FIRST);
    log_to_format_2(&log);
    log_bytes other = log_copy(&log);
    other.bytes[log_find(&log, STEP, 25).at + 8 + 8 + 32 + 8] ^= 0xff; /* its length */
    log_seal(&other);
    expect_refused(&other, NULL, VBSS_ERROR_CORRUPT, "after step 25");
    memcpy(other.bytes, log.bytes, log.count);
    other.bytes[log_find(&log, HEAD, 1).at + 8 + 8 + 8] ^= 1;
    log_seal(&other);
    expect_refused(&other, NULL, VBSS_ERROR_DATA_VERSION, "library version");
    memcpy(other.bytes, log.bytes, log.count);
    store_little_endian(damage_config_word(&other, 9), 200,
                        4); /* events of a step, in the scene 256 */
    log_seal(&other);
    expect_refused(&other, NULL, VBSS_ERROR_CAPACITY, "events");
    log_free(&other);
    log_free(&log);
}

static void bad_resume_arguments_are_rejected(void **state)
{
    (void)state;
    stage s;
    vbss_record *record;
    vbss_record_config config = config_of(5);
    uint64_t position;
    stage_begin(&s, NULL);
    log_bytes log = first_part(3);
    vbss_replay *replay = replay_of(&s, &log);
    expect_result(VBSS_ERROR_WRONG_STATE, vbss_record_resume(replay, NULL, &record, &position));
    assert_non_null(strstr(last_text(s.context), "not begun"));
    expect_ok(vbss_replay_begin(replay, s.scene));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_record_resume(replay, NULL, NULL, &position));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_record_resume(replay, NULL, &record, NULL));
    config.buffer_bytes = 1;
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_record_resume(replay, &config, &record, &position));
    assert_null(record);
    /* The scene of a record is not to be changed past it, by its replay neither. */
    vbss_replay_report report;
    expect_ok(vbss_record_resume(replay, NULL, &record, &position));
    expect_ok(vbss_replay_seek(replay, 1, &report, sizeof report));
    expect_result(VBSS_ERROR_WRONG_STATE, vbss_scene_set_recorder(s.scene, record));
    stage_end(&s);
    log_free(&log);
}

int test_resume(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(finished_log_can_be_resumed),
        cmocka_unit_test(truncated_log_can_be_resumed_at_any_cut),
        cmocka_unit_test(damaged_log_is_rejected_and_good_part_accepted),
        cmocka_unit_test(log_of_other_build_is_rejected),
        cmocka_unit_test(bad_resume_arguments_are_rejected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
