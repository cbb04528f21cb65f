/* Polls one adapter: reads it, checks its sample, accepts the sample part by part, and handles the
 * flags of the hardware. */
#include "base/error.h"
#include "device/device.h"

/* ---- flags of the hardware */

static void warn(const device_object *d, uint32_t source, const char *what)
{
    vbss_message(d->context, VBSS_LOG_WARNING, "%s %s", d->sources[source].name, what);
}

/* The clock of the next sample may be reset, so the filters start without earlier samples. */
static void reset_filters(device_object *d, uint32_t source)
{
    uint32_t routed = vbss_device_routed_signals(d, source);
    if ((routed & VBSS_DEVICE_HAS_POSITION) != 0) {
        vbss_device_reset_motion(&d->motion);
    }
    if ((routed & DEVICE_JAW_SIGNALS) != 0) {
        d->jaw.is_known = false;
    }
}

static void trigger_stop(device_object *d)
{
    vbss_device_latch_stop(d);
    d->events |= VBSS_DEVICE_EVENT_STOPPED;
}

static void handle_loss(device_object *d, uint32_t source)
{
    device_source *s = &d->sources[source];
    s->is_lost = true;
    s->has_time = false;
    reset_filters(d, source);
    d->statistics.lost[source]++;
    d->events |= VBSS_DEVICE_EVENT_LOST;
    if (d->config.stop_when_lost != 0 && !d->output.is_stopped) {
        trigger_stop(d);
    }
    vbss_device_record_failure(d->context, s, VBSS_ERROR_DEVICE);
    vbss_message(d->context, VBSS_LOG_WARNING, "%s is lost: %s", s->name,
                 s->text[0] == '\0' ? "no reason is given" : s->text);
}

static void handle_rate(device_object *d, uint32_t source, bool slow)
{
    device_source *s = &d->sources[source];
    if (slow && !s->is_slow) {
        d->events |= VBSS_DEVICE_EVENT_SLOW;
        vbss_device_record_failure(d->context, s, VBSS_ERROR_DEVICE);
        vbss_message(d->context, VBSS_LOG_WARNING, "%s is slow: %s", s->name, s->text);
    }
    s->is_slow = slow || (s->is_slow && s->read_failed);
}

/* A failed read can begin a loss or a fault, but cannot end one. */
static void handle_flags(device_object *d, uint32_t source, uint32_t flags)
{
    device_source *s = &d->sources[source];
    bool lost = (flags & VBSS_DEVICE_FLAG_LOST) != 0, fault = (flags & VBSS_DEVICE_FLAG_FAULT) != 0;
    if (lost && !s->is_lost) {
        handle_loss(d, source);
    } else if (s->is_lost && !lost && !s->read_failed) {
        s->is_lost = false;
        d->events |= VBSS_DEVICE_EVENT_FOUND;
        warn(d, source, "is back");
    }
    if ((flags & VBSS_DEVICE_FLAG_STOP) != 0 && !d->output.is_stopped) {
        trigger_stop(d);
        warn(d, source, "asks for an emergency stop");
    }
    if (fault && !s->has_fault) {
        d->statistics.faults[source]++;
        d->events |= VBSS_DEVICE_EVENT_FAULT;
        vbss_device_record_failure(d->context, s, VBSS_ERROR_DEVICE);
        warn(d, source, "refuses forces");
    }
    handle_rate(d, source, (flags & VBSS_DEVICE_FLAG_SLOW) != 0);
    s->has_fault = fault || (s->has_fault && s->read_failed);
}

/* ---- parts of a sample */

static void refresh_reading(device_reading *reading, double now, double time)
{
    reading->is_known = true;
    reading->received_at = now;
    reading->time = time;
}

static void accept_pose(device_object *d, const vbss_device_sample *sample, uint32_t valid,
                        double now)
{
    const bool oriented = (valid & VBSS_DEVICE_HAS_ORIENTATION) != 0;
    d->position = vec3_load(sample->position);
    if (oriented) {
        d->orientation = quat_unit(quat_make(sample->orientation[0], sample->orientation[1],
                                             sample->orientation[2], sample->orientation[3]));
    }
    vbss_device_update_motion(&d->motion, d->config.velocity_time, sample->time, d->position,
                              oriented ? &d->orientation : NULL);
    d->velocity =
        (valid & VBSS_DEVICE_HAS_VELOCITY) != 0 ? vec3_load(sample->velocity) : d->motion.velocity;
    d->spin = (valid & VBSS_DEVICE_HAS_ANGULAR_VELOCITY) != 0 ? vec3_load(sample->angular_velocity)
                                                              : d->motion.spin;
    d->known_signals |= valid & (DEVICE_POSE_SIGNALS | DEVICE_MOTION_SIGNALS);
    d->known_signals |= d->motion.has_velocity ? VBSS_DEVICE_HAS_VELOCITY : 0u;
    d->known_signals |= d->motion.has_spin ? VBSS_DEVICE_HAS_ANGULAR_VELOCITY : 0u;
    refresh_reading(&d->pose_reading, now, sample->time);
}

static void accept_jaw(device_object *d, const vbss_device_sample *sample, uint32_t valid,
                       double now)
{
    const bool calibrated = (valid & VBSS_DEVICE_HAS_JAW) != 0;
    if ((valid & VBSS_DEVICE_HAS_JAW_RAW) != 0) {
        d->jaw_raw = sample->jaw_raw;
        d->known_signals |= VBSS_DEVICE_HAS_JAW_RAW;
    }
    if (!calibrated && !vbss_device_is_plausible_raw(&d->calibration, sample->jaw_raw)) {
        d->statistics.jaw_refused++;
        d->events |= VBSS_DEVICE_EVENT_REFUSED;
        return;
    }
    double opening =
        calibrated ? sample->jaw : vbss_device_opening_from_raw(&d->calibration, sample->jaw_raw);
    vbss_device_update_jaw(&d->jaw, &d->calibration, opening,
                           sample->time - d->opening_reading.time);
    d->known_signals |= VBSS_DEVICE_HAS_JAW;
    refresh_reading(&d->opening_reading, now, sample->time);
}

static void accept_other_signals(device_object *d, const vbss_device_sample *sample, uint32_t valid)
{
    if ((valid & VBSS_DEVICE_HAS_BUTTONS) != 0) {
        d->buttons = sample->buttons;
    }
    if ((valid & VBSS_DEVICE_HAS_TEMPERATURE) != 0) {
        d->temperature = sample->temperature;
    }
    if ((valid & VBSS_DEVICE_HAS_TOOL) != 0) {
        const bool is_other = sample->tool != d->tool;
        d->events |= is_other ? VBSS_DEVICE_EVENT_TOOL : 0u;
        d->tool = sample->tool;
        if (is_other && d->config.jaw_takeover != 0) {
            vbss_device_hold_opening(d, vbss_device_reported_opening(d));
        }
    }
    d->known_signals |=
        valid & (VBSS_DEVICE_HAS_BUTTONS | VBSS_DEVICE_HAS_TEMPERATURE | VBSS_DEVICE_HAS_TOOL);
}

static void accept_sample(device_object *d, uint32_t source, const vbss_device_sample *sample,
                          uint32_t valid, double now)
{
    device_source *s = &d->sources[source];
    if ((valid & VBSS_DEVICE_HAS_POSITION) != 0) {
        accept_pose(d, sample, valid, now);
    }
    if ((valid & DEVICE_JAW_SIGNALS) != 0) {
        accept_jaw(d, sample, valid, now);
    }
    accept_other_signals(d, sample, valid);
    s->has_time = true;
    s->time = sample->time;
    s->received_at = now;
}

static void restart_clock(device_object *d, uint32_t source)
{
    d->statistics.restarts[source]++;
    d->events |= VBSS_DEVICE_EVENT_RESTARTED;
    reset_filters(d, source);
    warn(d, source, "counts time anew");
}

static void count_refusal(device_object *d, uint64_t *count)
{
    (*count)++;
    d->events |= VBSS_DEVICE_EVENT_REFUSED;
}

static void process_sample(device_object *d, uint32_t source, const vbss_device_sample *sample,
                           double now)
{
    vbss_device_statistics *f = &d->statistics;
    uint32_t valid = sample->valid & vbss_device_routed_signals(d, source);
    bool restarted = false;
    switch (
        vbss_device_check_sample(&d->sources[source], sample, valid, now, &d->config, &restarted)) {
    case DEVICE_SAMPLE_ACCEPTED:
        if (restarted) {
            restart_clock(d, source);
        }
        f->accepted[source]++;
        accept_sample(d, source, sample, valid, now);
        break;
    case DEVICE_SAMPLE_REPEATED:
        f->repeated[source]++;
        break;
    case DEVICE_SAMPLE_OUT_OF_ORDER:
        count_refusal(d, &f->out_of_order[source]);
        break;
    case DEVICE_SAMPLE_NOT_FINITE:
        count_refusal(d, &f->not_finite[source]);
        break;
    case DEVICE_SAMPLE_OUT_OF_RANGE:
        count_refusal(d, &f->out_of_range[source]);
        break;
    case DEVICE_SAMPLE_NOT_UNIT:
        count_refusal(d, &f->not_unit[source]);
        break;
    }
}

void vbss_device_poll(device_object *d, uint32_t source, double now)
{
    device_source *s = &d->sources[source];
    const vbss_device_sample *sample;
    if (s->adapter.read == NULL) {
        return;
    }
    s->read_failed = vbss_device_read_source(d->context, s, now, &sample) != VBSS_OK;
    uint32_t flags = sample->flags;
    if (s->read_failed) {
        d->statistics.failed_reads[source]++;
        d->events |= VBSS_DEVICE_EVENT_FAILED;
    } else if ((flags & VBSS_DEVICE_FLAG_LOST) == 0) {
        process_sample(d, source, sample, now);
    }
    handle_flags(d, source, flags); /* last: a stop overwrites the sample's buffer */
}
