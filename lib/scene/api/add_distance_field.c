/* Adds a distance field to a scene: a static mesh of the surface that half the thickness is inside of distance zero. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "base/memory.h"
#include "scene/api/api.h"
#include "scene/api/place.h"
#include "scene/api/surface_net.h"

_Static_assert(sizeof(vbss_scene_distance_field_config) ==
                   VBSS_SIZE_WITH_POINTERS(vbss_scene_distance_field_config, 120u, 1u),
               "published size");

static const vbss_scene_distance_field_config field_defaults = {
    .struct_size = sizeof(vbss_scene_distance_field_config),
    .one_sided = 1,
    .spacing = {1e-3, 1e-3, 1e-3},
    .orientation = {1.0, 0.0, 0.0, 0.0},
    .friction = 0.15,
    .thickness = 0.5e-3,
};
static const uint32_t field_sizes[] = {
    VBSS_SIZE_WITH_POINTERS(vbss_scene_distance_field_config, 120u, 1u), 0};
static const vbss_layout field_layout = {"vbss_scene_distance_field_config", &field_defaults,
                                         field_sizes};

vbss_result vbss_scene_distance_field_config_init(vbss_scene_distance_field_config *config,
                                                  uint32_t struct_size)
{
    return vbss_config_init(&field_layout, config, struct_size);
}

/* The mesh has its own checks. */
static vbss_result check_field(vbss_context *context, const vbss_scene_distance_field_config *c)
{
    uint64_t samples = 1;
    for (int k = 0; k < 3; k++) {
        VBSS_TRY(vbss_check_range(context, c->counts[k], 2.0, 2048.0, "an entry of counts"));
        VBSS_TRY(vbss_check_range(context, c->spacing[k], 1e-6, 1e3, "an entry of spacing"));
        samples *= c->counts[k];
    }
    if (samples != c->distance_count) {
        return vbss_fail(context, VBSS_ERROR_OUT_OF_RANGE,
                         "distance_count is %u, not the product of the counts, %llu",
                         c->distance_count, (unsigned long long)samples);
    }
    VBSS_TRY(vbss_check_range(context, c->thickness, 2e-6, 0.2, "thickness"));
    VBSS_TRY(vbss_check_pointer(context, c->distances, "distances"));
    VBSS_TRY(vbss_check_finite(context, c->distances, c->distance_count, "distances"));
    return vbss_check_vector(context, c->position, 1e3, "position");
}

static vbss_result count_triangles(vbss_context *context, const scene_sampled_field *field,
                                   uint32_t *layers, scene_surface_net *net)
{
    VBSS_TRY(vbss_scene_find_surface_net(context, field, layers, net));
    if (net->triangle_count == 0) {
        return vbss_fail(context, VBSS_ERROR_OUT_OF_RANGE,
                         "no distance is half the thickness, %g m, inside of the surface",
                         -field->level);
    }
    if (net->vertex_count > SCENE_MAX_MESH_VERTICES ||
        net->triangle_count > SCENE_MAX_MESH_TRIANGLES) {
        return vbss_fail(context, VBSS_ERROR_OUT_OF_RANGE,
                         "the surface has %u vertices and %u triangles, a mesh at most %u and %u",
                         net->vertex_count, net->triangle_count, SCENE_MAX_MESH_VERTICES,
                         SCENE_MAX_MESH_TRIANGLES);
    }
    return VBSS_OK;
}

static vbss_result add_surface(vbss_scene *scene, scene_object *s,
                               const vbss_scene_distance_field_config *c,
                               const scene_surface_net *net, uint32_t *body)
{
    vbss_scene_static_mesh_config mesh = vbss_scene_static_mesh_config_default();
    mesh.vertex_count = net->vertex_count;
    mesh.triangle_count = net->triangle_count;
    mesh.vertices = net->vertices;
    mesh.triangles = net->triangles;
    mesh.one_sided = c->one_sided;
    mesh.friction = c->friction;
    mesh.thickness = c->thickness;
    return vbss_scene_add_checked_mesh(scene, s, &mesh, body);
}

static vbss_result add_counted(vbss_scene *scene, scene_object *s,
                               const vbss_scene_distance_field_config *c,
                               const scene_sampled_field *field, uint32_t *layers,
                               scene_surface_net *net, pose at, uint32_t *body)
{
    const vbss_array arrays[] = {
        {&net->vertices, 3 * (size_t)net->vertex_count, sizeof *net->vertices},
        {&net->triangles, 3 * (size_t)net->triangle_count, sizeof *net->triangles}};
    VBSS_TRY(vbss_allocate_arrays(s->context, arrays, 2, "surface of a distance field"));
    vbss_result result = vbss_scene_find_surface_net(s->context, field, layers, net);
    for (uint32_t i = 0; i < net->vertex_count; i++) {
        double *x = net->vertices + 3 * (size_t)i;
        vec3_store(x, pose_apply(at, vec3_load(x)));
    }
    if (result == VBSS_OK) {
        result = add_surface(scene, s, c, net, body);
    }
    vbss_release_arrays(s->context, arrays, 2);
    return result;
}

static vbss_result add_field(vbss_scene *scene, scene_object *s,
                             const vbss_scene_distance_field_config *c, pose at, uint32_t *body)
{
    const scene_sampled_field field = {.values = c->distances,
                                       .counts = {c->counts[0], c->counts[1], c->counts[2]},
                                       .spacing = vec3_load(c->spacing),
                                       .level = -0.5 * c->thickness};
    const size_t count = 2 * (size_t)c->counts[0] * c->counts[1];
    scene_surface_net net = {.vertices = NULL};
    uint32_t *layers = vbss_allocate(s->context, count, sizeof *layers, "cells of a field");
    if (layers == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    vbss_result result = count_triangles(s->context, &field, layers, &net);
    if (result == VBSS_OK) {
        result = add_counted(scene, s, c, &field, layers, &net, at, body);
    }
    vbss_release(s->context, layers, count, sizeof *layers);
    return result;
}

vbss_result vbss_scene_add_distance_field(vbss_scene *scene,
                                          const vbss_scene_distance_field_config *config,
                                          uint32_t *body)
{
    VBSS_ENTER(scene);
    scene_object *s;
    vbss_scene_distance_field_config own;
    pose at;
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    VBSS_TRY(vbss_check_pointer(s->context, body, "body"));
    VBSS_TRY(vbss_config_read(s->context, &field_layout, config, &own));
    VBSS_TRY(vbss_scene_check_mesh_method(s));
    VBSS_TRY(check_field(s->context, &own));
    at.position = vec3_load(own.position);
    VBSS_TRY(vbss_read_orientation(s->context, own.orientation, &at.orientation));
    return add_field(scene, s, &own, at, body);
}
