/* Steps of scenes with a drain that need more contacts or candidates than there is capacity for. */
#include "scene/drains_rig.h"

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
static uint32_t crowd_steps(crowd *c, uint32_t limit)
{
    for (uint32_t i = 0; i < limit; i++) {
        expect_ok(drain_hands_drive(c->s.scene));
        const uint64_t hash = small_hash(&c->s), own = drains_rig_hash(c->hands.drain);
        const uint32_t events = small_object(&c->s)->events.count;
        vbss_result result = vbss_scene_step(c->s.scene, 1e-3);
        if (result != VBSS_OK) {
            for (int again = 0; again < 2; again++) {
                expect_result(VBSS_ERROR_CAPACITY, result);
                assert_true(small_hash(&c->s) == hash);
                assert_true(drains_rig_hash(c->hands.drain) == own);
                assert_int_equal(small_object(&c->s)->events.count, events);
                result = vbss_scene_step(c->s.scene, 1e-3);
            }
            return i;
        }
    }
    return limit;
}

static void step_without_capacity_changes_nothing(void **state)
{
    enum { STEPS = 420, ROOMS = 9 };
    (void)state;
    const uint32_t contacts[ROOMS] = {0, 2, 8, 11, 12, 64, 64, 64, 64};
    const uint32_t candidates[ROOMS] = {2048, 2048, 2048, 2048, 2048, 0, 300, 350, 380};
    uint32_t in_contact = 0;
    for (int mode = VBSS_SCENE_MODE_REAL_TIME; mode <= VBSS_SCENE_MODE_OFFLINE; mode++) {
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
    begin_crowd(&enough, 15, 2048, VBSS_SCENE_MODE_REAL_TIME); /* its contacts, exactly */
    assert_int_equal(crowd_steps(&enough, STEPS), STEPS);
    small_end(&enough.s);
}

int test_drain_capacity(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(step_without_capacity_changes_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
