/* Memory of shapes: one table lists all arrays; those that a shape does not need stay NULL. */
#include "base/error.h"
#include "base/memory.h"
#include "collision/shapes.h"

#include <string.h>

void vbss_collision_exclusion_arrays(const collision_shape *s, collision_exclusion *exclusion,
                                     vbss_array arrays[COLLISION_EXCLUSION_ARRAYS])
{
    size_t n = s->node_count, e = s->edge_count, t = s->triangle_count;
    const vbss_array all[COLLISION_EXCLUSION_ARRAYS] = {
        {&exclusion->edges, e * exclusion->words, sizeof *exclusion->edges},
        {&exclusion->triangles, t * exclusion->words, sizeof *exclusion->triangles},
        {&exclusion->edge_lanes, s->edge_bvh.level_groups[0] * e, sizeof *exclusion->edge_lanes},
        {&exclusion->point_lanes, s->point_bvh.level_groups[0] * t, sizeof *exclusion->point_lanes},
        {&exclusion->first_edge, n + 1, sizeof *exclusion->first_edge},
        {&exclusion->edges_of, 2 * e, sizeof *exclusion->edges_of},
        {&exclusion->leaf_of, e > n ? e : n, sizeof *exclusion->leaf_of},
    };
    memcpy(arrays, all, sizeof all);
}

enum { ARRAY_COUNT = 24 + COLLISION_EXCLUSION_ARRAYS };

typedef struct array_list {
    vbss_array arrays[ARRAY_COUNT];
    size_t count;
} array_list;

/* `pointer` is the address of the shape's pointer to the array. */
static void add_array(array_list *list, void *pointer, size_t count, size_t size)
{
    const vbss_array array = {pointer, count, size};
    if (count > 0) {
        list->arrays[list->count++] = array;
    }
}

static void add_bvh(array_list *list, collision_bvh *bvh, uint32_t features, bool ordered)
{
    size_t groups = vbss_collision_bvh_group_count(features);
    add_array(list, &bvh->boxes, features, sizeof *bvh->boxes);
    add_array(list, &bvh->group_boxes, groups, sizeof *bvh->group_boxes);
    add_array(list, &bvh->groups, groups, sizeof *bvh->groups);
    /* A single group needs no order. */
    add_array(list, &bvh->order, ordered && features > COLLISION_BVH_WIDTH ? features : 0,
              sizeof *bvh->order);
}

static void list_arrays(collision_shape *s, array_list *list)
{
    bool chain = s->kind == COLLISION_SHAPE_CHAIN;
    uint32_t n = s->node_capacity, e = chain ? n - 1 : s->edge_count, t = s->triangle_count;
    list->count = 0;
    add_array(list, &s->start, n, sizeof *s->start);
    add_array(list, &s->end, n, sizeof *s->end);
    add_array(list, &s->edges, e, sizeof *s->edges);
    add_array(list, &s->triangles, t, sizeof *s->triangles);
    add_array(list, &s->far_before, chain ? e : 0, sizeof *s->far_before);
    add_array(list, &s->far_after, chain ? (e + COLLISION_BVH_WIDTH - 1) / COLLISION_BVH_WIDTH : 0,
              sizeof *s->far_after);
    add_array(list, &s->edge_offsets, e, sizeof *s->edge_offsets);
    add_array(list, &s->point_offsets, n, sizeof *s->point_offsets);
    add_array(list, &s->displacement, s->caches_separation ? n : 0, sizeof *s->displacement);
    add_array(list, &s->search_displacement, s->caches_separation ? n : 0,
              sizeof *s->search_displacement);
    add_array(list, &s->search_start, s->caches_separation ? n : 0, sizeof *s->search_start);
    add_array(list, &s->swept_boxes, s->caches_separation ? n : 0, sizeof *s->swept_boxes);
    add_bvh(list, &s->point_bvh, n, !chain);
    add_bvh(list, &s->edge_bvh, e, !chain);
    add_bvh(list, &s->triangle_bvh, t, true);
    if (s->exclusion.words > 0) {
        vbss_collision_exclusion_arrays(s, &s->exclusion, list->arrays + list->count);
        list->count += COLLISION_EXCLUSION_ARRAYS;
    }
}

void vbss_collision_shape_free(vbss_context *context, collision_shape *s)
{
    array_list list;
    vbss_collision_free_posed(context, s);
    list_arrays(s, &list);
    vbss_release_arrays(context, list.arrays, list.count);
    vbss_release(context, s, 1, sizeof *s);
}

/* Inflation of the boxes of a shape: features that come within D (1 + tolerance) + margin of each
 * other have overlapping boxes. Each shape contributes its radius and half of thickness and margin.
 * The factor exceeds the few rounding errors here and in D, and DBL_MIN exceeds those of subnormal
 * numbers. Rounding of low - inflation and high + inflation loses nothing, because it preserves the
 * order of numbers: docs/explanation/collision.md. */
static double inflation_of(const vbss_collision_config *config, double radius)
{
    double half_distance = (radius + 0.5 * config->thickness) * (1.0 + config->tolerance);
    return (half_distance + 0.5 * config->margin) * (1.0 + 8.0 * DBL_EPSILON) + DBL_MIN;
}

vbss_result vbss_collision_create_shape(collision_object *c, collision_shape_kind kind,
                                        const uint32_t counts[3], double radius,
                                        collision_shape **shape)
{
    collision_shape *s = vbss_allocate(c->context, 1, sizeof *s, "shape");
    array_list list;
    *shape = NULL;
    if (s == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    s->kind = kind;
    s->node_count = s->node_capacity = counts[0];
    s->edge_count = counts[1];
    s->triangle_count = counts[2];
    s->radius = radius;
    s->category = 1;
    s->mask = UINT32_MAX;
    s->inflation = inflation_of(&c->config, radius);
    s->caches_separation = c->caches_separation;
    list_arrays(s, &list);
    vbss_result result = vbss_allocate_arrays(c->context, list.arrays, list.count, "shape");
    if (result != VBSS_OK) {
        vbss_collision_shape_free(c->context, s);
        return result;
    }
    vbss_collision_bvh_set_count(&s->point_bvh, s->node_count);
    vbss_collision_bvh_set_count(&s->edge_bvh, s->edge_count);
    vbss_collision_bvh_set_count(&s->triangle_bvh, s->triangle_count);
    *shape = s;
    return VBSS_OK;
}
