/* A tick of the servo, in the vendor's thread. It runs one frame for each arm,
 *
 *     measure -> errors -> coupling -> output stage -> write force -> errors -> report
 *
 * and then calls the host's tick function, if there is one. The tick does not wait, allocate or
 * print, and does not use the context. */
#include <string.h>

#include "base/api_call.h"
#include "device/openhaptics.h"
#include "device/tuning.h"

/* ---- errors */

static uint64_t ticks_of(const openhaptics_object *o, double seconds)
{
    return (uint64_t)(seconds * o->config.rate + 0.5);
}

/* The arm that an error belongs to. The vendor has one error stack for all arms. */
static haptic_arm *owner_of(openhaptics_object *o, haptic_arm *current, uint32_t device)
{
    for (uint32_t i = 0; i < o->arm_count; i++) {
        if (o->arms[i].device == device) {
            return &o->arms[i];
        }
    }
    return current;
}

static void record_error(openhaptics_object *o, haptic_arm *a, const hd_error *error)
{
    a->status.errors++;
    a->status.error = error->code;
    a->status.internal_error = error->internal;
    if (error->code >= HD_WARM_MOTORS && error->code <= HD_FORCE_ERROR) {
        a->refused_until_tick = o->tick + ticks_of(o, DEVICE_REFUSED_TIME);
    } else { /* a fault of the arm, or of our calls */
        a->lost_until_tick = o->tick + ticks_of(o, DEVICE_LOST_TIME);
        a->failed_tick = o->tick;
    }
}

/* Empties the error stack. Returns whether the arm failed in this tick, so that its measurements
 * are invalid. */
static bool collect_errors(openhaptics_object *o, haptic_arm *a)
{
    for (int i = 0; i < 64; i++) { /* bounded, in case the stack never empties */
        hd_error error = o->hd.get_error();
        if (error.code == 0) {
            break;
        }
        record_error(o, owner_of(o, a, error.device), &error);
    }
    return a->failed_tick == o->tick;
}

/* ---- measurement */

/* Quaternion of a column-major rotation matrix, not normalised. Uses that of four formulas which
 * has the largest divisor (Shepperd 1978). */
static quat quat_from_matrix(const double m[16])
{
    const double xx = m[0], yy = m[5], zz = m[10], trace = xx + yy + zz;
    quat q;
    if (trace >= xx && trace >= yy && trace >= zz) {
        q = quat_make(1.0 + trace, m[6] - m[9], m[8] - m[2], m[1] - m[4]);
    } else if (xx >= yy && xx >= zz) {
        q = quat_make(m[6] - m[9], 1.0 + xx - yy - zz, m[1] + m[4], m[8] + m[2]);
    } else if (yy >= zz) {
        q = quat_make(m[8] - m[2], m[1] + m[4], 1.0 + yy - xx - zz, m[6] + m[9]);
    } else {
        q = quat_make(m[1] - m[4], m[8] + m[2], m[6] + m[9], 1.0 + zz - xx - yy);
    }
    return q;
}

/* Stores a unit quaternion, scaled by 1 plus the deviation of the matrix from a rotation. The
 * device refuses a sample whose scale is outside its tolerance. */
static void store_orientation(const double m[16], double orientation[4])
{
    const quat q = quat_from_matrix(m), unit = quat_unit(q);
    const mat3 turn = quat_to_mat3(unit);
    const double columns[9] = {m[0], m[4], m[8], m[1], m[5], m[9], m[2], m[6], m[10]};
    double rows[9], max_error = 0.0;
    memcpy(rows, &turn, sizeof rows);
    for (int i = 0; i < 9; i++) {
        max_error = vbss_max(max_error, fabs(rows[i] - columns[i]));
    }
    const double length = 1.0 + max_error; /* `unit` has NaN if the matrix is not finite */
    orientation[0] = length * unit.w;
    orientation[1] = length * unit.x;
    orientation[2] = length * unit.y;
    orientation[3] = length * unit.z;
}

static void millimetres_to_metres(const double from[3], double to[3])
{
    for (int i = 0; i < 3; i++) {
        to[i] = 1e-3 * from[i];
    }
}

static void read_slow_signals(openhaptics_object *o, haptic_arm *a)
{
    double motors[8] = {0.0};
    o->hd.get_doublev(HD_MOTOR_TEMPERATURE, motors);
    double hottest = 0.0;
    for (int i = 0; i < 8; i++) {
        hottest = vbss_max_or_nan(hottest, motors[i]); /* keeps NaN, which the device refuses */
    }
    a->sample.temperature = hottest;
    uint32_t calibration = o->hd.check_calibration();
    if (calibration == HD_CALIBRATION_NEEDS_UPDATE) {
        o->hd.update_calibration((uint32_t)a->calibration_style);
    }
    a->is_calibrated = calibration == HD_CALIBRATION_OK;
}

/* The hand's tremor changes a measured pose all the time. A pose that is constant to the bit comes
 * from an arm that no hand holds, or from one whose encoders give no data. */
static void watch_transform(openhaptics_object *o, haptic_arm *a, const double transform[16])
{
    /* NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): to the bit */
    if (memcmp(transform, a->last_transform, sizeof a->last_transform) != 0) {
        memcpy(a->last_transform, transform, sizeof a->last_transform);
        a->transform_change_tick = o->tick;
    }
    a->status.is_constant =
        o->tick - a->transform_change_tick >= ticks_of(o, DEVICE_CONSTANT_POSE_TIME);
}

static void measure_arm(openhaptics_object *o, haptic_arm *a)
{
    double transform[16] = {0.0}, velocity[3] = {0.0};
    int32_t buttons = 0;
    vbss_device_sample *s = &a->sample;
    o->hd.get_doublev(HD_CURRENT_TRANSFORM, transform);
    o->hd.get_doublev(HD_CURRENT_VELOCITY, velocity);
    o->hd.get_doublev(HD_CURRENT_ANGULAR_VELOCITY, s->angular_velocity);
    o->hd.get_integerv(HD_CURRENT_BUTTONS, &buttons);
    watch_transform(o, a, transform);
    millimetres_to_metres(transform + 12, s->position);
    millimetres_to_metres(velocity, s->velocity);
    store_orientation(transform, s->orientation);
    s->buttons = (uint32_t)buttons;
    if (o->tick % DEVICE_SLOW_POLL_TICKS == 1) {
        read_slow_signals(o, a);
    }
}

/* ---- force */

static vbss_haptics_state hardware_state(const openhaptics_object *o, const haptic_arm *a)
{
    if (o->tick < a->lost_until_tick) {
        return VBSS_HAPTICS_STATE_LOST;
    }
    if (!a->is_calibrated || a->status.is_constant != 0) {
        return VBSS_HAPTICS_STATE_UNCALIBRATED;
    }
    return o->tick < a->refused_until_tick ? VBSS_HAPTICS_STATE_REFUSING
                                           : VBSS_HAPTICS_STATE_RUNNING;
}

/* Force of a coupling of this age, s. The tool is extrapolated with constant velocity. */
static vec3 coupled_force(const haptic_arm *a, const arm_command *command, double age)
{
    vbss_device_coupling c = command->coupling;
    vec3 position = vec3_add_scaled(vec3_load(c.position), age, vec3_load(c.velocity));
    vec3_store(c.position, position);
    return vbss_device_coupling_force(&c, vec3_load(a->sample.position),
                                      vec3_load(a->sample.velocity));
}

static vec3 compute_force(openhaptics_object *o, haptic_arm *a)
{
    const double h = 1.0 / o->config.rate;
    if (vbss_triple_buffer_fetch(&a->to_servo)) {
        a->command_tick = o->tick;
        a->status.orders++;
    }
    const arm_command *command = &a->commands[a->to_servo.reader];
    const double age = (double)(o->tick - a->command_tick) * h;
    /* + h: the command may have been one tick old when it was found */
    output_demand demand = {.age = command->is_given ? age + h : OUTPUT_NEVER,
                            .temperature = a->sample.temperature,
                            .has_fault =
                                a->status.state != VBSS_HAPTICS_STATE_RUNNING ||
                                atomic_load_explicit(&o->stop_requested, memory_order_acquire)};
    if (command->is_given) {
        demand.force = command->is_coupled ? coupled_force(a, command, age) : command->force;
    }
    if (!vec3_is_finite(vec3_load(a->sample.position))) { /* no force without a position */
        demand.has_fault = true;
    }
    uint32_t flags = vbss_output_advance(&a->limits, &a->output, h, &demand);
    if (command->is_given && (flags & VBSS_OUTPUT_FLAG_COMMAND_STALE) != 0) {
        a->status.silent_ticks++;
    }
    return a->output.force;
}

/* ---- tick */

static void publish_report(const openhaptics_object *o, haptic_arm *a, bool measured)
{
    vbss_device_sample *s = &a->sample;
    a->status.state = hardware_state(o, a);
    a->status.temperature = s->temperature;
    a->status.ticks = o->tick;
    s->flags = a->status.state == VBSS_HAPTICS_STATE_LOST ? VBSS_DEVICE_FLAG_LOST : 0u;
    s->flags |= a->status.state == VBSS_HAPTICS_STATE_REFUSING ||
                        a->status.state == VBSS_HAPTICS_STATE_UNCALIBRATED
                    ? VBSS_DEVICE_FLAG_FAULT
                    : 0u;
    if (measured) {
        s->time = (double)o->tick / o->config.rate;
    }
    arm_report *out = &a->reports[a->to_host.writer];
    out->sample = *s;
    out->status = a->status;
    vbss_triple_buffer_publish(&a->to_host);
}

static void tick_arm(openhaptics_object *o, haptic_arm *a)
{
    const double zeros[3] = {0.0, 0.0, 0.0};
    o->hd.begin_frame(a->device);
    measure_arm(o, a);
    bool failed = collect_errors(o, a);
    a->status.state = hardware_state(o, a);
    vec3_store(a->status.force, compute_force(o, a));
    o->hd.set_doublev(HD_CURRENT_FORCE, failed ? zeros : a->status.force);
    o->hd.end_frame(a->device);
    failed = collect_errors(o, a);
    a->status.failed_ticks += failed;
    publish_report(o, a, !failed);
}

static void record_tick_time(openhaptics_object *o)
{
    double duration = o->hd.get_time_stamp();
    for (uint32_t i = 0; i < o->arm_count; i++) {
        vbss_openhaptics_status *s = &o->arms[i].status;
        s->late_ticks += duration * o->config.rate > 1.0;
        s->longest_tick = vbss_max(s->longest_tick, duration);
    }
}

uint32_t HD_CALL vbss_openhaptics_tick(void *user)
{
    openhaptics_object *o = user;
    vbss_call call;
    vbss_call_enter(&call, NULL); /* the context is another thread's */
    const bool ending = atomic_load_explicit(&o->stop_requested, memory_order_acquire);
    o->tick++;
    for (uint32_t i = 0; i < o->arm_count; i++) {
        tick_arm(o, &o->arms[i]);
    }
    if (ending) { /* the forces of this tick were zero */
        atomic_store_explicit(&o->has_stopped, true, memory_order_release);
        vbss_call_leave(&call);
        return HD_DONE;
    }
    if (o->config.tick != NULL) {
        const double time = (double)o->tick / o->config.rate;
        vbss_call_leave(&call);
        o->config.tick(o->config.user, time);
        vbss_call_enter(&call, NULL);
    }
    record_tick_time(o);
    vbss_call_leave(&call);
    return HD_CONTINUE;
}
