/* Events of grasps: of threads, needles and walls. */
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

static vbss_scene_event event_of(vbss_scene_event_kind kind, const vbss_scene_grasp *grasp,
                                 uint32_t tool)
{
    return (vbss_scene_event){.kind = kind,
                              .body_a = grasp->body,
                              .body_b = tool,
                              .value = value_of(kind, grasp),
                              .arc_length = grasp->arc_length};
}

void vbss_scene_emit_thread_grasp_event(scene_object *s, vbss_scene_event_kind kind,
                                        const scene_thread_grasp *g)
{
    vbss_scene_grasp grasp = {.struct_size = sizeof grasp};
    vbss_scene_describe_thread_grasp(s, g, &grasp);
    vbss_scene_event event = event_of(kind, &grasp, g->tool);
    vbss_scene_add_event_at(s, &event, vec3_load(grasp.position),
                            (uint32_t)vbss_max(1e6 * grasp.arc_length, 0.0));
}

void vbss_scene_emit_needle_grasp_event(scene_object *s, vbss_scene_event_kind kind,
                                        const scene_body *tool)
{
    vbss_scene_grasp grasp = {.struct_size = sizeof grasp};
    vbss_scene_describe_needle_grasp(s, tool, &grasp);
    vbss_scene_event event = event_of(kind, &grasp, tool->number);
    vbss_scene_add_event_at(s, &event, vec3_load(grasp.position),
                            (uint32_t)(1e6 * grasp.arc_length));
}

void vbss_scene_emit_wall_grasp_event(scene_object *s, vbss_scene_event_kind kind,
                                      const scene_body *tool)
{
    const scene_wall_grasp *p = &tool->rigid.wall_grasp;
    vbss_scene_grasp grasp = {.struct_size = sizeof grasp};
    vbss_scene_describe_wall_grasp(s, tool, &grasp);
    vbss_scene_event event = event_of(kind, &grasp, tool->number);
    event.id = p->triangle[p->point_count / 2];
    vbss_scene_add_event_at(s, &event, vec3_load(grasp.position), event.id);
}
