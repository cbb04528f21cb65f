/* Graspers in a scene: rigid bodies with a shaft and two jaws that move against it.
 *
 * Before a step they are told where to go and how far to close; then the jaws move evenly, as their body
 * does, and after it the grasper is shown what became of it. */
#include "base/check.h"
#include "base/error.h"
#include "scene/events.h"
#include "scene/paper.h"
#include "scene/pins.h"
#include "scene/scene.h"
#include "scene/tools.h"

#include <string.h>

/* ---- joining and leaving */

static void set_rigid(scene_rigid *r, const grasper_object *g, vbss_slot *slot,
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
static void aim_capsules(scene_object *s, const scene_rigid *r, double angle)
{
    grasper_capsule laid[GRASPER_CAPSULES];
    vbss_grasper_compute_capsules(r->grasper, angle, laid);
    for (uint32_t i = 0; i < GRASPER_CAPSULES; i++) {
        scene_capsule *c = &s->capsules[r->first_capsule + i];
        for (int k = 0; k < 2; k++) {
            c->local_end[k] = pose_apply_inverse(r->frame, laid[i].axis[k]);
        }
        c->radius = laid[i].radius;
    }
}

static void show(scene_object *s, scene_body *b)
{
    const scene_rigid *r = &b->rigid;
    grasper_object *g = r->grasper;
    pose tool = pose_mul(r->body.now.pose, pose_inverse(r->frame));
    vec3 arm = vec3_sub(tool.position, r->body.now.pose.position); /* to the tip */
    bool driven = r->kind == VBSS_RIGID_DRIVEN;
    vec3 torque = driven ? vec3_zero() : vec3_neg(r->pull.torque);
    g->body_id = b->number;
    g->tool_pose = tool;
    g->velocity = vec3_add(r->body.now.v, vec3_cross(r->body.now.w, arm));
    g->angular_velocity = r->body.now.w;
    g->hand_force = driven ? vbss_scene_paper_hand_force(s, b) : vec3_neg(r->pull.force);
    g->hand_torque =
        driven ? torque : vec3_sub(torque, vec3_cross(arm, g->hand_force)); /* about the tip */
    g->grasp_count = vbss_scene_count_grasps(s, b->number);
    g->needle = vbss_scene_holds_needle(s, b->number) ? r->hold.needle : 0;
    bool squeezed = g->solenoid != 0 || g->opening <= g->config.solenoid_opening;
    g->solenoid = g->needle != 0 && squeezed;
    g->drain = vbss_scene_pinches(s, b->number) ? r->pinch.drain : 0;
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
#define GYRATION 0.03

/* A proxy has the mass that its coupling needs, at the tip, where the hand is to feel what acts. */
static vbss_rigid_mass mass_of(const grasper_object *g)
{
    double moment = g->config.mass * GYRATION * GYRATION;
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
    VBSS_TRY(vbss_scene_edit(scene, &s));
    VBSS_TRY(vbss_slot_edit_unowned(grasper, &vbss_grasper_kind_of_slot, &slot));
    VBSS_TRY(check_grasper(s, slot, body));
    grasper_object *g = slot->object;
    if (!vbss_grasper_apply_trocar(g, g->commanded_pose, &target)) {
        return vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE,
                         "the trocar is nearer to the tip than the jaws reach aside");
    }
    const vbss_rigid_mass mass = mass_of(g);
    scene_body *b = vbss_scene_new_place(s, BODY_RIGID);
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
    set_rigid(&b->rigid, g, slot, &mass, target);
    b->rigid.first_capsule = s->capsule_count;
    b->rigid.capsule_count = GRASPER_CAPSULES;
    s->capsule_count += GRASPER_CAPSULES;
    aim_capsules(s, &b->rigid, g->jaw_angle);
    for (uint32_t i = 0; i < GRASPER_CAPSULES; i++) {
        vbss_scene_finish_capsule(&s->capsules[b->rigid.first_capsule + i]);
    }
    slot->owner = s;
    vbss_scene_publish(s, b, BODY_RIGID, shape, body);
    show(s, b);
    return VBSS_OK;
}

void vbss_scene_release_grasper(scene_body *b)
{
    grasper_object *g = b->rigid.slot->object;
    b->rigid.slot->owner = NULL;
    if (g != NULL) { /* it may have ended with the context */
        vbss_grasper_detach(g);
    }
}

/* ---- as it was, if the step fails */

/* PAPER: the nodes that graspers carry. */
static void aim_carried(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        if (s->grasps[i].id != 0 && s->grasps[i].pin != 0) {
            vbss_scene_aim_pins(s);
            return;
        }
    }
}

void vbss_scene_keep_tools(scene_object *s)
{
    for (uint32_t i = 0; i < s->capsule_count; i++) {
        scene_capsule *c = &s->capsules[i];
        c->kept[0] = c->local[0];
        c->kept[1] = c->local[1];
        c->kept_end[0] = c->local_end[0]; /* elsewhere after a step that was cut short */
        c->kept_end[1] = c->local_end[1];
        c->kept_radius = c->radius;
    }
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_rigid *r = &s->bodies[i].rigid;
        if (s->bodies[i].kind == BODY_RIGID && r->grasper != NULL) {
            const grasper_object *g = r->grasper;
            r->kept_end = r->body.target_end;
            r->kept_hold = r->hold;
            r->kept_pinch = r->pinch;
            r->kept_jaws =
                (struct kept_jaws){g->kind, g->commanded_kind, g->jaw_angle, g->jaw_force};
        }
    }
    memcpy(s->kept_grasps, s->grasps, s->config.grasp_capacity * sizeof *s->grasps);
    s->kept_last_grasp = s->last_grasp;
    memcpy(s->kept_holes, s->holes, s->config.hole_capacity * sizeof *s->holes);
    s->kept_last_hole = s->last_hole;
}

void vbss_scene_return_tools(scene_object *s)
{
    for (uint32_t i = 0; i < s->capsule_count; i++) {
        scene_capsule *c = &s->capsules[i];
        c->local[0] = c->kept[0];
        c->local[1] = c->kept[1];
        c->local_end[0] = c->kept_end[0];
        c->local_end[1] = c->kept_end[1];
        c->radius = c->kept_radius;
    }
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_rigid *r = &s->bodies[i].rigid;
        if (s->bodies[i].kind == BODY_RIGID && r->grasper != NULL) {
            grasper_object *g = r->grasper;
            r->body.target_end = r->kept_end;
            r->hold = r->kept_hold;
            r->pinch = r->kept_pinch;
            g->kind = r->kept_jaws.kind;
            g->commanded_kind = r->kept_jaws.kind_told;
            g->jaw_angle = r->kept_jaws.angle;
            g->jaw_force = r->kept_jaws.pressure;
        }
    }
    memcpy(s->grasps, s->kept_grasps, s->config.grasp_capacity * sizeof *s->grasps);
    s->last_grasp = s->kept_last_grasp;
    memcpy(s->holes, s->kept_holes, s->config.hole_capacity * sizeof *s->holes);
    s->last_hole = s->kept_last_hole;
    aim_carried(s);
}

/* ---- before a step */

static void exchange(scene_object *s, scene_body *b)
{
    grasper_object *g = b->rigid.grasper;
    const vbss_grasper_config *c = &g->config;
    if (g->commanded_kind == g->kind) {
        return;
    }
    pose tool = pose_mul(b->rigid.body.now.pose, pose_inverse(b->rigid.frame));
    double far = vec3_distance(tool.position, vec3_load(c->exchange_centre));
    bool may = vbss_scene_count_grasps(s, b->number) == 0 && far >= c->exchange_distance;
    vbss_grasper_kind before = g->kind, wanted = g->commanded_kind;
    pose target;
    g->kind = may ? wanted : before;
    if (!vbss_grasper_apply_trocar(g, g->commanded_pose, &target)) { /* jaws of another bend */
        g->kind = before;
        may = false;
    }
    g->commanded_kind = g->kind;
    if (may) { /* nor does it wait for anything any more */
        vbss_scene_forget_grasps_of(s, b->number);
        vbss_scene_forget_holds_of(s, b->number);
        vbss_scene_forget_pinches_of(s, b->number);
    }
    vbss_scene_add_event(s, may ? VBSS_EVENT_EXCHANGED : VBSS_EVENT_NOT_EXCHANGED, b->number, 0,
                         (uint32_t)wanted);
}

static void take_told(scene_object *s, scene_body *b, double h)
{
    scene_rigid *r = &b->rigid;
    grasper_object *g = r->grasper;
    pose target;
    exchange(s, b);
    if (vbss_grasper_apply_trocar(g, g->commanded_pose,
                                  &target)) { /* it was asked when it was told */
        r->body.target_end = pose_mul(target, r->frame);
    }
    double before = g->jaw_angle;
    if (s->config.method == VBSS_METHOD_PAPER && g->kind == VBSS_GRASPER_NEEDLE_DRIVER) {
        g->jaw_angle = vbss_grasper_next_angle(g, h, 0.0);
    } else {
        vbss_scene_let_go(s, b);
        vbss_scene_let_needle_go(s, b);
        vbss_scene_let_wall_go(s, b);
        g->jaw_angle = vbss_scene_close_jaws(s, b, h);
    }
    r->has_closed = before > 0.0 && g->jaw_angle == 0.0;
    g->jaw_force = vbss_scene_count_grasps(s, b->number) > 0
                       ? vbss_grasper_jaw_force_at(g, g->jaw_angle)
                       : 0.0;
    aim_capsules(s, r, g->jaw_angle);
}

void vbss_scene_take_tools(scene_object *s, double h)
{
    s->cut_count = 0;
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == BODY_RIGID && b->rigid.grasper != NULL) {
            take_told(s, b, h);
        }
    }
    aim_carried(s);
}

/* ---- in a part: capsules cover the same share of what is left of their way as their body does */

void vbss_scene_aim_capsules(scene_object *s, const scene_part *part)
{
    double share = part->end < 1.0 ? (part->end - part->begin) / (1.0 - part->begin) : 1.0;
    for (uint32_t i = 0; i < s->capsule_count; i++) {
        scene_capsule *c = &s->capsules[i];
        for (int k = 0; k < 2; k++) {
            c->local_trial[k] =
                share < 1.0
                    ? vec3_add_scaled(c->local[k], share, vec3_sub(c->local_end[k], c->local[k]))
                    : c->local_end[k];
        }
    }
}

/* ---- after a step */

void vbss_scene_settle_tools(scene_object *s, double h)
{
    if (s->config.method == VBSS_METHOD_PAPER) {
        vbss_scene_paper_settle_needles(s, h);
        vbss_scene_paper_settle_grasps(s);
    } else {
        vbss_scene_settle_grasps(s, h);
        vbss_scene_settle_holds(s, h);
        vbss_scene_settle_pinches(s, h);
    }
    vbss_scene_make_cuts(s);
    vbss_scene_show_tools(s);
}

void vbss_scene_show_tools(scene_object *s)
{
    for (uint32_t i = 0; i < s->place_count; i++) {
        scene_body *b = &s->bodies[i];
        if (b->kind == BODY_RIGID && b->rigid.grasper != NULL) {
            show(s, b);
        } else if (b->kind == BODY_RIGID && b->rigid.needle != NULL) {
            vbss_scene_show_needle(b);
        }
    }
}
