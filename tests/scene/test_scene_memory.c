/* Memory and capacities of scenes: bodies without memory, steps without capacity, scenes and bodies that come and go. */
#include <stdlib.h>

#include "scene/small.h"
#include "fixtures/scene_build.h"

static const vbss_scene_capsule ball = {{0.0, 0.02, 0.0}, {0.0, 0.02, 0.0}, 1e-3};

/* What fails leaves the scene as it was, and what comes afterwards finds all its room. */
static void expect_no_body_without_memory(uint32_t friction_torque, uint64_t calls)
{
    for (uint64_t k = 1; k <= calls; k++) {
        small s;
        small_begin_scene(&s);
        s.thread.torsional_stiffness = friction_torque != 0 ? 1e-8 : 0.0;
        s.thread.friction_torque = friction_torque;
        vbss_thread *thread;
        uint32_t body = 77, other = 77;
        s.thread.segment_count = 5;
        expect_ok(vbss_thread_create(s.context, &s.thread, &thread));
        s.rigid.capsules = &ball;
        s.rigid.capsule_count = 1;
        uint64_t hash = small_hash(&s);
        s.memory.fail_call = s.memory.calls + k;
        vbss_result result = vbss_scene_add_thread(s.scene, thread, &body);
        vbss_result second = vbss_scene_add_rigid(s.scene, &s.rigid, &other);
        bool failed = s.memory.failures > 0;
        s.memory.fail_call = 0;
        assert_int_equal(failed,
                         result == VBSS_ERROR_OUT_OF_MEMORY || second == VBSS_ERROR_OUT_OF_MEMORY);
        if (result != VBSS_OK && second != VBSS_OK) {
            assert_true(small_hash(&s) == hash);
        }
        assert_true((result == VBSS_OK) == (body != 77));
        assert_true((second == VBSS_OK) == (other != 77));
        if (result != VBSS_OK) {
            expect_ok(vbss_thread_step(thread, 1e-3)); /* still the host's */
            expect_ok(vbss_scene_add_thread(s.scene, thread, &body));
        }
        if (second != VBSS_OK) {
            expect_ok(vbss_scene_add_rigid(s.scene, &s.rigid, &other));
        }
        small_steps(&s, 3, 1e-3);
        small_end(&s);
    }
}

static void body_without_memory_is_not_added(void **state)
{
    (void)state;
    expect_no_body_without_memory(0, 12);
}

/* The first thread with friction torque makes the scene's system larger. */
static void thread_with_friction_torque_needs_memory_of_its_scene(void **state)
{
    (void)state;
    expect_no_body_without_memory(1, 70);
}

/* ---- what there is room for */

typedef struct crowd {
    small s;
    uint64_t hash;
} crowd;

/* A thread above a floor, a tool that comes, a thread pinned to it: nothing touches yet, all will. */
static void begin_crowd(crowd *c, uint32_t contacts, uint32_t candidates)
{
    small *s = &c->s;
    small_begin(s);
    s->config.floor = 1;
    s->config.contact_capacity = contacts;
    s->config.candidate_capacity = candidates;
    small_create(s);
    s->thread.gravity[1] = -9.81;
    small_thread(s, vec3_make(0.0, 5e-3, 0.0), vec3_make(0.02, 5e-3, 0.0), 20, NULL);
    uint32_t tool = small_stick(s, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.01, 8e-3, 0.0),
                                vec3_make(0.0, 0.0, 3e-3), 1e-3);
    uint32_t line =
        small_thread(s, vec3_make(0.01, 8e-3, 3e-3), vec3_make(0.01, 8e-3, 0.01), 8, NULL);
    small_pin(s, line, 0, tool);
}

/* Steps until one has no room; that has changed nothing, nor has the same step again. */
static uint32_t crowd_steps(crowd *c)
{
    for (uint32_t i = 0; i < 80; i++) {
        small_move(&c->s, 2, vec3_make(0.01, 8e-3 - 1e-4 * i, 0.0));
        c->hash = small_hash(&c->s);
        vbss_result result = vbss_scene_step(c->s.scene, 1e-3);
        if (result != VBSS_OK) {
            expect_result(VBSS_ERROR_CAPACITY, result);
            assert_true(small_hash(&c->s) == c->hash);
            expect_result(VBSS_ERROR_CAPACITY, vbss_scene_step(c->s.scene, 1e-3));
            assert_true(small_hash(&c->s) == c->hash);
            return i;
        }
    }
    return 80;
}

static void step_without_capacity_changes_nothing(void **state)
{
    (void)state;
    const uint32_t contacts[] = {0, 1, 5, 12, 16}, candidates[] = {0, 1, 2, 3};
    for (int k = 0; k < 9; k++) {
        crowd c;
        begin_crowd(&c, k < 5 ? contacts[k] : 256, k < 5 ? 4096 : candidates[k - 5]);
        assert_true(crowd_steps(&c) < 80);
        /* Without what crowds it, it goes on. */
        expect_ok(vbss_scene_remove(c.s.scene, 1));
        expect_ok(vbss_scene_remove(c.s.scene, 3));
        small_move(&c.s, 2, vec3_make(0.01, 8e-3, 0.0));
        small_steps(&c.s, 2, 1e-3);
        small_end(&c.s);
    }
    crowd enough;
    begin_crowd(&enough, 256, 4096);
    assert_int_equal(crowd_steps(&enough), 80);
    small_end(&enough.s);
}

/* Also when parts of the step were made before: a thread flies at the floor, halved on the way. */
static void step_failing_midway_changes_nothing(void **state)
{
    (void)state;
    uint32_t in_the_middle = 0;
    for (uint32_t contacts = 1; contacts < 40; contacts++) {
        small s;
        vbss_thread *thread;
        double v[63] = {0.0};
        small_begin(&s);
        s.config.floor = 1;
        s.config.mode = VBSS_SCENE_MODE_OFFLINE;
        s.config.contact_capacity = contacts;
        small_create(&s);
        small_thread(&s, vec3_make(0.0, 0.012, 0.0), vec3_make(0.02, 0.002, 0.0), 20, &thread);
        for (int i = 0; i < 21; i++) {
            v[3 * i + 1] = -5.0 - 0.5 * i;
        }
        expect_ok(vbss_thread_set_state(thread, NULL, v, 21));
        for (int i = 0; i < 10; i++) {
            uint64_t hash = small_hash(&s);
            if (vbss_scene_step(s.scene, 1e-3) != VBSS_OK) {
                scene_object *object = small_object(&s);
                assert_true(small_hash(&s) == hash);
                /* What is left behind of the attempts shows how far it came. */
                double end = object->bodies[0].thread.substep.end_fraction;
                in_the_middle += end > 0.0 && end < 1.0;
                break;
            }
        }
        small_end(&s);
    }
    assert_true(in_the_middle > 0);
}

static void scene_churn_does_not_grow_memory(void **state)
{
    (void)state;
    small s;
    uint64_t blocks = 0;
    vbss_thread *thread;
    small_begin(&s);
    expect_ok(vbss_thread_create(s.context, &s.thread, &thread));
    for (int i = 0; i < 12; i++) {
        uint32_t body;
        small_create(&s);
        expect_ok(vbss_scene_add_thread(s.scene, thread, &body));
        small_capsule(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_zero(), vec3_zero(), 1e-3);
        expect_ok(vbss_scene_destroy(s.scene));
        blocks = i == 0 ? s.memory.blocks : blocks;
        assert_int_equal(s.memory.blocks, blocks);
    }
    small_end(&s);
}

/* Numbers are never used again, places are. */
static void removed_bodies_free_capacity(void **state)
{
    (void)state;
    small s;
    small_begin(&s);
    s.config.rigid_capacity = 2;
    s.config.capsule_capacity = 2;
    s.config.thread_capacity = 1;
    s.config.node_capacity = 6;
    small_create(&s);
    uint32_t last = 0;
    for (int i = 0; i < 50; i++) {
        vbss_thread *thread;
        uint32_t refused;
        vec3 high = vec3_make(0.0, 0.01, 0.0);
        uint32_t a = small_capsule(&s, VBSS_SCENE_RIGID_FREE, high, high, 1e-3);
        uint32_t t = small_thread(&s, vec3_zero(), vec3_make(0.01, 0.0, 0.0), 5, &thread);
        uint32_t b = small_capsule(&s, VBSS_SCENE_RIGID_DRIVEN, vec3_scale(high, 2.0), high, 1e-3);
        assert_true(last < a && a < t && t < b);
        last = b;
        expect_result(VBSS_ERROR_CAPACITY, scene_build_capsule(s.scene, &s.rigid, ball, &refused));
        small_steps(&s, 1, 1e-3);
        expect_ok(vbss_scene_remove(s.scene, i % 2 == 0 ? a : b));
        expect_ok(vbss_scene_remove(s.scene, t));
        small_steps(&s, 1, 1e-3);
        expect_ok(vbss_scene_remove(s.scene, i % 2 == 0 ? b : a));
        expect_result(VBSS_ERROR_NOT_FOUND, vbss_scene_remove(s.scene, a));
        expect_ok(vbss_thread_destroy(thread));
    }
    small_end(&s);
}

int test_scene_memory(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(body_without_memory_is_not_added),
        cmocka_unit_test(thread_with_friction_torque_needs_memory_of_its_scene),
        cmocka_unit_test(step_without_capacity_changes_nothing),
        cmocka_unit_test(step_failing_midway_changes_nothing),
        cmocka_unit_test(scene_churn_does_not_grow_memory),
        cmocka_unit_test(removed_bodies_free_capacity),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
