/* A scene that is saved and restored while a step is suspended goes on to the same bits. */
#include <stdlib.h>

#include "fixtures/solver_of.h"
#include "scene/small.h"

enum { STEPS = 60, POSES = 12, SOUGHT_POSES = 6 };

/* A needle with its thread falls on a drain, in a random pose. */
static void add_needle_over_drain(small *s, uint64_t seed)
{
    harness_source source = {.bytes = NULL};
    vbss_random_seed(&source.random, seed, 1);
    vbss_drain_config drain;
    expect_ok(vbss_drain_config_init(&drain, sizeof drain));
    drain.position[1] = -7.5e-3;
    s->drain = drain;
    small_drain(s, NULL);
    vbss_needle_config n;
    expect_ok(vbss_needle_config_init(&n, sizeof n));
    n.gravity[1] = -9.81;
    n.velocity[1] = -2.0;
    n.position[0] = harness_draw_real(&source, -0.01, 0.01);
    n.position[1] = harness_draw_real(&source, 4e-3, 1e-2);
    for (int i = 0; i < 4; i++) {
        n.orientation[i] = harness_draw_real(&source, -1.0, 1.0);
    }
    vbss_needle *needle;
    vbss_needle_state at;
    uint32_t body, pin;
    expect_ok(vbss_needle_create(s->context, &n, &needle));
    expect_ok(vbss_scene_add_needle(s->scene, needle, &body));
    expect_ok(vbss_needle_get_state(needle, &at, sizeof at));
    vec3 swage = vec3_load(at.swage);
    vbss_thread *thread;
    uint32_t line = small_thread(
        s, swage, vec3_add_scaled(swage, 0.06, vec3_load(at.swage_direction)), 60, &thread);
    const double end[3] = {-n.radius, 0.0, 0.0};
    expect_ok(vbss_scene_pin_thread(s->scene, line, 0, body, end, &pin));
}

static void begin(small *s, uint64_t seed)
{
    small_begin(s);
    set_call_operations(&s->config, 50000);
    s->config.contact_capacity = 4096;
    s->config.candidate_capacity = 65536;
    small_create(s);
    add_needle_over_drain(s, seed);
}

/* Runs the scene and keeps the hash of each step. With `restores`, the scene is saved and restored after
 * each call that leaves a step suspended. Returns the number of such calls. */
static uint32_t run(uint64_t seed, bool restores, uint64_t hashes[STEPS])
{
    small s;
    uint32_t suspended = 0;
    begin(&s, seed);
    for (uint32_t i = 0; i < STEPS; i++) {
        small_steps(&s, 1, 1e-3);
        if (small_statistics(&s).behind > 0) {
            suspended++;
            if (restores) {
                small_state saved = small_save(&s);
                expect_ok(vbss_scene_restore(s.scene, saved.bytes, saved.count));
                free(saved.bytes);
            }
        }
        hashes[i] = small_hash(&s);
    }
    small_end(&s);
    return suspended;
}

static void restored_suspended_step_finishes_its_correction(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < POSES; seed++) {
        uint64_t plain[STEPS], restored[STEPS];
        uint32_t suspended = run(seed, false, plain);
        assert_true(suspended > 10);
        assert_int_equal(run(seed, true, restored), suspended);
        assert_memory_equal(plain, restored, sizeof plain);
    }
}

/* Records a run with a snapshot after every fifth step. Returns the bytes of the log, to be freed. */
static uint8_t *record(uint64_t seed, uint64_t *count)
{
    small s;
    vbss_record_config config;
    vbss_record *record;
    const uint8_t *bytes;
    begin(&s, seed);
    expect_ok(vbss_record_config_init(&config, sizeof config));
    config.snapshot_interval = 5;
    config.buffer_bytes = 1 << 24;
    expect_ok(vbss_record_create(s.scene, &config, &record));
    expect_ok(vbss_scene_set_recorder(s.scene, record));
    for (uint32_t i = 0; i < STEPS; i++) {
        expect_ok(vbss_scene_step(s.scene, 1e-3));
    }
    expect_ok(vbss_record_end(record));
    expect_ok(vbss_record_take(record, &bytes, count));
    uint8_t *log = malloc(*count);
    assert_non_null(log);
    memcpy(log, bytes, *count);
    small_end(&s);
    return log;
}

static void replay_continues_after_seek_to_suspended_step(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < SOUGHT_POSES; seed++) {
        uint64_t count;
        uint8_t *log = record(seed, &count);
        small s;
        vbss_replay *replay;
        vbss_replay_report report;
        begin(&s, seed);
        expect_ok(vbss_replay_create(s.context, log, count, &replay));
        expect_ok(vbss_replay_begin(replay, s.scene));
        for (uint64_t step = 5; step + 6 <= STEPS; step += 5) {
            expect_ok(vbss_replay_seek(replay, step, &report, sizeof report));
            for (int i = 0; i < 6; i++) {
                expect_ok(vbss_replay_step(replay, &report, sizeof report));
                assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_STEPPED);
            }
        }
        small_end(&s);
        free(log);
    }
}

int test_suspended_restore(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(restored_suspended_step_finishes_its_correction),
        cmocka_unit_test(replay_continues_after_seek_to_suspended_step),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
