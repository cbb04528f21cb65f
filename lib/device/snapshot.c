/* Saves, restores and hashes the state of the device layer. The state of the adapters is not part
 * of it. */
#include "base/check.h"
#include "base/stream.h"
#include "device/device.h"

static void visit_quat(vbss_stream *stream, uint16_t tag, quat *q)
{
    vbss_stream_f64(stream, tag, &q->w, 4);
    if (!(fabs(quat_dot(*q, *q) - 1.0) < 1e-9)) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "an orientation is not of length 1");
    }
}

/* `bound` is for the components, so that results computed from them stay finite. */
static void visit_vec3(vbss_stream *stream, uint16_t tag, vec3 *v, double bound)
{
    double x[3];
    vbss_stream_f64(stream, tag, &v->x, 3);
    vec3_store(x, *v);
    if (!(vbss_max_abs(x, 3) <= bound)) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "a vector is too long");
    }
}

/* ---- configuration and calibration */

static void visit_config(vbss_stream *stream, const device_object *d)
{
    const vbss_device_config *c = &d->config;
    const uint32_t words[] = {(uint32_t)c->tool, c->second_signals,     (uint32_t)c->clock,
                              c->stop_when_lost, c->clutch_orientation, d->source_count};
    const double numbers[] = {d->jaw_timeout, c->velocity_time, c->norm_tolerance};
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        vbss_stream_expect(stream, 1, words[i]);
    }
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        vbss_stream_expect_f64(stream, 2, numbers[i]);
    }
    for (uint32_t i = 0; i < d->source_count; i++) {
        vbss_stream_expect(stream, 3, d->sources[i].capabilities.outputs);
    }
    if (c->jaw_takeover != 0) {
        vbss_stream_expect(stream, 5, c->jaw_takeover);
    }
    vbss_output_visit_config(stream, &d->limits);
}

/* Reads into a copy, because only a valid calibration has a frame. */
static void visit_calibration(vbss_stream *stream, device_object *d)
{
    vbss_device_calibration c = d->calibration;
    double *const numbers[] = {&c.scale,    &c.force_scale,  &c.jaw_closed,
                               &c.jaw_open, &c.jaw_margin,   &c.jaw_play,
                               &c.jaw_time, &c.jaw_close_at, &c.jaw_open_at};
    vbss_stream_i32(stream, 10, c.axes, 3);
    vbss_stream_f64(stream, 11, c.rotation, 9);
    vbss_stream_f64(stream, 12, c.offset, 3);
    vbss_stream_f64(stream, 13, c.mount, 4);
    vbss_stream_f64(stream, 14, c.workspace_low, 3);
    vbss_stream_f64(stream, 15, c.workspace_high, 3);
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        vbss_stream_f64(stream, 16, numbers[i], 1);
    }
    if (stream->mode != VBSS_STREAM_READ || stream->result != VBSS_OK) {
        return;
    }
    if (vbss_device_check_calibration(NULL, &c) != VBSS_OK) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no calibration is like this");
        return;
    }
    d->calibration = c;
    d->frame = vbss_device_make_frame(&c);
}

/* ---- input */

static void visit_source(vbss_stream *stream, device_source *s)
{
    vbss_stream_bool(stream, 20, &s->is_lost);
    vbss_stream_bool(stream, 21, &s->has_fault);
    vbss_stream_bool(stream, 22, &s->read_failed);
    vbss_stream_bool(stream, 23, &s->has_time);
    vbss_stream_f64(stream, 24, &s->time, 1);
    vbss_stream_f64(stream, 25, &s->received_at, 1);
}

static void visit_reading(vbss_stream *stream, device_reading *reading)
{
    vbss_stream_bool(stream, 30, &reading->is_known);
    vbss_stream_bool(stream, 31, &reading->is_stale);
    vbss_stream_f64(stream, 32, &reading->time, 1);
    vbss_stream_f64(stream, 33, &reading->received_at, 1);
    vbss_stream_f64(stream, 34, &reading->age, 1);
}

static void visit_motion(vbss_stream *stream, device_motion *m)
{
    vbss_stream_bool(stream, 40, &m->has_position);
    vbss_stream_bool(stream, 41, &m->has_velocity);
    vbss_stream_bool(stream, 42, &m->has_orientation);
    vbss_stream_bool(stream, 43, &m->has_spin);
    vbss_stream_f64(stream, 44, &m->time, 1);
    visit_vec3(stream, 45, &m->position, 1e3);
    visit_vec3(stream, 46, &m->velocity, 1e10);
    visit_vec3(stream, 47, &m->spin, 1e10);
    visit_quat(stream, 48, &m->orientation);
}

static void visit_jaw(vbss_stream *stream, device_jaw *jaw)
{
    vbss_stream_bool(stream, 50, &jaw->is_known);
    vbss_stream_bool(stream, 51, &jaw->is_closed);
    vbss_stream_f64(stream, 52, &jaw->filtered, 1);
    vbss_stream_f64(stream, 53, &jaw->after_play, 1);
    vbss_stream_f64(stream, 54, &jaw->opening, 1);
    if (!(jaw->opening >= 0.0 && jaw->opening <= 1.0)) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no jaws are that open");
    }
}

static void visit_takeover(vbss_stream *stream, device_takeover *t)
{
    vbss_stream_bool(stream, 55, &t->is_waiting);
    vbss_stream_bool(stream, 56, &t->has_side);
    vbss_stream_bool(stream, 57, &t->is_above);
    vbss_stream_f64(stream, 58, &t->opening, 1);
    if (!(t->opening >= 0.0 && t->opening <= 1.0)) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no jaws are that open");
    }
}

static void visit_sample(vbss_stream *stream, device_object *d)
{
    vbss_stream_u32(stream, 60, &d->known_signals, 1);
    visit_vec3(stream, 61, &d->position, 1e3);
    visit_vec3(stream, 62, &d->velocity, 1e10);
    visit_vec3(stream, 63, &d->spin, 1e10);
    visit_quat(stream, 64, &d->orientation);
    vbss_stream_f64(stream, 65, &d->jaw_raw, 1);
    vbss_stream_f64(stream, 66, &d->temperature, 1);
    vbss_stream_u32(stream, 67, &d->buttons, 1);
    vbss_stream_i32(stream, 68, &d->tool, 1);
    vbss_stream_bool(stream, 69, &d->is_clutched);
    vbss_stream_bool(stream, 70, &d->write_failed);
    visit_vec3(stream, 71, &d->position_offset, 1e7);
    visit_quat(stream, 72, &d->orientation_offset);
    visit_vec3(stream, 73, &d->clutch_pose.position, 1e3);
    visit_quat(stream, 74, &d->clutch_pose.orientation);
    visit_vec3(stream, 75, &d->reported_pose.position, 1e3);
    visit_quat(stream, 76, &d->reported_pose.orientation);
    if (d->tool < VBSS_DEVICE_TOOL_NONE || d->tool > VBSS_DEVICE_TOOL_SHEARS) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "there is no such tool");
    }
}

/* ---- statistics, and the whole state */

static void visit_figures(vbss_stream *stream, vbss_device_statistics *f)
{
    uint64_t *const counts[] = {&f->reads,         &f->writes,           &f->jaw_refused,
                                &f->pose_stale,    &f->pose_stale_reads, &f->jaw_stale,
                                &f->clamped_reads, &f->clutches};
    uint64_t *const pairs[] = {f->accepted,     f->repeated, f->out_of_order, f->not_finite,
                               f->out_of_range, f->not_unit, f->failed_reads, f->failed_writes,
                               f->lost,         f->faults,   f->restarts};
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        vbss_stream_u64(stream, 80, counts[i], 1);
    }
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
        vbss_stream_u64(stream, 81, pairs[i], 2);
    }
    vbss_stream_f64(stream, 82, &f->oldest_pose, 1);
}

void vbss_device_serialise(vbss_stream *stream, void *object)
{
    device_object *d = object;
    visit_config(stream, d);
    visit_calibration(stream, d);
    vbss_stream_bool(stream, 4, &d->has_time);
    vbss_stream_bool(stream, 5, &d->has_written);
    vbss_stream_f64(stream, 6, &d->now, 1);
    vbss_stream_f64(stream, 7, &d->read_at, 1);
    vbss_stream_f64(stream, 8, &d->written_at, 1);
    const double times[] = {d->now, d->read_at, d->written_at};
    if (vbss_max_abs(times, 3) > 1e9 || d->read_at > d->now || d->written_at > d->now) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no host's clock says so");
    }
    for (uint32_t i = 0; i < d->source_count; i++) {
        visit_source(stream, &d->sources[i]);
    }
    visit_reading(stream, &d->pose_reading);
    visit_reading(stream, &d->opening_reading);
    visit_motion(stream, &d->motion);
    visit_jaw(stream, &d->jaw);
    if (d->config.jaw_takeover != 0) {
        visit_takeover(stream, &d->takeover);
    }
    visit_sample(stream, d);
    vbss_output_visit_state(stream, &d->limits, &d->output);
    visit_figures(stream, &d->statistics);
}
