/**
 * @file grasper.h
 * @brief A tool with a shaft and two jaws: needle driver or shears.
 *
 * A grasper does nothing alone: it is told where its tip shall be and how far its handle is open, is added to
 * a scene (#vbss_scene_add_grasper), and moves, touches, holds and cuts when that is stepped. It is a *proxy*,
 * tied to the pose it is told by a virtual coupling, so that what stops the tool is felt by the hand.
 *
 * Frame of the tool: the origin is the *tip*, midway between the ends of the axes of the closed jaws; +z goes
 * along the shaft from the tip to the handle; the jaws open along x. Jaws that are bent lean toward -y, by
 * the angle `bend` from the shaft's axis. The *pivot* is where they begin; between it and the bend lies the *neck*,
 * along the line of the jaws.
 *
 * Grasping a thread, method OURS: the jaws close until what lies between them touches both, and hold it from then on
 * by a compliant clamp over a short length of the thread, in position and direction. What it can bear grows
 * with the pressure of the jaws, as Coulomb friction of both faces: beyond that the thread slides through,
 * turns, or is torn out, over its end or over the jaws'. Shears cut what lies between them when they close,
 * but not nearer to an end of a thread than it is thick: that, and a thread of which all cuts are made, they close
 * through, and do not touch it until they have been clear of it.
 * A wall of a drain that they close on is held at up to three points along the jaws. A needle (needle.h) is held where the jaws have found it, as it was turned, in position and orientation; it slides and
 * turns in them above what the pressure bears.
 * Method PAPER (VBLaST-SS, Qi et al. 2017): tools are where the hand is; one that closes near a thread carries
 * its nearest node exactly, and one that closes near a needle across its jaws carries that; of two tools the first leads, the
 * other changes nothing until that lets go.
 * docs/graspers.md has the formulas and limits.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_GRASPER_H
#define VBLAST_SS_GRASPER_H

#include <vblast_ss/base.h>

/** A tool with two jaws. */
typedef struct vbss_grasper vbss_grasper;

/** What a tool is: a VBSS_GRASPER_ constant. */
typedef int32_t vbss_grasper_kind;

/** The constants of #vbss_grasper_kind. */
enum {
    VBSS_GRASPER_NEEDLE_DRIVER = 1, /**< Jaws that hold. */
    VBSS_GRASPER_SHEARS = 2         /**< Blades that cut. */
};

/** How to make a grasper. Fill it with #vbss_grasper_config_init, then change what you need. */
typedef struct vbss_grasper_config {
    uint32_t struct_size;   /**< Size of this struct in bytes, set by the init function. */
    vbss_method method;     /**< Default VBSS_METHOD_OURS; the scene's must be the same. */
    vbss_grasper_kind kind; /**< With which it begins; default VBSS_GRASPER_NEEDLE_DRIVER. */
    int32_t has_trocar;     /**< 1: the shaft goes through `trocar`; default 0: free. */
    double trocar[3];       /**< Where the shaft enters, m, each at most 1e3; default 0. */
    /* Two jaws, or blades, round fingers that touch along their length when closed. */
    double driver_length; /**< Of a driver's jaws, pivot to tip, m, 1e-4 to 1; default 13e-3. */
    double driver_radius; /**< Of each jaw, m, 1e-6 to 0.1, below the length; default 0.5e-3. */
    double driver_bend;   /**< By which they lean from the shaft, rad, -1.5 to 1.5; default 0. */
    /** Angle of each from the middle when the handle is open, rad, 1e-3 to 1.2; default 0.35. */
    double driver_opening;
    double shears_length;  /**< Of the blades of shears, as driver_length; default 15e-3. */
    double shears_radius;  /**< As driver_radius; default 0.5e-3. */
    double shears_bend;    /**< As driver_bend; default 0. */
    double shears_opening; /**< As driver_opening; default 0.35. */
    double driver_neck;    /**< From the pivot back to the bend, m, 0 to 1; default 0. */
    double shears_neck;    /**< As driver_neck; default 0. */
    double neck_radius;    /**< Of both, m, 1e-6 to 0.1; default 1.2e-3. */
    double shaft_length;   /**< From the bend on, m, 1e-3 to 10; default 0.15. */
    double shaft_radius;   /**< m, 1e-6 to 0.1; default 2.5e-3. */
    double friction;       /**< Coefficient with all but what is held, 0 to 10; default 0.15. */
    double closing_force;  /**< Pressure of the jaws of a closed handle on what they hold, N,
                               * 0 to 1e4; default 8. */
    /** Angle that the jaws of a closed handle would close further if nothing held them, rad, 1e-3 to 1: the
     * pressure grows over it from nothing to closing_force; default 0.1. */
    double closing_angle;
    double jaw_speed;     /**< Most of each jaw, rad/s, 1e-2 to 1e3; default 8. */
    double grip_friction; /**< Coefficient of each face with what is held, 0 to 10; default 0.5. */
    double grip_length;   /**< Of thread that is held, m, 1e-5 to 1e-1; default 1e-3. */
    /** Of the clamp as a whole along the faces, N/m, 1 to 1e6; default 3000. From face to face it is 64 times as
     * stiff. */
    double grip_stiffness;
    /** Of the proxy, kg, 1e-4 to 1e2; default 0.02. It is at the tip, with a radius of gyration of 30 mm. */
    double mass;
    /** Of the virtual coupling, N/m, 0 to 1e9; default 400: for haptic arms; scripted hands may take 2000, with 10
     * N s/m. */
    double stiffness;
    /** N s/m, 0 to 1e6; default 5. A hand that gets its force d after its pose was read, held for h, wants at least
     * stiffness (d + h / 2), or the coupling feeds it. */
    double damping;
    double turning_stiffness; /**< N m/rad, 0 to 1e9; default 5. */
    double turning_damping;   /**< N m s/rad, 0 to 1e6; default 0.05. */
    /** Tools are exchanged only with empty jaws and with the tip further than exchange_distance from here,
     * m, each at most 1e3; default 0. */
    double exchange_centre[3];
    double exchange_distance; /**< m, 0 to 1e3; default 0: anywhere. */
    /** PAPER: k_s of the force to the hand, k_s (stretched length - length), N/m, 0 to 1e6; default 50. */
    double paper_stiffness;
    /** PAPER: within which closed jaws take a node, from their tip, or a needle, from their middle line, m, 0 to 0.1; default
     * 2e-3 (the paper gives no number). */
    double paper_distance;
    /* What is stiffer than a thread: a needle (needle.h), a wall of a drain. */
    /** Of the clamp on either, the same in all directions, N/m, 1 to 1e7; default 3e4. */
    double needle_stiffness;
    /** Of that on a needle about the normal of the jaws' faces, N m/rad, 1e-6 to 1e4; about axes in them half of it; default 0.5. */
    double needle_turning_stiffness;
    /** Torque that jaws of a closed handle bear before the needle turns in them, N m, 0 to 1e2; default 0.03 (not
     * verified). Of jaws that press less, less in proportion. */
    double needle_torque;
    double solenoid_opening; /**< See vbss_grasper_state::solenoid; 0 to 1; default 0.2. */
} vbss_grasper_config;

/** A known tool: a VBSS_GRASPER_PRESET_ constant. */
typedef int32_t vbss_grasper_preset;

/** The constants of #vbss_grasper_preset. */
enum {
    VBSS_GRASPER_PRESET_STRAIGHT = 0, /**< A needle driver with straight jaws: the defaults. */
    /** Jaws on a neck of 5 mm, bent by 0.8 rad: rolled about its shaft, the tool points its jaws at the other one,
     * which can then go round them without meeting the shaft. */
    VBSS_GRASPER_PRESET_ANGLED = 1
};

/** Where a grasper is, and what acts on it. */
typedef struct vbss_grasper_state {
    uint32_t struct_size;         /**< Bytes of this struct that the library filled. */
    vbss_grasper_kind kind;       /**< What it is now. */
    uint32_t body;                /**< Its number in its scene; 0: it is in none. */
    uint32_t grasp_count;         /**< Places of threads that it holds; a needle; a wall. */
    double position[3];           /**< Of the tip, m. */
    double orientation[4];        /**< w, x, y, z, unit. */
    double velocity[3];           /**< Of the tip, m/s. */
    double angular_velocity[3];   /**< rad/s. */
    double target_position[3];    /**< Where the tip shall be, m. */
    double target_orientation[4]; /**< What was told, as the trocar lets it be. */
    double opening;               /**< Of the handle, as told. */
    double jaw_angle;             /**< Of each jaw from the middle, rad. */
    double pressure;              /**< Of the jaws on all that they hold, N. */
    /** On the hand at the tip, N; what a device shall exert. PAPER: of the stretch of what it carries. */
    double hand_force[3];
    double hand_torque[3]; /**< On the hand about the tip, N m; PAPER: 0. */
    uint32_t needle;       /**< Number in its scene of the needle that it holds; 0: none. */
    uint32_t drain;        /**< The same of the drain whose wall it holds. */
    /** 1: a solenoid that locks the handle is wanted (vbss_output_command::solenoid): from when it holds a needle and the
     * handle is closed below solenoid_opening, until it holds none. */
    uint32_t solenoid;
    uint32_t reserved; /**< Zero. */
} vbss_grasper_state;

/** Arrays to look at: a VBSS_GRASPER_VIEW_ constant. */
typedef int32_t vbss_grasper_field;

/** The constants of #vbss_grasper_field. */
enum {
    /** x 7: begin and end of the axis, radius, m; shaft, the jaw at +x, the one at -x, neck. */
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
 * @since 0.1
 */
VBSS_API vbss_result vbss_grasper_config_init(vbss_grasper_config *config, uint32_t struct_size);

/**
 * Sets length, radius, bend, opening and neck of the driver's jaws to those of a known tool.
 *
 * @param[in,out] config  an initialised configuration
 * @param preset          which tool
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or VBSS_ERROR_OUT_OF_RANGE (no
 *         such preset)
 * @threads any thread, any time
 * @since 0.1
 */
VBSS_API vbss_result vbss_grasper_config_preset(vbss_grasper_config *config,
                                                vbss_grasper_preset preset);

/**
 * Creates a grasper with open jaws; its tip is at the origin until it is moved.
 *
 * @param context       owner
 * @param config        how; NULL for the defaults
 * @param[out] grasper  the new grasper; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE,
 *         VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_grasper_create(vbss_context *context, const vbss_grasper_config *config,
                                         vbss_grasper **grasper);

/**
 * Destroys a grasper.
 *
 * @param grasper  the grasper; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_IN_SCENE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_grasper_destroy(vbss_grasper *grasper);

/**
 * Says where the tip shall be at the end of the next step, and how the tool shall be turned. Before it is added
 * to a scene, that is where it begins. With a trocar the tip goes where it is told, and the orientation is the
 * told one turned the shortest way that takes the shaft through the trocar: what is left of it is the roll.
 *
 * @param grasper      the grasper
 * @param position     of the tip, m, each at most 1e3
 * @param orientation  w, x, y, z, of any length from 1e-100 to 1e100; NULL leaves what was told
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_OUT_OF_RANGE (also: the
 *         trocar is nearer to the tip than the bent jaws reach aside), VBSS_ERROR_NOT_FINITE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_grasper_move(vbss_grasper *grasper, const double position[3],
                                       const double *orientation);

/**
 * Says how far the handle is open from the next step on. The jaws follow as fast as jaw_speed lets them.
 *
 * @param grasper  the grasper
 * @param opening  0 closed to 1 open
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE or
 *         VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_grasper_set_opening(vbss_grasper *grasper, double opening);

/**
 * Says which tool it shall be. The next step of its scene exchanges it, or refuses to, with an event either way: while
 * it holds something, is where exchange_distance forbids it, or too near to its trocar for the other jaws. What was
 * refused is forgotten.
 *
 * @param grasper  the grasper
 * @param kind     what it shall be; what it is already changes nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_OUT_OF_RANGE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_grasper_exchange(vbss_grasper *grasper, vbss_grasper_kind kind);

/**
 * Where a grasper is and what acts on it.
 *
 * @param grasper      the grasper
 * @param[out] state   receives the numbers
 * @param struct_size  `sizeof *state` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_grasper_get_state(vbss_grasper *grasper, vbss_grasper_state *state,
                                            uint32_t struct_size);

/**
 * A look at one of the grasper's arrays, as it is after the last step.
 *
 * @param grasper      the grasper
 * @param field        which
 * @param[out] view    receives where the array is
 * @param struct_size  `sizeof *view` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_OUT_OF_RANGE (no such field)
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_grasper_get_view(vbss_grasper *grasper, vbss_grasper_field field,
                                           vbss_view *view, uint32_t struct_size);

#ifdef __cplusplus
}
#endif

#endif
