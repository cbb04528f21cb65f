/* Protects a solenoid from overheating: limits the time that it is on, and its duty cycle. Off is
 * the safe state.
 *
 * The time left is at most solenoid_time. It falls at rate 1 while the solenoid is on, and rises at
 * the rate d / (1 - d) while it is off; in the long run the duty cycle is thus at most d
 * (solenoid_duty). When no time is left, the solenoid goes off, and stays off until a step does not
 * want it. */
#include "device/device.h"

static void update_time_left(const vbss_output_config *c, output_solenoid *s, double h,
                             vbss_output_statistics *statistics)
{
    if (s->is_on) {
        s->time_left -= h;
        statistics->solenoid_on += h;
    } else {
        s->time_left += h * (c->solenoid_duty / (1.0 - c->solenoid_duty));
    }
    s->time_left = vbss_min(vbss_max(s->time_left, 0.0), c->solenoid_time);
}

uint32_t vbss_output_switch_solenoid(const vbss_output_config *c, output_solenoid *s, double h,
                                     bool wanted, bool blocked, vbss_output_statistics *statistics)
{
    update_time_left(c, s, h, statistics);
    s->is_exhausted = s->is_exhausted && wanted;
    bool was_on = s->is_on;
    s->is_on = false;
    if (!wanted) {
        return 0;
    }
    if (blocked) {
        return VBSS_OUTPUT_FLAG_SOLENOID_OFF;
    }
    /* The next step is assumed to be about as long as this one. */
    if (s->is_exhausted ||
        !(s->time_left > 0.0 && s->time_left >= vbss_min(h, DEVICE_MAX_RISE_TIME))) {
        s->is_exhausted = true;
        return VBSS_OUTPUT_FLAG_SOLENOID_SPENT;
    }
    s->is_on = true;
    statistics->pulses += was_on ? 0 : 1;
    return 0;
}
