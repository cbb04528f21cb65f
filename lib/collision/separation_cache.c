/* Separation cache: lower bounds of the distances of near pairs.
 *
 * A caller that has measured the axes of a candidate stores the distance. Each search reduces it by
 * the motion of the nodes. The cache only saves measurements and never changes a result. It is not
 * part of the state, and the caches of two objects with equal positions may differ. */
#include "collision/closest.h"
#include "collision/shapes.h"
#include "collision/tuning.h"

/* ---- displacement of nodes */

void vbss_collision_update_displacements(collision_shape *s)
{
    double largest = 0.0;
    for (uint32_t i = 0; i < s->node_count; i++) {
        s->displacement[i] = vec3_distance(s->start[i], s->end[i]);
        largest = vbss_max(s->displacement[i], largest);
    }
    s->max_displacement = largest;
}

/* Displacement since the last search; infinite for a shape that has changed since. */
static void update_search_displacements(collision_shape *s)
{
    if (s->posed != NULL) {
        vbss_collision_begin_posed_search(s);
        return;
    }
    if (s->is_search_at_rest) {
        return;
    }
    s->is_search_at_rest = s->is_static && s->has_search_start;
    for (uint32_t i = 0; i < s->node_count; i++) {
        s->search_displacement[i] =
            s->has_search_start ? vec3_distance(s->search_start[i], s->start[i]) : (double)INFINITY;
        s->search_start[i] = s->start[i];
    }
    s->has_search_start = true;
}

/* Largest value over the nodes of feature a of a candidate, and of feature b. */
static double max_of_feature_a(const collision_candidate *q, const collision_shape *a,
                               const double *of_nodes)
{
    return q->kind == VBSS_COLLISION_PAIR_EDGE_EDGE ? max_over_nodes(of_nodes, a->edges[q->a], 2)
                                                    : of_nodes[q->a];
}

static double max_of_feature_b(const collision_candidate *q, const collision_shape *b,
                               const double *of_nodes)
{
    return q->kind == VBSS_COLLISION_PAIR_EDGE_EDGE
               ? max_over_nodes(of_nodes, b->edges[q->b], 2)
               : max_over_nodes(of_nodes, b->triangles[q->b], 3);
}

void vbss_collision_update_search_displacements(collision_object *c)
{
    for (uint32_t i = 0; i < c->active_count; i++) {
        update_search_displacements(c->shapes[c->active_shapes[i]]);
    }
}

/* ---- cached separations */

void vbss_collision_store_separation(collision_object *c, const collision_candidate *q,
                                     double distance)
{
    c->separations[c->near_index[q - c->candidates]] = (2.0 - COLLISION_ROUNDED_UP) * distance;
}

/* Whether the axes stay farther apart than `distance` if they are at least `separation` apart at the
 * start. */
static bool does_separation_suffice(const collision_object *c, const collision_candidate *q,
                                    double separation, double distance)
{
    if (!(separation > COLLISION_ROUNDED_UP * distance)) {
        return false;
    }
    const collision_shape *a = c->shapes[q->shape_a], *b = c->shapes[q->shape_b];
    if (separation >
        COLLISION_ROUNDED_UP * (distance + (a->max_displacement + b->max_displacement))) {
        return true; /* most pairs need no look at their nodes */
    }
    double displacement =
        max_of_feature_a(q, a, a->displacement) + max_of_feature_b(q, b, b->displacement);
    return separation > COLLISION_ROUNDED_UP * (distance + displacement);
}

bool vbss_collision_stays_separated(const collision_object *c, const collision_candidate *q,
                                    double distance)
{
    return does_separation_suffice(c, q, collision_separation(c, q), distance);
}

static double distance_at_start(const collision_object *c, const collision_candidate *q)
{
    const collision_shape *a = c->shapes[q->shape_a], *b = c->shapes[q->shape_b];
    if (q->kind == VBSS_COLLISION_PAIR_EDGE_EDGE) {
        const vec3 *p[2] = {&a->start[a->edges[q->a][0]], &a->start[a->edges[q->a][1]]};
        const vec3 *r[2] = {&b->start[b->edges[q->b][0]], &b->start[b->edges[q->b][1]]};
        double s, u;
        return vec3_norm(closest_between_edges(vec3_sub(*p[1], *p[0]), vec3_sub(*r[1], *r[0]),
                                               vec3_sub(*r[0], *p[0]), &s, &u));
    }
    vec3 triangle[3];
    double weights[3];
    for (int i = 0; i < 3; i++) {
        triangle[i] = vec3_sub(b->start[b->triangles[q->b][i]], a->start[q->a]);
    }
    return vec3_norm(closest_on_triangle(triangle, weights));
}

bool vbss_collision_is_separated(const collision_object *c, const collision_candidate *q,
                                 double distance)
{
    return vbss_collision_stays_separated(c, q, distance) ||
           does_separation_suffice(c, q, (2.0 - COLLISION_ROUNDED_UP) * distance_at_start(c, q),
                                   distance);
}

/* ---- from one list of near pairs to the next */

void vbss_collision_swap_separation_cache(collision_object *c)
{
    collision_candidate *pairs = c->previous_pairs;
    double *separations = c->previous_separations;
    uint32_t count = c->previous_count;
    c->previous_pairs = c->near_pairs;
    c->previous_separations = c->separations;
    c->previous_count = c->near_count;
    c->near_pairs = pairs;
    c->separations = separations;
    c->near_count = count;
}
