/* A smooth curve through samples at any times: a cubic between two samples, and a low-pass filter.
 * Derivatives are differences of the filter's taps. docs/explanation/metrics.md, "Motion". */
#include "base/elementary.h"
#include "base/pi.h"
#include "metrics/metrics.h"
#include "metrics/tuning.h"

/* ---- the filter: an ideal low-pass at this cutoff in a Blackman window of +-0.25 s. At the ends
 * of the window the sine of the ideal filter is zero, which bounds the third derivative. */

static double filter_tap(int i)
{
    double t = i / METRICS_FINE_RATE, phase = VBSS_PI * i / METRICS_FILTER_HALF_WIDTH;
    if (i < -METRICS_FILTER_HALF_WIDTH || i > METRICS_FILTER_HALF_WIDTH) {
        return 0.0;
    }
    double ideal = i == 0 ? 2.0 * METRICS_CUTOFF_FREQUENCY
                          : vbss_sine(2.0 * VBSS_PI * METRICS_CUTOFF_FREQUENCY * t) / (VBSS_PI * t);
    return ideal * (0.42 + 0.5 * vbss_cosine(phase) + 0.08 * vbss_cosine(2.0 * phase));
}

void vbss_metrics_make_kernel(metrics_kernel *kernel)
{
    /* the margin of 2 entries makes bounds checks of the differences unnecessary */
    double taps[2 * METRICS_KERNEL_HALF_WIDTH + 5];
    double *h = taps + METRICS_KERNEL_HALF_WIDTH + 2, sum = 0.0;
    for (int i = -METRICS_KERNEL_HALF_WIDTH - 2; i <= METRICS_KERNEL_HALF_WIDTH + 2; i++) {
        h[i] = filter_tap(i);
        sum += h[i];
    }
    double first = 0.5 * METRICS_FINE_RATE / sum;
    double third = first * METRICS_FINE_RATE * METRICS_FINE_RATE;
    kernel->first[0] = kernel->third[0] = 0.0;
    for (int i = 1; i <= METRICS_KERNEL_HALF_WIDTH; i++) {
        kernel->first[i] = first * (h[i - 1] - h[i + 1]);
        kernel->third[i] = third * (h[i - 2] - 2.0 * h[i - 1] + 2.0 * h[i + 1] - h[i + 2]);
    }
}

void vbss_metrics_differentiate(const metrics_kernel *kernel, const vec3 *ring, uint64_t centre,
                                double *speed, double *jerk)
{
    vec3 v = vec3_zero(), j = vec3_zero();
    for (uint64_t i = 1; i <= METRICS_KERNEL_HALF_WIDTH; i++) {
        vec3 pair = vec3_sub(ring[(centre + i) % METRICS_RING_SIZE],
                             ring[(centre - i) % METRICS_RING_SIZE]);
        v = vec3_add_scaled(v, kernel->first[i], pair);
        j = vec3_add_scaled(j, kernel->third[i], pair);
    }
    *speed = vec3_norm(v);
    *jerk = vec3_norm_squared(j);
}

/* ---- the curve between samples */

/* Slope of the parabola through all three. If one neighbour is much closer than the other, its
 * error would dominate; the chord is used then. */
vec3 vbss_metrics_middle_velocity(const double time[3], const vec3 position[3])
{
    double before = time[1] - time[0], after = time[2] - time[1], both = time[2] - time[0];
    if (before > 4.0 * after || after > 4.0 * before) {
        return vec3_scale(vec3_sub(position[2], position[0]), 1.0 / both);
    }
    vec3 before_part = vec3_scale(vec3_sub(position[1], position[0]), after / (before * both));
    vec3 later = vec3_scale(vec3_sub(position[2], position[1]), before / (after * both));
    return vec3_add(before_part, later);
}

vec3 vbss_metrics_segment_at(const metrics_segment *segment, double time)
{
    double length = segment->end_time - segment->start_time,
           s = (time - segment->start_time) / length, r = 1.0 - s;
    vec3 p = vec3_scale(segment->start, r * r * (1.0 + 2.0 * s));
    p = vec3_add_scaled(p, s * s * (1.0 + 2.0 * r), segment->end);
    p = vec3_add_scaled(p, length * s * r * r, segment->start_velocity);
    return vec3_add_scaled(p, -length * s * s * r, segment->end_velocity);
}
