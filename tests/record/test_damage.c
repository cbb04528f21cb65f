/* Logs that are cut off or damaged. */
#include "damage.h"

/* ---- power loss */

static void truncated_log_is_reported_and_read_up_to_cut(void **state)
{
    (void)state;
    damage d;
    damage_begin(&d, 5);
    for (size_t cut = 0; cut < d.good.count; cut++) {
        log_bytes log = {d.good.bytes, cut};
        log_place place = {.next = 0};
        uint64_t complete = 0;
        while (log_next_place(&d.good, &place) && place.next <= cut) {
            complete += place.code == STEP;
        }
        damage_expect(&d, &log, VBSS_ERROR_TRUNCATED, complete);
    }
    damage_expect(&d, &d.good, VBSS_OK, 5);
    damage_end(&d);
}

static void steps_before_cut_are_replayed(void **state)
{
    (void)state;
    damage d;
    vbss_replay_report report;
    damage_begin(&d, 20);
    log_bytes log = {d.good.bytes, log_find(&d.good, STEP, 18).next - 1};
    vbss_replay *replay = replay_of(&d.s, &log);
    expect_ok(vbss_replay_begin(replay, d.s.scene));
    expect_result(VBSS_ERROR_TRUNCATED, replay_all(replay, &report));
    assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_STOPPED);
    assert_int_equal(report.agreed_step, 17);
    assert_int_equal(report.position, log_find(&d.good, STEP, 18).at);
    damage_end(&d);
}

/* ---- damage */

static void changed_byte_is_located(void **state)
{
    (void)state;
    damage d;
    char where[64];
    uint64_t steps;
    damage_begin(&d, 5);
    log_place place = {.next = 0};
    for (size_t at = 0; at < d.good.count; at++) {
        if (at >= 8 && at >= place.next) {
            assert_true(log_next_place(&d.good, &place));
        }
        d.good.bytes[at] ^= (uint8_t)(1u << (at % 8));
        expect_result(at >= 4 && at < 8 ? VBSS_ERROR_DATA_VERSION : VBSS_ERROR_CORRUPT,
                      damage_read(&d, &d.good, &steps));
        if (at >= 8) {
            snprintf(where, sizeof where, "byte %zu of", place.at);
            assert_non_null(strstr(last_text(d.s.context), where));
        }
        d.good.bytes[at] ^= (uint8_t)(1u << (at % 8));
    }
    damage_end(&d);
}

/* A tail of zeros, as some file systems leave it. */
static void zero_tail_is_reported(void **state)
{
    (void)state;
    damage d;
    damage_begin(&d, 5);
    log_bytes log = log_copy(&d.good);
    memset(log.bytes + log_find(&log, STEP, 4).at, 0, log.count - log_find(&log, STEP, 4).at);
    damage_expect(&d, &log, VBSS_ERROR_CORRUPT, 3);
    log_free(&log);
    damage_end(&d);
}

static void out_of_order_records_are_reported(void **state)
{
    (void)state;
    damage d;
    damage_begin(&d, 3);
    const log_place no = {.next = 0}, head = log_find(&d.good, HEAD, 1),
                    snap = log_find(&d.good, SNAP, 1), one = log_find(&d.good, STEP, 1),
                    two = log_find(&d.good, STEP, 2), three = log_find(&d.good, STEP, 3),
                    last = log_find(&d.good, ENDS, 1);
    const struct {
        log_place order[9];
        uint64_t steps;
    } orders[] = {
        {{head, snap, one, three, last, no}, 1},
        {{head, snap, one, three, two, last, no}, 1},
        {{head, snap, one, two, two, three, last, no}, 2},
        {{head, snap, one, two, last, no}, 2},
        {{head, snap, one, two, three, last, last, no}, 3},
        {{head, snap, one, snap, two, three, last, no}, 1},
        {{head, snap, one, head, two, three, last, no}, 1},
        {{snap, one, two, three, last, no}, 0},
        {{head, one, two, three, last, no}, 0},
        {{snap, head, one, two, three, last, no}, 0},
    };
    for (size_t i = 0; i < sizeof orders / sizeof orders[0]; i++) {
        log_bytes log = damage_shuffled(&d.good, orders[i].order);
        uint64_t steps;
        expect_result(VBSS_ERROR_CORRUPT, damage_read(&d, &log, &steps));
        log_seal(&log); /* under right checksums too */
        damage_expect(&d, &log, VBSS_ERROR_CORRUPT, orders[i].steps);
        log_free(&log);
    }
    damage_end(&d);
}

int test_damage(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(truncated_log_is_reported_and_read_up_to_cut),
        cmocka_unit_test(steps_before_cut_are_replayed),
        cmocka_unit_test(changed_byte_is_located),
        cmocka_unit_test(zero_tail_is_reported),
        cmocka_unit_test(out_of_order_records_are_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
