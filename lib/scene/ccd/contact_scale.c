/* Contact scales of pairs in CCD: which part of the contact distance a pair has to keep at holes, pins
 * and cuts, and in jaws. */
#include "scene/ccd/pair.h"
#include "scene/tissue/tissue.h"
#include "scene/tools/tools.h"
#include "scene/topology/topology.h"

/* Closest point of the wall at the start of the query, and the fraction of the closest point on
 * the other feature. */
static scene_wall_point find_nearest_wall_point(const scene_object *s, const ccd_query *query,
                                                bool first, const scene_body *wall,
                                                double *fraction)
{
    const collision_candidate *q = query->candidate;
    const uint32_t feature = first ? q->b : q->a;
    double coordinates[3];
    scene_wall_point wall_point;
    (void)vbss_scene_distance_at_start(s, query, coordinates);
    if (q->kind == VBSS_COLLISION_PAIR_POINT_TRIANGLE) {
        *fraction = 0.0;
        wall_point =
            vbss_scene_wall_point_at_time(wall, feature, coordinates, query->start_fraction);
    } else {
        double on_other = coordinates[first ? 0 : 1], on_side = coordinates[first ? 1 : 0];
        if (query->interval != NULL) {
            const double(*intervals)[2] = query->interval->bounds;
            on_other = intervals[0][0] + on_other * (intervals[0][1] - intervals[0][0]);
            on_side = intervals[1][0] + on_side * (intervals[1][1] - intervals[1][0]);
        }
        *fraction = on_other;
        const uint32_t *side = s->collision->shapes[wall->shape]->edges[feature];
        wall_point =
            vbss_scene_wall_point_on_edge_at_time(wall, side, on_side, query->start_fraction);
    }
    return wall_point;
}

double vbss_scene_contact_scale_at_wall(const scene_object *s, const ccd_query *query,
                                        double contact_distance, double extra_reach)
{
    const collision_candidate *q = query->candidate;
    const scene_body *a = &s->bodies[s->body_of_shape[q->shape_a]];
    const scene_body *b = &s->bodies[s->body_of_shape[q->shape_b]];
    bool first = !scene_is_wall(a), point = q->kind == VBSS_COLLISION_PAIR_POINT_TRIANGLE;
    const scene_body *other = first ? a : b, *wall = first ? b : a;
    bool holds_wall =
        other->kind == SCENE_BODY_RIGID && other->rigid.wall_grasp.drain == wall->number;
    if (scene_is_wall(other) || !scene_is_wall(wall) ||
        !(holds_wall || vbss_scene_is_suture(other))) {
        return 1.0;
    }
    double fraction;
    const scene_wall_point wall_point = find_nearest_wall_point(s, query, first, wall, &fraction);
    return vbss_scene_contact_scale_at(s, other, point, first ? q->a : q->b, fraction, wall,
                                       &wall_point,
                                       SCENE_EXCLUSION_ARC_RATIO * contact_distance + extra_reach);
}

double vbss_scene_contact_scale_of_pair(const scene_object *s, const collision_candidate *q,
                                        double contact_distance)
{
    const scene_body *a = &s->bodies[s->body_of_shape[q->shape_a]];
    const scene_body *b = &s->bodies[s->body_of_shape[q->shape_b]];
    if (scene_is_static_mesh(a) || scene_is_static_mesh(b)) {
        return vbss_scene_is_behind_mesh(s, q) ? 0.0 : 1.0;
    }
    if (scene_is_wall(a) || scene_is_wall(b)) {
        const ccd_query query = {q, NULL, 0.0};
        return vbss_scene_contact_scale_at_wall(s, &query, contact_distance,
                                                a->max_displacement + b->max_displacement);
    }
    if (a->kind == SCENE_BODY_THREAD && b->kind == SCENE_BODY_THREAD) {
        return vbss_scene_is_excluded_across_cut(s, a, q->a, b, q->b) ? 0.0 : 1.0;
    }
    if (a->kind == b->kind) {
        bool is_held = vbss_scene_is_needle_in_grasp(s, a, q->a, b, q->b) ||
                       vbss_scene_is_needle_in_grasp(s, b, q->b, a, q->a);
        return is_held ? 0.0 : 1.0;
    }
    bool is_excluded = a->kind == SCENE_BODY_THREAD
                           ? vbss_scene_is_excluded_at_pin(s, a, q->a, b, q->b, contact_distance)
                           : vbss_scene_is_excluded_at_pin(s, b, q->b, a, q->a, contact_distance);
    return is_excluded ? 0.0 : 1.0;
}
