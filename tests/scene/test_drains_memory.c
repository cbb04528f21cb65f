/* Where the memory of drains in scenes goes: failing allocations, steps without any, rooms that are met. */
#include "scene/drains_rig.h"

/* ---- allocations */

typedef struct plan {
    vbss_scene_config scene;
    vbss_drain_config drain;
} plan;

static vbss_result fill(vbss_scene *scene, vbss_drain *drain)
{
    uint32_t body;
    VBSS_TRY(vbss_scene_add_drain(scene, drain, &body));
    VBSS_TRY(vbss_scene_step(scene, 1e-3));
    return vbss_scene_remove(scene, body);
}

static vbss_result attempt(vbss_context *context, void *user)
{
    const plan *p = user;
    vbss_scene *scene;
    vbss_drain *drain = NULL;
    uint64_t hash;
    VBSS_TRY(vbss_scene_create(context, &p->scene, &scene));
    vbss_result result = vbss_drain_create(context, &p->drain, &drain);
    if (result == VBSS_OK) {
        result = fill(scene, drain);
    }
    VBSS_TRY(vbss_scene_get_hash(scene, &hash)); /* whatever failed, it is a scene */
    VBSS_TRY(vbss_scene_destroy(scene));
    VBSS_TRY(vbss_drain_destroy(drain)); /* and that is the host's */
    return result;
}

static void each_failed_allocation_is_reported_without_leak(void **state)
{
    (void)state;
    plan p;
    expect_ok(vbss_scene_config_init(&p.scene, sizeof p.scene));
    expect_ok(vbss_drain_config_init(&p.drain, sizeof p.drain));
    p.scene.node_capacity = 20;
    p.scene.contact_capacity = 16;
    p.scene.candidate_capacity = 512;
    harness_fail_every_allocation(attempt, &p);
}

/* What fails leaves the scene and the drain as they were, beside a drain that is there already too. */
static void drain_without_memory_is_not_added(void **state)
{
    (void)state;
    uint32_t failures = 0;
    bool failed = true;
    for (uint64_t k = 1; failed; k++) {
        small s;
        vbss_drain *first, *drain;
        uint32_t body = 77;
        small_begin(&s);
        s.config.drain_capacity = 2;
        small_create(&s);
        small_drain(&s, &first);
        small_steps(&s, 2, 1e-3);
        s.drain.position[0] = 0.05;
        expect_ok(vbss_drain_create(s.context, &s.drain, &drain));
        uint64_t hash = small_hash(&s), own = drains_rig_hash(drain), blocks = s.memory.blocks;
        s.memory.fail_call = s.memory.calls + k;
        vbss_result result = vbss_scene_add_drain(s.scene, drain, &body);
        failed = s.memory.failures > 0;
        s.memory.fail_call = 0;
        expect_result(failed ? VBSS_ERROR_OUT_OF_MEMORY : VBSS_OK, result);
        if (failed) {
            failures++;
            assert_int_equal(body, 77);
            assert_int_equal(s.memory.blocks, blocks);
            assert_true(small_hash(&s) == hash);
            assert_true(drains_rig_hash(drain) == own);
            small_steps(&s, 2, 1e-3);
            expect_ok(vbss_drain_step(drain, 1e-3)); /* still the host's */
            expect_ok(vbss_scene_add_drain(s.scene, drain, &body));
            assert_int_equal(body, 2);
        }
        small_steps(&s, 2, 1e-3);
        small_end(&s);
    }
    assert_true(failures >= 3);
}

static void steps_do_not_allocate(void **state)
{
    (void)state;
    drain_hands hands;
    expect_ok(drain_hands_init(&hands));
    harness_body body = drains_as_body(&hands);
    assert_int_equal(harness_step_allocations(&body, 250), 0);
}

static void drain_churn_does_not_grow_memory(void **state)
{
    (void)state;
    small s;
    vbss_drain *drain;
    uint32_t body;
    uint64_t blocks = 0;
    small_begin_scene(&s);
    expect_ok(vbss_drain_create(s.context, &s.drain, &drain));
    for (int i = 0; i < 12; i++) {
        expect_ok(vbss_scene_add_drain(s.scene, drain, &body));
        small_steps(&s, 2, 1e-3);
        expect_ok(vbss_scene_remove(s.scene, body));
        blocks = i == 0 ? s.memory.blocks : blocks;
        assert_int_equal(s.memory.blocks, blocks);
        small_steps(&s, 1, 1e-3);
    }
    small_end(&s);
}

/* ---- what there is room for */

typedef struct crowd {
    small s;
    drain_hands hands;
} crowd;

static void begin_crowd(crowd *c, uint32_t contacts, uint32_t candidates, vbss_scene_mode mode)
{
    expect_ok(drain_hands_init(&c->hands));
    c->hands.config.contact_capacity = contacts;
    c->hands.config.candidate_capacity = candidates;
    c->hands.config.mode = mode;
    (void)drains_rig_begin(&c->s, &c->hands);
}

/* Steps until one has no room; that has changed nothing, nor has the same step again. Which it was. */
static uint32_t crowd_steps(crowd *c, uint32_t most)
{
    for (uint32_t i = 0; i < most; i++) {
        expect_ok(drain_hands_drive(c->s.scene));
        uint64_t hash = small_hash(&c->s), own = drains_rig_hash(c->hands.drain);
        vbss_result result = vbss_scene_step(c->s.scene, 1e-3);
        if (result != VBSS_OK) {
            for (int again = 0; again < 2; again++) {
                expect_result(VBSS_ERROR_CAPACITY, result);
                assert_true(small_hash(&c->s) == hash);
                assert_true(drains_rig_hash(c->hands.drain) == own);
                assert_int_equal(small_view(&c->s, VBSS_SCENE_VIEW_EVENTS).count, 0);
                result = vbss_scene_step(c->s.scene, 1e-3);
            }
            return i;
        }
    }
    return most;
}

static void step_without_capacity_changes_nothing(void **state)
{
    enum { STEPS = 420, ROOMS = 9 };
    (void)state;
    const uint32_t contacts[ROOMS] = {0, 2, 8, 12, 13, 64, 64, 64, 64};
    const uint32_t candidates[ROOMS] = {2048, 2048, 2048, 2048, 2048, 0, 300, 350, 380};
    uint32_t in_contact = 0;
    for (int mode = VBSS_MODE_REAL_TIME; mode <= VBSS_MODE_OFFLINE; mode++) {
        for (int k = 0; k < ROOMS; k++) {
            crowd c;
            begin_crowd(&c, contacts[k], candidates[k], mode);
            assert_true(crowd_steps(&c, STEPS) < STEPS);
            in_contact += small_statistics(&c.s).contacts > 0;
            /* Without what crowds it, it goes on. */
            expect_ok(vbss_scene_remove(c.s.scene, DRAIN_HANDS_TOOL));
            expect_ok(vbss_scene_remove(c.s.scene, DRAIN_HANDS_THREAD));
            expect_ok(vbss_scene_remove(c.s.scene, DRAIN_HANDS_DRAIN));
            small_steps(&c.s, 2, 1e-3);
            expect_ok(vbss_drain_step(c.hands.drain, 1e-3));
            small_end(&c.s);
        }
    }
    assert_true(in_contact > 2);
    crowd enough;
    begin_crowd(&enough, 64, 2048, VBSS_MODE_REAL_TIME);
    assert_int_equal(crowd_steps(&enough, STEPS), STEPS);
    small_end(&enough.s);
}

int test_drains_memory(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_failed_allocation_is_reported_without_leak),
        cmocka_unit_test(drain_without_memory_is_not_added),
        cmocka_unit_test(steps_do_not_allocate),
        cmocka_unit_test(drain_churn_does_not_grow_memory),
        cmocka_unit_test(step_without_capacity_changes_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
