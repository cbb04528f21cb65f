/* A solenoid that cannot burn: on for a limited time, and for a limited part of it. Off is the safe side.
 *
 * A store of on-time: full it holds solenoid_time; it runs out while the solenoid is on, and fills with d / (1 -
 * d) while it is off, so that in the long run the solenoid is on for the part d. Wanted for longer, it goes off
 * and stays off until it is not wanted for a moment. */
#include "device/device.h"

static void account(const vbss_output_config *c, output_solenoid *s, double h,
                    vbss_output_statistics *statistics)
{
    if (s->on) {
        s->left -= h;
        statistics->solenoid_on += h;
    } else {
        s->left += h * (c->solenoid_duty / (1.0 - c->solenoid_duty));
    }
    s->left = vbss_min(vbss_max(s->left, 0.0), c->solenoid_time);
}

uint32_t vbss_output_switch(const vbss_output_config *c, output_solenoid *s, double h, bool wanted,
                            bool blocked, vbss_output_statistics *statistics)
{
    account(c, s, h, statistics);
    s->spent = s->spent && wanted;
    bool was = s->on;
    s->on = false;
    if (!wanted) {
        return 0;
    }
    if (blocked) {
        return VBSS_OUTPUT_SOLENOID_OFF;
    }
    /* The next step will be about as long as this one. */
    if (s->spent || !(s->left > 0.0 && s->left >= vbss_min(h, OUTPUT_LONGEST))) {
        s->spent = true;
        return VBSS_OUTPUT_SOLENOID_SPENT;
    }
    s->on = true;
    statistics->pulses += was ? 0 : 1;
    return 0;
}
