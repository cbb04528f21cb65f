/**
 * @file drain.h
 * @brief The Penrose drain: a tube of rubber with an open slit.
 *
 * A drain is a thin elastic shell, modelled by triangles of its middle surface. In its own frame the
 * tube lies along x with its centre at the origin, and the slit is on top (+y). Anchors glue a strip
 * along the bottom to the block on which the drain lies; they tear off under load. At rest the drain has
 * no stress, and the slit is open.
 *
 * Method IMPLICIT: membrane and bending are those of an isotropic elastic shell with large rotations
 * (assumed-strain patch triangles, Flores and Onate 2005; docs/explanation/drain-shell.md). The time integration is
 * backward Euler with one linearisation and one correction a step (docs/explanation/drain.md).
 *
 * Method VBLAST (VBLaST-SS, Qi et al. 2017): 85 particles, which move in explicit steps. A spring ties
 * each particle to its rest position, and nothing ties it to its neighbours (docs/explanation/paper-drain.md). The
 * method has a mesh of its own and no anchors.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_DRAIN_H
#define VBLAST_SS_DRAIN_H

#include <vblast_ss/base.h>
#include <vblast_ss/baseline.h>

/** A drain. */
typedef struct vbss_drain vbss_drain;

/** Mesh of a drain: a VBSS_DRAIN_MESH_ constant. All meshes are graded toward the slit, and have nodes
 * at its tips and at both marks. */
typedef int32_t vbss_drain_mesh;

/** The constants of #vbss_drain_mesh. */
enum {
    VBSS_DRAIN_MESH_137 = 0, /**< 137 nodes, 240 triangles. */
    VBSS_DRAIN_MESH_159 = 1, /**< 159 nodes, 280 triangles. */
    VBSS_DRAIN_MESH_181 = 2, /**< 181 nodes, 320 triangles. */
    VBSS_DRAIN_MESH_225 = 3  /**< 225 nodes, 400 triangles: for walls thinner than 0.6 mm. */
};

/**
 * A triangulated sheet or tube, which a drain may be in place of the tube with a slit: a pad of skin, a
 * vessel, a bowel. Fill it with #vbss_drain_surface_init, then set the arrays. The library copies them
 * when the drain is created.
 *
 * The triangles are those of the middle surface at rest, without stress. Each edge belongs to one
 * triangle (a free edge) or to two, which list it in opposite directions; where triangles meet in their
 * interior, more than three meet at a node.
 */
typedef struct vbss_drain_surface {
    uint32_t struct_size;    /**< Size of this struct in bytes, set by the init function. */
    uint32_t node_count;     /**< Number of nodes, 3 to 2048. */
    uint32_t triangle_count; /**< Number of triangles, 1 to 4096. */
    uint32_t anchor_count;   /**< Number of anchored nodes, 0 to node_count; default 0. */
    /** node_count x 3: positions of the nodes at rest, in the drain's frame, m, each at most 1 in
     * magnitude. */
    const double *positions;
    /** triangle_count x 3: nodes of each triangle, counter-clockwise seen from outside. Needles enter
     * from either side. */
    const uint32_t *triangles;
    /** anchor_count: nodes that are glued to their place at rest, each once; NULL if there are none.
     * They tear off above vbss_drain_config::tear_stress. */
    const uint32_t *anchors;
    /** triangle_count: thickness of the wall that stiffness and mass of each triangle have, m, 1e-6 to
     * 0.1; NULL (default): vbss_drain_config::thickness. Contacts use that one thickness everywhere. */
    const double *thickness;
    /** triangle_count: Young's modulus of each triangle, Pa, 1e3 to 1e12; NULL (default):
     * vbss_drain_config::young_modulus. */
    const double *young_modulus;
} vbss_drain_surface;

/** Configuration of a drain. Fill it with #vbss_drain_config_init, then change fields. */
typedef struct vbss_drain_config {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    vbss_method method;   /**< Method; default VBSS_METHOD_IMPLICIT. */
    vbss_drain_mesh mesh; /**< Method IMPLICIT: mesh; default VBSS_DRAIN_MESH_137. */
    /** Method IMPLICIT: divisions of each cell in each direction, 1 to 4; default 1. */
    uint32_t mesh_divisions;
    uint32_t attachment_capacity; /**< Largest number of attachments, 0 to 256; default 8. */
    /** Method IMPLICIT: largest number of linearisations in a step, 1 to 50; default 1. A step with a larger
     * limit stops at position_tolerance; this serves reference solutions. */
    uint32_t iteration_limit;
    uint32_t
        halving_limit; /**< Method IMPLICIT: how often a step may be halved, 0 to 10; default 4. */
    uint32_t reserved; /**< Zero. */
    double radius;     /**< Radius of the middle surface, m, 1e-4 to 1; default 6.5e-3. */
    double length;     /**< Length of the tube, m, 2 to 7 radii; default 32e-3. */
    /** Thickness of the wall, m, 0.01 to 0.3 radii, or with a surface 1e-6 to 0.1; default 1e-3. */
    double thickness;
    double slit_length; /**< Length of the slit, m, one radius to 0.7 lengths; default 10e-3. */
    /** Width of the slit at its middle, along the surface, m, 0 to 0.4 slit lengths and one radius; default
     * 3e-3. */
    double slit_opening;
    /** Arc from the middle of the slit to each mark, along the surface before the slit was opened, m. It is
     * longer than half the opening and lies between 20 and 90 degrees. Default 4.5e-3. */
    double mark_arc;
    /** Method IMPLICIT: Young's modulus, Pa, 1e3 to 1e12; default 1.2e6 (not verified for real
     * drains). */
    double young_modulus;
    double poisson_ratio; /**< Method IMPLICIT: Poisson's ratio, 0 to 0.49; default 0.47. */
    double density;       /**< Density, kg/m^3, 1 to 1e5; default 950. */
    /** Drag coefficient, 1/s, 0 to 1e6; default 20. The force is -drag * mass * velocity. */
    double drag;
    /** Gravitational acceleration, m/s^2, each component at most 1e6 in magnitude; default 0,
     * because the rest shape is that of a drain that lies on its block. */
    double gravity[3];
    double position
        [3]; /**< Origin of the drain's frame in the world, m, each at most 1e3; default 0. */
    double orientation
        [4]; /**< Quaternion (w, x, y, z) of any length from 1e-100 to 1e100; default (1, 0, 0, 0). */
    /** Method IMPLICIT: strength of the glue of the strip, Pa, 1 to 1e12; default 5e4 (not verified). The anchor
     * of a node tears off permanently above this stress times the node's area of the strip. Each step tears
     * off at most one anchor: the one with the largest overload. */
    double tear_stress;
    /** Method IMPLICIT: largest increment of the last linearisation, m, 1e-15 to 1; default 1e-6. */
    double position_tolerance;
    /** Method IMPLICIT: a step in which a node would move farther than this gets one more linearisation. A step
     * in which it would move four times as far is halved. m, 1e-9 to 1; default 1e-3. */
    double move_limit;
    /** Method VBLAST: its parameters; NULL (default): their defaults. The library copies them. */
    const vbss_baseline_config *baseline;
    /** In a scene: coefficient of friction with threads, 0 to 10. Friction with other bodies, the floor and
     * the drain itself uses the geometric mean of both coefficients. Default 0.3 (not verified). */
    double friction;
    /* Needles that are pushed through the wall in a scene: docs/explanation/puncture.md. */
    /** Force along the direction of a tip at which it enters a wall, N, 1e-3 to 1e3; default 1 (the
     * published range for both walls of a Penrose drain is 0.85 to 2.92). */
    double puncture_force;
    /** Friction of a hole with a needle that slides in it, N, 1e-6 to 1e3; default 0.25 (not verified). */
    double hole_force;
    /** Coefficient of the additional friction from the force across the suture, 0 to 10; default 0.3 (not
     * verified). */
    double hole_friction;
    /** Stiffness of a hole across and along the suture in it, N/m, 1 to 1e7; default 2e4. */
    double hole_stiffness;
    double hole_damping; /**< Damping of sliding in a hole, N s/m, 0 to 1e3; default 0.05. */
    /** Length of a tip's path through the wall over which the force against its advance falls from puncture_force
     * to hole_force, and that against drawing it back grows from 0 to hole_force; m, 0 to 0.1; default 0.5e-3. */
    double tip_length;
    /** Friction of a hole with a slack thread in it, N, 1e-6 to 1e3; default 0.02 (not verified). A tight
     * thread has capstan friction: docs/explanation/stitch.md. */
    double thread_force;
    /** Method IMPLICIT: sheet or tube in place of the tube with a slit; NULL (default): that tube. With a
     * surface the fields mesh, mesh_divisions, radius, length, slit_length, slit_opening and mark_arc have
     * no meaning, and the drain has neither marks nor a slit. The library copies the surface. */
    const vbss_drain_surface *surface;
    /** In a scene, method IMPLICIT: energy for each square metre of cut, J/m^2, 1 to 1e7; 0 (default): threads
     * do not tear the wall at their holes. With it, a thread cuts through the wall when the force across
     * it in the plane of the wall exceeds this energy times the thickness (of the triangle, where the surface
     * states it): docs/explanation/tearing.md has published values. The mesh stays whole: the cut behind
     * the thread is not opened. */
    double tear_energy;
} vbss_drain_config;

/** Kind of an attachment: a VBSS_DRAIN_ATTACHMENT_ constant. */
typedef int32_t vbss_drain_attachment_kind;

/** The constants of #vbss_drain_attachment_kind. */
enum {
    VBSS_DRAIN_ATTACHMENT_PIN = 0,   /**< The node is at `position`. */
    VBSS_DRAIN_ATTACHMENT_FORCE = 1, /**< `force` pulls at the node. */
    VBSS_DRAIN_ATTACHMENT_SPRING = 2 /**< A spring from `position` to the node. */
};

/** An attachment acts on one node. Fill it with #vbss_drain_attachment_init. */
typedef struct vbss_drain_attachment {
    uint32_t struct_size;            /**< Size of this struct in bytes, set by the init function. */
    vbss_drain_attachment_kind kind; /**< Kind; default VBSS_DRAIN_ATTACHMENT_PIN. */
    uint32_t node;                   /**< Node, which is not anchored. */
    uint32_t reserved;               /**< Zero. */
    /** PIN: target of the node in the next step; SPRING: its fixed end; m, each coordinate at most
     * 1e3 in magnitude. */
    double position[3];
    double force[3];  /**< FORCE: force, N, each component at most 1e6 in magnitude. */
    double stiffness; /**< SPRING: stiffness, N/m, 0 to 1e9. */
} vbss_drain_attachment;

/** An array of a drain: a VBSS_DRAIN_VIEW_ constant. */
typedef int32_t vbss_drain_field;

/** The constants of #vbss_drain_field. n nodes, m triangles. */
enum {
    VBSS_DRAIN_VIEW_POSITIONS = 0,      /**< n x 3 doubles, m, on the middle surface. */
    VBSS_DRAIN_VIEW_VELOCITIES = 1,     /**< n x 3 doubles, m/s. */
    VBSS_DRAIN_VIEW_REST_POSITIONS = 2, /**< n x 3 doubles, m, in the drain's frame. */
    VBSS_DRAIN_VIEW_TRIANGLES =
        3, /**< m x 3 uint32_t, nodes counter-clockwise seen from outside. */
    VBSS_DRAIN_VIEW_SLIT_LEFT =
        4, /**< uint32_t: nodes of the slit's edge on the left (-z), with both tips, along x. */
    /** uint32_t: nodes of the slit's edge on the right (+z), with both tips, along x. */
    VBSS_DRAIN_VIEW_SLIT_RIGHT = 5,
    VBSS_DRAIN_VIEW_ANCHORS = 6, /**< uint32_t: nodes of the bottom strip; method VBLAST: none. */
    /** 3 doubles for each of VBSS_DRAIN_VIEW_ANCHORS, N: the force of the anchor on the drain; zero once it is
     * torn off. */
    VBSS_DRAIN_VIEW_ANCHOR_FORCES = 7,
    /** m x 3 doubles: strains of the middle surface along and across the triangle's first side, and shear
     * (2 e12). Method VBLAST reports strains and curvatures too, although it does not resist them. */
    VBSS_DRAIN_VIEW_STRAINS = 8,
    /** m x 3 doubles, 1/m: changes of curvature along and across the triangle's first side, and
     * twist (2 k12). */
    VBSS_DRAIN_VIEW_CURVATURES = 9
};

/** Places on a drain, as nodes. */
typedef struct vbss_drain_places {
    uint32_t struct_size;    /**< Bytes of this struct that the library filled. */
    uint32_t node_count;     /**< Number of nodes of the mesh. */
    uint32_t triangle_count; /**< Number of triangles of the mesh. */
    uint32_t marks[2];       /**< The marks, left and right. */
    /** The middles of the slit's edges, left and right, which are the paper's points. */
    uint32_t gap_points[2];
    uint32_t reserved; /**< Zero. */
} vbss_drain_places;

/** Opening of the slit. */
typedef struct vbss_drain_gap {
    uint32_t struct_size;  /**< Bytes of this struct that the library filled. */
    uint32_t largest_pair; /**< Index of the opposite nodes that `largest` is between, along x. */
    double gap;     /**< Distance between the middles of the edges, m: the paper's measure. */
    double largest; /**< Largest distance between opposite nodes of the edges, m. */
    /** Component of the vector between the middles, left to right, along that vector at rest, which moves
     * with the drain's frame, m. It is negative when the edges have crossed. */
    double signed_gap;
    /** Distance between the lips at the middles of the edges, m, measured between the lines
     * through the wall there. At rest it is about the gap. Where lips meet it is 0 to a fifth of
     * the wall's thickness, for any rotation of the lips. Raised lips meet with their inner
     * corners or face to face, while `gap` is up to a whole wall. The opening is 0 (shut) where
     * one lip lies on the other. Method VBLAST measures it in the same manner. */
    double opening;
    double widest_opening; /**< Largest opening between opposite nodes of the edges, m. */
    double lips[2][3];     /**< End points of `opening`, left and right, m. */
} vbss_drain_gap;

/** Energies of a drain, J. */
typedef struct vbss_drain_energies {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    uint32_t reserved;    /**< Zero. */
    double kinetic;       /**< Kinetic energy of the lumped masses. */
    double membrane;      /**< Elastic energy of stretching; method VBLAST: zero. */
    double bending;       /**< Elastic energy of bending; method VBLAST: zero. */
    /** Energy of SPRING attachments; method VBLAST: also of the springs to the rest positions. */
    double springs;
    double gravity; /**< Potential, zero at the origin. */
    double total;   /**< Sum of the energies. */
} vbss_drain_energies;

/** Counters since creation, and results of the last step. */
typedef struct vbss_drain_statistics {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    uint32_t torn;        /**< Anchors that have torn off. */
    uint32_t inverted;    /**< Triangles that are inverted or collapsed at present. */
    uint32_t reserved;    /**< Zero. */
    uint64_t steps;       /**< Calls of #vbss_drain_step that succeeded, and steps of its scene. */
    /** Accepted parts of steps, equal to `steps` if none was halved; method VBLAST: explicit
     * steps. */
    uint64_t parts;
    uint64_t linearisations; /**< Linearisations assembled and solved. */
    /** Corrections that were not small against the increment, and were left out. */
    uint64_t corrections_dropped;
    uint64_t forced;  /**< Parts that moved a node beyond four move_limits at the last halving. */
    double last_move; /**< Largest displacement of a node in a part of the last step, m. */
    /** Largest displacement by the last correction of the last part, m: the remaining error is smaller. */
    double last_correction;
    double time; /**< Simulated time, s. */
    /** New matrices: a linearisation keeps the matrix of an earlier one while no node is farther than
     * 0.05 move_limit from where it was then. Method VBLAST: zero. */
    uint64_t matrices;
} vbss_drain_statistics;

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Fills a drain configuration with the defaults.
 *
 * @param[out] config  the configuration to fill
 * @param struct_size  `sizeof *config` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_drain_config_init(vbss_drain_config *config, uint32_t struct_size);

/**
 * Returns the default configuration that #vbss_drain_config_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_drain_config vbss_drain_config_default(void)
{
    vbss_drain_config vbss_filled;
    (void)vbss_drain_config_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Fills a surface with the defaults: no nodes, and NULL for all arrays.
 *
 * @param[out] surface  the surface to fill
 * @param struct_size   `sizeof *surface` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_drain_surface_init(vbss_drain_surface *surface, uint32_t struct_size);

/**
 * Returns the surface that #vbss_drain_surface_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_drain_surface vbss_drain_surface_default(void)
{
    vbss_drain_surface vbss_filled;
    (void)vbss_drain_surface_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Creates a drain at rest.
 *
 * @param context     owner
 * @param config      the configuration; NULL for the defaults
 * @param[out] drain  the new drain; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE (a field, or a surface that does not meet
 *         the rules of #vbss_drain_surface), VBSS_ERROR_NOT_FINITE, VBSS_ERROR_INCOMPATIBLE (a surface
 *         with method VBLAST), VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_drain_create(vbss_context *context, const vbss_drain_config *config,
                                       vbss_drain **drain);

/**
 * Destroys a drain.
 *
 * @param drain  the drain; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_IN_SCENE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_drain_destroy(vbss_drain *drain);

/**
 * Destroys a drain now, or when it leaves the scene that it belongs to: on #vbss_scene_remove and on
 * #vbss_scene_destroy. Until then the handle is valid. A host that has discarded all bodies of a
 * scene needs to destroy only the scene.
 *
 * @param drain  the drain; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_drain_discard(vbss_drain *drain);

/**
 * Advances a drain by one step. The call allocates nothing. If the new state is not finite, the
 * call fails and the drain keeps its state from before the step. With method VBLAST the call also
 * fails if a node is farther from its rest position than 100 times the length of the drain plus the
 * largest such distance of an attachment: the explicit steps have diverged, and the error text
 * states it.
 *
 * @param drain  the drain
 * @param h length of the step, s, 1e-7 to 0.1
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FINITE (h, or the state would be),
 *         VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_drain_step(vbss_drain *drain, double h);

/**
 * Sets positions and velocities of the nodes. Anchored nodes that have not torn off must keep their
 * position and have no velocity.
 *
 * @param drain       the drain
 * @param positions   3 doubles per node, m, each at most 1e3 in magnitude; NULL keeps them
 * @param velocities  3 doubles per node, m/s, each at most 1e5 in magnitude; NULL keeps them
 * @param node_count  number of nodes in the arrays, equal to the drain's
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_RANGE,
 *         VBSS_ERROR_IN_USE (an anchored node would move) or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_drain_set_state(vbss_drain *drain, const double *positions,
                                          const double *velocities, uint32_t node_count);

/**
 * Fills an attachment with the defaults.
 *
 * @param[out] attachment  the attachment to fill
 * @param struct_size      `sizeof *attachment` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_drain_attachment_init(vbss_drain_attachment *attachment,
                                                uint32_t struct_size);

/**
 * Returns the struct with the defaults that #vbss_drain_attachment_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_drain_attachment vbss_drain_attachment_default(void)
{
    vbss_drain_attachment vbss_filled;
    (void)vbss_drain_attachment_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Attaches something to a node. A node takes one PIN, and any number of the others. All fields must be in
 * their ranges, also those that the kind does not read.
 *
 * @param drain       the drain
 * @param attachment  the attachment
 * @param[out] id     identifier of the attachment, from 1 on, never reused in this drain
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_IN_USE (the node is pinned
 *         or anchored already), VBSS_ERROR_NOT_FINITE, VBSS_ERROR_CAPACITY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_drain_attach(vbss_drain *drain, const vbss_drain_attachment *attachment,
                                       uint32_t *id);

/**
 * Sets the target of an attachment for the end of the next step. A PIN, or the end of a SPRING,
 * moves there at constant velocity during the step, and then stays.
 *
 * @param drain   the drain
 * @param id      the attachment
 * @param target  PIN, SPRING: position, m; FORCE: the force, N, which changes at once
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no
 *         such attachment), VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_drain_set_attachment_target(vbss_drain *drain, uint32_t id,
                                                      const double target[3]);

/**
 * Removes an attachment.
 *
 * @param drain  the drain
 * @param id     the attachment
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FOUND (no such attachment) or
 *         VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_drain_detach(vbss_drain *drain, uint32_t id);

/**
 * Returns the force of an attachment on the drain at the end of the last step; zero before its first step.
 *
 * @param drain       the drain
 * @param id          the attachment
 * @param[out] force  receives the force, N
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_NOT_FOUND (no
 *         such attachment)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_drain_get_reaction(vbss_drain *drain, uint32_t id, double force[3]);

/**
 * Returns the nodes of the marks and of the points between which the gap is measured.
 *
 * @param drain        the drain
 * @param[out] places  receives the numbers
 * @param struct_size  `sizeof *places` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_drain_get_places(vbss_drain *drain, vbss_drain_places *places,
                                           uint32_t struct_size);

/**
 * Returns the opening of the slit.
 *
 * @param drain        the drain
 * @param[out] gap     receives the numbers
 * @param struct_size  `sizeof *gap` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_INCOMPATIBLE (a drain with a surface, which has no slit)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_drain_get_gap(vbss_drain *drain, vbss_drain_gap *gap,
                                        uint32_t struct_size);

/**
 * Returns a view of one of the drain's arrays.
 *
 * @param drain        the drain
 * @param field        the array
 * @param[out] view    receives the address and the shape of the array
 * @param struct_size  `sizeof *view` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_OUT_OF_RANGE (no such field)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_drain_get_view(vbss_drain *drain, vbss_drain_field field, vbss_view *view,
                                         uint32_t struct_size);

/**
 * Returns the drain's energies.
 *
 * @param drain          the drain
 * @param[out] energies  receives the numbers
 * @param struct_size    `sizeof *energies` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_drain_get_energies(vbss_drain *drain, vbss_drain_energies *energies,
                                             uint32_t struct_size);

/**
 * Returns the drain's counters.
 *
 * @param drain            the drain
 * @param[out] statistics  receives the numbers
 * @param struct_size      `sizeof *statistics` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_drain_get_statistics(vbss_drain *drain, vbss_drain_statistics *statistics,
                                               uint32_t struct_size);

/**
 * Saves the drain's state. A drain that restores it continues with identical bits, on any machine.
 *
 * @param drain         the drain
 * @param[out] bytes    receives the state; NULL with capacity 0 asks for its size, which logs no error
 * @param capacity      size of the buffer
 * @param[out] written  bytes of the state, also when it does not fit
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_CAPACITY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_drain_save(vbss_drain *drain, uint8_t *bytes, uint64_t capacity,
                                     uint64_t *written);

/**
 * Restores a saved state into this drain or an equally configured one. On failure the drain is
 * unchanged.
 *
 * @param drain  the drain
 * @param bytes  the state
 * @param count  its size
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED,
 *         VBSS_ERROR_CORRUPT, VBSS_ERROR_CAPACITY, VBSS_ERROR_DATA_VERSION, VBSS_ERROR_OUT_OF_MEMORY
 *         or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_drain_restore(vbss_drain *drain, const uint8_t *bytes, uint64_t count);

/**
 * Returns the XXH64 of the drain's state, its counters included; equal states have equal hashes on
 * every machine.
 *
 * @param drain      the drain
 * @param[out] hash  the hash
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_NULL_ARGUMENT
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_drain_get_hash(vbss_drain *drain, uint64_t *hash);

#ifdef __cplusplus
}
#endif

#endif
