/**
 * @file scene.h
 * @brief A scene simulates threads, drains, graspers, needles, other rigid bodies and a floor in
 *   contact with friction.
 *
 * Bodies of a scene are numbered from 1 on; body 0 is the world: the floor, and pins in space. A
 * thread belongs to the scene from its addition to its removal. Meanwhile stepping, cutting,
 * restoring or destroying it alone returns VBSS_ERROR_IN_SCENE; attachments, their targets and
 * views still work. #vbss_scene_cut_thread cuts it. The same rules hold for a drain (drain.h). Its
 * surfaces lie half the wall's thickness to either side of the middle; both touch all bodies and
 * each other. With method VBLAST only its edges touch other bodies, and not each other. Rigid bodies
 * are sets of capsules. A driven body follows its target exactly. A coupled body is a proxy that a
 * spring and a damper tie to its target, so an obstacle of the thread also stops the tool. A free
 * body moves under forces. A grasper (grasper.h) is a coupled body with jaws that hold threads,
 * needles and walls of drains; with method VBLAST it is driven. A needle (needle.h) is a free body.
 * Its tip pierces the wall of a drain when it presses hard enough. The hole then slides along the
 * needle and along the thread behind it (#vbss_scene_get_hole). With method VBLAST a needle follows
 * the first tool that has grasped it, and holes do not depend on forces.
 *
 * Method IMPLICIT solves one system of equations for all bodies and contacts: unilateral contact with
 * Coulomb friction that sticks without creep. A guard (CCD) tests each step: in an accepted step no
 * axis of a body passes through another body. It exempts a needle or a thread near its holes, a
 * held body near the jaws that hold it, and a thread near its pin, against the pin's body
 * (#vbss_scene_pin_thread). It also exempts segments so near along a thread that they do not touch,
 * and the ends at a cut until they have come apart. Method VBLAST is that of VBLaST-SS (Qi et al.
 * 2017): explicit steps, edge tests at both ends of a step, displacements as response, no friction,
 * knots held by pins. See docs/explanation/paper-scene.md.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_SCENE_H
#define VBLAST_SS_SCENE_H

#include <vblast_ss/base.h>
#include <vblast_ss/baseline.h>
#include <vblast_ss/drain.h>
#include <vblast_ss/grasper.h>
#include <vblast_ss/needle.h>
#include <vblast_ss/solver_options.h>
#include <vblast_ss/thread.h>

/** Bodies that touch each other and are stepped together. */
typedef struct vbss_scene vbss_scene;

/** Behaviour when a step finds no acceptable state at once: a VBSS_SCENE_MODE_ constant. */
typedef int32_t vbss_scene_mode;

/** The constants of #vbss_scene_mode. */
enum {
    /** The work and the attempts of a step are limited, and the work of a call, so that it ends in
     * time: see `step_budget_us` and `call_budget_us` of #vbss_solver_options. Work left over is
     * deferred to the next call. Time that would be deferred too long is left out and counted in
     * `paused`. As a result tight knots of many throws slip a little early. */
    VBSS_SCENE_MODE_REAL_TIME = 0,
    /** A step takes all the work that it needs. It is halved as often as `halving_limit` allows, and
     * only then truncated, which is counted in `clamped`. After eight truncated parts the rest of
     * the step is left out, for the bodies of these parts alone, and counted in `paused`. For
     * experiments. */
    VBSS_SCENE_MODE_OFFLINE = 1
};

/** Treatment of a new body that overlaps another one or the floor: a VBSS_SCENE_OVERLAP_ constant. */
typedef int32_t vbss_scene_overlap_policy;

/** The constants of #vbss_scene_overlap_policy. */
enum {
    VBSS_SCENE_OVERLAP_WARN =
        0, /**< The body is added; a warning in the log names the other body and the depth. */
    /** The call returns VBSS_ERROR_OUT_OF_RANGE, and nothing has changed. */
    VBSS_SCENE_OVERLAP_REFUSE = 1,
    VBSS_SCENE_OVERLAP_ALLOW = 2 /**< The body is added without a check. */
};

/** Configuration of a scene. Fill it with #vbss_scene_config_init, then change fields. */
typedef struct vbss_scene_config {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    /** Method; default VBSS_METHOD_IMPLICIT. Bodies of the scene must have the same method. */
    vbss_method method;
    vbss_scene_mode mode;     /**< Mode; default VBSS_SCENE_MODE_REAL_TIME. */
    uint32_t thread_capacity; /**< Largest number of threads at a time, 0 to 64; default 4. */
    /** Largest number of nodes of all threads, 0 to 8192; default 1024. */
    uint32_t node_capacity;
    /** Largest number of rigid bodies and graspers, 0 to 256; default 4. */
    uint32_t rigid_capacity;
    /** Largest number of capsules of these bodies, 0 to 4096; default 16. */
    uint32_t capsule_capacity;
    uint32_t pin_capacity; /**< Largest number of pins at a time, 0 to 256; default 8. */
    /** Largest number of contacts that may close at a time, 0 to 65536; default 1024. */
    uint32_t contact_capacity;
    /** Largest number of candidate pairs, 0 to 1e7; default 16384. */
    uint32_t candidate_capacity;
    /** Largest number of events that are kept until the host takes them (scene_event.h), and of those of
     * a step, 0 to 65536; default 256. */
    uint32_t event_capacity;
    int32_t floor; /**< 1: a floor fills the half-space below a plane; default 0. */
    /** Direction up, of any length from 1e-100 to 1e100; default (0, 1, 0). */
    double floor_normal[3];
    /** Height of the plane along its normal, m, at most 1e3 in magnitude; default 0. */
    double floor_height;
    double floor_friction; /**< Coefficient of friction of the floor, 0 to 10; default 0.3. */
    /** Coefficient of friction between threads, 0 to 10; default 0.3 (silk on silk; the literature
     * has 0.1 to 0.4). */
    double thread_friction;
    /** Normal and tangential stiffness of a contact, N/m, 1e3 to 1e9; default 2e5: 5 um at 1 N. */
    double contact_stiffness;
    /** Largest number of grasped places of threads at a time, 0 to 256; default 8. Places that jaws
     * have released but not cleared count too, and so do the two ends at each cut of blades.
     * Without capacity the jaws stay open. */
    uint32_t grasp_capacity;
    uint32_t drain_capacity; /**< Largest number of drains at a time, 0 to 16; default 1. */
    /** Largest number of holes of needles and threads in walls at a time, 0 to 256; default 16. */
    uint32_t hole_capacity;
    /** Treatment of overlapping new bodies; default VBSS_SCENE_OVERLAP_WARN. */
    vbss_scene_overlap_policy overlap;
    /** Largest speed of any point of a driven or coupled body, or of a grasper, on the way to
     * its target, m/s, 0 to 1e6; 0: no limit; default 20. A body approaches a target that is
     * farther away at this speed, over several steps. A pose in the wrong unit, or a jump of a
     * device, then causes no long step and no extreme force. Method IMPLICIT only. Logs and
     * snapshots store the limit, and a scene with another one rejects them. One exception:
     * scenes without a limit and with the default limit accept each other's snapshots. */
    double speed_limit;
    /** Method IMPLICIT: capacity of the linear system's matrix and its factor for threads and rigid
     * bodies, in blocks of 3 x 3 numbers of 96 bytes, 0 to 1e7; 0 (default): 4096, and 20 for each
     * node of node_capacity and 40 for each body of rigid_capacity. A node without contact takes up
     * to 12 blocks, one of a tight knot 42; each drain adds its own. A step that needs more returns
     * VBSS_ERROR_CAPACITY. See docs/reference/memory.md. */
    uint32_t matrix_capacity;
    uint32_t reserved; /**< Zero. */
    /** VBLAST: its parameters; NULL (default): their defaults. The library copies them. */
    const vbss_baseline_config *baseline;
    /** Options of the solver, with the budgets of steps and calls; NULL (default): their defaults. The
     * scene copies them. */
    const vbss_solver_options *solver;
} vbss_scene_config;

/** The deepest overlap of a body. */
typedef struct vbss_scene_overlap {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    uint32_t body;        /**< Number of the other body; 0: the floor, or none if depth is 0. */
    double depth;         /**< Depth of the overlap of the two surfaces, m; 0: no overlap. */
} vbss_scene_overlap;

/** Kind of motion of a rigid body: a VBSS_SCENE_RIGID_ constant. */
typedef int32_t vbss_scene_rigid_kind;

/** The constants of #vbss_scene_rigid_kind. */
enum {
    VBSS_SCENE_RIGID_DRIVEN =
        0, /**< The body follows its target exactly; only the guard can stop it. */
    VBSS_SCENE_RIGID_COUPLED =
        1, /**< The body is a proxy that a virtual coupling ties to its target. */
    VBSS_SCENE_RIGID_FREE = 2 /**< The body moves under forces. */
};

/** One capsule of a rigid body, in the frame of the body. */
typedef struct vbss_scene_capsule {
    double begin[3]; /**< One end of the axis, m. */
    double end[3];   /**< The other end of the axis, m; equal ends make a ball. */
    double radius;   /**< Radius, m, 1e-6 to 1. */
} vbss_scene_capsule;

/** Configuration of a rigid body. Fill it with #vbss_scene_rigid_config_init, then change fields. */
typedef struct vbss_scene_rigid_config {
    uint32_t struct_size;       /**< Size of this struct in bytes, set by the init function. */
    vbss_scene_rigid_kind kind; /**< Kind of motion; default VBSS_SCENE_RIGID_DRIVEN. */
    uint32_t capsule_count;     /**< Number of capsules, 1 to 256. */
    uint32_t reserved;          /**< Zero. */
    const vbss_scene_capsule
        *capsules; /**< Array of capsule_count capsules; the library copies it. */
    /** Position of the origin of the frame, m, each coordinate at most 1e3 in magnitude; default
     * 0. */
    double position[3];
    /** Orientation w, x, y, z, of any length from 1e-100 to 1e100; default 1, 0, 0, 0. */
    double orientation[4];
    /** COUPLED, FREE: velocity of the origin, m/s, each component at most 1e5 in magnitude; default
     * 0. */
    double velocity[3];
    /** COUPLED, FREE: angular velocity, rad/s, each component at most 1e6 in magnitude; default 0.
     * A body turns by at most a quarter of a turn in a part of a step; a faster one slows down. */
    double angular_velocity[3];
    /** Mass of the body, kg, 1e-9 to 1e3; default 0.02. It is distributed over the capsules as over
     * solids of one material; overlaps count twice. */
    double mass;
    /** Gravitational acceleration, m/s^2, each component at most 1e6 in magnitude; default 0,
     * because hands carry their tools. */
    double gravity[3];
    /** Coefficient of friction, 0 to 10; default 0.15. A contact with a thread uses this
     * coefficient, any other the geometric mean of both bodies. */
    double friction;
    double stiffness;         /**< COUPLED: stiffness, N/m, 0 to 1e9; default 2000. */
    double damping;           /**< COUPLED: damping, N s/m, 0 to 1e6; default 5. */
    double turning_stiffness; /**< COUPLED: rotational stiffness, N m/rad, 0 to 1e9; default 2. */
    /** COUPLED: rotational damping, N m s/rad, 0 to 1e6; default 0.005. */
    double turning_damping;
} vbss_scene_rigid_config;

/** State of a rigid body. */
typedef struct vbss_scene_rigid_state {
    uint32_t struct_size;         /**< Bytes of this struct that the library filled. */
    vbss_scene_rigid_kind kind;   /**< Kind of motion. */
    double position[3];           /**< Position of the origin of its frame, m. */
    double orientation[4];        /**< Orientation from body to world, w, x, y, z. */
    double velocity[3];           /**< Velocity of the origin, m/s. */
    double angular_velocity[3];   /**< Angular velocity in the world frame, rad/s. */
    double target_position[3];    /**< Target position of the origin, m. */
    double target_orientation[4]; /**< Target orientation, w, x, y, z. */
    /** Force on the hand, N: the opposite of the coupling's force; for a driven body the sum of its
     * contacts and pins. Zero for a free body. */
    double hand_force[3];
    double hand_torque[3]; /**< Torque on the hand about the origin of the body's frame, N m. */
    /** Sum of the forces of all contacts and pins on the body in the last step, N. */
    double contact_force[3];
    double contact_torque[3]; /**< Their torque about the origin of the body's frame, N m. */
} vbss_scene_rigid_state;

/** An array of a scene: a VBSS_SCENE_VIEW_ constant. */
typedef int32_t vbss_scene_field;

/** The constants of #vbss_scene_field. Contacts are those that carried a force at the end of the
 * last step, in the order of their features. With method VBLAST they are those with a response. */
enum {
    /** x 5 uint32_t: #vbss_scene_contact_kind, body a, feature a, body b, feature b. Features are
     * segments or nodes of a thread, capsules of a rigid body (2 times the capsule, plus the end
     * if an end touches), and nodes, triangles or sides of a drain; floor and planes have feature 0. Each
     * side of a drain's triangles is numbered once, in the order of its two nodes, the lower node
     * first. */
    VBSS_SCENE_VIEW_CONTACTS = 0,
    VBSS_SCENE_VIEW_CONTACT_POINTS = 1,  /**< x 3: point between the two surfaces, m. */
    VBSS_SCENE_VIEW_CONTACT_NORMALS = 2, /**< x 3: unit normal from b to a. */
    /** x 3: force of b on a, N. When a search for contact states has exhausted its work limit,
     * these are forces with which all bodies balance. They miss the contact law by the residual,
     * and may pull. */
    VBSS_SCENE_VIEW_CONTACT_FORCES = 3,
    /** x 1: distance of the surfaces, m; negative when they overlap. */
    VBSS_SCENE_VIEW_CONTACT_GAPS = 4
};

/** Features of a contact: a VBSS_SCENE_CONTACT_ constant. */
typedef int32_t vbss_scene_contact_kind;

/** The constants of #vbss_scene_contact_kind. */
enum {
    VBSS_SCENE_CONTACT_SEGMENTS = 0,        /**< Two segments of threads. */
    VBSS_SCENE_CONTACT_NODE_CAPSULE = 1,    /**< A smoothed point of a fine thread and a capsule. */
    VBSS_SCENE_CONTACT_SEGMENT_CAPSULE = 2, /**< A segment of a coarse thread and a capsule. */
    VBSS_SCENE_CONTACT_NODE_FLOOR = 3,      /**< A node of a thread and the floor, or a plane. */
    VBSS_SCENE_CONTACT_CAPSULES = 4,        /**< Two capsules of different bodies. */
    VBSS_SCENE_CONTACT_CAPSULE_FLOOR = 5,   /**< An end of a capsule and the floor, or a plane. */
    /** A held point and a grasper. The feature of a thread is 3 times the index of the grasp plus
     * the index of one of its three held points. The feature of a needle or a drain is the index
     * of the held point. The feature of the grasper is 0. */
    VBSS_SCENE_CONTACT_GRASP = 6,
    /** A node of a thread, an end of a capsule or a node of a drain, with a triangle of a drain. */
    VBSS_SCENE_CONTACT_POINT_FACE = 7,
    /** A segment of a thread, a capsule or a side of a drain's triangle, with a side of a drain's
     * triangle. */
    VBSS_SCENE_CONTACT_SIDES = 8,
    VBSS_SCENE_CONTACT_DRAIN_FLOOR = 9, /**< A node of a drain and the floor, or a plane. */
    /** A needle or a thread in a hole of a drain. The feature of the suture is the index of the
     * hole; the feature of the drain is 0. The normal is along the suture. VBLAST: a place where
     * particles were moved. */
    VBSS_SCENE_CONTACT_HOLE = 10
};

/** Counters since creation, and results of the last step. Method VBLAST leaves `rows`, `separators` and
 * the counters of attempts, solves, the guard and operations at 0; #vbss_scene_get_baseline_statistics
 * returns what it counts. */
typedef struct vbss_scene_statistics {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    uint32_t contacts;    /**< Contacts that carry a force after the last step. */
    uint32_t rows;        /**< Contacts that could have closed in the last part. */
    uint32_t separators;  /**< Blocks of the last part's system that contacts couple. */
    uint64_t steps;       /**< Calls of #vbss_scene_step that succeeded. */
    uint64_t parts;       /**< Accepted parts of steps; equal to `steps` if no step was divided. */
    uint64_t attempts;    /**< Attempts, rejected ones included. */
    uint64_t linearisations; /**< Linearisations of all attempts. */
    uint64_t state_solves;   /**< Solves of the separators' system. */
    /** Times the sparsity pattern of that system was computed; not part of the state. */
    uint64_t patterns;
    uint64_t rejected_states; /**< Attempts rejected because contact states were not found. */
    /** Attempts rejected because lengths or shapes did not converge, or a node of a drain moved too
     * far. */
    uint64_t rejected_stretch;
    uint64_t rejected_depth; /**< Attempts rejected because of penetration. */
    /** Attempts rejected by the guard: bodies would pass through each other, or come too near. */
    uint64_t rejected_guard;
    /** Attempts rejected because a pivot was too small or a number was not finite. */
    uint64_t rejected_singular;
    /** Attempts rejected because candidates or contacts exceeded their capacity. */
    uint64_t rejected_full;
    /** Attempts accepted with a residual of up to 5 % in the contact law. */
    uint64_t loose_states;
    uint64_t loose_stretch;  /**< Parts accepted with a stretch error above the tolerance. */
    uint64_t clamped;        /**< Parts truncated by the guard. */
    uint64_t recovering;     /**< Parts accepted that reduced a penetration above the tolerance. */
    uint64_t guard_pairs;    /**< Pairs that the guard has tested or knows to be apart. */
    double last_penetration; /**< Largest penetration after the last step, m. */
    double penetration;      /**< Largest penetration of all steps, m. */
    /** IMPLICIT: max |length / rest length - 1 - T / EA| after the last step; VBLAST: max |length /
     * rest length - 1|. */
    double last_stretch_error;
    double stretch_error; /**< Largest stretch error of all steps. */
    double last_residual; /**< Residual of the contact law after the last part, N. */
    double time;          /**< Sum of the lengths of the steps, `time_paused` included, s. */
    uint64_t
        operations; /**< Operations of all steps, as the step budget counts them; method IMPLICIT. */
    uint64_t most_operations; /**< Largest number of operations of a step. */
    uint64_t paused;          /**< REAL_TIME: steps of which a part, or all, was left out. */
    double time_paused;       /**< Simulated time that these steps have lost, s. */
    /** Calls after which a step was suspended or had not begun; see
     * vbss_solver_options::call_budget_us. */
    uint64_t deferred;
    uint32_t behind; /**< Number of suspended and unbegun steps after the last call, 0 to 2. */
    /** Steps that two calls had suspended while other bodies waited, so that the third completed
     * them without the budget of a call. */
    uint32_t overdue;
    double
        torn_length; /**< Length that threads have torn at holes, m (vbss_drain_config::tear_energy). */
    double tear_work; /**< Energy that this has dissipated, J. */
} vbss_scene_statistics;

/** Reason why bodies are held back: a VBSS_SCENE_BLOCKER_ constant. */
typedef int32_t vbss_scene_blocker_cause;

/** The constants of #vbss_scene_blocker_cause. */
enum {
    VBSS_SCENE_BLOCKER_WORK = 0, /**< The work limit of the step was exhausted. */
    VBSS_SCENE_BLOCKER_COLLISION =
        1, /**< The bodies would pass through each other, or come too near. */
    VBSS_SCENE_BLOCKER_PENETRATION =
        2, /**< The bodies penetrate each other by more than the tolerance. */
    VBSS_SCENE_BLOCKER_CONTACT = 3, /**< No contact forces were found that obey the contact law. */
    VBSS_SCENE_BLOCKER_CONVERGENCE = 4 /**< The motion of the body did not converge. */
};

/** Two bodies that hold each other back, and all bodies that touch them. A failed step holds back
 * only the bodies that contacts, grasps, holes or pins connect with these two. All other bodies
 * move on. */
typedef struct vbss_scene_blocker {
    uint32_t struct_size;           /**< Bytes of this struct that the library filled. */
    vbss_scene_blocker_cause cause; /**< Cause in the last step that held them back. */
    uint32_t body_a;                /**< Number of one body; 0: unknown. */
    uint32_t body_b;  /**< Number of the other body; 0: the floor, or no second body. */
    double since;     /**< Simulated time at which they were first held back, s. */
    double lost_time; /**< Simulated time that they have lost since then, s. */
    double depth; /**< Their deepest overlap in the last step that held them back, m; 0: none. */
} vbss_scene_blocker;

/** A hole of a needle or a thread in a drain or host surface. */
typedef struct vbss_scene_hole {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    uint32_t id;          /**< Identifier from 1 on, in the order of creation; never reused. */
    uint32_t needle;      /**< Number of the needle in the hole; 0: a thread is in it. */
    uint32_t drain;       /**< Number of the drain or host surface. */
    uint32_t triangle;    /**< Triangle of it. */
    uint32_t outward;     /**< 1: the tip went through from inside; 0: from outside. */
    double weights[3];    /**< Weights of the triangle's nodes at the hole. */
    /** Position of the hole on the drain at rest, m: VBSS_DRAIN_VIEW_REST_POSITIONS. In a host surface the
     * same as `position`. */
    double rest_position[3];
    double position[3]; /**< Current position of the hole, in the middle of the wall, m. */
    /** Unit direction of the suture at the hole, towards the needle's tip, or the thread's
     * beginning. */
    double direction[3];
    /** Arc length of the suture at the hole, m. For a needle it is measured from the tip, and is
     * negative before the tip has reached the middle of the wall. For a thread it is measured from
     * the beginning. Near the swage it may be up to 0.2 mm beyond an end. */
    double arc_length;
    double friction;   /**< Friction on the suture along `direction`, N. */
    double force[3];   /**< Force on the suture, N. */
    uint32_t thread;   /**< Number of the thread in the hole; 0: a needle is in it. */
    uint32_t reserved; /**< Zero. */
    /** Length of the cut by which the thread has torn this hole, m: along the wall as it was then, in the
     * plane of its triangles (vbss_drain_config::tear_energy). */
    double torn_length;
    double tear_work; /**< Energy that this has dissipated, J. */
} vbss_scene_hole;

/** A grasped place of a thread, a needle or a drain. */
typedef struct vbss_scene_grasp {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    uint32_t body;        /**< Number of the grasped body in the scene. */
    /** Arc length of the middle of the held part, m: unstretched along a thread, or from a needle's
     * tip. */
    double arc_length;
    double position[3]; /**< Position of that middle, m. */
    /** Force of the jaws on the held body in the last step, N. While the body slides, it exceeds
     * the limit by the clamp's gain in a step. */
    double force[3];
    double limit; /**< Largest force along the jaws' faces that they bear, N; VBLAST: 0. */
    double slid;  /**< Distance that the body has slid through the jaws since it was grasped, m. */
} vbss_scene_grasp;

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Fills a configuration with the defaults.
 *
 * @param[out] config  the configuration to fill
 * @param struct_size  `sizeof *config` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_config_init(vbss_scene_config *config, uint32_t struct_size);

/**
 * Returns the default configuration that #vbss_scene_config_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_scene_config vbss_scene_config_default(void)
{
    vbss_scene_config vbss_filled;
    (void)vbss_scene_config_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Creates a scene without bodies, and allocates the memory that steps need.
 *
 * @param context     owner
 * @param config   configuration; NULL for the defaults
 * @param[out] scene  the new scene; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE,
 *         VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_create(vbss_context *context, const vbss_scene_config *config,
                                       vbss_scene **scene);

/**
 * Destroys a scene with its rigid bodies and pins; its threads, drains and graspers no longer
 * belong to a scene.
 *
 * @param scene  the scene; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_destroy(vbss_scene *scene);

/**
 * Adds a thread of the same context, which belongs to the scene until it is removed. The scene also
 * reserves capacity for each piece that can still be cut from the thread: a thread and two nodes.
 * The remaining cuts belong to the scene as long as a thread of the family does. An adaptive mesh
 * needs capacity for its whole node_capacity; nodes of threads added later reduce that capacity.
 * The mesh adapts at the very end of steps, which renumbers the nodes and segments beyond a change.
 * Pins, grasps and contacts in the views follow (docs/explanation/adaptive.md).
 *
 * @param scene      the scene
 * @param thread     the thread, of the scene's method, with a radius above 0
 * @param[out] body  its number in the scene, from 1 on, never reused
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: the thread is of another context),
 *         VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_OUT_OF_RANGE (an overlap, if the scene refuses it),
 *         VBSS_ERROR_INCOMPATIBLE (another method), VBSS_ERROR_IN_SCENE, VBSS_ERROR_CAPACITY
 *         (pieces included), VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_add_thread(vbss_scene *scene, vbss_thread *thread, uint32_t *body);

/**
 * Adds a drain of the same context, which belongs to the scene until it is removed. The call
 * allocates the memory that the scene's steps need for it. Features within three wall thicknesses
 * of each other along its surface do not touch. The scene's limits of linearisations and halvings
 * apply; the drain's own limits are for its own steps.
 *
 * @param scene      the scene
 * @param drain      the drain, of the scene's method
 * @param[out] body  its number in the scene, from 1 on, never reused
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: the drain is of another context),
 *         VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_OUT_OF_RANGE (an overlap, if the scene refuses it),
 *         VBSS_ERROR_INCOMPATIBLE (another method), VBSS_ERROR_IN_SCENE, VBSS_ERROR_CAPACITY,
 *         VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_add_drain(vbss_scene *scene, vbss_drain *drain, uint32_t *body);

/**
 * Fills a configuration of a rigid body with the defaults.
 *
 * @param[out] config  the configuration to fill
 * @param struct_size  `sizeof *config` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_rigid_config_init(vbss_scene_rigid_config *config,
                                                  uint32_t struct_size);

/**
 * Returns the default configuration that #vbss_scene_rigid_config_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_scene_rigid_config vbss_scene_rigid_config_default(void)
{
    vbss_scene_rigid_config vbss_filled;
    (void)vbss_scene_rigid_config_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Adds a rigid body. A scene accepts at most 4096 bodies in its life, threads included.
 *
 * @param scene      the scene
 * @param config   the configuration; not NULL, because a body needs capsules
 * @param[out] body  its number in the scene, from 1 on, never reused
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE,
 *         VBSS_ERROR_CAPACITY, VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_add_rigid(vbss_scene *scene, const vbss_scene_rigid_config *config,
                                          uint32_t *body);

/**
 * Adds a needle as a free body with its current pose and velocity. A thread whose first node is
 * pinned to it at the swage (#vbss_scene_pin_thread) is swaged to it. Until its removal stepping,
 * placing, restoring or destroying it alone returns VBSS_ERROR_IN_SCENE. With method VBLAST it
 * exactly follows the tool whose jaws have closed on it first. A needle that no tool holds flies,
 * lies on the floor, and stays in the walls of drains that it passes through
 * (docs/explanation/paper-needle.md).
 *
 * @param scene      the scene
 * @param needle     a needle of the same context and method
 * @param[out] body  its number in the scene, from 1 on, never reused
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: the needle is of another context),
 *         VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_IN_SCENE, VBSS_ERROR_OUT_OF_RANGE (an overlap, if
 *         the scene refuses it), VBSS_ERROR_INCOMPATIBLE (another method), VBSS_ERROR_CAPACITY
 *         (bodies or capsules), VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_add_needle(vbss_scene *scene, vbss_needle *needle, uint32_t *body);

/**
 * Adds a grasper of the same context, which belongs to the scene until it is removed. It starts at
 * its last target, at rest. It counts as a rigid body with four capsules.
 *
 * @param scene      the scene
 * @param grasper    the grasper, of the scene's method
 * @param[out] body  its number in the scene, from 1 on, never reused
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: the grasper is of another context),
 *         VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_OUT_OF_RANGE (an overlap, if the scene refuses it,
 *         or the trocar is nearer to the tip than the lateral reach of the bent jaws),
 *         VBSS_ERROR_INCOMPATIBLE (another method), VBSS_ERROR_IN_SCENE, VBSS_ERROR_CAPACITY,
 *         VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_add_grasper(vbss_scene *scene, vbss_grasper *grasper,
                                            uint32_t *body);

/**
 * Returns one of the places that a grasper holds.
 *
 * @param scene        the scene
 * @param tool         number of the grasper in the scene
 * @param index        index of the place, from 0 on
 * @param[out] grasp   receives the grasp
 * @param struct_size  `sizeof *grasp` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_NOT_FOUND (no such place)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_get_grasp(vbss_scene *scene, uint32_t tool, uint32_t index,
                                          vbss_scene_grasp *grasp, uint32_t struct_size);

/**
 * Returns a hole of a needle or a thread in a drain or host surface, after the last step.
 *
 * @param scene        the scene
 * @param index        index of the hole, from 0 on; the order may change with the next step
 * @param[out] hole    receives the hole
 * @param struct_size  `sizeof *hole` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_NOT_FOUND (no such hole)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_get_hole(vbss_scene *scene, uint32_t index, vbss_scene_hole *hole,
                                         uint32_t struct_size);

/**
 * Returns a pair of bodies that hold each other back. Pairs are in the order in which they began. A
 * pair is listed until it has moved freely for 0.1 s of simulated time. At most 16 are listed.
 * Method IMPLICIT.
 *
 * @param scene         the scene
 * @param index         index of the pair, from 0 on
 * @param[out] blocker  receives the pair
 * @param struct_size   `sizeof *blocker` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_NOT_FOUND (no such pair)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_get_blocker(vbss_scene *scene, uint32_t index,
                                            vbss_scene_blocker *blocker, uint32_t struct_size);

/**
 * Makes a hole where a thread or a needle already goes through the wall of a drain or host surface, for hosts that
 * lay out a stitch. Afterwards the hole behaves as if a needle had made it.
 *
 * @param scene       the scene, of method IMPLICIT
 * @param body        the thread or the needle; a thread of three nodes at least
 * @param arc_length  approximate arc length of the hole, m, 0 to its length; the hole is at the
 *         nearest place of the suture that a descent from there finds
 * @param drain       the drain or host surface
 * @param triangle    its triangle: of a drain in VBSS_DRAIN_VIEW_TRIANGLES, of a host surface as it was added
 * @param weights     three weights of its nodes at the hole, 0 to 1, with the sum 1
 * @param[out] id     receives the identifier of the hole; may be NULL
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_OUT_OF_RANGE (a
 *         value, or the suture is too far from there to touch the wall), VBSS_ERROR_NOT_FOUND (no
 *         such body), VBSS_ERROR_INCOMPATIBLE (a body of another kind, a thread of two nodes, or
 *         another method), VBSS_ERROR_IN_USE (a hole of the same suture is nearer than its
 *         diameter), VBSS_ERROR_NOT_FINITE, VBSS_ERROR_CAPACITY (hole_capacity),
 *         VBSS_ERROR_OUT_OF_MEMORY (only while a step is suspended) or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_make_hole(vbss_scene *scene, uint32_t body, double arc_length,
                                          uint32_t drain, uint32_t triangle, const double *weights,
                                          uint32_t *id);

/**
 * Removes a body, with its pins and grasps. A thread, drain or grasper then no longer belongs to a
 * scene, and a grasper is at its target.
 *
 * @param scene  the scene
 * @param body   its number, not 0
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FOUND (no such body) or
 *         VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_remove(vbss_scene *scene, uint32_t body);

/**
 * Sets the target of a driven or coupled body for the end of the next step. The body, or the pose
 * that it is tied to, moves there at constant speed during the step, turning the shortest way, and
 * then stays. The last call before a step counts. Between two steps the target must turn by less
 * than half a turn.
 *
 * @param scene        the scene
 * @param body         a rigid body, neither a free one nor a grasper (#vbss_grasper_set_target)
 * @param position     position of the origin of its frame, m, each coordinate at most 1e3 in
 *         magnitude
 * @param orientation  quaternion w, x, y, z, of any length from 1e-100 to 1e100; NULL keeps the
 *         orientation
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no
 *         such body), VBSS_ERROR_INCOMPATIBLE (no rigid body, a free one or a grasper),
 *         VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_set_rigid_target(vbss_scene *scene, uint32_t body,
                                                 const double position[3],
                                                 const double *orientation);

/**
 * Pins a node of a thread to a point of a body. The node moves there within the next step and then
 * moves with the body. With method IMPLICIT the node's motion is eliminated in favour of the body's, so
 * the body bears its force, at any ratio of masses. With method VBLAST, and on driven bodies and the
 * world, the node moves as the body does. With method VBLAST pins keep a knot: pin the nearest node
 * of both strands of a crossing. No other attachment may hold the node. On driven bodies and the
 * world the node becomes the end of a section, and the pin is an attachment of the thread. A pin
 * whose attachment was detached holds nothing. Along the thread the thread does not touch the body
 * within 1.6 contact distances of the pin.
 *
 * @param scene     the scene
 * @param thread    number of the thread in the scene
 * @param node      0 to its number of nodes - 1
 * @param body      number of a rigid body; 0: the world
 * @param point     point in the frame of the body, m, each coordinate at most 1e3 in magnitude;
 *         NULL: the current position of the node
 * @param[out] pin  identifier of the pin, from 1 on, never reused
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no
 *         such thread or body), VBSS_ERROR_INCOMPATIBLE (a body of another kind), VBSS_ERROR_IN_USE
 *         (the node is held already), VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE,
 *         VBSS_ERROR_CAPACITY (pins, or the thread's attachments), VBSS_ERROR_OUT_OF_MEMORY (only
 *         while a step is suspended) or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_pin_thread(vbss_scene *scene, uint32_t thread, uint32_t node,
                                           uint32_t body, const double *point, uint32_t *pin);

/**
 * Removes a pin.
 *
 * @param scene  the scene
 * @param pin    identifier of the pin
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FOUND (no such pin) or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_unpin_thread(vbss_scene *scene, uint32_t pin);

/**
 * Cuts a thread of the scene in two, in place, with its pins, attachments and contacts. The part
 * beyond the cut becomes a new body with node 0 at the cut. Pieces can be cut again. The scene has
 * reserved capacity for the pieces when the thread was added, so the call allocates nothing, except
 * a temporary copy of the state while a step is suspended. A cut within 1 % of a segment, or 1e-7
 * m, of a node goes through the node, which the thread keeps with its attachments. A cut within 0.2
 * mm of a hole of the thread is made 0.2 mm beside it, where an end is out of the hole. The ends at
 * a cut do not touch each other until they have come apart. Contacts in the views keep their
 * earlier numbers until the next step.
 *
 * @param scene       the scene
 * @param thread      number of the thread in the scene
 * @param arc_length  unstretched arc length from the thread's node 0 to the cut, m, within its
 *         length and not at an end
 * @param[out] piece  number of the new body, for #vbss_scene_get_thread; also in an event (scene_event.h)
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no
 *         such body), VBSS_ERROR_INCOMPATIBLE (no thread), VBSS_ERROR_OUT_OF_RANGE (the cut is not
 *         within the thread), VBSS_ERROR_NOT_FINITE, VBSS_ERROR_CAPACITY (no cuts left, which is an
 *         event, too), VBSS_ERROR_OUT_OF_MEMORY (only while a step is suspended) or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_cut_thread(vbss_scene *scene, uint32_t thread, double arc_length,
                                           uint32_t *piece);

/**
 * Returns the handle of a thread in the scene, for views and attachments. When a state from before
 * its cut is restored, the handle of a piece becomes invalid. It becomes valid again when a state
 * from after the cut is restored.
 *
 * @param scene        the scene
 * @param body         number of the thread in the scene
 * @param[out] thread  its handle; NULL when there is no such thread
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FOUND (no
 *         such body) or VBSS_ERROR_INCOMPATIBLE (no thread)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_get_thread(vbss_scene *scene, uint32_t body, vbss_thread **thread);

/**
 * Returns the memory that #vbss_scene_create allocates for a configuration. Bodies and drains add
 * their own: see docs/reference/memory.md. The call creates such a scene and destroys it again, so that the
 * number is exact; a host then knows what to reserve on another machine with the same sizes of
 * pointers.
 *
 * @param context     the context, whose allocator must have this memory
 * @param config      configuration; NULL for the defaults
 * @param[out] bytes  memory of the scene, bytes, without the slots of handles, which a context
 *         allocates 64 at a time
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, the failures of
 *         #vbss_scene_create or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_config_get_memory(vbss_context *context,
                                                  const vbss_scene_config *config, uint64_t *bytes);

/**
 * Does the work of the next step that does not depend on contacts, so that this step takes no
 * longer than those after it: the search for close bodies begins, and the pattern of the linear system is
 * analysed. Call it when all bodies are in the scene, before the first step or after bodies were
 * added. The state does not change, and a scene steps with the same bits without the call. A suspended step stays
 * as it is. The call allocates nothing. Method IMPLICIT; with method VBLAST the call does nothing.
 *
 * @param scene  the scene
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_CAPACITY (candidates or matrix) or
 *         VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_prepare(vbss_scene *scene);

/**
 * Advances the scene by one step. The call allocates nothing. On failure the scene is unchanged.
 * With method VBLAST the step of a thread or drain that has diverged fails; see #vbss_thread_step
 * and #vbss_drain_step for the bounds. If a call has ended a suspended step, or some islands of a
 * step, and the rest fails, that result stays: the call returns VBSS_OK, `behind` counts the rest,
 * and the next call returns the failure.
 *
 * @param scene  the scene
 * @param h      length of the step, s, 1e-7 to 0.1
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FINITE (h, or the state would be),
 *         VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_CAPACITY (contacts, candidates or matrix),
 *         VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_step(vbss_scene *scene, double h);

/**
 * Returns the state of a rigid body.
 *
 * @param scene        the scene
 * @param body         its number
 * @param[out] state   receives the state
 * @param struct_size  `sizeof *state` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_NOT_FOUND (no such body) or VBSS_ERROR_INCOMPATIBLE (no rigid body)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_get_rigid(vbss_scene *scene, uint32_t body,
                                          vbss_scene_rigid_state *state, uint32_t struct_size);

/**
 * Returns a view of one of the scene's arrays.
 *
 * @param scene        the scene
 * @param field        the array
 * @param[out] view    receives the view
 * @param struct_size  `sizeof *view` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_OUT_OF_RANGE (no such field)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_get_view(vbss_scene *scene, vbss_scene_field field, vbss_view *view,
                                         uint32_t struct_size);

/**
 * Returns the counters of a scene.
 *
 * @param scene            the scene
 * @param[out] statistics  receives the counters
 * @param struct_size      `sizeof *statistics` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_get_statistics(vbss_scene *scene, vbss_scene_statistics *statistics,
                                               uint32_t struct_size);

/**
 * Returns what method VBLAST counts in a scene, without what its threads count.
 *
 * @param scene           the scene
 * @param[out] statistics  receives the counters
 * @param struct_size      `sizeof *statistics` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INCOMPATIBLE if the scene uses another method, VBSS_ERROR_INVALID_HANDLE,
 * VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_get_baseline_statistics(vbss_scene *scene,
                                                        vbss_baseline_statistics *statistics,
                                                        uint32_t struct_size);

/**
 * Returns the deepest overlap of a body with another body or the floor in their current poses. An
 * overlap counts if it is deeper than `penetration_tolerance` of the solver's options allows
 * after a step. Overlaps of the body with itself do not count, nor do those near a pin of a thread
 * on the other body or at the swage of a needle. Pairs of driven bodies do not count either,
 * because a step does not test them until they have come apart. Contacts in jaws and holes count.
 * The call compares all segments of the body with all others; use it while a scene is set up.
 *
 * @param scene         the scene
 * @param body          number of the body
 * @param[out] overlap  receives the overlap
 * @param struct_size   `sizeof *overlap` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NOT_FOUND (no such body),
 *         VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_get_overlap(vbss_scene *scene, uint32_t body,
                                            vbss_scene_overlap *overlap, uint32_t struct_size);

/**
 * Saves the state of the scene and all its bodies, with a description from which #vbss_scene_load
 * creates an equal scene. A restored scene continues with the same bits, also on another machine.
 *
 * @param scene         the scene
 * @param[out] bytes    receives the state; NULL with capacity 0 asks for its size, which logs no error
 * @param capacity      size of the buffer
 * @param[out] written  bytes of the state, also when it does not fit
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_CAPACITY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_save(vbss_scene *scene, uint8_t *bytes, uint64_t capacity,
                                     uint64_t *written);

/**
 * Restores a saved state into this scene or an equal one, with equal bodies added in the same
 * order. Cuts are part of the state: the call undoes and repeats them as needed. It cannot restore
 * a piece that was removed. A body that was added after a cut has another number in a scene without
 * that cut. On failure the scene is unchanged.
 *
 * @param scene  the scene
 * @param bytes  the state
 * @param count  its size
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED,
 *         VBSS_ERROR_CORRUPT, VBSS_ERROR_CAPACITY, VBSS_ERROR_DATA_VERSION, VBSS_ERROR_OUT_OF_MEMORY
 *         or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_restore(vbss_scene *scene, const uint8_t *bytes, uint64_t count);

/**
 * Creates a scene and all its bodies from the bytes of #vbss_scene_save alone. The scene has the hash
 * of the saved one and continues with the same bits. Its bodies have their old numbers;
 * #vbss_scene_get_bodies lists them, and #vbss_scene_get_thread and its like return their handles.
 *
 * The host destroys the scene. The scene owns the bodies that it was loaded with: #vbss_scene_remove
 * destroys such a body, and #vbss_scene_destroy all of them, pieces of their threads included. Bodies
 * that the host adds later stay the host's, as in any scene. Pointers of the host for bodies are NULL
 * (#vbss_scene_set_user_data).
 *
 * @param context     owner
 * @param bytes       the saved scene; not used after the call
 * @param count       its size
 * @param[out] scene  the new scene; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED,
 *         VBSS_ERROR_CORRUPT (also: no scene or body can have the described configuration),
 *         VBSS_ERROR_DATA_VERSION (also: an older library saved the scene, without a description),
 *         VBSS_ERROR_CAPACITY, VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_load(vbss_context *context, const uint8_t *bytes, uint64_t count,
                                     vbss_scene **scene);

/**
 * Returns the XXH64 of the state of the scene and its bodies, counters included. Equal states have
 * equal hashes on every machine.
 *
 * @param scene      the scene
 * @param[out] hash  the hash
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_NULL_ARGUMENT
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_get_hash(vbss_scene *scene, uint64_t *hash);

#ifdef __cplusplus
}
#endif

#endif
