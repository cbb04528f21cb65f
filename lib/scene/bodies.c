/* Threads and rigid bodies come into a scene, move there, and leave. */
#include "base/check.h"
#include "base/error.h"
#include "scene/substep.h"
#include "scene/cuts.h"
#include "scene/holes.h"
#include "scene/paper.h"
#include "scene/pins.h"
#include "scene/scene.h"
#include "scene/tools.h"

#include <string.h>

_Static_assert(sizeof(vbss_rigid_config) == 200, "published size");
_Static_assert(sizeof(vbss_rigid_state) == 264, "published size");
_Static_assert(sizeof(vbss_capsule) == 56, "published size");

static const vbss_rigid_config rigid_defaults = {
    .struct_size = sizeof(vbss_rigid_config),
    .kind = VBSS_RIGID_DRIVEN,
    .orientation = {1.0, 0.0, 0.0, 0.0},
    .mass = 0.02,
    .friction = 0.15,
    .stiffness = 2000.0,
    .damping = 5.0,
    .turning_stiffness = 2.0,
    .turning_damping = 0.005,
};
static const uint32_t rigid_sizes[] = {200, 0};
static const vbss_layout rigid_layout = {"vbss_rigid_config", &rigid_defaults, rigid_sizes};
static const uint32_t state_sizes[] = {264, 0};
static const vbss_layout state_layout = {"vbss_rigid_state", NULL, state_sizes};

vbss_result vbss_rigid_config_init(vbss_rigid_config *config, uint32_t struct_size)
{
    return vbss_config_init(&rigid_layout, config, struct_size);
}

/* ---- finding */

scene_body *vbss_scene_body(const scene_object *s, uint32_t number)
{
    for (uint32_t i = 0; number != 0 && i < s->body_count; i++) {
        if (s->bodies[i].kind != SCENE_BODY_NONE && s->bodies[i].number == number) {
            return &s->bodies[i];
        }
    }
    return NULL;
}

bool vbss_scene_has_body_kind(const scene_object *s, scene_body_kind kind)
{
    bool any = false;
    for (uint32_t i = 0; i < s->body_count; i++) {
        any = any || s->bodies[i].kind == kind;
    }
    return any;
}

scene_body *vbss_scene_require_body(const scene_object *s, uint32_t number, scene_body_kind kind)
{
    scene_body *b = vbss_scene_body(s, number);
    if (b == NULL || b->kind != kind) {
        static const char *const names[] = {[SCENE_BODY_NONE] = "body",
                                            [SCENE_BODY_THREAD] = "thread",
                                            [SCENE_BODY_RIGID] = "rigid body",
                                            [SCENE_BODY_DRAIN] = "drain"};
        vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE, "body %u is no %s of this scene", number,
                  names[kind]);
        return NULL;
    }
    return b;
}

/* A place for one more body of that kind; NULL, told. */
scene_body *vbss_scene_find_free_body(scene_object *s, scene_body_kind kind)
{
    const uint32_t capacities[] = {[SCENE_BODY_THREAD] = s->config.thread_capacity,
                                   [SCENE_BODY_RIGID] = s->config.rigid_capacity,
                                   [SCENE_BODY_DRAIN] = s->config.drain_capacity};
    const uint32_t capacity = capacities[kind];
    uint32_t alive = 0, body_index = s->body_count;
    for (uint32_t i = s->body_count; i > 0; i--) {
        const scene_body *b = &s->bodies[i - 1];
        alive += b->kind == kind ||
                 (b->is_reserved && b->kind == SCENE_BODY_NONE && kind == SCENE_BODY_THREAD);
        body_index = b->kind == SCENE_BODY_NONE && !b->is_reserved ? i - 1 : body_index;
    }
    if (alive == capacity || s->last_body_number == UINT32_MAX) {
        vbss_fail(s->context, VBSS_ERROR_CAPACITY, "the scene has room for %u such bodies",
                  capacity);
        return NULL;
    }
    return &s->bodies[body_index];
}

void vbss_scene_register_body(scene_object *s, scene_body *b, scene_body_kind kind, uint32_t shape,
                              uint32_t *number)
{
    uint32_t body_index = (uint32_t)(b - s->bodies);
    b->kind = kind;
    b->shape = shape;
    b->number = *number = ++s->last_body_number;
    s->body_of_shape[shape] = body_index;
    s->body_count = body_index == s->body_count ? body_index + 1 : s->body_count;
    s->pattern_hash = 0;
    s->generation++;
}

/* ---- threads */

static vbss_result check_thread(const scene_object *s, const vbss_slot *slot, uint32_t *number)
{
    const thread_object *t = slot->object;
    VBSS_TRY(vbss_check_pointer(s->context, number, "body"));
    if (slot->context != s->context) {
        return vbss_fail(s->context, VBSS_ERROR_INVALID_HANDLE,
                         "thread %llu belongs to another context",
                         (unsigned long long)slot->ordinal);
    }
    if (t->config.method != s->config.method) {
        return vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE,
                         "the thread's method is not the scene's");
    }
    return vbss_scene_check_thread_capacity(s, t);
}

void vbss_scene_number_nodes(scene_object *s)
{
    s->node_count = 0;
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (s->bodies[i].kind == SCENE_BODY_THREAD) {
            s->bodies[i].thread.first_node = s->node_count;
            s->node_count += s->bodies[i].thread.thread->node_count;
        }
    }
}

/* One that a mesh can grow in. */
static vbss_result add_shape(scene_object *s, const thread_object *t, uint32_t *shape)
{
    if (t->config.mesh == VBSS_MESH_FIXED) {
        return vbss_collision_add_chain(scene_collision(s), t->node_count, t->rest,
                                        t->config.radius, shape);
    }
    VBSS_TRY(
        vbss_collision_add_disabled_chain(s->collision, t->node_capacity, t->config.radius, shape));
    vbss_collision_resize_chain(s->collision, *shape, t->node_count, t->rest);
    return VBSS_OK;
}

vbss_result vbss_scene_add_thread(vbss_scene *scene, vbss_thread *thread, uint32_t *body)
{
    scene_object *s;
    vbss_slot *slot;
    uint32_t shape = 0;
    VBSS_TRY(vbss_scene_open_for_edit(scene, &s));
    VBSS_TRY(vbss_slot_edit_unowned(thread, &vbss_thread_kind, &slot));
    VBSS_TRY(check_thread(s, slot, body));
    scene_body *b = vbss_scene_find_free_body(s, SCENE_BODY_THREAD);
    if (b == NULL) {
        return VBSS_ERROR_CAPACITY;
    }
    thread_object *t = slot->object;
    VBSS_TRY(add_shape(s, t, &shape));
    VBSS_TRY(vbss_scene_create_piece_shapes(s, t, shape));
    *b = (scene_body){0};
    b->thread.slot = slot;
    b->thread.thread = t;
    slot->owner = s;
    vbss_scene_register_body(s, b, SCENE_BODY_THREAD, shape, body);
    vbss_scene_add_spares(s, t, shape + 1);
    vbss_scene_number_nodes(s);
    return VBSS_OK;
}

void vbss_scene_disown_thread(scene_body *b)
{
    thread_object *t = b->thread.thread;
    b->thread.slot->owner = NULL;
    if (b->thread.slot->object == t) { /* it may have ended with the context */
        t->is_sparsity_valid = false;
        memset(t->welded, 0, t->node_count * sizeof *t->welded);
    }
}

/* ---- rigid bodies */

static vbss_result check_capsule(vbss_context *context, const vbss_capsule *c)
{
    VBSS_TRY(vbss_check_finite(context, c->begin, 3, "begin of a capsule"));
    VBSS_TRY(vbss_check_finite(context, c->end, 3, "end of a capsule"));
    VBSS_TRY(vbss_check_range(context, vbss_max_abs(c->begin, 3), 0.0, 1e3, "begin of a capsule"));
    VBSS_TRY(vbss_check_range(context, vbss_max_abs(c->end, 3), 0.0, 1e3, "end of a capsule"));
    return vbss_check_range(context, c->radius, 1e-6, 1.0, "radius of a capsule");
}

static vbss_result check_rigid(const scene_object *s, const vbss_rigid_config *c)
{
    vbss_context *context = s->context;
    VBSS_TRY(vbss_check_range(context, c->kind, VBSS_RIGID_DRIVEN, VBSS_RIGID_FREE, "kind"));
    VBSS_TRY(vbss_check_range(context, c->capsule_count, 1.0, 256.0, "capsule_count"));
    VBSS_TRY(vbss_check_range(context, c->reserved, 0.0, 0.0, "reserved"));
    VBSS_TRY(vbss_check_pointer(context, c->capsules, "capsules"));
    VBSS_TRY(vbss_check_vector(context, c->position, 1e3, "position"));
    VBSS_TRY(vbss_check_vector(context, c->velocity, 1e5, "velocity"));
    VBSS_TRY(vbss_check_vector(context, c->angular_velocity, 1e6, "angular_velocity"));
    VBSS_TRY(vbss_check_vector(context, c->gravity, 1e6, "gravity"));
    VBSS_TRY(vbss_check_range(context, c->mass, 1e-9, 1e3, "mass"));
    VBSS_TRY(vbss_check_range(context, c->friction, 0.0, 10.0, "friction"));
    VBSS_TRY(vbss_check_range(context, c->stiffness, 0.0, 1e9, "stiffness"));
    VBSS_TRY(vbss_check_range(context, c->damping, 0.0, 1e6, "damping"));
    VBSS_TRY(vbss_check_range(context, c->turning_stiffness, 0.0, 1e9, "turning_stiffness"));
    VBSS_TRY(vbss_check_range(context, c->turning_damping, 0.0, 1e6, "turning_damping"));
    for (uint32_t i = 0; i < c->capsule_count; i++) {
        VBSS_TRY(check_capsule(context, &c->capsules[i]));
    }
    if (c->capsule_count > s->config.capsule_capacity - s->capsule_count) {
        return vbss_fail(context, VBSS_ERROR_CAPACITY, "the scene has room for %u capsules",
                         s->config.capsule_capacity);
    }
    return VBSS_OK;
}

/* Capsules as if solid and of one material. */
static vbss_result distribute_mass(const scene_object *s, const vbss_rigid_config *c,
                                   vbss_rigid_mass *mass)
{
    for (uint32_t i = 0; i < c->capsule_count; i++) {
        const vbss_capsule *from = &c->capsules[i];
        s->mass_capsules[i] = (vbss_rigid_capsule){vec3_load(from->begin), vec3_load(from->end),
                                                   from->radius, 1000.0};
    }
    if (!vbss_rigid_mass_of_capsules(s->mass_capsules, c->capsule_count, mass)) {
        return vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE, "the capsules have no mass");
    }
    mass->inertia = vec3_scale(mass->inertia, c->mass / mass->mass);
    mass->mass = c->mass;
    return VBSS_OK;
}

static void init_rigid(scene_rigid *r, const vbss_rigid_config *c, const vbss_rigid_mass *mass,
                       quat orientation)
{
    pose at = pose_mul(pose_make(vec3_load(c->position), orientation), mass->frame);
    vec3 w = vec3_load(c->angular_velocity);
    vec3 arm = quat_rotate(orientation, mass->frame.position);
    *r = (scene_rigid){.kind = c->kind, .frame = mass->frame, .friction = c->friction};
    r->body.mass = mass->mass;
    r->body.inertia = mass->inertia;
    r->body.gravity = vec3_load(c->gravity);
    r->body.now.pose = r->body.target_start = r->body.target_end = r->trial = at;
    if (c->kind == VBSS_RIGID_COUPLED) {
        const vbss_rigid_coupling coupling = {c->stiffness, c->damping, c->turning_stiffness,
                                              c->turning_damping};
        r->body.coupling = coupling;
    }
    if (c->kind != VBSS_RIGID_DRIVEN) {
        r->body.now.v = vec3_add(vec3_load(c->velocity), vec3_cross(w, arm));
        r->body.now.w = w;
    }
}

static void add_capsules(scene_object *s, scene_body *b, const vbss_rigid_config *c)
{
    scene_rigid *r = &b->rigid;
    r->first_capsule = s->capsule_count;
    r->capsule_count = c->capsule_count;
    for (uint32_t i = 0; i < c->capsule_count; i++) {
        scene_capsule *to = &s->capsules[s->capsule_count++];
        to->local_end[0] = pose_apply_inverse(r->frame, vec3_load(c->capsules[i].begin));
        to->local_end[1] = pose_apply_inverse(r->frame, vec3_load(c->capsules[i].end));
        vbss_scene_snap_capsule_to_target(to);
        to->radius = c->capsules[i].radius;
        vbss_scene_transform_capsule(to, r->body.now.pose, to->now);
    }
}

vbss_result vbss_scene_add_rigid(vbss_scene *scene, const vbss_rigid_config *config, uint32_t *body)
{
    scene_object *s;
    vbss_rigid_config own;
    vbss_rigid_mass mass;
    quat orientation;
    uint32_t shape = 0;
    double radius = 0.0;
    VBSS_TRY(vbss_scene_open_for_edit(scene, &s));
    VBSS_TRY(vbss_check_pointer(s->context, body, "body"));
    VBSS_TRY(vbss_config_read(s->context, &rigid_layout, config, &own));
    VBSS_TRY(check_rigid(s, &own));
    VBSS_TRY(vbss_read_orientation(s->context, own.orientation, &orientation));
    VBSS_TRY(distribute_mass(s, &own, &mass));
    scene_body *b = vbss_scene_find_free_body(s, SCENE_BODY_RIGID);
    if (b == NULL) {
        return VBSS_ERROR_CAPACITY;
    }
    for (uint32_t i = 0; i < own.capsule_count; i++) {
        radius = vbss_max(own.capsules[i].radius, radius);
    }
    VBSS_TRY(vbss_collision_add_capsules(scene_collision(s), own.capsule_count, radius, &shape));
    s->collision->shapes[shape]->is_rigid = true;
    *b = (scene_body){0};
    init_rigid(&b->rigid, &own, &mass, orientation);
    add_capsules(s, b, &own);
    vbss_scene_register_body(s, b, SCENE_BODY_RIGID, shape, body);
    return VBSS_OK;
}

void vbss_scene_transform_capsule(const scene_capsule *capsule, pose at, vec3 axis[2])
{
    axis[0] = pose_apply(at, capsule->local[0]);
    axis[1] = pose_apply(at, capsule->local[1]);
}

bool vbss_scene_feature_segment(const scene_object *s, uint32_t number, uint32_t feature,
                                vec3 axis[2])
{
    const scene_body *b = vbss_scene_body(s, number);
    if (b == NULL) {
        return false;
    }
    if (b->kind == SCENE_BODY_THREAD) {
        memcpy(axis, b->thread.thread->now.x + feature, 2 * sizeof *axis);
    } else if (b->kind == SCENE_BODY_DRAIN) {
        const uint32_t *edge = s->collision->shapes[b->shape]->edges[feature];
        axis[0] = b->drain.drain->x[edge[0]];
        axis[1] = b->drain.drain->x[edge[1]];
    } else {
        vbss_scene_transform_capsule(&s->capsules[b->rigid.first_capsule + feature],
                                     b->rigid.body.now.pose, axis);
    }
    return true;
}

void vbss_scene_transform_trial_capsule(scene_capsule *capsule, pose at)
{
    capsule->trial[0] = pose_apply(at, capsule->local_trial[0]);
    capsule->trial[1] = pose_apply(at, capsule->local_trial[1]);
}

void vbss_scene_snap_capsule_to_target(scene_capsule *capsule)
{
    for (int k = 0; k < 2; k++) {
        capsule->local[k] = capsule->local_trial[k] = capsule->local_end[k];
    }
}

/* ---- leaving */

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

vbss_result vbss_scene_remove(vbss_scene *scene, uint32_t body)
{
    scene_object *s;
    VBSS_TRY(vbss_scene_open_for_edit(scene, &s));
    scene_body *b = vbss_scene_body(s, body);
    if (b == NULL) {
        return vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE, "the scene has no body %u", body);
    }
    vbss_scene_remove_pins_of(s, body);
    vbss_scene_remove_thread_grasps_of(s, body);
    vbss_scene_remove_needle_grasps_of(s, body);
    vbss_scene_remove_wall_grasps_of(s, body);
    vbss_scene_remove_holes_of(s, body);
    vbss_scene_paper_forget_toggles_of(s, body);
    if (b->kind == SCENE_BODY_DRAIN) {
        vbss_scene_disown_drain(s, b);
    }
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
    vbss_scene_number_nodes(s);
    s->pattern_hash = 0;
    s->generation++;
    return VBSS_OK;
}

/* ---- moving and looking */

static scene_body *find_rigid(const scene_object *s, uint32_t number)
{
    return vbss_scene_require_body(s, number, SCENE_BODY_RIGID);
}

void vbss_scene_apply_rigid_targets(scene_object *s)
{
    bool any = false;
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_rigid *r = &s->bodies[i].rigid;
        if (s->bodies[i].kind == SCENE_BODY_RIGID && r->has_pending_target) {
            r->body.target_end = r->pending_target;
            r->has_pending_target = false;
            any = true;
        }
    }
    if (any) {
        vbss_scene_set_pin_targets(s);
    }
}

void vbss_scene_set_rigid_target(scene_object *s, scene_rigid *r, pose target)
{
    r->pending_target = target;
    r->has_pending_target = true;
    if (!s->cursor.is_suspended) {
        vbss_scene_apply_rigid_targets(s); /* a step that fails shall find nothing to undo */
    }
}

vbss_result vbss_scene_move_rigid(vbss_scene *scene, uint32_t body, const double position[3],
                                  const double *orientation)
{
    scene_object *s;
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    VBSS_TRY(vbss_check_pointer(s->context, position, "position"));
    scene_body *b = find_rigid(s, body);
    if (b == NULL) {
        return VBSS_ERROR_OUT_OF_RANGE;
    }
    scene_rigid *r = &b->rigid;
    pose previous = r->has_pending_target ? r->pending_target : r->body.target_end,
         target = pose_mul(previous, pose_inverse(r->frame));
    if (r->grasper != NULL) {
        return vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE,
                         "body %u is a grasper: it goes where vbss_grasper_move says", body);
    }
    if (r->kind == VBSS_RIGID_FREE) {
        return vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE, "body %u is free", body);
    }
    VBSS_TRY(vbss_check_vector(s->context, position, 1e3, "position"));
    if (orientation != NULL) {
        VBSS_TRY(vbss_read_orientation(s->context, orientation, &target.orientation));
    }
    target.position = vec3_load(position);
    target = pose_mul(target, r->frame);
    if (orientation == NULL) { /* to the bit: rounding would turn it */
        target.orientation = previous.orientation;
    }
    vbss_scene_set_rigid_target(s, r, target);
    s->generation++;
    return VBSS_OK;
}

vbss_result vbss_scene_get_rigid(vbss_scene *scene, uint32_t body, vbss_rigid_state *state,
                                 uint32_t struct_size)
{
    scene_object *s;
    VBSS_TRY(vbss_scene_open(scene, &s));
    const scene_body *b = find_rigid(s, body);
    if (b == NULL) {
        return VBSS_ERROR_OUT_OF_RANGE;
    }
    const scene_rigid *r = &b->rigid;
    vbss_rigid_state own = {.struct_size = sizeof own, .kind = r->kind};
    pose back = pose_inverse(r->frame), at = pose_mul(r->body.now.pose, back);
    vec3 to_centre = vec3_sub(r->body.now.pose.position, at.position);
    vec3 hand = r->kind == VBSS_RIGID_DRIVEN ? r->force : vec3_neg(r->coupling_wrench.force);
    vec3 turn = r->kind == VBSS_RIGID_DRIVEN ? r->torque : vec3_neg(r->coupling_wrench.torque);
    pose_store(at, own.position, own.orientation);
    pose_store(pose_mul(r->has_pending_target ? r->pending_target : r->body.target_end, back),
               own.target_position, own.target_orientation);
    vec3_store(own.velocity, vec3_sub(r->body.now.v, vec3_cross(r->body.now.w, to_centre)));
    vec3_store(own.angular_velocity, r->body.now.w);
    vec3_store(own.hand_force, hand);
    vec3_store(own.hand_torque, vec3_add(turn, vec3_cross(to_centre, hand)));
    vec3_store(own.contact_force, r->force);
    vec3_store(own.contact_torque, vec3_add(r->torque, vec3_cross(to_centre, r->force)));
    return vbss_struct_write(s->context, &state_layout, &own, state, struct_size);
}
