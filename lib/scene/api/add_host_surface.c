/* Adds a host surface to a scene: a driven rigid body without capsules, whose collision shape has the
 * triangles. It is placed as a static mesh that then gets a motion. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "base/stream.h"
#include "scene/api/api.h"
#include "scene/api/overlap.h"
#include "scene/api/place.h"
#include "scene/solve/solve.h"
#include "scene/world/world.h"

_Static_assert(sizeof(vbss_scene_surface_config) ==
                   VBSS_SIZE_WITH_POINTERS(vbss_scene_surface_config, 112u, 2u),
               "published size");

static const vbss_scene_surface_config surface_defaults = {
    .struct_size = sizeof(vbss_scene_surface_config),
    .friction = 0.15,
    .thickness = 0.5e-3,
    .jump_limit = 20e-3,
    .hole_force = 0.25,
    .hole_friction = 0.3,
    .hole_stiffness = 2e4,
    .hole_damping = 0.05,
    .tip_length = 0.5e-3,
    .thread_force = 0.02,
};
static const uint32_t surface_sizes[] = {
    VBSS_SIZE_WITH_POINTERS(vbss_scene_surface_config, 48u, 2u),
    VBSS_SIZE_WITH_POINTERS(vbss_scene_surface_config, 104u, 2u),
    VBSS_SIZE_WITH_POINTERS(vbss_scene_surface_config, 112u, 2u), 0};
static const vbss_layout surface_layout = {"vbss_scene_surface_config", &surface_defaults,
                                           surface_sizes};

vbss_result vbss_scene_surface_config_init(vbss_scene_surface_config *config, uint32_t struct_size)
{
    return vbss_config_init(&surface_layout, config, struct_size);
}

static vbss_scene_static_mesh_config mesh_of(const vbss_scene_surface_config *c)
{
    vbss_scene_static_mesh_config mesh = vbss_scene_static_mesh_config_default();
    mesh.vertex_count = c->vertex_count;
    mesh.triangle_count = c->triangle_count;
    mesh.one_sided = c->one_sided;
    mesh.vertices = c->vertices;
    mesh.triangles = c->triangles;
    mesh.friction = c->friction;
    mesh.thickness = c->thickness;
    return mesh;
}

static scene_outline outline_of(const vbss_scene_surface_config *c)
{
    return (scene_outline){.surface = {(const vec3 *)(const void *)c->vertices,
                                       (const uint32_t(*)[3])(const void *)c->triangles,
                                       c->triangle_count, 0.5 * c->thickness, false},
                           .is_prescribed = true};
}

static vbss_result check_holes(vbss_context *context, const vbss_scene_surface_config *c)
{
    if (c->puncture_force != 0.0) {
        VBSS_TRY(vbss_check_range(context, c->puncture_force, 1e-3, 1e3, "puncture_force"));
    }
    VBSS_TRY(vbss_check_range(context, c->hole_force, 1e-6, 1e3, "hole_force"));
    VBSS_TRY(vbss_check_range(context, c->hole_friction, 0.0, 10.0, "hole_friction"));
    VBSS_TRY(vbss_check_range(context, c->hole_stiffness, 1.0, 1e7, "hole_stiffness"));
    VBSS_TRY(vbss_check_range(context, c->hole_damping, 0.0, 1e3, "hole_damping"));
    VBSS_TRY(vbss_check_range(context, c->tip_length, 0.0, 0.1, "tip_length"));
    if (c->tear_energy != 0.0) {
        VBSS_TRY(vbss_check_range(context, c->tear_energy, 1.0, 1e7, "tear_energy"));
    }
    return vbss_check_range(context, c->thread_force, 1e-6, 1e3, "thread_force");
}

vbss_result vbss_scene_check_host_surface(vbss_context *context, const vbss_scene_surface_config *c)
{
    const vbss_scene_static_mesh_config mesh = mesh_of(c);
    VBSS_TRY(vbss_scene_check_static_mesh(context, &mesh));
    VBSS_TRY(vbss_check_range(context, c->jump_limit, 1e-6, 1e3, "jump_limit"));
    VBSS_TRY(check_holes(context, c));
    if (c->one_sided != 0) {
        return vbss_fail(context, VBSS_ERROR_OUT_OF_RANGE,
                         "one_sided is %u: a host surface has two sides", c->one_sided);
    }
    if (c->compliance_size != 0 && c->compliance_size != 1 && c->compliance_size != 9) {
        return vbss_fail(context, VBSS_ERROR_OUT_OF_RANGE, "compliance_size is %u, not 0, 1 or 9",
                         c->compliance_size);
    }
    uint32_t thin = 0;
    const scene_surface surface = outline_of(c).surface;
    return vbss_scene_keeps_triangles(surface.triangles, surface.triangle_count, surface.vertices,
                                      surface.vertices, &thin)
               ? VBSS_OK
               : vbss_fail(context, VBSS_ERROR_OUT_OF_RANGE, "triangle %u has no area", thin);
}

static bool has_default_holes(const vbss_drain_config *law)
{
    const vbss_scene_surface_config *d = &surface_defaults;
    return law->puncture_force == d->puncture_force && law->hole_force == d->hole_force &&
           law->hole_friction == d->hole_friction && law->hole_stiffness == d->hole_stiffness &&
           law->hole_damping == d->hole_damping && law->tip_length == d->tip_length &&
           law->thread_force == d->thread_force;
}

/* Another hash than that of a static mesh: positions are state. The parameters of holes count if they are not
 * the defaults, which older snapshots have. */
uint64_t vbss_scene_hash_host_surface(const scene_host_surface *h, const scene_static_mesh *mesh)
{
    vbss_stream stream;
    uint64_t topology = h->shape->topology_hash;
    uint32_t one_sided = mesh->is_one_sided ? 1 : 0;
    vbss_stream_begin_hash(&stream);
    vbss_stream_u64(&stream, 1, &topology, 1);
    vbss_stream_u32(&stream, 2, &one_sided, 1);
    vbss_drain_config holes = h->law;
    if (!has_default_holes(&h->law)) {
        vbss_scene_visit_hole_parameters(&stream, 3, &holes);
    }
    if (h->law.tear_energy > 0.0) {
        vbss_stream_f64(&stream, 4, &holes.tear_energy, 1);
    }
    return vbss_hash_end(&stream.hash);
}

vbss_result vbss_scene_place_host_surface(scene_object *s, const vbss_scene_surface_config *c,
                                          scene_body *b, uint32_t *body)
{
    const vbss_scene_static_mesh_config mesh = mesh_of(c);
    scene_rigid motion = {.surface = NULL};
    VBSS_TRY(vbss_scene_create_host_surface(s, &motion, c));
    const uint32_t blocks = vbss_scene_surface_blocks(motion.surface);
    vbss_result result = blocks > 0 ? vbss_scene_create_system(s, NULL, blocks) : VBSS_OK;
    if (result == VBSS_OK) {
        result = vbss_scene_place_static_mesh(s, &mesh, b, body);
    }
    if (result != VBSS_OK) {
        vbss_scene_release_host_surface(s, &motion);
        return result;
    }
    collision_shape *shape = s->collision->shapes[b->shape];
    shape->is_static = false;
    motion.surface->shape = shape;
    b->rigid.is_static_mesh = false;
    b->rigid.surface = motion.surface;
    b->rigid.mesh.geometry_hash = vbss_scene_hash_host_surface(motion.surface, &b->rigid.mesh);
    return VBSS_OK;
}

static vbss_result add_surface(scene_object *s, const vbss_scene_surface_config *c, uint32_t *body)
{
    const scene_outline outline = outline_of(c);
    VBSS_TRY(vbss_scene_check_overlap(s, &outline, "host surface"));
    scene_body *b;
    VBSS_TRY(vbss_scene_find_free_body(s, SCENE_BODY_RIGID, &b));
    return vbss_scene_place_host_surface(s, c, b, body);
}

vbss_result vbss_scene_add_surface(vbss_scene *scene, const vbss_scene_surface_config *config,
                                   uint32_t *body)
{
    VBSS_ENTER(scene);
    scene_object *s;
    vbss_scene_surface_config own;
    scene_edit edit;
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    VBSS_TRY(vbss_check_pointer(s->context, body, "body"));
    VBSS_TRY(vbss_config_read(s->context, &surface_layout, config, &own));
    if (s->config.method != VBSS_METHOD_IMPLICIT) {
        return vbss_fail(s->context, VBSS_ERROR_INCOMPATIBLE,
                         "only scenes of method IMPLICIT have host surfaces");
    }
    VBSS_TRY(vbss_scene_check_host_surface(s->context, &own));
    scene_body *entry;
    VBSS_TRY(vbss_scene_find_free_body(s, SCENE_BODY_RIGID, &entry));
    vbss_warn_if_unlikely(s->context, vbss_max_abs(own.vertices, 3 * (size_t)own.vertex_count),
                          VBSS_LIKELY_LENGTH, "a coordinate of vertices", "m", "mm");
    vbss_edit input = {.kind = VBSS_EDIT_OTHER};
    VBSS_TRY(vbss_scene_begin_edit(scene, &input, &edit));
    return vbss_scene_end_edit(&edit, add_surface(s, &own, body));
}
