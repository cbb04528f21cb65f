/* A stage that is recorded, and whose log must lead to where it is. */
#ifndef VBSS_TESTS_RECORD_RECORDER_H
#define VBSS_TESTS_RECORD_RECORDER_H

#include "fixture.h"

typedef struct recorder {
    stage s;
    vbss_record *record;
    log_bytes log;
} recorder;

static inline void recorder_begin(recorder *r, const vbss_record_config *config)
{
    stage_begin(&r->s, NULL);
    for (uint32_t i = 0; i < 5; i++) { /* a force is attached, so that all can be told */
        stage_step(&r->s, NULL);
    }
    expect_ok(vbss_record_create(r->s.scene, config, &r->record));
    r->log = (log_bytes){NULL, 0};
}

/* The log must lead to where the scene is, in `steps` steps. */
static inline void recorder_end(recorder *r, uint64_t steps)
{
    stage other;
    vbss_replay_report report;
    log_take(&r->log, r->record);
    stage_begin(&other, NULL);
    vbss_replay *replay = replay_of(&other, &r->log);
    expect_ok(vbss_replay_begin(replay, other.scene));
    expect_ok(replay_all(replay, &report));
    assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_ENDED);
    assert_int_equal(report.step, steps);
    assert_int_equal(report.agreed_step, steps);
    stage_end(&other);
    log_free(&r->log);
    stage_end(&r->s);
}

#endif
