/* Logs that are cut off or changed, and states of other sessions: a status, and nothing has changed. */
#include "followed.h"
#include "fuzz/fuzz.h"

static void truncated_log_seeks_up_to_cut(void **state)
{
    (void)state;
    static trial_log was;
    static session_trial t;
    state_place last;
    trial_record(&was);
    (void)trial_find_states(&was.log, &last);
    const uint32_t step = last.step;
    const size_t cuts[] = {last.at - 8, last.at, last.at + 20, last.at + last.length / 2,
                           last.at + last.length + 7};
    for (size_t i = 0; i < sizeof cuts / sizeof cuts[0]; i++) { /* within the newest state */
        log_bytes log = {was.log.bytes, cuts[i]};
        trial_follow(&t, &log);
        expect_ok(vbss_session_seek(t.session, step)); /* from the state before it */
        trial_expect_at(&t, &was, step);
        expect_result(VBSS_ERROR_TRUNCATED, vbss_session_seek(t.session, step + 1));
        trial_expect_at(&t, &was, step);
        trial_end(&t);
    }
    free(was.log.bytes);
}

/* Bytes of a state are changed under right checksums: a status, and nothing has changed, or it was no state's meaning. */
static void invalid_snapshot_is_rejected_and_changes_nothing(void **state)
{
    (void)state;
    static trial_log was;
    static session_trial t;
    state_place last;
    uint32_t refused = 0;
    trial_record_plain(&was);
    (void)trial_find_states(&was.log, &last);
    trial_follow(&t, &was.log);
    for (size_t i = 0; i < last.length; i += i < 400 ? 7 : 1117) {
        uint8_t *byte = was.log.bytes + last.at + i, right = *byte;
        expect_ok(vbss_session_seek(t.session, 10));
        *byte ^= 0x55;
        expect_result(VBSS_ERROR_CORRUPT, vbss_session_seek(t.session, last.step + 1));
        seal_log(was.log.bytes, was.log.count);
        vbss_result result = vbss_session_seek(t.session, last.step);
        assert_true(result == VBSS_OK || result == VBSS_ERROR_CORRUPT ||
                    result == VBSS_ERROR_DATA_VERSION || result == VBSS_ERROR_TRUNCATED ||
                    result == VBSS_ERROR_CAPACITY); /* a count beyond that of the detector */
        if (result != VBSS_OK) {
            trial_expect_at(&t, &was, 10);
            refused++;
        }
        *byte = right;
        seal_log(was.log.bytes, was.log.count);
    }
    print_message("%u states refused\n", refused);
    assert_true(refused > 40);
    expect_ok(vbss_session_seek(t.session, TRIAL_STEPS));
    trial_expect_at(&t, &was, TRIAL_STEPS);
    trial_end(&t);
    free(was.log.bytes);
}

static void snapshot_of_other_session_is_rejected(void **state)
{
    (void)state;
    static trial_log was;
    static session_trial t;
    trial_record(&was);
    trial_begin(&t);
    t.scene.config.dwell = 0.06;
    expect_ok(vbss_replay_create(t.context, was.log.bytes, was.log.count, &t.scene.config.replay));
    expect_ok(vbss_replay_begin(t.scene.config.replay, t.scene.scene));
    trial_start(&t);
    expect_result(VBSS_ERROR_CORRUPT, vbss_session_seek(t.session, 100));
    trial_end(&t);
    free(was.log.bytes);
}

int test_seek_damage(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(truncated_log_seeks_up_to_cut),
        cmocka_unit_test(invalid_snapshot_is_rejected_and_changes_nothing),
        cmocka_unit_test(snapshot_of_other_session_is_rejected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
