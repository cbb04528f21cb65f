/* How far the handle is open: range, filter, play, and when the jaws count as closed. */
#include "device/device.h"

/* 0 at the closed end, 1 at the open one, and beyond. */
static double part_of_range(const vbss_device_calibration *c, double raw)
{
    return (raw - c->jaw_closed) / (c->jaw_open - c->jaw_closed);
}

bool vbss_device_believes_raw(const vbss_device_calibration *c, double raw)
{
    double part = part_of_range(c, raw);
    return part >= -c->jaw_margin && part <= 1.0 + c->jaw_margin;
}

double vbss_device_opening_of(const vbss_device_calibration *c, double raw)
{
    return vbss_min(vbss_max(part_of_range(c, raw), 0.0), 1.0);
}

/* The opening goes through both ends although the play swallows half of itself at each. */
static double stretched(double play, double half)
{
    return vbss_min(vbss_max((play - half) / (1.0 - 2.0 * half), 0.0), 1.0);
}

void vbss_device_move_jaw(device_jaw *jaw, const vbss_device_calibration *c, double opening,
                          double h)
{
    double half = 0.5 * c->jaw_play;
    if (!jaw->known) { /* from where it is, not from closed */
        jaw->known = true;
        jaw->filtered = opening;
        jaw->play = half + (1.0 - 2.0 * half) * opening;
    } else {
        jaw->filtered += device_share(h, c->jaw_time) * (opening - jaw->filtered);
    }
    jaw->play = vbss_min(vbss_max(jaw->play, jaw->filtered - half), jaw->filtered + half);
    jaw->opening = stretched(jaw->play, half);
    if (jaw->opening <= c->jaw_close_at) {
        jaw->closed = true;
    } else if (jaw->opening >= c->jaw_open_at) {
        jaw->closed = false;
    }
}
