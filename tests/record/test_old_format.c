/* format_2.vbss, which a library of format 2 wrote (revision 3991ab1), is still read, replayed and gone on with. */
#include <stdio.h>

#include "fixture.h"

enum { STEPS = 12, MORE = 10 };

typedef struct desk {
    harness_memory memory;
    vbss_context *context;
    vbss_scene *scene;
    uint32_t body;
    log_bytes log;
    vbss_replay *replay;
} desk;

static log_bytes read_file(const char *path)
{
    enum { ROOM = 1 << 14 };
    log_bytes log = {malloc(ROOM), 0};
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    assert_non_null(log.bytes);
    log.count = fread(log.bytes, 1, ROOM, file);
    assert_int_equal(fclose(file), 0);
    assert_true(log.count > 0 && log.count < ROOM);
    return log;
}

/* The scene of which the log is. */
static void desk_begin(desk *d)
{
    vbss_scene_rigid_config config;
    const vbss_scene_capsule capsule = {{0.0, 0.0, -0.01}, {0.0, 0.0, 0.01}, 2e-3};
    memset(d, 0, sizeof *d);
    d->context = harness_context(&d->memory);
    expect_ok(empty_scene(d->context, &d->scene));
    expect_ok(vbss_scene_rigid_config_init(&config, sizeof config));
    config.kind = VBSS_SCENE_RIGID_DRIVEN;
    config.capsules = &capsule;
    config.capsule_count = 1;
    expect_ok(vbss_scene_add_rigid(d->scene, &config, &d->body));
    d->log = read_file(VBSS_OLD_LOG);
    expect_ok(vbss_replay_create(d->context, d->log.bytes, d->log.count, &d->replay));
}

static void desk_end(desk *d)
{
    harness_context_end(d->context, &d->memory);
    log_free(&d->log);
}

static void position_at(uint32_t step, double at[3])
{
    at[0] = step / 1024.0;
    at[1] = 0.5 - step / 64.0;
    at[2] = step % 3 == 0 ? -0.0 : 0.25;
}

static void old_format_reads_bit_exact(void **state)
{
    (void)state;
    desk d;
    vbss_record_log_report report;
    desk_begin(&d);
    expect_ok(vbss_record_check_log(d.context, d.log.bytes, d.log.count, &report, sizeof report));
    expect_ok(report.result);
    assert_int_equal(report.steps, STEPS);
    assert_int_equal(report.inputs, STEPS);
    assert_int_equal(report.snapshots, 2);
    for (uint32_t i = 1; i <= STEPS; i++) {
        vbss_replay_logged_step step;
        double at[3];
        expect_ok(vbss_replay_read(d.replay, i, &step, sizeof step));
        position_at(i, at);
        expect_same_bits(i < 9 ? 0x1p-10 : 0x1p-9, step.h);
        assert_int_equal(step.hashed, i % 2 == 0);
        assert_int_equal(step.input_count, 1);
        assert_int_equal(step.inputs[0].kind, VBSS_RECORD_INPUT_RIGID_TARGET);
        assert_int_equal(step.inputs[0].words[1], i % 2);
        assert_memory_equal(step.inputs[0].numbers, at, sizeof at);
        expect_same_bits(i % 2 == 1 ? i / 256.0 : 0.0, step.inputs[0].numbers[4]);
    }
    desk_end(&d);
}

/* The same bits are promised to logs of the same library version. */
static bool is_of_this_version(const desk *d)
{
    vbss_replay_info info;
    expect_ok(vbss_replay_get_info(d->replay, &info, sizeof info));
    return info.library_version == vbss_version();
}

static void old_format_replays_and_seeks(void **state)
{
    (void)state;
    desk d;
    vbss_replay_report report;
    desk_begin(&d);
    expect_ok(vbss_replay_begin(d.replay, d.scene));
    if (is_of_this_version(&d)) {
        const uint64_t targets[] = {10, 3, 9};
        for (int i = 0; i < 3; i++) {
            expect_ok(vbss_replay_seek(d.replay, targets[i], &report, sizeof report));
            assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_STEPPED);
            assert_int_equal(report.step, targets[i]);
        }
        expect_ok(replay_all(d.replay, &report));
        assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_ENDED);
        assert_int_equal(report.agreed_step, STEPS);
    }
    desk_end(&d);
}

/* Gone on with, it stays a log of format 2. */
static void old_format_can_be_resumed(void **state)
{
    (void)state;
    desk d;
    vbss_record *record;
    uint64_t position;
    vbss_replay_report report;
    desk_begin(&d);
    expect_ok(vbss_replay_begin(d.replay, d.scene));
    if (!is_of_this_version(&d)) {
        expect_result(VBSS_ERROR_DATA_VERSION,
                      vbss_record_resume(d.replay, NULL, &record, &position));
        desk_end(&d);
        return;
    }
    expect_ok(vbss_record_resume(d.replay, NULL, &record, &position));
    expect_ok(vbss_replay_destroy(d.replay));
    assert_true(position < d.log.count); /* before its end */
    d.log.count = (size_t)position;
    expect_ok(vbss_scene_set_recorder(d.scene, record));
    for (uint32_t i = STEPS + 1; i <= STEPS + MORE; i++) {
        double at[3];
        position_at(i, at);
        expect_ok(vbss_scene_set_rigid_target(d.scene, d.body, at, NULL));
        expect_ok(vbss_scene_step(d.scene, 0x1p-10));
    }
    expect_ok(vbss_record_end(record));
    log_take(&d.log, record);
    assert_int_equal(d.log.bytes[4], 2);
    expect_ok(vbss_replay_create(d.context, d.log.bytes, d.log.count, &d.replay));
    expect_ok(vbss_replay_begin(d.replay, d.scene));
    expect_ok(replay_all(d.replay, &report));
    assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_ENDED);
    assert_int_equal(report.agreed_step, STEPS + MORE);
    desk_end(&d);
}

/* ---- when it is not as it should be */

static vbss_result check(desk *d)
{
    vbss_record_log_report report;
    expect_ok(
        vbss_record_check_log(d->context, d->log.bytes, d->log.count, &report, sizeof report));
    return report.result;
}

static void damaged_old_log_is_reported(void **state)
{
    (void)state;
    desk d;
    desk_begin(&d);
    expect_ok(vbss_replay_destroy(d.replay));
    for (size_t i = 0; i < d.log.count; i++) {
        d.log.bytes[i] ^= 1;
        assert_int_not_equal(check(&d), VBSS_OK);
        d.log.bytes[i] ^= 1;
    }
    while (d.log.count > 0) {
        d.log.count--;
        expect_result(VBSS_ERROR_TRUNCATED, check(&d));
    }
    desk_end(&d);
}

/* With right checksums: whatever comes of it is a status, and no step that is read has a number that is none. */
static void damaged_old_log_with_valid_checksum_is_handled(void **state)
{
    (void)state;
    enum { STRIDE = 5 };
    desk d;
    desk_begin(&d);
    expect_ok(vbss_replay_destroy(d.replay));
    log_place place = {.next = 0};
    while (log_next_place(&d.log, &place)) {
        for (size_t i = place.at + 8; i < place.next - 8; i += STRIDE) {
            log_bytes log = log_copy(&d.log);
            vbss_replay_report report;
            log.bytes[i] ^= (uint8_t)(1u << i % 8);
            log_seal(&log);
            if (vbss_replay_create(d.context, log.bytes, log.count, &d.replay) == VBSS_OK) {
                vbss_replay_logged_step step;
                for (uint64_t n = 1; vbss_replay_read(d.replay, n, &step, sizeof step) == VBSS_OK;
                     n++) {
                    assert_true(step.h - step.h == 0.0);
                }
                if (vbss_replay_begin(d.replay, d.scene) == VBSS_OK) {
                    (void)replay_all(d.replay, &report);
                }
                expect_ok(vbss_replay_destroy(d.replay));
            }
            log_free(&log);
        }
    }
    desk_end(&d);
}

int test_old_format(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(old_format_reads_bit_exact),
        cmocka_unit_test(old_format_replays_and_seeks),
        cmocka_unit_test(old_format_can_be_resumed),
        cmocka_unit_test(damaged_old_log_is_reported),
        cmocka_unit_test(damaged_old_log_with_valid_checksum_is_handled),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
