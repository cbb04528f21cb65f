/* Threads with twist and with memory of bends in a log: replayed to the bit, also from a snapshot inside the log. */
#include "record/replayed.h"
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

static void end(rolled *r)
{
    harness_context_end(r->context, &r->memory);
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

typedef struct last_state {
    rolled r;
    uint32_t segment;
    double twist, set;
} last_state;

static void step_last_state(void *user, uint32_t k)
{
    (void)k;
    last_state *l = user;
    expect_ok(rolled_scene_step(&l->r.s));
}

static double twist_of(vbss_scene *scene, uint32_t segment)
{
    return at(scene, ROLLED_TWISTED, VBSS_THREAD_VIEW_TWISTS, segment);
}

static double set_of(vbss_scene *scene)
{
    return at(scene, ROLLED_BENT, VBSS_THREAD_VIEW_PLASTIC_CURVATURES, 14);
}

static void expect_last_state(void *user, vbss_scene *scene, uint32_t k)
{
    const last_state *l = user;
    if (k == STEPS) {
        expect_near(l->twist, twist_of(scene, l->segment), 0.0);
        expect_near(l->set, set_of(scene), 0.0);
    }
}

/* In the scene that the log describes: there is no other knowledge of twist and memory. */
static void expect_replay(bool has_friction_torque)
{
    uint64_t hashes[STEPS + 1];
    /* With friction torque the thread is cut, and only the contact still twists it; at rest it has 20 rad/m. */
    last_state l = {.segment = has_friction_torque ? 8 : 20};
    begin(&l.r, has_friction_torque);
    const replayed r = {l.r.s.scene, STEPS, INTERVAL, &l, step_last_state, expect_last_state};
    log_bytes log = replayed_log(&r, hashes);
    l.twist = twist_of(l.r.s.scene, l.segment);
    l.set = set_of(l.r.s.scene);
    assert_true(fabs(l.twist - 20.0) > (has_friction_torque ? 1e-3 : 30.0) && fabs(l.set) > 5.0);
    /* Between snapshots, before, while and after the section is held. */
    const uint32_t sought[] = {30, 10, 55, 17};
    expect_replayed(&r, &log, hashes, sought, sizeof sought / sizeof sought[0]);
    log_free(&log);
    end(&l.r);
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
