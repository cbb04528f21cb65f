/* Public tests through an object: one query, or a batch. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "collision/shapes.h"

_Static_assert(sizeof(vbss_collision_batch) ==
                   VBSS_SIZE_WITH_POINTERS(vbss_collision_batch, 16u, 8u),
               "published size");
static const vbss_collision_batch batch_defaults = {.struct_size = sizeof(vbss_collision_batch)};
static const uint32_t batch_sizes[] = {VBSS_SIZE_WITH_POINTERS(vbss_collision_batch, 16u, 8u), 0};
static const vbss_layout batch_layout = {"vbss_collision_batch", &batch_defaults, batch_sizes};

static const double max_queries = 1e8;

vbss_result vbss_collision_batch_init(vbss_collision_batch *batch, uint32_t struct_size)
{
    return vbss_config_init(&batch_layout, batch, struct_size);
}

static vbss_result check_kind(vbss_context *context, vbss_collision_pair_kind kind)
{
    return vbss_check_range(context, kind, VBSS_COLLISION_PAIR_EDGE_EDGE,
                            VBSS_COLLISION_PAIR_POINT_TRIANGLE, "kind");
}

vbss_result vbss_collision_test(vbss_collision *collision, vbss_collision_pair_kind kind,
                                const double start[12], const double end[12],
                                vbss_collision_impact *impact, uint32_t struct_size)
{
    VBSS_ENTER(collision);
    collision_object *c;
    VBSS_TRY(vbss_collision_edit(collision, &c));
    VBSS_TRY(check_kind(c->context, kind));
    VBSS_TRY(vbss_collision_check_coordinates(c->context, start, 12, "start"));
    VBSS_TRY(vbss_collision_check_coordinates(c->context, end, 12, "end"));
    VBSS_TRY(vbss_check_pointer(c->context, impact, "impact"));
    collision_ccd_query query = {.kind = kind, .thickness = c->thickness};
    vbss_collision_set_vertices(&query, start, end);
    collision_ccd_result result;
    collision_counters counters = c->counters;
    vbss_collision_run_ccd(&c->ccd_options, &query, &result, &counters);
    VBSS_TRY(vbss_collision_write_impact(c->context, &query, &result, impact, struct_size));
    c->counters = counters;
    return VBSS_OK;
}

static vbss_result check_batch(vbss_context *context, const vbss_collision_batch *b)
{
    VBSS_TRY(check_kind(context, b->kind));
    VBSS_TRY(vbss_check_range(context, b->count, 0.0, max_queries, "count"));
    VBSS_TRY(vbss_check_range(context, b->stride, b->count, UINT32_MAX, "stride"));
    if (b->count == 0) {
        return VBSS_OK;
    }
    VBSS_TRY(vbss_check_pointer(context, b->hit, "hit"));
    VBSS_TRY(vbss_check_pointer(context, b->start, "start"));
    VBSS_TRY(vbss_check_pointer(context, b->end, "end"));
    for (size_t row = 0; row < 12; row++) {
        size_t at = row * b->stride;
        VBSS_TRY(vbss_collision_check_coordinates(context, b->start + at, b->count, "start"));
        VBSS_TRY(vbss_collision_check_coordinates(context, b->end + at, b->count, "end"));
    }
    for (uint32_t i = 0; b->thickness != NULL && i < b->count; i++) {
        VBSS_TRY(vbss_collision_check_thickness(context, b->thickness[i]));
    }
    return VBSS_OK;
}

vbss_result vbss_collision_test_batch(vbss_collision *collision, const vbss_collision_batch *batch)
{
    VBSS_ENTER(collision);
    collision_object *c;
    VBSS_TRY(vbss_collision_edit(collision, &c));
    vbss_collision_batch own;
    VBSS_TRY(vbss_config_read(c->context, &batch_layout, batch, &own));
    VBSS_TRY(check_batch(c->context, &own));
    collision_ccd_batch ccd_batch = {
        .kind = own.kind,
        .count = own.count,
        .stride = own.stride,
        .start = own.start,
        .end = own.end,
        .thickness = own.thickness,
        .same_thickness = c->thickness,
        .hit = own.hit,
        .decision = own.decision,
        .time = own.time,
        .normal = own.normal,
        .weights = own.weights,
    };
    vbss_collision_run_ccd_batch(&c->ccd_options, c->wide, &ccd_batch, &c->counters);
    return VBSS_OK;
}
