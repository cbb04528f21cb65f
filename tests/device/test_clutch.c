/* Clutch, re-centring, calibrating anew, workspace, and what of a force reaches a hand. */
#include <string.h>

#include "base/rotation.h"
#include "device/rig.h"

static void begin(device_rig *r)
{
    device_rig_begin(r);
    /* A rotated, larger world. */
    mat3 m = quat_to_mat3(vbss_quat_from_rotation_vector(vec3_make(0.3, 0.5, -0.2)));
    for (int i = 0; i < 9; i++) {
        r->calibration.rotation[i] = m.m[i / 3][i % 3];
    }
    r->calibration.scale = 2.0;
    r->calibration.offset[1] = 0.1;
    r->command.force[0] = 0.8;
    r->command.solenoid = 1;
}

static vec3 position_of(const device_rig *r)
{
    return vec3_load(r->input.position);
}

static quat orientation_of(const device_rig *r)
{
    const double *q = r->input.orientation;
    return quat_make(q[0], q[1], q[2], q[3]);
}

static double turn_between(quat a, quat b)
{
    return vec3_norm(vbss_quat_to_rotation_vector(quat_mul(a, quat_conjugate(b))));
}

static void pose_holds_and_continues(void **state)
{
    (void)state;
    for (int with_orientation = 0; with_orientation < 2; with_orientation++) {
        device_rig r;
        begin(&r);
        r.config.clutch_orientation = (uint32_t)with_orientation;
        device_rig_open(&r, 1);
        device_rig_steps(&r, 20);
        vec3 held = position_of(&r);
        quat turned = orientation_of(&r);
        vec3 velocity = vec3_load(r.input.velocity), spin = vec3_load(r.input.angular_velocity);
        expect_ok(vbss_device_set_clutch(r.device, 1));
        for (int i = 0; i < 50; i++) {
            device_rig_steps(&r, 1);
            assert_int_equal(r.input.clutched, 1);
            expect_near(0.0, vec3_distance(held, position_of(&r)), 0.0);
            assert_true(vec3_norm(vec3_load(r.input.velocity)) == 0.0);
            expect_near(with_orientation == 1 ? 0.0 : 1.0,
                        vec3_norm(vec3_load(r.input.angular_velocity)), 1e-9);
            /* The orientation follows unless it is held, too. */
            double since = 1e-3 * (i + 1);
            expect_near(with_orientation == 1 ? 0.0 : since,
                        turn_between(turned, orientation_of(&r)), 1e-9);
            assert_true(r.result.force[0] == 0.0 && r.result.solenoid == 0);
        }
        expect_ok(vbss_device_set_clutch(r.device, 0));
        vec3 before = position_of(&r);
        quat turned_before = orientation_of(&r);
        device_rig_steps(&r, 1);
        /* One step of the hand's movement away from where it stayed, in the same direction as before. */
        expect_near(0.0,
                    vec3_distance(vec3_scale(velocity, 1e-3), vec3_sub(position_of(&r), before)),
                    1e-12);
        expect_near(1e-3, turn_between(turned_before, orientation_of(&r)), 1e-9);
        expect_near(0.0, vec3_distance(spin, vec3_load(r.input.angular_velocity)), 1e-9);
        quat step = quat_mul(orientation_of(&r), quat_conjugate(turned_before));
        vec3 seen = vec3_scale(vbss_quat_to_rotation_vector(step), 1e3);
        expect_near(0.0, vec3_distance(spin, seen), 1e-9);
        device_rig_steps(&r, 20);
        expect_near(0.8, vec3_norm(vec3_load(r.result.force)), 1e-14);
        assert_int_equal(device_rig_statistics(&r).clutches, 1);
        device_rig_end(&r);
    }
}

static void double_hold_is_one_hold(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    device_rig_open(&r, 1);
    device_rig_steps(&r, 20);
    vec3 held = position_of(&r);
    vec3 velocity = vec3_load(r.input.velocity);
    expect_ok(vbss_device_set_clutch(r.device, 0)); /* nothing to let go */
    device_rig_read(&r);
    assert_int_equal(r.input.clutched, 0);
    expect_near(0.0, vec3_distance(vec3_add_scaled(held, 1e-3, velocity), position_of(&r)), 1e-12);
    held = position_of(&r);
    expect_ok(vbss_device_set_clutch(r.device, 1));
    device_rig_steps(&r, 5);
    expect_ok(vbss_device_set_clutch(r.device, 1));
    device_rig_steps(&r, 5);
    expect_near(0.0, vec3_distance(held, position_of(&r)), 0.0);
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_device_set_clutch(r.device, 2));
    assert_int_equal(device_rig_statistics(&r).clutches, 1);
    device_rig_end(&r);
}

static void recentre_sets_pose(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    device_rig_open(&r, 1);
    device_rig_steps(&r, 20);
    vec3 velocity = vec3_load(r.input.velocity);
    const double wanted[3] = {0.2, -0.3, 0.4};
    quat q = vbss_quat_from_rotation_vector(vec3_make(-1.0, 0.4, 2.0));
    const double turned[4] = {3.0 * q.w, 3.0 * q.x, 3.0 * q.y, 3.0 * q.z};
    expect_ok(vbss_device_set_clutch(r.device, 1));
    expect_ok(vbss_device_recentre(r.device, wanted, turned));
    device_rig_steps(&r, 1);
    vec3 expected = vec3_add_scaled(vec3_load(wanted), 1e-3, velocity);
    expect_near(0.0, vec3_distance(expected, position_of(&r)), 1e-12);
    expect_near(1e-3, turn_between(q, orientation_of(&r)), 1e-9);
    assert_int_equal(r.input.clutched, 0);
    /* Each alone leaves the other. */
    quat before = orientation_of(&r);
    expect_ok(vbss_device_recentre(r.device, wanted, NULL));
    device_rig_steps(&r, 1);
    expect_near(1e-3, turn_between(before, orientation_of(&r)), 1e-9);
    device_rig_end(&r);
}

static void invalid_pose_is_rejected(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    device_rig_open(&r, 1);
    const double zero[4] = {0.0, 0.0, 0.0, 0.0}, far[3] = {0.0, 1001.0, 0.0};
    expect_result(VBSS_ERROR_WRONG_STATE, vbss_device_recentre(r.device, zero, NULL));
    device_rig_steps(&r, 2);
    uint64_t before = device_rig_hash(&r);
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_device_recentre(r.device, far, NULL));
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_device_recentre(r.device, zero, zero));
    for (int i = 0; i < 3; i++) {
        const double bad[4] = {0.0, 1.0, harness_bad_numbers[i], 0.0};
        expect_result(VBSS_ERROR_NOT_FINITE, vbss_device_recentre(r.device, bad, NULL));
        expect_result(VBSS_ERROR_NOT_FINITE, vbss_device_recentre(r.device, NULL, bad));
    }
    assert_true(device_rig_hash(&r) == before);
    device_rig_end(&r);
}

static void new_calibration_applies_from_next_read(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    device_rig_open(&r, 1);
    device_rig_steps(&r, 20);
    const double elsewhere[3] = {0.3, 0.3, 0.3}, turned[4] = {0.0, 1.0, 0.0, 0.0};
    expect_ok(vbss_device_recentre(r.device, elsewhere, turned));
    expect_ok(vbss_device_set_clutch(r.device, 1));
    vbss_device_calibration bad = r.calibration, good = r.calibration;
    bad.scale = 0.0;
    uint64_t before = device_rig_hash(&r);
    expect_result(VBSS_ERROR_OUT_OF_RANGE, vbss_device_set_calibration(r.device, &bad));
    assert_true(device_rig_hash(&r) == before);
    good.scale = 1.0;
    good.axes[0] = -1;
    good.jaw_open = 0.625;
    memcpy(good.rotation, (const double[9]){1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0},
           sizeof good.rotation);
    expect_ok(vbss_device_set_calibration(r.device, &good));
    device_rig_steps(&r, 1);
    expect_near(-(0.1 * r.now - 0.005), r.input.position[0], 1e-15);
    expect_near(0.1, r.input.position[1], 1e-15);
    expect_near(vbss_cos(0.5 * r.now), r.input.orientation[0], 1e-12);
    expect_near(0.8, r.input.jaw, 1e-12); /* at once, by no filter */
    assert_int_equal(r.input.clutched, 0);
    expect_near(-0.5, r.result.force[0], 1e-15);
    device_rig_steps(&r, 20);
    expect_near(-0.8, r.result.force[0], 1e-15);
    expect_ok(vbss_device_set_calibration(r.device, NULL));
    device_rig_steps(&r, 1);
    expect_near(0.1 * r.now - 0.005, r.input.position[0], 1e-15);
    device_rig_end(&r);
}

/* ---- the workspace */

static void pose_outside_workspace_waits_at_boundary(void **state)
{
    (void)state;
    device_rig r;
    device_rig_begin(&r);
    r.calibration.workspace_high[0] = 0.0; /* reached after 50 ms */
    device_rig_open(&r, 1);
    device_rig_steps(&r, 50);
    assert_int_equal(r.input.clamped, 0);
    assert_true(r.input.velocity[0] > 0.0);
    device_rig_steps(&r, 1); /* on the wall, or a rounding beyond */
    uint64_t before = device_rig_statistics(&r).clamped_reads;
    for (int i = 0; i < 30; i++) {
        device_rig_steps(&r, 1);
        assert_int_equal(r.input.clamped, 1);
        expect_near(0.0, r.input.position[0], 0.0);
        assert_true(r.input.velocity[0] == 0.0);
        expect_near(1.0, r.input.angular_velocity[2], 1e-9);
    }
    assert_int_equal(device_rig_statistics(&r).clamped_reads, before + 30);
    device_rig_end(&r);
}

/* ---- forces */

static void forces_are_rotated_and_scaled_to_device(void **state)
{
    (void)state;
    device_rig r;
    device_rig_begin(&r);
    r.calibration.axes[0] = 2;
    r.calibration.axes[1] = -3;
    r.calibration.axes[2] = 1;
    r.calibration.force_scale = 0.5;
    r.output.force_rise = 1e9;
    r.output.torque_rise = 1e9;
    device_rig_open(&r, 1);
    device_rig_steps(&r, 2);
    const double force[3] = {0.2, 0.4, -0.6};
    const double torque[3] = {0.02, 0.01, 0.0};
    memcpy(r.command.force, force, sizeof force);
    memcpy(r.command.torque, torque, sizeof torque);
    device_rig_steps(&r, 1);
    /* World x is device y, world y device -z, world z device x. */
    expect_near(-0.3, r.result.force[0], 1e-16);
    expect_near(0.1, r.result.force[1], 1e-16);
    expect_near(-0.2, r.result.force[2], 1e-16);
    /* A cyclic order with one minus is a mirror, in which torques turn round. */
    expect_near(-0.01, r.result.torque[1], 1e-17);
    expect_near(0.005, r.result.torque[2], 1e-17);
    device_rig_end(&r);
}

int test_clutch(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pose_holds_and_continues),
        cmocka_unit_test(double_hold_is_one_hold),
        cmocka_unit_test(recentre_sets_pose),
        cmocka_unit_test(invalid_pose_is_rejected),
        cmocka_unit_test(new_calibration_applies_from_next_read),
        cmocka_unit_test(pose_outside_workspace_waits_at_boundary),
        cmocka_unit_test(forces_are_rotated_and_scaled_to_device),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
