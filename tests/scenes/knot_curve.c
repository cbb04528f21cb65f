#include "scenes/knot_curve.h"

#include "base/elementary.h"

void knot_curve_begin(knot_curve *curve, double spacing)
{
    curve->spacing = spacing;
    curve->count = 0;
    curve->full = false;
}

static void put(knot_curve *curve, vec3 point)
{
    if (curve->count == KNOT_CURVE_POINTS) {
        curve->full = true;
        return;
    }
    curve->points[curve->count++] = point;
}

void knot_curve_piece(knot_curve *curve, double length, vec3 (*at)(double t, const void *user),
                      const void *user)
{
    uint32_t steps = (uint32_t)(length / curve->spacing) + 1;
    for (uint32_t i = 0; i < steps && !curve->full; i++) {
        put(curve, at((double)i / steps, user));
    }
}

typedef struct line {
    vec3 from, to;
} line;

static vec3 on_line(double t, const void *user)
{
    const line *l = user;
    return vec3_lerp(l->from, l->to, t);
}

void knot_curve_straight(knot_curve *curve, vec3 from, vec3 to)
{
    double length = vec3_distance(from, to);
    if (length > 0.0) {
        line l = {from, to};
        knot_curve_piece(curve, length, on_line, &l);
    }
}

typedef struct arc {
    vec3 centre;
    double radius, from, to;
} arc;

static vec3 on_arc(double t, const void *user)
{
    const arc *a = user;
    double sine, cosine;
    vbss_sincos((1.0 - t) * a->from + t * a->to, &sine, &cosine);
    return vec3_add_scaled(a->centre, a->radius, vec3_make(cosine, 0.0, sine));
}

void knot_curve_arc(knot_curve *curve, vec3 centre, double radius, double from, double to)
{
    arc a = {centre, radius, from, to};
    knot_curve_piece(curve, radius * fabs(to - from), on_arc, &a);
}

/* ---- the spline; span k runs between control points k + 1 and k + 2 */

static vec3 blend(const vec3 *p, double b0, double b1, double b2, double b3)
{
    vec3 sum = vec3_scale(p[0], b0);
    sum = vec3_add_scaled(sum, b1, p[1]);
    sum = vec3_add_scaled(sum, b2, p[2]);
    return vec3_add_scaled(sum, b3, p[3]);
}

static vec3 span_point(const vec3 *p, double u)
{
    double v = 1.0 - u, u2 = u * u, u3 = u2 * u;
    return blend(p, v * v * v / 6.0, (3.0 * u3 - 6.0 * u2 + 4.0) / 6.0,
                 (3.0 * (u + u2 - u3) + 1.0) / 6.0, u3 / 6.0);
}

static double span_speed(const vec3 *p, double u)
{
    double v = 1.0 - u;
    return vec3_norm(
        blend(p, -0.5 * v * v, (1.5 * u - 2.0) * u, (1.0 - 1.5 * u) * u + 0.5, 0.5 * u * u));
}

/* From 0 to u, by Gauss with five points: the speed hardly changes within a span. */
static double span_length(const vec3 *p, double u)
{
    static const double places[5] = {0.04691007703066800, 0.23076534494715845, 0.5,
                                     0.76923465505284155, 0.95308992296933200};
    static const double weights[5] = {0.11846344252809454, 0.23931433524968324, 0.28444444444444444,
                                      0.23931433524968324, 0.11846344252809454};
    double sum = 0.0;
    for (int i = 0; i < 5; i++) {
        sum += weights[i] * span_speed(p, u * places[i]);
    }
    return u * sum;
}

void knot_curve_finish(knot_curve *curve, vec3 last)
{
    put(curve, last);
    double s = 0.0;
    for (uint32_t k = 0; k + 3 < curve->count; k++) {
        curve->arcs[k] = s;
        s += span_length(&curve->points[k], 1.0);
    }
    curve->arcs[curve->count - 3] = s;
}

double knot_curve_length(const knot_curve *curve)
{
    return curve->arcs[curve->count - 3];
}

static vec3 beyond(vec3 end, vec3 inside, double distance)
{
    vec3 out = vec3_sub(end, inside);
    return vec3_add_scaled(end, distance / vec3_norm(out), out);
}

vec3 knot_curve_at(const knot_curve *curve, double s)
{
    uint32_t spans = curve->count - 3;
    if (s <= 0.0) {
        return beyond(curve->points[1], curve->points[2], -s);
    }
    if (s >= curve->arcs[spans]) {
        return beyond(curve->points[spans + 1], curve->points[spans], s - curve->arcs[spans]);
    }
    uint32_t low = 0, high = spans; /* arcs[low] <= s < arcs[high] */
    while (high - low > 1) {
        uint32_t middle = (low + high) / 2;
        if (curve->arcs[middle] <= s) {
            low = middle;
        } else {
            high = middle;
        }
    }
    const vec3 *p = &curve->points[low];
    double rest = s - curve->arcs[low];
    double u = rest / (curve->arcs[low + 1] - curve->arcs[low]);
    for (int i = 0; i < 6; i++) {
        u -= (span_length(p, u) - rest) / span_speed(p, u);
    }
    return span_point(p, u);
}
