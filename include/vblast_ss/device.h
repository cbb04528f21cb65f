/**
 * @file device.h
 * @brief Haptic arms, instrument handles and solenoids: sampled, checked and calibrated on the way in, made safe on
 * the way out. Works without a scene.
 *
 * An *adapter* is a table of functions that the host fills (or a built-in object hands out) for one piece of
 * hardware. A #vbss_device stands on one or two of them: the pose may come from a haptic arm, the jaw and the
 * solenoid from the handle's electronics. In each step of the host it is read once and written once; neither call
 * blocks, as adapters never wait (slow hardware has a thread of the adapter's own that keeps the newest sample).
 *
 * What goes out passes an output stage that is the same for every device (output.h). An adapter without hardware stands
 * in mock.h, real hardware in haptics.h, mouse, keyboard and gamepad in mapping.h.
 *
 * Time: `now` is the host's clock in s, real time when a hand is on the device, at most 1e9 in magnitude, never
 * running backwards. Frames: an adapter speaks in the device's own frame, the host hears of the world's;
 * #vbss_device_calibration stands between them.
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
 * From the device to the world. Fill it with #vbss_device_calibration_init, then change what you need. With C the
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
    /** World axis i is device axis |axes[i]| (1 to 3), negative: reversed; default 1, 2, 3. An odd one mirrors. */
    int32_t axes[3];
    double rotation[9]; /**< Then this rotation, row by row, right to 1e-6; default identity. */
    double scale;       /**< World metres per device metre, 1e-3 to 1e3; default 1. */
    double offset[3];   /**< m, each at most 1e3; default 0. */
    double mount[4]; /**< Tool frame in the handle's, w, x, y, z, any length; default 1, 0, 0, 0. */
    double workspace_low[3]; /**< Corner of the box that poses are kept in, world, m; default -1. */
    double workspace_high[3]; /**< The opposite corner, above it; each within 1e3; default 1. */
    double force_scale;       /**< 1e-3 to 1e3; default 1. */
    double jaw_closed;        /**< `jaw_raw` of the closed handle; default 0. */
    double jaw_open; /**< The same of the open one; more or less, but 1e-9 apart; default 1. */
    /** How far outside this range, as a part of it, a raw value is believed, 0 to 10; default 0.25. Beyond, the
     * sensor is broken and the value refused. */
    double jaw_margin;
    /** Movements of the opening smaller than this are not seen, 0 to 0.5; default 0.02. */
    double jaw_play;
    double jaw_time; /**< Time constant of the filter of the opening, s, 0 to 10; default 0.01. */
    /** The jaws count as closed from this opening down, 0 to 1; default 0.05, */
    double jaw_close_at;
    /** and as not closed again from this one up, at least jaw_close_at; default 0.1. */
    double jaw_open_at;
} vbss_device_calibration;

/* ---- devices */

/** How the times of samples are read: a VBSS_DEVICE_CLOCK_ constant. */
typedef int32_t vbss_device_clock;

/** The constants of #vbss_device_clock. */
enum {
    /** Of any origin: a sample is as old as the read that found its time advanced. */
    VBSS_DEVICE_CLOCK_OWN = 0,
    /** The host's own: a sample is as old as it says, so that one that comes late is known to. */
    VBSS_DEVICE_CLOCK_SHARED = 1
};

/** How to make a device. Fill it with #vbss_device_config_init, then change what you need. */
typedef struct vbss_device_config {
    uint32_t struct_size;  /**< Size of this struct in bytes, set by the init function. */
    vbss_device_tool tool; /**< Where no adapter tells; default VBSS_DEVICE_TOOL_NEEDLE_DRIVER. */
    /** VBSS_DEVICE_HAS_ bits that come from the second adapter, if there is one; default the jaw. One of the pose
     * (position, orientation, velocities) brings all of it, one opening the other. */
    uint32_t second_signals;
    vbss_device_clock clock; /**< Default VBSS_DEVICE_CLOCK_OWN. */
    /** 1 (default): a lost adapter latches the emergency stop; 0: its samples just grow old. */
    uint32_t stop_when_lost;
    /** 1: the clutch holds the orientation too; 0 (default): it always follows. */
    uint32_t clutch_orientation;
    /** 1: the opening does not jump. It stays as it was reported last while the clutch is held, after
     * #vbss_device_restore, after another tool was taken, and after #vbss_device_hold_jaw, until the handle has passed
     * it; a session also does so in its first step and after #vbss_session_restore. 0 (default): it always follows. */
    uint32_t jaw_takeover;
    uint32_t reserved; /**< Zero. */
    /** Age at which the jaw's opening is stale, s, 1e-4 to 1e3; default 0.1. The pose's is the output's
     * input_timeout. */
    double jaw_timeout;
    double velocity_time; /**< Time constant of estimated velocities, s, 0 to 10; default 0.005. */
    /** |1 - length| of an orientation that is taken and made unit, 0 to 0.5; default 1e-3. */
    double norm_tolerance;
    double max_stiffness; /**< Ceiling for couplings, N/m, 0 to 1e6; default 400. Only told. */
    double max_damping;   /**< The same, N s/m; default 4. Only told. */
    const vbss_device_calibration *calibration; /**< NULL (default): as initialised. Copied. */
    const vbss_output_config *output;           /**< NULL (default): as initialised. Copied. */
} vbss_device_config;

/** How a device is: a VBSS_DEVICE_ status constant. */
typedef int32_t vbss_device_status;

/** The constants of #vbss_device_status. */
enum {
    VBSS_DEVICE_WAITING = 0, /**< There was no pose yet. */
    VBSS_DEVICE_READY = 1,   /**< The pose is new. */
    VBSS_DEVICE_STALE = 2,   /**< The pose is old and held. */
    VBSS_DEVICE_LOST = 3     /**< An adapter says that its hardware is not there. */
};

/** What happened in a read: bits. */
enum {
    VBSS_DEVICE_EVENT_LOST = 1,         /**< An adapter's hardware is gone, */
    VBSS_DEVICE_EVENT_FOUND = 2,        /**< or back. */
    VBSS_DEVICE_EVENT_STALE = 4,        /**< The pose became stale, */
    VBSS_DEVICE_EVENT_FRESH = 8,        /**< or new again, or came for the first time. */
    VBSS_DEVICE_EVENT_JAW_STALE = 16,   /**< The opening became stale, */
    VBSS_DEVICE_EVENT_JAW_FRESH = 32,   /**< or new again, or came for the first time. */
    VBSS_DEVICE_EVENT_REFUSED = 64,     /**< A sample or raw opening was refused. */
    VBSS_DEVICE_EVENT_FAILED = 128,     /**< An adapter gave no sample. */
    VBSS_DEVICE_EVENT_STOPPED = 256,    /**< The device latched the emergency stop. */
    VBSS_DEVICE_EVENT_FAULT = 512,      /**< A device began to refuse forces. */
    VBSS_DEVICE_EVENT_RESTARTED = 1024, /**< The clock of an adapter began anew. */
    VBSS_DEVICE_EVENT_TOOL = 2048,      /**< The tool is another. */
    VBSS_DEVICE_EVENT_SLOW = 4096, /**< An adapter became too slow to put outputs off in time. */
    VBSS_DEVICE_EVENT_JAW_HELD = 8192,  /**< The opening is held until the handle has passed it. */
    VBSS_DEVICE_EVENT_JAW_TAKEN = 16384 /**< The handle took over the opening. */
};

/** What a read found, in the world's frame. */
typedef struct vbss_device_input {
    uint32_t struct_size;      /**< Bytes of this struct that the library filled. */
    vbss_device_status status; /**< How the device is. */
    uint32_t valid;    /**< VBSS_DEVICE_HAS_ bits of what is known; estimated velocities count. */
    uint32_t stale;    /**< Of them, those that are too old and held; stale velocities are zero. */
    uint32_t events;   /**< VBSS_DEVICE_EVENT_ bits. */
    uint32_t clamped;  /**< 1, 2, 4: x, y, z is held at the workspace. */
    uint32_t buttons;  /**< As told last. */
    uint32_t pressed;  /**< Those that were up in the last read. */
    uint32_t released; /**< Those that were down in the last read. */
    vbss_device_tool tool;      /**< Kind of tool. */
    int32_t jaw_closed;         /**< 1: the jaws count as closed. */
    int32_t clutched;           /**< 1: the clutch is held: the pose stays, there is no force. */
    int32_t stopped;            /**< 1: the emergency stop is latched. */
    uint32_t jaw_held;          /**< 1: `jaw` is held until the handle has passed it. */
    double time;                /**< Of the pose, by the adapter's clock, s. */
    double age;                 /**< Of the pose, s; -1: there was none. */
    double jaw_age;             /**< Of the opening, s; -1: there was none. */
    double position[3];         /**< m. */
    double orientation[4];      /**< w, x, y, z, unit: tool to world. */
    double velocity[3];         /**< m/s. */
    double angular_velocity[3]; /**< rad/s, in the world's frame. */
    double jaw;                 /**< Opening, 0 closed to 1 open. */
    double jaw_raw;             /**< As told last. */
    double temperature;         /**< As told last. */
} vbss_device_input;

/** Figures of a device since creation; [0] and [1]: of the first and the second adapter. */
typedef struct vbss_device_statistics {
    uint32_t struct_size;      /**< Bytes of this struct that the library filled. */
    uint32_t reserved;         /**< Zero. */
    uint64_t reads;            /**< Calls of #vbss_device_read. */
    uint64_t writes;           /**< Calls of #vbss_device_write. */
    uint64_t accepted[2];      /**< Samples that were taken. */
    uint64_t repeated[2];      /**< Samples whose time had not advanced. */
    uint64_t out_of_order[2];  /**< Refused: older than the one before. */
    uint64_t not_finite[2];    /**< Refused: with a NaN or an infinity. */
    uint64_t out_of_range[2];  /**< Refused: outside what the fields allow. */
    uint64_t not_unit[2];      /**< Refused: an orientation outside norm_tolerance. */
    uint64_t failed_reads[2];  /**< Reads without a sample. */
    uint64_t failed_writes[2]; /**< Outputs that were not taken. */
    uint64_t lost[2];          /**< How often the hardware was lost. */
    uint64_t faults[2];        /**< How often it began to refuse forces. */
    uint64_t restarts[2];      /**< How often its clock began anew. */
    uint64_t jaw_refused;      /**< Raw openings outside jaw_margin. */
    uint64_t pose_stale;       /**< How often the pose became stale. */
    uint64_t pose_stale_reads; /**< Reads in which it was. */
    uint64_t jaw_stale;        /**< How often the opening became stale. */
    uint64_t clamped_reads;    /**< Reads in which the workspace held the pose. */
    uint64_t clutches;         /**< How often the clutch was held. */
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
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_calibration_init(vbss_device_calibration *calibration,
                                                  uint32_t struct_size);

/**
 * Fills a device's configuration with the defaults.
 *
 * @param[out] config  the configuration to fill
 * @param struct_size  `sizeof *config` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_config_init(vbss_device_config *config, uint32_t struct_size);

/* ---- devices */

/**
 * Opens a device: opens and describes its adapters, whose tables are copied.
 *
 * @param context      owner
 * @param first        the adapter of the pose; must have `read`
 * @param second       another for what `second_signals` says, and for outputs: the solenoid is the second's if it has
 *                     one, forces are the first's if it has them; NULL: there is none
 * @param config       how; NULL for the defaults
 * @param[out] device  the new device; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_DEVICE (an adapter could not be opened or described; the text says what it says),
 *         VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_UNKNOWN_FIELD,
 *         VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE (also: capabilities), VBSS_ERROR_OUT_OF_MEMORY or
 *         VBSS_ERROR_BUSY; on failure no adapter is open
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_create(vbss_context *context, const vbss_device_adapter *first,
                                        const vbss_device_adapter *second,
                                        const vbss_device_config *config, vbss_device **device);

/**
 * Puts all outputs off, closes the adapters and destroys the device.
 *
 * @param device  the device; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_destroy(vbss_device *device);

/**
 * Reads each adapter once. Whatever is wrong with the hardware is told by status, stale, events and statistics, and
 * what asks for somebody (lost, back, stopped, refuses forces, counts time anew) by a warning in the log; the call
 * succeeds. Nothing is allocated.
 *
 * @param device       the device
 * @param now          the host's clock, s; not before the `now` of an earlier call. If it is, or is no number in
 *                     range, the call returns an error and puts all outputs off
 * @param[out] input   receives what was found
 * @param struct_size  `sizeof *input` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE, VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY; then no
 *         adapter was read
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_read(vbss_device *device, double now, vbss_device_input *input,
                                      uint32_t struct_size);

/**
 * Puts a command through the output stage and writes what is left of it to the adapters. While the clutch is held,
 * forces and solenoid are off. When two writes are more than 0.1 s apart, the clock has jumped or the host was stopped:
 * all outputs are off for vbss_output_result::expires from then on. Nothing is allocated.
 *
 * @param device       the device
 * @param now          the host's clock, s; not before the `now` of an earlier call. If it is, or is no number in
 *                     range, the call returns an error and puts all outputs off
 * @param command      what is wanted, forces in the world's frame; NULL: there is no new command since the last, which
 *                     grows old
 * @param[out] result  receives what went out, in the device's frame; may be NULL
 * @param struct_size  `sizeof *result` as the caller was compiled
 * @return as #vbss_device_read, further VBSS_ERROR_UNKNOWN_FIELD; then nothing was written, or zeros for a wrong `now`
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_write(vbss_device *device, double now,
                                       const vbss_output_command *command,
                                       vbss_output_result *result, uint32_t struct_size);

/**
 * As #vbss_device_write, with a force that a virtual coupling adds to the command's. An adapter with a servo of its own is
 * handed the coupling, in its frame, unless forces are off for any reason: then it goes on without the host for as long as
 * `command_timeout` of its output stage allows. Relative to the pose that was read last: where the workspace holds the
 * pose, the coupling holds no more than that.
 *
 * @param device       the device
 * @param now          the host's clock, s; not before the `now` of an earlier call. If it is, or is no number in
 *                     range, the call returns an error and puts all outputs off
 * @param command      what else is wanted, forces in the world's frame
 * @param coupling     where the tool is that the hand is tied to, and how, in the world's frame
 * @param[out] result  receives what went out, in the device's frame; may be NULL
 * @param struct_size  `sizeof *result` as the caller was compiled
 * @return as #vbss_device_write, further VBSS_ERROR_NULL_ARGUMENT
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_write_coupled(vbss_device *device, double now,
                                               const vbss_output_command *command,
                                               const vbss_device_coupling *coupling,
                                               vbss_output_result *result, uint32_t struct_size);

/**
 * Emergency stop: writes zeros at once, and latches: nothing goes out until #vbss_device_release.
 *
 * @param device  the device
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_stop(vbss_device *device);

/**
 * Lets the emergency stop go. Forces rise from zero; a cause that is still there latches again in the next read.
 *
 * @param device  the device
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_release(vbss_device *device);

/**
 * Holds or lets go the clutch. While it is held the pose stays and the hand moves freely; let go, the pose goes on
 * from where it stayed.
 *
 * @param device  the device
 * @param held    1: hold, 0: let go; as it was: nothing happens
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_OUT_OF_RANGE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_clutch(vbss_device *device, int32_t held);

/**
 * Shifts and turns the calibrated pose so that the last sample stands for a given pose; lets the clutch go.
 *
 * @param device       the device
 * @param position     of the tool, world, m, each at most 1e3; NULL leaves it
 * @param orientation  w, x, y, z, of any length from 1e-100 to 1e100; NULL leaves it
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_OUT_OF_RANGE (also: there was no pose yet),
 *         VBSS_ERROR_NOT_FINITE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_recentre(vbss_device *device, const double *position,
                                          const double *orientation);

/**
 * Holds the opening that reads report until the handle has passed it, or has come within 0.04 of it. A host calls this
 * when the jaws are elsewhere than the handle, such as after it has restored a scene.
 *
 * @param device   the device; its configuration has `jaw_takeover`
 * @param opening  of the jaws, 0 closed to 1 open
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_OUT_OF_RANGE (also: without `jaw_takeover`),
 *         VBSS_ERROR_NOT_FINITE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_hold_jaw(vbss_device *device, double opening);

/**
 * Calibrates a device anew, from the next read on; what clutch and re-centring did is forgotten, as is the filter
 * of the opening.
 *
 * @param device       the device
 * @param calibration  the calibration; NULL for the defaults
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_UNKNOWN_FIELD,
 *         VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_set_calibration(vbss_device *device,
                                                 const vbss_device_calibration *calibration);

/**
 * What the hardware can do.
 *
 * @param device             the device
 * @param which              0, 1: the first or second adapter, as it says; 2: both together, within the limits of the
 *                           configuration
 * @param[out] capabilities  receives it
 * @param struct_size        `sizeof *capabilities` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
 *         VBSS_ERROR_OUT_OF_RANGE (no such adapter)
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_get_capabilities(vbss_device *device, uint32_t which,
                                                  vbss_device_capabilities *capabilities,
                                                  uint32_t struct_size);

/**
 * What failed last in an adapter.
 *
 * @param device       the device
 * @param which        0, 1: the first or second adapter
 * @param[out] result  what its function returned, VBSS_OK when nothing has failed yet; may be NULL
 * @param[out] text    what it said of that, valid until the next call that reads, writes or restores the device; never
 *                     NULL; may be NULL
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_OUT_OF_RANGE (no such adapter)
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_get_error(vbss_device *device, uint32_t which, vbss_result *result,
                                           const char **text);

/**
 * Figures of what came in.
 *
 * @param device           the device
 * @param[out] statistics  receives them
 * @param struct_size      `sizeof *statistics` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_get_statistics(vbss_device *device,
                                                vbss_device_statistics *statistics,
                                                uint32_t struct_size);

/**
 * Figures of the device's output stage.
 *
 * @param device           the device
 * @param[out] statistics  receives them
 * @param struct_size      `sizeof *statistics` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_get_output_statistics(vbss_device *device,
                                                       vbss_output_statistics *statistics,
                                                       uint32_t struct_size);

/**
 * Saves the device layer: calibration, clutch, filters, ages, output stage, latch, figures. What the adapters keep
 * is not in it.
 *
 * @param device        the device
 * @param[out] bytes    receives the snapshot; NULL with capacity 0 asks for its size, which logs no error
 * @param capacity      bytes there is room for
 * @param[out] written  bytes written or, with VBSS_ERROR_CAPACITY, wanted
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_CAPACITY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_save(vbss_device *device, uint8_t *bytes, uint64_t capacity,
                                      uint64_t *written);

/**
 * Restores what was saved from a device with the same configuration and capabilities. All or nothing. The latch of the
 * emergency stop comes back as it was saved: with a hand on the device, call #vbss_device_stop after it.
 *
 * @param device  the device
 * @param bytes   the snapshot
 * @param count   its size
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED, VBSS_ERROR_CORRUPT
 *         (also: of another device), VBSS_ERROR_DATA_VERSION, VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY; on
 *         failure nothing has changed
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_restore(vbss_device *device, const uint8_t *bytes, uint64_t count);

/**
 * A hash of the device layer: equal for equal histories, on every machine.
 *
 * @param device     the device
 * @param[out] hash  receives it
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_NULL_ARGUMENT
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_device_get_hash(vbss_device *device, uint64_t *hash);

#ifdef __cplusplus
}
#endif

#endif
