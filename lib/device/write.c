/* A write to a device: command -> device's frame -> output stage -> adapters. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "device/device.h"

/* ---- demand */

static bool has_output(const device_object *d, uint32_t output)
{
    return (d->sources[0].capabilities.outputs & output) != 0 ||
           (d->sources[1].capabilities.outputs & output) != 0;
}

/* The solenoid is off after a failure of an adapter, and while the opening is stale or the clutch
 * is engaged. */
static bool must_block_solenoid(const device_object *d)
{
    return d->sources[0].read_failed || d->sources[1].read_failed || d->write_failed ||
           d->opening_reading.is_stale || d->sources[0].is_lost || d->sources[1].is_lost ||
           d->is_clutched;
}

/* Combines the demand with age, temperature and faults that the device knows. */
static output_demand complete_demand(const device_object *d, output_demand demand)
{
    double age =
        d->pose_reading.is_known ? d->pose_reading.age + (d->now - d->read_at) : OUTPUT_NEVER;
    demand.input_age =
        demand.input_age > age || demand.input_age != demand.input_age ? demand.input_age : age;
    demand.temperature = vbss_max_or_nan(demand.temperature, d->temperature);
    demand.has_fault = demand.has_fault || d->sources[0].has_fault || d->sources[1].has_fault;
    demand.block_solenoid = must_block_solenoid(d);
    if (d->is_clutched || !has_output(d, VBSS_DEVICE_OUT_FORCE)) {
        demand.force = vec3_zero();
    }
    if (d->is_clutched || !has_output(d, VBSS_DEVICE_OUT_TORQUE)) {
        demand.torque = vec3_zero();
    }
    return demand;
}

/* A force of the host beside a coupling would often be that of the same spring. Numbers that are not
 * finite pass, because the output stage switches off for them. */
static vbss_result check_only_coupling(const device_object *d, const vbss_output_command *command)
{
    for (int i = 0; i < 3; i++) {
        if (fabs(command->force[i]) > 0.0) {
            return vbss_fail(d->context, VBSS_ERROR_OUT_OF_RANGE,
                             "force[%d] is %g; with a coupling it must be 0, because the coupling "
                             "has the force of the spring",
                             i, command->force[i]);
        }
    }
    return VBSS_OK;
}

static vbss_result read_demand(const device_object *d, double h, const vbss_output_command *command,
                               bool has_coupling, output_demand *demand)
{
    if (command == NULL) { /* the last one is in the device's frame already */
        *demand = vbss_output_repeat_demand(&d->output, h);
        demand->input_age = 0.0; /* complete_demand adds the age of the pose */
        return VBSS_OK;
    }
    vbss_output_command own;
    VBSS_TRY(vbss_config_read(d->context, &vbss_output_command_layout, command, &own));
    VBSS_TRY(vbss_output_check_command(d->context, &own));
    if (has_coupling) {
        VBSS_TRY(check_only_coupling(d, &own));
    }
    *demand = vbss_output_make_demand(&own);
    demand->force = vbss_device_force_to_device(&d->calibration, &d->frame, demand->force);
    demand->torque = vbss_device_torque_to_device(&d->calibration, &d->frame, demand->torque);
    return VBSS_OK;
}

/* ---- coupling */

/* Flags with which a coupling is not passed on to an adapter. */
#define COUPLING_OFF_FLAGS                                                             \
    (VBSS_OUTPUT_FLAG_NOT_FINITE | VBSS_OUTPUT_FLAG_FAULT | VBSS_OUTPUT_FLAG_STOPPED | \
     VBSS_OUTPUT_FLAG_INPUT_STALE | VBSS_OUTPUT_FLAG_COMMAND_STALE)

/* Maps a coupling to the device's frame and adds its force to the demand. The tool's position is
 * taken relative to the last reported pose. Offsets of clutch, re-centring and workspace therefore
 * do not stretch the spring. */
static void couple_demand(const device_object *d, vbss_device_coupling *c, output_demand *demand)
{
    const vbss_device_calibration *k = &d->calibration;
    vec3 away = vec3_sub(vec3_load(c->position), d->reported_pose.position);
    vec3 force = vbss_device_force_to_device(k, &d->frame, vec3_load(c->force));
    vec3 velocity = vbss_device_displacement_to_device(k, &d->frame, vec3_load(c->velocity));
    away = vbss_device_displacement_to_device(k, &d->frame, away);
    vec3_store(c->position, vec3_add(d->position, away));
    vec3_store(c->velocity, velocity);
    vec3_store(c->force, vec3_add(force, demand->force));
    c->stiffness *= k->scale * k->force_scale;
    c->damping *= k->scale * k->force_scale;
    demand->force = d->pose_reading.is_known
                        ? vbss_device_coupling_force(c, d->position, d->velocity)
                        : vec3_load(c->force);
}

/* Whether outputs are off because the clock has jumped, or the host was stopped: the time for which
 * the last force was out is unknown. They stay off for as long as a command lasts, so that each
 * adapter finds out. */
static bool is_after_jump(device_object *d, double h)
{
    if (h > DEVICE_CLOCK_JUMP) {
        d->off_until = d->now + d->limits.command_timeout + d->limits.ramp_time;
    }
    return d->now < d->off_until;
}

static vbss_result write_output(device_object *d, double now, const vbss_output_command *command,
                                vbss_device_coupling *coupling, vbss_output_result *result,
                                uint32_t struct_size)
{
    output_demand demand;
    vbss_output_result own = {.struct_size = sizeof own};
    VBSS_TRY(vbss_device_check_now(d, now));
    double h = d->has_written ? now - d->written_at : 0.0;
    VBSS_TRY(read_demand(d, h, command, coupling != NULL, &demand));
    if (result != NULL) {
        VBSS_TRY(
            vbss_struct_write(d->context, &vbss_output_result_layout, &own, result, struct_size));
    }
    if (coupling != NULL) {
        couple_demand(d, coupling, &demand);
    }
    d->has_time = d->has_written = true;
    d->now = d->written_at = now;
    d->statistics.writes++;
    vbss_output_store_demand(&d->output, &demand);
    demand = complete_demand(d, demand);
    if (is_after_jump(d, h)) {
        demand.age = OUTPUT_NEVER;
    }
    uint32_t flags = vbss_output_advance(&d->limits, &d->output, h, &demand);
    vbss_output_fill_result(&d->limits, &d->output, flags, &own);
    bool coupled = coupling != NULL && (flags & COUPLING_OFF_FLAGS) == 0 && !d->is_clutched &&
                   d->pose_reading.is_known;
    own.flags |= vbss_device_send(d, &own, coupled ? coupling : NULL);
    return result == NULL ? VBSS_OK
                          : vbss_struct_write(d->context, &vbss_output_result_layout, &own, result,
                                              struct_size);
}

vbss_result vbss_device_write(vbss_device *device, double now, const vbss_output_command *command,
                              vbss_output_result *result, uint32_t struct_size)
{
    VBSS_ENTER(device);
    device_object *d;
    VBSS_TRY(vbss_device_edit(device, &d));
    return write_output(d, now, command, NULL, result, struct_size);
}

vbss_result vbss_device_write_coupled(vbss_device *device, double now,
                                      const vbss_output_command *command,
                                      const vbss_device_coupling *coupling,
                                      vbss_output_result *result, uint32_t struct_size)
{
    VBSS_ENTER(device);
    device_object *d;
    vbss_device_coupling own;
    VBSS_TRY(vbss_device_edit(device, &d));
    VBSS_TRY(vbss_check_pointer(d->context, command, "command"));
    VBSS_TRY(vbss_check_pointer(d->context, coupling, "coupling"));
    VBSS_TRY(vbss_config_read(d->context, &vbss_device_coupling_layout, coupling, &own));
    VBSS_TRY(vbss_device_check_coupling(d->context, &own));
    return write_output(d, now, command, &own, result, struct_size);
}
