/* What is wrong with a log, and where: told without a scene, for any bytes. */
#include "base/little_endian.h"
#include "damage.h"

static vbss_record_log_report check(damage *d, const log_bytes *log)
{
    vbss_record_log_report report;
    uint8_t *exact = malloc(log->count > 0 ? log->count : 1); /* reading beyond is found out */
    assert_non_null(exact);
    memcpy(exact, log->bytes, log->count);
    expect_ok(vbss_record_check_log(d->s.context, exact, log->count, &report, sizeof report));
    free(exact);
    assert_int_equal(report.log_bytes, log->count);
    assert_true((report.result == VBSS_OK) == (report.fault_count == 0));
    assert_true(report.fault_count == 0 || report.fault_results[0] == report.result);
    for (uint32_t i = 0; i < report.fault_count && i < 8; i++) {
        assert_true(strlen(report.fault_problems[i]) > 10);
        assert_true(report.fault_positions[i] <= log->count);
    }
    return report;
}

static void good_log_is_counted(void **state)
{
    (void)state;
    damage d;
    stage recorded;
    vbss_record_config config;
    expect_ok(vbss_record_config_init(&config, sizeof config));
    config.snapshot_interval = 10;
    damage_begin(&d, 1);
    stage_begin(&recorded, NULL);
    log_bytes log = log_of(&recorded, &config, 45);
    vbss_replay *replay = replay_of(&recorded, &log);
    uint64_t inputs = 0, events = 0;
    double time = 0.0;
    for (uint32_t i = 1; i <= 45; i++) {
        vbss_replay_logged_step step;
        expect_ok(vbss_replay_read(replay, i, &step, sizeof step));
        inputs += step.input_count;
        events += step.event_count;
        time = step.time;
    }
    const vbss_record_log_report report = check(&d, &log);
    expect_ok(report.result);
    assert_int_equal(report.ended, 1);
    assert_int_equal(report.good_bytes, log.count);
    assert_int_equal(report.steps, 45);
    assert_int_equal(report.inputs, inputs);
    assert_int_equal(report.events, events);
    assert_int_equal(report.snapshots, 5);
    expect_same_bits(time, report.time);
    stage_end(&recorded);
    log_free(&log);
    damage_end(&d);
}

static void cut_is_reported_at_last_complete_record(void **state)
{
    (void)state;
    damage d;
    damage_begin(&d, 5);
    for (size_t cut = 0; cut < d.good.count; cut++) {
        log_bytes log = {d.good.bytes, cut};
        log_place place = {.next = 0};
        uint64_t complete = 0;
        size_t good = 0;
        while (log_next_place(&d.good, &place) && place.next <= cut) {
            complete += place.code == STEP;
            good = place.code == HEAD ? 0 : place.next; /* it takes both to begin */
        }
        const vbss_record_log_report report = check(&d, &log);
        assert_int_equal(report.result, VBSS_ERROR_TRUNCATED);
        assert_int_equal(report.fault_count, 1);
        assert_int_equal(report.steps, complete);
        assert_int_equal(report.good_bytes, good);
        assert_int_equal(report.ended, 0);
    }
    damage_end(&d);
}

static void changed_byte_is_reported_and_rest_is_found(void **state)
{
    (void)state;
    damage d;
    log_place place = {.next = 0};
    damage_begin(&d, 5);
    for (size_t at = 0; at < d.good.count; at++) {
        if (at >= 8 && at >= place.next) {
            assert_true(log_next_place(&d.good, &place));
        }
        d.good.bytes[at] ^= (uint8_t)(1u << (at % 8));
        const vbss_record_log_report report = check(&d, &d.good);
        assert_int_equal(report.result,
                         at >= 4 && at < 8 ? VBSS_ERROR_DATA_VERSION : VBSS_ERROR_CORRUPT);
        bool in_sum = at >= 8 && at >= place.next - 8; /* which the next record covers too */
        assert_int_equal(report.fault_count, in_sum && place.code != ENDS ? 2 : 1);
        assert_int_equal(report.fault_positions[0], at < 4 ? 0 : at < 8 ? 4 : place.at);
        assert_true(at < 8 || report.good_bytes <= place.at);
        d.good.bytes[at] ^= (uint8_t)(1u << (at % 8));
    }
    damage_end(&d);
}

static void all_faults_are_reported(void **state)
{
    (void)state;
    damage d;
    damage_begin(&d, 40);
    for (uint32_t step = 3; step <= 39; step += 3) {
        d.good.bytes[log_find(&d.good, STEP, step).at + 10] ^= 1;
    }
    const log_bytes cut = {d.good.bytes, log_find(&d.good, STEP, 40).next - 2};
    const vbss_record_log_report report = check(&d, &cut);
    assert_int_equal(report.result, VBSS_ERROR_CORRUPT);
    assert_int_equal(report.steps, 2);
    assert_int_equal(report.fault_count, 13 + 1);
    for (uint32_t i = 0; i < 8; i++) { /* of which these have room */
        assert_int_equal(report.fault_positions[i], log_find(&d.good, STEP, 3 + 3 * i).at);
        assert_int_equal(report.fault_results[i], VBSS_ERROR_CORRUPT);
    }
    damage_end(&d);
}

static void invalid_content_with_valid_checksum_is_reported(void **state)
{
    (void)state;
    damage d;
    damage_begin(&d, 5);
    log_to_format_2(&d.good);
    const size_t step = log_find(&d.good, STEP, 3).at;
    const size_t intervals = log_find(&d.good, HEAD, 1).at;
    log_bytes log = log_copy(&d.good);
    log.bytes[step + 8 + 8 + 8] = 9; /* another step */
    log_seal(&log);
    vbss_record_log_report report = check(&d, &log);
    assert_int_equal(report.result, VBSS_ERROR_CORRUPT);
    assert_int_equal(report.steps, 2);
    assert_int_equal(report.good_bytes, step);
    assert_int_equal(report.fault_positions[0], step);
    assert_int_equal(report.fault_count, 1);
    memcpy(log.bytes, d.good.bytes, log.count);
    size_t build = strlen(vbss_build_info()); /* section, version, count and bytes of the text */
    uint8_t *interval = log.bytes + intervals + 8 + 8 + 12 + 12 + 8 + build + 8;
    assert_int_equal(load_little_endian(interval, 4), 1);
    store_little_endian(interval, 0, 4);
    log_seal(&log);
    report = check(&d, &log);
    assert_int_equal(report.result, VBSS_ERROR_CORRUPT);
    assert_int_equal(report.good_bytes, 0);
    memcpy(log.bytes, d.good.bytes, log.count);
    uint8_t *largest = damage_config_word(&log, 9); /* events of a step */
    assert_int_equal(load_little_endian(largest, 4), 256);
    store_little_endian(largest, 65537, 4);
    log_seal(&log);
    report = check(&d, &log);
    assert_int_equal(report.result, VBSS_ERROR_CORRUPT);
    assert_int_equal(report.good_bytes, 0);
    memcpy(log.bytes, d.good.bytes, log.count);
    const log_place first = log_find(&log, SNAP, 1);
    log.bytes[first.at + 8 + 8 + 8] = 1; /* not the scene at the begin */
    log_seal(&log);
    report = check(&d, &log);
    assert_int_equal(report.result, VBSS_ERROR_CORRUPT);
    assert_int_equal(report.fault_positions[0], first.at);
    log_free(&log);
    damage_end(&d);
}

static void check_anything(harness_source *source, void *user)
{
    damage *d = user;
    uint8_t bytes[300];
    log_bytes log = {bytes, harness_draw_below(source, sizeof bytes)};
    for (size_t i = 0; i < log.count; i++) {
        bytes[i] = (uint8_t)harness_draw_below(source, 256);
    }
    if (harness_draw_below(source, 2) == 0 && log.count >= 8) {
        memcpy(bytes, d->good.bytes, 8);
    }
    assert_true(check(d, &log).result != VBSS_OK);
}

static void any_bytes_can_be_checked(void **state)
{
    (void)state;
    damage d;
    vbss_record_log_report report;
    damage_begin(&d, 1);
    harness_property("no log at all", 300, check_anything, &d);
    expect_result(VBSS_ERROR_NULL_ARGUMENT,
                  vbss_record_check_log(d.s.context, NULL, 9, &report, sizeof report));
    expect_result(VBSS_ERROR_INVALID_HANDLE,
                  vbss_record_check_log(NULL, d.good.bytes, 9, &report, sizeof report));
    damage_end(&d);
}

int test_faults(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(good_log_is_counted),
        cmocka_unit_test(cut_is_reported_at_last_complete_record),
        cmocka_unit_test(changed_byte_is_reported_and_rest_is_found),
        cmocka_unit_test(all_faults_are_reported),
        cmocka_unit_test(invalid_content_with_valid_checksum_is_reported),
        harness_test(any_bytes_can_be_checked),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
