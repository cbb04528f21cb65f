/* Threads laid by hand, as curves. */
#ifndef VBSS_TESTS_SUTURE_CURVE_FIXTURE_H
#define VBSS_TESTS_SUTURE_CURVE_FIXTURE_H

#include <math.h>

#include "harness/harness.h"
#include "suture/suture.h"

enum { LAID_MOST = 64 };

typedef struct laid {
    vec3 x[LAID_MOST];
    double rest[LAID_MOST];
    thread_object thread;
    suture_line line;
} laid;

/* Of that many nodes, all that is left is where they are. */
static inline void lay_nodes(laid *l, uint32_t count)
{
    *l = (laid){.thread = {.node_count = count}};
    l->thread.rest = l->rest;
    l->line = (suture_line){.at = pose_identity(), .thread = &l->thread, .x = l->x};
}

/* On from a place by a segment, unstretched. */
static inline void lay_on(laid *l, uint32_t node, double length, vec3 way)
{
    l->rest[node - 1] = length;
    l->x[node] = vec3_add_scaled(l->x[node - 1], length, way);
}

/* Segments of 0.7 to 1.3 mm that turn by some degrees each; of a begin and a way that are given. */
static inline void lay_any(harness_source *source, laid *l, uint32_t count, vec3 begin, vec3 way)
{
    lay_nodes(l, count);
    l->x[0] = begin;
    for (uint32_t i = 1; i < count; i++) {
        double length = harness_draw_real(source, 0.7e-3, 1.3e-3);
        lay_on(l, i, length, way);
        way = vec3_unit_or(vec3_add(way, harness_draw_vec3(source, -0.3, 0.3)), way);
    }
}

/* The middle of a segment, and its arc length on the line. */
static inline vec3 middle_of(const laid *l, uint32_t segment)
{
    return vec3_lerp(l->x[segment], l->x[segment + 1], 0.5);
}

static inline double arc_of_middle(const laid *l, uint32_t segment)
{
    return l->line.swage + vbss_thread_arc_length(&l->thread, segment) + 0.5 * l->rest[segment];
}

/* Toward the tip. */
static inline vec3 back_along(const laid *l, uint32_t segment)
{
    return vec3_unit_or(vec3_sub(l->x[segment], l->x[segment + 1]), vec3_zero());
}

/* The place of a line at a parameter, as its nodes and weights have it. */
static inline vec3 point_by_weights(const suture_line *line, const suture_place *place)
{
    vec3 point = vec3_zero();
    if (place->on_needle != 0.0) {
        point = vec3_scale(pose_apply(line->at, place->needle), place->on_needle);
    }
    for (uint32_t k = 0; place->span != SUTURE_ON_NEEDLE && k < 3; k++) {
        if (place->weights[k] != 0.0) {
            point = vec3_add_scaled(point, place->weights[k], line->x[place->first + k]);
        }
    }
    return point;
}

#endif
