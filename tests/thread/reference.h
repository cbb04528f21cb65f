/* Solutions that several tests compare with. */
#ifndef VBSS_TESTS_THREAD_REFERENCE_H
#define VBSS_TESTS_THREAD_REFERENCE_H

#include "base/elementary.h"
#include "base/linear.h"

/* J0 or J1, by its series; good to rounding below 10. */
static inline double reference_bessel(int order, double x)
{
    double term = order == 0 ? 1.0 : 0.5 * x, sum = term;
    for (int k = 1; k < 40; k++) {
        term *= -0.25 * x * x / (k * (k + order));
        sum += term;
    }
    return sum;
}

/* A circle in the plane of x and y, from the origin along +x to +y: place and direction at an arc
 * length. */
static inline vec3 on_circle(double curvature, double s)
{
    double sine, cosine;
    vbss_sincos(curvature * s, &sine, &cosine);
    return vec3_make(sine / curvature, (1.0 - cosine) / curvature, 0.0);
}

static inline vec3 along_circle(double curvature, double s)
{
    double sine, cosine;
    vbss_sincos(curvature * s, &sine, &cosine);
    return vec3_make(cosine, sine, 0.0);
}

/* The paper's thread, 150 mm, clamped level: where its tip hangs, by a boundary value solver of
 * tolerance 1e-11. */
static const vec3 hanging_tip = {15.612192e-3, -143.708681e-3, 0.0};

/* Its tip after 0.05, 0.10, 0.15, 0.20 s when straight and let go, by BDF2 with 480 segments and steps
 * of 10 us: correct to a few micrometres. */
enum { FALLING_TIPS = 4 };
static const vec3 falling_tip[FALLING_TIPS] = {{0.1482311, -0.0121077, 0.0},
                                               {0.1329157, -0.0462432, 0.0},
                                               {0.0802080, -0.1230730, 0.0},
                                               {-0.0329476, -0.1333763, 0.0}};

#endif
