/* Adds a static mesh to a scene: a driven rigid body without capsules, whose collision shape has the
 * vertices and triangles. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "base/stream.h"
#include "scene/api/api.h"
#include "scene/api/overlap.h"
#include "scene/api/place.h"
#include "scene/world/world.h"

#include <string.h>

_Static_assert(sizeof(vbss_scene_static_mesh_config) ==
                   VBSS_SIZE_WITH_POINTERS(vbss_scene_static_mesh_config, 32u, 2u),
               "published size");
_Static_assert(sizeof(vec3) == 3 * sizeof(double), "vertices are vectors");

static const vbss_scene_static_mesh_config mesh_defaults = {
    .struct_size = sizeof(vbss_scene_static_mesh_config),
    .friction = 0.15,
    .thickness = 0.5e-3,
};
static const uint32_t mesh_sizes[] = {
    VBSS_SIZE_WITH_POINTERS(vbss_scene_static_mesh_config, 32u, 2u), 0};
static const vbss_layout mesh_layout = {"vbss_scene_static_mesh_config", &mesh_defaults,
                                        mesh_sizes};

/* Category bit of the shapes of meshes in the collision object: they form no pairs with each other. The
 * filters of bodies are another matter (world/filters.c). Chosen. */
enum { MESH_CATEGORY = 2 };

void vbss_scene_set_mesh_category(collision_shape *shape)
{
    shape->category = MESH_CATEGORY;
    shape->mask = ~(uint32_t)MESH_CATEGORY;
}

vbss_result vbss_scene_read_mesh_config(vbss_context *context,
                                        const vbss_scene_static_mesh_config *config,
                                        vbss_scene_static_mesh_config *own)
{
    return vbss_config_read(context, &mesh_layout, config, own);
}

vbss_result vbss_scene_static_mesh_config_init(vbss_scene_static_mesh_config *config,
                                               uint32_t struct_size)
{
    return vbss_config_init(&mesh_layout, config, struct_size);
}

static vbss_result check_triangles(vbss_context *context, const vbss_scene_static_mesh_config *c)
{
    for (uint32_t i = 0; i < c->triangle_count; i++) {
        const uint32_t *n = c->triangles + 3 * (size_t)i;
        for (int k = 0; k < 3; k++) {
            if (n[k] >= c->vertex_count) {
                return vbss_fail(context, VBSS_ERROR_OUT_OF_RANGE,
                                 "triangle %u has vertex %u of %u", i, n[k], c->vertex_count);
            }
            if (n[k] == n[(k + 1) % 3]) {
                return vbss_fail(context, VBSS_ERROR_OUT_OF_RANGE,
                                 "triangle %u has vertex %u twice", i, n[k]);
            }
        }
    }
    return VBSS_OK;
}

vbss_result vbss_scene_check_static_mesh(vbss_context *context,
                                         const vbss_scene_static_mesh_config *c)
{
    VBSS_TRY(
        vbss_check_range(context, c->vertex_count, 3.0, SCENE_MAX_MESH_VERTICES, "vertex_count"));
    VBSS_TRY(vbss_check_range(context, c->triangle_count, 1.0, SCENE_MAX_MESH_TRIANGLES,
                              "triangle_count"));
    VBSS_TRY(vbss_check_range(context, c->one_sided, 0.0, 1.0, "one_sided"));
    VBSS_TRY(vbss_check_pointer(context, c->vertices, "vertices"));
    VBSS_TRY(vbss_check_pointer(context, c->triangles, "triangles"));
    VBSS_TRY(vbss_check_range(context, c->friction, 0.0, 10.0, "friction"));
    VBSS_TRY(vbss_check_range(context, c->thickness, 2e-6, 0.2, "thickness"));
    const size_t numbers = 3 * (size_t)c->vertex_count;
    VBSS_TRY(vbss_check_finite(context, c->vertices, numbers, "vertices"));
    VBSS_TRY(vbss_check_range(context, vbss_max_abs(c->vertices, numbers), 0.0, 1e3,
                              "largest coordinate of vertices"));
    return check_triangles(context, c);
}

uint64_t vbss_scene_hash_mesh(const collision_shape *shape, vec3 *vertices, bool is_one_sided)
{
    vbss_stream stream;
    uint64_t topology = shape->topology_hash;
    uint32_t one_sided = is_one_sided ? 1 : 0;
    vbss_stream_begin_hash(&stream);
    vbss_stream_u64(&stream, 1, &topology, 1);
    vbss_stream_f64(&stream, 2, &vertices->x, 3 * (size_t)shape->node_count);
    vbss_stream_u32(&stream, 3, &one_sided, 1);
    return vbss_hash_end(&stream.hash);
}

vbss_result vbss_scene_set_up_mesh(scene_object *s, const double *vertices, collision_shape *shape,
                                   scene_static_mesh *m)
{
    memcpy(shape->start, vertices, shape->node_count * sizeof *shape->start);
    memcpy(shape->end, vertices, shape->node_count * sizeof *shape->end);
    VBSS_TRY(vbss_scene_create_static_mesh(s, m, shape));
    m->geometry_hash = vbss_scene_hash_mesh(shape, shape->start, m->is_one_sided);
    shape->is_rigid = shape->is_static = true;
    vbss_scene_set_mesh_category(shape);
    vbss_collision_update_displacements(shape);
    vbss_collision_shape_update_boxes(shape);
    vbss_collision_shape_refit_points(shape);
    vbss_collision_shape_refit_edges(shape);
    vbss_collision_shape_refit_triangles(shape);
    return VBSS_OK;
}

vbss_result vbss_scene_place_static_mesh(scene_object *s, const vbss_scene_static_mesh_config *c,
                                         scene_body *b, uint32_t *body)
{
    uint32_t shape = 0;
    scene_static_mesh mesh = {.is_one_sided = c->one_sided != 0};
    VBSS_TRY(vbss_collision_add_mesh(scene_collision(s), c->vertex_count, c->triangles,
                                     c->triangle_count, 0.5 * c->thickness, &shape));
    const vbss_result result =
        vbss_scene_set_up_mesh(s, c->vertices, s->collision->shapes[shape], &mesh);
    if (result != VBSS_OK) {
        (void)vbss_collision_remove(scene_collision(s), shape);
        return result;
    }
    const pose origin = pose_make(vec3_zero(), quat_identity());
    *b = (scene_body){.kind = SCENE_BODY_NONE};
    scene_rigid *rigid =
        &b->rigid; /* in place: a copy would double the stack of those that load scenes */
    rigid->kind = VBSS_SCENE_RIGID_DRIVEN;
    rigid->frame = rigid->trial = origin;
    rigid->first_capsule = s->capsule_count;
    rigid->friction = rigid->created_friction = c->friction;
    rigid->is_static_mesh = true;
    rigid->mesh = mesh;
    rigid->body.mass = 1.0; /* a driven body needs some; it has no effect */
    rigid->body.inertia = vec3_make(1.0, 1.0, 1.0);
    rigid->body.now.pose = rigid->body.target_start = rigid->body.target_end = origin;
    vbss_scene_register_body(s, b, SCENE_BODY_RIGID, shape, body);
    return VBSS_OK;
}

static vbss_result add_mesh(scene_object *s, const vbss_scene_static_mesh_config *c, uint32_t *body)
{
    const scene_outline outline = {.surface = {(const vec3 *)(const void *)c->vertices,
                                               (const uint32_t(*)[3])(const void *)c->triangles,
                                               c->triangle_count, 0.5 * c->thickness, false},
                                   .is_prescribed = true};
    VBSS_TRY(vbss_scene_check_overlap(s, &outline, "static mesh"));
    scene_body *b;
    VBSS_TRY(vbss_scene_find_free_body(s, SCENE_BODY_RIGID, &b));
    return vbss_scene_place_static_mesh(s, c, b, body);
}

vbss_result vbss_scene_add_checked_mesh(vbss_scene *scene, scene_object *s,
                                        const vbss_scene_static_mesh_config *c, uint32_t *body)
{
    scene_edit edit;
    scene_body *entry;
    VBSS_TRY(vbss_scene_check_static_mesh(s->context, c));
    VBSS_TRY(vbss_scene_find_free_body(s, SCENE_BODY_RIGID, &entry));
    vbss_warn_if_unlikely(s->context, vbss_max_abs(c->vertices, 3 * (size_t)c->vertex_count),
                          VBSS_LIKELY_LENGTH, "a coordinate of vertices", "m", "mm");
    vbss_edit input = {.kind = VBSS_EDIT_OTHER};
    VBSS_TRY(vbss_scene_begin_edit(scene, &input, &edit));
    return vbss_scene_end_edit(&edit, add_mesh(s, c, body));
}

vbss_result vbss_scene_check_mesh_method(const scene_object *s)
{
    return s->config.method == VBSS_METHOD_IMPLICIT
               ? VBSS_OK
               : vbss_fail(s->context, VBSS_ERROR_INCOMPATIBLE,
                           "only scenes of method IMPLICIT have static meshes");
}

vbss_result vbss_scene_add_static_mesh(vbss_scene *scene,
                                       const vbss_scene_static_mesh_config *config, uint32_t *body)
{
    VBSS_ENTER(scene);
    scene_object *s;
    vbss_scene_static_mesh_config own;
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    VBSS_TRY(vbss_check_pointer(s->context, body, "body"));
    VBSS_TRY(vbss_scene_read_mesh_config(s->context, config, &own));
    VBSS_TRY(vbss_scene_check_mesh_method(s));
    return vbss_scene_add_checked_mesh(scene, s, &own, body);
}
