/* Checks of a body that a host adds to a scene. */
#include "base/check.h"
#include "base/error.h"
#include "scene/api/place.h"

vbss_result vbss_scene_check_new_body(const scene_object *s, const scene_new_body *added,
                                      const uint32_t *number, vbss_slot **slot)
{
    VBSS_TRY(vbss_slot_check_other(s->context, added->handle, added->name));
    VBSS_TRY(vbss_slot_edit_unowned(added->handle, added->kind, slot));
    return vbss_check_pointer(s->context, number, "body");
}

vbss_result vbss_scene_check_method(const scene_object *s, vbss_method method, const char *name)
{
    return method == s->config.method ? VBSS_OK
                                      : vbss_fail(s->context, VBSS_ERROR_INCOMPATIBLE,
                                                  "the %s's method is not the scene's", name);
}

vbss_result vbss_scene_check_capsule_room(const scene_object *s, uint32_t count)
{
    return count <= s->config.capsule_capacity - s->capsule_count
               ? VBSS_OK
               : vbss_fail(s->context, VBSS_ERROR_CAPACITY, "the scene has room for %u capsules",
                           s->config.capsule_capacity);
}
