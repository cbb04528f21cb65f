/**
 * @file adapter.h
 * @brief The interface between a device (device.h) and one piece of hardware: a table of functions
 *   and their data.
 *
 * Hosts fill the table for their own hardware; mock.h and haptics.h supply filled ones.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_ADAPTER_H
#define VBLAST_SS_ADAPTER_H

#include <vblast_ss/output.h>

/* ---- data of adapters and devices */

/** Bits for the parts of a sample. */
enum {
    VBSS_DEVICE_HAS_POSITION = 1,         /**< `position` is valid. */
    VBSS_DEVICE_HAS_ORIENTATION = 2,      /**< `orientation` is valid. */
    VBSS_DEVICE_HAS_VELOCITY = 4,         /**< `velocity` is valid. */
    VBSS_DEVICE_HAS_ANGULAR_VELOCITY = 8, /**< `angular_velocity` is valid. */
    VBSS_DEVICE_HAS_JAW_RAW = 16,         /**< `jaw_raw` is valid. */
    VBSS_DEVICE_HAS_JAW = 32,             /**< `jaw` is valid and replaces `jaw_raw`. */
    VBSS_DEVICE_HAS_BUTTONS = 64,         /**< `buttons` is valid. */
    VBSS_DEVICE_HAS_TOOL = 128,           /**< `tool` is valid. */
    VBSS_DEVICE_HAS_TEMPERATURE = 256     /**< `temperature` is valid. */
};

/** Bits for the outputs of a device. */
enum {
    VBSS_DEVICE_OUT_FORCE = 1,   /**< Force on the hand. */
    VBSS_DEVICE_OUT_TORQUE = 2,  /**< Torque on the hand. */
    VBSS_DEVICE_OUT_SOLENOID = 4 /**< Solenoid in the handle. */
};

/** Bits for the state that a device reports with a sample. */
enum {
    /** The hardware is missing: unplugged, or its driver has failed. */
    VBSS_DEVICE_FLAG_LOST = 1,
    VBSS_DEVICE_FLAG_STOP =
        2, /**< Emergency stop; it latches as #vbss_device_latch_emergency_stop does. */
    /** The hardware refuses forces for now; all outputs are off while this bit is set. */
    VBSS_DEVICE_FLAG_FAULT = 4,
    /** The hardware is too slow to switch outputs off within vbss_output_result::expires. `explain`
     * gives its speed. */
    VBSS_DEVICE_FLAG_SLOW = 8
};

/** Kind of tool that a device holds: a VBSS_DEVICE_TOOL_ constant. */
typedef int32_t vbss_device_tool;

/** The constants of #vbss_device_tool. */
enum {
    VBSS_DEVICE_TOOL_NONE = 0,          /**< No tool. */
    VBSS_DEVICE_TOOL_NEEDLE_DRIVER = 1, /**< A needle driver. */
    VBSS_DEVICE_TOOL_SHEARS = 2         /**< Shears. */
};

/**
 * A sample of an adapter. The library passes a cleared one; the adapter fills the fields that it
 * has and sets their bits in `valid`. The library's memory has 4096 bytes, so an adapter with a
 * newer header may fill fields that an older library does not know. The library ignores them, and
 * unknown bits.
 */
typedef struct vbss_device_sample {
    uint32_t struct_size;  /**< Size of this struct in bytes, as the library knows it. */
    uint32_t valid;        /**< VBSS_DEVICE_HAS_ bits. */
    uint32_t flags;        /**< VBSS_DEVICE_FLAG_ bits; evaluated even if the read fails. */
    uint32_t buttons;      /**< Pressed buttons, one bit each. */
    vbss_device_tool tool; /**< Kind of tool. */
    uint32_t reserved;     /**< Zero. */
    double time;        /**< Time of the measurement, s, by any clock that never runs backwards. */
    double position[3]; /**< Position, m, each coordinate at most 1e3 in magnitude. */
    /** Orientation from handle to device frame, unit quaternion w, x, y, z. */
    double orientation[4];
    double velocity[3]; /**< Velocity, m/s, each component at most 1e3 in magnitude. */
    /** Angular velocity in the device's frame, rad/s, each component at most 1e4 in magnitude. */
    double angular_velocity[3];
    double jaw_raw;     /**< Opening in the sensor's unit, such as V, at most 1e6 in magnitude. */
    double jaw;         /**< Opening, 0 (closed) to 1 (open). */
    double temperature; /**< Temperature of the hottest motor, 0 (cold) to 1 (about to fail). */
} vbss_device_sample;

/** Capabilities of a device; 0 means unknown. The library passes a cleared struct of 4096 bytes, as
 * with #vbss_device_sample. */
typedef struct vbss_device_capabilities {
    uint32_t struct_size;         /**< Size of this struct in bytes. */
    uint32_t signals;             /**< VBSS_DEVICE_HAS_ bits that samples may have. */
    uint32_t outputs;             /**< VBSS_DEVICE_OUT_ bits of the available outputs. */
    uint32_t input_dof;           /**< Degrees of freedom that are measured. */
    uint32_t output_dof;          /**< Degrees of freedom that are driven. */
    uint32_t reserved;            /**< Zero. */
    double max_force;             /**< Peak force, N. */
    double max_continuous_force;  /**< Largest continuous force, N. */
    double max_torque;            /**< Peak torque, N m. */
    double max_continuous_torque; /**< Largest continuous torque, N m. */
    double max_stiffness;         /**< Largest stiffness that does not make the arm buzz, N/m. */
    double max_damping;           /**< Largest damping that does not make the arm buzz, N s/m. */
    double update_rate;           /**< Sample rate, Hz. */
    double workspace_low[3];      /**< Lower corner of the reachable box, device frame, m. */
    /** Upper corner of the reachable box; equal to `workspace_low` if unknown. */
    double workspace_high[3];
} vbss_device_capabilities;

/**
 * A virtual coupling between the hand and the tool. The force on the hand is
 *
 *     force + stiffness (position - p) + damping (velocity - v)
 *
 * with p and v the hand's position and velocity. Fill it with #vbss_device_coupling_init, then set
 * its fields. A device computes this force in each write, from the pose that was read last. An
 * adapter with its own servo (haptics.h) recomputes it in every tick from the pose just measured.
 * The simulation then adds no delay between the hand and its spring.
 */
typedef struct vbss_device_coupling {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    uint32_t reserved;    /**< Zero. */
    /** Position of the tool that is coupled to the hand, m, each coordinate at most 1e3 in
     * magnitude. */
    double position[3];
    /** Velocity of the tool, m/s, each component at most 1e3 in magnitude; default 0. */
    double velocity[3];
    /** Force that is added, N, each component at most 1e3 in magnitude; default 0. */
    double force[3];
    double stiffness; /**< Stiffness, N/m, 0 to 1e6; default 0. */
    double damping;   /**< Damping, N s/m, 0 to 1e6; default 0. */
} vbss_device_coupling;

/* ---- the adapter: functions of the host */

/**
 * Opens the hardware. Unlike `read` and `write`, it may block.
 *
 * @param user  the table's `user`
 * @return VBSS_OK, or any other number if the hardware could not be opened
 */
typedef vbss_result (*vbss_device_open_fn)(void *user);

/**
 * Closes the hardware. The library has switched its outputs off before.
 *
 * @param user  the table's `user`
 */
typedef void (*vbss_device_close_fn)(void *user);

/**
 * Reports the capabilities of the hardware. The library calls it once, after `open`.
 *
 * @param user               the table's `user`
 * @param[out] capabilities  cleared except for struct_size
 * @return VBSS_OK, or any other number if the capabilities are not available; the device is not
 *         created then
 */
typedef vbss_result (*vbss_device_describe_fn)(void *user, vbss_device_capabilities *capabilities);

/**
 * Returns the newest sample without waiting. It may return a sample again, with an unchanged time.
 *
 * @param user         the table's `user`
 * @param now          the host's clock, s
 * @param[out] sample  cleared except for struct_size and orientation (1, 0, 0, 0)
 * @return VBSS_OK, or any other number if there is no sample now
 */
typedef vbss_result (*vbss_device_read_fn)(void *user, double now, vbss_device_sample *sample);

/**
 * Writes the outputs without waiting.
 *
 * @param user    the table's `user`
 * @param now     the host's clock, s
 * @param output  the outputs; all numbers are finite; parts that this adapter does not have are
 *         zero
 * @return VBSS_OK, or any other number if the outputs were not written
 */
typedef vbss_result (*vbss_device_write_fn)(void *user, double now,
                                            const vbss_output_result *output);

/**
 * Describes the last failure in words.
 *
 * @param user       the table's `user`
 * @param[out] text  receives UTF-8 text and a final zero
 * @param bytes      size of `text`
 */
typedef void (*vbss_device_explain_fn)(void *user, char *text, uint32_t bytes);

/**
 * Writes like #vbss_device_write_fn, and replaces it when there is a coupling and forces are on.
 * The output has the coupling's force at the pose that was read last. Until `expires` has passed,
 * the adapter may apply the coupling's force at newer poses, within the limits of the output stage.
 *
 * @param user      the table's `user`
 * @param now       the host's clock, s
 * @param output    the outputs; all numbers are finite
 * @param coupling  the coupling, in the device's frame
 * @return VBSS_OK, or any other number if the outputs were not written
 */
typedef vbss_result (*vbss_device_couple_fn)(void *user, double now,
                                             const vbss_output_result *output,
                                             const vbss_device_coupling *coupling);

/** An adapter. Fill it with #vbss_device_adapter_init, then set the functions that exist. The
 * library calls them on the thread that calls the device. They must return (no longjmp, no
 * exception) and must not change the context. */
typedef struct vbss_device_adapter {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    uint32_t reserved;    /**< Zero. */
    /** Name in messages; NULL (default): "device". At most 31 bytes are kept. */
    const char *name;
    void *user;                 /**< Pointer that the functions receive; may be NULL. */
    vbss_device_open_fn open;   /**< Opens the hardware; NULL (default): nothing to open. */
    vbss_device_close_fn close; /**< Closes the hardware; NULL (default): nothing to close. */
    /** Reports the capabilities; NULL (default): all signals, and the outputs that there are
     * functions for. */
    vbss_device_describe_fn describe;
    /** Reads a sample; NULL (default) only beside another adapter, and if `write` is set. */
    vbss_device_read_fn read;
    vbss_device_write_fn write;     /**< Writes outputs; NULL (default): no outputs. */
    vbss_device_explain_fn explain; /**< Describes failures; NULL (default): no texts. */
    /** Writes outputs with a coupling; NULL (default): the adapter has no servo. */
    vbss_device_couple_fn couple;
} vbss_device_adapter;

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Fills an adapter with the defaults without functions.
 *
 * @param[out] adapter  the table to fill
 * @param struct_size   `sizeof *adapter` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_device_adapter_init(vbss_device_adapter *adapter, uint32_t struct_size);

/**
 * Returns the struct with the defaults that #vbss_device_adapter_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_device_adapter vbss_device_adapter_default(void)
{
    vbss_device_adapter vbss_filled;
    (void)vbss_device_adapter_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Fills a sample with the defaults: no valid part, orientation (1, 0, 0, 0).
 *
 * @param[out] sample  the sample to fill
 * @param struct_size  `sizeof *sample` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_device_sample_init(vbss_device_sample *sample, uint32_t struct_size);

/**
 * Returns the struct with the defaults that #vbss_device_sample_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_device_sample vbss_device_sample_default(void)
{
    vbss_device_sample vbss_filled;
    (void)vbss_device_sample_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Fills capabilities with the defaults: all unknown.
 *
 * @param[out] capabilities  the capabilities to fill
 * @param struct_size        `sizeof *capabilities` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_device_capabilities_init(vbss_device_capabilities *capabilities,
                                                   uint32_t struct_size);

/**
 * Returns the struct with the defaults that #vbss_device_capabilities_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_device_capabilities vbss_device_capabilities_default(void)
{
    vbss_device_capabilities vbss_filled;
    (void)vbss_device_capabilities_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Fills a coupling with the defaults: no force.
 *
 * @param[out] coupling  the coupling to fill
 * @param struct_size    `sizeof *coupling` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_device_coupling_init(vbss_device_coupling *coupling,
                                               uint32_t struct_size);

/**
 * Returns the struct with the defaults that #vbss_device_coupling_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_device_coupling vbss_device_coupling_default(void)
{
    vbss_device_coupling vbss_filled;
    (void)vbss_device_coupling_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

#ifdef __cplusplus
}
#endif

#endif
