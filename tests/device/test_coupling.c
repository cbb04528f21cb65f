/* Virtual couplings through a device: the force at the pose that was read last, and what adapters with a servo get. */
#include <string.h>

#include "device/rig.h"

/* An adapter with a servo of its own stands on the mock, and keeps what it is handed. */
static vbss_device_coupling handed;
static int couples, writes;
static vbss_device_write_fn write_of_mock;

static vbss_result keep_write(void *user, double now, const vbss_output_result *output)
{
    writes++;
    return write_of_mock(user, now, output);
}

static vbss_result keep_couple(void *user, double now, const vbss_output_result *output,
                               const vbss_device_coupling *coupling)
{
    couples++;
    handed = *coupling;
    return write_of_mock(user, now, output);
}

static void begin(device_rig *r)
{
    device_rig_begin(r);
    device_rig_open(r, 1);
    expect_ok(vbss_device_destroy(r->device));
    write_of_mock = r->adapters[0].write;
    r->adapters[0].write = keep_write;
    r->adapters[0].couple = keep_couple;
    r->config.calibration = &r->calibration;
    r->config.output = &r->output;
    expect_ok(vbss_device_create(r->context, &r->adapters[0], NULL, &r->config, &r->device));
    couples = writes = 0;
}

static vbss_device_coupling spring(double stiffness, double damping)
{
    vbss_device_coupling c;
    expect_ok(vbss_device_coupling_init(&c, sizeof c));
    c.stiffness = stiffness;
    c.damping = damping;
    return c;
}

static void write_it(device_rig *r, const vbss_device_coupling *c)
{
    expect_ok(
        vbss_device_write_coupled(r->device, r->now, &r->command, c, &r->result, sizeof r->result));
}

static void force_is_spring_damper(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    vbss_device_coupling c = spring(50.0, 2.0);
    c.velocity[1] = 0.02;
    c.force[2] = 0.1;
    for (int i = 0; i < 20; i++) {
        device_rig_read(&r);
        for (int k = 0; k < 3; k++) {
            c.position[k] = r.input.position[k];
        }
        c.position[0] += 0.004;
        write_it(&r, &c);
    }
    expect_near(50.0 * 0.004 - 2.0 * r.input.velocity[0], r.result.force[0], 1e-12);
    expect_near(2.0 * 0.02, r.result.force[1], 1e-12);
    expect_near(0.1, r.result.force[2], 1e-12);
    assert_true(couples == 20 && writes == 0);
    device_rig_end(&r);
}

/* Scaled, turned, mirrored and held at a wall: at the pose that was read, the adapter's coupling and the device's force
 * are the same. */
static void adapter_gets_coupling_in_its_frame(void **state)
{
    (void)state;
    device_rig r;
    device_rig_begin(&r);
    const int32_t axes[3] = {2, -3, 1};
    memcpy(r.calibration.axes, axes, sizeof axes);
    r.calibration.scale = 2.0;
    r.calibration.force_scale = 0.5;
    r.calibration.workspace_high[2] = -1e-3; /* the hand goes beyond */
    vbss_device_calibration kept = r.calibration;
    device_rig_end(&r);
    begin(&r);
    expect_ok(vbss_device_set_calibration(r.device, &kept));
    vbss_device_coupling c = spring(60.0, 0.0);
    for (int i = 0; i < 120; i++) {
        device_rig_read(&r);
        for (int k = 0; k < 3; k++) {
            c.position[k] = r.input.position[k] + 0.001 * (k + 1);
        }
        write_it(&r, &c);
    }
    assert_true(r.input.clamped != 0);
    const device_object *d = device_rig_object(&r);
    vec3 again = vbss_device_coupling_force(&handed, d->position, d->velocity);
    expect_near(again.x, r.result.force[0], 1e-12);
    expect_near(again.y, r.result.force[1], 1e-12);
    expect_near(again.z, r.result.force[2], 1e-12);
    expect_near(60.0 * 2.0 * 0.5, handed.stiffness, 1e-12);
    expect_near(0.5 * 60.0 * 0.001 * sqrt(14.0), vec3_norm(again), 1e-12);
    device_rig_end(&r);
}

/* Stopped, clutched, refused, or without a pose: no coupling goes out, and no force. */
static void coupling_is_withheld_while_forces_are_off(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    vbss_device_coupling c = spring(50.0, 0.0);
    c.position[0] = 0.5;
    write_it(&r, &c); /* before there is a pose */
    assert_true(couples == 0 && r.result.force[0] == 0.0);
    for (int i = 0; i < 10; i++) {
        device_rig_read(&r);
        write_it(&r, &c);
    }
    assert_int_equal(couples, 10);
    assert_true(r.result.force[0] > 0.5);
    expect_ok(vbss_device_latch_emergency_stop(r.device));
    couples = 0;
    device_rig_read(&r);
    write_it(&r, &c);
    assert_true(couples == 0 && r.result.force[0] == 0.0);
    expect_ok(vbss_device_clear_emergency_stop(r.device));
    expect_ok(vbss_device_set_clutch(r.device, 1));
    device_rig_read(&r);
    write_it(&r, &c);
    assert_true(couples == 0 && r.result.force[0] == 0.0);
    expect_ok(vbss_device_set_clutch(r.device, 0));
    device_rig_fault(&r, 0, VBSS_MOCK_FAULT_REFUSAL, 5.0, 0.0);
    device_rig_read(&r);
    write_it(&r, &c);
    assert_true(couples == 0 && r.result.force[0] == 0.0);
    device_rig_end(&r);
}

static void bad_couplings_are_rejected(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    device_rig_read(&r);
    vbss_device_coupling c = spring(50.0, 0.0);
    expect_result(VBSS_ERROR_NULL_ARGUMENT,
                  vbss_device_write_coupled(r.device, r.now, &r.command, NULL, NULL, 0));
    expect_result(VBSS_ERROR_NULL_ARGUMENT,
                  vbss_device_write_coupled(r.device, r.now, NULL, &c, NULL, 0));
    c.stiffness = -1.0;
    expect_result(VBSS_ERROR_OUT_OF_RANGE,
                  vbss_device_write_coupled(r.device, r.now, &r.command, &c, NULL, 0));
    c = spring(50.0, harness_bad_numbers[0]);
    expect_result(VBSS_ERROR_NOT_FINITE,
                  vbss_device_write_coupled(r.device, r.now, &r.command, &c, NULL, 0));
    c = spring(50.0, 0.0);
    c.position[1] = 2e3;
    expect_result(VBSS_ERROR_OUT_OF_RANGE,
                  vbss_device_write_coupled(r.device, r.now, &r.command, &c, NULL, 0));
    c = spring(50.0, 0.0);
    c.struct_size = 12;
    expect_result(VBSS_ERROR_STRUCT_SIZE,
                  vbss_device_write_coupled(r.device, r.now, &r.command, &c, NULL, 0));
    assert_true(couples + writes == 0);
    device_rig_end(&r);
}

/* hand_force of a tool beside the coupling to the same tool would be twice the spring. */
static void command_with_a_force_is_rejected_beside_a_coupling(void **state)
{
    (void)state;
    device_rig r;
    begin(&r);
    device_rig_read(&r);
    vbss_device_coupling c = spring(50.0, 0.0);
    for (int i = 0; i < 3; i++) {
        r.command.force[i] = i == 1 ? -1e-9 : 0.4;
        expect_result(VBSS_ERROR_OUT_OF_RANGE,
                      vbss_device_write_coupled(r.device, r.now, &r.command, &c, NULL, 0));
        assert_true(couples + writes == 0);
        r.command.force[i] = 0.0;
    }
    r.command.torque[2] = 0.01; /* a coupling has none */
    write_it(&r, &c);
    assert_true(couples == 1);
    r.command.force[0] = harness_bad_numbers[0]; /* switches off instead */
    r.now += 1e-3;
    device_rig_read(&r);
    write_it(&r, &c);
    assert_true((r.result.flags & VBSS_OUTPUT_FLAG_NOT_FINITE) != 0 && r.result.force[0] == 0.0);
    device_rig_end(&r);
}

int test_coupling(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(force_is_spring_damper),
        cmocka_unit_test(adapter_gets_coupling_in_its_frame),
        cmocka_unit_test(coupling_is_withheld_while_forces_are_off),
        cmocka_unit_test(bad_couplings_are_rejected),
        cmocka_unit_test(command_with_a_force_is_rejected_beside_a_coupling),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
