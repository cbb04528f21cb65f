/* Method VBLAST of scenes: a step that fails is undone, and options of the other method are rejected. */
#include "fixtures/baseline_of.h"
#include "scene/paper_fixture.h"

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
            add_capsule(s.scene, VBSS_SCENE_RIGID_DRIVEN, vec3_make(-0.02, 0.004, 0),
                        vec3_make(0.02, 0.004, 0), 1e-3);
        }
        place_over(&s, 0.01);
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

/* Springs that four substeps cannot carry: the thread is far from diverging at first, and nothing of the step that
 * diverges stays. */
static void diverged_thread_fails_step_and_changes_nothing(void **state)
{
    (void)state;
    stage s;
    begin(&s);
    make(&s);
    vbss_thread_config c = paper_thread(SEGMENTS);
    baseline_of(&c.baseline)->thread_stiffness = 100.0;
    baseline_of(&c.baseline)->thread_substeps = 4;
    add(&s, 0, &c);
    hands h = hold_ends(&s, 0);
    vbss_result result = VBSS_OK;
    uint64_t before = 0;
    for (int i = 1; i <= 1000 && result == VBSS_OK; i++) {
        double target[3];
        uint32_t n;
        vec3_store(target, vec3_add(h.at[1], vec3_make(vbss_min(1e-4 * i, 0.01), 0.0, 0.0)));
        expect_ok(vbss_thread_set_attachment_target(s.threads[0], h.ids[1], target, NULL));
        before = hash_of(s.scene);
        result = vbss_scene_step(s.scene, 1e-3);
        const vec3 *x = places(s.threads[0], &n);
        for (uint32_t k = 0; k < n; k++) {
            assert_true(vec3_norm(x[k]) < 100.0 * (0.15 + 0.16) * NODES);
        }
    }
    const char *text;
    expect_result(VBSS_ERROR_NOT_FINITE, result);
    expect_ok(vbss_context_get_last_error(s.context, NULL, &text));
    assert_non_null(strstr(text, "the explicit method has diverged"));
    assert_int_equal(before, hash_of(s.scene));
    expect_undone(&s, result);
    end(&s);
}

static void options_of_other_method_are_rejected(void **state)
{
    (void)state;
    stage s;
    uint32_t body;
    begin(&s);
    for (int k = 0; k < 5; k++) {
        vbss_scene_config bad = s.config;
        baseline_of(&bad.baseline)->scene_pass_limit = k == 0 ? 0 : k == 1 ? 1001 : 4;
        baseline_of(&bad.baseline)->scene_thickness = k == 2   ? -1e-9
                                                      : k == 3 ? 0.02
                                                      : k == 4 ? harness_bad_numbers[0]
                                                               : 0.0;
        expect_result(k == 4 ? VBSS_ERROR_NOT_FINITE : VBSS_ERROR_OUT_OF_RANGE,
                      vbss_scene_create(s.context, &bad, &s.scene));
    }
    make(&s);
    vbss_thread_config ours = paper_thread(4);
    ours.method = VBSS_METHOD_IMPLICIT;
    expect_ok(vbss_thread_create(s.context, &ours, &s.threads[0]));
    expect_result(VBSS_ERROR_INCOMPATIBLE, vbss_scene_add_thread(s.scene, s.threads[0], &body));
    place_over(&s, 0.0);
    expect_result(VBSS_ERROR_IN_SCENE, vbss_thread_step(s.threads[0], 1e-3));
    for (int k = 0; k < 3; k++) {
        expect_result(VBSS_ERROR_NOT_FINITE, vbss_scene_step(s.scene, harness_bad_numbers[k]));
    }
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_scene_step(s.scene, 0.2));
    end(&s);
}

int test_paper_rollback(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(failed_step_is_undone),
        harness_test(diverged_thread_fails_step_and_changes_nothing),
        harness_test(options_of_other_method_are_rejected),
    };
    return cmocka_run_group_tests_name("scene.paper_rollback", tests, NULL, NULL);
}
