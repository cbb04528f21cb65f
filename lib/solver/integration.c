/* Time integration: coefficients, prediction and correction. */
#include "solver/solver.h"

/* The family of methods, with q the acceleration that balances the forces:
 *   (1 - am) a1 + am a0 = (1 - af) q1 + af q0,
 *   x1 = x0 + h v0 + h^2 ((1/2 - beta) a0 + beta a1),
 *   v1 = v0 + h ((1 - gamma) a0 + gamma a1). */
static vbss_integration make_integration(double h, double am, double af, double beta, double gamma)
{
    double q1_factor = (1.0 - af) / (1.0 - am); /* coefficient of q1 in a1 */
    vbss_integration i;
    i.h = h;
    i.inertia = 1.0 / (h * h * beta * q1_factor);
    i.acceleration_factor = q1_factor * i.inertia;
    i.velocity_factor = h * gamma * i.acceleration_factor;
    i.a_a = -am / (1.0 - am);
    i.a_q = af / (1.0 - am);
    i.x_a = h * h * (0.5 - beta + beta * i.a_a);
    i.x_q = h * h * beta * i.a_q;
    i.v_a = h * (1.0 - gamma + gamma * i.a_a);
    i.v_q = h * gamma * i.a_q;
    return i;
}

vbss_integration vbss_integration_generalised_alpha(double h, double spectral_radius)
{
    double r = spectral_radius;
    double am = (2.0 * r - 1.0) / (r + 1.0), af = r / (r + 1.0);
    double s = 1.0 - am + af;
    return make_integration(h, am, af, 0.25 * s * s, 0.5 - am + af);
}

vbss_integration vbss_integration_backward_euler(double h)
{
    vbss_integration i = make_integration(h, 0.0, 0.0, 1.0, 1.0);
    i.x_a = i.v_a = 0.0; /* exact zeros, so that the old acceleration has no influence */
    return i;
}

/* ---- prediction and correction, as long loops over all numbers */

void vbss_integration_predict(const vbss_integration *integration, size_t count, const double *x,
                              const double *v, const double *a, const double *q,
                              double *x_predicted, double *v_predicted, double *a_predicted)
{
    const vbss_integration c = *integration;
    for (size_t i = 0; i < count; i++) {
        x_predicted[i] = x[i] + c.h * v[i] + c.x_a * a[i] + c.x_q * q[i];
    }
    for (size_t i = 0; i < count; i++) {
        v_predicted[i] = v[i] + c.v_a * a[i] + c.v_q * q[i];
    }
    for (size_t i = 0; i < count; i++) {
        a_predicted[i] = c.a_a * a[i] + c.a_q * q[i];
    }
}

static double flush_small(double speed)
{
    return fabs(speed) > VBSS_FLUSH_THRESHOLD ? speed : 0.0;
}

void vbss_integration_correct(const vbss_integration *integration, size_t count, const double *x,
                              const double *x_predicted, const double *v_predicted,
                              const double *a_predicted, double *v, double *a, double *q)
{
    const vbss_integration c = *integration;
    for (size_t i = 0; i < count; i++) {
        v[i] = flush_small(v_predicted[i] + c.velocity_factor * (x[i] - x_predicted[i]));
    }
    for (size_t i = 0; i < count; i++) {
        a[i] = flush_small(a_predicted[i] + c.acceleration_factor * (x[i] - x_predicted[i]));
    }
    for (size_t i = 0; i < count; i++) {
        q[i] = flush_small(c.inertia * (x[i] - x_predicted[i]));
    }
}
