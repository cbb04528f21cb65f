/**
 * @file needle.h
 * @brief A curved suture needle: a rigid arc of round wire.
 *
 * A needle flies alone (#vbss_needle_step) or is added to a scene (#vbss_scene_add_needle). In a scene it touches
 * other bodies, tools grasp it, and it carries a thread. Contacts use a chain of straight capsules whose ends lie
 * on its arc. Mass and inertia are exactly those of the arc.
 *
 * Frame of the needle: the origin is the centre of its arc, which lies in the plane z = 0. The *tip* is at
 * (radius, 0, 0) and points along +y. The body of the needle goes back clockwise about +z to the *swage*, where
 * the thread is fixed, at the angle -arc; the swage of a half circle is at (-radius, 0, 0). A rotation about +z
 * drives the tip forward. Arc length is measured from the tip to the swage.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_NEEDLE_H
#define VBLAST_SS_NEEDLE_H

#include <vblast_ss/base.h>

/** A needle. */
typedef struct vbss_needle vbss_needle;

/** Configuration of a needle. Fill it with #vbss_needle_config_init, then change fields. */
typedef struct vbss_needle_config {
    uint32_t struct_size;   /**< Size of this struct in bytes, set by the init function. */
    vbss_method method;     /**< Must be that of the scene; default VBSS_METHOD_IMPLICIT. */
    uint32_t segment_count; /**< Capsules along the arc, 2 to 64; default 8. */
    uint32_t reserved;      /**< Zero. */
    /** Radius of the arc's centre line, m, 1e-4 to 1; default 10.5e-3, the paper's radius. */
    double radius;
    /** Radius of the wire, m, 1e-6 to radius / 5; default 0.35e-3 (not verified). */
    double wire_radius;
    double arc;     /**< Angle from tip to swage, rad, 0.1 to 6; default pi. */
    double density; /**< Density, kg/m^3, 1 to 1e5; default 7900, steel. */
    /** Coefficient of friction with other bodies of a scene, 0 to 10; default 0.2. */
    double friction;
    double drag; /**< Decay rate of linear and angular momentum, 1/s, 0 to 1e6; default 0. */
    /** Gravitational acceleration, m/s^2, each component at most 1e6 in magnitude; default 0. */
    double gravity[3];
    /** Position of the frame's origin, m, each coordinate at most 1e3 in magnitude; default 0. */
    double position[3];
    /** Orientation w, x, y, z, of any length from 1e-100 to 1e100; default 1, 0, 0, 0. */
    double orientation[4];
    /** Velocity of the origin, m/s, each component at most 1e5 in magnitude; default 0. */
    double velocity[3];
    /** Angular velocity, rad/s, each component at most 1e6 in magnitude; default 0. */
    double angular_velocity[3];
} vbss_needle_config;

/** A known needle: a VBSS_NEEDLE_PRESET_ constant. */
typedef int32_t vbss_needle_preset;

/** The constants of #vbss_needle_preset. */
enum {
    VBSS_NEEDLE_PRESET_VBLAST =
        0,                    /**< Half circle of radius 10.5 mm (Qi et al. 2017): the defaults. */
    VBSS_NEEDLE_PRESET_SH = 1 /**< Half circle of 26 mm, radius 8.28 mm (not verified). */
};

/** Pose and velocity of a needle. */
typedef struct vbss_needle_state {
    uint32_t struct_size;       /**< Bytes of this struct that the library filled. */
    uint32_t body;              /**< Number of the needle in its scene; 0: not in a scene. */
    double position[3];         /**< Position of the frame's origin, m. */
    double orientation[4];      /**< Orientation, unit quaternion w, x, y, z. */
    double velocity[3];         /**< Velocity of the origin, m/s. */
    double angular_velocity[3]; /**< Angular velocity, rad/s. */
    double tip[3];              /**< Position of the tip, m. */
    double tip_direction[3];    /**< Unit vector out of the tip. */
    double swage[3];            /**< Position of the swage, m. */
    double swage_direction[3];  /**< Unit vector of the thread, away from the needle. */
} vbss_needle_state;

/** Mass and inertia of a needle. */
typedef struct vbss_needle_mass {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    uint32_t reserved;    /**< Zero. */
    double mass;          /**< Mass, kg. */
    double length;        /**< Length of the centre line, m. */
    double centre[3];     /**< Centre of mass in the needle's frame, m. */
    double inertia[3];    /**< Principal moments about it, kg m^2. */
    double axes[3][3];    /**< Their unit axes in the needle's frame, in the same order. */
} vbss_needle_mass;

/** Energies, J. */
typedef struct vbss_needle_energies {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    uint32_t reserved;    /**< Zero. */
    double kinetic;       /**< Kinetic energy of translation and rotation. */
    double gravity;       /**< Potential energy, zero at the world's origin. */
    double total;         /**< Their sum. */
} vbss_needle_energies;

/** An array to view: a VBSS_NEEDLE_VIEW_ constant. */
typedef int32_t vbss_needle_field;

/** The constants of #vbss_needle_field. */
enum {
    /** x 3: ends of the capsules' axes, m, from the tip to the swage; segment_count + 1 rows. */
    VBSS_NEEDLE_VIEW_POINTS = 0
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
VBSS_API vbss_result vbss_needle_config_init(vbss_needle_config *config, uint32_t struct_size);

/**
 * Returns the default configuration that #vbss_needle_config_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_needle_config vbss_needle_config_default(void)
{
    vbss_needle_config vbss_filled;
    (void)vbss_needle_config_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Sets radius, wire radius and arc to those of a known needle.
 *
 * @param[in,out] config  an initialised configuration
 * @param preset          the known needle
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or VBSS_ERROR_OUT_OF_RANGE (no
 *         such preset)
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_needle_config_preset(vbss_needle_config *config,
                                               vbss_needle_preset preset);

/**
 * Sets radius, wire radius and arc to those of a needle as catalogues describe it. docs/reference/sutures.md lists
 * common needles.
 *
 * @param[in,out] config  an initialised configuration
 * @param circle          share of a circle, 0.05 to 0.9: 0.5 for a half circle
 * @param length          length along the arc, m, 1e-3 to 1
 * @param wire_diameter   diameter of the wire, m, 1e-5 to 0.4 of the arc's radius
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_NOT_FINITE or
 *         VBSS_ERROR_OUT_OF_RANGE; the configuration is then unchanged
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_needle_config_shape(vbss_needle_config *config, double circle,
                                              double length, double wire_diameter);

/**
 * Creates a needle with the pose and velocity of its configuration.
 *
 * @param context      owner
 * @param config       configuration; NULL for the defaults
 * @param[out] needle  the new needle; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE,
 *         VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_needle_create(vbss_context *context, const vbss_needle_config *config,
                                        vbss_needle **needle);

/**
 * Destroys a needle.
 *
 * @param needle  the needle; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_IN_SCENE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_needle_destroy(vbss_needle *needle);

/**
 * Destroys a needle now, or when it leaves the scene that it belongs to: on #vbss_scene_remove and on
 * #vbss_scene_destroy. Until then the handle is valid. A host that has discarded all bodies of a
 * scene needs to destroy only the scene.
 *
 * @param needle  the needle; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_needle_discard(vbss_needle *needle);

/**
 * Makes one step of free flight under gravity and drag, without contacts. Angular momentum is
 * conserved up to rounding; the rotation is of second order (the splitting of docs/explanation/needle.md). A
 * needle turns by at most a quarter of a turn in a step; a faster one slows down.
 *
 * @param needle  the needle
 * @param h       length of the step, s, 1e-7 to 0.1
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE (h, or
 *         the state would be: nothing has changed), VBSS_ERROR_IN_SCENE, VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_needle_step(vbss_needle *needle, double h);

/**
 * Sets the pose and velocity of a needle that is not in a scene.
 *
 * @param needle            the needle
 * @param position          position of the frame's origin, m, each coordinate at most 1e3 in
 *         magnitude
 * @param orientation       w, x, y, z, of any length from 1e-100 to 1e100; NULL keeps it
 * @param velocity          velocity of the frame's origin, m/s, each component at most 1e5 in
 *         magnitude; NULL: zero
 * @param angular_velocity  rad/s, each component at most 1e6 in magnitude; NULL: zero
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_OUT_OF_RANGE,
 *         VBSS_ERROR_NOT_FINITE, VBSS_ERROR_IN_SCENE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_needle_set_state(vbss_needle *needle, const double position[3],
                                           const double *orientation, const double *velocity,
                                           const double *angular_velocity);

/**
 * Returns pose and velocity of a needle.
 *
 * @param needle       the needle
 * @param[out] state   receives the numbers
 * @param struct_size  `sizeof *state` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_needle_get_state(vbss_needle *needle, vbss_needle_state *state,
                                           uint32_t struct_size);

/**
 * Returns mass and inertia of a needle.
 *
 * @param needle       the needle
 * @param[out] mass    receives the numbers
 * @param struct_size  `sizeof *mass` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_needle_get_mass(vbss_needle *needle, vbss_needle_mass *mass,
                                          uint32_t struct_size);

/**
 * Returns a point on the exact centre line, and the direction toward the tip there. Beyond the ends the line
 * continues straight.
 *
 * @param needle          the needle
 * @param arc_length      from the tip towards the swage, m, at most 10 in magnitude
 * @param[out] position position on the centre line, m
 * @param[out] direction unit vector; may be NULL
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_OUT_OF_RANGE or
 *         VBSS_ERROR_NOT_FINITE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_needle_get_place(vbss_needle *needle, double arc_length,
                                           double position[3], double *direction);

/**
 * Returns the energies of a needle.
 *
 * @param needle         the needle
 * @param[out] energies  receives the numbers
 * @param struct_size    `sizeof *energies` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_needle_get_energies(vbss_needle *needle, vbss_needle_energies *energies,
                                              uint32_t struct_size);

/**
 * Returns a view of one of the needle's arrays after the last step.
 *
 * @param needle       the needle
 * @param field        the array
 * @param[out] view    receives the view
 * @param struct_size  `sizeof *view` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_OUT_OF_RANGE (no such field)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_needle_get_view(vbss_needle *needle, vbss_needle_field field,
                                          vbss_view *view, uint32_t struct_size);

/**
 * Saves the needle's state.
 *
 * @param needle        the needle
 * @param[out] bytes    receives the state; NULL with capacity 0 asks for its size, which logs no error
 * @param capacity      size of `bytes`
 * @param[out] written  bytes written, or bytes needed with VBSS_ERROR_CAPACITY
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_CAPACITY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_needle_save(vbss_needle *needle, uint8_t *bytes, uint64_t capacity,
                                      uint64_t *written);

/**
 * Restores a saved state into this needle or an equally configured one. On failure the needle is
 * unchanged.
 *
 * @param needle  the needle
 * @param bytes   the state that #vbss_needle_save wrote
 * @param count   its size
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED,
 *         VBSS_ERROR_CORRUPT (also of another configuration), VBSS_ERROR_CAPACITY,
 *         VBSS_ERROR_DATA_VERSION, VBSS_ERROR_OUT_OF_MEMORY, VBSS_ERROR_IN_SCENE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_needle_restore(vbss_needle *needle, const uint8_t *bytes, uint64_t count);

/**
 * Returns the XXH64 of the needle's state; equal states have equal hashes on every machine.
 *
 * @param needle     the needle
 * @param[out] hash  the hash
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_NULL_ARGUMENT
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_needle_get_hash(vbss_needle *needle, uint64_t *hash);

#ifdef __cplusplus
}
#endif

#endif
