/* Describes the grasps of a tool to hosts. */
#include "base/api_call.h"
#include "base/error.h"
#include "scene/api/api.h"
#include "scene/tools/tools.h"
#include "scene/world/method.h"
#include "scene/world/world.h"

vbss_result vbss_scene_get_grasp(vbss_scene *scene, uint32_t tool, uint32_t index,
                                 vbss_scene_grasp *grasp, uint32_t struct_size)
{
    VBSS_ENTER(scene);
    static const uint32_t sizes[] = {sizeof(vbss_scene_grasp), 0};
    static const vbss_layout layout = {"vbss_scene_grasp", NULL, sizes};
    scene_object *s;
    VBSS_TRY(vbss_scene_open(scene, &s));
    uint32_t left = index;
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        const scene_thread_grasp *g = &s->thread_grasps[i];
        bool other = !vbss_scene_is_active_grasp(s, tool, g);
        if (other || left > 0) {
            left -= !other;
            continue;
        }
        vbss_scene_grasp own = {.struct_size = sizeof own};
        vbss_scene_describe_thread_grasp(s, g, &own);
        return vbss_struct_write(s->context, &layout, &own, grasp, struct_size);
    }
    if (left == 0 && vbss_scene_has_needle_grasp(s, tool)) {
        vbss_scene_grasp own = {.struct_size = sizeof own};
        vbss_scene_describe_needle_grasp(s, vbss_scene_body(s, tool), &own);
        return vbss_struct_write(s->context, &layout, &own, grasp, struct_size);
    }
    left -= vbss_scene_has_needle_grasp(s, tool) ? 1 : 0;
    if (left == 0 && vbss_scene_has_wall_grasp(s, tool)) {
        vbss_scene_grasp own = {.struct_size = sizeof own};
        vbss_scene_describe_wall_grasp(s, vbss_scene_body(s, tool), &own);
        return vbss_struct_write(s->context, &layout, &own, grasp, struct_size);
    }
    return vbss_fail(s->context, VBSS_ERROR_NOT_FOUND, "body %u does not hold %u places", tool,
                     index + 1);
}
