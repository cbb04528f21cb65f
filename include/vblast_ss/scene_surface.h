/**
 * @file scene_surface.h
 * @brief Host surfaces: triangle meshes in a scene whose vertices the host's own model moves.
 *
 * A host that simulates tissue gives its surface to a scene once (#vbss_scene_add_surface), and its
 * vertices before each step (#vbss_scene_move_surface). Threads, needles, tools and drains touch the
 * surface where it is during the step, with friction. After the step the host takes the contact force
 * on each vertex (#vbss_scene_get_surface_view) and applies it to its model. This is weak coupling:
 * docs/guides/host-surface.md tells when it is stable.
 *
 * Vertices move along straight lines from their positions at the start of the step to those that the
 * host gave. The guard (CCD) tests the moving triangles, so nothing passes through them.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_SCENE_SURFACE_H
#define VBLAST_SS_SCENE_SURFACE_H

#include <vblast_ss/base.h>
#include <vblast_ss/scene.h>

/**
 * Configuration of a host surface. Fill it with #vbss_scene_surface_config_init, then change fields.
 */
typedef struct vbss_scene_surface_config {
    uint32_t struct_size;    /**< Size of this struct in bytes, set by the init function. */
    uint32_t vertex_count;   /**< Number of vertices, 3 to 65536. */
    uint32_t triangle_count; /**< Number of triangles, 1 to 131072. */
    /** 0: both sides are solid. Other values are refused: the guard does not yet hold for one side of a
     * surface that moves. */
    uint32_t one_sided;
    /** First positions of the vertices in the world, m: vertex_count times x, y, z, each at most 1e3
     * in magnitude; the library copies them. */
    const double *vertices;
    /** Corners of triangles: triangle_count times three different indices of vertices, in any order.
     * No triangle may be so thin that the cross product of two of its sides is zero. The library
     * copies them. */
    const uint32_t *triangles;
    /** Friction coefficient of its surface, 0 to 10; default 0.15. A contact with a thread has this
     * coefficient, any other contact the geometric mean of both. */
    double friction;
    /** Thickness of the wall, m, 2e-6 to 0.2; default 0.5e-3. The triangles are its middle: other
     * bodies touch it at half the thickness from them. */
    double thickness;
    /** Largest distance between two positions of a vertex that the host gives one after the other, m,
     * 1e-6 to 1e3; default 20e-3: 20 m/s at steps of 1 ms. #vbss_scene_move_surface refuses a longer
     * one. */
    double jump_limit;
    /** Numbers with which the host states how far each vertex gives way to a force: 0 (default): none, all
     * vertices are exactly where the host says; 1: one compliance for all directions; 9: a symmetric matrix of
     * 3 x 3. Values are set by #vbss_scene_set_surface_compliance, and are zero before. */
    uint32_t compliance_size;
    uint32_t reserved; /**< Zero. */
    /** Force along the direction of a tip at which it enters the wall, N, 1e-3 to 1e3; 0 (default): no tip
     * enters by force, and holes are those of #vbss_scene_make_hole only. */
    double puncture_force;
    double
        hole_force; /**< Friction of a hole with a needle that slides in it, N, 1e-6 to 1e3; default 0.25. */
    /** Coefficient of the additional friction from the force across the suture, 0 to 10; default 0.3. */
    double hole_friction;
    /** Stiffness of a hole across and along the suture in it, N/m, 1 to 1e7; default 2e4. */
    double hole_stiffness;
    double hole_damping; /**< Damping of sliding in a hole, N s/m, 0 to 1e3; default 0.05. */
    /** Length of a tip's path through the wall over which the force against its advance falls from puncture_force
     * to hole_force, and that against drawing it back grows from 0 to hole_force; m, 0 to 0.1; default 0.5e-3. */
    double tip_length;
    double
        thread_force; /**< Friction of a hole with a slack thread in it, N, 1e-6 to 1e3; default 0.02. */
    /** Energy for each square metre of cut, J/m^2, 1 to 1e7; 0 (default): threads do not tear the wall at their
     * holes. Otherwise as vbss_drain_config::tear_energy. */
    double tear_energy;
} vbss_scene_surface_config;

/** An array of a host surface: a VBSS_SCENE_SURFACE_VIEW_ constant. */
typedef int32_t vbss_scene_surface_field;

/** The constants of #vbss_scene_surface_field. */
enum {
    /** Positions of the vertices after the last step, m: vertex_count times x, y, z. They differ from
     * the targets while a step is suspended, and after a step of which the scene left out a part. */
    VBSS_SCENE_SURFACE_VIEW_POSITIONS = 1,
    /** Positions that the host gave last, m: vertex_count times x, y, z. */
    VBSS_SCENE_SURFACE_VIEW_TARGETS = 2,
    /** Forces of contacts and holes on the vertices at the end of the last step, friction included, N: vertex_count
     * times x, y, z. Each contact force acts at a point of the middle of the wall, and the corners of
     * the triangle or edge there share it by its barycentric coordinates. So the forces on the
     * vertices have the sum and the torque of the contact forces at these points. The corners of the triangle
     * in which a hole is share its force in the same way. After a step of which
     * the scene left out a part they are those of the step before. */
    VBSS_SCENE_SURFACE_VIEW_FORCES = 3
};

/** A hole of a host surface that gets another mesh, as #vbss_scene_place_hole_fn receives it. */
typedef struct vbss_scene_hole_place {
    uint32_t struct_size; /**< Size of this struct in bytes. */
    uint32_t hole;        /**< Id of the hole, as #vbss_scene_make_hole gave it. */
    uint32_t triangle;    /**< Triangle of the mesh before in which the hole is. */
    uint32_t reserved;    /**< Zero. */
    double weights[3];    /**< Barycentric coordinates of the hole in that triangle. */
    double position[3];   /**< Where the hole is now, in the world, m. */
    /** Unit normal of that triangle now: along (b - a) x (c - a) for its corners a, b, c. */
    double normal[3];
} vbss_scene_hole_place;

/**
 * Says where on the new mesh of a host surface a hole is (#vbss_scene_remesh_surface). It runs on the thread
 * that remeshes, once for each hole of the surface, in ascending order of the entries of #vbss_scene_get_hole. The scene still has
 * the mesh from before; calls that change the context return VBSS_ERROR_BUSY.
 *
 * @param user           as given to #vbss_scene_remesh_surface
 * @param hole           the hole and its place on the mesh before; valid during the call
 * @param[in,out] triangle  triangle of the new mesh. It comes with that of the nearest place, which the function may leave
 * @param[in,out] weights   three barycentric coordinates of the hole in it, each 0 to 1, with a sum of 1; likewise
 * @return VBSS_OK; any other status if the new mesh has no place for the hole: it then is refused
 * @since 1.0
 */
typedef vbss_result (*vbss_scene_place_hole_fn)(void *user, const vbss_scene_hole_place *hole,
                                                uint32_t *triangle, double *weights);

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Fills a configuration of a host surface with the defaults.
 *
 * @param[out] config  the configuration to fill
 * @param struct_size  `sizeof *config` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_surface_config_init(vbss_scene_surface_config *config,
                                                    uint32_t struct_size);

/**
 * Returns the default configuration that #vbss_scene_surface_config_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_scene_surface_config vbss_scene_surface_config_default(void)
{
    vbss_scene_surface_config vbss_filled;
    (void)vbss_scene_surface_config_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Adds a host surface: a static mesh that moves (#vbss_scene_add_static_mesh). It counts as one of the
 * scene's rigid bodies (rigid_capacity). It touches neither itself nor static meshes nor other host
 * surfaces. No node can be pinned to it. Needles and threads pass through it by holes, as through a drain
 * (#vbss_scene_make_hole, puncture_force). A driven body and the surface do not press on each other, because both follow the host exactly: the guard holds both back.
 * Vertices with a compliance (#vbss_scene_set_surface_compliance) give way to it, and a coupled tool gives
 * way itself. The call allocates all memory that steps need for the surface.
 * #vbss_scene_get_rigid reports the sum of the contact forces on it.
 *
 * @param scene      the scene, of method VBSS_METHOD_IMPLICIT
 * @param config     the configuration; not NULL, because a surface needs triangles
 * @param[out] body  its number in the scene, from 1 on, never reused
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE (also: a triangle without area, with a
 *         vertex that does not exist or occurs twice, triangles of a one-sided surface that are not
 *         wound alike, or an overlap, if the scene refuses it), VBSS_ERROR_NOT_FINITE,
 *         VBSS_ERROR_INCOMPATIBLE (another method), VBSS_ERROR_CAPACITY, VBSS_ERROR_OUT_OF_MEMORY or
 *         VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_add_surface(vbss_scene *scene,
                                            const vbss_scene_surface_config *config,
                                            uint32_t *body);

/**
 * Sets the positions of the vertices at the end of the next step that begins. Without a call the
 * surface stays where it is. Velocities follow from the positions. A refused call changes nothing.
 *
 * The positions are an input of the scene. Snapshots save them. A log stores the state of the whole
 * scene with each call (#vbss_scene_set_recorder), and so replays without the host's model; it grows by
 * the size of a snapshot each time.
 *
 * @param scene         the scene
 * @param body          a host surface
 * @param vertices      vertex_count times x, y, z, m, each at most 1e3 in magnitude
 * @param vertex_count  number of vertices, as the surface was added
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no such
 *         body), VBSS_ERROR_INCOMPATIBLE (the body is no host surface), VBSS_ERROR_NOT_FINITE,
 *         VBSS_ERROR_OUT_OF_RANGE (another number of vertices; a vertex that is farther than
 *         jump_limit from its last position; a triangle that has lost its area or whose normal has
 *         turned by 90 degrees or more since the last positions), VBSS_ERROR_CAPACITY (the record has
 *         no room) or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_move_surface(vbss_scene *scene, uint32_t body,
                                             const double *vertices, uint32_t vertex_count);

/**
 * Sets how far each vertex of a host surface gives way to a contact force: the scene finds contacts at the
 * position that the host has given plus compliance times force. So it solves for the force that the host's
 * model bears at the end of the step, and a light or soft surface stays stable
 * (docs/guides/host-surface.md). The best value is the displacement in the host's model by a unit force that
 * acts during the whole next step: h^2 / mass for a free particle, or the block of the inverse of the host's
 * system matrix. The host gives the positions that its vertices reach without contact force, and then applies
 * the returned forces during the same step. The vertices then end where #VBSS_SCENE_SURFACE_VIEW_POSITIONS
 * says. Vertices that no contact touches stay where the host says. At most 1,024 vertices of a surface are
 * touched at a time, or the step returns VBSS_ERROR_CAPACITY.
 *
 * The call ends a suspended step. Snapshots save the compliance, and a log stores the state with each call.
 *
 * @param scene       the scene
 * @param body        a host surface that was added with compliance_size 1 or 9
 * @param compliance  vertex_count times compliance_size numbers, m/N: for each vertex a number, or the rows of a
 *         symmetric, positive definite matrix of which no pivot is below 1e-6 of the largest number. The largest
 *         number of a vertex is 1e-9 to 1e6; all zero: the vertex is exactly where the host says
 * @param count       number of these numbers
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no such
 *         body), VBSS_ERROR_INCOMPATIBLE (no host surface, or one of compliance_size 0),
 *         VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_OUT_OF_MEMORY (only while a step is
 *         suspended), VBSS_ERROR_CAPACITY (the record has no room) or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_set_surface_compliance(vbss_scene *scene, uint32_t body,
                                                       const double *compliance, uint32_t count);

/**
 * Gives a host surface another mesh. The body keeps its number, filter, friction, thickness, the parameters of
 * holes, compliance_size and jump_limit. Its holes keep their ids, their needles and threads, and their forces: each goes to the
 * place on the new mesh that `place` returns. The new vertices are where the surface is from now on. So they must be on the
 * surface of #VBSS_SCENE_SURFACE_VIEW_POSITIONS, as exactly as forces shall stay the same: a hole
 * that moves by d across its suture changes its force by up to hole_stiffness times d.
 *
 * - A move that no step has used yet is dropped. The next one starts from the new vertices.
 * - All vertices are prescribed until the host states their compliance again
 *   (#vbss_scene_set_surface_compliance). Their forces are zero until the next step.
 * - Contacts, unlike holes, start the next step without the forces of the last one.
 * - Bodies that the new mesh overlaps, except sutures at its holes, are treated as the scene's `overlap` says. A body
 *   that lies wholly on the other side of the new mesh is not found.
 *
 * The call ends a suspended step, and allocates all memory that steps need. A refused or failed call changes
 * nothing. It compares each hole, and for overlaps each part of the other bodies near the surface, with all new triangles.
 *
 * A snapshot from before cannot be restored into the scene any more; #vbss_scene_load creates a scene with the mesh of its
 * snapshot. A log stores the state of the whole scene, so a replay needs no callback; only a scene of
 * #vbss_replay_load_scene follows it.
 *
 * @param scene           the scene
 * @param body            a host surface
 * @param vertices        vertex_count times x, y, z, m, each at most 1e3 in magnitude; the library copies them
 * @param vertex_count    number of vertices, 3 to 65536
 * @param triangles       triangle_count times three different indices of vertices; as in #vbss_scene_surface_config
 * @param triangle_count  number of triangles, 1 to 131072
 * @param place           says where each hole goes; NULL: to the nearest place on the new mesh
 * @param user            passed to `place`
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no such
 *         body, or `place` returned another status than VBSS_OK), VBSS_ERROR_INCOMPATIBLE (the body is no host
 *         surface), VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_RANGE (a count; a triangle that #vbss_scene_add_surface
 *         would refuse; a triangle or weights from `place` that do not exist; a hole that would move by more than the radius of
 *         its suture and half the thickness of the wall; an overlap, if the scene refuses it),
 *         VBSS_ERROR_OUT_OF_MEMORY, VBSS_ERROR_CAPACITY (the record has no room) or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_remesh_surface(vbss_scene *scene, uint32_t body,
                                               const double *vertices, uint32_t vertex_count,
                                               const uint32_t *triangles, uint32_t triangle_count,
                                               vbss_scene_place_hole_fn place, void *user);

/**
 * Describes an array of a host surface without copying it.
 *
 * @param scene        the scene
 * @param body         a host surface
 * @param field        the array
 * @param[out] view    where it is; valid until the next step, move or edit of the scene
 * @param struct_size  `sizeof *view` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no such
 *         body), VBSS_ERROR_INCOMPATIBLE (the body is no host surface), VBSS_ERROR_OUT_OF_RANGE (no
 *         such array), VBSS_ERROR_STRUCT_SIZE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_get_surface_view(vbss_scene *scene, uint32_t body,
                                                 vbss_scene_surface_field field, vbss_view *view,
                                                 uint32_t struct_size);

#ifdef __cplusplus
}
#endif

#endif
