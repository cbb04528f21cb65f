/* Haptic arms through the vendor's interface: what is measured, what goes out, and that no call is illegal. */
#include <string.h>

#include "device/hardware_rig.h"

static void poses_are_in_metres_and_unit_quaternions(void **state)
{
    (void)state;
    hardware_rig r;
    hardware_rig_begin(&r, false);
    const double there[3] = {0.01, -0.02, 0.03};
    hardware_rig_open(&r, 2);
    r.hd->place(0, there, NULL);
    r.hd->set_hand(0, &(stand_in_hand){.mass = 0.1});
    hardware_rig_steps(&r, 20);
    const vbss_device_input *in = &r.inputs[0];
    assert_int_equal(in->status, VBSS_DEVICE_STATUS_READY);
    for (int i = 0; i < 3; i++) {
        assert_true(fabs(in->position[i] - there[i]) < 1e-12);
    }
    /* the stand-in's transform turns about z by atan2(0.6, 0.8): half of it has cosine 3 / sqrt(10) */
    assert_true(fabs(in->orientation[0] - 3.0 / sqrt(10.0)) < 1e-12);
    assert_true(fabs(in->orientation[3] - 1.0 / sqrt(10.0)) < 1e-12);
    assert_int_equal(in->buttons, 1);
    assert_int_equal(r.inputs[1].buttons, 2);
    r.hd->press(0, 3);
    hardware_rig_steps(&r, 1);
    assert_int_equal(in->buttons, 3);
    assert_int_equal(r.inputs[1].buttons, 2);
    assert_true(fabs(in->temperature - 0.2) < 1e-12);
    hardware_rig_end(&r);
}

/* What is left of a turn between two orientations, rad. */
static double angle_between(const double a[4], const double b[4])
{
    double dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
    double away = 0.0;
    for (int i = 0; i < 4; i++) {
        double one = a[i] - (dot < 0.0 ? -b[i] : b[i]);
        away += one * one;
    }
    return 4.0 * asin(0.5 * sqrt(away));
}

/* About axes that are none of the arm's, both signs of the quaternion, and half a turn, which no trace tells. */
static void arm_orientation_follows_hand(void **state)
{
    (void)state;
    static const double turns[][4] = {{0.5, 0.5, -0.1, 0.7},
                                      {-0.5, 0.5, -0.1, 0.7},
                                      {0.1, -0.9, 0.3, 0.3},
                                      {0.0, 0.6, 0.0, 0.8},
                                      {1.0, 0.0, 0.0, 0.0}};
    const double there[3] = {0.01, 0.0, 0.0};
    hardware_rig r;
    hardware_rig_begin(&r, false);
    hardware_rig_open(&r, 2);
    r.hd->place(1, there, turns[0]);
    for (size_t k = 0; k < sizeof turns / sizeof *turns; k++) {
        stand_in_hand hand = {.mass = 0.1, .stiffness = 50.0, .damping = 1.0};
        memcpy(hand.turn, turns[k], sizeof hand.turn);
        r.hd->set_hand(0, &hand);
        hardware_rig_steps(&r, 2);
        assert_true(angle_between(r.inputs[0].orientation, turns[k]) < 1e-12);
        assert_true(angle_between(r.inputs[1].orientation, turns[0]) < 1e-12);
    }
    hardware_rig_end(&r);
}

/* The angle that is left falls as exp(-t / wrist), about one axis, whatever the motors do; a tick measures what was before it. */
static void wrist_filter_is_exponential(void **state)
{
    (void)state;
    const double begin[4] = {0.8, 0.0, 0.6, 0.0}, here[3] = {0.0, 0.0, 0.0};
    const double wrist = 0.03, whole = 4.0 * asin(0.5 * sqrt(0.04 + 0.36));
    stand_in_hand hand = {.mass = 0.1, .stiffness = 50.0, .damping = 1.0, .wrist = wrist};
    hardware_rig r;
    hardware_rig_begin(&r, false);
    hardware_rig_open(&r, 1);
    r.hd->place(0, here, begin);
    r.commands[0].force[2] = 0.4;
    hand.turn[0] = -1.0; /* the longer way round, if it were not told from the shorter one */
    r.hd->set_hand(0, &hand);
    for (int k = 0; k < 100; k++) {
        const double nothing[4] = {1.0, 0.0, 0.0, 0.0};
        hardware_rig_steps(&r, 1);
        const vbss_device_input *in = &r.inputs[0];
        double left = whole * exp(-1e-3 * k / wrist);
        assert_true(fabs(angle_between(in->orientation, nothing) - left) < 1e-12);
        assert_true(in->orientation[1] == 0.0 && in->orientation[3] == 0.0);
        double spun =
            k == 0 ? 0.0 : -whole * (exp(-1e-3 * (k - 1) / wrist) - exp(-1e-3 * k / wrist)) * 1e3;
        assert_true(fabs(in->angular_velocity[1] - spun) < 1e-9);
    }
    hardware_rig_end(&r);
}

static void capabilities_are_reported(void **state)
{
    (void)state;
    hardware_rig r;
    vbss_device_capabilities c;
    const char *model, *serial;
    hardware_rig_begin(&r, false);
    hardware_rig_open(&r, 1);
    expect_ok(vbss_device_get_capabilities(r.devices[0], 0, &c, sizeof c));
    assert_true(c.max_force == 3.3 && c.max_continuous_force == 0.88 && c.update_rate == 1000.0);
    assert_int_equal(c.input_dof, 6);
    assert_int_equal(c.output_dof, 3);
    assert_true(fabs(c.workspace_low[1] + 0.06) < 1e-12 &&
                fabs(c.workspace_high[0] - 0.08) < 1e-12);
    expect_ok(vbss_openhaptics_get_identity(r.openhaptics, 1, &model, &serial));
    assert_string_equal(model, "Touch (stand-in)");
    assert_string_equal(serial, "stand-in 2");
    hardware_rig_end(&r);
}

static void force_is_written_in_next_tick(void **state)
{
    (void)state;
    hardware_rig r;
    stand_in_arm now;
    vbss_openhaptics_status status;
    hardware_rig_begin(&r, false);
    hardware_rig_open(&r, 2);
    hardware_rig_steps(&r, 10);
    r.commands[1].force[1] = -0.3;
    hardware_rig_steps(&r, 2);
    r.hd->get_state(1, &now);
    assert_true(fabs(now.force[1] + 0.3) < 1e-12);
    assert_true(hardware_rig_force(&r, 0) == 0.0);
    expect_ok(vbss_openhaptics_get_status(r.openhaptics, 1, &status, sizeof status));
    assert_int_equal(status.state, VBSS_HAPTICS_STATE_RUNNING);
    assert_true(status.ticks == 12 && status.errors == 0 && status.failed_ticks == 0);
    assert_true(status.force[1] == now.force[1]);
    hardware_rig_end(&r);
}

/* Each tick has the spring at the pose of that tick, though the host's anchor is of the step before. */
static void coupling_uses_newest_pose(void **state)
{
    (void)state;
    hardware_rig r;
    stand_in_arm before, now;
    hardware_rig_begin(&r, false);
    hardware_rig_open(&r, 1);
    hardware_rig_steps(&r, 10);
    r.hd->set_hand(
        0, &(stand_in_hand){.mass = 0.1, .stiffness = 50.0, .damping = 1.0, .target = {0.004}});
    r.couplings[0].stiffness = 200.0;
    hardware_rig_steps(&r, 1);
    double worst = 0.0, largest = 0.0;
    for (int i = 0; i < 200; i++) {
        r.hd->get_state(0, &before);
        hardware_rig_steps(&r, 1);
        r.hd->get_state(0, &now);
        worst = vbss_max(worst, fabs(now.force[0] + 200.0 * before.position[0]));
        largest = vbss_max(largest, fabs(now.force[0]));
    }
    assert_true(largest > 0.1);
    assert_true(worst < 1e-9);
    hardware_rig_end(&r);
}

static void servo_rates_match_vendor(void **state)
{
    (void)state;
    hardware_rig r;
    hardware_rig_begin(&r, false);
    r.arms.rate = 900;
    expect_result(VBSS_ERROR_DEVICE, vbss_openhaptics_create(r.context, &r.arms, &r.openhaptics));
    hardware_rig_expect_text(&r, "rate of the servo: a value it does not take (0x0101");
    r.arms.rate = 2000;
    hardware_rig_open(&r, 1);
    hardware_rig_steps(&r, 50);
    assert_true(fabs(r.inputs[0].time - 0.025) < 1e-12);
    hardware_rig_end(&r);
}

/* A host that steps inside the servo: its function is called once a tick, after the frames. */
static hardware_rig *stepped;
static int calls;

static void step_inside(void *user, double now)
{
    vbss_device *device = stepped->devices[0];
    assert_ptr_equal(user, stepped);
    calls++;
    if (device != NULL) {
        expect_ok(vbss_device_read(device, now, &stepped->inputs[0], sizeof stepped->inputs[0]));
        expect_ok(vbss_device_write(device, now, &stepped->commands[0], NULL, 0));
    }
}

static void host_may_step_inside_servo(void **state)
{
    (void)state;
    hardware_rig r;
    hardware_rig_begin(&r, false);
    stepped = &r;
    calls = 0;
    r.arms.tick = step_inside;
    r.arms.user = &r;
    r.silent = true; /* but in there */
    r.commands[0].force[2] = 0.4;
    hardware_rig_open(&r, 1);
    hardware_rig_steps(&r, 20);
    assert_int_equal(calls, 20);
    assert_int_equal(r.inputs[0].status, VBSS_DEVICE_STATUS_READY);
    assert_true(fabs(hardware_rig_force(&r, 0) - 0.4) < 1e-12);
    hardware_rig_end(&r);
}

static void arm_serves_one_device_at_a_time(void **state)
{
    (void)state;
    hardware_rig r;
    vbss_device *second;
    vbss_device_adapter arm;
    hardware_rig_begin(&r, false);
    hardware_rig_open(&r, 1);
    expect_ok(vbss_device_adapter_init(&arm, sizeof arm));
    expect_ok(vbss_openhaptics_get_adapter(r.openhaptics, 0, &arm));
    expect_result(VBSS_ERROR_DEVICE, vbss_device_create(r.context, &arm, NULL, NULL, &second));
    hardware_rig_expect_text(&r, "another device stands on this arm");
    expect_ok(vbss_device_destroy(r.devices[0]));
    expect_ok(vbss_device_create(r.context, &arm, NULL, NULL, &r.devices[0]));
    hardware_rig_steps(&r, 5);
    hardware_rig_end(&r);
}

static void abandoned_device_reports_arm_lost(void **state)
{
    (void)state;
    hardware_rig r;
    const char *text;
    hardware_rig_begin(&r, false);
    hardware_rig_open(&r, 1);
    r.commands[0].force[0] = 1.0;
    hardware_rig_steps(&r, 20);
    expect_ok(vbss_openhaptics_destroy(r.openhaptics));
    assert_true(hardware_rig_force(&r, 0) == 0.0);
    r.openhaptics = NULL;
    hardware_rig_steps(&r, 2);
    assert_int_equal(r.inputs[0].status, VBSS_DEVICE_STATUS_LOST);
    assert_int_equal(r.inputs[0].stopped, 1);
    expect_ok(vbss_device_get_error(r.devices[0], 0, NULL, &text));
    assert_string_equal(text, "the arms were closed");
    hardware_rig_end(&r);
}

int test_haptic_arms(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(poses_are_in_metres_and_unit_quaternions),
        cmocka_unit_test(arm_orientation_follows_hand),
        cmocka_unit_test(wrist_filter_is_exponential),
        cmocka_unit_test(capabilities_are_reported),
        cmocka_unit_test(force_is_written_in_next_tick),
        cmocka_unit_test(coupling_uses_newest_pose),
        cmocka_unit_test(servo_rates_match_vendor),
        cmocka_unit_test(host_may_step_inside_servo),
        cmocka_unit_test(arm_serves_one_device_at_a_time),
        cmocka_unit_test(abandoned_device_reports_arm_lost),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
