/* Estimates velocities for devices that do not measure them.
 *
 * The difference quotient d of two poses that are h apart passes a low-pass filter with the time
 * constant T: v += (1 - exp(-h/T)) (d - v). The first quotient is not filtered, so a constant
 * velocity is exact to rounding from the second sample on. */
#include "base/rotation.h"
#include "device/device.h"

void vbss_device_reset_motion(device_motion *m)
{
    *m = (device_motion){.orientation = quat_identity()};
}

static vec3 low_pass(vec3 previous, vec3 current, bool has_previous, double factor)
{
    return has_previous ? vec3_add_scaled(previous, factor, vec3_sub(current, previous)) : current;
}

static void update_spin(device_motion *m, double per_second, double factor, const quat *orientation)
{
    if (m->has_orientation) {
        quat turned = quat_mul(*orientation, quat_conjugate(m->orientation));
        vec3 spin = vec3_scale(vbss_quat_to_rotation_vector(turned), per_second);
        m->spin = low_pass(m->spin, spin, m->has_spin, factor);
        m->has_spin = true;
    }
}

void vbss_device_update_motion(device_motion *m, double filter_time, double time, vec3 position,
                               const quat *orientation)
{
    double h = time - m->time;
    if (m->has_position && h > 0.5 * DEVICE_MIN_SAMPLE_SPACING) {
        double factor = device_smoothing_factor(h, filter_time);
        vec3 velocity = vec3_scale(vec3_sub(position, m->position), 1.0 / h);
        m->velocity = low_pass(m->velocity, velocity, m->has_velocity, factor);
        m->has_velocity = true;
        if (orientation != NULL) {
            update_spin(m, 1.0 / h, factor, orientation);
        }
    }
    m->has_position = true;
    m->time = time;
    m->position = position;
    if (orientation != NULL) {
        m->has_orientation = true;
        m->orientation = *orientation;
    }
}
