/* The shaft goes through its trocar, turned the shortest way from what was told. */
#include "base/rotation.h"
#include "fixture.h"

/* Of the trocar from the axis of the shaft, and how far it is up the shaft from the bend. */
static double off_the_shaft(const grasper_object *g, pose at, double *up)
{
    vec3 bend = vbss_grasper_bend_point(g);
    vec3 trocar = vec3_sub(pose_apply_inverse(at, vec3_load(g->config.trocar)), bend);
    *up = trocar.z;
    return sqrt(trocar.x * trocar.x + trocar.y * trocar.y);
}

static double angle_between(quat a, quat b)
{
    return vec3_norm(vbss_quat_to_rotation_vector(quat_mul(a, quat_conjugate(b))));
}

static void random_trocar(harness_source *source, vbss_grasper_config *c)
{
    c->has_trocar = 1;
    vec3_store(c->trocar, harness_draw_vec3(source, -0.3, 0.3));
    c->driver_bend = harness_draw_real(source, -1.5, 1.5);
    c->driver_length = harness_draw_real(source, 5e-3, 50e-3);
    c->driver_neck = harness_draw_real(source, 0.0, 20e-3);
}

/* Of all ways to the same axis the shortest turn has none of it about that axis. */
static void the_shaft_goes_through(harness_source *source, void *user)
{
    grasper_object g = {.kind = VBSS_GRASPER_KIND_NEEDLE_DRIVER};
    double *worst = user, up;
    random_trocar(source, &g.config);
    g.driver.length = g.config.driver_length;
    g.driver.bend = g.config.driver_bend;
    g.driver.neck = g.config.driver_neck;
    double to_bend = g.driver.length + g.driver.neck;
    pose reported = pose_make(harness_draw_vec3(source, -0.3, 0.3), quat_identity()), target;
    reported.orientation = harness_draw_unit_quat(source);
    vec3 to_trocar = vec3_sub(vec3_load(g.config.trocar), reported.position);
    double reach = fabs(to_bend * sin(g.driver.bend));
    if (vec3_norm(to_trocar) <= 1.01 * reach) {
        return;
    }
    assert_true(vbss_grasper_apply_trocar(&g, reported, &target));
    expect_near_vec3(reported.position, target.position, 0.0);
    expect_near(1.0, quat_dot(target.orientation, target.orientation), 1e-15);
    double off = off_the_shaft(&g, target, &up);
    *worst = vbss_max(*worst, off);
    expect_near(0.0, off, 1e-12);
    expect_near(vec3_norm(to_trocar) * vec3_norm(to_trocar),
                reach * reach +
                    (up + to_bend * cos(g.driver.bend)) * (up + to_bend * cos(g.driver.bend)),
                1e-12);
    /* the shaft lies toward the trocar, however the tool was told to lie */
    assert_true(up + g.driver.length * cos(g.driver.bend) > 0.0);
    vec3 turn = vbss_quat_to_rotation_vector(
        quat_mul(target.orientation, quat_conjugate(reported.orientation)));
    expect_near(0.0, vec3_dot(turn, to_trocar) / vec3_norm(to_trocar), 1e-12);
    /* a tool that lies right is not turned, to rounding */
    pose again;
    assert_true(vbss_grasper_apply_trocar(&g, target, &again));
    expect_near(0.0, angle_between(again.orientation, target.orientation), 1e-14);
}

static void shaft_passes_through_trocar(void **state)
{
    (void)state;
    double worst = 0.0;
    harness_property("the shaft goes through", 2000, the_shaft_goes_through, &worst);
    assert_true(worst > 0.0 && worst < 1e-14);
}

static void roll_matches_command(void **state)
{
    (void)state;
    grasper_object g = {.kind = VBSS_GRASPER_KIND_SHEARS};
    g.config.has_trocar = 1;
    g.config.trocar[2] = 0.2;
    g.shears.length = 15e-3;
    for (int i = -15; i <= 15; i++) { /* about the shaft, which lies right */
        pose reported = pose_identity(), target;
        reported.orientation = vbss_quat_from_rotation_vector(vec3_make(0.0, 0.0, 0.2 * i));
        assert_true(vbss_grasper_apply_trocar(&g, reported, &target));
        expect_near(0.0, angle_between(target.orientation, reported.orientation), 1e-14);
    }
}

static void inverted_tool_is_turned_over(void **state)
{
    (void)state;
    grasper_object g = {.kind = VBSS_GRASPER_KIND_NEEDLE_DRIVER};
    g.config.has_trocar = 1;
    vec3_store(g.config.trocar, vec3_make(0.05, -0.1, 0.15));
    g.driver.length = 13e-3;
    double up;
    for (int bent = 0; bent < 2; bent++) {
        g.driver.bend = 0.6 * bent;
        for (int k = -1; k < 18; k++) { /* nearer and nearer to opposite, then opposite */
            double tilt = k < 0 ? 0.0 : pow(10.0, -k);
            pose right, reported = pose_identity(), target;
            assert_true(vbss_grasper_apply_trocar(&g, reported, &right));
            vec3 axis = vec3_unit_or(vec3_load(g.config.trocar), vec3_zero());
            vec3 over = vec3_scale(vec3_any_normal(axis), 3.141592653589793 - tilt);
            reported.orientation =
                quat_mul(vbss_quat_from_rotation_vector(over), right.orientation);
            assert_true(vbss_grasper_apply_trocar(&g, reported, &target));
            expect_near(0.0, off_the_shaft(&g, target, &up), 1e-15);
            assert_true(up > 0.0);
            expect_near(3.141592653589793 - tilt,
                        angle_between(target.orientation, reported.orientation), 2e-8);
        }
    }
}

/* ---- too near */

static void pose_too_near_trocar_is_rejected_and_changes_nothing(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    f.config.has_trocar = 1;
    f.config.trocar[2] = 0.1;
    f.config.driver_bend = 0.5;
    vbss_grasper *grasper = make(&f);
    grasper_object *g = inside(grasper);
    double reach = vbss_grasper_jaw_frame(g).position.y;
    expect_near(13e-3 * sin(0.5), reach, 1e-17);
    uint64_t hash = hash_of(grasper), generation = g->generation;
    const double part[] = {0.0, 1e-9, 0.5, 1.0 - 1e-12};
    for (int i = 0; i < 4; i++) {
        vec3 at = vec3_make(0.0, part[i] * reach, 0.1);
        expect_result(VBSS_ERROR_OUT_OF_RANGE, move_to(grasper, at, quat_identity()));
    }
    assert_true(hash_of(grasper) == hash);
    assert_true(g->generation == generation);
    expect_ok(move_to(grasper, vec3_make(0.0, reach * (1.0 + 1e-6), 0.1), quat_identity()));
    double up;
    expect_near(0.0, off_the_shaft(g, g->tool_pose, &up), 1e-15);
    end(&f);
}

static void straight_jaws_may_approach_but_not_enter_trocar(void **state)
{
    (void)state;
    grasper_object g = {.kind = VBSS_GRASPER_KIND_NEEDLE_DRIVER};
    g.config.has_trocar = 1;
    g.driver.length = 13e-3;
    pose target, reported = pose_identity();
    assert_false(vbss_grasper_apply_trocar(&g, reported, &target));
    reported.position.x = 1e-320;
    assert_false(vbss_grasper_apply_trocar(&g, reported, &target));
    reported.position.x = 1e-13;
    assert_false(vbss_grasper_apply_trocar(&g, reported, &target));
    reported.position.x = 1e-9;
    assert_true(vbss_grasper_apply_trocar(&g, reported, &target));
    vec3 shaft = quat_rotate(target.orientation, vec3_make(0.0, 0.0, 1.0));
    expect_near_vec3(vec3_make(-1.0, 0.0, 0.0), shaft, 1e-15);
    reported.position.x = (double)NAN;
    assert_false(vbss_grasper_apply_trocar(&g, reported, &target));
}

static void grasper_created_in_trocar_is_aligned(void **state)
{
    (void)state;
    fixture f;
    begin(&f);
    f.config.has_trocar = 1;
    vbss_grasper_state s = get_state(make(&f));
    expect_same_bits(1.0, s.orientation[0]);
    expect_same_bits(1.0, s.target_orientation[0]);
    end(&f);
}

int test_trocar(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(shaft_passes_through_trocar),
        harness_test(roll_matches_command),
        harness_test(inverted_tool_is_turned_over),
        harness_test(pose_too_near_trocar_is_rejected_and_changes_nothing),
        harness_test(straight_jaws_may_approach_but_not_enter_trocar),
        harness_test(grasper_created_in_trocar_is_aligned),
    };
    return cmocka_run_group_tests_name("grasper.trocar", tests, NULL, NULL);
}
