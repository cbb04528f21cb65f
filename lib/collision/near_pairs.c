/* Near pairs: a list of pairs that stays valid while shapes move a little.
 *
 * The trees of a shape hold loose boxes, which contain the swept boxes of the present motion and of
 * some more like it. All pairs whose loose boxes overlap are near pairs. While swept boxes stay in
 * their loose boxes, the candidates are the near pairs whose swept boxes overlap, and a search needs
 * no tree. The candidates do not depend on how loose the boxes are. */
#include "collision/shapes.h"
#include "collision/tuning.h"

/* ---- loose boxes */

static bool contains(const collision_aabb *box, const collision_aabb *other)
{
    bool inside = true;
    for (int k = 0; k < 3; k++) {
        inside = inside & (box->low[k] <= other->low[k]) & (box->high[k] >= other->high[k]);
    }
    return inside;
}

static bool contain_all_swept_boxes(const collision_shape *s)
{
    for (uint32_t i = 0; i < s->node_count; i++) {
        if (!contains(&s->point_bvh.boxes[i], &s->swept_boxes[i])) {
            return false;
        }
    }
    return true;
}

static void set_loose_boxes(collision_shape *s)
{
    const bool is_tight = s->is_tight || s->is_static;
    const double margin = is_tight ? 0.0 : COLLISION_LOOSENESS * s->inflation;
    const double steps = is_tight ? 0.0 : COLLISION_LOOSE_STEPS;
    collision_aabb root = aabb_empty();
    for (uint32_t i = 0; i < s->node_count; i++) {
        const vec3 motion = vec3_sub(s->end[i], s->start[i]);
        const double ahead[3] = {steps * motion.x, steps * motion.y, steps * motion.z};
        collision_aabb *box = &s->point_bvh.boxes[i];
        *box = s->swept_boxes[i];
        for (int k = 0; k < 3; k++) {
            box->low[k] += vbss_min(ahead[k], 0.0) - margin;
            box->high[k] += vbss_max(ahead[k], 0.0) + margin;
        }
        aabb_extend(&root, box);
    }
    s->loose_root = root;
    s->has_new_loose_boxes = true;
    vbss_collision_shape_invalidate_trees(s);
}

void vbss_collision_fit_loose_boxes(collision_shape *s)
{
    if (!s->has_loose_boxes || !contain_all_swept_boxes(s)) {
        s->has_loose_boxes = true;
        set_loose_boxes(s);
    }
}

void vbss_collision_tighten_boxes(collision_object *c)
{
    for (uint32_t i = 0; i < c->active_count; i++) {
        collision_shape *s = c->shapes[c->active_shapes[i]];
        if (!s->is_static && s->posed == NULL) {
            s->is_tight = true;
            set_loose_boxes(s);
        }
    }
}

void vbss_collision_allow_loose_boxes(collision_object *c)
{
    for (uint32_t i = 0; i < c->active_count; i++) {
        c->shapes[c->active_shapes[i]]->is_tight = false;
    }
}

bool vbss_collision_have_boxes_changed(collision_object *c)
{
    bool changed = false;
    for (uint32_t i = 0; i < c->active_count; i++) {
        collision_shape *s = c->shapes[c->active_shapes[i]];
        s->has_new_loose_boxes = s->has_new_loose_boxes || !c->near_valid;
        changed = changed || s->has_new_loose_boxes;
    }
    return changed || !c->near_valid;
}

/* ---- the list */

static bool is_of_same_boxes(const collision_object *c, const collision_candidate *q)
{
    return c->near_valid && !c->shapes[q->shape_a]->has_new_loose_boxes &&
           !c->shapes[q->shape_b]->has_new_loose_boxes;
}

/* Merges two sorted lists: the present near pairs and the pairs of shapes with new loose boxes. */
static bool merge_lists(collision_object *c, const collision_candidate *listed, uint32_t count)
{
    uint32_t i = 0, k = 0, merged = 0;
    while (i < count || k < c->previous_count) {
        const collision_candidate *q = &listed[i], *p = &c->previous_pairs[k];
        int order = i == count               ? -1
                    : k == c->previous_count ? 1
                                             : vbss_collision_compare_candidates(p, q);
        if (order >= 0 || is_of_same_boxes(c, p)) {
            if (merged == c->search.pair_capacity) {
                return false;
            }
            c->near_pairs[merged] = order >= 0 ? *q : *p;
            c->separations[merged++] = order <= 0 ? c->previous_separations[k] : 0.0;
        }
        i += order >= 0;
        k += order <= 0;
    }
    c->near_count = merged;
    return true;
}

bool vbss_collision_merge_near_pairs(collision_object *c, uint32_t count)
{
    vbss_collision_swap_separation_cache(c);
    if (!merge_lists(c, c->candidates, count)) {
        vbss_collision_swap_separation_cache(c);
        return false;
    }
    for (uint32_t i = 0; i < c->active_count; i++) {
        c->shapes[c->active_shapes[i]]->has_new_loose_boxes = false;
    }
    return true;
}

/* ---- candidates */

/* Swept box of a feature from those of its nodes, equal to the bit to the inflated box around all
 * their positions. */
static inline collision_aabb box_around(const collision_aabb *boxes, const uint32_t *nodes,
                                        uint32_t count)
{
    collision_aabb box = boxes[nodes[0]];
    for (uint32_t k = 1; k < count; k++) {
        aabb_extend(&box, &boxes[nodes[k]]);
    }
    return box;
}

/* Differences are exact in sign. The padding of boxes lets compilers process all lanes at once. */
static inline bool overlap(const collision_aabb *a, const collision_aabb *b)
{
    double depth[4];
    for (int k = 0; k < 4; k++) {
        depth[k] = vbss_min(a->high[k] - b->low[k], b->high[k] - a->low[k]);
    }
    return vbss_min(vbss_min(depth[0], depth[1]), depth[2]) >= 0.0;
}

/* One feature of a near pair. */
typedef struct near_feature {
    collision_aabb box;
    double displacement; /* since the last search, m */
} near_feature;

static inline near_feature feature_of(collision_shape *s, const uint32_t *nodes, uint32_t count)
{
    if (s->posed != NULL) {
        vbss_collision_set_posed_nodes(s, nodes, count);
    }
    return (near_feature){box_around(s->swept_boxes, nodes, count),
                          max_over_nodes(s->search_displacement, nodes, count)};
}

bool vbss_collision_filter_near_pairs(collision_object *c)
{
    near_feature a = {.displacement = 0.0};
    uint32_t count = 0;
    for (uint32_t i = 0; i < c->near_count; i++) {
        const collision_candidate *q = &c->near_pairs[i];
        const bool edges = q->kind == VBSS_COLLISION_PAIR_EDGE_EDGE;
        if (i == 0 || q->a != q[-1].a || q->shape_a != q[-1].shape_a || q->kind != q[-1].kind) {
            collision_shape *s = c->shapes[q->shape_a];
            a = edges ? feature_of(s, s->edges[q->a], 2) : feature_of(s, &q->a, 1);
        }
        collision_shape *other = c->shapes[q->shape_b];
        const near_feature b = edges ? feature_of(other, other->edges[q->b], 2)
                                     : feature_of(other, other->triangles[q->b], 3);
        c->separations[i] -= COLLISION_ROUNDED_UP * (a.displacement + b.displacement);
        c->candidates[count] = *q;
        c->near_index[count] = i;
        count += overlap(&a.box, &b.box);
        if (count > c->search.pair_capacity) {
            return false;
        }
    }
    c->candidate_count = count;
    return true;
}
