/* Drains in scenes of method VBLAST: equal to a drain alone without contact, owned by the scene, unchanged by a step that fails. */
#include "fixtures/baseline_of.h"
#include "scene/paper_drains.h"

static uint64_t drain_hash(vbss_drain *drain)
{
    uint64_t hash;
    expect_ok(vbss_drain_get_hash(drain, &hash));
    return hash;
}

/* ---- without contact */

static void attach_all_kinds(const stage_drain *d)
{
    vec3 away = vec3_add(d->object->x[7], vec3_make(1e-3, 2e-3, 0));
    attach(d, VBSS_DRAIN_ATTACHMENT_PIN, 7, away);
    attach(d, VBSS_DRAIN_ATTACHMENT_SPRING, 30, away);
    attach(d, VBSS_DRAIN_ATTACHMENT_FORCE, SIDE_NODE, vec3_make(0.02, -0.05, 0.11));
}

/* To the bit, counters and forces of attachments included. A thread falls beside it, a tool stands by. */
static void contact_free_drain_equals_standalone(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        const double h = k == 0 ? 1e-3 : FRAME;
        stage s;
        stage_drain d, alone = {NULL, NULL, 0};
        vbss_drain_config c = paper_drain();
        c.gravity[1] = -9.81;
        baseline_of(&c.baseline)->drain_damping = 0.1;
        begin(&s);
        make(&s);
        place_over(&s, 0.05);
        add_capsule(s.scene, VBSS_SCENE_RIGID_DRIVEN, vec3_make(0.1, 0, 0), vec3_make(0.1, 0.1, 0),
                    2e-3);
        d = add_drain(&s, &c);
        expect_ok(vbss_drain_create(s.context, &c, &alone.drain));
        expect_ok(vbss_drain_open(alone.drain, &alone.object));
        attach_all_kinds(&d);
        attach_all_kinds(&alone);
        for (int i = 0; i < 10; i++) {
            expect_ok(vbss_scene_step(s.scene, h));
            expect_ok(vbss_drain_step(alone.drain, h));
            assert_int_equal(drain_hash(alone.drain), drain_hash(d.drain));
        }
        assert_int_equal(0, statistics_of(&s).contacts);
        end(&s);
    }
}

/* The scene's rules while it is there, its own afterwards. */
static void drain_belongs_to_scene_until_removed(void **state)
{
    (void)state;
    stage s;
    uint32_t body;
    vbss_drain *ours;
    stage_drain d = begin_with_drain(&s);
    vbss_drain_config c = paper_drain();
    expect_result(VBSS_ERROR_IN_SCENE, vbss_drain_step(d.drain, 1e-3));
    expect_result(VBSS_ERROR_IN_SCENE, vbss_scene_add_drain(s.scene, d.drain, &body));
    wait_for(&s, 3);
    expect_ok(vbss_scene_remove(s.scene, d.body));
    expect_ok(vbss_drain_step(d.drain, 1e-3));
    c.method = VBSS_METHOD_IMPLICIT;
    expect_ok(vbss_drain_create(s.context, &c, &ours));
    expect_result(VBSS_ERROR_INCOMPATIBLE, vbss_scene_add_drain(s.scene, ours, &body));
    expect_ok(vbss_scene_add_drain(s.scene, d.drain, &body));
    wait_for(&s, 3);
    end(&s);
}

/* A spring pulls with what it is stretched by where the tool has left its particle. */
static void spring_force_is_reported_after_response(void **state)
{
    (void)state;
    stage s;
    double force[3];
    stage_drain d = begin_with_drain(&s);
    vec3 hook = vec3_add(d.object->x[SIDE_NODE], vec3_make(0, 0, 2e-3));
    uint32_t spring = attach(&d, VBSS_DRAIN_ATTACHMENT_SPRING, SIDE_NODE, hook);
    uint32_t tool = add_tool(&s, vec3_make(0, 0, 0.011), vec3_make(0, 0, 0.06), 2.5e-3);
    travel(&s, tool, vec3_make(0, 0, 0.011), vec3_make(0, 0, 0.009), 100);
    expect_ok(vbss_drain_get_reaction(d.drain, spring, force));
    expect_near(200.0 * (hook.z - d.object->x[SIDE_NODE].z), force[2], 1e-12);
    assert_true(statistics_of(&s).contacts > 0 && force[2] > 0.4);
    end(&s);
}

/* ---- failing */

static void expect_undone(stage *s, const stage_drain *d, vbss_result wanted)
{
    uint64_t before = hash_of(s->scene);
    vec3 x[DRAIN_NODES];
    memcpy(x, d->object->x, sizeof x);
    expect_result(wanted, vbss_scene_step(s->scene, 1e-3));
    assert_int_equal(before, hash_of(s->scene));
    assert_memory_equal(x, d->object->x, sizeof x);
}

static void failed_step_changes_nothing(void **state)
{
    (void)state;
    for (int k = 0; k < 3; k++) {
        stage s;
        vbss_drain_config c = paper_drain();
        begin(&s);
        s.config.contact_capacity = k == 0 ? 2 : 1024;
        s.config.candidate_capacity = k == 1 ? 8 : 16384;
        make(&s);
        stage_drain d = add_drain(&s, &c);
        attach_all_kinds(&d);
        uint32_t tool = add_tool(&s, vec3_make(-5e-3, 0, 0.02), vec3_make(10e-3, 0, 0), 1e-3);
        double into[3] = {-5e-3, 0.0, k < 2 ? 5e-3 : 0.02};
        expect_ok(vbss_scene_set_rigid_target(s.scene, tool, into, NULL));
        if (k == 2) { /* no call gives it that */
            d.object->v[8] = vec3_make(1e60, 0, 0);
        }
        expect_undone(&s, &d, k < 2 ? VBSS_ERROR_CAPACITY : VBSS_ERROR_NOT_FINITE);
        expect_undone(&s, &d, k < 2 ? VBSS_ERROR_CAPACITY : VBSS_ERROR_NOT_FINITE);
        into[2] = 0.02;
        d.object->v[8] = vec3_zero();
        expect_ok(vbss_scene_set_rigid_target(s.scene, tool, into, NULL));
        expect_ok(vbss_scene_step(s.scene, 1e-3));
        end(&s);
    }
}

int test_paper_drain_rules(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(contact_free_drain_equals_standalone),
        harness_test(drain_belongs_to_scene_until_removed),
        harness_test(spring_force_is_reported_after_response),
        harness_test(failed_step_changes_nothing),
    };
    return cmocka_run_group_tests_name("scene.paper_drain_rules", tests, NULL, NULL);
}
