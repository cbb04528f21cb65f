/* The functions that hosts call on a whole drain. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/edit_hook.h"
#include "base/error.h"
#include "base/snapshot.h"
#include "drain/drain.h"

#include <string.h>

vbss_result vbss_drain_create(vbss_context *context, const vbss_drain_config *config,
                              vbss_drain **drain)
{
    VBSS_ENTER_WITH_RESULT(context, drain);
    if (drain == NULL) {
        VBSS_TRY(vbss_context_open(context));
        return vbss_check_pointer(context, drain, "drain");
    }
    VBSS_TRY(vbss_context_open(context));
    VBSS_TRY(vbss_context_edit(context));
    vbss_drain_config own;
    vbss_baseline_config baseline;
    vbss_drain_surface surface;
    VBSS_TRY(vbss_drain_read_config(context, config, &own, &baseline, &surface));
    vbss_warn_if_unlikely(context, vbss_max_abs(own.gravity, 3), VBSS_LIKELY_GRAVITY, "gravity",
                          "m/s^2", "mm/s^2");
    drain_object *d = vbss_allocate(context, 1, sizeof *d, "drain");
    if (d == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    d->context = context;
    vbss_slot *slot = NULL;
    vbss_result result = vbss_drain_build(d, &own);
    if (result == VBSS_OK) {
        result = vbss_slot_create(context, &vbss_drain_kind, d, &slot);
    }
    if (result != VBSS_OK) {
        vbss_drain_free(context, d);
        return result;
    }
    *drain = (vbss_drain *)slot;
    return VBSS_OK;
}

vbss_result vbss_drain_destroy(vbss_drain *drain)
{
    VBSS_ENTER(drain);
    return vbss_slot_destroy(drain, &vbss_drain_kind);
}

vbss_result vbss_drain_discard(vbss_drain *drain)
{
    VBSS_ENTER(drain);
    return vbss_slot_discard(drain, &vbss_drain_kind);
}

/* Runs a step; on failure nothing changes. */
static vbss_result run_step(drain_object *d, double h)
{
    const vbss_drain_statistics before = d->statistics;
    size_t bytes = d->mesh.node_count * sizeof *d->x;
    memcpy(d->saved_x, d->x, bytes);
    memcpy(d->saved_v, d->v, bytes);
    vbss_drain_checkpoint_tangent(d);
    d->statistics.last_move = 0.0;
    vbss_result result = d->method->step_drain(d, h);
    if (result != VBSS_OK) {
        d->statistics = before;
        memcpy(d->x, d->saved_x, bytes);
        memcpy(d->v, d->saved_v, bytes);
        vbss_drain_rollback_tangent(d);
        return result;
    }
    vbss_drain_finish_step(d, h);
    return VBSS_OK;
}

vbss_result vbss_drain_step(vbss_drain *drain, double h)
{
    VBSS_ENTER(drain);
    drain_object *d;
    VBSS_TRY(vbss_drain_edit_unowned(drain, &d));
    VBSS_TRY(vbss_check_range(d->context, h, 1e-7, 0.1, "h"));
    return run_step(d, h);
}

static vbss_result check_state(const drain_object *d, const double *positions,
                               const double *velocities)
{
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        const double *x = positions != NULL ? positions + 3 * (size_t)i : &d->x[i].x;
        const double *v = velocities != NULL ? velocities + 3 * (size_t)i : &d->v[i].x;
        VBSS_TRY(vbss_check_finite(d->context, x, 3, "a position"));
        VBSS_TRY(vbss_check_finite(d->context, v, 3, "a velocity"));
        VBSS_TRY(vbss_check_range(d->context, vbss_max_abs(x, 3), 0.0, 1e3, "a position"));
        VBSS_TRY(vbss_check_range(d->context, vbss_max_abs(v, 3), 0.0, 1e5, "a velocity"));
        bool moves = vec3_distance(vec3_load(x), d->x[i]) > 0.0 || vbss_max_abs(v, 3) > 0.0;
        if (d->anchored[i] && moves) {
            return vbss_fail(d->context, VBSS_ERROR_IN_USE, "node %u is anchored", i);
        }
    }
    return VBSS_OK;
}

void vbss_drain_invalidate(drain_object *d)
{
    d->generation++;
    d->edit_generation++;
    vbss_drain_drop_tangent(d);
}

vbss_result vbss_drain_set_state(vbss_drain *drain, const double *positions,
                                 const double *velocities, uint32_t node_count)
{
    VBSS_ENTER(drain);
    drain_object *d;
    VBSS_TRY(vbss_drain_edit(drain, &d));
    double nodes = d->mesh.node_count;
    VBSS_TRY(vbss_check_range(d->context, node_count, nodes, nodes, "node_count"));
    VBSS_TRY(check_state(d, positions, velocities));
    vbss_edit input = {.kind = VBSS_EDIT_OTHER};
    VBSS_TRY(vbss_edit_begin(drain, &input));
    for (uint32_t i = 0; i < node_count; i++) {
        d->x[i] = positions != NULL ? vec3_load(positions + 3 * (size_t)i) : d->x[i];
        d->v[i] = velocities != NULL ? vec3_load(velocities + 3 * (size_t)i) : d->v[i];
    }
    vbss_drain_invalidate(d);
    return vbss_edit_end(drain, &input, VBSS_OK);
}

vbss_result vbss_drain_save(vbss_drain *drain, uint8_t *bytes, uint64_t capacity, uint64_t *written)
{
    VBSS_ENTER(drain);
    return vbss_object_save(drain, &vbss_drain_kind, bytes, capacity, written);
}

vbss_result vbss_drain_restore(vbss_drain *drain, const uint8_t *bytes, uint64_t count)
{
    VBSS_ENTER(drain);
    return vbss_object_restore(drain, &vbss_drain_kind, bytes, count);
}

vbss_result vbss_drain_get_hash(vbss_drain *drain, uint64_t *hash)
{
    VBSS_ENTER(drain);
    return vbss_object_hash(drain, &vbss_drain_kind, hash);
}
