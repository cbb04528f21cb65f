/* Rotations that need elementary functions. Rotation vectors are in rad. */
#ifndef VBSS_BASE_ROTATION_H
#define VBSS_BASE_ROTATION_H

#include "base/linear.h"

quat vbss_quat_from_rotation_vector(vec3 rotation);
vec3 vbss_quat_to_rotation_vector(quat q); /* length at most pi */
/* Orientation after a rotation with constant angular velocity omega (world frame, rad/s) for h
 * seconds. */
quat vbss_quat_integrate(quat q, vec3 omega, double h);

#endif
