/* A replay goes to any step by way of snapshots, and on from there to the same bits. */
#include "damage.h"

enum { LENGTH = 60, INTERVAL = 16 };

typedef struct sought {
    stage s;
    log_bytes log;
    vbss_replay *replay;
    uint64_t hashes[LENGTH + 1];
} sought;

static log_bytes log_with_snapshots(stage *s, uint32_t interval, uint32_t steps)
{
    vbss_record_config config;
    expect_ok(vbss_record_config_init(&config, sizeof config));
    config.snapshot_interval = interval;
    return log_of(s, &config, steps);
}

static void sought_begin(sought *p, uint32_t interval)
{
    stage plain;
    stage_begin(&plain, NULL);
    stage_begin(&p->s, NULL);
    p->hashes[0] = stage_hash(&plain);
    for (uint32_t i = 1; i <= LENGTH; i++) {
        stage_step(&plain, NULL);
        p->hashes[i] = stage_hash(&plain);
    }
    stage_end(&plain);
    stage_begin(&plain, NULL);
    p->log = log_with_snapshots(&plain, interval, LENGTH);
    stage_end(&plain);
    p->replay = replay_of(&p->s, &p->log);
    expect_ok(vbss_replay_begin(p->replay, p->s.scene));
}

/* Its numbers stand at fixed places. */
static void sought_in_format_2(sought *p)
{
    expect_ok(vbss_replay_destroy(p->replay));
    log_to_format_2(&p->log);
    p->replay = replay_of(&p->s, &p->log);
    expect_ok(vbss_replay_begin(p->replay, p->s.scene));
}

static void sought_end(sought *p)
{
    stage_end(&p->s);
    log_free(&p->log);
}

static uint32_t count_of(const log_bytes *log, uint32_t code)
{
    uint32_t count = 0;
    log_place place = {.next = 0};
    while (log_next_place(log, &place)) {
        count += place.code == code;
    }
    return count;
}

static vbss_replay_report seek(sought *p, uint64_t step)
{
    vbss_replay_report report;
    expect_ok(vbss_replay_seek(p->replay, step, &report, sizeof report));
    assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_STEPPED);
    assert_int_equal(report.step, step);
    assert_int_equal(report.agreed_step, step);
    assert_true(stage_hash(&p->s) == p->hashes[step]);
    return report;
}

static void snapshots_follow_their_steps(void **state)
{
    (void)state;
    sought p;
    sought_begin(&p, INTERVAL);
    assert_int_equal(count_of(&p.log, SNAP), 1 + LENGTH / INTERVAL);
    for (uint32_t i = 1; i <= LENGTH / INTERVAL; i++) {
        assert_int_equal(log_find(&p.log, SNAP, 1 + i).at,
                         log_find(&p.log, STEP, i * INTERVAL).next);
    }
    sought_end(&p);
    sought_begin(&p, 0);
    assert_int_equal(count_of(&p.log, SNAP), 1);
    sought_end(&p);
}

static void every_step_is_reachable_from_every_other(void **state)
{
    (void)state;
    const uint64_t steps[] = {0, 1, 15, 16, 17, 31, 33, 48, 59, 60};
    const uint32_t intervals[] = {INTERVAL, 1, 0};
    for (size_t k = 0; k < sizeof intervals / sizeof intervals[0]; k++) {
        sought p;
        sought_begin(&p, intervals[k]);
        for (size_t i = 0; i < 10; i++) {
            for (size_t j = 0; j < 10; j++) {
                (void)seek(&p, steps[i]);
                (void)seek(&p, steps[j]);
            }
        }
        sought_end(&p);
    }
}

static void replay_continues_after_seek(void **state)
{
    (void)state;
    sought p;
    vbss_replay_report report;
    sought_begin(&p, INTERVAL);
    for (uint64_t from = 0; from <= LENGTH; from += 7) {
        (void)seek(&p, from);
        for (uint64_t i = from + 1; i <= LENGTH; i++) {
            expect_ok(vbss_replay_step(p.replay, &report, sizeof report));
            assert_int_equal(report.agreed_step, i);
            assert_true(stage_hash(&p.s) == p.hashes[i]);
        }
        expect_ok(vbss_replay_step(p.replay, &report, sizeof report));
        assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_ENDED);
        assert_int_equal(report.position, p.log.count);
    }
    sought_end(&p);
}

/* So that it was the snapshot which brought it there: what lies before is not replayed. */
static void seek_replays_only_from_last_snapshot(void **state)
{
    (void)state;
    sought p;
    vbss_scene_statistics statistics;
    sought_begin(&p, INTERVAL);
    sought_in_format_2(&p);
    uint8_t *h = p.log.bytes + log_find(&p.log, STEP, 20).at + 8 + 8 + 32 + 8;
    h[0] ^= 0xff; /* another length of step 20 */
    log_seal(&p.log);
    (void)seek(&p, 19);
    vbss_replay_report report;
    expect_ok(vbss_replay_seek(p.replay, 20, &report, sizeof report));
    assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_DIFFERS);
    assert_int_equal(report.agreed_step, 19);
    (void)seek(&p, 32);
    (void)seek(&p, 47);
    expect_ok(vbss_scene_get_statistics(p.s.scene, &statistics, sizeof statistics));
    assert_int_equal(statistics.steps, 47);
    sought_end(&p);
}

static void missing_step_is_rejected_and_nothing_moves(void **state)
{
    (void)state;
    sought p;
    vbss_replay_report report;
    sought_begin(&p, INTERVAL);
    (void)seek(&p, 21);
    expect_result(VBSS_ERROR_NOT_FOUND,
                  vbss_replay_seek(p.replay, LENGTH + 1, &report, sizeof report));
    assert_int_equal(report.step, 21);
    assert_true(stage_hash(&p.s) == p.hashes[21]);
    p.log.bytes[log_find(&p.log, STEP, 30).at + 40] ^= 1;
    expect_result(VBSS_ERROR_CORRUPT, vbss_replay_seek(p.replay, 40, &report, sizeof report));
    assert_int_equal(report.step, 21);
    assert_true(stage_hash(&p.s) == p.hashes[21]);
    (void)seek(&p, 29); /* what comes before the damage */
    expect_result(VBSS_ERROR_CORRUPT, vbss_replay_step(p.replay, &report, sizeof report));
    (void)seek(&p, 22); /* and it can be left again */
    vbss_replay *fresh = replay_of(&p.s, &p.log);
    expect_result(VBSS_ERROR_WRONG_STATE, vbss_replay_seek(fresh, 1, &report, sizeof report));
    assert_non_null(strstr(last_text(p.s.context), "not begun"));
    sought_end(&p);
}

/* A snapshot that says something else than the steps before it. */
static void mismatching_snapshot_is_detected(void **state)
{
    (void)state;
    sought p;
    vbss_replay_report report;
    sought_begin(&p, INTERVAL);
    sought_in_format_2(&p);
    const log_place second = log_find(&p.log, SNAP, 3);
    log_place first = log_find(&p.log, SNAP, 2);
    enum { INSIDE = 8 + 8 + 16 + 12 + 8 };
    for (uint32_t k = 4; k < 8 && first.next - first.at != second.next - second.at; k++) {
        first = log_find(&p.log, SNAP, k); /* another state with as many bytes */
    }
    assert_int_equal(first.next - first.at, second.next - second.at);
    memcpy(p.log.bytes + second.at + INSIDE, p.log.bytes + first.at + INSIDE,
           first.next - first.at - INSIDE - 8 - 8);
    log_seal(&p.log);
    expect_ok(vbss_replay_seek(p.replay, 40, &report, sizeof report));
    assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_DIFFERS);
    assert_int_equal(report.step, 32);
    (void)seek(&p, 31); /* by the one before */
    sought_end(&p);
}

static void snapshot_without_space_is_deferred(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_scene *scene; /* whose steps take far less room than its snapshots */
    vbss_record *record;
    vbss_record_config config;
    uint64_t hashes[LENGTH + 1];
    log_bytes log = {NULL, 0};
    expect_ok(vbss_record_config_init(&config, sizeof config));
    config.snapshot_interval = 1; /* each, of which only few can wait to be taken */
    config.buffer_bytes = 4300;   /* at the end there is room for steps, but for no snapshot */
    expect_ok(empty_scene(context, &scene));
    expect_ok(vbss_record_create(scene, &config, &record));
    expect_ok(vbss_scene_set_recorder(scene, record));
    expect_ok(vbss_scene_get_hash(scene, &hashes[0]));
    for (uint32_t i = 1; i <= LENGTH; i++) {
        vbss_result result = vbss_scene_step(scene, 1e-3);
        if (result != VBSS_OK) {
            expect_result(VBSS_ERROR_CAPACITY, result);
            log_take(&log, record);
            expect_ok(vbss_scene_step(scene, 1e-3));
        }
        expect_ok(vbss_scene_get_hash(scene, &hashes[i]));
    }
    expect_ok(vbss_record_end(record));
    log_take(&log, record);
    uint32_t count = count_of(&log, SNAP);
    assert_true(count > 3 && count < LENGTH);
    vbss_replay *replay;
    vbss_replay_report report;
    expect_ok(vbss_replay_create(context, log.bytes, log.count, &replay));
    expect_ok(vbss_replay_begin(replay, scene));
    for (uint64_t i = LENGTH + 1; i-- > 0;) {
        uint64_t hash;
        expect_ok(vbss_replay_seek(replay, i, &report, sizeof report));
        assert_int_equal(report.agreed_step, i);
        expect_ok(vbss_scene_get_hash(scene, &hash));
        assert_true(hash == hashes[i]);
    }
    harness_context_end(context, &memory);
    log_free(&log);
}

int test_seek(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(snapshots_follow_their_steps),
        cmocka_unit_test(every_step_is_reachable_from_every_other),
        cmocka_unit_test(replay_continues_after_seek),
        cmocka_unit_test(seek_replays_only_from_last_snapshot),
        cmocka_unit_test(missing_step_is_rejected_and_nothing_moves),
        cmocka_unit_test(mismatching_snapshot_is_detected),
        cmocka_unit_test(snapshot_without_space_is_deferred),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
