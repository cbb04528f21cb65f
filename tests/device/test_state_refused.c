/* Snapshots of devices that are damaged, of others, or of no device at all. */
#include <string.h>

#include "device/rig.h"
#include "fixtures/device_body.h"

static void bad_snapshots_are_rejected(void **state)
{
    (void)state;
    const harness_body body = device_body();
    harness_refuses_bad_snapshots(&body, 37);
    harness_refuses_bad_snapshots(&body, 155);
}

/* Damage that only a visitor sees may bring in a state that is odd; a step from it is defined all the same. */
static void accepted_damaged_state_can_be_stepped(void **state)
{
    (void)state;
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    device_run run;
    vbss_device_input input;
    vbss_output_result result;
    uint8_t good[8192], bad[8192];
    uint64_t count;
    uint32_t taken = 0;
    expect_ok(device_run_create(context, &run));
    vbss_device *device = run.device;
    for (int i = 0; i < 155; i++) {
        expect_ok(device_run_step(device, &input, &result));
    }
    expect_ok(vbss_device_save(device, good, sizeof good, &count));
    for (uint64_t at = 16; at < count - 8; at++) {
        for (int bit = 0; bit < 8; bit += 1 + (int)(at % 3)) {
            memcpy(bad, good, count);
            bad[at] ^= (uint8_t)(1u << bit);
            harness_seal_snapshot(bad, count);
            if (vbss_device_restore(device, bad, count) != VBSS_OK) {
                continue;
            }
            taken++;
            device_object *d;
            expect_ok(vbss_device_open(device, &d));
            for (int i = 0; i < 3; i++) {
                double now = d->now + 1e-3;
                if (now > 1e9) {
                    break;
                }
                vbss_output_command command;
                expect_ok(vbss_output_command_init(&command, sizeof command));
                command.force[i] = 1.0;
                expect_ok(vbss_device_read(device, now, &input, sizeof input));
                expect_ok(vbss_device_write(device, now, &command, &result, sizeof result));
                assert_true(vec3_norm(vec3_load(result.force)) <= 3.0 + 1e-9);
                assert_true(isfinite(input.position[0]) && isfinite(input.velocity[1]));
            }
            uint64_t hash;
            expect_ok(vbss_device_get_hash(device, &hash));
        }
    }
    assert_true(taken > 100);
    harness_context_end(context, &memory);
}

/* ---- devices that are not alike */

static void snapshot_of_other_device_is_rejected(void **state)
{
    (void)state;
    uint8_t bytes[8192];
    uint64_t count;
    device_rig one;
    device_rig_begin(&one);
    device_rig_open(&one, 1);
    device_rig_steps(&one, 20);
    expect_ok(vbss_device_save(one.device, bytes, sizeof bytes, &count));
    enum { DIFFERENCES = 6 };
    for (int difference = 0; difference <= DIFFERENCES; difference++) {
        device_rig other;
        device_rig_begin(&other);
        other.output.max_force = difference == 0 ? 2.0 : 3.0;
        other.config.velocity_time = difference == 1 ? 0.1 : 0.005;
        other.capabilities[0].max_force = difference == 2 ? 1.0 : 0.0;
        other.config.clutch_orientation = difference == 3;
        other.capabilities[0].outputs = difference == 5 ? VBSS_DEVICE_OUT_FORCE : DEVICE_OUTPUTS;
        device_rig_open(&other, difference == 4 ? 2 : 1);
        vbss_result wanted = difference < DIFFERENCES ? VBSS_ERROR_CORRUPT : VBSS_OK;
        uint64_t before = device_rig_hash(&other);
        expect_result(wanted, vbss_device_restore(other.device, bytes, count));
        assert_int_equal(device_rig_hash(&other) == before, difference < DIFFERENCES);
        device_rig_end(&other);
    }
    device_rig_end(&one);
}

/* ---- what is no state: neither written nor read */

static void expect_unsaved(vbss_device *device, device_object *d, const device_object *good)
{
    uint8_t bytes[8192];
    uint64_t count;
    expect_result(VBSS_ERROR_CORRUPT, vbss_device_save(device, bytes, sizeof bytes, &count));
    *d = *good;
    expect_ok(vbss_device_save(device, bytes, sizeof bytes, &count));
}

#define NUMBER(field, value)                  \
    {                                         \
        offsetof(device_object, field), value \
    }

static void impossible_state_is_rejected(void **state)
{
    (void)state;
    static const struct {
        size_t at;
        double value;
    } numbers[] = {NUMBER(orientation.w, 0.5),
                   NUMBER(orientation_offset.w, 0.5),
                   NUMBER(clutch_pose.orientation.x, 1.0),
                   NUMBER(reported_pose.orientation.y, 1.0),
                   NUMBER(motion.orientation.z, 2.0),
                   NUMBER(position.y, -1001.0),
                   NUMBER(motion.position.x, 1001.0),
                   NUMBER(reported_pose.position.z, 1e4),
                   NUMBER(clutch_pose.position.z, 1e4),
                   NUMBER(velocity.x, 1e11),
                   NUMBER(spin.x, 1e11),
                   NUMBER(position_offset.x, 1e8),
                   NUMBER(jaw.opening, 1.1),
                   NUMBER(jaw.opening, -0.1),
                   NUMBER(written_at, 1.0),
                   NUMBER(read_at, 1.0),
                   NUMBER(now, 2e9),
                   NUMBER(output.force.x, 3.1),
                   NUMBER(output.torque.x, 0.11),
                   NUMBER(output.force_load, -1.0),
                   NUMBER(output.torque_load, -1.0),
                   NUMBER(output.force_load, 1e8),
                   NUMBER(output.torque_load, 1e8),
                   NUMBER(output.last_demand.age, -1.0),
                   NUMBER(output.last_demand.age, 2e9),
                   NUMBER(output.last_demand.input_age, -1.0),
                   NUMBER(output.last_demand.input_age, 2e9),
                   NUMBER(output.solenoid.time_left, 1.0),
                   NUMBER(output.solenoid.time_left, -1.0),
                   NUMBER(output.ramp_force, -1.0),
                   NUMBER(output.ramp_torque, -1.0)};
    harness_memory memory;
    vbss_context *context = harness_context(&memory);
    device_run run;
    device_object *d;
    expect_ok(device_run_create(context, &run));
    for (int i = 0; i < 20; i++) {
        expect_ok(device_body_step(run.device));
    }
    expect_ok(vbss_device_open(run.device, &d));
    const device_object good = *d;
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        memcpy((unsigned char *)d + numbers[i].at, &numbers[i].value, sizeof(double));
        expect_unsaved(run.device, d, &good);
    }
    d->tool = 3;
    expect_unsaved(run.device, d, &good);
    d->tool = -1;
    expect_unsaved(run.device, d, &good);
    d->output.solenoid.is_on = d->output.solenoid.is_exhausted = true;
    expect_unsaved(run.device, d, &good);
    harness_context_end(context, &memory);
}

int test_state_refused(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bad_snapshots_are_rejected),
        cmocka_unit_test(accepted_damaged_state_can_be_stepped),
        cmocka_unit_test(snapshot_of_other_device_is_rejected),
        cmocka_unit_test(impossible_state_is_rejected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
