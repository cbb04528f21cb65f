/* Threads with twist and with memory of bends in a log: replayed to the bit, also from a snapshot inside the log. */
#include "fixture.h"
#include "fixtures/rolled_scene.h"
#include "record/record.h"

enum { STEPS = 60, INTERVAL = 8 };

typedef struct rolled {
    harness_memory memory;
    vbss_context *context;
    rolled_scene s;
} rolled;

static void begin(rolled *r, bool has_friction_torque)
{
    *r = (rolled){.context = NULL};
    r->context = harness_context(&r->memory);
    expect_ok(rolled_scene_create(r->context, has_friction_torque, &r->s));
}

static uint64_t hash_of(vbss_scene *scene)
{
    uint64_t hash = 0;
    expect_ok(vbss_scene_get_hash(scene, &hash));
    return hash;
}

static void end(rolled *r)
{
    harness_context_end(r->context, &r->memory);
}

static log_bytes log_of_rolls(rolled *r, uint64_t hashes[STEPS + 1])
{
    vbss_record_config config;
    vbss_record *record;
    log_bytes log = {NULL, 0};
    expect_ok(vbss_record_config_init(&config, sizeof config));
    config.hash_interval = 1;
    config.snapshot_interval = INTERVAL;
    expect_ok(vbss_record_create(r->s.scene, &config, &record));
    expect_ok(vbss_scene_set_recorder(r->s.scene, record));
    hashes[0] = hash_of(r->s.scene);
    for (uint32_t k = 1; k <= STEPS; k++) {
        expect_ok(rolled_scene_step(&r->s));
        hashes[k] = hash_of(r->s.scene);
        log_take(&log, record);
    }
    expect_ok(vbss_record_end(record));
    log_take(&log, record);
    return log;
}

static double at(vbss_scene *scene, uint32_t body, vbss_thread_field field, uint32_t entry)
{
    vbss_thread *thread;
    vbss_view view;
    expect_ok(vbss_scene_get_thread(scene, body, &thread));
    expect_ok(vbss_thread_get_view(thread, field, &view, sizeof view));
    assert_true(entry < view.count);
    return *(const double *)(const void *)((const char *)view.data +
                                           (size_t)entry * view.stride_bytes);
}

/* In the scene that the log describes: there is no other knowledge of twist and memory. */
static void expect_replay(bool has_friction_torque)
{
    uint64_t hashes[STEPS + 1];
    rolled r, other;
    begin(&r, has_friction_torque);
    log_bytes log = log_of_rolls(&r, hashes);
    /* With friction torque the thread is cut, and only the contact still twists it; at rest it has 20 rad/m. */
    const uint32_t segment = has_friction_torque ? 8 : 20;
    const double twist = at(r.s.scene, ROLLED_TWISTED, VBSS_THREAD_VIEW_TWISTS, segment);
    const double set = at(r.s.scene, ROLLED_BENT, VBSS_THREAD_VIEW_PLASTIC_CURVATURES, 14);
    assert_true(fabs(twist - 20.0) > (has_friction_torque ? 1e-3 : 30.0) && fabs(set) > 5.0);

    other.context = harness_context(&other.memory);
    vbss_replay *replay;
    vbss_scene *scene;
    vbss_replay_report report;
    expect_ok(vbss_replay_create(other.context, log.bytes, log.count, &replay));
    expect_ok(vbss_replay_load_scene(replay, &scene));
    for (uint32_t k = 1; k <= STEPS; k++) {
        expect_ok(vbss_replay_step(replay, &report, sizeof report));
        assert_true(hash_of(scene) == hashes[k]);
    }
    expect_ok(replay_all(replay, &report));
    assert_int_equal(report.outcome, VBSS_REPLAY_OUTCOME_ENDED);
    assert_int_equal(report.agreed_step, STEPS);
    expect_near(twist, at(scene, ROLLED_TWISTED, VBSS_THREAD_VIEW_TWISTS, segment), 0.0);
    expect_near(set, at(scene, ROLLED_BENT, VBSS_THREAD_VIEW_PLASTIC_CURVATURES, 14), 0.0);

    /* Between snapshots, before, while and after the section is held. */
    const uint32_t sought[] = {30, 10, 55, 17};
    for (int k = 0; k < 4; k++) {
        expect_ok(vbss_replay_seek(replay, sought[k], &report, sizeof report));
        assert_int_equal(report.agreed_step, sought[k]);
        assert_true(hash_of(scene) == hashes[sought[k]]);
    }
    expect_ok(vbss_replay_destroy(replay));
    harness_context_end(other.context, &other.memory);
    log_free(&log);
    end(&r);
}

/* Each saved state, in a scene that has another past and in one that is loaded, continues with the same bits. */
static void expect_restored_states(bool has_friction_torque)
{
    rolled r, other;
    begin(&r, has_friction_torque);
    begin(&other, has_friction_torque);
    for (uint32_t k = 0; k < 37; k++) {
        expect_ok(rolled_scene_step(&other.s));
    }
    for (uint32_t k = 0; k < STEPS; k++) {
        expect_ok(rolled_scene_step(&r.s));
        if (k % 10 != 6) {
            continue;
        }
        uint64_t count = 0;
        expect_result(VBSS_ERROR_CAPACITY, vbss_scene_save(r.s.scene, NULL, 0, &count));
        uint8_t *bytes = malloc(count);
        assert_non_null(bytes);
        expect_ok(vbss_scene_save(r.s.scene, bytes, count, &count));
        expect_ok(vbss_scene_restore(other.s.scene, bytes, count));
        rolled_scene loaded = r.s;
        expect_ok(vbss_scene_load(other.context, bytes, count, &loaded.scene));
        free(bytes);
        other.s.roll = r.s.roll;
        assert_true(hash_of(other.s.scene) == hash_of(r.s.scene));
        for (int i = 0; i < 3; i++, k++) {
            expect_ok(rolled_scene_step(&r.s));
            expect_ok(rolled_scene_step(&other.s));
            expect_ok(rolled_scene_step(&loaded));
            assert_true(hash_of(other.s.scene) == hash_of(r.s.scene));
            assert_true(hash_of(loaded.scene) == hash_of(r.s.scene));
        }
        expect_ok(vbss_scene_destroy(loaded.scene));
    }
    end(&other);
    end(&r);
}

/* A refused edit is not in the log, and changes no bit of the scene. */
static void refused_rolls_are_not_recorded(void **state)
{
    (void)state;
    rolled r;
    vbss_record *record;
    vbss_thread *bent;
    uint32_t id = 77;
    begin(&r, false);
    expect_ok(vbss_record_create(r.s.scene, NULL, &record));
    expect_ok(vbss_scene_set_recorder(r.s.scene, record));
    expect_ok(rolled_scene_step(&r.s));
    const uint64_t before = hash_of(r.s.scene);
    log_bytes log = {NULL, 0};
    log_take(&log, record);
    const size_t taken = log.count;
    expect_ok(vbss_scene_get_thread(r.s.scene, ROLLED_BENT, &bent));
    expect_result(VBSS_ERROR_INCOMPATIBLE, vbss_thread_set_roll(bent, r.s.force, 1.0));
    vbss_thread_attachment roll;
    expect_ok(vbss_thread_attachment_init(&roll, sizeof roll));
    roll.kind = VBSS_THREAD_ATTACHMENT_ROLL;
    roll.node = 5;
    expect_result(VBSS_ERROR_INCOMPATIBLE, vbss_thread_attach(bent, &roll, &id));
    assert_int_equal(id, 77);
    assert_true(hash_of(r.s.scene) == before);
    log_take(&log, record);
    assert_int_equal(log.count, taken);
    expect_ok(rolled_scene_step(&r.s));
    expect_ok(vbss_record_end(record));
    log_free(&log);
    end(&r);
}

static void replay_repeats_rolls_and_sets_to_the_bit(void **state)
{
    (void)state;
    expect_replay(false);
}

static void replay_repeats_friction_torque_to_the_bit(void **state)
{
    (void)state;
    expect_replay(true);
}

static void saved_states_restore_to_the_bit(void **state)
{
    (void)state;
    expect_restored_states(false);
}

static void saved_friction_torque_restores_to_the_bit(void **state)
{
    (void)state;
    expect_restored_states(true);
}

int test_roll_log(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(replay_repeats_rolls_and_sets_to_the_bit),
        cmocka_unit_test(replay_repeats_friction_torque_to_the_bit),
        cmocka_unit_test(saved_states_restore_to_the_bit),
        cmocka_unit_test(saved_friction_torque_restores_to_the_bit),
        cmocka_unit_test(refused_rolls_are_not_recorded),
    };
    return cmocka_run_group_tests_name("record.roll_log", tests, NULL, NULL);
}
