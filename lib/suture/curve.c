/* The suture as one curve with one arc length: the needle's arc, then the thread behind it.
 *
 * The thread must be smooth here, or a hole would jump at every node. It is a cubic B-spline with
 * its nodes as control points (docs/explanation/stitch.md), continuous up to its curvature. Span k belongs to
 * segment k; its arc length is the same spline of the nodes' arc lengths. At the thread's end the
 * spline ends in the last node, and the curve continues straight. At the swage it starts at the
 * needle's end, along the needle. */
#include "base/elementary.h"
#include "suture/suture.h"
#include "suture/tuning.h"

#include <string.h>

/* ---- spans */

enum { CONTROL_POINTS = SUTURE_SPAN_NODES };

/* One span: four control points with cubic weights in u from 0 to 1, given by the coefficients of
 * its powers. The first control point is a node, or over the swage a point of the needle. */
typedef struct span {
    vec3 control_point[CONTROL_POINTS];
    double arc[CONTROL_POINTS]; /* arc lengths of the control points */
    double basis[CONTROL_POINTS][4];
    uint32_t first_node; /* first of its nodes */
    bool is_at_swage;
} span;

static const double spline[CONTROL_POINTS][4] = {{1.0 / 6.0, -0.5, 0.5, -1.0 / 6.0},
                                                 {4.0 / 6.0, 0.0, -1.0, 0.5},
                                                 {1.0 / 6.0, 0.5, 0.5, -0.5},
                                                 {0.0, 0.0, 0.0, 1.0 / 6.0}};

static void add_scaled(double to[4], double factor, const double of[4])
{
    for (int i = 0; i < 4; i++) {
        to[i] += factor * of[i];
    }
}

/* Basis over the swage, as Hermite cubics: from the needle's end, along the needle, to the spline
 * at the first node. */
static void set_swage_basis(span *p)
{
    static const double h[4][4] = {
        {1.0, 0.0, -3.0, 2.0}, {0.0, 1.0, -2.0, 1.0}, {0.0, 0.0, 3.0, -2.0}, {0.0, 0.0, -1.0, 1.0}};
    memset(p->basis, 0, sizeof p->basis);
    add_scaled(p->basis[0], -1.0, h[1]);
    add_scaled(p->basis[1], 1.0, h[0]);
    add_scaled(p->basis[1], 1.0, h[1]);
    for (int k = 0; k < 3; k++) {
        add_scaled(p->basis[1 + k], k == 1 ? 4.0 / 6.0 : 1.0 / 6.0, h[2]);
        add_scaled(p->basis[1 + k], 0.5 * (k - 1), h[3]);
    }
}

/* Replaces the control point beyond the last node by a reflection of the one before it, so that the
 * spline ends in the last node. */
static void end_at_node(span *p, int beyond, int last, int before)
{
    add_scaled(p->basis[last], 2.0, p->basis[beyond]);
    add_scaled(p->basis[before], -1.0, p->basis[beyond]);
    memset(p->basis[beyond], 0, sizeof p->basis[beyond]);
}

static span span_of(const suture_curve *curve, uint32_t k)
{
    const double *rest = curve->thread->rest;
    const uint32_t last = curve->thread->node_count - 1;
    span p = {.first_node = k > 0 ? k - 1 : 0, .is_at_swage = k == 0 && curve->needle != NULL};
    memcpy(p.basis, spline, sizeof p.basis);
    double arc = curve->swage_arc + vbss_thread_arc_length(curve->thread, p.first_node);
    for (uint32_t i = k > 0 ? 0 : 1; i < CONTROL_POINTS; i++) {
        uint32_t node = k + i - 1;
        if (node <= last) {
            p.control_point[i] = curve->node_positions[node];
            p.arc[i] = arc;
            arc += node < last ? rest[node] : 0.0;
        }
    }
    if (p.is_at_swage) {
        const needle_object *n = curve->needle;
        vec3 back = vec3_add_scaled(vbss_needle_point(n, curve->swage_arc), rest[0],
                                    vbss_needle_direction(n, curve->swage_arc));
        p.control_point[0] = pose_apply(curve->needle_pose, back);
        p.arc[0] = curve->swage_arc - rest[0];
        set_swage_basis(&p);
    } else if (k == 0) {
        end_at_node(&p, 0, 1, 2);
    }
    if (k + 1 == last) {
        end_at_node(&p, 3, 2, 1);
    }
    return p;
}

/* Weights of the control points, or their derivatives of order 1 or 2. */
static void evaluate_weights(const span *p, double u, int order, double weights[CONTROL_POINTS])
{
    for (int i = 0; i < CONTROL_POINTS; i++) {
        const double *b = p->basis[i];
        weights[i] = order == 0   ? ((b[3] * u + b[2]) * u + b[1]) * u + b[0]
                     : order == 1 ? (3.0 * b[3] * u + 2.0 * b[2]) * u + b[1]
                                  : 6.0 * b[3] * u + 2.0 * b[2];
    }
}

static vec3 weighted_sum(const span *p, const double weights[CONTROL_POINTS])
{
    vec3 sum = vec3_zero();
    for (int i = 0; i < CONTROL_POINTS; i++) {
        sum = vec3_add_scaled(sum, weights[i], p->control_point[i]);
    }
    return sum;
}

static vec3 curve_at(const span *p, double u, int order)
{
    double weights[CONTROL_POINTS];
    evaluate_weights(p, u, order, weights);
    return weighted_sum(p, weights);
}

static double distance_derivative(const span *p, vec3 to, double u)
{
    return vec3_dot(vec3_sub(curve_at(p, u, 0), to), curve_at(p, u, 1));
}

/* Parameter of the nearest point, by false position; an end that is kept twice counts half
 * (Illinois). The derivative of the distance must be negative at 0 and positive at 1. */
static double nearest_parameter(const span *p, vec3 to)
{
    double low = 0.0, high = 1.0, at_low = distance_derivative(p, to, low),
           at_high = distance_derivative(p, to, high);
    double u = low;
    for (int i = 0, side = 0; i < SUTURE_MAX_ITERATIONS && at_high > at_low; i++) {
        u = low - at_low * (high - low) / (at_high - at_low);
        double found = distance_derivative(p, to, u);
        if (!(found != 0.0) || !(u > low) || !(u < high)) {
            break;
        }
        if (found > 0.0) {
            high = u;
            at_high = found;
            at_low *= side > 0 ? 0.5 : 1.0;
            side = 1;
        } else {
            low = u;
            at_low = found;
            at_high *= side < 0 ? 0.5 : 1.0;
            side = -1;
        }
    }
    return u;
}

/* ---- points */

static suture_curve_point point_in_span(const suture_curve *curve, uint32_t k, const span *p,
                                        double u)
{
    double weights[CONTROL_POINTS], derivatives[CONTROL_POINTS];
    suture_curve_point point = {.span = k, .u = u, .first_node = p->first_node};
    evaluate_weights(p, u, 0, weights);
    evaluate_weights(p, u, 1, derivatives);
    const vec3 derivative = weighted_sum(p, derivatives), second_derivative = curve_at(p, u, 2);
    const double size = vec3_norm(derivative), speed = size > 0.0 ? size : curve->thread->rest[k];
    point.position = weighted_sum(p, weights);
    point.tangent = vec3_unit_or(vec3_neg(derivative), vec3_make(1.0, 0.0, 0.0));
    point.curvature = vec3_add_scaled(second_derivative,
                                      -vec3_dot(second_derivative, point.tangent), point.tangent);
    point.curvature = vec3_scale(point.curvature, -1.0 / (speed * speed));
    for (uint32_t i = 0; i < CONTROL_POINTS; i++) {
        point.arc += weights[i] * p->arc[i];
        if (k > 0 || i > 0) {
            point.weights[k + i - 1 - p->first_node] = weights[i];
            point.weight_derivatives[k + i - 1 - p->first_node] = derivatives[i] / speed;
        }
    }
    if (p->is_at_swage) {
        point.needle_weight = weights[0];
        point.needle_point = pose_apply_inverse(curve->needle_pose, p->control_point[0]);
    }
    return point;
}

/* Point on the straight continuation of a span beyond its start or end. */
static suture_curve_point point_beyond_span(const suture_curve *curve, uint32_t k, const span *p,
                                            bool at_end, vec3 to)
{
    suture_curve_point point = point_in_span(curve, k, p, at_end ? 1.0 : 0.0);
    double weights[CONTROL_POINTS], on = -vec3_dot(vec3_sub(to, point.position), point.tangent);
    evaluate_weights(p, at_end ? 1.0 : 0.0, 1, weights);
    double size = vec3_norm(weighted_sum(p, weights)), delta_u = size > 0.0 ? on / size : 0.0;
    point.position = vec3_add_scaled(point.position, -on, point.tangent);
    for (uint32_t i = k > 0 ? 0 : 1; i < CONTROL_POINTS; i++) {
        point.weights[k + i - 1 - p->first_node] += delta_u * weights[i];
    }
    point.needle_weight += p->is_at_swage ? delta_u * weights[0] : 0.0;
    for (uint32_t i = 0; i < CONTROL_POINTS; i++) {
        point.arc += delta_u * weights[i] * p->arc[i];
    }
    point.curvature = vec3_zero();
    memset(point.weight_derivatives, 0, sizeof point.weight_derivatives);
    for (uint32_t i = k > 0 ? 0 : 1; i < CONTROL_POINTS && size > 0.0; i++) {
        point.weight_derivatives[k + i - 1 - p->first_node] = weights[i] / size;
    }
    return point;
}

static suture_curve_point point_on_needle(const suture_curve *curve, double arc)
{
    suture_curve_point point = {.arc = arc, .needle_weight = 1.0, .span = SUTURE_ON_NEEDLE};
    point.needle_point = vbss_needle_point(curve->needle, arc);
    point.position = pose_apply(curve->needle_pose, point.needle_point);
    point.tangent =
        quat_rotate(curve->needle_pose.orientation, vbss_needle_direction(curve->needle, arc));
    return point;
}

/* ---- nearest point */

static uint32_t last_span(const suture_curve *curve)
{
    return curve->thread->node_count - 2;
}

/* Arc length at the start of a span; k > 0. */
static double span_start_arc(const suture_curve *curve, uint32_t k)
{
    const double *rest = curve->thread->rest;
    return curve->swage_arc + vbss_thread_arc_length(curve->thread, k) +
           (rest[k] - rest[k - 1]) / 6.0;
}

/* Starts of spans increase, as rest lengths are positive. */
uint32_t vbss_suture_span_at(const suture_curve *curve, double arc)
{
    uint32_t low = 0, high = last_span(curve);
    while (low < high) {
        const uint32_t middle = high - (high - low) / 2;
        if (arc > span_start_arc(curve, middle)) {
            low = middle;
        } else {
            high = middle - 1;
        }
    }
    return low;
}

/* Descends from a span to the nearest local minimum among spans low to high. */
static suture_curve_point search_thread(const suture_curve *curve, uint32_t from, uint32_t low,
                                        uint32_t high, vec3 to)
{
    uint32_t k = from < low ? low : from > high ? high : from;
    for (int direction = 0;;) {
        const span p = span_of(curve, k);
        bool back = distance_derivative(&p, to, 0.0) > 0.0,
             on = distance_derivative(&p, to, 1.0) < 0.0;
        if (back && direction <= 0) {
            if (p.is_at_swage) {
                vec3 in_needle_frame = pose_apply_inverse(curve->needle_pose, to);
                return point_on_needle(
                    curve, vbss_min(vbss_needle_nearest_arc(curve->needle, in_needle_frame),
                                    curve->swage_arc));
            }
            if (k == low) {
                return point_beyond_span(curve, k, &p, false, to);
            }
            direction = -1;
            k--;
        } else if (on && !back && direction >= 0) {
            if (k == high) {
                return point_beyond_span(curve, k, &p, true, to);
            }
            direction = 1;
            k++;
        } else {
            return point_in_span(curve, k, &p, back ? 0.0 : on ? 1.0 : nearest_parameter(&p, to));
        }
    }
}

static suture_curve_point search(const suture_curve *curve, double from, uint32_t low,
                                 uint32_t high, vec3 to)
{
    if (curve->needle != NULL && from < curve->swage_arc) {
        double arc =
            vbss_needle_nearest_arc(curve->needle, pose_apply_inverse(curve->needle_pose, to));
        if (arc < curve->swage_arc) {
            return point_on_needle(curve, arc);
        }
    }
    return search_thread(curve, vbss_suture_span_at(curve, from), low, high, to);
}

suture_curve_point vbss_suture_nearest_point(const suture_curve *curve, double from, vec3 to)
{
    if (curve->thread == NULL) {
        return point_on_needle(
            curve,
            vbss_needle_nearest_arc(curve->needle, pose_apply_inverse(curve->needle_pose, to)));
    }
    return search(curve, from, 0, last_span(curve), to);
}

suture_curve_point vbss_suture_nearest_point_around_span(const suture_curve *curve,
                                                         uint32_t centre_span, double from, vec3 to)
{
    uint32_t low = centre_span > 0 ? centre_span - 1 : centre_span;
    uint32_t high = centre_span < last_span(curve) ? centre_span + 1 : centre_span;
    return search(curve, from, low, high, to);
}

/* ---- capstan friction */

/* Vector from the end of a segment to its start, which is on the tip's side. Before the first
 * segment it is the needle's direction, or the first segment without a needle. */
static vec3 segment_vector(const suture_curve *curve, int64_t i)
{
    const int64_t last = (int64_t)curve->thread->node_count - 2;
    if (i < 0 && curve->needle != NULL) {
        vec3 along = vbss_needle_direction(curve->needle, curve->swage_arc);
        return vec3_scale(quat_rotate(curve->needle_pose.orientation, along),
                          curve->thread->rest[0]);
    }
    const int64_t at = i < 0 ? 0 : i < last ? i : last;
    return vec3_sub(curve->node_positions[at], curve->node_positions[at + 1]);
}

/* Directions of the suture on the tip's side and on the other, beyond the nodes that the point
 * moves. They change continuously along the curve; a jump would push the suture to and fro between
 * two spans. */
static void directions_at(const suture_curve *curve, const suture_curve_point *point,
                          vec3 direction[2])
{
    const bool later = point->u > 0.5;
    const int64_t k = (int64_t)point->span + later;
    const double u = point->u + (later ? -0.5 : 0.5);
    direction[0] = vec3_lerp(segment_vector(curve, k - 3), segment_vector(curve, k - 2), u);
    direction[1] = vec3_lerp(segment_vector(curve, k + 1), segment_vector(curve, k + 2), u);
    direction[0] = vec3_unit_or(direction[0], point->tangent);
    direction[1] = vec3_unit_or(vec3_neg(direction[1]), vec3_neg(point->tangent));
}

/* With tensions 1 on one side and exp(mu theta) on the other: the force along over that across. */
static double capstan_ratio(vec3 low, vec3 high, vec3 along, double ratio, double friction)
{
    double along_force = -ratio * vec3_dot(high, along) - vec3_dot(low, along);
    vec3 sum = vec3_add_scaled(low, ratio, high);
    vec3 across = vec3_add_scaled(sum, -vec3_dot(sum, along), along);
    return (along_force + SUTURE_BEND_REGULARISATION * friction) /
           (vec3_norm(across) + SUTURE_BEND_REGULARISATION);
}

void vbss_suture_capstan_friction(const suture_curve *curve, const suture_curve_point *point,
                                  double friction, double capstan[2])
{
    vec3 direction[2];
    directions_at(curve, point, direction);
    double theta = vbss_arc_tangent(vec3_norm(vec3_cross(direction[0], direction[1])),
                                    -vec3_dot(direction[0], direction[1]));
    double ratio = vbss_exp(friction * theta);
    /* against the tangent, the suture is pulled toward the tip */
    capstan[0] =
        capstan_ratio(direction[1], direction[0], vec3_neg(point->tangent), ratio, friction);
    capstan[1] = capstan_ratio(direction[0], direction[1], point->tangent, ratio, friction);
    if (capstan[0] + capstan[1] < 0.0) { /* by rounding, or if both sides bend the same way */
        capstan[1] = 0.5 * (capstan[1] - capstan[0]);
        capstan[0] = -capstan[1];
    }
}
