/* Opens scene handles, and destroys scenes. */
#include "base/api_call.h"
#include "base/error.h"
#include "scene/api/api.h"
#include "scene/world/world.h"

vbss_result vbss_scene_destroy(vbss_scene *scene)
{
    VBSS_ENTER(scene);
    scene_object *s;
    if (scene == NULL) {
        return VBSS_OK;
    }
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    s->hook.data = NULL; /* the end of a scene is no edit of its bodies */
    /* Threads lose their pins, as when a thread is removed from a scene. */
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (s->bodies[i].kind == SCENE_BODY_THREAD) {
            vbss_scene_remove_pins_of(s, s->bodies[i].number);
        }
    }
    return vbss_slot_destroy(scene, &vbss_scene_kind);
}

vbss_result vbss_scene_open(const vbss_scene *handle, scene_object **scene)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_open(handle, &vbss_scene_kind, &slot));
    *scene = slot->object;
    return VBSS_OK;
}

vbss_result vbss_scene_open_mutable(vbss_scene *handle, scene_object **scene)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_edit(handle, &vbss_scene_kind, &slot));
    *scene = slot->object;
    return VBSS_OK;
}
