/* Gives the handle of a body back to the host when the body leaves the scene. */
#include "scene/world/world.h"
#include "thread/twist.h"

#include <string.h>

void vbss_scene_disown_thread(scene_body *b)
{
    thread_object *t = b->thread.thread;
    vbss_slot_set_owner(b->thread.slot, NULL, NULL);
    if (b->thread.slot->object == t) { /* the context may have destroyed it */
        t->is_sparsity_valid = false;
        t->gravity = vec3_load(t->config.gravity);
        memset(t->welded, 0, t->node_count * sizeof *t->welded);
        if (thread_has_twist(t)) {
            vbss_thread_release_owned_sections(t);
        }
    }
}

void vbss_scene_disown_grasper(scene_body *b)
{
    grasper_object *g = b->rigid.slot->object;
    vbss_slot_set_owner(b->rigid.slot, NULL, NULL);
    if (g != NULL) { /* the context may have destroyed it */
        vbss_grasper_detach(g);
    }
}

void vbss_scene_disown_needle(scene_body *b)
{
    needle_object *n = b->rigid.slot->object;
    vbss_slot_set_owner(b->rigid.slot, NULL, NULL);
    if (n != NULL) { /* the context may have destroyed it */
        vbss_needle_set_motion(n, &b->rigid.body.now, 0);
    }
}

/* Largest number of sides of triangles per node of a surface. Derived from Euler's formula. */
#define EDGES_PER_NODE 3u

void vbss_scene_list_drain_arrays(scene_drain *b, uint32_t nodes,
                                  vbss_array arrays[SCENE_DRAIN_ARRAYS])
{
    const vbss_array all[SCENE_DRAIN_ARRAYS] = {
        {&b->is_separator, nodes, sizeof *b->is_separator},
        {&b->expected_displacements, nodes, sizeof *b->expected_displacements},
        {&b->vertices, 2 * (size_t)nodes, sizeof *b->vertices},
        {&b->lip_of_side, EDGES_PER_NODE * (size_t)nodes, sizeof *b->lip_of_side},
        {&b->lip_of_node, nodes, sizeof *b->lip_of_node},
        {&b->near_features, EDGES_PER_NODE * (size_t)nodes, sizeof *b->near_features}};
    memcpy(arrays, all, sizeof all);
}

void vbss_scene_disown_drain(scene_object *s, scene_body *b)
{
    vbss_array arrays[SCENE_DRAIN_ARRAYS];
    scene_drain *own = &b->drain;
    uint32_t nodes = s->collision->shapes[b->shape]->node_count;
    vbss_slot_set_owner(own->slot, NULL, NULL);
    if (own->slot->object == own->drain) { /* the context may have destroyed it */
        own->drain->is_sparsity_valid = false;
        own->drain->gravity = vec3_load(own->drain->config.gravity);
        memset(own->drain->contact_forces, 0, nodes * sizeof *own->drain->contact_forces);
    }
    vbss_scene_list_drain_arrays(own, nodes, arrays);
    vbss_release_arrays(s->context, arrays, SCENE_DRAIN_ARRAYS);
}
