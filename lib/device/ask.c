/* Asking one adapter: its sample judged, and taken part by part; then what it says about itself. */
#include "base/error.h"
#include "device/device.h"

/* ---- what a device says about itself */

static void warn(const device_object *d, uint32_t source, const char *what)
{
    vbss_message(d->context, VBSS_LOG_WARNING, "%s %s", d->sources[source].name, what);
}

/* What comes next may count time anew: no filter looks back. */
static void forget_filters(device_object *d, uint32_t source)
{
    uint32_t routed = vbss_device_routed(d, source);
    if ((routed & VBSS_DEVICE_HAS_POSITION) != 0) {
        vbss_device_forget_motion(&d->motion);
    }
    if ((routed & DEVICE_JAW_SIGNALS) != 0) {
        d->jaw.known = false;
    }
}

static void stop(device_object *d)
{
    vbss_device_latch(d);
    d->events |= VBSS_DEVICE_EVENT_STOPPED;
}

static void lose(device_object *d, uint32_t source)
{
    device_source *s = &d->sources[source];
    s->lost = true;
    s->timed = false;
    forget_filters(d, source);
    d->statistics.lost[source]++;
    d->events |= VBSS_DEVICE_EVENT_LOST;
    if (d->config.stop_when_lost != 0 && !d->output.stopped) {
        stop(d);
    }
    vbss_device_note_failure(d->context, s, VBSS_ERROR_DEVICE);
    vbss_message(d->context, VBSS_LOG_WARNING, "%s is lost: %s", s->name,
                 s->text[0] == '\0' ? "no reason is given" : s->text);
}

/* A read that failed says nothing of what is over. */
static void heed_flags(device_object *d, uint32_t source, uint32_t flags)
{
    device_source *s = &d->sources[source];
    bool lost = (flags & VBSS_DEVICE_FLAG_LOST) != 0, fault = (flags & VBSS_DEVICE_FLAG_FAULT) != 0;
    if (lost && !s->lost) {
        lose(d, source);
    } else if (s->lost && !lost && !s->mute) {
        s->lost = false;
        d->events |= VBSS_DEVICE_EVENT_FOUND;
        warn(d, source, "is back");
    }
    if ((flags & VBSS_DEVICE_FLAG_STOP) != 0 && !d->output.stopped) {
        stop(d);
        warn(d, source, "asks for an emergency stop");
    }
    if (fault && !s->fault) {
        d->statistics.faults[source]++;
        d->events |= VBSS_DEVICE_EVENT_FAULT;
        warn(d, source, "refuses forces");
    }
    s->fault = fault || (s->fault && s->mute);
}

/* ---- what a sample says */

static void renew(device_part *part, double now, double time)
{
    part->known = true;
    part->heard = now;
    part->time = time;
}

static void take_pose(device_object *d, const vbss_device_sample *sample, uint32_t valid,
                      double now)
{
    const bool oriented = (valid & VBSS_DEVICE_HAS_ORIENTATION) != 0;
    d->position = vec3_load(sample->position);
    if (oriented) {
        d->orientation = quat_unit(quat_make(sample->orientation[0], sample->orientation[1],
                                             sample->orientation[2], sample->orientation[3]));
    }
    vbss_device_follow(&d->motion, d->config.velocity_time, sample->time, d->position,
                       oriented ? &d->orientation : NULL);
    d->velocity =
        (valid & VBSS_DEVICE_HAS_VELOCITY) != 0 ? vec3_load(sample->velocity) : d->motion.velocity;
    d->spin = (valid & VBSS_DEVICE_HAS_ANGULAR_VELOCITY) != 0 ? vec3_load(sample->angular_velocity)
                                                              : d->motion.spin;
    d->known |= valid & (DEVICE_POSE_SIGNALS | DEVICE_MOTION_SIGNALS);
    d->known |= d->motion.moving ? VBSS_DEVICE_HAS_VELOCITY : 0u;
    d->known |= d->motion.spinning ? VBSS_DEVICE_HAS_ANGULAR_VELOCITY : 0u;
    renew(&d->pose, now, sample->time);
}

static void take_jaw(device_object *d, const vbss_device_sample *sample, uint32_t valid, double now)
{
    const bool calibrated = (valid & VBSS_DEVICE_HAS_JAW) != 0;
    if ((valid & VBSS_DEVICE_HAS_JAW_RAW) != 0) {
        d->jaw_raw = sample->jaw_raw;
        d->known |= VBSS_DEVICE_HAS_JAW_RAW;
    }
    if (!calibrated && !vbss_device_believes_raw(&d->calibration, sample->jaw_raw)) {
        d->statistics.jaw_refused++;
        d->events |= VBSS_DEVICE_EVENT_REFUSED;
        return;
    }
    double opening =
        calibrated ? sample->jaw : vbss_device_opening_of(&d->calibration, sample->jaw_raw);
    vbss_device_move_jaw(&d->jaw, &d->calibration, opening, sample->time - d->opening.time);
    d->known |= VBSS_DEVICE_HAS_JAW;
    renew(&d->opening, now, sample->time);
}

static void take_rest(device_object *d, const vbss_device_sample *sample, uint32_t valid)
{
    if ((valid & VBSS_DEVICE_HAS_BUTTONS) != 0) {
        d->buttons = sample->buttons;
    }
    if ((valid & VBSS_DEVICE_HAS_TEMPERATURE) != 0) {
        d->temperature = sample->temperature;
    }
    if ((valid & VBSS_DEVICE_HAS_TOOL) != 0) {
        d->events |= sample->tool != d->tool ? VBSS_DEVICE_EVENT_TOOL : 0u;
        d->tool = sample->tool;
    }
    d->known |=
        valid & (VBSS_DEVICE_HAS_BUTTONS | VBSS_DEVICE_HAS_TEMPERATURE | VBSS_DEVICE_HAS_TOOL);
}

static void take(device_object *d, uint32_t source, const vbss_device_sample *sample,
                 uint32_t valid, double now)
{
    device_source *s = &d->sources[source];
    if ((valid & VBSS_DEVICE_HAS_POSITION) != 0) {
        take_pose(d, sample, valid, now);
    }
    if ((valid & DEVICE_JAW_SIGNALS) != 0) {
        take_jaw(d, sample, valid, now);
    }
    take_rest(d, sample, valid);
    s->timed = true;
    s->time = sample->time;
    s->heard = now;
}

static void restart(device_object *d, uint32_t source)
{
    d->statistics.restarts[source]++;
    d->events |= VBSS_DEVICE_EVENT_RESTARTED;
    forget_filters(d, source);
    warn(d, source, "counts time anew");
}

static void refuse(device_object *d, uint64_t *count)
{
    (*count)++;
    d->events |= VBSS_DEVICE_EVENT_REFUSED;
}

static void judge(device_object *d, uint32_t source, const vbss_device_sample *sample, double now)
{
    vbss_device_statistics *f = &d->statistics;
    uint32_t valid = sample->valid & vbss_device_routed(d, source);
    bool restarted = false;
    switch (vbss_device_judge(&d->sources[source], sample, valid, now, &d->config, &restarted)) {
    case DEVICE_TAKEN:
        if (restarted) {
            restart(d, source);
        }
        f->accepted[source]++;
        take(d, source, sample, valid, now);
        break;
    case DEVICE_REPEATED:
        f->repeated[source]++;
        break;
    case DEVICE_OUT_OF_ORDER:
        refuse(d, &f->out_of_order[source]);
        break;
    case DEVICE_NOT_FINITE:
        refuse(d, &f->not_finite[source]);
        break;
    case DEVICE_OUT_OF_RANGE:
        refuse(d, &f->out_of_range[source]);
        break;
    case DEVICE_NOT_UNIT:
        refuse(d, &f->not_unit[source]);
        break;
    }
}

void vbss_device_ask(device_object *d, uint32_t source, double now)
{
    device_source *s = &d->sources[source];
    const vbss_device_sample *sample;
    if (s->adapter.read == NULL) {
        return;
    }
    s->mute = vbss_device_read_source(d->context, s, now, &sample) != VBSS_OK;
    uint32_t flags = sample->flags;
    if (s->mute) {
        d->statistics.failed_reads[source]++;
        d->events |= VBSS_DEVICE_EVENT_FAILED;
    } else if ((flags & VBSS_DEVICE_FLAG_LOST) == 0) {
        judge(d, source, sample, now);
    }
    heed_flags(d, source, flags); /* last: a stop writes to where the sample is */
}
