/* Events of grasps, of threads, needles and walls alike. */
#include "scene/tools/tools.h"
#include "scene/world/world.h"

/* A slip and a tear have the force on the body, a release has the distance slid. */
static double value_of(vbss_scene_event_kind kind, const vbss_scene_grasp *grasp)
{
    switch (kind) {
    case VBSS_SCENE_EVENT_SLIP:
    case VBSS_SCENE_EVENT_TORN:
        return vec3_norm(vec3_load(grasp->force));
    case VBSS_SCENE_EVENT_RELEASE:
        return grasp->slid;
    default:
        return 0.0;
    }
}

void vbss_scene_emit_grasp_event(scene_object *s, vbss_scene_event_kind kind,
                                 const scene_grasp_event *of)
{
    vbss_scene_event event = {.kind = kind,
                              .body_a = of->grasp.body,
                              .body_b = of->tool,
                              .id = of->triangle,
                              .value = value_of(kind, &of->grasp),
                              .arc_length = of->grasp.arc_length};
    vbss_scene_add_event_at(s, &event, vec3_load(of->grasp.position), of->logged_number);
}
