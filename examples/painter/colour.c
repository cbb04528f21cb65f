/* Colours: light and its code in a file, and the ramp. */
#include "picture.h"

/* Codes are taken for square roots of light: near to sRGB, and the same on every machine. */

rgb rgb_of(painter_colour colour)
{
    double r = (double)(colour >> 16 & 255) / 255.0;
    double g = (double)(colour >> 8 & 255) / 255.0;
    double b = (double)(colour & 255) / 255.0;
    return (rgb){r * r, g * g, b * b};
}

static painter_colour code_of(double light)
{
    return (painter_colour)(255.0 * sqrt(clamp(light, 0.0, 1.0)) + 0.5);
}

painter_colour rgb_packed(rgb light)
{
    return code_of(light.r) << 16 | code_of(light.g) << 8 | code_of(light.b);
}

rgb rgb_mix(rgb a, rgb b, double t)
{
    return (rgb){a.r + (b.r - a.r) * t, a.g + (b.g - a.g) * t, a.b + (b.b - a.b) * t};
}

/* ---- the ramp: a curve through OKLab, lightness rising evenly (worked out by B. Ottosson's
 * matrices, then written down as codes) */

static const painter_colour ramp[] = {0x2e3a99u, 0x4a3ca0u, 0x6240a4u, 0x7943a4u, 0x8f47a2u,
                                      0xa44a9au, 0xb74f90u, 0xc85584u, 0xd75d76u, 0xe5686bu,
                                      0xf07660u, 0xf98555u, 0xff964du, 0xfea74eu, 0xffb84cu,
                                      0xffc845u, 0xf9da50u};

painter_colour painter_ramp(double value, double low, double high)
{
    const int last = (int)(sizeof ramp / sizeof ramp[0]) - 1;
    double range = high - low;
    if (!(fabs(value) < HUGE_VAL && fabs(range) < HUGE_VAL && fabs(range) > 0.0)) {
        return 0x9a9a9au;
    }
    double at = clamp((value - low) / range, 0.0, 1.0) * last;
    int below = (int)at < last ? (int)at : last - 1;
    double t = at - below;
    painter_colour mixed = 0;
    for (int shift = 0; shift <= 16; shift += 8) {
        double from = (double)(ramp[below] >> shift & 255);
        double to = (double)(ramp[below + 1] >> shift & 255);
        mixed |= (painter_colour)(from + (to - from) * t + 0.5) << shift;
    }
    return mixed;
}
