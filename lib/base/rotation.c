/* Rotation vectors and the integration of orientations. */
#include "base/elementary.h"
#include "base/linear.h"
#include "base/rotation.h"

quat vbss_quat_from_rotation_vector(vec3 rotation)
{
    double angle = vec3_norm(rotation);
    double w, s;
    if (angle < 1e-4) {
        /* sin(a/2)/a and cos(a/2), accurate to 1e-18 relative, without division by a small
         * angle. */
        double a2 = angle * angle;
        s = 0.5 - a2 * (1.0 / 48.0);
        w = 1.0 - a2 * (1.0 / 8.0);
    } else {
        double sine;
        vbss_sincos(0.5 * angle, &sine, &w);
        s = sine / angle;
    }
    return quat_make(w, s * rotation.x, s * rotation.y, s * rotation.z);
}

vec3 vbss_quat_to_rotation_vector(quat q)
{
    if (q.w < 0.0) {
        /* q and -q are the same orientation; this one has the smaller angle */
        q = quat_make(-q.w, -q.x, -q.y, -q.z);
    }
    vec3 axis = vec3_make(q.x, q.y, q.z);
    if (axis.x == 0.0 && axis.y == 0.0 && axis.z == 0.0 && q.w > 0.0) {
        return axis; /* as below, with the signs of the zeros: bodies at rest have them */
    }
    double sine = vec3_norm(axis);
    /* For a small angle: 2 atan2(s, w)/s = 2/w (1 - (s/w)^2/3 + ...). */
    double factor = sine < 1e-5 * q.w ? (2.0 - 2.0 / 3.0 * sine * sine / (q.w * q.w)) / q.w
                                      : 2.0 * vbss_arc_tangent(sine, q.w) / sine;
    return vec3_scale(axis, factor);
}

quat vbss_quat_integrate(quat q, vec3 omega, double h)
{
    return quat_unit(quat_mul(vbss_quat_from_rotation_vector(vec3_scale(omega, h)), q));
}
