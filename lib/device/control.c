/* Public functions that change a device between reads: emergency stop, clutch, re-centring and
 * calibration. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "device/device.h"

vbss_result vbss_device_latch_emergency_stop(vbss_device *device)
{
    VBSS_ENTER(device);
    device_object *d;
    VBSS_TRY(vbss_device_edit(device, &d));
    vbss_device_latch_stop(d);
    return VBSS_OK;
}

vbss_result vbss_device_clear_emergency_stop(vbss_device *device)
{
    VBSS_ENTER(device);
    device_object *d;
    VBSS_TRY(vbss_device_edit(device, &d));
    d->output.is_stopped = false;
    return VBSS_OK;
}

/* ---- clutch and re-centring
 *
 * The offset of the position is in the world, that of the orientation in the tool's frame. The tool
 * therefore still moves and turns in the directions in which the hand does. */

static void set_position_offset(device_object *d, vec3 position)
{
    d->position_offset = vec3_sub(position, vbss_device_calibrated_pose(d).position);
}

static void set_orientation_offset(device_object *d, quat orientation)
{
    quat current = vbss_device_calibrated_pose(d).orientation;
    d->orientation_offset = quat_unit(quat_mul(quat_conjugate(current), orientation));
}

vbss_result vbss_device_set_clutch(vbss_device *device, int32_t held)
{
    VBSS_ENTER(device);
    device_object *d;
    VBSS_TRY(vbss_device_edit(device, &d));
    VBSS_TRY(vbss_check_range(d->context, held, 0.0, 1.0, "held"));
    if (held != 0 && !d->is_clutched) {
        d->clutch_pose = d->reported_pose;
        if (d->config.jaw_takeover != 0) {
            vbss_device_hold_opening(d, vbss_device_reported_opening(d));
        }
        d->statistics.clutches++;
    } else if (held == 0 && d->is_clutched) {
        set_position_offset(d, d->clutch_pose.position);
        if (d->config.clutch_orientation != 0) {
            set_orientation_offset(d, d->clutch_pose.orientation);
        }
    }
    d->is_clutched = held != 0;
    return VBSS_OK;
}

vbss_result vbss_device_recentre(vbss_device *device, const double *position,
                                 const double *orientation)
{
    VBSS_ENTER(device);
    device_object *d;
    VBSS_TRY(vbss_device_edit(device, &d));
    if (!d->pose_reading.is_known) {
        return vbss_fail(d->context, VBSS_ERROR_WRONG_STATE, "there was no pose yet");
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
    d->is_clutched = false;
    if (position != NULL) {
        set_position_offset(d, vec3_load(position));
    }
    if (orientation != NULL) {
        set_orientation_offset(d, quat_unit(quat_make(orientation[0], orientation[1],
                                                      orientation[2], orientation[3])));
    }
    return VBSS_OK;
}

vbss_result vbss_device_hold_jaw(vbss_device *device, double opening)
{
    VBSS_ENTER(device);
    device_object *d;
    VBSS_TRY(vbss_device_edit(device, &d));
    VBSS_TRY(vbss_check_range(d->context, opening, 0.0, 1.0, "opening"));
    if (d->config.jaw_takeover == 0) {
        return vbss_fail(d->context, VBSS_ERROR_INCOMPATIBLE, "the device has no jaw_takeover");
    }
    vbss_device_hold_opening(d, opening);
    return VBSS_OK;
}

vbss_result vbss_device_set_calibration(vbss_device *device,
                                        const vbss_device_calibration *calibration)
{
    VBSS_ENTER(device);
    device_object *d;
    vbss_device_calibration own;
    VBSS_TRY(vbss_device_edit(device, &d));
    VBSS_TRY(vbss_device_calibration_init(&own, sizeof own));
    if (calibration != NULL) {
        VBSS_TRY(vbss_config_read(d->context, &vbss_device_calibration_layout, calibration, &own));
    }
    VBSS_TRY(vbss_device_check_calibration(d->context, &own));
    d->calibration = own;
    d->frame = vbss_device_make_frame(&own);
    d->position_offset = vec3_zero();
    d->orientation_offset = quat_identity();
    d->is_clutched = false;
    d->jaw.is_known = false;
    return VBSS_OK;
}
