/* Public functions of visuals: creation, sources, views and statistics. */
#include "base/api_call.h"
#include "base/config.h"
#include "base/memory.h"
#include "base/simd_dispatch.h"
#include "visual/visual.h"

#include "base/check.h"
#include "base/error.h"
#include "base/stream.h"

_Static_assert(sizeof(visual_vertex) == 48, "floats side by side");
_Static_assert(sizeof(visual_decal) == 24, "floats side by side");
_Static_assert(sizeof(visual_part) == 32, "numbers side by side");
_Static_assert(sizeof(vbss_visual_statistics) == 32, "published size");

static const uint32_t statistics_sizes[] = {32, 0};
static const vbss_layout statistics_layout = {"vbss_visual_statistics", NULL, statistics_sizes};

/* ---- creation and destruction */

enum { ARRAYS_PER_FRAME = 7, ARRAY_COUNT = 2 * ARRAYS_PER_FRAME + 3 };

static uint32_t list_arrays(visual_object *v, vbss_array arrays[ARRAY_COUNT])
{
    const vbss_visual_config *c = &v->config;
    uint32_t n = 0;
    for (int i = 0; i < 2; i++) {
        visual_frame *f = &v->frames[i];
        arrays[n++] = (vbss_array){&f->vertices, c->vertex_capacity, sizeof *f->vertices};
        arrays[n++] = (vbss_array){&f->triangles, c->triangle_capacity, sizeof *f->triangles};
        arrays[n++] = (vbss_array){&f->parts, c->part_capacity, sizeof *f->parts};
        arrays[n++] = (vbss_array){&f->decals, c->spot_capacity, sizeof *f->decals};
        arrays[n++] = (vbss_array){&f->tube_starts, c->part_capacity, sizeof *f->tube_starts};
        arrays[n++] = (vbss_array){&f->walls, c->part_capacity, sizeof *f->walls};
        arrays[n++] = (vbss_array){&f->lofts, (size_t)VISUAL_LOFTS_PER_PART * c->part_capacity,
                                   sizeof *f->lofts};
    }
    arrays[n++] = (vbss_array){&v->sources, c->source_capacity, sizeof *v->sources};
    arrays[n++] = (vbss_array){&v->node_vectors, c->node_capacity, sizeof *v->node_vectors};
    arrays[n++] =
        (vbss_array){&v->elimination_ratios, c->node_capacity, sizeof *v->elimination_ratios};
    return n;
}

static void free_visual(vbss_context *context, void *object)
{
    visual_object *v = object;
    vbss_array arrays[ARRAY_COUNT];
    vbss_release_arrays(context, arrays, list_arrays(v, arrays));
    vbss_release(context, v, 1, sizeof *v);
}

/* Frames are not part of the state, so there is nothing to save. */
static void visit_nothing(vbss_stream *stream, void *object)
{
    (void)stream;
    (void)object;
}

const vbss_kind vbss_visual_kind_of_slot = {
    "visual", VBSS_CODE('V', 'I', 'S', 'U'), 1, free_visual, visit_nothing, NULL};

static vbss_result allocate_visual(vbss_context *context, const vbss_visual_config *config,
                                   visual_object **visual)
{
    vbss_array arrays[ARRAY_COUNT];
    visual_object *v = vbss_allocate(context, 1, sizeof *v, "visual");
    if (v == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    v->context = context;
    v->config = *config;
    v->origin = vec3_load(config->origin);
    v->wide = vbss_wide_is_available();
    vbss_result result = vbss_allocate_arrays(context, arrays, list_arrays(v, arrays), "visual");
    if (result != VBSS_OK) {
        free_visual(context, v);
        return result;
    }
    *visual = v;
    return VBSS_OK;
}

vbss_result vbss_visual_create(vbss_context *context, const vbss_visual_config *config,
                               vbss_visual **visual)
{
    VBSS_ENTER_WITH_RESULT(context, visual);
    if (visual == NULL) {
        VBSS_TRY(vbss_context_open(context));
        return vbss_check_pointer(context, visual, "visual");
    }
    VBSS_TRY(vbss_context_open(context));
    VBSS_TRY(vbss_context_edit(context));
    vbss_visual_config own;
    visual_object *v;
    vbss_slot *slot;
    VBSS_TRY(vbss_visual_read_config(context, config, &own));
    VBSS_TRY(allocate_visual(context, &own, &v));
    vbss_result result = vbss_slot_create(context, &vbss_visual_kind_of_slot, v, &slot);
    if (result != VBSS_OK) {
        free_visual(context, v);
        return result;
    }
    *visual = (vbss_visual *)slot;
    return VBSS_OK;
}

vbss_result vbss_visual_destroy(vbss_visual *visual)
{
    VBSS_ENTER(visual);
    return vbss_slot_destroy(visual, &vbss_visual_kind_of_slot);
}

/* ---- sources */

static vbss_result store_source(visual_object *v, const visual_source *source, uint32_t *number)
{
    for (uint32_t i = 0; i < v->config.source_capacity; i++) {
        if (v->sources[i].number == 0) {
            v->sources[i] = *source;
            v->sources[i].number = ++v->last_source;
            if (number != NULL) {
                *number = v->last_source;
            }
            return VBSS_OK;
        }
    }
    return vbss_fail(v->context, VBSS_ERROR_CAPACITY, "the visual has room for %u sources",
                     v->config.source_capacity);
}

static vbss_result add_source(vbss_visual *visual, void *handle, scene_handle_type type,
                              uint32_t *number)
{
    vbss_slot *slot, *shown;
    VBSS_TRY(vbss_slot_edit(visual, &vbss_visual_kind_of_slot, &slot));
    visual_object *v = slot->object;
    VBSS_TRY(vbss_slot_check_other(v->context, handle, "source"));
    VBSS_TRY(vbss_scene_inspect_handle(type, handle, &shown));
    return store_source(v, &(visual_source){.type = type, .handle = handle}, number);
}

vbss_result vbss_visual_add_replica(vbss_visual *visual, vbss_replica *replica, uint32_t *source)
{
    VBSS_ENTER(visual);
    vbss_slot *slot, *shown;
    VBSS_TRY(vbss_slot_edit(visual, &vbss_visual_kind_of_slot, &slot));
    visual_object *v = slot->object;
    if (vbss_slot_open_shared(replica, &vbss_replica_kind_of_slot, &shown) != VBSS_OK) {
        return vbss_fail(v->context, VBSS_ERROR_INVALID_HANDLE, "replica is no valid replica");
    }
    return store_source(v, &(visual_source){.is_replica = true, .handle = replica}, source);
}

vbss_result vbss_visual_add_scene(vbss_visual *visual, vbss_scene *scene, uint32_t *source)
{
    VBSS_ENTER(visual);
    return add_source(visual, scene, SCENE_HANDLE_SCENE, source);
}

vbss_result vbss_visual_add_thread(vbss_visual *visual, vbss_thread *thread, uint32_t *source)
{
    VBSS_ENTER(visual);
    return add_source(visual, thread, SCENE_HANDLE_THREAD, source);
}

vbss_result vbss_visual_add_drain(vbss_visual *visual, vbss_drain *drain, uint32_t *source)
{
    VBSS_ENTER(visual);
    return add_source(visual, drain, SCENE_HANDLE_DRAIN, source);
}

vbss_result vbss_visual_add_needle(vbss_visual *visual, vbss_needle *needle, uint32_t *source)
{
    VBSS_ENTER(visual);
    return add_source(visual, needle, SCENE_HANDLE_NEEDLE, source);
}

vbss_result vbss_visual_add_grasper(vbss_visual *visual, vbss_grasper *grasper, uint32_t *source)
{
    VBSS_ENTER(visual);
    return add_source(visual, grasper, SCENE_HANDLE_GRASPER, source);
}

vbss_result vbss_visual_remove(vbss_visual *visual, uint32_t source)
{
    VBSS_ENTER(visual);
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_edit(visual, &vbss_visual_kind_of_slot, &slot));
    visual_object *v = slot->object;
    for (uint32_t i = 0; i < v->config.source_capacity; i++) {
        if (source != 0 && v->sources[i].number == source) {
            v->sources[i] = (visual_source){.number = 0};
            return VBSS_OK;
        }
    }
    return vbss_fail(v->context, VBSS_ERROR_NOT_FOUND, "the visual has no source %u", source);
}

/* ---- views and statistics */

vbss_result vbss_visual_get_view(vbss_visual *visual, vbss_visual_field field, vbss_view *view,
                                 uint32_t struct_size)
{
    VBSS_ENTER(visual);
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_open(visual, &vbss_visual_kind_of_slot, &slot));
    const visual_object *v = slot->object;
    const visual_frame *f = &v->frames[v->front];
    vbss_view own = {.type = VBSS_VIEW_TYPE_F32, .generation = v->generation};
    switch (field) {
    case VBSS_VISUAL_VIEW_VERTICES:
        own.components = 12;
        own.stride_bytes = sizeof *f->vertices;
        own.count = f->vertex_count;
        own.data = f->vertices;
        break;
    case VBSS_VISUAL_VIEW_TRIANGLES:
        own.type = VBSS_VIEW_TYPE_U32;
        own.components = 3;
        own.stride_bytes = sizeof *f->triangles;
        own.count = f->triangle_count;
        own.data = f->triangles;
        break;
    case VBSS_VISUAL_VIEW_PARTS:
        own.type = VBSS_VIEW_TYPE_U32;
        own.components = 8;
        own.stride_bytes = sizeof *f->parts;
        own.count = f->part_count;
        own.data = f->parts;
        break;
    case VBSS_VISUAL_VIEW_SPOTS:
        own.components = 6;
        own.stride_bytes = sizeof *f->decals;
        own.count = f->decal_count;
        own.data = f->decals;
        break;
    default:
        return vbss_fail(v->context, VBSS_ERROR_OUT_OF_RANGE, "a visual has no field %d", field);
    }
    return vbss_struct_write(v->context, &vbss_view_layout, &own, view, struct_size);
}

vbss_result vbss_visual_get_statistics(vbss_visual *visual, vbss_visual_statistics *statistics,
                                       uint32_t struct_size)
{
    VBSS_ENTER(visual);
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_open(visual, &vbss_visual_kind_of_slot, &slot));
    const visual_object *v = slot->object;
    const visual_frame *f = &v->frames[v->front];
    vbss_visual_statistics own = {.struct_size = sizeof own,
                                  .parts = f->part_count,
                                  .vertices = f->vertex_count,
                                  .triangles = f->triangle_count,
                                  .spots = f->decal_count,
                                  .updates = v->updates};
    for (uint32_t i = 0; i < v->config.source_capacity; i++) {
        own.sources += v->sources[i].number != 0;
    }
    return vbss_struct_write(v->context, &statistics_layout, &own, statistics, struct_size);
}
