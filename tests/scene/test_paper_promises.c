/* Method PAPER of scenes: what fails is undone, what is told is told, and what a stepped body promises. */
#include "scene/paper_stage.h"

/* ---- failing */

static void expect_undone(stage *s, vbss_result wanted)
{
    uint64_t before = hash_of(s->scene);
    expect_result(wanted, vbss_scene_step(s->scene, 1e-3));
    assert_int_equal(before, hash_of(s->scene));
}

static void failed_step_is_undone(void **state)
{
    (void)state;
    for (int k = 0; k < 3; k++) {
        stage s;
        begin(&s);
        s.config.floor = 1;
        s.config.contact_capacity = k == 0 ? 2 : 1024;
        s.config.candidate_capacity = k == 1 ? 1 : 16384;
        make(&s);
        if (k < 2) { /* that many segments lie along it */
            add_capsule(s.scene, VBSS_RIGID_DRIVEN, vec3_make(-0.02, 0.004, 0),
                        vec3_make(0.02, 0.004, 0), 1e-3);
        }
        lay_over(&s, 0.01);
        vbss_result result = VBSS_OK;
        if (k == 2) {
            thread_object *t;
            expect_ok(vbss_thread_open(s.threads[0], &t));
            t->now.v[8] = vec3_make(1e40, 0, 0); /* no call gives it that */
        }
        uint64_t before = 0;
        for (int i = 0; i < 400 && result == VBSS_OK; i++) {
            before = hash_of(s.scene);
            result = vbss_scene_step(s.scene, 1e-3);
        }
        expect_result(k < 2 ? VBSS_ERROR_CAPACITY : VBSS_ERROR_NOT_FINITE, result);
        assert_int_equal(before, hash_of(s.scene));
        expect_undone(&s, result);
        end(&s);
    }
}

static void options_of_other_method_are_rejected(void **state)
{
    (void)state;
    stage s;
    uint32_t body;
    begin(&s);
    for (int k = 0; k < 5; k++) {
        vbss_scene_config bad = s.config;
        bad.paper_pass_limit = k == 0 ? 0 : k == 1 ? 1001 : 4;
        bad.paper_thickness = k == 2   ? -1e-9
                              : k == 3 ? 0.02
                              : k == 4 ? harness_bad_numbers[0]
                                       : 0.0;
        expect_result(k == 4 ? VBSS_ERROR_NOT_FINITE : VBSS_ERROR_OUT_OF_RANGE,
                      vbss_scene_create(s.context, &bad, &s.scene));
    }
    make(&s);
    vbss_thread_config ours = paper_thread(4);
    ours.method = VBSS_METHOD_OURS;
    expect_ok(vbss_thread_create(s.context, &ours, &s.threads[0]));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_scene_add_thread(s.scene, s.threads[0], &body));
    lay_over(&s, 0.0);
    expect_result(VBSS_ERROR_IN_SCENE, vbss_thread_step(s.threads[0], 1e-3));
    for (int k = 0; k < 3; k++) {
        expect_result(VBSS_ERROR_NOT_FINITE, vbss_scene_step(s.scene, harness_bad_numbers[k]));
    }
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_scene_step(s.scene, 0.2));
    end(&s);
}

/* ---- the promises of a stepped body */

static vbss_result create_heap(vbss_context *context, void *user, void **handle)
{
    (void)user;
    vbss_scene_config c;
    vbss_scene *scene = NULL;
    uint32_t body, pin;
    expect_ok(vbss_scene_config_init(&c, sizeof c));
    c.method = VBSS_METHOD_PAPER;
    c.floor = 1;
    c.floor_height = -0.01;
    expect_ok(vbss_scene_create(context, &c, &scene));
    uint32_t tool =
        add_capsule(scene, VBSS_RIGID_COUPLED, vec3_make(0, 0, -0.02), vec3_make(0, 0, 0.02), 2e-3);
    for (int k = 0; k < 2; k++) {
        vbss_thread_config t = paper_thread(12);
        vbss_thread *thread;
        const double start[3] = {-0.02, 0.003 + 0.002 * k, 0.001 * k}, way[3] = {1.0, 0.0, 0.2 * k};
        memcpy(t.start, start, sizeof start);
        memcpy(t.direction, way, sizeof way);
        t.length = 0.05;
        expect_ok(vbss_thread_create(context, &t, &thread));
        expect_ok(vbss_scene_add_thread(scene, thread, &body));
    }
    expect_ok(vbss_scene_pin_thread(scene, body, 12, tool, NULL, &pin));
    *handle = scene;
    return VBSS_OK;
}

static vbss_result step_heap(void *handle)
{
    vbss_scene_statistics t;
    expect_ok(vbss_scene_get_statistics(handle, &t, sizeof t));
    double along = 1e-4 * (double)t.steps;
    const double to[3] = {along, 0.3 * along, 0.0}, turn[4] = {1.0, 0.0, 10.0 * along, 0.0};
    expect_ok(vbss_scene_move_rigid(handle, 1, to, turn));
    return vbss_scene_step(handle, FRAME);
}

static vbss_result destroy_heap(void *handle)
{
    return vbss_scene_destroy(handle);
}

static const harness_body heap = {"paper scene", &vbss_scene_kind, create_heap, NULL,
                                  step_heap,     destroy_heap,     NULL};

static void step_does_not_allocate_and_restores_bit_equal(void **state)
{
    (void)state;
    assert_int_equal(0, harness_step_allocations(&heap, 60));
    harness_save_restore_continue(&heap, 40, 40);
    harness_refuses_bad_snapshots(&heap, 40);
}

static void runs_are_bit_equal(void **state)
{
    (void)state;
    expect_runs_alike(&heap, 100);
}

int test_paper_promises(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(failed_step_is_undone),
        harness_test(options_of_other_method_are_rejected),
        harness_test(step_does_not_allocate_and_restores_bit_equal),
        harness_test(runs_are_bit_equal),
    };
    return cmocka_run_group_tests_name("scene.paper_promises", tests, NULL, NULL);
}
