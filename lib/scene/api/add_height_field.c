/* Adds a height field to a scene: a static mesh with two triangles a cell. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "base/memory.h"
#include "scene/api/api.h"
#include "scene/api/place.h"

_Static_assert(sizeof(vbss_scene_height_field_config) ==
                   VBSS_SIZE_WITH_POINTERS(vbss_scene_height_field_config, 112u, 1u),
               "published size");

static const vbss_scene_height_field_config field_defaults = {
    .struct_size = sizeof(vbss_scene_height_field_config),
    .spacing = {1e-3, 1e-3},
    .orientation = {1.0, 0.0, 0.0, 0.0},
    .friction = 0.15,
    .thickness = 0.5e-3,
};
static const uint32_t field_sizes[] = {
    VBSS_SIZE_WITH_POINTERS(vbss_scene_height_field_config, 112u, 1u), 0};
static const vbss_layout field_layout = {"vbss_scene_height_field_config", &field_defaults,
                                         field_sizes};

vbss_result vbss_scene_height_field_config_init(vbss_scene_height_field_config *config,
                                                uint32_t struct_size)
{
    return vbss_config_init(&field_layout, config, struct_size);
}

/* The mesh has its own checks. */
static vbss_result check_field(vbss_context *context, const vbss_scene_height_field_config *c)
{
    VBSS_TRY(vbss_check_range(context, c->reserved, 0.0, 0.0, "reserved"));
    VBSS_TRY(vbss_check_range(context, c->column_count, 2.0, 32768.0, "column_count"));
    VBSS_TRY(vbss_check_range(context, c->row_count, 2.0, 32768.0, "row_count"));
    VBSS_TRY(
        vbss_check_range(context, c->height_count, 4.0, SCENE_MAX_MESH_VERTICES, "height_count"));
    if ((uint64_t)c->column_count * c->row_count != c->height_count) {
        return vbss_fail(context, VBSS_ERROR_OUT_OF_RANGE,
                         "height_count is %u, not %u columns times %u rows", c->height_count,
                         c->column_count, c->row_count);
    }
    VBSS_TRY(vbss_check_pointer(context, c->heights, "heights"));
    VBSS_TRY(vbss_check_finite(context, c->heights, c->height_count, "heights"));
    VBSS_TRY(vbss_check_range(context, vbss_max_abs(c->heights, c->height_count), 0.0, 1e3,
                              "largest magnitude of heights"));
    VBSS_TRY(vbss_check_range(context, c->spacing[0], 1e-6, 1e3, "spacing of columns"));
    VBSS_TRY(vbss_check_range(context, c->spacing[1], 1e-6, 1e3, "spacing of rows"));
    return vbss_check_vector(context, c->position, 1e3, "position");
}

static void write_mesh(const vbss_scene_height_field_config *c, pose at, double *vertices,
                       uint32_t *triangles)
{
    for (uint32_t i = 0; i < c->height_count; i++) {
        const uint32_t column = i % c->column_count, row = i / c->column_count;
        const vec3 local = vec3_make(column * c->spacing[0], c->heights[i], row * c->spacing[1]);
        vec3_store(vertices + 3 * (size_t)i, pose_apply(at, local));
    }
    for (uint32_t row = 0; row + 1 < c->row_count; row++) {
        for (uint32_t column = 0; column + 1 < c->column_count; column++, triangles += 6) {
            const uint32_t a = row * c->column_count + column, b = a + c->column_count;
            triangles[0] = triangles[3] = a;
            triangles[1] = b;
            triangles[2] = triangles[4] = b + 1;
            triangles[5] = a + 1;
        }
    }
}

static vbss_result add_field(vbss_scene *scene, scene_object *s,
                             const vbss_scene_height_field_config *c, pose at, uint32_t *body)
{
    double *vertices;
    uint32_t *triangles;
    const uint32_t triangle_count = 2 * (c->column_count - 1) * (c->row_count - 1);
    const vbss_array arrays[] = {{&vertices, 3 * (size_t)c->height_count, sizeof *vertices},
                                 {&triangles, 3 * (size_t)triangle_count, sizeof *triangles}};
    VBSS_TRY(vbss_allocate_arrays(s->context, arrays, 2, "height field"));
    write_mesh(c, at, vertices, triangles);
    vbss_scene_static_mesh_config mesh = vbss_scene_static_mesh_config_default();
    mesh.vertex_count = c->height_count;
    mesh.triangle_count = triangle_count;
    mesh.vertices = vertices;
    mesh.triangles = triangles;
    mesh.one_sided = c->one_sided;
    mesh.friction = c->friction;
    mesh.thickness = c->thickness;
    const vbss_result result = vbss_scene_add_checked_mesh(scene, s, &mesh, body);
    vbss_release_arrays(s->context, arrays, 2);
    return result;
}

vbss_result vbss_scene_add_height_field(vbss_scene *scene,
                                        const vbss_scene_height_field_config *config,
                                        uint32_t *body)
{
    VBSS_ENTER(scene);
    scene_object *s;
    vbss_scene_height_field_config own;
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
