/* The functions that hosts call on a whole collision object. */
#include "base/api_call.h"
#include "base/baseline_config.h"
#include "base/baseline_statistics.h"
#include "base/check.h"
#include "base/error.h"
#include "base/snapshot.h"
#include "collision/shapes.h"

_Static_assert(sizeof(vbss_collision_statistics) == 72, "published size");

static const uint32_t statistics_sizes[] = {72, 0};
static const vbss_layout statistics_layout = {"vbss_collision_statistics", NULL, statistics_sizes};

static vbss_result check_capacities(vbss_context *context, const vbss_collision_config *c)
{
    VBSS_TRY(vbss_check_range(context, c->shape_capacity, 0.0, 65536.0, "shape_capacity"));
    VBSS_TRY(vbss_check_range(context, c->pair_capacity, 0.0, 1e8, "pair_capacity"));
    VBSS_TRY(vbss_check_range(context, c->impact_capacity, 0.0, 1e8, "impact_capacity"));
    VBSS_TRY(vbss_check_range(context, c->exclusion, 0.0, 1e3, "exclusion"));
    return vbss_check_range(context, c->margin, 0.0, 1e3, "margin");
}

vbss_result vbss_collision_create(vbss_context *context, const vbss_collision_config *config,
                                  vbss_collision **collision)
{
    VBSS_ENTER_WITH_RESULT(context, collision);
    if (collision == NULL) {
        VBSS_TRY(vbss_context_open(context));
        return vbss_check_pointer(context, collision, "collision");
    }
    VBSS_TRY(vbss_context_open(context));
    VBSS_TRY(vbss_context_edit(context));
    vbss_collision_config own;
    VBSS_TRY(vbss_config_init(&vbss_collision_config_layout, &own, sizeof own));
    if (config != NULL) {
        VBSS_TRY(vbss_config_read(context, &vbss_collision_config_layout, config, &own));
    }
    vbss_baseline_config baseline;
    VBSS_TRY(vbss_baseline_read_config(context, &own.baseline, &baseline));
    VBSS_TRY(vbss_collision_check_ccd_options(context, &own));
    VBSS_TRY(check_capacities(context, &own));

    collision_object *c;
    vbss_slot *slot = NULL;
    VBSS_TRY(vbss_collision_allocate(context, &own, own.shape_capacity, false, &c));
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
    VBSS_ENTER(collision);
    return vbss_slot_destroy(collision, &vbss_collision_kind);
}

vbss_result vbss_collision_get_statistics(vbss_collision *collision,
                                          vbss_collision_statistics *statistics,
                                          uint32_t struct_size)
{
    VBSS_ENTER(collision);
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
        .boxes_tested = c->boxes_tested,
        .searches = c->searches,
    };
    return vbss_struct_write(c->context, &statistics_layout, &own, statistics, struct_size);
}

vbss_result vbss_collision_get_baseline_statistics(vbss_collision *collision,
                                                   vbss_baseline_statistics *statistics,
                                                   uint32_t struct_size)
{
    VBSS_ENTER(collision);
    collision_object *c;
    VBSS_TRY(vbss_collision_open(collision, &c));
    const vbss_baseline_statistics own = {.sign_tests_ended = c->counters.sign_tests_ended};
    return vbss_baseline_write_statistics(
        c->context, c->config.method == VBSS_COLLISION_METHOD_VBLAST ? &own : NULL, statistics,
        struct_size);
}

vbss_result vbss_collision_save(vbss_collision *collision, uint8_t *bytes, uint64_t capacity,
                                uint64_t *written)
{
    VBSS_ENTER(collision);
    return vbss_object_save(collision, &vbss_collision_kind, bytes, capacity, written);
}

vbss_result vbss_collision_restore(vbss_collision *collision, const uint8_t *bytes, uint64_t count)
{
    VBSS_ENTER(collision);
    collision_object *c;
    VBSS_TRY(vbss_object_restore(collision, &vbss_collision_kind, bytes, count));
    VBSS_TRY(vbss_collision_open(collision, &c));
    vbss_collision_clear_results(c);
    c->generation++;
    return VBSS_OK;
}

vbss_result vbss_collision_get_hash(vbss_collision *collision, uint64_t *hash)
{
    VBSS_ENTER(collision);
    return vbss_object_hash(collision, &vbss_collision_kind, hash);
}
