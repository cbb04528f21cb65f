/**
 * @file grasper.h
 * @brief A tool with a shaft and two jaws: needle driver or shears.
 *
 * A grasper does nothing alone. The host adds it to a scene (#vbss_scene_add_grasper), sets where its
 * tip shall be and how far its handle is open, and steps the scene. The tool then moves, touches, holds
 * and cuts. It is a *proxy*: a virtual coupling ties it to its target pose, so the hand feels whatever
 * stops the tool.
 *
 * Frame of the tool: the origin is the *tip*, midway between the ends of the axes of the closed jaws; +z
 * goes along the shaft from the tip to the handle; the jaws open along x. Bent jaws lean toward -y, by
 * the angle `bend` from the axis of the shaft. The *pivot* is where the jaws begin. The *neck* lies
 * between the pivot and the bend, in line with the jaws.
 *
 * Grasping, method IMPLICIT:
 * - A thread: the jaws close until both touch it. A compliant clamp then holds a short length of the
 *   thread in position and direction. The load that it bears grows with the pressure of the jaws, as
 *   Coulomb friction of both faces. Beyond that load the thread slides through, turns, or is torn out
 *   over its own end or over that of the jaws.
 * - A wall of a drain: the jaws hold it at up to three points along them.
 * - A needle (needle.h): the jaws hold it where they find it, in position and orientation. It slides and
 *   turns in them under a load above the limit of the pressure.
 * - Shears cut a thread between their blades when they close. They do not cut within one thickness of
 *   an end of the thread, or a thread that has no cuts left. They close through such a thread, and do
 *   not touch it until they have been clear of it.
 *
 * Grasping, method VBLAST (VBLaST-SS, Qi et al. 2017): tools are exactly where the hand is. A tool that
 * closes near a thread carries its nearest node exactly. A tool that closes near a needle across its
 * jaws carries the needle. The first of two tools leads; the second changes nothing until the first
 * lets go.
 *
 * docs/explanation/graspers.md has the formulas and limits.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_GRASPER_H
#define VBLAST_SS_GRASPER_H

#include <vblast_ss/base.h>
#include <vblast_ss/baseline.h>

/** A tool with two jaws. */
typedef struct vbss_grasper vbss_grasper;

/** Kind of a tool: a VBSS_GRASPER_KIND_ constant. */
typedef int32_t vbss_grasper_kind;

/** The constants of #vbss_grasper_kind. */
enum {
    VBSS_GRASPER_KIND_NEEDLE_DRIVER = 1, /**< Jaws that hold. */
    VBSS_GRASPER_KIND_SHEARS = 2         /**< Blades that cut. */
};

/** Configuration of a grasper. Fill it with #vbss_grasper_config_init, then change fields. */
typedef struct vbss_grasper_config {
    uint32_t struct_size;   /**< Size of this struct in bytes, set by the init function. */
    vbss_method method;     /**< Must be that of the scene; default VBSS_METHOD_IMPLICIT. */
    vbss_grasper_kind kind; /**< Initial kind; default VBSS_GRASPER_KIND_NEEDLE_DRIVER. */
    int32_t has_trocar;     /**< 1: the shaft goes through `trocar`; default 0: free. */
    double trocar[3];       /**< Point of entry of the shaft, m, each at most 1e3; default 0. */
    /* Both jaws or blades are round fingers that touch along their length when closed. */
    /** Length of a driver's jaws, pivot to tip, m, 1e-4 to 1; default 13e-3. */
    double driver_length;
    /** Radius of each jaw, m, 1e-6 to 0.1, below the length; default 0.5e-3. */
    double driver_radius;
    double driver_bend; /**< Angle between jaws and shaft, rad, -1.5 to 1.5; default 0. */
    /** Angle of each jaw from the middle when the handle is open, rad, 1e-3 to 1.2; default 0.35. */
    double driver_opening;
    /** Length of the blades of shears, pivot to tip, m, 1e-4 to 1; default 15e-3. */
    double shears_length;
    /** Radius of each blade, m, 1e-6 to 0.1, below the length; default 0.5e-3. */
    double shears_radius;
    double shears_bend; /**< Angle between blades and shaft, rad, -1.5 to 1.5; default 0. */
    /** Angle of each blade from the middle when the handle is open, rad, 1e-3 to 1.2; default
     * 0.35. */
    double shears_opening;
    double driver_neck; /**< Length from the pivot back to the bend, m, 0 to 1; default 0. */
    /** Length from the pivot of the blades back to the bend, m, 0 to 1; default 0. */
    double shears_neck;
    double neck_radius;  /**< Radius of either neck, m, 1e-6 to 0.1; default 1.2e-3. */
    double shaft_length; /**< Length from the bend on, m, 1e-3 to 10; default 0.15. */
    double shaft_radius; /**< Radius of the shaft, m, 1e-6 to 0.1; default 2.5e-3. */
    double friction;     /**< Coefficient for contacts outside the grasp, 0 to 10; default 0.15. */
    /** Pressure of the jaws on a grasped body when the handle is closed, N, 0 to 1e4; default 8. */
    double closing_force;
    /** Angle by which the jaws of a closed handle would close further without a grasped body, rad, 1e-3
     * to 1. The pressure grows over this angle from zero to closing_force. Default 0.1. */
    double closing_angle;
    double jaw_speed;     /**< Largest speed of each jaw, rad/s, 1e-2 to 1e3; default 8. */
    double grip_friction; /**< Coefficient of each face in the grasp, 0 to 10; default 0.5. */
    double grip_length; /**< Length of thread that a grasp holds, m, 1e-5 to 1e-1; default 1e-3. */
    /** Stiffness of the whole clamp of a thread along the faces, N/m, 1 to 1e6; default 3000. From face to
     * face it is 64 times as stiff. */
    double grip_stiffness;
    /** Mass of the proxy, kg, 1e-4 to 1e2; default 0.02. It is at the tip, with a radius of gyration of
     * 30 mm. */
    double mass;
    /** Stiffness of the virtual coupling, N/m, 0 to 1e9. The default of 400 suits haptic arms; scripted
     * hands may use 2000 with a damping of 10 N s/m. */
    double stiffness;
    /** Damping of the virtual coupling, N s/m, 0 to 1e6; default 5. If a hand receives its force a time d
     * after its pose was read, and holds it for h, the damping must be at least stiffness (d + h / 2).
     * Otherwise the coupling adds energy to a hand that presses on a rigid obstacle. At an elastic one the
     * hand itself needs a little damping, which docs/reference/device-layer.md derives. */
    double damping;
    /** Rotational stiffness of the coupling, N m/rad, 0 to 1e9; default 5. */
    double turning_stiffness;
    /** Rotational damping of the coupling, N m s/rad, 0 to 1e6; default 0.05. */
    double turning_damping;
    /** Tools are exchanged only with empty jaws and with the tip farther than exchange_distance from this
     * point, m, each at most 1e3; default 0. */
    double exchange_centre[3];
    double exchange_distance; /**< Distance, m, 0 to 1e3; default 0: no limit. */
    /** VBLAST: its parameters; NULL (default): their defaults. The library copies them. */
    const vbss_baseline_config *baseline;
    /* Needles (needle.h) and walls of drains, which are stiffer than threads. */
    /** Stiffness of the clamp on either, equal in all directions, N/m, 1 to 1e7; default 3e4. */
    double needle_stiffness;
    /** Rotational stiffness of the clamp on a needle about the normal of the jaws' faces, N m/rad, 1e-6 to
     * 1e4; default 0.5. About axes in the faces it is half of this. */
    double needle_turning_stiffness;
    /** Torque at which a needle turns in the jaws of a closed handle, N m, 0 to 1e2; default 0.03 (not
     * verified). The torque is proportional to the pressure of the jaws. */
    double needle_torque;
    double solenoid_opening; /**< See vbss_grasper_state::solenoid; 0 to 1; default 0.2. */
} vbss_grasper_config;

/** A known tool: a VBSS_GRASPER_PRESET_ constant. */
typedef int32_t vbss_grasper_preset;

/** The constants of #vbss_grasper_preset. */
enum {
    VBSS_GRASPER_PRESET_STRAIGHT = 0, /**< A needle driver with straight jaws: the defaults. */
    /** Jaws on a neck of 5 mm, bent by 0.8 rad. Rolled about its shaft, the tool points its jaws at the
     * other tool, which can then go round them without meeting the shaft. */
    VBSS_GRASPER_PRESET_ANGLED = 1
};

/** Pose of a grasper, and the forces that act on it. */
typedef struct vbss_grasper_state {
    uint32_t struct_size;         /**< Bytes of this struct that the library filled. */
    vbss_grasper_kind kind;       /**< Present kind. */
    uint32_t body;                /**< Number of the grasper in its scene; 0: not in a scene. */
    uint32_t grasp_count;         /**< Number of grasps: places of threads, a needle, a wall. */
    double position[3];           /**< Position of the tip, m. */
    double orientation[4];        /**< Unit quaternion, w, x, y, z. */
    double velocity[3];           /**< Velocity of the tip, m/s. */
    double angular_velocity[3];   /**< Angular velocity, rad/s. */
    double target_position[3];    /**< Target of the tip, m. */
    double target_orientation[4]; /**< Target, after the trocar has turned it. */
    double opening;               /**< Opening of the handle that the host set. */
    double jaw_angle;             /**< Angle of each jaw from the middle, rad. */
    double pressure;              /**< Pressure of the jaws on all grasped bodies, N. */
    /** Force on the hand at the tip, which a device shall exert, N: a command for vbss_device_write. A
     * device that gets the pose of the tool by vbss_device_write_coupled has this force already. VBLAST:
     * the force of stretched threads that it carries. */
    double hand_force[3];
    double hand_torque[3]; /**< Torque on the hand about the tip, N m; VBLAST: 0. */
    uint32_t needle;       /**< Number of the held needle in its scene; 0: none. */
    uint32_t drain;        /**< Number of the drain whose wall it holds; 0: none. */
    /** 1: a solenoid shall lock the handle (vbss_output_command::solenoid). It is set once the tool holds a
     * needle and the opening of the handle is below solenoid_opening, and cleared when the tool holds no
     * needle. */
    uint32_t solenoid;
    uint32_t reserved; /**< Zero. */
} vbss_grasper_state;

/** An array to view: a VBSS_GRASPER_VIEW_ constant. */
typedef int32_t vbss_grasper_field;

/** The constants of #vbss_grasper_field. */
enum {
    /** x 7: start and end of the axis, radius, m. Order: shaft, jaw at +x, jaw at -x, neck. */
    VBSS_GRASPER_VIEW_CAPSULES = 0
};

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
VBSS_API vbss_result vbss_grasper_config_init(vbss_grasper_config *config, uint32_t struct_size);

/**
 * Returns the default configuration that #vbss_grasper_config_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_grasper_config vbss_grasper_config_default(void)
{
    vbss_grasper_config vbss_filled;
    (void)vbss_grasper_config_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Sets length, radius, bend, opening and neck of the driver's jaws to those of a known tool.
 *
 * @param[in,out] config  an initialised configuration
 * @param preset          the known tool
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or VBSS_ERROR_OUT_OF_RANGE (no
 *         such preset)
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_grasper_config_preset(vbss_grasper_config *config,
                                                vbss_grasper_preset preset);

/**
 * Creates a grasper with open jaws. Its tip is at the origin until the host moves it.
 *
 * @param context       owner
 * @param config        the configuration; NULL for the defaults
 * @param[out] grasper  the new grasper; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE,
 *         VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_grasper_create(vbss_context *context, const vbss_grasper_config *config,
                                         vbss_grasper **grasper);

/**
 * Destroys a grasper.
 *
 * @param grasper  the grasper; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_IN_SCENE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_grasper_destroy(vbss_grasper *grasper);

/**
 * Destroys a grasper now, or when it leaves the scene that it belongs to: on #vbss_scene_remove and on
 * #vbss_scene_destroy. Until then the handle is valid. A host that has discarded all bodies of a
 * scene needs to destroy only the scene.
 *
 * @param grasper  the grasper; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_grasper_discard(vbss_grasper *grasper);

/**
 * Sets the pose that the tool reaches at the end of the next step. Before the tool is added to a
 * scene, the call sets its initial pose. With a trocar, the tip moves to the given position. The
 * given orientation is turned along the shortest path until the shaft passes through the trocar, so
 * only its roll about the shaft is free.
 *
 * @param grasper      the grasper
 * @param position     target of the tip, m, each at most 1e3
 * @param orientation  target, w, x, y, z, of any length from 1e-100 to 1e100; NULL keeps the last one
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_OUT_OF_RANGE
 *         (also: the trocar is nearer to the tip than the lateral reach of the bent jaws),
 *         VBSS_ERROR_NOT_FINITE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_grasper_set_target(vbss_grasper *grasper, const double position[3],
                                             const double *orientation);

/**
 * Sets how far the handle is open from the next step on. The jaws follow with at most jaw_speed.
 *
 * @param grasper  the grasper
 * @param opening  opening, 0 (closed) to 1 (open)
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE or
 *         VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_grasper_set_opening(vbss_grasper *grasper, double opening);

/**
 * Requests another kind of tool. The next step of the scene exchanges the tool or refuses the
 * request, with an event either way. It refuses while the tool holds a body, where
 * exchange_distance forbids the exchange, and where the tip is too near to the trocar for the other
 * jaws. A refused request is not repeated.
 *
 * @param grasper  the grasper
 * @param kind     the new kind; the present kind changes nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_OUT_OF_RANGE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_grasper_exchange(vbss_grasper *grasper, vbss_grasper_kind kind);

/**
 * Returns the pose of a grasper and the forces that act on it.
 *
 * @param grasper      the grasper
 * @param[out] state   receives the numbers
 * @param struct_size  `sizeof *state` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_grasper_get_state(vbss_grasper *grasper, vbss_grasper_state *state,
                                            uint32_t struct_size);

/**
 * Returns a view of one of the grasper's arrays after the last step.
 *
 * @param grasper      the grasper
 * @param field        the array
 * @param[out] view    receives the address and the shape of the array
 * @param struct_size  `sizeof *view` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_OUT_OF_RANGE (no such field)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_grasper_get_view(vbss_grasper *grasper, vbss_grasper_field field,
                                           vbss_view *view, uint32_t struct_size);

#ifdef __cplusplus
}
#endif

#endif
