/* Removes a body from a scene, with its pins, grasps and holes. */
#include "base/api_call.h"
#include "base/error.h"
#include "scene/api/api.h"
#include "scene/step/step.h"
#include "scene/tissue/tissue.h"
#include "scene/tools/tools.h"
#include "scene/topology/topology.h"
#include "scene/world/method.h"
#include "scene/world/world.h"

#include <string.h>

static void remove_capsules(scene_object *s, const scene_rigid *gone)
{
    uint32_t end = gone->first_capsule + gone->capsule_count;
    memmove(s->capsules + gone->first_capsule, s->capsules + end,
            (s->capsule_count - end) * sizeof *s->capsules);
    s->capsule_count -= gone->capsule_count;
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_rigid *r = &s->bodies[i].rigid;
        if (s->bodies[i].kind == SCENE_BODY_RIGID && r->first_capsule >= end) {
            r->first_capsule -= gone->capsule_count;
        }
    }
}

static vbss_result remove_body(scene_object *s, scene_body *b)
{
    const uint32_t body = b->number;
    VBSS_TRY(vbss_scene_abandon_suspended_step(s)); /* which removes no body */
    vbss_slot *slot = vbss_scene_slot_of_body(b);
    vbss_scene_remove_pins_of(s, body);
    vbss_scene_remove_thread_grasps_of(s, body);
    vbss_scene_remove_needle_grasps_of(s, body);
    vbss_scene_remove_wall_grasps_of(s, body);
    vbss_scene_remove_holes_of(s, body);
    s->method->remove_body(s, body);
    if (b->kind == SCENE_BODY_DRAIN) {
        vbss_scene_disown_drain(s, b);
    }
    vbss_scene_release_static_mesh(s, b);
    VBSS_TRY(vbss_collision_remove(scene_collision(s), b->shape));
    if (b->kind == SCENE_BODY_THREAD) {
        const thread_piece_pool *family = b->thread.thread->piece_pool;
        vbss_scene_disown_thread(b);
        b->kind = SCENE_BODY_NONE;
        b->is_reserved = false;
        vbss_scene_return_spares(s, family);
    } else if (b->kind == SCENE_BODY_RIGID) {
        if (b->rigid.grasper != NULL) {
            vbss_scene_disown_grasper(b);
        } else if (b->rigid.needle != NULL) {
            vbss_scene_disown_needle(b);
        }
        remove_capsules(s, &b->rigid);
    }
    b->kind = SCENE_BODY_NONE;
    vbss_scene_drop_ended_overlaps(s);
    vbss_scene_number_nodes(s);
    s->step.pattern_hash = 0;
    s->report.generation++;
    if (slot != NULL) {
        vbss_slot_destroy_owned(slot);
    }
    return VBSS_OK;
}

vbss_result vbss_scene_remove(vbss_scene *scene, uint32_t body)
{
    VBSS_ENTER(scene);
    scene_object *s;
    vbss_edit input = {.kind = VBSS_EDIT_REMOVE, .words = {body}};
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    scene_body *b;
    VBSS_TRY(vbss_scene_require_any_body(s, body, &b));
    VBSS_TRY(vbss_edit_begin(scene, &input));
    return vbss_edit_end(scene, &input, remove_body(s, b));
}
