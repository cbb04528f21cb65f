/* A thread that tears a wall at its hole, in a log: replayed to the bit, also from snapshots inside the log, when the wall is a
 * sheet, a surface of the host, or the slit drain. */
#include "fixture.h"
#include "scene/tear_rig.h"

enum { STEPS = 120, INTERVAL = 16 };

typedef enum wall { SHEET, HOST_SURFACE, DRAIN } wall;

/* of both ends of the thread, m/s: the drain yields, before it tears */
static const double speeds[] = {[SHEET] = 40e-3, [HOST_SURFACE] = 40e-3, [DRAIN] = 80e-3};

static uint64_t hash_of(vbss_scene *scene)
{
    uint64_t hash = 0;
    expect_ok(vbss_scene_get_hash(scene, &hash));
    return hash;
}

static double torn_length_of(vbss_scene *scene)
{
    vbss_scene_hole hole;
    expect_ok(vbss_scene_get_hole(scene, 0, &hole, sizeof hole));
    return hole.torn_length;
}

static vec3 create(tear_rig *r, wall kind)
{
    vec3 direction = {1.0, 0.0, 0.0};
    tear_rig_begin(r, false);
    r->is_of_host = kind == HOST_SURFACE;
    if (kind == DRAIN) {
        tear_rig_create_drain(r, &direction);
    } else {
        tear_rig_create(r, 6, 6);
    }
    return vec3_scale(direction, speeds[kind]);
}

static log_bytes log_of_tear(tear_rig *r, vec3 velocity, uint64_t hashes[STEPS + 1],
                             double torn[STEPS + 1])
{
    vbss_record_config config;
    vbss_record *record;
    log_bytes log = {NULL, 0};
    expect_ok(vbss_record_config_init(&config, sizeof config));
    config.hash_interval = 1;
    config.snapshot_interval = INTERVAL;
    config.buffer_bytes = 1u << 22;
    expect_ok(vbss_record_create(r->s.scene, &config, &record));
    expect_ok(vbss_scene_set_recorder(r->s.scene, record));
    hashes[0] = hash_of(r->s.scene);
    torn[0] = 0.0;
    for (uint32_t k = 1; k <= STEPS; k++) {
        tear_rig_step(r, velocity);
        hashes[k] = hash_of(r->s.scene);
        torn[k] = torn_length_of(r->s.scene);
        log_take(&log, record);
    }
    expect_ok(vbss_record_end(record));
    log_take(&log, record);
    return log;
}

static void expect_replay_of(wall kind)
{
    uint64_t hashes[STEPS + 1];
    double torn[STEPS + 1];
    tear_rig r;
    const vec3 velocity = create(&r, kind);
    log_bytes log = log_of_tear(&r, velocity, hashes, torn);
    uint32_t first = 1;
    while (first < STEPS && torn[first] == 0.0) {
        first++;
    }
    assert_true(first > 1 && first < STEPS - 20 && torn[STEPS] > 0.5e-3);

    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    vbss_replay *replay;
    vbss_scene *scene;
    vbss_replay_report report;
    expect_ok(vbss_replay_create(context, log.bytes, log.count, &replay));
    expect_ok(vbss_replay_load_scene(replay, &scene));
    for (uint32_t k = 1; k <= STEPS; k++) {
        expect_ok(vbss_replay_step(replay, &report, sizeof report));
        assert_true(hash_of(scene) == hashes[k]);
        expect_near(torn[k], torn_length_of(scene), 0.0);
    }
    expect_ok(replay_all(replay, &report));
    assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_ENDED);
    assert_int_equal(report.agreed_step, STEPS);

    /* Within the tear, before it, and as it begins. */
    const uint32_t sought[] = {STEPS - 3, first / 2, first + 7, first};
    for (size_t i = 0; i < sizeof sought / sizeof sought[0]; i++) {
        expect_ok(vbss_replay_seek(replay, sought[i], &report, sizeof report));
        assert_true(hash_of(scene) == hashes[sought[i]]);
        expect_near(torn[sought[i]], torn_length_of(scene), 0.0);
    }
    expect_ok(vbss_replay_destroy(replay));
    harness_context_end(context, &memory);
    log_free(&log);
    tear_rig_end(&r);
}

static void tear_in_a_sheet_is_replayed(void **state)
{
    (void)state;
    expect_replay_of(SHEET);
}

static void tear_in_a_host_surface_is_replayed(void **state)
{
    (void)state;
    expect_replay_of(HOST_SURFACE);
}

static void tear_in_the_drain_is_replayed(void **state)
{
    (void)state;
    expect_replay_of(DRAIN);
}

int test_tear_log(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tear_in_a_sheet_is_replayed),
        cmocka_unit_test(tear_in_a_host_surface_is_replayed),
        cmocka_unit_test(tear_in_the_drain_is_replayed),
    };
    return cmocka_run_group_tests_name("record.tear_log", tests, NULL, NULL);
}
