/* Speed and jerk near an end of a run, where the filter would need samples that do not exist.
 *
 * A quintic polynomial is fitted by least squares to the fine samples that the filter would use and
 * that exist, and is differentiated (Gorry, Anal Chem 62:570, 1990). A quintic is the path of least
 * jerk between two states (Flash and Hogan, J Neurosci 5:1688, 1985). */
#include "metrics/metrics.h"

enum {
    DEGREE = 5,
    /* degree for a run shorter than one half of the filter; its jerk is 0; chosen */
    SHORT_DEGREE = 2,
    /* The speed at the outermost ticks is that of the quartic fit, which has half the noise of the
     * quintic one there: windows below this count of samples; chosen. */
    OUTERMOST_DEGREE = 4,
    OUTERMOST_COUNT = METRICS_KERNEL_HALF_WIDTH + 20
};

/* Equally spaced samples, at abscissas from -1 to 1. */
typedef struct end_window {
    uint64_t first;
    uint32_t count, degree;
    double half_width; /* in fine samples */
    /* b[k] of the monic orthogonal polynomials p[k + 1] = x p[k] - b[k] p[k - 1] on these abscissas
     * (Gram polynomials) */
    double recurrence[DEGREE + 1];
} end_window;

static end_window make_window(const metrics_hand *h, uint64_t centre)
{
    uint64_t end = centre + METRICS_KERNEL_HALF_WIDTH + 1;
    bool has_before = centre >= h->run_start + METRICS_KERNEL_HALF_WIDTH;
    end_window w = {.first = has_before ? centre - METRICS_KERNEL_HALF_WIDTH : h->run_start};
    w.count = (uint32_t)((end < h->next_fine ? end : h->next_fine) - w.first);
    w.half_width = 0.5 * (w.count - 1.0);
    w.degree = w.count > METRICS_KERNEL_HALF_WIDTH ? DEGREE
               : w.count > SHORT_DEGREE            ? SHORT_DEGREE
                                                   : w.count - 1;
    for (uint32_t k = 1; k <= w.degree; k++) {
        double order = (double)k * k, scale = 4.0 * (4.0 * order - 1.0);
        w.recurrence[k] =
            order * ((double)w.count * w.count - order) / (scale * w.half_width * w.half_width);
    }
    return w;
}

static double abscissa(const end_window *w, double index)
{
    return (index - w->half_width) / w->half_width;
}

/* Coefficients of the fit in the orthogonal polynomials. Positions count from the first sample, so
 * that a tool at rest has exactly no motion. */
static void fit(const end_window *w, const vec3 *ring, vec3 coefficients[DEGREE + 1])
{
    vec3 origin = ring[w->first % METRICS_RING_SIZE];
    double norm = w->count;
    for (uint32_t k = 0; k <= w->degree; k++) {
        coefficients[k] = vec3_zero();
    }
    for (uint32_t i = 0; i < w->count; i++) {
        vec3 position = vec3_sub(ring[(w->first + i) % METRICS_RING_SIZE], origin);
        double x = abscissa(w, i), p = 1.0, previous = 0.0;
        for (uint32_t k = 0; k <= w->degree; k++) {
            coefficients[k] = vec3_add_scaled(coefficients[k], p, position);
            double next = x * p - w->recurrence[k] * previous;
            previous = p;
            p = next;
        }
    }
    for (uint32_t k = 0; k <= w->degree; k++) {
        norm *= k > 0 ? w->recurrence[k] : 1.0;
        coefficients[k] = vec3_scale(coefficients[k], 1.0 / norm);
    }
}

void vbss_metrics_differentiate_end(const metrics_hand *h, uint64_t centre, double *speed,
                                    double *jerk)
{
    if (h->next_fine - h->run_start < 2) {
        *speed = *jerk = 0.0;
        return;
    }
    const end_window w = make_window(h, centre);
    vec3 coefficients[DEGREE + 1], velocity = vec3_zero(), third = vec3_zero();
    fit(&w, h->ring, coefficients);
    /* derivatives 0 to 3 of a polynomial and of the one before it */
    double p[4] = {1.0, 0.0, 0.0, 0.0}, previous[4] = {0.0, 0.0, 0.0, 0.0};
    double x = abscissa(&w, (double)(centre - w.first));
    for (uint32_t k = 0; k <= w.degree; k++) {
        if (k <= OUTERMOST_DEGREE || w.count >= OUTERMOST_COUNT) {
            velocity = vec3_add_scaled(velocity, p[1], coefficients[k]);
        }
        third = vec3_add_scaled(third, p[3], coefficients[k]);
        for (int d = 3; d >= 0; d--) {
            double next = x * p[d] - w.recurrence[k] * previous[d] + (d > 0 ? d * p[d - 1] : 0.0);
            previous[d] = p[d];
            p[d] = next;
        }
    }
    double rate = METRICS_FINE_RATE / w.half_width;
    *speed = rate * vec3_norm(velocity);
    *jerk = rate * rate * rate * rate * rate * rate * vec3_norm_squared(third);
}
