/* Contact scales: the suture does not touch the wall around a hole, and jaws come nearer to the wall
 * that they grasp. */
#include "scene/contacts/contacts.h"
#include "scene/tissue/tissue.h"
#include "scene/tools/tools.h"
#include "scene/tuning.h"
#include "scene/world/world.h"

/* Reach of a thread relative to that of a needle. */
#define THREAD_REACH_RATIO (SCENE_THREAD_EXCLUSION_ARC / SCENE_EXCLUSION_ARC_RATIO)

/* Exclusion radius of a hole for a point of the suture, m. A needle that enters at a small angle
 * has pressed down the wall beside its tip. There the radius is larger until the tip has passed
 * the hole. */
static double exclusion_reach(const suture_hole *hole, const scene_body *suture, double arc,
                              double reach)
{
    bool at_mouth = hole->needle != 0 && hole->arc < 0.0 && suture->kind == SCENE_BODY_RIGID &&
                    vbss_scene_is_at_tip(suture, arc);
    return at_mouth ? vbss_max(reach, -SCENE_EXCLUSION_ARC_RATIO * hole->entry_arc) : reach;
}

static double segment_length(const scene_body *thread, uint32_t segment)
{
    const thread_object *t = thread->thread.thread;
    const uint32_t last = t->node_count - 2, own = segment < last ? segment : last;
    return vbss_thread_arc_length(t, own + 1) - vbss_thread_arc_length(t, own);
}

/* Radius within which a suture does not touch the wall, m. A thread bends at once, so its radius is
 * smaller than a needle's. */
static double suture_reach(const scene_body *suture, double reach)
{
    return suture->kind == SCENE_BODY_THREAD ? THREAD_REACH_RATIO * reach : reach;
}

/* Length within which a thread may return to its side of the wall, m: that where contact is not complete, and
 * the segment beside it. */
static double return_length(const scene_body *thread, uint32_t segment, double reach)
{
    return vbss_max((1.0 + SCENE_EXIT_RAMP_RATIO) * reach,
                    reach + SCENE_RETURN_SEGMENTS * segment_length(thread, segment));
}

/* Not through the walls of drains: these fold, so the triangle of the hole does not tell on which side of them a point is.
 * There a needle that is turned back could get stuck. */
static bool may_thread_return(const suture_hole *hole, const scene_body *suture,
                              const scene_body *wall_body)
{
    return hole->thread != 0 && hole->thread == suture->number &&
           scene_host_surface_of(wall_body) != NULL;
}

/* Whether a point of a thread is on the side of the wall from which the hole's other half of the thread comes. A fast
 * pull can take a node past a hole before it has gone through. `beyond`: arc length from the hole to the point, m. */
static bool is_on_wrong_side(const suture_hole *hole, const suture_wall *wall,
                             const scene_body *thread, uint32_t segment, double fraction,
                             double beyond, vec3 wall_point)
{
    const vec3 *x = thread->thread.thread->now.x;
    const vec3 point =
        fraction > 0.0 ? vec3_lerp(x[segment], x[segment + 1], fraction) : x[segment];
    const vec3 off = vec3_sub(point, wall_point);
    /* The thread's start, of arc length 0, is beyond the wall in the direction in which the tip went. */
    const bool belongs_outside = hole->is_outward == (beyond < 0.0);
    return vbss_suture_is_outward(wall, hole->triangle, belongs_outside ? vec3_neg(off) : off);
}

/* Distance from a hole along the suture, across the swage too, m. INFINITY if another suture is in
 * the hole. */
static double arc_from_hole(const scene_object *s, const suture_hole *hole,
                            const scene_body *suture, double arc, double time)
{
    bool thread = suture->kind == SCENE_BODY_THREAD;
    const double hole_arc = hole->arc + time * hole->trial_slide;
    if (suture->number == (thread ? hole->thread : hole->needle)) {
        return fabs(hole_arc - arc);
    }
    uint32_t number = thread ? hole->needle : hole->thread;
    const scene_body *other =
        thread ? vbss_scene_swaged_needle(s, suture) : vbss_scene_swaged_thread(s, suture);
    if (number == 0 || other == NULL || other->number != number) {
        return (double)INFINITY;
    }
    const scene_body *needle = thread ? other : suture;
    double length = vbss_needle_length(needle->rigid.needle);
    return fabs(thread ? length + arc - hole_arc : length + hole_arc - arc);
}

/* Near its swage a thread has the exclusion radius of its needle: the contact scale does not jump
 * as the swage passes. */
static double reach_at_swage(const scene_object *s, const scene_body *suture, uint32_t segment,
                             const scene_body *wall_body, double reach)
{
    if (suture->kind != SCENE_BODY_THREAD) {
        return reach;
    }
    const scene_body *needle = vbss_scene_swaged_needle(s, suture);
    if (needle == NULL) {
        return reach;
    }
    double wire = needle->rigid.needle->config.wire_radius;
    double contact_distance =
        SCENE_EXCLUSION_ARC_RATIO * (wire + 0.5 * vbss_scene_wall_of(wall_body).law->thickness);
    double arc = vbss_scene_suture_arc_length(suture, segment, 0.0);
    double more = SCENE_EXCLUSION_ARC_RATIO * (wire - suture->thread.thread->config.radius);
    return arc < contact_distance ? reach + vbss_max(more, 0.0) : reach;
}

/* Contact scale at a distance from a hole, given in exclusion radii. */
static double scale_beside_hole(const scene_body *suture, double reaches)
{
    double ramp_length = suture->kind == SCENE_BODY_THREAD ? SCENE_EXIT_RAMP_RATIO : 0.0;
    if (reaches < 1.0) {
        return 0.0;
    }
    return reaches < 1.0 + ramp_length ? (reaches - 1.0) / ramp_length : 1.0;
}

/* Position of a hole at a time 0..1 within the substep. */
static vec3 hole_point_at(const suture_hole *hole, const suture_wall *wall, double time)
{
    const vec3 start = vbss_hole_point(hole, wall, wall->now);
    return time > 0.0 ? vec3_lerp(start, vbss_hole_point(hole, wall, wall->trial), time) : start;
}

/* Smallest contact scale over all holes. The distance counts along the suture, in the current and
 * in the rest shape: walls that lie on each other are near now, but not at rest. */
static double scale_in_holes(const scene_object *s, const scene_body *suture, uint32_t segment,
                             double fraction, const scene_body *wall_body,
                             const scene_wall_point *wall_point, double reach)
{
    const suture_wall wall = vbss_scene_wall_of(wall_body);
    const double own = reach_at_swage(s, suture, segment, wall_body, suture_reach(suture, reach));
    double scale = 1.0;
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        const suture_hole *hole = &s->holes[i];
        if (hole->id == 0 || hole->wall != wall_body->number) {
            continue;
        }
        double now = vec3_distance(wall_point->now, hole_point_at(hole, &wall, wall_point->time));
        double rest = vec3_distance(wall_point->rest, vbss_hole_point(hole, &wall, wall.rest));
        double max_reach = vbss_max(own, -SCENE_EXCLUSION_ARC_RATIO * hole->entry_arc);
        const double may_return =
            may_thread_return(hole, suture, wall_body) ? return_length(suture, segment, own) : 0.0;
        if (!(vbss_max(now, rest) <
              vbss_max((1.0 + SCENE_EXIT_RAMP_RATIO) * max_reach, may_return))) {
            continue;
        }
        double arc = vbss_scene_suture_arc_length(suture, segment, fraction);
        const double beyond = arc - hole->arc;
        if (fabs(beyond) < may_return &&
            is_on_wrong_side(hole, &wall, suture, segment, fraction, beyond, wall_point->now)) {
            return 0.0;
        }
        double hole_reach = exclusion_reach(hole, suture, arc, own);
        double distance =
            vbss_max(vbss_max(now, rest), arc_from_hole(s, hole, suture, arc, wall_point->time));
        scale = vbss_min(scale, scale_beside_hole(suture, distance / hole_reach));
    }
    return scale;
}

double vbss_scene_contact_scale_at(const scene_object *s, const scene_body *body, bool is_point,
                                   uint32_t feature, double fraction, const scene_body *wall_body,
                                   const scene_wall_point *wall_point, double reach)
{
    if (body->kind == SCENE_BODY_RIGID && is_point) { /* the two ends of a capsule are adjacent */
        fraction = feature % 2;
        feature /= 2;
    }
    if (body->kind == SCENE_BODY_RIGID &&
        vbss_scene_is_wall_in_grasp(s, wall_body, wall_point->now, body, feature)) {
        return SCENE_HELD_WALL_CONTACT_SCALE;
    }
    bool node = is_point && body->kind == SCENE_BODY_THREAD;
    return vbss_scene_is_suture(body) ? scale_in_holes(s, body, feature, node ? 0.0 : fraction,
                                                       wall_body, wall_point, reach)
                                      : 1.0;
}

/* Moves `from` to the end of a hole's exclusion interval if it is inside, and returns true.
 * Otherwise moves `to` back to the start of that interval. `arc`: place of the hole along the
 * needle, m. */
static bool pass_hole(const suture_hole *hole, double arc, const scene_body *needle, double reach,
                      double *from, double *to)
{
    double start = arc - reach, end = arc + reach;
    double mouth = arc + exclusion_reach(hole, needle, 0.0, reach);
    end = vbss_max(
        end, vbss_min(SCENE_TIP_LENGTH_RATIO * needle->rigid.needle->config.wire_radius, mouth));
    bool is_inside = start <= *from && *from < end;
    *from = is_inside ? end : *from;
    *to = start > *from ? vbss_min(*to, start) : *to;
    return is_inside;
}

/* Finds the next interval of arc lengths from..to outside all holes. False: the capsule has no
 * further one. */
static bool find_interval(const scene_object *s, const scene_body *needle,
                          const scene_body *wall_body, double reach, double *from, double *to)
{
    const double end = *to, length = vbss_needle_length(needle->rigid.needle);
    const scene_body *thread = vbss_scene_swaged_thread(s, needle);
    bool moved = true;
    while (moved) { /* where one hole's interval ends, another may start */
        moved = false;
        *to = end;
        for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
            const suture_hole *h = &s->holes[i];
            /* The hole is in the swaged thread. */
            bool behind = thread != NULL && h->thread == thread->number;
            bool own = h->id != 0 && (behind || h->needle == needle->number);
            double arc = behind ? length + h->arc : h->arc;
            moved = (own && h->wall == wall_body->number &&
                     pass_hole(h, arc, needle, reach, from, to)) ||
                    moved;
        }
    }
    return *from < *to;
}

/* Clips an edge to the half space beyond `point` in direction `along`. False: nothing is left. */
static bool clip_edge(const vec3 edge[2], vec3 point, vec3 along, double fractions[2])
{
    double start = vec3_dot(vec3_sub(edge[0], point), along);
    double end = vec3_dot(vec3_sub(edge[1], point), along);
    if (start < 0.0 && end < 0.0) {
        return false;
    }
    double cut = start != end ? start / (start - end) : 0.0;
    fractions[0] = start < 0.0 ? vbss_max(fractions[0], cut) : fractions[0];
    fractions[1] = end < 0.0 ? vbss_min(fractions[1], cut) : fractions[1];
    return fractions[0] < fractions[1];
}

/* Clips the edge by the planes across the ends of an axis interval, except at ends of the
 * capsule. */
static bool clip_to_interval(const vec3 axis[2], const vec3 edge[2], double at[2][2])
{
    vec3 along = vec3_sub(axis[1], axis[0]);
    at[1][0] = 0.0;
    at[1][1] = 1.0;
    return (at[0][0] <= 0.0 ||
            clip_edge(edge, vec3_lerp(axis[0], axis[1], at[0][0]), along, at[1])) &&
           (at[0][1] >= 1.0 ||
            clip_edge(edge, vec3_lerp(axis[0], axis[1], at[0][1]), vec3_neg(along), at[1]));
}

bool vbss_scene_next_axis_interval(const scene_object *s, const scene_body *needle,
                                   uint32_t capsule, const scene_body *wall_body, uint32_t edge,
                                   double reach, scene_axis_interval *interval)
{
    const uint32_t *node = s->collision->shapes[wall_body->shape]->edges[edge];
    const vec3 *x = vbss_scene_wall_of(wall_body).now, edge_points[2] = {x[node[0]], x[node[1]]};
    const vec3 *axis = s->capsules[needle->rigid.first_capsule + capsule].now;
    const double start = vbss_scene_suture_arc_length(needle, capsule, 0.0);
    const double end = vbss_scene_suture_arc_length(needle, capsule, 1.0);
    double from = interval->started ? interval->end_arc : start, to = end;
    while (find_interval(s, needle, wall_body, reach, &from, &to)) {
        *interval = (scene_axis_interval){true, to, {{(from - start) / (end - start)}}};
        interval->bounds[0][1] = to < end ? (to - start) / (end - start) : 1.0;
        if (clip_to_interval(axis, edge_points, interval->bounds)) {
            return true;
        }
        from = to;
        to = end;
    }
    return false;
}

static scene_wall_point wall_point_of(const scene_object *s, const scene_body *wall_body,
                                      const contact_constraint *constraint)
{
    const double *at = scene_geometry_of(s, constraint)->barycentric;
    const double weights[3] = {1.0 - at[0] - at[1], at[0], at[1]};
    if (constraint->key.kind == VBSS_SCENE_CONTACT_POINT_FACE) {
        return vbss_scene_wall_point(wall_body, constraint->key.feature_b, weights);
    }
    const uint32_t *edge = s->collision->shapes[wall_body->shape]->edges[constraint->key.feature_b];
    return vbss_scene_wall_point_on_edge(wall_body, edge, at[1]);
}

double vbss_scene_contact_scale_of(const scene_object *s, const contact_constraint *constraint)
{
    const scene_body *a = vbss_scene_body(s, constraint->key.body_a);
    const scene_body *b = vbss_scene_body(s, constraint->key.body_b);
    if (scene_is_wall(a) || !scene_is_wall(b)) {
        return 1.0;
    }
    const scene_contact_geometry *geometry = scene_geometry_of(s, constraint);
    const scene_wall_point wall_point = wall_point_of(s, b, constraint);
    return vbss_scene_contact_scale_at(s, a, constraint->key.kind == VBSS_SCENE_CONTACT_POINT_FACE,
                                       constraint->key.feature_a, geometry->barycentric[0], b,
                                       &wall_point,
                                       SCENE_EXCLUSION_ARC_RATIO * geometry->contact_distance);
}
