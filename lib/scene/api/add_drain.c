/* Adds a drain to a scene: its collision shape, its free edges, and its arrays. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "scene/api/api.h"
#include "scene/api/overlap.h"
#include "scene/api/place.h"
#include "scene/world/method.h"
#include "scene/world/world.h"

/* Returns the slot of the drain. There is a free entry for it. */
static vbss_result check_drain(scene_object *s, vbss_drain *drain, const uint32_t *number,
                               vbss_slot **found)
{
    const scene_new_body added = {drain, &vbss_drain_kind, "drain"};
    VBSS_TRY(vbss_scene_check_new_body(s, &added, number, found));
    const vbss_slot *slot = *found;
    const drain_object *d = slot->object;
    VBSS_TRY(vbss_scene_check_method(s, d->config.method, "drain"));
    scene_body *entry;
    return vbss_scene_find_free_body(s, SCENE_BODY_DRAIN, &entry);
}

static vbss_result add_shape(scene_object *s, const drain_object *d, uint32_t *shape)
{
    const drain_mesh *m = &d->mesh;
    return vbss_collision_add_mesh(scene_collision(s), m->node_count, m->triangles[0],
                                   m->triangle_count, 0.5 * d->config.thickness, shape);
}

static uint32_t find_edge(const collision_shape *shape, uint32_t p, uint32_t q)
{
    uint32_t i = 0;
    while ((shape->edges[i][0] != p || shape->edges[i][1] != q) &&
           (shape->edges[i][0] != q || shape->edges[i][1] != p)) {
        i++;
    }
    return i;
}

static void find_lips(scene_drain *b, const collision_shape *shape)
{
    const drain_mesh *m = &b->drain->mesh;
    for (uint32_t i = 0; i < shape->edge_count; i++) {
        b->lip_of_side[i] = SCENE_NO_FACE;
    }
    for (uint32_t i = 0; i < m->node_count; i++) {
        b->lip_of_node[i] = SCENE_NO_FACE;
    }
    for (uint32_t t = 0; t < m->triangle_count; t++) {
        for (int k = 0; k < 3; k++) {
            uint32_t p = m->triangles[t][(k + 1) % 3], q = m->triangles[t][(k + 2) % 3];
            if (m->opposite_node[t][k] == DRAIN_NONE) {
                b->lip_of_side[find_edge(shape, p, q)] = t;
                b->lip_of_node[p] = b->lip_of_node[q] = t;
            }
        }
    }
}

static vbss_result create_drain_data(scene_object *s, scene_drain *b, uint32_t *shape)
{
    vbss_array arrays[SCENE_DRAIN_ARRAYS];
    vbss_scene_list_drain_arrays(b, b->drain->mesh.node_count, arrays);
    VBSS_TRY(vbss_allocate_arrays(s->context, arrays, SCENE_DRAIN_ARRAYS, "drain in a scene"));
    VBSS_TRY(add_shape(s, b->drain, shape));
    find_lips(b, s->collision->shapes[*shape]);
    vbss_result result = s->method->prepare_drain(s, b->drain, *shape);
    if (result != VBSS_OK) {
        (void)vbss_collision_remove(scene_collision(s), *shape);
    }
    return result;
}

vbss_result vbss_scene_place_drain(scene_object *s, vbss_slot *slot, scene_body *b, uint32_t *body)
{
    uint32_t shape = 0;
    scene_drain own = {.slot = slot, .drain = slot->object};
    own.friction = own.drain->config.friction;
    vbss_result result = create_drain_data(s, &own, &shape);
    if (result != VBSS_OK) {
        vbss_array arrays[SCENE_DRAIN_ARRAYS];
        vbss_scene_list_drain_arrays(&own, own.drain->mesh.node_count, arrays);
        vbss_release_arrays(s->context, arrays, SCENE_DRAIN_ARRAYS);
        return result;
    }
    *b = (scene_body){.drain = own};
    vbss_slot_set_owner(slot, s, &s->hook);
    vbss_scene_register_body(s, b, SCENE_BODY_DRAIN, shape, body);
    return VBSS_OK;
}

static vbss_result add_drain(scene_object *s, vbss_drain *drain, uint32_t *body)
{
    vbss_slot *slot;
    VBSS_TRY(check_drain(s, drain, body, &slot));
    VBSS_TRY(vbss_scene_check_overlap(
        s, &(scene_outline){.surface = vbss_scene_surface_of_drain(slot->object)}, "drain"));
    scene_body *b;
    VBSS_TRY(vbss_scene_find_free_body(s, SCENE_BODY_DRAIN, &b));
    return vbss_scene_place_drain(s, slot, b, body);
}

vbss_result vbss_scene_add_drain(vbss_scene *scene, vbss_drain *drain, uint32_t *body)
{
    VBSS_ENTER(scene);
    scene_object *s;
    vbss_slot *slot;
    scene_edit edit;
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    VBSS_TRY(check_drain(s, drain, body, &slot));
    vbss_edit input = {.kind = VBSS_EDIT_OTHER};
    VBSS_TRY(vbss_scene_begin_edit(scene, &input, &edit));
    return vbss_scene_end_edit(&edit, add_drain(s, drain, body));
}
