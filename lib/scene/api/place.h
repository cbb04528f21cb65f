/* Places a body at an entry of a scene. The callers have found the entry, and checked the body: they
 * add a body of the host (add_*.c) or create a scene from its description (load.c). Each function
 * gives the body the next number and the next shape, and changes nothing when it fails. */
#ifndef VBSS_SCENE_PLACE_H
#define VBSS_SCENE_PLACE_H

#include <vblast_ss/scene_geometry.h>
#include <vblast_ss/scene_surface.h>

#include "scene/snapshot/describe.h"
#include "scene/world/scene_data.h"

/* ---- new_body.c */

/* A body that a host adds. */
typedef struct scene_new_body {
    void *handle;
    const vbss_kind *kind;
    const char *name; /* of the argument, for error texts */
} scene_new_body;

/* Checks the handle, and the address of the number that the body gets. Returns the body's slot. */
vbss_result vbss_scene_check_new_body(const scene_object *s, const scene_new_body *added,
                                      const uint32_t *number, vbss_slot **slot);

/* VBSS_ERROR_INCOMPATIBLE if the scene uses another method than the body. */
vbss_result vbss_scene_check_method(const scene_object *s, vbss_method method, const char *name);

/* VBSS_ERROR_CAPACITY if the scene has no room for so many more capsules. */
vbss_result vbss_scene_check_capsule_room(const scene_object *s, uint32_t count);

/* ---- add_thread.c, add_drain.c, add_needle.c, add_grasper.c, add_rigid.c */

/* Creates the shape of a thread. That of an adaptive thread has room for all nodes that its mesh may
 * get. */
vbss_result vbss_scene_create_thread_shape(scene_object *s, const thread_object *t,
                                           uint32_t *shape);

/* Places a thread that has a shape. The caller numbers the nodes of the scene. */
void vbss_scene_place_thread(scene_object *s, vbss_slot *slot, scene_body *b, uint32_t shape,
                             uint32_t *body);

vbss_result vbss_scene_place_drain(scene_object *s, vbss_slot *slot, scene_body *b, uint32_t *body);
vbss_result vbss_scene_place_needle(scene_object *s, vbss_slot *slot, scene_body *b,
                                    uint32_t *body);

/* `target`: pose of the tool, through its trocar. */
vbss_result vbss_scene_place_grasper(scene_object *s, vbss_slot *slot, pose target, scene_body *b,
                                     uint32_t *body);

/* Places another rigid body. The caller has written radius and `local_end` of its capsules behind the
 * capsules of the scene. */
vbss_result vbss_scene_place_rigid(scene_object *s, const scene_rigid *rigid, scene_body *b,
                                   uint32_t *body);

/* Places a static mesh. The configuration has been checked, its filter apart, which the caller sets. */
vbss_result vbss_scene_place_static_mesh(scene_object *s,
                                         const vbss_scene_static_mesh_config *config, scene_body *b,
                                         uint32_t *body);

/* Moves a new shape to its place and builds its trees, so that no step has to. Creates what the scene keeps
 * of a mesh. `vertices`: as many as the shape has, checked. */
vbss_result vbss_scene_set_up_mesh(scene_object *s, const double *vertices, collision_shape *shape,
                                   scene_static_mesh *mesh);

/* Lets a shape form no pairs with other meshes. */
void vbss_scene_set_mesh_category(collision_shape *shape);

/* Hash of triangles, thickness, vertices and sides of a mesh. The stream writes nothing to `vertices`. */
uint64_t vbss_scene_hash_mesh(const collision_shape *shape, vec3 *vertices, bool is_one_sided);

/* Reads the configuration of a host: of a static mesh, of a rigid body. */
vbss_result vbss_scene_read_mesh_config(vbss_context *context,
                                        const vbss_scene_static_mesh_config *config,
                                        vbss_scene_static_mesh_config *own);
vbss_result vbss_scene_read_rigid_config(vbss_context *context,
                                         const vbss_scene_rigid_config *config,
                                         vbss_scene_rigid_config *own);

/* Checks everything of a rigid body but its capsules, and sets the error text. */
vbss_result vbss_scene_check_rigid_motion(vbss_context *context,
                                          const vbss_scene_rigid_config *config);

/* Sets a rigid body at its pose, with its motion and mass, without its shape. */
void vbss_scene_init_rigid(scene_rigid *r, const vbss_scene_rigid_config *config,
                           const vbss_rigid_mass *mass, quat orientation);

/* Places a rigid body whose shape is a mesh. `config`: its geometry; the vertices are in the frame that
 * hosts see, or if `is_principal` in the principal frame. */
vbss_result vbss_scene_place_rigid_mesh(scene_object *s, const scene_rigid *rigid,
                                        const vbss_scene_static_mesh_config *config,
                                        bool is_principal, scene_body *b, uint32_t *body);

/* Checks the geometry of a rigid mesh, and sets the error text. */
vbss_result vbss_scene_check_rigid_mesh(vbss_context *context,
                                        const vbss_scene_static_mesh_config *config);

/* Checks a static mesh and adds it, as an edit of the host. */
vbss_result vbss_scene_add_checked_mesh(vbss_scene *scene, scene_object *s,
                                        const vbss_scene_static_mesh_config *config,
                                        uint32_t *body);

/* VBSS_ERROR_INCOMPATIBLE if the method of the scene has no static meshes. */
vbss_result vbss_scene_check_mesh_method(const scene_object *s);

/* Places a plane. */
vbss_result vbss_scene_place_plane(scene_object *s, const scene_plane_description *plane,
                                   scene_body *b, uint32_t *body);

/* Whether the numbers of a plane are those of one that a host can add. */
bool vbss_scene_is_plane_valid(const scene_plane_description *plane);

/* Places a host surface, likewise. */
vbss_result vbss_scene_place_host_surface(scene_object *s, const vbss_scene_surface_config *config,
                                          scene_body *b, uint32_t *body);

/* Hash of everything of a host surface that a snapshot must have in common with the scene. */
uint64_t vbss_scene_hash_host_surface(const scene_host_surface *h, const scene_static_mesh *mesh);

/* Checks the configuration of a host surface, and sets the error text. */
vbss_result vbss_scene_check_host_surface(vbss_context *context,
                                          const vbss_scene_surface_config *config);

/* Checks the configuration of a static mesh, and sets the error text. */
vbss_result vbss_scene_check_static_mesh(vbss_context *context,
                                         const vbss_scene_static_mesh_config *config);

#endif
