/* Adds a thread to a scene, with room for all pieces that may be cut from it. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "scene/api/api.h"
#include "scene/api/overlap.h"
#include "scene/api/place.h"
#include "scene/solve/solve.h"
#include "scene/topology/topology.h"
#include "scene/world/world.h"

/* Returns the slot of the thread. There is a free entry for it. */
static vbss_result check_thread(scene_object *s, vbss_thread *thread, const uint32_t *number,
                                vbss_slot **found)
{
    const scene_new_body added = {thread, &vbss_thread_kind, "thread"};
    VBSS_TRY(vbss_scene_check_new_body(s, &added, number, found));
    const vbss_slot *slot = *found;
    const thread_object *t = slot->object;
    VBSS_TRY(vbss_scene_check_method(s, t->config.method, "thread"));
    VBSS_TRY(vbss_scene_check_thread_capacity(s, t));
    scene_body *entry;
    return vbss_scene_find_free_body(s, SCENE_BODY_THREAD, &entry);
}

vbss_result vbss_scene_create_thread_shape(scene_object *s, const thread_object *t, uint32_t *shape)
{
    if (t->config.mesh == VBSS_THREAD_MESH_FIXED) {
        return vbss_collision_add_chain(scene_collision(s), t->node_count, t->rest,
                                        t->config.radius, shape);
    }
    VBSS_TRY(
        vbss_collision_add_disabled_chain(s->collision, t->node_capacity, t->config.radius, shape));
    vbss_collision_resize_chain(s->collision, *shape, t->node_count, t->rest);
    return VBSS_OK;
}

void vbss_scene_place_thread(scene_object *s, vbss_slot *slot, scene_body *b, uint32_t shape,
                             uint32_t *body)
{
    *b = (scene_body){0};
    b->thread.slot = slot;
    b->thread.thread = slot->object;
    vbss_slot_set_owner(slot, s, &s->hook);
    vbss_scene_register_body(s, b, SCENE_BODY_THREAD, shape, body);
}

static vbss_result add_thread(scene_object *s, vbss_thread *thread, uint32_t *body)
{
    vbss_slot *slot;
    uint32_t shape = 0;
    VBSS_TRY(check_thread(s, thread, body, &slot));
    VBSS_TRY(vbss_scene_check_overlap(s, &(scene_outline){.thread = slot->object}, "thread"));
    scene_body *b;
    VBSS_TRY(vbss_scene_find_free_body(s, SCENE_BODY_THREAD, &b));
    thread_object *t = slot->object;
    VBSS_TRY(vbss_scene_reserve_rolls(s, t));
    VBSS_TRY(vbss_scene_create_thread_shape(s, t, &shape));
    VBSS_TRY(vbss_scene_create_piece_shapes(s, t, shape));
    vbss_scene_place_thread(s, slot, b, shape, body);
    vbss_scene_add_spares(s, t, shape + 1);
    vbss_scene_number_nodes(s);
    return VBSS_OK;
}

vbss_result vbss_scene_add_thread(vbss_scene *scene, vbss_thread *thread, uint32_t *body)
{
    VBSS_ENTER(scene);
    scene_object *s;
    vbss_slot *slot;
    scene_edit edit;
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    VBSS_TRY(check_thread(s, thread, body, &slot));
    vbss_edit input = {.kind = VBSS_EDIT_OTHER};
    VBSS_TRY(vbss_scene_begin_edit(scene, &input, &edit));
    return vbss_scene_end_edit(&edit, add_thread(s, thread, body));
}
