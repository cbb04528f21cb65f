/* How records and replays begin and end: structs they take and give, and their memory. */
#include "base/error.h"
#include "fixture.h"

/* ---- the size protocols */

static vbss_result init_config(void *config, uint32_t struct_size)
{
    return vbss_record_config_init(config, struct_size);
}

static vbss_result create_and_destroy(vbss_context *context, const void *config)
{
    vbss_scene *scene;
    vbss_record *record;
    VBSS_TRY(empty_scene(context, &scene));
    vbss_result result = vbss_record_create(scene, config, &record);
    assert_true((record == NULL) == (result != VBSS_OK));
    VBSS_TRY(vbss_record_destroy(record));
    VBSS_TRY(vbss_scene_destroy(scene));
    return result;
}

static void config_size_protocol(void **state)
{
    (void)state;
    static const uint32_t sizes[] = {32, 40, 0};
    const harness_config config = {sizes, init_config, create_and_destroy};
    harness_config_protocol(&config);
}

static vbss_result write_out(vbss_replay *replay, int which, void *out, uint32_t size)
{
    if (which == 2 && out != NULL) {
        memcpy(out, &size, sizeof size);
        return vbss_replay_get_scene_config(replay, out);
    }
    switch (which) {
    case 0:
        return vbss_replay_get_info(replay, out, size);
    case 1:
        return vbss_replay_step(replay, out, size);
    case 2:
        return vbss_replay_get_scene_config(replay, out);
    case 3:
        return vbss_replay_seek(replay, 1, out, size);
    default:
        return vbss_replay_read(replay, 1, out, size);
    }
}

static void output_struct_size_protocol(void **state)
{
    (void)state;
    const uint32_t sizes[5] = {48, 48, 152, 48, 80};
    stage s;
    stage_begin(&s, NULL);
    log_bytes log = log_of(&s, NULL, 3);
    vbss_replay *replay = replay_of(&s, &log);
    expect_ok(vbss_replay_begin(replay, s.scene));
    uint64_t hash = stage_hash(&s);
    for (int which = 0; which < 5; which++) {
        unsigned char out[256];
        uint32_t filled;
        expect_result(VBSS_ERROR_NULL_ARGUMENT, write_out(replay, which, NULL, sizes[which]));
        for (uint32_t size = 4; size < sizes[which]; size++) {
            if (which == 4 && size == 72) { /* an older version */
                continue;
            }
            expect_result(VBSS_ERROR_STRUCT_SIZE, write_out(replay, which, out, size));
        }
        assert_true(stage_hash(&s) == hash); /* no step was made */
        memset(out, 0xff, sizeof out);
        expect_ok(write_out(replay, which, out, 200));
        memcpy(&filled, out, sizeof filled);
        assert_int_equal(filled, sizes[which]);
        for (uint32_t i = sizes[which]; i < 200; i++) {
            assert_int_equal(out[i], 0);
        }
        assert_int_equal(out[200], 0xff);
        hash = stage_hash(&s);
    }
    stage_end(&s);
    log_free(&log);
}

static void log_output_struct_size_protocol(void **state)
{
    (void)state;
    unsigned char out[256];
    stage s;
    stage_begin(&s, NULL);
    log_bytes log = log_of(&s, NULL, 3);
    for (uint32_t size = 4; size < 240; size++) {
        if (size == 232) { /* of older hosts */
            continue;
        }
        expect_result(VBSS_ERROR_STRUCT_SIZE,
                      vbss_record_check_log(s.context, log.bytes, log.count,
                                            (vbss_record_log_report *)out, size));
    }
    memset(out, 0xff, sizeof out);
    expect_ok(
        vbss_record_check_log(s.context, log.bytes, log.count, (vbss_record_log_report *)out, 248));
    assert_int_equal(out[0], 240);
    assert_int_equal(out[247], 0);
    assert_int_equal(out[248], 0xff);
    stage_end(&s);
    log_free(&log);
}

static void bad_configs_are_rejected(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_record_config good, c;
    expect_ok(vbss_record_config_init(&good, sizeof good));
    const vbss_record_config bad[] = {
        {good.struct_size, 0, 64, 0, 4096, NULL, 0, 0},
        {good.struct_size, 1000000001u, 64, 0, 4096, NULL, 0, 0},
        {good.struct_size, 1, 65537, 0, 4096, NULL, 0, 0},
        {good.struct_size, 1, 64, 16777217, 4096, &good, 0, 0},
        {good.struct_size, 1, 64, 0, 4095, NULL, 0, 0},
        {good.struct_size, 1, 64, 0, (1u << 30) + 1, NULL, 0, 0},
        {good.struct_size, 1, 64, 0, UINT64_MAX, NULL, 0, 0},
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        expect_result(VBSS_ERROR_OUT_OF_RANGE, create_and_destroy(context, &bad[i]));
    }
    c = good;
    c.snapshot_interval = 1000000001u;
    expect_result(VBSS_ERROR_OUT_OF_RANGE, create_and_destroy(context, &c));
    c = good;
    c.note_bytes = 5;
    expect_result(VBSS_ERROR_NULL_ARGUMENT, create_and_destroy(context, &c));
    c.note = "five";
    expect_ok(create_and_destroy(context, &c));
    expect_ok(create_and_destroy(context, NULL));
    harness_context_end(context, &memory);
}

/* ---- memory */

static void steps_do_not_allocate(void **state)
{
    (void)state;
    stage s;
    vbss_record *record;
    vbss_replay_report report;
    stage_begin(&s, NULL);
    log_bytes log = {NULL, 0};
    vbss_record_config config;
    expect_ok(vbss_record_config_init(&config, sizeof config));
    config.snapshot_interval = 10;
    expect_ok(vbss_record_create(s.scene, &config, &record));
    uint64_t calls = s.memory.calls;
    for (uint32_t i = 0; i < 80; i++) {
        stage_step(&s, record);
        log_take(&log, record);
    }
    expect_ok(vbss_record_end(record));
    assert_int_equal(s.memory.calls, calls);
    log_take(&log, record);
    expect_ok(vbss_record_destroy(record));
    vbss_replay *replay = replay_of(&s, &log);
    expect_ok(vbss_replay_begin(replay, s.scene));
    calls = s.memory.calls;
    expect_ok(replay_all(replay, &report));
    assert_int_equal(report.agreed_step, 80);
    assert_int_equal(s.memory.calls, calls);
    stage_end(&s);
    log_free(&log);
}

/* Allocations of a record, then of a replay of another's log; the stage's own fail in tests of scenes. */
static vbss_result live(vbss_context *context, void *user)
{
    const log_bytes *log = user;
    const stage_options options = stage_defaults();
    stage s = {.context = context};
    vbss_record *record = NULL;
    vbss_replay *replay = NULL;
    vbss_result result = stage_make(&s, &options);
    if (result == VBSS_OK) {
        result = vbss_record_create(s.scene, NULL, &record);
    }
    if (result == VBSS_OK) {
        stage_step(&s, record);
        expect_ok(vbss_record_end(record));
        result = vbss_replay_create(context, log->bytes, log->count, &replay);
    }
    if (result == VBSS_OK) {
        result = vbss_replay_begin(replay, s.scene);
    }
    if (result == VBSS_OK) {
        vbss_replay_report report;
        expect_ok(replay_all(replay, &report));
        assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_ENDED);
    }
    vbss_record *resumed = NULL;
    if (result == VBSS_OK) {
        uint64_t position;
        result = vbss_record_resume(replay, NULL, &resumed, &position);
        assert_true((resumed == NULL) == (result != VBSS_OK));
    }
    if (result == VBSS_OK) {
        vbss_record_log_report found;
        result = vbss_record_check_log(context, log->bytes, log->count, &found, sizeof found);
        assert_true(result != VBSS_OK || found.result == VBSS_OK);
    }
    VBSS_TRY(vbss_record_destroy(resumed));
    VBSS_TRY(vbss_replay_destroy(replay));
    VBSS_TRY(vbss_record_destroy(record));
    VBSS_TRY(stage_leave(&s));
    return result;
}

static void each_failed_allocation_is_reported_without_leak(void **state)
{
    (void)state;
    stage s;
    stage_begin(&s, NULL);
    log_bytes log = log_of(&s, NULL, 4);
    harness_fail_every_allocation(live, &log);
    log_free(&log);
    stage_end(&s);
}

int test_life(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(config_size_protocol),
        cmocka_unit_test(output_struct_size_protocol),
        cmocka_unit_test(log_output_struct_size_protocol),
        cmocka_unit_test(bad_configs_are_rejected),
        cmocka_unit_test(steps_do_not_allocate),
        cmocka_unit_test(each_failed_allocation_is_reported_without_leak),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
