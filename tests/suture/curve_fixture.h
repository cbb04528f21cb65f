/* Threads laid by hand, as curves. */
#ifndef VBSS_TESTS_SUTURE_CURVE_FIXTURE_H
#define VBSS_TESTS_SUTURE_CURVE_FIXTURE_H

#include <math.h>

#include "harness/harness.h"
#include "suture/suture.h"

enum { LAID_MAX = 64 };

typedef struct laid {
    vec3 x[LAID_MAX];
    double rest[LAID_MAX];
    thread_object thread;
    suture_curve line;
} laid;

/* Of that many nodes, all that is left is where they are. */
static inline void place_nodes(laid *l, uint32_t count)
{
    *l = (laid){.thread = {.node_count = count}};
    l->thread.rest = l->rest;
    l->line = (suture_curve){
        .needle_pose = pose_identity(), .thread = &l->thread, .node_positions = l->x};
}

/* On from a place by a segment, unstretched. */
static inline void place_on(laid *l, uint32_t node, double length, vec3 direction)
{
    l->rest[node - 1] = length;
    l->x[node] = vec3_add_scaled(l->x[node - 1], length, direction);
}

/* Segments of 0.7 to 1.3 mm that turn by some degrees each; from a given begin in a given direction. */
static inline void place_any(harness_source *source, laid *l, uint32_t count, vec3 begin,
                             vec3 direction)
{
    place_nodes(l, count);
    l->x[0] = begin;
    for (uint32_t i = 1; i < count; i++) {
        double length = harness_draw_real(source, 0.7e-3, 1.3e-3);
        place_on(l, i, length, direction);
        direction =
            vec3_unit_or(vec3_add(direction, harness_draw_vec3(source, -0.3, 0.3)), direction);
    }
}

/* Toward the tip. */
static inline vec3 back_along(const laid *l, uint32_t segment)
{
    return vec3_unit_or(vec3_sub(l->x[segment], l->x[segment + 1]), vec3_zero());
}

/* ---- the curve by hand: the library's own formulas are others */

/* A node and, along x, its arc length; beyond either end as far on as the node before is on the other side. */
static inline void control_point(const laid *l, int node, vec3 *at, vec3 *arc)
{
    const int last = (int)l->thread.node_count - 1;
    if (node < 0 || node > last) {
        const int end = node < 0 ? 0 : last, before = node < 0 ? 1 : last - 1;
        vec3 ends[2], arcs[2];
        control_point(l, end, &ends[0], &arcs[0]);
        control_point(l, before, &ends[1], &arcs[1]);
        *at = vec3_sub(vec3_scale(ends[0], 2.0), ends[1]);
        *arc = vec3_sub(vec3_scale(arcs[0], 2.0), arcs[1]);
        return;
    }
    *at = l->x[node];
    *arc = vec3_zero();
    arc->x = l->line.swage_arc + vbss_thread_arc_length(&l->thread, (uint32_t)node);
}

/* Of a parameter: the point and its derivatives; the same of the arc length. */
typedef struct hand_place {
    vec3 point, derivative, bend;
    double arc, rate;
} hand_place;

/* De Boor's algorithm with knots at the integers: the point, first and second derivative. */
static inline void de_boor(const vec3 corner[4], double u, vec3 found[3])
{
    const vec3 a = vec3_lerp(corner[0], corner[1], (u + 2.0) / 3.0);
    const vec3 b = vec3_lerp(corner[1], corner[2], (u + 1.0) / 3.0);
    const vec3 c = vec3_lerp(corner[2], corner[3], u / 3.0);
    const vec3 d = vec3_lerp(a, b, (u + 1.0) / 2.0), e = vec3_lerp(b, c, u / 2.0);
    found[0] = vec3_lerp(d, e, u);
    found[1] = vec3_scale(vec3_sub(e, d), 3.0);
    found[2] = vec3_scale(vec3_sub(vec3_sub(c, b), vec3_sub(b, a)), 3.0);
}

/* On the span of a segment, u from 0 to 1; not over a swage. */
static inline hand_place by_hand(const laid *l, uint32_t span, double u)
{
    vec3 corner[4], arc[4], at[3], length[3];
    for (int i = 0; i < 4; i++) {
        control_point(l, (int)span + i - 1, &corner[i], &arc[i]);
    }
    de_boor(corner, u, at);
    de_boor(arc, u, length);
    return (hand_place){at[0], at[1], at[2], length[0].x, length[1].x};
}

/* Toward the tip. */
static inline vec3 tangent_by_hand(const hand_place *place)
{
    return vec3_unit_or(vec3_neg(place->derivative), vec3_zero());
}

/* How that turns by length, from thread to tip: the curvature. */
static inline vec3 turn_by_hand(const hand_place *place)
{
    const vec3 along = tangent_by_hand(place);
    vec3 aside = vec3_add_scaled(place->bend, -vec3_dot(place->bend, along), along);
    return vec3_scale(aside, -1.0 / vec3_norm_squared(place->derivative));
}

/* Seen from either side of a joint: no step in place, arc length or direction; with `turns` none in curvature. */
static inline void expect_no_step(const suture_curve *line, const hand_place *joint, vec3 along,
                                  bool turns)
{
    const double aside = 1e-10;
    for (int side = -1; side <= 1; side++) {
        const vec3 near = vec3_add_scaled(joint->point, -aside * side, along);
        const suture_curve_point place =
            vbss_suture_nearest_point(line, joint->arc + 1e-5 * side, near);
        expect_near(0.0, vec3_distance(joint->point, place.position), 1.01 * aside);
        expect_near(joint->arc, place.arc, 1.1 * aside);
        expect_near(0.0, vec3_distance(along, place.tangent), 1e-6);
        if (turns) {
            expect_near(0.0, vec3_distance(turn_by_hand(joint), place.curvature), 1e-3);
        }
    }
}

/* ---- what places say */

/* What a place has of a node. */
static inline double number_of(const suture_curve_point *place,
                               const double numbers[SUTURE_SPAN_NODES], uint32_t node)
{
    bool own = place->span != SUTURE_ON_NEEDLE && node >= place->first_node &&
               node < place->first_node + SUTURE_SPAN_NODES;
    return own ? numbers[node - place->first_node] : 0.0;
}

/* All of its weights: of nodes and of the needle. */
static inline double sum_of_weights(const laid *l, const suture_curve_point *place)
{
    double sum = place->needle_weight;
    for (uint32_t i = 0; i < l->thread.node_count; i++) {
        sum += number_of(place, place->weights, i);
    }
    return sum;
}

/* The point of the needle that it is moved by, in the world. */
static inline vec3 on_needle(const suture_curve *line, const suture_curve_point *place)
{
    return place->needle_weight != 0.0 ? pose_apply(line->needle_pose, place->needle_point)
                                       : vec3_zero();
}

/* The place as its nodes, needle and weights have it. */
static inline vec3 point_by_weights(const laid *l, const suture_curve_point *place)
{
    vec3 point = vec3_scale(on_needle(&l->line, place), place->needle_weight);
    for (uint32_t i = 0; i < l->thread.node_count; i++) {
        point = vec3_add_scaled(point, number_of(place, place->weights, i), l->x[i]);
    }
    return point;
}

#endif
