/* Bodies of a scene by number: properties, handles, and data of the host. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "scene/api/api.h"
#include "scene/world/world.h"

#include <vblast_ss/scene_query.h>

_Static_assert(sizeof(vbss_scene_body_info) == 56, "published size");

static const uint32_t info_sizes[] = {56, 0};
static const vbss_layout info_layout = {"vbss_scene_body_info", NULL, info_sizes};

/* ---- enumeration and properties */

vbss_result vbss_scene_get_bodies(vbss_scene *scene, uint32_t *numbers, uint32_t capacity,
                                  uint32_t *count)
{
    VBSS_ENTER(scene);
    scene_object *s;
    uint32_t found = 0;
    VBSS_TRY(vbss_scene_open(scene, &s));
    VBSS_TRY(vbss_check_pointer(s->context, count, "count"));
    if (capacity > 0) {
        VBSS_TRY(vbss_check_pointer(s->context, numbers, "numbers"));
    }
    for (uint32_t number = 1; number <= s->last_body_number; number++) {
        if (vbss_scene_body(s, number) != NULL) {
            if (found < capacity) {
                numbers[found] = number;
            }
            found++;
        }
    }
    *count = found;
    if (found <= capacity || numbers == NULL) { /* without a buffer the host asks for the count */
        return VBSS_OK;
    }
    return vbss_fail(s->context, VBSS_ERROR_CAPACITY, "the scene has %u bodies", found);
}

static void describe_floor(const scene_object *s, vbss_scene_body_info *info)
{
    info->kind = VBSS_SCENE_BODY_FLOOR;
    info->friction = s->settings.floor_friction;
}

static void describe_rigid(const scene_rigid *r, vbss_scene_body_info *info)
{
    info->kind = r->needle != NULL    ? VBSS_SCENE_BODY_NEEDLE
                 : r->grasper != NULL ? VBSS_SCENE_BODY_GRASPER
                 : r->is_static_mesh  ? VBSS_SCENE_BODY_STATIC_MESH
                 : r->is_plane        ? VBSS_SCENE_BODY_PLANE
                 : r->surface != NULL ? VBSS_SCENE_BODY_SURFACE
                                      : VBSS_SCENE_BODY_RIGID;
    info->motion = r->kind;
    info->friction = r->friction;
    vec3_store(info->gravity, r->body.gravity);
}

static void describe(const scene_object *s, const scene_body *b, vbss_scene_body_info *info)
{
    if (b == NULL) {
        describe_floor(s, info);
    } else if (b->kind == SCENE_BODY_THREAD) {
        info->kind = VBSS_SCENE_BODY_THREAD;
        info->friction = s->settings.thread_friction;
        vec3_store(info->gravity, b->thread.thread->gravity);
    } else if (b->kind == SCENE_BODY_DRAIN) {
        info->kind = VBSS_SCENE_BODY_DRAIN;
        info->friction = b->drain.friction;
        vec3_store(info->gravity, b->drain.drain->gravity);
    } else {
        describe_rigid(&b->rigid, info);
    }
}

vbss_result vbss_scene_get_body(vbss_scene *scene, uint32_t body, vbss_scene_body_info *info,
                                uint32_t struct_size)
{
    VBSS_ENTER(scene);
    scene_object *s;
    VBSS_TRY(vbss_scene_open(scene, &s));
    scene_body *b = NULL;
    if (body != 0) {
        VBSS_TRY(vbss_scene_require_any_body(s, body, &b));
    }
    const scene_filter *filter = vbss_scene_filter_of(s, b);
    vbss_scene_body_info own = {.struct_size = sizeof own,
                                .body = body,
                                .category = filter->category,
                                .mask = filter->mask};
    describe(s, b, &own);
    return vbss_struct_write(s->context, &info_layout, &own, info, struct_size);
}

/* ---- handles */

vbss_result vbss_scene_get_drain(vbss_scene *scene, uint32_t body, vbss_drain **drain)
{
    VBSS_ENTER_WITH_RESULT(scene, drain);
    scene_object *s;
    VBSS_TRY(vbss_scene_open(scene, &s));
    VBSS_TRY(vbss_check_pointer(s->context, drain, "drain"));
    scene_body *b;
    VBSS_TRY(vbss_scene_require_body(s, body, SCENE_BODY_DRAIN, &b));
    *drain = (vbss_drain *)b->drain.slot;
    return VBSS_OK;
}

vbss_result vbss_scene_get_needle(vbss_scene *scene, uint32_t body, vbss_needle **needle)
{
    VBSS_ENTER_WITH_RESULT(scene, needle);
    scene_object *s;
    VBSS_TRY(vbss_scene_open(scene, &s));
    VBSS_TRY(vbss_check_pointer(s->context, needle, "needle"));
    scene_body *b;
    VBSS_TRY(vbss_scene_require_any_body(s, body, &b));
    if (b->kind != SCENE_BODY_RIGID || b->rigid.needle == NULL) {
        return vbss_fail(s->context, VBSS_ERROR_INCOMPATIBLE, "body %u is no needle", body);
    }
    *needle = (vbss_needle *)b->rigid.slot;
    return VBSS_OK;
}

vbss_result vbss_scene_get_grasper(vbss_scene *scene, uint32_t body, vbss_grasper **grasper)
{
    VBSS_ENTER_WITH_RESULT(scene, grasper);
    scene_object *s;
    VBSS_TRY(vbss_scene_open(scene, &s));
    VBSS_TRY(vbss_check_pointer(s->context, grasper, "grasper"));
    scene_body *b;
    VBSS_TRY(vbss_scene_require_any_body(s, body, &b));
    if (b->kind != SCENE_BODY_RIGID || b->rigid.grasper == NULL) {
        return vbss_fail(s->context, VBSS_ERROR_INCOMPATIBLE, "body %u is no grasper", body);
    }
    *grasper = (vbss_grasper *)b->rigid.slot;
    return VBSS_OK;
}

/* ---- data of the host */

vbss_result vbss_scene_set_user_data(vbss_scene *scene, uint32_t body, void *data)
{
    VBSS_ENTER(scene);
    scene_object *s;
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    scene_body *b;
    VBSS_TRY(vbss_scene_require_any_body(s, body, &b));
    b->user_data = data;
    return VBSS_OK;
}

vbss_result vbss_scene_get_user_data(vbss_scene *scene, uint32_t body, void **data)
{
    VBSS_ENTER_WITH_RESULT(scene, data);
    scene_object *s;
    VBSS_TRY(vbss_scene_open(scene, &s));
    VBSS_TRY(vbss_check_pointer(s->context, data, "data"));
    scene_body *b;
    VBSS_TRY(vbss_scene_require_any_body(s, body, &b));
    *data = b->user_data;
    return VBSS_OK;
}
