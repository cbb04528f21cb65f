/**
 * @file device.h
 * @brief Haptic arms, instrument handles and solenoids. Input is sampled, checked and calibrated;
 *   output is limited to safe values. Works without a scene.
 *
 * An *adapter* is a table of functions for one piece of hardware, which the host fills or a
 * built-in object supplies. A #vbss_device uses one or two adapters: the pose may come from a
 * haptic arm, the jaw and the solenoid from the handle's electronics. The host reads and writes it
 * once in each step. Neither call blocks, because adapters never wait; slow hardware needs a thread
 * in its adapter that keeps the newest sample.
 *
 * All output passes the same output stage (output.h). mock.h has an adapter without hardware,
 * haptics.h adapters for real hardware, and mapping.h supports mouse, keyboard and gamepad.
 *
 * Time: `now` is the host's clock in s, at most 1e9 in magnitude, and never runs backwards. It is
 * real time when a hand is on the device. Frames: an adapter uses the device's own frame, and the
 * host the world's; #vbss_device_calibration relates them.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_DEVICE_H
#define VBLAST_SS_DEVICE_H

#include <vblast_ss/adapter.h>

/** A device: one or two adapters, calibration, and the output stage. */
typedef struct vbss_device vbss_device;

/* ---- calibration: data */

/**
 * Transform from the device to the world. Fill it with #vbss_device_calibration_init, then change
 * fields. Let p be a position and R an orientation of the device, f a force of the world, and C the
 * rotation times the matrix of `axes`:
 *
 *     position     offset + C scale p, then the clutch's shift, then into the workspace
 *     orientation  C R C^T mount: at the device's identity the tool is oriented as `mount`
 *     force        to the device: force_scale C^T f
 *
 * A stiffness k in the world is felt as k scale force_scale.
 */
typedef struct vbss_device_calibration {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    /** World axis i is device axis |axes[i]| (1 to 3), reversed if negative; default 1, 2, 3. A
     * left-handed choice mirrors. */
    int32_t axes[3];
    /** Rotation applied after `axes`, row by row, orthonormal to 1e-6; default identity. */
    double rotation[9];
    double scale;     /**< World metres per device metre, 1e-3 to 1e3; default 1. */
    double offset[3]; /**< Offset, m, each coordinate at most 1e3 in magnitude; default 0. */
    /** Orientation of the tool frame in the handle's frame, w, x, y, z, any length; default 1, 0,
     * 0, 0. */
    double mount[4];
    /** Lower corner of the box to which poses are confined, world, m; default -1. */
    double workspace_low[3];
    /** Upper corner of the box, above the lower one, at most 1e3 in magnitude; default 1. */
    double workspace_high[3];
    double force_scale; /**< Device force per world force, 1e-3 to 1e3; default 1. */
    double jaw_closed;  /**< `jaw_raw` of the closed handle; default 0. */
    /** `jaw_raw` of the open handle, at least 1e-9 away from jaw_closed, above or below; default
     * 1. */
    double jaw_open;
    /** Largest distance of a raw value outside the range from closed to open, as a share of the
     * range, 0 to 10; default 0.25. A value farther outside is refused, because the sensor must be
     * broken. */
    double jaw_margin;
    /** Backlash: largest movement of the opening that is ignored, 0 to 0.5; default 0.02. */
    double jaw_play;
    double jaw_time; /**< Time constant of the opening's filter, s, 0 to 10; default 0.01. */
    /** Opening at and below which the jaws become closed, 0 to 1; default 0.05. */
    double jaw_close_at;
    /** Opening at and above which closed jaws become open, jaw_close_at to 1; default 0.1. */
    double jaw_open_at;
} vbss_device_calibration;

/* ---- devices */

/** Interpretation of the times of samples: a VBSS_DEVICE_CLOCK_ constant. */
typedef int32_t vbss_device_clock;

/** The constants of #vbss_device_clock. */
enum {
    /** The adapter's clock has its own origin. The age of a sample is the time since the first read
     * that returned it. */
    VBSS_DEVICE_CLOCK_OWN = 0,
    /** The adapter uses the host's clock. The age of a sample follows from its own time, so that
     * delays are known. */
    VBSS_DEVICE_CLOCK_SHARED = 1
};

/** Configuration of a device. Fill it with #vbss_device_config_init, then change fields. */
typedef struct vbss_device_config {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    /** Kind of tool, where no adapter reports one; default VBSS_DEVICE_TOOL_NEEDLE_DRIVER. */
    vbss_device_tool tool;
    /** VBSS_DEVICE_HAS_ bits of the signals that come from the second adapter, if there is one;
     * default the jaw. A bit of the pose (position, orientation, velocities) selects the whole
     * pose; either bit of the opening selects both. */
    uint32_t second_signals;
    vbss_device_clock clock; /**< Interpretation of sample times; default VBSS_DEVICE_CLOCK_OWN. */
    /** 1 (default): a lost adapter latches the emergency stop; 0: its samples only become stale. */
    uint32_t stop_when_lost;
    /** 1: the clutch holds the orientation too; 0 (default): the orientation always follows the
     * hand. */
    uint32_t clutch_orientation;
    /** 1: the reported opening never jumps. It is held while the clutch is held, and after
     * #vbss_device_restore, a change of tool or #vbss_device_hold_jaw, until the handle has passed
     * it. A session also holds it in its first step and after #vbss_session_restore. 0 (default):
     * the opening always follows the handle. */
    uint32_t jaw_takeover;
    uint32_t reserved; /**< Zero. */
    /** Age at which the jaw's opening is stale, s, 1e-4 to 1e3; default 0.1. The pose uses
     * input_timeout of the output stage. */
    double jaw_timeout;
    double velocity_time; /**< Time constant of estimated velocities, s, 0 to 10; default 0.005. */
    /** Largest |1 - length| of an orientation that is accepted and normalised, 0 to 0.5; default
     * 1e-3. */
    double norm_tolerance;
    /** Upper limit of couplings, N/m, 0 to 1e6; default 400. The device only reports it. */
    double max_stiffness;
    /** Upper limit of couplings, N s/m, 0 to 1e6; default 4. The device only reports it. */
    double max_damping;
    /** Calibration; NULL (default): the initialised one. The library copies it. */
    const vbss_device_calibration *calibration;
    /** Output stage; NULL (default): the initialised one. The library copies it. */
    const vbss_output_config *output;
} vbss_device_config;

/** Status of a device: a VBSS_DEVICE_STATUS_ constant. */
typedef int32_t vbss_device_status;

/** The constants of #vbss_device_status. */
enum {
    VBSS_DEVICE_STATUS_WAITING = 0, /**< There is no pose yet. */
    VBSS_DEVICE_STATUS_READY = 1,   /**< The pose is current. */
    VBSS_DEVICE_STATUS_STALE = 2,   /**< The pose is stale; the last one is held. */
    VBSS_DEVICE_STATUS_LOST = 3     /**< An adapter reports that its hardware is missing. */
};

/** Bits of the events of a read. */
enum {
    VBSS_DEVICE_EVENT_LOST = 1,       /**< An adapter's hardware is missing. */
    VBSS_DEVICE_EVENT_FOUND = 2,      /**< An adapter's hardware is back. */
    VBSS_DEVICE_EVENT_STALE = 4,      /**< The pose became stale. */
    VBSS_DEVICE_EVENT_FRESH = 8,      /**< The pose is current again, or came for the first time. */
    VBSS_DEVICE_EVENT_JAW_STALE = 16, /**< The opening became stale. */
    /** The opening is current again, or came for the first time. */
    VBSS_DEVICE_EVENT_JAW_FRESH = 32,
    VBSS_DEVICE_EVENT_REFUSED = 64,     /**< A sample or raw opening was refused. */
    VBSS_DEVICE_EVENT_FAILED = 128,     /**< An adapter returned no sample. */
    VBSS_DEVICE_EVENT_STOPPED = 256,    /**< The device latched the emergency stop. */
    VBSS_DEVICE_EVENT_FAULT = 512,      /**< A device began to refuse forces. */
    VBSS_DEVICE_EVENT_RESTARTED = 1024, /**< The clock of an adapter restarted. */
    VBSS_DEVICE_EVENT_TOOL = 2048,      /**< The kind of tool has changed. */
    /** An adapter became too slow to switch outputs off in time. */
    VBSS_DEVICE_EVENT_SLOW = 4096,
    VBSS_DEVICE_EVENT_JAW_HELD = 8192,  /**< The opening is held until the handle has passed it. */
    VBSS_DEVICE_EVENT_JAW_TAKEN = 16384 /**< The handle took over the opening. */
};

/** Result of a read, in the world's frame. */
typedef struct vbss_device_input {
    uint32_t struct_size;      /**< Bytes of this struct that the library filled. */
    vbss_device_status status; /**< Status of the device. */
    uint32_t valid; /**< VBSS_DEVICE_HAS_ bits of the known values; estimated velocities count. */
    /** VBSS_DEVICE_HAS_ bits of the values that are stale and held; stale velocities are zero. */
    uint32_t stale;
    uint32_t events;       /**< VBSS_DEVICE_EVENT_ bits. */
    uint32_t clamped;      /**< Bits 1, 2, 4: the workspace limits x, y, z. */
    uint32_t buttons;      /**< Buttons as last reported, one bit each. */
    uint32_t pressed;      /**< Buttons that were up in the last read and are down now. */
    uint32_t released;     /**< Buttons that were down in the last read and are up now. */
    vbss_device_tool tool; /**< Kind of tool. */
    int32_t jaw_closed;    /**< 1: the jaws count as closed. */
    int32_t clutched;      /**< 1: the clutch is held, so the pose stays and there is no force. */
    int32_t stopped;       /**< 1: the emergency stop is latched. */
    uint32_t jaw_held;     /**< 1: `jaw` is held until the handle has passed it. */
    double time;           /**< Time of the pose, by the adapter's clock, s. */
    double age;            /**< Age of the pose, s; -1: there is none. */
    double jaw_age;        /**< Age of the opening, s; -1: there is none. */
    double position[3];    /**< Position, m. */
    double orientation[4]; /**< Orientation from tool to world, unit quaternion w, x, y, z. */
    double velocity[3];    /**< Velocity, m/s. */
    double angular_velocity[3]; /**< Angular velocity in the world's frame, rad/s. */
    double jaw;                 /**< Opening, 0 (closed) to 1 (open). */
    double jaw_raw;             /**< Raw opening as last reported. */
    double temperature;         /**< Temperature as last reported, 0 to 1. */
} vbss_device_input;

/** Counts of a device since creation. Entry [0] is of the first adapter and [1] of the second. */
typedef struct vbss_device_statistics {
    uint32_t struct_size;     /**< Bytes of this struct that the library filled. */
    uint32_t reserved;        /**< Zero. */
    uint64_t reads;           /**< Calls of #vbss_device_read. */
    uint64_t writes;          /**< Calls of #vbss_device_write. */
    uint64_t accepted[2];     /**< Samples accepted. */
    uint64_t repeated[2];     /**< Samples whose time had not advanced. */
    uint64_t out_of_order[2]; /**< Samples refused because they are older than the one before. */
    uint64_t not_finite[2];   /**< Samples refused because of a NaN or an infinity. */
    uint64_t out_of_range[2]; /**< Samples refused because a field is out of range. */
    uint64_t not_unit[2]; /**< Samples refused because of an orientation outside norm_tolerance. */
    uint64_t failed_reads[2];  /**< Reads without a sample. */
    uint64_t failed_writes[2]; /**< Outputs that an adapter did not accept. */
    uint64_t lost[2];          /**< Times the hardware was lost. */
    uint64_t faults[2];        /**< Times the hardware began to refuse forces. */
    uint64_t restarts[2];      /**< Times the adapter's clock restarted. */
    uint64_t jaw_refused;      /**< Raw openings refused because they are outside jaw_margin. */
    uint64_t pose_stale;       /**< Times the pose became stale. */
    uint64_t pose_stale_reads; /**< Reads with a stale pose. */
    uint64_t jaw_stale;        /**< Times the opening became stale. */
    uint64_t clamped_reads;    /**< Reads in which the workspace limited the pose. */
    uint64_t clutches;         /**< Times the clutch was held. */
    double oldest_pose;        /**< Largest age of a pose, s. */
} vbss_device_statistics;

#ifdef __cplusplus
extern "C" {
#endif

/* ---- structs that hosts fill */

/**
 * Fills a calibration with the defaults: the device's frame is the world's.
 *
 * @param[out] calibration  the calibration to fill
 * @param struct_size       `sizeof *calibration` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_device_calibration_init(vbss_device_calibration *calibration,
                                                  uint32_t struct_size);

/**
 * Returns the struct with the defaults that #vbss_device_calibration_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_device_calibration vbss_device_calibration_default(void)
{
    vbss_device_calibration vbss_filled;
    (void)vbss_device_calibration_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Fills a device's configuration with the defaults.
 *
 * @param[out] config  the configuration to fill
 * @param struct_size  `sizeof *config` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 1.0
 */
VBSS_API vbss_result vbss_device_config_init(vbss_device_config *config, uint32_t struct_size);

/**
 * Returns the default configuration that #vbss_device_config_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_device_config vbss_device_config_default(void)
{
    vbss_device_config vbss_filled;
    (void)vbss_device_config_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/* ---- devices */

/**
 * Creates a device: copies the tables of its adapters, opens them and asks for their capabilities.
 *
 * @param context      owner
 * @param first        the adapter of the pose; must have `read`
 * @param second       an adapter for the signals in `second_signals` and for outputs, or NULL. The
 *         second adapter drives the solenoid if it has one. The first one drives forces if it can.
 * @param config       configuration; NULL for the defaults
 * @param[out] device  the new device; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_DEVICE (an adapter could not be opened or described; the error text
 *         quotes it), VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE (also in
 *         capabilities), VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY; on failure no adapter is open
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_device_create(vbss_context *context, const vbss_device_adapter *first,
                                        const vbss_device_adapter *second,
                                        const vbss_device_config *config, vbss_device **device);

/**
 * Switches all outputs off, closes the adapters and destroys the device.
 *
 * @param device  the device; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_device_destroy(vbss_device *device);

/**
 * Reads each adapter once. The call succeeds even if the hardware fails: status, stale, events and
 * statistics report faults. The library also logs a warning when the hardware is lost, is back, has
 * stopped, refuses forces or restarts its clock. The call allocates nothing.
 *
 * @param device       the device
 * @param now          the host's clock, s; not before the `now` of an earlier call. If it is
 *         earlier or out of range, the call returns an error and switches all outputs off
 * @param[out] input   receives the input
 * @param struct_size  `sizeof *input` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE, VBSS_ERROR_ARITHMETIC_MODE or
 *         VBSS_ERROR_BUSY; after an error no adapter was read
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_device_read(vbss_device *device, double now, vbss_device_input *input,
                                      uint32_t struct_size);

/**
 * Passes a command through the output stage and writes the result to the adapters. While the clutch
 * is held, forces and solenoid are off. Two writes more than 0.1 s apart mean that the clock has
 * jumped or the host was suspended: all outputs are then off for vbss_output_result::expires. The
 * call allocates nothing.
 *
 * @param device       the device
 * @param now          the host's clock, s; not before the `now` of an earlier call. If it is
 *         earlier or out of range, the call returns an error and switches all outputs off
 * @param command      the wanted outputs, forces in the world's frame; NULL: no new command, so
 *         that the last one ages
 * @param[out] result  receives the outputs as written, in the device's frame; may be NULL
 * @param struct_size  `sizeof *result` as the caller was compiled
 * @return as #vbss_device_read, or VBSS_ERROR_UNKNOWN_FIELD; after an error nothing was written,
 *         except zeros for a wrong `now`
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_device_write(vbss_device *device, double now,
                                       const vbss_output_command *command,
                                       vbss_output_result *result, uint32_t struct_size);

/**
 * Writes like #vbss_device_write, with the force of a virtual coupling. The coupling acts relative to
 * the pose that was read last; where the workspace limits that pose, it also limits the coupling. An
 * adapter with its own servo receives the coupling in its frame, unless forces are off. It then
 * applies the coupling without the host until `command_timeout` of its output stage has passed.
 *
 * A device gets the force of a tool's spring in one way only. Use this function with the pose of the
 * tool, or #vbss_device_write with vbss_grasper_state::hand_force. Both at once would be twice the
 * spring, so this call refuses a command with a force. docs/reference/device-layer.md says which one suits which
 * device.
 *
 * @param device       the device
 * @param now          the host's clock, s; not before the `now` of an earlier call. If it is
 *         earlier or out of range, the call returns an error and switches all outputs off
 * @param command      the other wanted outputs, torque in the world's frame; its force must be 0.
 *         vbss_device_coupling::force has other forces than that of the spring
 * @param coupling     pose of the tool and the coupling to the hand, in the world's frame
 * @param[out] result  receives the outputs as written, in the device's frame; may be NULL
 * @param struct_size  `sizeof *result` as the caller was compiled
 * @return as #vbss_device_write (VBSS_ERROR_OUT_OF_RANGE also: the command has a force), or
 *         VBSS_ERROR_NULL_ARGUMENT
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_device_write_coupled(vbss_device *device, double now,
                                               const vbss_output_command *command,
                                               const vbss_device_coupling *coupling,
                                               vbss_output_result *result, uint32_t struct_size);

/**
 * Emergency stop: writes zeros at once and latches. All outputs stay off until
 * #vbss_device_clear_emergency_stop.
 *
 * @param device  the device
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_device_latch_emergency_stop(vbss_device *device);

/**
 * Clears the emergency stop. Forces rise from zero. If its cause persists, the next read latches
 * it again.
 *
 * @param device  the device
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_device_clear_emergency_stop(vbss_device *device);

/**
 * Holds or releases the clutch. While it is held, the pose stays and the hand moves freely. After
 * the release the pose follows the hand from where it stayed.
 *
 * @param device  the device
 * @param held    1: hold, 0: release; no effect if it is already so
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_OUT_OF_RANGE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_device_set_clutch(vbss_device *device, int32_t held);

/**
 * Shifts and turns the calibrated pose so that the last sample corresponds to a given pose, and
 * releases the clutch.
 *
 * @param device       the device
 * @param position     position of the tool, world, m, each coordinate at most 1e3 in magnitude;
 *         NULL keeps it
 * @param orientation  quaternion w, x, y, z, of any length from 1e-100 to 1e100; NULL keeps it
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_WRONG_STATE (there is no pose yet),
 *         VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_device_recentre(vbss_device *device, const double *position,
                                          const double *orientation);

/**
 * Holds the opening that reads report until the handle has passed it, or has come within 0.04 of
 * it. A host calls this when the jaws and the handle differ, for example after it has restored a
 * scene.
 *
 * @param device   the device; its configuration has `jaw_takeover`
 * @param opening  opening of the jaws, 0 (closed) to 1 (open)
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_INCOMPATIBLE (the
 *         configuration has no `jaw_takeover`), VBSS_ERROR_NOT_FINITE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_device_hold_jaw(vbss_device *device, double opening);

/**
 * Replaces the calibration from the next read on. The call resets the shifts of the clutch and of
 * #vbss_device_recentre and the filter of the opening.
 *
 * @param device       the device
 * @param calibration  the calibration; NULL for the defaults
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_UNKNOWN_FIELD,
 *         VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_device_set_calibration(vbss_device *device,
                                                 const vbss_device_calibration *calibration);

/**
 * Returns the capabilities of the hardware.
 *
 * @param device             the device
 * @param which              0 or 1: capabilities that the first or second adapter reports; 2: both
 *         together, within the limits of the configuration
 * @param[out] capabilities  receives the capabilities
 * @param struct_size        `sizeof *capabilities` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_NOT_FOUND (no such adapter)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_device_get_capabilities(vbss_device *device, uint32_t which,
                                                  vbss_device_capabilities *capabilities,
                                                  uint32_t struct_size);

/**
 * Returns the last failure of an adapter.
 *
 * @param device       the device
 * @param which        0 or 1: the first or second adapter
 * @param[out] result  the result of its function, VBSS_OK when nothing has failed yet; may be NULL
 * @param[out] text    its explanation, never NULL, valid until the next call that reads, writes or
 *         restores the device; the argument may be NULL
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_NOT_FOUND (no such adapter)
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_device_get_error(vbss_device *device, uint32_t which, vbss_result *result,
                                           const char **text);

/**
 * Returns the input statistics of a device.
 *
 * @param device           the device
 * @param[out] statistics  receives them
 * @param struct_size      `sizeof *statistics` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_device_get_statistics(vbss_device *device,
                                                vbss_device_statistics *statistics,
                                                uint32_t struct_size);

/**
 * Returns the statistics of the device's output stage.
 *
 * @param device           the device
 * @param[out] statistics  receives them
 * @param struct_size      `sizeof *statistics` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_device_get_output_statistics(vbss_device *device,
                                                       vbss_output_statistics *statistics,
                                                       uint32_t struct_size);

/**
 * Saves the device layer: calibration, clutch, filters, ages, output stage, latch and statistics.
 * The state of the adapters is not saved.
 *
 * @param device        the device
 * @param[out] bytes    receives the snapshot; NULL with capacity 0 asks for its size, which logs no error
 * @param capacity      size of `bytes`
 * @param[out] written  bytes written, or bytes needed with VBSS_ERROR_CAPACITY
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_CAPACITY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_device_save(vbss_device *device, uint8_t *bytes, uint64_t capacity,
                                      uint64_t *written);

/**
 * Restores a snapshot of a device with the same configuration and capabilities, completely or not
 * at all. The call also restores the latch of the emergency stop. With a hand on the device, call
 * #vbss_device_latch_emergency_stop afterwards.
 *
 * @param device  the device
 * @param bytes   the snapshot
 * @param count   its size
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED,
 *         VBSS_ERROR_CORRUPT (also: the snapshot is of another device), VBSS_ERROR_DATA_VERSION,
 *         VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY; on failure nothing has changed
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_device_restore(vbss_device *device, const uint8_t *bytes, uint64_t count);

/**
 * Returns a hash of the device layer; equal histories give equal hashes on every machine.
 *
 * @param device     the device
 * @param[out] hash  receives the hash
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_NULL_ARGUMENT
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_device_get_hash(vbss_device *device, uint64_t *hash);

#ifdef __cplusplus
}
#endif

#endif
