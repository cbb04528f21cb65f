/* Four vectors in SIMD lanes: the operations of vec3, in the same order of operations. */
#ifndef VBSS_BASE_VLANES_H
#define VBSS_BASE_VLANES_H

#include "base/lanes.h"

typedef struct vlanes {
    lanes x, y, z;
} vlanes;

static inline vlanes v_add(vlanes a, vlanes b)
{
    vlanes r = {lanes_add(a.x, b.x), lanes_add(a.y, b.y), lanes_add(a.z, b.z)};
    return r;
}

static inline vlanes v_sub(vlanes a, vlanes b)
{
    vlanes r = {lanes_sub(a.x, b.x), lanes_sub(a.y, b.y), lanes_sub(a.z, b.z)};
    return r;
}

static inline vlanes v_scale(vlanes a, lanes s)
{
    vlanes r = {lanes_times(a.x, s), lanes_times(a.y, s), lanes_times(a.z, s)};
    return r;
}

static inline vlanes v_add_scaled(vlanes a, lanes s, vlanes b)
{
    return v_add(a, v_scale(b, s));
}

static inline lanes v_dot(vlanes a, vlanes b)
{
    return lanes_add(lanes_add(lanes_times(a.x, b.x), lanes_times(a.y, b.y)),
                     lanes_times(a.z, b.z));
}

static inline vlanes v_cross(vlanes a, vlanes b)
{
    vlanes r = {lanes_sub(lanes_times(a.y, b.z), lanes_times(a.z, b.y)),
                lanes_sub(lanes_times(a.z, b.x), lanes_times(a.x, b.z)),
                lanes_sub(lanes_times(a.x, b.y), lanes_times(a.y, b.x))};
    return r;
}

static inline vlanes v_select(lanes_mask mask, vlanes a, vlanes b)
{
    vlanes r = {lanes_select(mask, a.x, b.x), lanes_select(mask, a.y, b.y),
                lanes_select(mask, a.z, b.z)};
    return r;
}

#endif
