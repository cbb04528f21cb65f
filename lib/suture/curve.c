/* The suture as one curve: a needle's arc, then the thread behind it, by one arc length.
 *
 * A thread is smooth here, or what slides along it would jump at every node: from the middle of a segment over its node to
 * the middle of the next a parabola, a quadratic B-spline (docs/stitch.md). Its span k is that over node k. At the swage one
 * leads from the needle's end into the middle of the first segment; where no span follows, the curve goes on straight. */
#include "suture/suture.h"

/* How much of the needle belongs to the span over the swage, in radii of its wire. */
#define SWAGE_LEG 1.0
/* Steps of the search in a span: the last bits take few. */
enum { STEPS = 24 };

/* ---- spans */

typedef struct span {
    vec3 corner[3];    /* control points */
    double begin;      /* arc length on the line */
    double leg, other; /* unstretched lengths before and after the node, m */
} span;

static double leg_of_needle(const suture_line *line)
{
    return SWAGE_LEG * line->needle->config.wire_radius;
}

static span span_of(const suture_line *line, uint32_t k)
{
    const double *rest = line->thread->rest;
    const vec3 *x = line->x;
    span p = {.leg = k == 0 ? leg_of_needle(line) : 0.5 * rest[k - 1], .other = 0.5 * rest[k]};
    p.begin = line->swage + vbss_thread_arc_length(line->thread, k) - p.leg;
    p.corner[0] = k > 0 ? vec3_lerp(x[k - 1], x[k], 0.5)
                        : pose_apply(line->at, vbss_needle_point(line->needle, p.begin));
    p.corner[1] = x[k];
    p.corner[2] = vec3_lerp(x[k], x[k + 1], 0.5);
    return p;
}

static vec3 point_at(const span *p, double u)
{
    vec3 a = vec3_lerp(p->corner[0], p->corner[1], u), b = vec3_lerp(p->corner[1], p->corner[2], u);
    return vec3_lerp(a, b, u);
}

/* Half the derivative with u. */
static vec3 way_at(const span *p, double u)
{
    return vec3_lerp(vec3_sub(p->corner[1], p->corner[0]), vec3_sub(p->corner[2], p->corner[1]), u);
}

/* Exact where the thread is straight and not stretched. */
static double arc_at(const span *p, double u)
{
    return p->begin + 2.0 * p->leg * u + (p->other - p->leg) * u * u;
}

static double slope_at(const span *p, vec3 to, double u)
{
    return vec3_dot(vec3_sub(point_at(p, u), to), way_at(p, u));
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
    double before = (1.0 - u) * (1.0 - u), after = 0.5 * u * u;
    suture_place place = {.arc = arc_at(p, u), .point = point_at(p, u), .span = k};
    double speed = 2.0 * (p->leg + (p->other - p->leg) * u), size = vec3_norm(way_at(p, u));
    vec3 bend =
        vec3_sub(vec3_sub(p->corner[2], p->corner[1]), vec3_sub(p->corner[1], p->corner[0]));
    place.tangent = vec3_unit_or(vec3_neg(way_at(p, u)), vec3_make(1.0, 0.0, 0.0));
    bend = vec3_add_scaled(bend, -vec3_dot(bend, place.tangent), place.tangent);
    place.turn = size > 0.0 ? vec3_scale(bend, -1.0 / (size * speed)) : vec3_zero();
    place.first = k > 0 ? k - 1 : 0;
    if (k > 0) {
        place.weights[0] = 0.5 * before;
        place.weights[1] = 1.0 - 0.5 * before - after;
        place.weights[2] = after;
        place.slopes[0] = (u - 1.0) / speed;
        place.slopes[1] = (1.0 - 2.0 * u) / speed;
        place.slopes[2] = u / speed;
    } else {
        place.on_needle = before;
        place.needle = pose_apply_inverse(line->at, p->corner[0]);
        place.weights[0] = 1.0 - before - after;
        place.weights[1] = after;
        place.slopes[0] = (2.0 - 3.0 * u) / speed;
        place.slopes[1] = u / speed;
    }
    return place;
}

/* On along the segment at the begin or the end of span k. */
static suture_place place_beyond(const suture_line *line, uint32_t k, const span *p, bool at_end,
                                 vec3 to)
{
    suture_place place = place_in(line, k, p, at_end ? 1.0 : 0.0);
    uint32_t segment = at_end ? k : k - 1;
    vec3 along = vec3_sub(line->x[segment + 1], line->x[segment]);
    double square = vec3_norm_squared(along);
    double share = square > 0.0 ? vec3_dot(vec3_sub(to, place.point), along) / square : 0.0;
    place.arc += share * line->thread->rest[segment];
    place.point = vec3_add_scaled(place.point, share, along);
    uint32_t i = segment - place.first;
    place.weights[i] -= share;
    place.weights[i + 1] += share;
    place.turn = vec3_zero();
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

static uint32_t first_span(const suture_line *line)
{
    return line->needle != NULL ? 0 : 1;
}

uint32_t vbss_suture_span_at(const suture_line *line, double arc)
{
    double left = arc - line->swage;
    uint32_t k = 0, last = last_span(line);
    while (k < last && left > 0.5 * line->thread->rest[k]) {
        left -= line->thread->rest[k++];
    }
    return k < first_span(line) ? first_span(line) : k;
}

/* Downhill from a span to the next place that is nearest, among spans low to high. */
static suture_place search_thread(const suture_line *line, uint32_t from, uint32_t low,
                                  uint32_t high, vec3 to)
{
    uint32_t k = from < low ? low : from > high ? high : from;
    vec3 seen = pose_apply_inverse(line->at, to);
    for (int way = 0;;) {
        const span p = span_of(line, k);
        bool back = slope_at(&p, to, 0.0) > 0.0, on = slope_at(&p, to, 1.0) < 0.0;
        if (back && way <= 0) {
            if (k == 0) {
                return place_on_needle(line,
                                       lesser(vbss_needle_nearest(line->needle, seen), p.begin));
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
    double swage = line->needle == NULL ? 0.0 : line->swage - leg_of_needle(line);
    if (line->needle != NULL && from < swage) {
        double arc = vbss_needle_nearest(line->needle, pose_apply_inverse(line->at, to));
        if (arc < swage) {
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
    return search(line, from, first_span(line), last_span(line), to);
}

suture_place vbss_suture_nearest_by(const suture_line *line, uint32_t by, double from, vec3 to)
{
    uint32_t low = by > first_span(line) ? by - 1 : by;
    uint32_t high = by < last_span(line) ? by + 1 : by;
    return search(line, from, low, high, to);
}

/* ---- what friction is worth there */

/* Where the suture comes from on the side of the tip, and where it goes: beyond the nodes that a place moves. */
static void directions_at(const suture_line *line, const suture_place *place, vec3 way[2])
{
    const thread_object *t = line->thread;
    uint32_t k = place->span, last = t->node_count - 1;
    uint32_t before = k > 2 ? k - 2 : 0, after = k + 2 <= last ? k + 1 : last - 1;
    way[0] = vec3_sub(line->x[before], line->x[before + 1]);
    if (k < 2 && line->needle != NULL) {
        way[0] =
            quat_rotate(line->at.orientation, vbss_needle_direction(line->needle, line->swage));
    }
    way[1] = vec3_sub(line->x[after + 1], line->x[after]);
    way[0] = vec3_unit_or(way[0], place->tangent);
    way[1] = vec3_unit_or(way[1], vec3_neg(place->tangent));
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
