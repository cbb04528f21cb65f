/* Variations of a performance: the hands' places are somewhat off. */
#include "pad.h"

static const double largest = 0.1e-3; /* m, along each axis: a hand's tremor */

/* From -1 to 1: splitmix64. */
static double draw(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (double)((z ^ (z >> 31)) >> 11) * 0x1p-52 - 1.0;
}

vec3 pad_vary(uint64_t seed, uint32_t place)
{
    uint64_t state = seed * 1000u + place;
    const double x = draw(&state), y = draw(&state), z = draw(&state);
    return seed == 0 ? vec3_zero() : vec3_scale(vec3_make(x, y, z), largest);
}
