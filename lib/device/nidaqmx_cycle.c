/* One cycle of the lines: writes the newest commands to the solenoids, then reads all inputs and
 * reports them to the host. A cycle waits for the hardware, so it must not run inside a step of the
 * host. */
#include <string.h>

#include "device/nidaqmx.h"

/* ---- solenoids */

static void record_code(nidaqmx_object *o, int32_t code)
{
    if (code != 0) {
        o->report.status.error = code;
        o->report.status.warnings += code > 0;
        o->is_lost = o->is_lost || vbss_nidaqmx_is_lost(code);
    }
}

/* Writes 0 or 1 to each line. The first write starts the task, so a line is never driven before it
 * has a value. */
static int32_t write_lines(nidaqmx_object *o, const uint8_t *levels)
{
    int32_t written = 0;
    int32_t code = o->daq.write_digital(o->digital, 1, 1, o->config.timeout, DAQ_GROUP_BY_CHANNEL,
                                        levels, &written, NULL);
    o->levels_written = code >= 0 && written == 1;
    if (o->levels_written) {
        memcpy(o->levels, levels, sizeof o->levels);
    } else {
        o->report.status.failed_writes++;
    }
    record_code(o, code);
    return code;
}

static int32_t set_solenoids(nidaqmx_object *o, uint32_t wanted)
{
    uint8_t levels[DAQ_HANDLES] = {0};
    uint32_t line = 0;
    for (uint32_t i = 0; i < o->handle_count; i++) {
        if (o->lines[i][0] != '\0') {
            uint32_t on = wanted >> i & 1u;
            levels[line++] = (uint8_t)(o->config.active_low != 0 ? 1u - on : on);
        }
    }
    if (!o->has_lines || (o->levels_written && memcmp(levels, o->levels, sizeof levels) == 0)) {
        return 0;
    }
    int32_t code = write_lines(o, levels);
    o->report.status.solenoids = o->levels_written ? wanted : o->report.status.solenoids;
    return code;
}

int32_t vbss_nidaqmx_switch_off(nidaqmx_object *o)
{
    return set_solenoids(o, 0);
}

/* A command may be one cycle old when it is found, and stays in force until the next cycle. Both
 * cycles are assumed to take as long as the last one. If that is long, a command expires unless
 * this cycle found it. */
static bool is_expired(const nidaqmx_object *o, const handle_command *command, double age)
{
    return age > vbss_max(command->expires - 2.0 * o->cycle_interval, 0.0);
}

/* Bits of the solenoids that are to be on. A command that has expired counts as off. */
static uint32_t wanted_solenoids(nidaqmx_object *o, double now)
{
    uint32_t wanted = 0;
    bool is_silent = false;
    for (uint32_t i = 0; i < o->handle_count; i++) {
        daq_handle *h = &o->handles[i];
        if (device_triple_buffer_fetch(&h->to_cycle)) {
            h->commanded_at = now;
        }
        const handle_command *command = &h->commands[h->to_cycle.reader];
        bool is_too_old = is_expired(o, command, now - h->commanded_at);
        is_silent = is_silent || (command->is_on && is_too_old);
        wanted |= command->is_on && !is_too_old ? 1u << i : 0u;
    }
    o->report.status.silent_cycles += is_silent;
    return wanted;
}

/* ---- inputs */

static void read_inputs(nidaqmx_object *o, double now)
{
    double volts[DAQ_HANDLES] = {0.0};
    int32_t read = 0;
    int32_t code = o->daq.read_analog(o->analog, 1, o->config.timeout, DAQ_GROUP_BY_SCAN, volts,
                                      o->handle_count, &read, NULL);
    record_code(o, code);
    o->read_failed = code < 0 || read != 1;
    if (o->read_failed) {
        o->report.status.failed_reads++;
        return;
    }
    memcpy(o->report.volts, volts, sizeof volts);
    o->report.has_sample = true;
    o->report.time = now;
}

/* ---- cycle */

static void publish_report(nidaqmx_object *o)
{
    vbss_nidaqmx_status *s = &o->report.status;
    s->state = o->is_lost             ? VBSS_HARDWARE_LOST
               : o->read_failed       ? VBSS_HARDWARE_REFUSING
               : o->report.has_sample ? VBSS_HARDWARE_RUNNING
                                      : VBSS_HARDWARE_WAITING;
    o->reports[o->to_host.writer] = o->report;
    device_triple_buffer_publish(&o->to_host);
}

void vbss_nidaqmx_cycle(nidaqmx_object *o, double now)
{
    o->cycle_interval = o->report.status.cycles > 0
                            ? vbss_max(now - o->cycle_start, o->config.period)
                            : o->config.period;
    o->cycle_start = now;
    o->report.status.cycles++;
    uint32_t wanted = wanted_solenoids(o, now);
    set_solenoids(o, o->read_failed || o->is_lost ? 0 : wanted);
    if (!o->is_lost) {
        read_inputs(o, now);
    }
    if (o->read_failed || o->is_lost) { /* whether the jaws are closed is unknown */
        vbss_nidaqmx_switch_off(o);
    }
    publish_report(o);
}

void vbss_nidaqmx_run(void *user)
{
    nidaqmx_object *o = user;
    while (!atomic_load_explicit(&o->stop_requested, memory_order_acquire)) {
        const double start = vbss_device_time();
        vbss_nidaqmx_cycle(o, start);
        vbss_device_sleep(vbss_max(start + o->config.period - vbss_device_time(), 0.0));
    }
}
