/* One cycle of the lines: writes the newest commands to the solenoids, then reads all inputs and
 * reports them to the host. A cycle waits for the hardware, so it must not run inside a step of the
 * host. */
#include <string.h>

#include "device/nidaqmx.h"

/* ---- solenoids */

/* NI-DAQmx Base takes one byte with the levels of a port. Lines without a solenoid stay high, as
 * they are when no program drives them. */
static uint8_t port_levels(const nidaqmx_object *o, const uint8_t *levels)
{
    uint32_t port = 0xFFu, line = 0;
    for (uint32_t i = 0; i < o->handle_count; i++) {
        if (o->lines[i][0] != '\0' && levels[line++] == 0) {
            port &= ~(1u << o->line_bits[i]);
        }
    }
    return (uint8_t)port;
}

/* Writes 0 or 1 to each line. The first write starts the task, so a line is never driven before it
 * has a value. */
static int32_t write_lines(nidaqmx_object *o, const uint8_t *levels)
{
    const uint8_t port = port_levels(o, levels);
    const double start = vbss_device_time();
    int32_t written[2] = {0, 0}; /* some versions of the vendor's library write 8 bytes */
    int32_t code = o->daq.write_digital(o->digital, 1, 1, o->timeout, DAQ_GROUP_BY_CHANNEL,
                                        o->daq.is_base ? &port : levels, written, NULL);
    o->write_time = vbss_device_time() - start;
    o->levels_written = code >= 0 && written[0] == 1;
    if (o->levels_written) {
        memcpy(o->levels, levels, sizeof o->levels);
    } else {
        o->report.status.failed_writes++;
    }
    vbss_nidaqmx_record_code(o, code, o->write_time, &o->write_timeouts);
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
    if (!o->lines_open || (o->levels_written && memcmp(levels, o->levels, sizeof levels) == 0)) {
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
 * this cycle found it. After a step back of the clock the age is negative, and the command counts
 * as expired. */
static bool is_expired(const nidaqmx_object *o, const handle_command *command, double age)
{
    return age < 0.0 || age > vbss_max(command->expires - 2.0 * o->cycle_interval, 0.0);
}

/* Bits of the solenoids that are to be on. A command that has expired counts as off. `expires`
 * receives the shortest time after which a command expires, s; 0: there is no command. */
static uint32_t wanted_solenoids(nidaqmx_object *o, double now, double *expires)
{
    uint32_t wanted = 0;
    bool is_silent = false;
    *expires = 0.0;
    for (uint32_t i = 0; i < o->handle_count; i++) {
        daq_handle *h = &o->handles[i];
        if (vbss_triple_buffer_fetch(&h->to_cycle)) {
            h->commanded_at = now;
        }
        const handle_command *command = &h->commands[h->to_cycle.reader];
        bool is_too_old = is_expired(o, command, now - h->commanded_at);
        is_silent = is_silent || (command->is_on && is_too_old);
        wanted |= command->is_on && !is_too_old ? 1u << i : 0u;
        if (command->expires > 0.0 && (*expires == 0.0 || command->expires < *expires)) {
            *expires = command->expires;
        }
    }
    o->report.status.silent_cycles += is_silent;
    return wanted;
}

/* ---- inputs */

static void read_inputs(nidaqmx_object *o, double now)
{
    double volts[DAQ_HANDLES] = {0.0};
    int32_t read[2] = {0, 0}; /* as in write_lines */
    const double start = vbss_device_time();
    int32_t code = o->daq.read_analog(o->analog, 1, o->timeout, DAQ_GROUP_BY_SCAN, volts,
                                      o->handle_count, read, NULL);
    vbss_nidaqmx_record_code(o, code, vbss_device_time() - start, &o->read_timeouts);
    o->read_failed = code < 0 || read[0] != 1;
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
    s->state = o->is_lost                         ? VBSS_HAPTICS_STATE_LOST
               : o->read_failed || o->must_reopen ? VBSS_HAPTICS_STATE_REFUSING
               : o->report.has_sample             ? VBSS_HAPTICS_STATE_RUNNING
                                                  : VBSS_HAPTICS_STATE_WAITING;
    o->report.is_slow = o->is_slow;
    o->report.has_late_reads = o->read_timeouts >= DAQ_TIMEOUTS_IN_A_ROW;
    o->reports[o->to_host.writer] = o->report;
    vbss_triple_buffer_publish(&o->to_host);
}

static void begin_cycle(nidaqmx_object *o, double now)
{
    o->cycle_interval = o->report.status.cycles > 0
                            ? vbss_max(now - o->cycle_start, o->config.period)
                            : o->config.period;
    o->cycle_start = now;
    o->report.status.cycles++;
}

void vbss_nidaqmx_cycle(nidaqmx_object *o, double now)
{
    double expires;
    begin_cycle(o, now);
    uint32_t wanted = wanted_solenoids(o, now, &expires);
    vbss_nidaqmx_update_rate(o, expires);
    vbss_nidaqmx_recover(o, now);
    set_solenoids(o, o->read_failed || o->must_reopen ? 0 : wanted);
    if (!o->must_reopen) {
        read_inputs(o, now);
    }
    if (o->read_failed || o->must_reopen) { /* whether the jaws are closed is unknown */
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
