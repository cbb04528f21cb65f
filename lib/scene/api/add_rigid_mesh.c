/* Adds a rigid body whose shape is a mesh: a body without capsules, whose collision shape is a posed mesh in
 * its principal frame. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "scene/api/api.h"
#include "scene/api/overlap.h"
#include "scene/api/place.h"
#include "scene/world/world.h"

/* Everything that a new body needs, computed before anything changes. */
typedef struct new_mesh {
    vbss_scene_rigid_config motion;
    vbss_scene_static_mesh_config geometry;
    vbss_rigid_mass mass;
    quat orientation;
} new_mesh;

vbss_result vbss_scene_check_rigid_mesh(vbss_context *context,
                                        const vbss_scene_static_mesh_config *c)
{
    VBSS_TRY(vbss_scene_check_static_mesh(context, c));
    return c->one_sided == 0 ? VBSS_OK
                             : vbss_fail(context, VBSS_ERROR_OUT_OF_RANGE,
                                         "one_sided is 1: a mesh that moves has two sides");
}

static vbss_result check_motion(vbss_context *context, const vbss_scene_rigid_config *c)
{
    if (c->capsule_count != 0 || c->capsules != NULL) {
        return vbss_fail(context, VBSS_ERROR_OUT_OF_RANGE,
                         "the body has capsules: its shape is the mesh alone");
    }
    return vbss_scene_check_rigid_motion(context, c);
}

static vbss_result read_mesh(const scene_object *s, const vbss_scene_rigid_config *motion,
                             const vbss_scene_static_mesh_config *geometry, new_mesh *read)
{
    const vbss_scene_static_mesh_config *c = &read->geometry;
    read->motion = vbss_scene_rigid_config_default();
    if (motion != NULL) {
        VBSS_TRY(vbss_scene_read_rigid_config(s->context, motion, &read->motion));
    }
    VBSS_TRY(vbss_scene_read_mesh_config(s->context, geometry, &read->geometry));
    VBSS_TRY(vbss_scene_check_mesh_method(s));
    VBSS_TRY(check_motion(s->context, &read->motion));
    VBSS_TRY(vbss_scene_check_rigid_mesh(s->context, c));
    VBSS_TRY(vbss_read_orientation(s->context, read->motion.orientation, &read->orientation));
    const vbss_rigid_triangles triangles = {c->vertices, c->triangles, c->triangle_count};
    if (!vbss_rigid_mass_of_triangles(&triangles, read->motion.mass, &read->mass)) {
        return vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE, "the triangles have no area");
    }
    read->motion.friction = c->friction;
    return VBSS_OK;
}

/* Largest distance of the surface from the origin of the mesh's frame, m. */
static double reach_of(const collision_shape *shape)
{
    double reach = 0.0;
    for (uint32_t i = 0; i < shape->node_count; i++) {
        reach = vbss_max(reach, vec3_norm(shape->posed->local[i]));
    }
    return reach + shape->radius;
}

/* Makes a new shape that of a rigid mesh. */
static vbss_result set_up_shape(scene_object *s, const scene_rigid *rigid, uint32_t shape,
                                const double *vertices, bool is_principal, scene_static_mesh *mesh)
{
    collision_shape *own = s->collision->shapes[shape];
    VBSS_TRY(vbss_collision_make_posed(s->collision, shape, vertices,
                                       is_principal ? NULL : &rigid->frame, rigid->body.now.pose));
    VBSS_TRY(vbss_scene_create_static_mesh(s, mesh, own));
    mesh->geometry_hash = vbss_scene_hash_mesh(own, own->posed->local, false);
    mesh->reach = reach_of(own);
    vbss_scene_set_mesh_category(own);
    return VBSS_OK;
}

vbss_result vbss_scene_place_rigid_mesh(scene_object *s, const scene_rigid *rigid,
                                        const vbss_scene_static_mesh_config *c, bool is_principal,
                                        scene_body *b, uint32_t *body)
{
    uint32_t shape = 0;
    scene_static_mesh mesh = {.is_one_sided = false};
    VBSS_TRY(vbss_collision_add_mesh(scene_collision(s), c->vertex_count, c->triangles,
                                     c->triangle_count, 0.5 * c->thickness, &shape));
    const vbss_result result = set_up_shape(s, rigid, shape, c->vertices, is_principal, &mesh);
    if (result != VBSS_OK) {
        (void)vbss_collision_remove(scene_collision(s), shape);
        return result;
    }
    *b = (scene_body){.kind = SCENE_BODY_NONE};
    b->rigid = *rigid; /* in place: a copy would double the stack of those that load scenes */
    b->rigid.first_capsule = s->capsule_count;
    b->rigid.is_rigid_mesh = true;
    b->rigid.mesh = mesh;
    b->rigid.expected = rigid->body.now.pose;
    vbss_scene_register_body(s, b, SCENE_BODY_RIGID, shape, body);
    return VBSS_OK;
}

static vbss_result add_mesh(scene_object *s, const new_mesh *added, uint32_t *body)
{
    const vbss_scene_rigid_config *motion = &added->motion;
    const vbss_scene_static_mesh_config *c = &added->geometry;
    const scene_outline outline = {.surface = {(const vec3 *)(const void *)c->vertices,
                                               (const uint32_t(*)[3])(const void *)c->triangles,
                                               c->triangle_count, 0.5 * c->thickness, true},
                                   .at = pose_make(vec3_load(motion->position), added->orientation),
                                   .is_prescribed = motion->kind == VBSS_SCENE_RIGID_DRIVEN};
    VBSS_TRY(vbss_scene_check_overlap(s, &outline, "rigid mesh"));
    scene_body *b;
    VBSS_TRY(vbss_scene_find_free_body(s, SCENE_BODY_RIGID, &b));
    scene_rigid rigid;
    vbss_scene_init_rigid(&rigid, motion, &added->mass, added->orientation);
    return vbss_scene_place_rigid_mesh(s, &rigid, c, false, b, body);
}

static void warn_of_units(vbss_context *context, const new_mesh *added)
{
    const vbss_scene_static_mesh_config *c = &added->geometry;
    vbss_warn_if_unlikely(context, vbss_max_abs(c->vertices, 3 * (size_t)c->vertex_count),
                          VBSS_LIKELY_LENGTH, "a coordinate of vertices", "m", "mm");
    vbss_warn_if_unlikely(context, vbss_max_abs(added->motion.gravity, 3), VBSS_LIKELY_GRAVITY,
                          "gravity", "m/s^2", "mm/s^2");
}

vbss_result vbss_scene_add_rigid_mesh(vbss_scene *scene, const vbss_scene_rigid_config *motion,
                                      const vbss_scene_static_mesh_config *geometry, uint32_t *body)
{
    VBSS_ENTER(scene);
    scene_object *s;
    new_mesh added;
    scene_edit edit;
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    VBSS_TRY(vbss_check_pointer(s->context, body, "body"));
    VBSS_TRY(read_mesh(s, motion, geometry, &added));
    scene_body *entry;
    VBSS_TRY(vbss_scene_find_free_body(s, SCENE_BODY_RIGID, &entry));
    warn_of_units(s->context, &added);
    vbss_edit input = {.kind = VBSS_EDIT_OTHER};
    VBSS_TRY(vbss_scene_begin_edit(scene, &input, &edit));
    return vbss_scene_end_edit(&edit, add_mesh(s, &added, body));
}
