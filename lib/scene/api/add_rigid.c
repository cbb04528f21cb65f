/* Adds a rigid body to a scene, with its mass spread over its capsules. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "scene/api/api.h"
#include "scene/api/overlap.h"
#include "scene/api/place.h"
#include "scene/world/world.h"

_Static_assert(sizeof(vbss_scene_rigid_config) ==
                   VBSS_SIZE_WITH_POINTERS(vbss_scene_rigid_config, 192u, 1u),
               "published size");
_Static_assert(sizeof(vbss_scene_capsule) == 56, "published size");

static const vbss_scene_rigid_config rigid_defaults = {
    .struct_size = sizeof(vbss_scene_rigid_config),
    .kind = VBSS_SCENE_RIGID_DRIVEN,
    .orientation = {1.0, 0.0, 0.0, 0.0},
    .mass = 0.02,
    .friction = 0.15,
    .stiffness = 2000.0,
    .damping = 5.0,
    .turning_stiffness = 2.0,
    .turning_damping = 0.005,
};
static const uint32_t rigid_sizes[] = {VBSS_SIZE_WITH_POINTERS(vbss_scene_rigid_config, 192u, 1u),
                                       0};
static const vbss_layout rigid_layout = {"vbss_scene_rigid_config", &rigid_defaults, rigid_sizes};

vbss_result vbss_scene_rigid_config_init(vbss_scene_rigid_config *config, uint32_t struct_size)
{
    return vbss_config_init(&rigid_layout, config, struct_size);
}

static vbss_result check_capsule(vbss_context *context, const vbss_scene_capsule *c)
{
    VBSS_TRY(vbss_check_finite(context, c->begin, 3, "begin of a capsule"));
    VBSS_TRY(vbss_check_finite(context, c->end, 3, "end of a capsule"));
    VBSS_TRY(vbss_check_range(context, vbss_max_abs(c->begin, 3), 0.0, 1e3, "begin of a capsule"));
    VBSS_TRY(vbss_check_range(context, vbss_max_abs(c->end, 3), 0.0, 1e3, "end of a capsule"));
    return vbss_check_range(context, c->radius, 1e-6, 1.0, "radius of a capsule");
}

static void warn_of_units(vbss_context *context, const vbss_scene_rigid_config *c)
{
    double farthest = 0.0, thickest = 0.0;
    for (uint32_t i = 0; i < c->capsule_count; i++) {
        const vbss_scene_capsule *p = &c->capsules[i];
        farthest = vbss_max(farthest, vbss_max(vbss_max_abs(p->begin, 3), vbss_max_abs(p->end, 3)));
        thickest = vbss_max(thickest, p->radius);
    }
    vbss_warn_if_unlikely(context, farthest, VBSS_LIKELY_LENGTH, "a coordinate of a capsule", "m",
                          "mm");
    vbss_warn_if_unlikely(context, thickest, VBSS_LIKELY_RADIUS, "radius of a capsule", "m", "mm");
    vbss_warn_if_unlikely(context, vbss_max_abs(c->gravity, 3), VBSS_LIKELY_GRAVITY, "gravity",
                          "m/s^2", "mm/s^2");
}

vbss_result vbss_scene_check_rigid_motion(vbss_context *context, const vbss_scene_rigid_config *c)
{
    VBSS_TRY(
        vbss_check_range(context, c->kind, VBSS_SCENE_RIGID_DRIVEN, VBSS_SCENE_RIGID_FREE, "kind"));
    VBSS_TRY(vbss_check_range(context, c->reserved, 0.0, 0.0, "reserved"));
    VBSS_TRY(vbss_check_vector(context, c->position, 1e3, "position"));
    VBSS_TRY(vbss_check_vector(context, c->velocity, 1e5, "velocity"));
    VBSS_TRY(vbss_check_vector(context, c->angular_velocity, 1e6, "angular_velocity"));
    VBSS_TRY(vbss_check_vector(context, c->gravity, 1e6, "gravity"));
    VBSS_TRY(vbss_check_range(context, c->mass, 1e-9, 1e3, "mass"));
    VBSS_TRY(vbss_check_range(context, c->friction, 0.0, 10.0, "friction"));
    VBSS_TRY(vbss_check_range(context, c->stiffness, 0.0, 1e9, "stiffness"));
    VBSS_TRY(vbss_check_range(context, c->damping, 0.0, 1e6, "damping"));
    VBSS_TRY(vbss_check_range(context, c->turning_stiffness, 0.0, 1e9, "turning_stiffness"));
    return vbss_check_range(context, c->turning_damping, 0.0, 1e6, "turning_damping");
}

static vbss_result check_rigid(const scene_object *s, const vbss_scene_rigid_config *c)
{
    vbss_context *context = s->context;
    VBSS_TRY(
        vbss_check_range(context, c->kind, VBSS_SCENE_RIGID_DRIVEN, VBSS_SCENE_RIGID_FREE, "kind"));
    VBSS_TRY(vbss_check_range(context, c->capsule_count, 1.0, 256.0, "capsule_count"));
    VBSS_TRY(vbss_check_range(context, c->reserved, 0.0, 0.0, "reserved"));
    VBSS_TRY(vbss_check_pointer(context, c->capsules, "capsules"));
    VBSS_TRY(vbss_scene_check_rigid_motion(context, c));
    for (uint32_t i = 0; i < c->capsule_count; i++) {
        VBSS_TRY(check_capsule(context, &c->capsules[i]));
    }
    return vbss_scene_check_capsule_room(s, c->capsule_count);
}

/* Computes mass and inertia as if the capsules were solid and of one material. */
static vbss_result distribute_mass(const scene_object *s, const vbss_scene_rigid_config *c,
                                   vbss_rigid_mass *mass)
{
    for (uint32_t i = 0; i < c->capsule_count; i++) {
        const vbss_scene_capsule *from = &c->capsules[i];
        s->scratch.mass_capsules[i] = (vbss_rigid_capsule){
            vec3_load(from->begin), vec3_load(from->end), from->radius, 1000.0};
    }
    if (!vbss_rigid_mass_of_capsules(s->scratch.mass_capsules, c->capsule_count, mass)) {
        return vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE, "the capsules have no mass");
    }
    mass->inertia = vec3_scale(mass->inertia, c->mass / mass->mass);
    mass->mass = c->mass;
    return VBSS_OK;
}

void vbss_scene_init_rigid(scene_rigid *r, const vbss_scene_rigid_config *c,
                           const vbss_rigid_mass *mass, quat orientation)
{
    pose at = pose_mul(pose_make(vec3_load(c->position), orientation), mass->frame);
    vec3 w = vec3_load(c->angular_velocity);
    vec3 arm = quat_rotate(orientation, mass->frame.position);
    *r = (scene_rigid){.kind = c->kind,
                       .frame = mass->frame,
                       .capsule_count = c->capsule_count,
                       .friction = c->friction,
                       .created_friction = c->friction};
    r->body.mass = mass->mass;
    r->body.inertia = mass->inertia;
    r->body.gravity = vec3_load(c->gravity);
    r->body.now.pose = r->body.target_start = r->body.target_end = r->trial = at;
    if (c->kind == VBSS_SCENE_RIGID_COUPLED) {
        const vbss_rigid_coupling coupling = {c->stiffness, c->damping, c->turning_stiffness,
                                              c->turning_damping};
        r->body.coupling = coupling;
    }
    if (c->kind != VBSS_SCENE_RIGID_DRIVEN) {
        r->body.now.v = vec3_add(vec3_load(c->velocity), vec3_cross(w, arm));
        r->body.now.w = w;
    }
}

/* Writes the capsules of a new body behind those of the others. */
static void write_capsules(scene_object *s, const scene_rigid *r, const vbss_scene_rigid_config *c)
{
    for (uint32_t i = 0; i < c->capsule_count; i++) {
        scene_capsule *to = &s->capsules[s->capsule_count + i];
        to->local_end[0] = pose_apply_inverse(r->frame, vec3_load(c->capsules[i].begin));
        to->local_end[1] = pose_apply_inverse(r->frame, vec3_load(c->capsules[i].end));
        to->radius = c->capsules[i].radius;
    }
}

vbss_result vbss_scene_place_rigid(scene_object *s, const scene_rigid *rigid, scene_body *b,
                                   uint32_t *body)
{
    uint32_t shape = 0;
    double radius = 0.0;
    scene_capsule *capsules = &s->capsules[s->capsule_count];
    for (uint32_t i = 0; i < rigid->capsule_count; i++) {
        radius = vbss_max(capsules[i].radius, radius);
    }
    VBSS_TRY(vbss_collision_add_capsules(scene_collision(s), rigid->capsule_count, radius, &shape));
    s->collision->shapes[shape]->is_rigid = true;
    *b = (scene_body){.rigid = *rigid};
    b->rigid.first_capsule = s->capsule_count;
    for (uint32_t i = 0; i < rigid->capsule_count; i++) {
        vbss_scene_snap_capsule_to_target(&capsules[i]);
        vbss_scene_transform_capsule(&capsules[i], rigid->body.now.pose, capsules[i].now);
    }
    s->capsule_count += rigid->capsule_count;
    vbss_scene_register_body(s, b, SCENE_BODY_RIGID, shape, body);
    vbss_scene_list_overlaps_of(s, b);
    return VBSS_OK;
}

/* Everything that a new body needs, computed before anything changes. */
typedef struct new_rigid {
    vbss_scene_rigid_config config;
    vbss_rigid_mass mass;
    quat orientation;
} new_rigid;

vbss_result vbss_scene_read_rigid_config(vbss_context *context,
                                         const vbss_scene_rigid_config *config,
                                         vbss_scene_rigid_config *own)
{
    return vbss_config_read(context, &rigid_layout, config, own);
}

static vbss_result read_rigid(const scene_object *s, const vbss_scene_rigid_config *config,
                              new_rigid *read)
{
    VBSS_TRY(vbss_config_read(s->context, &rigid_layout, config, &read->config));
    VBSS_TRY(check_rigid(s, &read->config));
    VBSS_TRY(vbss_read_orientation(s->context, read->config.orientation, &read->orientation));
    VBSS_TRY(distribute_mass(s, &read->config, &read->mass));
    return VBSS_OK;
}

static vbss_result add_rigid(scene_object *s, const new_rigid *added, uint32_t *body)
{
    const vbss_scene_rigid_config *c = &added->config;
    const scene_outline outline = {.capsules = c,
                                   .at = pose_make(vec3_load(c->position), added->orientation),
                                   .is_prescribed = c->kind == VBSS_SCENE_RIGID_DRIVEN};
    VBSS_TRY(vbss_scene_check_overlap(s, &outline, "rigid body"));
    scene_body *b;
    VBSS_TRY(vbss_scene_find_free_body(s, SCENE_BODY_RIGID, &b));
    scene_rigid rigid;
    vbss_scene_init_rigid(&rigid, c, &added->mass, added->orientation);
    write_capsules(s, &rigid, c);
    return vbss_scene_place_rigid(s, &rigid, b, body);
}

vbss_result vbss_scene_add_rigid(vbss_scene *scene, const vbss_scene_rigid_config *config,
                                 uint32_t *body)
{
    VBSS_ENTER(scene);
    scene_object *s;
    new_rigid added;
    scene_edit edit;
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    VBSS_TRY(vbss_check_pointer(s->context, body, "body"));
    VBSS_TRY(read_rigid(s, config, &added));
    scene_body *entry;
    VBSS_TRY(vbss_scene_find_free_body(s, SCENE_BODY_RIGID, &entry));
    warn_of_units(s->context, &added.config);
    vbss_edit input = {.kind = VBSS_EDIT_OTHER};
    VBSS_TRY(vbss_scene_begin_edit(scene, &input, &edit));
    return vbss_scene_end_edit(&edit, add_rigid(s, &added, body));
}
