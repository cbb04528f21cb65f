/* Drains in scenes of method PAPER: what a stepped body promises, and that the drain is the one that is stepped alone. */
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
        c.paper_damping = 0.1;
        begin(&s);
        make(&s);
        lay_over(&s, 0.05);
        add_capsule(s.scene, VBSS_RIGID_DRIVEN, vec3_make(0.1, 0, 0), vec3_make(0.1, 0.1, 0), 2e-3);
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
    c.method = VBSS_METHOD_OURS;
    expect_ok(vbss_drain_create(s.context, &c, &ours));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_scene_add_drain(s.scene, ours, &body));
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
        expect_ok(vbss_scene_move_rigid(s.scene, tool, into, NULL));
        if (k == 2) { /* no call gives it that */
            d.object->v[8] = vec3_make(1e60, 0, 0);
        }
        expect_undone(&s, &d, k < 2 ? VBSS_ERROR_CAPACITY : VBSS_ERROR_NOT_FINITE);
        expect_undone(&s, &d, k < 2 ? VBSS_ERROR_CAPACITY : VBSS_ERROR_NOT_FINITE);
        into[2] = 0.02;
        d.object->v[8] = vec3_zero();
        expect_ok(vbss_scene_move_rigid(s.scene, tool, into, NULL));
        expect_ok(vbss_scene_step(s.scene, 1e-3));
        end(&s);
    }
}

/* ---- the promises of a stepped body: a tool goes in and out at the side, a thread lies across */

static vbss_result create_poked(vbss_context *context, void *user, void **handle)
{
    (void)user;
    vbss_scene_config c;
    vbss_scene *scene = NULL;
    vbss_thread *thread;
    vbss_drain *drain;
    uint32_t body, id;
    expect_ok(vbss_scene_config_init(&c, sizeof c));
    c.method = VBSS_METHOD_PAPER;
    c.floor = 1;
    c.floor_height = -6.8e-3;
    expect_ok(vbss_scene_create(context, &c, &scene));
    add_capsule(scene, VBSS_RIGID_COUPLED, vec3_zero(), vec3_make(0, 0, 0.05), 2e-3);
    vbss_drain_config d = paper_drain();
    d.gravity[1] = -9.81;
    expect_ok(vbss_drain_create(context, &d, &drain));
    expect_ok(vbss_scene_add_drain(scene, drain, &body));
    vbss_drain_attachment a;
    expect_ok(vbss_drain_attachment_init(&a, sizeof a));
    a.node = 3;
    a.position[1] = 7e-3;
    expect_ok(vbss_drain_attach(drain, &a, &id));
    vbss_thread_config t = paper_thread(12);
    const double start[3] = {3e-3, 7.3e-3, -0.02}, way[3] = {0.0, 0.0, 1.0};
    memcpy(t.start, start, sizeof start);
    memcpy(t.direction, way, sizeof way);
    t.length = 0.04;
    expect_ok(vbss_thread_create(context, &t, &thread));
    expect_ok(vbss_scene_add_thread(scene, thread, &body));
    *handle = scene;
    return VBSS_OK;
}

static vbss_result step_poked(void *handle)
{
    vbss_scene_statistics t;
    expect_ok(vbss_scene_get_statistics(handle, &t, sizeof t));
    double way = 1e-4 * (double)(t.steps % 40);
    const double to[3] = {way, 0.2 * way, 0.0095 - way};
    expect_ok(vbss_scene_move_rigid(handle, 1, to, NULL));
    return vbss_scene_step(handle, 1e-3);
}

static vbss_result destroy_poked(void *handle)
{
    return vbss_scene_destroy(handle);
}

static const harness_body poked = {"poked paper drain", &vbss_scene_kind, create_poked, NULL,
                                   step_poked,          destroy_poked,    NULL};

static void step_does_not_allocate_and_restores_bit_equal(void **state)
{
    (void)state;
    assert_int_equal(0, harness_step_allocations(&poked, 60));
    harness_save_restore_continue(&poked, 30, 40);
    harness_refuses_bad_snapshots(&poked, 30);
}

static void runs_are_bit_equal(void **state)
{
    (void)state;
    expect_runs_alike(&poked, 400);
}

int test_paper_drain_promises(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(contact_free_drain_equals_standalone),
        harness_test(drain_belongs_to_scene_until_removed),
        harness_test(spring_force_is_reported_after_response),
        harness_test(failed_step_changes_nothing),
        harness_test(step_does_not_allocate_and_restores_bit_equal),
        harness_test(runs_are_bit_equal),
    };
    return cmocka_run_group_tests_name("scene.paper_drain_promises", tests, NULL, NULL);
}
