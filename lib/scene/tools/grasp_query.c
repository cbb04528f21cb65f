/* Queries about the grasps of a tool: threads, a needle, a wall. */
#include "scene/tools/tools.h"
#include "scene/world/method.h"
#include "scene/world/world.h"

scene_thread_grasp *vbss_scene_find_free_grasp(const scene_object *s)
{
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        if (s->thread_grasps[i].id == 0) {
            return &s->thread_grasps[i];
        }
    }
    return NULL;
}

bool vbss_scene_is_active_grasp(const scene_object *s, uint32_t tool, const scene_thread_grasp *g)
{
    return scene_holds_strand(g) && g->tool == tool && s->method->holds_thread(s, g);
}

uint32_t vbss_scene_count_grasps(const scene_object *s, uint32_t tool)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        count += vbss_scene_is_active_grasp(s, tool, &s->thread_grasps[i]);
    }
    return count + vbss_scene_has_needle_grasp(s, tool) + vbss_scene_has_wall_grasp(s, tool);
}

scene_rigid *vbss_scene_held_needle(const scene_object *s, const scene_needle_grasp *grasp)
{
    return &vbss_scene_body(s, grasp->needle)->rigid;
}

bool vbss_scene_has_needle_grasp(const scene_object *s, uint32_t tool)
{
    const scene_body *b = vbss_scene_body(s, tool);
    return b != NULL && b->kind == SCENE_BODY_RIGID && b->rigid.needle_grasp.needle != 0 &&
           !b->rigid.needle_grasp.is_released && s->method->holds_needle(s, b);
}

bool vbss_scene_has_wall_grasp(const scene_object *s, uint32_t tool)
{
    const scene_body *b = vbss_scene_body(s, tool);
    return b != NULL && b->kind == SCENE_BODY_RIGID && b->rigid.wall_grasp.drain != 0 &&
           !b->rigid.wall_grasp.is_released;
}
