/* Separation cache: lower bounds of the distances of candidates, carried from one search to the
 * next.
 *
 * A caller that has measured the axes of a candidate stores the distance. The next search passes it
 * on to the same pair, reduced by the motion of its nodes. The cache only saves measurements and
 * never changes a result. It is not part of the state, and the caches of two objects with equal
 * positions may differ. */
#include "collision/shapes.h"

/* Factors that make proved bounds safe against rounding, relative to the distance. Chosen. */
#define ROUNDED_UP (1.0 + 1e-9)
#define ROUNDED_DOWN (1.0 - 1e-9)

/* ---- displacement of nodes */

void vbss_collision_update_displacements(collision_shape *s)
{
    for (uint32_t i = 0; i < s->node_count; i++) {
        s->displacement[i] = vec3_distance(s->start[i], s->end[i]);
    }
}

/* Displacement since the last search; infinite for a shape that has changed since. */
static void update_search_displacements(collision_shape *s)
{
    for (uint32_t i = 0; i < s->node_count; i++) {
        s->search_displacement[i] =
            s->has_search_start ? vec3_distance(s->search_start[i], s->start[i]) : (double)INFINITY;
        s->search_start[i] = s->start[i];
    }
    s->has_search_start = true;
}

static inline double max_over_nodes(const double *of_nodes, const uint32_t *nodes, uint32_t count)
{
    double largest = of_nodes[nodes[0]];
    for (uint32_t k = 1; k < count; k++) {
        largest = vbss_max(of_nodes[nodes[k]], largest);
    }
    return largest;
}

/* Largest value over the nodes of feature a of a candidate, and of feature b. */
static double max_of_feature_a(const collision_candidate *q, const collision_shape *a,
                               const double *of_nodes)
{
    return q->kind == VBSS_PAIR_EDGE_EDGE ? max_over_nodes(of_nodes, a->edges[q->a], 2)
                                          : of_nodes[q->a];
}

static double max_of_feature_b(const collision_candidate *q, const collision_shape *b,
                               const double *of_nodes)
{
    return q->kind == VBSS_PAIR_EDGE_EDGE ? max_over_nodes(of_nodes, b->edges[q->b], 2)
                                          : max_over_nodes(of_nodes, b->triangles[q->b], 3);
}

/* ---- cached separations */

void vbss_collision_store_separation(collision_object *c, const collision_candidate *q,
                                     double distance)
{
    c->separations[q - c->candidates] = ROUNDED_DOWN * distance;
}

bool vbss_collision_stays_separated(const collision_object *c, const collision_candidate *q,
                                    double distance)
{
    const double separation = c->separations[q - c->candidates];
    if (!(separation > ROUNDED_UP * distance)) {
        return false;
    }
    const collision_shape *a = c->shapes[q->shape_a], *b = c->shapes[q->shape_b];
    double displacement =
        max_of_feature_a(q, a, a->displacement) + max_of_feature_b(q, b, b->displacement);
    return separation > ROUNDED_UP * (distance + displacement);
}

/* ---- from one search to the next */

void vbss_collision_swap_separation_cache(collision_object *c)
{
    collision_candidate *candidates = c->previous_candidates;
    double *separation = c->previous_separations;
    c->previous_candidates = c->candidates;
    c->previous_separations = c->separations;
    c->previous_count = c->separation_count;
    c->candidates = candidates;
    c->separations = separation;
    c->separation_count = 0;
}

static bool is_before(const collision_candidate *p, const collision_candidate *q)
{
    return p->kind != q->kind         ? p->kind < q->kind
           : p->shape_a != q->shape_a ? p->shape_a < q->shape_a
           : p->a != q->a             ? p->a < q->a
           : p->shape_b != q->shape_b ? p->shape_b < q->shape_b
                                      : p->b < q->b;
}

static bool is_same(const collision_candidate *p, const collision_candidate *q)
{
    return p->b == q->b && p->a == q->a && p->shape_b == q->shape_b && p->shape_a == q->shape_a &&
           p->kind == q->kind;
}

/* Both lists are sorted. */
void vbss_collision_carry_separations(collision_object *c)
{
    uint32_t k = 0;
    double displacement_a = 0.0;
    for (uint32_t i = 0; i < c->active_count; i++) {
        update_search_displacements(c->shapes[c->active_shapes[i]]);
    }
    for (uint32_t i = 0; i < c->candidate_count; i++) {
        const collision_candidate *q = &c->candidates[i];
        const collision_shape *a = c->shapes[q->shape_a], *b = c->shapes[q->shape_b];
        if (i == 0 || q->a != q[-1].a || q->shape_a != q[-1].shape_a || q->kind != q[-1].kind) {
            displacement_a = max_of_feature_a(q, a, a->search_displacement);
        }
        while (k < c->previous_count && is_before(&c->previous_candidates[k], q)) {
            k++;
        }
        bool is_known = k < c->previous_count && is_same(&c->previous_candidates[k], q);
        c->separations[i] =
            is_known
                ? c->previous_separations[k] -
                      ROUNDED_UP * (displacement_a + max_of_feature_b(q, b, b->search_displacement))
                : 0.0;
    }
    c->separation_count = c->candidate_count;
}
