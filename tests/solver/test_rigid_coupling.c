#include <math.h>

#include "base/rotation.h"
#include "solver/rigid_rig.h"

static rigid_rig rig;

static void begin_tied(double stiffness, double damping)
{
    rigid_rig_begin(&rig, VBSS_ROLE_INTERIOR);
    rig.body.coupling = (vbss_rigid_coupling){stiffness, damping, 1e-3 * stiffness, 1e-3 * damping};
    pose at = {vec3_make(0.1, -0.2, 0.3),
               vbss_quat_from_rotation_vector(vec3_make(0.5, 0.6, -0.7))};
    rigid_rig_place(&rig, at);
}

/* How far the body is from the given pose; the turn is short. */
static vec3 lag(void)
{
    return vec3_sub(rig.body.target_end.position, rig.body.now.pose.position);
}

static vec3 turning_lag(void)
{
    quat q =
        quat_mul(rig.body.target_end.orientation, quat_conjugate(rig.body.now.pose.orientation));
    return vbss_quat_to_rotation_vector(q);
}

/* ---- at rest */

static void spring_carries_force_and_torque(void **state)
{
    (void)state;
    begin_tied(200.0, 5.0);
    rig.force = vec3_make(1.0, -2.0, 0.5);
    rig.torque = vec3_make(0.05, 0.08, -0.1);
    rigid_rig_steps(&rig, 3000);
    expect_near(0.0, vec3_norm(vec3_add_scaled(lag(), 1.0 / 200.0, rig.force)), 1e-14);
    expect_near(0.0, vec3_norm(vec3_add_scaled(turning_lag(), 1.0 / 0.2, rig.torque)), 1e-13);
    vbss_rigid_wrench pull = vbss_rigid_coupling_wrench(&rig.body, &rig.part, &rig.body.now);
    expect_near(0.0, vec3_norm(vec3_add(pull.force, rig.force)), 1e-11);
    expect_near(0.0, vec3_norm(vec3_add(pull.torque, rig.torque)), 1e-12);
    rigid_rig_end(&rig);
}

/* What is told to have acted is what changed the motion. */
static void impulse_equals_momentum_change(void **state)
{
    (void)state;
    begin_tied(300.0, 2.0);
    rig.rounds = 8;
    rig.body.now.v = vec3_make(0.1, 0.2, -0.3);
    rig.body.now.w = vec3_make(8.0, -6.0, 7.0);
    pose end = rig.body.target_end;
    for (int i = 0; i < 50; i++) {
        end.position.x += 1e-3;
        end.orientation = quat_mul(vbss_quat_from_rotation_vector(vec3_make(0.004, 0.003, -0.002)),
                                   end.orientation);
        rigid_rig_step(&rig, end);
        vbss_rigid_wrench pull = vbss_rigid_coupling_wrench(&rig.body, &rig.part, &rig.body.now);
        vec3 gained = vec3_sub(rig.body.now.v, rig.predicted.v);
        vec3 spun = vec3_sub(rig.body.now.w, rig.predicted.w);
        mat3 inertia = vbss_rigid_world_inertia(&rig.body, rig.predicted.pose.orientation);
        vec3 torque = vec3_scale(mat3_mul_vec3(inertia, spun), 1.0 / rig.h);
        expect_near(0.0, vec3_distance(pull.force, vec3_scale(gained, rig.body.mass / rig.h)),
                    1e-9);
        expect_near(0.0, vec3_distance(pull.torque, torque), 1e-10);
    }
    rigid_rig_end(&rig);
}

/* ---- let go beside the given pose: m x'' + c x' + k x = 0 */

static double damped_swing(double mass, double stiffness, double damping, double t)
{
    double decay = 0.5 * damping / mass, w = sqrt(stiffness / mass - decay * decay);
    return exp(-decay * t) * (cos(w * t) + decay / w * sin(w * t));
}

/* Errors after 50 ms, of translation and of rotation about each principal axis. */
static void swing_errors(double h, double errors[4])
{
    for (int axis = -1; axis < 3; axis++) {
        begin_tied(50.0, 1.0);
        const double moments[3] = {rig.body.inertia.x, rig.body.inertia.y, rig.body.inertia.z};
        double own[3] = {0.0, 0.0, 0.0}, start = axis < 0 ? 0.01 : 0.4;
        rig.h = h;
        if (axis < 0) {
            rig.body.now.pose.position.y += start;
        } else {
            own[axis] = start;
            vec3 turn = quat_rotate(rig.body.now.pose.orientation, vec3_load(own));
            rig.body.now.pose.orientation =
                quat_mul(vbss_quat_from_rotation_vector(turn), rig.body.now.pose.orientation);
            rig.body.coupling.turning_damping = 4e-4;
        }
        rigid_rig_steps(&rig, (uint32_t)(0.05 / h + 0.5));
        double mass = axis < 0 ? rig.body.mass : moments[axis];
        double wanted =
            start * damped_swing(mass, axis < 0 ? 50.0 : 0.05, axis < 0 ? 1.0 : 4e-4, 0.05);
        vec3 turn = quat_rotate_back(rig.body.target_end.orientation, turning_lag());
        const double turns[3] = {turn.x, turn.y, turn.z};
        errors[axis + 1] = fabs((axis < 0 ? lag().y : turns[axis]) + wanted);
        rigid_rig_end(&rig);
    }
}

static void damped_oscillation_converges_at_first_order(void **state)
{
    (void)state;
    double coarse[4], fine[4];
    swing_errors(5e-5, coarse);
    swing_errors(2.5e-5, fine);
    for (int i = 0; i < 4; i++) {
        expect_near(2.0, coarse[i] / fine[i], 0.03);
        assert_true(fine[i] < (i == 0 ? 1e-5 : 2e-3));
    }
}

/* Oblique, large, with gyroscopic torque: against the fine integration. */
static double oblique_error(double h)
{
    begin_tied(50.0, 0.4);
    rig.h = h;
    rig.rounds = 6;
    rig.body.now.pose.orientation = quat_identity();
    rig.body.now.w = vec3_make(20.0, -10.0, 15.0);
    rig.torque = vec3_make(0.01, 0.02, -0.01);
    vbss_rigid_motion wanted = rigid_fine(&rig.body, rig.torque, 0.1, 20000);
    rigid_rig_steps(&rig, (uint32_t)(0.1 / h + 0.5));
    double error = rigid_turn(wanted.pose.orientation, rig.body.now.pose.orientation);
    rigid_rig_end(&rig);
    return error;
}

static void oblique_oscillation_converges_at_first_order(void **state)
{
    (void)state;
    double coarse = oblique_error(1e-4), fine = oblique_error(5e-5);
    expect_near(2.0, coarse / fine, 0.1);
    assert_true(coarse < 0.02);
}

/* ---- hard cases at 1 ms */

static void jerk_about(harness_source *source, const vbss_rigid_coupling *coupling)
{
    rig.body.coupling = *coupling;
    double largest = 0.0;
    for (int i = 0; i < 300; i++) {
        pose end = rig.body.target_end;
        if (i < 200) {
            end = rigid_draw_pose(source, 0.01);
        }
        rigid_rig_step(&rig, end);
        largest = fmax(largest, vec3_norm(lag()));
    }
    assert_true(largest < 0.1);
    assert_true(vec3_is_finite(rig.body.now.v) && vec3_is_finite(rig.body.now.w));
}

static void stiff_coupling_of_light_body_holds(void **state)
{
    (void)state;
    harness_source source = {0};
    static const vec3 moments[] = {
        {1e-12, 1e-12, 1e-12}, {1e-15, 3e-12, 3e-12}, {2e-13, 5e-12, 5.2e-12}};
    static const vbss_rigid_coupling couplings[] = {
        {1e6, 0.0, 1e3, 0.0}, {1e6, 1e3, 1e3, 1.0}, {1e6, 1e-3, 1e-3, 1e-9}};
    vbss_random_seed(&source.random, 1, 0);
    for (int i = 0; i < 9; i++) {
        for (uint32_t rounds = 1; rounds <= 2; rounds++) {
            rigid_rig_begin(&rig, VBSS_ROLE_INTERIOR);
            rig.rounds = rounds;
            rig.body.mass = 1e-6;
            rig.body.inertia = moments[i / 3];
            jerk_about(&source, &couplings[i % 3]);
            expect_near(0.0, vec3_norm(lag()), 1e-9); /* the hand stood still for the last 100 ms */
            expect_near(0.0, vec3_norm(turning_lag()), 1e-9);
            rigid_rig_end(&rig);
        }
    }
}

static void soft_coupling_of_heavy_body_hardly_moves_it(void **state)
{
    (void)state;
    rigid_rig_begin(&rig, VBSS_ROLE_INTERIOR);
    rig.body.mass = 1e3;
    rig.body.inertia = vec3_make(1e3, 2e3, 2.5e3);
    rig.body.coupling = (vbss_rigid_coupling){1e-3, 1e-6, 1e-3, 1e-6};
    rig.body.target_end = pose_make(vec3_make(0.1, 0.0, 0.0),
                                    vbss_quat_from_rotation_vector(vec3_make(0.1, 0.0, 0.0)));
    rigid_rig_steps(&rig, 1000);
    expect_near(0.5 * 1e-4 / 1e3, rig.body.now.pose.position.x, 2e-10); /* a t^2/2, to h/t */
    expect_near(0.5 * 1e-4 / 1e3, rig.body.now.pose.orientation.x * 2.0, 2e-10);
    rigid_rig_end(&rig);
}

/* At 1 ms a spin of 1000 turns a second looks like rest, and one of 900 like 100 the other way. */
static void unresolvable_spin_ends_in_stiff_coupling(void **state)
{
    (void)state;
    for (int i = 1; i <= 20; i++) {
        begin_tied(1e6, 10.0);
        rig.body.now.w = vec3_make(0.0, 100.0 * 6.283185307179586 * i, 1.0);
        rigid_rig_steps(&rig, 30);
        expect_near(0.0, vec3_norm(rig.body.now.w), 1e-9);
        expect_near(0.0, vec3_norm(turning_lag()), 1e-12);
        rigid_rig_end(&rig);
    }
}

int test_rigid_coupling(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(spring_carries_force_and_torque),
        harness_test(impulse_equals_momentum_change),
        harness_test(damped_oscillation_converges_at_first_order),
        harness_test(oblique_oscillation_converges_at_first_order),
        harness_test(stiff_coupling_of_light_body_holds),
        harness_test(soft_coupling_of_heavy_body_hardly_moves_it),
        harness_test(unresolvable_spin_ends_in_stiff_coupling),
    };
    return cmocka_run_group_tests_name("solver.rigid_coupling", tests, NULL, NULL);
}
