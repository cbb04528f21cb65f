/* Takeover of the jaws by a handle: after a restore, an exchange or the clutch the jaws stay as they
 * are until the handle has been where they are. */
#include <math.h>

#include "device/device.h"

void vbss_device_hold_opening(device_object *d, double opening)
{
    d->takeover = (device_takeover){.is_waiting = true, .is_new = true, .opening = opening};
}

/* Whether the handle is at the opening, or has been on both sides of it. */
static bool has_passed(device_takeover *t, double handle)
{
    const bool is_above = handle > t->opening, was_above = t->is_above;
    const bool has_crossed = t->has_side && is_above != was_above;
    t->has_side = true;
    t->is_above = is_above;
    return has_crossed || fabs(handle - t->opening) <= DEVICE_TAKEOVER_DISTANCE;
}

void vbss_device_update_takeover(device_object *d)
{
    device_takeover *t = &d->takeover;
    if (!t->is_waiting) {
        return;
    }
    const bool is_blind = d->is_clutched || !d->jaw.is_known || d->opening_reading.is_stale;
    t->is_waiting = is_blind || !has_passed(t, d->jaw.opening);
    if (t->is_new != t->is_waiting) { /* a handle that is there at once needs no event */
        return;
    }
    d->events |= t->is_waiting ? VBSS_DEVICE_EVENT_JAW_HELD : VBSS_DEVICE_EVENT_JAW_TAKEN;
    t->is_new = false;
}

double vbss_device_reported_opening(const device_object *d)
{
    return d->takeover.is_waiting ? d->takeover.opening : d->jaw.opening;
}

bool vbss_device_reports_closed(const device_object *d)
{
    return d->takeover.is_waiting ? d->takeover.opening <= d->calibration.jaw_close_at
                                  : d->jaw.is_closed;
}
