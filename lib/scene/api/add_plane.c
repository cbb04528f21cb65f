/* Adds a plane to a scene: a driven rigid body without capsules. Its collision shape takes part in no
 * search. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "scene/api/api.h"
#include "scene/api/overlap.h"
#include "scene/api/place.h"
#include "scene/world/world.h"

_Static_assert(sizeof(vbss_scene_plane_config) == 48, "published size");

static const vbss_scene_plane_config plane_defaults = {
    .struct_size = sizeof(vbss_scene_plane_config),
    .normal = {0.0, 1.0, 0.0},
    .friction = 0.3,
};
static const uint32_t plane_sizes[] = {48, 0};
static const vbss_layout plane_layout = {"vbss_scene_plane_config", &plane_defaults, plane_sizes};

/* By how much the length of a saved normal may differ from 1.
 * Unit: relative. Origin: chosen, far above rounding. Test: scene.planes. */
#define UNIT_TOLERANCE 1e-12
/* Radius of the shape that takes part in no search. Unit: m. Origin: chosen. Test: scene.planes. */
#define UNUSED_RADIUS 1e-3

vbss_result vbss_scene_plane_config_init(vbss_scene_plane_config *config, uint32_t struct_size)
{
    return vbss_config_init(&plane_layout, config, struct_size);
}

static vbss_result check_plane(vbss_context *context, const vbss_scene_plane_config *c)
{
    VBSS_TRY(vbss_check_range(context, c->reserved, 0.0, 0.0, "reserved"));
    VBSS_TRY(vbss_check_finite(context, c->normal, 3, "normal"));
    VBSS_TRY(vbss_check_range(context, vec3_norm(vec3_load(c->normal)), 1e-100, 1e100,
                              "length of normal"));
    VBSS_TRY(vbss_check_range(context, c->height, -1e3, 1e3, "height"));
    return vbss_check_range(context, c->friction, 0.0, 10.0, "friction");
}

bool vbss_scene_is_plane_valid(const scene_plane_description *plane)
{
    const double length = vec3_norm(plane->plane.normal);
    return fabs(length - 1.0) <= UNIT_TOLERANCE && fabs(plane->plane.height) <= 1e3 &&
           plane->friction >= 0.0 && plane->friction <= 10.0;
}

vbss_result vbss_scene_place_plane(scene_object *s, const scene_plane_description *plane,
                                   scene_body *b, uint32_t *body)
{
    const pose origin = pose_make(vec3_zero(), quat_identity());
    uint32_t shape = 0;
    VBSS_TRY(vbss_collision_add_disabled_chain(s->collision, 2, UNUSED_RADIUS, &shape));
    scene_rigid rigid = {.kind = VBSS_SCENE_RIGID_DRIVEN,
                         .frame = origin,
                         .trial = origin,
                         .first_capsule = s->capsule_count,
                         .friction = plane->friction,
                         .created_friction = plane->friction,
                         .is_plane = true,
                         .plane = plane->plane};
    rigid.body.mass = 1.0; /* a driven body needs some; it has no effect */
    rigid.body.inertia = vec3_make(1.0, 1.0, 1.0);
    rigid.body.now.pose = rigid.body.target_start = rigid.body.target_end = origin;
    *b = (scene_body){.rigid = rigid};
    vbss_scene_register_body(s, b, SCENE_BODY_RIGID, shape, body);
    return VBSS_OK;
}

static vbss_result add_plane(scene_object *s, const scene_plane_description *plane, uint32_t *body)
{
    const scene_outline outline = {.plane = &plane->plane, .is_prescribed = true};
    VBSS_TRY(vbss_scene_check_overlap(s, &outline, "plane"));
    scene_body *b;
    VBSS_TRY(vbss_scene_find_free_body(s, SCENE_BODY_RIGID, &b));
    return vbss_scene_place_plane(s, plane, b, body);
}

vbss_result vbss_scene_add_plane(vbss_scene *scene, const vbss_scene_plane_config *config,
                                 uint32_t *body)
{
    VBSS_ENTER(scene);
    scene_object *s;
    vbss_scene_plane_config own;
    scene_edit edit;
    scene_body *entry;
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    VBSS_TRY(vbss_check_pointer(s->context, body, "body"));
    VBSS_TRY(vbss_config_read(s->context, &plane_layout, config, &own));
    if (s->config.method != VBSS_METHOD_IMPLICIT) {
        return vbss_fail(s->context, VBSS_ERROR_INCOMPATIBLE,
                         "only scenes of method IMPLICIT have further planes");
    }
    VBSS_TRY(check_plane(s->context, &own));
    VBSS_TRY(vbss_scene_find_free_body(s, SCENE_BODY_RIGID, &entry));
    vbss_warn_if_unlikely(s->context, fabs(own.height), VBSS_LIKELY_LENGTH, "height", "m", "mm");
    const scene_plane_description plane = {
        {vec3_unit_or(vec3_load(own.normal), vec3_make(0.0, 1.0, 0.0)), own.height}, own.friction};
    vbss_edit input = {.kind = VBSS_EDIT_OTHER};
    VBSS_TRY(vbss_scene_begin_edit(scene, &input, &edit));
    return vbss_scene_end_edit(&edit, add_plane(s, &plane, body));
}
