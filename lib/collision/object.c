/* Creation, destruction and counters of collision objects. */
#include "base/check.h"
#include "base/error.h"
#include "base/stream.h"
#include "collision/shapes.h"

#include <string.h>

_Static_assert(sizeof(vbss_collision_statistics) == 80, "published size");

static const uint32_t statistics_sizes[] = {80, 0};
static const vbss_layout statistics_layout = {"vbss_collision_statistics", NULL, statistics_sizes};

static vbss_result check_capacities(vbss_context *context, const vbss_collision_config *c)
{
    VBSS_TRY(vbss_check_range(context, c->shape_capacity, 0.0, 65536.0, "shape_capacity"));
    VBSS_TRY(vbss_check_range(context, c->pair_capacity, 0.0, 1e8, "pair_capacity"));
    VBSS_TRY(vbss_check_range(context, c->impact_capacity, 0.0, 1e8, "impact_capacity"));
    VBSS_TRY(vbss_check_range(context, c->exclusion, 0.0, 1e3, "exclusion"));
    return vbss_check_range(context, c->margin, 0.0, 1e3, "margin");
}

/* ---- memory: one table lists all arrays */

enum { ARRAY_COUNT = 25 };

static size_t list_arrays(collision_object *c, vbss_array arrays[ARRAY_COUNT])
{
    size_t shapes = c->config.shape_capacity, pairs = c->config.pair_capacity;
    size_t impacts = c->config.impact_capacity, separations = c->caches_separation ? pairs : 0;
    const vbss_array all[] = {
        {&c->shapes, shapes, sizeof(collision_shape *)},
        {&c->active_shapes, shapes, sizeof *c->active_shapes},
        {&c->overlapping, shapes, sizeof *c->overlapping},
        {&c->shape_bvh.boxes, shapes, sizeof *c->shape_bvh.boxes},
        {&c->shape_bvh.order, shapes, sizeof *c->shape_bvh.order},
        {&c->shape_bvh.group_boxes, vbss_collision_bvh_group_count(c->config.shape_capacity),
         sizeof *c->shape_bvh.group_boxes},
        {&c->shape_bvh.groups, vbss_collision_bvh_group_count(c->config.shape_capacity),
         sizeof *c->shape_bvh.groups},
        {&c->search.parents_a, COLLISION_SEARCH_PARENTS, sizeof *c->search.parents_a},
        {&c->search.parents_b, COLLISION_SEARCH_PARENTS, sizeof *c->search.parents_b},
        {&c->search.pairs, pairs + COLLISION_BVH_WIDTH, sizeof *c->search.pairs},
        {&c->sort_buffer, pairs, sizeof *c->sort_buffer},
        {&c->buckets, COLLISION_SORT_BUCKETS, sizeof *c->buckets},
        {&c->runs, (size_t)c->run_capacity + 1, sizeof *c->runs},
        {&c->candidates, pairs, sizeof *c->candidates},
        {&c->separations, separations, sizeof *c->separations},
        {&c->previous_candidates, separations, sizeof *c->previous_candidates},
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

const vbss_kind vbss_collision_kind = {"collision object", VBSS_CODE('C', 'O', 'L', 'L'), 1,
                                       vbss_collision_free, vbss_collision_serialise};

/* Two kinds of pairs for any two shapes, but no more runs than candidates. */
static uint32_t max_runs(const vbss_collision_config *config)
{
    uint64_t shapes = config->shape_capacity, runs = 2 * shapes * shapes;
    return runs < config->pair_capacity ? (uint32_t)runs : config->pair_capacity;
}

vbss_result vbss_collision_allocate(vbss_context *context, const vbss_collision_config *config,
                                    bool caches_separation, collision_object **collision)
{
    collision_object *c = vbss_allocate(context, 1, sizeof *c, "collision object");
    vbss_array arrays[ARRAY_COUNT];
    if (c == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    c->context = context;
    c->config = *config;
    c->ccd_options = vbss_collision_ccd_options_of(config);
    c->ccd_options.limb_count = COLLISION_LIMBS;
    c->wide = vbss_wide_is_available();
    c->thickness = config->thickness;
    c->caches_separation = caches_separation;
    c->run_capacity = max_runs(config);
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

/* ---- creation and destruction */

vbss_result vbss_collision_create(vbss_context *context, const vbss_collision_config *config,
                                  vbss_collision **collision)
{
    if (collision == NULL) {
        VBSS_TRY(vbss_context_open(context));
        return vbss_check_pointer(context, collision, "collision");
    }
    *collision = NULL;
    VBSS_TRY(vbss_context_open(context));
    VBSS_TRY(vbss_context_edit(context));
    vbss_collision_config own;
    VBSS_TRY(vbss_config_init(&vbss_collision_config_layout, &own, sizeof own));
    if (config != NULL) {
        VBSS_TRY(vbss_config_read(context, &vbss_collision_config_layout, config, &own));
    }
    VBSS_TRY(vbss_collision_check_ccd_options(context, &own));
    VBSS_TRY(check_capacities(context, &own));

    collision_object *c;
    vbss_slot *slot = NULL;
    VBSS_TRY(vbss_collision_allocate(context, &own, false, &c));
    vbss_result result = vbss_slot_create(context, &vbss_collision_kind, c, &slot);
    if (result != VBSS_OK) {
        vbss_collision_free(context, c);
        return result;
    }
    *collision = (vbss_collision *)slot;
    return VBSS_OK;
}

vbss_result vbss_collision_destroy(vbss_collision *collision)
{
    return vbss_slot_destroy(collision, &vbss_collision_kind);
}

vbss_result vbss_collision_open(const vbss_collision *handle, collision_object **collision)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_open(handle, &vbss_collision_kind, &slot));
    *collision = slot->object;
    return VBSS_OK;
}

vbss_result vbss_collision_edit(vbss_collision *handle, collision_object **collision)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_edit(handle, &vbss_collision_kind, &slot));
    *collision = slot->object;
    return VBSS_OK;
}

void vbss_collision_clear_results(collision_object *c)
{
    c->candidate_count = c->impact_count = 0;
}

vbss_result vbss_collision_get_statistics(vbss_collision *collision,
                                          vbss_collision_statistics *statistics,
                                          uint32_t struct_size)
{
    collision_object *c;
    VBSS_TRY(vbss_collision_open(collision, &c));
    const vbss_collision_statistics own = {
        .struct_size = sizeof own,
        .candidates = c->candidate_count,
        .impacts = c->impact_count,
        .queries = c->counters.queries,
        .hits = c->counters.hits,
        .undecided = c->counters.undecided,
        .exact = c->counters.exact,
        .passes = c->counters.passes,
        .sign_tests_ended = c->counters.sign_tests_ended,
        .boxes_tested = c->boxes_tested,
        .searches = c->searches,
    };
    return vbss_struct_write(c->context, &statistics_layout, &own, statistics, struct_size);
}
