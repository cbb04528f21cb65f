/* A read of a device: poll all adapters -> update ages -> map the pose to the world. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "device/device.h"

_Static_assert(sizeof(vbss_device_input) == 208, "published size");
static const uint32_t input_sizes[] = {208, 0};
static const vbss_layout input_layout = {"vbss_device_input", NULL, input_sizes};

/* ---- ages */

/* Returns whether the reading is stale. Sets an event when that changes, and counts each time that
 * it becomes stale. */
static bool update_age(device_object *d, device_reading *reading, double now, double timeout,
                       uint32_t stale_event, uint32_t renewed_event, uint64_t *count)
{
    if (!reading->is_known) {
        return false;
    }
    double from =
        d->config.clock == VBSS_DEVICE_CLOCK_SHARED ? reading->time : reading->received_at;
    bool was_stale = reading->is_stale, is_first = reading->age < 0.0;
    reading->age = vbss_max(now - from, 0.0);
    reading->is_stale = reading->age > timeout;
    if (reading->is_stale && (!was_stale || is_first)) {
        d->events |= stale_event;
        (*count)++;
    } else if (!reading->is_stale && (was_stale || is_first)) {
        d->events |= renewed_event;
    }
    return reading->is_stale;
}

static void update_ages(device_object *d, double now)
{
    vbss_device_statistics *f = &d->statistics;
    if (update_age(d, &d->pose_reading, now, d->limits.input_timeout, VBSS_DEVICE_EVENT_STALE,
                   VBSS_DEVICE_EVENT_FRESH, &f->pose_stale)) {
        f->pose_stale_reads++;
        d->velocity = d->spin = vec3_zero();
        vbss_device_reset_motion(&d->motion);
    }
    update_age(d, &d->opening_reading, now, d->jaw_timeout, VBSS_DEVICE_EVENT_JAW_STALE,
               VBSS_DEVICE_EVENT_JAW_FRESH, &f->jaw_stale);
    f->oldest_pose = vbss_max(f->oldest_pose, d->pose_reading.age);
}

/* ---- results, in the world's frame */

pose vbss_device_calibrated_pose(const device_object *d)
{
    return pose_make(vbss_device_position_to_world(&d->calibration, &d->frame, d->position),
                     vbss_device_orientation_to_world(&d->frame, d->orientation));
}

/* While the clutch is engaged, the position stays, and the orientation if it is configured to. */
static void fill_pose(device_object *d, vbss_device_input *in)
{
    pose p = vbss_device_calibrated_pose(d);
    vec3 velocity = vbss_device_velocity_to_world(&d->calibration, &d->frame, d->velocity);
    vec3 spin = vbss_device_spin_to_world(&d->frame, d->spin);
    double world_velocity[3];
    p.position = vec3_add(p.position, d->position_offset);
    p.orientation = quat_unit(quat_mul(p.orientation, d->orientation_offset));
    if (d->is_clutched) {
        p.position = d->clutch_pose.position;
        velocity = vec3_zero();
        if (d->config.clutch_orientation != 0) {
            p.orientation = d->clutch_pose.orientation;
            spin = vec3_zero();
        }
    }
    in->clamped = vbss_device_clamp_to_workspace(&d->calibration, &p.position);
    vec3_store(world_velocity, velocity);
    for (int i = 0; i < 3; i++) { /* no velocity along a clamped axis */
        in->velocity[i] = (in->clamped >> i & 1u) != 0 ? 0.0 : world_velocity[i];
    }
    vec3_store(in->position, p.position);
    vec3_store(in->angular_velocity, spin);
    in->orientation[0] = p.orientation.w;
    vec3_store(in->orientation + 1, vec3_make(p.orientation.x, p.orientation.y, p.orientation.z));
    d->reported_pose = p;
}

static vbss_device_status current_status(const device_object *d)
{
    if (d->sources[0].is_lost || d->sources[1].is_lost) {
        return VBSS_DEVICE_STATUS_LOST;
    }
    if (!d->pose_reading.is_known) {
        return VBSS_DEVICE_STATUS_WAITING;
    }
    return d->pose_reading.is_stale ? VBSS_DEVICE_STATUS_STALE : VBSS_DEVICE_STATUS_READY;
}

static uint32_t stale_signals(const device_object *d)
{
    uint32_t stale = d->pose_reading.is_stale ? DEVICE_POSE_SIGNALS | DEVICE_MOTION_SIGNALS : 0u;
    stale |= d->opening_reading.is_stale ? DEVICE_JAW_SIGNALS : 0u;
    return stale & d->known_signals;
}

static void fill_input(device_object *d, uint32_t buttons_before, vbss_device_input *in)
{
    in->status = current_status(d);
    in->valid = d->known_signals;
    in->stale = stale_signals(d);
    in->events = d->events;
    in->buttons = d->buttons;
    in->pressed = d->buttons & ~buttons_before;
    in->released = buttons_before & ~d->buttons;
    in->tool = d->tool;
    in->jaw_closed = vbss_device_reports_closed(d);
    in->clutched = d->is_clutched;
    in->stopped = d->output.is_stopped;
    in->time = d->pose_reading.time;
    in->age = d->pose_reading.age;
    in->jaw_age = d->opening_reading.age;
    in->jaw = vbss_device_reported_opening(d);
    in->jaw_held = d->takeover.is_waiting;
    in->jaw_raw = d->jaw_raw;
    in->temperature = d->temperature;
    fill_pose(d, in);
}

vbss_result vbss_device_read(vbss_device *device, double now, vbss_device_input *input,
                             uint32_t struct_size)
{
    VBSS_ENTER(device);
    device_object *d;
    VBSS_TRY(vbss_device_edit(device, &d));
    VBSS_TRY(vbss_device_check_now(d, now));
    vbss_device_input own = {.struct_size = sizeof own};
    VBSS_TRY(vbss_struct_write(d->context, &input_layout, &own, input, struct_size));
    uint32_t buttons_before = d->buttons;
    d->events = 0;
    d->has_time = true;
    d->now = d->read_at = now;
    d->statistics.reads++;
    for (uint32_t i = 0; i < d->source_count; i++) {
        vbss_device_poll(d, i, now);
    }
    update_ages(d, now);
    vbss_device_update_takeover(d);
    fill_input(d, buttons_before, &own);
    d->statistics.clamped_reads += d->pose_reading.is_known && own.clamped != 0 ? 1 : 0;
    return vbss_struct_write(d->context, &input_layout, &own, input, struct_size);
}
