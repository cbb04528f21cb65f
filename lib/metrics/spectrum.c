/* Spectral arc length (SPARC) of a speed profile: minus the arc length of its normalised amplitude
 * spectrum (Balasubramanian et al., J NeuroEng Rehabil 12:112, 2015). docs/explanation/metrics.md says which
 * parts are not verified. */
#include "base/elementary.h"
#include "base/pi.h"
#include "metrics/metrics.h"
#include "metrics/tuning.h"

/* ---- discrete Fourier transform of `size` complex numbers, a power of two: decimation in
 * frequency, result in bit-reversed order */

static void fourier_transform(double *x, uint32_t size)
{
    for (uint32_t half = size / 2; half >= 1; half /= 2) {
        for (uint32_t k = 0; k < half; k++) {
            double sine, cosine;
            vbss_sincos(-VBSS_TWO_PI * (double)k / (2.0 * (double)half), &sine, &cosine);
            for (uint32_t i = k; i < size; i += 2 * half) {
                double *a = x + 2 * (size_t)i, *b = x + 2 * ((size_t)i + half);
                double re = a[0] - b[0], im = a[1] - b[1];
                a[0] += b[0];
                a[1] += b[1];
                b[0] = re * cosine - im * sine;
                b[1] = re * sine + im * cosine;
            }
        }
    }
}

static uint32_t bit_reversed(uint32_t number, uint32_t size)
{
    uint32_t result = 0;
    for (uint32_t bit = 1; bit < size; bit *= 2) {
        result = 2 * result + (number & 1u);
        number /= 2;
    }
    return result;
}

static double amplitude(const double *x, uint32_t number, uint32_t size)
{
    const double *value = x + 2 * (size_t)bit_reversed(number, size);
    return sqrt(value[0] * value[0] + value[1] * value[1]);
}

/* ---- arc length */

bool vbss_metrics_sparc(const double *speed, uint32_t count, double *buffer, double *sparc)
{
    uint32_t size = METRICS_SPECTRUM_PADDING;
    while (size < METRICS_SPECTRUM_PADDING * count) {
        size *= 2;
    }
    for (uint32_t i = 0; i < size; i++) {
        buffer[2 * (size_t)i] = i < count ? speed[i] : 0.0;
        buffer[2 * (size_t)i + 1] = 0.0;
    }
    fourier_transform(buffer, size);
    double dc_amplitude = amplitude(buffer, 0, size), length = 0.0, previous = 1.0;
    if (!(dc_amplitude > 0.0)) {
        return false;
    }
    uint32_t last = (uint32_t)(METRICS_MAX_FREQUENCY * (double)size / METRICS_TICK_RATE);
    while (last > 1 && amplitude(buffer, last, size) < METRICS_AMPLITUDE_THRESHOLD * dc_amplitude) {
        last--;
    }
    for (uint32_t k = 1; k <= last; k++) {
        double current = amplitude(buffer, k, size) / dc_amplitude, step = 1.0 / (double)last;
        length += sqrt(step * step + (current - previous) * (current - previous));
        previous = current;
    }
    *sparc = -length;
    return true;
}
