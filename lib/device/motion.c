/* Velocities of devices that give none.
 *
 * The difference of two poses over that of their times, filtered with a time constant: v += (1 - exp(-h/T)) (d -
 * v). The first difference is taken as it is, so a constant velocity is told right, to rounding, from the second
 * sample on. */
#include "base/rotation.h"
#include "device/device.h"

void vbss_device_forget_motion(device_motion *m)
{
    *m = (device_motion){.orientation = quat_identity()};
}

static vec3 filtered(vec3 before, vec3 now, bool again, double share)
{
    return again ? vec3_add_scaled(before, share, vec3_sub(now, before)) : now;
}

static void follow_turn(device_motion *m, double per_second, double share, const quat *orientation)
{
    if (m->oriented) {
        quat turned = quat_mul(*orientation, quat_conjugate(m->orientation));
        vec3 spin = vec3_scale(vbss_quat_to_rotation_vector(turned), per_second);
        m->spin = filtered(m->spin, spin, m->spinning, share);
        m->spinning = true;
    }
}

void vbss_device_follow(device_motion *m, double filter_time, double time, vec3 position,
                        const quat *orientation)
{
    double h = time - m->time;
    if (m->placed && h > 0.5 * DEVICE_LEAST_ADVANCE) {
        double share = device_share(h, filter_time);
        vec3 velocity = vec3_scale(vec3_sub(position, m->position), 1.0 / h);
        m->velocity = filtered(m->velocity, velocity, m->moving, share);
        m->moving = true;
        if (orientation != NULL) {
            follow_turn(m, 1.0 / h, share, orientation);
        }
    }
    m->placed = true;
    m->time = time;
    m->position = position;
    if (orientation != NULL) {
        m->oriented = true;
        m->orientation = *orientation;
    }
}
