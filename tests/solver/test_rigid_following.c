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

/* ---- following */

static void steady_target_lag_is_drag_only(void **state)
{
    (void)state;
    for (int with_drag = 0; with_drag < 2; with_drag++) {
        begin_tied(100.0, 3.0);
        rig.body.drag = with_drag == 0 ? 0.0 : 40.0;
        rig.body.coupling.turning_damping = 2e-3;
        vec3 axis = quat_rotate(rig.body.now.pose.orientation, vec3_make(0.0, 1.0, 0.0));
        pose start = rig.body.target_end;
        for (int i = 1; i <= 2000;
             i++) { /* 1 m/s, and 5 rad/s about a principal axis: past half a turn */
            vec3 turn = vec3_scale(axis, 5.0 * rig.h * i);
            pose end = {vec3_add(start.position, vec3_make(0.0, rig.h * i, 0.0)),
                        quat_mul(vbss_quat_from_rotation_vector(turn), start.orientation)};
            end.orientation = quat_unit(end.orientation);
            rigid_rig_step(&rig, end);
        }
        vec3 wanted = vec3_make(0.0, rig.body.mass * rig.body.drag / 100.0, 0.0);
        vec3 turning = vec3_scale(axis, 5.0 * rig.body.inertia.y * rig.body.drag / 0.1);
        expect_near(0.0, vec3_distance(wanted, lag()), 1e-12);
        expect_near(0.0, vec3_distance(turning, turning_lag()), 1e-12);
        expect_near(0.0, vec3_distance(vec3_scale(axis, 5.0), rig.body.now.w), 1e-10);
        rigid_rig_end(&rig);
    }
}

static void accelerating_target_lag_is_inertia(void **state)
{
    (void)state;
    begin_tied(100.0, 3.0);
    pose start = rig.body.target_end, end = start;
    for (int i = 1; i <= 1000; i++) {
        double t = rig.h * i;
        end.position = vec3_add_scaled(start.position, 0.5 * 4.0 * t * t, vec3_make(0.6, 0.0, 0.8));
        rigid_rig_step(&rig, end);
    }
    expect_near(4.0 * rig.body.mass / 100.0, vec3_norm(lag()), 1e-12);
    rigid_rig_end(&rig);
}

/* The quaternion of a turn changes sign past pi: the same orientation. */
static void rotations_past_pi_and_either_quaternion_sign_are_followed(void **state)
{
    (void)state;
    begin_tied(1000.0, 3.0);
    rigid_rig_place(&rig, pose_identity());
    for (int i = 1; i <= 4000; i++) {
        double angle = 0.004 * i;
        quat q = quat_make(cos(0.5 * angle), 0.0, 0.0, sin(0.5 * angle));
        if (i % 3 == 0 || angle > 9.0) {
            q = quat_make(-q.w, -q.x, -q.y, -q.z);
        }
        rigid_rig_step(&rig, pose_make(vec3_zero(), q));
        assert_true(vec3_norm(turning_lag()) < 0.1);
        assert_true(vec3_norm(rig.body.now.w) < 8.0);
    }
    expect_near(0.0, vec3_norm(turning_lag()), 1e-10);
    expect_near(4.0, rig.body.now.w.z, 1e-8);
    rigid_rig_end(&rig);
}

/* ---- what does not matter */

/* In a frame turned and shifted by `frame`. */
static vbss_rigid_motion run_in(pose frame, const pose *ends, uint32_t count)
{
    begin_tied(80.0, 0.5);
    quat q = frame.orientation;
    rig.rounds = 2;
    rig.body.gravity = quat_rotate(q, vec3_make(0.0, 0.0, -9.81));
    rig.force = quat_rotate(q, vec3_make(0.2, 0.1, -0.3));
    rig.torque = quat_rotate(q, vec3_make(0.002, -0.001, 0.003));
    rigid_rig_place(&rig, pose_mul(frame, rig.body.target_end));
    rig.body.now.w = quat_rotate(q, vec3_make(5.0, 6.0, -7.0));
    for (uint32_t i = 0; i < count; i++) {
        rigid_rig_step(&rig, pose_mul(frame, ends[i]));
    }
    vbss_rigid_motion m = rig.body.now;
    rigid_rig_end(&rig);
    return m;
}

static void any_frame(harness_source *source, void *user)
{
    (void)user;
    pose ends[100], at = {vec3_make(0.1, -0.2, 0.3), harness_draw_unit_quat(source)};
    for (int i = 0; i < 100; i++) {
        vec3 turn = harness_draw_vec3(source, -0.02, 0.02);
        at.position = vec3_add(at.position, harness_draw_vec3(source, -1e-3, 1e-3));
        at.orientation = quat_unit(quat_mul(vbss_quat_from_rotation_vector(turn), at.orientation));
        ends[i] = at;
    }
    pose frame = rigid_draw_pose(source, 0.5);
    vbss_rigid_motion plain = run_in(pose_identity(), ends, 100), other = run_in(frame, ends, 100);
    pose wanted = pose_mul(frame, plain.pose);
    expect_near(0.0, vec3_distance(wanted.position, other.pose.position), 1e-12);
    expect_near(0.0, rigid_turn(wanted.orientation, other.pose.orientation), 1e-11);
    expect_near(0.0, vec3_distance(quat_rotate(frame.orientation, plain.v), other.v), 1e-10);
    expect_near(0.0, vec3_distance(quat_rotate(frame.orientation, plain.w), other.w), 1e-8);
}

static void frame_invariance(void **state)
{
    (void)state;
    harness_property("frames", 30, any_frame, NULL);
}

/* Four parts of a step are four steps of a quarter, as the given pose crosses evenly. */
static void substeps_are_short_steps(void **state)
{
    (void)state;
    pose begin, end = {vec3_make(0.11, -0.19, 0.3),
                       vbss_quat_from_rotation_vector(vec3_make(0.6, 0.7, -0.6))};
    begin_tied(500.0, 1.0);
    begin = rig.body.target_end;
    rig.parts = 4;
    rigid_rig_step(&rig, end);
    vbss_rigid_motion wanted = rig.body.now;
    rigid_rig_end(&rig);
    begin_tied(500.0, 1.0);
    rig.h *= 0.25;
    vbss_rigid_substep quarter = {1.0, 0.0, 0.0};
    for (int i = 1; i <= 4; i++) {
        vbss_rigid body = {.target_start = begin, .target_end = end};
        quarter.end_fraction = 0.25 * i;
        vbss_rigid_motion given = vbss_rigid_target_motion(&body, &quarter);
        rigid_rig_step(&rig, given.pose);
    }
    expect_near(0.0, vec3_distance(wanted.pose.position, rig.body.now.pose.position), 1e-15);
    expect_near(0.0, vec3_distance(wanted.v, rig.body.now.v), 1e-11);
    expect_near(0.0, rigid_turn(wanted.pose.orientation, rig.body.now.pose.orientation), 1e-14);
    expect_near(0.0, vec3_distance(wanted.w, rig.body.now.w), 1e-10);
    rigid_rig_end(&rig);
}

int test_rigid_following(void)
{
    const struct CMUnitTest tests[] = {
        harness_test(steady_target_lag_is_drag_only),
        harness_test(accelerating_target_lag_is_inertia),
        harness_test(rotations_past_pi_and_either_quaternion_sign_are_followed),
        harness_test(frame_invariance),
        harness_test(substeps_are_short_steps),
    };
    return cmocka_run_group_tests_name("solver.rigid_following", tests, NULL, NULL);
}
