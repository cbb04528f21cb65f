/* Shears that cut, recorded and replayed. */
#include <stdlib.h>
#include <string.h>

#include "contract/events.h"
#include "fixtures/cutting_scene.h"
#include "harness/harness.h"

typedef struct bytes {
    uint8_t *all;
    size_t count;
} bytes;

static void take(bytes *log, vbss_record *record)
{
    const uint8_t *more;
    uint64_t count;
    expect_ok(vbss_record_take(record, &more, &count));
    log->all = realloc(log->all, log->count + count + 1);
    assert_non_null(log->all);
    memcpy(log->all + log->count, more, count);
    log->count += count;
}

static void exchange_and_cuts_replay_bit_equal(void **state)
{
    (void)state;
    for (int method = 0; method < 2; method++) {
        harness_memory memory;
        vbss_context *context = harness_context(&memory);
        vbss_scene *scenes[2] = {NULL, NULL};
        bytes log = {NULL, 0};
        uint32_t cuts = 0;
        uint64_t hashes[2];
        for (int k = 0; k < 2; k++) {
            expect_ok(cutting_scene_create(context, method, &scenes[k]));
        }
        vbss_record *record;
        expect_ok(vbss_record_create(scenes[0], NULL, &record));
        expect_ok(vbss_scene_set_recorder(scenes[0], record));
        for (uint32_t i = 0; i < CUTTING_SCENE_STEPS; i++) {
            expect_ok(cutting_scene_drive(scenes[0]));
            expect_ok(vbss_scene_step(scenes[0], 1e-3));
            cuts += count_cuts(scenes[0]);
            take(&log, record);
        }
        assert_int_equal(cuts, 2);
        expect_ok(vbss_record_end(record));
        take(&log, record);
        expect_ok(vbss_record_destroy(record));
        expect_ok(vbss_scene_get_hash(scenes[0], &hashes[0]));
        /* In a scene made alike, once more in it, and in the one that was recorded, with its cuts. */
        static const int order[] = {1, 1, 0};
        for (int k = 0; k < 3; k++) {
            vbss_replay *replay;
            vbss_replay_report report = {.outcome = VBSS_REPLAY_OUTCOME_STEPPED};
            expect_ok(vbss_replay_create(context, log.all, log.count, &replay));
            expect_ok(vbss_replay_begin(replay, scenes[order[k]]));
            while (report.outcome == VBSS_REPLAY_OUTCOME_STEPPED) {
                expect_ok(vbss_replay_step(replay, &report, sizeof report));
            }
            assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_ENDED);
            assert_int_equal(report.agreed_step, CUTTING_SCENE_STEPS);
            expect_ok(vbss_scene_get_hash(scenes[order[k]], &hashes[1]));
            assert_true(hashes[0] == hashes[1]);
            expect_ok(vbss_replay_destroy(replay));
        }
        free(log.all);
        harness_context_end(context, &memory);
    }
}

int test_shears_replay(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exchange_and_cuts_replay_bit_equal),
    };
    return cmocka_run_group_tests_name("scene.shears_replay", tests, NULL, NULL);
}
