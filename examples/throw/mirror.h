/* Left-handed hands do what right-handed ones do, in the mirror: they act in a world that is the scene reflected at the plane x = 0. What
 * they see and feel is reflected on its way to them, where they want their tools on its way back. Every function is its own inverse, and
 * changes nothing if nothing is mirrored. */
#ifndef VBSS_EXAMPLES_THROW_MIRROR_H
#define VBSS_EXAMPLES_THROW_MIRROR_H

#include <stdbool.h>
#include <string.h>

#include "throw/vec.h"

/* A place, a direction or a force. */
static inline vec mirror_vec(bool mirrored, vec v)
{
    return mirrored ? v3(-v.x, v.y, v.z) : v;
}

/* How a body is turned (w, x, y, z) whose own halves x < 0 and x > 0 are mirror images, as a tool's are: its jaws open along x. The image is
 * the same body, turned so. */
static inline void mirror_tool(bool mirrored, const double q[4], double image[4])
{
    const double reflected[4] = {q[0], q[1], -q[2], -q[3]};
    memcpy(image, mirrored ? reflected : q, sizeof reflected);
}

/* The same of a needle, which is flat: its own halves z < 0 and z > 0 are. That is how a tool would be turned, after half a turn
 * about its own y. */
static inline void mirror_needle(bool mirrored, const double q[4], double image[4])
{
    const double reflected[4] = {q[2], q[3], q[0], q[1]};
    memcpy(image, mirrored ? reflected : q, sizeof reflected);
}

/* 0 and 1: left and right. */
static inline int mirror_side(bool mirrored, int side)
{
    return mirrored ? 1 - side : side;
}

/* Of turns and throws, whose sign is their handedness. */
static inline double mirror_sign(bool mirrored)
{
    return mirrored ? -1.0 : 1.0;
}

#endif
