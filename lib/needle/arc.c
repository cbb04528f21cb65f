/* Shape, mass and inertia of a needle. */
#include "base/elementary.h"
#include "base/pi.h"
#include "base/rotation.h"
#include "needle/needle.h"

/* ---- the middle line */

double vbss_needle_length(const needle_object *n)
{
    return n->config.radius * n->config.arc;
}

double vbss_needle_vertex_arc(const needle_object *n, uint32_t i)
{
    return vbss_needle_length(n) * ((double)i / (double)n->config.segment_count);
}

/* Clockwise angle from the tip, clamped to the needle. */
static double angle_at(double radius, double arc, double arc_length)
{
    return vbss_min(vbss_max(arc_length / radius, 0.0), arc);
}

vec3 vbss_needle_line_direction(double radius, double arc, double arc_length)
{
    double sine, cosine;
    vbss_sincos(angle_at(radius, arc, arc_length), &sine, &cosine);
    return vec3_make(sine, cosine, 0.0);
}

vec3 vbss_needle_line_point(double radius, double arc, double arc_length)
{
    double sine, cosine;
    vbss_sincos(angle_at(radius, arc, arc_length), &sine, &cosine);
    /* distance behind the swage, or below zero ahead of the tip */
    double overshoot = vbss_min(arc_length, 0.0) + vbss_max(arc_length - radius * arc, 0.0);
    return vec3_make(radius * cosine - overshoot * sine, -radius * sine - overshoot * cosine, 0.0);
}

vec3 vbss_needle_direction(const needle_object *n, double arc_length)
{
    return vbss_needle_line_direction(n->config.radius, n->config.arc, arc_length);
}

vec3 vbss_needle_point(const needle_object *n, double arc_length)
{
    return vbss_needle_line_point(n->config.radius, n->config.arc, arc_length);
}

double vbss_needle_nearest_arc(const needle_object *n, vec3 point)
{
    double open = 2.0 * VBSS_PI - n->config.arc, length = vbss_needle_length(n);
    /* angle of the point, from the tip into the open side */
    double angle = vbss_arc_tangent(point.y, point.x);
    angle = angle < 0.0 ? angle + 2.0 * VBSS_PI : angle;
    if (angle >= open) {
        return (2.0 * VBSS_PI - angle) * n->config.radius;
    }
    bool at_tip = angle < 0.5 * open;
    double end = at_tip ? 0.0 : length;
    vec3 beyond = vec3_sub(point, vbss_needle_point(n, end));
    return end - vec3_dot(beyond, vbss_needle_direction(n, end));
}

/* ---- mass and inertia */

/* Means over an arc of angle a, with theta measured from its middle: <sin^2 theta>, <cos theta> and
 * the variance of cos theta. The first and the last are power series, accurate up to a = 6. The
 * closed form 1/2 + sin(a)/(2 a) - (sin(a/2)/(a/2))^2 of the variance, about a^4/720, would lose
 * digits for a short arc. */
typedef struct arc_means {
    double sine_squared, cosine, cosine_variance;
} arc_means;

static arc_means means_over(double a)
{
    enum { LAST = 24 }; /* derived: at a = 6 the truncation error is below 1e-25 */
    arc_means means = {0.0, vbss_sine(0.5 * a) / (0.5 * a), 0.0};
    double term = 0.5; /* (-a^2)^k / (2 k + 2)! */
    for (int k = 1; k <= LAST; k++) {
        term *= -a * a / ((2.0 * k + 1.0) * (2.0 * k + 2.0));
        means.sine_squared -= (k + 1.0) * term;
        means.cosine_variance += (k - 1.0) * term;
    }
    return means;
}

/* Mass and principal moments (derived in docs/explanation/needle.md). The volume element of a torus is u du
 * dpsi q dtheta at the distance q = R + u cos(psi) from the axis and the height z = u sin(psi). The
 * principal axes are the middle of the arc, across it in the plane, and z. All sums have positive
 * terms only, so no digits are lost. */
vbss_rigid_mass vbss_needle_mass_properties(const vbss_needle_config *config)
{
    double big = config->radius, r2 = config->wire_radius * config->wire_radius;
    double mass = config->density * VBSS_PI * r2 * big * config->arc;
    const arc_means arc = means_over(config->arc);
    double q = big + 0.25 * r2 / big, q_squared = big * big + 0.75 * r2, z_squared = 0.25 * r2;
    double q_variance = 0.25 * r2 * (1.0 - 0.25 * r2 / (big * big));
    double along = q_squared * arc.sine_squared; /* second moments in the plane, about the centre */
    double across = q_squared * arc.cosine_variance + q_variance * arc.cosine * arc.cosine;
    double sine, cosine;
    vbss_sincos(-0.5 * config->arc, &sine, &cosine);
    double centre = q * arc.cosine;
    vbss_rigid_mass properties = {.mass = mass};
    properties.inertia =
        vec3_make(mass * (along + z_squared), mass * (across + z_squared), mass * (along + across));
    properties.frame =
        pose_make(vec3_make(centre * cosine, centre * sine, 0.0),
                  vbss_quat_from_rotation_vector(vec3_make(0.0, 0.0, -0.5 * config->arc)));
    return properties;
}
