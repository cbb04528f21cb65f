#include "record/replayed.h"

uint64_t hash_of(vbss_scene *scene)
{
    uint64_t hash = 0;
    expect_ok(vbss_scene_get_hash(scene, &hash));
    return hash;
}

log_bytes replayed_log(const replayed *r, uint64_t *hashes)
{
    vbss_record_config config;
    vbss_record *record;
    log_bytes log = {NULL, 0};
    expect_ok(vbss_record_config_init(&config, sizeof config));
    config.hash_interval = 1;
    config.snapshot_interval = r->snapshot_interval;
    config.buffer_bytes = 1u << 22;
    expect_ok(vbss_record_create(r->scene, &config, &record));
    expect_ok(vbss_scene_set_recorder(r->scene, record));
    hashes[0] = hash_of(r->scene);
    for (uint32_t k = 1; k <= r->steps; k++) {
        r->step(r->user, k);
        hashes[k] = hash_of(r->scene);
        log_take(&log, record);
    }
    expect_ok(vbss_record_end(record));
    log_take(&log, record);
    return log;
}

static void expect_state(const replayed *r, vbss_scene *scene, const uint64_t *hashes, uint32_t k)
{
    assert_true(hash_of(scene) == hashes[k]);
    if (r->check != NULL) {
        r->check(r->user, scene, k);
    }
}

void expect_replayed(const replayed *r, const log_bytes *log, const uint64_t *hashes,
                     const uint32_t *sought, size_t sought_count)
{
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_replay *replay;
    vbss_scene *scene;
    vbss_replay_report report;
    expect_ok(vbss_replay_create(context, log->bytes, log->count, &replay));
    expect_ok(vbss_replay_load_scene(replay, &scene));
    for (uint32_t k = 1; k <= r->steps; k++) {
        expect_ok(vbss_replay_step(replay, &report, sizeof report));
        expect_state(r, scene, hashes, k);
    }
    expect_ok(replay_all(replay, &report));
    assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_ENDED);
    assert_int_equal(report.agreed_step, r->steps);
    for (size_t i = 0; i < sought_count; i++) {
        expect_ok(vbss_replay_seek(replay, sought[i], &report, sizeof report));
        assert_int_equal(report.agreed_step, sought[i]);
        expect_state(r, scene, hashes, sought[i]);
    }
    expect_ok(vbss_replay_destroy(replay));
    harness_context_end(context, &memory);
}
