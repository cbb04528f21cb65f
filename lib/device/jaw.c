/* Opening of the handle: calibrated range, low-pass filter, play, and when the jaws count as
 * closed. */
#include "device/device.h"

/* 0 at the closed end of the calibrated range, 1 at the open end; not clamped. */
static double range_fraction(const vbss_device_calibration *c, double raw)
{
    return (raw - c->jaw_closed) / (c->jaw_open - c->jaw_closed);
}

bool vbss_device_is_plausible_raw(const vbss_device_calibration *c, double raw)
{
    double fraction = range_fraction(c, raw);
    return fraction >= -c->jaw_margin && fraction <= 1.0 + c->jaw_margin;
}

double vbss_device_opening_from_raw(const vbss_device_calibration *c, double raw)
{
    return vbss_min(vbss_max(range_fraction(c, raw), 0.0), 1.0);
}

/* The value behind the play stays half of the play away from either end. This stretches it so that
 * the opening still reaches 0 and 1. */
static double compensate_play(double play, double half)
{
    return vbss_min(vbss_max((play - half) / (1.0 - 2.0 * half), 0.0), 1.0);
}

void vbss_device_update_jaw(device_jaw *jaw, const vbss_device_calibration *c, double opening,
                            double h)
{
    double half = 0.5 * c->jaw_play;
    if (!jaw->is_known) { /* the filter starts at the first opening */
        jaw->is_known = true;
        jaw->filtered = opening;
        jaw->after_play = half + (1.0 - 2.0 * half) * opening;
    } else {
        jaw->filtered += device_smoothing_factor(h, c->jaw_time) * (opening - jaw->filtered);
    }
    jaw->after_play =
        vbss_min(vbss_max(jaw->after_play, jaw->filtered - half), jaw->filtered + half);
    jaw->opening = compensate_play(jaw->after_play, half);
    if (jaw->opening <= c->jaw_close_at) {
        jaw->is_closed = true;
    } else if (jaw->opening >= c->jaw_open_at) {
        jaw->is_closed = false;
    }
}
