/* Adds a needle to a scene, as a free rigid body. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "scene/api/api.h"
#include "scene/api/overlap.h"
#include "scene/api/place.h"
#include "scene/tools/tools.h"
#include "scene/world/world.h"

/* Returns the slot of the needle. There is a free entry for it. */
static vbss_result check_needle(scene_object *s, vbss_needle *needle, const uint32_t *number,
                                vbss_slot **found)
{
    const scene_new_body added = {needle, &vbss_needle_kind, "needle"};
    VBSS_TRY(vbss_scene_check_new_body(s, &added, number, found));
    const vbss_slot *slot = *found;
    const needle_object *n = slot->object;
    VBSS_TRY(vbss_scene_check_method(s, n->config.method, "needle"));
    VBSS_TRY(vbss_scene_check_capsule_room(s, n->config.segment_count));
    scene_body *entry;
    return vbss_scene_find_free_body(s, SCENE_BODY_RIGID, &entry);
}

static void add_capsules(scene_object *s, scene_rigid *r)
{
    const needle_object *n = r->needle;
    r->first_capsule = s->capsule_count;
    r->capsule_count = n->config.segment_count;
    for (uint32_t i = 0; i < r->capsule_count; i++) {
        scene_capsule *to = &s->capsules[s->capsule_count++];
        for (uint32_t k = 0; k < 2; k++) {
            vec3 corner = vbss_needle_point(n, vbss_needle_vertex_arc(n, i + k));
            to->local_end[k] = pose_apply_inverse(r->frame, corner);
        }
        vbss_scene_snap_capsule_to_target(to);
        to->radius = n->config.wire_radius;
        vbss_scene_transform_capsule(to, r->body.now.pose, to->now);
    }
}

vbss_result vbss_scene_place_needle(scene_object *s, vbss_slot *slot, scene_body *b, uint32_t *body)
{
    uint32_t shape = 0;
    needle_object *n = slot->object;
    VBSS_TRY(vbss_collision_add_capsules(scene_collision(s), n->config.segment_count,
                                         n->config.wire_radius, &shape));
    s->collision->shapes[shape]->is_rigid = true;
    *b = (scene_body){.rigid = {.kind = VBSS_SCENE_RIGID_FREE,
                                .body = n->body,
                                .frame = n->body_frame,
                                .friction = n->config.friction,
                                .created_friction = n->config.friction,
                                .trial = n->body.now.pose,
                                .slot = slot,
                                .needle = n}};
    b->rigid.body.target_start = b->rigid.body.target_end = n->body.now.pose;
    add_capsules(s, &b->rigid);
    vbss_slot_set_owner(slot, s, &s->hook);
    vbss_scene_register_body(s, b, SCENE_BODY_RIGID, shape, body);
    vbss_scene_publish_needle(b);
    return VBSS_OK;
}

static vbss_result add_needle(scene_object *s, vbss_needle *needle, uint32_t *body)
{
    vbss_slot *slot;
    VBSS_TRY(check_needle(s, needle, body, &slot));
    VBSS_TRY(vbss_scene_check_overlap(s, &(scene_outline){.needle = slot->object}, "needle"));
    scene_body *b;
    VBSS_TRY(vbss_scene_find_free_body(s, SCENE_BODY_RIGID, &b));
    return vbss_scene_place_needle(s, slot, b, body);
}

vbss_result vbss_scene_add_needle(vbss_scene *scene, vbss_needle *needle, uint32_t *body)
{
    VBSS_ENTER(scene);
    scene_object *s;
    vbss_slot *slot;
    scene_edit edit;
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    VBSS_TRY(check_needle(s, needle, body, &slot));
    vbss_edit input = {.kind = VBSS_EDIT_OTHER};
    VBSS_TRY(vbss_scene_begin_edit(scene, &input, &edit));
    return vbss_scene_end_edit(&edit, add_needle(s, needle, body));
}
