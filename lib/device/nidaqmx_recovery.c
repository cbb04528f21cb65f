/* Recovery of the lines from errors, and their pace. The functions run in the thread of the
 * cycle. */
#include "device/nidaqmx.h"
#include "device/tuning.h"

/* ---- timeouts */

static void lengthen_timeout(nidaqmx_object *o)
{
    if (o->config.timeout == 0.0) {
        o->timeout = vbss_min(2.0 * o->timeout, DEVICE_DAQ_LONGEST_TIMEOUT);
    }
}

/* Calls that are quick again for long get the short timeout back, so that a later fault does not
 * delay the solenoids. */
static void shorten_timeout(nidaqmx_object *o, double duration)
{
    o->quick_calls = duration < 0.25 * o->timeout ? o->quick_calls + 1 : 0;
    if (o->config.timeout == 0.0 && o->config.own_thread != 0 &&
        o->quick_calls >= DEVICE_DAQ_QUICK_CALLS) {
        o->timeout = vbss_max(0.5 * o->timeout, DEVICE_DAQ_FIRST_TIMEOUT);
        o->quick_calls = 0;
    }
}

static void note_timeout(nidaqmx_object *o, int32_t code, double duration, uint32_t *in_a_row)
{
    if (vbss_nidaqmx_remedy(code) != DAQ_RETRY) {
        *in_a_row = 0;
        shorten_timeout(o, duration);
        return;
    }
    o->report.status.timeouts++;
    (*in_a_row)++;
    if (*in_a_row % DAQ_TIMEOUTS_IN_A_ROW == 0) {
        lengthen_timeout(o);
    }
}

void vbss_nidaqmx_record_code(nidaqmx_object *o, int32_t code, double duration, uint32_t *in_a_row)
{
    vbss_nidaqmx_status *s = &o->report.status;
    if (code != 0) {
        s->error = code;
        s->warnings += code > 0;
    }
    note_timeout(o, code, duration, in_a_row);
    const daq_remedy remedy = vbss_nidaqmx_remedy(code);
    if (remedy == DAQ_REOPEN || remedy == DAQ_LOST) {
        if (!o->must_reopen) {
            o->trouble_since = o->reopen_at = o->cycle_start;
        }
        o->must_reopen = true;
        o->is_lost = o->is_lost || remedy == DAQ_LOST;
    }
}

/* ---- opening the lines again */

/* A clock that has stepped back does not delay the next attempt. */
static bool is_due(const nidaqmx_object *o, double now)
{
    const double wait = o->reopen_at - now;
    return wait <= 0.0 || wait > DEVICE_DAQ_REOPEN_INTERVAL;
}

void vbss_nidaqmx_recover(nidaqmx_object *o, double now)
{
    const char *what;
    if (!o->must_reopen || !is_due(o, now)) {
        return;
    }
    o->reopen_at = now + DEVICE_DAQ_REOPEN_INTERVAL;
    vbss_nidaqmx_close_tasks(o);
    if (vbss_nidaqmx_open_tasks(o, &what) >= 0) {
        o->must_reopen = o->is_lost = false;
        o->report.status.reopened++;
        return;
    }
    o->is_lost = o->is_lost || now - o->trouble_since > DEVICE_DAQ_GRACE_TIME;
}

/* ---- pace */

/* The mean over about 16 rounds ignores single late rounds of a busy machine. */
static void update_mean(nidaqmx_object *o)
{
    vbss_nidaqmx_status *s = &o->report.status;
    s->round_time = s->cycles > 1 ? s->round_time + (o->cycle_interval - s->round_time) / 16.0
                                  : o->cycle_interval;
}

/* A command may be one round old when it is found, and is in force for one round at least. So a
 * solenoid goes off after two rounds, if these are longer than the time after which the command
 * expires. */
void vbss_nidaqmx_update_rate(nidaqmx_object *o, double expires)
{
    vbss_nidaqmx_status *s = &o->report.status;
    update_mean(o);
    s->timeout = o->timeout;
    if (!o->has_lines || expires <= 0.0) {
        return;
    }
    s->off_time = vbss_max(expires, 2.0 * s->round_time) + o->write_time;
    const double limit = o->is_slow ? DEVICE_DAQ_RATE_HYSTERESIS * expires : expires;
    o->is_slow = 2.0 * s->round_time > limit * (1.0 + 1e-9);
    s->late_rounds += o->is_slow;
}
