/* Memory and results of collision objects, and their shapes by id. */
#include "base/error.h"
#include "base/memory.h"
#include "base/simd_dispatch.h"
#include "collision/shapes.h"

#include <string.h>

/* ---- memory: one table lists all arrays */

enum { ARRAY_COUNT = 26 };

static size_t list_arrays(collision_object *c, vbss_array arrays[ARRAY_COUNT])
{
    size_t shapes = c->config.shape_capacity, pairs = c->config.pair_capacity;
    size_t active = c->active_capacity, groups = vbss_collision_bvh_group_count(c->active_capacity);
    size_t impacts = c->config.impact_capacity, separations = c->caches_separation ? pairs : 0;
    const vbss_array all[] = {
        {&c->shapes, shapes, sizeof(collision_shape *)},
        {&c->active_shapes, active, sizeof *c->active_shapes},
        {&c->overlapping, active, sizeof *c->overlapping},
        {&c->shape_bvh.boxes, active, sizeof *c->shape_bvh.boxes},
        {&c->shape_bvh.order, active, sizeof *c->shape_bvh.order},
        {&c->shape_bvh.group_boxes, groups, sizeof *c->shape_bvh.group_boxes},
        {&c->shape_bvh.groups, groups, sizeof *c->shape_bvh.groups},
        {&c->search.parents_a, COLLISION_SEARCH_PARENTS, sizeof *c->search.parents_a},
        {&c->search.parents_b, COLLISION_SEARCH_PARENTS, sizeof *c->search.parents_b},
        {&c->search.pairs, pairs + COLLISION_BVH_WIDTH, sizeof *c->search.pairs},
        {&c->buckets, COLLISION_SORT_BUCKETS, sizeof *c->buckets},
        {&c->runs, (size_t)c->run_capacity + 1, sizeof *c->runs},
        {&c->candidates, pairs + 1, sizeof *c->candidates}, /* one for the filter of near pairs */
        {&c->near_index, separations > 0 ? separations + 1 : 0, sizeof *c->near_index},
        {&c->near_pairs, separations, sizeof *c->near_pairs},
        {&c->previous_pairs, separations, sizeof *c->previous_pairs},
        {&c->separations, separations, sizeof *c->separations},
        {&c->previous_separations, separations, sizeof *c->previous_separations},
        {&c->block, 1, sizeof *c->block},
        {&c->ccd_options.limbs, COLLISION_LIMBS, sizeof *c->ccd_options.limbs},
        {&c->impacts, impacts, sizeof *c->impacts},
        {&c->times, impacts, sizeof *c->times},
        {&c->distances, impacts, sizeof *c->distances},
        {&c->normals, impacts, sizeof *c->normals},
        {&c->weights, impacts, sizeof *c->weights},
        {&c->decisions, impacts, sizeof *c->decisions},
    };
    _Static_assert(sizeof all == ARRAY_COUNT * sizeof(vbss_array), "the table has its length");
    memcpy(arrays, all, sizeof all);
    return ARRAY_COUNT;
}

void vbss_collision_free(vbss_context *context, void *object)
{
    collision_object *c = object;
    vbss_array arrays[ARRAY_COUNT];
    for (uint32_t i = 0; i < c->shape_count; i++) {
        if (c->shapes[i] != NULL) {
            vbss_collision_shape_free(context, c->shapes[i]);
        }
    }
    vbss_release_arrays(context, arrays, list_arrays(c, arrays));
    vbss_release(context, c, 1, sizeof *c);
}

/* Two kinds of pairs for any two shapes, but no more runs than candidates. */
static uint32_t max_runs(uint64_t shapes, uint32_t pairs)
{
    uint64_t runs = 2 * shapes * shapes;
    return runs < pairs ? (uint32_t)runs : pairs;
}

vbss_result vbss_collision_allocate(vbss_context *context, const vbss_collision_config *config,
                                    uint32_t active_capacity, bool caches_separation,
                                    collision_object **collision)
{
    collision_object *c = vbss_allocate(context, 1, sizeof *c, "collision object");
    vbss_array arrays[ARRAY_COUNT];
    if (c == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    c->context = context;
    c->config = *config;
    c->baseline_config = *config->baseline;
    c->config.baseline = &c->baseline_config;
    c->ccd_options = vbss_collision_ccd_options_of(config);
    c->ccd_options.limb_count = COLLISION_LIMBS;
    c->wide = vbss_wide_is_available();
    c->thickness = config->thickness;
    c->caches_separation = caches_separation;
    c->active_capacity = active_capacity;
    c->run_capacity = max_runs(active_capacity, config->pair_capacity);
    c->search.pair_capacity = config->pair_capacity;
    vbss_result result =
        vbss_allocate_arrays(context, arrays, list_arrays(c, arrays), "collision object");
    if (result != VBSS_OK) {
        vbss_collision_free(context, c);
        return result;
    }
    *collision = c;
    return VBSS_OK;
}

/* ---- results and shapes */

void vbss_collision_clear_results(collision_object *c)
{
    c->candidate_count = c->impact_count = 0;
}

vbss_result vbss_collision_find_shape(const collision_object *c, uint32_t id,
                                      collision_shape **shape)
{
    *shape = id < c->shape_count ? c->shapes[id] : NULL;
    return *shape != NULL ? VBSS_OK
                          : vbss_fail(c->context, VBSS_ERROR_NOT_FOUND, "there is no shape %u", id);
}
