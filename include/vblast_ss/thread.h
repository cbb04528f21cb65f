/**
 * @file thread.h
 * @brief A suture thread: an elastic rod, alone or as a body of a scene.
 *
 * The thread is a chain of `segment_count + 1` nodes, numbered from 0; segment i joins the nodes i
 * and i + 1. It resists stretching with EA and bending with EI, which are independent inputs, and
 * carries gravity. With a torsional stiffness GJ it resists twist, too; without (default) it has none.
 * Lengths are measured along the thread from node 0 ("arc length").
 *
 * Method IMPLICIT is implicit with the node positions as unknowns: one system of equations for a step,
 * generalised-alpha in time (Chung and Hulbert 1993; second order, high frequencies damped),
 * backward Euler where a motion starts or breaks. Method VBLAST is that of VBLaST-SS (Qi et al.
 * 2017): explicit springs, curvature-binormal bending, fast projection.
 *
 * The mesh is fixed or adapts to the shape (#VBSS_THREAD_MESH_ADAPTIVE). An adaptive mesh changes the
 * number of nodes in the views, and their generation, after steps.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_THREAD_H
#define VBLAST_SS_THREAD_H

#include <vblast_ss/base.h>
#include <vblast_ss/baseline.h>

/** A suture thread. */
typedef struct vbss_thread vbss_thread;

/** Discretisation of bending: a VBSS_THREAD_BENDING_ constant. Method VBLAST has its own bending. */
typedef int32_t vbss_thread_bending;

/** The constants of #vbss_thread_bending. */
enum {
    /** Fourth order: the energy of the cubic spline through the nodes, truncated to neighbours
     * three apart. The length of a segment is that of its arc. */
    VBSS_THREAD_BENDING_SPLINE = 0,
    /** Second order: each node couples with its two neighbours only. The length of a segment is its
     * chord. */
    VBSS_THREAD_BENDING_LOCAL = 1
};

/** Kind of a thread's mesh: a VBSS_THREAD_MESH_ constant. */
typedef int32_t vbss_thread_mesh;

/** The constants of #vbss_thread_mesh. */
enum {
    /** Nodes and rest lengths stay as they were created. */
    VBSS_THREAD_MESH_FIXED = 0,
    /** Method IMPLICIT, docs/explanation/adaptive.md: between two steps the thread divides segments where it is
     * bent or near another body, and removes nodes where it is straight and has clearance. This
     * renumbers nodes, segments, attachments, pins, grasps and contacts. */
    VBSS_THREAD_MESH_ADAPTIVE = 1
};

/** Material of a thread: a VBSS_THREAD_PRESET_ constant. */
typedef int32_t vbss_thread_preset;

/** The constants of #vbss_thread_preset. */
enum {
    /** 2-0 silk: 0.32 mm, 1.05e-4 kg/m, EA = 700 N (8.7 GPa), EI = 2.7e-8 N m^2. Diameter by USP
     * <861> (0.30 to 0.339 mm), density of a solid braid; EI is that of the paper's thread,
     * scaled with the fourth power of the radius, and uncertain by a factor of five. */
    VBSS_THREAD_PRESET_SILK_2_0 = 0,
    /** The thread of VBLaST-SS: 0.25 mm, 6.4e-5 kg/m, EA = 427 N, EI = 1e-8 N m^2. */
    VBSS_THREAD_PRESET_VBLAST = 1
};

/** Material of a suture: a VBSS_THREAD_MATERIAL_ constant. */
typedef int32_t vbss_thread_material;

/** The constants of #vbss_thread_material. docs/reference/sutures.md has sources and uncertainties. */
enum {
    VBSS_THREAD_MATERIAL_SILK = 0,          /**< Braided silk. */
    VBSS_THREAD_MATERIAL_POLYGLACTIN = 1,   /**< Braided polyglactin 910, absorbable. */
    VBSS_THREAD_MATERIAL_POLYPROPYLENE = 2, /**< Polypropylene monofilament. */
    VBSS_THREAD_MATERIAL_NYLON = 3          /**< Nylon monofilament. */
};

/** Size of a suture by USP <861>: a VBSS_THREAD_USP_ constant. */
typedef int32_t vbss_thread_usp_size;

/** The constants of #vbss_thread_usp_size, with the middle of the range of the diameter, mm. */
enum {
    VBSS_THREAD_USP_10_0 = -10, /**< 0.025 (0.020 to 0.029). */
    VBSS_THREAD_USP_9_0 = -9,   /**< 0.035 (0.030 to 0.039). */
    VBSS_THREAD_USP_8_0 = -8,   /**< 0.045 (0.040 to 0.049). */
    VBSS_THREAD_USP_7_0 = -7,   /**< 0.06 (0.050 to 0.069). */
    VBSS_THREAD_USP_6_0 = -6,   /**< 0.085 (0.070 to 0.099). */
    VBSS_THREAD_USP_5_0 = -5,   /**< 0.125 (0.100 to 0.149). */
    VBSS_THREAD_USP_4_0 = -4,   /**< 0.175 (0.150 to 0.199). */
    VBSS_THREAD_USP_3_0 = -3,   /**< 0.225 (0.200 to 0.249). */
    VBSS_THREAD_USP_2_0 = -2,   /**< 0.32 (0.300 to 0.339). */
    VBSS_THREAD_USP_0 = 0,      /**< 0.375 (0.350 to 0.399). */
    VBSS_THREAD_USP_1 = 1,      /**< 0.45 (0.400 to 0.499). */
    VBSS_THREAD_USP_2 = 2       /**< 0.55 (0.500 to 0.599). */
};

/** Configuration of a thread. Fill it with #vbss_thread_config_init, then change fields. */
typedef struct vbss_thread_config {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    vbss_method method;   /**< Method; default VBSS_METHOD_IMPLICIT. */
    /** Method IMPLICIT: discretisation of bending; default VBSS_THREAD_BENDING_SPLINE. */
    vbss_thread_bending bending;
    uint32_t segment_count;       /**< Number of segments, 1 to 65536; default 120. */
    uint32_t attachment_capacity; /**< Largest number of attachments, 0 to 256; default 8. */
    /** Largest number of cuts of this thread and its pieces, 0 to 64; default 0. */
    uint32_t cut_capacity;
    /** Length, m, 1e-6 to 1e3, at least 1e-7 per segment; default 0.15; ignored with
     * rest_lengths. */
    double length;
    /** Radius, m, 1e-7 to 0.1; default of VBSS_THREAD_PRESET_VBLAST. Contact in a scene and display
     * use it; a thread alone does not. */
    double radius;
    double linear_density;  /**< Mass per length, kg/m, 1e-9 to 1e3; default of that preset. */
    double axial_stiffness; /**< Axial stiffness EA, N, 1e-6 to 1e9; default of that preset. */
    /** Bending stiffness EI, N m^2, 0 to 1e3; default of that preset. */
    double bending_stiffness;
    /** Curvature at rest, 1/m, 0 to 1e4; default 0. Its plane is free, because such a thread has no
     * twist: it does not work with torsional_stiffness. */
    double rest_curvature;
    /** Gravitational acceleration, m/s^2, each component at most 1e6 in magnitude; default (0,
     * -9.81, 0). */
    double gravity[3];
    /** Drag coefficient, 1/s, 0 to 1e6; default 0. The force is -drag * mass * velocity. */
    double drag;
    /** Method IMPLICIT: decay rate of the motion relative to the rigid motion of each section, 1/s,
     * 0 to 1e6; default 0. It conserves linear and angular momentum. */
    double damping;
    /** Position of node 0, m, each coordinate at most 1e3 in magnitude; default (0, 0, 0); ignored
     * with positions. */
    double start[3];
    /** Direction from node 0 on, of any length from 1e-100 to 1e100; default (1, 0, 0); ignored
     * with positions. */
    double direction[3];
    /** Rest length of each segment, m, 1e-7 to 1e2; segment_count values, or NULL (default) for
     * length / segment_count each. #vbss_thread_grade_lengths fills such an array. The library copies
     * it. */
    const double *rest_lengths;
    /** Positions of the nodes, m, each at most 1e3; 3 (segment_count + 1) values, or NULL
     * (default) for a straight thread from start along direction. The library copies them. */
    const double *positions;
    /** Method IMPLICIT: spectral radius at infinite frequency of the time integration, 0 (strongest
     * damping) to 1 (none); default 0.3. Above 0.5 stiff motion may gain energy. */
    double spectral_radius;
    /** Method IMPLICIT: largest stretch error that a step may leave, 1e-12 to 1e-2; default 1e-6. */
    double stretch_tolerance;
    /** Method IMPLICIT: largest distance by which a further linearisation would move a node, m, 1e-12
     * to 1; an estimate; default 1e-6. */
    double position_tolerance;
    /** Method IMPLICIT: largest number of linearisations of an attempt, 1 to 100; default 40. Smooth
     * motion takes one or two. The worst known case (ends shaken by 3 mm every ms) takes 300 in a
     * step with its halves. */
    uint32_t iteration_limit;
    /** Method IMPLICIT: how often a step is halved before its state is accepted unconverged, 0 to
     * 10; default 5. `forced` counts such states and should stay zero. */
    uint32_t halving_limit;
    /** Method VBLAST: its parameters; NULL (default): their defaults. The library copies them. */
    const vbss_baseline_config *baseline;
    vbss_thread_mesh
        mesh; /**< Default VBSS_THREAD_MESH_FIXED, which ignores the following fields. */
    /** ADAPTIVE: largest number of nodes, segment_count + 1 to 65537; default 0: four times the
     * initial number of segments, at most 65536. A scene must have capacity for all of them when
     * the thread is added. */
    uint32_t node_capacity;
    /** ADAPTIVE: length of the finest segments, m, 1e-7 to coarsest_length; default 3e-4, 1.2
     * diameters of the paper's thread, at which a tight knot is converged. Because segments are
     * halved, the finest ones have 0.63 to 1.25 times this length. Choose initial lengths of
     * this length times a power of two. */
    double finest_length;
    /** ADAPTIVE: a node is not removed if that leaves a segment longer than 1.25 times this
     * length, m, at most 1e2; default 2e-3. */
    double coarsest_length;
    /** ADAPTIVE: curvature times length, rad, above which a segment is divided, 0.01 to 1; default 0.25. */
    double refine_angle;
    /** ADAPTIVE: curvature times length, rad, below which a node may be removed, 0 to half of
     * refine_angle; default 0.05. */
    double coarsen_angle;
    /** ADAPTIVE, in a scene: gap, m, to another strand below which a segment is divided down to finest_length, and
     * to a tool down to a quarter of its radius; 0 to 0.1; default 1e-3. The floor does not count. */
    double near_distance;
    /** ADAPTIVE, in a scene: a node is removed only if no other body is within this gap, m,
     * near_distance to 0.1; default 3e-3. */
    double clear_distance;
    /** ADAPTIVE: largest number of divisions and removals after a step, 0 to 64; default 4. */
    uint32_t mesh_operations;
    /** 1: contacts of a scene resist rolling of the thread about itself by their friction, so that a tight
     * knot holds twist on either side of itself; 0 (default): they let it roll. Needs
     * torsional_stiffness. docs/explanation/twist.md has the model. */
    uint32_t friction_torque;
    /** Method IMPLICIT: elastic curvature beyond which bending is plastic, 1/m, 0 to 1e6; default 0:
     * bending is elastic. The bending moment at yield is EI times this curvature.
     * docs/explanation/bending-memory.md has the model. Memory of bends, plastic or viscous, needs
     * VBSS_THREAD_MESH_FIXED and a rest_curvature of 0. */
    double yield_curvature;
    /** Stiffness of bending beyond yield as a fraction of EI, 0 (ideally plastic) to 0.999; default
     * 0. The hardening is linear and kinematic. */
    double yield_hardening;
    /** Method IMPLICIT: stiffness of the viscous branch of bending as a fraction of EI, 0 to 1e3;
     * default 0: there is none. A fast bend has the stiffness EI (1 + relaxation_ratio), a slow one
     * EI. */
    double relaxation_ratio;
    /** Time in which the moment of the viscous branch decays to 1/e at constant curvature, s, 1e-6 to
     * 1e9; default 1. */
    double relaxation_time;
    /** Method IMPLICIT: torsional stiffness GJ, N m^2, 0 to 1e3; default 0: the thread has no twist.
     * docs/explanation/twist.md has the model. Twist needs VBSS_THREAD_MESH_FIXED, a rest_curvature of 0 and
     * bends without memory. */
    double torsional_stiffness;
    /** Twist per length at which there is no torque, rad/m, -1e5 to 1e5; default 0; needs
     * torsional_stiffness. */
    double rest_twist;
} vbss_thread_config;

/** Kind of an attachment: a VBSS_THREAD_ATTACHMENT_ constant. */
typedef int32_t vbss_thread_attachment_kind;

/** The constants of #vbss_thread_attachment_kind. */
enum {
    VBSS_THREAD_ATTACHMENT_PIN = 0, /**< The node is held at `position`. */
    /** The node is held at `position`, and the thread's direction there is `direction`. */
    VBSS_THREAD_ATTACHMENT_CLAMP = 1,
    VBSS_THREAD_ATTACHMENT_FORCE = 2,  /**< `force` pulls at the node. */
    VBSS_THREAD_ATTACHMENT_SPRING = 3, /**< A spring-damper from `position` to the node. */
    VBSS_THREAD_ATTACHMENT_MASS = 4, /**< `mass` is fixed to the node; it has inertia and weight. */
    /** Threads with torsional_stiffness: holds the section at the node, which moves freely;
     * #vbss_thread_set_roll turns it. A CLAMP does this, too. */
    VBSS_THREAD_ATTACHMENT_ROLL = 5
};

/** An attachment acts on one node. Fill it with #vbss_thread_attachment_init. */
typedef struct vbss_thread_attachment {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    vbss_thread_attachment_kind kind; /**< Kind; default VBSS_THREAD_ATTACHMENT_PIN. */
    uint32_t node;                    /**< Node, 0 to segment_count; default 0. */
    uint32_t reserved;                /**< Zero. */
    /** PIN, CLAMP: target of the node in the next step; SPRING: its fixed end; m, each coordinate
     * at most 1e3 in magnitude. */
    double position[3];
    /** CLAMP: direction of the thread towards higher nodes, of any length from 1e-100 to 1e100;
     * default (1, 0, 0). A thread with another direction turns there in the next step. */
    double direction[3];
    double force[3];  /**< FORCE: force, N, each component at most 1e6 in magnitude. */
    double stiffness; /**< SPRING: stiffness, N/m, 0 to 1e9. */
    /** SPRING: damping of the velocity relative to the moving end, N s/m, 0 to 1e6. */
    double damping;
    double mass; /**< MASS: mass, kg, 0 to 1e3. */
} vbss_thread_attachment;

/** Reaction of an attachment in the last step. */
typedef struct vbss_thread_reaction {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    uint32_t node;        /**< The node, as cuts have renumbered it. */
    double force[3];      /**< Force of the attachment on the thread at the end of the step, N. */
    double torque[3];     /**< CLAMP, ROLL: torque of the attachment on the thread, N m; else 0. */
} vbss_thread_reaction;

/** An array of a thread: a VBSS_THREAD_VIEW_ constant. */
typedef int32_t vbss_thread_field;

/** The constants of #vbss_thread_field. n is the number of nodes. */
enum {
    VBSS_THREAD_VIEW_POSITIONS = 0,    /**< n x 3 doubles, m. */
    VBSS_THREAD_VIEW_VELOCITIES = 1,   /**< n x 3 doubles, m/s. */
    VBSS_THREAD_VIEW_REST_LENGTHS = 2, /**< n - 1 doubles, m. */
    VBSS_THREAD_VIEW_LENGTHS = 3, /**< n - 1 doubles, m: chords, or arcs with BENDING_SPLINE. */
    /** n - 1 doubles, N: force along each segment at the end of the last step, due to stretching
     * and bending. */
    VBSS_THREAD_VIEW_TENSIONS = 4,
    VBSS_THREAD_VIEW_CURVATURES =
        5, /**< n x 3 doubles, 1/m: from the node to the centre of curvature. */
    VBSS_THREAD_VIEW_SECTIONS =
        6, /**< First node of each section, uint32_t; the last ends at node n - 1. */
    /** n - 1 doubles, m: sagitta of each segment, the shape error due to the mesh. It is rest
     * length^2 / 8 times the larger curvature at the two nodes. Fixed meshes have it too. */
    VBSS_THREAD_VIEW_SAGITTAS = 7,
    /** n x 3 doubles, 1/m: plastic curvature at each node, towards the centre of curvature; at a
     * clamp as VBSS_THREAD_VIEW_CURVATURES. No entries in a thread without memory of bends. */
    VBSS_THREAD_VIEW_PLASTIC_CURVATURES = 8,
    /** The same for the viscous curvature: that at which the viscous branch has no moment. */
    VBSS_THREAD_VIEW_VISCOUS_CURVATURES = 9,
    /** n - 1 doubles, rad/m: twist per length of each segment; between a holder and a free end 0, with
     * friction_torque rest_twist where no contact resists. No entries in a thread without torsional_stiffness. */
    VBSS_THREAD_VIEW_TWISTS = 10,
    /** n - 1 x 3 doubles: a unit vector across each segment, at its middle, that is fixed to the material;
     * for display. No entries in a thread without torsional_stiffness. */
    VBSS_THREAD_VIEW_MATERIAL_DIRECTORS = 11
};

/** Energies of a thread, J. */
typedef struct vbss_thread_energies {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    uint32_t reserved;    /**< Zero. */
    double kinetic;       /**< Kinetic energy, attached masses included. */
    double stretching;    /**< Elastic energy of EA. */
    double bending;       /**< Elastic energy of bending; with memory what hardening stores, too. */
    double gravity;       /**< Potential, zero at the origin; attached masses included. */
    double total;         /**< Sum of the four and of `twisting`. */
    /** Energy that plastic and viscous bending have dissipated since creation, or since the cut that
     * made this piece; not part of the total; never decreases. */
    double dissipated;
    double twisting; /**< Elastic energy of twist. */
} vbss_thread_energies;

/** Momentum of a thread, attached masses included. */
typedef struct vbss_thread_momentum {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    uint32_t reserved;    /**< Zero. */
    double mass;          /**< Mass, kg. */
    double centre[3];     /**< Centre of mass, m. */
    double linear[3];     /**< Linear momentum, kg m/s. */
    double angular[3];    /**< Angular momentum about the origin, kg m^2/s. */
} vbss_thread_momentum;

/** Counters since creation, and results of the last step. #vbss_thread_get_baseline_statistics returns
 * what method VBLAST counts beside these. */
typedef struct vbss_thread_statistics {
    uint32_t struct_size;     /**< Bytes of this struct that the library filled. */
    uint32_t last_iterations; /**< IMPLICIT: linearisations of the last step. */
    uint64_t steps;           /**< Calls of #vbss_thread_step that succeeded. */
    uint64_t iterations;      /**< IMPLICIT: linearisations. */
    uint64_t substeps;        /**< Accepted parts of steps; equal to steps if none was divided. */
    uint64_t first_order;     /**< IMPLICIT: substeps made by backward Euler. */
    uint64_t rejections;      /**< IMPLICIT: attempts that were rejected and halved. */
    uint64_t forced;          /**< IMPLICIT: substeps accepted unconverged, at the last halving. */
    /** IMPLICIT: linearisations repeated with less compression, parts that started from the old positions because
     * the prediction was unusable, and parts in which the force of rest curvature was kept constant. */
    uint64_t softened;
    /** IMPLICIT: max |length / rest length - 1 - T / EA| after the last step; VBLAST: max |length / rest
     * length - 1|. */
    double last_stretch_error;
    double stretch_error; /**< Largest stretch error after any part of a step. */
    double last_stretch;  /**< max (length / rest length - 1) after the last step. */
    double time;          /**< Simulated time, s. */
    /* The following counters are 0 for a fixed mesh, except where they say otherwise. */
    uint64_t refined;   /**< Segments divided. */
    uint64_t coarsened; /**< Nodes removed. */
    /** Divisions whose new node is on the chord instead of the arc, for lack of clearance. */
    uint64_t laid_on_chord;
    /** Divisions refused because thread or scene had no free node. */
    uint64_t refused_capacity;
    /** Changes refused at or beside attachments, pins, grasps or the ends at a cut. */
    uint64_t refused_held;
    uint64_t refused_near; /**< Removals refused because another body was too near. */
    uint32_t nodes;        /**< Present number of nodes; also for a fixed mesh. */
    uint32_t most_nodes;   /**< Largest number of nodes so far; 0 for a fixed mesh. */
    double sagitta;        /**< Largest of VBSS_THREAD_VIEW_SAGITTAS, m; also for a fixed mesh. */
} vbss_thread_statistics;

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Fills a thread configuration with the defaults.
 *
 * @param[out] config  the configuration to fill
 * @param struct_size  `sizeof *config` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_thread_config_init(vbss_thread_config *config, uint32_t struct_size);

/**
 * Returns the default configuration that #vbss_thread_config_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_thread_config vbss_thread_config_default(void)
{
    vbss_thread_config vbss_filled;
    (void)vbss_thread_config_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Sets radius, linear density, EA and EI of a configuration to those of a known thread.
 *
 * @param[in,out] config  an initialised configuration
 * @param preset          the known thread
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or VBSS_ERROR_OUT_OF_RANGE (no
 *         such preset)
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_thread_config_preset(vbss_thread_config *config,
                                               vbss_thread_preset preset);

/**
 * Sets radius, linear density, EA and EI of a configuration to those of a suture. They follow from the
 * diameter of the size and from density, modulus of elasticity and modulus of bending of the material
 * (docs/reference/sutures.md): a braid bends far more easily than a solid rod, a monofilament like one.
 *
 * @param[in,out] config  an initialised configuration
 * @param material        the material
 * @param size            the size
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or VBSS_ERROR_OUT_OF_RANGE (no
 *         such material or size)
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_thread_config_suture(vbss_thread_config *config,
                                               vbss_thread_material material,
                                               vbss_thread_usp_size size);

/**
 * Divides a length into segments that are fine about one place and grow away from it by a constant
 * ratio, up to the largest length. The lengths sum to `length` up to rounding. For this the ratio
 * is lowered on either side. Segments that are too long even when equal are scaled, to no less than
 * half. A place closer to an end than half the finest length is moved to the end.
 *
 * @param length the length, m, 1e-6 to 1e3
 * @param centre             arc length of the fine place, m, 0 to length
 * @param finest             length of the segments there, m, 2e-7 to coarsest
 * @param coarsest           largest length, m, at most length
 * @param ratio              largest ratio of neighbours, 1 to 2
 * @param[out] rest_lengths  receives the lengths, m; may be NULL when capacity is 0
 * @param capacity           size of `rest_lengths`
 * @param[out] count         number of segments, also when they do not fit; 0 above 65536
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_RANGE or
 *         VBSS_ERROR_CAPACITY (more than capacity, or more than 65536)
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_thread_grade_lengths(double length, double centre, double finest,
                                               double coarsest, double ratio, double *rest_lengths,
                                               uint32_t capacity, uint32_t *count);

/**
 * Creates a thread at rest.
 *
 * @param context      owner
 * @param config       the configuration; NULL for the defaults
 * @param[out] thread  the new thread; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_INCOMPATIBLE (an adaptive
 *         mesh with method VBLAST; memory of bends with method VBLAST, an adaptive mesh or a rest
 *         curvature; torsional_stiffness with one of these three or with memory of bends; rest_twist
 *         without torsional_stiffness), VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_MEMORY or
 *         VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_thread_create(vbss_context *context, const vbss_thread_config *config,
                                        vbss_thread **thread);

/**
 * Destroys a thread; pieces cut from it remain.
 *
 * @param thread  the thread; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_IN_SCENE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_thread_destroy(vbss_thread *thread);

/**
 * Destroys a thread now, or when it leaves the scene that it belongs to: on #vbss_scene_remove and on
 * #vbss_scene_destroy; pieces cut from it remain. Until then the handle is valid. A host that has discarded all bodies of a
 * scene needs to destroy only the scene.
 *
 * @param thread  the thread; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_thread_discard(vbss_thread *thread);

/**
 * Advances a thread by one step. The call allocates nothing. If the new state is not finite, the
 * call fails and the thread keeps its state from before the step. With method VBLAST the call also
 * fails if a segment has become longer than 100 times the length of the thread plus the distance
 * that its attachments span: the explicit steps have diverged, and the error text states it. A
 * thread with an adaptive mesh then adapts it by its curvature alone, because only a scene knows
 * the distance to other bodies.
 *
 * @param thread  the thread
 * @param h length of the step, s, 1e-7 to 0.1
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FINITE (h, or the state would be),
 *         VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_thread_step(vbss_thread *thread, double h);

/**
 * Sets positions and velocities of the nodes. Nodes held by attachments move to their targets in the next step.
 * Plastic and viscous curvatures stay, in the plane of the new bend at each node and on the same side of it.
 * The twist between two holders of the section stays.
 *
 * @param thread      the thread
 * @param positions   3 doubles per node, m, each at most 1e3 in magnitude; NULL keeps them
 * @param velocities  3 doubles per node, m/s, each at most 1e5 in magnitude; NULL keeps them
 * @param node_count  number of nodes in the arrays, equal to the thread's
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FINITE, VBSS_ERROR_OUT_OF_RANGE or
 *         VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_thread_set_state(vbss_thread *thread, const double *positions,
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
VBSS_API vbss_result vbss_thread_attachment_init(vbss_thread_attachment *attachment,
                                                 uint32_t struct_size);

/**
 * Returns the struct with the defaults that #vbss_thread_attachment_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_thread_attachment vbss_thread_attachment_default(void)
{
    vbss_thread_attachment vbss_filled;
    (void)vbss_thread_attachment_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Attaches something to a node. A node takes one PIN or CLAMP, one CLAMP or ROLL, and any number of the others. All fields
 * must be in their ranges, also those that the kind does not read.
 *
 * @param thread      the thread
 * @param attachment the attachment
 * @param[out] id     identifier of the attachment, from 1 on, never reused in this thread
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_IN_USE (the node is held
 *         already), VBSS_ERROR_INCOMPATIBLE (a ROLL on a thread without twist), VBSS_ERROR_NOT_FINITE,
 *         VBSS_ERROR_CAPACITY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_thread_attach(vbss_thread *thread,
                                        const vbss_thread_attachment *attachment, uint32_t *id);

/**
 * Sets the target of an attachment for the end of the next step. The attachment moves there at
 * constant velocity during the step, and then stays.
 *
 * @param thread     the thread
 * @param id         the attachment, not a MASS
 * @param target     PIN, CLAMP, SPRING: position, m; FORCE: the force, N, which changes at once
 * @param direction  CLAMP: as in #vbss_thread_attachment; NULL keeps it
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no
 *         such attachment), VBSS_ERROR_INCOMPATIBLE (a MASS), VBSS_ERROR_OUT_OF_RANGE,
 *         VBSS_ERROR_NOT_FINITE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_thread_set_attachment_target(vbss_thread *thread, uint32_t id,
                                                       const double target[3],
                                                       const double *direction);

/**
 * Sets the roll of a CLAMP or ROLL for the end of the next step: the angle by which it has turned the
 * section about the thread since it was attached. The section rolls at constant speed during the step, and then
 * stays. A change of the thread's direction takes the section along without spin. A new holder has the roll 0
 * and leaves the twist of the thread as it is. The twist between a holder and a free end is zero.
 *
 * @param thread  the thread, with torsional_stiffness above 0
 * @param id      the attachment, a CLAMP or ROLL
 * @param roll    angle, rad, -1e6 to 1e6, any number of turns; positive by the right-hand rule about the
 *                direction towards higher nodes
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FOUND (no such attachment),
 *         VBSS_ERROR_INCOMPATIBLE (another kind, or a thread without twist), VBSS_ERROR_OUT_OF_RANGE,
 *         VBSS_ERROR_NOT_FINITE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_thread_set_roll(vbss_thread *thread, uint32_t id, double roll);

/**
 * Removes an attachment. The twist between its neighbours is the sum of those on either side, or zero at a
 * free end.
 *
 * @param thread  the thread
 * @param id      the attachment
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FOUND (no such attachment) or
 *         VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_thread_detach(vbss_thread *thread, uint32_t id);

/**
 * Returns the reaction of an attachment in the last step, regardless of later changes; zero before
 * its first step. While a scene has a suspended step (vbss_solver_options::call_budget_us), the last step
 * may be some calls ago. A host that feeds a spring's force back to a hand should then compute it
 * as stiffness times the current distance of both ends; a delayed force lets the hand wind the
 * thread up.
 *
 * @param thread         the thread
 * @param id             the attachment
 * @param[out] reaction  receives the reaction
 * @param struct_size    `sizeof *reaction` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_NOT_FOUND (no such attachment)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_thread_get_reaction(vbss_thread *thread, uint32_t id,
                                              vbss_thread_reaction *reaction, uint32_t struct_size);

/**
 * Cuts a thread in two. The segment at the place is divided, unless a node is within 1 % of a
 * segment or 1e-7 m of it, which is then doubled. The thread keeps the part with node 0; the piece is a thread
 * of its own with the same material and settings, its node 0 at the cut. Attachments go with their
 * nodes and keep their ids; one on a doubled node stays with the thread. Plastic and viscous curvatures
 * stay with their nodes; a node inside a divided segment begins without. Memory was reserved by
 * cut_capacity, which both parts share.
 *
 * @param thread      the thread
 * @param arc_length  place of the cut, m from node 0, measured in rest lengths, inside the thread
 * @param[out] piece  the far part; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FINITE,
 *         VBSS_ERROR_OUT_OF_RANGE (not inside, or within 1 % of a segment of an end),
 *         VBSS_ERROR_CAPACITY (no cuts left) or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_thread_cut(vbss_thread *thread, double arc_length, vbss_thread **piece);

/**
 * Returns a view of one of the thread's arrays.
 *
 * @param thread       the thread
 * @param field the array
 * @param[out] view    receives the view
 * @param struct_size  `sizeof *view` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_OUT_OF_RANGE (no such field)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_thread_get_view(vbss_thread *thread, vbss_thread_field field,
                                          vbss_view *view, uint32_t struct_size);

/**
 * Returns the thread's energies.
 *
 * @param thread         the thread
 * @param[out] energies  receives the numbers
 * @param struct_size    `sizeof *energies` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_thread_get_energies(vbss_thread *thread, vbss_thread_energies *energies,
                                              uint32_t struct_size);

/**
 * Returns the thread's momentum.
 *
 * @param thread         the thread
 * @param[out] momentum  receives the numbers
 * @param struct_size    `sizeof *momentum` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_thread_get_momentum(vbss_thread *thread, vbss_thread_momentum *momentum,
                                              uint32_t struct_size);

/**
 * Returns the thread's counters.
 *
 * @param thread           the thread
 * @param[out] statistics  receives the numbers
 * @param struct_size      `sizeof *statistics` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_thread_get_statistics(vbss_thread *thread,
                                                vbss_thread_statistics *statistics,
                                                uint32_t struct_size);

/**
 * Returns what method VBLAST counts in a thread.
 *
 * @param thread          the thread
 * @param[out] statistics  receives the counters
 * @param struct_size      `sizeof *statistics` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INCOMPATIBLE if the thread uses another method, VBSS_ERROR_INVALID_HANDLE,
 * VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_thread_get_baseline_statistics(vbss_thread *thread,
                                                         vbss_baseline_statistics *statistics,
                                                         uint32_t struct_size);

/**
 * Saves the thread's state. A thread that restores it continues with identical bits, on any machine.
 *
 * @param thread        the thread
 * @param[out] bytes    receives the state; NULL with capacity 0 asks for its size, which logs no error
 * @param capacity      size of the buffer
 * @param[out] written  bytes of the state, also when it does not fit
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_CAPACITY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_thread_save(vbss_thread *thread, uint8_t *bytes, uint64_t capacity,
                                      uint64_t *written);

/**
 * Restores a saved state into this thread or an equally configured one. Later cuts are not undone
 * in the pieces, which are separate threads. On failure the thread is unchanged.
 *
 * @param thread  the thread
 * @param bytes   the state
 * @param count   its size
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED,
 *         VBSS_ERROR_CORRUPT, VBSS_ERROR_CAPACITY, VBSS_ERROR_DATA_VERSION, VBSS_ERROR_OUT_OF_MEMORY
 *         or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_thread_restore(vbss_thread *thread, const uint8_t *bytes, uint64_t count);

/**
 * Returns the XXH64 of the thread's state, its counters included; equal states have equal hashes on
 * every machine.
 *
 * @param thread     the thread
 * @param[out] hash  the hash
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_NULL_ARGUMENT
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_thread_get_hash(vbss_thread *thread, uint64_t *hash);

#ifdef __cplusplus
}
#endif

#endif
