/* A round of the lines: newest orders -> solenoids, then one sample of all inputs -> host. It waits for the hardware,
 * so it is never the host's step that runs it. */
#include <string.h>

#include "device/nidaqmx.h"

/* ---- solenoids */

static void heed(nidaqmx_object *o, int32_t code)
{
    if (code != 0) {
        o->seen.status.error = code;
        o->seen.status.warnings += code > 0;
        o->lost = o->lost || vbss_nidaqmx_is_lost(code);
    }
}

/* One byte a line, 0 or 1 only. The first write starts the task, so a line is never driven before it has a value. */
static int32_t write_lines(nidaqmx_object *o, const uint8_t *levels)
{
    int32_t written = 0;
    int32_t code = o->daq.write_digital(o->digital, 1, 1, o->config.timeout, DAQ_GROUP_BY_CHANNEL,
                                        levels, &written, NULL);
    o->written = code >= 0 && written == 1;
    if (o->written) {
        memcpy(o->out, levels, sizeof o->out);
    } else {
        o->seen.status.failed_writes++;
    }
    heed(o, code);
    return code;
}

static int32_t set_solenoids(nidaqmx_object *o, uint32_t wanted)
{
    uint8_t levels[HANDLES] = {0};
    uint32_t line = 0;
    for (uint32_t i = 0; i < o->handle_count; i++) {
        if (o->lines[i][0] != '\0') {
            uint32_t on = wanted >> i & 1u;
            levels[line++] = (uint8_t)(o->config.active_low != 0 ? 1u - on : on);
        }
    }
    if (!o->has_lines || (o->written && memcmp(levels, o->out, sizeof levels) == 0)) {
        return 0;
    }
    int32_t code = write_lines(o, levels);
    o->seen.status.solenoids = o->written ? wanted : o->seen.status.solenoids;
    return code;
}

int32_t vbss_nidaqmx_put_off(nidaqmx_object *o)
{
    return set_solenoids(o, 0);
}

/* An order may be a round old when it is found, and the next look comes a round later; rounds take as long as the hardware
 * does, so that is the last one's. Where it is long, what the last one had already is old. */
static bool is_old(const nidaqmx_object *o, const handle_order *order, double age)
{
    return age > vbss_max(order->expires - 2.0 * o->spacing, 0.0);
}

/* What is wanted of the solenoids, unless the host was silent for too long. */
static uint32_t wanted_now(nidaqmx_object *o, double now)
{
    uint32_t wanted = 0;
    bool silent = false;
    for (uint32_t i = 0; i < o->handle_count; i++) {
        handle *h = &o->handles[i];
        if (device_exchange_take(&h->to_round)) {
            h->ordered_at = now;
        }
        const handle_order *order = &h->orders[h->to_round.reader];
        bool old = is_old(o, order, now - h->ordered_at);
        silent = silent || (order->on && old);
        wanted |= order->on && !old ? 1u << i : 0u;
    }
    o->seen.status.silent_cycles += silent;
    return wanted;
}

/* ---- inputs */

static void measure(nidaqmx_object *o, double now)
{
    double volts[HANDLES] = {0.0};
    int32_t read = 0;
    int32_t code = o->daq.read_analog(o->analog, 1, o->config.timeout, DAQ_GROUP_BY_SCAN, volts,
                                      o->handle_count, &read, NULL);
    heed(o, code);
    o->failing = code < 0 || read != 1;
    if (o->failing) {
        o->seen.status.failed_reads++;
        return;
    }
    memcpy(o->seen.volts, volts, sizeof volts);
    o->seen.measured = true;
    o->seen.time = now;
}

/* ---- a round */

static void report(nidaqmx_object *o)
{
    vbss_nidaqmx_status *s = &o->seen.status;
    s->state = o->lost            ? VBSS_HARDWARE_LOST
               : o->failing       ? VBSS_HARDWARE_REFUSING
               : o->seen.measured ? VBSS_HARDWARE_RUNNING
                                  : VBSS_HARDWARE_WAITING;
    o->reports[o->to_host.writer] = o->seen;
    device_exchange_publish(&o->to_host);
}

void vbss_nidaqmx_round(nidaqmx_object *o, double now)
{
    o->spacing = o->seen.status.cycles > 0 ? vbss_max(now - o->begun_at, o->config.period)
                                           : o->config.period;
    o->begun_at = now;
    o->seen.status.cycles++;
    uint32_t wanted = wanted_now(o, now);
    set_solenoids(o, o->failing || o->lost ? 0 : wanted);
    if (!o->lost) {
        measure(o, now);
    }
    if (o->failing || o->lost) { /* nobody knows whether the jaws are closed */
        vbss_nidaqmx_put_off(o);
    }
    report(o);
}

void vbss_nidaqmx_run(void *user)
{
    nidaqmx_object *o = user;
    while (!atomic_load_explicit(&o->ending, memory_order_acquire)) {
        const double begin = vbss_device_time();
        vbss_nidaqmx_round(o, begin);
        vbss_device_sleep(vbss_max(begin + o->config.period - vbss_device_time(), 0.0));
    }
}
