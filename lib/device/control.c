/* What a host does with a device between its steps: stop, clutch, re-centre, calibrate. */
#include "base/check.h"
#include "base/error.h"
#include "device/device.h"

vbss_result vbss_device_stop(vbss_device *device)
{
    device_object *d;
    VBSS_TRY(vbss_device_edit(device, &d));
    vbss_device_latch(d);
    return VBSS_OK;
}

vbss_result vbss_device_release(vbss_device *device)
{
    device_object *d;
    VBSS_TRY(vbss_device_edit(device, &d));
    d->output.stopped = false;
    return VBSS_OK;
}

/* ---- clutch and re-centring: a shift in the world, a turn in the tool's frame, so that movements of the hand
 * keep their directions */

static void place_position(device_object *d, vec3 position)
{
    d->shift = vec3_sub(position, vbss_device_calibrated(d).position);
}

static void place_orientation(device_object *d, quat orientation)
{
    quat seen = vbss_device_calibrated(d).orientation;
    d->turn = quat_unit(quat_mul(quat_conjugate(seen), orientation));
}

vbss_result vbss_device_clutch(vbss_device *device, int32_t held)
{
    device_object *d;
    VBSS_TRY(vbss_device_edit(device, &d));
    VBSS_TRY(vbss_check_range(d->context, held, 0.0, 1.0, "held"));
    if (held != 0 && !d->clutched) {
        d->held = d->shown;
        d->statistics.clutches++;
    } else if (held == 0 && d->clutched) {
        place_position(d, d->held.position);
        if (d->config.clutch_orientation != 0) {
            place_orientation(d, d->held.orientation);
        }
    }
    d->clutched = held != 0;
    return VBSS_OK;
}

vbss_result vbss_device_recentre(vbss_device *device, const double *position,
                                 const double *orientation)
{
    device_object *d;
    VBSS_TRY(vbss_device_edit(device, &d));
    if (!d->pose.known) {
        return vbss_fail(d->context, VBSS_ERROR_OUT_OF_RANGE, "there was no pose yet");
    }
    if (position != NULL) {
        VBSS_TRY(vbss_check_finite(d->context, position, 3, "position"));
        VBSS_TRY(vbss_check_range(d->context, vbss_max_abs(position, 3), 0.0, 1e3, "position"));
    }
    if (orientation != NULL) {
        VBSS_TRY(vbss_check_finite(d->context, orientation, 4, "orientation"));
        VBSS_TRY(vbss_check_range(d->context, vbss_max_abs(orientation, 4), 1e-100, 1e100,
                                  "orientation"));
    }
    d->clutched = false;
    if (position != NULL) {
        place_position(d, vec3_load(position));
    }
    if (orientation != NULL) {
        place_orientation(d, quat_unit(quat_make(orientation[0], orientation[1], orientation[2],
                                                 orientation[3])));
    }
    return VBSS_OK;
}

vbss_result vbss_device_set_calibration(vbss_device *device,
                                        const vbss_device_calibration *calibration)
{
    device_object *d;
    vbss_device_calibration own;
    VBSS_TRY(vbss_device_edit(device, &d));
    VBSS_TRY(vbss_device_calibration_init(&own, sizeof own));
    if (calibration != NULL) {
        VBSS_TRY(vbss_config_read(d->context, &vbss_device_calibration_layout, calibration, &own));
    }
    VBSS_TRY(vbss_device_check_calibration(d->context, &own));
    d->calibration = own;
    d->frame = vbss_device_frame_of(&own);
    d->shift = vec3_zero();
    d->turn = quat_identity();
    d->clutched = false;
    d->jaw.known = false;
    return VBSS_OK;
}
