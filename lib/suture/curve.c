/* The suture as one curve: a needle's arc, then the thread behind it, by one arc length.
 *
 * A thread is smooth here, or what slides along it would jump at every node: a cubic B-spline with its nodes as control points
 * (docs/stitch.md), continuous up to its curvature. Its span k is that of segment k; its arc length is the same spline of the
 * nodes' arc lengths. Where the thread ends the spline ends in its last node, and the curve goes on straight. At the swage it
 * begins in the needle's end, along the needle. */
#include "base/elementary.h"
#include "suture/suture.h"

#include <string.h>

/* Steps of the search in a span: the last bits take few. */
enum { STEPS = 24 };

/* ---- spans */

enum { CORNERS = SUTURE_NODES };

/* Four corners with cubic weights of u from 0 to 1: coefficients of its powers. Without a needle the first is node `first`; with
 * one, over the swage, it is a point of the needle. */
typedef struct span {
    vec3 corner[CORNERS];
    double arc[CORNERS]; /* arc lengths on the line */
    double basis[CORNERS][4];
    uint32_t first; /* node */
    bool swage;
} span;

static const double spline[CORNERS][4] = {{1.0 / 6.0, -0.5, 0.5, -1.0 / 6.0},
                                          {4.0 / 6.0, 0.0, -1.0, 0.5},
                                          {1.0 / 6.0, 0.5, 0.5, -0.5},
                                          {0.0, 0.0, 0.0, 1.0 / 6.0}};

static void add_weight(double to[4], double share, const double of[4])
{
    for (int i = 0; i < 4; i++) {
        to[i] += share * of[i];
    }
}

/* From the needle's end, whence the needle points on, to where the spline is at the first node: Hermite's cubics. */
static void lay_swage(span *p)
{
    static const double h[4][4] = {
        {1.0, 0.0, -3.0, 2.0}, {0.0, 1.0, -2.0, 1.0}, {0.0, 0.0, 3.0, -2.0}, {0.0, 0.0, -1.0, 1.0}};
    memset(p->basis, 0, sizeof p->basis);
    add_weight(p->basis[0], -1.0, h[1]);
    add_weight(p->basis[1], 1.0, h[0]);
    add_weight(p->basis[1], 1.0, h[1]);
    for (int k = 0; k < 3; k++) {
        add_weight(p->basis[1 + k], k == 1 ? 4.0 / 6.0 : 1.0 / 6.0, h[2]);
        add_weight(p->basis[1 + k], 0.5 * (k - 1), h[3]);
    }
}

/* Beyond the last node one like the one before, on the other side: there the spline ends in the last. */
static void end_in(span *p, int beyond, int last, int before)
{
    add_weight(p->basis[last], 2.0, p->basis[beyond]);
    add_weight(p->basis[before], -1.0, p->basis[beyond]);
    memset(p->basis[beyond], 0, sizeof p->basis[beyond]);
}

static span span_of(const suture_line *line, uint32_t k)
{
    const double *rest = line->thread->rest;
    const uint32_t last = line->thread->node_count - 1;
    span p = {.first = k > 0 ? k - 1 : 0, .swage = k == 0 && line->needle != NULL};
    memcpy(p.basis, spline, sizeof p.basis);
    double arc = line->swage + vbss_thread_arc_length(line->thread, p.first);
    for (uint32_t i = k > 0 ? 0 : 1; i < CORNERS; i++) {
        uint32_t node = k + i - 1;
        if (node <= last) {
            p.corner[i] = line->x[node];
            p.arc[i] = arc;
            arc += node < last ? rest[node] : 0.0;
        }
    }
    if (p.swage) {
        const needle_object *n = line->needle;
        vec3 back = vec3_add_scaled(vbss_needle_point(n, line->swage), rest[0],
                                    vbss_needle_direction(n, line->swage));
        p.corner[0] = pose_apply(line->at, back);
        p.arc[0] = line->swage - rest[0];
        lay_swage(&p);
    } else if (k == 0) {
        end_in(&p, 0, 1, 2);
    }
    if (k + 1 == last) {
        end_in(&p, 3, 2, 1);
    }
    return p;
}

/* Derivatives of the weights: of order 0, 1, 2. */
static void weigh(const span *p, double u, int order, double weights[CORNERS])
{
    for (int i = 0; i < CORNERS; i++) {
        const double *b = p->basis[i];
        weights[i] = order == 0   ? ((b[3] * u + b[2]) * u + b[1]) * u + b[0]
                     : order == 1 ? (3.0 * b[3] * u + 2.0 * b[2]) * u + b[1]
                                  : 6.0 * b[3] * u + 2.0 * b[2];
    }
}

static vec3 sum_of(const span *p, const double weights[CORNERS])
{
    vec3 sum = vec3_zero();
    for (int i = 0; i < CORNERS; i++) {
        sum = vec3_add_scaled(sum, weights[i], p->corner[i]);
    }
    return sum;
}

static vec3 curve_at(const span *p, double u, int order)
{
    double weights[CORNERS];
    weigh(p, u, order, weights);
    return sum_of(p, weights);
}

static double slope_at(const span *p, vec3 to, double u)
{
    return vec3_dot(vec3_sub(curve_at(p, u, 0), to), curve_at(p, u, 1));
}

/* The slope is below 0 at 0 and above at 1: false position, with an end that stays counted half (Illinois). */
static double nearest_within(const span *p, vec3 to)
{
    double low = 0.0, high = 1.0, at_low = slope_at(p, to, low), at_high = slope_at(p, to, high);
    double u = low;
    for (int i = 0, side = 0; i < STEPS && at_high > at_low; i++) {
        u = low - at_low * (high - low) / (at_high - at_low);
        double found = slope_at(p, to, u);
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

/* ---- places */

static suture_place place_in(const suture_line *line, uint32_t k, const span *p, double u)
{
    double weights[CORNERS], slopes[CORNERS];
    suture_place place = {.span = k, .share = u, .first = p->first};
    weigh(p, u, 0, weights);
    weigh(p, u, 1, slopes);
    const vec3 way = sum_of(p, slopes), bend = curve_at(p, u, 2);
    const double size = vec3_norm(way), speed = size > 0.0 ? size : line->thread->rest[k];
    place.point = sum_of(p, weights);
    place.tangent = vec3_unit_or(vec3_neg(way), vec3_make(1.0, 0.0, 0.0));
    place.turn = vec3_add_scaled(bend, -vec3_dot(bend, place.tangent), place.tangent);
    place.turn = vec3_scale(place.turn, -1.0 / (speed * speed));
    for (uint32_t i = 0; i < CORNERS; i++) {
        place.arc += weights[i] * p->arc[i];
        if (k > 0 || i > 0) {
            place.weights[k + i - 1 - p->first] = weights[i];
            place.slopes[k + i - 1 - p->first] = slopes[i] / speed;
        }
    }
    if (p->swage) {
        place.on_needle = weights[0];
        place.needle = pose_apply_inverse(line->at, p->corner[0]);
    }
    return place;
}

/* On along the segment at the begin or the end of the thread, or of what is looked at. */
static suture_place place_beyond(const suture_line *line, uint32_t k, const span *p, bool at_end,
                                 vec3 to)
{
    suture_place place = place_in(line, k, p, at_end ? 1.0 : 0.0);
    double weights[CORNERS], on = -vec3_dot(vec3_sub(to, place.point), place.tangent);
    weigh(p, at_end ? 1.0 : 0.0, 1, weights);
    double size = vec3_norm(sum_of(p, weights)), share = size > 0.0 ? on / size : 0.0;
    place.point = vec3_add_scaled(place.point, -on, place.tangent);
    for (uint32_t i = k > 0 ? 0 : 1; i < CORNERS; i++) {
        place.weights[k + i - 1 - p->first] += share * weights[i];
    }
    place.on_needle += p->swage ? share * weights[0] : 0.0;
    for (uint32_t i = 0; i < CORNERS; i++) {
        place.arc += share * weights[i] * p->arc[i];
    }
    place.turn = vec3_zero();
    memset(place.slopes, 0, sizeof place.slopes);
    for (uint32_t i = k > 0 ? 0 : 1; i < CORNERS && size > 0.0; i++) {
        place.slopes[k + i - 1 - p->first] = weights[i] / size;
    }
    return place;
}

static suture_place place_on_needle(const suture_line *line, double arc)
{
    suture_place place = {.arc = arc, .on_needle = 1.0, .span = SUTURE_ON_NEEDLE};
    place.needle = vbss_needle_point(line->needle, arc);
    place.point = pose_apply(line->at, place.needle);
    place.tangent = quat_rotate(line->at.orientation, vbss_needle_direction(line->needle, arc));
    return place;
}

/* ---- the search */

static uint32_t last_span(const suture_line *line)
{
    return line->thread->node_count - 2;
}

/* Of a span's begin. */
static double arc_of_joint(const suture_line *line, uint32_t k)
{
    const double *rest = line->thread->rest;
    return line->swage + vbss_thread_arc_length(line->thread, k) + (rest[k] - rest[k - 1]) / 6.0;
}

uint32_t vbss_suture_span_at(const suture_line *line, double arc)
{
    uint32_t k = 0, last = last_span(line);
    while (k < last && arc > arc_of_joint(line, k + 1)) {
        k++;
    }
    return k;
}

/* Downhill from a span to the next place that is nearest, among spans low to high. */
static suture_place search_thread(const suture_line *line, uint32_t from, uint32_t low,
                                  uint32_t high, vec3 to)
{
    uint32_t k = from < low ? low : from > high ? high : from;
    for (int way = 0;;) {
        const span p = span_of(line, k);
        bool back = slope_at(&p, to, 0.0) > 0.0, on = slope_at(&p, to, 1.0) < 0.0;
        if (back && way <= 0) {
            if (p.swage) {
                vec3 seen = pose_apply_inverse(line->at, to);
                return place_on_needle(
                    line, vbss_min(vbss_needle_nearest(line->needle, seen), line->swage));
            }
            if (k == low) {
                return place_beyond(line, k, &p, false, to);
            }
            way = -1;
            k--;
        } else if (on && !back && way >= 0) {
            if (k == high) {
                return place_beyond(line, k, &p, true, to);
            }
            way = 1;
            k++;
        } else {
            return place_in(line, k, &p, back ? 0.0 : on ? 1.0 : nearest_within(&p, to));
        }
    }
}

static suture_place search(const suture_line *line, double from, uint32_t low, uint32_t high,
                           vec3 to)
{
    if (line->needle != NULL && from < line->swage) {
        double arc = vbss_needle_nearest(line->needle, pose_apply_inverse(line->at, to));
        if (arc < line->swage) {
            return place_on_needle(line, arc);
        }
    }
    return search_thread(line, vbss_suture_span_at(line, from), low, high, to);
}

suture_place vbss_suture_nearest(const suture_line *line, double from, vec3 to)
{
    if (line->thread == NULL) {
        return place_on_needle(line,
                               vbss_needle_nearest(line->needle, pose_apply_inverse(line->at, to)));
    }
    return search(line, from, 0, last_span(line), to);
}

suture_place vbss_suture_nearest_by(const suture_line *line, uint32_t by, double from, vec3 to)
{
    uint32_t low = by > 0 ? by - 1 : by;
    uint32_t high = by < last_span(line) ? by + 1 : by;
    return search(line, from, low, high, to);
}

/* ---- what friction is worth there */

/* From a segment's end to its begin, which is on the side of the tip; before the first the needle goes on, or it does. */
static vec3 way_of_segment(const suture_line *line, int64_t i)
{
    const int64_t last = (int64_t)line->thread->node_count - 2;
    if (i < 0 && line->needle != NULL) {
        vec3 along = vbss_needle_direction(line->needle, line->swage);
        return vec3_scale(quat_rotate(line->at.orientation, along), line->thread->rest[0]);
    }
    const int64_t at = i < 0 ? 0 : i < last ? i : last;
    return vec3_sub(line->x[at], line->x[at + 1]);
}

/* Where the suture comes from on the side of the tip, and where it goes: beyond the nodes that a place moves. From segment to
 * segment that turns as the place goes on: if it jumped, the suture would be pushed to and fro between two spans. */
static void directions_at(const suture_line *line, const suture_place *place, vec3 way[2])
{
    const bool later = place->share > 0.5;
    const int64_t k = (int64_t)place->span + later;
    const double u = place->share + (later ? -0.5 : 0.5);
    way[0] = vec3_lerp(way_of_segment(line, k - 3), way_of_segment(line, k - 2), u);
    way[1] = vec3_lerp(way_of_segment(line, k + 1), way_of_segment(line, k + 2), u);
    way[0] = vec3_unit_or(way[0], place->tangent);
    way[1] = vec3_unit_or(vec3_neg(way[1]), vec3_neg(place->tangent));
}

/* As much bend as this is none: a straight suture rubs as what is pressed across. */
#define STRAIGHT 0.01

/* With tensions 1 on one side and exp(mu theta) on the other: the force along over that across. */
static double grip_of(vec3 low, vec3 high, vec3 along, double ratio, double friction)
{
    double pulls = -ratio * vec3_dot(high, along) - vec3_dot(low, along);
    vec3 sum = vec3_add_scaled(low, ratio, high);
    vec3 across = vec3_add_scaled(sum, -vec3_dot(sum, along), along);
    return (pulls + STRAIGHT * friction) / (vec3_norm(across) + STRAIGHT);
}

void vbss_suture_grip(const suture_line *line, const suture_place *place, double friction,
                      double grip[2])
{
    vec3 way[2];
    directions_at(line, place, way);
    double theta = vbss_atan2(vec3_norm(vec3_cross(way[0], way[1])), -vec3_dot(way[0], way[1]));
    double ratio = vbss_exp(friction * theta);
    /* against the tangent on the suture: it is pulled toward the tip */
    grip[0] = grip_of(way[1], way[0], vec3_neg(place->tangent), ratio, friction);
    grip[1] = grip_of(way[0], way[1], place->tangent, ratio, friction);
    if (grip[0] + grip[1] < 0.0) { /* by rounding, or what turns away from both */
        grip[1] = 0.5 * (grip[1] - grip[0]);
        grip[0] = -grip[1];
    }
}
