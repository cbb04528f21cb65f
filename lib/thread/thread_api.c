/* The functions that hosts call on a whole thread. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/edit_hook.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/number_text.h"
#include "base/snapshot.h"
#include "thread/remesh.h"

/* Allocates threads and handles for the pieces of later cuts. */
static vbss_result create_piece_pool(thread_object *t)
{
    vbss_context *context = t->context;
    thread_piece_pool *pool = vbss_allocate(context, 1, sizeof *pool, "pieces of a thread");
    if (pool == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    t->piece_pool = pool;
    pool->reference_count = 1;
    pool->available = pool->capacity = t->config.cut_capacity;
    pool->pieces =
        vbss_allocate(context, pool->capacity, sizeof *pool->pieces, "pieces of a thread");
    pool->slots = vbss_allocate(context, pool->capacity, sizeof(vbss_slot *), "pieces of a thread");
    if (pool->pieces == NULL || pool->slots == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    for (uint32_t i = 0; i < pool->capacity; i++) {
        VBSS_TRY(vbss_thread_allocate(context, &t->config, t->node_capacity, &pool->pieces[i]));
        VBSS_TRY(vbss_slot_reserve(context, &vbss_thread_kind, &pool->slots[i]));
    }
    return VBSS_OK;
}

static void init_nodes(thread_object *t, const vbss_thread_config *c)
{
    vec3 direction = vec3_unit_or(vec3_load(c->direction), vec3_make(1.0, 0.0, 0.0));
    double arc_length = 0.0;
    t->node_count = c->segment_count + 1;
    for (uint32_t i = 0; i < t->node_count; i++) {
        if (i + 1 < t->node_count) {
            t->rest[i] =
                c->rest_lengths != NULL ? c->rest_lengths[i] : c->length / c->segment_count;
        }
        t->now.x[i] = c->positions != NULL
                          ? vec3_load(c->positions + 3 * (size_t)i)
                          : vec3_add_scaled(vec3_load(c->start), arc_length, direction);
        arc_length += i + 1 < t->node_count ? t->rest[i] : 0.0;
    }
    t->is_acceleration_unknown = t->is_in_setup = true;
}

static void warn_of_units(vbss_context *context, const vbss_thread_config *c)
{
    vbss_warn_if_unlikely(context, c->length, VBSS_LIKELY_LENGTH, "length", "m", "mm");
    vbss_warn_if_unlikely(context, c->radius, VBSS_LIKELY_THREAD_RADIUS, "radius", "m", "mm");
    vbss_warn_if_unlikely(context, c->linear_density, VBSS_LIKELY_LINEAR_DENSITY, "linear_density",
                          "kg/m", "g/m");
    vbss_warn_if_unlikely(context, vbss_max_abs(c->gravity, 3), VBSS_LIKELY_GRAVITY, "gravity",
                          "m/s^2", "mm/s^2");
}

static uint32_t node_capacity_of(const vbss_thread_config *c)
{
    uint32_t segments = c->segment_count;
    if (c->mesh == VBSS_THREAD_MESH_FIXED) {
        return segments + 1;
    }
    return c->node_capacity > 0 ? c->node_capacity : (segments < 16384 ? 4 * segments : 65536) + 1;
}

vbss_result vbss_thread_create(vbss_context *context, const vbss_thread_config *config,
                               vbss_thread **thread)
{
    VBSS_ENTER_WITH_RESULT(context, thread);
    if (thread == NULL) {
        VBSS_TRY(vbss_context_open(context));
        return vbss_check_pointer(context, thread, "thread");
    }
    VBSS_TRY(vbss_context_open(context));
    VBSS_TRY(vbss_context_edit(context));
    vbss_thread_config own;
    vbss_baseline_config baseline;
    VBSS_TRY(vbss_thread_read_config(context, config, &own, &baseline));
    warn_of_units(context, &own);

    thread_object *t;
    vbss_slot *slot = NULL;
    VBSS_TRY(vbss_thread_allocate(context, &own, node_capacity_of(&own), &t));
    vbss_result result = create_piece_pool(t);
    if (result == VBSS_OK) {
        result = vbss_slot_create(context, &vbss_thread_kind, t, &slot);
    }
    if (result != VBSS_OK) {
        vbss_thread_free(context, t);
        return result;
    }
    init_nodes(t, &own);
    *thread = (vbss_thread *)slot;
    return VBSS_OK;
}

vbss_result vbss_thread_destroy(vbss_thread *thread)
{
    VBSS_ENTER(thread);
    return vbss_slot_destroy(thread, &vbss_thread_kind);
}

vbss_result vbss_thread_discard(vbss_thread *thread)
{
    VBSS_ENTER(thread);
    return vbss_slot_discard(thread, &vbss_thread_kind);
}

vbss_result vbss_thread_set_state(vbss_thread *thread, const double *positions,
                                  const double *velocities, uint32_t node_count)
{
    VBSS_ENTER(thread);
    thread_object *t;
    VBSS_TRY(vbss_thread_edit(thread, &t));
    VBSS_TRY(vbss_check_range(t->context, node_count, t->node_count, t->node_count, "node_count"));
    size_t numbers = 3u * (size_t)node_count;
    for (size_t i = 0; i < numbers; i++) {
        if (positions != NULL) {
            VBSS_TRY(vbss_check_range(t->context, positions[i], -1e3, 1e3, "a position"));
        }
        if (velocities != NULL) {
            VBSS_TRY(vbss_check_range(t->context, velocities[i], -1e5, 1e5, "a velocity"));
        }
    }
    vbss_edit input = {.kind = VBSS_EDIT_OTHER};
    VBSS_TRY(vbss_edit_begin(thread, &input));
    for (uint32_t i = 0; i < node_count; i++) {
        if (positions != NULL) {
            t->now.x[i] = vec3_load(positions + 3 * (size_t)i);
        }
        if (velocities != NULL) {
            t->now.v[i] = vec3_load(velocities + 3 * (size_t)i);
        }
        t->now.a[i] = t->now.q[i] = vec3_zero();
        t->now.tension[i] = 0.0;
    }
    vbss_thread_invalidate(t);
    t->is_in_setup = t->is_in_setup || positions != NULL;
    return vbss_edit_end(thread, &input, VBSS_OK);
}

vbss_result vbss_thread_step(vbss_thread *thread, double h)
{
    VBSS_ENTER(thread);
    thread_object *t;
    VBSS_TRY(vbss_thread_edit_unowned(thread, &t));
    VBSS_TRY(vbss_check_range(t->context, h, 1e-7, 0.1, "h"));
    VBSS_TRY(vbss_thread_update_sparsity(t));
    const vbss_result result = t->method->step_thread(t, h);
    VBSS_TRY(result);
    vbss_thread_finish_step(t, h);
    vbss_thread_adapt_mesh(t);
    return VBSS_OK;
}

vbss_result vbss_thread_cut(vbss_thread *thread, double arc_length, vbss_thread **piece)
{
    VBSS_ENTER_WITH_RESULT(thread, piece);
    thread_object *t;
    if (piece == NULL) {
        VBSS_TRY(vbss_thread_edit_unowned(thread, &t));
        return vbss_check_pointer(t->context, piece, "piece");
    }
    VBSS_TRY(vbss_thread_edit_unowned(thread, &t));
    double length = vbss_thread_arc_length(t, t->node_count - 1);
    VBSS_TRY(vbss_check_range(t->context, arc_length, 0.0, length, "arc_length"));
    thread_cut cut;
    if (!vbss_thread_locate_cut(t, arc_length, &cut)) {
        return vbss_fail(t->context, VBSS_ERROR_OUT_OF_RANGE, "a cut at %s m is at an end",
                         VBSS_NUMBER(arc_length));
    }
    vbss_slot *slot;
    thread_object *new_piece = vbss_thread_acquire_piece(t, &slot);
    if (new_piece == NULL) {
        return vbss_fail(t->context, VBSS_ERROR_CAPACITY, "all %u cuts are made",
                         t->piece_pool->capacity);
    }
    vbss_thread_apply_cut(t, new_piece, &cut);
    vbss_slot_fill(slot, new_piece);
    *piece = (vbss_thread *)slot;
    return VBSS_OK;
}

vbss_result vbss_thread_save(vbss_thread *thread, uint8_t *bytes, uint64_t capacity,
                             uint64_t *written)
{
    VBSS_ENTER(thread);
    return vbss_object_save(thread, &vbss_thread_kind, bytes, capacity, written);
}

vbss_result vbss_thread_restore(vbss_thread *thread, const uint8_t *bytes, uint64_t count)
{
    VBSS_ENTER(thread);
    return vbss_object_restore(thread, &vbss_thread_kind, bytes, count);
}

vbss_result vbss_thread_get_hash(vbss_thread *thread, uint64_t *hash)
{
    VBSS_ENTER(thread);
    return vbss_object_hash(thread, &vbss_thread_kind, hash);
}
