/**
 * @file mapping.h
 * @brief Mouse, keyboard and gamepad as hands: pure functions that move a sample.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_MAPPING_H
#define VBLAST_SS_MAPPING_H

#include <vblast_ss/adapter.h>

/** Mapping from mouse, keyboard or gamepad to a pose. Fill it with #vbss_mapping_config_init,
 * then change fields. Rotations are about axes of the pose's frame. */
typedef struct vbss_mapping_config {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    uint32_t pad_curve;   /**< Gamepad: power of the deflection, 1 to 4; default 2. */
    double right[3];      /**< Direction to the right of the screen, unit to 1e-6; default x. */
    /** Direction to the top of the screen, normal to `right`; default y. Right x up points towards the user. */
    double up[3];
    /** Lower corner of the box to which positions are confined, m; default -0.1. */
    double low[3];
    /** Upper corner of the box, m, each coordinate at most 1e3 in magnitude; default 0.1. */
    double high[3];
    double mouse_metres; /**< Mouse: metres per count; default 1e-4. */
    /** Mouse: metres away from the user per notch of the wheel; default 2e-3. */
    double mouse_depth;
    double mouse_radians; /**< Mouse, turning: rad per count; default 5e-3. */
    /** Mouse, turning: rad about the direction of depth per notch; default 0.1. */
    double mouse_roll;
    /** Mouse: speed at which the jaws close and open, 1/s, 0 to 1e3; default 4. */
    double jaw_rate;
    double key_metres;  /**< Keyboard: metres per press; default 1e-3. */
    double key_radians; /**< Keyboard: rad per press; default 0.05. */
    double key_jaw;     /**< Keyboard: change of the opening per press; default 0.1. */
    double pad_speed;   /**< Gamepad: m/s at full deflection; default 0.1. */
    double pad_turning; /**< Gamepad: rad/s at full deflection; default 1. */
    double pad_dead;    /**< Gamepad: deflection that counts as zero, 0 to 0.9; default 0.15. */
} vbss_mapping_config;

/** Bits for the buttons of a mouse. */
enum {
    /** Movements of the mouse turn the tool instead of shifting it. */
    VBSS_MAPPING_MOUSE_TURN = 1,
    VBSS_MAPPING_MOUSE_CLOSE = 2 /**< The jaws close; otherwise they open. */
};

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Fills a mapping with the defaults.
 *
 * @param[out] config  the mapping to fill
 * @param struct_size  `sizeof *config` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_mapping_config_init(vbss_mapping_config *config, uint32_t struct_size);

/**
 * Returns the default configuration that #vbss_mapping_config_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_mapping_config vbss_mapping_config_default(void)
{
    vbss_mapping_config vbss_filled;
    (void)vbss_mapping_config_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/* ---- mapping: pure functions. Each moves the position, orientation and opening of a sample,
 * makes them valid, and adds h to its time. On failure the sample is unchanged. */

/**
 * Applies a motion of a mouse. It shifts the tool in the plane of the screen and, by the wheel, in
 * depth. With VBSS_MAPPING_MOUSE_TURN the side of the tool that faces the user follows the mouse,
 * and the wheel rolls the tool.
 *
 * @param config          the mapping; NULL for the defaults
 * @param motion          counts to the right, counts up, notches of the wheel away from the user; each at most 1e6
 * @param buttons         VBSS_MAPPING_MOUSE_ bits
 * @param h               time since the last call, s, 0 to 10
 * @param[in,out] sample  an initialised sample
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_UNKNOWN_FIELD,
 *         VBSS_ERROR_OUT_OF_RANGE or VBSS_ERROR_NOT_FINITE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_mapping_mouse(const vbss_mapping_config *config, const double motion[3],
                                        uint32_t buttons, double h, vbss_device_sample *sample);

/**
 * Applies presses of keys.
 *
 * @param config          the mapping; NULL for the defaults
 * @param presses         presses since the last call, negative for the opposite key: right, up,
 *                        towards the user, turns about these three, opening; each at most 1e6
 * @param h               time since the last call, s, 0 to 10
 * @param[in,out] sample  an initialised sample
 * @return as #vbss_mapping_mouse
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_mapping_keyboard(const vbss_mapping_config *config,
                                           const double presses[7], double h,
                                           vbss_device_sample *sample);

/**
 * Applies the state of a gamepad: its axes set rates, with a dead zone and a curve.
 *
 * @param config          the mapping; NULL for the defaults
 * @param axes            -1 to 1: right, up, towards the user, turns about these three; larger
 *         values count as full deflection
 * @param opening         opening of the jaws, 0 to 1, such as the value of a trigger
 * @param h               time since the last call, s, 0 to 10
 * @param[in,out] sample  an initialised sample
 * @return as #vbss_mapping_mouse
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_mapping_gamepad(const vbss_mapping_config *config, const double axes[6],
                                          double opening, double h, vbss_device_sample *sample);

#ifdef __cplusplus
}
#endif

#endif
