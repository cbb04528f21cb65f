/* Adds a grasper to a scene, as a rigid body with four capsules. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "scene/api/api.h"
#include "scene/api/overlap.h"
#include "scene/api/place.h"
#include "scene/tools/tools.h"
#include "scene/tuning.h"
#include "scene/world/method.h"
#include "scene/world/world.h"

static void init_rigid(scene_rigid *r, vbss_scene_rigid_kind kind, const grasper_object *g,
                       vbss_slot *slot, const vbss_rigid_mass *mass, pose target)
{
    const vbss_grasper_config *c = &g->config;
    pose at = pose_mul(target, mass->frame);
    *r = (scene_rigid){.kind = kind,
                       .frame = mass->frame,
                       .friction = c->friction,
                       .created_friction = c->friction,
                       .slot = slot,
                       .grasper = slot->object};
    r->body.mass = mass->mass;
    r->body.inertia = mass->inertia;
    r->body.now.pose = r->body.target_start = r->body.target_end = r->trial = at;
    if (kind == VBSS_SCENE_RIGID_COUPLED) {
        const vbss_rigid_coupling coupling = {c->stiffness, c->damping, c->turning_stiffness,
                                              c->turning_damping};
        r->body.coupling = coupling;
    }
}

/* What a new grasper needs; found by the checks. */
typedef struct new_grasper {
    vbss_slot *slot;
    scene_body *body; /* a free entry */
    pose target;
} new_grasper;

static vbss_result check_grasper(scene_object *s, vbss_grasper *grasper, const uint32_t *number,
                                 new_grasper *found)
{
    const scene_new_body added = {grasper, &vbss_grasper_kind_of_slot, "grasper"};
    VBSS_TRY(vbss_scene_check_new_body(s, &added, number, &found->slot));
    const vbss_slot *slot = found->slot;
    const grasper_object *g = slot->object;
    VBSS_TRY(vbss_scene_check_method(s, g->config.method, "grasper"));
    VBSS_TRY(vbss_scene_check_capsule_room(s, GRASPER_CAPSULES));
    if (!vbss_grasper_apply_trocar(g, g->commanded_pose, &found->target)) {
        return vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE,
                         "the trocar is nearer to the tip than the jaws reach aside");
    }
    return vbss_scene_find_free_body(s, SCENE_BODY_RIGID, &found->body);
}

/* A proxy has the mass that its coupling needs, at the tip, where the hand is to feel what acts. */
static vbss_rigid_mass proxy_mass(const grasper_object *g)
{
    double moment = g->config.mass * SCENE_GYRATION_RADIUS * SCENE_GYRATION_RADIUS;
    const vbss_rigid_mass mass = {
        g->config.mass, {moment, moment, moment}, pose_make(vec3_zero(), quat_identity())};
    return mass;
}

static vbss_scene_rigid_kind motion_of_tools(const scene_object *s)
{
    return s->method->drives_tools ? VBSS_SCENE_RIGID_DRIVEN : VBSS_SCENE_RIGID_COUPLED;
}

vbss_result vbss_scene_place_grasper(scene_object *s, vbss_slot *slot, pose target, scene_body *b,
                                     uint32_t *body)
{
    uint32_t shape = 0;
    const grasper_object *g = slot->object;
    const vbss_rigid_mass mass = proxy_mass(g);
    VBSS_TRY(vbss_collision_add_capsules(
        scene_collision(s), GRASPER_CAPSULES,
        vbss_max(g->config.shaft_radius,
                 vbss_max(g->config.driver_radius, g->config.shears_radius)),
        &shape));
    s->collision->shapes[shape]->is_rigid = true;
    *b = (scene_body){0};
    init_rigid(&b->rigid, motion_of_tools(s), g, slot, &mass, target);
    b->rigid.first_capsule = s->capsule_count;
    b->rigid.capsule_count = GRASPER_CAPSULES;
    s->capsule_count += GRASPER_CAPSULES;
    vbss_scene_set_capsule_targets(s, &b->rigid, g->jaw_angle);
    for (uint32_t i = 0; i < GRASPER_CAPSULES; i++) {
        vbss_scene_snap_capsule_to_target(&s->capsules[b->rigid.first_capsule + i]);
    }
    vbss_slot_set_owner(slot, s, &s->hook);
    vbss_scene_register_body(s, b, SCENE_BODY_RIGID, shape, body);
    vbss_scene_publish_grasper(s, b);
    return VBSS_OK;
}

static vbss_result add_grasper(scene_object *s, vbss_grasper *grasper, uint32_t *body)
{
    new_grasper found;
    VBSS_TRY(check_grasper(s, grasper, body, &found));
    const scene_outline outline = {.grasper = found.slot->object,
                                   .at = found.target,
                                   .is_prescribed = motion_of_tools(s) == VBSS_SCENE_RIGID_DRIVEN};
    VBSS_TRY(vbss_scene_check_overlap(s, &outline, "grasper"));
    return vbss_scene_place_grasper(s, found.slot, found.target, found.body, body);
}

vbss_result vbss_scene_add_grasper(vbss_scene *scene, vbss_grasper *grasper, uint32_t *body)
{
    VBSS_ENTER(scene);
    scene_object *s;
    new_grasper found;
    scene_edit edit;
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    VBSS_TRY(check_grasper(s, grasper, body, &found));
    vbss_edit input = {.kind = VBSS_EDIT_OTHER};
    VBSS_TRY(vbss_scene_begin_edit(scene, &input, &edit));
    return vbss_scene_end_edit(&edit, add_grasper(s, grasper, body));
}
