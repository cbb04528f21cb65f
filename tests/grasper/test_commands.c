/* What a grasper is told and what it shows of it; what it refuses leaves it as it was. */
#include "fixture.h"

static void move_sets_pose(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    vbss_grasper *grasper = make(&f);
    const double position[3] = {0.1, -0.2, 0.3}, orientation[4] = {0.0, 0.0, 3e99, 3e99};
    uint64_t generation = inside(grasper)->generation;
    expect_ok(vbss_grasper_set_target(grasper, position, orientation));
    assert_true(inside(grasper)->generation > generation);
    vbss_grasper_state s = get_state(grasper);
    for (int i = 0; i < 3; i++) {
        expect_same_bits(position[i], s.position[i]);
        expect_same_bits(position[i], s.target_position[i]);
        expect_same_bits(0.0, s.velocity[i]);
        expect_same_bits(0.0, s.hand_force[i]);
    }
    for (int i = 0; i < 4; i++) {
        expect_near(i < 2 ? 0.0 : sqrt(0.5), s.orientation[i], 1e-15);
        expect_same_bits(s.orientation[i], s.target_orientation[i]);
    }
    assert_int_equal(s.struct_size, sizeof s);
    assert_int_equal(s.body, 0);
    /* only the place */
    const double there[3] = {-1e3, 1e3, 0.0};
    expect_ok(vbss_grasper_set_target(grasper, there, NULL));
    vbss_grasper_state later = get_state(grasper);
    assert_memory_equal(s.orientation, later.orientation, sizeof s.orientation);
    expect_same_bits(-1e3, later.position[0]);
    end(&f);
}

static void handle_and_exchange_apply_in_next_step(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    vbss_grasper *grasper = make(&f);
    grasper_object *g = inside(grasper);
    uint64_t generation = g->generation;
    expect_ok(vbss_grasper_set_opening(grasper, 0.25));
    assert_true(g->generation > generation);
    generation = g->generation;
    expect_ok(vbss_grasper_exchange(grasper, VBSS_GRASPER_KIND_SHEARS));
    assert_true(g->generation > generation);
    vbss_grasper_state s = get_state(grasper);
    expect_same_bits(0.25, s.opening);
    expect_same_bits(f.config.driver_opening, s.jaw_angle);
    assert_int_equal(s.kind, VBSS_GRASPER_KIND_NEEDLE_DRIVER);
    assert_int_equal(g->commanded_kind, VBSS_GRASPER_KIND_SHEARS);
    /* told to be what it is, it forgets the exchange */
    expect_ok(vbss_grasper_exchange(grasper, VBSS_GRASPER_KIND_NEEDLE_DRIVER));
    assert_int_equal(g->commanded_kind, g->kind);
    end(&f);
}

/* ---- in a scene, as far as a grasper knows */

static void move_in_scene_is_deferred(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    vbss_grasper *grasper = make(&f);
    grasper_object *g = inside(grasper);
    vbss_slot *slot;
    expect_ok(vbss_slot_open(grasper, &vbss_grasper_kind_of_slot, &slot));
    slot->owner = &f;
    g->body_id = 7;
    g->grasp_count = 2;
    g->jaw_force = 3.0;
    g->velocity = vec3_make(1.0, 2.0, 3.0);
    g->hand_force = vec3_make(4.0, 5.0, 6.0);
    expect_ok(move_to(grasper, vec3_make(0.5, 0.0, 0.0), quat_make(0.0, 1.0, 0.0, 0.0)));
    expect_result(VBSS_ERROR_IN_SCENE, vbss_grasper_destroy(grasper));
    expect_ok(vbss_grasper_discard(grasper)); /* the scene destroys it later */
    vbss_grasper_state s = get_state(grasper);
    assert_int_equal(s.body, 7);
    assert_int_equal(s.grasp_count, 2);
    expect_same_bits(0.0, s.position[0]);
    expect_same_bits(0.5, s.target_position[0]);
    expect_same_bits(1.0, s.orientation[0]);
    expect_same_bits(1.0, s.target_orientation[1]);
    expect_same_bits(3.0, s.pressure);
    expect_same_bits(2.0, s.velocity[1]);
    expect_same_bits(6.0, s.hand_force[2]);
    vbss_grasper_detach(g);
    slot->owner = NULL;
    s = get_state(grasper);
    assert_int_equal(s.body + s.grasp_count, 0);
    expect_same_bits(0.5, s.position[0]);
    expect_near(0.5, g->view_capsules[1][0] - f.config.driver_radius, 1e-15);
    expect_same_bits(0.0, s.pressure + s.velocity[1] + s.hand_force[2]);
    expect_ok(vbss_grasper_destroy(grasper));
    end(&f);
}

/* ---- the view */

static void view_shows_capsules(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    f.config.driver_bend = 0.4;
    vbss_grasper *grasper = make(&f);
    grasper_object *g = inside(grasper);
    grasper_capsule laid[GRASPER_CAPSULES];
    vbss_view view;
    expect_ok(move_to(grasper, vec3_make(0.1, 0.2, 0.3), quat_make(0.5, -0.1, 0.7, 0.2)));
    expect_ok(vbss_grasper_get_view(grasper, VBSS_GRASPER_VIEW_CAPSULES, &view, sizeof view));
    assert_int_equal(view.type, VBSS_VIEW_TYPE_F64);
    assert_int_equal(view.components, 7);
    assert_int_equal(view.stride_bytes, 7 * sizeof(double));
    assert_int_equal(view.count, GRASPER_CAPSULES);
    assert_true(view.generation == g->generation);
    vbss_grasper_compute_capsules(g, g->jaw_angle, laid);
    const double *shown = view.data;
    for (int i = 0; i < GRASPER_CAPSULES; i++, shown += 7) {
        expect_near_vec3(pose_apply(g->commanded_pose, laid[i].axis[0]), vec3_load(shown), 1e-15);
        expect_near_vec3(pose_apply(g->commanded_pose, laid[i].axis[1]), vec3_load(shown + 3),
                         1e-15);
        expect_same_bits(i == GRASPER_SHAFT  ? f.config.shaft_radius
                         : i == GRASPER_NECK ? f.config.neck_radius
                                             : f.config.driver_radius,
                         shown[6]);
    }
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_grasper_get_view(grasper, 1, &view, sizeof view));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_grasper_get_view(grasper, -1, &view, sizeof view));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_grasper_get_view(grasper, 0, NULL, sizeof view));
    expect_result(VBSS_ERROR_STRUCT_SIZE, vbss_grasper_get_view(grasper, 0, &view, 3));
    end(&f);
}

/* ---- what is refused */

static void bad_numbers_change_nothing(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    vbss_grasper *grasper = make(&f);
    vbss_grasper_state s;
    uint64_t hash = hash_of(grasper), generation = inside(grasper)->generation;
    double p[3] = {0.1, 0.1, 0.1}, q[4] = {1.0, 0.0, 0.0, 0.0};
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_grasper_set_target(grasper, NULL, q));
    for (int i = 0; i < 7; i++) {
        double *at = i < 3 ? &p[i] : &q[i - 3], kept = *at;
        for (int k = 0; k < 3; k++) {
            *at = harness_bad_numbers[k];
            expect_result(VBSS_ERROR_NOT_FINITE, vbss_grasper_set_target(grasper, p, q));
        }
        *at = i < 3 ? 1e3 * (1.0 + 1e-15) : 1.01e100;
        expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_grasper_set_target(grasper, p, q));
        *at = kept;
    }
    q[0] = 0.0;
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_grasper_set_target(grasper, p, q));
    for (int k = 0; k < 3; k++) {
        expect_result(VBSS_ERROR_NOT_FINITE,
                      vbss_grasper_set_opening(grasper, harness_bad_numbers[k]));
    }
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_grasper_set_opening(grasper, -1e-300));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_grasper_set_opening(grasper, 1.0 + DBL_EPSILON));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_grasper_exchange(grasper, 0));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_grasper_exchange(grasper, 3));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_grasper_exchange(grasper, INT32_MIN));
    expect_result(VBSS_ERROR_NULL_ARGUMENT, vbss_grasper_get_state(grasper, NULL, sizeof s));
    expect_result(VBSS_ERROR_STRUCT_SIZE, vbss_grasper_get_state(grasper, &s, 247));
    assert_true(hash_of(grasper) == hash);
    assert_true(inside(grasper)->generation == generation);
    end(&f);
}

int test_commands(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(move_sets_pose),
        harness_test(handle_and_exchange_apply_in_next_step),
        harness_test(move_in_scene_is_deferred),
        harness_test(view_shows_capsules),
        harness_test(bad_numbers_change_nothing),
    };
    return cmocka_run_group_tests_name("grasper.commands", tests, NULL, NULL);
}
