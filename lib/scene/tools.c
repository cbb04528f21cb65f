/* Graspers in a scene: rigid bodies with a shaft and two jaws that move against it.
 *
 * Before a step they are told where to go and how far to close; then the jaws move evenly, as their body
 * does, and after it the grasper is shown what became of it. */
#include "base/check.h"
#include "base/error.h"
#include "scene/events.h"
#include "scene/pins.h"
#include "scene/scene.h"
#include "scene/tools.h"

#include <string.h>

/* ---- joining and leaving */

static void init_rigid(scene_rigid *r, const grasper_object *g, vbss_slot *slot,
                       const vbss_rigid_mass *mass, pose target)
{
    const vbss_grasper_config *c = &g->config;
    pose at = pose_mul(target, mass->frame);
    bool paper = c->method == VBSS_METHOD_PAPER; /* its tools are where the hand is */
    *r = (scene_rigid){.kind = paper ? VBSS_RIGID_DRIVEN : VBSS_RIGID_COUPLED,
                       .frame = mass->frame,
                       .friction = c->friction,
                       .slot = slot,
                       .grasper = slot->object};
    r->body.mass = mass->mass;
    r->body.inertia = mass->inertia;
    r->body.now.pose = r->body.target_start = r->body.target_end = r->trial = at;
    if (!paper) {
        const vbss_rigid_coupling coupling = {c->stiffness, c->damping, c->turning_stiffness,
                                              c->turning_damping};
        r->body.coupling = coupling;
    }
}

/* Where the capsules shall be when the jaws are at that angle, in the principal frame. */
static void set_capsule_targets(scene_object *s, const scene_rigid *r, double angle)
{
    grasper_capsule capsules[GRASPER_CAPSULES];
    vbss_grasper_compute_capsules(r->grasper, angle, capsules);
    for (uint32_t i = 0; i < GRASPER_CAPSULES; i++) {
        scene_capsule *c = &s->capsules[r->first_capsule + i];
        for (int k = 0; k < 2; k++) {
            c->local_end[k] = pose_apply_inverse(r->frame, capsules[i].axis[k]);
        }
        c->radius = capsules[i].radius;
    }
}

static void publish_grasper(scene_object *s, scene_body *b)
{
    const scene_rigid *r = &b->rigid;
    grasper_object *g = r->grasper;
    pose tool = pose_mul(r->body.now.pose, pose_inverse(r->frame));
    vec3 arm = vec3_sub(tool.position, r->body.now.pose.position); /* to the tip */
    bool driven = r->kind == VBSS_RIGID_DRIVEN;
    vec3 torque = driven ? vec3_zero() : vec3_neg(r->coupling_wrench.torque);
    g->body_id = b->number;
    g->tool_pose = tool;
    g->velocity = vec3_add(r->body.now.v, vec3_cross(r->body.now.w, arm));
    g->angular_velocity = r->body.now.w;
    /* The baseline sets its own. */
    g->hand_force = driven ? vec3_zero() : vec3_neg(r->coupling_wrench.force);
    g->hand_torque =
        driven ? torque : vec3_sub(torque, vec3_cross(arm, g->hand_force)); /* about the tip */
    g->grasp_count = vbss_scene_count_grasps(s, b->number);
    g->needle = vbss_scene_has_needle_grasp(s, b->number) ? r->needle_grasp.needle : 0;
    bool squeezed = g->solenoid != 0 || g->opening <= g->config.solenoid_opening;
    g->solenoid = g->needle != 0 && squeezed;
    g->drain = vbss_scene_has_wall_grasp(s, b->number) ? r->wall_grasp.drain : 0;
    g->generation++;
    vbss_grasper_update_view(g);
}

static vbss_result check_grasper(const scene_object *s, const vbss_slot *slot,
                                 const uint32_t *number)
{
    const grasper_object *g = slot->object;
    VBSS_TRY(vbss_check_pointer(s->context, number, "body"));
    if (slot->context != s->context) {
        return vbss_fail(s->context, VBSS_ERROR_INVALID_HANDLE,
                         "grasper %llu belongs to another context",
                         (unsigned long long)slot->ordinal);
    }
    if (g->config.method != s->config.method) {
        return vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE,
                         "the grasper's method is not the scene's");
    }
    if (GRASPER_CAPSULES > s->config.capsule_capacity - s->capsule_count) {
        return vbss_fail(s->context, VBSS_ERROR_CAPACITY, "the scene has room for %u capsules",
                         s->config.capsule_capacity);
    }
    return VBSS_OK;
}

/* Radius of gyration about the tip, m: about that of what works there. */
#define GYRATION_RADIUS 0.03

/* A proxy has the mass that its coupling needs, at the tip, where the hand is to feel what acts. */
static vbss_rigid_mass proxy_mass(const grasper_object *g)
{
    double moment = g->config.mass * GYRATION_RADIUS * GYRATION_RADIUS;
    const vbss_rigid_mass mass = {
        g->config.mass, {moment, moment, moment}, pose_make(vec3_zero(), quat_identity())};
    return mass;
}

vbss_result vbss_scene_add_grasper(vbss_scene *scene, vbss_grasper *grasper, uint32_t *body)
{
    scene_object *s;
    vbss_slot *slot;
    pose target;
    uint32_t shape = 0;
    VBSS_TRY(vbss_scene_open_for_edit(scene, &s));
    VBSS_TRY(vbss_slot_edit_unowned(grasper, &vbss_grasper_kind_of_slot, &slot));
    VBSS_TRY(check_grasper(s, slot, body));
    grasper_object *g = slot->object;
    if (!vbss_grasper_apply_trocar(g, g->commanded_pose, &target)) {
        return vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE,
                         "the trocar is nearer to the tip than the jaws reach aside");
    }
    const vbss_rigid_mass mass = proxy_mass(g);
    scene_body *b = vbss_scene_find_free_body(s, SCENE_BODY_RIGID);
    if (b == NULL) {
        return VBSS_ERROR_CAPACITY;
    }
    VBSS_TRY(vbss_collision_add_capsules(
        scene_collision(s), GRASPER_CAPSULES,
        vbss_max(g->config.shaft_radius,
                 vbss_max(g->config.driver_radius, g->config.shears_radius)),
        &shape));
    s->collision->shapes[shape]->is_rigid = true;
    *b = (scene_body){0};
    init_rigid(&b->rigid, g, slot, &mass, target);
    b->rigid.first_capsule = s->capsule_count;
    b->rigid.capsule_count = GRASPER_CAPSULES;
    s->capsule_count += GRASPER_CAPSULES;
    set_capsule_targets(s, &b->rigid, g->jaw_angle);
    for (uint32_t i = 0; i < GRASPER_CAPSULES; i++) {
        vbss_scene_snap_capsule_to_target(&s->capsules[b->rigid.first_capsule + i]);
    }
    slot->owner = s;
    vbss_scene_register_body(s, b, SCENE_BODY_RIGID, shape, body);
    publish_grasper(s, b);
    return VBSS_OK;
}

void vbss_scene_disown_grasper(scene_body *b)
{
    grasper_object *g = b->rigid.slot->object;
    b->rigid.slot->owner = NULL;
    if (g != NULL) { /* it may have ended with the context */
        vbss_grasper_detach(g);
    }
}

/* ---- as it was, if the step fails */

/* PAPER: the nodes that graspers carry. */
static void set_carried_targets(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        if (s->thread_grasps[i].id != 0 && s->thread_grasps[i].pin != 0) {
            vbss_scene_set_pin_targets(s);
            return;
        }
    }
}

void vbss_scene_checkpoint_tools(scene_object *s)
{
    for (uint32_t i = 0; i < s->capsule_count; i++) {
        scene_capsule *c = &s->capsules[i];
        c->checkpoint_local[0] = c->local[0];
        c->checkpoint_local[1] = c->local[1];
        c->checkpoint_local_end[0] =
            c->local_end[0]; /* elsewhere after a step that was cut short */
        c->checkpoint_local_end[1] = c->local_end[1];
        c->checkpoint_radius = c->radius;
    }
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_rigid *r = &s->bodies[i].rigid;
        if (s->bodies[i].kind == SCENE_BODY_RIGID && r->grasper != NULL) {
            const grasper_object *g = r->grasper;
            r->checkpoint_end = r->body.target_end;
            r->checkpoint_needle_grasp = r->needle_grasp;
            r->checkpoint_wall_grasp = r->wall_grasp;
            r->checkpoint_jaws = (struct scene_checkpoint_jaws){g->kind, g->commanded_kind,
                                                                g->jaw_angle, g->jaw_force};
        }
    }
    memcpy(s->checkpoint_thread_grasps, s->thread_grasps,
           s->config.grasp_capacity * sizeof *s->thread_grasps);
    s->checkpoint_last_grasp_id = s->last_grasp_id;
    memcpy(s->checkpoint_holes, s->holes, s->config.hole_capacity * sizeof *s->holes);
    s->checkpoint_last_hole_id = s->last_hole_id;
}

void vbss_scene_rollback_tools(scene_object *s)
{
    for (uint32_t i = 0; i < s->capsule_count; i++) {
        scene_capsule *c = &s->capsules[i];
        c->local[0] = c->checkpoint_local[0];
        c->local[1] = c->checkpoint_local[1];
        c->local_end[0] = c->checkpoint_local_end[0];
        c->local_end[1] = c->checkpoint_local_end[1];
        c->radius = c->checkpoint_radius;
    }
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_rigid *r = &s->bodies[i].rigid;
        if (s->bodies[i].kind == SCENE_BODY_RIGID && r->grasper != NULL) {
            grasper_object *g = r->grasper;
            r->body.target_end = r->checkpoint_end;
            r->needle_grasp = r->checkpoint_needle_grasp;
            r->wall_grasp = r->checkpoint_wall_grasp;
            g->kind = r->checkpoint_jaws.kind;
            g->commanded_kind = r->checkpoint_jaws.target_kind;
            g->jaw_angle = r->checkpoint_jaws.angle;
            g->jaw_force = r->checkpoint_jaws.pressure;
        }
    }
    memcpy(s->thread_grasps, s->checkpoint_thread_grasps,
           s->config.grasp_capacity * sizeof *s->thread_grasps);
    s->last_grasp_id = s->checkpoint_last_grasp_id;
    memcpy(s->holes, s->checkpoint_holes, s->config.hole_capacity * sizeof *s->holes);
    s->last_hole_id = s->checkpoint_last_hole_id;
    set_carried_targets(s);
}

/* ---- before a step */

static void exchange_instrument(scene_object *s, scene_body *b)
{
    grasper_object *g = b->rigid.grasper;
    const vbss_grasper_config *c = &g->config;
    if (g->commanded_kind == g->kind) {
        return;
    }
    pose tool = pose_mul(b->rigid.body.now.pose, pose_inverse(b->rigid.frame));
    double far = vec3_distance(tool.position, vec3_load(c->exchange_centre));
    bool allowed = vbss_scene_count_grasps(s, b->number) == 0 && far >= c->exchange_distance;
    vbss_grasper_kind before = g->kind, wanted = g->commanded_kind;
    pose target;
    g->kind = allowed ? wanted : before;
    if (!vbss_grasper_apply_trocar(g, g->commanded_pose, &target)) { /* jaws of another bend */
        g->kind = before;
        allowed = false;
    }
    g->commanded_kind = g->kind;
    if (allowed) { /* nor does it wait for anything any more */
        vbss_scene_remove_thread_grasps_of(s, b->number);
        vbss_scene_remove_needle_grasps_of(s, b->number);
        vbss_scene_remove_wall_grasps_of(s, b->number);
    }
    vbss_scene_add_event(s, allowed ? VBSS_EVENT_EXCHANGED : VBSS_EVENT_NOT_EXCHANGED, b->number, 0,
                         (uint32_t)wanted);
}

static void apply_target(scene_object *s, scene_body *b, double h)
{
    scene_rigid *r = &b->rigid;
    grasper_object *g = r->grasper;
    pose target;
    exchange_instrument(s, b);
    if (vbss_grasper_apply_trocar(g, g->commanded_pose,
                                  &target)) { /* it was asked when it was told */
        r->body.target_end = pose_mul(target, r->frame);
    }
    double before = g->jaw_angle;
    if (s->config.method == VBSS_METHOD_PAPER && g->kind == VBSS_GRASPER_NEEDLE_DRIVER) {
        g->jaw_angle = vbss_grasper_next_angle(g, h, 0.0);
    } else {
        vbss_scene_release_thread_grasps(s, b);
        vbss_scene_release_needle_grasp(s, b);
        vbss_scene_release_wall_grasp(s, b);
        g->jaw_angle = vbss_scene_close_jaws(s, b, h);
    }
    r->has_closed_jaws = before > 0.0 && g->jaw_angle == 0.0;
    g->jaw_force = vbss_scene_count_grasps(s, b->number) > 0
                       ? vbss_grasper_jaw_force_at(g, g->jaw_angle)
                       : 0.0;
    set_capsule_targets(s, r, g->jaw_angle);
}

void vbss_scene_apply_tool_targets(scene_object *s, double h)
{
    s->cut_count = 0;
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_RIGID && b->rigid.grasper != NULL) {
            apply_target(s, b, h);
        }
    }
    set_carried_targets(s);
}

/* ---- in a part: capsules cover the same share of what is left of their way as their body does */

void vbss_scene_set_capsule_trials(scene_object *s, const scene_substep *substep)
{
    double fraction =
        substep->end_fraction < 1.0
            ? (substep->end_fraction - substep->start_fraction) / (1.0 - substep->start_fraction)
            : 1.0;
    for (uint32_t i = 0; i < s->capsule_count; i++) {
        scene_capsule *c = &s->capsules[i];
        for (int k = 0; k < 2; k++) {
            c->local_trial[k] =
                fraction < 1.0
                    ? vec3_add_scaled(c->local[k], fraction, vec3_sub(c->local_end[k], c->local[k]))
                    : c->local_end[k];
        }
    }
}

/* ---- after a step */

void vbss_scene_update_tools(scene_object *s, double h)
{
    vbss_scene_update_thread_grasps(s, h);
    vbss_scene_update_needle_grasps(s, h);
    vbss_scene_update_wall_grasps(s, h);
    vbss_scene_make_cuts(s);
    vbss_scene_publish_tools(s);
}

void vbss_scene_publish_tools(scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_RIGID && b->rigid.grasper != NULL) {
            publish_grasper(s, b);
        } else if (b->kind == SCENE_BODY_RIGID && b->rigid.needle != NULL) {
            vbss_scene_publish_needle(b);
        }
    }
}
